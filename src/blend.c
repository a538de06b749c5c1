/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/blend.h>

#include "lane/blend.h"
#include "simd/select.h"

/* The most that a weight counts. */
#define HEAVIEST 0x1p60f

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
    return nkw_pose_view(pose + p->from, p->joints);
}

static nkw_trs_span span_of(float *pose, const part *p)
{
    return nkw_pose_span(pose + p->from, p->joints);
}

static nkw_quat_view as_view(nkw_quat_span s)
{
    nkw_quat_view v = {s.x, s.y, s.z, s.w};
    return v;
}

static float weight_of(float weight)
{
    float w = weight > 0.0f ? weight : 0.0f;
    return w < HEAVIEST ? w : HEAVIEST;
}

/* The joints' own weights: weight * mask. */
static void weigh(float weight, const float *mask, const part *p, float *out)
{
    if (mask)
        nkw_batch_selected()->blend_weigh(weight, mask + p->from, out, p->n);
    else
        for (size_t i = 0; i < p->n; i++)
            out[i] = weight;
}

/* two poses */

static void nlerp_inside(const float *a, const float *b, size_t joints, float t, float *out)
{
    for (size_t from = 0; from < NKW_POSE_STRIDE(joints); from += BLEND_BLOCK) {
        part p = part_at(joints, from);
        nkw_batch_selected()->pose_nlerp_at(a + from, b + from, p.stride, t, (int)p.used, out + from, (int)p.n);
    }
}

static void blend_at(const float *a, const float *b, size_t joints, float t, int slerp, float *out)
{
    const nkw_batch *batch = nkw_batch_selected();
    size_t stride = NKW_POSE_STRIDE(joints), scales = 7 * stride;
    nkw_quat_view qa = nkw_pose_view(a, joints).rotation, qb = nkw_pose_view(b, joints).rotation;
    batch->lerp_at(a, b, t, out, 3 * stride);
    (slerp ? batch->quat_slerp_at : batch->quat_nlerp_at)(qa, qb, t, nkw_pose_span(out, joints).rotation, stride);
    batch->lerp_at(a + scales, b + scales, t, out + scales, 3 * stride);
}

static void blend_masked(const float *a, const float *b, size_t joints, float t, const float *mask, int slerp,
                         float *out)
{
    const nkw_batch *batch = nkw_batch_selected();
    for (size_t from = 0; from < NKW_POSE_STRIDE(joints); from += BLEND_BLOCK) {
        part p = part_at(joints, from);
        float ts[BLEND_BLOCK];
        weigh(t, mask, &p, ts);
        nkw_trs_view va = view_of(a, &p), vb = view_of(b, &p);
        nkw_trs_span vo = span_of(out, &p);
        batch->vec3_lerp(va.translation, vb.translation, ts, vo.translation, p.n);
        (slerp ? batch->quat_slerp : batch->quat_nlerp)(va.rotation, vb.rotation, ts, vo.rotation, p.n);
        batch->vec3_lerp(va.scale, vb.scale, ts, vo.scale, p.n);
    }
}

static void blend(const float *a, const float *b, size_t joints, float t, const float *mask, int slerp, float *out)
{
    float known = t == t ? t : 0.0f;
    if (mask)
        blend_masked(a, b, joints, known, mask, slerp, out);
    else if (!slerp && known > 0.0f && known < 1.0f)
        nlerp_inside(a, b, joints, known, out);
    else
        blend_at(a, b, joints, known, slerp, out);
}

void nkw_pose_blend(const float *a, const float *b, size_t joints, float t, const float *mask, float *out)
{
    blend(a, b, joints, t, mask, 0, out);
}

void nkw_pose_blend_slerp(const float *a, const float *b, size_t joints, float t, const float *mask, float *out)
{
    blend(a, b, joints, t, mask, 1, out);
}

/* many poses */

/* The lerps of the layers so far. Without any mask all lanes share the first one's total, mixed, weight and t. */
typedef struct sum {
    float v[10][BLEND_BLOCK];
    float total[BLEND_BLOCK], mixed[BLEND_BLOCK], weight[BLEND_BLOCK], t[BLEND_BLOCK];
    int masked;
} sum;

/* Orders numbers by their bits. */
static int compare_floats(float a, float b)
{
    uint32_t x = lane_bits(a), y = lane_bits(b);
    return x < y ? -1 : x > y;
}

static int compare_masks(const float *a, const float *b, const part *p)
{
    int order = 0;
    for (size_t j = p->from; order == 0 && (a || b) && j < p->from + p->used; j++)
        order = compare_floats(a ? lane_mask(a[j]) : 1.0f, b ? lane_mask(b[j]) : 1.0f);
    return order;
}

/* Rotations first: they are the least likely to be equal. */
static int compare_poses(const float *a, const float *b, const part *p)
{
    static const unsigned char arrays[10] = {3, 4, 5, 6, 0, 1, 2, 7, 8, 9};
    int order = 0;
    for (size_t c = 0; order == 0 && a != b && c < 10; c++)
        for (size_t j = p->from; order == 0 && j < p->from + p->used; j++)
            order = compare_floats(a[arrays[c] * p->stride + j], b[arrays[c] * p->stride + j]);
    return order;
}

/* Whether layer i is added before layer k. Layers that are the same in all are as good in either order. */
static int is_before(const nkw_pose_layer *layers, size_t i, size_t k, const part *p)
{
    const nkw_pose_layer *a = &layers[i], *b = &layers[k];
    int order = -compare_floats(weight_of(a->weight), weight_of(b->weight));
    order = order ? order : compare_masks(a->mask, b->mask, p);
    order = order ? order : compare_poses(a->pose, b->pose, p);
    return order < 0 || (order == 0 && i < k);
}

/* The layer to be added after `last`, and the first one after `count`; `count` after the last one. */
static size_t next_layer(const nkw_pose_layer *layers, size_t count, size_t last, const part *p)
{
    size_t next = count;
    for (size_t i = 0; i < count; i++)
        if (layers[i].weight > 0.0f && (last == count || is_before(layers, last, i, p)) &&
            (next == count || is_before(layers, i, next, p)))
            next = i;
    return next;
}

/* Array c of the pose, 0 to 9: rotations are 3 to 6. */
static int is_rotation(size_t c)
{
    return c >= 3 && c < 7;
}

/* sum = lerp(sum, pose, t) for each joint's own t. */
static void mix(sum *s, const float *pose, const part *p)
{
    nkw_quat_span q = {s->v[3], s->v[4], s->v[5], s->v[6]};
    nkw_batch_selected()->quat_mix(as_view(q), view_of(pose, p).rotation, s->t, q, p->n);
    for (size_t c = 0; c < 10; c++)
        if (!is_rotation(c))
            nkw_batch_selected()->lerp(s->v[c], pose + c * p->stride + p->from, s->t, s->v[c], p->n);
}

/* The same for one t of all. */
static void mix_at(sum *s, const float *pose, float t, const part *p)
{
    nkw_quat_span q = {s->v[3], s->v[4], s->v[5], s->v[6]};
    if (t < 1.0f)
        nkw_batch_selected()->quat_chord_at(as_view(q), view_of(pose, p).rotation, t, q, p->n);
    for (size_t c = 0; c < 10; c++) {
        const float *to = pose + c * p->stride + p->from;
        if (t == 1.0f)
            memcpy(s->v[c], to, p->n * sizeof(float));
        else if (!is_rotation(c))
            nkw_batch_selected()->lerp_at(s->v[c], to, t, s->v[c], p->n);
    }
}

/* Adds a pose by the weights in s->weight, which are negative nowhere. */
static void add_pose(sum *s, const float *pose, const part *p)
{
    nkw_batch_selected()->blend_share(s->weight, s->total, s->mixed, s->t, s->masked ? p->n : 1);
    if (s->masked)
        mix(s, pose, p);
    else if (s->t[0] > 0.0f)
        mix_at(s, pose, s->t[0], p);
}

/* What the rest pose has to make up for. */
static void weigh_rest(sum *s, float threshold, const part *p)
{
    float limit = weight_of(threshold);
    for (size_t i = 0; i < (s->masked ? p->n : 1); i++) {
        float missing = s->total[i] < limit ? limit - s->total[i] : 0.0f;
        s->weight[i] = s->total[i] == 0.0f ? 1.0f : missing;
    }
}

/* Writes the sums; rotations that more than one pose has a part in are brought to unit length. */
static void settle(const sum *s, const part *p, float *out)
{
    const nkw_batch *batch = nkw_batch_selected();
    nkw_quat_view v = {s->v[3], s->v[4], s->v[5], s->v[6]};
    float *to = out + p->from;
    if (s->masked || s->mixed[0] > 0.0f)
        batch->quat_settle(v, (int)p->used, span_of(out, p).rotation, (int)p->n);
    for (size_t c = 0; c < 10; c++)
        if (!is_rotation(c) || (!s->masked && s->mixed[0] == 0.0f))
            memcpy(to + c * p->stride, s->v[c], p->n * sizeof(float));
        else if (s->masked)
            batch->lerp(s->v[c], to + c * p->stride, s->mixed, to + c * p->stride, p->n);
}

static void blend_part(const nkw_pose_layer *layers, size_t count, const float *rest, float threshold, int masked,
                       const part *p, float *out)
{
    sum s;
    s.masked = masked;
    memset(s.total, 0, sizeof s.total);
    memset(s.mixed, 0, sizeof s.mixed);
    if (masked)
        memset(s.v, 0, sizeof s.v);
    for (size_t i = next_layer(layers, count, count, p); i < count; i = next_layer(layers, count, i, p)) {
        weigh(weight_of(layers[i].weight), layers[i].mask, p, s.weight);
        add_pose(&s, layers[i].pose, p);
    }
    weigh_rest(&s, threshold, p);
    add_pose(&s, rest, p);
    settle(&s, p, out);
}

void nkw_pose_blend_layers(const nkw_pose_layer *layers, size_t count, const float *rest, size_t joints,
                           float threshold, float *out)
{
    int masked = 0;
    for (size_t i = 0; i < count; i++)
        masked = masked || layers[i].mask;
    for (size_t from = 0; from < NKW_POSE_STRIDE(joints); from += BLEND_BLOCK) {
        part p = part_at(joints, from);
        blend_part(layers, count, rest, threshold, masked, &p, out);
    }
}

/* differences */

void nkw_pose_additive_build(const float *a, const float *ref, size_t joints, nkw_additive side, float *out)
{
    nkw_batch_selected()->additive_build(nkw_pose_view(a, joints), nkw_pose_view(ref, joints),
                                         side == NKW_ADDITIVE_PARENT, nkw_pose_span(out, joints),
                                         NKW_POSE_STRIDE(joints));
}

void nkw_pose_additive_apply(const float *base, const float *delta, size_t joints, nkw_additive side, float weight,
                             const float *mask, float *out)
{
    for (size_t from = 0; from < NKW_POSE_STRIDE(joints); from += BLEND_BLOCK) {
        part p = part_at(joints, from);
        float w[BLEND_BLOCK];
        weigh(weight_of(weight), mask, &p, w);
        nkw_batch_selected()->additive_apply(view_of(base, &p), view_of(delta, &p), w, side == NKW_ADDITIVE_PARENT,
                                             span_of(out, &p), p.n);
    }
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

void nkw_pose_mirror(const float *pose, const int32_t *pair, size_t joints, nkw_mirror plane, float *out)
{
    size_t normal = plane == NKW_MIRROR_Y ? 1 : plane == NKW_MIRROR_Z ? 2 : 0;
    float sign[10] = {1, 1, 1, -1, -1, -1, 1, 1, 1, 1};
    sign[normal] = -1.0f;
    sign[3 + normal] = 1.0f;
    for (size_t j = 0; j < joints; j++) {
        size_t k = is_paired(pair, joints, j) ? (size_t)pair[j] : j;
        if (j <= k)
            mirror_pair(pose, NKW_POSE_STRIDE(joints), j, k, sign, out);
    }
}

nkw_result nkw_mirror_validate(const int32_t *pair, size_t joints, size_t *bad_joint)
{
    nkw_result result = joints == 0 ? NKW_EMPTY : NKW_OK;
    size_t bad = 0;
    for (size_t j = 0; result == NKW_OK && j < joints; j++) {
        if (pair[j] < 0 || (size_t)pair[j] >= joints)
            result = NKW_OUT_OF_RANGE;
        else if (!is_paired(pair, joints, j))
            result = NKW_NOT_PAIRED;
        bad = result == NKW_OK ? 0 : j;
    }
    if (bad_joint)
        *bad_joint = bad;
    return result;
}

void nkw_mask_from_subtree(const int32_t *parents, size_t joints, size_t root, float *mask)
{
    for (size_t j = 0; j < NKW_POSE_STRIDE(joints); j++) {
        int below = j < joints && parents[j] >= 0 && (size_t)parents[j] < j && mask[parents[j]] == 1.0f;
        mask[j] = j < joints && (j == root || below) ? 1.0f : 0.0f;
    }
}
