/* SPDX-License-Identifier: MIT */
/**
 * @file
 * nakawari: interpolation of key frames. This header includes core.h and all kits, subject by subject. What is marked
 * with a star is core.
 */
#ifndef NAKAWARI_NAKAWARI_H
#define NAKAWARI_NAKAWARI_H

#include "core.h"

/* Math: numbers, vectors, quaternions, matrices, Euler angles, transforms. */
#include "base.h" /* * results and their texts, versions, inlining */
#include "types.h" /* * vectors, quaternions, matrices, transforms, component arrays */
#include "scalar.h" /* * lerp, elementary functions, angles, periods */
#include "vec.h" /* * vectors */
#include "quat.h" /* * quaternions as rotations */
#include "mat.h" /* * 3x3 and 4x4 matrices */
#include "euler.h" /* * Euler angles in six orders */
#include "axes.h" /* the axes and handedness of other tools */
#include "transform.h" /* * translation, rotation, scale */
#include "arrays.h" /* the small functions over component arrays */
#include "dual.h" /* dual quaternions */
#include "box.h" /* boxes along the axes */

/* Curve: a value at a parameter; the piece of a time. */
#include "curve.h" /* * Hermite, Bezier, B-spline, Catmull-Rom */
#include "handle.h" /* Bezier segments with handles in time */
#include "ease.h" /* easing: Penner, CSS */
#include "orient.h" /* * slerp, nlerp, logarithm and exponential of rotations */
#include "rotation.h" /* splines of rotations: Hermite, squad, TCB, B-spline */
#include "segment.h" /* * from a time to the two keys around it */
#include "spline.h" /* tangents through many keys: TCB, PCHIP, Akima, C2 */
#include "nurbs.h" /* rational B-splines */
#include "polycurve.h" /* paths: length, constant speed, frames, polylines */

/* Motion: what follows a goal. */
#include "spring.h" /* springs and dampers */
#include "inertia.h" /* inertialisation and dead blending */

/* Track: a value at a time. */
#include "playback.h" /* * from the running time to the time in a clip; events */
#include "timecode.h" /* frames and ticks */
#include "keyframe.h" /* * key frames of position and orientation */
#include "track.h" /* * the keys of one property */
#include "fcurve.h" /* keys with handles, behaviour outside the keys */
#include "dialect.h" /* the curves of other tools */
#include "edit.h" /* tracks that are cut, retimed, joined, closed */
#include "fit.h" /* few cubic keys for many samples */
#include "reduce.h" /* fewer keys within a tolerance */

/* Pose: all joints at one time. */
#include "pose.h" /* * the transforms of all joints */
#include "skeleton.h" /* * hierarchies, model matrices */
#include "blend.h" /* * blends, layers, masks, additive poses, mirrors */
#include "mirror.h" /* poses mirrored through the rest pose, partners by names */
#include "layer.h" /* masks that rise along a branch, blend times of joints, rotations in model space */
#include "transition.h" /* from one pose to another: inertialisation of poses */
#include "root.h" /* root motion */
#include "limit.h" /* limits of joints: cones, ellipses, twist */
#include "ik.h" /* limbs of two bones, aim, chains */
#include "foot.h" /* contacts and locked feet */
#include "retarget.h" /* poses on other skeletons */
#include "blendspace.h" /* weights of a blend space */

/* Clip: many tracks in one block. */
#include "clip.h" /* * many tracks in one block */
#include "clip_reduce.h" /* small clips within a tolerance in model space */
#include "clip_motion.h" /* a few joints of a clip, velocities of clips and through blends */
#include "records.h" /* poses of records of nkw_trs, as engines store them */
#include "mixer.h" /* * clips that play together: times, fades, layers, events */
#include "fingerprint.h" /* 64 bits of a pose, a clip, a mixer: where two machines part */
#include "chunk.h" /* chunks of a clip that arrive later */

/* Skin: palettes from model matrices, skinned vertices, parts of meshes. */
#include "palette.h" /* * joint matrices for skinning and shaders */
#include "skin.h" /* * skinned vertices */
#include "morph.h" /* morph targets */
#include "character.h" /* skeleton, clips, skins and vertices in one block */
#include "bounds.h" /* boxes around skinned meshes */
#include "partition.h" /* meshes cut into parts of few joints */
#include "mesh.h" /* meshes prepared: normals, tangents, facing */
#include "crowd.h" /* sixteen characters at once */

#endif
