/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include "batch/pose.h"
#include "simd/dispatch.h"

NKW_LOOPS_POSE(NKW_DISPATCH)
