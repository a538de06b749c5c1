/* SPDX-License-Identifier: MIT */
/* Errors of <nakawari/limit.h> against binary128. */
#include "wide.h"
#include "../support/joint_limits.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <quadmath.h>

#define SAMPLES 20000u

/* A sample: rotation 4, axis 3, side 3, half axes 2, twist 2, rest 4. */
enum { Q = 0, AXIS = 4, SIDE = 7, ANGLES = 10, TWIST = 12, REST = 14, NUMBERS = 18 };

static void any(random_source *r, float *x)
{
    put_quat(x + Q, random_unit_quat(r));
    put_vec3(x + AXIS, random_direction(r));
    put_vec3(x + SIDE, random_direction(r));
    x[ANGLES] = random_between(r, 0.1f, 2.5f);
    x[ANGLES + 1] = random_between(r, 0.1f, 2.5f);
    x[TWIST] = random_between(r, -2.5f, -0.1f);
    x[TWIST + 1] = random_between(r, 0.1f, 2.5f);
    put_quat(x + REST, random_unit_quat(r));
}

static nkw_limit limit_of(const float *x)
{
    nkw_limit limit = {quat_at(x + REST), vec3_at(x + AXIS), vec3_at(x + SIDE), x[ANGLES],
                       x[ANGLES + 1],     x[TWIST],          x[TWIST + 1]};
    return limit;
}

static void conjugate(const wide q[4], wide out[4])
{
    for (int i = 0; i < 4; i++)
        out[i] = i < 3 ? -q[i] : q[i];
}

/* q = swing twist; the swing as a rotation vector, with the angle below a half turn. */
static void split(const wide q[4], const wide axis[3], wide s[3], wide twist[4])
{
    wide along = wide_dot(q, axis, 3), inverse[4], swing[4];
    for (int i = 0; i < 3; i++)
        twist[i] = along * axis[i];
    twist[3] = q[3];
    wide_normalize(twist, 4);
    conjugate(twist, inverse);
    wide_quat_mul(q, inverse, swing);
    if (swing[3] < 0)
        wide_scale(swing, -1, 4);
    wide_quat_log(swing, s);
    wide_scale(s, 2, 3);
}

static void join(const wide s[3], const wide twist[4], wide out[4])
{
    wide half[3] = {s[0] / 2, s[1] / 2, s[2] / 2}, swing[4];
    wide_quat_exp(half, swing);
    wide_quat_mul(swing, twist, out);
}

/* The nearest point of an ellipse, by bisection of Eberly's equation. */
static void nearest(wide a, wide b, wide *x, wide *y)
{
    wide low = 0, high = (wide)1e6;
    if ((*x / a) * (*x / a) + (*y / b) * (*y / b) <= 1)
        return;
    for (int i = 0; i < 160; i++) {
        wide t = (low + high) / 2, u = a * *x / (t + a * a), v = b * *y / (t + b * b);
        if (u * u + v * v > 1)
            low = t;
        else
            high = t;
    }
    *x = a * a * *x / (low + a * a);
    *y = b * b * *y / (low + b * b);
}

static void limit_swing(const float *x, const wide axis[3], wide s[3], wide a, wide b)
{
    wide side[3], across[3];
    wide_from(x + SIDE, side, 3);
    wide_cross(axis, side, across);
    wide_normalize(across, 3);
    wide_cross(across, axis, side);
    wide p = wide_dot(s, side, 3), q = wide_dot(s, across, 3);
    nearest(a, b, &p, &q);
    for (int i = 0; i < 3; i++)
        s[i] = p * side[i] + q * across[i];
}

static void wide_limit_twist(const float *x, const wide axis[3], wide twist[4])
{
    wide low = x[TWIST], high = x[TWIST + 1], middle = (low + high) / 2, half = (high - low) / 2;
    wide angle = 2 * atan2q(wide_dot(twist, axis, 3), twist[3]), turn = 2 * wide_pi();
    wide off = remainderq(angle - middle, turn);
    off = off > half ? half : off < -half ? -half : off;
    wide_quat_from_axis(axis, middle + off, twist);
}

typedef enum which { CONE, ELLIPSE, TWISTS, ALL } which;

static nkw_quat got_of(const float *x, which w)
{
    nkw_limit limit = limit_of(x);
    nkw_quat q = quat_at(x);
    switch (w) {
    case CONE:
        return limit_cone(q, limit.axis, x[ANGLES]);
    case ELLIPSE:
        return limit_ellipse(q, limit.axis, limit.side, x[ANGLES], x[ANGLES + 1]);
    case TWISTS:
        return limit_twist(q, limit.axis, x[TWIST], x[TWIST + 1]);
    default:
        return nkw_limit_apply(&limit, q);
    }
}

/* Not counted: swings within 1e-3 rad of half a turn, and what the functions return unchanged. */
static double error_of(const float *x, which w)
{
    wide axis[3], q[4], s[3], twist[4], out[4], rest[4], off[4], inverse[4];
    float result[4];
    nkw_quat got = got_of(x, w);
    put_quat(result, got);
    wide_from(x + AXIS, axis, 3);
    wide_normalize(axis, 3);
    wide_from(x, q, 4);
    wide_normalize(q, 4);
    wide_from(x + REST, rest, 4);
    wide_normalize(rest, 4);
    conjugate(rest, inverse);
    wide_quat_mul(inverse, q, off);
    split(w == ALL ? off : q, axis, s, twist);
    if (wide_length(s, 3) > wide_pi() - (wide)1e-3 || (result[0] == x[0] && result[1] == x[1] && result[2] == x[2]))
        return 0;
    if (w != TWISTS)
        limit_swing(x, axis, s, x[ANGLES], x[w == CONE ? ANGLES : ANGLES + 1]);
    if (w == TWISTS || w == ALL)
        wide_limit_twist(x, axis, twist);
    join(s, twist, out);
    if (w == ALL) {
        wide_quat_mul(rest, out, off);
        return wide_error_either(result, off, 4);
    }
    return wide_error_either(result, out, 4);
}

static double cone_error(const float *x)
{
    return error_of(x, CONE);
}

static double ellipse_error(const float *x)
{
    return error_of(x, ELLIPSE);
}

static double twist_error(const float *x)
{
    return error_of(x, TWISTS);
}

static double all_error(const float *x)
{
    return error_of(x, ALL);
}

static const wide_case cases[] = {
    {"nkw_limit_apply", "cones of 0.1 .. 2.5 rad", any, cone_error, NUMBERS, WIDE_CHECKED},
    {"nkw_limit_apply", "half axes 0.1 .. 2.5 rad", any, ellipse_error, NUMBERS, WIDE_CHECKED},
    {"nkw_limit_apply", "ranges of 0.2 .. 5 rad", any, twist_error, NUMBERS, WIDE_CHECKED},
    {"nkw_limit_apply", "all three, from a rest rotation", any, all_error, NUMBERS, WIDE_CHECKED},
};

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("limit.h", argc, argv);
    wide_search(&a, cases, sizeof cases / sizeof cases[0], SAMPLES);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
