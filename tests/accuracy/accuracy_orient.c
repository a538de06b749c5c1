/* SPDX-License-Identifier: MIT */
/*
 * Errors of <nakawari/orient.h> against binary128.
 *
 * Slerp is judged against the arc between the directions of the float inputs, shorter one, up to the sign of the whole:
 * the regions R, T1..T7, P, O1, O2, X, E and D are those in which other libraries fail.
 */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <quadmath.h>
#include <string.h>

#define SAMPLES 30000u
#define PI      0x1.921fb6p1f

/* ---- Samples: a, b, t ---- */

static void uniform_pair(random_source *r, float *x)
{
    put_quat(x, random_unit_quat(r));
    put_quat(x + 4, random_unit_quat(r));
    x[8] = random_unit(r);
}

/* Both signs of b. */
static void apart(random_source *r, float *x, float low, float high)
{
    nkw_quat a = random_unit_quat(r);
    float angle = random_log(r, low, high), sign = random_sign(r);
    put_quat(x, a);
    put_quat(x + 4, nkw_quat_scale(random_unit_near(r, a, angle), sign));
    x[8] = random_unit(r);
}

#define APART(name, low, high)                                                                                         \
    static void name(random_source *r, float *x)                                                                       \
    {                                                                                                                  \
        apart(r, x, low, high);                                                                                        \
    }

APART(t1, 1e-8f, 1e-4f)
APART(t2, 1e-4f, 1e-3f)
APART(t3, 1e-3f, 1e-2f)
APART(t4, 1e-2f, 0.1f)
APART(t5, 0.1f, 0.5f)
APART(t6, 0.5f, 1.0f)
APART(t7, 1.0f, 1.5698f)

static void perpendicular(random_source *r, float *x)
{
    nkw_quat a = random_unit_quat(r);
    float angle = PI / 2.0f + random_between(r, -1e-6f, 1e-6f);
    put_quat(x, a);
    put_quat(x + 4, random_unit_near(r, a, angle));
    x[8] = random_unit(r);
}

static void from_opposite(random_source *r, float *x, float low, float high)
{
    nkw_quat a = random_unit_quat(r);
    float angle = random_log(r, low, high);
    put_quat(x, a);
    put_quat(x + 4, nkw_quat_negate(random_unit_near(r, a, angle)));
    x[8] = random_unit(r);
}

static void o1(random_source *r, float *x)
{
    from_opposite(r, x, 1e-6f, 1e-3f);
}

static void o2(random_source *r, float *x)
{
    from_opposite(r, x, 1e-3f, 0.1f);
}

/* t of more than 24 bits after the point: 1 - t is rounded. */
static void fine_t(random_source *r, float *x)
{
    uniform_pair(r, x);
    x[8] = fabsf(random_scaled(r, -30, 0));
}

/* As unit as the header asks. */
static void nearly_unit(random_source *r, float *x)
{
    uniform_pair(r, x);
    for (int k = 0; k < 8; k += 4) {
        float length = 1.0f + random_between(r, -1e-5f, 1e-5f);
        put_quat(x + k, nkw_quat_scale(quat_at(x + k), length));
    }
}

static void extrapolated(random_source *r, float *x)
{
    uniform_pair(r, x);
    x[8] = random_between(r, -1.0f, 2.0f);
}

static void far_extrapolated(random_source *r, float *x)
{
    uniform_pair(r, x);
    x[8] = random_between(r, -10.0f, 10.0f);
}

static void extreme_t(random_source *r, float *x)
{
    static const float t[7] = {0x1p-149f, 0x1.8p-130f, 0x1p-24f, 0x1.fffffep-1f, 0x1.fffffep-2f, -0.0f, 0.5f};
    uniform_pair(r, x);
    x[8] = t[random_bits(r) % 7];
}

static void t5_middle(random_source *r, float *x)
{
    t5(r, x);
    x[8] = 0.5f;
}

/* Pairs whose product in binary32 is above 1. */
static void above_one(random_source *r, float *x)
{
    do {
        t1(r, x);
    } while (!(fabsf(nkw_quat_dot(quat_at(x), quat_at(x + 4))) > 1.0f));
}

static void any_angle(random_source *r, float *x)
{
    if (random_bits(r) >> 63)
        uniform_pair(r, x);
    else
        apart(r, x, 1e-7f, 1.57f);
}

/* ---- slerp and nlerp ---- */

static void pair_of(const float *x, wide a[4], wide b[4])
{
    wide_from(x, a, 4);
    wide_from(x + 4, b, 4);
}

static double slerp_error(const float *x)
{
    wide a[4], b[4], exact[4];
    float got[4];
    pair_of(x, a, b);
    wide_scale(b, wide_dot(a, b, 4) < 0 ? -1 : 1, 4);
    wide_slerp(a, b, x[8], exact);
    put_quat(got, nkw_quat_slerp(quat_at(x), quat_at(x + 4), x[8]));
    return wide_error_either(got, exact, 4);
}

/* At right angles either arc will do. */
static double slerp_either_error(const float *x)
{
    wide a[4], b[4], exact[4];
    float got[4];
    put_quat(got, nkw_quat_slerp(quat_at(x), quat_at(x + 4), x[8]));
    pair_of(x, a, b);
    wide_slerp(a, b, x[8], exact);
    double one = wide_error_either(got, exact, 4);
    wide_scale(b, -1, 4);
    wide_slerp(a, b, x[8], exact);
    return fmin(one, wide_error_either(got, exact, 4));
}

static double slerp_unit_error(const float *x)
{
    float got[4];
    put_quat(got, nkw_quat_slerp(quat_at(x), quat_at(x + 4), x[8]));
    return wide_unit_error(got, 4);
}

static int same(nkw_quat a, nkw_quat b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w;
}

static int same_either(nkw_quat a, nkw_quat b)
{
    return same(a, b) || same(a, nkw_quat_negate(b));
}

static double slerp_ends(const float *x)
{
    nkw_quat a = quat_at(x), b = quat_at(x + 4);
    int exact = same(nkw_quat_slerp(a, b, 0.0f), a) && same_either(nkw_quat_slerp(a, b, 1.0f), b);
    return exact ? 0.0 : HUGE_VAL;
}

/* 1 - t is exact for t = k / 2^24. */
static double slerp_symmetry(const float *x)
{
    nkw_quat a = quat_at(x), b = quat_at(x + 4);
    nkw_quat forth = nkw_quat_slerp(a, b, x[8]), back = nkw_quat_slerp(b, a, 1.0f - x[8]);
    return same_either(forth, back) ? 0.0 : HUGE_VAL;
}

static double slerp_constant(const float *x)
{
    nkw_quat a = quat_at(x), opposite = nkw_quat_negate(a);
    return same(nkw_quat_slerp(a, a, x[8]), a) && same(nkw_quat_slerp(a, opposite, x[8]), a) ? 0.0 : HUGE_VAL;
}

static wide angle_from(const float *a, nkw_quat q)
{
    wide p[4], s[4], d[4];
    float f[4];
    put_quat(f, q);
    wide_from(a, p, 4);
    wide_from(f, s, 4);
    wide_normalize(p, 4);
    wide_normalize(s, 4);
    for (int i = 0; i < 4; i++) {
        d[i] = s[i] - p[i];
        s[i] += p[i];
    }
    return 2 * atan2q(wide_length(d, 4), wide_length(s, 4));
}

/* How far two neighbouring t step back, in u rad. */
static double slerp_backwards(const float *x)
{
    nkw_quat a = quat_at(x), b = quat_at(x + 4);
    float next = fminf(x[8] + 0x1p-14f, 1.0f);
    wide step = angle_from(x, nkw_quat_slerp(a, b, x[8])) - angle_from(x, nkw_quat_slerp(a, b, next));
    return step > 0 ? (double)step * 0x1p24 : 0.0;
}

/* Of the arc to b, or to -b. */
static double nlerp_error_to(const float *x, int sign)
{
    wide a[4], b[4];
    float got[4];
    pair_of(x, a, b);
    for (int i = 0; i < 4; i++)
        a[i] = (1 - (wide)x[8]) * a[i] + sign * (wide)x[8] * b[i];
    /* Exact inputs come back as they are, unit or not. */
    if (x[8] != 0.0f)
        wide_normalize(a, 4);
    put_quat(got, nkw_quat_nlerp(quat_at(x), quat_at(x + 4), x[8]));
    return wide_error_either(got, a, 4);
}

/* At right angles rounding decides the arc. */
static double nlerp_error(const float *x)
{
    wide a[4], b[4];
    pair_of(x, a, b);
    wide dot = wide_dot(a, b, 4);
    double error = nlerp_error_to(x, dot < 0 ? -1 : 1);
    return fabsq(dot) < 0x1p-21 ? fmin(error, nlerp_error_to(x, dot < 0 ? 1 : -1)) : error;
}

static double nlerp_ends(const float *x)
{
    nkw_quat a = quat_at(x), b = quat_at(x + 4);
    int exact = same(nkw_quat_nlerp(a, b, 0.0f), a) && same_either(nkw_quat_nlerp(a, b, 1.0f), b);
    return exact ? 0.0 : HUGE_VAL;
}

static double nlerp_constant(const float *x)
{
    nkw_quat a = quat_at(x), opposite = nkw_quat_negate(a);
    return same(nkw_quat_nlerp(a, a, x[8]), a) && same(nkw_quat_nlerp(a, opposite, x[8]), a) ? 0.0 : HUGE_VAL;
}

/* ---- Named arcs ---- */

static double path_error(const float *x, nkw_path path)
{
    wide a[4], b[4], exact[4];
    float got[4];
    pair_of(x, a, b);
    int obtuse = wide_dot(a, b, 4) < 0;
    int turned = path == NKW_PATH_LONG ? !obtuse : path == NKW_PATH_SHORT ? obtuse : 0;
    wide_scale(b, turned ? -1 : 1, 4);
    /* The arc is that of the directions; the length goes from |a| to |b|. */
    wide la = wide_length(a, 4), lb = wide_length(b, 4);
    wide_scale(a, 1 / la, 4);
    wide_scale(b, 1 / lb, 4);
    wide_slerp(a, b, x[8], exact);
    wide_scale(exact, la + x[8] * (lb - la), 4);
    put_quat(got, nkw_quat_slerp_path(quat_at(x), quat_at(x + 4), x[8], path, 0));
    return wide_error(got, exact, 4);
}

static double short_error(const float *x)
{
    return path_error(x, NKW_PATH_SHORT);
}

static double long_error(const float *x)
{
    return path_error(x, NKW_PATH_LONG);
}

static double given_error(const float *x)
{
    return path_error(x, NKW_PATH_AS_GIVEN);
}

/* The long way between nearly equal rotations: the arc is undecided, but it should be one of unit quaternions. */
static double long_unit_error(const float *x)
{
    float got[4];
    int obtuse = nkw_quat_dot(quat_at(x), quat_at(x + 4)) < 0.0f;
    nkw_quat b = nkw_quat_scale(quat_at(x + 4), obtuse ? -1.0f : 1.0f);
    put_quat(got, nkw_quat_slerp_path(quat_at(x), b, x[8], NKW_PATH_LONG, 0));
    return wide_unit_error(got, 4);
}

/* pi - 0.1 .. pi - 0.042: arcs of up to 3.1 rad. */
static void long_arc(random_source *r, float *x)
{
    from_opposite(r, x, 0.042f, 0.1f);
}

static void unequal_arc(random_source *r, float *x)
{
    uniform_pair(r, x);
    put_quat(x, nkw_quat_scale(quat_at(x), 1.0f + random_between(r, -1e-5f, 1e-5f)));
}

static double path_ends(const float *x)
{
    nkw_quat a = quat_at(x), b = quat_at(x + 4);
    nkw_path path = (nkw_path)((int)(x[8] * 4096.0f) % 3);
    int exact =
        same(nkw_quat_slerp_path(a, b, 0.0f, path, 0), a) && same_either(nkw_quat_slerp_path(a, b, 1.0f, path, 0), b);
    return exact ? 0.0 : HUGE_VAL;
}

/* ---- log, exp, pow ---- */

static void unit_quat(random_source *r, float *x)
{
    put_quat(x, random_unit_quat(r));
}

static void near_one(random_source *r, float *x)
{
    put_vec3(x, nkw_vec3_scale(random_direction(r), random_log(r, 1e-30f, 1e-2f)));
    x[3] = random_sign(r);
}

static double log_error(const float *x)
{
    wide q[4], v[3];
    float got[3];
    wide_from(x, q, 4);
    wide_quat_log(q, v);
    put_vec3(got, nkw_quat_log(quat_at(x)));
    return wide_error(got, v, 3);
}

static void half_turns(random_source *r, float *x)
{
    put_vec3(x, random_vec3(r, -PI, PI));
}

static void small_turns(random_source *r, float *x)
{
    put_vec3(x, nkw_vec3_scale(random_direction(r), random_log(r, 1e-30f, 1e-2f)));
}

static void many_turns(random_source *r, float *x)
{
    put_vec3(x, nkw_vec3_scale(random_direction(r), random_log(r, 10.0f, 1e5f)));
}

static double exp_error(const float *x)
{
    wide v[3], q[4];
    float got[4];
    wide_from(x, v, 3);
    wide_quat_exp(v, q);
    put_quat(got, nkw_quat_exp(vec3_at(x)));
    return wide_error(got, q, 4);
}

static void small_power(random_source *r, float *x)
{
    unit_quat(r, x);
    x[4] = random_between(r, -4.0f, 4.0f);
}

static void large_power(random_source *r, float *x)
{
    unit_quat(r, x);
    float sign = random_sign(r);
    x[4] = sign * random_log(r, 1.0f, 1e4f);
}

static double pow_error(const float *x)
{
    wide q[4], v[3];
    float got[4];
    wide_from(x, q, 4);
    wide_quat_log(q, v);
    wide_scale(v, x[4], 3);
    wide_quat_exp(v, q);
    put_quat(got, nkw_quat_pow(quat_at(x), x[4]));
    return wide_error(got, q, 4);
}

/* ---- Angular velocity: a, b, duration; integration: q, velocity, duration ---- */

static void uniform_turn(random_source *r, float *x)
{
    uniform_pair(r, x);
    x[8] = random_log(r, 1e-3f, 10.0f);
}

static void small_turn(random_source *r, float *x)
{
    apart(r, x, 1e-6f, 0.1f);
    x[8] = random_log(r, 1e-3f, 10.0f);
}

static double velocity_error(const float *x)
{
    wide a[4], b[4], v[3];
    float got[3];
    pair_of(x, a, b);
    wide_scale(b, wide_dot(a, b, 4) < 0 ? -1 : 1, 4);
    wide_scale(a, -1, 3);
    wide_quat_mul(b, a, b);
    wide_quat_log(b, v);
    wide_scale(v, 2 / (wide)x[8], 3);
    put_vec3(got, nkw_quat_angular_velocity(quat_at(x), quat_at(x + 4), x[8]));
    return wide_error(got, v, 3);
}

static void spin(random_source *r, float *x)
{
    unit_quat(r, x);
    put_vec3(x + 4, random_vec3(r, -10.0f, 10.0f));
    x[7] = random_log(r, 1e-3f, 1.0f);
}

static void fast_spin(random_source *r, float *x)
{
    unit_quat(r, x);
    put_vec3(x + 4, nkw_vec3_scale(random_direction(r), random_log(r, 1.0f, 1e4f)));
    x[7] = random_log(r, 1e-3f, 10.0f);
}

static double integrate_error(const float *x)
{
    wide q[4], v[3], turn[4];
    float got[4];
    wide_from(x, q, 4);
    wide_from(x + 4, v, 3);
    wide_scale(v, (wide)x[7] / 2, 3);
    wide_quat_exp(v, turn);
    wide_quat_mul(turn, q, q);
    put_quat(got, nkw_quat_integrate(quat_at(x), vec3_at(x + 4), x[7]));
    return wide_error(got, q, 4);
}

#define SLERP "nkw_quat_slerp"
#define NLERP "nkw_quat_nlerp"
#define ARC   "nkw_quat_slerp_path"
#define OMEGA "nkw_quat_angular_velocity"

static const wide_case cases[] = {
    {SLERP, "uniform", uniform_pair, slerp_error, 9, WIDE_UNITS},
    {SLERP, "uniform, t in 2^-30 .. 1", fine_t, slerp_error, 9, WIDE_UNITS},
    {SLERP, "angle 1e-8 .. 1e-4", t1, slerp_error, 9, WIDE_CHECKED},
    {SLERP, "angle 1e-4 .. 1e-3", t2, slerp_error, 9, WIDE_CHECKED},
    {SLERP, "angle 1e-3 .. 1e-2", t3, slerp_error, 9, WIDE_CHECKED},
    {SLERP, "angle 1e-2 .. 0.1", t4, slerp_error, 9, WIDE_CHECKED},
    {SLERP, "angle 0.1 .. 0.5", t5, slerp_error, 9, WIDE_CHECKED},
    {SLERP, "angle 0.1 .. 0.5, t = 1/2", t5_middle, slerp_error, 9, WIDE_CHECKED},
    {SLERP, "angle 0.5 .. 1.0", t6, slerp_error, 9, WIDE_CHECKED},
    {SLERP, "angle 1.0 .. pi/2 - 1e-3", t7, slerp_error, 9, WIDE_UNITS},
    {SLERP, "P abs(dot) < 1e-6", perpendicular, slerp_either_error, 9, WIDE_CHECKED},
    {SLERP, "O1 pi - 1e-3 .. pi - 1e-6", o1, slerp_error, 9, WIDE_CHECKED},
    {SLERP, "O2 pi - 0.1 .. pi - 1e-3", o2, slerp_error, 9, WIDE_CHECKED},
    {SLERP, "X t in [-1, 2]", extrapolated, slerp_error, 9, WIDE_CHECKED},
    {SLERP, "t in [-10, 10], against the formula with unnormalised keys", far_extrapolated, slerp_error, 9, WIDE_NOTED},
    {SLERP, "lengths 1 +- 1e-5", nearly_unit, slerp_error, 9, WIDE_NOTED},
    {SLERP, "extreme t", extreme_t, slerp_error, 9, WIDE_CHECKED},
    {SLERP, "dot > 1", above_one, slerp_error, 9, WIDE_CHECKED},
    {SLERP, "ends, bit for bit", any_angle, slerp_ends, 9, WIDE_CHECKED},
    {SLERP, "symmetry, bit for bit", any_angle, slerp_symmetry, 9, WIDE_CHECKED},
    {SLERP, "q to q and -q, bit for bit", uniform_pair, slerp_constant, 9, WIDE_CHECKED},
    {SLERP, "uniform, length - 1", uniform_pair, slerp_unit_error, 9, WIDE_NOTED},
    {SLERP, "angle 1e-2 .. 0.1, length - 1", t4, slerp_unit_error, 9, WIDE_NOTED},
    {SLERP, "angle 1.0 .. pi/2 - 1e-3, length - 1", t7, slerp_unit_error, 9, WIDE_NOTED},
    {SLERP, "backward steps, u rad", any_angle, slerp_backwards, 9, WIDE_NOTED},
    {NLERP, "uniform", uniform_pair, nlerp_error, 9, WIDE_UNITS},
    {NLERP, "uniform, t in 2^-30 .. 1", fine_t, nlerp_error, 9, WIDE_UNITS},
    {NLERP, "1e-8 .. 1e-4", t1, nlerp_error, 9, WIDE_UNITS},
    {NLERP, "1.0 .. pi/2 - 1e-3", t7, nlerp_error, 9, WIDE_UNITS},
    {NLERP, "extreme t", extreme_t, nlerp_error, 9, WIDE_CHECKED},
    {NLERP, "lengths 1 +- 1e-5", nearly_unit, nlerp_error, 9, WIDE_CHECKED},
    {NLERP, "ends, bit for bit", any_angle, nlerp_ends, 9, WIDE_CHECKED},
    {NLERP, "q to q and -q, bit for bit", uniform_pair, nlerp_constant, 9, WIDE_CHECKED},
    {ARC, "short, uniform", uniform_pair, short_error, 9, WIDE_CHECKED},
    {ARC, "as given, uniform", uniform_pair, given_error, 9, WIDE_CHECKED},
    {ARC, "long, uniform", uniform_pair, long_error, 9, WIDE_CHECKED},
    {ARC, "as given, 1e-8 .. 1e-4", t1, short_error, 9, WIDE_CHECKED},
    {ARC, "as given, pi - 0.1 .. 3.1", long_arc, given_error, 9, WIDE_CHECKED},
    {ARC, "lengths 1 +- 1e-5", unequal_arc, given_error, 9, WIDE_CHECKED},
    {ARC, "as given, pi - 0.1 .. pi - 1e-3", o2, given_error, 9, WIDE_CHECKED},
    {ARC, "as given, pi - 1e-3 .. pi - 1e-6", o1, given_error, 9, WIDE_CHECKED},
    {ARC, "long, 1e-8 .. 1e-4 apart, length - 1", t1, long_unit_error, 9, WIDE_NOTED},
    {ARC, "ends, bit for bit", any_angle, path_ends, 9, WIDE_CHECKED},
    {"nkw_quat_log", "unit", unit_quat, log_error, 4, WIDE_CHECKED},
    {"nkw_quat_log", "near 1 and -1", near_one, log_error, 4, WIDE_CHECKED},
    {"nkw_quat_exp", "components +-pi", half_turns, exp_error, 3, WIDE_CHECKED},
    {"nkw_quat_exp", "1e-30 .. 1e-2", small_turns, exp_error, 3, WIDE_CHECKED},
    {"nkw_quat_exp", "10 .. 1e5", many_turns, exp_error, 3, WIDE_CHECKED},
    {"nkw_quat_pow", "t in [-4, 4]", small_power, pow_error, 5, WIDE_CHECKED},
    {"nkw_quat_pow", "abs(t) in 1 .. 1e4", large_power, pow_error, 5, WIDE_CHECKED},
    {OMEGA, "uniform", uniform_turn, velocity_error, 9, WIDE_CHECKED},
    {OMEGA, "1e-6 .. 0.1", small_turn, velocity_error, 9, WIDE_CHECKED},
    {"nkw_quat_integrate", "up to 10 rad/s, 1 s", spin, integrate_error, 8, WIDE_CHECKED},
    {"nkw_quat_integrate", "up to 1e5 rad", fast_spin, integrate_error, 8, WIDE_CHECKED},
};

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("orient.h", argc, argv);
    wide_search(&a, cases, sizeof cases / sizeof cases[0], SAMPLES);
    orient_more(&a);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
