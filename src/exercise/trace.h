/* SPDX-License-Identifier: MIT */
/** @file The calculation of one matrix, printed so that it can be followed with pencil and paper. */
#ifndef TRACE_H
#define TRACE_H

#include <stdio.h>

#include "scene.h"

void trace_print(FILE *f, const scene *s, float time, nkw_position_method position,
                 nkw_orientation_method orientation);

#endif
