/* SPDX-License-Identifier: MIT */
/* Errors of <nakawari/mat.h> against binary128: normal matrices, also of flat blocks. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>

#define SAMPLES 20000u
#define NORMAL  "nkw_mat3_normal"

/* U diag(1, a, b) V, rounded. */
static void stretched(random_source *r, float *x, double a, double b)
{
    const double s[3] = {1.0, a, b};
    double u[9], v[9];
    double_mat3_from_quat(random_unit_quat(r), u);
    double_mat3_from_quat(random_unit_quat(r), v);
    for (int i = 0; i < 9; i++) {
        double sum = 0.0;
        for (int k = 0; k < 3; k++)
            sum += u[k * 3 + i % 3] * s[k] * v[i / 3 * 3 + k];
        x[i] = (float)sum;
    }
}

static void even(random_source *r, float *x)
{
    double a = (double)random_log(r, 0.1f, 1.0f);
    stretched(r, x, a, (double)random_log(r, 0.1f, 1.0f));
}

static void uneven(random_source *r, float *x)
{
    double a = (double)random_log(r, 1e-5f, 1.0f);
    stretched(r, x, a, (double)random_log(r, 1e-5f, 1.0f));
}

static void flat(random_source *r, float *x)
{
    double a = (double)random_log(r, 0.1f, 1.0f);
    stretched(r, x, a, random_bits(r) % 4 ? (double)random_log(r, 1e-12f, 1e-6f) : 0.0);
}

/* Columns whose lengths differ by whole exponents. */
static void far_columns(random_source *r, float *x)
{
    uneven(r, x);
    for (int c = 0; c < 3; c++) {
        float scale = nkw_abs(random_scaled(r, -30, 30));
        for (int i = 0; i < 3; i++)
            x[3 * c + i] *= scale;
    }
}

/* The cofactors over the determinant; where that is at most 2^-20 of the columns' lengths, over the largest of them. */
static double normal_error(const float *x)
{
    wide m[9], c[9], det, lengths = 1, divisor = 0;
    nkw_mat3 f, got;
    for (int i = 0; i < 9; i++)
        f.m[i] = x[i];
    wide_from(x, m, 9);
    for (int i = 0; i < 3; i++) {
        wide_cross(m + (i + 1) % 3 * 3, m + (i + 2) % 3 * 3, c + 3 * i);
        lengths *= wide_length(m + 3 * i, 3);
    }
    det = wide_dot(m, c, 3);
    for (int i = 0; i < 9; i++)
        divisor = (c[i] < 0 ? -c[i] : c[i]) > divisor ? (c[i] < 0 ? -c[i] : c[i]) : divisor;
    if ((det < 0 ? -det : det) > lengths * 0x1p-20)
        divisor = det;
    wide_scale(c, 1 / divisor, 9);
    got = nkw_mat3_normal(&f);
    return wide_error(got.m, c, 9);
}

static const wide_case cases[] = {
    {NORMAL, "scales to 10 : 1", even, normal_error, 9, WIDE_CHECKED},
    {NORMAL, "scales to 1e5 : 1", uneven, normal_error, 9, WIDE_CHECKED},
    {NORMAL, "flat", flat, normal_error, 9, WIDE_CHECKED},
    {NORMAL, "columns of any lengths", far_columns, normal_error, 9, WIDE_CHECKED},
};

void mat_more(accuracy *a)
{
    wide_search(a, cases, sizeof cases / sizeof cases[0], SAMPLES);
}

#else
/* ISO C forbids an empty file. */
typedef int mat_more_is_skipped;
#endif
