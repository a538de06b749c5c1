/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/blend.h>

#include "lane/blend.h"
#include "simd/select.h"

/* Joints that are worked on at once, with what they need on the stack; all of a pose's inputs before any output. */
#define BLOCK 128

/* The most that a weight counts. */
#define HEAVIEST 0x1p60f

/* `n` lanes of poses from joint `from` on, padding included; `stride` of the whole pose. */
typedef struct part {
    size_t joints, stride, from, n;
} part;

static part part_at(size_t joints, size_t from)
{
    part p = {joints, NKW_POSE_STRIDE(joints), from, NKW_POSE_STRIDE(joints) - from};
    p.n = p.n < BLOCK ? p.n : BLOCK;
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

typedef void rotations_at(nkw_quat_view a, nkw_quat_view b, float t, nkw_quat_span out, size_t n);
typedef void rotations(nkw_quat_view a, nkw_quat_view b, const float *t, nkw_quat_span out, size_t n);

/* nkw_quat_nlerp in two loops, between which no lane waits for the other's root. */
static void nlerp_inside(nkw_quat_view a, nkw_quat_view b, float t, nkw_quat_span out, size_t n)
{
    float v[4][BLOCK];
    nkw_quat_span chord = {v[0], v[1], v[2], v[3]};
    nkw_batch_selected()->quat_mix_at(a, b, t, chord, n);
    nkw_batch_selected()->quat_settle(as_view(chord), out, n);
}

static void blend_at(const float *a, const float *b, size_t joints, float t, rotations_at *turn, float *out)
{
    const nkw_batch *batch = nkw_batch_selected();
    size_t stride = NKW_POSE_STRIDE(joints), scales = 7 * stride;
    batch->lerp_at(a, b, t, out, 3 * stride);
    for (size_t from = 0; from < stride; from += BLOCK) {
        part p = part_at(joints, from);
        turn(view_of(a, &p).rotation, view_of(b, &p).rotation, t, span_of(out, &p).rotation, p.n);
    }
    batch->lerp_at(a + scales, b + scales, t, out + scales, 3 * stride);
}

static void blend_masked(const float *a, const float *b, size_t joints, float t, const float *mask, rotations *turn,
                         float *out)
{
    const nkw_batch *batch = nkw_batch_selected();
    for (size_t from = 0; from < NKW_POSE_STRIDE(joints); from += BLOCK) {
        part p = part_at(joints, from);
        float ts[BLOCK];
        weigh(t, mask, &p, ts);
        nkw_trs_view va = view_of(a, &p), vb = view_of(b, &p);
        nkw_trs_span vo = span_of(out, &p);
        batch->vec3_lerp(va.translation, vb.translation, ts, vo.translation, p.n);
        turn(va.rotation, vb.rotation, ts, vo.rotation, p.n);
        batch->vec3_lerp(va.scale, vb.scale, ts, vo.scale, p.n);
    }
}

void nkw_pose_blend(const float *a, const float *b, size_t joints, float t, const float *mask, float *out)
{
    const nkw_batch *batch = nkw_batch_selected();
    float known = t == t ? t : 0.0f;
    int inside = known > 0.0f && known < 1.0f;
    if (mask)
        blend_masked(a, b, joints, known, mask, batch->quat_nlerp, out);
    else
        blend_at(a, b, joints, known, inside ? nlerp_inside : batch->quat_nlerp_at, out);
}

void nkw_pose_blend_slerp(const float *a, const float *b, size_t joints, float t, const float *mask, float *out)
{
    const nkw_batch *batch = nkw_batch_selected();
    float known = t == t ? t : 0.0f;
    if (mask)
        blend_masked(a, b, joints, known, mask, batch->quat_slerp, out);
    else
        blend_at(a, b, joints, known, batch->quat_slerp_at, out);
}

/* many poses */

/* The lerps of the layers so far. Without any mask all lanes share the first one's total, mixed and t. */
typedef struct sum {
    float v[10][BLOCK];
    float total[BLOCK], mixed[BLOCK], weight[BLOCK], t[BLOCK];
    int masked, begun;
} sum;

static const float ZEROS[BLOCK];

/* Orders numbers by their bits. */
static int compare_floats(float a, float b)
{
    uint32_t x = lane_bits(a), y = lane_bits(b);
    return x < y ? -1 : x > y;
}

static int compare_masks(const float *a, const float *b, const part *p)
{
    int order = 0;
    for (size_t j = p->from; order == 0 && (a || b) && j < p->from + p->n && j < p->joints; j++)
        order = compare_floats(a ? lane_mask(a[j]) : 1.0f, b ? lane_mask(b[j]) : 1.0f);
    return order;
}

/* Rotations first: they are the least likely to be equal. */
static int compare_poses(const float *a, const float *b, const part *p)
{
    static const unsigned char arrays[10] = {3, 4, 5, 6, 0, 1, 2, 7, 8, 9};
    int order = 0;
    for (size_t c = 0; order == 0 && a != b && c < 10; c++)
        for (size_t j = p->from; order == 0 && j < p->from + p->n && j < p->joints; j++)
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

/* sum = lerp(sum, pose, weight / (total + weight)) */
static void add_pose(sum *s, const float *pose, const part *p)
{
    const nkw_batch *batch = nkw_batch_selected();
    batch->blend_share(s->weight, s->total, s->mixed, s->t, s->masked ? p->n : 1);
    const float *from[10];
    for (size_t c = 0; c < 10; c++)
        from[c] = s->begun ? s->v[c] : ZEROS;
    for (size_t c = 0; c < 10; c++) {
        const float *to = pose + c * p->stride + p->from;
        if (c >= 3 && c < 7)
            continue;
        if (s->masked)
            batch->lerp(from[c], to, s->t, s->v[c], p->n);
        else
            batch->lerp_at(from[c], to, s->t[0], s->v[c], p->n);
    }
    nkw_quat_view a = {from[3], from[4], from[5], from[6]}, b = view_of(pose, p).rotation;
    nkw_quat_span out = {s->v[3], s->v[4], s->v[5], s->v[6]};
    if (s->masked)
        batch->quat_mix(a, b, s->t, out, p->n);
    else
        batch->quat_mix_at(a, b, s->t[0], out, p->n);
    s->begun = 1;
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

/* Rotations that more than one pose has a part in are brought to unit length. */
static void settle(sum *s, const part *p)
{
    float unit[4][BLOCK];
    nkw_quat_span v = {s->v[3], s->v[4], s->v[5], s->v[6]}, out = {unit[0], unit[1], unit[2], unit[3]};
    const nkw_batch *batch = nkw_batch_selected();
    batch->quat_settle(as_view(v), out, p->n);
    for (size_t c = 0; c < 4; c++)
        if (s->masked)
            batch->lerp(s->v[3 + c], unit[c], s->mixed, s->v[3 + c], p->n);
        else
            batch->lerp_at(s->v[3 + c], unit[c], s->mixed[0], s->v[3 + c], p->n);
}

static void blend_part(const nkw_pose_layer *layers, size_t count, const float *rest, float threshold, int masked,
                       const part *p, float *out)
{
    sum s;
    s.masked = masked;
    s.begun = 0;
    memset(s.total, 0, sizeof s.total);
    memset(s.mixed, 0, sizeof s.mixed);
    for (size_t i = next_layer(layers, count, count, p); i < count; i = next_layer(layers, count, i, p)) {
        weigh(weight_of(layers[i].weight), layers[i].mask, p, s.weight);
        add_pose(&s, layers[i].pose, p);
    }
    weigh_rest(&s, threshold, p);
    add_pose(&s, rest, p);
    settle(&s, p);
    for (size_t c = 0; c < 10; c++)
        memcpy(out + c * p->stride + p->from, s.v[c], p->n * sizeof(float));
}

void nkw_pose_blend_layers(const nkw_pose_layer *layers, size_t count, const float *rest, size_t joints,
                           float threshold, float *out)
{
    int masked = 0;
    for (size_t i = 0; i < count; i++)
        masked = masked || layers[i].mask;
    for (size_t from = 0; from < NKW_POSE_STRIDE(joints); from += BLOCK) {
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
    for (size_t from = 0; from < NKW_POSE_STRIDE(joints); from += BLOCK) {
        part p = part_at(joints, from);
        float w[BLOCK];
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
