/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/arrays.h>
#include <nakawari/orient.h>

#include "batch/orient.h"
#include "simd/dispatch.h"

NKW_LOOPS_ORIENT(NKW_DISPATCH)
