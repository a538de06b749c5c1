/* SPDX-License-Identifier: MIT */
/* The instruction sets for which this build has loops, and the choice at run time. */
#ifndef NAKAWARI_SIMD_PROCESSOR_H
#define NAKAWARI_SIMD_PROCESSOR_H

#include <stddef.h>

/* A library for several architectures is compiled once for each, with the same macros. */
#if !(defined(__x86_64__) || defined(_M_X64))
#undef NKW_HAVE_AVX2
#undef NKW_HAVE_AVX512
#endif

/* In ascending order of vector width. The baseline is SSE2 on x86-64, NEON on AArch64, simd128 in WebAssembly. */
typedef enum nkwi_isa { NKWI_ISA_GENERIC, NKWI_ISA_AVX2, NKWI_ISA_AVX512 } nkwi_isa;

/*
 * Returns the widest instruction set of this build and this processor whose vector has at most n elements: a shorter
 * array would be remainder only. All builds of a loop compute the same bits, so the choice does not change results.
 *
 * The run-time library of the compiler detects the processor before main. Each query is a load and a test; this library
 * stores no state.
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
