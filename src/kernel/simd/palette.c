/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include "batch/palette.h"
#include "simd/dispatch.h"

NKW_LOOPS_PALETTE(NKW_DISPATCH)
