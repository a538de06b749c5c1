/* SPDX-License-Identifier: MIT */
/** @file A model seen from other axes, and in another unit. */
#ifndef REFRAME_H
#define REFRAME_H

#include <nakawari/axes.h>

#include "model.h"

/**
 * The axes of a text: a tool (gltf, maya, vrm, blender, max, opengl, unity, directx, unreal), or right, up and forward
 * as signed letters, "x,z,-y". Returns 0 if it is neither.
 */
int reframe_axes(const char *text, nkw_axes *axes);

/**
 * Converts nodes, rest poses, meshes, morph targets, inverse bind matrices and all tracks. scale: target units in a
 * unit of the model. Returns 0 without memory, which is reported.
 */
int reframe(model *m, nkw_axes_map map, float scale);

#endif
