/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include "simd/isa.h"

/*
 * The compiler's run-time library asks the processor before main. Reading its answer is a load and a test, so nothing
 * is initialised or kept here.
 */
nkwi_isa nkwi_isa_for(size_t n)
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
