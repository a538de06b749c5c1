/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/arrays.h>
#include <nakawari/mat.h>

#include "batch/mat.h"
#include "simd/dispatch.h"

NKW_LOOPS_MAT(NKW_DISPATCH)
