/* SPDX-License-Identifier: MIT */
/* The loops of morph.c; batch/isa.h explains the list. */
#ifndef NAKAWARI_BATCH_MORPH_H
#define NAKAWARI_BATCH_MORPH_H

#include "batch/isa.h"

/* clang-format off */
#define NKW_LOOPS_MORPH(X) \
    X(nkwi_morph_add, (const float *deltas, float weight, float *out, size_t n), (deltas, weight, out, n), n)
/* clang-format on */

NKW_LOOPS_MORPH(NKW_DECLARE)

#endif
