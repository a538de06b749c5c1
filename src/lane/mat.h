/* SPDX-License-Identifier: MIT */
/* Floor 2: the formulas of mat.h beyond the small algebra. All in binary64. */
#ifndef NAKAWARI_LANE_MAT_H
#define NAKAWARI_LANE_MAT_H

#include "strict.h"

#include <nakawari/mat.h>

#include "quat.h"

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
        double a = m->m[i] < 0.0 ? -m->m[i] : m->m[i];
        largest = a > largest ? a : largest;
    }
    return largest;
}

/* The inverse transpose; the cofactors over the largest of them where m is singular. */
static inline nkw_mat3 lane_mat3_normal(const nkw_mat3 *m)
{
    lane_wmat3 w = lane_wmat3_from(m);
    lane_wmat3 c = lane_wmat3_cofactors(&w);
    double inverse = lane_reciprocal_or_zero(lane_wmat3_determinant(&w, &c));
    double singular = lane_reciprocal_or_zero(lane_wmat3_largest(&c));
    return lane_mat3_from_wide(&c, inverse == 0.0 ? singular : inverse);
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

/* Laplace expansion by two lines and two lines. */
static inline double lane_minors_determinant(const lane_minors *s, const lane_minors *c)
{
    return ((s->m01 * c->m23 + s->m23 * c->m01) - (s->m02 * c->m13 + s->m13 * c->m02)) +
           (s->m03 * c->m12 + s->m12 * c->m03);
}

/* The sum of the magnitudes in that expansion: how much there was to cancel. */
static inline double lane_minors_magnitude(const lane_minors *s, const lane_minors *c)
{
    double a = s->m01 * c->m23, b = s->m23 * c->m01, d = s->m02 * c->m13;
    double e = s->m13 * c->m02, f = s->m03 * c->m12, g = s->m12 * c->m03;
    return (((a < 0.0 ? -a : a) + (b < 0.0 ? -b : b)) + ((d < 0.0 ? -d : d) + (e < 0.0 ? -e : e))) +
           ((f < 0.0 ? -f : f) + (g < 0.0 ? -g : g));
}

/* One line of the adjugate: the line x of four against the minors of two other lines. */
static inline void lane_adjugate_line(const double *x, const lane_minors *c, double sign, double out[4])
{
    out[0] = sign * ((x[1] * c->m23 - x[2] * c->m13) + x[3] * c->m12);
    out[1] = -sign * ((x[0] * c->m23 - x[2] * c->m03) + x[3] * c->m02);
    out[2] = sign * ((x[0] * c->m13 - x[1] * c->m03) + x[3] * c->m01);
    out[3] = -sign * ((x[0] * c->m12 - x[1] * c->m02) + x[2] * c->m01);
}

#endif
