/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Core: from key frames to skinned vertices.
 *
 *     numbers, vectors, quaternions, matrices     scalar vec quat mat euler transform
 *     a value between two keys                    curve orient, segment finds the two keys
 *     a value at a time                           keyframe track playback
 *     all joints at a time                        pose skeleton blend, clip holds the tracks of all
 *     vertices                                    palette skin
 *
 * Every other header is a kit, for one purpose; nakawari.h lists all. docs/reference.md has core on two pages.
 */
#ifndef NAKAWARI_CORE_H
#define NAKAWARI_CORE_H

#include "base.h" /* results and their texts, versions, inlining */
#include "types.h" /* vectors, quaternions, matrices, transforms, component arrays */
#include "scalar.h" /* lerp, elementary functions, angles, periods */
#include "vec.h" /* vectors */
#include "quat.h" /* quaternions as rotations */
#include "mat.h" /* 3x3 and 4x4 matrices */
#include "euler.h" /* Euler angles in six orders */
#include "transform.h" /* translation, rotation, scale */
#include "curve.h" /* Hermite, Bezier, B-spline, Catmull-Rom; their motion */
#include "orient.h" /* slerp, nlerp, logarithm and exponential of rotations */
#include "segment.h" /* from a time to the two keys around it */
#include "keyframe.h" /* key frames of position and orientation */
#include "track.h" /* the keys of one property */
#include "playback.h" /* from the running time to the time in a clip; events */
#include "pose.h" /* the transforms of all joints */
#include "skeleton.h" /* hierarchies, model matrices */
#include "blend.h" /* blends, layers, masks, additive poses, mirrors */
#include "clip.h" /* many tracks in one block */
#include "mixer.h" /* clips that play together: times, fades, layers, events */
#include "palette.h" /* joint matrices for skinning and shaders */
#include "skin.h" /* skinned vertices */

#endif
