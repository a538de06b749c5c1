/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/mat.h>

#include "lane/mat.h"
#include "pack/affine.h"

#if !NKW_F32X4
nkw_mat4 nkw_mat4_mul(const nkw_mat4 *a, const nkw_mat4 *b)
{
    return lane_mat4_mul(a, b);
}

nkw_mat4 nkw_mat4_mul_affine(const nkw_mat4 *a, const nkw_mat4 *b)
{
    return lane_mat4_mul_affine(a, b);
}
#endif

float nkw_mat3_determinant(const nkw_mat3 *m)
{
    lane_f64_mat3 w = lane_f64_mat3_from(m);
    lane_f64_mat3 c = lane_f64_mat3_cofactors(&w);
    return (float)lane_f64_mat3_determinant(&w, &c);
}

nkw_mat3 nkw_mat3_inverse(const nkw_mat3 *m)
{
    lane_f64_mat3 w = lane_f64_mat3_from(m);
    lane_f64_mat3 c = lane_f64_mat3_cofactors(&w);
    lane_laplace by = lane_f64_mat3_laplace(&w, &c);
    double r = lane_is_singular(by) ? 0.0 : lane_reciprocal_or_zero(by.determinant);
    lane_f64_mat3 adjugate = lane_f64_mat3_transpose(&c);
    return lane_mat3_from_f64(&adjugate, r);
}

nkw_mat3 nkw_mat3_normal(const nkw_mat3 *m)
{
    return lane_mat3_normal(m);
}

/* The square of the angle, in rad, below which a column counts as dependent on those before it. */
#define DEPENDENT 0x1p-60

static lane_f64_vec3 direction_or(lane_f64_vec3 remainder, lane_f64_vec3 whole, lane_f64_vec3 otherwise)
{
    int lost = lane_f64_vec3_dot(remainder, remainder) <= DEPENDENT * lane_f64_vec3_dot(whole, whole);
    return lane_f64_vec3_normalize(lane_f64_vec3_select(lost, otherwise, remainder));
}

nkw_mat3 nkw_mat3_orthonormalize(const nkw_mat3 *m)
{
    lane_f64_mat3 w = lane_f64_mat3_from(m);
    lane_f64_vec3 a = lane_f64_mat3_column(&w, 0), b = lane_f64_mat3_column(&w, 1), c = lane_f64_mat3_column(&w, 2);
    lane_f64_vec3 across = lane_f64_vec3_cross(b, c);
    lane_f64_vec3 x = direction_or(a, a, direction_or(across, across, lane_f64_vec3_perpendicular(b)));
    lane_f64_vec3 remainder = lane_f64_vec3_sub(b, lane_f64_vec3_scale(x, lane_f64_vec3_dot(b, x)));
    lane_f64_vec3 y =
        direction_or(remainder, b, direction_or(lane_f64_vec3_cross(c, x), c, lane_f64_vec3_perpendicular(x)));
    lane_f64_vec3 z = lane_f64_vec3_cross(x, y);
    double along = lane_f64_vec3_dot(z, c);
    int mirrors = along < 0.0 && along * along > DEPENDENT * lane_f64_vec3_dot(c, c);
    double side = mirrors ? -1.0 : along == along ? 1.0 : along;
    lane_f64_mat3 r = lane_f64_mat3_from_columns(x, y, lane_f64_vec3_scale(z, side));
    return lane_mat3_from_f64(&r, 1.0);
}

nkw_vec3 nkw_mat4_project_point(const nkw_mat4 *m, nkw_vec3 p)
{
    const float *a = m->m;
    float w = (a[3] * p.x + a[7] * p.y) + (a[11] * p.z + a[15]);
    nkw_vec3 r = nkw_mat4_transform_point(m, p);
    r.x /= w;
    r.y /= w;
    r.z /= w;
    return r;
}

static void widen(const nkw_mat4 *m, double a[16])
{
    for (size_t i = 0; i < 16; i++)
        a[i] = m->m[i];
}

float nkw_mat4_determinant(const nkw_mat4 *m)
{
    double a[16];
    widen(m, a);
    lane_minors s = lane_minors_of(a, a + 4), c = lane_minors_of(a + 8, a + 12);
    return (float)lane_minors_determinant(&s, &c).determinant;
}

/* Swaps line k of a | b with the line below it whose element k is largest. */
static void pivot(double a[4][8], size_t k)
{
    size_t best = k;
    for (size_t i = k + 1; i < 4; i++)
        best = lane_abs64(a[i][k]) > lane_abs64(a[best][k]) ? i : best;
    for (size_t j = 0; j < 8; j++) {
        double t = a[k][j];
        a[k][j] = a[best][j];
        a[best][j] = t;
    }
}

/*
 * Gauss-Jordan elimination with partial pivoting, where cofactors would cancel too much. Lines are the
 * matrix's columns, which inverts the transpose into the transposed inverse. Returns 0 for a singular matrix.
 */
static int eliminate(const double m[16], double out[16])
{
    double a[4][8] = {{0}};
    for (size_t i = 0; i < 4; i++) {
        for (size_t j = 0; j < 4; j++)
            a[i][j] = m[i * 4 + j];
        a[i][4 + i] = 1.0;
    }
    for (size_t k = 0; k < 4; k++) {
        pivot(a, k);
        double r = lane_reciprocal_or_zero(a[k][k]);
        if (r == 0.0)
            return 0;
        for (size_t j = 0; j < 8; j++)
            a[k][j] *= r;
        for (size_t i = 0; i < 4; i++) {
            double f = i == k ? 0.0 : a[i][k];
            for (size_t j = 0; j < 8; j++)
                a[i][j] -= f * a[k][j];
        }
    }
    for (size_t i = 0; i < 16; i++)
        out[i] = a[i / 4][4 + i % 4];
    return 1;
}

/* Cofactors lose log2(magnitude / |det|) bits, of 29 to spare. */
LANE_SELDOM static nkw_mat4 inverse_of_cancelling(const nkw_mat4 *m, lane_laplace by)
{
    nkw_mat4 result = {{0.0f}};
    double a[16], inverse[16];
    widen(m, a);
    if (lane_is_singular(by) || !eliminate(a, inverse))
        return result;
    for (size_t i = 0; i < 16; i++)
        result.m[i] = (float)inverse[i];
    return result;
}

LANE_FLAT nkw_mat4 nkw_mat4_inverse(const nkw_mat4 *m)
{
    double a[16], inverse[16];
    widen(m, a);
    lane_laplace by = lane_adjugate(a, inverse);
    if (!(lane_abs64(by.determinant) > by.magnitude * 0x1p-12))
        return inverse_of_cancelling(m, by);
    double r = 1.0 / by.determinant;
    nkw_mat4 result;
    for (size_t i = 0; i < 16; i++)
        result.m[i] = (float)(inverse[i] * r);
    return result;
}

LANE_SELDOM static nkw_mat4 inverse_of_any_affine(const nkw_mat4 *m)
{
    return lane_inverse_any_affine(m);
}

LANE_FLAT nkw_mat4 nkw_mat4_inverse_affine(const nkw_mat4 *m)
{
#if NKW_F32X4
    affine inverse;
    int is_near = affine_inverse(m, &inverse);
#else
    const float *a = m->m;
    nkw_vec3 x = {a[0], a[1], a[2]}, y = {a[4], a[5], a[6]}, z = {a[8], a[9], a[10]};
    lane_affine_inverse i = lane_inverse_affine(x, y, z, nkw_mat4_translation(m));
    nkw_mat3 block = nkw_mat3_from_columns(i.x, i.y, i.z);
    affine inverse = nkw_mat4_from_mat3(&block, i.t);
    int is_near = i.is_near;
#endif
    nkw_mat4 r;
    if (!is_near)
        return inverse_of_any_affine(m);
    affine_store(&inverse, &r);
    return r;
}

nkw_mat4 nkw_mat4_from_row_major(const float rows[16])
{
    nkw_mat4 r;
    for (size_t c = 0; c < 4; c++)
        for (size_t i = 0; i < 4; i++)
            r.m[c * 4 + i] = rows[i * 4 + c];
    return r;
}

void nkw_mat4_to_row_major(const nkw_mat4 *m, float rows[16])
{
    nkw_mat4 t = nkw_mat4_transpose(m);
    for (size_t i = 0; i < 16; i++)
        rows[i] = t.m[i];
}

nkw_mat3x4 nkw_mat3x4_from_mat4(const nkw_mat4 *m)
{
    return lane_mat3x4_from_mat4(m);
}

nkw_mat4 nkw_mat4_from_mat3x4(const nkw_mat3x4 *m)
{
    const float *a = m->m;
    nkw_mat4 r = {{a[0], a[4], a[8], 0.0f, a[1], a[5], a[9], 0.0f, a[2], a[6], a[10], 0.0f, a[3], a[7], a[11], 1.0f}};
    return r;
}
