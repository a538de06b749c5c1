/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/arrays.h>
#include <nakawari/quat.h>

#include "batch/quat.h"
#include "simd/dispatch.h"

NKW_LOOPS_QUAT(NKW_DISPATCH)
