/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include "batch/skin.h"
#include "simd/dispatch.h"

NKW_LOOPS_SKIN(NKW_DISPATCH)
