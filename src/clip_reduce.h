/* SPDX-License-Identifier: MIT */
/* The errors of a reduced clip in model space, in units of the tolerance of each joint. */
#ifndef NAKAWARI_CLIP_REDUCE_H
#define NAKAWARI_CLIP_REDUCE_H

#include <nakawari/clip.h>

/* A sampled pose, its floats, and the model matrices of its joints: three columns and the position, 12 numbers each. */
typedef struct reduce_pose {
    float *pose, *floats;
    double *models;
} reduce_pose;

/*
 * reach        of each joint: by how much a radian of it moves a point of a joint below it, in tolerances
 * tight        of each joint: 1 / the smallest tolerance of the joints below it, itself included
 * scale        of each joint: how much longer its parent's model matrix makes a vector, at most
 * errors       of each joint, in its tolerances; then of each track of floats
 * distance     the largest of all joints; floats, of all floats
 */
typedef struct reduce_errors {
    double *reach, *tight, *scale, *errors;
    double distance, floats;
    reduce_pose want, got;
} reduce_errors;

static inline size_t reduce_parent(const nkw_clip_reduction *r, size_t joint)
{
    return r->parents && r->parents[joint] >= 0 && (size_t)r->parents[joint] < joint ? (size_t)r->parents[joint]
                                                                                     : joint;
}

/* 1 / tolerance; a tolerance of 0 is as small as numbers allow. */
static inline double reduce_tightness(float tolerance)
{
    return tolerance > 0.0f ? 1.0 / (double)tolerance : 1e300;
}

/* Sets reach, tight and scale, from the poses of the tracks of the source. */
void nkwi_reduce_reach(const nkw_clip_source *source, const nkw_clip_reduction *r, reduce_errors *e);

/* Sets errors, distance and floats, at the times of all keys and in the middle between two keys. */
void nkwi_reduce_errors(const nkw_clip_source *source, const nkw_clip_reduction *r, const nkw_clip *clip,
                        reduce_errors *e);

#endif
