/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include "batch/crowd.h"
#include "simd/dispatch.h"

NKW_LOOPS_CROWD(NKW_DISPATCH)
