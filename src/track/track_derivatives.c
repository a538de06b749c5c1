/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/track.h>

#include "lane/arc.h"
#include "lane/cubic.h"
#include "track_keys.h"

/* Velocity and acceleration of one component. */
typedef struct rates {
    double velocity, acceleration;
} rates;

/* The interpolation of the segment from key k on. CUBICSPLINE only where there are tangents. */
static nkw_interpolation interpolation_at(const nkw_track *track, size_t k)
{
    nkw_interpolation own = track_interpolation_at(track, k);
    return own == NKW_INTERPOLATION_CUBICSPLINE && !track_is_cubic(track) ? NKW_INTERPOLATION_STEP : own;
}

/* The change of component c from key k to the next, and its tangents, per second. */
static lane_f64_slopes slopes_of(const nkw_track *track, size_t k, size_t c, double h)
{
    const float *a = track_value_at(track, k) + c, *b = track_value_at(track, k + 1) + c;
    lane_f64_slopes slopes = {((double)b[0] - (double)a[0]) / h, 0.0, 0.0};
    if (track_is_cubic(track)) {
        slopes.v0 = a[track->width];
        slopes.v1 = b[0 - (ptrdiff_t)track->width];
    }
    return slopes;
}

/* Component c from key k to the next, `h` seconds later. */
static rates rates_at(const nkw_track *track, size_t k, size_t c, double t, double h)
{
    lane_f64_slopes slopes = slopes_of(track, k, c, h);
    nkw_interpolation interpolation = interpolation_at(track, k);
    rates still = {0.0, 0.0}, even = {slopes.f, 0.0},
          curved = {lane_f64_first(slopes, t), lane_f64_second(slopes, t) / h};
    return interpolation == NKW_INTERPOLATION_CUBICSPLINE ? curved
           : interpolation == NKW_INTERPOLATION_LINEAR    ? even
                                                          : still;
}

/* Whether the time is within the keys, and the segment lasts. */
static int is_moving(const nkw_track *track, nkw_segment segment, float time)
{
    const float *times = track->times;
    size_t last = track->count - 1;
    return segment.index < last && time >= times[0] && time <= times[last] &&
           times[segment.index] < times[segment.index + 1];
}

/* The derivatives of numbers in a segment; 0 where nothing moves. */
static void put_rates(const nkw_track *track, nkw_segment segment, int moving, nkw_motion_span out)
{
    const double h = moving ? (double)track->times[segment.index + 1] - (double)track->times[segment.index] : 1.0;
    for (size_t c = 0; c < track->width; c++) {
        rates r = {0.0, 0.0};
        if (moving)
            r = rates_at(track, segment.index, c, segment.t, h);
        if (out.velocity)
            out.velocity[c] = (float)r.velocity;
        if (out.acceleration)
            out.acceleration[c] = (float)r.acceleration;
    }
}

/* ---- Rotations ---- */

/* The vector part of a b*. */
static lane_f64_vec3 vector_of_product(lane_f64_quat a, lane_f64_quat b)
{
    lane_f64_quat q = lane_f64_quat_mul(a, lane_f64_quat_conjugate(b));
    lane_f64_vec3 v = {q.x, q.y, q.z};
    return v;
}

/* The shorter arc from key k to the next in h seconds, at constant velocity. */
static lane_f64_vec3 velocity_of_slerp(const nkw_track *track, size_t k, double h)
{
    lane_f64_quat a = lane_f64_quat_unit_from(track_read_quat(track_value_at(track, k)));
    lane_f64_quat b = lane_f64_quat_unit_from(track_read_quat(track_value_at(track, k + 1)));
    b = lane_f64_quat_aligned(a, b, NKW_PATH_SHORT);
    lane_f64_vec3 half = lane_f64_quat_log(lane_f64_quat_mul(b, lane_f64_quat_conjugate(a)));
    return lane_f64_vec3_scale(half, 2.0 / h);
}

/* q = p/|p|: w = 2 Im(p' p*)/|p|^2, a = 2 Im(p'' p*)/|p|^2 - 2 (p.p')/|p|^2 w. */
static void put_rates_of_cubic(const nkw_track *track, size_t k, double t, double h, nkw_vec3 rates_of[2])
{
    double p[4], p1[4], p2[4];
    for (size_t c = 0; c < 4; c++) {
        lane_f64_slopes slopes = slopes_of(track, k, c, h), per_segment = {h * slopes.f, h * slopes.v0, h * slopes.v1};
        p[c] = lane_f64_value(track_value_at(track, k)[c], per_segment, t);
        p1[c] = lane_f64_first(slopes, t);
        p2[c] = lane_f64_second(slopes, t) / h;
    }
    lane_f64_quat q = {p[0], p[1], p[2], p[3]}, q1 = {p1[0], p1[1], p1[2], p1[3]}, q2 = {p2[0], p2[1], p2[2], p2[3]};
    double length2 = lane_f64_quat_dot(q, q);
    if (length2 == 0.0)
        return;
    lane_f64_vec3 w = lane_f64_vec3_scale(vector_of_product(q1, q), 2.0 / length2);
    lane_f64_vec3 a = lane_f64_vec3_scale(vector_of_product(q2, q), 2.0 / length2);
    rates_of[0] = lane_vec3_from_f64(w);
    rates_of[1] = lane_vec3_from_f64(lane_f64_vec3_add_scaled(a, w, -2.0 * lane_f64_quat_dot(q, q1) / length2));
}

static void put_turn(const nkw_track *track, nkw_segment segment, int moving, nkw_motion_span out)
{
    nkw_vec3 turn[2] = {{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}}; /* velocity, acceleration */
    if (moving) {
        double h = (double)track->times[segment.index + 1] - (double)track->times[segment.index];
        nkw_interpolation interpolation = interpolation_at(track, segment.index);
        if (interpolation == NKW_INTERPOLATION_LINEAR)
            turn[0] = lane_vec3_from_f64(velocity_of_slerp(track, segment.index, h));
        else if (interpolation == NKW_INTERPOLATION_CUBICSPLINE)
            put_rates_of_cubic(track, segment.index, segment.t, h, turn);
    }
    if (out.velocity)
        memcpy(out.velocity, &turn[0], sizeof turn[0]);
    if (out.acceleration)
        memcpy(out.acceleration, &turn[1], sizeof turn[1]);
}

nkw_result nkw_track_sample_motion(const nkw_track *track, float time, nkw_motion_span out)
{
    const nkw_result result = track_check_readable(track);
    if (result != NKW_OK)
        return result;
    const nkw_segment segment = nkw_segment_find(track->times, track->count, time);
    const int moving = is_moving(track, segment, time);
    if (track_is_rotation(track))
        put_turn(track, segment, moving, out);
    else
        put_rates(track, segment, moving, out);
    return out.value ? nkw_track_sample_segment(track, segment, out.value) : NKW_OK;
}
