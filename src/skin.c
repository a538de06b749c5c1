/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/palette.h>
#include <nakawari/skin.h>

#include "batch/skin.h"
#include "lane/skin.h"
#include "report.h"

/* What of a skin can be used: no influences where a format is not for it. */
typedef struct plan {
    nkw_skin_view joints, weights;
    size_t vertices, influences;
    uint32_t limit; /* joints in the palette */
    int raw; /* directions as blended */
} plan;

static int is_for_joints(nkw_skin_format format)
{
    return format == NKW_SKIN_U8 || format == NKW_SKIN_U16 || format == NKW_SKIN_U32;
}

static int is_for_weights(nkw_skin_format format)
{
    return format == NKW_SKIN_U8 || format == NKW_SKIN_U16 || format == NKW_SKIN_F32;
}

static size_t stride_of(size_t stride, nkw_skin_format format, size_t influences)
{
    return stride ? stride : influences * lane_skin_format_size(format);
}

static plan plan_of(const nkw_skin *skin, size_t joints, int raw)
{
    plan r = {skin->joints, skin->weights, skin->vertex_count, skin->influence_count, UINT32_MAX, raw};
    r.joints.stride = stride_of(r.joints.stride, r.joints.format, r.influences);
    r.weights.stride = stride_of(r.weights.stride, r.weights.format, r.influences);
    r.influences = r.influences < NKW_SKIN_INFLUENCES ? r.influences : NKW_SKIN_INFLUENCES;
    if (joints < UINT32_MAX)
        r.limit = (uint32_t)joints;
    if (joints == 0 || !is_for_joints(r.joints.format) || !is_for_weights(r.weights.format))
        r.influences = 0;
    return r;
}

/* The palette of either method: matrices or dual is NULL. */
typedef struct transforms {
    const nkw_mat4 *matrices;
    const nkw_mat3 *normals;
    const nkw_dual_quat *dual;
} transforms;

static const void *influences_at(const nkw_skin_view *v, size_t from)
{
    return (const unsigned char *)v->data + from * v->stride;
}

static void decode_block(const plan *p, size_t from, size_t n, skin_block *b)
{
    nkw_skin_view joints = p->joints, weights = p->weights;
    if (p->influences == 0) {
        memset(b->moved, 0, sizeof b->moved);
        return;
    }
    joints.data = influences_at(&p->joints, from);
    weights.data = influences_at(&p->weights, from);
    nkwi_skin_decode(b, &joints, p->limit, &weights, p->influences, n);
}

/* The block's matrices, and those of the normals if they are asked for: gives where the latter stand. */
static const float *blend_block(const plan *p, const transforms *t, int normals, size_t from, size_t n, skin_block *b)
{
    size_t padded = (n + 3) / 4 * 4;
    if (p->influences == 0) {
        memset(b, 0, sizeof *b);
        return b->matrix;
    }
    decode_block(p, from, n, b);
    if (t->dual) {
        nkwi_skin_blend_dual_quats(b, t->dual, p->influences, padded);
        return b->matrix;
    }
    nkwi_skin_blend(b, t->matrices, p->influences, padded);
    if (!normals || !t->normals)
        return b->matrix;
    nkwi_skin_blend_normals(b, t->normals, p->influences, padded);
    return b->normal;
}

static void move(const plan *p, const skin_block *b, const float *m, nkw_vec3_view in, nkw_vec3_span out, size_t n)
{
    if (m)
        nkwi_skin_directions(b, m, p->raw, in, out, n);
    else
        nkwi_skin_points(b, in, out, n);
}

static size_t block_at(const plan *p, size_t from)
{
    return p->vertices - from < SKIN_BLOCK ? p->vertices - from : SKIN_BLOCK;
}

/* Strides of 0 where there is none: no place is worked out from NULL. */
static skin_stream stream_at(nkw_vec3_stream_view in, nkw_vec3_stream_span out, size_t from)
{
    size_t in_stride = in.stride ? in.stride : sizeof(nkw_vec3),
           out_stride = out.stride ? out.stride : sizeof(nkw_vec3);
    skin_stream r = {NULL, NULL, 0, 0};
    if (!in.data || !out.data)
        return r;
    r.in = (const unsigned char *)in.data + from * in_stride;
    r.out = (unsigned char *)out.data + from * out_stride;
    r.in_stride = in_stride;
    r.out_stride = out_stride;
    return r;
}

/* m NULL: positions. */
static void move_stream(const plan *p, skin_block *b, const float *m, nkw_vec3_stream_view in, nkw_vec3_stream_span out,
                        size_t from, size_t n)
{
    const skin_stream s = stream_at(in, out, from);
    float *v = b->vector;
    nkw_vec3_view view = {v, v + SKIN_BLOCK, v + 2 * SKIN_BLOCK};
    nkw_vec3_span span = {v, v + SKIN_BLOCK, v + 2 * SKIN_BLOCK};
    if (!s.in_stride)
        return;
    nkwi_skin_read(s.in, s.in_stride, v, n);
    move(p, b, m, view, span, n);
    nkwi_skin_write(v, s.out, s.out_stride, n);
}

/* What a pass over the influences moves: positions or none, and one kind of directions or none. */
static void run_pass(const plan *p, const skin_influences *f, const nkw_mat4 *palette, const skin_stream *positions,
                     const skin_stream *directions, size_t from, size_t n)
{
    if (positions->in_stride || directions->in_stride)
        nkwi_skin_pairs(f, palette, positions, directions, p->raw, p->vertices - from - n, n);
}

/*
 * Positions and normals by one matrix, which stays in registers, unless normals have their own; tangents and bitangents
 * by the same once more. Weights that are not floats are made so, a block at a time.
 */
static void run_pairs(const plan *p, const nkw_mat4 *palette, const nkw_mat4 *normal_palette,
                      const nkw_vertices_view *in, const nkw_vertices_span *out)
{
    const skin_stream none = {NULL, NULL, 0, 0};
    skin_influences f = {p->joints, p->weights, p->influences, p->limit};
    int decoded = p->influences && p->weights.format != NKW_SKIN_F32;
    size_t n = p->vertices;
    skin_block b;
    nkw_skin_view nowhere = {&b, 0, NKW_SKIN_F32};
    if (p->influences == 0)
        f.joints = f.weights = nowhere;
    for (size_t from = 0; from < p->vertices; from += n) {
        skin_stream positions = stream_at(in->positions, out->positions, from);
        skin_stream normals = stream_at(in->normals, out->normals, from);
        skin_stream tangents = stream_at(in->tangents, out->tangents, from);
        skin_stream bitangents = stream_at(in->bitangents, out->bitangents, from);
        if (decoded) {
            nkw_skin_view joints = {b.joint, 4 * p->influences, NKW_SKIN_U32};
            nkw_skin_view weights = {b.weight, 4 * p->influences, NKW_SKIN_F32};
            n = block_at(p, from);
            decode_block(p, from, n, &b);
            f.joints = joints, f.weights = weights;
        }
        run_pass(p, &f, palette, &positions, normal_palette ? &none : &normals, from, n);
        if (normal_palette)
            run_pass(p, &f, normal_palette, &none, &normals, from, n);
        run_pass(p, &f, palette, &none, &tangents, from, n);
        run_pass(p, &f, palette, &none, &bitangents, from, n);
    }
}

static void run_streams(const plan *p, const transforms *t, const nkw_vertices_view *in, const nkw_vertices_span *out)
{
    skin_block b;
    for (size_t from = 0; from < p->vertices; from += SKIN_BLOCK) {
        size_t n = block_at(p, from);
        const float *normal = blend_block(p, t, in->normals.data && out->normals.data, from, n, &b);
        move_stream(p, &b, NULL, in->positions, out->positions, from, n);
        move_stream(p, &b, normal, in->normals, out->normals, from, n);
        move_stream(p, &b, b.matrix, in->tangents, out->tangents, from, n);
        move_stream(p, &b, b.matrix, in->bitangents, out->bitangents, from, n);
    }
}

/* Of up to so many joints the matrices of normals are made 4x4 first; of more, or of few vertices, all goes by blocks. */
#define NORMAL_JOINTS 256

static void run_normal_pairs(const plan *p, const transforms *t, size_t joint_count, const nkw_vertices_view *in,
                             const nkw_vertices_span *out)
{
    const nkw_vec3 origin = {0.0f, 0.0f, 0.0f};
    nkw_mat4 normals[NORMAL_JOINTS];
    for (size_t j = 0; j < joint_count; j++)
        normals[j] = nkw_mat4_from_mat3(&t->normals[j], origin);
    run_pairs(p, t->matrices, normals, in, out);
}

/* Whether a palette has the format, and the skin formats for joints and weights. */
static nkw_result check_formats(const nkw_skin *skin, nkw_palette_view palette, nkw_palette_format format)
{
    int fits = palette.format == format && is_for_joints(skin->joints.format) && is_for_weights(skin->weights.format);
    return fits ? NKW_OK : NKW_BAD_FORMAT;
}

nkw_result nkw_skin_linear(const nkw_skin *skin, const nkw_skin_palette *palette, const nkw_vertices_view *in,
                           const nkw_vertices_span *out)
{
    nkw_result result = check_formats(skin, palette->matrices, NKW_PALETTE_MAT4);
    size_t joint_count = palette->matrices.joint_count;
    if (palette->normals.data && palette->normals.format != NKW_PALETTE_NORMAL_MAT3)
        result = NKW_BAD_FORMAT;
    if (palette->normals.data && palette->normals.joint_count < joint_count)
        joint_count = palette->normals.joint_count;
    plan p = plan_of(skin, result == NKW_OK ? joint_count : 0, palette->skip_normalization);
    transforms t = {(const nkw_mat4 *)palette->matrices.data, (const nkw_mat3 *)palette->normals.data, NULL};
    if (!t.normals)
        run_pairs(&p, t.matrices, NULL, in, out);
    else if (joint_count <= NORMAL_JOINTS && joint_count <= p.vertices)
        run_normal_pairs(&p, &t, joint_count, in, out);
    else
        run_streams(&p, &t, in, out);
    return result;
}

nkw_result nkw_skin_dual_quat(const nkw_skin *skin, nkw_palette_view palette, const nkw_vertices_view *in,
                              const nkw_vertices_span *out)
{
    nkw_result result = check_formats(skin, palette, NKW_PALETTE_DUAL_QUAT);
    plan p = plan_of(skin, result == NKW_OK ? palette.joint_count : 0, 0);
    transforms t = {NULL, NULL, (const nkw_dual_quat *)palette.data};
    run_streams(&p, &t, in, out);
    return result;
}

/* What is done to a skin once, after loading: normalising, pruning, checking. */

/* The influences of one vertex. */
typedef struct held {
    float weight[NKW_SKIN_INFLUENCES];
    uint32_t joint[NKW_SKIN_INFLUENCES];
} held;

static const unsigned char *vertex_at(const nkw_skin_view *v, size_t influences, size_t i)
{
    return (const unsigned char *)v->data + i * stride_of(v->stride, v->format, influences);
}

static unsigned char *vertex_of(const nkw_skin_span *v, size_t influences, size_t i)
{
    return (unsigned char *)v->data + i * stride_of(v->stride, v->format, influences);
}

static void read_weights(const nkw_skin_view *v, size_t k, size_t i, float *out)
{
    const unsigned char *p = vertex_at(v, k, i);
    for (size_t e = 0; e < k; e++)
        out[e] = lane_skin_weight(p + e * lane_skin_format_size(v->format), v->format);
}

static void read_joints(const nkw_skin_view *v, size_t k, size_t i, uint32_t *out)
{
    const unsigned char *p = vertex_at(v, k, i);
    for (size_t e = 0; e < k; e++)
        out[e] = lane_skin_joint(p + e * lane_skin_format_size(v->format), v->format);
}

/* The whole of a format: what weights of 1 sum to. */
static uint32_t total_of(nkw_skin_format format)
{
    return format == NKW_SKIN_U8 ? 255 : format == NKW_SKIN_U16 ? 65535 : 1u << 24;
}

/* A weight of any scale, 0 if it cannot be used: whole numbers as they are, so that equal parts of them are equal. */
static float part_at(const unsigned char *p, nkw_skin_format format)
{
    float weight = format == NKW_SKIN_F32 ? lane_skin_weight(p, format) : (float)lane_skin_joint(p, format);
    return weight > 0.0f && lane_is_finite(weight) ? weight : 0.0f;
}

static void give_rest(const double *rest, size_t k, uint32_t missing, uint32_t *n)
{
    unsigned given = 0;
    for (; missing > 0; missing--) {
        size_t most = k;
        for (size_t e = 0; e < k; e++)
            if (!(given >> e & 1) && (most == k || rest[e] > rest[most]))
                most = e;
        given |= 1u << most;
        n[most]++;
    }
}

/* Largest remainder. The floors miss less than k, for the quotas sum to the total but for 1e-8. */
static void apportion(const float *weight, size_t k, uint32_t total, uint32_t *n)
{
    double sum = 0.0, rest[NKW_SKIN_INFLUENCES];
    uint32_t missing = total;
    for (size_t e = 0; e < k; e++)
        sum += (double)weight[e];
    for (size_t e = 0; e < k; e++) {
        double share = (double)weight[e] * (double)total;
        n[e] = sum > 0.0 ? (uint32_t)(share / sum) : 0;
        rest[e] = share - (double)n[e] * sum;
        missing -= n[e];
    }
    if (sum > 0.0)
        give_rest(rest, k, missing, n);
}

static void write_number(unsigned char *p, nkw_skin_format format, uint32_t n)
{
    uint16_t wide = (uint16_t)n;
    if (format == NKW_SKIN_U8)
        *p = (unsigned char)n;
    else if (format == NKW_SKIN_U16)
        memcpy(p, &wide, sizeof wide);
    else
        memcpy(p, &n, sizeof n);
}

/* `k` weights normalised, then zeros up to `width`. */
static void write_weights(const float *weight, size_t k, size_t width, unsigned char *p, nkw_skin_format format)
{
    uint32_t n[NKW_SKIN_INFLUENCES];
    apportion(weight, k, total_of(format), n);
    for (size_t e = 0; e < width; e++) {
        uint32_t value = e < k ? n[e] : 0;
        unsigned char *at = p + e * lane_skin_format_size(format);
        write_number(at, format, format == NKW_SKIN_F32 ? lane_bits((float)value * 0x1p-24f) : value);
    }
}

static nkw_result check_count(size_t influence_count)
{
    return influence_count == 0 ? NKW_EMPTY : influence_count > NKW_SKIN_INFLUENCES ? NKW_TOO_MANY : NKW_OK;
}

nkw_result nkw_skin_normalize_weights(nkw_skin_view in, nkw_skin_span out, size_t influence_count, size_t vertex_count)
{
    float weight[NKW_SKIN_INFLUENCES];
    if (check_count(influence_count) != NKW_OK)
        return check_count(influence_count);
    if (!is_for_weights(in.format) || !is_for_weights(out.format))
        return NKW_BAD_FORMAT;
    for (size_t i = 0; i < vertex_count; i++) {
        const unsigned char *p = vertex_at(&in, influence_count, i);
        for (size_t e = 0; e < influence_count; e++)
            weight[e] = part_at(p + e * lane_skin_format_size(in.format), in.format);
        write_weights(weight, influence_count, influence_count, vertex_of(&out, influence_count, i), out.format);
    }
    return NKW_OK;
}

static uint32_t largest_joint(nkw_skin_format format)
{
    return format == NKW_SKIN_U8 ? 255 : format == NKW_SKIN_U16 ? 65535 : UINT32_MAX;
}

/* The smallest weight, the last of equals. */
static size_t smallest_of(const held *v, size_t k)
{
    size_t least = 0;
    for (size_t e = 1; e < k; e++)
        least = v->weight[e] <= v->weight[least] ? e : least;
    return least;
}

static void drop(held *v, size_t k, size_t e)
{
    memmove(v->weight + e, v->weight + e + 1, (k - e - 1) * sizeof *v->weight);
    memmove(v->joint + e, v->joint + e + 1, (k - e - 1) * sizeof *v->joint);
}

/* The `keep` largest of vertex i, in their order; gives how many. Joints above `most` have no weight. */
static size_t keep_largest(const nkw_skin *skin, size_t i, size_t keep, uint32_t most, held *v)
{
    const unsigned char *joints = vertex_at(&skin->joints, skin->influence_count, i);
    const unsigned char *weights = vertex_at(&skin->weights, skin->influence_count, i);
    size_t kept = 0;
    for (size_t e = 0; e < skin->influence_count; e++) {
        nkw_skin_format of_joints = skin->joints.format, of_weights = skin->weights.format;
        uint32_t joint = lane_skin_joint(joints + e * lane_skin_format_size(of_joints), of_joints);
        float weight = part_at(weights + e * lane_skin_format_size(of_weights), of_weights);
        weight = joint <= most ? weight : 0.0f;
        size_t least = kept == keep ? smallest_of(v, kept) : 0;
        if (kept == keep && !(weight > v->weight[least]))
            continue;
        if (kept == keep)
            drop(v, kept--, least);
        v->weight[kept] = weight;
        v->joint[kept++] = joint <= most ? joint : 0;
    }
    return kept;
}

static void write_joints(const uint32_t *joint, size_t k, size_t width, unsigned char *p, nkw_skin_format format)
{
    for (size_t e = 0; e < width; e++)
        write_number(p + e * lane_skin_format_size(format), format, e < k ? joint[e] : 0);
}

nkw_result nkw_skin_prune(const nkw_skin *skin, size_t keep_count, nkw_skin_span joints, nkw_skin_span weights)
{
    if (skin->influence_count == 0 || check_count(keep_count) != NKW_OK)
        return skin->influence_count == 0 ? NKW_EMPTY : check_count(keep_count);
    if (!is_for_joints(skin->joints.format) || !is_for_weights(skin->weights.format) || !is_for_joints(joints.format) ||
        !is_for_weights(weights.format))
        return NKW_BAD_FORMAT;
    for (size_t i = 0; i < skin->vertex_count; i++) {
        held v;
        size_t kept = keep_largest(skin, i, keep_count, largest_joint(joints.format), &v);
        write_joints(v.joint, kept, keep_count, vertex_of(&joints, keep_count, i), joints.format);
        write_weights(v.weight, kept, keep_count, vertex_of(&weights, keep_count, i), weights.format);
    }
    return NKW_OK;
}

static nkw_result check_shape(const nkw_skin *skin)
{
    if (check_count(skin->influence_count) != NKW_OK)
        return check_count(skin->influence_count);
    return is_for_joints(skin->joints.format) && is_for_weights(skin->weights.format) ? NKW_OK : NKW_BAD_FORMAT;
}

/* Whole numbers sum to the whole exactly; w / 65535 times 65535 is within 1e-2 of w. */
static int is_sum(double sum, nkw_skin_format format)
{
    double total = (double)total_of(format);
    double off = format == NKW_SKIN_F32 ? (sum - 1.0) * 1e3 : (sum - 1.0) * total * 2.0;
    return sum == 0.0 || (off >= -1.0 && off <= 1.0);
}

static nkw_result check_vertex(const nkw_skin *skin, size_t joint_count, size_t i)
{
    held v;
    double sum = 0.0;
    nkw_result result = NKW_OK;
    read_joints(&skin->joints, skin->influence_count, i, v.joint);
    read_weights(&skin->weights, skin->influence_count, i, v.weight);
    for (size_t e = 0; e < skin->influence_count; e++) {
        if (!lane_is_finite(v.weight[e]))
            return NKW_NOT_FINITE;
        if (v.weight[e] < 0.0f)
            result = NKW_BAD_WEIGHTS;
        sum += (double)v.weight[e];
    }
    if (result != NKW_OK || !is_sum(sum, skin->weights.format))
        return NKW_BAD_WEIGHTS;
    for (size_t e = 0; e < skin->influence_count; e++)
        if (v.joint[e] >= joint_count)
            return NKW_OUT_OF_RANGE;
    return NKW_OK;
}

nkw_result nkw_skin_validate(const nkw_skin *skin, size_t joint_count, size_t *bad_vertex)
{
    nkw_result result = check_shape(skin);
    size_t bad = 0;
    for (size_t i = 0; result == NKW_OK && i < skin->vertex_count; i++) {
        result = check_vertex(skin, joint_count, i);
        bad = i;
    }
    return report(result, bad, bad_vertex);
}
