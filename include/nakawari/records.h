/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Poses of records: a pose is an array of nkw_trs, 40 bytes for each joint, as many engines store it. These functions
 * read and write such poses as they are.
 *
 * Each has the arguments, the results and the bits of its function on component arrays: what pose.h, blend.h, clip.h
 * and skeleton.h state holds here too, weights above 1 and below 0 included.
 *
 *     nkw_records_blend                  nkw_pose_blend
 *     nkw_records_layers_blend           nkw_pose_layers_blend
 *     nkw_records_additive_build         nkw_pose_additive_build
 *     nkw_records_additive_apply         nkw_pose_additive_apply
 *     nkw_clip_sample_records            nkw_clip_sample
 *     nkw_skeleton_models_from_records   nkw_skeleton_models_from_pose
 *
 * The model matrices are those of a palette (palette.h). nkw_pose_from_trs and nkw_trs_from_pose convert a pose for all
 * other functions. Masks are those of blend.h, padded as one array of a pose.
 *
 * All poses and masks of a call have the same joint_count; otherwise the result is NKW_MISMATCHED and nothing is
 * written. Records need the alignment of float. `out` may be one of the input poses; otherwise it must not overlap them.
 */
#ifndef NAKAWARI_RECORDS_H
#define NAKAWARI_RECORDS_H

#include <stdint.h>

#include "blend.h"
#include "clip.h"
#include "skeleton.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A pose of records to read: joint_count transforms. */
typedef struct nkw_records_view {
    const nkw_trs *data;
    size_t joint_count;
} nkw_records_view;
NKW_SIZE(nkw_records_view, 16, 8);
/** A pose of records to write. */
typedef struct nkw_records_span {
    nkw_trs *data;
    size_t joint_count;
} nkw_records_span;
NKW_SIZE(nkw_records_span, 16, 8);

/**
 * nkw_pose_blend: from pose a to pose b by t times the mask. t is any: above 1 and below 0 it extrapolates, NaN counts
 * as 0.
 *
 * Stack  at most 8 KiB.
 */
NKW_API nkw_result nkw_records_blend(nkw_records_view a, nkw_records_view b, float t, nkw_mask_view mask,
                                     nkw_records_span out);

/** A pose that takes part in a blend of many. */
typedef struct nkw_records_layer {
    nkw_records_view pose;
    float weight; /**< of nkw_pose_layer: at least 0, the sum may be any */
    nkw_mask_view mask; /**< the weight of a joint is weight * mask */
} nkw_records_layer;
NKW_SIZE(nkw_records_layer, 40, 20);

/** The bytes of working memory of nkw_records_layers_blend: 128 joints of each layer and of the result. */
#define NKW_RECORDS_LAYERS_WORK(layer_count) (5184 * ((layer_count) + 1))

/**
 * nkw_pose_layers_blend: the weighted mean of any number of poses, over the rest pose.
 *
 * weights    negative and NaN count as 0, above 2^60 as 2^60; a sum above 1 is divided by itself, a sum below the
 *            threshold is completed by the rest pose
 * threshold  0.1 is usual
 * work       NKW_RECORDS_LAYERS_WORK(layer_count) bytes
 * Returns    NKW_TOO_SMALL for too little working memory; nothing is then written
 *
 * Stack  at most 16 KiB.
 */
NKW_API nkw_result nkw_records_layers_blend(const nkw_records_layer *layers, size_t layer_count, nkw_records_view rest,
                                            float threshold, nkw_records_span out, nkw_work work);

/**
 * nkw_pose_additive_build: the additive pose from ref to a.
 *
 * Returns  NKW_BAD_METHOD for an unknown side; nothing is then written.
 *
 * Stack  at most 8 KiB.
 */
NKW_API nkw_result nkw_records_additive_build(nkw_records_view a, nkw_records_view ref, nkw_additive side,
                                              nkw_records_span out);

/**
 * nkw_pose_additive_apply: adds an additive pose to base by weight times the mask.
 *
 * weight   negative and NaN count as 0, above 2^60 as 2^60. Above 1 it extrapolates
 * Returns  NKW_BAD_METHOD for an unknown side; nothing is then written.
 *
 * Stack  at most 16 KiB.
 */
NKW_API nkw_result nkw_records_additive_apply(nkw_records_view base, nkw_records_view delta, float weight,
                                              nkw_mask_view mask, nkw_additive side, nkw_records_span out);

/** The bytes of working memory of nkw_clip_sample_records. */
#define NKW_CLIP_RECORDS_WORK(joint_count) (4 * NKW_POSE_FLOATS(joint_count))

/**
 * nkw_clip_sample into records.
 *
 * cursors  as those of nkw_clip_sample; may be NULL
 * out      receives all joints; data may be NULL
 * floats   receives the separate floats; may be NULL
 * work     NKW_CLIP_RECORDS_WORK of the clip's joints; none if out has no data
 * Returns  NKW_OK; NKW_MISMATCHED for a pose with another number of joints; NKW_TOO_SMALL for too little working
 *          memory; nothing is then written
 *
 * Stack  at most 15 KiB.
 */
NKW_API nkw_result nkw_clip_sample_records(const nkw_clip *clip, float time, uint32_t *cursors, nkw_records_span out,
                                           float *floats, nkw_work work);

/**
 * nkw_skeleton_models_from_pose: local to model.
 *
 * range    as that of nkw_skeleton_models_from_pose; NULL: all joints
 *
 * Stack  at most 6 KiB.
 */
NKW_API nkw_result nkw_skeleton_models_from_records(const nkw_skeleton *skeleton, nkw_records_view records,
                                                    const nkw_mat4 *root, const nkw_range *range, nkw_mat4 *models);

#ifdef __cplusplus
}
#endif

#endif
