/* SPDX-License-Identifier: MIT */
#include "data.h"
#include "hash.h"
#include "random.h"
#include "views.h"

#define JOINTS 21

uint64_t data_pose(void)
{
    random_source r = random_from(1);
    uint64_t hash = HASH_START;
    float pose[NKW_POSE_FLOATS(JOINTS)];
    nkw_trs trs[JOINTS];
    for (int j = 0; j < JOINTS; j++) {
        trs[j].translation = random_vec3(&r, -5, 5);
        trs[j].rotation = random_rotation(&r);
        trs[j].scale = random_vec3(&r, 0.5f, 2);
    }
    nkw_pose_from_trs(trs, pose_span(pose, JOINTS));
    nkw_pose_set(pose_span(pose, JOINTS), 3, &trs[7]);
    hash = hash_floats(hash, pose, NKW_POSE_FLOATS(JOINTS));
    nkw_trs_from_pose(pose_view(pose, JOINTS), trs);
    return hash_floats(hash, &trs[0].translation.x, 10 * JOINTS);
}
