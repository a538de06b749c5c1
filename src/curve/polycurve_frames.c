/* SPDX-License-Identifier: MIT */
#include "polycurve_slopes.h"

/* Below this sine of the angle to the tangent a direction has no part perpendicular to it. */
#define FRAME_PARALLEL 0x1p-20

/* A derivative that is less than this times the largest of its terms counts as 0. */
#define HEADING_NOISE 0x1p-46

/* A frame in binary64; the binormal is t x n. */
typedef struct frame {
    lane_f64_vec3 t, n;
} frame;

static lane_f64_vec3 reject(lane_f64_vec3 a, lane_f64_vec3 unit)
{
    return lane_f64_vec3_add_scaled(a, unit, -lane_f64_vec3_dot(a, unit));
}

static int is_zero(lane_f64_vec3 a)
{
    return lane_f64_vec3_dot(a, a) == 0.0;
}

/* The frame of a unit tangent with the normal near `up`. */
static frame frame_from(lane_f64_vec3 tangent, lane_f64_vec3 up)
{
    lane_f64_vec3 side = reject(up, tangent);
    int parallel = !(lane_f64_vec3_length(side) > FRAME_PARALLEL * lane_f64_vec3_length(up));
    frame r = {tangent, lane_f64_vec3_perpendicular(tangent)};
    if (!parallel)
        r.n = lane_f64_vec3_normalize(reject(lane_f64_vec3_normalize(side), tangent));
    return r;
}

static nkw_curve_frame rounded(frame a)
{
    nkw_curve_frame r = {lane_vec3_from_f64(a.t), lane_vec3_from_f64(a.n),
                         lane_vec3_from_f64(lane_f64_vec3_cross(a.t, a.n))};
    return r;
}

static lane_f64_vec3 x_axis(void)
{
    lane_f64_vec3 r = {1.0, 0.0, 0.0};
    return r;
}

/* a/|a|; b/|b| if a is 0; the x axis if both are. */
static lane_f64_vec3 direction(lane_f64_vec3 a, lane_f64_vec3 b)
{
    lane_f64_vec3 other = is_zero(b) ? x_axis() : lane_f64_vec3_normalize(b);
    return is_zero(a) ? other : lane_f64_vec3_normalize(a);
}

static nkw_curve_frame frenet(lane_f64_vec3 v, lane_f64_vec3 a, nkw_vec3 before)
{
    lane_f64_vec3 across = lane_f64_vec3_cross(v, a), tangent = direction(v, a);
    if (!(lane_f64_vec3_length(across) > FRAME_PARALLEL * (lane_f64_vec3_length(v) * lane_f64_vec3_length(a))))
        return rounded(frame_from(tangent, lane_f64_vec3_from(before)));
    frame r = {tangent, lane_f64_vec3_cross(lane_f64_vec3_normalize(across), tangent)};
    return rounded(r);
}

nkw_curve_frame nkw_curve_frame_frenet(const nkw_vec3_motion *point, nkw_vec3 before)
{
    return frenet(lane_f64_vec3_from(point->velocity), lane_f64_vec3_from(point->acceleration), before);
}

/* Two vectors with the directions of p' and p' x p'' next to a place, inside of its segment. */
typedef struct heading {
    lane_f64_vec3 v, a;
} heading;

/*
 * Where p' = 0 at t, p' = s p'' + s^2/2 p''' at t + s: along p'' after t and against it before the end. Where p'' = 0
 * too, it is along p'''. What is less than the rounding of its terms counts as 0.
 */
static heading heading_at(const nkw_polycurve *curve, nkw_segment at)
{
    heading none = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
    if (curve->count == 0)
        return none;
    polycurve_slopes c =
        polycurve_slopes_of(curve->kind, &curve->cubics[at.index < curve->count - 1 ? at.index : curve->count - 1]);
    double t = (double)at.t, reach = 1.0 + lane_abs64(t), side = t < 1.0 ? 1.0 : -1.0;
    double noise = HEADING_NOISE * polycurve_size(&c) * (reach * reach);
    lane_f64_vec3 third = polycurve_third(&c);
    heading r = {polycurve_first(&c, t), polycurve_second(&c, t)};
    if (lane_f64_vec3_length(r.v) <= noise) {
        r.v = lane_f64_vec3_scale(r.a, side);
        r.a = lane_f64_vec3_scale(third, side);
    }
    if (lane_f64_vec3_length(r.v) <= noise) {
        r.v = third;
        r.a = none.a;
    }
    return r;
}

nkw_curve_frame nkw_polycurve_frenet(const nkw_polycurve *curve, nkw_segment at, nkw_vec3 before)
{
    heading h = heading_at(curve, at);
    return frenet(h.v, h.a, before);
}

/* Reflected in the plane through the origin perpendicular to v; unchanged for v = 0. */
static lane_f64_vec3 reflect(lane_f64_vec3 a, lane_f64_vec3 v)
{
    double n2 = lane_f64_vec3_dot(v, v);
    return lane_f64_vec3_add_scaled(a, v, n2 > 0.0 ? -2.0 * lane_f64_vec3_dot(v, a) / n2 : 0.0);
}

/*
 * The step between the points, then the tangents: each reflection maps a tangent to the next. Without a step, the first
 * one is along the tangent: both together are then the least rotation of the tangents.
 */
static frame transport(frame from, lane_f64_vec3 step, lane_f64_vec3 tangent)
{
    if (is_zero(step) && is_zero(tangent))
        return from;
    lane_f64_vec3 t = direction(tangent, step), v = is_zero(step) ? from.t : step;
    lane_f64_vec3 n = reflect(from.n, v), reached = reflect(from.t, v);
    return frame_from(t, reflect(n, lane_f64_vec3_sub(t, reached)));
}

nkw_curve_frame nkw_curve_frame_transport(const nkw_curve_frame *from, nkw_vec3 a, nkw_vec3 b, nkw_vec3 tangent)
{
    frame f = {lane_f64_vec3_from(from->tangent), lane_f64_vec3_from(from->normal)};
    lane_f64_vec3 step = lane_f64_vec3_sub(lane_f64_vec3_from(b), lane_f64_vec3_from(a));
    if (is_zero(step) && nkw_vec3_dot(tangent, tangent) == 0.0f && is_zero(lane_f64_vec3_from(tangent)))
        return *from;
    return rounded(transport(f, step, lane_f64_vec3_from(tangent)));
}

/* Even parameter i of a polycurve. */
static nkw_segment place_of(const nkw_polycurve *curve, size_t steps, size_t i)
{
    nkw_segment end = {curve->count - 1, 1.0f}, at = {i / steps, (float)((double)(i % steps) / (double)steps)};
    return i == curve->count * steps ? end : at;
}

/* A point with the direction of p' next to it. */
typedef struct course {
    nkw_vec3 at;
    lane_f64_vec3 tangent;
} course;

static course course_at(const nkw_polycurve *curve, size_t steps, size_t i)
{
    nkw_segment at = place_of(curve, steps, i);
    nkw_vec3_motion p = nkw_polycurve_evaluate(curve, at);
    course r = {p.value, lane_f64_vec3_from(p.velocity)};
    if (is_zero(r.tangent))
        r.tangent = heading_at(curve, at).v;
    return r;
}

static lane_f64_vec3 step_between(const course *a, const course *b)
{
    return lane_f64_vec3_sub(lane_f64_vec3_from(b->at), lane_f64_vec3_from(a->at));
}

static frame first_frame(const nkw_polycurve *curve, size_t steps, nkw_vec3 up)
{
    course a = course_at(curve, steps, 0), b = course_at(curve, steps, 1);
    return frame_from(direction(a.tangent, step_between(&a, &b)), lane_f64_vec3_from(up));
}

/*
 * Stores the frames, each turned by angle * (length so far) about its tangent. Returns the last frame without a turn;
 * *length receives the sum of the steps.
 */
static frame along(const nkw_polycurve *curve, size_t steps, frame f, double angle, nkw_curve_frame *frames,
                   double *length)
{
    course before = course_at(curve, steps, 0);
    *length = 0.0;
    for (size_t i = 0; i <= curve->count * steps; i++) {
        course at = course_at(curve, steps, i);
        lane_f64_vec3 step = step_between(&before, &at);
        f = i > 0 ? transport(f, step, at.tangent) : f;
        *length += lane_f64_vec3_length(step);
        lane_sincos turn = lane_sincos64_any((double)(float)(angle * *length));
        lane_f64_vec3 across = lane_f64_vec3_cross(f.t, f.n);
        frame turned = {f.t, lane_f64_vec3_add_scaled(lane_f64_vec3_scale(f.n, turn.c), across, turn.s)};
        frames[i] = rounded(turned);
        before = at;
    }
    return f;
}

nkw_result nkw_polycurve_frames(const nkw_polycurve *curve, size_t steps, nkw_vec3 up, nkw_polycurve_ends ends,
                                nkw_curve_frame *frames, size_t frame_count)
{
    if (curve->count == 0 || steps == 0)
        return NKW_EMPTY;
    if (frame_count == 0 || (frame_count - 1) / steps < curve->count)
        return NKW_TOO_SMALL;
    double length;
    frame first = first_frame(curve, steps, up), last = along(curve, steps, first, 0.0, frames, &length);
    if (ends != NKW_POLYCURVE_CLOSED)
        return NKW_OK;
    double sine = lane_f64_vec3_dot(first.n, lane_f64_vec3_cross(last.t, last.n));
    double angle = lane_atan2_64(sine, lane_f64_vec3_dot(first.n, last.n));
    along(curve, steps, first, length > 0.0 ? angle / length : 0.0, frames, &length);
    frames[curve->count * steps] = frames[0];
    return NKW_OK;
}
