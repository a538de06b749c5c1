/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/arrays.h>
#include <nakawari/vec.h>

#include "batch/vec.h"
#include "simd/dispatch.h"

NKW_LOOPS_VEC(NKW_DISPATCH)
