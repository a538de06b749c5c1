/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include "batch/euler.h"
#include "simd/dispatch.h"

NKW_LOOPS_EULER(NKW_DISPATCH)
