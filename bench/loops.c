/* SPDX-License-Identifier: MIT */
/*
 * The loops of the library by the instruction set of the build that is measured, BENCH_LOOPS, and not by the widest of
 * the processor. Arrays that are shorter than a vector use a narrower one, as the library chooses.
 */
#include "simd/processor.h"

static inline nkwi_isa isa_for(size_t n)
{
    const nkwi_isa chosen = nkwi_isa_for(n);
    return chosen < BENCH_LOOPS ? chosen : BENCH_LOOPS;
}

#define NKW_ISA_FOR(name, n) isa_for(n)
#include "loop_list.h"
#include "simd/dispatch.h"

LOOPS(NKW_DISPATCH)
