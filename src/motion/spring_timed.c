/* SPDX-License-Identifier: MIT */
/*
 * Springs that arrive at a time. Without help a spring that follows the point is at b(T) at the time T, not at the goal g.
 * An acceleration u is added to the spring; of all that arrive, the one with the least integral of u^2. With the motion
 * E(t) of a deviation in t seconds, a matrix, and the reach
 *
 *     W(t) = integral from 0 to t of e e^T,     e(s) the second column of E(s), what an impulse leaves
 *
 *     u(t) = e(T - t)^T l,     W(T) l = (g, 0) - b(T),     state(h) = b(h) + W(h) E(T - h)^T l
 *
 * From any state on its way, what is left of the least u is the least u that is left: steps compose.
 */
#include "lane/strict.h"

#include <nakawari/spring.h>
#include <nakawari/vec.h>

#include "lane/rotation_vector.h"
#include "motion_component.h"
#include "spring_flow.h"

/* A deviation and its rate. */
typedef struct moving64 {
    double value, velocity;
} moving64;

static moving64 flowed(const flow *m, moving64 e)
{
    moving64 r = {m->xx * e.value + m->xv * e.velocity, m->vx * e.value + m->vv * e.velocity};
    return r;
}

/* ---- What an acceleration reaches ---- */

/* The symmetric matrix W. */
typedef struct reach {
    double xx, xv, vv;
} reach;

/* The nodes of Gauss and Legendre on 0..1 and their weights: to 2^-30 for phases up to 1/2. */
static const double nodes[4] = {0x1.1c6490c2719ecp-4, 0x1.51ee013116102p-2, 0x1.5708ff6774f7fp-1, 0x1.dc736de7b1cc2p-1};
static const double shares[4] = {0x1.64340f7e7b66bp-3, 0x1.4de5f840c24cbp-2, 0x1.4de5f840c24cbp-2, 0x1.64340f7e7b66bp-3};

static reach short_reach(double stiffness, double damping, double h)
{
    reach w = {0.0, 0.0, 0.0};
    for (int i = 0; i < 4; i++) {
        flow m = flow_of(stiffness, damping, h * nodes[i]);
        w.xx += shares[i] * h * (m.xv * m.xv);
        w.xv += shares[i] * h * (m.xv * m.vv);
        w.vv += shares[i] * h * (m.vv * m.vv);
    }
    return w;
}

/* W(2 h) = W(h) + E(h) W(h) E(h)^T: sums of what is not negative. */
static reach doubled(reach w, const flow *m)
{
    moving64 first = {m->xx * w.xx + m->xv * w.xv, m->xx * w.xv + m->xv * w.vv};
    moving64 second = {m->vx * w.xx + m->vv * w.xv, m->vx * w.xv + m->vv * w.vv};
    reach r = {w.xx + (m->xx * first.value + m->xv * first.velocity),
               w.xv + (m->vx * first.value + m->vv * first.velocity),
               w.vv + (m->vx * second.value + m->vv * second.velocity)};
    return r;
}

static reach reach_of(double stiffness, double damping, double h)
{
    double rate = damping > lane_sqrt64(stiffness) ? damping : lane_sqrt64(stiffness);
    double part = h;
    int doublings = 0;
    for (; rate * part > 0.5; part *= 0.5)
        doublings++;
    reach w = short_reach(stiffness, damping, part);
    for (int i = 0; i < doublings; i++, part *= 2.0) {
        flow m = flow_of(stiffness, damping, part);
        w = doubled(w, &m);
    }
    return w;
}

/* The solution l of W l = e. */
static moving64 solution_of(const reach *w, moving64 e)
{
    double determinant = w->xx * w->vv - w->xv * w->xv;
    moving64 l = {(w->vv * e.value - w->xv * e.velocity) / determinant,
                  (w->xx * e.velocity - w->xv * e.value) / determinant};
    return l;
}

/* ---- Steps ---- */

/* A step on the way, and the way. The point moves in the first part of each, and rests at the goal in the second. */
typedef struct timed_plan {
    flow moving, resting, last_moving, last_resting, rest; /* rest: from the end of the step to the time */
    reach step, way;
    double h, moves, left, last_moves; /* seconds: of the step, of its first part, of the way, of its first part */
} timed_plan;

static timed_plan plan_of(nkw_spring spring, double left, double h)
{
    double k = bounded(spring.stiffness), d = bounded(spring.damping), lead = k > 0.0 ? d / k : 0.0;
    double last = left > lead ? left - lead : 0.0, moves = last < h ? last : h;
    timed_plan p = {
        flow_of(k, d, moves),       flow_of(k, d, h - moves), flow_of(k, d, last),
        flow_of(k, d, left - last), flow_of(k, d, left - h),  reach_of(k, d, h),
        reach_of(k, d, left),       h,                        moves,
        left,                       last,
    };
    return p;
}

/* The spring that follows a point without help: both from the goal, `rate` that of the point. */
static moving64 unhelped(const flow *moving, const flow *resting, moving64 x, double point, double rate, double moves)
{
    moving64 e = {x.value - point, x.velocity - rate};
    e = flowed(moving, e);
    e.value += point + rate * moves;
    e.velocity += rate;
    return flowed(resting, e);
}

/* The state after the step, from the goal. */
static moving64 arriving(const timed_plan *p, moving64 x, double point)
{
    double rate = p->last_moves > 0.0 ? -point / p->left : 0.0, at = p->last_moves > 0.0 ? point : 0.0;
    moving64 now = unhelped(&p->moving, &p->resting, x, at, rate, p->moves);
    moving64 end = unhelped(&p->last_moving, &p->last_resting, x, at, rate, p->last_moves);
    moving64 miss = {-end.value, -end.velocity}, l = solution_of(&p->way, miss);
    double value = p->rest.xx * l.value + p->rest.vx * l.velocity;
    double velocity = p->rest.xv * l.value + p->rest.vv * l.velocity;
    moving64 r = {now.value + (p->step.xx * value + p->step.xv * velocity),
                  now.velocity + (p->step.xv * value + p->step.vv * velocity)};
    return r;
}

/* The time left after a step of h. */
static float time_after(float left, float h)
{
    double after = bounded(left) - (double)h;
    return after > 0.0 ? kept_moving(left, (float)after, 0.0f) : 0.0f;
}

/* Whether the point is still on its way at the end of the step. */
static int is_moving(const timed_plan *p)
{
    return p->moves == p->h && p->h < p->last_moves;
}

static void timed_step(const timed_plan *p, nkw_state *state, nkw_state *point, float goal)
{
    double g = (double)goal, way = (double)point->value - g, rate = -way / p->left;
    moving64 from = {(double)state->value - g, (double)state->velocity};
    moving64 to = arriving(p, from, way);
    nkw_state next = {(float)(g + to.value), (float)to.velocity}, still = {goal, 0.0f};
    nkw_state on = {(float)(g + (way + rate * p->h)), (float)rate};
    *state = next;
    *point = is_moving(p) ? on : still;
}

void nkw_spring_timed_step(nkw_spring_timed *timed, float goal, float h)
{
    const nkw_state still = {goal, 0.0f};
    float left = timed->time_left;
    if (is_none(h))
        return;
    timed->time_left = time_after(left, h);
    if (!(left > 0.0f)) {
        timed->state = nkw_spring_step(timed->spring, timed->state, still, h);
        timed->point = still;
    } else if (!(timed->time_left > 0.0f)) {
        timed->state = timed->point = still;
    } else {
        timed_plan p = plan_of(timed->spring, bounded(left), bounded(h));
        timed_step(&p, &timed->state, &timed->point, goal);
    }
}

void nkw_vec3_spring_timed_step(nkw_vec3_spring_timed *timed, nkw_vec3 goal, float h)
{
    nkw_spring_timed x = {timed->spring, timed->time_left, motion_component(&timed->state, 0),
                          motion_component(&timed->point, 0)};
    nkw_spring_timed y = {timed->spring, timed->time_left, motion_component(&timed->state, 1),
                          motion_component(&timed->point, 1)};
    nkw_spring_timed z = {timed->spring, timed->time_left, motion_component(&timed->state, 2),
                          motion_component(&timed->point, 2)};
    nkw_spring_timed_step(&x, goal.x, h);
    nkw_spring_timed_step(&y, goal.y, h);
    nkw_spring_timed_step(&z, goal.z, h);
    nkw_vec3_state state = {{x.state.value, y.state.value, z.state.value},
                            {x.state.velocity, y.state.velocity, z.state.velocity}};
    nkw_vec3_state point = {{x.point.value, y.point.value, z.point.value},
                            {x.point.velocity, y.point.velocity, z.point.velocity}};
    timed->time_left = x.time_left;
    timed->state = state;
    timed->point = point;
}

static lane_f64_vec3 vec64(double x, double y, double z)
{
    lane_f64_vec3 v = {x, y, z};
    return v;
}

/* In rotation vectors from the goal: their rates are converted to angular velocities, as in nkw_quat_spring_step. */
static void quat_timed_step(const timed_plan *p, nkw_quat_state *state, nkw_quat_state *point, nkw_quat goal)
{
    lane_f64_quat g = lane_f64_quat_unit_from(goal), e, unused;
    lane_f64_vec3 half = error_of(lane_f64_quat_unit_from(state->value), g, &e);
    lane_f64_vec3 rate = lane_f64_rotation_rate(e, half, lane_f64_vec3_from(state->velocity));
    lane_f64_vec3 way = lane_f64_vec3_scale(error_of(lane_f64_quat_unit_from(point->value), g, &unused), 2.0);
    const moving64 from[3] = {{2.0 * half.x, rate.x}, {2.0 * half.y, rate.y}, {2.0 * half.z, rate.z}};
    moving64 x = arriving(p, from[0], way.x), y = arriving(p, from[1], way.y), z = arriving(p, from[2], way.z);
    lane_f64_vec3 r = vec64(x.value, y.value, z.value), v = vec64(x.velocity, y.velocity, z.velocity);
    lane_sincos angle;
    e = exp_of(lane_f64_vec3_scale(r, 0.5), &angle);
    state->value = lane_quat_from_f64(lane_f64_quat_mul(e, g));
    state->velocity = lane_vec3_from_f64(lane_f64_rotation_velocity(r, angle, v));
    double left = is_moving(p) ? 0.5 * (p->left - p->h) / p->left : 0.0, speed = is_moving(p) ? -1.0 / p->left : 0.0;
    e = exp_of(lane_f64_vec3_scale(way, left), &angle);
    point->value = lane_quat_from_f64(lane_f64_quat_mul(e, g));
    point->velocity = lane_vec3_from_f64(lane_f64_vec3_scale(way, speed));
}

void nkw_quat_spring_timed_step(nkw_quat_spring_timed *timed, nkw_quat goal, float h)
{
    const nkw_quat_state still = {lane_quat_from_f64(lane_f64_quat_unit_from(goal)), {0.0f, 0.0f, 0.0f}};
    float left = timed->time_left;
    if (is_none(h))
        return;
    timed->time_left = time_after(left, h);
    if (!(left > 0.0f)) {
        timed->state = nkw_quat_spring_step(timed->spring, &timed->state, &still, h);
        timed->point = still;
    } else if (!(timed->time_left > 0.0f)) {
        timed->state = timed->point = still;
    } else {
        timed_plan p = plan_of(timed->spring, bounded(left), bounded(h));
        quat_timed_step(&p, &timed->state, &timed->point, goal);
    }
}
