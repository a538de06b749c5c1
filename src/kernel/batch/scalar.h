/* SPDX-License-Identifier: MIT */
/* The loops of scalar.c; batch/isa.h explains the list. */
#ifndef NAKAWARI_BATCH_SCALAR_H
#define NAKAWARI_BATCH_SCALAR_H

#include "batch/isa.h"

/* clang-format off */
#define NKW_LOOPS_SCALAR(X) \
    X(nkw_sincos_n, (const float *angle, float *sine, float *cosine, size_t n), (angle, sine, cosine, n), n)
/* clang-format on */

NKW_LOOPS_SCALAR(NKW_DECLARE)

#endif
