/* SPDX-License-Identifier: MIT */
/*
 * Prints src/data/slerp.h:
 *
 *     gcc -std=c99 -O2 docs/generate/slerp.c -lm -o slerp && ./slerp > src/data/slerp.h
 *
 * Needs a long double of 64 or more bits, such as x86's 80-bit one. Takes a second. u = 2^-24.
 *
 * The formula (src/lane/orient.h), h = theta/2, rho = 1 - 2t:
 *
 *     slerp = C s/2 - S d/2         s = near + far, |s/2| = cos h      C = cos(rho h) / cos h = 1 + z F(v, P)
 *                                   d = far - near, |d/2| = sin h      S = sin(rho h) / sin h = rho + 2 rho z G(v, P)
 *
 *     x = 1 - cos theta    p = t (1 - t)    z = p x    v = x / (2.625 - x)    P = p v
 *
 * F and G minimise the largest error they make in slerp, in units of |near| = |far| = 1:
 *
 *     |s/2| |dC| = z cos h |dF|          |d/2| |dS| = 2 rho z sin h |dG|
 *
 * over theta in 0..pi/2 and t in 0..1; t in -1..0, and by symmetry in 1..2, joins with the weight 2e-4.
 * Their coefficients are rounded to binary32 one after the other, the rest fitted again each time.
 *
 * Source Lawson, Contributions to the Theory of Linear Least Maximum Approximation, 1961.
 */
#include <float.h>
#include <math.h>
#include <stdio.h>

typedef long double real;

enum { SIDE = 60, POINTS = SIDE * SIDE, FINE_SIDE = 240, ROWS = 5, TERMS = 16 };

static const real PI = 3.14159265358979323846264338L;
static const real POLE = 2.625L, OUTSIDE = 2e-4L, U = 0x1p-24L;

typedef struct place {
    real rho, h, z, v;
    real pv; /* P */
} place;

/* F or G: the sum of the terms v^i P^j, i <= degree[j], j < rows. */
typedef struct series {
    char name;
    int rows, degree[ROWS];
    int one; /* whether the term of v^0 P^0 is 1 */
    real (*target)(const place *at);
    real (*scale)(const place *at); /* what slerp changes by when the series changes by 1 */
    const char *form, *meaning;
} series;

/* A place seen by the fit; basis[k] = (2v)^i (8P)^j. */
typedef struct point {
    real basis[TERMS], target, scale;
    real share; /* in the least squares */
    real error;
} point;

typedef struct fit {
    int count, i[TERMS], j[TERMS], fixed[TERMS];
    real c[TERMS];
    point points[POINTS];
} fit;

/* (cos(rho h) - cos h) / (z cos h). */
static real f_target(const place *at)
{
    real h = at->h / 2;
    return 2 * sinl((1 + at->rho) * h) * sinl((1 - at->rho) * h) / cosl(at->h) / at->z;
}

static real f_scale(const place *at)
{
    return fabsl(at->z) * cosl(at->h);
}

/* (sin(rho h) / sin h - rho) / (2 rho z). */
static real g_target(const place *at)
{
    return (sinl(at->rho * at->h) / sinl(at->h) - at->rho) / (2 * at->rho * at->z);
}

static real g_scale(const place *at)
{
    return 2 * at->rho * fabsl(at->z) * sinl(at->h);
}

/* Chebyshev's points of 0..1: k in 0..side - 1. */
static real node(int k, int side)
{
    return 0.5L * (1 - cosl((k + 0.5L) * PI / side));
}

static place place_at(real x, real p)
{
    place at;
    at.rho = sqrtl(1 - 4 * p);
    at.h = asinl(sqrtl(x / 2));
    at.z = p * x;
    at.v = x / (POLE - x);
    at.pv = p * at.v;
    return at;
}

/* t in 0..1 has p in 0..1/4, t in -1..0 has p in -2..0. */
static void sample(const series *s, const fit *f, point *at, real x, real p)
{
    place here = place_at(x, p);
    at->target = s->target(&here);
    at->scale = (p > 0 ? 1 : OUTSIDE) * s->scale(&here);
    for (int k = 0; k < f->count; k++)
        at->basis[k] = powl(2 * here.v, f->i[k]) * powl(8 * here.pv, f->j[k]);
}

static void list_terms(const series *s, fit *f)
{
    f->count = 0;
    for (int j = 0; j < s->rows; j++) {
        for (int i = 0; i <= s->degree[j]; i++, f->count++) {
            f->i[f->count] = i;
            f->j[f->count] = j;
            f->fixed[f->count] = 0;
        }
    }
    f->c[0] = 1;
    f->fixed[0] = s->one;
}

/* Every other column is outside. */
static void sample_all(const series *s, fit *f)
{
    for (int a = 0; a < SIDE; a++) {
        for (int b = 0; b < SIDE; b++) {
            real y = node(b, SIDE);
            sample(s, f, &f->points[a * SIDE + b], node(a, SIDE), b % 2 ? -2 * y : y / 4);
        }
    }
}

static real sum(const fit *f, const point *at)
{
    real value = 0;
    for (int k = 0; k < f->count; k++)
        value += f->c[k] * at->basis[k];
    return value;
}

static real error_at(const fit *f, const point *at)
{
    return fabsl((sum(f, at) - at->target) * at->scale);
}

/* The target less the fixed terms. */
static real residual(const fit *f, const point *at)
{
    real rest = at->target;
    for (int k = 0; k < f->count; k++)
        if (f->fixed[k])
            rest -= f->c[k] * at->basis[k];
    return rest;
}

/* Adds a point to the normal equations  B^T W B c = B^T W r  of the m free terms, upper half, right side last. */
static void add_point(const fit *f, const point *at, const int *free_terms, int m,
                      real q[][TERMS + 1])
{
    real rest = residual(f, at), weight = at->share * at->scale * at->scale;
    for (int i = 0; i < m; i++) {
        real wb = weight * at->basis[free_terms[i]];
        for (int j = i; j < m; j++)
            q[i][j] += wb * at->basis[free_terms[j]];
        q[i][m] += wb * rest;
    }
}

static void swap_rows(real *a, real *b, int count)
{
    for (int k = 0; k < count; k++) {
        real t = a[k];
        a[k] = b[k];
        b[k] = t;
    }
}

static int pivot(real q[][TERMS + 1], int m, int k)
{
    int best = k;
    for (int r = k + 1; r < m; r++)
        if (fabsl(q[r][k]) > fabsl(q[best][k]))
            best = r;
    return best;
}

/* Gauss and Jordan: leaves a diagonal and the right side. */
static void eliminate(real q[][TERMS + 1], int m)
{
    for (int k = 0; k < m; k++) {
        swap_rows(q[k], q[pivot(q, m, k)], m + 1);
        for (int r = 0; r < m; r++) {
            real s = q[r][k] / q[k][k];
            for (int j = k; r != k && j <= m; j++)
                q[r][j] -= s * q[k][j];
        }
    }
}

static int find_free(const fit *f, int *free_terms)
{
    int m = 0;
    for (int k = 0; k < f->count; k++)
        if (!f->fixed[k])
            free_terms[m++] = k;
    return m;
}

static void least_squares(fit *f)
{
    real q[TERMS][TERMS + 1] = {{0}};
    int free_terms[TERMS], m = find_free(f, free_terms);
    for (int n = 0; n < POINTS; n++)
        add_point(f, &f->points[n], free_terms, m, q);
    for (int i = 0; i < m; i++)
        for (int j = 0; j < i; j++)
            q[i][j] = q[j][i];
    eliminate(q, m);
    for (int i = 0; i < m; i++)
        f->c[free_terms[i]] = q[i][m] / q[i][i];
}

/* Sets the error at every point; gives the largest. */
static real measure(fit *f)
{
    real largest = 0;
    for (int n = 0; n < POINTS; n++) {
        f->points[n].error = error_at(f, &f->points[n]);
        largest = fmaxl(largest, f->points[n].error);
    }
    return largest;
}

/* Lawson's step, damped:  share <- share (sqrt(error / largest) + 1/1000),  mean share 1. */
static void reweigh(fit *f, real largest)
{
    real total = 0;
    for (int n = 0; n < POINTS; n++) {
        point *at = &f->points[n];
        at->share *= sqrtl(at->error / largest) + 1e-3L;
        total += at->share;
    }
    for (int n = 0; n < POINTS; n++)
        f->points[n].share *= POINTS / total;
}

static void copy(real *to, const real *from, int count)
{
    for (int k = 0; k < count; k++)
        to[k] = from[k];
}

/* The free terms for the least largest error: the best of so many of Lawson's steps. */
static void minimax(fit *f, int steps)
{
    real best = LDBL_MAX, best_c[TERMS];
    for (int n = 0; n < POINTS; n++)
        f->points[n].share = 1;
    for (int step = 0; step < steps; step++) {
        least_squares(f);
        real largest = measure(f);
        if (largest < best) {
            best = largest;
            copy(best_c, f->c, f->count);
        }
        reweigh(f, largest);
    }
    copy(f->c, best_c, f->count);
}

/* c (2v)^i (8P)^j = c 2^(i + 3j) v^i P^j. */
static float coefficient(const fit *f, int k)
{
    return (float)ldexpl(f->c[k], f->i[k] + 3 * f->j[k]);
}

/* Rounds term k to binary32 and fits the free ones again. */
static void settle(fit *f, int k)
{
    int free_terms[TERMS];
    f->c[k] = ldexpl((real)coefficient(f, k), -f->i[k] - 3 * f->j[k]);
    f->fixed[k] = 1;
    if (find_free(f, free_terms) > 0)
        minimax(f, 25);
}

/* One after the other, lowest order first: v counts 1, P counts 2. */
static void settle_all(fit *f)
{
    for (int order = 0; order <= 2 * TERMS; order++)
        for (int k = 0; k < f->count; k++)
            if (!f->fixed[k] && f->i[k] + 2 * f->j[k] == order)
                settle(f, k);
}

/* The largest error for t in 0..1, on a finer grid. */
static real largest_error(const series *s, const fit *f)
{
    real largest = 0;
    for (int a = 0; a < FINE_SIDE; a++) {
        for (int b = 0; b < FINE_SIDE; b++) {
            point at;
            sample(s, f, &at, node(a, FINE_SIDE), node(b, FINE_SIDE) / 4);
            largest = fmaxl(largest, error_at(f, &at));
        }
    }
    return largest;
}

static void print_row(const series *s, const fit *f, int j)
{
    int skipped = j == 0 && s->one;
    printf("static const float LANE_SLERP_%c%d[%d] = {\n", s->name, j, s->degree[j] + 1 - skipped);
    for (int k = skipped; k < f->count; k++)
        if (f->j[k] == j)
            printf("    %af,\n", (double)coefficient(f, k));
    printf("};\n");
}

/* The error in thousandths of u, rounded up. */
static void print_series(const series *s, const fit *f)
{
    real error = ceill(1000 * largest_error(s, f) / U) / 1000;
    printf("\n/*\n * %s\n", s->form);
    printf(" * %s. Its error moves slerp by at most %.3Lf u for t in 0..1.\n */\n", s->meaning, error);
    for (int j = 0; j < s->rows; j++)
        print_row(s, f, j);
}

static void make_series(const series *s)
{
    static fit f;
    list_terms(s, &f);
    sample_all(s, &f);
    minimax(&f, 40);
    settle_all(&f);
    print_series(s, &f);
}

static void print_head(void)
{
    printf("/* SPDX-License-Identifier: MIT */\n"
           "/* Generated by docs/generate/slerp.c: edit that file, not this one. */\n"
           "#ifndef NAKAWARI_DATA_SLERP_H\n"
           "#define NAKAWARI_DATA_SLERP_H\n"
           "\n"
           "/* clang-format off */\n"
           "\n"
           "/* v = x / (LANE_SLERP_POLE - x), x = 1 - cos theta: maps the branch point at theta = pi away. */\n"
           "#define LANE_SLERP_POLE %.3Lff\n",
           POLE);
}

static const series F = {
    .name = 'F',
    .rows = 5,
    .degree = {5, 3, 2, 1, 0},
    .one = 1,
    .target = f_target,
    .scale = f_scale,
    .form = "F = 1 + v F0(v) + P (F1(v) + P (F2(v) + P (F3(v) + P F4))), lowest power of v first.",
    .meaning = "cos(rho theta/2) / cos(theta/2) = 1 + z F",
};

static const series G = {
    .name = 'G',
    .rows = 4,
    .degree = {5, 2, 2, 0},
    .one = 0,
    .target = g_target,
    .scale = g_scale,
    .form = "G = G0(v) + P (G1(v) + P (G2(v) + P G3)).",
    .meaning = "sin(rho theta/2) / sin(theta/2) = rho + 2 rho z G",
};

int main(void)
{
    if (LDBL_MANT_DIG < 64) {
        fputs("slerp.c needs a long double of 64 bits or more, such as x86's 80-bit one\n", stderr);
        return 1;
    }
    print_head();
    make_series(&F);
    make_series(&G);
    printf("\n#endif\n");
    return fflush(stdout) != 0 || ferror(stdout);
}
