/* SPDX-License-Identifier: MIT */
/*
 * LOOPS lists all loops of the library (src/kernel/batch/isa.h). A program that defines NKW_ISA_FOR(name, n) and expands
 * LOOPS(NKW_DISPATCH) in one of its files replaces the functions of src/kernel/simd: its macro chooses the instruction set. The
 * program links the static library.
 */
#ifndef NAKAWARI_LOOP_LIST_H
#define NAKAWARI_LOOP_LIST_H

#include <stddef.h>

#include "batch/blend.h"
#include "batch/clip.h"
#include "batch/crowd.h"
#include "batch/curve.h"
#include "batch/mat.h"
#include "batch/orient.h"
#include "batch/palette.h"
#include "batch/quat.h"
#include "batch/skeleton.h"
#include "batch/skin.h"
#include "batch/transform.h"
#include "batch/transition.h"
#include "batch/vec.h"

/* clang-format off */
#define LOOPS(X) \
    NKW_LOOPS_BLEND(X) \
    NKW_LOOPS_CLIP(X) \
    NKW_LOOPS_CROWD(X) \
    NKW_LOOPS_CURVE(X) \
    NKW_LOOPS_MAT(X) \
    NKW_LOOPS_ORIENT(X) \
    NKW_LOOPS_PALETTE(X) \
    NKW_LOOPS_QUAT(X) \
    NKW_LOOPS_SKELETON(X) \
    NKW_LOOPS_SKIN(X) \
    NKW_LOOPS_TRANSFORM(X) \
    NKW_LOOPS_TRANSITION(X) \
    NKW_LOOPS_VEC(X)
/* clang-format on */

#endif
