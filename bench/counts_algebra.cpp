/* SPDX-License-Identifier: MIT */
#include "counts_algebra.c"
