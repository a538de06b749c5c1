/* SPDX-License-Identifier: MIT */
/* Errors of <nakawari/palette.h> against binary128: one joint, drawn from its seed. */
#include "wide.h"
#include "../support/views.h"

#if WIDE_AVAILABLE

#include <math.h>

/* The bounds of nkw_palette_from_models, in u: the table of palette.h. That of normals is 1. */
#define MATRIX_BOUND 6.0
#define DUAL_BOUND   1.5

#define SAMPLES 15000u

/* What a joint matrix is made of; scales low .. 1 / low. */
typedef struct joint {
    nkw_mat4 model, inverse_bind, global_inverse;
    wide m[16], b[16], g[16];
} joint;

static nkw_mat4 draw_matrix(random_source *r, float low, wide exact[16])
{
    nkw_vec3 scale = {random_log(r, low, 1.0f / low), random_log(r, low, 1.0f / low), random_log(r, low, 1.0f / low)};
    nkw_trs trs = {random_vec3(r, -2.0f, 2.0f), random_unit_quat(r), scale};
    nkw_mat4 m = nkw_mat4_from_trs(&trs);
    wide_from(m.m, exact, 16);
    return m;
}

static joint draw_joint(const float *x, float low)
{
    random_source r = wide_source(x);
    joint j;
    j.model = draw_matrix(&r, low, j.m);
    j.inverse_bind = draw_matrix(&r, low, j.b);
    j.global_inverse = draw_matrix(&r, low, j.g);
    return j;
}

/* Of the product of the factors' Frobenius norms. */
static double palette_error(const float *x, float low, int has_global)
{
    joint j = draw_joint(x, low);
    nkw_mat4 got;
    wide exact[16], magnitude = wide_length(j.m, 16) * wide_length(j.b, 16);
    palette_from_models(&j.model, 1, NULL, &j.inverse_bind, has_global ? &j.global_inverse : NULL, 1, &got);
    wide_mat_mul(j.m, j.b, exact, 4);
    if (has_global)
        wide_mat_mul(j.g, exact, exact, 4);
    return wide_error_of(got.m, exact, 16, has_global ? magnitude * wide_length(j.g, 16) : magnitude) / MATRIX_BOUND;
}

static double rigid(const float *x)
{
    return palette_error(x, 1.0f, 0);
}

static double scaled(const float *x)
{
    return palette_error(x, 0.1f, 0);
}

static double with_global(const float *x)
{
    return palette_error(x, 0.1f, 1);
}

/* The rotation of a rigid joint matrix, whose product is rounded first. */
static double dual_error(const float *x)
{
    joint j = draw_joint(x, 1.0f);
    nkw_dual_quat got;
    float q[4];
    wide exact[16], block[9], want[4];
    palette_dual_from_models(&j.model, 1, NULL, &j.inverse_bind, NULL, 1, &got);
    wide_mat_mul(j.m, j.b, exact, 4);
    wide_block(exact, block);
    wide_quat_from_mat3(block, want);
    put_quat(q, got.real);
    return wide_error_either(q, want, 4) / DUAL_BOUND;
}

/* The block of |A^-1| and the translation of |A^-1| |t|, the larger of the two. */
static double bind_error(const float *x)
{
    joint j = draw_joint(x, 0.1f);
    nkw_mat4 got;
    wide exact[16], block[9];
    inverse_bind_from_models(&j.model, 1, NULL, NULL, 1, &got);
    nkw_mat3 linear = nkw_mat3_from_mat4(&got);
    wide_inverse(j.m, exact, 4);
    wide_block(exact, block);
    double place = wide_error_of(got.m + 12, exact + 12, 3, wide_length(block, 9) * wide_length(j.m + 12, 3));
    return fmax(wide_error(linear.m, block, 9), place);
}

typedef enum form { MATRIX, ROWS, COLUMNS } form;

static double normal_error(const float *x, form written)
{
    joint j = draw_joint(x, 0.1f);
    nkw_mat3 m;
    nkw_mat3x4 rows;
    float columns[12], got[9];
    wide block[9], inverse[9], exact[9];
    palette_normals(&j.model, 1, &m);
    palette_normals_rows(&j.model, 1, &rows);
    palette_normals_columns(&j.model, 1, columns);
    wide_block(j.m, block);
    wide_inverse(block, inverse, 3);
    for (int i = 0; i < 9; i++) {
        int c = i / 3, r = i % 3;
        got[i] = written == MATRIX ? m.m[i] : written == ROWS ? rows.m[4 * r + c] : columns[4 * c + r];
        exact[i] = inverse[3 * r + c];
    }
    return wide_error(got, exact, 9);
}

static double normals(const float *x)
{
    return normal_error(x, MATRIX);
}

static double normal_rows(const float *x)
{
    return normal_error(x, ROWS);
}

static double normal_columns(const float *x)
{
    return normal_error(x, COLUMNS);
}

#define PALETTE "nkw_palette_from_models"

static const wide_case cases[] = {
    {PALETTE, "matrices, model, inverse bind; rigid", wide_seed, rigid, 2, WIDE_CHECKED},
    {PALETTE, "matrices, model, inverse bind; scales 0.1 .. 10", wide_seed, scaled, 2, WIDE_CHECKED},
    {PALETTE, "matrices, with a global inverse, scales 0.1 .. 10", wide_seed, with_global, 2, WIDE_CHECKED},
    {PALETTE, "dual quaternions, rotation, rigid", wide_seed, dual_error, 2, WIDE_CHECKED},
    {"nkw_palette_inverse_bind", "scales 0.1 .. 10", wide_seed, bind_error, 2, WIDE_CHECKED},
    {PALETTE, "normals, scales 0.1 .. 10", wide_seed, normals, 2, WIDE_CHECKED},
    {PALETTE, "rows of normals, scales 0.1 .. 10", wide_seed, normal_rows, 2, WIDE_CHECKED},
    {PALETTE, "columns of normals, scales 0.1 .. 10", wide_seed, normal_columns, 2, WIDE_CHECKED},
};

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("palette.h", argc, argv);
    wide_search_seeds(&a, cases, sizeof cases / sizeof cases[0], SAMPLES);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
