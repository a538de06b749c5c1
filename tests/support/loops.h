/* SPDX-License-Identifier: MIT */
/*
 * The functions of all loops (src/batch/isa.h), in place of the library's in src/simd: by the instruction set
 * `loop_isa`, and counted in `loop_runs`. For one file of a program that is linked with the static library.
 */
#ifndef NAKAWARI_LOOPS_H
#define NAKAWARI_LOOPS_H

#include <stddef.h>

#include "batch/blend.h"
#include "batch/clip.h"
#include "batch/crowd.h"
#include "batch/curve.h"
#include "batch/euler.h"
#include "batch/mat.h"
#include "batch/orient.h"
#include "batch/palette.h"
#include "batch/quat.h"
#include "batch/scalar.h"
#include "batch/skeleton.h"
#include "batch/skin.h"
#include "batch/transform.h"
#include "batch/vec.h"

/* clang-format off */
#define LOOPS(X) \
    NKW_LOOPS_BLEND(X) \
    NKW_LOOPS_CLIP(X) \
    NKW_LOOPS_CROWD(X) \
    NKW_LOOPS_CURVE(X) \
    NKW_LOOPS_EULER(X) \
    NKW_LOOPS_MAT(X) \
    NKW_LOOPS_ORIENT(X) \
    NKW_LOOPS_PALETTE(X) \
    NKW_LOOPS_QUAT(X) \
    NKW_LOOPS_SCALAR(X) \
    NKW_LOOPS_SKELETON(X) \
    NKW_LOOPS_SKIN(X) \
    NKW_LOOPS_TRANSFORM(X) \
    NKW_LOOPS_VEC(X)
/* clang-format on */

static struct {
#define LOOP_RUNS(name, parameters, arguments, n) size_t name;
    LOOPS(LOOP_RUNS)
#undef LOOP_RUNS
} loop_runs;

#define NKW_ISA_FOR(name, n) (loop_runs.name++, loop_isa_for(n))
#include "simd/dispatch.h"

/* At most this one, and the baseline for arrays that are shorter than a vector if loop_by_length is set. */
static nkwi_isa loop_isa = NKWI_ISA_GENERIC;
static int loop_by_length;

static inline nkwi_isa loop_isa_for(size_t n)
{
    return loop_by_length && n < 8 ? NKWI_ISA_GENERIC : loop_isa;
}

LOOPS(NKW_DISPATCH)

#endif
