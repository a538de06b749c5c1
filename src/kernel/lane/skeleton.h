/* SPDX-License-Identifier: MIT */
#ifndef NAKAWARI_LANE_SKELETON_H
#define NAKAWARI_LANE_SKELETON_H

#include "strict.h"

#include <stddef.h>
#include <stdint.h>

#include <nakawari/skeleton.h>

/*
 * The parent of joint j, which has one only if it is less than j. NKW_NO_JOINT, and every negative number, is at least
 * 2^31 here.
 */
static inline size_t skeleton_parent(const int32_t *parents, size_t j)
{
    return (size_t)(uint32_t)parents[j];
}

/* The range clamped to the joints; all joints for NULL. */
static inline nkw_range skeleton_range(const nkw_skeleton *skeleton, const nkw_range *range)
{
    nkw_range all = {0, skeleton->joint_count};
    nkw_range r = range ? *range : all;
    r.to = r.to < all.to ? r.to : all.to;
    return r;
}

#endif
