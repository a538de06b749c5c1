/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/arrays.h>
#include <nakawari/transform.h>

#include "batch/transform.h"
#include "simd/dispatch.h"

NKW_LOOPS_TRANSFORM(NKW_DISPATCH)
