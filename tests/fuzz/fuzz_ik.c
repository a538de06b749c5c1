/* SPDX-License-Identifier: MIT */
/* Inverse kinematics: rotations stay finite and unit for any numbers, errors are never NaN, indices stay in bounds. */
#include "fuzz.h"
#include "../support/views.h"

#include <string.h>

enum { JOINTS = 40 };

static void check_rotation(nkw_quat q)
{
    float length = nkw_quat_length(q);
    FUZZ_CHECK(length > 0.999999f && length < 1.000001f);
}

static void two_bones(fuzz *f, int wild)
{
    nkw_ik_two_bone limb;
    memcpy(&limb, fuzz_floats(f, sizeof limb / sizeof(float), wild), sizeof limb);
    if (fuzz_byte(f) % 4 == 0)
        limb.mid = limb.root;
    if (fuzz_byte(f) % 4 == 0)
        limb.target = limb.root;
    nkw_ik_two_bone_solution s = nkw_ik_two_bone_solve(&limb);
    check_rotation(s.root);
    check_rotation(s.mid);
    FUZZ_CHECK(s.error >= 0.0f);
}

static void aims(fuzz *f, int wild)
{
    nkw_ik_aim aim;
    memcpy(&aim, fuzz_floats(f, sizeof aim / sizeof(float), wild), sizeof aim);
    nkw_ik_aim_solution s = nkw_ik_aim_solve(&aim);
    check_rotation(s.rotation);
    FUZZ_CHECK(s.error >= 0.0f);
}

static void chains(fuzz *f, int wild)
{
    size_t n = fuzz_upto(f, 12), room = fuzz_byte(f) % 8 ? n : n / 2;
    float *limits = fuzz_floats(f, n * sizeof(nkw_limit) / sizeof(float), wild);
    float *offsets = fuzz_floats(f, 3 * n, wild), *rotations = fuzz_floats(f, 4 * n, wild);
    nkw_ik_chain chain = {{1, 2, 3}, {0, 0, 0, 1}, (nkw_vec3 *)(void *)offsets, NULL, n};
    nkw_ik_goal goal = {{0, 0, 0}, fuzz_float(f), fuzz_byte(f) % 12};
    memcpy(&goal.target, fuzz_floats(f, 3, wild), sizeof goal.target);
    chain.limits = fuzz_byte(f) % 2 ? (nkw_limit *)(void *)limits : NULL;
    int finite = fuzz_finite(offsets, 3 * n) && fuzz_finite(rotations, 4 * n) && fuzz_finite(&goal.target.x, 3);
    nkw_quat *q = (nkw_quat *)(void *)rotations;
    nkw_ik_chain_result a = {0, 0}, b = {0, 0};
    const nkw_work none = {NULL, 0}, work = {fuzz_block(f, NKW_IK_CHAIN_WORK(room)), NKW_IK_CHAIN_WORK(room)};
    nkw_result one = nkw_ik_chain_solve(&chain, &goal, NKW_IK_CCD, q, &a, none);
    nkw_result two = nkw_ik_chain_solve(&chain, &goal, NKW_IK_FABRIK, q, &b, work);
    FUZZ_CHECK(a.error >= 0.0f && b.error >= 0.0f && a.iterations <= goal.iterations);
    FUZZ_CHECK(!finite || fuzz_finite(rotations, 4 * n));
    FUZZ_CHECK(finite || (one != NKW_OK && two != NKW_OK));
    FUZZ_CHECK(goal.tolerance >= 0.0f || (one != NKW_OK && two != NKW_OK));
}

static void poses(fuzz *f, int wild)
{
    size_t n = fuzz_upto(f, JOINTS), from = fuzz_upto(f, 12);
    nkw_ik_pose ik = {{fuzz_parents(f, n, wild), n}, NULL, NULL, {fuzz_pose(f, n, wild), n}};
    nkw_mat4 *models = fuzz_matrices(f, n, wild);
    float error = 0.0f;
    const nkw_work work = {fuzz_block(f, NKW_IK_POSE_CHAIN_WORK(from)), NKW_IK_POSE_CHAIN_WORK(from)};
    ik.models = models;
    ik.root = fuzz_byte(f) % 2 ? fuzz_matrices(f, 1, wild) : NULL;
    if (fuzz_byte(f) % 2)
        nkw_skeleton_models_from_pose(&ik.skeleton, NKW_VIEW(nkw_pose, ik.pose), ik.root, NULL, models);
    nkw_ik_limb limb = {fuzz_upto(f, n), fuzz_upto(f, n), fuzz_upto(f, n), {1, 1, 1}, {1, 0, 0}, {0, 1, 0}, 0, 1};
    nkw_ik_look look = {fuzz_upto(f, n), {1, 2, 3}, {0, 0, 1}, {0, 1, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 0}, 1, 1};
    nkw_ik_reach reach = {fuzz_huge(f), fuzz_huge(f), {{1, 2, 1}, 1e-3f, 6}, NULL, NKW_IK_FABRIK, fuzz_float(f)};
    if (fuzz_byte(f) % 4) {
        reach.end = fuzz_upto(f, n);
        reach.joint_count = fuzz_upto(f, 12);
    }
    reach.method = (nkw_ik_method)fuzz_choice(f, 1);
    nkw_ik_chain_result result = {0, 0};
    nkw_ik_pose_two_bone(&ik, &limb, &error);
    FUZZ_CHECK(error >= 0.0f);
    nkw_ik_pose_aim(&ik, &look, &error);
    FUZZ_CHECK(error >= 0.0f);
    nkw_ik_pose_chain(&ik, &reach, &result, work);
    FUZZ_CHECK(result.error >= 0.0f);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz f = fuzz_begin(data, size);
    int wild = fuzz_byte(&f) % 2;
    two_bones(&f, wild);
    aims(&f, wild);
    chains(&f, wild);
    poses(&f, wild);
    return fuzz_end(&f);
}
