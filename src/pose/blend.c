/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/blend.h>

#include "batch/blend.h"
#include "batch/orient.h"
#include "batch/vec.h"
#include "lane/blend.h"
#include "lane/scalar.h"
#include "lane/skeleton.h"
#include "report.h"
#include "sizes.h"

/* Weights count as this at most, so that the sum of all is finite. */
#define BLEND_MOST_WEIGHT 0x1p60f

/* `n` lanes of poses from joint `from` on, the first `used` of them joints; `stride` of the whole pose. */
typedef struct part {
    size_t joints, stride, from, used, n;
} part;

static size_t at_most(size_t n, size_t most)
{
    return n < most ? n : most;
}

static part part_at(size_t joints, size_t from)
{
    size_t stride = NKW_POSE_STRIDE(joints);
    part p = {joints, stride, from, at_most(joints - from, BLEND_BLOCK), at_most(stride - from, BLEND_BLOCK)};
    return p;
}

static nkw_trs_view view_of(const float *pose, const part *p)
{
    nkw_pose_view view = {pose + p->from, p->joints};
    return nkw_pose_components(view);
}

static nkw_trs_span span_of(float *pose, const part *p)
{
    nkw_pose_span span = {pose + p->from, p->joints};
    return nkw_pose_components_span(span);
}

static blend_rows rows_of(const float *pose, const part *p)
{
    blend_rows r = {pose + p->from, p->stride};
    return r;
}

static blend_span rows_span(float *pose, const part *p)
{
    blend_span r = {pose + p->from, p->stride};
    return r;
}

static float weight_of(float weight)
{
    float w = weight > 0.0f ? weight : 0.0f;
    return w < BLEND_MOST_WEIGHT ? w : BLEND_MOST_WEIGHT;
}

/* The joints' own weights: weight * mask. */
static void weigh(float weight, const float *mask, const part *p, float *out)
{
    if (mask)
        nkwi_blend_weigh(weight, mask + p->from, (int)p->used, out, (int)p->n);
    else
        for (size_t i = 0; i < p->n; i++)
            out[i] = weight;
}

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

/* A mask without data fits every pose. */
static int fits(nkw_mask_view mask, size_t joint_count)
{
    return !mask.data || mask.joint_count == joint_count;
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

/* many poses */

/* -1, 0 or 1: whether the first number in which a and b differ is smaller in a, as bits. */
static int compare(const float *a, const float *b, size_t n)
{
    if (a == b || memcmp(a, b, n * sizeof *a) == 0)
        return 0;
    for (size_t i = 0; i < n; i++)
        if (lane_bits(a[i]) != lane_bits(b[i]))
            return lane_bits(a[i]) < lane_bits(b[i]) ? -1 : 1;
    return 0;
}

/* Masks, none before any; then rotations, scales and translations. */
static int compare_layers(const nkw_pose_layer *a, const nkw_pose_layer *b, const part *p)
{
    int order = (b->mask.data == NULL) - (a->mask.data == NULL);
    if (a->mask.data && b->mask.data)
        order = compare(a->mask.data + p->from, b->mask.data + p->from, p->used);
    for (size_t row = 3; order == 0 && row < 13; row++) {
        size_t at = row % 10 * p->stride + p->from;
        order = compare(a->pose.data + at, b->pose.data + at, p->used);
    }
    return order;
}

/* Whether layer a is added before b: the heavier, and of one weight by their numbers. */
static int goes_before(const nkw_pose_layer *a, const nkw_pose_layer *b, const part *p)
{
    float heavy = weight_of(a->weight), other = weight_of(b->weight);
    int order = heavy == other ? compare_layers(a, b, p) : heavy > other ? -1 : 1;
    return order != 0 ? order < 0 : a < b;
}

/* The layers that have a weight, in the order in which they are added: `sorted` of them, of which `taken` are done. */
typedef struct queue {
    const nkw_pose_layer *layers, *order[BLEND_SORTED];
    const part *p;
    size_t count, sorted, taken;
} queue;

/* Finds the first layers after `last`; of all if it is NULL. A separate function: the call is rare. */
NKW_NOINLINE static void sort_layers(queue *q, const nkw_pose_layer *last)
{
    q->sorted = q->taken = 0;
    for (size_t i = 0; i < q->count; i++) {
        const nkw_pose_layer *l = &q->layers[i];
        if (!(l->weight > 0.0f) || (last && !goes_before(last, l, q->p)))
            continue;
        size_t k = q->sorted;
        for (; k > 0 && goes_before(l, q->order[k - 1], q->p); k--)
            if (k < BLEND_SORTED)
                q->order[k] = q->order[k - 1];
        if (k < BLEND_SORTED)
            q->order[k] = l;
        q->sorted += q->sorted < BLEND_SORTED;
    }
}

static void begin_queue(queue *q, const nkw_pose_layer *layers, size_t count, const part *p)
{
    q->layers = layers;
    q->count = count;
    q->p = p;
    sort_layers(q, NULL);
}

/* NULL after the last one. */
static const nkw_pose_layer *next_layer(queue *q)
{
    if (q->taken == BLEND_SORTED)
        sort_layers(q, q->order[BLEND_SORTED - 1]);
    return q->taken < q->sorted ? q->order[q->taken++] : NULL;
}

static void copy_rows(blend_rows from, size_t rows, blend_span to, size_t n)
{
    for (size_t c = 0; c < rows; c++)
        memmove(to.at + c * to.stride, from.at + c * from.stride, n * sizeof(float));
}

/*
 * Layers without masks: sum = lerp(sum, pose, weight / (total + weight)). A layer is added when the next one is known,
 * because the loop of the last one also normalises the rotations. The sum is at first the first pose, not a copy of it.
 */
typedef struct plain_sum {
    float v[10 * BLEND_BLOCK];
    blend_rows sum, last;
    double total;
    float t;
} plain_sum;

static void add_plain(plain_sum *s, blend_rows rows, float weight, const part *p)
{
    blend_span v = {s->v, p->n};
    float t = lane_share(weight, (float)s->total);
    s->total = s->total + (double)weight;
    if (t == 0.0f)
        return;
    if (t < 1.0f && s->t > 0.0f) {
        nkwi_blend_sum(s->sum, s->last, s->t, (int)p->used, v);
        s->sum.at = s->v;
        s->sum.stride = p->n;
    }
    s->sum = t < 1.0f ? s->sum : rows;
    s->t = t < 1.0f ? t : 0.0f;
    s->last = rows;
}

static int has_mask(const nkw_pose_layer *layers, size_t count)
{
    int any = 0;
    for (size_t i = 0; i < count; i++)
        any |= layers[i].mask.data && weight_of(layers[i].weight) > 0.0f;
    return any;
}

static void blend_plain(const nkw_pose_layer *layers, size_t count, const float *rest, float threshold, const part *p,
                        float *out)
{
    plain_sum s;
    queue q;
    s.total = 0.0;
    s.t = 0.0f;
    begin_queue(&q, layers, count, p);
    for (const nkw_pose_layer *l = next_layer(&q); l; l = next_layer(&q))
        add_plain(&s, rows_of(l->pose.data, p), weight_of(l->weight), p);
    add_plain(&s, rows_of(rest, p), lane_missing(s.total, threshold), p);
    if (s.t > 0.0f)
        nkwi_blend_nlerp(s.sum, s.last, s.t, (int)p->used, rows_span(out, p));
    else
        copy_rows(s.sum, 10, rows_span(out, p), p->n);
}

/*
 * Layers with masks: each joint has its own total and share. mixed is 1 where more than one pose has a share in the
 * sum. The sum is at first the first pose, not a copy of it, then v. The first pose counts whole: where it has no
 * weight, the share of the next one is 1.
 */
typedef struct masked_sum {
    float v[10 * BLEND_BLOCK];
    blend_rows sum, last;
    double total[BLEND_BLOCK];
    float mixed[BLEND_BLOCK], t[BLEND_BLOCK];
    size_t poses;
} masked_sum;

/* Adds a pose by its joints' weights. */
static void add_masked(masked_sum *s, blend_rows rows, const float *weight, const part *p)
{
    blend_span v = {s->v, p->n};
    if (s->poses > 1) {
        nkwi_blend_mix(s->sum, s->last, s->t, s->mixed, (int)p->used, v);
        s->sum.at = s->v;
        s->sum.stride = p->n;
    }
    nkwi_blend_share(weight, s->total, s->t, p->n);
    s->sum = s->poses == 0 ? rows : s->sum;
    s->last = rows;
    s->poses++;
}

static void add_rest(masked_sum *s, const float *rest, float threshold, const part *p)
{
    float weight[BLEND_BLOCK];
    int any;
    nkwi_blend_missing(s->total, threshold, weight, &any, (int)p->n);
    if (any)
        add_masked(s, rows_of(rest, p), weight, p);
}

static void blend_with_masks(const nkw_pose_layer *layers, size_t count, const float *rest, float threshold,
                             const part *p, float *out)
{
    masked_sum s;
    queue q;
    memset(s.total, 0, p->n * sizeof *s.total);
    memset(s.mixed, 0, p->n * sizeof *s.mixed);
    s.poses = 0;
    begin_queue(&q, layers, count, p);
    for (const nkw_pose_layer *l = next_layer(&q); l; l = next_layer(&q)) {
        float weight[BLEND_BLOCK];
        weigh(weight_of(l->weight), l->mask.data, p, weight);
        add_masked(&s, rows_of(l->pose.data, p), weight, p);
    }
    add_rest(&s, rest, threshold, p);
    if (s.poses > 1)
        nkwi_blend_each(s.sum, s.last, s.t, s.mixed, (int)p->used, rows_span(out, p));
    else
        copy_rows(s.sum, 10, rows_span(out, p), p->n);
}

/* Whether all layers are of so many joints. */
static int all_fit(const nkw_pose_layer *layers, size_t count, size_t joint_count)
{
    int fit = 1;
    for (size_t i = 0; joint_count > 0 && i < count; i++)
        fit = fit && layers[i].pose.joint_count == joint_count && fits(layers[i].mask, joint_count);
    return fit;
}

nkw_result nkw_pose_layers_blend(const nkw_pose_layer *layers, size_t layer_count, nkw_pose_view rest, float threshold,
                                 nkw_pose_span out)
{
    size_t joints = out.joint_count;
    if (rest.joint_count != joints || !all_fit(layers, layer_count, joints))
        return NKW_MISMATCHED;
    int masked = joints > 0 && has_mask(layers, layer_count);
    float limit = weight_of(threshold);
    for (size_t from = 0; from < NKW_POSE_STRIDE(joints); from += BLEND_BLOCK) {
        part p = part_at(joints, from);
        if (masked)
            blend_with_masks(layers, layer_count, rest.data, limit, &p, out.data);
        else
            blend_plain(layers, layer_count, rest.data, limit, &p, out.data);
    }
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
