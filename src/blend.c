/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/blend.h>

#include "lane/blend.h"
#include "report.h"
#include "simd/select.h"

/* The most that a weight counts. */
#define HEAVIEST  0x1p60f
#define ABOVE_ALL 0x1p61f

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
    return w < HEAVIEST ? w : HEAVIEST;
}

/* The joints' own weights: weight * mask. */
static void weigh(float weight, const float *mask, const part *p, float *out)
{
    if (mask)
        nkw_batch_selected()->blend_weigh(weight, mask + p->from, (int)p->used, out, (int)p->n);
    else
        for (size_t i = 0; i < p->n; i++)
            out[i] = i < p->used ? weight : 0.0f;
}

/* two poses */

static void nlerp_inside(const float *a, const float *b, size_t joints, float t, float *out)
{
    for (size_t from = 0; from < NKW_POSE_STRIDE(joints); from += BLEND_BLOCK) {
        part p = part_at(joints, from);
        nkw_batch_selected()->blend_nlerp(rows_of(a, &p), rows_of(b, &p), t, (int)p.used, rows_span(out, &p), (int)p.n);
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

/* nkw_pose_blend_slerp by a t for each joint. */
static void slerp_each(const float *a, const float *b, const float *t, const part *p, float *out)
{
    const nkw_batch *batch = nkw_batch_selected();
    nkw_trs_view va = view_of(a, p), vb = view_of(b, p);
    nkw_trs_span vo = span_of(out, p);
    batch->vec3_lerp(va.translation, vb.translation, t, vo.translation, p->n);
    batch->quat_slerp(va.rotation, vb.rotation, t, vo.rotation, p->n);
    batch->vec3_lerp(va.scale, vb.scale, t, vo.scale, p->n);
}

static void blend_masked(const float *a, const float *b, size_t joints, float t, const float *mask, int slerp,
                         float *out)
{
    for (size_t from = 0; from < NKW_POSE_STRIDE(joints); from += BLEND_BLOCK) {
        part p = part_at(joints, from);
        float ts[BLEND_BLOCK];
        weigh(t, mask, &p, ts);
        if (slerp)
            slerp_each(a, b, ts, &p, out);
        else
            nkw_batch_selected()->blend_each(rows_of(a, &p), rows_of(b, &p), ts, (int)p.used, rows_span(out, &p),
                                             (int)p.n);
    }
}

static void blend(const float *a, const float *b, size_t joints, float t, const float *mask, int slerp, float *out)
{
    float known = t == t ? t : 0.0f;
    if (joints == 0)
        return;
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

/* The layers of one weight: how many, and the first of them. */
typedef struct peers {
    const nkw_pose_layer *layers;
    size_t layer_count; /* of any weight */
    float weight;
    size_t count, first;
} peers;

/* Those of the largest weight below another one. */
static peers peers_below(const nkw_pose_layer *layers, size_t count, float weight)
{
    peers r = {layers, count, 0.0f, 0, count};
    for (size_t i = count; i-- > 0;) {
        float w = weight_of(layers[i].weight);
        if (!(w > 0.0f && w < weight && w >= r.weight))
            continue;
        r.count = w > r.weight ? 1 : r.count + 1;
        r.weight = w;
        r.first = i;
    }
    return r;
}

static int is_peer(const peers *g, size_t i)
{
    return weight_of(g->layers[i].weight) == g->weight;
}

static void copy_rows(blend_rows from, blend_span to, size_t n)
{
    for (size_t c = 0; c < 10; c++)
        memmove(to.at + c * to.stride, from.at + c * from.stride, n * sizeof(float));
}

/* Of so many turns the order is worked out together. */
#define TURNS 8

/*
 * Layers of one weight take turns, joint by joint in an order that follows from the joint's own numbers: `layer` has
 * those of TURNS turns.
 */
typedef struct turns {
    uint32_t layer[TURNS][BLEND_BLOCK];
    float pose[2][10 * BLEND_BLOCK], weight[BLEND_BLOCK];
} turns;

/* How many of layer i's peers go before it, joint by joint. */
static void rank_layer(const peers *g, size_t i, const part *p, uint32_t *rank)
{
    const nkw_pose_layer *layer = &g->layers[i];
    float mask[BLEND_BLOCK], other_mask[BLEND_BLOCK];
    memset(rank, 0, p->n * sizeof *rank);
    weigh(1.0f, layer->mask, p, mask);
    for (size_t k = g->first; k < g->layer_count; k++) {
        const nkw_pose_layer *other = &g->layers[k];
        if (k == i || !is_peer(g, k))
            continue;
        weigh(1.0f, other->mask, p, other_mask);
        nkw_batch_selected()->blend_rank(rows_of(layer->pose, p), rows_of(other->pose, p), mask, other_mask, k < i,
                                         rank, (int)p->n);
    }
}

/* Finds the layers of the turns from `turn` on. */
static void order_layers(turns *s, const peers *g, uint32_t turn, const part *p)
{
    for (size_t i = g->first; i < g->layer_count; i++) {
        uint32_t rank[BLEND_BLOCK];
        if (!is_peer(g, i))
            continue;
        rank_layer(g, i, p, rank);
        for (size_t j = 0; j < p->n; j++)
            if (rank[j] >= turn && rank[j] - turn < TURNS)
                s->layer[rank[j] - turn][j] = (uint32_t)i;
    }
}

/* The pose of the joints whose turn it is, into `out`, and their weights, s->weight. */
static blend_rows take_turn(turns *s, const peers *g, uint32_t turn, const part *p, float *out)
{
    blend_rows pose = {out, p->n};
    const uint32_t *layer = s->layer[turn % TURNS];
    if (turn % TURNS == 0)
        order_layers(s, g, turn, p);
    for (size_t j = 0; j < p->n; j++) {
        const nkw_pose_layer *from = &g->layers[layer[j]];
        const float *at = from->pose + p->from + j, *mask = from->mask;
        s->weight[j] = j < p->used ? g->weight * (mask ? lane_mask(mask[p->from + j]) : 1.0f) : 0.0f;
        for (size_t c = 0; c < 10; c++)
            out[c * p->n + j] = at[c * p->stride];
    }
    return pose;
}

/* What the rest pose has to make up for, which may be the most of all; all, where there is nothing else. */
static float missing(double total, float threshold)
{
    double limit = (double)weight_of(threshold);
    double short_of = total < limit ? limit - total : 0.0;
    return total == 0.0 ? 1.0f : (float)short_of;
}

/*
 * Layers without masks: sum = lerp(sum, pose, weight / (total + weight)), one pose behind, for with the last one the
 * rotations are normalised in the same loop. The sum begins as the first pose where it lies.
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
        nkw_batch_selected()->blend_chord(s->sum, s->last, s->t, v, (int)p->n);
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
        any |= layers[i].mask && weight_of(layers[i].weight) > 0.0f;
    return any;
}

/*
 * Where a turn's pose may go: the first one of all where the sum will be, then to and fro, for the one before is not
 * added yet.
 */
static float *place_of_turn(plain_sum *s, turns *t)
{
    return s->total == 0.0 ? s->v : t->pose[s->last.at == t->pose[0]];
}

static void blend_plain(const nkw_pose_layer *layers, size_t count, const float *rest, float threshold, const part *p,
                        float *out)
{
    plain_sum s;
    turns t;
    s.total = 0.0;
    s.t = 0.0f;
    for (peers g = peers_below(layers, count, ABOVE_ALL); g.count; g = peers_below(layers, count, g.weight)) {
        if (g.count == 1)
            add_plain(&s, rows_of(layers[g.first].pose, p), g.weight, p);
        for (uint32_t turn = 0; g.count > 1 && turn < g.count; turn++)
            add_plain(&s, take_turn(&t, &g, turn, p, place_of_turn(&s, &t)), g.weight, p);
    }
    add_plain(&s, rows_of(rest, p), missing(s.total, threshold), p);
    if (s.t > 0.0f)
        nkw_batch_selected()->blend_nlerp(s.sum, s.last, s.t, (int)p->used, rows_span(out, p), (int)p->n);
    else
        copy_rows(s.sum, rows_span(out, p), p->n);
}

/*
 * The same with totals and parts for each joint of its own. mixed is 1 where more than one pose has a part. The first
 * pose is taken whole: where it has no weight, the next one's part is 1.
 */
typedef struct masked_sum {
    float v[10 * BLEND_BLOCK];
    double total[BLEND_BLOCK];
    float mixed[BLEND_BLOCK], t[BLEND_BLOCK];
    int begun;
} masked_sum;

/* Adds a pose by its joints' weights. */
static void add_masked(masked_sum *s, blend_rows rows, const float *weight, const part *p)
{
    const nkw_batch *batch = nkw_batch_selected();
    blend_span v = {s->v, p->n};
    batch->blend_share(weight, s->total, s->mixed, s->t, p->n);
    if (s->begun)
        batch->blend_mix(rows, s->t, v, (int)p->n);
    else
        copy_rows(rows, v, p->n);
    s->begun = 1;
}

static void add_rest(masked_sum *s, const float *rest, float threshold, const part *p)
{
    float weight[BLEND_BLOCK];
    int any = 0;
    for (size_t i = 0; i < p->n; i++) {
        weight[i] = missing(s->total[i], threshold);
        any |= i < p->used && weight[i] > 0.0f;
    }
    if (any)
        add_masked(s, rows_of(rest, p), weight, p);
}

static void blend_with_masks(const nkw_pose_layer *layers, size_t count, const float *rest, float threshold,
                             const part *p, float *out)
{
    masked_sum s;
    turns t;
    float unit[4][BLEND_BLOCK];
    nkw_quat_span units = {unit[0], unit[1], unit[2], unit[3]};
    blend_rows sum = {s.v, p->n};
    memset(s.total, 0, sizeof s.total);
    memset(s.mixed, 0, sizeof s.mixed);
    s.begun = 0;
    for (peers g = peers_below(layers, count, ABOVE_ALL); g.count; g = peers_below(layers, count, g.weight)) {
        float weight[BLEND_BLOCK];
        weigh(g.weight, layers[g.first].mask, p, weight);
        if (g.count == 1)
            add_masked(&s, rows_of(layers[g.first].pose, p), weight, p);
        for (uint32_t turn = 0; g.count > 1 && turn < g.count; turn++) {
            blend_rows pose = take_turn(&t, &g, turn, p, t.pose[0]);
            add_masked(&s, pose, t.weight, p);
        }
    }
    add_rest(&s, rest, threshold, p);
    nkw_batch_selected()->quat_settle(nkw_pose_view(s.v, p->n).rotation, (int)p->used, units, (int)p->n);
    for (size_t c = 0; c < 4; c++) {
        float *q = s.v + (3 + c) * p->n;
        nkw_batch_selected()->lerp(q, unit[c], s.mixed, q, p->n);
    }
    copy_rows(sum, rows_span(out, p), p->n);
}

void nkw_pose_blend_layers(const nkw_pose_layer *layers, size_t count, const float *rest, size_t joints,
                           float threshold, float *out)
{
    int masked = has_mask(layers, count);
    for (size_t from = 0; from < NKW_POSE_STRIDE(joints); from += BLEND_BLOCK) {
        part p = part_at(joints, from);
        if (masked)
            blend_with_masks(layers, count, rest, threshold, &p, out);
        else
            blend_plain(layers, count, rest, threshold, &p, out);
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
        bad = j;
    }
    return report(result, bad, bad_joint);
}

void nkw_mask_from_subtree(const int32_t *parents, size_t joints, size_t root, float *mask)
{
    for (size_t j = 0; j < NKW_POSE_STRIDE(joints); j++) {
        int below = j < joints && parents[j] >= 0 && (size_t)parents[j] < j && mask[parents[j]] == 1.0f;
        mask[j] = j < joints && (j == root || below) ? 1.0f : 0.0f;
    }
}
