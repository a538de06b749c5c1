/* SPDX-License-Identifier: MIT */
/* Curves of tools from a few numbers. */
#ifndef NAKAWARI_TESTS_GOLDEN_HANDLES_H
#define NAKAWARI_TESTS_GOLDEN_HANDLES_H

#include <string.h>

#include <nakawari/nakawari.h>

static void put_tool_point(float *o, nkw_motion p)
{
    memcpy(o, &p, sizeof p);
}

static void put_handles(float *o, nkw_handle a, nkw_handle b)
{
    memcpy(o, &a, sizeof a);
    memcpy(o + 2, &b, sizeof b);
}

/* Handles of any direction, often so long that the curve runs back. */
static nkw_handle_segment some_handles(const float s[8])
{
    nkw_handle_segment c = {s[0], s[1], {s[2], s[3]}, {s[4], s[5]}, 0.0f, s[6]};
    c.time1 = c.time0 + nkw_abs(s[7]);
    return c;
}

static void handle_split(float *o, const float s[8], float t)
{
    nkw_handle_segment whole = some_handles(s), left, right;
    nkw_handle_split(&whole, nkw_lerp(whole.time0, whole.time1, t), &left, &right);
    memcpy(o, &left, sizeof left);
    memcpy(o + 8, &right, sizeof right);
}

static void handle_limits(float *o, const float s[8])
{
    nkw_handle_segment c = some_handles(s), ratio = nkw_handle_limit(&c, NKW_HANDLE_KEEP_RATIO);
    nkw_handle_segment start = nkw_handle_limit(&c, NKW_HANDLE_KEEP_START);
    nkw_handle_segment contained = nkw_handle_limit(&c, NKW_HANDLE_CONTAIN);
    put_handles(o, ratio.out, ratio.in);
    put_handles(o + 4, start.out, start.in);
    put_handles(o + 8, contained.out, contained.in);
}

static void handle_points(float *o, const float s[8], float t)
{
    nkw_handle_segment c = some_handles(s), limited = nkw_handle_limit(&c, NKW_HANDLE_KEEP_RATIO);
    float time = nkw_lerp(c.time0, c.time1, t);
    put_tool_point(o, nkw_handle_sample(&c, time));
    put_tool_point(o + 3, nkw_handle_sample(&limited, time));
    o[6] = nkw_handle_parameter(&c, time);
    o[7] = (float)nkw_handle_runs_back(&c);
}

/* Four kinds a round: all of them in nine rounds. */
static void eases(float *o, unsigned some, float t)
{
    for (unsigned k = 0; k < 4; k++)
        put_tool_point(o + 3 * k, nkw_ease_evaluate((nkw_ease_kind)((10 * k + some) % NKW_EASE_COUNT), t));
}

/* All kinds of segments and of behaviour outside, chosen by `some`, 0..17, at times far outside too. */
static void sample_fcurve(float *o, const nkw_keyframe *from, const float s[8], unsigned some, float t)
{
    nkw_fcurve_key keys[5];
    for (unsigned k = 0; k < 5; k++) {
        nkw_handle in = {-nkw_abs(s[k]), s[k + 1]}, out = {nkw_abs(s[k + 1]), s[k + 2]};
        nkw_fcurve_key key = {from[k].time, from[k].position.x, in, out, NKW_FCURVE_BEZIER, NKW_EASE_CSS};
        keys[k] = key;
        keys[k].kind = (nkw_fcurve_kind)((k + some) % 5);
        keys[k].ease = (nkw_ease_kind)((7 * k + some) % NKW_EASE_COUNT);
    }
    nkw_fcurve_outside before = (nkw_fcurve_outside)(some % 5), after = (nkw_fcurve_outside)((some + 2) % 5);
    nkw_fcurve curve = {keys, 5, before, after, some % 3, some % 2, (nkw_handle_policy)(some % 4)};
    put_tool_point(o, nkw_fcurve_sample(&curve, nkw_lerp(keys[0].time, keys[4].time, t), NULL));
    put_tool_point(o + 3, nkw_fcurve_sample(&curve, keys[2].time, NULL));
    put_tool_point(o + 6, nkw_fcurve_sample(&curve, s[0], NULL));
    put_tool_point(o + 9, nkw_fcurve_sample(&curve, 64.0f * s[1], NULL));
    put_tool_point(o + 12, nkw_fcurve_sample(&curve, -0x1p20f * nkw_abs(s[2]), NULL));
}

static void insert_key(float *o, const nkw_keyframe *from, const float s[8], unsigned some, float t)
{
    nkw_fcurve_key keys[3], more[4];
    size_t index = 0;
    for (unsigned k = 0; k < 3; k++) {
        nkw_handle in = {-nkw_abs(s[k]), s[k + 1]}, out = {nkw_abs(s[k + 1]), s[k + 2]};
        nkw_fcurve_key key = {from[k].time, from[k].position.x, in, out, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR};
        keys[k] = key;
    }
    nkw_fcurve curve = {keys, 3, NKW_FCURVE_OUTSIDE_HOLD, NKW_FCURVE_OUTSIDE_HOLD, 0, 0, (nkw_handle_policy)(some % 4)};
    if (nkw_fcurve_insert(&curve, nkw_lerp(from[0].time, from[2].time, t), more, &index) != NKW_OK)
        return;
    put_handles(o, more[index - 1].out, more[index].in);
    put_handles(o + 4, more[index].out, more[index + 1].in);
    o[8] = more[index].value;
}

/* Handles of all types. */
static void auto_handles(float *o, const nkw_keyframe *from, unsigned some)
{
    nkw_fcurve_key keys[4];
    nkw_handle_types types[4];
    for (unsigned k = 0; k < 4; k++) {
        nkw_fcurve_key key = {from[k].time,    from[k].position.x, {-0.25f, 0.5f},
                              {0.25f, 0.125f}, NKW_FCURVE_BEZIER,  NKW_EASE_LINEAR};
        keys[k] = key;
        types[k].in = (nkw_handle_type)((some + k) % 5);
        types[k].out = (nkw_handle_type)((some / 2 + 2 * k) % 5);
    }
    nkw_fcurve_auto_handles(keys, 4, types);
    for (unsigned k = 0; k < 4; k++)
        put_handles(o + 4 * k, keys[k].in, keys[k].out);
}

/* A track of numbers and one of rotations, by their errors, numbers of keys and a sample. */
static void tracks_of_fcurves(float *o, const nkw_fcurve *curve, float time)
{
    float times[300], values[3600];
    nkw_fcurve angles[3] = {curve[0], curve[0], curve[0]};
    nkw_track_span memory = {times, values, NULL, 300};
    nkw_track track;
    nkw_track_from_fcurves(curve, 1, 0.25f, memory, &track, o);
    o[1] = (float)track.count;
    nkw_track_sample(&track, time, NULL, o + 2);
    nkw_track_from_euler_fcurves(angles, NKW_EULER_YXZ, 0.25f, memory, &track, o + 3);
    nkw_track_sample(&track, time, NULL, o + 4);
}

/* Keys of slopes, of Blender and of CSS; with_tracks: tracks of them too. */
static void dialects(float *o, const nkw_keyframe *from, const float s[8], unsigned some, float t, int with_tracks)
{
    nkw_slope_key slopes[4];
    nkw_fcurve_key keys[4];
    nkw_blender_key blender[4];
    for (unsigned k = 0; k < 4; k++) {
        nkw_slope_key key = {from[k].time,
                             from[k].position.x,
                             s[k],
                             s[k + 1],
                             nkw_abs(s[k + 2]),
                             nkw_abs(s[k + 3]),
                             (nkw_weighted)((k + some) % 4),
                             NKW_FCURVE_BEZIER};
        slopes[k] = key;
    }
    nkw_fcurve_from_slope_keys(slopes, 4, (nkw_weight_unit)(some % 3), keys, NULL);
    nkw_fcurve curve = {keys, 4, NKW_FCURVE_OUTSIDE_HOLD, NKW_FCURVE_OUTSIDE_HOLD, 0, 0, NKW_HANDLE_KEEP_RATIO};
    nkw_blender_keys_from_fcurve(keys, 4, blender, NULL);
    put_handles(o, blender[1].left, blender[1].center);
    put_handles(o + 4, blender[1].right, keys[1].in);
    nkw_slope_keys_from_fcurve(keys, 4, (nkw_weight_unit)((some + 1) % 3), slopes, NULL);
    o[8] = slopes[1].in_slope;
    o[9] = slopes[1].out_slope;
    o[10] = slopes[1].in_weight;
    o[11] = slopes[1].out_weight;
    if (with_tracks)
        tracks_of_fcurves(o, &curve, nkw_lerp(from[0].time, from[3].time, t));
    nkw_fcurve_from_css(s, keys);
    o[13] = keys[0].out.value;
    o[14] = keys[1].in.time;
}

#endif
