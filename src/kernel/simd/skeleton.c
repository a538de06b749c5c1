/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include "batch/skeleton.h"
#include "simd/dispatch.h"

NKW_LOOPS_SKELETON(NKW_DISPATCH)
