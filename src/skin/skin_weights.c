/* SPDX-License-Identifier: MIT */
/* Skins once, after loading: weights normalized, influences pruned, everything checked. */
#include "lane/strict.h"

#include <float.h>

#include <nakawari/skin.h>

#include "lane/scalar.h"
#include "report.h"
#include "batch/skin_format.h"

/* The influences of one vertex. */
typedef struct vertex_influences {
    float weight[NKW_SKIN_INFLUENCES];
    uint32_t joint[NKW_SKIN_INFLUENCES];
} vertex_influences;

static const unsigned char *vertex_at(const nkw_skin_view *v, size_t influences, size_t i)
{
    return (const unsigned char *)v->data + i * skin_stride(v->stride, v->format, influences);
}

static unsigned char *vertex_of(const nkw_skin_span *v, size_t influences, size_t i)
{
    return (unsigned char *)v->data + i * skin_stride(v->stride, v->format, influences);
}

static void read_weights(const nkw_skin_view *v, size_t k, size_t i, float *out)
{
    const unsigned char *p = vertex_at(v, k, i);
    for (size_t e = 0; e < k; e++)
        out[e] = skin_weight(p + e * skin_format_size(v->format), v->format);
}

static void read_joints(const nkw_skin_view *v, size_t k, size_t i, uint32_t *out)
{
    const unsigned char *p = vertex_at(v, k, i);
    for (size_t e = 0; e < k; e++)
        out[e] = skin_joint(p + e * skin_format_size(v->format), v->format);
}

/* The whole of a format: what weights of 1 sum to. */
static uint32_t total_of(nkw_skin_format format)
{
    return format == NKW_SKIN_U8 ? 255 : format == NKW_SKIN_U16 ? 65535 : 1u << 24;
}

/* A weight of any scale, 0 if it cannot be used: whole numbers as they are, so that equal parts of them are equal. */
static float part_at(const unsigned char *p, nkw_skin_format format)
{
    float weight = format == NKW_SKIN_F32 ? skin_weight(p, format) : (float)skin_joint(p, format);
    return weight > 0.0f && lane_is_finite(weight) ? weight : 0.0f;
}

static void give_rest(const double *remainder, size_t k, uint32_t missing, uint32_t *n)
{
    unsigned given = 0;
    for (; missing > 0; missing--) {
        size_t most = k;
        for (size_t e = 0; e < k; e++)
            if (!(given >> e & 1) && (most == k || remainder[e] > remainder[most]))
                most = e;
        given |= 1u << most;
        n[most]++;
    }
}

/* Largest remainder. The floors miss less than k, because the quotas sum to the total to within 1e-8. */
static void apportion(const float *weight, size_t k, uint32_t total, uint32_t *n)
{
    double sum = 0.0, remainder[NKW_SKIN_INFLUENCES];
    uint32_t missing = total;
    for (size_t e = 0; e < k; e++)
        sum += (double)weight[e];
    for (size_t e = 0; e < k; e++) {
        double share = (double)weight[e] * (double)total;
        n[e] = sum > 0.0 ? (uint32_t)(share / sum) : 0;
        remainder[e] = share - (double)n[e] * sum;
        missing -= n[e];
    }
    if (sum > 0.0)
        give_rest(remainder, k, missing, n);
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
        unsigned char *at = p + e * skin_format_size(format);
        write_number(at, format, format == NKW_SKIN_F32 ? lane_bits((float)value * 0x1p-24f) : value);
    }
}

static nkw_result check_count(size_t influence_count)
{
    return influence_count == 0 ? NKW_EMPTY : influence_count > NKW_SKIN_INFLUENCES ? NKW_TOO_MANY : NKW_OK;
}

nkw_result nkw_skin_normalize_weights(nkw_skin_view in, size_t influence_count, size_t vertex_count, nkw_skin_span out)
{
    float weight[NKW_SKIN_INFLUENCES];
    if (check_count(influence_count) != NKW_OK)
        return check_count(influence_count);
    if (!skin_format_is_weight(in.format) || !skin_format_is_weight(out.format))
        return NKW_BAD_FORMAT;
    for (size_t i = 0; i < vertex_count; i++) {
        const unsigned char *p = vertex_at(&in, influence_count, i);
        for (size_t e = 0; e < influence_count; e++)
            weight[e] = part_at(p + e * skin_format_size(in.format), in.format);
        write_weights(weight, influence_count, influence_count, vertex_of(&out, influence_count, i), out.format);
    }
    return NKW_OK;
}

static uint32_t largest_joint(nkw_skin_format format)
{
    return format == NKW_SKIN_U8    ? 255
           : format == NKW_SKIN_U16 ? 65535
           : format == NKW_SKIN_U32 ? SKIN_NO_JOINT - 1
                                    : (uint32_t)SKIN_FLOAT_JOINTS;
}

/* The smallest weight, the last of equals. */
static size_t smallest_of(const vertex_influences *v, size_t k)
{
    size_t least = 0;
    for (size_t e = 1; e < k; e++)
        least = v->weight[e] <= v->weight[least] ? e : least;
    return least;
}

static void drop(vertex_influences *v, size_t k, size_t e)
{
    memmove(v->weight + e, v->weight + e + 1, (k - e - 1) * sizeof *v->weight);
    memmove(v->joint + e, v->joint + e + 1, (k - e - 1) * sizeof *v->joint);
}

/* The influences of one vertex as they are stored, any number of them. Joints above `most` have no weight. */
typedef struct stored {
    const unsigned char *joints, *weights;
    nkw_skin_format of_joints, of_weights;
    uint32_t most;
    size_t count;
} stored;

static uint32_t stored_joint(const stored *s, size_t e)
{
    return skin_joint(s->joints + e * skin_format_size(s->of_joints), s->of_joints);
}

/* The sum of the weights of all influences of the joint of influence e; 0 if an earlier one has this joint. */
static float merged_weight(const stored *s, size_t e)
{
    const uint32_t joint = stored_joint(s, e);
    float sum = 0.0f;
    if (joint > s->most)
        return 0.0f;
    for (size_t k = 0; k < s->count; k++) {
        if (stored_joint(s, k) != joint)
            continue;
        if (k < e)
            return 0.0f;
        sum += part_at(s->weights + k * skin_format_size(s->of_weights), s->of_weights);
    }
    return lane_is_finite(sum) ? sum : FLT_MAX;
}

/* The `keep` largest of vertex i after the merge, in their order. Returns their number. */
static size_t keep_largest(const nkw_skin *skin, size_t i, size_t keep, uint32_t most, vertex_influences *v)
{
    const stored s = {vertex_at(&skin->joints, skin->influence_count, i),
                      vertex_at(&skin->weights, skin->influence_count, i),
                      skin->joints.format,
                      skin->weights.format,
                      most,
                      skin->influence_count};
    size_t kept = 0;
    for (size_t e = 0; e < s.count; e++) {
        const uint32_t joint = stored_joint(&s, e);
        const float weight = merged_weight(&s, e);
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
    for (size_t e = 0; e < width; e++) {
        uint32_t j = e < k ? joint[e] : 0;
        write_number(p + e * skin_format_size(format), format, format == NKW_SKIN_F32 ? lane_bits((float)j) : j);
    }
}

nkw_result nkw_skin_prune(const nkw_skin *skin, size_t keep_count, nkw_skin_span joints, nkw_skin_span weights)
{
    if (skin->influence_count == 0 || check_count(keep_count) != NKW_OK)
        return skin->influence_count == 0 ? NKW_EMPTY : check_count(keep_count);
    if (!skin_format_is_joint(skin->joints.format) || !skin_format_is_weight(skin->weights.format) ||
        !skin_format_is_joint(joints.format) || !skin_format_is_weight(weights.format))
        return NKW_BAD_FORMAT;
    for (size_t i = 0; i < skin->vertex_count; i++) {
        vertex_influences v;
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
    return skin_format_is_joint(skin->joints.format) && skin_format_is_weight(skin->weights.format) ? NKW_OK
                                                                                                    : NKW_BAD_FORMAT;
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
    vertex_influences v;
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
        if (v.joint[e] >= joint_count || v.joint[e] == SKIN_NO_JOINT)
            return NKW_OUT_OF_RANGE;
    return NKW_OK;
}

nkw_result nkw_skin_validate(const nkw_skin *skin, size_t joint_count, size_t *bad)
{
    nkw_result result = check_shape(skin);
    size_t at = 0;
    for (size_t i = 0; result == NKW_OK && i < skin->vertex_count; i++) {
        result = check_vertex(skin, joint_count, i);
        at = i;
    }
    return report(result, at, bad);
}
