/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/mat.h>
#include <nakawari/orient.h>
#include <nakawari/quat.h>
#include <nakawari/retarget.h>
#include <nakawari/transform.h>
#include <nakawari/vec.h>

#include "lane/scalar.h"
#include "lane/skeleton.h"
#include "report.h"
#include "work.h"

/* The model-space rotations of a rest pose, and of a pose, of each joint. */
typedef struct rotations {
    nkw_quat *rest, *now;
} rotations;

static nkw_quat parent_of(const nkw_skeleton *skeleton, const nkw_quat *models, size_t j)
{
    size_t parent = skeleton_parent(skeleton->parents, j);
    return parent < j ? models[parent] : nkw_quat_identity();
}

static nkw_quat model_of(const nkw_skeleton *skeleton, const nkw_quat *models, nkw_pose_view pose, size_t j)
{
    return nkw_quat_normalize(nkw_quat_mul(parent_of(skeleton, models, j), nkw_pose_get(pose, j).rotation));
}

static void models_of(const nkw_skeleton *skeleton, nkw_pose_view pose, nkw_quat *models)
{
    for (size_t j = 0; j < skeleton->joint_count; j++)
        models[j] = model_of(skeleton, models, pose, j);
}

static nkw_quat align_of(const nkw_retarget *r)
{
    return nkw_quat_normalize(r->align);
}

/* Whether the source has the joint. */
static int is_joint(const nkw_retarget *r, int32_t joint)
{
    return joint >= 0 && (size_t)joint < r->source.joint_count;
}

/* How far a source joint is rotated from rest, in the target's model space. */
static nkw_quat rotation_from_rest(const nkw_retarget *r, const rotations *source, int32_t joint)
{
    nkw_quat align = align_of(r);
    nkw_quat d = nkw_quat_mul(source->now[joint], nkw_quat_conjugate(source->rest[joint]));
    return nkw_quat_mul(align, nkw_quat_mul(d, nkw_quat_conjugate(align)));
}

static nkw_quat rotation_of(const nkw_retarget *r, const rotations *source, const nkw_retarget_joint *map)
{
    nkw_quat from = rotation_from_rest(r, source, map->from);
    float t = nkw_clamp(map->t, 0.0f, 1.0f);
    if (!is_joint(r, map->to) || !(t > 0.0f))
        return from;
    nkw_quat to = rotation_from_rest(r, source, map->to);
    return t < 1.0f ? nkw_quat_slerp(from, to, t) : to;
}

static nkw_vec3 translation_of(const nkw_retarget *r, const rotations *source, nkw_pose_view pose,
                               const nkw_retarget_joint *map, nkw_quat parent)
{
    size_t j = (size_t)map->from;
    nkw_vec3 moved = nkw_vec3_sub(nkw_pose_get(pose, j).translation, nkw_pose_get(r->source_rest, j).translation);
    moved = nkw_quat_rotate(align_of(r), nkw_quat_rotate(parent_of(&r->source, source->now, j), moved));
    return nkw_vec3_scale(nkw_quat_rotate_inverse(parent, moved), map->translation);
}

static void retarget_joint(const nkw_retarget *r, const rotations *source, const rotations *target, nkw_pose_view pose,
                           size_t j, nkw_pose_span out)
{
    const nkw_retarget_joint *map = &r->joints[j];
    nkw_trs local = nkw_pose_get(r->target_rest, j);
    nkw_quat parent = parent_of(&r->target, target->now, j);
    if (is_joint(r, map->from)) {
        target->now[j] = nkw_quat_normalize(nkw_quat_mul(rotation_of(r, source, map), target->rest[j]));
        local.rotation = nkw_quat_normalize(nkw_quat_mul(nkw_quat_conjugate(parent), target->now[j]));
        if (map->translation != 0.0f)
            local.translation = nkw_vec3_add(local.translation, translation_of(r, source, pose, map, parent));
    } else {
        target->now[j] = nkw_quat_normalize(nkw_quat_mul(parent, local.rotation));
    }
    nkw_pose_set(out, j, &local);
}

static nkw_result check_counts(const nkw_retarget *r)
{
    int fit =
        r->source_rest.joint_count == r->source.joint_count && r->target_rest.joint_count == r->target.joint_count;
    return fit ? NKW_OK : NKW_MISMATCHED;
}

nkw_result nkw_retarget_apply(const nkw_retarget *retarget, nkw_pose_view source, nkw_pose_span out, nkw_work work)
{
    size_t m = retarget->source.joint_count, n = retarget->target.joint_count;
    if (check_counts(retarget) != NKW_OK || source.joint_count != m || out.joint_count != n)
        return NKW_MISMATCHED;
    if (m > SIZE_MAX - n || !work_fits_each(work, m + n, NKW_RETARGET_WORK(1, 0)))
        return NKW_TOO_SMALL;
    nkw_quat *quats = work.data;
    rotations from = {quats, quats + m}, to = {quats + 2 * m, quats + 2 * m + n};
    models_of(&retarget->source, retarget->source_rest, from.rest);
    models_of(&retarget->source, source, from.now);
    models_of(&retarget->target, retarget->target_rest, to.rest);
    nkw_pose_identity(out);
    for (size_t j = 0; j < n; j++)
        retarget_joint(retarget, &from, &to, source, j, out);
    return NKW_OK;
}

nkw_result nkw_pose_convert_axes(nkw_pose_view pose, nkw_axes_map map, nkw_pose_span out)
{
    const nkw_pose_span padded = {out.data, NKW_POSE_STRIDE(out.joint_count)};
    const nkw_trs none = nkw_trs_identity();
    if (pose.joint_count != out.joint_count)
        return NKW_MISMATCHED;
    for (size_t j = 0; j < pose.joint_count; j++) {
        nkw_trs trs = nkw_pose_get(pose, j), converted = nkw_axes_convert_trs(map, &trs);
        nkw_pose_set(out, j, &converted);
    }
    for (size_t j = out.joint_count; j < padded.joint_count; j++)
        nkw_pose_set(padded, j, &none);
    return NKW_OK;
}

static nkw_result check_map(const nkw_retarget *r, const nkw_retarget_joint *map)
{
    int32_t count = (int32_t)(r->source.joint_count < INT32_MAX ? r->source.joint_count : INT32_MAX);
    if (map->from < NKW_NO_JOINT || map->from >= count || map->to < NKW_NO_JOINT || map->to >= count)
        return NKW_OUT_OF_RANGE;
    return lane_is_finite(map->t) && lane_is_finite(map->translation) ? NKW_OK : NKW_NOT_FINITE;
}

nkw_result nkw_retarget_validate(const nkw_retarget *r, size_t *bad)
{
    size_t offender = 0;
    nkw_result result = nkw_skeleton_validate(&r->source, &offender);
    result = result == NKW_OK ? nkw_skeleton_validate(&r->target, &offender) : result;
    result = result == NKW_OK ? check_counts(r) : result;
    result = result == NKW_OK ? nkw_pose_validate(r->source_rest, &offender) : result;
    result = result == NKW_OK ? nkw_pose_validate(r->target_rest, &offender) : result;
    for (size_t j = 0; result == NKW_OK && j < r->target.joint_count; j++) {
        result = check_map(r, &r->joints[j]);
        offender = j;
    }
    return report(result, offender, bad);
}

/* ---- Chains ---- */

static int are_joints(const int32_t *chain, size_t count, size_t joint_count)
{
    for (size_t k = 0; k < count; k++)
        if (chain[k] < 0 || (size_t)chain[k] >= joint_count)
            return 0;
    return 1;
}

/* The length of a chain up to joint k; a chain of length 0 counts joints. */
static double length_to(nkw_pose_view rest, const int32_t *chain, size_t k)
{
    double sum = 0.0;
    for (size_t i = 1; i <= k; i++)
        sum += (double)nkw_vec3_length(nkw_pose_get(rest, (size_t)chain[i]).translation);
    return sum;
}

/* The share of the length of a chain at joint k, 0..1. */
static double share_at(nkw_pose_view rest, const int32_t *chain, size_t count, size_t k)
{
    double whole = length_to(rest, chain, count - 1);
    if (count < 2)
        return 0.0;
    return whole > 0.0 && whole < (double)INFINITY ? length_to(rest, chain, k) / whole
                                                   : (double)k / (double)(count - 1);
}

static nkw_result check_chains(const nkw_retarget *r, const int32_t *source_chain, size_t source_count,
                               const int32_t *target_chain, size_t target_count)
{
    if (source_count == 0 || target_count == 0)
        return NKW_EMPTY;
    int known = are_joints(source_chain, source_count, r->source_rest.joint_count) &&
                are_joints(target_chain, target_count, r->target_rest.joint_count);
    return known ? NKW_OK : NKW_OUT_OF_RANGE;
}

nkw_result nkw_retarget_map_chain(const nkw_retarget *r, const int32_t *source_chain, size_t source_count,
                                  const int32_t *target_chain, size_t target_count, nkw_retarget_joint *joints)
{
    nkw_result result = check_chains(r, source_chain, source_count, target_chain, target_count);
    if (result != NKW_OK)
        return result;
    for (size_t k = 0, s = 0; k < target_count; k++) {
        double x = share_at(r->target_rest, target_chain, target_count, k);
        while (s + 2 < source_count && share_at(r->source_rest, source_chain, source_count, s + 1) <= x)
            s++;
        nkw_retarget_joint *map = &joints[target_chain[k]];
        size_t next = s + 1 < source_count ? s + 1 : s;
        double low = share_at(r->source_rest, source_chain, source_count, s);
        double width = share_at(r->source_rest, source_chain, source_count, next) - low;
        map->from = source_chain[s];
        map->to = source_chain[next];
        map->t = width > 0.0 ? nkw_clamp((float)((x - low) / width), 0.0f, 1.0f) : 0.0f;
    }
    return NKW_OK;
}

nkw_result nkw_retarget_chain_scale(const nkw_retarget *r, const int32_t *source_chain, size_t source_count,
                                    const int32_t *target_chain, size_t target_count, float *scale)
{
    nkw_result result = check_chains(r, source_chain, source_count, target_chain, target_count);
    if (result != NKW_OK)
        return result;
    float ratio = (float)(length_to(r->target_rest, target_chain, target_count - 1) /
                          length_to(r->source_rest, source_chain, source_count - 1));
    if (!(ratio > 0.0f && ratio < INFINITY))
        return NKW_NOT_FINITE;
    *scale = ratio;
    return NKW_OK;
}
