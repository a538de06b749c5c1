/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include "simd/select.h"

/*
 * The compiler's run-time keeps what the processor can do, filled in before main. Asking it is a load and a test: there
 * is nothing to initialise here and nothing to keep. All tables give the same bits, so it never shows which was taken.
 */
const nkw_batch *nkw_batch_selected(void)
{
#if defined(NKW_HAVE_AVX512)
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw"))
        return &nkw_batch_avx512;
#endif
#if defined(NKW_HAVE_AVX2)
    if (__builtin_cpu_supports("avx2"))
        return &nkw_batch_avx2;
#endif
    return &nkw_batch_generic;
}
