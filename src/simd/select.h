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

/* The table for the processor that runs this. */
const nkw_batch *nkw_batch_selected(void);

#endif
