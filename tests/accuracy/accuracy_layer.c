/* SPDX-License-Identifier: MIT */
/* Errors of <nakawari/layer.h> against binary128: rotations of chains, drawn from their seed. */
#include "wide.h"
#include "../support/views.h"

#if WIDE_AVAILABLE

#include <math.h>

#include <nakawari/layer.h>

#define SAMPLES 3000u
#define MOST    200

static int32_t parents[MOST];
static float pose[NKW_POSE_FLOATS(MOST)], composed[NKW_POSE_FLOATS(MOST)];

static const nkw_skeleton *draw_chain(const float *x, size_t joints)
{
    static nkw_skeleton skeleton;
    random_source r = wide_source(x);
    for (size_t j = 0; j < joints; j++) {
        const nkw_trs trs = {random_vec3(&r, -1.0f, 1.0f), random_unit_quat(&r), {1.0f, 1.0f, 1.0f}};
        parents[j] = (int32_t)j - 1;
        nkw_pose_set(pose_span(pose, joints), j, &trs);
    }
    skeleton.parents = parents;
    skeleton.joint_count = joints;
    nkw_skeleton_compose_rotations(&skeleton, pose_view(pose, joints), pose_span(composed, joints));
    return &skeleton;
}

static void rotation_of(const float *block, size_t joints, size_t j, float q[4])
{
    put_quat(q, nkw_pose_get(pose_view(block, joints), j).rotation);
}

/* separate(compose(pose)) against pose: the worst joint. */
static double back_error(const float *x, size_t joints)
{
    const nkw_skeleton *skeleton = draw_chain(x, joints);
    double worst = 0.0;
    nkw_skeleton_separate_rotations(skeleton, pose_view(composed, joints), pose_span(composed, joints));
    for (size_t j = 0; j < joints; j++) {
        float want[4], got[4];
        wide exact[4];
        rotation_of(pose, joints, j, want);
        rotation_of(composed, joints, j, got);
        wide_from(want, exact, 4);
        worst = fmax(worst, wide_error(got, exact, 4));
    }
    return worst;
}

/* The last rotation in model space against the product of all: it grows with the number of joints. */
static double last_error(const float *x, size_t joints)
{
    float got[4];
    wide exact[4] = {0, 0, 0, 1};
    draw_chain(x, joints);
    for (size_t j = 0; j < joints; j++) {
        float q[4];
        wide local[4];
        rotation_of(pose, joints, j, q);
        wide_from(q, local, 4);
        wide_quat_mul(exact, local, exact);
    }
    rotation_of(composed, joints, joints - 1, got);
    return wide_error(got, exact, 4);
}

#define LAYER_CASE(name, error, joints)                                                                                \
    static double name(const float *x)                                                                                 \
    {                                                                                                                  \
        return error(x, joints);                                                                                       \
    }

LAYER_CASE(back_2, back_error, 2)
LAYER_CASE(back_67, back_error, 67)
LAYER_CASE(back_200, back_error, MOST)
LAYER_CASE(last_2, last_error, 2)
LAYER_CASE(last_67, last_error, 67)

#define BACK    "nkw_skeleton_separate_rotations"
#define COMPOSE "nkw_skeleton_compose_rotations"

static const wide_case cases[] = {
    {BACK, "separate(compose), chain of 2", wide_seed, back_2, 2, WIDE_CHECKED},
    {BACK, "separate(compose), chain of 67", wide_seed, back_67, 2, WIDE_CHECKED},
    {BACK, "separate(compose), chain of 200", wide_seed, back_200, 2, WIDE_CHECKED},
    {COMPOSE, "the last of 2", wide_seed, last_2, 2, WIDE_NOTED},
    {COMPOSE, "the last of 67", wide_seed, last_67, 2, WIDE_NOTED},
};

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("layer.h", argc, argv);
    wide_search_seeds(&a, cases, sizeof cases / sizeof cases[0], SAMPLES);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
