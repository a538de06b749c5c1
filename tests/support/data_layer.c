/* SPDX-License-Identifier: MIT */
#include "data.h"
#include "random.h"
#include "views.h"

enum { JOINTS = 40 };

uint64_t data_layer(void)
{
    random_source r = random_from(71);
    static float pose[NKW_POSE_FLOATS(JOINTS)];
    float mask[NKW_POSE_STRIDE(JOINTS)], times[JOINTS];
    int32_t parents[JOINTS];
    const nkw_skeleton skeleton = {parents, JOINTS};
    uint64_t hash = 0;
    for (int round = 0; round < 30; round++) {
        for (size_t j = 0; j < JOINTS; j++) {
            const nkw_trs trs = {random_vec3(&r, -1, 1), random_rotation(&r), random_vec3(&r, 0.5f, 2.0f)};
            parents[j] = j ? (int32_t)(random_bits(&r) % j) : -1;
            times[j] = random_between(&r, -0.1f, 2.0f);
            nkw_pose_set(pose_span(pose, JOINTS), j, &trs);
        }
        nkw_skeleton_compose_rotations(&skeleton, pose_view(pose, JOINTS), pose_span(pose, JOINTS));
        hash = nkw_pose_fingerprint(pose_view(pose, JOINTS), hash);
        nkw_skeleton_separate_rotations(&skeleton, pose_view(pose, JOINTS), pose_span(pose, JOINTS));
        hash = nkw_pose_fingerprint(pose_view(pose, JOINTS), hash);
        nkw_mask_from_branch(&skeleton, (size_t)round % 8, random_between(&r, 0.0f, 6.0f), mask_span(mask, JOINTS));
        hash = nkw_fingerprint_floats(mask, NKW_POSE_STRIDE(JOINTS), hash);
        nkw_mask_from_times(times, 0.7f, (nkw_ease_kind)(round % 12), mask_span(mask, JOINTS));
        hash = nkw_fingerprint_floats(mask, NKW_POSE_STRIDE(JOINTS), hash);
    }
    return hash;
}
