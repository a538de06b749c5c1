/* SPDX-License-Identifier: MIT */
/* The mean of many poses by their weights. */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/blend.h>

#include "batch/blend.h"
#include "lane/blend.h"
#include "lane/quat_mean.h"
#include "lane/scalar.h"
#include "pose/blend_part.h"
#include "sizes.h"

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

/*
 * The signs of rotations. With s_ik = -1 where q_i . q_k < 0, else 1, and the weights w_i of a joint:
 *
 *     A = sum over i and k of w_i w_k s_ik q_i q_k^T        mean = the eigenvector of the largest eigenvalue of A
 *
 * If signs s_i exist with s_ik = s_i s_k for all pairs, A = v v^T with v = sum s_i w_i q_i: the mean is v made unit, and
 * the chain of lerps adds with these signs. They exist for two rotations, and where all q_i are within 45 degrees of
 * one of them up to sign, as vectors. Otherwise the eigenvector is computed: A is continuous in the weights, so the
 * mean is continuous wherever the largest eigenvalue is simple. No mean of which each pair takes the shorter arc is
 * continuous everywhere: around 0, 120 and 240 degrees about one axis three shorter arcs make a whole turn.
 */
typedef struct member {
    lane_f64_quat q;
    double weight;
} member;

/* The layers of a joint that have a weight, the heaviest first, and the rest pose. */
typedef struct members {
    member at[BLEND_SIGNED + 1];
    size_t count;
} members;

static lane_f64_quat on_side_of(lane_f64_quat a, lane_f64_quat q)
{
    return lane_f64_quat_scale(q, lane_f64_quat_dot(a, q) < 0.0 ? -1.0 : 1.0);
}

/* Of all only the signs are changed: none has a negative dot product with the first. */
static void add_member(members *all, const float *pose, float weight, const part *p, size_t joint)
{
    const float *x = pose + 3 * p->stride + p->from + joint;
    const nkw_quat q = {x[0], x[p->stride], x[2 * p->stride], x[3 * p->stride]};
    const lane_f64_quat r = lane_f64_quat_from(q);
    const member m = {all->count > 0 ? on_side_of(all->at[0].q, r) : r, (double)weight};
    if (weight > 0.0f)
        all->at[all->count++] = m;
}

static int signs_agree(const members *all)
{
    for (size_t i = 2; i < all->count; i++)
        for (size_t k = 1; k < i; k++)
            if (lane_f64_quat_dot(all->at[i].q, all->at[k].q) < 0.0)
                return 0;
    return 1;
}

/* A. */
static lane_f64_form signed_form(const members *all)
{
    const lane_f64_quat zero = {0.0, 0.0, 0.0, 0.0};
    lane_f64_form form = {zero, zero, zero, zero};
    for (const member *a = all->at; a < all->at + all->count; a++) {
        lane_f64_quat sum = zero;
        for (const member *b = all->at; b < all->at + all->count; b++)
            sum = lane_f64_quat_add(sum, lane_f64_quat_scale(on_side_of(a->q, b->q), b->weight));
        form = lane_f64_form_added(&form, lane_f64_quat_scale(a->q, a->weight), sum);
    }
    return form;
}

/*
 * Some eigenvalues of A may be negative; those of A / |A| + 1 are not, |A| the Frobenius norm. Returns 0 where the chain
 * of lerps has the mean.
 */
static int mean_by_form(const members *all, nkw_quat *mean)
{
    if (signs_agree(all))
        return 0;
    lane_f64_form m = signed_form(all);
    const double norm = lane_sqrt64((lane_f64_quat_dot(m.x, m.x) + lane_f64_quat_dot(m.y, m.y)) +
                                    (lane_f64_quat_dot(m.z, m.z) + lane_f64_quat_dot(m.w, m.w)));
    if (!(norm > 0.0) || !(norm < INFINITY))
        return 0;
    m = lane_f64_form_scale(&m, 1.0 / norm);
    m.x.x += 1.0;
    m.y.y += 1.0;
    m.z.z += 1.0;
    m.w.w += 1.0;
    const lane_f64_quat axis = lane_f64_form_axis(m);
    *mean = lane_quat_from_f64(on_side_of(all->at[0].q, axis));
    return 1;
}

/* Whether the rest pose takes no weight at any joint: the layers without masks reach the threshold. */
static int is_whole(const nkw_pose_layer *layers, size_t count, float threshold)
{
    double total = 0.0;
    for (size_t i = 0; i < count; i++)
        total += layers[i].mask.data ? 0.0 : (double)weight_of(layers[i].weight);
    return total > 0.0 && !(lane_missing(total, threshold) > 0.0f);
}

/* The poses of the layers that have a weight, after the rest pose if it can have one. */
typedef struct rotations {
    const float *pose[BLEND_SIGNED + 1];
    size_t count;
} rotations;

/* No poses for layers whose signs always agree, and for more than BLEND_SIGNED. */
static void list_rotations(const nkw_pose_layer *layers, size_t count, const float *rest, rotations *r)
{
    const size_t most = BLEND_SIGNED + (rest ? 1 : 0);
    r->count = 0;
    if (rest)
        r->pose[r->count++] = rest;
    for (size_t i = 0; i < count; i++) {
        if (!(layers[i].weight > 0.0f))
            continue;
        if (r->count == most) {
            r->count = 0;
            return;
        }
        r->pose[r->count++] = layers[i].pose.data;
    }
    r->count = r->count > 2 ? r->count : 0;
}

/* Marks the joints of a part at which the signs of three rotations do not agree. */
NKW_NOINLINE static int find_frustrated(const rotations *r, const part *p, float *marks)
{
    const blend_rows first = rows_of(r->pose[0], p);
    int any = 0;
    memset(marks, 0, p->n * sizeof *marks);
    for (size_t i = 2; i < r->count; i++)
        for (size_t k = 1; k < i; k++)
            nkwi_blend_disagree(first, rows_of(r->pose[i], p), rows_of(r->pose[k], p), (int)p->used, marks, &any);
    return any;
}

/* The same, but first whether any rotation is far from the first one: the usual poses are near each other. */
static int find_apart(const rotations *r, const part *p, float *marks)
{
    int far = 0;
    if (r->count > 0)
        nkwi_blend_far(r->pose, r->count, p->stride, p->from, (int)p->used, &far);
    return far && find_frustrated(r, p, marks);
}

/* What a call does with each part. */
typedef struct blending {
    const nkw_pose_layer *layers;
    size_t count;
    const float *rest;
    float threshold;
    int is_masked;
} blending;

static void blend_chain(const blending *b, const part *p, float *out)
{
    if (b->is_masked)
        blend_with_masks(b->layers, b->count, b->rest, b->threshold, p, out);
    else
        blend_plain(b->layers, b->count, b->rest, b->threshold, p, out);
}

/* The layers of a part that have a weight, sorted: at most BLEND_SIGNED. */
typedef struct sorted {
    const nkw_pose_layer *at[BLEND_SIGNED];
    size_t count;
} sorted;

NKW_NOINLINE static int mean_of_joint(const blending *b, const sorted *layers, const part *p, size_t joint,
                                      nkw_quat *mean)
{
    members all;
    double total = 0.0;
    all.count = 0;
    for (size_t i = 0; i < layers->count; i++) {
        const nkw_pose_layer *l = layers->at[i];
        const float mask = l->mask.data ? lane_mask(l->mask.data[p->from + joint]) : 1.0f;
        const float weight = weight_of(l->weight) * mask;
        add_member(&all, l->pose.data, weight, p, joint);
        total += (double)weight;
    }
    if (b->rest)
        add_member(&all, b->rest, lane_missing(total, b->threshold), p, joint);
    return mean_by_form(&all, mean);
}

/* The chain, and the rotations of the joints that are marked. These come first: out may be a layer. */
NKW_NOINLINE static void blend_marked(const blending *b, const part *p, const float *marks, float *out)
{
    nkw_quat mean[BLEND_BLOCK];
    unsigned char joint[BLEND_BLOCK];
    size_t count = 0;
    sorted layers;
    queue q;
    layers.count = 0;
    begin_queue(&q, b->layers, b->count, p);
    for (const nkw_pose_layer *l = next_layer(&q); l; l = next_layer(&q))
        layers.at[layers.count++] = l;
    for (size_t j = 0; j < p->used; j++)
        if (lane_bits(marks[j]) != 0 && mean_of_joint(b, &layers, p, j, &mean[count]))
            joint[count++] = (unsigned char)j;
    blend_chain(b, p, out);
    const nkw_quat_span to = span_of(out, p).rotation;
    for (size_t k = 0; k < count; k++) {
        to.x[joint[k]] = mean[k].x;
        to.y[joint[k]] = mean[k].y;
        to.z[joint[k]] = mean[k].z;
        to.w[joint[k]] = mean[k].w;
    }
}

nkw_result nkw_pose_layers_blend(const nkw_pose_layer *layers, size_t layer_count, nkw_pose_view rest, float threshold,
                                 nkw_pose_span out)
{
    const size_t joints = out.joint_count;
    if (rest.joint_count != joints || !all_fit(layers, layer_count, joints))
        return NKW_MISMATCHED;
    if (joints == 0)
        return NKW_OK;
    const float limit = weight_of(threshold);
    const blending b = {layers, layer_count, rest.data, limit, has_mask(layers, layer_count)};
    rotations r;
    list_rotations(layers, layer_count, is_whole(layers, layer_count, limit) ? NULL : rest.data, &r);
    for (size_t from = 0; from < NKW_POSE_STRIDE(joints); from += BLEND_BLOCK) {
        const part p = part_at(joints, from);
        float marks[BLEND_BLOCK];
        if (find_apart(&r, &p, marks))
            blend_marked(&b, &p, marks, out.data);
        else
            blend_chain(&b, &p, out.data);
    }
    return NKW_OK;
}
