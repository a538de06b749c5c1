/* SPDX-License-Identifier: MIT */
/* Errors of the rotations of <nakawari/retarget.h> against binary128. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>

#include "../support/views.h"

#define SAMPLES 20000u

/* A chain: each joint is the child of the one before. */
enum { JOINTS = 8 };

static void draw(random_source *r, float *pose)
{
    nkw_pose_identity(pose_span(pose, JOINTS));
    for (size_t j = 0; j < JOINTS; j++) {
        nkw_trs trs = {{0, 1, 0}, random_unit_quat(r), {1, 1, 1}};
        nkw_pose_set(pose_span(pose, JOINTS), j, &trs);
    }
}

/* The model-space rotations of a pose. */
static void models(const float *pose, wide m[JOINTS][4])
{
    for (size_t j = 0; j < JOINTS; j++) {
        float f[4];
        wide q[4];
        put_quat(f, nkw_pose_get(pose_view(pose, JOINTS), j).rotation);
        wide_from(f, q, 4);
        wide_normalize(q, 4);
        if (j)
            wide_quat_mul(m[j - 1], q, m[j]);
        else
            for (int i = 0; i < 4; i++)
                m[0][i] = q[i];
    }
}

static void conjugate(const wide q[4], wide out[4])
{
    for (int i = 0; i < 4; i++)
        out[i] = i < 3 ? -q[i] : q[i];
}

/* p becomes q p q^-1: the rotation p in the space that q leads to. */
static void turn_into(const wide q[4], wide p[4])
{
    wide back[4], half[4];
    conjugate(q, back);
    wide_quat_mul(q, p, half);
    wide_quat_mul(half, back, p);
}

/* The worst of the first `count` joints, divided by the joint's depth in both chains. */
static double chain_error(const float *x, size_t count)
{
    static const int32_t parents[JOINTS] = {-1, 0, 1, 2, 3, 4, 5, 6};
    float rest[NKW_POSE_FLOATS(JOINTS)], pose[NKW_POSE_FLOATS(JOINTS)], target[NKW_POSE_FLOATS(JOINTS)];
    float out[NKW_POSE_FLOATS(JOINTS)];
    NKW_STACK_WORK(work, NKW_RETARGET_WORK(JOINTS, JOINTS));
    wide w[JOINTS][4], g[JOINTS][4], v[JOINTS][4], want[JOINTS][4];
    nkw_retarget_joint joints[JOINTS];
    random_source r = wide_source(x);
    float align[4];
    wide turn[4];
    double worst = 0.0;
    put_quat(align, random_unit_quat(&r));
    wide_from(align, turn, 4);
    wide_normalize(turn, 4);
    draw(&r, rest);
    draw(&r, pose);
    draw(&r, target);
    for (int32_t j = 0; j < JOINTS; j++) {
        nkw_retarget_joint map = {j, NKW_NO_JOINT, 0.0f, 0.0f};
        joints[j] = map;
    }
    nkw_retarget retarget = {
        {parents, JOINTS}, {parents, JOINTS}, pose_view(rest, JOINTS), pose_view(target, JOINTS), joints, quat_at(align)};
    nkw_retarget_apply(&retarget, pose_view(pose, JOINTS), pose_span(out, JOINTS), work);
    models(rest, w);
    models(pose, g);
    models(target, v);
    for (size_t j = 0; j < count; j++) {
        wide inverse[4], d[4], local[4];
        float got[4];
        conjugate(w[j], inverse);
        wide_quat_mul(g[j], inverse, d);
        turn_into(turn, d);
        wide_quat_mul(d, v[j], want[j]);
        if (j) {
            conjugate(want[j - 1], inverse);
            wide_quat_mul(inverse, want[j], local);
        }
        put_quat(got, nkw_pose_get(pose_view(out, JOINTS), j).rotation);
        worst = fmax(worst, wide_error_either(got, j ? local : want[j], 4) / (double)(2 * (j + 1)));
    }
    return worst;
}

static double all_error(const float *x)
{
    return chain_error(x, JOINTS);
}

static double first_error(const float *x)
{
    return chain_error(x, 1);
}

static const wide_case cases[] = {
    {"nkw_retarget_apply", "chains of 8 joints, per level", wide_seed, all_error, 2, WIDE_CHECKED},
    {"nkw_retarget_apply", "one joint of each, per level", wide_seed, first_error, 2, WIDE_CHECKED},
};

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("retarget.h", argc, argv);
    wide_search_seeds(&a, cases, sizeof cases / sizeof cases[0], SAMPLES);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
