/* SPDX-License-Identifier: MIT */
/* The loops of vec.c; batch/isa.h explains the list. */
#ifndef NAKAWARI_BATCH_VEC_H
#define NAKAWARI_BATCH_VEC_H

#include <nakawari/types.h>

#include "batch/isa.h"

/* clang-format off */
#define NKW_LOOPS_VEC(X) \
    X(nkw_vec3_normalize_n, (nkw_vec3_view a, nkw_vec3_span out, size_t n), (a, out, n), n) \
    X(nkw_vec3_lerp_n, (nkw_vec3_view a, nkw_vec3_view b, const float *t, nkw_vec3_span out, size_t n), (a, b, t, out, n), n) \
    X(nkw_vec3_lerp_at_n, (nkw_vec3_view a, nkw_vec3_view b, float t, nkw_vec3_span out, size_t n), (a, b, t, out, n), n) \
    X(nkw_vec3_unpack_n, (const nkw_vec3 *in, nkw_vec3_span out, size_t n), (in, out, n), n) \
    X(nkw_vec3_pack_n, (nkw_vec3_view in, nkw_vec3 *out, size_t n), (in, out, n), n)
/* clang-format on */

NKW_LOOPS_VEC(NKW_DECLARE)

#endif
