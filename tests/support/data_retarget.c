/* SPDX-License-Identifier: MIT */
#include "data.h"
#include "hash.h"
#include "random.h"
#include "views.h"

enum { SOURCE = 11, TARGET = 13 };

static void draw_pose(random_source *r, float *pose, size_t joints)
{
    nkw_pose_identity(pose_span(pose, joints));
    for (size_t j = 0; j < joints; j++) {
        nkw_trs trs = {random_vec3(r, -1, 1), random_rotation(r), {1, 1, 1}};
        nkw_pose_set(pose_span(pose, joints), j, &trs);
    }
}

uint64_t data_retarget(void)
{
    random_source r = random_from(12);
    uint64_t hash = HASH_START;
    for (int i = 0; i < 200; i++) {
        float rest[NKW_POSE_FLOATS(SOURCE)], pose[NKW_POSE_FLOATS(SOURCE)], target[NKW_POSE_FLOATS(TARGET)];
        float out[NKW_POSE_FLOATS(TARGET)];
        NKW_STACK_WORK(work, NKW_RETARGET_WORK(SOURCE, TARGET));
        int32_t parents[TARGET], chain[3] = {1, 2, 4}, other[4] = {2, 3, 5, 6};
        nkw_retarget_joint joints[TARGET];
        draw_pose(&r, rest, SOURCE);
        draw_pose(&r, pose, SOURCE);
        draw_pose(&r, target, TARGET);
        for (int j = 0; j < TARGET; j++) {
            nkw_retarget_joint map = {(int32_t)(random_bits(&r) % (SOURCE + 1)) - 1,
                                      (int32_t)(random_bits(&r) % (SOURCE + 1)) - 1, random_unit(&r),
                                      j % 4 ? 0.0f : random_unit(&r)};
            joints[j] = map;
            parents[j] = j ? (int32_t)(random_bits(&r) % (unsigned)j) : -1;
        }
        nkw_retarget retarget = {
            {parents, SOURCE},  {parents, TARGET}, pose_view(rest, SOURCE), pose_view(target, TARGET), joints,
            random_rotation(&r)};
        nkw_retarget_map_chain(&retarget, chain, 3, other, 4, joints);
        nkw_retarget_apply(&retarget, pose_view(pose, SOURCE), pose_span(out, TARGET), work);
        hash = hash_floats(hash, out, NKW_POSE_FLOATS(TARGET));
    }
    return hash;
}
