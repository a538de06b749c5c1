/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/track.h>

#include "lane/curve.h"

/* Velocity and acceleration of one component. */
typedef struct rates {
    double velocity, acceleration;
} rates;

/* The interpolation of the segment from key k on. CUBICSPLINE only where there are tangents. */
static nkw_interpolation interpolation_at(const nkw_track *track, size_t k)
{
    int cubic = track->interpolation == NKW_INTERPOLATION_CUBICSPLINE;
    nkw_interpolation own =
        track->key_interpolation ? (nkw_interpolation)track->key_interpolation[k] : track->interpolation;
    return own == NKW_INTERPOLATION_CUBICSPLINE && !cubic ? NKW_INTERPOLATION_STEP : own;
}

/* Component c from key k to the next, `h` seconds later. */
static rates rates_at(const nkw_track *track, size_t k, size_t c, double t, double h)
{
    size_t width = track->width, offset = track->interpolation == NKW_INTERPOLATION_CUBICSPLINE ? width : 0;
    size_t size = width + 2 * offset;
    const float *a = track->values + k * size + offset + c, *b = a + size;
    rates still = {0.0, 0.0}, even = {((double)b[0] - (double)a[0]) / h, 0.0};
    nkw_interpolation interpolation = interpolation_at(track, k);
    if (interpolation == NKW_INTERPOLATION_CUBICSPLINE) {
        lane_f64_slopes slopes = {even.velocity, a[width], b[0 - (ptrdiff_t)width]};
        rates r = {lane_f64_first(slopes, t), lane_f64_second(slopes, t) / h};
        return r;
    }
    return interpolation == NKW_INTERPOLATION_LINEAR ? even : still;
}

/* Whether the time is within the keys, and the segment lasts. */
static int is_moving(const nkw_track *track, nkw_segment segment, float time)
{
    const float *times = track->times;
    size_t last = track->count - 1;
    return segment.index < last && time >= times[0] && time <= times[last] &&
           times[segment.index] < times[segment.index + 1];
}

nkw_result nkw_track_sample_derivatives(const nkw_track *track, float time, float *value, float *velocity,
                                        float *acceleration)
{
    if (track->count == 0 || track->width == 0)
        return NKW_EMPTY;
    if (track->kind != NKW_TRACK_FLOATS)
        return NKW_BAD_METHOD;
    nkw_segment segment = nkw_segment_find(track->times, track->count, time);
    int moving = is_moving(track, segment, time);
    double h = moving ? (double)track->times[segment.index + 1] - (double)track->times[segment.index] : 1.0;
    for (size_t c = 0; c < track->width; c++) {
        rates r = {0.0, 0.0};
        if (moving)
            r = rates_at(track, segment.index, c, segment.t, h);
        velocity[c] = (float)r.velocity;
        acceleration[c] = (float)r.acceleration;
    }
    nkw_track_sample_segment(track, segment, value);
    return NKW_OK;
}
