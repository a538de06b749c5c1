/* SPDX-License-Identifier: MIT */
/* A test for the loops of each instruction set that this build and this processor have. */
#ifndef NAKAWARI_TESTS_ISAS_H
#define NAKAWARI_TESTS_ISAS_H

#include <stdio.h>

#include "simd/processor.h"

/* Asks the processor, not nkwi_isa_for. Returns the sum of what `run` returns: what failed. */
static inline int run_isas(const char *program, int (*run)(nkwi_isa tested, const char *isa))
{
    int failed = run(NKWI_ISA_GENERIC, "generic");
    (void)program; /* of builds with one instruction set */
#if defined(NKW_HAVE_AVX2)
    if (__builtin_cpu_supports("avx2"))
        failed += run(NKWI_ISA_AVX2, "avx2");
    else
        printf("%s: avx2 skipped, this processor has none\n", program);
#endif
#if defined(NKW_HAVE_AVX512)
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
        __builtin_cpu_supports("avx512bw"))
        failed += run(NKWI_ISA_AVX512, "avx512");
    else
        printf("%s: avx512 skipped, this processor has none\n", program);
#endif
    return failed;
}

#endif
