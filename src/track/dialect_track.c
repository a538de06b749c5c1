/* SPDX-License-Identifier: MIT */
/* Fcurves as one CUBICSPLINE track of numbers or of rotations, by subdivision. */
#include "lane/strict.h"

#include <math.h>

#include <nakawari/curve.h>
#include <nakawari/dialect.h>
#include <nakawari/quat.h>

#include "fcurve_segment.h"
#include "lane/euler.h"
#include "lane/scalar.h"
#include "curve/segment_search.h"
#include "track_keys.h"

/* The track while it is written: `count` keys, the last of which has no out-tangents yet. */
typedef struct writer {
    const nkw_fcurve *curves;
    size_t curve_count;
    nkw_track_kind kind; /* FLOATS: a curve for each component; ROTATION: angles about x, y and z */
    nkw_euler_order order;
    size_t width; /* of the track */
    float tolerance;
    nkw_track_span span;
    size_t count;
    float error;
} writer;

/* ---- Neighbouring floats ---- */

static float float_after(float x)
{
    uint32_t bits = lane_bits(x);
    return x > 0.0f ? lane_float(bits + 1u) : x < 0.0f ? lane_float(bits - 1u) : 0x1p-149f;
}

static float float_before(float x)
{
    return -float_after(-x);
}

/* ---- Where a curve may jump or turn ---- */

/* The first float time at which a segment that runs back, though its handles point inwards, has jumped. */
static float jump_of(const nkw_fcurve *curve, const nkw_fcurve_key *key)
{
    handle_cubic c = fcurve_cubic(key, curve->policy);
    if (key->kind != NKW_FCURVE_BEZIER || !handle_runs_back(&c) || c.p < 0.0 || c.q < 0.0)
        return key->time;
    double turn = (double)key->time + handle_time(&c, handle_turns_of(&c, (c.h - c.p) - c.q).falling);
    float jump = (float)turn;
    return (double)jump > turn ? jump : float_after(jump);
}

static float sooner(float time, float candidate, float next)
{
    return candidate > time && candidate < next ? candidate : next;
}

/* The first time after `time` at which a segment of the curve begins, or jumps; infinity if there is none. */
static float next_break(const nkw_fcurve *curve, float time)
{
    const nkw_fcurve_key *keys = curve->keys;
    float next = INFINITY;
    if (time < keys[0].time || curve->key_count < 2)
        return sooner(time, keys[0].time, next);
    segment_times times = {(const char *)&keys->time, sizeof *keys, curve->key_count};
    const nkw_fcurve_key *key = keys + segment_find(times, time).index;
    next = sooner(time, key[1].time, next);
    return sooner(time, jump_of(curve, key), next);
}

/* ---- Values and slopes ---- */

static nkw_quat axis_of(unsigned axis)
{
    nkw_quat q = {axis == 0 ? 1.0f : 0.0f, axis == 1 ? 1.0f : 0.0f, axis == 2 ? 1.0f : 0.0f, 0.0f};
    return q;
}

/*
 * Of the rotation q = qi qj qk of three angles, in the order i j k with the axes ei, ej, ek, of a proper order ek = ei:
 *
 *     2 dq/dt = i' ei q + j' qi ej qi^-1 q + k' q ek
 */
static nkw_quat rotation_slope(const nkw_motion angle[3], nkw_quat q, nkw_euler_order order)
{
    const lane_euler_axes *o = lane_euler_axes_of(order);
    int proper = lane_euler_is_proper(order);
    nkw_quat ei = axis_of(o->i), ej = axis_of(o->j), ek = axis_of(proper ? o->i : o->k);
    const nkw_motion *i = angle + (proper ? 0 : o->i), *j = angle + (proper ? 1 : o->j);
    const nkw_motion *k = angle + (proper ? 2 : o->k);
    nkw_vec3 about = {ei.x, ei.y, ei.z};
    nkw_quat qi = nkw_quat_from_axis_angle(about, i->value);
    nkw_quat middle = nkw_quat_mul(nkw_quat_mul(qi, ej), nkw_quat_mul(nkw_quat_conjugate(qi), q));
    nkw_quat sum = nkw_quat_add(nkw_quat_scale(nkw_quat_mul(ei, q), i->velocity),
                                nkw_quat_scale(nkw_quat_mul(q, ek), k->velocity));
    return nkw_quat_scale(nkw_quat_add(sum, nkw_quat_scale(middle, j->velocity)), 0.5f);
}

/*
 * The quaternion of three angles is continuous: it keeps whole turns in its sign. Its slope is infinite where that of
 * an angle is.
 */
static nkw_motion rotation_component(const writer *w, size_t i, float time)
{
    nkw_motion angle[3], r = {0.0f, 0.0f, 0.0f};
    for (size_t k = 0; k < 3; k++)
        angle[k] = nkw_fcurve_sample(w->curves + k, time, NULL);
    nkw_vec3 angles = {angle[0].value, angle[1].value, angle[2].value};
    nkw_quat q = nkw_quat_from_euler(angles, w->order), slope;
    r.value = i == 0 ? q.x : i == 1 ? q.y : i == 2 ? q.z : q.w;
    r.velocity = INFINITY;
    if (!lane_is_finite(angle[0].velocity) || !lane_is_finite(angle[1].velocity) || !lane_is_finite(angle[2].velocity))
        return r;
    slope = rotation_slope(angle, q, w->order);
    r.velocity = i == 0 ? slope.x : i == 1 ? slope.y : i == 2 ? slope.z : slope.w;
    return r;
}

/* Value and slope of component i of the track. */
static nkw_motion component(const writer *w, size_t i, float time)
{
    return w->kind == NKW_TRACK_FLOATS ? nkw_fcurve_sample(w->curves + i, time, NULL) : rotation_component(w, i, time);
}

/* Whether a value at b is more than the tolerance from that at the float before; half of it for quaternions. */
static int jumps_at(const writer *w, float b)
{
    float most = w->kind == NKW_TRACK_FLOATS ? w->tolerance : 0.5f * w->tolerance;
    for (size_t i = 0; i < w->width; i++) {
        float before = component(w, i, float_before(b)).value;
        if (!(lane_abs(component(w, i, b).value - before) <= most))
            return 1;
    }
    return 0;
}

static float next_key_of_all(const writer *w, float time, float end)
{
    float next = end;
    for (size_t i = 0; i < w->curve_count; i++) {
        float own = next_break(w->curves + i, time);
        next = own < next ? own : next;
    }
    return next;
}

/* The next break of a curve after a break; it is the next float if a curve leaves its key by a jump. */
static float next_break_of_all(const writer *w, float time, float end)
{
    float after = float_after(time);
    return after < end && jumps_at(w, after) ? after : next_key_of_all(w, time, end);
}

/* ---- Keys ---- */

/* In-tangents, values and out-tangents of key k. */
static float *triple(const writer *w, size_t k)
{
    return w->span.values + 3 * w->width * k;
}

static int has_room(const writer *w)
{
    return w->count < w->span.key_capacity;
}

/* Begins key w->count at a time, without tangents, and without counting it. */
static void write_values(const writer *w, float time)
{
    float *v = triple(w, w->count);
    w->span.times[w->count] = time;
    for (size_t i = 0; i < w->width; i++) {
        v[i] = v[2 * w->width + i] = 0.0f;
        v[w->width + i] = component(w, i, time).value;
    }
}

/* A slope at an end; where it is vertical, that of the chord. */
static float slope_or(float slope, float v0, float v1, float h)
{
    double chord = ((double)v1 - (double)v0) / (double)h;
    return lane_is_finite(slope) ? slope : (float)chord;
}

/* The tangents between the last key and the one that write_values began. */
static void write_tangents(const writer *w, float a, float b)
{
    float *v0 = triple(w, w->count - 1), *v1 = triple(w, w->count);
    for (size_t i = 0; i < w->width; i++) {
        float from = v0[w->width + i], to = v1[w->width + i];
        v0[2 * w->width + i] = slope_or(component(w, i, a).velocity, from, to, b - a);
        v1[i] = slope_or(component(w, i, float_before(b)).velocity, from, to, b - a);
    }
}

/* The difference of the track from the curves at one time between the last key and the new one. */
static float difference_at(const writer *w, float a, float b, float time)
{
    const float *v0 = triple(w, w->count - 1), *v1 = triple(w, w->count);
    float worst = 0.0f, h = b - a, t = segment_t(a, b, time), made[4] = {0}, want[4] = {0};
    size_t n = w->width;
    for (size_t i = 0; i < n; i++) {
        made[i % 4] = nkw_hermite(v0[n + i], h * v0[2 * n + i], v1[n + i], h * v1[i], t);
        want[i % 4] = component(w, i, time).value;
        float off = lane_abs(made[i % 4] - want[i % 4]);
        worst = !(off <= worst) ? off : worst;
    }
    if (w->kind == NKW_TRACK_FLOATS)
        return worst;
    return nkw_quat_angle(nkw_quat_normalize(track_read_quat(made)), track_read_quat(want));
}

/* The largest difference at 31 times. */
static float difference_between(const writer *w, float a, float b)
{
    float worst = 0.0f;
    for (int k = 1; k < 32; k++) {
        float time = (float)((double)a + ((double)b - (double)a) * (k / 32.0));
        float off = time > a && time < b ? difference_at(w, a, b, time) : 0.0f;
        worst = !(off <= worst) ? off : worst;
    }
    return worst;
}

/* ---- Subdivision ---- */

#define DEPTH 48

/* Writes keys from the last key to b, without a jump between. Returns 0 without room. */
static int write_span(writer *w, float b)
{
    float ends[DEPTH + 1];
    int depth = 0;
    ends[0] = b;
    while (depth >= 0) {
        float a = w->span.times[w->count - 1], end = ends[depth];
        if (!has_room(w))
            return 0;
        write_values(w, end);
        write_tangents(w, a, end);
        float difference = difference_between(w, a, end), middle = (float)(0.5 * ((double)a + (double)end));
        if (!(difference <= w->tolerance) && depth < DEPTH && middle > a && middle < end) {
            ends[++depth] = middle;
            continue;
        }
        w->error = !(difference <= w->error) ? difference : w->error;
        w->count++;
        depth--;
    }
    return 1;
}

/* Writes keys from the last key to b, where the curves may jump. Returns 0 without room. */
static int write_until(writer *w, float b)
{
    float before = float_before(b);
    if (!jumps_at(w, b))
        return write_span(w, b);
    if (before > w->span.times[w->count - 1] && !write_span(w, before))
        return 0;
    if (!has_room(w))
        return 0;
    write_values(w, b);
    w->count++;
    return 1;
}

static nkw_result write_all(writer *w, float first, float last)
{
    if (!has_room(w))
        return NKW_TOO_SMALL;
    write_values(w, first);
    w->count = 1;
    for (float time = first; time < last;) {
        time = next_break_of_all(w, time, last);
        if (!write_until(w, time))
            return NKW_TOO_SMALL;
    }
    return NKW_OK;
}

static int is_stepped(const writer *w)
{
    for (size_t i = 0; i < w->curve_count; i++)
        for (size_t k = 0; k + 1 < w->curves[i].key_count; k++)
            if (w->curves[i].keys[k].kind > NKW_FCURVE_CONSTANT_NEXT)
                return 0;
    return w->kind == NKW_TRACK_FLOATS;
}

/* The keys of a STEP track: one value at each time at which a curve has a key, or leaves one for the next. */
static nkw_result write_steps(writer *w, float first, float last)
{
    w->tolerance = 0.0f; /* the steps are exact */
    for (float time = first;; time = next_break_of_all(w, time, last)) {
        if (!has_room(w))
            return NKW_TOO_SMALL;
        w->span.times[w->count] = time;
        for (size_t i = 0; i < w->width; i++)
            w->span.values[w->count * w->width + i] = nkw_fcurve_sample(w->curves + i, time, NULL).value;
        w->count++;
        if (!(time < last))
            return NKW_OK;
    }
}

static int is_cycle(nkw_fcurve_outside outside)
{
    return outside != NKW_FCURVE_OUTSIDE_HOLD && outside != NKW_FCURVE_OUTSIDE_LINEAR;
}

/* Checks the curves; first and last receive the times of the first and the last key of all. */
static nkw_result check_curves(const nkw_fcurve *curves, size_t width, float *first, float *last)
{
    *first = INFINITY;
    *last = -INFINITY;
    for (size_t i = 0; i < width; i++) {
        nkw_result result = nkw_fcurve_validate(curves + i, NULL);
        if (result != NKW_OK)
            return result;
        float begin = curves[i].keys[0].time, end = curves[i].keys[curves[i].key_count - 1].time;
        *first = begin < *first ? begin : *first;
        *last = end > *last ? end : *last;
    }
    for (size_t i = 0; i < width; i++) {
        int early = curves[i].keys[0].time > *first, late = curves[i].keys[curves[i].key_count - 1].time < *last;
        if ((early && is_cycle(curves[i].before)) || (late && is_cycle(curves[i].after)))
            return NKW_MISMATCHED;
    }
    return width > 0 ? NKW_OK : NKW_EMPTY;
}

static nkw_result write_track(writer *w, nkw_track *out, float *difference)
{
    const nkw_track_span span = w->span;
    float first, last;
    nkw_result result = check_curves(w->curves, w->curve_count, &first, &last);
    if (result == NKW_OK && !(w->tolerance >= 0.0f))
        result = NKW_OUT_OF_RANGE;
    int steps = result == NKW_OK && is_stepped(w);
    if (result == NKW_OK)
        result = steps ? write_steps(w, first, last) : write_all(w, first, last);
    size_t count = result == NKW_OK ? w->count : 0;
    nkw_interpolation mode = steps ? NKW_INTERPOLATION_STEP : NKW_INTERPOLATION_CUBICSPLINE;
    nkw_track made = {span.times, span.values, count, w->width, w->kind, mode, NULL};
    *out = made;
    if (difference)
        *difference = result == NKW_OK ? w->error : INFINITY;
    return result;
}

nkw_result nkw_track_from_fcurves(const nkw_fcurve *curves, size_t count, float tolerance, nkw_track_span span,
                                  nkw_track *out, float *difference)
{
    writer w = {curves, count, NKW_TRACK_FLOATS, NKW_EULER_XYZ, count, tolerance, span, 0, 0.0f};
    return write_track(&w, out, difference);
}

nkw_result nkw_track_from_euler_fcurves(const nkw_fcurve angles[3], nkw_euler_order order, float tolerance,
                                        nkw_track_span span, nkw_track *out, float *difference)
{
    writer w = {angles, 3, NKW_TRACK_ROTATION, order, 4, tolerance, span, 0, 0.0f};
    return write_track(&w, out, difference);
}
