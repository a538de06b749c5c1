/* SPDX-License-Identifier: MIT */
/*
 * What reductions of clips share: the errors in model space, in units of the tolerance of each joint, and the search by
 * trials for the share of each joint.
 *
 * The share of a joint is the distance by which the reduction of one of its tracks may move a point in model space, in
 * units of the tolerance. A trial reduces all tracks with these shares and measures the error of each joint, in units
 * of its tolerance. With E, the largest error of the joints below a joint, itself included, divided by AIM, the next
 * share is
 *
 *     E > 1    share E^(-3/4)
 *     E <= 1   share min(3/2, E^(-1/2))
 *
 * So each chain of joints soon reaches the tolerance somewhere. The smallest result within the tolerance is made again
 * at the end. If there is none, shares of joints beyond it are reduced until one is. Otherwise all shares are 0.
 *
 * Of a long clip the first trials are of parts of it, windows; a few trials of the whole clip then correct the shares.
 */
#ifndef NAKAWARI_CLIP_REDUCTION_H
#define NAKAWARI_CLIP_REDUCTION_H

#include <nakawari/clip_reduce.h>

#include "lane/mat.h"
#include "lane/skeleton.h"

/* A sampled pose, its floats, the model matrices of its joints, and the segments in which its tracks were found. */
typedef struct reduce_pose {
    float *pose, *floats;
    uint32_t *cursors;
    lane_f64_affine *models;
} reduce_pose;

/*
 * reach        of each joint: by how much a radian of it moves a point of a joint below it, in tolerances
 * tight        of each joint: 1 / the smallest tolerance of the joints below it, itself included
 * scale        of each joint: how much longer its parent's model matrix makes a vector, at most
 * axes         of each joint: the half axes of the points around it, in its space: its distance, divided by the largest
 *              length of each column of its model matrix; 3 numbers
 * errors       of each joint, in its tolerances; then of each track of floats
 * distance     the largest of all joints; floats, of all floats
 * from, to     the times that are measured
 */
typedef struct reduce_errors {
    double *reach, *tight, *scale, *axes, *errors;
    double distance, floats;
    float from, to;
    reduce_pose want, got;
} reduce_errors;

/* The parent of a joint; of a root, the joint. */
static inline size_t reduce_parent(const nkw_clip_reduction *r, size_t joint)
{
    size_t parent = r->parents ? skeleton_parent(r->parents, joint) : joint;
    return parent < joint ? parent : joint;
}

/* 1 / tolerance; a tolerance of 0 is as small as numbers allow. */
static inline double reduce_tightness(float tolerance)
{
    return tolerance > 0.0f ? 1.0 / (double)tolerance : 1e300;
}

/* A reduced clip, or reduced tracks: exactly one of both. */
typedef struct reduce_made {
    const nkw_clip *clip;
    const nkw_clip_source *tracks;
    int parts; /* of each segment between two keys: errors are measured where they begin */
} reduce_made;

/* Sets reach, tight, scale and axes, from the poses of the tracks of the source. */
void nkwi_reduce_reach(const nkw_clip_source *source, const nkw_clip_reduction *r, reduce_errors *e);

/* No errors yet, at all times. */
void nkwi_reduce_no_errors(const nkw_clip_source *source, reduce_errors *e);

/* Adds to errors, distance and floats those at the times of all keys of the source and between them. */
void nkwi_reduce_errors(const nkw_clip_source *source, const nkw_clip_reduction *r, const reduce_made *made,
                        reduce_errors *e);

/*
 * shares   of joints, then of tracks of floats; of this trial and of the smallest result within the tolerance
 * sizes    of each track of scales: the smallest, not 0, of the largest magnitudes of its components
 * part     what is made and measured: the source, or its `slices` in a window, tracks in the same order
 */
typedef struct reduce_trials {
    const nkw_clip_source *source;
    const nkw_clip_reduction *reduction;
    nkw_clip_source part;
    nkw_clip_track *slices;
    size_t windows; /* of a trial; 0: the whole source */
    double *shares, *best, *worst, *sizes;
    reduce_errors errors;
    double share; /* the largest of the errors */
    size_t size; /* of what was made */
    double
        limit; /* the largest share that is accepted: less than 1 where errors between measured times may be larger */
    /* Reduces the part with the current shares and sets what was made, which is then measured, and its size. */
    nkw_result (*make)(void *user, reduce_made *made, size_t *size, size_t *bad);
    void *user;
} reduce_trials;

/* Takes n numbers of `size` bytes of the working memory. */
static inline void *reduce_take(double **work, size_t n, size_t size)
{
    void *at = *work;
    *work += (n * size + sizeof **work - 1) / sizeof **work;
    return at;
}

/* Checks the reduction, and the memory by NKW_CLIP_REDUCE_WORK. */
nkw_result nkwi_reduce_check(const nkw_clip_source *source, const nkw_clip_reduction *reduction);
int nkwi_reduce_has_work(const nkw_clip_source *source, nkw_work work);

/* Takes the memory of the arrays, and sets the first shares. */
void nkwi_reduce_begin(reduce_trials *t, double **work);

/* The change of a value by which the share of its joint is used: a distance, radians, or of floats. */
float nkwi_reduce_step(const reduce_trials *t, size_t track);

/* Makes and measures the result of the current shares: sets errors, share and size. */
nkw_result nkwi_reduce_try(reduce_trials *t, size_t *bad);

/* The trials; makes the smallest result within the tolerance again at the end. */
nkw_result nkwi_reduce_search(reduce_trials *t, size_t *bad);

#endif
