/* SPDX-License-Identifier: MIT */
/* The loops of records.c; batch/isa.h explains the list. */
#ifndef NAKAWARI_BATCH_RECORDS_H
#define NAKAWARI_BATCH_RECORDS_H

#include <nakawari/types.h>

#include "batch/isa.h"

/* clang-format off */
#define NKW_LOOPS_RECORDS(X) \
    X(nkwi_records_blend, (const nkw_trs *a, const nkw_trs *b, float t, int used, nkw_trs *out), (a, b, t, used, out), NKW_WIDEST) \
    X(nkwi_records_blend_each, (const nkw_trs *a, const nkw_trs *b, const float *t, int used, nkw_trs *out), (a, b, t, used, out), NKW_WIDEST)
/* clang-format on */

NKW_LOOPS_RECORDS(NKW_DECLARE)

#endif
