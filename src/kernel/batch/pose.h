/* SPDX-License-Identifier: MIT */
/* The loops of pose.c; batch/isa.h explains the list. */
#ifndef NAKAWARI_BATCH_POSE_H
#define NAKAWARI_BATCH_POSE_H

#include <nakawari/types.h>

#include "batch/isa.h"

/* clang-format off */
#define NKW_LOOPS_POSE(X) \
    X(nkwi_pose_from_trs, (const nkw_trs *trs, size_t n, float *rows, size_t stride), (trs, n, rows, stride), NKW_WIDEST) \
    X(nkwi_trs_from_pose, (const float *rows, size_t stride, size_t n, nkw_trs *trs), (rows, stride, n, trs), NKW_WIDEST)
/* clang-format on */

NKW_LOOPS_POSE(NKW_DECLARE)

#endif
