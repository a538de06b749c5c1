/* SPDX-License-Identifier: MIT */
/*
 * Prints src/kernel/data/slerp.h:
 *
 *     gcc -std=c99 -O2 docs/generate/slerp.c -lm -o slerp && ./slerp > src/kernel/data/slerp.h
 *
 * Requires a long double with a significand of at least 64 bits, such as the 80-bit type of x86. Runs for two seconds.
 * u = 2^-24.
 *
 * The formula (src/kernel/lane/slerp.h):
 *
 *     sin(k theta)/sin theta = k - E(k)      E(k) = k (1 - k) (1 + k) v H(v, k^2)
 *
 *     x = 1 - cos theta    v = 2x / (1 - 5x/16)
 *
 * H minimises the largest error of E over theta in 0..pi/2. Errors of small arcs have a larger weight. There is one H
 * for k in 0..1/2, the weight of the key farther from t, and one for k in 1/2..1, the weight of the nearer key. slerp
 * multiplies each by a vector of length 1, so an error of E is an absolute error of the result.
 * The coefficients are rounded to binary32 one by one; the others are fitted again each time.
 *
 * Source Lawson, Contributions to the Theory of Linear Least Maximum Approximation, 1961.
 */
#include <float.h>
#include <math.h>
#include <stdio.h>

typedef long double real;

enum { SIDE = 48, POINTS = SIDE * SIDE, FINE_SIDE = 240, ROWS = 4, POWERS = 6, TERMS = 15 };

static const real PI = 3.14159265358979323846264338L;
static const real POLE = 16.0L / 5, U = 0x1p-24L;

typedef struct argument {
    real k, theta, v;
} argument;

/* H for k in from..from + 1/2: the sum of the terms v^i k^2j, i < POWERS, j <= degree[i]. */
typedef struct series {
    const char *name, *use;
    real from, stress; /* weight of errors of small arcs, such as those between neighbouring keys */
    int degree[POWERS];
} series;

/* src/kernel/lane/slerp.h and src/kernel/lane/compact.h omit the terms that are missing here. Degree -1: no terms. */
static const series all[] = {
    {"LANE_SLERP_NEARER", "", 0.5L, 4, {0, 1, 2, 3, 0, 2}},
    {"LANE_SLERP_FARTHER", "", 0, 4, {0, 1, 2, 1, 0, 1}},
    {"LANE_SLERP_COMPACT_NEARER", ", for compact clips", 0.5L, 1, {0, 1, 2, 3, 2, -1}},
    {"LANE_SLERP_COMPACT_FARTHER", ", for compact clips", 0, 1, {0, 1, 2, 1, 0, -1}},
};

/* A sample of the fit at (k, theta); basis[n] = (v/2)^i k^2j. */
typedef struct point {
    real basis[TERMS], target, scale, stress;
    real share; /* its weight in the least squares */
    real error;
} point;

typedef struct fit {
    const series *of;
    int count, i[TERMS], j[TERMS], fixed[TERMS];
    real c[TERMS];
    point points[POINTS];
} fit;

/* dE / dH. */
static real scale(const argument *at)
{
    return at->k * (1 - at->k) * (1 + at->k) * at->v;
}

/* The exact H. */
static real target(const argument *at)
{
    return (at->k - sinl(at->k * at->theta) / sinl(at->theta)) / scale(at);
}

/* The Chebyshev nodes of 0..1: k in 0..side - 1. */
static real node(int k, int side)
{
    return 0.5L * (1 - cosl((k + 0.5L) * PI / side));
}

/* x = 1 - cos theta. */
static argument argument_at(real x, real k)
{
    argument at;
    at.k = k;
    at.theta = 2 * asinl(sqrtl(x / 2));
    at.v = 2 * x / (1 - x / POLE);
    return at;
}

/* k = from + y/2, y in 0..1. */
static void sample(const fit *f, point *at, real x, real y)
{
    argument here = argument_at(x, f->of->from + y / 2);
    at->target = target(&here);
    at->scale = scale(&here);
    at->stress = 1 + (f->of->stress - 1) / (1 + powl(4 * here.v, 4));
    for (int n = 0; n < f->count; n++)
        at->basis[n] = powl(here.v / 2, f->i[n]) * powl(here.k, 2 * f->j[n]);
}

static void list_terms(fit *f, const series *of)
{
    f->of = of;
    f->count = 0;
    for (int i = 0; i < POWERS; i++) {
        for (int j = 0; j <= of->degree[i]; j++, f->count++) {
            f->i[f->count] = i;
            f->j[f->count] = j;
            f->fixed[f->count] = 0;
        }
    }
}

static void sample_all(fit *f)
{
    for (int a = 0; a < SIDE; a++)
        for (int b = 0; b < SIDE; b++)
            sample(f, &f->points[a * SIDE + b], node(a, SIDE), node(b, SIDE));
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

/* The target minus the fixed terms. */
static real residual(const fit *f, const point *at)
{
    real rest = at->target;
    for (int k = 0; k < f->count; k++)
        if (f->fixed[k])
            rest -= f->c[k] * at->basis[k];
    return rest;
}

/* Adds a point to the normal equations  B^T W B c = B^T W r  of the m free terms: upper half, right side last. */
static void add_point(const fit *f, const point *at, const int *free_terms, int m,
                      real q[][TERMS + 1])
{
    real rest = residual(f, at), stressed = at->scale * at->stress, weight = at->share * stressed * stressed;
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

/* Gauss-Jordan elimination with partial pivoting: leaves a diagonal and the right side. */
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

/* Stores the weighted error at every point. Returns the largest. */
static real measure(fit *f)
{
    real largest = 0;
    for (int n = 0; n < POINTS; n++) {
        f->points[n].error = error_at(f, &f->points[n]) * f->points[n].stress;
        largest = fmaxl(largest, f->points[n].error);
    }
    return largest;
}

/* A damped step of Lawson's algorithm:  share <- share (sqrt(error / largest) + 1/1000),  mean share 1. */
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

/* The free terms with the smallest largest error in `steps` of Lawson's steps. */
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

/* c (v/2)^i = c 2^-i v^i. */
static float coefficient(const fit *f, int k)
{
    return (float)ldexpl(f->c[k], -f->i[k]);
}

/* Rounds term k to binary32 and fits the free ones again. */
static void round_term(fit *f, int k)
{
    int free_terms[TERMS];
    f->c[k] = ldexpl((real)coefficient(f, k), f->i[k]);
    f->fixed[k] = 1;
    if (find_free(f, free_terms) > 0)
        minimax(f, 20);
}

/* One by one, in ascending powers of v, then of k^2. */
static void round_terms(fit *f)
{
    for (int k = 0; k < f->count; k++)
        round_term(f, k);
}

/* The largest error, on a finer grid. */
static real largest_error(const fit *f)
{
    real largest = 0;
    for (int a = 0; a < FINE_SIDE; a++) {
        for (int b = 0; b < FINE_SIDE; b++) {
            point at;
            sample(f, &at, node(a, FINE_SIDE), node(b, FINE_SIDE));
            largest = fmaxl(largest, error_at(f, &at));
        }
    }
    return largest;
}

/* The coefficients of k^2j in ascending powers of v; 0 for a missing term. */
static void print_row(const fit *f, int j)
{
    float row[POWERS] = {0};
    for (int k = 0; k < f->count; k++)
        if (f->j[k] == j)
            row[f->i[k]] = coefficient(f, k);
    printf("    {");
    for (int i = 0; i < POWERS; i++)
        printf("%af%s", (double)row[i], i < POWERS - 1 ? ", " : "},\n");
}

/* The error in thousandths of u, rounded up. */
static void print_series(const fit *f)
{
    real error = ceill(1000 * largest_error(f) / U) / 1000;
    printf("\n/* E for k in %.1Lf..%.1Lf%s. Error at most %.3Lf u. */\n", f->of->from, f->of->from + 0.5L, f->of->use,
           error);
    printf("static const float %s[LANE_SLERP_ROWS][LANE_SLERP_POWERS] = {\n", f->of->name);
    for (int j = 0; j < ROWS; j++)
        print_row(f, j);
    printf("};\n");
}

static void make_series(const series *of)
{
    static fit f;
    list_terms(&f, of);
    sample_all(&f);
    minimax(&f, 40);
    round_terms(&f);
    print_series(&f);
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
           "/* v = |b - a|^2 / (a.b + LANE_SLERP_BEND |b - a|^2): moves the branch point at theta = pi farther out. */\n"
           "#define LANE_SLERP_BEND %.7Lff\n"
           "\n"
           "/*\n"
           " * sin(k theta) / sin theta = k - E(k),  E(k) = k (1 - k) (1 + k) v H(v, k^2),\n"
           " * H(v, k^2) = sum of H[j][i] v^i k^2j.\n"
           " */\n"
           "#define LANE_SLERP_ROWS   %d\n"
           "#define LANE_SLERP_POWERS 8 /* six, padded by two zeros to a multiple of 4 */\n",
           (1 - 1 / POLE) / 2, ROWS);
}

int main(void)
{
    if (LDBL_MANT_DIG < 64) {
        fputs("slerp.c: requires a long double with a significand of at least 64 bits\n", stderr);
        return 1;
    }
    print_head();
    for (size_t k = 0; k < sizeof all / sizeof all[0]; k++)
        make_series(&all[k]);
    printf("\n#endif\n");
    return fflush(stdout) != 0 || ferror(stdout);
}
