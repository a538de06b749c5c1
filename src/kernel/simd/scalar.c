/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/scalar.h>

#include "batch/scalar.h"
#include "simd/dispatch.h"

NKW_LOOPS_SCALAR(NKW_DISPATCH)
