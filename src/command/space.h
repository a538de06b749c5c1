/* SPDX-License-Identifier: MIT */
/** @file The axes and the unit of a file, and their conversion to those of glTF. */
#ifndef SPACE_H
#define SPACE_H

#include <stdio.h>

#include "command.h"

/** Metres of a unit: m, cm, mm, km, in, ft, yd; 0 for keep. Returns 0 for any other text. */
int space_unit(const char *text, float *metres);

/** Whether a file states its axes. */
int space_has_axes(const nkw_document *d);

/** The direction upwards, in the axes of the file; y, as in glTF, of one that states none. */
nkw_vec3 space_up(const nkw_document *d);

/** The letters of an axis: "x", "-z". */
const char *space_axis(nkw_axis axis);

/** "axes up z, forward -y, right -x; a unit is 0.01 m", as far as the file states them. Returns 0 if it states none. */
int space_print(FILE *out, const nkw_document *d);

#endif
