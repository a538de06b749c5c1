/* SPDX-License-Identifier: MIT */
/**
 * @file
 * nakawari: interpolation of key frames. This header includes all others, floor by floor.
 */
#ifndef NAKAWARI_NAKAWARI_H
#define NAKAWARI_NAKAWARI_H

/* Floor 0, base: names, results. */
#include "base.h"

/* Floor 1, scalar: arithmetic and elementary functions of one float. */
#include "scalar.h"

/* Floor 2, value: vectors, quaternions, matrices, Euler angles, transforms. */
#include "types.h"
#include "vec.h"
#include "quat.h"
#include "mat.h"
#include "euler.h"
#include "axes.h"
#include "transform.h"
#include "dual.h"

/* Floor 3, curve and orient: curves on numbers, curves on rotations; what follows a goal. */
#include "curve.h"
#include "curve_point.h"
#include "handle.h"
#include "ease.h"
#include "orient.h"
#include "rotation.h"
#include "spring.h"
#include "inertia.h"
#include "limit.h"

/* Floor 4, track: the keys around a time; values, poses and matrices from keys. */
#include "segment.h"
#include "fcurve.h"
#include "spline.h"
#include "nurbs.h"
#include "polycurve.h"
#include "keyframe.h"
#include "track.h"
#include "dialect.h"
#include "edit.h"
#include "fit.h"
#include "playback.h"
#include "timecode.h"
#include "pose.h"
#include "clip.h"
#include "reduce.h"

/* Floor 5, skeleton: hierarchies, blending of poses. */
#include "skeleton.h"
#include "blend.h"
#include "transition.h"
#include "root.h"
#include "ik.h"
#include "foot.h"
#include "retarget.h"
#include "blendspace.h"

/* Floor 6, skin: palettes from model matrices, skinned vertices, parts of meshes. */
#include "palette.h"
#include "skin.h"
#include "morph.h"
#include "bounds.h"
#include "crowd.h"
#include "partition.h"

#endif
