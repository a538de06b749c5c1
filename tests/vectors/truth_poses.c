/* SPDX-License-Identifier: CC0-1.0 */
/* Transforms, blends of two, hierarchies, palettes. */
#include "truth.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <quadmath.h>
#include <string.h>

/* Column by column, T R S: translation, x y z w, scale. */
static void matrix_of(const float trs[10], wide m[16])
{
    wide q[4], r[9];
    wide_from(trs + 3, q, 4);
    wide_mat3_from_quat(q, r);
    for (int i = 0; i < 16; i++) {
        int c = i / 4, row = i % 4;
        m[i] = row == 3 ? (wide)(c == 3) : c == 3 ? (wide)trs[row] : trs[7 + c] * r[3 * c + row];
    }
}

static void draw_trs(float trs[10])
{
    put_vec3(trs, random_vec3(truth_random(), -4.0f, 4.0f));
    truth_some_turn(trs + 3);
    put_vec3(trs + 7, random_vec3(truth_random(), 0.5f, 2.0f));
}

static const float nothing[10] = {0, 0, 0, 0, 0, 0, 1, 1, 1, 1};

static void trs_case(const char *kind, const char *name, const float trs[10])
{
    wide m[16];
    matrix_of(trs, m);
    truth_case(kind, name, NULL);
    truth_scale(truth_size(trs, 10));
    truth_in("translation", trs, 3);
    truth_in("rotation", trs + 3, 4);
    truth_in("scale", trs + 7, 3);
    truth_out("m", m, 16);
}

static void trs_group(void)
{
    static const char *const lines[] = {"in translation 3", "in rotation 4", "in scale 3", "out m 16 near", NULL};
    float trs[10], mirror[10];
    truth_group("trs_matrix", lines, 8.0, "M = T R S, column by column: m[12..14] is the translation");
    for (int i = 0; i < 6; i++) {
        draw_trs(trs);
        trs_case("ordinary", "random", trs);
    }
    trs_case("boundary", "identity", nothing);
    memcpy(mirror, trs, sizeof trs);
    mirror[7] = -1.0f;
    trs_case("boundary", "mirror", mirror);
    mirror[7] = 0.0f;
    trs_case("hostile", "scale-0", mirror);
}

static void blend_case(const char *kind, const char *name, const float a[10], const float b[10], float weight)
{
    wide r[10], p[4], q[4];
    for (int i = 0; i < 10; i++)
        r[i] = (1 - (wide)weight) * a[i] + (wide)weight * b[i];
    wide_from(a + 3, p, 4);
    wide_from(b + 3, q, 4);
    truth_align(p, q, 0);
    for (int i = 0; i < 4; i++)
        r[3 + i] = (1 - (wide)weight) * p[i] + (wide)weight * q[i];
    wide_normalize(r + 3, 4);
    truth_case(kind, name, NULL);
    truth_scale(fmax(truth_size(a, 10), truth_size(b, 10)));
    truth_in("a", a, 10);
    truth_in("b", b, 10);
    truth_in("weight", &weight, 1);
    truth_out("translation", r, 3);
    truth_out("rotation", r + 3, 4);
    truth_out("scale", r + 7, 3);
}

static void blend_group(void)
{
    static const char *const lines[] = {
        "in a 10", "in b 10", "in weight 1", "out translation 3 near", "out rotation 4 sign", "out scale 3 near", NULL};
    float a[10], b[10];
    truth_group("pose_blend", lines, 8.0, "lerp of translation and scale, nlerp of the rotation along the shorter arc");
    for (int i = 0; i < 6; i++) {
        draw_trs(a);
        draw_trs(b);
        blend_case("ordinary", "random", a, b, random_unit(truth_random()));
    }
    blend_case("boundary", "weight-0", a, b, 0.0f);
    blend_case("boundary", "weight-1", a, b, 1.0f);
    blend_case("boundary", "equal", a, a, 0.3f);
    memcpy(b, a, sizeof a);
    for (int i = 3; i < 7; i++)
        b[i] = -b[i];
    blend_case("hostile", "opposite-signs-of-one-rotation", a, b, 0.5f);
}

/* model[j] = model[parent] local[j]. */
static void models_of(const float *parents, const float *locals, int n, wide *models)
{
    for (int j = 0; j < n; j++) {
        wide local[16];
        matrix_of(locals + 10 * j, local);
        memcpy(models + 16 * j, local, sizeof local);
        if (parents[j] >= 0)
            wide_mat_mul(models + 16 * (int)parents[j], local, models + 16 * j, 4);
    }
}

static void models_case(const char *kind, const char *name, const float *parents, const float *locals, int n)
{
    wide models[48];
    models_of(parents, locals, n, models);
    truth_case(kind, name, NULL);
    truth_scale(16.0 * truth_size(locals, 10 * n));
    truth_in("parents", parents, n);
    truth_in("locals", locals, 10 * n);
    truth_out("models", models, 16 * n);
}

static void models_group(void)
{
    static const char *const lines[] = {"in parents n", "in locals n", "out models n near", NULL};
    const float chain[3] = {-1, 0, 1}, fork[3] = {-1, 0, 0}, roots[3] = {-1, -1, -1};
    float locals[30];
    truth_group("models", lines, 8.0,
                "a parent comes before its children, -1 is none; ten numbers for each joint: t, q, s");
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 3; j++)
            draw_trs(locals + 10 * j);
        models_case("ordinary", "chain", chain, locals, 3);
    }
    models_case("ordinary", "fork", fork, locals, 3);
    models_case("boundary", "roots-alone", roots, locals, 3);
    for (int j = 0; j < 3; j++)
        memcpy(locals + 10 * j, nothing, sizeof nothing);
    models_case("boundary", "identities", chain, locals, 3);
    locals[7] = 4.0f;
    truth_turn(0, 0, 1, 45, locals + 13);
    models_case("hostile", "a-turn-below-an-uneven-scale-is-sheared", chain, locals, 3);
}

static void palette_case(const char *kind, const char *name, const float *models, const float *inverse_bind, int n)
{
    wide m[48], a[16], b[16];
    for (int j = 0; j < n; j++) {
        wide_from(models + 16 * j, a, 16);
        wide_from(inverse_bind + 16 * j, b, 16);
        wide_mat_mul(a, b, m + 16 * j, 4);
    }
    truth_case(kind, name, NULL);
    truth_scale(4.0 * truth_size(models, 16 * n) * truth_size(inverse_bind, 16 * n));
    truth_in("models", models, 16 * n);
    truth_in("inverse_bind", inverse_bind, 16 * n);
    truth_out("palette", m, 16 * n);
}

static void palette_group(void)
{
    static const char *const lines[] = {"in models n", "in inverse_bind n", "out palette n near", NULL};
    truth_group("palette", lines, 4.0,
                "joint matrix = model matrix times inverse bind matrix, 16 numbers each, by columns");
    for (int i = 0; i < 5; i++) {
        float models[32], inverse_bind[32], trs[10];
        wide m[16], inverse[16];
        for (int j = 0; j < 2; j++) {
            draw_trs(trs);
            matrix_of(trs, m);
            wide_round(m, models + 16 * j, 16);
            if (i < 4)
                draw_trs(trs);
            matrix_of(trs, m);
            wide_inverse(m, inverse, 4);
            wide_round(inverse, inverse_bind + 16 * j, 16);
        }
        palette_case(i < 4 ? "ordinary" : "boundary", i < 4 ? "random" : "in-the-bind-pose-all-are-identities", models,
                     inverse_bind, 2);
    }
}

void truth_poses(const char *folder)
{
    static const char *const about[] = {
        "Poses: translation, rotation (x y z w, unit), scale; M = T R S. Column vectors; matrices column by column.",
        "models: model[j] = model[parent j] local[j]; palettes: joint matrix = model times inverse bind.",
        NULL,
    };
    truth_open(folder, "poses", about);
    trs_group();
    blend_group();
    models_group();
    truth_close();
    truth_open(folder, "palettes", about);
    palette_group();
    truth_close();
}

#else
typedef int truth_poses_is_skipped;
#endif
