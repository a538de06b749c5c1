/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/blend.h>

#include "batch/blend.h"
#include "batch/orient.h"
#include "batch/vec.h"
#include "lane/blend.h"
#include "lane/scalar.h"
#include "lane/skeleton.h"
#include "pose/blend_part.h"
#include "report.h"
#include "sizes.h"

/* two poses: `slerp` is a constant, so that a program of nkw_pose_blend links no loop of slerp, and the reverse */

static void blend_inside(const float *a, const float *b, size_t joints, float t, float *out)
{
    for (size_t i = 0; i < joints; i += BLEND_BLOCK)
        nkwi_blend_poses(a + i, b + i, NKW_POSE_STRIDE(joints), t, (int)at_most(joints - i, BLEND_BLOCK), out + i);
}

NKW_ALWAYS_INLINE void blend_at(const float *a, const float *b, size_t joints, float t, int slerp, float *out)
{
    const nkw_pose_view pa = {a, joints}, pb = {b, joints};
    const nkw_pose_span po = {out, joints};
    const nkw_trs_view va = nkw_pose_components(pa), vb = nkw_pose_components(pb);
    const nkw_trs_span vo = nkw_pose_components_span(po);
    nkw_vec3_lerp_at_n(va.translation, vb.translation, t, vo.translation, joints);
    (slerp ? nkw_quat_slerp_at_n : nkw_quat_nlerp_at_n)(va.rotation, vb.rotation, t, vo.rotation, joints);
    nkw_vec3_lerp_at_n(va.scale, vb.scale, t, vo.scale, joints);
}

/* nkw_pose_blend_slerp by a t for each joint. */
static void slerp_each(const float *a, const float *b, const float *t, const part *p, float *out)
{
    nkw_trs_view va = view_of(a, p), vb = view_of(b, p);
    nkw_trs_span vo = span_of(out, p);
    nkw_vec3_lerp_n(va.translation, vb.translation, t, vo.translation, p->used);
    nkw_quat_slerp_n(va.rotation, vb.rotation, t, vo.rotation, p->used);
    nkw_vec3_lerp_n(va.scale, vb.scale, t, vo.scale, p->used);
}

NKW_ALWAYS_INLINE void blend_masked(const float *a, const float *b, size_t joints, float t, const float *mask,
                                    int slerp, float *out)
{
    for (size_t from = 0; from < NKW_POSE_STRIDE(joints); from += BLEND_BLOCK) {
        part p = part_at(joints, from);
        float ts[BLEND_BLOCK];
        weigh(t, mask, &p, ts);
        if (slerp)
            slerp_each(a, b, ts, &p, out);
        else
            nkwi_blend_each(rows_of(a, &p), rows_of(b, &p), ts, NULL, (int)p.used, rows_span(out, &p));
    }
}

NKW_ALWAYS_INLINE void blend(const float *a, const float *b, size_t joints, float t, const float *mask, int slerp,
                             float *out)
{
    float known = t == t ? t : 0.0f;
    if (joints == 0)
        return;
    if (mask)
        blend_masked(a, b, joints, known, mask, slerp, out);
    else if (!slerp && known > 0.0f && known < 1.0f)
        blend_inside(a, b, joints, known, out);
    else
        blend_at(a, b, joints, known, slerp, out);
}

nkw_result nkw_pose_blend(nkw_pose_view a, nkw_pose_view b, float t, nkw_mask_view mask, nkw_pose_span out)
{
    if (a.joint_count != out.joint_count || b.joint_count != out.joint_count || !fits(mask, out.joint_count))
        return NKW_MISMATCHED;
    blend(a.data, b.data, out.joint_count, t, mask.data, 0, out.data);
    return NKW_OK;
}

nkw_result nkw_pose_blend_slerp(nkw_pose_view a, nkw_pose_view b, float t, nkw_mask_view mask, nkw_pose_span out)
{
    if (a.joint_count != out.joint_count || b.joint_count != out.joint_count || !fits(mask, out.joint_count))
        return NKW_MISMATCHED;
    blend(a.data, b.data, out.joint_count, t, mask.data, 1, out.data);
    return NKW_OK;
}

static nkw_result check_weight(float weight, float most)
{
    if (!lane_is_finite(weight))
        return NKW_NOT_FINITE;
    return weight >= 0.0f && weight <= most ? NKW_OK : NKW_BAD_WEIGHTS;
}

nkw_result nkw_mask_validate(nkw_mask_view mask, size_t *bad)
{
    nkw_result result = mask.joint_count == 0 ? NKW_EMPTY : NKW_OK;
    size_t offender = 0;
    for (size_t j = 0; result == NKW_OK && mask.data && j < mask.joint_count; j++) {
        result = check_weight(mask.data[j], 1.0f);
        offender = j;
    }
    return report(result, offender, bad);
}

static nkw_result check_layer(const nkw_pose_layer *layer, size_t joint_count)
{
    if (!layer->pose.data)
        return NKW_EMPTY;
    if (!all_fit(layer, 1, joint_count))
        return NKW_MISMATCHED;
    nkw_result result = check_weight(layer->weight, BLEND_MOST_WEIGHT);
    return result == NKW_OK && layer->mask.data ? nkw_mask_validate(layer->mask, NULL) : result;
}

nkw_result nkw_pose_layers_validate(const nkw_pose_layer *layers, size_t layer_count, size_t joint_count, size_t *bad)
{
    nkw_result result = joint_count == 0 ? NKW_EMPTY : NKW_OK;
    size_t offender = 0;
    for (size_t i = 0; result == NKW_OK && i < layer_count; i++) {
        result = check_layer(&layers[i], joint_count);
        offender = i;
    }
    return report(result, offender, bad);
}

/* differences */

static int is_side(nkw_additive side)
{
    return side == NKW_ADDITIVE_LOCAL || side == NKW_ADDITIVE_PARENT;
}

nkw_result nkw_pose_additive_build(nkw_pose_view a, nkw_pose_view ref, nkw_additive side, nkw_pose_span out)
{
    if (a.joint_count != out.joint_count || ref.joint_count != out.joint_count)
        return NKW_MISMATCHED;
    if (!is_side(side))
        return NKW_BAD_METHOD;
    nkwi_additive_build(nkw_pose_components(a), nkw_pose_components(ref), side == NKW_ADDITIVE_PARENT,
                        nkw_pose_components_span(out), out.joint_count);
    return NKW_OK;
}

nkw_result nkw_pose_additive_apply(nkw_pose_view base, nkw_pose_view delta, float weight, nkw_mask_view mask,
                                   nkw_additive side, nkw_pose_span out)
{
    size_t joints = out.joint_count;
    if (base.joint_count != joints || delta.joint_count != joints || !fits(mask, joints))
        return NKW_MISMATCHED;
    if (!is_side(side))
        return NKW_BAD_METHOD;
    for (size_t from = 0; from < NKW_POSE_STRIDE(joints); from += BLEND_BLOCK) {
        part p = part_at(joints, from);
        float w[BLEND_BLOCK];
        weigh(weight_of(weight), mask.data, &p, w);
        nkwi_additive_apply(view_of(base.data, &p), view_of(delta.data, &p), w, side == NKW_ADDITIVE_PARENT,
                            span_of(out.data, &p), p.used);
    }
    return NKW_OK;
}

/* left and right */

/* Whether joint j's partner is in range and has j for its own. */
static int is_paired(const int32_t *pair, size_t joints, size_t j)
{
    return pair[j] >= 0 && (size_t)pair[j] < joints && pair[pair[j]] >= 0 && (size_t)pair[pair[j]] == j;
}

static void mirror_pair(const float *pose, size_t stride, size_t j, size_t k, const float sign[10], float *out)
{
    for (size_t c = 0; c < 10; c++) {
        float at_j = sign[c] * pose[c * stride + j], at_k = sign[c] * pose[c * stride + k];
        out[c * stride + j] = at_k;
        out[c * stride + k] = at_j;
    }
}

/* Checks the plane and the partners. */
static nkw_result check_mirror(const int32_t *pair, size_t joints, nkw_mirror plane, size_t *offender)
{
    if (plane != NKW_MIRROR_X && plane != NKW_MIRROR_Y && plane != NKW_MIRROR_Z)
        return NKW_BAD_METHOD;
    for (size_t j = 0; j < joints; j++) {
        *offender = j;
        if (pair[j] < 0 || (size_t)pair[j] >= joints)
            return NKW_OUT_OF_RANGE;
        if (!is_paired(pair, joints, j))
            return NKW_BAD_MIRROR;
    }
    return NKW_OK;
}

nkw_result nkw_pose_mirror(nkw_pose_view pose, const int32_t *pair, nkw_mirror plane, nkw_pose_span out, size_t *bad)
{
    size_t joints = out.joint_count, offender = 0;
    nkw_result result = pose.joint_count == joints ? check_mirror(pair, joints, plane, &offender) : NKW_MISMATCHED;
    if (result != NKW_OK)
        return report(result, offender, bad);
    size_t normal = plane == NKW_MIRROR_Y ? 1 : plane == NKW_MIRROR_Z ? 2 : 0;
    float sign[10] = {1, 1, 1, -1, -1, -1, 1, 1, 1, 1};
    sign[normal] = -1.0f;
    sign[3 + normal] = 1.0f;
    for (size_t j = 0; j < joints; j++)
        if (j <= (size_t)pair[j])
            mirror_pair(pose.data, NKW_POSE_STRIDE(joints), j, (size_t)pair[j], sign, out.data);
    return report(NKW_OK, 0, bad);
}

nkw_result nkw_mask_from_subtree(const nkw_skeleton *skeleton, size_t root, nkw_mask_span mask)
{
    const int32_t *parents = skeleton->parents;
    size_t joints = mask.joint_count;
    if (skeleton->joint_count != joints)
        return NKW_MISMATCHED;
    for (size_t j = 0; j < NKW_POSE_STRIDE(joints); j++) {
        size_t parent = j < joints ? skeleton_parent(parents, j) : j;
        int below = parent < j && mask.data[parent] == 1.0f;
        mask.data[j] = below || (j == root && j < joints) ? 1.0f : 0.0f;
    }
    return NKW_OK;
}
