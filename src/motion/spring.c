/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/spring.h>
#include <nakawari/vec.h>

#include "lane/arc.h"
#include "lane/rotation_vector.h"
#include "lane/scalar.h"
#include "motion_component.h"

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

/* 2 pi as a sum: n times the first or the second, of 27 bits, is exact for n < 2^26. */
#define TURN_HIGH   0x1.921fb54p2
#define TURN_MIDDLE 0x1.10b461p-28
#define TURN_LOW    0x1.a62633145c06ep-56

/* The phase w h of an oscillation, and w. */
typedef struct phase {
    double w, high, low, tail; /* w h = high + low + tail; high and low are exact products */
} phase;

/* w^2 = stiffness - y^2 = square + left; w = a + b + more, a of 26 bits, and h is a float. */
static phase phase_of(double stiffness, double y, double h)
{
    double yy = y * y, square = stiffness - yy, back = square - stiffness;
    double left = (stiffness - (square - back)) - (yy + back), w = lane_sqrt64(square);
    double a = lane_double(lane_bits64(w) & ~UINT64_C(0x7FFFFFF)), b = w - a;
    double more = ((((square - a * a) - 2.0 * a * b) - b * b) + left) / (2.0 * w);
    phase p = {w + more, a * h, b * h, more * h};
    return p;
}

/* sin and cos of the phase without its whole turns, less than 2^26 of them, to 2^-49 rad; beyond, of the rounded one. */
static lane_sincos underdamped(double stiffness, double y, double h)
{
    phase p = phase_of(stiffness, y, h);
    double n = (p.w * h * (1.0 / LANE_TWO_PI) + LANE_ROUND) - LANE_ROUND;
    double reduced = ((p.high - n * TURN_HIGH) + p.low) - n * TURN_MIDDLE;
    lane_sincos a = n < 0x1p26 ? lane_sincos64(reduced + (p.tail - n * TURN_LOW)) : lane_turn64_long(p.w * h);
    a.s = a.s / p.w;
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
    return flow_by(stiffness, y, lane_decay64(y * h), z > -0.25 ? near_critical(z, h) : underdamped(stiffness, y, h));
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

/* Whether a step of h changes nothing. */
static int is_none(float h)
{
    return h <= 0.0f;
}

/* The float next to a finite `from` on the way to another number. */
static float next_towards(float from, float to)
{
    uint32_t bits = lane_bits(from), away = (from < to) == (from > 0.0f);
    float next = lane_float(away ? bits + 1u : bits - 1u);
    return from == 0.0f ? lane_float(lane_sign_bit(to) | 1u) : next;
}

/* `next`, the rounded end of a step; one ULP nearer to the goal where the step rounds to nothing before it. */
static float kept_moving(float from, float next, float goal)
{
    return next == from && goal != from && lane_is_finite(from) ? next_towards(from, goal) : next;
}

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

/* ---- Springs that arrive at a time ---- */

/* A step in two parts: while the point moves, and after it has stopped. */
typedef struct parts {
    float moving, resting; /* seconds of the step */
    double rate; /* the share of the way to the goal that the point moves in a second */
} parts;

/* Of a step of h; `time_left` receives the time after it. */
static parts parts_of(nkw_spring spring, float *time_left, float h)
{
    double left = bounded(*time_left), stiffness = bounded(spring.stiffness);
    double lead = stiffness > 0.0 ? bounded(spring.damping) / stiffness : 0.0;
    double moving = left - lead < (double)h ? left - lead : (double)h, after = left - (double)h;
    parts p = {moving > 0.0 ? (float)moving : 0.0f, h, 0.0};
    if (p.moving > 0.0f) {
        p.rate = 1.0 / left;
        p.resting = (float)((double)h - (double)p.moving);
    }
    *time_left = after > 0.0 ? kept_moving(*time_left, (float)after, 0.0f) : 0.0f;
    return p;
}

static void timed_step(nkw_spring spring, const parts *p, nkw_state *state, nkw_state *point, float goal)
{
    if (p->moving > 0.0f) {
        double rate = ((double)goal - (double)point->value) * p->rate;
        point->velocity = (float)rate;
        *state = nkw_spring_step(spring, *state, *point, p->moving);
        point->value = (float)((double)point->value + rate * (double)p->moving);
    }
    if (p->resting != 0.0f) {
        const nkw_state still = {goal, 0.0f};
        *point = still;
        *state = nkw_spring_step(spring, *state, *point, p->resting);
    }
}

void nkw_spring_timed_step(nkw_spring_timed *timed, float goal, float h)
{
    if (is_none(h))
        return;
    parts p = parts_of(timed->spring, &timed->time_left, h);
    timed_step(timed->spring, &p, &timed->state, &timed->point, goal);
}

void nkw_vec3_spring_timed_step(nkw_vec3_spring_timed *timed, nkw_vec3 goal, float h)
{
    if (is_none(h))
        return;
    parts p = parts_of(timed->spring, &timed->time_left, h);
    const nkw_vec3_state *from = &timed->state, *way = &timed->point;
    nkw_state x = motion_component(from, 0), y = motion_component(from, 1), z = motion_component(from, 2);
    nkw_state px = motion_component(way, 0), py = motion_component(way, 1), pz = motion_component(way, 2);
    timed_step(timed->spring, &p, &x, &px, goal.x);
    timed_step(timed->spring, &p, &y, &py, goal.y);
    timed_step(timed->spring, &p, &z, &pz, goal.z);
    nkw_vec3_state to = {{x.value, y.value, z.value}, {x.velocity, y.velocity, z.velocity}};
    nkw_vec3_state at = {{px.value, py.value, pz.value}, {px.velocity, py.velocity, pz.velocity}};
    timed->state = to;
    timed->point = at;
}

void nkw_quat_spring_timed_step(nkw_quat_spring_timed *timed, nkw_quat goal, float h)
{
    if (is_none(h))
        return;
    parts p = parts_of(timed->spring, &timed->time_left, h);
    nkw_quat_state *state = &timed->state, *point = &timed->point;
    lane_f64_quat end = lane_f64_quat_unit_from(goal), begin = lane_f64_quat_unit_from(point->value), way;
    if (p.moving > 0.0f) {
        lane_f64_vec3 half = error_of(end, begin, &way);
        point->velocity = lane_vec3_from_f64(lane_f64_vec3_scale(half, 2.0 * p.rate));
        *state = nkw_quat_spring_step(timed->spring, state, point, p.moving);
        way = lane_f64_quat_exp(lane_f64_vec3_scale(half, p.rate * (double)p.moving));
        point->value = lane_quat_from_f64(lane_f64_quat_mul(way, begin));
    }
    if (p.resting != 0.0f) {
        nkw_quat_state at = {lane_quat_from_f64(end), {0.0f, 0.0f, 0.0f}};
        *point = at;
        *state = nkw_quat_spring_step(timed->spring, state, point, p.resting);
    }
}
