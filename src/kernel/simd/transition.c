/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include "batch/transition.h"
#include "simd/dispatch.h"

NKW_LOOPS_TRANSITION(NKW_DISPATCH)
