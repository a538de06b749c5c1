/* SPDX-License-Identifier: MIT */
/*
 * The influences of a block of vertices as offsets of palette entries and floats. Formats and the usual counts are
 * constants in the loops that these functions are inlined into.
 */
#ifndef NAKAWARI_BATCH_SKIN_DECODE_H
#define NAKAWARI_BATCH_SKIN_DECODE_H

#include <nakawari/mat.h>

#include "batch/skin.h"
#include "lane/scalar.h"
#include "skin_format.h"
#include "sizes.h"

#define SKIN_BLOCK_INFLUENCES (SKIN_BLOCK * NKW_SKIN_INFLUENCES)

/* Influence e of vertex i, of k, at [i * k + e]. */
typedef struct decoded_influences {
    uint32_t offset[SKIN_BLOCK_INFLUENCES];
    float weight[SKIN_BLOCK_INFLUENCES]; /* where weights are not read where they are stored */
} decoded_influences;

/* The palette and the k influences of vertices; weights are floats. */
typedef struct influences {
    const unsigned char *palette;
    const uint32_t *offset; /* of the joints' entries, if they were nkw_mat4, in bytes */
    const unsigned char *weights;
    size_t weight_stride, k;
} influences;

/* Those from vertex i on. */
NKW_ALWAYS_INLINE influences influences_at(const influences *f, size_t i)
{
    influences r = *f;
    r.offset += i * f->k;
    r.weights += i * f->weight_stride;
    return r;
}

NKW_ALWAYS_INLINE float load_float(const unsigned char *p)
{
    float x;
    memcpy(&x, p, sizeof x);
    return x;
}

/* n elements of `size` bytes, contiguous: at data, or copied to `packed`. */
NKW_ALWAYS_INLINE const unsigned char *gather(const unsigned char *data, size_t stride, size_t size,
                                              unsigned char *packed, size_t n)
{
    if (stride == size)
        return data;
    for (size_t i = 0; i < n; i++, data += stride)
        memcpy(packed + i * size, data, size);
    return packed;
}

/* Weights of n vertices from data on. */
NKW_ALWAYS_INLINE void decode_weights(const unsigned char *data, size_t stride, nkw_skin_format format, size_t k,
                                      size_t n, float *weight)
{
    unsigned char packed[4 * SKIN_BLOCK_INFLUENCES];
    const size_t size = skin_format_size(format);
    data = gather(data, stride, size * k, packed, n);
    for (size_t e = 0; e < n * k; e++)
        weight[e] = skin_weight(data + e * size, format);
}

/*
 * Returns whether a joint j may be beyond the palette, joint_count <= SKIN_JOINTS: where j or joint_count - 1 - j has
 * the sign bit of an int32_t.
 */
NKW_ALWAYS_INLINE uint32_t decode_joints(const unsigned char *data, size_t stride, nkw_skin_format format,
                                         uint32_t joint_count, size_t k, size_t n, uint32_t *offset)
{
    unsigned char packed[4 * SKIN_BLOCK_INFLUENCES];
    const size_t size = skin_format_size(format);
    uint32_t beyond = 0;
    data = gather(data, stride, size * k, packed, n);
#pragma omp simd reduction(| : beyond)
    for (size_t e = 0; e < n * k; e++) {
        const uint32_t j = skin_joint(data + e * size, format);
        offset[e] = j << 6;
        beyond |= (skin_format_size(format) == 4 ? j : 0) | (joint_count - 1 - j);
    }
    return beyond >> 31;
}

NKW_ALWAYS_INLINE uint32_t decode_by_format(const skin_job *job, const unsigned char *joints,
                                            const unsigned char *weights, size_t k, size_t n, decoded_influences *d)
{
    const size_t joint_stride = job->joints.stride, weight_stride = job->weights.stride;
    if (job->weights.format == NKW_SKIN_U8)
        decode_weights(weights, weight_stride, NKW_SKIN_U8, k, n, d->weight);
    else if (job->weights.format == NKW_SKIN_U16)
        decode_weights(weights, weight_stride, NKW_SKIN_U16, k, n, d->weight);
    if (job->joints.format == NKW_SKIN_U8)
        return decode_joints(joints, joint_stride, NKW_SKIN_U8, job->joint_count, k, n, d->offset);
    if (job->joints.format == NKW_SKIN_U16)
        return decode_joints(joints, joint_stride, NKW_SKIN_U16, job->joint_count, k, n, d->offset);
    if (job->joints.format == NKW_SKIN_U32)
        return decode_joints(joints, joint_stride, NKW_SKIN_U32, job->joint_count, k, n, d->offset);
    return decode_joints(joints, joint_stride, NKW_SKIN_F32, job->joint_count, k, n, d->offset);
}

/* A joint beyond the palette becomes joint 0 of weight 0. It is read again: an offset has lost its highest bits. */
NKW_NOINLINE static void drop_joints(const skin_job *job, const unsigned char *joints, size_t k, size_t n,
                                     decoded_influences *d)
{
    const size_t size = skin_format_size(job->joints.format);
    for (size_t i = 0; i < n; i++)
        for (size_t e = 0; e < k; e++)
            if (skin_joint(joints + i * job->joints.stride + e * size, job->joints.format) >= job->joint_count)
                d->offset[i * k + e] = 0, d->weight[i * k + e] = 0.0f;
}

/* Vertices from .. from + n - 1. Float weights stay where they are stored if every joint is in the palette. */
NKW_NOINLINE static influences decode(const skin_job *job, size_t from, size_t n, decoded_influences *d)
{
    const size_t k = job->influence_count;
    const unsigned char *joints = (const unsigned char *)job->joints.data + from * job->joints.stride;
    const unsigned char *weights = (const unsigned char *)job->weights.data + from * job->weights.stride;
    const influences stored = {job->palette, d->offset, weights, job->weights.stride, k};
    const influences decoded = {job->palette, d->offset, (const unsigned char *)d->weight, k * sizeof *d->weight, k};
    const uint32_t beyond = k == 4   ? decode_by_format(job, joints, weights, 4, n, d)
                            : k == 1 ? decode_by_format(job, joints, weights, 1, n, d)
                            : k == 2 ? decode_by_format(job, joints, weights, 2, n, d)
                                     : decode_by_format(job, joints, weights, k, n, d);
    if (beyond && job->weights.format == NKW_SKIN_F32)
        decode_weights(weights, job->weights.stride, NKW_SKIN_F32, k, n, d->weight);
    if (beyond)
        drop_joints(job, joints, k, n, d);
    return beyond || job->weights.format != NKW_SKIN_F32 ? decoded : stored;
}

/* The vertices, of n, before the first one of which all weights are 0. */
NKW_NOINLINE static size_t count_weighted(const influences *f, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        uint32_t any = 0;
        for (size_t e = 0; e < f->k; e++)
            any |= lane_bits(load_float(f->weights + i * f->weight_stride + e * sizeof(float))) << 1;
        if (any == 0)
            return i;
    }
    return n;
}

#endif
