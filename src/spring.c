/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/spring.h>

#include "lane/orient.h"
#include "lane/scalar.h"

/* Bounds of what springs are made from. Slower ones would have a damping, but no stiffness that a float can show. */
#define LEAST_FREQUENCY 0x1p-62
#define MOST_FREQUENCY  0x1p62
#define MOST_RATIO      0x1p20

/* max(x, 0), at most the largest float; NaN stays. -0 becomes 0. */
static double bounded(float x)
{
    double most = (double)FLT_MAX;
    return lane_limit64((double)x + 0.0, 0.0, most);
}

/* The deviation e of a spring without a goal after h seconds: e(h) = xx e + xv e', e'(h) = vx e + vv e'. */
typedef struct flow {
    double xx, xv, vx, vv;
} flow;

/*
 * With y = damping/2, q = y^2 - stiffness, z = q h^2, c and s the functions of z that are
 *
 *     cosh sqrt z and h sinh(sqrt z) / sqrt z,  for z < 0  cos sqrt -z and h sin(sqrt -z) / sqrt -z
 *
 *     xx = e^-yh (c + y s),   xv = e^-yh s,   vx = -stiffness xv,   vv = e^-yh (c - y s)
 */
static flow flow_by(double stiffness, double y, double decay, lane_sincos a)
{
    flow m = {decay * (a.c + y * a.s), decay * a.s, -stiffness * (decay * a.s), decay * (a.c - y * a.s)};
    return m;
}

/* Critical damping and its neighbourhood, |z| < 1/4: the series of both functions in z, to 2^-50. */
static lane_sincos near_critical(double z, double h)
{
    double c = 1.0 + z / 2.0 * (1.0 + z / 12.0 * (1.0 + z / 30.0 * (1.0 + z / 56.0 * (1.0 + z / 90.0))));
    double s = 1.0 + z / 6.0 * (1.0 + z / 20.0 * (1.0 + z / 42.0 * (1.0 + z / 72.0 * (1.0 + z / 110.0))));
    lane_sincos a = {h * s, c};
    return a;
}

static lane_sincos underdamped(double q, double h)
{
    double w = lane_sqrt64(-q);
    lane_sincos a = lane_turn64_long(w * h);
    a.s = a.s / w;
    return a;
}

/*
 * By the two exponentials, of rates r = y - w = stiffness/(y + w) and y + w, w^2 = q:
 *
 *     2 xx = e^-rh (1 + y/w) - e^-(y + w)h r/w,      2 vv = e^-(y + w)h (1 + y/w) - e^-rh r/w
 */
static flow overdamped(double stiffness, double y, double q, double h)
{
    double w = lane_sqrt64(q), r = stiffness / (y + w);
    double slow = 0.5 * lane_decay64(r * h), fast = slow * lane_decay64(2.0 * w * h);
    double rest = r / w, more = 1.0 + y / w;
    double xv = (slow - fast) / w;
    flow m = {slow * more - fast * rest, xv, -stiffness * xv, fast * more - slow * rest};
    return m;
}

static flow flow_of(double stiffness, double damping, double h)
{
    double y = 0.5 * damping, q = y * y - stiffness, z = q * h * h;
    if (z >= 0.25)
        return overdamped(stiffness, y, q, h);
    return flow_by(stiffness, y, lane_decay64(y * h), z > -0.25 ? near_critical(z, h) : underdamped(q, h));
}

static flow flow_after(nkw_spring spring, double h)
{
    return flow_of(bounded(spring.stiffness), bounded(spring.damping), h);
}

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

float nkw_spring_frequency(nkw_spring spring)
{
    return (float)(lane_sqrt64(bounded(spring.stiffness)) / LANE_TWO_PI);
}

/* 0 for 0/0. */
static double ratio_of(nkw_spring spring)
{
    double damping = bounded(spring.damping);
    return damping == 0.0 ? 0.0 : damping / (2.0 * lane_sqrt64(bounded(spring.stiffness)));
}

float nkw_spring_damping_ratio(nkw_spring spring)
{
    return (float)ratio_of(spring);
}

float nkw_spring_half_life(nkw_spring spring)
{
    double omega = lane_sqrt64(bounded(spring.stiffness));
    return omega == 0.0 ? INFINITY : (float)(half_time(ratio_of(spring)) / omega);
}

/* ---- Steps ---- */

/* Whether a step of h changes nothing. */
static int is_none(float h)
{
    return h <= 0.0f;
}

static nkw_motion step_of(const flow *m, nkw_motion from, nkw_motion goal, double h)
{
    double x = (double)from.value - (double)goal.value, v = (double)from.velocity - (double)goal.velocity;
    double g = (double)goal.value + (double)goal.velocity * h;
    nkw_motion r = {(float)(g + (m->xx * x + m->xv * v)), (float)((double)goal.velocity + (m->vx * x + m->vv * v))};
    return r;
}

nkw_motion nkw_spring_step(nkw_spring spring, nkw_motion from, nkw_motion goal, float h)
{
    double seconds = bounded(h);
    flow m = flow_after(spring, seconds);
    return is_none(h) ? from : step_of(&m, from, goal, seconds);
}

static nkw_motion motion_of(float value, float velocity)
{
    nkw_motion m = {value, velocity};
    return m;
}

#define MOTION_AT(m, c) motion_of((m)->value.c, (m)->velocity.c)

nkw_vec3_motion nkw_vec3_spring_step(nkw_spring spring, const nkw_vec3_motion *from, const nkw_vec3_motion *goal,
                                     float h)
{
    double seconds = bounded(h);
    flow m = flow_after(spring, seconds);
    nkw_motion x = step_of(&m, MOTION_AT(from, x), MOTION_AT(goal, x), seconds);
    nkw_motion y = step_of(&m, MOTION_AT(from, y), MOTION_AT(goal, y), seconds);
    nkw_motion z = step_of(&m, MOTION_AT(from, z), MOTION_AT(goal, z), seconds);
    nkw_vec3_motion r = {{x.value, y.value, z.value}, {x.velocity, y.velocity, z.velocity}};
    return is_none(h) ? *from : r;
}

/* exp v: any angle, without the rounding to float from 2^20 rad on. */
static lane_f64_quat exp_of(lane_f64_vec3 half, lane_sincos *turn)
{
    *turn = lane_turn64_long(lane_f64_vec3_length(half));
    return lane_f64_quat_from_axis_half(lane_f64_vec3_normalize(half), *turn);
}

/* The rotation vector of the shorter arc from `goal` to `from`, halved. */
static lane_f64_vec3 error_of(lane_f64_quat from, lane_f64_quat goal, lane_f64_quat *error)
{
    lane_f64_quat to = lane_f64_quat_aligned(goal, from, NKW_PATH_SHORT);
    *error = lane_f64_quat_mul(to, lane_f64_quat_conjugate(goal));
    return lane_f64_quat_log(*error);
}

static lane_f64_vec3 combined(lane_f64_vec3 a, double s, lane_f64_vec3 b, double t)
{
    return lane_f64_vec3_add_scaled(lane_f64_vec3_scale(a, s), b, t);
}

nkw_quat_motion nkw_quat_spring_step(nkw_spring spring, const nkw_quat_motion *from, const nkw_quat_motion *goal,
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
    nkw_quat_motion out = {lane_quat_from_f64(x), lane_vec3_from_f64(spin)};
    return is_none(h) ? *from : out;
}

/* 2^(-h / half_life); NaN if either is. */
static double halves(float half_life, float h)
{
    double n = (double)h / (double)half_life, kept = n < 1000.0 ? lane_exp2_64(-n) : n == n ? 0.0 : n;
    return half_life > 0.0f || half_life != half_life ? kept : h == h ? 0.0 : (double)h;
}

static float damped(float from, float goal, double kept)
{
    return (float)((double)goal + ((double)from - (double)goal) * kept);
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
    return is_none(h) ? from : lane_quat_from_f64(lane_f64_quat_slerp_turned(x, g, 1.0 - kept, 0.0, 0));
}

/* ---- Springs that arrive at a time ---- */

/* A step in two parts: while the point moves, and after it has stopped. */
typedef struct parts {
    float moving, resting; /* seconds of the step */
    double rate; /* the part of the way to the goal that the point moves in a second */
} parts;

static parts parts_of(nkw_spring_timed *timed, float h)
{
    double left = bounded(timed->time_left), stiffness = bounded(timed->spring.stiffness);
    double lead = stiffness > 0.0 ? bounded(timed->spring.damping) / stiffness : 0.0;
    double moving = left - lead < (double)h ? left - lead : (double)h, after = left - (double)h;
    parts p = {moving > 0.0 ? (float)moving : 0.0f, h, 0.0};
    if (p.moving > 0.0f) {
        p.rate = 1.0 / left;
        p.resting = (float)((double)h - (double)p.moving);
    }
    timed->time_left = after > 0.0 ? (float)after : 0.0f;
    return p;
}

static void timed_step(nkw_spring spring, const parts *p, nkw_motion *motion, nkw_motion *point, float goal)
{
    if (p->moving > 0.0f) {
        double rate = ((double)goal - (double)point->value) * p->rate;
        point->velocity = (float)rate;
        *motion = nkw_spring_step(spring, *motion, *point, p->moving);
        point->value = (float)((double)point->value + rate * (double)p->moving);
    }
    if (p->resting != 0.0f) {
        *point = motion_of(goal, 0.0f);
        *motion = nkw_spring_step(spring, *motion, *point, p->resting);
    }
}

void nkw_spring_timed_step(nkw_spring_timed *timed, nkw_motion *motion, nkw_motion *point, float goal, float h)
{
    if (is_none(h))
        return;
    parts p = parts_of(timed, h);
    timed_step(timed->spring, &p, motion, point, goal);
}

void nkw_vec3_spring_timed_step(nkw_spring_timed *timed, nkw_vec3_motion *motion, nkw_vec3_motion *point, nkw_vec3 goal,
                                float h)
{
    if (is_none(h))
        return;
    parts p = parts_of(timed, h);
    nkw_motion x = MOTION_AT(motion, x), y = MOTION_AT(motion, y), z = MOTION_AT(motion, z);
    nkw_motion px = MOTION_AT(point, x), py = MOTION_AT(point, y), pz = MOTION_AT(point, z);
    timed_step(timed->spring, &p, &x, &px, goal.x);
    timed_step(timed->spring, &p, &y, &py, goal.y);
    timed_step(timed->spring, &p, &z, &pz, goal.z);
    nkw_vec3_motion to = {{x.value, y.value, z.value}, {x.velocity, y.velocity, z.velocity}};
    nkw_vec3_motion at = {{px.value, py.value, pz.value}, {px.velocity, py.velocity, pz.velocity}};
    *motion = to;
    *point = at;
}

void nkw_quat_spring_timed_step(nkw_spring_timed *timed, nkw_quat_motion *motion, nkw_quat_motion *point, nkw_quat goal,
                                float h)
{
    if (is_none(h))
        return;
    parts p = parts_of(timed, h);
    lane_f64_quat end = lane_f64_quat_unit_from(goal), begin = lane_f64_quat_unit_from(point->value), way;
    if (p.moving > 0.0f) {
        lane_f64_vec3 half = error_of(end, begin, &way);
        point->velocity = lane_vec3_from_f64(lane_f64_vec3_scale(half, 2.0 * p.rate));
        *motion = nkw_quat_spring_step(timed->spring, motion, point, p.moving);
        way = lane_f64_quat_exp(lane_f64_vec3_scale(half, p.rate * (double)p.moving));
        point->value = lane_quat_from_f64(lane_f64_quat_mul(way, begin));
    }
    if (p.resting != 0.0f) {
        nkw_quat_motion at = {lane_quat_from_f64(end), {0.0f, 0.0f, 0.0f}};
        *point = at;
        *motion = nkw_quat_spring_step(timed->spring, motion, point, p.resting);
    }
}
