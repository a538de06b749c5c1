/* SPDX-License-Identifier: MIT */
/* The loops of quat.c; batch/isa.h explains the list. */
#ifndef NAKAWARI_BATCH_QUAT_H
#define NAKAWARI_BATCH_QUAT_H

#include <nakawari/types.h>

#include "batch/isa.h"

/* clang-format off */
#define NKW_LOOPS_QUAT(X) \
    X(nkw_quat_mul_n, (nkw_quat_view a, nkw_quat_view b, nkw_quat_span out, size_t n), (a, b, out, n), n) \
    X(nkw_quat_normalize_n, (nkw_quat_view q, nkw_quat_span out, size_t n), (q, out, n), n) \
    X(nkw_quat_rotate_n, (nkw_quat_view q, nkw_vec3_view v, nkw_vec3_span out, size_t n), (q, v, out, n), n) \
    X(nkw_quat_unpack_n, (const nkw_quat *in, nkw_quat_span out, size_t n), (in, out, n), n) \
    X(nkw_quat_pack_n, (nkw_quat_view in, nkw_quat *out, size_t n), (in, out, n), n)
/* clang-format on */

NKW_LOOPS_QUAT(NKW_DECLARE)

#endif
