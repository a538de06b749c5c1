/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include "batch/morph.h"
#include "lane/morph.h"

NKW_LOOPS_MORPH(NKW_DECLARE_LOOP)

/* Components of contiguous vectors, one after the other. */
NKW_LOOP(nkwi_morph_add)(const float *deltas, float weight, float *out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        out[i] = lane_morph(out[i], weight, deltas[i]);
}
