/* SPDX-License-Identifier: MIT */
/* Errors of <nakawari/vec.h> against binary128. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <quadmath.h>

#define SAMPLES 100000u
/* For sums of products. */
#define FEWER 150000u

/* ---- lerp: a, b, t; components of a and b from one distribution ---- */

static void lerp_t(random_source *r, float *x)
{
    x[6] = random_unit(r);
}

static void near_lerp(random_source *r, float *x)
{
    for (int i = 0; i < 3; i++) {
        float sign = random_sign(r), base = random_log(r, 1e-3f, 1e3f);
        x[i] = sign * base;
        x[3 + i] = x[i] * random_between(r, 0.25f, 4.0f);
    }
    lerp_t(r, x);
}

static void crossing_lerp(random_source *r, float *x)
{
    for (int i = 0; i < 3; i++) {
        x[i] = random_between(r, -1.0f, 0.0f);
        x[3 + i] = random_between(r, 0.0f, 1.0f);
    }
    lerp_t(r, x);
}

static void scattered_lerp(random_source *r, float *x)
{
    for (int i = 0; i < 6; i++) {
        float sign = random_sign(r);
        x[i] = sign * random_log(r, 1e-6f, 1e6f);
    }
    lerp_t(r, x);
}

static void base_lerp(random_source *r, float *x)
{
    for (int i = 0; i < 3; i++) {
        x[i] = random_log(r, 1e4f, 1e6f);
        float sign = random_sign(r);
        x[3 + i] = x[i] + sign * random_log(r, 1e-3f, 1.0f);
    }
    lerp_t(r, x);
}

static void extreme_lerp(random_source *r, float *x)
{
    for (int i = 0; i < 6; i++) {
        float sign = random_sign(r);
        x[i] = sign * random_log(r, 1e-15f, 1e15f);
    }
    lerp_t(r, x);
}

static void beyond_lerp(random_source *r, float *x)
{
    near_lerp(r, x);
    x[6] = random_between(r, -1.0f, 2.0f);
}

static double lerp_error(const float *x)
{
    nkw_vec3 v = nkw_vec3_lerp(vec3_at(x), vec3_at(x + 3), x[6]);
    double worst = 0.0;
    float got[3];
    put_vec3(got, v);
    for (int i = 0; i < 3; i++) {
        wide exact = (1 - (wide)x[6]) * x[i] + (wide)x[6] * x[3 + i];
        worst = fmax(worst, wide_error_of(got + i, &exact, 1, fmaxf(fabsf(x[i]), fabsf(x[3 + i]))));
    }
    return worst;
}

static double lerp_ulps(const float *x)
{
    nkw_vec3 v = nkw_vec3_lerp(vec3_at(x), vec3_at(x + 3), x[6]);
    return accuracy_ulps(v.x, (double)((1 - (wide)x[6]) * x[0] + (wide)x[6] * x[3]));
}

/* What is promised bit by bit: an infinite error where it is broken. */
static double lerp_promises(const float *x)
{
    nkw_vec3 a = vec3_at(x), b = vec3_at(x + 3);
    float start = nkw_vec3_lerp(a, b, 0.0f).x, end = nkw_vec3_lerp(a, b, 1.0f).x;
    float same = nkw_vec3_lerp(a, a, x[6]).x;
    return start == a.x && end == b.x && same == a.x ? 0.0 : HUGE_VAL;
}

/* ---- One vector ---- */

static void any_vector(random_source *r, float *x)
{
    float size = random_log(r, 1e-3f, 1e3f);
    put_vec3(x, nkw_vec3_scale(random_vec3(r, -1.0f, 1.0f), size));
}

static void scattered_vector(random_source *r, float *x)
{
    for (int i = 0; i < 3; i++)
        x[i] = random_scaled(r, -30, 30);
}

static void huge_vector(random_source *r, float *x)
{
    for (int i = 0; i < 3; i++)
        x[i] = random_scaled(r, 100, 127);
}

static void tiny_vector(random_source *r, float *x)
{
    for (int i = 0; i < 3; i++)
        x[i] = random_scaled(r, -149, -100);
}

/* From 2^-52 to 2^-44 and from 2^44 to 2^52: about the thresholds of rescaling. */
static void rescued_vector(random_source *r, float *x)
{
    float scale = random_bits(r) >> 63 ? 0x1p-48f : 0x1p48f;
    for (int i = 0; i < 3; i++)
        x[i] = random_scaled(r, -4, 4) * scale;
}

static double length_error(const float *x)
{
    wide v[3];
    wide_from(x, v, 3);
    return accuracy_ulps(nkw_vec3_length(vec3_at(x)), (double)wide_length(v, 3));
}

static double normalize_error(const float *x)
{
    wide v[3];
    float got[3];
    wide_from(x, v, 3);
    put_vec3(got, nkw_vec3_normalize(vec3_at(x)));
    wide_normalize(v, 3);
    return wide_error(got, v, 3);
}

/* As nkw_vec3_perpendicular says: the axis on which a is shortest is crossed with a. */
static double perpendicular_error(const float *x)
{
    float size[3] = {fabsf(x[0]), fabsf(x[1]), fabsf(x[2])}, got[3];
    int least = size[0] <= size[1] && size[0] <= size[2] ? 0 : size[1] <= size[2] ? 1 : 2;
    wide v[3], axis[3] = {least == 0, least == 1, least == 2};
    wide_from(x, v, 3);
    wide_cross(axis, v, v);
    wide_normalize(v, 3);
    put_vec3(got, nkw_vec3_perpendicular(vec3_at(x)));
    return wide_error(got, v, 3);
}

/* ---- Two vectors ---- */

static void any_pair(random_source *r, float *x)
{
    any_vector(r, x);
    any_vector(r, x + 3);
}

static void huge_pair(random_source *r, float *x)
{
    huge_vector(r, x);
    huge_vector(r, x + 3);
}

static void tiny_pair(random_source *r, float *x)
{
    tiny_vector(r, x);
    tiny_vector(r, x + 3);
}

/* b near a, at angles of about 1e-7 to 1e-1. */
static void near_pair(random_source *r, float *x)
{
    nkw_vec3 a = random_direction(r);
    nkw_vec3 b = nkw_vec3_add_scaled(a, random_direction(r), random_log(r, 1e-7f, 0.1f));
    put_vec3(x, nkw_vec3_scale(a, random_between(r, 0.5f, 2.0f)));
    put_vec3(x + 3, nkw_vec3_scale(b, random_between(r, 0.5f, 2.0f)));
}

static void opposite_pair(random_source *r, float *x)
{
    near_pair(r, x);
    for (int i = 3; i < 6; i++)
        x[i] = -x[i];
}

static double distance_error(const float *x)
{
    wide a[3], b[3];
    wide_from(x, a, 3);
    wide_from(x + 3, b, 3);
    for (int i = 0; i < 3; i++)
        a[i] -= b[i];
    return accuracy_ulps(nkw_vec3_distance(vec3_at(x), vec3_at(x + 3)), (double)wide_length(a, 3));
}

static double angle_error(const float *x)
{
    wide a[3], b[3], c[3];
    wide_from(x, a, 3);
    wide_from(x + 3, b, 3);
    wide_cross(a, b, c);
    wide exact = atan2q(wide_length(c, 3), wide_dot(a, b, 3));
    return accuracy_ulps(nkw_vec3_angle(vec3_at(x), vec3_at(x + 3)), (double)exact);
}

static void projection(const float *x, wide p[3], wide rest[3], wide *size)
{
    wide a[3], b[3];
    wide_from(x, a, 3);
    wide_from(x + 3, b, 3);
    wide k = wide_dot(a, b, 3) / wide_dot(b, b, 3);
    for (int i = 0; i < 3; i++) {
        p[i] = k * b[i];
        rest[i] = a[i] - p[i];
    }
    *size = wide_length(a, 3);
}

static double project_error(const float *x)
{
    wide p[3], rest[3], size;
    float got[3];
    projection(x, p, rest, &size);
    put_vec3(got, nkw_vec3_project(vec3_at(x), vec3_at(x + 3)));
    return wide_error_of(got, p, 3, size);
}

static double reject_error(const float *x)
{
    wide p[3], rest[3], size;
    float got[3];
    projection(x, p, rest, &size);
    put_vec3(got, nkw_vec3_reject(vec3_at(x), vec3_at(x + 3)));
    return wide_error_of(got, rest, 3, size);
}

/* ---- Sums of products: a, b; and s, or b a unit normal ---- */

static void scattered_pair(random_source *r, float *x)
{
    scattered_vector(r, x);
    scattered_vector(r, x + 3);
}

/* At right angles to 1e-7 .. 0.1. */
static void crossed_pair(random_source *r, float *x)
{
    nkw_vec3 a = random_direction(r), b = nkw_vec3_perpendicular(a);
    b = nkw_vec3_add_scaled(b, nkw_vec3_cross(a, b), random_between(r, -2.0f, 2.0f));
    b = nkw_vec3_add_scaled(b, a, random_log(r, 1e-7f, 0.1f));
    put_vec3(x, nkw_vec3_scale(a, random_between(r, 0.5f, 2.0f)));
    put_vec3(x + 3, b);
}

static wide wide_lengths(const float *x)
{
    wide a[3], b[3];
    wide_from(x, a, 3);
    wide_from(x + 3, b, 3);
    return wide_length(a, 3) * wide_length(b, 3);
}

static double dot_error(const float *x)
{
    wide a[3], b[3];
    wide_from(x, a, 3);
    wide_from(x + 3, b, 3);
    wide exact = wide_dot(a, b, 3);
    float got = nkw_vec3_dot(vec3_at(x), vec3_at(x + 3));
    return wide_error_of(&got, &exact, 1, wide_lengths(x));
}

static double cross_error(const float *x)
{
    wide a[3], b[3], exact[3];
    float got[3];
    wide_from(x, a, 3);
    wide_from(x + 3, b, 3);
    wide_cross(a, b, exact);
    put_vec3(got, nkw_vec3_cross(vec3_at(x), vec3_at(x + 3)));
    return wide_error_of(got, exact, 3, wide_lengths(x));
}

static void any_sum(random_source *r, float *x)
{
    any_pair(r, x);
    float sign = random_sign(r);
    x[6] = sign * random_log(r, 1e-3f, 1.0f);
}

/* a + s b near zero. */
static void cancelling_sum(random_source *r, float *x)
{
    any_sum(r, x);
    for (int i = 0; i < 3; i++)
        x[i] = -x[6] * x[3 + i] * (1.0f + random_scaled(r, -24, -4));
}

static double add_scaled_error(const float *x)
{
    double worst = 0.0;
    float got[3];
    put_vec3(got, nkw_vec3_add_scaled(vec3_at(x), vec3_at(x + 3), x[6]));
    for (int i = 0; i < 3; i++) {
        wide a = x[i], b = (wide)x[6] * x[3 + i], exact = a + b;
        worst = fmax(worst, wide_error_of(got + i, &exact, 1, (a < 0 ? -a : a) + (b < 0 ? -b : b)));
    }
    return worst;
}

/* Each component of an exactly unit normal rounded once. */
static void rounded_normal(float *n)
{
    wide w[3];
    wide_from(n, w, 3);
    wide_normalize(w, 3);
    wide_round(w, n, 3);
}

static void mirrored_by_rounded(random_source *r, float *x)
{
    any_pair(r, x);
    rounded_normal(x + 3);
}

/* Unit as the library makes it. */
static void mirrored_by_normalised(random_source *r, float *x)
{
    any_pair(r, x);
    put_vec3(x + 3, nkw_vec3_normalize(vec3_at(x + 3)));
}

static void mirrored_along_normal(random_source *r, float *x)
{
    near_pair(r, x);
    put_vec3(x + 3, nkw_vec3_normalize(vec3_at(x + 3)));
}

static void mirrored_beside_normal(random_source *r, float *x)
{
    crossed_pair(r, x);
    put_vec3(x + 3, nkw_vec3_normalize(vec3_at(x + 3)));
}

/* Against the mirror of n's direction, its length left out. */
static double reflect_error(const float *x)
{
    wide a[3], n[3], exact[3];
    float got[3];
    wide_from(x, a, 3);
    wide_from(x + 3, n, 3);
    wide k = 2 * wide_dot(a, n, 3) / wide_dot(n, n, 3);
    for (int i = 0; i < 3; i++)
        exact[i] = a[i] - k * n[i];
    put_vec3(got, nkw_vec3_reflect(vec3_at(x), vec3_at(x + 3)));
    return wide_error(got, exact, 3);
}

static const wide_case cases[] = {
    {"nkw_vec3_lerp", "within factor 4", near_lerp, lerp_error, 7, WIDE_CHECKED},
    {"nkw_vec3_lerp", "opposite signs", crossing_lerp, lerp_error, 7, WIDE_CHECKED},
    {"nkw_vec3_lerp", "magnitudes 1e-6 .. 1e6", scattered_lerp, lerp_error, 7, WIDE_CHECKED},
    {"nkw_vec3_lerp", "1e4 .. 1e6 + 1e-3 .. 1", base_lerp, lerp_error, 7, WIDE_CHECKED},
    {"nkw_vec3_lerp", "ratio to 1e30", extreme_lerp, lerp_error, 7, WIDE_CHECKED},
    {"nkw_vec3_lerp", "t in [-1, 2], within factor 4", beyond_lerp, lerp_error, 7, WIDE_NOTED},
    {"nkw_vec3_lerp", "within factor 4, ULP of x", near_lerp, lerp_ulps, 7, WIDE_NOTED},
    {"nkw_vec3_lerp", "1e4 .. 1e6 + 1e-3 .. 1, ULP of x", base_lerp, lerp_ulps, 7, WIDE_NOTED},
    {"nkw_vec3_lerp", "ends and constants, bit for bit", scattered_lerp, lerp_promises, 7, WIDE_CHECKED},
    {"nkw_vec3_length", "1e-3 .. 1e3", any_vector, length_error, 3, WIDE_CHECKED},
    {"nkw_vec3_length", "2^-30 .. 2^30 mixed", scattered_vector, length_error, 3, WIDE_CHECKED},
    {"nkw_vec3_length", "2^100 .. 2^127", huge_vector, length_error, 3, WIDE_CHECKED},
    {"nkw_vec3_length", "2^-149 .. 2^-100", tiny_vector, length_error, 3, WIDE_CHECKED},
    {"nkw_vec3_distance", "1e-3 .. 1e3", any_pair, distance_error, 6, WIDE_CHECKED},
    {"nkw_vec3_distance", "nearly equal", near_pair, distance_error, 6, WIDE_CHECKED},
    {"nkw_vec3_distance", "2^100 .. 2^127", huge_pair, distance_error, 6, WIDE_CHECKED},
    {"nkw_vec3_normalize", "1e-3 .. 1e3", any_vector, normalize_error, 3, WIDE_CHECKED},
    {"nkw_vec3_normalize", "2^-30 .. 2^30 mixed", scattered_vector, normalize_error, 3, WIDE_CHECKED},
    {"nkw_vec3_normalize", "2^-52 .. 2^52", rescued_vector, normalize_error, 3, WIDE_CHECKED},
    {"nkw_vec3_normalize", "2^100 .. 2^127", huge_vector, normalize_error, 3, WIDE_CHECKED},
    {"nkw_vec3_normalize", "2^-149 .. 2^-100", tiny_vector, normalize_error, 3, WIDE_CHECKED},
    {"nkw_vec3_angle", "any", any_pair, angle_error, 6, WIDE_CHECKED},
    {"nkw_vec3_angle", "1e-7 .. 0.1", near_pair, angle_error, 6, WIDE_CHECKED},
    {"nkw_vec3_angle", "pi - 0.1 .. pi - 1e-7", opposite_pair, angle_error, 6, WIDE_CHECKED},
    {"nkw_vec3_angle", "2^100 .. 2^127", huge_pair, angle_error, 6, WIDE_CHECKED},
    {"nkw_vec3_angle", "2^-149 .. 2^-100", tiny_pair, angle_error, 6, WIDE_CHECKED},
    {"nkw_vec3_project", "any", any_pair, project_error, 6, WIDE_CHECKED},
    {"nkw_vec3_project", "nearly along", near_pair, project_error, 6, WIDE_CHECKED},
    {"nkw_vec3_reject", "any", any_pair, reject_error, 6, WIDE_CHECKED},
    {"nkw_vec3_reject", "nearly along", near_pair, reject_error, 6, WIDE_CHECKED},
    {"nkw_vec3_perpendicular", "any", any_vector, perpendicular_error, 3, WIDE_CHECKED},
    {"nkw_vec3_perpendicular", "2^-30 .. 2^30 mixed", scattered_vector, perpendicular_error, 3, WIDE_CHECKED},
    {"nkw_vec3_perpendicular", "2^100 .. 2^127", huge_vector, perpendicular_error, 3, WIDE_CHECKED},
};

static const wide_case sums[] = {
    {"nkw_vec3_add_scaled", "s to 1 : 1000", any_sum, add_scaled_error, 7, WIDE_CHECKED},
    {"nkw_vec3_add_scaled", "a near -s b", cancelling_sum, add_scaled_error, 7, WIDE_CHECKED},
    {"nkw_vec3_dot", "any", any_pair, dot_error, 6, WIDE_CHECKED},
    {"nkw_vec3_dot", "nearly along", near_pair, dot_error, 6, WIDE_CHECKED},
    {"nkw_vec3_dot", "1e-7 .. 0.1 from right angles", crossed_pair, dot_error, 6, WIDE_CHECKED},
    {"nkw_vec3_dot", "2^-30 .. 2^30 mixed", scattered_pair, dot_error, 6, WIDE_CHECKED},
    {"nkw_vec3_cross", "any", any_pair, cross_error, 6, WIDE_CHECKED},
    {"nkw_vec3_cross", "nearly along", near_pair, cross_error, 6, WIDE_CHECKED},
    {"nkw_vec3_cross", "1e-7 .. 0.1 from right angles", crossed_pair, cross_error, 6, WIDE_CHECKED},
    {"nkw_vec3_cross", "2^-30 .. 2^30 mixed", scattered_pair, cross_error, 6, WIDE_CHECKED},
    {"nkw_vec3_reflect", "n rounded once", mirrored_by_rounded, reflect_error, 6, WIDE_CHECKED},
    {"nkw_vec3_reflect", "n normalised", mirrored_by_normalised, reflect_error, 6, WIDE_CHECKED},
    {"nkw_vec3_reflect", "n normalised, a nearly along", mirrored_along_normal, reflect_error, 6, WIDE_CHECKED},
    {"nkw_vec3_reflect", "n normalised, a nearly in the plane", mirrored_beside_normal, reflect_error, 6, WIDE_CHECKED},
};

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("vec.h", argc, argv);
    wide_search(&a, cases, sizeof cases / sizeof cases[0], SAMPLES);
    wide_search(&a, sums, sizeof sums / sizeof sums[0], FEWER);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
