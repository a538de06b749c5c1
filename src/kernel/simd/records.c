/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include "batch/records.h"
#include "simd/dispatch.h"

NKW_LOOPS_RECORDS(NKW_DISPATCH)
