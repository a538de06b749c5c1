/* SPDX-License-Identifier: MIT */
/* The formulas of mat.h and transform.h beyond the small algebra. */
#ifndef NAKAWARI_LANE_MAT_H
#define NAKAWARI_LANE_MAT_H

#include "strict.h"

#include <nakawari/mat.h>
#include <nakawari/transform.h>

#include "quat.h"
#include "scalar.h"

/* The sums in the order of nkw_mat4_mul. */
static inline nkw_mat4 lane_mat4_mul(const nkw_mat4 *a, const nkw_mat4 *b)
{
    const float *x = a->m, *y = x + 4, *z = x + 8, *t = x + 12;
    nkw_mat4 r;
    for (size_t c = 0; c < 16; c += 4) {
        const float *k = b->m + c;
        for (size_t i = 0; i < 4; i++)
            r.m[c + i] = (x[i] * k[0] + y[i] * k[1]) + (z[i] * k[2] + t[i] * k[3]);
    }
    return r;
}

/* Computes the same product where the last row of both is 0 0 0 1. */
static inline nkw_mat4 lane_mat4_mul_affine(const nkw_mat4 *a, const nkw_mat4 *b)
{
    const float *x = a->m, *y = x + 4, *z = x + 8, *t = x + 12;
    nkw_mat4 r;
    for (size_t c = 0; c < 16; c += 4) {
        const float *k = b->m + c;
        for (size_t i = 0; i < 3; i++)
            r.m[c + i] = (x[i] * k[0] + y[i] * k[1]) + (c < 12 ? z[i] * k[2] : z[i] * k[2] + t[i]);
        r.m[c + 3] = c < 12 ? 0.0f : 1.0f;
    }
    return r;
}

/* Rows of four from columns of four. */
static inline nkw_mat3x4 lane_mat3x4_from_mat4(const nkw_mat4 *m)
{
    nkw_mat3x4 r;
    for (size_t k = 0; k < 12; k++)
        r.m[k] = m->m[k % 4 * 4 + k / 4];
    return r;
}

static inline nkw_mat4 lane_mat4_from_trs(const nkw_trs *trs)
{
    nkw_mat3 m = nkw_mat3_from_quat_scale(trs->rotation, trs->scale);
    return nkw_mat4_from_mat3(&m, trs->translation);
}

static inline lane_f64_mat3 lane_f64_mat3_from(const nkw_mat3 *m)
{
    lane_f64_mat3 r;
    for (size_t i = 0; i < 9; i++)
        r.m[i] = m->m[i];
    return r;
}

/* The 3x3 block of an affine matrix. */
static inline lane_f64_mat3 lane_f64_mat3_from_mat4(const nkw_mat4 *m)
{
    const float *a = m->m;
    lane_f64_mat3 r = {{a[0], a[1], a[2], a[4], a[5], a[6], a[8], a[9], a[10]}};
    return r;
}

/* The sums of nkw_mat3_from_quat: |q|^2 times a rotation. */
static inline lane_f64_mat3 lane_f64_mat3_from_quat(nkw_quat q)
{
    double x = (double)q.x, y = (double)q.y, z = (double)q.z, w = (double)q.w;
    lane_f64_mat3 r = {{
        (w * w - y * y) + (x * x - z * z),
        2.0 * (x * y + w * z),
        2.0 * (x * z - w * y),
        2.0 * (x * y - w * z),
        (w * w - z * z) + (y * y - x * x),
        2.0 * (y * z + w * x),
        2.0 * (x * z + w * y),
        2.0 * (y * z - w * x),
        (w * w - x * x) + (z * z - y * y),
    }};
    return r;
}

/* An affine matrix: the columns x y z and the position, three numbers each. */
typedef struct lane_f64_affine {
    double m[12];
} lane_f64_affine;

static inline lane_f64_vec3 lane_f64_affine_column(const lane_f64_affine *a, size_t c)
{
    lane_f64_vec3 r = {a->m[c * 3], a->m[c * 3 + 1], a->m[c * 3 + 2]};
    return r;
}

static inline lane_f64_affine lane_f64_affine_from_trs(const nkw_trs *trs)
{
    const double scale[3] = {(double)trs->scale.x, (double)trs->scale.y, (double)trs->scale.z};
    lane_f64_mat3 rotation = lane_f64_mat3_from_quat(trs->rotation);
    lane_f64_affine r;
    for (size_t i = 0; i < 9; i++)
        r.m[i] = rotation.m[i] * scale[i / 3];
    r.m[9] = (double)trs->translation.x;
    r.m[10] = (double)trs->translation.y;
    r.m[11] = (double)trs->translation.z;
    return r;
}

/* The position of b is a point, its columns are directions. */
static inline lane_f64_affine lane_f64_affine_mul(const lane_f64_affine *a, const lane_f64_affine *b)
{
    const double *x = a->m, *y = x + 3, *z = x + 6, *t = x + 9;
    lane_f64_affine r;
    for (size_t c = 0; c < 12; c += 3) {
        const double *k = b->m + c;
        for (size_t i = 0; i < 3; i++) {
            double sum = (x[i] * k[0] + y[i] * k[1]) + z[i] * k[2];
            r.m[c + i] = c < 9 ? sum : sum + t[i];
        }
    }
    return r;
}

/* The scale 0, for a matrix without an inverse, returns 0 for any elements. */
static inline nkw_mat3 lane_mat3_from_f64(const lane_f64_mat3 *m, double scale)
{
    nkw_mat3 r;
    for (size_t i = 0; i < 9; i++)
        r.m[i] = scale == 0.0 ? 0.0f : (float)(m->m[i] * scale);
    return r;
}

static inline lane_f64_vec3 lane_f64_mat3_column(const lane_f64_mat3 *m, size_t c)
{
    lane_f64_vec3 r = {m->m[c * 3], m->m[c * 3 + 1], m->m[c * 3 + 2]};
    return r;
}

static inline lane_f64_mat3 lane_f64_mat3_from_columns(lane_f64_vec3 x, lane_f64_vec3 y, lane_f64_vec3 z)
{
    lane_f64_mat3 r = {{x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z}};
    return r;
}

static inline lane_f64_mat3 lane_f64_mat3_transpose(const lane_f64_mat3 *a)
{
    const double *m = a->m;
    lane_f64_mat3 r = {{m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]}};
    return r;
}

/* The columns y x z, z x x, x x y: det(M) times the inverse transpose, also where det(M) is 0. */
static inline lane_f64_mat3 lane_f64_mat3_cofactors(const lane_f64_mat3 *m)
{
    lane_f64_vec3 x = lane_f64_mat3_column(m, 0), y = lane_f64_mat3_column(m, 1), z = lane_f64_mat3_column(m, 2);
    return lane_f64_mat3_from_columns(lane_f64_vec3_cross(y, z), lane_f64_vec3_cross(z, x), lane_f64_vec3_cross(x, y));
}

static inline double lane_f64_mat3_determinant(const lane_f64_mat3 *m, const lane_f64_mat3 *cofactors)
{
    return lane_f64_vec3_dot(lane_f64_mat3_column(m, 0), lane_f64_mat3_column(cofactors, 0));
}

/*
 * A determinant by the expansion of Laplace, and the sum of the magnitudes of its terms: how much there was to cancel.
 * Its minors have one rounding each, so its error is at most 2^-51 of the magnitude.
 */
typedef struct lane_laplace {
    double determinant, magnitude;
} lane_laplace;

static inline lane_laplace lane_f64_mat3_laplace(const lane_f64_mat3 *m, const lane_f64_mat3 *cofactors)
{
    const double *a = m->m, *c = cofactors->m;
    lane_laplace r = {
        lane_f64_mat3_determinant(m, cofactors),
        (lane_abs64(a[0] * c[0]) + lane_abs64(a[1] * c[1])) + lane_abs64(a[2] * c[2]),
    };
    return r;
}

/* Whether a determinant of floats is 0, may be 0 within its error, or is NaN or infinite. */
static inline int lane_is_singular(lane_laplace by)
{
    return !(lane_abs64(by.determinant) > by.magnitude * 0x1p-50);
}

/*
 * The volume of the box of three unit vectors from which on they count as independent. The rounding of a product of
 * matrices moves the volume of columns that are dependent to 2^-22 or so, on either side of 0.
 */
#define LANE_LEAST_VOLUME 0x1p-20

/*
 * Whether the columns of a block that was rounded to floats may be dependent, |det| <= 2^-20 |x| |y| |z|: the sign of
 * its determinant then depends on roundings. 0 for NaN.
 */
static inline int lane_is_flat(const lane_f64_mat3 *m, double det)
{
    lane_f64_vec3 x = lane_f64_mat3_column(m, 0), y = lane_f64_mat3_column(m, 1), z = lane_f64_mat3_column(m, 2);
    double n2 = (lane_f64_vec3_dot(x, x) * lane_f64_vec3_dot(y, y)) * lane_f64_vec3_dot(z, z);
    return det * det <= (LANE_LEAST_VOLUME * LANE_LEAST_VOLUME) * n2;
}

/* 1 / det, and 0 for a determinant that has no finite inverse. */
static inline double lane_reciprocal_or_zero(double det)
{
    double r = 1.0 / lane_divisor64(det);
    return det != 0.0 && lane_abs64(r) < (double)INFINITY ? r : 0.0;
}

static inline double lane_f64_mat3_largest(const lane_f64_mat3 *m)
{
    double largest = 0.0;
    for (size_t i = 0; i < 9; i++) {
        double a = lane_abs64(m->m[i]);
        largest = a > largest ? a : largest;
    }
    return largest;
}

/* The inverse transpose; the cofactors over the largest of them where m is flat. */
static inline nkw_mat3 lane_mat3_normal(const nkw_mat3 *m)
{
    lane_f64_mat3 w = lane_f64_mat3_from(m);
    lane_f64_mat3 c = lane_f64_mat3_cofactors(&w);
    double det = lane_f64_mat3_determinant(&w, &c), inverse = lane_reciprocal_or_zero(det);
    double flat = lane_reciprocal_or_zero(lane_f64_mat3_largest(&c));
    return lane_mat3_from_f64(&c, lane_is_flat(&w, det) ? flat : inverse);
}

/*
 * Rotation and scale of a block of three columns. `is_near` is 0 where the result is not to be used: a length is not in
 * 2^-30 .. 2^30, or the columns are so far from orthogonal that LANE_NEAREST_STEPS do not reach the nearest rotation.
 */
typedef struct lane_scaled_rotation {
    nkw_quat rotation;
    nkw_vec3 scale;
    int is_near;
} lane_scaled_rotation;

#define LANE_LEAST_SQUARE 0x1p-60f
#define LANE_MOST_SQUARE  0x1p60f
/* The sum of the squares of the three cosines between the columns. */
#define LANE_LITTLE_SHEAR 0x1p-20f

static inline int lane_is_moderate_square(float n2)
{
    return n2 > LANE_LEAST_SQUARE && n2 < LANE_MOST_SQUARE;
}

static inline lane_scaled_rotation lane_scaled_rotation_of(nkw_vec3 x, nkw_vec3 y, nkw_vec3 z)
{
    float xx = nkw_vec3_dot(x, x), yy = nkw_vec3_dot(y, y), zz = nkw_vec3_dot(z, z);
    nkw_vec3 c = nkw_vec3_cross(x, y), scale = {sqrtf(xx), sqrtf(yy), sqrtf(zz)};
    float rx = 1.0f / lane_divisor(scale.x), ry = 1.0f / lane_divisor(scale.y), rz = 1.0f / lane_divisor(scale.z);
    int mirrors = nkw_vec3_dot(c, z) < 0.0f; /* where is_near, whatever the rounding of c */
    scale.x = mirrors ? -scale.x : scale.x;
    nkw_vec3 u = nkw_vec3_scale(x, mirrors ? -rx : rx), v = nkw_vec3_scale(y, ry), n = nkw_vec3_scale(z, rz);
    float uv = nkw_vec3_dot(x, y) * (rx * ry), vn = nkw_vec3_dot(y, z) * (ry * rz), nu = nkw_vec3_dot(z, x) * (rz * rx);
    int is_near = lane_is_moderate_square(xx) && lane_is_moderate_square(yy) && lane_is_moderate_square(zz) &&
                  (uv * uv + vn * vn) + nu * nu < LANE_LITTLE_SHEAR;
    lane_scaled_rotation r = {lane_quat_from_columns(u, v, n).q, scale, is_near};
    return r;
}

/* Six 2x2 minors of two lines of four, each with one rounding: the products of floats are exact. */
typedef struct lane_minors {
    double m01, m02, m03, m12, m13, m23;
} lane_minors;

static inline lane_minors lane_minors_of(const double *p, const double *q)
{
    lane_minors r = {
        p[0] * q[1] - p[1] * q[0], p[0] * q[2] - p[2] * q[0], p[0] * q[3] - p[3] * q[0],
        p[1] * q[2] - p[2] * q[1], p[1] * q[3] - p[3] * q[1], p[2] * q[3] - p[3] * q[2],
    };
    return r;
}

static inline lane_laplace lane_minors_determinant(const lane_minors *s, const lane_minors *c)
{
    double a = s->m01 * c->m23, b = s->m23 * c->m01, d = s->m02 * c->m13;
    double e = s->m13 * c->m02, f = s->m03 * c->m12, g = s->m12 * c->m03;
    lane_laplace r = {
        ((a + b) - (d + e)) + (f + g),
        ((lane_abs64(a) + lane_abs64(b)) + (lane_abs64(d) + lane_abs64(e))) + (lane_abs64(f) + lane_abs64(g)),
    };
    return r;
}

/*
 * The adjugate of the matrix with the columns a: two of its rows from each pair of columns against the minors of the
 * other pair. By its columns, as a is.
 */
static inline void lane_adjugate_row(const double *x, const lane_minors *c, double sign, double *out)
{
    out[0] = sign * ((x[1] * c->m23 - x[2] * c->m13) + x[3] * c->m12);
    out[4] = -sign * ((x[0] * c->m23 - x[2] * c->m03) + x[3] * c->m02);
    out[8] = sign * ((x[0] * c->m13 - x[1] * c->m03) + x[3] * c->m01);
    out[12] = -sign * ((x[0] * c->m12 - x[1] * c->m02) + x[2] * c->m01);
}

static inline lane_laplace lane_adjugate(const double a[16], double out[16])
{
    lane_minors s = lane_minors_of(a, a + 4), c = lane_minors_of(a + 8, a + 12);
    lane_adjugate_row(a + 4, &c, 1.0, out);
    lane_adjugate_row(a, &c, -1.0, out + 1);
    lane_adjugate_row(a + 12, &s, 1.0, out + 2);
    lane_adjugate_row(a + 8, &s, -1.0, out + 3);
    return lane_minors_determinant(&s, &c);
}

/*
 * The inverse of an affine matrix with the columns x y z t: rows y x z, z x x, x x y over the determinant. `is_near` is
 * 0 where the result is not to be used: the product of the lengths of x y z is not within 2^-30 .. 2^30, so that a
 * float could overflow, or the determinant is less than half of it, so that it has lost digits.
 */
typedef struct lane_affine_inverse {
    nkw_vec3 x, y, z, t; /* columns */
    int is_near;
} lane_affine_inverse;

static inline int lane_is_near_affine(float xx, float yy, float zz, float det)
{
    float n2 = (xx * yy) * zz;
    return (n2 > 0x1p-60f) & (n2 < 0x1p60f) & (det * det > 0.25f * n2);
}

static inline lane_affine_inverse lane_inverse_affine(nkw_vec3 x, nkw_vec3 y, nkw_vec3 z, nkw_vec3 t)
{
    nkw_vec3 u = nkw_vec3_cross(y, z), v = nkw_vec3_cross(z, x), w = nkw_vec3_cross(x, y);
    float det = nkw_vec3_dot(x, u), r = 1.0f / lane_divisor(det);
    u = nkw_vec3_scale(u, r), v = nkw_vec3_scale(v, r), w = nkw_vec3_scale(w, r);
    lane_affine_inverse i = {
        {u.x, v.x, w.x},
        {u.y, v.y, w.y},
        {u.z, v.z, w.z},
        {-nkw_vec3_dot(u, t), -nkw_vec3_dot(v, t), -nkw_vec3_dot(w, t)},
        lane_is_near_affine(nkw_vec3_dot(x, x), nkw_vec3_dot(y, y), nkw_vec3_dot(z, z), det),
    };
    return i;
}

/* The same in binary64: by the cofactors c of the block and the reciprocal r of its determinant, 0 for no inverse. */
static inline nkw_mat4 lane_inverse_by_cofactors(const nkw_mat4 *m, const lane_f64_mat3 *c, double r)
{
    lane_f64_vec3 t = {m->m[12], m->m[13], m->m[14]};
    nkw_mat4 out = {{0.0f}};
    if (r == 0.0)
        return out;
    for (size_t i = 0; i < 3; i++) {
        lane_f64_vec3 row = lane_f64_mat3_column(c, i);
        out.m[i] = (float)(row.x * r);
        out.m[4 + i] = (float)(row.y * r);
        out.m[8 + i] = (float)(row.z * r);
        out.m[12 + i] = (float)(-lane_f64_vec3_dot(row, t) * r);
    }
    out.m[15] = 1.0f;
    return out;
}

/* Returns the inverse of any affine matrix; zeros where it is singular. */
static inline nkw_mat4 lane_inverse_any_affine(const nkw_mat4 *m)
{
    lane_f64_mat3 block = lane_f64_mat3_from_mat4(m), c = lane_f64_mat3_cofactors(&block);
    lane_laplace by = lane_f64_mat3_laplace(&block, &c);
    return lane_inverse_by_cofactors(m, &c, lane_is_singular(by) ? 0.0 : lane_reciprocal_or_zero(by.determinant));
}

/* Returns the inverse of a product of matrices that was rounded to floats; zeros where it is flat. */
static inline nkw_mat4 lane_inverse_any_model(const nkw_mat4 *m)
{
    lane_f64_mat3 block = lane_f64_mat3_from_mat4(m), c = lane_f64_mat3_cofactors(&block);
    double det = lane_f64_mat3_determinant(&block, &c);
    return lane_inverse_by_cofactors(m, &c, lane_is_flat(&block, det) ? 0.0 : lane_reciprocal_or_zero(det));
}

#endif
