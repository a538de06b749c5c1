/* SPDX-License-Identifier: MIT */
/* Floor 6: the formulas of skin.h, and the block of vertices that its loops hand to each other. */
#ifndef NAKAWARI_LANE_SKIN_H
#define NAKAWARI_LANE_SKIN_H

#include "strict.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include <nakawari/mat.h>
#include <nakawari/quat.h>
#include <nakawari/skin.h>

#include "scalar.h"
#include "vec.h"

/* Vertices in a block: its arrays stay in the first-level cache. */
#define SKIN_BLOCK 64

/* A block of vertices on its way. Influence k of vertex i, of K, is at [i * K + k]. */
typedef struct skin_block {
    float weight[SKIN_BLOCK * NKW_SKIN_INFLUENCES];
    uint32_t joint[SKIN_BLOCK * NKW_SKIN_INFLUENCES];
    uint32_t moved[SKIN_BLOCK]; /* 0 where all weights are 0 */
    float matrix[12 * SKIN_BLOCK]; /* element (row r, column c) of vertex i at [(c * 3 + r) * SKIN_BLOCK + i] */
    float normal[9 * SKIN_BLOCK]; /* likewise */
    float vector[3 * SKIN_BLOCK]; /* x, y, z */
} skin_block;

/* The influences of vertices: strides that are not 0, formats that are for them, `count` of each vertex, 0..8. */
typedef struct skin_influences {
    nkw_skin_view joints, weights;
    size_t count;
    uint32_t limit; /* joints in the palette */
} skin_influences;

/* Vectors from one place to another, strides in bytes; strides of 0: none. */
typedef struct skin_stream {
    const unsigned char *in;
    unsigned char *out;
    size_t in_stride, out_stride;
} skin_stream;

/* The number at p; what the format is not for reads as 0. */
static inline float lane_skin_weight(const unsigned char *p, nkw_skin_format format)
{
    uint16_t wide;
    float real;
    switch (format) {
    case NKW_SKIN_U8:
        return (float)*p / 255.0f;
    case NKW_SKIN_U16:
        memcpy(&wide, p, sizeof wide);
        return (float)wide / 65535.0f;
    case NKW_SKIN_F32:
        memcpy(&real, p, sizeof real);
        return real;
    default:
        return 0.0f;
    }
}

static inline uint32_t lane_skin_joint(const unsigned char *p, nkw_skin_format format)
{
    uint16_t wide;
    uint32_t wider;
    switch (format) {
    case NKW_SKIN_U8:
        return *p;
    case NKW_SKIN_U16:
        memcpy(&wide, p, sizeof wide);
        return wide;
    case NKW_SKIN_U32:
        memcpy(&wider, p, sizeof wider);
        return wider;
    default:
        return 0;
    }
}

static inline size_t lane_skin_format_size(nkw_skin_format format)
{
    return format == NKW_SKIN_U8 ? 1 : format == NKW_SKIN_U16 ? 2 : 4;
}

static inline nkw_vec3 lane_vec3_choose(uint32_t first, nkw_vec3 a, nkw_vec3 b)
{
    nkw_vec3 r = {first ? a.x : b.x, first ? a.y : b.y, first ? a.z : b.z};
    return r;
}

/* Element e of a vertex's matrix is m[e * SKIN_BLOCK]. As nkw_mat4_transform_point. */
static inline nkw_vec3 lane_skin_point(const float *m, nkw_vec3 p)
{
    const float *x = m, *y = m + 3 * SKIN_BLOCK, *z = m + 6 * SKIN_BLOCK, *t = m + 9 * SKIN_BLOCK;
    nkw_vec3 r = {
        (x[0] * p.x + y[0] * p.y) + (z[0] * p.z + t[0]),
        (x[SKIN_BLOCK] * p.x + y[SKIN_BLOCK] * p.y) + (z[SKIN_BLOCK] * p.z + t[SKIN_BLOCK]),
        (x[2 * SKIN_BLOCK] * p.x + y[2 * SKIN_BLOCK] * p.y) + (z[2 * SKIN_BLOCK] * p.z + t[2 * SKIN_BLOCK]),
    };
    return r;
}

/* n / |n|; zero stays zero. */
static inline nkw_vec3 lane_skin_unit(nkw_vec3 n)
{
    float n2 = (n.x * n.x + n.y * n.y) + n.z * n.z;
    return nkw_vec3_scale(n, n2 == 0.0f ? 0.0f : 1.0f / sqrtf(n2));
}

/* As nkw_mat4_transform_direction. */
static inline nkw_vec3 lane_skin_direction(const float *m, nkw_vec3 d)
{
    const float *x = m, *y = m + 3 * SKIN_BLOCK, *z = m + 6 * SKIN_BLOCK;
    nkw_vec3 r = {
        (x[0] * d.x + y[0] * d.y) + z[0] * d.z,
        (x[SKIN_BLOCK] * d.x + y[SKIN_BLOCK] * d.y) + z[SKIN_BLOCK] * d.z,
        (x[2 * SKIN_BLOCK] * d.x + y[2 * SKIN_BLOCK] * d.y) + z[2 * SKIN_BLOCK] * d.z,
    };
    return r;
}

/*
 * A dual quaternion of any length but 0 made unit, r = real / |real|, d = dual / |real|; of length 0 the one that moves
 * nothing. NaN stays NaN.
 */
static inline nkw_quat lane_skin_rotation(nkw_quat real, float n2)
{
    float k = n2 > 0.0f ? 1.0f / sqrtf(n2) : 0.0f;
    nkw_quat r = {real.x * k, real.y * k, real.z * k, real.w * k + (n2 == 0.0f ? 1.0f : 0.0f)};
    return r;
}

/* 2 d conj(r) */
static inline nkw_vec3 lane_skin_translation(nkw_quat r, nkw_quat dual, float n2)
{
    float k = n2 > 0.0f ? 2.0f / sqrtf(n2) : 0.0f;
    nkw_vec3 t = {
        k * ((dual.x * r.w - dual.w * r.x) + (r.y * dual.z - r.z * dual.y)),
        k * ((dual.y * r.w - dual.w * r.y) + (r.z * dual.x - r.x * dual.z)),
        k * ((dual.z * r.w - dual.w * r.z) + (r.x * dual.y - r.y * dual.x)),
    };
    return t;
}

#endif
