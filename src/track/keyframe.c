/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/keyframe.h>
#include <nakawari/mat.h>
#include <nakawari/orient.h>
#include <nakawari/quat.h>
#include <nakawari/rotation.h>
#include <nakawari/scalar.h>
#include <nakawari/spline.h>
#include <nakawari/vec.h>

#include "lane/scalar.h"
#include "curve/segment_search.h"
#include "report.h"

/* The keys around a time, and the trace that the methods fill, or NULL. */
typedef struct sampler {
    const nkw_keyframe *keys;
    size_t count;
    float time;
    nkw_segment segment;
    size_t from, to; /* the keys of the segment; equal if there is only one key */
    nkw_keyframe_rule rule;
    nkw_keyframe_trace *trace;
} sampler;

static size_t key_before(const sampler *s)
{
    return s->from > 0 ? s->from - 1 : s->from;
}

static size_t key_after(const sampler *s)
{
    return s->to + 1 < s->count ? s->to + 1 : s->to;
}

/* The key that STEP returns: the first of the segment; the last key from its time on, but not in the exercise. */
static size_t key_held(const sampler *s)
{
    return s->segment.t < 1.0f || s->rule == NKW_KEYFRAME_RULE_EXERCISE ? s->from : s->to;
}

/* Stores control value i in the trace: `value` of key `key`, and its weight. */
static void control(const sampler *s, size_t i, size_t key, nkw_vec3 value, float weight)
{
    nkw_keyframe_trace *trace = s->trace;
    if (!trace)
        return;
    trace->control_count = i + 1;
    trace->key[i] = key;
    trace->control[i] = value;
    trace->weight[i] = weight;
}

static void control_point(const sampler *s, size_t i, size_t key, float weight)
{
    control(s, i, key, s->keys[key].position, weight);
}

static nkw_vec3 hold(const sampler *s, size_t key)
{
    control_point(s, 0, key, 1.0f);
    return s->keys[key].position;
}

static nkw_vec3 linear(const sampler *s, float t)
{
    control_point(s, 0, s->from, 1.0f - t);
    control_point(s, 1, s->to, t);
    return nkw_vec3_lerp(s->keys[s->from].position, s->keys[s->to].position, t);
}

/* The negated third column of the rotation matrix of the key: the viewing direction of the object. */
static nkw_vec3 heading(const nkw_keyframe *key)
{
    nkw_mat3 m = nkw_mat3_from_quat(key->orientation);
    return nkw_vec3_negate(nkw_mat3_column(&m, 2));
}

/*
 * Keys 3i..3i + 3 control one curve; neighbouring curves share a key. After the last complete group of four, the
 * position is its last key. With fewer than four keys, it is the first key.
 */
static nkw_vec3 bezier(const sampler *s)
{
    size_t first = s->from / 3 * 3;
    if (s->count < 4)
        return hold(s, 0);
    if (first + 3 >= s->count)
        return hold(s, first);
    const nkw_keyframe *key = &s->keys[first];
    float u = s->rule == NKW_KEYFRAME_RULE_EXERCISE ? nkw_inverse_lerp(key[0].time, key[3].time, s->time)
                                                    : segment_t(key[0].time, key[3].time, s->time);
    if (s->trace) {
        nkw_weights k = nkw_cubic_weights(NKW_CUBIC_BEZIER, 0, u);
        for (size_t i = 0; i < 4; i++)
            control_point(s, i, first + i, k.w[i]);
        s->trace->parameter = u;
    }
    return nkw_vec3_bezier(key[0].position, key[1].position, key[2].position, key[3].position, u);
}

/* The four keys around the segment; the first and last key of the array are repeated at the ends. */
static void neighbours(const sampler *s, const nkw_keyframe *key[4])
{
    key[0] = &s->keys[key_before(s)];
    key[1] = &s->keys[s->from];
    key[2] = &s->keys[s->to];
    key[3] = &s->keys[key_after(s)];
}

static void control_neighbours(const sampler *s, nkw_weights k)
{
    control_point(s, 0, key_before(s), k.w[0]);
    control_point(s, 1, s->from, k.w[1]);
    control_point(s, 2, s->to, k.w[2]);
    control_point(s, 3, key_after(s), k.w[3]);
}

static nkw_vec3 bspline(const sampler *s, float t)
{
    const nkw_keyframe *k[4];
    neighbours(s, k);
    if (s->trace)
        control_neighbours(s, nkw_cubic_weights(NKW_CUBIC_BSPLINE, 0, t));
    return nkw_vec3_bspline(k[0]->position, k[1]->position, k[2]->position, k[3]->position, t);
}

/* The curve of four keys at any times. */
static float uneven(const float times[4], float p0, float p1, float p2, float p3, float t)
{
    const float keys[4] = {p0, p1, p2, p3};
    float c[4];
    nkw_cubic_from_catmull_rom(keys, times, c);
    return nkw_hermite(c[0], c[1], c[2], c[3], t);
}

/* The curve is linear in its control values: weight i is the curve of control value i = 1 and all others 0. */
static nkw_weights catmull_rom_weights(const float times[4], float t)
{
    nkw_weights k = {{
        uneven(times, 1.0f, 0.0f, 0.0f, 0.0f, t),
        uneven(times, 0.0f, 1.0f, 0.0f, 0.0f, t),
        uneven(times, 0.0f, 0.0f, 1.0f, 0.0f, t),
        uneven(times, 0.0f, 0.0f, 0.0f, 1.0f, t),
    }};
    return k;
}

static nkw_vec3 catmull_rom(const sampler *s, float t)
{
    const nkw_keyframe *key[4];
    neighbours(s, key);
    const float times[4] = {key[0]->time, key[1]->time, key[2]->time, key[3]->time};
    if (s->trace)
        control_neighbours(s, catmull_rom_weights(times, t));
    const nkw_vec3 keys[4] = {key[0]->position, key[1]->position, key[2]->position, key[3]->position};
    const nkw_vec3_cubic curve = nkw_vec3_cubic_from_catmull_rom(keys, times);
    return nkw_vec3_hermite(curve.c[0], curve.c[1], curve.c[2], curve.c[3], t);
}

/* The key that STEP_NEXT returns: the second of the segment; the first at its own time. */
static size_t key_next(const sampler *s)
{
    return s->segment.t > 0.0f ? s->to : s->from;
}

/* Tangents per segment. */
static nkw_vec3 hermite_of(const sampler *s, nkw_vec3 v0, nkw_vec3 v1, float t)
{
    if (s->trace) {
        nkw_weights k = nkw_cubic_weights(NKW_CUBIC_HERMITE, 0, t);
        control_point(s, 0, s->from, k.w[0]);
        control(s, 1, s->from, v0, k.w[1]);
        control_point(s, 2, s->to, k.w[2]);
        control(s, 3, s->to, v1, k.w[3]);
    }
    return nkw_vec3_hermite(s->keys[s->from].position, v0, s->keys[s->to].position, v1, t);
}

static nkw_vec3 hermite(const sampler *s, float t)
{
    return hermite_of(s, heading(&s->keys[s->from]), heading(&s->keys[s->to]), t);
}

/* The tangent of a key of the segment, `duration` times per second. */
static nkw_vec3 scaled_tangent(const float *tangents, size_t key, float duration)
{
    const float *v = tangents + 3 * key;
    nkw_vec3 r = {duration * v[0], duration * v[1], duration * v[2]};
    return r;
}

/*
 * The keys up to two before and two after the segment determine the tangents of its keys. Keys that are refused have
 * the tangent 0.
 */
static nkw_vec3 smooth(const sampler *s, float t, nkw_spline_method method)
{
    size_t first = s->from > 2 ? s->from - 2 : 0, last = s->count - 1 - s->to < 2 ? s->count - 1 : s->to + 2;
    float times[6] = {0.0f}, in[18] = {0.0f}, out[18] = {0.0f};
    for (size_t k = first; k <= last; k++)
        times[k - first] = s->keys[k].time;
    nkw_spline spline = {times,
                         &s->keys[first].position.x,
                         last - first + 1,
                         3,
                         sizeof(nkw_keyframe) / sizeof(float),
                         method,
                         NKW_SPLINE_ENDS_FREE,
                         0.0f,
                         NULL,
                         NULL};
    nkw_tangent_span tangents = {in, out, 3};
    nkw_spline_tangents(&spline, tangents, NULL, (nkw_work){NULL, 0});
    float duration = s->keys[s->to].time - s->keys[s->from].time;
    return hermite_of(s, scaled_tangent(out, s->from - first, duration), scaled_tangent(in, s->to - first, duration),
                      t);
}

static nkw_vec3 position_at(const sampler *s, nkw_position_method method)
{
    float t = s->segment.t;
    switch (method) {
    case NKW_POSITION_LINEAR:
        return linear(s, t);
    case NKW_POSITION_HERMITE:
        return hermite(s, t);
    case NKW_POSITION_BEZIER:
        return bezier(s);
    case NKW_POSITION_BSPLINE:
        return bspline(s, t);
    case NKW_POSITION_CATMULL_ROM:
        return catmull_rom(s, t);
    case NKW_POSITION_STEP_NEXT:
        return hold(s, key_next(s));
    case NKW_POSITION_CENTRIPETAL:
        return smooth(s, t, NKW_SPLINE_CENTRIPETAL);
    case NKW_POSITION_PCHIP:
        return smooth(s, t, NKW_SPLINE_PCHIP);
    case NKW_POSITION_AKIMA:
        return smooth(s, t, NKW_SPLINE_AKIMA);
    case NKW_POSITION_MAKIMA:
        return smooth(s, t, NKW_SPLINE_MAKIMA);
    case NKW_POSITION_STEP:
    default:
        return hold(s, key_held(s));
    }
}

/* Stores the two blended orientations and their weights in the trace. */
static void orientations(const sampler *s, nkw_quat a, nkw_quat b, float wa, float wb)
{
    if (!s->trace)
        return;
    s->trace->orientation[0] = a;
    s->trace->orientation[1] = b;
    s->trace->orientation_weight[0] = wa;
    s->trace->orientation_weight[1] = wb;
}

static nkw_mat3 step(const sampler *s)
{
    nkw_quat q = s->keys[key_held(s)].orientation;
    orientations(s, q, q, 1.0f, 0.0f);
    return nkw_mat3_from_quat(q);
}

/*
 * The angles of ConvMatToEuler of the exercise. At a pitch of 90 or -90 degrees the third column is (0, -1, 0) or
 * (0, 1, 0): yaw and roll are atan2 of what rounding leaves, and part of the rotation is lost.
 */
static nkw_vec3 exercise_angles(nkw_quat q)
{
    nkw_mat3 m = nkw_mat3_from_quat(q);
    nkw_vec3 y = nkw_mat3_column(&m, 1), z = nkw_mat3_column(&m, 2);
    float yaw = nkw_atan2(z.x, z.z), pitch = nkw_atan2(-z.y, nkw_sqrt(z.x * z.x + z.z * z.z));
    float side = nkw_sin(yaw) * y.z - nkw_cos(yaw) * y.x;
    nkw_vec3 angles = {pitch, yaw, nkw_atan2(nkw_cos(pitch) * side, y.y)};
    return angles;
}

static nkw_vec3 angles_of(const sampler *s, nkw_quat q)
{
    return s->rule == NKW_KEYFRAME_RULE_EXERCISE ? exercise_angles(q) : nkw_euler_from_quat(q, NKW_EULER_YXZ);
}

static nkw_mat3 euler(const sampler *s, float t, nkw_unwrap unwrap)
{
    nkw_quat a = s->keys[s->from].orientation, b = s->keys[s->to].orientation;
    nkw_vec3 to = angles_of(s, b), from = nkw_euler_lerp(angles_of(s, a), to, 0.0f, unwrap);
    orientations(s, a, b, 1.0f - t, t);
    if (s->trace) {
        s->trace->angles[0] = from;
        s->trace->angles[1] = to;
    }
    return nkw_mat3_from_euler(nkw_euler_lerp(from, to, t, NKW_UNWRAP_NONE), NKW_EULER_YXZ);
}

/*
 * The weights of slerp by the textbook formula sin((1-t)h)/sin h, sin(t h)/sin h, for the trace only: the result is
 * that of nkw_quat_slerp.
 */
static void arc(const sampler *s, nkw_quat a, nkw_quat b, float t)
{
    if (!s->trace)
        return;
    float sign = nkw_quat_dot(a, b) < 0.0f ? -1.0f : 1.0f;
    float h = 0.5f * nkw_quat_angle(a, b);
    float whole = nkw_sin(h);
    s->trace->half_angle = h;
    orientations(s, a, nkw_quat_scale(b, sign), h > 0.0f ? nkw_sin((1.0f - t) * h) / whole : 1.0f - t,
                 h > 0.0f ? nkw_sin(t * h) / whole : t);
}

static nkw_mat3 slerp(const sampler *s, float t)
{
    nkw_quat a = s->keys[s->from].orientation, b = s->keys[s->to].orientation;
    arc(s, a, b, t);
    return nkw_mat3_from_quat(nkw_quat_slerp(a, b, t));
}

static nkw_mat3 nlerp(const sampler *s, float t)
{
    nkw_quat a = s->keys[s->from].orientation, b = s->keys[s->to].orientation;
    arc(s, a, b, t);
    if (s->trace)
        orientations(s, a, s->trace->orientation[1], 1.0f - t, t);
    return nkw_mat3_from_quat(nkw_quat_nlerp(a, b, t));
}

/* The segment of rotations of the four keys around. */
static nkw_rotation_segment rotation_segment(const sampler *s, nkw_orientation_method method)
{
    const nkw_keyframe *k[4];
    neighbours(s, k);
    const nkw_quat keys[4] = {k[0]->orientation, k[1]->orientation, k[2]->orientation, k[3]->orientation};
    const float times[4] = {k[0]->time, k[1]->time, k[2]->time, k[3]->time};
    if (method == NKW_ORIENTATION_CATMULL_ROM)
        return nkw_rotation_from_catmull_rom(keys, times);
    float duration = times[2] - times[1];
    return method == NKW_ORIENTATION_SQUAD ? nkw_rotation_from_squad(keys, duration)
                                           : nkw_rotation_from_bspline(keys, duration);
}

static nkw_mat3 rotation_curve(const sampler *s, float t, nkw_orientation_method method)
{
    nkw_rotation_segment segment = rotation_segment(s, method);
    nkw_quat_motion at = nkw_rotation_evaluate(&segment, t);
    orientations(s, s->keys[s->from].orientation, s->keys[s->to].orientation, 0.0f, 0.0f);
    if (s->trace)
        s->trace->angular_velocity = at.velocity;
    return nkw_mat3_from_quat(at.value);
}

static nkw_mat3 rotation_at(const sampler *s, nkw_orientation_method method)
{
    float t = s->segment.t;
    switch (method) {
    case NKW_ORIENTATION_EULER:
        return euler(s, t, NKW_UNWRAP_YAW);
    case NKW_ORIENTATION_EULER_UNWRAPPED:
        return euler(s, t, NKW_UNWRAP_ALL);
    case NKW_ORIENTATION_SLERP:
        return slerp(s, t);
    case NKW_ORIENTATION_NLERP:
        return nlerp(s, t);
    case NKW_ORIENTATION_SQUAD:
    case NKW_ORIENTATION_CATMULL_ROM:
    case NKW_ORIENTATION_BSPLINE:
        return rotation_curve(s, t, method);
    case NKW_ORIENTATION_STEP:
    default:
        return step(s);
    }
}

static nkw_result check_key(const nkw_keyframe *keys, size_t k)
{
    const nkw_keyframe *key = &keys[k];
    float length = nkw_quat_length(key->orientation);
    if (!lane_is_finite(key->time) || !nkw_vec3_is_finite(key->position) || !nkw_quat_is_finite(key->orientation))
        return NKW_NOT_FINITE;
    if (k > 0 && key->time < keys[k - 1].time)
        return NKW_NOT_ASCENDING;
    return lane_is_unit_length(length) ? NKW_OK : NKW_NOT_UNIT;
}

nkw_result nkw_keyframes_validate(const nkw_keyframe *keys, size_t count, size_t *bad)
{
    nkw_result result = count > 0 ? NKW_OK : NKW_EMPTY;
    size_t offender = 0;
    for (size_t k = 0; k < count && result == NKW_OK; k++) {
        result = check_key(keys, k);
        offender = k;
    }
    return report(result, offender, bad);
}

/* The first segment that contains the time, ends included: where a key begins a segment, the one that ends there. */
static nkw_segment closed_segment(const nkw_keyframe *keys, nkw_segment at, float time)
{
    while (at.index > 0 && keys[at.index].time >= time) {
        at.index--;
        at.t = 1.0f;
    }
    return at;
}

/* Sets the sampler to `time`. Returns NKW_OK or the error. */
static nkw_result sampler_at(const nkw_keyframe *keys, size_t count, float time, const nkw_keyframe_options *options,
                             sampler *s)
{
    if (count == 0 || (count == 1 && options->rule == NKW_KEYFRAME_RULE_EXERCISE))
        return NKW_EMPTY;
    if ((unsigned)options->position > NKW_POSITION_MAKIMA || (unsigned)options->orientation > NKW_ORIENTATION_BSPLINE ||
        (unsigned)options->rule > NKW_KEYFRAME_RULE_EXERCISE)
        return NKW_BAD_METHOD;
    segment_times times = {(const char *)&keys[0].time, sizeof keys[0], count};
    nkw_segment segment = segment_find(times, time);
    if (options->rule == NKW_KEYFRAME_RULE_EXERCISE)
        segment = closed_segment(keys, segment, time);
    sampler found = {keys, count, time, segment, segment.index, segment.index, options->rule, NULL};
    found.to += segment.index + 1 < count;
    *s = found;
    return NKW_OK;
}

nkw_result nkw_keyframes_sample_as(const nkw_keyframe *keys, size_t count, float time,
                                   const nkw_keyframe_options *options, nkw_mat4 *out)
{
    sampler s;
    nkw_result result = sampler_at(keys, count, time, options, &s);
    if (result != NKW_OK)
        return result;
    nkw_mat3 rotation = rotation_at(&s, options->orientation);
    *out = nkw_mat4_from_mat3(&rotation, position_at(&s, options->position));
    return NKW_OK;
}

nkw_result nkw_keyframes_sample(const nkw_keyframe *keys, size_t count, float time, nkw_position_method position,
                                nkw_orientation_method orientation, nkw_mat4 *out)
{
    nkw_keyframe_options options = {position, orientation, NKW_KEYFRAME_RULE_LIBRARY};
    return nkw_keyframes_sample_as(keys, count, time, &options, out);
}

nkw_result nkw_keyframes_trace(const nkw_keyframe *keys, size_t count, float time, const nkw_keyframe_options *options,
                               nkw_keyframe_trace *trace)
{
    const nkw_keyframe_trace nothing = {0};
    sampler s;
    nkw_result result = sampler_at(keys, count, time, options, &s);
    if (result != NKW_OK)
        return result;
    *trace = nothing;
    trace->segment = s.segment;
    trace->parameter = s.segment.t;
    s.trace = trace;
    trace->position = position_at(&s, options->position);
    trace->rotation = rotation_at(&s, options->orientation);
    return NKW_OK;
}
