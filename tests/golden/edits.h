/* SPDX-License-Identifier: MIT */
/* Edits and rates of a track of three keys. */
#ifndef NAKAWARI_TESTS_GOLDEN_EDITS_H
#define NAKAWARI_TESTS_GOLDEN_EDITS_H

#include <string.h>

#include <nakawari/nakawari.h>

typedef enum edit_kind { EDIT_TRIM, EDIT_RETIME, EDIT_JOIN, EDIT_CLOSE } edit_kind;

/* Three keys of quaternions at times[0..2]; writes the number of keys, the last time and the last key: 14 floats. */
static void edit_track(float *o, const float *times, const nkw_quat *q, const float *s, edit_kind kind,
                       nkw_interpolation mode)
{
    float values[36], made_times[8], made[96];
    for (unsigned k = 0; k < 9; k++)
        memcpy(values + 4 * k, &q[k % 4], 4 * sizeof(float));
    nkw_track track = {times, values, 3, 4, NKW_TRACK_ROTATION, mode, NULL}, out;
    nkw_track_span memory = {made_times, made, NULL, 8};
    if (kind == EDIT_TRIM)
        nkw_track_trim(&track, nkw_min(s[0], s[1]), nkw_max(s[0], s[1]), memory, &out);
    else if (kind == EDIT_RETIME)
        nkw_track_retime(&track, s[0], s[1], memory, &out);
    else if (kind == EDIT_JOIN)
        nkw_track_join(&track, &track, memory, &out);
    else
        nkw_track_close(&track, 0.5f, memory, &out);
    o[0] = (float)out.count;
    if (out.count == 0)
        return;
    size_t size = mode == NKW_INTERPOLATION_CUBICSPLINE ? 12 : 4;
    o[1] = out.times[out.count - 1];
    memcpy(o + 2, out.values + size * (out.count - 1), size * sizeof(float));
}

/* Orientation, angular velocity and angular acceleration of a track of three keys: 10 floats. */
static void turn_track(float *o, const float *times, const nkw_quat *q, float time, nkw_interpolation mode)
{
    float values[36];
    for (unsigned k = 0; k < 9; k++)
        memcpy(values + 4 * k, &q[k % 4], 4 * sizeof(float));
    nkw_track track = {times, values, 3, 4, NKW_TRACK_ROTATION, mode, NULL};
    nkw_quat_motion state;
    nkw_track_sample_motion(&track, time, quat_motion_span(&state));
    memcpy(o, &state, sizeof state);
}

/* A fit of 16 samples; its error is a part of the hash. */
static void fit_track(float *o, const float *x, float tolerance)
{
    float times[16], values[16], made_times[16], made[48];
    NKW_STACK_WORK(work, NKW_FIT_WORK(16, 1));
    for (unsigned k = 0; k < 16; k++) {
        times[k] = 0.25f * (float)k;
        values[k] = x[(3 * k) % 8];
    }
    nkw_track track = {times, values, 16, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR, NULL}, out;
    nkw_track_span memory = {made_times, made, NULL, 16};
    nkw_track_fit(&track, tolerance, memory, &out, &o[0], work);
    o[1] = (float)out.count;
    memcpy(o + 2, made, 6 * sizeof(float));
    memcpy(o + 8, made + 3 * (out.count - 1), 3 * sizeof(float));
}

#endif
