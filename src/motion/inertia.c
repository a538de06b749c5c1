/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/curve.h>
#include <nakawari/inertia.h>
#include <nakawari/rotation.h>
#include <nakawari/vec.h>

#include "lane/offset.h"
#include "motion_component.h"

/* When a dead blend ends. */
static float dead_end(float duration)
{
    return duration > 0.0f ? duration : 0.0f;
}

void nkw_offset_begin(nkw_offset *offset, nkw_state from, nkw_state to)
{
    nkw_offset r = {offset->kind, offset->duration, offset->half_life, dead_end(offset->duration), from, {0, 0, 0}};
    if (offset->kind != NKW_OFFSET_DEAD_BLEND) {
        lane_f64_vec3 x = {(double)from.value - (double)to.value, 0.0, 0.0};
        lane_f64_vec3 v = {(double)from.velocity - (double)to.velocity, 0.0, 0.0};
        lane_inertia_c i = lane_inertia_begin(x, v, offset->duration);
        r.end = i.duration;
        r.c[0] = i.c0.x;
        r.c[1] = i.c1.x;
        r.c[2] = i.c2.x;
    }
    *offset = r;
}

static const nkw_vec3 zero = {0.0f, 0.0f, 0.0f};

static void put_coefficients(lane_inertia_c i, float *end, nkw_vec3 *c)
{
    *end = i.duration;
    c[0] = i.c0;
    c[1] = i.c1;
    c[2] = i.c2;
}

void nkw_vec3_offset_begin(nkw_vec3_offset *offset, const nkw_vec3_state *from, const nkw_vec3_state *to)
{
    lane_inertia_c i = {zero, zero, zero, dead_end(offset->duration)};
    if (offset->kind != NKW_OFFSET_DEAD_BLEND) {
        lane_f64_vec3 x = lane_vec3_difference(from->value, to->value), v = lane_vec3_difference(from->velocity, to->velocity);
        i = lane_inertia_begin(x, v, offset->duration);
    }
    offset->from = *from;
    put_coefficients(i, &offset->end, offset->c);
}

void nkw_quat_offset_begin(nkw_quat_offset *offset, const nkw_quat_state *from, const nkw_quat_state *to)
{
    const nkw_quat none = {0.0f, 0.0f, 0.0f, 0.0f};
    lane_inertia_c i = {zero, zero, zero, dead_end(offset->duration)};
    if (offset->kind != NKW_OFFSET_DEAD_BLEND) {
        lane_rotation_offset x = lane_rotation_offset_of(from->value, from->velocity, to->value, to->velocity);
        i = lane_inertia_begin_quat(x, offset->duration);
    }
    offset->from = *from;
    offset->difference = none;
    put_coefficients(i, &offset->end, offset->c);
}

/* ---- Inertialisation ---- */

/* The rate of the offset: (1 - u)^2 ((1 - u) p' - 3 p) / end, p = c[0] + c[1] u + c[2] u^2. */
static double offset_rate(float c0, float c1, float c2, double u, float end)
{
    double w = 1.0 - u, p = (double)c0 + u * ((double)c1 + u * (double)c2), slope = (double)c1 + 2.0 * (u * (double)c2);
    return (w * w) * (w * slope - 3.0 * p) / lane_divisor64((double)end);
}

static lane_f64_vec3 offset_rate_vec3(const nkw_vec3 *c, double u, float end)
{
    lane_f64_vec3 r = {
        offset_rate(c[0].x, c[1].x, c[2].x, u, end),
        offset_rate(c[0].y, c[1].y, c[2].y, u, end),
        offset_rate(c[0].z, c[1].z, c[2].z, u, end),
    };
    return r;
}

static nkw_state inertia(const nkw_offset *offset, nkw_state to, float t)
{
    const float *c = offset->c;
    double u = lane_inertia_time(t, offset->end);
    nkw_state r = {
        lane_inertia_value(to.value, lane_inertia_offset(c[0], c[1], c[2], u), u),
        lane_inertia_value(to.velocity, offset_rate(c[0], c[1], c[2], u, offset->end), u),
    };
    return r;
}

static nkw_vec3_state inertia_vec3(const nkw_vec3_offset *offset, const nkw_vec3_state *to, float t)
{
    const nkw_vec3 *c = offset->c;
    double u = lane_inertia_time(t, offset->end);
    nkw_vec3_state r = {
        lane_inertia_value_vec3(to->value, lane_inertia_offset_vec3(c[0], c[1], c[2], u), u),
        lane_inertia_value_vec3(to->velocity, offset_rate_vec3(c, u, offset->end), u),
    };
    return r;
}

/* The angular velocity of exp(half) to, whose parts have the rates `rate` and `to`. */
static nkw_vec3 velocity_of(lane_f64_vec3 half, lane_f64_vec3 rate, nkw_vec3 to)
{
    lane_sincos turn = lane_turn64(lane_f64_vec3_length(half));
    lane_f64_quat d = lane_f64_quat_from_axis_half(lane_f64_vec3_normalize(half), turn);
    lane_f64_vec3 own =
        lane_f64_rotation_velocity(lane_f64_vec3_scale(half, 2.0), turn, lane_f64_vec3_scale(rate, 2.0));
    lane_f64_vec3 carried = lane_f64_quat_rotate(d, lane_f64_vec3_from(to));
    return lane_vec3_from_f64(lane_f64_vec3_add_scaled(own, carried, 1.0));
}

static nkw_quat_state inertia_quat(const nkw_quat_offset *offset, const nkw_quat_state *to, float t)
{
    const nkw_vec3 *c = offset->c;
    double u = lane_inertia_time(t, offset->end);
    if (!(u < 1.0))
        return *to;
    lane_f64_vec3 half = lane_inertia_offset_vec3(c[0], c[1], c[2], u);
    nkw_quat_state r = {
        lane_inertia_value_quat(to->value, half, u),
        velocity_of(half, offset_rate_vec3(c, u, offset->end), to->velocity),
    };
    return r;
}

/* ---- Dead blending ---- */

/* The velocity of a blend: of both velocities, and of the weight. */
static float blended_rate(nkw_state from, nkw_state to, double old, const lane_dead_time *at)
{
    double rate = (double)from.velocity * at->left, end = (double)to.velocity;
    double blended = rate + at->s * (end - rate) + at->rate * ((double)to.value - old);
    return (float)(at->s == 1.0 ? end : at->s == 0.0 ? rate : blended);
}

static nkw_state dead_blend(nkw_state from, nkw_state to, const lane_dead_time *at)
{
    double old = lane_dead_old(from.value, from.velocity, at->carried);
    nkw_state r = {lane_dead_blend(old, to.value, at->s), blended_rate(from, to, old, at)};
    return r;
}

static nkw_vec3_state dead_blend_vec3(const nkw_vec3_state *from, const nkw_vec3_state *to, const lane_dead_time *at)
{
    nkw_state x = dead_blend(motion_component(from, 0), motion_component(to, 0), at);
    nkw_state y = dead_blend(motion_component(from, 1), motion_component(to, 1), at);
    nkw_state z = dead_blend(motion_component(from, 2), motion_component(to, 2), at);
    nkw_vec3_state r = {{x.value, y.value, z.value}, {x.velocity, y.velocity, z.velocity}};
    return r;
}

static nkw_quat_state dead_blend_quat(nkw_quat_offset *offset, const nkw_quat_state *to, const lane_dead_time *at)
{
    lane_f64_quat old = lane_dead_old_quat(offset->from.value, offset->from.velocity, at->carried);
    lane_f64_quat d = lane_dead_difference(old, to->value, offset->difference);
    lane_f64_vec3 half = lane_f64_quat_log(d), w = lane_f64_vec3_from(offset->from.velocity);
    lane_f64_vec3 left = lane_f64_vec3_scale(w, at->left), to_rate = lane_f64_vec3_from(to->velocity);
    lane_f64_vec3 rate = lane_difference_rate(d, half, left, to_rate);
    rate = lane_f64_vec3_add_scaled(lane_f64_vec3_scale(rate, 1.0 - at->s), half, -at->rate);
    nkw_quat_state r = {
        lane_dead_value_quat(d, to->value, at->s),
        velocity_of(lane_f64_vec3_scale(half, 1.0 - at->s), rate, to->velocity),
    };
    offset->difference = lane_quat_from_f64(d);
    return at->s == 1.0 ? *to : r;
}

/* ---- Either kind ---- */

nkw_state nkw_offset_evaluate(const nkw_offset *offset, nkw_state to, float t)
{
    if (offset->kind != NKW_OFFSET_DEAD_BLEND)
        return inertia(offset, to, t);
    lane_dead_time at = lane_dead_time_at(offset->half_life, offset->end, t);
    return dead_blend(offset->from, to, &at);
}

nkw_vec3_state nkw_vec3_offset_evaluate(const nkw_vec3_offset *offset, const nkw_vec3_state *to, float t)
{
    if (offset->kind != NKW_OFFSET_DEAD_BLEND)
        return inertia_vec3(offset, to, t);
    lane_dead_time at = lane_dead_time_at(offset->half_life, offset->end, t);
    return dead_blend_vec3(&offset->from, to, &at);
}

nkw_quat_state nkw_quat_offset_evaluate(nkw_quat_offset *offset, const nkw_quat_state *to, float t)
{
    if (offset->kind != NKW_OFFSET_DEAD_BLEND)
        return inertia_quat(offset, to, t);
    lane_dead_time at = lane_dead_time_at(offset->half_life, offset->end, t);
    return dead_blend_quat(offset, to, &at);
}

nkw_body_motion nkw_body_motion_between(const nkw_body_motion *a, const nkw_body_motion *b, float duration, float t)
{
    float h = duration > 0.0f && duration < INFINITY ? duration : 0.0f;
    nkw_vec3 none = {0.0f, 0.0f, 0.0f};
    nkw_vec3_cubic cubic = {{a->position.value, none, b->position.value, none}};
    if (h > 0.0f) {
        cubic.c[1] = nkw_vec3_scale(a->position.velocity, h);
        cubic.c[3] = nkw_vec3_scale(b->position.velocity, h);
    }
    nkw_vec3_motion position = nkw_vec3_cubic_evaluate(&cubic, t, NKW_CUBIC_HERMITE);
    nkw_rotation_segment segment =
        nkw_rotation_from_hermite(a->rotation.value, a->rotation.velocity, b->rotation.value, b->rotation.velocity, h);
    nkw_quat_motion rotation = nkw_rotation_evaluate(&segment, t);
    nkw_body_motion r = {
        {position.value, h > 0.0f ? nkw_vec3_scale(position.velocity, 1.0f / h) : none},
        {rotation.value, rotation.velocity},
    };
    return r;
}
