/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/skeleton.h>

#include "sort.h"

/* The most joints: depths are numbers of 16 bits. */
#define MOST_JOINTS 65536u

/*
 * The depths of a joint and of all above it, up to a root or to a joint whose depth is known already (UINT16_MAX is
 * not; a joint at that depth is no parent). Returns 0 where there is no end.
 */
static int find_depth(const int32_t *parents, size_t joint_count, size_t joint, uint16_t *depths)
{
    size_t steps = 0, top = joint;
    for (; parents[top] >= 0 && depths[top] == UINT16_MAX && steps <= joint_count; steps++)
        top = (size_t)parents[top];
    if (steps > joint_count)
        return 0;
    size_t depth = steps + (parents[top] < 0 ? 0 : depths[top]);
    for (; joint != top; joint = (size_t)parents[joint])
        depths[joint] = (uint16_t)depth--;
    depths[top] = (uint16_t)depth;
    return 1;
}

static nkw_result find_depths(const int32_t *parents, size_t joint_count, uint16_t *depths, size_t *offender)
{
    *offender = MOST_JOINTS;
    if (joint_count > MOST_JOINTS)
        return NKW_OUT_OF_RANGE;
    for (*offender = 0; *offender < joint_count; ++*offender) {
        if (parents[*offender] < -1 || parents[*offender] >= (int32_t)joint_count)
            return NKW_OUT_OF_RANGE;
        depths[*offender] = UINT16_MAX;
    }
    for (*offender = 0; *offender < joint_count; ++*offender)
        if (!find_depth(parents, joint_count, *offender, depths))
            return NKW_NOT_A_TREE;
    *offender = 0;
    return NKW_OK;
}

/* By depth, then by index. */
static int before_by_depth(const void *context, uint32_t a, uint32_t b)
{
    const uint16_t *depths = context;
    return depths[a] != depths[b] ? depths[a] < depths[b] : a < b;
}

nkw_result nkw_skeleton_depths(const nkw_skeleton *skeleton, uint16_t *depths, uint32_t *order, size_t *bad)
{
    size_t offender, joint_count = skeleton->joint_count;
    nkw_result result = find_depths(skeleton->parents, joint_count, depths, &offender);
    if (bad)
        *bad = offender;
    if (result != NKW_OK || !order)
        return result;
    for (size_t j = 0; j < joint_count; j++)
        order[j] = (uint32_t)j;
    sort_indices(order, joint_count, before_by_depth, depths);
    return NKW_OK;
}
