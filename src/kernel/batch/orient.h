/* SPDX-License-Identifier: MIT */
/* The loops of orient.c; batch/isa.h explains the list. */
#ifndef NAKAWARI_BATCH_ORIENT_H
#define NAKAWARI_BATCH_ORIENT_H

#include <nakawari/types.h>

#include "batch/isa.h"

/* clang-format off */
#define NKW_LOOPS_ORIENT(X) \
    X(nkw_quat_nlerp_n, (nkw_quat_view a, nkw_quat_view b, const float *t, nkw_quat_span out, size_t n), (a, b, t, out, n), n) \
    X(nkw_quat_nlerp_at_n, (nkw_quat_view a, nkw_quat_view b, float t, nkw_quat_span out, size_t n), (a, b, t, out, n), n) \
    X(nkw_quat_slerp_n, (nkw_quat_view a, nkw_quat_view b, const float *t, nkw_quat_span out, size_t n), (a, b, t, out, n), n) \
    X(nkw_quat_slerp_at_n, (nkw_quat_view a, nkw_quat_view b, float t, nkw_quat_span out, size_t n), (a, b, t, out, n), n)
/* clang-format on */

NKW_LOOPS_ORIENT(NKW_DECLARE)

#endif
