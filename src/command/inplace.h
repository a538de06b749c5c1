/* SPDX-License-Identifier: MIT */
/** @file Root motion taken out of a clip: the character remains in its place. */
#ifndef INPLACE_H
#define INPLACE_H

#include <nakawari/root.h>

#include "model.h"

/** The parts of a text: plane, height, yaw, rotation, separated by commas. Returns 0 if it names another. */
int inplace_parts(const char *text, unsigned *parts);

/**
 * Removes the motion from the joint of that name in a clip of the model; NULL: from the first joint whose translation
 * is animated. Plane, height and yaw are those of the model's space, whatever the joint's parents are. Its tracks become
 * LINEAR, with keys at the key times of both. Returns 0 and reports if there is no such joint, if a track is
 * CUBICSPLINE, or without memory.
 */
int inplace_clip(model *m, size_t animation, const char *joint, const nkw_root_rule *rule);

#endif
