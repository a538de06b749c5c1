/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/spring.h>
#include <nakawari/vec.h>

#include "lane/arc.h"
#include "lane/rotation_vector.h"
#include "lane/scalar.h"
#include "motion_component.h"
#include "spring_flow.h"

/* Bounds of what springs are made from. Slower ones would have a damping, but no stiffness that a float can show. */
#define LEAST_FREQUENCY 0x1p-62
#define MOST_FREQUENCY  0x1p62
#define MOST_RATIO      0x1p20

/* ---- The constants ---- */

/*
 * The time in which a spring of omega = 1 at rest halves its deviation, by bisection and Newton's method: the first
 * root of xx(h) = 1/2. It is at least pi/3, where there is no damping, and at most pi/3 + 2 ln 2 zeta.
 */
static double half_time(double ratio)
{
    double low = LANE_PI / 3.0, high = low + 2.0 * LANE_LN_2 * ratio, t = 0.5 * (low + high);
    if (!(ratio > 0.0))
        return ratio == ratio ? low : ratio;
    for (int i = 0; i < 64 && high - low > 0x1p-50 * high; i++) {
        flow m = flow_of(1.0, 2.0 * ratio, t);
        double excess = m.xx - 0.5, next = t - excess / m.vx;
        low = excess > 0.0 ? t : low;
        high = excess > 0.0 ? high : t;
        t = next > low && next < high ? next : 0.5 * (low + high);
    }
    return t;
}

static nkw_spring spring_of(double omega, double ratio)
{
    double known = omega < LEAST_FREQUENCY ? 0.0 : omega;
    double w = known < MOST_FREQUENCY ? known : known == known ? MOST_FREQUENCY : known;
    nkw_spring spring = {(float)(w * w), (float)(2.0 * w * ratio)};
    return spring;
}

nkw_spring nkw_spring_from_half_life(float half_life, float damping_ratio)
{
    double ratio = lane_limit64((double)damping_ratio, 0.0, MOST_RATIO);
    double omega = half_time(ratio) / (double)half_life;
    return spring_of(half_life <= 0.0f ? MOST_FREQUENCY : omega, ratio);
}

nkw_spring nkw_spring_from_frequency(float frequency, float damping_ratio)
{
    double ratio = lane_limit64((double)damping_ratio, 0.0, MOST_RATIO);
    return spring_of(LANE_TWO_PI * lane_limit64((double)frequency, 0.0, 0x1p60), ratio);
}

nkw_spring_description nkw_spring_describe(nkw_spring spring)
{
    double omega = lane_sqrt64(bounded(spring.stiffness)), damping = bounded(spring.damping);
    double ratio = damping == 0.0 ? 0.0 : damping / (2.0 * omega); /* 0 for 0/0 */
    nkw_spring_description r = {
        (float)(omega / LANE_TWO_PI),
        (float)ratio,
        omega == 0.0 ? INFINITY : (float)(half_time(ratio) / omega),
    };
    return r;
}

/* ---- Steps ---- */

/* How a spring comes to rest at its goal: not at all, by swinging, or with zeta >= 1/2 by settling. */
typedef enum spring_kind { DRIFTS, SWINGS, SETTLES } spring_kind;

static spring_kind kind_of(nkw_spring spring)
{
    double stiffness = bounded(spring.stiffness), damping = bounded(spring.damping);
    return stiffness > 0.0 && damping > 0.0 ? damping * damping >= stiffness ? SETTLES : SWINGS : DRIFTS;
}

/* Only on the way to the goal, and what swings not while it is still accelerated. */
static nkw_state step_of(const flow *m, nkw_state from, nkw_state goal, double h, spring_kind kind)
{
    double x = (double)from.value - (double)goal.value, v = (double)from.velocity - (double)goal.velocity;
    double g = (double)goal.value + (double)goal.velocity * h, gap = g - (double)from.value;
    nkw_state r = {(float)(g + (m->xx * x + m->xv * v)), (float)((double)goal.velocity + (m->vx * x + m->vv * v))};
    double gain = (double)r.velocity - (double)from.velocity;
    int nears = kind != DRIFTS && (double)from.velocity * gap > 0.0;
    if (nears && (kind == SETTLES || gain * gap <= 0.0))
        r.value = kept_moving(from.value, r.value, (float)g);
    return r;
}

nkw_state nkw_spring_step(nkw_spring spring, nkw_state from, nkw_state goal, float h)
{
    double seconds = bounded(h);
    flow m = flow_after(spring, seconds);
    return is_none(h) ? from : step_of(&m, from, goal, seconds, kind_of(spring));
}

nkw_vec3_state nkw_vec3_spring_step(nkw_spring spring, const nkw_vec3_state *from, const nkw_vec3_state *goal,
                                     float h)
{
    double seconds = bounded(h);
    flow m = flow_after(spring, seconds);
    spring_kind kind = kind_of(spring);
    nkw_state x = step_of(&m, motion_component(from, 0), motion_component(goal, 0), seconds, kind);
    nkw_state y = step_of(&m, motion_component(from, 1), motion_component(goal, 1), seconds, kind);
    nkw_state z = step_of(&m, motion_component(from, 2), motion_component(goal, 2), seconds, kind);
    nkw_vec3_state r = {{x.value, y.value, z.value}, {x.velocity, y.velocity, z.velocity}};
    return is_none(h) ? *from : r;
}

static lane_f64_vec3 combined(lane_f64_vec3 a, double s, lane_f64_vec3 b, double t)
{
    return lane_f64_vec3_add_scaled(lane_f64_vec3_scale(a, s), b, t);
}

/* A step of a rotation by this much, in half its angle, is more than its rounding and that of the length. */
#define LEAST_TURN 0x1.4p-23

/* Half the angle from g to q. */
static double half_angle(nkw_quat q, lane_f64_quat g)
{
    lane_f64_quat e;
    return lane_f64_vec3_length(error_of(lane_f64_quat_from(q), g, &e));
}

/* Whether rounding to `next` takes more than half of a step towards g, short, that turns from `before` to `after`. */
static int is_lost(nkw_quat next, lane_f64_quat g, double before, double after)
{
    double way = before - after;
    return way > 0.0 && way < LEAST_TURN && before - half_angle(next, g) < 0.5 * way;
}

/* Whether two unit quaternions may be a short step apart, rounding included. */
static int is_near(nkw_quat a, nkw_quat b)
{
    lane_f64_quat d = lane_f64_quat_sub(lane_f64_quat_from(a), lane_f64_quat_from(b));
    return lane_f64_quat_dot(d, d) < 0x1p-42;
}

/* kept_moving for a rotation: the value of `next`, by the least turn from `from` where the step to `after` is lost. */
static nkw_quat kept_turning(const nkw_quat_state *from, const nkw_quat_state *next, lane_f64_quat g, double after,
                             spring_kind kind)
{
    lane_f64_quat e;
    lane_f64_vec3 half = error_of(lane_f64_quat_unit_from(from->value), g, &e);
    lane_f64_vec3 spin = lane_f64_vec3_from(from->velocity), then = lane_f64_vec3_from(next->velocity);
    double n = lane_f64_vec3_length(half), left = n > LEAST_TURN ? 1.0 - LEAST_TURN / n : 0.0;
    int nears = lane_f64_vec3_dot(half, spin) < 0.0;
    int slows = kind == SETTLES || lane_f64_vec3_dot(half, lane_f64_vec3_sub(then, spin)) >= 0.0;
    nkw_quat moved = lane_quat_from_f64(lane_f64_quat_mul(lane_f64_quat_exp(lane_f64_vec3_scale(half, left)), g));
    return nears && slows && is_lost(next->value, g, n, after) ? moved : next->value;
}

nkw_quat_state nkw_quat_spring_step(nkw_spring spring, const nkw_quat_state *from, const nkw_quat_state *goal,
                                     float h)
{
    double seconds = bounded(h);
    flow m = flow_after(spring, seconds);
    lane_f64_quat x = lane_f64_quat_unit_from(from->value), g = lane_f64_quat_unit_from(goal->value), e;
    lane_f64_vec3 spin = lane_f64_vec3_from(from->velocity), turn = lane_f64_vec3_from(goal->velocity);
    lane_f64_vec3 half = error_of(x, g, &e);
    lane_f64_vec3 relative = lane_f64_vec3_sub(spin, lane_f64_quat_rotate(e, turn));
    lane_f64_vec3 rate = lane_f64_rotation_rate(e, half, relative);
    lane_f64_vec3 r = combined(half, 2.0 * m.xx, rate, m.xv), v = combined(half, 2.0 * m.vx, rate, m.vv);
    lane_sincos angle, unused;
    e = exp_of(lane_f64_vec3_scale(r, 0.5), &angle);
    g = lane_f64_quat_mul(exp_of(lane_f64_vec3_scale(turn, 0.5 * seconds), &unused), g);
    x = lane_f64_quat_mul(e, g);
    spin = lane_f64_vec3_add_scaled(lane_f64_rotation_velocity(r, angle, v), lane_f64_quat_rotate(e, turn), 1.0);
    nkw_quat_state out = {lane_quat_from_f64(x), lane_vec3_from_f64(spin)};
    if (kind_of(spring) != DRIFTS && is_near(out.value, from->value))
        out.value = kept_turning(from, &out, g, 0.5 * lane_f64_vec3_length(r), kind_of(spring));
    return is_none(h) ? *from : out;
}

/* 2^(-h / half_life); NaN if either is. */
static double halves(float half_life, float h)
{
    double n = (double)h / lane_divisor64((double)half_life), kept = n < 1000.0 ? lane_exp2_64(-n) : n == n ? 0.0 : n;
    return half_life > 0.0f || half_life != half_life ? kept : h == h ? 0.0 : (double)h;
}

static float damped(float from, float goal, double kept)
{
    float next = (float)((double)goal + ((double)from - (double)goal) * kept);
    return kept == 1.0 && goal - goal == 0.0f ? from : kept_moving(from, next, goal);
}

float nkw_damper_step(float from, float goal, float half_life, float h)
{
    return is_none(h) ? from : damped(from, goal, halves(half_life, h));
}

nkw_vec3 nkw_vec3_damper_step(nkw_vec3 from, nkw_vec3 goal, float half_life, float h)
{
    double k = halves(half_life, h);
    nkw_vec3 r = {damped(from.x, goal.x, k), damped(from.y, goal.y, k), damped(from.z, goal.z, k)};
    return is_none(h) ? from : r;
}

nkw_quat nkw_quat_damper_step(nkw_quat from, nkw_quat goal, float half_life, float h)
{
    double kept = halves(half_life, h);
    lane_f64_quat x = lane_f64_quat_from(from);
    lane_f64_quat g = lane_f64_quat_aligned(x, lane_f64_quat_from(goal), NKW_PATH_SHORT);
    lane_f64_arc arc = lane_f64_arc_between(x, g);
    nkw_quat next = lane_quat_from_f64(lane_f64_arc_at(&arc, (1.0 - kept) * arc.h, 0.0, 0));
    if (is_lost(next, g, arc.h, kept * arc.h))
        next = lane_quat_from_f64(lane_f64_arc_at(&arc, arc.h < LEAST_TURN ? arc.h : LEAST_TURN, 0.0, 0));
    next = lane_quat_select(kept == 0.0, lane_quat_from_f64(g), next);
    return is_none(h) || kept == 1.0 ? from : next;
}
