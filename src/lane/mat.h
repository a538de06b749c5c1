/* SPDX-License-Identifier: MIT */
/* Floor 2: the formulas of mat.h beyond the small algebra. All in binary64. */
#ifndef NAKAWARI_LANE_MAT_H
#define NAKAWARI_LANE_MAT_H

#include "strict.h"

#include <nakawari/mat.h>
#include <nakawari/transform.h>

#include "quat.h"
#include "two.h"

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

/* The same where the last row of both is 0 0 0 1. */
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

static inline nkw_mat4 lane_mat4_from_trs(const nkw_trs *trs)
{
    nkw_mat3 m = nkw_mat3_from_quat_scale(trs->rotation, trs->scale);
    return nkw_mat4_from_mat3(&m, trs->translation);
}

static inline lane_wmat3 lane_wmat3_from(const nkw_mat3 *m)
{
    lane_wmat3 r;
    for (size_t i = 0; i < 9; i++)
        r.m[i] = m->m[i];
    return r;
}

/* The 3x3 block of an affine matrix. */
static inline lane_wmat3 lane_wmat3_from_mat4(const nkw_mat4 *m)
{
    const float *a = m->m;
    lane_wmat3 r = {{a[0], a[1], a[2], a[4], a[5], a[6], a[8], a[9], a[10]}};
    return r;
}

/* The scale 0, of a matrix without an inverse, gives 0 whatever the elements are. */
static inline nkw_mat3 lane_mat3_from_wide(const lane_wmat3 *m, double scale)
{
    nkw_mat3 r;
    for (size_t i = 0; i < 9; i++)
        r.m[i] = scale == 0.0 ? 0.0f : (float)(m->m[i] * scale);
    return r;
}

static inline lane_wvec3 lane_wmat3_column(const lane_wmat3 *m, size_t c)
{
    lane_wvec3 r = {m->m[c * 3], m->m[c * 3 + 1], m->m[c * 3 + 2]};
    return r;
}

static inline lane_wmat3 lane_wmat3_from_columns(lane_wvec3 x, lane_wvec3 y, lane_wvec3 z)
{
    lane_wmat3 r = {{x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z}};
    return r;
}

static inline lane_wmat3 lane_wmat3_transpose(const lane_wmat3 *a)
{
    const double *m = a->m;
    lane_wmat3 r = {{m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]}};
    return r;
}

/* The columns y x z, z x x, x x y: det(M) times the inverse transpose, also where det(M) is 0. */
static inline lane_wmat3 lane_wmat3_cofactors(const lane_wmat3 *m)
{
    lane_wvec3 x = lane_wmat3_column(m, 0), y = lane_wmat3_column(m, 1), z = lane_wmat3_column(m, 2);
    return lane_wmat3_from_columns(lane_wvec3_cross(y, z), lane_wvec3_cross(z, x), lane_wvec3_cross(x, y));
}

static inline double lane_wmat3_determinant(const lane_wmat3 *m, const lane_wmat3 *cofactors)
{
    return lane_wvec3_dot(lane_wmat3_column(m, 0), lane_wmat3_column(cofactors, 0));
}

/* 1 / det, and 0 for a determinant that has no finite inverse. */
static inline double lane_reciprocal_or_zero(double det)
{
    double r = 1.0 / det;
    return det != 0.0 && r - r == 0.0 ? r : 0.0;
}

static inline double lane_wmat3_largest(const lane_wmat3 *m)
{
    double largest = 0.0;
    for (size_t i = 0; i < 9; i++) {
        double a = lane_abs64(m->m[i]);
        largest = a > largest ? a : largest;
    }
    return largest;
}

/* The inverse transpose; the cofactors over the largest of them where m is singular. */
static inline nkw_mat3 lane_mat3_normal(const nkw_mat3 *m)
{
    lane_wmat3 w = lane_wmat3_from(m);
    lane_wmat3 c = lane_wmat3_cofactors(&w);
    double det = lane_wmat3_determinant(&w, &c), inverse = lane_reciprocal_or_zero(det);
    double singular = lane_reciprocal_or_zero(lane_wmat3_largest(&c));
    return lane_mat3_from_wide(&c, det == 0.0 ? singular : inverse);
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

/* A determinant by two lines and two lines (Laplace), and the magnitudes of its terms: how much there was to cancel. */
typedef struct lane_laplace {
    double determinant, magnitude;
} lane_laplace;

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
#if defined(LANE_TWO)
typedef struct lane_minor_pairs {
    lane_two near, far, across; /* 01 23, 02 13, 03 12 */
} lane_minor_pairs;

/* p and q are 0 1 and 2 3 of a column each. */
static inline lane_minor_pairs lane_minor_pairs_of(const lane_two p[2], const lane_two q[2])
{
    lane_minor_pairs r = {
        LANE_TWO_MIX(p[0], p[1], 0, 2) * LANE_TWO_MIX(q[0], q[1], 1, 3) -
            LANE_TWO_MIX(p[0], p[1], 1, 3) * LANE_TWO_MIX(q[0], q[1], 0, 2),
        p[0] * q[1] - p[1] * q[0],
        p[0] * lane_two_swap(q[1]) - lane_two_swap(p[1]) * q[0],
    };
    return r;
}

/* lane_minors_determinant. */
static inline lane_laplace lane_minor_pairs_determinant(const lane_minor_pairs *s, const lane_minor_pairs *c)
{
    lane_two ab = s->near * lane_two_swap(c->near), de = s->far * lane_two_swap(c->far);
    lane_two fg = s->across * lane_two_swap(c->across);
    lane_two sums = LANE_TWO_MIX(ab, de, 0, 2) + LANE_TWO_MIX(ab, de, 1, 3);
    ab = lane_two_abs(ab);
    de = lane_two_abs(de);
    lane_two sizes = LANE_TWO_MIX(ab, de, 0, 2) + LANE_TWO_MIX(ab, de, 1, 3);
    lane_two size = lane_two_abs(fg);
    lane_laplace r = {(sums[0] - sums[1]) + (fg[0] + fg[1]), (sizes[0] + sizes[1]) + (size[0] + size[1])};
    return r;
}

/* The rows of p and of q, side by side. */
static inline void lane_adjugate_rows(const lane_two p[2], const lane_two q[2], const lane_minor_pairs *c, double *out)
{
    const lane_two_bits even = {0, INT64_MIN}, odd = {INT64_MIN, 0};
    lane_two x0 = LANE_TWO_MIX(p[0], q[0], 0, 2), x1 = LANE_TWO_MIX(p[0], q[0], 1, 3);
    lane_two x2 = LANE_TWO_MIX(p[1], q[1], 0, 2), x3 = LANE_TWO_MIX(p[1], q[1], 1, 3);
    double c01 = c->near[0], c23 = c->near[1], c02 = c->far[0], c13 = c->far[1], c03 = c->across[0], c12 = c->across[1];
    lane_two r[4] = {
        (x1 * c23 - x2 * c13) + x3 * c12,
        (x0 * c23 - x2 * c03) + x3 * c02,
        (x0 * c13 - x1 * c03) + x3 * c01,
        (x0 * c12 - x1 * c02) + x2 * c01,
    };
    for (size_t i = 0; i < 4; i++) {
        r[i] = (lane_two)((lane_two_bits)r[i] ^ (i % 2 == 0 ? even : odd));
        memcpy(out + 4 * i, &r[i], sizeof r[i]);
    }
}

static inline lane_laplace lane_adjugate(const double a[16], double out[16])
{
    lane_two p[8];
    memcpy(p, a, sizeof p);
    lane_minor_pairs s = lane_minor_pairs_of(p, p + 2), c = lane_minor_pairs_of(p + 4, p + 6);
    lane_adjugate_rows(p + 2, p, &c, out);
    lane_adjugate_rows(p + 6, p + 4, &s, out + 2);
    return lane_minor_pairs_determinant(&s, &c);
}
#else
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
#endif

/*
 * The columns of the adjugate of x y z, and -adjugate t; the fourth row is 0 0 0 1 after the division by det, which
 * gives its sign to these zeros as well.
 */
static inline void lane_adjugate_affine(lane_wvec3 x, lane_wvec3 y, lane_wvec3 z, lane_wvec3 t, double det,
                                        double out[16])
{
    lane_wvec3 w = lane_wvec3_cross(x, y);
    double none = 0.0 * det;
#if defined(LANE_TWO)
    lane_two ax = lane_two_of(y.x, z.x), ay = lane_two_of(y.y, z.y), az = lane_two_of(y.z, z.z);
    lane_two bx = lane_two_of(z.x, x.x), by = lane_two_of(z.y, x.y), bz = lane_two_of(z.z, x.z);
    lane_two ux = ay * bz - az * by, uy = az * bx - ax * bz, uz = ax * by - ay * bx;
    const lane_two columns[8] = {
        ux, lane_two_of(w.x, none), uy, lane_two_of(w.y, none), uz, lane_two_of(w.z, none),
        -((ux * t.x + uy * t.y) + uz * t.z), lane_two_of(-lane_wvec3_dot(w, t), det),
    };
#else
    lane_wvec3 u = lane_wvec3_cross(y, z), v = lane_wvec3_cross(z, x);
    const double columns[16] = {
        u.x, v.x, w.x, none, u.y, v.y, w.y, none, u.z, v.z, w.z, none,
        -lane_wvec3_dot(u, t), -lane_wvec3_dot(v, t), -lane_wvec3_dot(w, t), det,
    };
#endif
    memcpy(out, columns, sizeof columns);
}

#endif
