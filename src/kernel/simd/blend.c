/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include "batch/blend.h"
#include "simd/dispatch.h"

NKW_LOOPS_BLEND(NKW_DISPATCH)
