/* SPDX-License-Identifier: MIT */
/**
 * @file
 * nakawari: interpolation of key frames. This header includes all others, floor by floor.
 */
#ifndef NAKAWARI_NAKAWARI_H
#define NAKAWARI_NAKAWARI_H

/* Floor 0, base: names, results. */
#include "base.h" /* results and their texts, versions, inlining */

/* Floor 1, scalar: arithmetic and elementary functions of one float. */
#include "scalar.h" /* lerp, elementary functions, angles, periods */

/* Floor 2, value: vectors, quaternions, matrices, Euler angles, transforms. */
#include "types.h" /* vectors, quaternions, matrices, transforms, component arrays */
#include "vec.h" /* vectors */
#include "quat.h" /* quaternions as rotations */
#include "mat.h" /* 3x3 and 4x4 matrices */
#include "euler.h" /* Euler angles in six orders */
#include "axes.h" /* the axes and handedness of other tools */
#include "transform.h" /* translation, rotation, scale */
#include "dual.h" /* dual quaternions */
#include "box.h" /* boxes along the axes */

/* Floor 3, curve and orient: curves on numbers, curves on rotations; what follows a goal. */
#include "curve.h" /* Hermite, Bezier, B-spline, Catmull-Rom */
#include "curve_point.h" /* value, velocity and acceleration of a cubic; quintic Hermite */
#include "handle.h" /* Bezier segments with handles in time */
#include "ease.h" /* easing: Penner, CSS */
#include "orient.h" /* slerp, nlerp, logarithm and exponential of rotations */
#include "rotation.h" /* splines of rotations: Hermite, squad, TCB, B-spline */
#include "spring.h" /* springs and dampers */
#include "inertia.h" /* inertialisation and dead blending */
#include "limit.h" /* limits of joints: cones, ellipses, twist */

/* Floor 4, track: the keys around a time; values, poses and matrices from keys. */
#include "segment.h" /* from a time to the two keys around it */
#include "fcurve.h" /* keys with handles, behaviour outside the keys */
#include "spline.h" /* tangents through many keys: TCB, PCHIP, Akima, C2 */
#include "nurbs.h" /* rational B-splines */
#include "polycurve.h" /* paths: length, constant speed, frames, polylines */
#include "keyframe.h" /* key frames of position and orientation */
#include "track.h" /* the keys of one property */
#include "dialect.h" /* the curves of other tools */
#include "edit.h" /* tracks that are cut, retimed, joined, closed */
#include "fit.h" /* few cubic keys for many samples */
#include "playback.h" /* from the running time to the time in a clip; events */
#include "timecode.h" /* frames and ticks */
#include "pose.h" /* the transforms of all joints */
#include "clip.h" /* many tracks in one block */
#include "reduce.h" /* fewer keys within a tolerance */
#include "clip_reduce.h" /* small clips within a tolerance in model space */

/* Floor 5, skeleton: hierarchies, blending of poses. */
#include "skeleton.h" /* hierarchies, model matrices */
#include "blend.h" /* blends, layers, masks, additive poses, mirrors */
#include "transition.h" /* from one pose to another: inertialisation of poses */
#include "root.h" /* root motion */
#include "ik.h" /* limbs of two bones, aim, chains */
#include "foot.h" /* contacts and locked feet */
#include "retarget.h" /* poses on other skeletons */
#include "blendspace.h" /* weights of a blend space */

/* Floor 6, skin: palettes from model matrices, skinned vertices, parts of meshes. */
#include "palette.h" /* joint matrices for skinning and shaders */
#include "skin.h" /* skinned vertices */
#include "morph.h" /* morph targets */
#include "bounds.h" /* boxes around skinned meshes */
#include "crowd.h" /* sixteen characters at once */
#include "partition.h" /* meshes cut into parts of few joints */

#endif
