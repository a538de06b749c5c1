/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/curve.h>
#include <nakawari/inertia.h>
#include <nakawari/rotation.h>
#include <nakawari/vec.h>

#include "lane/offset.h"
#include "motion_component.h"

static lane_f64_vec3 difference_of(nkw_vec3 a, nkw_vec3 b)
{
    return lane_f64_vec3_sub(lane_f64_vec3_from(a), lane_f64_vec3_from(b));
}

nkw_inertia nkw_inertia_begin(nkw_state from, nkw_state to, float duration)
{
    lane_f64_vec3 x = {(double)from.value - (double)to.value, 0.0, 0.0};
    lane_f64_vec3 v = {(double)from.velocity - (double)to.velocity, 0.0, 0.0};
    lane_inertia_c i = lane_inertia_begin(x, v, duration);
    nkw_inertia r = {{i.c0.x, i.c1.x, i.c2.x}, i.duration};
    return r;
}

static nkw_vec3_inertia inertia_of(lane_inertia_c i)
{
    nkw_vec3_inertia r = {{i.c0, i.c1, i.c2}, i.duration};
    return r;
}

nkw_vec3_inertia nkw_vec3_inertia_begin(const nkw_vec3_state *from, const nkw_vec3_state *to, float duration)
{
    lane_f64_vec3 x = difference_of(from->value, to->value), v = difference_of(from->velocity, to->velocity);
    return inertia_of(lane_inertia_begin(x, v, duration));
}

nkw_vec3_inertia nkw_quat_inertia_begin(const nkw_quat_state *from, const nkw_quat_state *to, float duration)
{
    lane_rotation_offset x = lane_rotation_offset_of(from->value, from->velocity, to->value, to->velocity);
    return inertia_of(lane_inertia_begin_quat(x, duration));
}

/* The rate of the offset: (1 - u)^2 ((1 - u) p' - 3 p) / duration, p = c[0] + c[1] u + c[2] u^2. */
static double offset_rate(float c0, float c1, float c2, double u, float duration)
{
    double w = 1.0 - u, p = (double)c0 + u * ((double)c1 + u * (double)c2), slope = (double)c1 + 2.0 * (u * (double)c2);
    return (w * w) * (w * slope - 3.0 * p) / lane_divisor64((double)duration);
}

static lane_f64_vec3 offset_rate_vec3(const nkw_vec3_inertia *i, double u)
{
    lane_f64_vec3 r = {
        offset_rate(i->c[0].x, i->c[1].x, i->c[2].x, u, i->duration),
        offset_rate(i->c[0].y, i->c[1].y, i->c[2].y, u, i->duration),
        offset_rate(i->c[0].z, i->c[1].z, i->c[2].z, u, i->duration),
    };
    return r;
}

nkw_state nkw_inertia_evaluate(nkw_inertia inertia, nkw_state to, float t)
{
    const float *c = inertia.c;
    double u = lane_inertia_time(t, inertia.duration);
    nkw_state r = {
        lane_inertia_value(to.value, lane_inertia_offset(c[0], c[1], c[2], u), u),
        lane_inertia_value(to.velocity, offset_rate(c[0], c[1], c[2], u, inertia.duration), u),
    };
    return r;
}

nkw_vec3_state nkw_vec3_inertia_evaluate(const nkw_vec3_inertia *inertia, const nkw_vec3_state *to, float t)
{
    double u = lane_inertia_time(t, inertia->duration);
    lane_f64_vec3 offset = lane_inertia_offset_vec3(inertia->c[0], inertia->c[1], inertia->c[2], u);
    nkw_vec3_state r = {
        lane_inertia_value_vec3(to->value, offset, u),
        lane_inertia_value_vec3(to->velocity, offset_rate_vec3(inertia, u), u),
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

nkw_quat_state nkw_quat_inertia_evaluate(const nkw_vec3_inertia *inertia, const nkw_quat_state *to, float t)
{
    double u = lane_inertia_time(t, inertia->duration);
    if (!(u < 1.0))
        return *to;
    lane_f64_vec3 offset = lane_inertia_offset_vec3(inertia->c[0], inertia->c[1], inertia->c[2], u);
    nkw_quat_state r = {
        lane_inertia_value_quat(to->value, offset, u),
        velocity_of(offset, offset_rate_vec3(inertia, u), to->velocity),
    };
    return r;
}

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

nkw_state nkw_dead_blend_evaluate(const nkw_dead_blend *blend, nkw_state to, float t)
{
    lane_dead_time at = lane_dead_time_at(blend->half_life, blend->duration, t);
    return dead_blend(blend->from, to, &at);
}

nkw_vec3_state nkw_vec3_dead_blend_evaluate(const nkw_vec3_dead_blend *blend, const nkw_vec3_state *to, float t)
{
    lane_dead_time at = lane_dead_time_at(blend->half_life, blend->duration, t);
    const nkw_vec3_state *a = &blend->from;
    nkw_state x = dead_blend(motion_component(a, 0), motion_component(to, 0), &at);
    nkw_state y = dead_blend(motion_component(a, 1), motion_component(to, 1), &at);
    nkw_state z = dead_blend(motion_component(a, 2), motion_component(to, 2), &at);
    nkw_vec3_state r = {{x.value, y.value, z.value}, {x.velocity, y.velocity, z.velocity}};
    return r;
}

nkw_quat_state nkw_quat_dead_blend_evaluate(nkw_quat_dead_blend *blend, const nkw_quat_state *to, float t)
{
    lane_dead_time at = lane_dead_time_at(blend->half_life, blend->duration, t);
    lane_f64_quat old = lane_dead_old_quat(blend->from.value, blend->from.velocity, at.carried);
    lane_f64_quat d = lane_dead_difference(old, to->value, blend->difference);
    lane_f64_vec3 half = lane_f64_quat_log(d), w = lane_f64_vec3_from(blend->from.velocity);
    lane_f64_vec3 left = lane_f64_vec3_scale(w, at.left), to_rate = lane_f64_vec3_from(to->velocity);
    lane_f64_vec3 rate = lane_difference_rate(d, half, left, to_rate);
    rate = lane_f64_vec3_add_scaled(lane_f64_vec3_scale(rate, 1.0 - at.s), half, -at.rate);
    nkw_quat_state r = {
        lane_dead_value_quat(d, to->value, at.s),
        velocity_of(lane_f64_vec3_scale(half, 1.0 - at.s), rate, to->velocity),
    };
    blend->difference = lane_quat_from_f64(d);
    return at.s == 1.0 ? *to : r;
}

float nkw_dead_blend_half_life(nkw_state from, float to, float half_life, float least, float most)
{
    float way = half_life * ((to - from.value) / lane_divisor(from.velocity));
    float least_or_more = way < least ? least : way;
    return from.velocity != 0.0f && least_or_more < most ? least_or_more : most;
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
