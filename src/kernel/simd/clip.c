/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include "batch/clip.h"
#include "simd/dispatch.h"

NKW_LOOPS_CLIP(NKW_DISPATCH)
