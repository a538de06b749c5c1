/* SPDX-License-Identifier: MIT */
/* Errors of inertia.h, in u of the magnitudes that the Error lines name. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <quadmath.h>

#include "../support/motions.h"

/* Two motions of a number, the duration, the time as a part of the shortened duration, the half-life. */
static void two_motions(random_source *r, float *x)
{
    for (int i = 0; i < 4; i++)
        x[i] = random_sign(r) * random_log(r, 0.01f, 10.0f);
    x[4] = random_log(r, 0.05f, 2.0f);
    x[5] = random_unit(r);
    x[6] = random_log(r, 0.01f, 10.0f);
}

/* The coefficients of the quintic in u, and its duration. */
static wide quintic(wide x, wide v, wide duration, wide c[3])
{
    wide growth = x == 0 ? 0 : v / x, t = duration * growth < -5 ? -5 / growth : duration, a = -8 * growth * t - 20;
    c[0] = x;
    c[1] = v * t + 3 * x;
    c[2] = 3 * v * t + (6 + (a > 0 ? a / 2 : 0)) * x;
    return t;
}

static double begin_error(const float *x)
{
    nkw_state from = {x[0], x[1]}, to = {x[2], x[3]};
    nkw_offset got = inertia_of(from, to, x[4]);
    wide c[3], e = (wide)x[0] - x[2], v = (wide)x[1] - x[3], t = quintic(e, v, x[4], c);
    return fmax(wide_error(got.c, c, 3), wide_error(&got.end, &t, 1));
}

static double evaluate_error(const float *x)
{
    nkw_state from = {x[0], x[1]}, to = {x[2], x[3]};
    nkw_offset i = inertia_of(from, to, x[4]);
    float t = x[5] * i.end, got = nkw_offset_evaluate(&i, to, t).value;
    wide u = (wide)t / i.end, w = 1 - u;
    wide want = x[2] + (u < 1 ? w * w * w * (i.c[0] + u * (i.c[1] + u * (wide)i.c[2])) : 0);
    float size = fabsf(x[2]) + fabsf(i.c[0]) + fabsf(i.c[1]) + fabsf(i.c[2]);
    return wide_error_of(&got, &want, 1, size);
}

/* The coefficients, the new rotation, u. */
static void offset(random_source *r, float *x)
{
    for (int i = 0; i < 3; i++)
        put_vec3(x + 3 * i, random_vec3(r, -0.5f, 0.5f));
    put_quat(x + 9, random_unit_quat(r));
    x[13] = random_unit(r);
}

/* The same with coefficients to 2^10 rad that cancel each other. */
static void large_offset(random_source *r, float *x)
{
    offset(r, x);
    float size = random_log(r, 0.01f, 0x1p10f);
    for (int i = 0; i < 9; i++)
        x[i] *= size;
}

static double quat_evaluate_error(const float *x)
{
    nkw_quat_offset i = {.end = 1.0f, .c = {vec3_at(x), vec3_at(x + 3), vec3_at(x + 6)}};
    nkw_quat_state to = {quat_at(x + 9), {0.0f, 0.0f, 0.0f}}, got = nkw_quat_offset_evaluate(&i, &to, x[13]);
    wide u = x[13], w = (1 - u) * (1 - u) * (1 - u), v[3], q[4], e[4], want[4];
    for (int k = 0; k < 3; k++)
        v[k] = w * (x[k] + u * (x[3 + k] + u * x[6 + k]));
    wide_from(x + 9, q, 4);
    wide_quat_exp(v, e);
    wide_quat_mul(e, q, want);
    return wide_error(&got.value.x, want, 4);
}

/* The old rotation and its velocity, the new one and its velocity, the duration. */
static void two_turning(random_source *r, float *x)
{
    nkw_quat q = random_unit_quat(r);
    put_quat(x, q);
    put_vec3(x + 4, nkw_vec3_scale(random_direction(r), random_unit(r) < 0.25f ? 0.0f : random_log(r, 0.001f, 5.0f)));
    put_quat(x + 7, random_unit_near(r, q, random_log(r, 0x1p-10f, 1.5f)));
    put_vec3(x + 11, nkw_vec3_scale(random_direction(r), random_unit(r) < 0.25f ? 0.0f : random_log(r, 0.001f, 5.0f)));
    x[14] = random_log(r, 0.05f, 2.0f);
}

/* The rate of half the rotation vector v = log d for the angular velocity w. */
static void half_rate(const wide v[3], const wide w[3], wide out[3])
{
    wide_rotation_rate(v, w, out);
    wide_scale(out, (wide)0.5, 3);
}

/* x = log(from to^-1) of the shorter arc, and its rate v. */
static void exact_offset(const float *in, wide x[3], wide v[3])
{
    wide q[4], g[4], d[4], w[3], to[3], m[9];
    wide_from(in, q, 4);
    wide_from(in + 7, g, 4);
    wide_from(in + 4, w, 3);
    wide_from(in + 11, to, 3);
    wide_normalize(q, 4);
    wide_normalize(g, 4);
    wide c[4] = {-g[0], -g[1], -g[2], g[3]};
    wide_quat_mul(q, c, d);
    wide_scale(d, d[3] < 0 ? -1 : 1, 4);
    wide_quat_log(d, x);
    wide_mat3_from_quat(d, m);
    for (int i = 0; i < 3; i++)
        w[i] -= m[i] * to[0] + m[3 + i] * to[1] + m[6 + i] * to[2];
    half_rate(x, w, v);
}

/* The coefficients of nkw_vec3_offset_begin for an offset x of rate v, and the duration. */
static wide exact_coefficients(const wide x[3], const wide v[3], wide duration, wide c[9])
{
    wide xx = wide_dot(x, x, 3), growth = xx > 0 ? wide_dot(x, v, 3) / xx : 0;
    wide t = duration * growth < -5 ? -5 / growth : duration, a = -8 * growth * t - 20;
    for (int i = 0; i < 3; i++) {
        c[i] = x[i];
        c[3 + i] = v[i] * t + 3 * x[i];
        c[6 + i] = 3 * v[i] * t + (6 + (a > 0 ? a / 2 : 0)) * x[i];
    }
    return t;
}

static double quat_begin_error(const float *in)
{
    nkw_quat_state from = {quat_at(in), vec3_at(in + 4)}, to = {quat_at(in + 7), vec3_at(in + 11)};
    nkw_quat_offset got = inertia_of_quat(&from, &to, in[14]);
    wide x[3], v[3], c[9];
    exact_offset(in, x, v);
    wide t = exact_coefficients(x, v, in[14], c);
    double direction = (double)fabsq(wide_dot(x, v, 3)), size = (double)(wide_length(x, 3) * wide_length(v, 3));
    if (t != (wide)in[14] && direction < 0x1p-10 * size)
        return 0.0;
    return fmax(wide_error(&got.c[0].x, c, 9), wide_error(&got.end, &t, 1));
}

/* Two rotations at rest: x[14] is the duration, x[15] the time in it. */
static void two_resting(random_source *r, float *x)
{
    two_turning(r, x);
    for (int i = 0; i < 3; i++)
        x[4 + i] = x[11 + i] = 0.0f;
    x[15] = random_unit(r);
}

/* The header states 2.5 u for both functions together: in parts of that, as the line of 1.01 u. */
static double resting_error(const float *in)
{
    nkw_quat_state from = {quat_at(in), vec3_at(in + 4)}, to = {quat_at(in + 7), vec3_at(in + 11)};
    nkw_quat_offset inertia = inertia_of_quat(&from, &to, in[14]);
    float t = in[14] * in[15];
    nkw_quat_state got = nkw_quat_offset_evaluate(&inertia, &to, t);
    wide x[3], v[3], c[9], u = (wide)t / in[14], w = (1 - u) * (1 - u) * (1 - u), e[4], g[4], want[4];
    exact_offset(in, x, v);
    exact_coefficients(x, v, in[14], c);
    for (int i = 0; i < 3; i++)
        v[i] = u < 1 ? w * (c[i] + u * (c[3 + i] + u * c[6 + i])) : 0;
    wide_from(in + 7, g, 4);
    wide_quat_exp(v, e);
    wide_quat_mul(e, g, want);
    return wide_error(&got.value.x, want, 4) * (1.01 / 2.5);
}

static double dead_error(const float *x)
{
    nkw_state from = {x[0], x[1]}, to = {x[2], x[3]};
    nkw_offset d = dead_of(from, x[6], x[4]);
    float t = x[5] * x[4], got = nkw_offset_evaluate(&d, to, t).value;
    wide u = (wide)t / x[4], h = x[6] / logq(2), carried = x[1] * h * -expm1q(-t / h), old = x[0] + carried;
    wide s = u * u * (3 - 2 * u), want = u < 1 ? old + s * (x[2] - old) : x[2];
    return wide_error_of(&got, &want, 1, fabsq((wide)x[0]) + fabsq(carried) + fabsq((wide)x[2]));
}

/* The old rotation and its velocity, the new one, the duration, u, the half-life. */
static void two_rotations(random_source *r, float *x)
{
    nkw_quat q = random_unit_quat(r);
    put_quat(x, q);
    put_vec3(x + 4, nkw_vec3_scale(random_direction(r), random_between(r, 0.0f, 5.0f)));
    put_quat(x + 7, random_unit_near(r, q, random_between(r, 0.0f, 1.5f)));
    x[11] = random_log(r, 0.05f, 2.0f);
    x[12] = random_unit(r);
    x[13] = random_log(r, 0.01f, 10.0f);
}

static double quat_dead_error(const float *x)
{
    nkw_quat_state from = {quat_at(x), vec3_at(x + 4)}, to = {quat_at(x + 7), {0.0f, 0.0f, 0.0f}};
    nkw_quat_offset d = dead_of_quat(from, x[13], x[11]);
    float t = x[12] * x[11];
    nkw_quat_state got = nkw_quat_offset_evaluate(&d, &to, t);
    wide u = (wide)t / x[11], h = x[13] / logq(2), s = u < 1 ? u * u * (3 - 2 * u) : 1, q[4], v[3], e[4], g[4], old[4];
    wide_from(x, q, 4);
    wide_from(x + 4, v, 3);
    wide_from(x + 7, g, 4);
    wide_normalize(q, 4);
    wide_scale(v, h * -expm1q(-t / h) / 2, 3);
    wide_quat_exp(v, e);
    wide_quat_mul(e, q, old);
    wide c[4] = {-g[0], -g[1], -g[2], g[3]}, want[4];
    wide_normalize(c, 4);
    wide_quat_mul(old, c, e);
    wide_scale(e, d.difference.w * e[3] < 0 ? -1 : 1, 4);
    wide_quat_log(e, v);
    wide_scale(v, 1 - s, 3);
    wide_quat_exp(v, e);
    wide_quat_mul(e, g, want);
    return wide_error(&got.value.x, want, 4);
}

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("inertia.h", argc, argv);
    static const wide_case cases[] = {
        {"nkw_offset_begin", "inertialisation", two_motions, begin_error, 5, WIDE_CHECKED},
        {"nkw_offset_evaluate", "inertialisation", two_motions, evaluate_error, 6, WIDE_CHECKED},
        {"nkw_quat_offset_evaluate", "inertialisation", offset, quat_evaluate_error, 14, WIDE_CHECKED},
        {"nkw_quat_offset_evaluate", "coefficients to 2^9 rad", large_offset, quat_evaluate_error, 14, WIDE_CHECKED},
        {"nkw_quat_offset_begin", "2^-9 to 3 rad", two_turning, quat_begin_error, 15, WIDE_CHECKED},
        {"nkw_quat_offset_evaluate", "from rest to rest, its begin too, of 2.5 u", two_resting, resting_error, 16,
         WIDE_CHECKED},
        {"nkw_offset_evaluate", "dead blending", two_motions, dead_error, 7, WIDE_CHECKED},
        {"nkw_quat_offset_evaluate", "dead blending", two_rotations, quat_dead_error, 14, WIDE_CHECKED},
    };
    wide_search(&a, cases, sizeof cases / sizeof *cases, 20000);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
