/* SPDX-License-Identifier: MIT */
/*
 * The functions of all loops (src/kernel/batch/isa.h), in place of the library's in src/kernel/simd: by the instruction set
 * `loop_isa`, and counted in `loop_runs`. For one file of a program that is linked with the static library.
 */
#ifndef NAKAWARI_LOOPS_H
#define NAKAWARI_LOOPS_H

#include "loop_list.h"

static struct {
#define LOOP_RUNS(name, parameters, arguments, n) size_t name;
    LOOPS(LOOP_RUNS)
#undef LOOP_RUNS
} loop_runs;

#define NKW_ISA_FOR(name, n) (loop_runs.name++, loop_isa_for(n))
#include "simd/dispatch.h"

/* This one, or if loop_by_length is set, the library's choice, but at most this one. */
static nkwi_isa loop_isa = NKWI_ISA_GENERIC;
static int loop_by_length;

static inline nkwi_isa loop_isa_for(size_t n)
{
    const nkwi_isa chosen = nkwi_isa_for(n);
    return loop_by_length && chosen < loop_isa ? chosen : loop_isa;
}

LOOPS(NKW_DISPATCH)

#endif
