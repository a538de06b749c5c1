/* SPDX-License-Identifier: MIT */
/* Errors of root.h. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <string.h>
#include <quadmath.h>

/* A rotation, then a translation. */
typedef struct rigid {
    wide q[4], t[3];
} rigid;

static void draw(random_source *r, float *x)
{
    put_vec3(x, random_vec3(r, -3.0f, 3.0f));
    put_quat(x + 3, random_unit_quat(r));
}

static nkw_trs trs_at(const float *x)
{
    nkw_trs t = {vec3_at(x), quat_at(x + 3), {1.0f, 1.0f, 1.0f}};
    return t;
}

static rigid rigid_at(const float *x)
{
    rigid a;
    wide_from(x, a.t, 3);
    wide_from(x + 3, a.q, 4);
    wide_normalize(a.q, 4);
    return a;
}

static void rotate(const wide q[4], const wide v[3], wide out[3])
{
    wide m[9];
    wide_mat3_from_quat(q, m);
    for (int i = 0; i < 3; i++)
        out[i] = m[i] * v[0] + m[3 + i] * v[1] + m[6 + i] * v[2];
}

static rigid mul(rigid a, rigid b)
{
    rigid c;
    wide_quat_mul(a.q, b.q, c.q);
    rotate(a.q, b.t, c.t);
    for (int i = 0; i < 3; i++)
        c.t[i] += a.t[i];
    return c;
}

static rigid inverse(rigid a)
{
    rigid c = {{-a.q[0], -a.q[1], -a.q[2], a.q[3]}, {0, 0, 0}};
    rotate(c.q, a.t, c.t);
    wide_scale(c.t, -1, 3);
    return c;
}

static double error_of(nkw_trs got, rigid want, wide size)
{
    return fmax(wide_error_either(&got.rotation.x, want.q, 4), wide_error_of(&got.translation.x, want.t, 3, size));
}

/* Up, the root. */
static void up_and_root(random_source *r, float *x)
{
    draw(r, x + 3);
    put_vec3(x, random_vec3(r, -1.0f, 1.0f));
}

static double rest_error(const float *x)
{
    nkw_root_rule rule = {vec3_at(x), NKW_ROOT_PLANE | NKW_ROOT_YAW};
    nkw_trs root = trs_at(x + 3);
    nkw_root_motion got = nkw_root_split(&rule, &root);
    float m[7];
    memcpy(m, &got.motion, sizeof m);
    rigid a = rigid_at(x + 3), b = rigid_at(m);
    return error_of(got.rest, mul(inverse(b), a), wide_length(a.t, 3) + wide_length(b.t, 3));
}

static double extract_error(const float *x)
{
    nkw_root_rule rule = {vec3_at(x), NKW_ROOT_PLANE};
    nkw_trs root = trs_at(x + 3), got = nkw_root_split(&rule, &root).motion;
    wide up[3], p[3];
    wide_from(x, up, 3);
    wide_from(x + 3, p, 3);
    wide along = wide_dot(up, p, 3) / wide_dot(up, up, 3), size = wide_length(p, 3);
    for (int i = 0; i < 3; i++)
        p[i] -= along * up[i];
    return wide_error_of(&got.translation.x, p, 3, wide_length(p, 3) + size * 0x1p-26);
}

/* First, last, from, to, cycles. */
static void step(random_source *r, float *x)
{
    for (int i = 0; i < 4; i++)
        draw(r, x + 7 * i);
    x[28] = (float)(int)random_between(r, -30.0f, 30.0f);
}

/* Twelve days of cycles of one second. */
static void many_steps(random_source *r, float *x)
{
    step(r, x);
    x[28] = (float)(int)(random_sign(r) * random_log(r, 1.0f, 0x1p20f));
}

/* c^n, by squaring. */
static rigid power(rigid c, long n)
{
    rigid all = {{0, 0, 0, 1}, {0, 0, 0}};
    if (n < 0)
        c = inverse(c);
    for (n = n < 0 ? -n : n; n > 0; n /= 2) {
        if (n % 2)
            all = mul(c, all);
        c = mul(c, c);
    }
    return all;
}

static double delta_error(const float *x)
{
    nkw_root_cycle cycle = {trs_at(x), trs_at(x + 7)};
    nkw_trs from = trs_at(x + 14), to = trs_at(x + 21);
    rigid c = mul(rigid_at(x + 7), inverse(rigid_at(x)));
    rigid want = mul(power(c, (long)x[28]), rigid_at(x + 21));
    wide size = (1 + fabsf(x[28])) * (wide_length(rigid_at(x).t, 3) + wide_length(rigid_at(x + 7).t, 3));
    want = mul(inverse(rigid_at(x + 14)), want);
    return error_of(nkw_root_delta(&cycle, &from, &to, (double)x[28]), want, wide_length(want.t, 3) + size * 0x1p-10);
}

static double place_error(const float *x)
{
    nkw_root_cycle cycle = {trs_at(x), trs_at(x + 7)};
    nkw_trs origin = trs_at(x + 14), now = trs_at(x + 21);
    rigid c = mul(rigid_at(x + 7), inverse(rigid_at(x)));
    rigid want = mul(power(c, (long)x[28]), rigid_at(x + 21));
    wide size = (1 + fabsf(x[28])) * (wide_length(rigid_at(x).t, 3) + wide_length(rigid_at(x + 7).t, 3));
    want = mul(rigid_at(x + 14), mul(inverse(rigid_at(x)), want));
    return error_of(nkw_root_place(&cycle, &origin, &now, (double)x[28]), want,
                    wide_length(want.t, 3) + size * 0x1p-10);
}

/* Three motions and their weights. */
static void three(random_source *r, float *x)
{
    for (int i = 0; i < 3; i++) {
        draw(r, x + 7 * i);
        x[21 + i] = random_unit(r) + 0.001f;
    }
}

static double blend_error(const float *x)
{
    nkw_trs motions[3] = {trs_at(x), trs_at(x + 7), trs_at(x + 14)};
    rigid mean = {{0, 0, 0, 0}, {0, 0, 0}};
    wide half[3] = {0, 0, 0}, total = 0, size = 0;
    for (int i = 0; i < 3; i++) {
        rigid a = rigid_at(x + 7 * i);
        wide v[3], w = x[21 + i];
        wide_scale(a.q, a.q[3] < 0 ? -1 : 1, 4);
        wide_quat_log(a.q, v);
        for (int k = 0; k < 3; k++) {
            half[k] += w * v[k];
            mean.t[k] += w * a.t[k];
        }
        total += w;
        size = fmaxq(size, wide_length(a.t, 3));
    }
    wide_scale(half, 1 / total, 3);
    wide_scale(mean.t, 1 / total, 3);
    wide_quat_exp(half, mean.q);
    return error_of(nkw_root_blend(motions, x + 21, 3), mean, size);
}

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("root.h", argc, argv);
    static const wide_case cases[] = {
        {"nkw_root_split", "the motion of the plane", up_and_root, extract_error, 10, WIDE_CHECKED},
        {"nkw_root_split", "the rest of plane and yaw", up_and_root, rest_error, 10, WIDE_CHECKED},
        {"nkw_root_delta", "up to 30 loops", step, delta_error, 29, WIDE_CHECKED},
        {"nkw_root_place", "up to 30 loops", step, place_error, 29, WIDE_CHECKED},
        {"nkw_root_delta", "up to 2^20 loops", many_steps, delta_error, 29, WIDE_CHECKED},
        {"nkw_root_place", "up to 2^20 loops", many_steps, place_error, 29, WIDE_CHECKED},
        {"nkw_root_blend", "three motions", three, blend_error, 24, WIDE_CHECKED},
    };
    wide_search(&a, cases, sizeof cases / sizeof *cases, 4000);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
