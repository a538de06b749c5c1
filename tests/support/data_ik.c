/* SPDX-License-Identifier: MIT */
#include "data.h"
#include "hash.h"
#include "random.h"
#include "views.h"

enum { LINKS = 5, ROUNDS = 400 };

static uint64_t two_bones(random_source *r, uint64_t hash)
{
    nkw_ik_two_bone limb = {random_vec3(r, -1, 1), random_vec3(r, -1, 1), random_vec3(r, -1, 1), random_vec3(r, -2, 2),
                            random_vec3(r, -1, 1), random_vec3(r, -1, 1), random_unit(r),        1.5f * random_unit(r)};
    if (random_bits(r) % 4 == 0)
        limb.end = nkw_vec3_sub(nkw_vec3_add(limb.mid, limb.mid), limb.root);
    nkw_ik_two_bone_solution s = nkw_ik_two_bone_solve(&limb);
    hash = hash_floats(hash, &s.root.x, 8);
    hash = hash_floats(hash, &s.mid_position.x, 6);
    return hash_floats(hash, &s.error, 1);
}

static uint64_t aims(random_source *r, uint64_t hash)
{
    nkw_ik_aim aim = {random_vec3(r, -1, 1), random_vec3(r, -1, 1), random_vec3(r, -1, 1),
                      random_vec3(r, -4, 4), random_vec3(r, -1, 1), random_vec3(r, -1, 1),
                      random_vec3(r, -1, 1), 2.0f * random_unit(r), 1.5f * random_unit(r)};
    nkw_ik_aim_solution s = nkw_ik_aim_solve(&aim);
    hash = hash_floats(hash, &s.rotation.x, 4);
    return hash_floats(hash, &s.error, 1);
}

static uint64_t chains(random_source *r, uint64_t hash)
{
    nkw_vec3 offsets[LINKS];
    NKW_STACK_WORK(work, NKW_IK_CHAIN_WORK(LINKS));
    nkw_quat rotations[LINKS];
    nkw_limit limits[LINKS];
    for (int k = 0; k < LINKS; k++) {
        offsets[k] = random_vec3(r, -1, 1);
        rotations[k] = random_rotation(r);
        nkw_limit limit = {random_rotation(r), offsets[k],      random_vec3(r, -1, 1), random_unit(r),
                           random_unit(r),     -random_unit(r), random_unit(r)};
        limits[k] = limit;
    }
    nkw_ik_chain chain = {random_vec3(r, -1, 1), random_rotation(r), offsets, NULL, LINKS};
    nkw_ik_goal goal = {random_vec3(r, -2, 2), 1e-4f, 8};
    chain.limits = random_bits(r) % 2 ? limits : NULL;
    nkw_ik_chain_result a, b;
    nkw_ik_chain_solve(&chain, &goal, NKW_IK_CCD, rotations, &a, work);
    hash = hash_floats(hash, &rotations[0].x, 4 * LINKS);
    goal.target = random_vec3(r, -2, 2);
    nkw_ik_chain_solve(&chain, &goal, NKW_IK_FABRIK, rotations, &b, work);
    hash = hash_floats(hash, &rotations[0].x, 4 * LINKS);
    hash = hash_floats(hash, &a.error, 1);
    return hash_floats(hash, &b.error, 1);
}

static uint64_t poses(random_source *r, uint64_t hash)
{
    static const int32_t parents[LINKS] = {-1, 0, 1, 2, 3};
    nkw_trs trs[LINKS];
    float pose[NKW_POSE_FLOATS(LINKS)], errors[3];
    NKW_STACK_WORK(work, NKW_IK_POSE_CHAIN_WORK(3));
    nkw_mat4 models[LINKS];
    nkw_ik_pose ik = {{parents, LINKS}, models, NULL, pose_span(pose, LINKS)};
    for (int k = 0; k < LINKS; k++) {
        nkw_trs t = {random_vec3(r, -1, 1), random_rotation(r), {1, 1, 1}};
        trs[k] = t;
    }
    nkw_pose_from_trs(trs, pose_span(pose, LINKS));
    nkw_skeleton_models_from_pose(&ik.skeleton, pose_view(pose, LINKS), NULL, NULL, models);
    nkw_ik_limb limb = {1, 2, 4, random_vec3(r, -2, 2), random_vec3(r, -1, 1), random_vec3(r, -1, 1), 0.1f, 1.0f};
    nkw_ik_look look = {3,
                        random_vec3(r, -2, 2),
                        random_vec3(r, -1, 1),
                        random_vec3(r, -1, 1),
                        random_vec3(r, -1, 1),
                        random_vec3(r, -1, 1),
                        random_vec3(r, -1, 1),
                        random_unit(r),
                        0.75f};
    nkw_ik_reach reach = {4, 3, {random_vec3(r, -2, 2), 1e-4f, 8}, NULL, NKW_IK_FABRIK, 0.5f};
    nkw_ik_chain_result result;
    nkw_ik_pose_two_bone(&ik, &limb, &errors[0]);
    nkw_ik_pose_aim(&ik, &look, &errors[1]);
    nkw_ik_pose_chain(&ik, &reach, &result, work);
    errors[2] = result.error;
    hash = hash_floats(hash, errors, 3);
    return hash_floats(hash, pose, NKW_POSE_FLOATS(LINKS));
}

uint64_t data_ik(void)
{
    random_source r = random_from(7);
    uint64_t hash = HASH_START;
    for (int i = 0; i < ROUNDS; i++) {
        hash = two_bones(&r, hash);
        hash = aims(&r, hash);
        hash = chains(&r, hash);
        hash = poses(&r, hash);
    }
    return hash;
}
