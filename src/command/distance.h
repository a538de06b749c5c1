/* SPDX-License-Identifier: MIT */
/** @file The distance of two matrices of a joint. */
#ifndef DISTANCE_H
#define DISTANCE_H

#include <nakawari/types.h>

/**
 * The largest distance of four points, each moved by a and by b: the joint's origin, and the points at `reach` along
 * its three axes, as long as they are in its space. NaN counts as infinity; equal bytes are at a distance of 0.
 */
double matrix_distance(const nkw_mat4 *a, const nkw_mat4 *b, float reach);

#endif
