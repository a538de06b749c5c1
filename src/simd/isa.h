/* SPDX-License-Identifier: MIT */
/* The instruction sets that this build has loops for. */
#ifndef NAKAWARI_SIMD_ISA_H
#define NAKAWARI_SIMD_ISA_H

#include <stddef.h>

/* In ascending order of their vectors. The baseline is SSE2 on x86-64, NEON on AArch64, simd128 in WebAssembly. */
typedef enum nkwi_isa { NKWI_ISA_GENERIC, NKWI_ISA_AVX2, NKWI_ISA_AVX512 } nkwi_isa;

/*
 * The widest instruction set that this build and this processor have and that n elements fill: an array shorter than a
 * vector would be all remainder. All loops compute the same bits, so the choice never shows.
 *
 * The compiler's run-time library asks the processor before main. Reading its answer is a load and a test, so nothing
 * is initialised or kept here.
 */
static inline nkwi_isa nkwi_isa_for(size_t n)
{
#if defined(NKW_HAVE_AVX512)
    if (n >= 16 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw"))
        return NKWI_ISA_AVX512;
#endif
#if defined(NKW_HAVE_AVX2)
    if (n >= 8 && __builtin_cpu_supports("avx2"))
        return NKWI_ISA_AVX2;
#endif
    (void)n;
    return NKWI_ISA_GENERIC;
}

#endif
