/* SPDX-License-Identifier: MIT */
/* The unit sphere, on which directions are drawn. */
#ifndef NAKAWARI_EXAMPLES_SPHERE_H
#define NAKAWARI_EXAMPLES_SPHERE_H

#include "svg.h"

/** Points of a smooth line: one more than this many pieces. */
enum { SPHERE_STEPS = 96 };

/** A ball of radius 1 with meridians and parallels, 30 degrees apart. */
void sphere_ball(svg *s, const svg_camera *camera);
/** A line in space about the origin, of up to 4 SPHERE_STEPS pieces: in full on the eye's side, faint behind. */
void sphere_line(svg *s, const svg_camera *camera, const nkw_vec3 *points, size_t count, svg_paint paint);

#endif
