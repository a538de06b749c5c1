/* SPDX-License-Identifier: MIT */
/**
 * @file
 * The pictures of a scene. Each picture_ function writes one SVG file and gives 0, errno set, if it could not.
 */
#ifndef PICTURE_H
#define PICTURE_H

#include "scene.h"
#include "draw/space.h"
#include "draw/svg.h"

/** The four position curves over the keys, seen from above: x to the right, z down, as on a map. */
int picture_trajectory_top(const scene *s, const char *path);
/** The four position curves in space, one panel each, with their shadows, through the exercise's camera. */
int picture_trajectory_perspective(const scene *s, const char *path);
/** The object every 0.2 s along the Hermite curve by slerp, through the exercise's camera. */
int picture_frames(const scene *s, const char *path);
/** The keys where they differ most, enlarged: the object by Euler angles and by slerp, and the angle between them. */
int picture_frames_compare(const scene *s, const char *path);
/** Euler angles against slerp where they differ most: the object, the path of its nose, the speed of turning. */
int picture_orientation_compare(const scene *s, const char *path);

/* ---- shared by the pictures ---- */

/** The exercise's field of view, 45 degrees, in radians. */
#define PICTURE_FOV 0.785398163f

/** "key 2 (2 s)" */
const char *picture_key_name(const scene *s, size_t key, char text[SVG_DIGITS]);

/** A place for a key's label: `far` pixels from the key, away from the middle of all keys. */
svg_point picture_outward(const scene *s, const svg_camera *camera, size_t key, float far);

/** The colours of the dart's parts, in one row; or the name of the model in its place. */
void picture_object_legend(svg *out, const scene *s, svg_point at);

#endif
