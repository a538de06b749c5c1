/* SPDX-License-Identifier: MIT */
/*
 * Skinning, a block of vertices at a time: decode the influences, blend the joints' transforms into one matrix for each vertex,
 * in component arrays, then take the vectors of the vertices by it.
 */
#include "lane/strict.h"

#include <nakawari/skin.h>

#include "batch/element.h"
#include "batch/table.h"
#include "lane/skin.h"

/* The formats and the usual count are constants in the loops that these are inlined into. */

static inline void read_weights(skin_block *b, const unsigned char *data, size_t stride, nkw_skin_format format,
                                size_t k, size_t n)
{
    size_t size = lane_skin_format_size(format), run = stride == size * k ? n * k : k;
    for (size_t at = 0; at < n * k; at += run, data += stride)
        for (size_t e = 0; e < run; e++)
            b->weight[at + e] = lane_skin_weight(data + e * size, format);
}

/* A joint that the palette has not becomes joint 0 of weight 0. */
static inline void read_joints(skin_block *b, const unsigned char *data, size_t stride, nkw_skin_format format,
                               uint32_t joints, size_t k, size_t n)
{
    size_t size = lane_skin_format_size(format), run = stride == size * k ? n * k : k;
    for (size_t at = 0; at < n * k; at += run, data += stride)
        for (size_t e = 0; e < run; e++) {
            uint32_t joint = lane_skin_joint(data + e * size, format);
            float weight = b->weight[at + e];
            b->joint[at + e] = joint < joints ? joint : 0;
            b->weight[at + e] = joint < joints ? weight : 0.0f;
        }
}

static inline void find_moved(skin_block *b, size_t k, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        uint32_t any = 0;
        for (size_t e = 0; e < k; e++)
            any |= lane_bits(b->weight[i * k + e]) << 1;
        b->moved[i] = any;
    }
}

static inline void decode(skin_block *b, const nkw_skin_view *joints, uint32_t limit, const nkw_skin_view *weights,
                          size_t k, size_t n)
{
    const unsigned char *w = (const unsigned char *)weights->data, *j = (const unsigned char *)joints->data;
    if (weights->format == NKW_SKIN_U8)
        read_weights(b, w, weights->stride, NKW_SKIN_U8, k, n);
    else if (weights->format == NKW_SKIN_U16)
        read_weights(b, w, weights->stride, NKW_SKIN_U16, k, n);
    else
        read_weights(b, w, weights->stride, NKW_SKIN_F32, k, n);
    if (joints->format == NKW_SKIN_U8)
        read_joints(b, j, joints->stride, NKW_SKIN_U8, limit, k, n);
    else if (joints->format == NKW_SKIN_U16)
        read_joints(b, j, joints->stride, NKW_SKIN_U16, limit, k, n);
    else
        read_joints(b, j, joints->stride, NKW_SKIN_U32, limit, k, n);
    find_moved(b, k, n);
    for (size_t e = n * k; e < (n + 3) / 4 * 4 * k; e++)
        b->joint[e] = 0, b->weight[e] = 0.0f;
}

/* Up to a multiple of 4 vertices more, of weight 0. */
KERNEL(skin_decode)
(skin_block *b, const nkw_skin_view *joints, uint32_t limit, const nkw_skin_view *weights, size_t k, size_t n)
{
    if (k == 4)
        decode(b, joints, limit, weights, 4, n);
    else
        decode(b, joints, limit, weights, k, n);
}

/*
 * The blend of matrices is shaped by hand: columns of four floats fill a vector, their blends are turned into component arrays
 * four vertices at a time. ARMv7 is left out, its vectors flush subnormals.
 */
#if defined(__has_builtin) && (defined(__SSE2__) || defined(__aarch64__) || defined(__wasm_simd128__))
#if __has_builtin(__builtin_shufflevector)
#define SKIN_VECTORS
#endif
#endif

#if defined(SKIN_VECTORS)

/* In each group of four floats: the low, the high halves of a and b taken in turn; the low, the high halves together. */
#if defined(__AVX__)
#define COLUMNS            2
#define LOW_IN_TURN(a, b)  __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13)
#define HIGH_IN_TURN(a, b) __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15)
#define LOW_HALVES(a, b)   __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13)
#define HIGH_HALVES(a, b)  __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15)
#else
#define COLUMNS            1
#define LOW_IN_TURN(a, b)  __builtin_shufflevector(a, b, 0, 4, 1, 5)
#define HIGH_IN_TURN(a, b) __builtin_shufflevector(a, b, 2, 6, 3, 7)
#define LOW_HALVES(a, b)   __builtin_shufflevector(a, b, 0, 1, 4, 5)
#define HIGH_HALVES(a, b)  __builtin_shufflevector(a, b, 2, 3, 6, 7)
#endif

/* One or two columns of a matrix. */
typedef float columns __attribute__((vector_size(16 * COLUMNS)));
/* All four, of one vertex. */
typedef struct blended {
    columns c[4 / COLUMNS];
} blended;

static inline columns load_columns(const float *m)
{
    columns r;
    memcpy(&r, m, sizeof r);
    return r;
}

static inline blended blend_one(const skin_block *b, const nkw_mat4 *palette, size_t k, size_t i)
{
    blended r;
    const float *m = palette[b->joint[i * k]].m;
    for (size_t c = 0; c < 4 / COLUMNS; c++)
        r.c[c] = b->weight[i * k] * load_columns(m + 4 * COLUMNS * c);
    for (size_t e = 1; e < k; e++) {
        m = palette[b->joint[i * k + e]].m;
        for (size_t c = 0; c < 4 / COLUMNS; c++)
            r.c[c] += b->weight[i * k + e] * load_columns(m + 4 * COLUMNS * c);
    }
    return r;
}

/* Row r of the columns from c on, of four vertices. */
static inline void store_row(skin_block *b, size_t c, size_t r, size_t i, columns v)
{
    for (size_t h = 0; h < COLUMNS; h++)
        memcpy(&b->matrix[((c * COLUMNS + h) * 3 + r) * SKIN_BLOCK + i], (const char *)&v + 16 * h, 16);
}

static inline void blend(skin_block *b, const nkw_mat4 *palette, size_t k, size_t n)
{
    for (size_t i = 0; i < n; i += 4) {
        blended v0 = blend_one(b, palette, k, i), v1 = blend_one(b, palette, k, i + 1);
        blended v2 = blend_one(b, palette, k, i + 2), v3 = blend_one(b, palette, k, i + 3);
        for (size_t c = 0; c < 4 / COLUMNS; c++) {
            columns xy01 = LOW_IN_TURN(v0.c[c], v1.c[c]), zw01 = HIGH_IN_TURN(v0.c[c], v1.c[c]);
            columns xy23 = LOW_IN_TURN(v2.c[c], v3.c[c]), zw23 = HIGH_IN_TURN(v2.c[c], v3.c[c]);
            store_row(b, c, 0, i, LOW_HALVES(xy01, xy23));
            store_row(b, c, 1, i, HIGH_HALVES(xy01, xy23));
            store_row(b, c, 2, i, LOW_HALVES(zw01, zw23));
        }
    }
}

#else

static inline void blend(skin_block *b, const nkw_mat4 *palette, size_t k, size_t n)
{
    for (size_t i = 0; i < n; i++)
        for (size_t a = 0; a < 12; a++) {
            size_t element = a / 3 * 4 + a % 3;
            float sum = b->weight[i * k] * palette[b->joint[i * k]].m[element];
            for (size_t e = 1; e < k; e++)
                sum += b->weight[i * k + e] * palette[b->joint[i * k + e]].m[element];
            b->matrix[a * SKIN_BLOCK + i] = sum;
        }
}

#endif

/* n is a multiple of 4. */
KERNEL(skin_blend)(skin_block *b, const nkw_mat4 *palette, size_t k, size_t n)
{
    switch (k) {
    case 1:
        blend(b, palette, 1, n);
        break;
    case 2:
        blend(b, palette, 2, n);
        break;
    case 3:
        blend(b, palette, 3, n);
        break;
    case 4:
        blend(b, palette, 4, n);
        break;
    default:
        blend(b, palette, k, n);
        break;
    }
}

/* Sums of `width` floats a joint: element e of vertex i to out[e * SKIN_BLOCK + i]. */
static inline void blend_floats(const skin_block *b, const float *palette, size_t width, size_t k, float *out, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        const float *w = b->weight + i * k, *first = palette + width * b->joint[i * k];
        float sum[12];
        for (size_t a = 0; a < width; a++)
            sum[a] = w[0] * first[a];
        for (size_t e = 1; e < k; e++) {
            const float *m = palette + width * b->joint[i * k + e];
            for (size_t a = 0; a < width; a++)
                sum[a] += w[e] * m[a];
        }
        for (size_t a = 0; a < width; a++)
            out[a * SKIN_BLOCK + i] = sum[a];
    }
}

KERNEL(skin_blend_normals)(skin_block *b, const nkw_mat3 *palette, size_t k, size_t n)
{
    if (k == 4)
        blend_floats(b, palette->m, 9, 4, b->normal, n);
    else
        blend_floats(b, palette->m, 9, k, b->normal, n);
}

/* Weights of joints on the other half sphere than that of the largest weight change their sign. */
static inline void align_weights(skin_block *b, const nkw_dual_quat *palette, size_t k, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        float *w = b->weight + i * k;
        const uint32_t *joint = b->joint + i * k;
        size_t largest = 0;
        for (size_t e = 1; e < k; e++)
            largest = w[e] > w[largest] ? e : largest;
        nkw_quat pivot = palette[joint[largest]].real;
        for (size_t e = 0; e < k; e++)
            w[e] = nkw_quat_dot(pivot, palette[joint[e]].real) < 0.0f ? -w[e] : w[e];
    }
}

KERNEL(skin_blend_dual_quats)(skin_block *b, const nkw_dual_quat *palette, size_t k, size_t n)
{
    align_weights(b, palette, k, n);
    if (k == 4)
        blend_floats(b, &palette->real.x, 8, 4, b->matrix, n);
    else
        blend_floats(b, &palette->real.x, 8, k, b->matrix, n);
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        float *q = b->matrix + i;
        nkw_quat real = {q[0], q[SKIN_BLOCK], q[2 * SKIN_BLOCK], q[3 * SKIN_BLOCK]};
        nkw_quat dual = {q[4 * SKIN_BLOCK], q[5 * SKIN_BLOCK], q[6 * SKIN_BLOCK], q[7 * SKIN_BLOCK]};
        float m[12];
        lane_mat3x4_from_dual_quat(real, dual, m);
        for (size_t e = 0; e < 12; e++)
            q[e * SKIN_BLOCK] = m[e];
    }
}

KERNEL(skin_points)(const skin_block *b, nkw_vec3_view in, nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        nkw_vec3 p = at_vec3(in, i);
        put_vec3(out, i, lane_vec3_choose(b->moved[i], lane_skin_point(b->matrix + i, p), p));
    }
}

KERNEL(skin_directions)(const skin_block *b, const float *m, nkw_vec3_view in, nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        nkw_vec3 d = at_vec3(in, i);
        put_vec3(out, i, lane_vec3_choose(b->moved[i], lane_skin_direction(m + i, d), d));
    }
}

/* Three floats of each vertex into component arrays, and back. Those that lie one behind the other go by a copy in whole. */

KERNEL(skin_read)(const unsigned char *data, size_t stride, float *out, size_t n)
{
    nkw_vec3 v[SKIN_BLOCK];
    if (stride == sizeof *v)
        memcpy(v, data, n * sizeof *v);
    else
        for (size_t i = 0; i < n; i++)
            memcpy(&v[i], data + i * stride, sizeof *v);
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        out[i] = v[i].x, out[SKIN_BLOCK + i] = v[i].y, out[2 * SKIN_BLOCK + i] = v[i].z;
}

KERNEL(skin_write)(const float *in, unsigned char *data, size_t stride, size_t n)
{
    nkw_vec3 v[SKIN_BLOCK];
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        v[i].x = in[i], v[i].y = in[SKIN_BLOCK + i], v[i].z = in[2 * SKIN_BLOCK + i];
    if (stride == sizeof *v)
        memcpy(data, v, n * sizeof *v);
    else
        for (size_t i = 0; i < n; i++)
            memcpy(data + i * stride, &v[i], sizeof *v);
}
