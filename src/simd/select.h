/* SPDX-License-Identifier: MIT */
/* The tables that this build has. One line for each instruction set besides the baseline. */
#ifndef NAKAWARI_SIMD_SELECT_H
#define NAKAWARI_SIMD_SELECT_H

#include "batch/table.h"

/* The baseline of the target: SSE2 on x86-64, NEON on AArch64, simd128 on WebAssembly where it is switched on. */
extern const nkw_batch nkw_batch_generic;
#if defined(NKW_HAVE_AVX2)
extern const nkw_batch nkw_batch_avx2;
#endif
#if defined(NKW_HAVE_AVX512)
extern const nkw_batch nkw_batch_avx512;
#endif

/*
 * The widest loops that this processor has and that n elements fill: an array shorter than a vector would be a tail all
 * over. The compiler's run-time keeps what the processor can do, filled in before main. Asking it is a load and a test:
 * there is nothing to initialise here and nothing to keep. All tables give the same bits, so it never shows which was
 * taken.
 */
static inline const nkw_batch *nkw_batch_for(size_t n)
{
#if defined(NKW_HAVE_AVX512)
    if (n >= 16 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw"))
        return &nkw_batch_avx512;
#endif
#if defined(NKW_HAVE_AVX2)
    if (n >= 8 && __builtin_cpu_supports("avx2"))
        return &nkw_batch_avx2;
#endif
    (void)n;
    return &nkw_batch_generic;
}

/*
 * The library's own functions take their loops from here, where a test may put others in their place: the widest of
 * all, for arrays that are long or whole blocks, and those for n elements.
 */
const nkw_batch *nkw_batch_selected(void);
const nkw_batch *nkw_batch_selected_for(size_t n);

#endif
