/* SPDX-License-Identifier: MIT */
/*
 * NKW_DISPATCH defines the function `name` of a list of loops (batch/isa.h). The function calls the build of the loop
 * for the instruction set that nkwi_isa_for returns, or the baseline if no other is built.
 *
 * Each stem has a separate file, so that a program links only the loops of the stems that it calls.
 */
#ifndef NAKAWARI_SIMD_DISPATCH_H
#define NAKAWARI_SIMD_DISPATCH_H

#include "batch/isa.h"
#include "simd/processor.h"

/* Tests define NKW_ISA_FOR to choose the instruction set and to count calls. */
#ifndef NKW_ISA_FOR
#define NKW_ISA_FOR(name, n) nkwi_isa_for(n)
#endif

#if defined(NKW_HAVE_AVX2)
#define NKW_WITH_AVX2(...) __VA_ARGS__
#else
#define NKW_WITH_AVX2(...)
#endif
#if defined(NKW_HAVE_AVX512)
#define NKW_WITH_AVX512(...) __VA_ARGS__
#else
#define NKW_WITH_AVX512(...)
#endif

#if defined(NKW_HAVE_AVX2) || defined(NKW_HAVE_AVX512)
#define NKW_DISPATCH(name, parameters, arguments, n)                                                                   \
    NKW_LOCAL void name##_generic parameters;                                                                          \
    NKW_WITH_AVX2(NKW_LOCAL void name##_avx2 parameters;)                                                              \
    NKW_WITH_AVX512(NKW_LOCAL void name##_avx512 parameters;)                                                          \
    NKW_APART void name parameters                                                                                     \
    {                                                                                                                  \
        const nkwi_isa isa = NKW_ISA_FOR(name, n);                                                                     \
        NKW_WITH_AVX512(if (isa == NKWI_ISA_AVX512) name##_avx512 arguments; else)                                     \
        NKW_WITH_AVX2(if (isa == NKWI_ISA_AVX2) name##_avx2 arguments; else)                                           \
        name##_generic arguments;                                                                                      \
    }
#else
#define NKW_DISPATCH(name, parameters, arguments, n)                                                                   \
    NKW_LOCAL void name##_generic parameters;                                                                          \
    NKW_APART void name parameters                                                                                     \
    {                                                                                                                  \
        (void)NKW_ISA_FOR(name, n);                                                                                    \
        name##_generic arguments;                                                                                      \
    }
#endif

#endif
