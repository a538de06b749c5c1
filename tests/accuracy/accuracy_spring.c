/* SPDX-License-Identifier: MIT */
/* Errors of spring.h, in u of the sum of the magnitudes that a result consists of. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <quadmath.h>
#include <string.h>

/* Stiffness, damping, the motion, the goal's motion, h. */
static void any_spring(random_source *r, float *x)
{
    float omega = random_log(r, 0.01f, 100.0f), ratio = random_log(r, 0.01f, 30.0f);
    x[0] = omega * omega;
    x[1] = 2.0f * omega * ratio;
    for (int i = 2; i < 6; i++)
        x[i] = random_sign(r) * random_log(r, 0.001f, 10.0f);
    x[6] = random_log(r, 0.0001f, 10.0f);
}

static void critical_spring(random_source *r, float *x)
{
    any_spring(r, x);
    x[1] = 2.0f * sqrtf(x[0]) * random_between(r, 0.999f, 1.001f);
}

static void undamped_spring(random_source *r, float *x)
{
    any_spring(r, x);
    x[1] = random_unit(r) < 0.5f ? 0.0f : x[1] * 0x1p-20f;
    x[6] *= 100.0f;
}

/* Phases to 2^28 rad in a step. */
static void long_spring(random_source *r, float *x)
{
    any_spring(r, x);
    x[1] = random_unit(r) < 0.5f ? 0.0f : x[1] * 0x1p-40f;
    x[6] = random_log(r, 1.0f, 0x1p28f) / sqrtf(x[0]);
}

static void drag(random_source *r, float *x)
{
    any_spring(r, x);
    x[0] = random_unit(r) < 0.5f ? 0.0f : x[0] * 0x1p-30f;
}

/* The flow of the deviation: xx, xv, vx, vv. */
static void flow(wide s, wide d, wide h, wide m[4])
{
    wide y = d / 2, q = y * y - s, e = expq(-y * h), w = sqrtq(fabsq(q)), a = w * h;
    wide c = q < 0 ? cosq(a) : coshq(a), f = a == 0 ? h : (q < 0 ? sinq(a) : sinhq(a)) / w;
    if (q > 0) {
        wide slow = expq(-s / (y + w) * h), fast = expq(-(y + w) * h);
        m[0] = (slow * (y + w) - fast * s / (y + w)) / (2 * w);
        m[1] = -slow * expm1q(-2 * a) / (2 * w);
        m[3] = (fast * (y + w) - slow * s / (y + w)) / (2 * w);
    } else {
        m[0] = e * (c + y * f);
        m[1] = e * f;
        m[3] = e * (c - y * f);
    }
    m[2] = -s * m[1];
}

/* Whether a step that rounds to nothing was made one ULP: the header states that, and tests hold it. */
static int is_least(float got, float from, wide exact)
{
    float next = nextafterf(from, got);
    return got == next && got != from && fabsq(exact - from) <= fabsq((wide)next - from) / 2;
}

static double step_error(nkw_state got, const float *x, wide h)
{
    wide m[4], e = (wide)x[2] - x[4], v = (wide)x[3] - x[5];
    flow(x[0], x[1], h, m);
    wide goal = x[4] + x[5] * h, value = goal + m[0] * e + m[1] * v, rate = x[5] + m[2] * e + m[3] * v;
    wide size = fabsq(goal) + fabsq(m[0] * e) + fabsq(m[1] * v),
         speed = fabsq((wide)x[5]) + fabsq(m[2] * e) + fabsq(m[3] * v);
    double error = is_least(got.value, x[2], value) ? 0.0 : wide_error_of(&got.value, &value, 1, size);
    return fmax(error, wide_error_of(&got.velocity, &rate, 1, speed));
}

static nkw_state step(const float *x, nkw_state from, float h)
{
    nkw_spring s = {x[0], x[1]};
    nkw_state goal = {x[4], x[5]};
    return nkw_spring_step(s, from, goal, h);
}

static double spring_error(const float *x)
{
    nkw_state from = {x[2], x[3]};
    return step_error(step(x, from, x[6]), x, x[6]);
}

/* A step of one ULP, which may be longer than the exact one. */
static int is_one_ulp(float from, float to)
{
    return to != from && to == nextafterf(from, to);
}

/* Two steps of h against the exact step of 2h, for a goal at rest; the sum of magnitudes of both steps. */
static double composition_error(const float *x)
{
    nkw_state from = {x[2], x[3]}, half = step(x, from, x[6]), got = step(x, half, x[6]);
    wide m[4], e = (wide)x[2] - x[4], v = (wide)x[3], h = x[6];
    if (is_one_ulp(from.value, half.value) || is_one_ulp(half.value, got.value))
        return 0.0;
    flow(x[0], x[1], h, m);
    wide e1 = m[0] * e + m[1] * v, v1 = m[2] * e + m[3] * v;
    wide value = x[4] + m[0] * e1 + m[1] * v1, rate = m[2] * e1 + m[3] * v1;
    wide a = fabsq((wide)x[4]) + fabsq(m[0] * e) + fabsq(m[1] * v), b = fabsq(m[2] * e) + fabsq(m[3] * v);
    wide size = fabsq((wide)x[4]) + fabsq(m[0]) * a + fabsq(m[1]) * b, speed = fabsq(m[2]) * a + fabsq(m[3]) * b;
    return fmax(wide_error_of(&got.value, &value, 1, size), wide_error_of(&got.velocity, &rate, 1, speed));
}

static void still_goal(random_source *r, float *x)
{
    any_spring(r, x);
    x[5] = 0.0f;
}

/* Half-life or frequency, and the damping ratio. */
static void constants(random_source *r, float *x)
{
    x[0] = random_log(r, 0.001f, 1000.0f);
    x[1] = random_unit(r) < 0.2f ? 1.0f : random_log(r, 0.001f, 100.0f);
}

static wide half_time(wide ratio)
{
    wide low = wide_pi() / 3, high = low + 2 * logq(2) * ratio;
    for (int i = 0; i < 120; i++) {
        wide m[4], t = (low + high) / 2;
        flow(1, 2 * ratio, t, m);
        if (m[0] > 0.5)
            low = t;
        else
            high = t;
    }
    return low;
}

static double constants_error(nkw_spring got, wide omega, wide ratio)
{
    wide s = omega * omega, d = 2 * omega * ratio;
    return fmax(wide_error(&got.stiffness, &s, 1), wide_error(&got.damping, &d, 1));
}

static double from_half_life_error(const float *x)
{
    return constants_error(nkw_spring_from_half_life(x[0], x[1]), half_time(x[1]) / x[0], x[1]);
}

static double from_frequency_error(const float *x)
{
    return constants_error(nkw_spring_from_frequency(x[0], x[1]), 2 * wide_pi() * x[0], x[1]);
}

static nkw_spring spring_at(const float *x)
{
    nkw_spring s = {x[0] * x[0], 2.0f * x[0] * x[1]};
    return s;
}

static double frequency_error(const float *x)
{
    nkw_spring s = spring_at(x);
    wide want = sqrtq(s.stiffness) / (2 * wide_pi());
    float got = nkw_spring_describe(s).frequency;
    return wide_error(&got, &want, 1);
}

static double ratio_error(const float *x)
{
    nkw_spring s = spring_at(x);
    wide want = s.damping / (2 * sqrtq(s.stiffness));
    float got = nkw_spring_describe(s).damping_ratio;
    return wide_error(&got, &want, 1);
}

static double half_life_error(const float *x)
{
    nkw_spring s = spring_at(x);
    wide omega = sqrtq(s.stiffness), want = half_time(s.damping / (2 * omega)) / omega;
    float got = nkw_spring_describe(s).half_life;
    return wide_error(&got, &want, 1);
}

/* The value, the goal, the half-life, h. */
static void damper(random_source *r, float *x)
{
    x[0] = random_between(r, -1.0f, 1.0f);
    x[1] = random_between(r, -1.0f, 1.0f);
    x[2] = random_log(r, 0.01f, 10.0f);
    x[3] = random_log(r, 0.001f, 100.0f);
}

static double damper_error(const float *x)
{
    wide e = (wide)x[0] - x[1], want = x[1] + e * exp2q(-(wide)x[3] / x[2]);
    float got = nkw_damper_step(x[0], x[1], x[2], x[3]);
    return is_least(got, x[0], want) ? 0.0 : wide_error_of(&got, &want, 1, fabsq((wide)x[1]) + fabsq(e));
}

static double damper_composition(const float *x)
{
    wide e = (wide)x[0] - x[1], want = x[1] + e * exp2q(-2 * (wide)x[3] / x[2]);
    float half = nkw_damper_step(x[0], x[1], x[2], x[3]), got = nkw_damper_step(half, x[1], x[2], x[3]);
    return is_one_ulp(x[0], half) || is_one_ulp(half, got)
               ? 0.0
               : wide_error_of(&got, &want, 1, fabsq((wide)x[1]) + fabsq(e));
}

/* From, goal, half-life, h. */
static void quat_damper(random_source *r, float *x)
{
    nkw_quat a = random_unit_quat(r);
    put_quat(x, a);
    put_quat(x + 4, random_unit_near(r, a, random_between(r, 0.0f, 1.5f)));
    x[8] = random_log(r, 0.1f, 10.0f);
    x[9] = random_log(r, 0.01f, 10.0f);
}

/* Almost equal to almost opposite, and exactly so. */
static void wide_quat_damper(random_source *r, float *x)
{
    quat_damper(r, x);
    nkw_quat a = quat_at(x), b = random_unit_near(r, a, random_log(r, 0x1p-30f, 1.5707964f));
    if (random_unit(r) < 0.125f)
        b = random_unit(r) < 0.5f ? a : nkw_quat_negate(a);
    put_quat(x + 4, random_unit(r) < 0.5f ? b : nkw_quat_negate(b));
}

/* 3.5 u where the exact step is less than the least one. */
static double turn_error(const float *got, const wide want[4], const wide from[4])
{
    wide way[4];
    for (int i = 0; i < 4; i++)
        way[i] = want[i] - from[i];
    double error = wide_error(got, want, 4);
    return wide_length(way, 4) > 0x1.4p-23f ? error : error > 3.5 ? HUGE_VAL : 0.0;
}

static double quat_damper_error(const float *x)
{
    nkw_quat got = nkw_quat_damper_step(quat_at(x), quat_at(x + 4), x[8], x[9]);
    wide a[4], b[4], want[4];
    wide_from(x, a, 4);
    wide_from(x + 4, b, 4);
    wide_normalize(a, 4);
    wide_normalize(b, 4);
    wide_scale(b, wide_dot(a, b, 4) < 0 ? -1 : 1, 4);
    wide_slerp(a, b, 1 - exp2q(-(wide)x[9] / x[8]), want);
    return turn_error(&got.x, want, a);
}

/* Stiffness, damping; from, its velocity; goal, its velocity; h. */
static void quat_spring(random_source *r, float *x)
{
    float omega = random_log(r, 0.1f, 10.0f);
    x[0] = omega * omega;
    x[1] = 2.0f * omega * random_log(r, 0.1f, 5.0f);
    nkw_quat q = random_unit_quat(r);
    put_quat(x + 2, q);
    put_vec3(x + 6, nkw_vec3_scale(random_direction(r), random_between(r, 0.0f, 4.0f)));
    put_quat(x + 9, random_unit_near(r, q, random_between(r, 0.0f, 1.5f)));
    put_vec3(x + 13, nkw_vec3_scale(random_direction(r), random_between(r, 0.0f, 4.0f)));
    x[16] = random_log(r, 0.001f, 1.0f);
}

static void rotate(const wide q[4], const wide v[3], wide out[3])
{
    wide m[9];
    wide_mat3_from_quat(q, m);
    for (int i = 0; i < 3; i++)
        out[i] = m[i] * v[0] + m[3 + i] * v[1] + m[6 + i] * v[2];
}

static double quat_spring_error(const float *x)
{
    nkw_spring s = {x[0], x[1]};
    nkw_quat_state from = {quat_at(x + 2), vec3_at(x + 6)}, goal = {quat_at(x + 9), vec3_at(x + 13)};
    nkw_quat_state got = nkw_quat_spring_step(s, &from, &goal, x[16]);
    wide q[4], g[4], e[4], w[3], turn[3], v[3], rate[3], m[4], want[4];
    wide_from(x + 2, q, 4);
    wide_from(x + 9, g, 4);
    wide_from(x + 6, w, 3);
    wide_from(x + 13, turn, 3);
    wide_normalize(q, 4);
    wide_normalize(g, 4);
    wide c[4] = {-g[0], -g[1], -g[2], g[3]};
    wide_quat_mul(q, c, e);
    wide_scale(e, e[3] < 0 ? -1 : 1, 4);
    wide_quat_log(e, v);
    rotate(e, turn, rate);
    for (int i = 0; i < 3; i++)
        w[i] -= rate[i];
    wide_rotation_rate(v, w, rate);
    flow(x[0], x[1], x[16], m);
    for (int i = 0; i < 3; i++) {
        v[i] = m[0] * v[i] + m[1] * rate[i] / 2;
        turn[i] *= (wide)x[16] / 2;
    }
    wide_quat_exp(turn, c);
    wide_quat_mul(c, g, q);
    wide_quat_exp(v, e);
    wide_quat_mul(e, q, want);
    wide_from(x + 2, q, 4);
    wide_normalize(q, 4);
    wide_scale(want, wide_dot(want, (wide[4]){got.value.x, got.value.y, got.value.z, got.value.w}, 4) < 0 ? -1 : 1, 4);
    wide_scale(q, wide_dot(q, want, 4) < 0 ? -1 : 1, 4);
    return turn_error(&got.value.x, want, q);
}

/* ---- A timed spring ---- */

enum { EFFORT = 6 };

/*
 * The state x, v, the costates a, b of the least integral of u^2/2, u = -b, the place of the point, its rate:
 *
 *     x' = v,   v' = s (p - x) + d (p' - v) - b,   a' = s b,   b' = d b - a,   p' = rate
 *
 * after h seconds: the series of the exponential, in parts in which it converges fast.
 */
static void effort_flow(wide s, wide d, wide h, wide y[EFFORT])
{
    const int parts = 1 + (int)((double)h * (sqrt((double)s) + (double)d));
    for (int n = 0; n < parts; n++) {
        wide t[EFFORT];
        memcpy(t, y, sizeof t);
        for (int k = 1; k < 24; k++) {
            const wide f = h / (parts * k);
            const wide next[EFFORT] = {f * t[1], f * (s * (t[4] - t[0]) + d * (t[5] - t[1]) - t[3]), f * s * t[3],
                                       f * (d * t[3] - t[2]), f * t[5], 0};
            for (int c = 0; c < EFFORT; c++)
                y[c] += next[c];
            memcpy(t, next, sizeof t);
        }
    }
}

/* The point moves for `moves` seconds, then it is at the goal. */
static void effort_both(const float *x, wide goal, wide moves, wide rests, wide y[EFFORT])
{
    effort_flow(x[0], x[1], moves, y);
    y[4] = goal;
    y[5] = 0;
    effort_flow(x[0], x[1], rests, y);
}

/* Stiffness, damping, the motion, the point, the goal, the time, h as a part of it. */
static void timed_spring(random_source *r, float *x)
{
    const float omega = random_log(r, 0.1f, 20.0f), ratio = random_log(r, 0.02f, 2.0f);
    x[6] = random_log(r, 0.03f, 3.0f);
    x[0] = omega * omega;
    x[1] = nkw_min(2.0f * omega * ratio, 12.0f / x[6]);
    for (int i = 2; i < 6; i++)
        x[i] = random_sign(r) * random_log(r, 0.001f, 10.0f);
    x[7] = random_between(r, 0.02f, 0.98f);
}

static void timed_without_spring(random_source *r, float *x)
{
    timed_spring(r, x);
    x[0] = 0;
    x[1] = random_unit(r) < 0.5f ? 0.0f : x[1];
}

static double timed_spring_error(const float *x)
{
    const wide goal = x[5], time = x[6], lead = x[0] > 0 ? (wide)x[1] / x[0] : 0, moves = lead < time ? time - lead : 0;
    const float h = x[6] * x[7];
    const wide rate = (goal - x[4]) / time, first = moves < h ? moves : h;
    wide b[EFFORT] = {x[2], x[3], 0, 0, x[4], rate}, p[EFFORT] = {0, 0, 1}, q[EFFORT] = {0, 0, 0, 1};
    effort_both(x, goal, moves, time - moves, b);
    effort_both(x, 0, moves, time - moves, p);
    effort_both(x, 0, moves, time - moves, q);
    const wide miss = goal - b[0], det = p[0] * q[1] - q[0] * p[1];
    wide y[EFFORT] = {x[2], x[3], (miss * q[1] + b[1] * q[0]) / det, (-b[1] * p[0] - miss * p[1]) / det, x[4], rate};
    if (first < h)
        effort_both(x, goal, first, h - first, y);
    else
        effort_flow(x[0], x[1], h, y);
    nkw_spring_timed timed = {{x[0], x[1]}, x[6], {x[2], x[3]}, {x[4], 0}};
    nkw_spring_timed_step(&timed, x[5], h);
    const wide size = fabsq(goal) + fabsq(x[2]) + fabsq(x[4]) + fabsq(x[3]) * time;
    return fmax(wide_error_of(&timed.state.value, &y[0], 1, size),
                wide_error_of(&timed.state.velocity, &y[1], 1, size * (sqrtq(x[0]) + x[1] + 6 / time)));
}

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("spring.h", argc, argv);
    static const wide_case halves[] = {
        {"nkw_spring_from_half_life", "1 ms to 1000 s", constants, from_half_life_error, 2, WIDE_CHECKED},
        {"nkw_spring_describe", "half-life", constants, half_life_error, 2, WIDE_CHECKED},
    };
    static const wide_case cases[] = {
        {"nkw_spring_from_frequency", "1 mHz to 1 kHz", constants, from_frequency_error, 2, WIDE_CHECKED},
        {"nkw_spring_describe", "frequency", constants, frequency_error, 2, WIDE_CHECKED},
        {"nkw_spring_describe", "damping ratio", constants, ratio_error, 2, WIDE_CHECKED},
        {"nkw_spring_step", "any damping", any_spring, spring_error, 7, WIDE_CHECKED},
        {"nkw_spring_step", "nearly critical", critical_spring, spring_error, 7, WIDE_CHECKED},
        {"nkw_spring_step", "little damping, long steps", undamped_spring, spring_error, 7, WIDE_CHECKED},
        {"nkw_spring_step", "no damping, to 2^28 rad", long_spring, spring_error, 7, WIDE_CHECKED},
        {"nkw_spring_step", "drag", drag, spring_error, 7, WIDE_CHECKED},
        {"nkw_spring_step", "two steps of h", still_goal, composition_error, 7, WIDE_NOTED},
        {"nkw_quat_spring_step", "any", quat_spring, quat_spring_error, 17, WIDE_CHECKED},
        {"nkw_damper_step", "any", damper, damper_error, 4, WIDE_CHECKED},
        {"nkw_damper_step", "two steps of h", damper, damper_composition, 4, WIDE_NOTED},
        {"nkw_quat_damper_step", "any", quat_damper, quat_damper_error, 10, WIDE_CHECKED},
        {"nkw_quat_damper_step", "equal to opposite", wide_quat_damper, quat_damper_error, 10, WIDE_CHECKED},
    };
    static const wide_case timed[] = {
        {"nkw_spring_timed_step", "a part of the time", timed_spring, timed_spring_error, 8, WIDE_CHECKED},
        {"nkw_spring_timed_step", "without stiffness", timed_without_spring, timed_spring_error, 8, WIDE_CHECKED},
    };
    wide_search(&a, halves, sizeof halves / sizeof *halves, 1000);
    wide_search(&a, cases, sizeof cases / sizeof *cases, 20000);
    wide_search(&a, timed, sizeof timed / sizeof *timed, 10000);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
