/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include "batch/morph.h"
#include "simd/dispatch.h"

NKW_LOOPS_MORPH(NKW_DISPATCH)
