/* SPDX-License-Identifier: MIT */
#ifndef NAKAWARI_LANE_SKELETON_H
#define NAKAWARI_LANE_SKELETON_H

#include "strict.h"

#include <stddef.h>
#include <stdint.h>

/*
 * The parent of joint j, which has one only if it is less than j. NKW_NO_JOINT, and every negative number, is at least
 * 2^31 here.
 */
static inline size_t skeleton_parent(const int32_t *parents, size_t j)
{
    return (size_t)(uint32_t)parents[j];
}

#endif
