/* SPDX-License-Identifier: MIT */
/* The loops of transform.c; batch/isa.h explains the list. */
#ifndef NAKAWARI_BATCH_TRANSFORM_H
#define NAKAWARI_BATCH_TRANSFORM_H

#include <nakawari/types.h>

#include "batch/isa.h"

/* clang-format off */
#define NKW_LOOPS_TRANSFORM(X) \
    X(nkw_mat4_from_trs_n, (nkw_trs_view trs, nkw_mat4_span out, size_t n), (trs, out, n), n)
/* clang-format on */

NKW_LOOPS_TRANSFORM(NKW_DECLARE)

#endif
