/* SPDX-License-Identifier: MIT */
/**
 * @file
 * The lesson's four joints, one above the other, and how they move: key frames, made into tracks, made into a clip.
 */
#ifndef RIG_H
#define RIG_H

#include <nakawari/clip.h>
#include <nakawari/dual.h>
#include <nakawari/pose.h>
#include <nakawari/skeleton.h>

#include "mesh.h"

enum { RIG_JOINTS = 4 };

/** The length of the motion, and when joint 2 is twisted most, seconds. */
#define RIG_END   4.0f
#define RIG_TWIST 2.0f

typedef struct rig {
    nkw_skeleton skeleton;
    nkw_clip *clip; /* owned */
    float foot, spacing; /* the height of joint 0, and how far each joint is above the one before */
    nkw_mat4 inverse_bind[RIG_JOINTS];
} rig;

/** Everything of one moment on the way from keys to joint matrices. */
typedef struct rig_state {
    nkw_mat4 local[RIG_JOINTS], model[RIG_JOINTS], palette[RIG_JOINTS];
} rig_state;

/**
 * A rig as high as the mesh, with a joint at its foot, at one and two thirds, and on top; the vertices are hung on it.
 * Gives NULL, or what is wrong. rig_free is due in either case.
 */
const char *rig_build(rig *r, mesh *m);
void rig_free(rig *r);

/**
 * The share of each joint in a vertex at a height: uniform cubic B-splines over the joints, joint j strongest half way
 * between j and j + 1, where the lesson has weight 1 for it.
 */
void rig_weights(const rig *r, float height, float out[RIG_JOINTS]);

rig_state rig_at(const rig *r, float time);

/** The mesh moved by the joint matrices, blended or as dual quaternions: a position and a normal for each vertex. */
void rig_skin(const rig_state *state, const mesh *m, int dual, nkw_vec3 *positions, nkw_vec3 *normals);

#endif
