/* SPDX-License-Identifier: MIT */
/* Fcurves as one CUBICSPLINE track, by subdivision. */
#include "lane/strict.h"

#include <math.h>

#include <nakawari/curve.h>
#include <nakawari/dialect.h>

#include "fcurve_segment.h"
#include "lane/scalar.h"
#include "segment_search.h"

/* The track while it is written: `count` keys, the last of which has no out-tangents yet. */
typedef struct writer {
    const nkw_fcurve *curves;
    size_t width;
    float tolerance;
    const nkw_track_memory *memory;
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

/* Whether a value at b is more than the tolerance from that at the float before. */
static int jumps_at(const writer *w, float b)
{
    for (size_t i = 0; i < w->width; i++) {
        float before = nkw_fcurve_sample(w->curves + i, float_before(b)).value;
        if (!(lane_abs(nkw_fcurve_sample(w->curves + i, b).value - before) <= w->tolerance))
            return 1;
    }
    return 0;
}

/* The next break of a curve after a break; it is the next float if a curve leaves its key by a jump. */
static float next_break_of_all(const writer *w, float time, float end)
{
    float next = end, after = float_after(time);
    if (after < end && jumps_at(w, after))
        return after;
    for (size_t i = 0; i < w->width; i++) {
        float own = next_break(w->curves + i, time);
        next = own < next ? own : next;
    }
    return next;
}

/* ---- Keys ---- */

/* In-tangents, values and out-tangents of key k. */
static float *triple(const writer *w, size_t k)
{
    return w->memory->values + 3 * w->width * k;
}

static int has_room(const writer *w)
{
    return w->count < w->memory->key_capacity;
}

/* Begins key w->count at a time, without tangents, and without counting it. */
static void write_values(const writer *w, float time)
{
    float *v = triple(w, w->count);
    w->memory->times[w->count] = time;
    for (size_t i = 0; i < w->width; i++) {
        v[i] = v[2 * w->width + i] = 0.0f;
        v[w->width + i] = nkw_fcurve_sample(w->curves + i, time).value;
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
        v0[2 * w->width + i] = slope_or(nkw_fcurve_sample(w->curves + i, a).first, from, to, b - a);
        v1[i] = slope_or(nkw_fcurve_sample(w->curves + i, float_before(b)).first, from, to, b - a);
    }
}

/* The largest difference between curves and track at 31 times between the last key and the new one. */
static float difference_between(const writer *w, float a, float b)
{
    const float *v0 = triple(w, w->count - 1), *v1 = triple(w, w->count);
    float worst = 0.0f, h = b - a;
    for (int k = 1; k < 32; k++) {
        float time = (float)((double)a + ((double)b - (double)a) * (k / 32.0)), t = segment_t(a, b, time);
        for (size_t i = 0; i < w->width; i++) {
            size_t n = w->width;
            float made = nkw_hermite(v0[n + i], h * v0[2 * n + i], v1[n + i], h * v1[i], t);
            float off = lane_abs(made - nkw_fcurve_sample(w->curves + i, time).value);
            worst = !(off <= worst) && time > a && time < b ? off : worst;
        }
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
        float a = w->memory->times[w->count - 1], end = ends[depth];
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
    if (before > w->memory->times[w->count - 1] && !write_span(w, before))
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
            return NKW_BAD_METHOD;
    }
    return width > 0 ? NKW_OK : NKW_EMPTY;
}

nkw_result nkw_track_from_fcurves(const nkw_fcurve *curves, size_t width, float tolerance,
                                  const nkw_track_memory *memory, nkw_track *out, float *error)
{
    writer w = {curves, width, tolerance, memory, 0, 0.0f};
    float first, last;
    nkw_result result = check_curves(curves, width, &first, &last);
    if (result == NKW_OK && !(tolerance >= 0.0f))
        result = NKW_OUT_OF_RANGE;
    if (result == NKW_OK)
        result = write_all(&w, first, last);
    nkw_track made = {memory->times, memory->values,   result == NKW_OK ? w.count : 0,
                      width,         NKW_TRACK_FLOATS, NKW_INTERPOLATION_CUBICSPLINE,
                      NULL};
    *out = made;
    if (error)
        *error = result == NKW_OK ? w.error : INFINITY;
    return result;
}
