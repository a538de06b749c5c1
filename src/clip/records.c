/* SPDX-License-Identifier: MIT */
/*
 * Poses of records, a block of joints at a time: component arrays, the functions of poses on them, and back. Blocks of
 * layers are those of nkw_pose_layers_blend, which sorts the layers of each.
 *
 *     records     | block 0: joints 0 .. 127 | block 1: 128 .. 255 | last block |
 *     pose        a pose of its own of the joints of one block
 *
 * nkw_records_blend has loops of its own (batch/records.c), as the conversions would take longer than the blend.
 */
#include "lane/strict.h"

#include <nakawari/pose.h>
#include <nakawari/records.h>

#include "batch/blend.h"
#include "batch/pose.h"
#include "batch/records.h"
#include "batch/skeleton.h"
#include "lane/skeleton.h"
#include "sizes.h"
#include "work.h"

#define BLOCK_FLOATS (10 * BLEND_BLOCK)
#define LAYER_BYTES  ((size_t)NKW_RECORDS_LAYERS_WORK(0))

static size_t joints_in_block(size_t joints, size_t from, size_t most)
{
    return joints - from < most ? joints - from : most;
}

/* The pose of n joints of records from `from` on; without records, one without data. */
static nkw_pose_view read_block(nkw_records_view records, size_t from, size_t n, float *block)
{
    const nkw_pose_view view = {records.data ? block : NULL, n};
    if (records.data)
        nkwi_pose_from_trs(records.data + from, n, block, NKW_POSE_STRIDE(n));
    return view;
}

static void write_block(nkw_pose_span pose, nkw_records_span out, size_t from)
{
    nkwi_trs_from_pose(pose.data, NKW_POSE_STRIDE(pose.joint_count), pose.joint_count, out.data + from);
}

static nkw_mask_view mask_from(nkw_mask_view mask, size_t from, size_t n)
{
    const nkw_mask_view view = {mask.data ? mask.data + from : NULL, n};
    return view;
}

static int fit(nkw_records_view a, nkw_records_view b, nkw_mask_view mask, nkw_records_span out)
{
    return a.joint_count == out.joint_count && b.joint_count == out.joint_count &&
           (!mask.data || mask.joint_count == out.joint_count);
}

/* A t for each joint, as nkw_pose_blend weighs them. */
static void blend_masked(nkw_records_view a, nkw_records_view b, float t, nkw_mask_view mask, nkw_records_span out)
{
    for (size_t from = 0; from < out.joint_count; from += BLEND_BLOCK) {
        float each[BLEND_BLOCK];
        const int n = (int)joints_in_block(out.joint_count, from, BLEND_BLOCK);
        for (int i = 0; !mask.data && i < BLEND_BLOCK; i++)
            each[i] = t;
        if (mask.data)
            nkwi_blend_weigh(t, mask.data + from, n, each, BLEND_BLOCK);
        nkwi_records_blend_each(a.data + from, b.data + from, each, n, out.data + from);
    }
}

nkw_result nkw_records_blend(nkw_records_view a, nkw_records_view b, float t, nkw_mask_view mask, nkw_records_span out)
{
    const float known = t == t ? t : 0.0f;
    if (!fit(a, b, mask, out))
        return NKW_MISMATCHED;
    if (mask.data || !(known > 0.0f && known < 1.0f))
        blend_masked(a, b, known, mask, out);
    else
        for (size_t from = 0; from < out.joint_count; from += BLEND_BLOCK)
            nkwi_records_blend(a.data + from, b.data + from, known,
                               (int)joints_in_block(out.joint_count, from, BLEND_BLOCK), out.data + from);
    return NKW_OK;
}

static int all_fit(const nkw_records_layer *layers, size_t count, nkw_records_view rest, nkw_records_span out)
{
    const nkw_mask_view none = {NULL, 0};
    int fits = fit(rest, rest, none, out);
    for (size_t i = 0; out.joint_count > 0 && i < count; i++)
        fits = fits && fit(layers[i].pose, rest, layers[i].mask, out);
    return fits;
}

nkw_result nkw_records_layers_blend(const nkw_records_layer *layers, size_t layer_count, nkw_records_view rest,
                                    float threshold, nkw_records_span out, nkw_work work)
{
    if (!all_fit(layers, layer_count, rest, out))
        return NKW_MISMATCHED;
    if (layer_count >= SIZE_MAX / LAYER_BYTES || !work_fits_each(work, layer_count + 1, LAYER_BYTES))
        return NKW_TOO_SMALL;
    float *block = (float *)work.data, *blocks = block + BLOCK_FLOATS;
    nkw_pose_layer *poses = (nkw_pose_layer *)(void *)(blocks + layer_count * BLOCK_FLOATS);
    for (size_t from = 0; from < out.joint_count; from += BLEND_BLOCK) {
        const size_t n = joints_in_block(out.joint_count, from, BLEND_BLOCK);
        const nkw_pose_span result = {block, n};
        for (size_t i = 0; i < layer_count; i++) {
            const nkw_pose_layer layer = {read_block(layers[i].pose, from, n, blocks + i * BLOCK_FLOATS),
                                          layers[i].weight, mask_from(layers[i].mask, from, n)};
            poses[i] = layer;
        }
        nkw_pose_layers_blend(poses, layer_count, read_block(rest, from, n, block), threshold, result);
        write_block(result, out, from);
    }
    return NKW_OK;
}

static nkw_result check_additive(nkw_records_view a, nkw_records_view b, nkw_mask_view mask, nkw_additive side,
                                 nkw_records_span out)
{
    if (!fit(a, b, mask, out))
        return NKW_MISMATCHED;
    return side == NKW_ADDITIVE_LOCAL || side == NKW_ADDITIVE_PARENT ? NKW_OK : NKW_BAD_METHOD;
}

nkw_result nkw_records_additive_build(nkw_records_view a, nkw_records_view ref, nkw_additive side, nkw_records_span out)
{
    const nkw_mask_view none = {NULL, 0};
    const nkw_result result = check_additive(a, ref, none, side, out);
    for (size_t from = 0; result == NKW_OK && from < out.joint_count; from += RECORDS_BLOCK) {
        float first[10 * RECORDS_BLOCK], second[10 * RECORDS_BLOCK];
        const size_t n = joints_in_block(out.joint_count, from, RECORDS_BLOCK);
        const nkw_pose_span pose = {first, n};
        nkw_pose_additive_build(read_block(a, from, n, first), read_block(ref, from, n, second), side, pose);
        write_block(pose, out, from);
    }
    return result;
}

nkw_result nkw_records_additive_apply(nkw_records_view base, nkw_records_view delta, float weight, nkw_mask_view mask,
                                      nkw_additive side, nkw_records_span out)
{
    const nkw_result result = check_additive(base, delta, mask, side, out);
    for (size_t from = 0; result == NKW_OK && from < out.joint_count; from += RECORDS_BLOCK) {
        float first[10 * RECORDS_BLOCK], second[10 * RECORDS_BLOCK];
        const size_t n = joints_in_block(out.joint_count, from, RECORDS_BLOCK);
        const nkw_pose_span pose = {first, n};
        nkw_pose_additive_apply(read_block(base, from, n, first), read_block(delta, from, n, second), weight,
                                mask_from(mask, from, n), side, pose);
        write_block(pose, out, from);
    }
    return result;
}

nkw_result nkw_clip_sample_records(const nkw_clip *clip, float time, uint32_t *cursors, nkw_records_span out,
                                   float *floats, nkw_work work)
{
    const nkw_pose_span pose = {out.data ? (float *)work.data : NULL, out.joint_count};
    if (out.data && !work_fits_each(work, NKW_POSE_STRIDE(out.joint_count), 40))
        return NKW_TOO_SMALL;
    const nkw_result result = nkw_clip_sample(clip, time, cursors, pose, floats);
    if (result == NKW_OK && out.data && out.joint_count > 0)
        write_block(pose, out, 0);
    return result;
}

nkw_result nkw_skeleton_models_from_records(const nkw_skeleton *skeleton, nkw_records_view records,
                                            const nkw_mat4 *root, const nkw_range *range, nkw_mat4 *models)
{
    const nkw_range r = skeleton_range(skeleton, range);
    if (records.joint_count != skeleton->joint_count)
        return NKW_MISMATCHED;
    nkwi_models_from_records(skeleton->parents, records.data, root, r.from, r.to, models);
    return NKW_OK;
}
