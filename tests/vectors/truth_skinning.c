/* SPDX-License-Identifier: CC0-1.0 */
/* One vertex, blended by matrices and by dual quaternions. */
#include "truth.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <quadmath.h>
#include <string.h>

enum { MOST = 4 };

/* Rigid transforms of joints and one vertex. */
typedef struct vertex {
    float rotations[4 * MOST], translations[3 * MOST], weights[MOST], position[3], normal[3];
    int count;
} vertex;

static void joint_matrix(const vertex *v, int j, wide m[16])
{
    wide q[4], r[9];
    wide_from(v->rotations + 4 * j, q, 4);
    wide_mat3_from_quat(q, r);
    for (int i = 0; i < 16; i++)
        m[i] = i % 4 == 3 ? (wide)(i == 15) : i / 4 == 3 ? (wide)v->translations[3 * j + i % 4] : r[i / 4 * 3 + i % 4];
}

static void put_vertex(const vertex *v)
{
    truth_in("weights", v->weights, v->count);
    truth_in("position", v->position, 3);
    truth_in("normal", v->normal, 3);
}

/* Sum of w M p, and of w M n, divided by its length. */
static void linear_case(const char *kind, const char *name, const vertex *v)
{
    float matrices[16 * MOST];
    wide p[3] = {0}, n[3] = {0};
    for (int j = 0; j < v->count; j++) {
        wide m[16];
        joint_matrix(v, j, m);
        wide_round(m, matrices + 16 * j, 16);
        wide_from(matrices + 16 * j, m, 16);
        for (int i = 0; i < 3; i++) {
            wide w = v->weights[j];
            p[i] += w * (m[i] * v->position[0] + m[4 + i] * v->position[1] + m[8 + i] * v->position[2] + m[12 + i]);
            n[i] += w * (m[i] * v->normal[0] + m[4 + i] * v->normal[1] + m[8 + i] * v->normal[2]);
        }
    }
    wide_normalize(n, 3);
    truth_case(kind, name, NULL);
    truth_scale(4.0 * truth_size(v->position, 3) * truth_size(v->translations, 3 * v->count));
    truth_in("matrices", matrices, 16 * v->count);
    put_vertex(v);
    truth_out("position", p, 3);
    truth_out("normal", n, 3);
}

/* The blend of q and t q/2, divided by |q|; signs as the first joint's. */
static void dual_case(const char *kind, const char *name, const vertex *v)
{
    wide real[4] = {0}, dual[4] = {0}, first[4], p[4], n[4], t[4], back[4];
    for (int j = 0; j < v->count; j++) {
        wide q[4], d[4] = {0};
        wide_from(v->rotations + 4 * j, q, 4);
        wide_from(v->translations + 3 * j, d, 3);
        if (j == 0)
            memcpy(first, q, sizeof q);
        truth_align(first, q, 0);
        wide_quat_mul(d, q, d);
        for (int i = 0; i < 4; i++) {
            real[i] += v->weights[j] * q[i];
            dual[i] += v->weights[j] * d[i] / 2;
        }
    }
    wide length = wide_length(real, 4);
    wide_scale(real, 1 / length, 4);
    wide_scale(dual, 1 / length, 4);
    truth_inverse(real, back);
    wide_quat_mul(dual, back, t);
    wide_from(v->position, p, 3);
    wide_from(v->normal, n, 3);
    p[3] = n[3] = 0;
    wide_quat_mul(real, p, p);
    wide_quat_mul(p, back, p);
    wide_quat_mul(real, n, n);
    wide_quat_mul(n, back, n);
    for (int i = 0; i < 3; i++)
        p[i] += 2 * t[i];
    truth_case(kind, name, NULL);
    truth_scale(4.0 * truth_size(v->position, 3) * truth_size(v->translations, 3 * v->count));
    truth_in("rotations", v->rotations, 4 * v->count);
    truth_in("translations", v->translations, 3 * v->count);
    put_vertex(v);
    truth_out("position", p, 3);
    truth_out("normal", n, 3);
}

typedef void skin_case(const char *kind, const char *name, const vertex *v);

/* Weights in 1/16, so that their sum is exactly 1. */
static vertex draw_vertex(int count)
{
    vertex v = {{0}, {0}, {0}, {0}, {0}, count};
    float left = 1.0f;
    truth_some_turn(v.rotations);
    for (int j = 0; j < count; j++) {
        wide q[4];
        put_quat(v.rotations + 4 * j,
                 random_near(truth_random(), quat_at(v.rotations), 0.7f * random_unit(truth_random())));
        wide_from(v.rotations + 4 * j, q, 4);
        wide_normalize(q, 4);
        wide_round(q, v.rotations + 4 * j, 4);
        put_vec3(v.translations + 3 * j, random_vec3(truth_random(), -2.0f, 2.0f));
        v.weights[j] = j + 1 == count ? left : (float)(1 + (int)(random_bits(truth_random()) % 4)) / 16.0f;
        left -= v.weights[j];
    }
    put_vec3(v.position, random_vec3(truth_random(), -1.0f, 1.0f));
    truth_turn(1, 2, 3, 50, v.rotations + 4 * (MOST - 1) * (count < MOST));
    put_vec3(v.normal, random_direction(truth_random()));
    return v;
}

static void all_cases(skin_case *c)
{
    vertex v = draw_vertex(MOST);
    for (int i = 0; i < 6; i++) {
        v = draw_vertex(2 + i % 3);
        c("ordinary", "random", &v);
    }
    v.count = 1;
    v.weights[0] = 1.0f;
    c("boundary", "one-joint", &v);
    v = draw_vertex(2);
    memcpy(v.rotations + 4, v.rotations, 4 * sizeof(float));
    memcpy(v.translations + 3, v.translations, 3 * sizeof(float));
    c("boundary", "equal-joints", &v);
    v.weights[0] = 1.0f;
    v.weights[1] = 0.0f;
    c("boundary", "weight-0", &v);
    v.weights[0] = v.weights[1] = 0.5f;
    memset(v.translations, 0, sizeof v.translations);
    truth_turn(1, 0, 0, 0, v.rotations);
    truth_turn(1, 0, 0, 170, v.rotations + 4);
    c("hostile", "a-twist-of-170-degrees", &v);
    for (int i = 4; i < 8; i++)
        v.rotations[i] = -v.rotations[i];
    c("hostile", "the-same-with-a-negated-quaternion", &v);
}

void truth_skinning(const char *folder)
{
    static const char *const about[] = {
        "One vertex of one to four joints. Weights sum to 1. Column vectors; matrices column by column.",
        "skin_linear: sum of weight M p; the normal by the 3x3 blocks, then of length 1.",
        "skin_dual_quat: joints are a rotation (x y z w), then a translation; the dual quaternions q + e t q/2 are "
        "summed",
        "with the signs for which q.q0 >= 0, and divided by the length of the real part (Kavan and others 2008).",
        NULL,
    };
    static const char *const linear[] = {"in matrices n",
                                         "in weights n",
                                         "in position 3",
                                         "in normal 3",
                                         "out position 3 near",
                                         "out normal 3 near",
                                         NULL};
    static const char *const dual[] = {"in rotations n", "in translations n",   "in weights n",      "in position 3",
                                       "in normal 3",    "out position 3 near", "out normal 3 near", NULL};
    truth_open(folder, "skinning", about);
    truth_group("skin_linear", linear, 8.0, "sums of up to sixteen products in binary32");
    all_cases(linear_case);
    truth_group("skin_dual_quat", dual, 16.0, "the same, with the rounding of the dual quaternions");
    all_cases(dual_case);
    truth_close();
}

#else
typedef int truth_skinning_is_skipped;
#endif
