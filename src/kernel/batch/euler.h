/* SPDX-License-Identifier: MIT */
/* The loops of euler.c; batch/isa.h explains the list. */
#ifndef NAKAWARI_BATCH_EULER_H
#define NAKAWARI_BATCH_EULER_H

#include <nakawari/euler.h>

#include "batch/isa.h"

/* clang-format off */
#define NKW_LOOPS_EULER(X) \
    X(nkw_quat_from_euler_n, (nkw_vec3_view angles, nkw_euler_order order, nkw_quat_span out, size_t n), (angles, order, out, n), n)
/* clang-format on */

NKW_LOOPS_EULER(NKW_DECLARE)

#endif
