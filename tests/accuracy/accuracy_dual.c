/* SPDX-License-Identifier: MIT */
/* Errors of <nakawari/dual.h> against binary128. Motions are those of d / |real|: its rounding counts. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <string.h>

#define SAMPLES 25000u

static nkw_dual_quat dual_at(const float *x)
{
    nkw_dual_quat d = {quat_at(x), quat_at(x + 4)};
    return d;
}

static void put_dual(float *x, nkw_dual_quat d)
{
    put_quat(x, d.real);
    put_quat(x + 4, d.dual);
}

/* ---- Samples: a unit dual quaternion, and what it works on ---- */

static void any_dual(random_source *r, float *x)
{
    nkw_quat q = random_unit_quat(r);
    float size = random_log(r, 1e-3f, 1e3f);
    put_dual(x, nkw_dual_quat_from_rigid(q, nkw_vec3_scale(random_vec3(r, -1.0f, 1.0f), size)));
}

static nkw_quat near_half_turn(random_source *r)
{
    nkw_vec3 axis = random_direction(r);
    nkw_quat half = {axis.x, axis.y, axis.z, 0.0f};
    return random_unit_near(r, half, random_log(r, 1e-7f, 1e-2f));
}

static void half_turned_dual(random_source *r, float *x)
{
    nkw_quat q = near_half_turn(r);
    float size = random_log(r, 1e-3f, 1e3f);
    put_dual(x, nkw_dual_quat_from_rigid(q, nkw_vec3_scale(random_vec3(r, -1.0f, 1.0f), size)));
}

/* d or -d, the one whose real part is nearer to that of `side`. */
static nkw_dual_quat aligned(const nkw_dual_quat *d, const nkw_dual_quat *side)
{
    const float sign = nkw_quat_dot(d->real, side->real) < 0.0f ? -1.0f : 1.0f;
    nkw_dual_quat r = {nkw_quat_scale(d->real, sign), nkw_quat_scale(d->dual, sign)};
    return r;
}

/* As blending makes them: the sum of two, normalised. */
static void blended_dual(random_source *r, float *x)
{
    float other[8];
    any_dual(r, x);
    any_dual(r, other);
    nkw_dual_quat a = dual_at(x), b = dual_at(other);
    b = aligned(&b, &a);
    float t = random_unit(r);
    a.real = nkw_quat_add(nkw_quat_scale(a.real, 1.0f - t), nkw_quat_scale(b.real, t));
    a.dual = nkw_quat_add(nkw_quat_scale(a.dual, 1.0f - t), nkw_quat_scale(b.dual, t));
    put_dual(x, nkw_dual_quat_normalize(&a));
}

static void any_point(random_source *r, float *x)
{
    any_dual(r, x);
    put_vec3(x + 8, random_vec3(r, -10.0f, 10.0f));
}

static void half_turned_point(random_source *r, float *x)
{
    half_turned_dual(r, x);
    put_vec3(x + 8, random_vec3(r, -10.0f, 10.0f));
}

static void blended_point(random_source *r, float *x)
{
    blended_dual(r, x);
    put_vec3(x + 8, random_vec3(r, -10.0f, 10.0f));
}

/* To near the origin. */
static void lost_point(random_source *r, float *x)
{
    nkw_quat q = random_unit_quat(r);
    nkw_vec3 p = random_vec3(r, -10.0f, 10.0f), off = random_vec3(r, -1.0f, 1.0f);
    nkw_vec3 t = nkw_vec3_add_scaled(nkw_vec3_negate(nkw_quat_rotate(q, p)), off, random_scaled(r, -24, -4));
    put_dual(x, nkw_dual_quat_from_rigid(q, t));
    put_vec3(x + 8, p);
}

static void any_pair(random_source *r, float *x)
{
    any_dual(r, x);
    any_dual(r, x + 8);
}

static void half_turned_pair(random_source *r, float *x)
{
    half_turned_dual(r, x);
    half_turned_dual(r, x + 8);
}

static nkw_dual_quat conjugate(const nkw_dual_quat *d)
{
    nkw_dual_quat r = {nkw_quat_conjugate(d->real), nkw_quat_conjugate(d->dual)};
    return r;
}

/* b near the inverse of a. */
static void undoing_pair(random_source *r, float *x)
{
    any_dual(r, x);
    nkw_dual_quat a = dual_at(x), back = conjugate(&a);
    back.real = random_unit_near(r, back.real, random_log(r, 1e-7f, 1e-2f));
    put_dual(x + 8, back);
}

/* ---- The motion of d: the rotation matrix and the translation 2 dual real* / |real|^2 ---- */

static void motion_of(const float *x, wide m[9], wide t[3])
{
    wide real[4], dual[4], back[4];
    wide_from(x, real, 4);
    wide_from(x + 4, dual, 4);
    wide_mat3_from_quat(real, m);
    wide s = 2 / wide_dot(real, real, 4);
    for (int i = 0; i < 4; i++)
        back[i] = i < 3 ? -real[i] : real[i];
    wide_quat_mul(dual, back, dual);
    for (int i = 0; i < 3; i++)
        t[i] = s * dual[i];
}

static double translation_error(const float *x)
{
    wide m[9], t[3];
    float got[3];
    nkw_dual_quat d = dual_at(x);
    motion_of(x, m, t);
    put_vec3(got, nkw_dual_quat_transform_point(&d, NKW_VEC3_ZERO));
    return wide_error(got, t, 3);
}

/* The 3x3 block as nkw_mat3_from_quat, by |R| = sqrt 3; the last row exactly. */
static double matrix_turn_error(const float *x)
{
    wide m[9], t[3];
    nkw_dual_quat d = dual_at(x);
    nkw_mat4 got = nkw_mat4_from_dual_quat(&d);
    nkw_mat3 block = nkw_mat3_from_mat4(&got);
    motion_of(x, m, t);
    int last = got.m[3] == 0.0f && got.m[7] == 0.0f && got.m[11] == 0.0f && got.m[15] == 1.0f;
    return last ? wide_error(block.m, m, 9) : HUGE_VAL;
}

static double matrix_place_error(const float *x)
{
    wide m[9], t[3];
    nkw_dual_quat d = dual_at(x);
    nkw_mat4 got = nkw_mat4_from_dual_quat(&d);
    motion_of(x, m, t);
    return wide_error(got.m + 12, t, 3);
}

/* Of |p| + |t|. */
static double point_error(const float *x)
{
    wide m[9], t[3], p[3], exact[3];
    float got[3];
    nkw_dual_quat d = dual_at(x);
    motion_of(x, m, t);
    wide_from(x + 8, p, 3);
    for (int i = 0; i < 3; i++)
        exact[i] = m[i] * p[0] + m[3 + i] * p[1] + m[6 + i] * p[2] + t[i];
    put_vec3(got, nkw_dual_quat_transform_point(&d, vec3_at(x + 8)));
    return wide_error_of(got, exact, 3, wide_length(p, 3) + wide_length(t, 3));
}

/* ---- Products ---- */

static double product_real_error(const float *x)
{
    wide a[4], b[4];
    float got[4];
    nkw_dual_quat c = dual_at(x), d = dual_at(x + 8);
    wide_from(x, a, 4);
    wide_from(x + 8, b, 4);
    wide_quat_mul(a, b, a);
    put_quat(got, nkw_dual_quat_mul(&c, &d).real);
    return wide_error(got, a, 4);
}

/* Of |a.dual| + |b.dual|. */
static double product_dual_error(const float *x)
{
    wide a[8], b[8], first[4], second[4];
    float got[4];
    nkw_dual_quat c = dual_at(x), d = dual_at(x + 8);
    wide_from(x, a, 8);
    wide_from(x + 8, b, 8);
    wide_quat_mul(a, b + 4, first);
    wide_quat_mul(a + 4, b, second);
    for (int i = 0; i < 4; i++)
        first[i] += second[i];
    put_quat(got, nkw_dual_quat_mul(&c, &d).dual);
    return wide_error_of(got, first, 4, wide_length(a + 4, 4) + wide_length(b + 4, 4));
}

/* ---- Normalised: any eight numbers ---- */

static void scaled(random_source *r, float *x, int low, int high)
{
    for (int i = 0; i < 8; i++)
        x[i] = random_scaled(r, low, high);
}

static void any_eight(random_source *r, float *x)
{
    float size = random_log(r, 1e-3f, 1e3f);
    for (int i = 0; i < 8; i++)
        x[i] = random_between(r, -1.0f, 1.0f) * size;
}

static void sum_of_two(random_source *r, float *x)
{
    any_pair(r, x);
    for (int i = 0; i < 8; i++)
        x[i] += x[8 + i];
}

static void scattered_eight(random_source *r, float *x)
{
    scaled(r, x, -30, 30);
}

static void huge_eight(random_source *r, float *x)
{
    scaled(r, x, 100, 126);
}

static void tiny_eight(random_source *r, float *x)
{
    scaled(r, x, -149, -100);
}

static double normal_real_error(const float *x)
{
    wide real[4];
    float got[4];
    nkw_dual_quat d = dual_at(x);
    wide_from(x, real, 4);
    wide_normalize(real, 4);
    put_quat(got, nkw_dual_quat_normalize(&d).real);
    return wide_error(got, real, 4);
}

/* Of |dual| / |real|. */
static double normal_dual_error(const float *x)
{
    wide real[4], dual[4];
    float got[4];
    nkw_dual_quat d = dual_at(x);
    wide_from(x, real, 4);
    wide_from(x + 4, dual, 4);
    wide length = wide_length(real, 4);
    wide_normalize(real, 4);
    wide_scale(dual, 1 / length, 4);
    wide along = wide_dot(real, dual, 4), size = wide_length(dual, 4);
    for (int i = 0; i < 4; i++)
        dual[i] -= along * real[i];
    put_quat(got, nkw_dual_quat_normalize(&d).dual);
    return wide_error_of(got, dual, 4, size);
}

/* ---- Made: a rotation, a translation, a scale ---- */

static void rigid(random_source *r, float *x)
{
    put_quat(x, random_unit_quat(r));
    float size = random_log(r, 1e-3f, 1e3f);
    put_vec3(x + 4, nkw_vec3_scale(random_vec3(r, -1.0f, 1.0f), size));
    x[7] = 1.0f;
}

static void rigid_near_half_turn(random_source *r, float *x)
{
    rigid(r, x);
    put_quat(x, near_half_turn(r));
}

static void scaled_rigid(random_source *r, float *x)
{
    rigid(r, x);
    x[7] = random_log(r, 0.1f, 10.0f);
}

/* (t / 2) q. */
static void dual_part(const wide q[4], const float *t, wide out[4])
{
    wide half[4] = {(wide)t[0] / 2, (wide)t[1] / 2, (wide)t[2] / 2, 0};
    wide_quat_mul(half, q, out);
}

static double from_rigid_error(const float *x)
{
    wide q[4], exact[4];
    float got[8];
    put_dual(got, nkw_dual_quat_from_rigid(quat_at(x), vec3_at(x + 4)));
    wide_from(x, q, 4);
    dual_part(q, x + 4, exact);
    return memcmp(got, x, 4 * sizeof *x) ? HUGE_VAL : wide_error(got + 4, exact, 4);
}

static double there_and_back_error(const float *x)
{
    wide t[3];
    float got[3];
    nkw_dual_quat d = nkw_dual_quat_from_rigid(quat_at(x), vec3_at(x + 4));
    wide_from(x + 4, t, 3);
    put_vec3(got, nkw_dual_quat_transform_point(&d, NKW_VEC3_ZERO));
    return wide_error(got, t, 3);
}

/* Against the rotation nearest to the columns of the matrix, each rounded once and divided by its length. */
static double from_mat4_error(const float *x, int part)
{
    wide q[4], m[9], exact[8];
    float got[8];
    nkw_mat4 f = nkw_mat4_identity();
    wide_from(x, q, 4);
    wide_mat3_from_quat(q, m);
    wide_scale(m, x[7], 9);
    for (int c = 0; c < 3; c++) {
        wide_round(m + c * 3, f.m + c * 4, 3);
        wide_from(f.m + c * 4, m + c * 3, 3);
        wide_normalize(m + c * 3, 3);
    }
    put_vec3(f.m + 12, vec3_at(x + 4));
    wide_quat_from_mat3(m, exact);
    put_dual(got, nkw_dual_quat_from_mat4(&f));
    /* The sign of the result: at half turns either is right. */
    wide_scale(exact, got[0] * exact[0] + got[1] * exact[1] + got[2] * exact[2] + got[3] * exact[3] < 0 ? -1 : 1, 4);
    dual_part(exact, x + 4, exact + 4);
    return got[3] >= 0.0f ? wide_error(got + part, exact + part, 4) : HUGE_VAL;
}

static double from_mat4_real_error(const float *x)
{
    return from_mat4_error(x, 0);
}

static double from_mat4_dual_error(const float *x)
{
    return from_mat4_error(x, 4);
}

#define FROM_RIGID  "nkw_dual_quat_from_rigid"
#define FROM_MAT4   "nkw_dual_quat_from_mat4"
#define TO_MAT4     "nkw_mat4_from_dual_quat"
#define MUL         "nkw_dual_quat_mul"
#define NORMALIZE   "nkw_dual_quat_normalize"
#define POINT       "nkw_dual_quat_transform_point"

static const wide_case cases[] = {
    {FROM_RIGID, "dual", rigid, from_rigid_error, 8, WIDE_CHECKED},
    {FROM_RIGID, "dual, near half turns", rigid_near_half_turn, from_rigid_error, 8, WIDE_CHECKED},
    {FROM_MAT4, "real, rigid", rigid, from_mat4_real_error, 8, WIDE_CHECKED},
    {FROM_MAT4, "real, scales 0.1 .. 10", scaled_rigid, from_mat4_real_error, 8, WIDE_CHECKED},
    {FROM_MAT4, "dual, rigid", rigid, from_mat4_dual_error, 8, WIDE_CHECKED},
    {FROM_MAT4, "dual, scales 0.1 .. 10", scaled_rigid, from_mat4_dual_error, 8, WIDE_CHECKED},
    {TO_MAT4, "rotation", any_dual, matrix_turn_error, 8, WIDE_CHECKED},
    {TO_MAT4, "rotation, near half turns", half_turned_dual, matrix_turn_error, 8, WIDE_CHECKED},
    {TO_MAT4, "translation", any_dual, matrix_place_error, 8, WIDE_CHECKED},
    {TO_MAT4, "translation, near half turns", half_turned_dual, matrix_place_error, 8, WIDE_CHECKED},
    {MUL, "real", any_pair, product_real_error, 16, WIDE_CHECKED},
    {MUL, "real, near half turns", half_turned_pair, product_real_error, 16, WIDE_CHECKED},
    {MUL, "dual", any_pair, product_dual_error, 16, WIDE_CHECKED},
    {MUL, "dual, near half turns", half_turned_pair, product_dual_error, 16, WIDE_CHECKED},
    {MUL, "dual, with nearly the inverse", undoing_pair, product_dual_error, 16, WIDE_CHECKED},
    {NORMALIZE, "real, sum of two", sum_of_two, normal_real_error, 8, WIDE_CHECKED},
    {NORMALIZE, "real, 1e-3 .. 1e3", any_eight, normal_real_error, 8, WIDE_CHECKED},
    {NORMALIZE, "real, 2^-30 .. 2^30 mixed", scattered_eight, normal_real_error, 8, WIDE_CHECKED},
    {NORMALIZE, "real, 2^100 .. 2^126", huge_eight, normal_real_error, 8, WIDE_CHECKED},
    {NORMALIZE, "real, 2^-149 .. 2^-100", tiny_eight, normal_real_error, 8, WIDE_CHECKED},
    {NORMALIZE, "dual, sum of two", sum_of_two, normal_dual_error, 8, WIDE_CHECKED},
    {NORMALIZE, "dual, 1e-3 .. 1e3", any_eight, normal_dual_error, 8, WIDE_CHECKED},
    {NORMALIZE, "dual, 2^-30 .. 2^30 mixed", scattered_eight, normal_dual_error, 8, WIDE_CHECKED},
    {NORMALIZE, "dual, 2^100 .. 2^126", huge_eight, normal_dual_error, 8, WIDE_CHECKED},
    {NORMALIZE, "dual, 2^-149 .. 2^-100", tiny_eight, normal_dual_error, 8, WIDE_CHECKED},
    {POINT, "any", any_point, point_error, 11, WIDE_CHECKED},
    {POINT, "near half turns", half_turned_point, point_error, 11, WIDE_CHECKED},
    {POINT, "two blended", blended_point, point_error, 11, WIDE_CHECKED},
    {POINT, "result near the origin", lost_point, point_error, 11, WIDE_CHECKED},
    {POINT, "the origin, from a rotation and a translation", any_dual, translation_error, 8, WIDE_CHECKED},
    {POINT, "the origin, near half turns", half_turned_dual, translation_error, 8, WIDE_CHECKED},
    {POINT, "the origin, two blended", blended_dual, translation_error, 8, WIDE_CHECKED},
    {POINT, "the origin, round trip", rigid, there_and_back_error, 8, WIDE_NOTED},
};

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("dual.h", argc, argv);
    wide_search(&a, cases, sizeof cases / sizeof cases[0], SAMPLES);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
