/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/arrays.h>
#include <nakawari/curve.h>

#include "batch/curve.h"
#include "simd/dispatch.h"

NKW_LOOPS_CURVE(NKW_DISPATCH)
