/* SPDX-License-Identifier: MIT */
/*
 * The farthest point of an ellipsoid from the origin: max |d + D n| over all |n| <= 1.
 *
 * With M = D^T D, b = D^T d, and any l above the largest eigenvalue of M,
 *
 *     |d + D n|^2 = |d|^2 + n.M n + 2 b.n <= |d|^2 + l + b.x,    x = (l - M)^-1 b
 *
 * and both sides are equal where |x| = 1 or, if |x| < 1 for all l, at the largest eigenvalue. So every l returns a
 * bound, and the root of |x| = 1 the maximum, by Newton's method for 1/|x| - 1.
 *
 * Source J. J. Moré and D. C. Sorensen, Computing a Trust Region Step, SIAM J. Sci. Stat. Comput. 4, 1983.
 */
#ifndef NAKAWARI_FARTHEST_H
#define NAKAWARI_FARTHEST_H

#include "lane/strict.h"

#include <stddef.h>

#include "lane/f64.h"

#define FARTHEST_STEPS 8

/* A symmetric matrix. */
typedef struct farthest_matrix {
    double xx, yy, zz, xy, yz, zx;
} farthest_matrix;

static inline double farthest_dot(const double *a, const double *b)
{
    return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
}

/*
 * The largest eigenvalue; up to 1e-7 of the spread of the eigenvalues and 2^-36 of the trace t more. With
 * M = t/3 + p C, tr C = 0 and tr C^2 = 6,
 *
 *     u^3 - 3 u - det C = 0,    t/3 + p u
 *
 * whose largest root is in 1..2, by Laguerre's method from 2 on, which descends.
 */
static inline double farthest_eigenvalue(const farthest_matrix *m)
{
    const double t = (m->xx + m->yy) + m->zz, x = m->xx - t / 3.0, y = m->yy - t / 3.0, z = m->zz - t / 3.0;
    const double outside = (m->xy * m->xy + m->yz * m->yz) + m->zx * m->zx;
    const double p = lane_sqrt64((((x * x + y * y) + z * z) + 2.0 * outside) / 6.0);
    const double determinant =
        (x * (y * z - m->yz * m->yz) - m->xy * (m->xy * z - m->yz * m->zx)) + m->zx * (m->xy * m->yz - y * m->zx);
    const double d = p > 0.0 ? determinant / p / p / p : 0.0;
    double u = 2.0;
    for (int i = 0; i < FARTHEST_STEPS; i++) {
        double f = (u * u - 3.0) * u - d, f1 = 3.0 * (u * u - 1.0), under = 4.0 * (f1 * f1) - 36.0 * (f * u);
        double divisor = f1 + lane_sqrt64(under > 0.0 ? under : 0.0);
        u = f > 0.0 && divisor > 0.0 ? u - 3.0 * f / divisor : u;
        u = u > 1.0 ? u : 1.0;
    }
    return (t / 3.0 + p * u) + (1e-7 * p + 0x1p-36 * t);
}

/* l - M = L diag(a, b, c) L^T; L has ones in its diagonal. */
typedef struct farthest_factors {
    double a, b, c, yx, zx, zy;
} farthest_factors;

static inline farthest_factors farthest_factor(const farthest_matrix *m, double l)
{
    farthest_factors f;
    f.a = l - m->xx;
    f.yx = -m->xy / f.a;
    f.zx = -m->zx / f.a;
    const double yz = -m->yz + f.yx * m->zx;
    f.b = (l - m->yy) + f.yx * m->xy;
    f.zy = yz / f.b;
    f.c = ((l - m->zz) + f.zx * m->zx) - f.zy * yz;
    return f;
}

/* L^-1 v. Returns v.(l - M)^-1 v. */
static inline double farthest_forward(const farthest_factors *f, const double v[3], double out[3])
{
    out[0] = v[0];
    out[1] = v[1] - f->yx * out[0];
    out[2] = (v[2] - f->zx * out[0]) - f->zy * out[1];
    return (out[0] * out[0] / f->a + out[1] * out[1] / f->b) + out[2] * out[2] / f->c;
}

/* (l - M)^-1 v from L^-1 v. */
static inline void farthest_back(const farthest_factors *f, const double forward[3], double x[3])
{
    x[2] = forward[2] / f->c;
    x[1] = forward[1] / f->b - f->zy * x[2];
    x[0] = (forward[0] / f->a - f->yx * x[1]) - f->zx * x[2];
}

/* The least of the bounds, |d|^2 apart. */
static inline double farthest_bound(const farthest_matrix *m, const double b[3])
{
    const double least = farthest_eigenvalue(m);
    double l = least + lane_sqrt64(farthest_dot(b, b)), best = INFINITY;
    for (int i = 0; i < FARTHEST_STEPS; i++) {
        double x[3], forward[3];
        const farthest_factors f = farthest_factor(m, l);
        double bound = l + farthest_forward(&f, b, forward);
        best = bound < best ? bound : best;
        farthest_back(&f, forward, x);
        double xx = farthest_dot(x, x), curved = farthest_forward(&f, x, forward);
        l = curved > 0.0 ? l + xx / curved * (lane_sqrt64(xx) - 1.0) : least;
        l = l > least ? l : least;
    }
    return best;
}

/* The distance, at most 1e-6 of it too large. columns: of D, 3 numbers each. */
static inline double farthest_of(const double d[3], const double columns[9])
{
    double size = 0.0, v[12];
    for (size_t i = 0; i < 12; i++) {
        double s = lane_abs64(i < 9 ? columns[i] : d[i - 9]);
        size = s > size ? s : size;
    }
    if (size == 0.0)
        return 0.0;
    for (size_t i = 0; i < 12; i++)
        v[i] = (i < 9 ? columns[i] : d[i - 9]) / size;
    const double *x = v, *y = v + 3, *z = v + 6, *e = v + 9;
    const double b[3] = {farthest_dot(x, e), farthest_dot(y, e), farthest_dot(z, e)};
    const farthest_matrix m = {farthest_dot(x, x), farthest_dot(y, y), farthest_dot(z, z),
                               farthest_dot(x, y), farthest_dot(y, z), farthest_dot(z, x)};
    if (!((m.xx + m.yy) + m.zz > 0.0))
        return size * lane_sqrt64(farthest_dot(e, e));
    return size * lane_sqrt64(farthest_dot(e, e) + farthest_bound(&m, b));
}

#endif
