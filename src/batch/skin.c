/* SPDX-License-Identifier: MIT */
/*
 * Skinning, a block of vertices at a time: decode the influences, blend the joints' transforms into one matrix for
 * each vertex, in component arrays, then take the vectors of the vertices by it.
 */
#include "lane/strict.h"

#include <nakawari/skin.h>

#include "batch/element.h"
#include "batch/skin.h"
#include "lane/skin.h"

NKW_LOOPS_SKIN(NKW_DECLARE_LOOP)

/* The formats and the usual count are constants in the loops that these are inlined into. */

/* n elements of `size` bytes one behind the other: where they lie if they do so, else copied to `tight`. */
INLINE const unsigned char *gather(const unsigned char *data, size_t stride, size_t size, unsigned char *tight,
                                   size_t n)
{
    if (stride == size)
        return data;
    for (size_t i = 0; i < n; i++, data += stride)
        memcpy(tight + i * size, data, size);
    return tight;
}

INLINE void read_weights(skin_block *b, const nkw_skin_view *weights, nkw_skin_format format, size_t k, size_t n)
{
    unsigned char tight[4 * NKW_SKIN_INFLUENCES * SKIN_BLOCK];
    const size_t size = lane_skin_format_size(format);
    const unsigned char *data = (const unsigned char *)weights->data;
    data = gather(data, weights->stride, size * k, tight, n);
    for (size_t e = 0; e < n * k; e++)
        b->weight[e] = lane_skin_weight(data + e * size, format);
}

/* A joint that the palette has not becomes joint 0 of weight 0. */
INLINE void read_joints(skin_block *b, const nkw_skin_view *joints, nkw_skin_format format, uint32_t limit, size_t k,
                        size_t n)
{
    unsigned char tight[4 * NKW_SKIN_INFLUENCES * SKIN_BLOCK];
    const size_t size = lane_skin_format_size(format);
    const unsigned char *data = (const unsigned char *)joints->data;
    data = gather(data, joints->stride, size * k, tight, n);
    for (size_t e = 0; e < n * k; e++) {
        uint32_t joint = lane_skin_joint(data + e * size, format);
        float weight = b->weight[e];
        b->joint[e] = joint < limit ? joint : 0;
        b->weight[e] = joint < limit ? weight : 0.0f;
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

INLINE void decode(skin_block *b, const nkw_skin_view *joints, uint32_t limit, const nkw_skin_view *weights, size_t k,
                   size_t n)
{
    if (weights->format == NKW_SKIN_U8)
        read_weights(b, weights, NKW_SKIN_U8, k, n);
    else if (weights->format == NKW_SKIN_U16)
        read_weights(b, weights, NKW_SKIN_U16, k, n);
    else
        read_weights(b, weights, NKW_SKIN_F32, k, n);
    if (joints->format == NKW_SKIN_U8)
        read_joints(b, joints, NKW_SKIN_U8, limit, k, n);
    else if (joints->format == NKW_SKIN_U16)
        read_joints(b, joints, NKW_SKIN_U16, limit, k, n);
    else
        read_joints(b, joints, NKW_SKIN_U32, limit, k, n);
    find_moved(b, k, n);
    for (size_t e = n * k; e < (n + 3) / 4 * 4 * k; e++)
        b->joint[e] = 0, b->weight[e] = 0.0f;
}

/* Up to a multiple of 4 vertices more, of weight 0. */
NKW_LOOP(nkwi_skin_decode)
(skin_block *b, const nkw_skin_view *joints, uint32_t limit, const nkw_skin_view *weights, size_t k, size_t n)
{
    if (k == 4)
        decode(b, joints, limit, weights, 4, n);
    else if (k == 1)
        decode(b, joints, limit, weights, 1, n);
    else if (k == 2)
        decode(b, joints, limit, weights, 2, n);
    else if (k == 3)
        decode(b, joints, limit, weights, 3, n);
    else if (k == 8)
        decode(b, joints, limit, weights, 8, n);
    else
        decode(b, joints, limit, weights, k, n);
}

/*
 * A joint has `width` floats, of which `groups` groups of four are blended, `rows` floats of each: element (group g,
 * row r) of vertex i goes to out[(g * rows + r) * SKIN_BLOCK + i].
 *
 * Compilers find no vectors here, so these are shaped by hand: groups fill a vector, and the sums of four vertices
 * are turned into component arrays together. ARMv7 is left out, its vectors flush subnormals.
 */
#if defined(__has_builtin) && (defined(__SSE2__) || defined(__aarch64__) || defined(__wasm_simd128__))
#if __has_builtin(__builtin_shufflevector)
#define SKIN_VECTORS
#endif
#endif

#if defined(SKIN_VECTORS)

/* In each group: the low, the high halves of a and b taken in turn; the low, the high halves one after the other. */
#if defined(__AVX__)
#define PAIR               2
#define LOW_IN_TURN(a, b)  __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13)
#define HIGH_IN_TURN(a, b) __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15)
#define LOW_HALVES(a, b)   __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13)
#define HIGH_HALVES(a, b)  __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15)
#else
#define PAIR               1
#define LOW_IN_TURN(a, b)  __builtin_shufflevector(a, b, 0, 4, 1, 5)
#define HIGH_IN_TURN(a, b) __builtin_shufflevector(a, b, 2, 6, 3, 7)
#define LOW_HALVES(a, b)   __builtin_shufflevector(a, b, 0, 1, 4, 5)
#define HIGH_HALVES(a, b)  __builtin_shufflevector(a, b, 2, 3, 6, 7)
#endif

/* One group, or a pair. */
typedef float vector __attribute__((vector_size(16 * PAIR)));
/* All groups of one vertex. */
typedef struct sums {
    vector v[4 / PAIR];
} sums;

static inline vector load_vector(const float *m)
{
    vector r;
    memcpy(&r, m, sizeof r);
    return r;
}

static inline sums sum_one(const skin_block *b, const float *palette, size_t width, size_t groups, size_t k, size_t i)
{
    sums r;
    const float *w = b->weight + i * k, *m = palette + width * b->joint[i * k];
    for (size_t g = 0; g < groups / PAIR; g++)
        r.v[g] = w[0] * load_vector(m + 4 * PAIR * g);
    for (size_t e = 1; e < k; e++) {
        m = palette + width * b->joint[i * k + e];
        for (size_t g = 0; g < groups / PAIR; g++)
            r.v[g] += w[e] * load_vector(m + 4 * PAIR * g);
    }
    return r;
}

/* Row r, of four vertices, of the group g or the pair g. */
static inline void store_row(float *out, size_t rows, size_t g, size_t r, vector v)
{
    for (size_t h = 0; h < PAIR; h++)
        memcpy(&out[((g * PAIR + h) * rows + r) * SKIN_BLOCK], (const char *)&v + 16 * h, 16);
}

static inline void blend(const skin_block *b, const float *palette, size_t width, size_t groups, size_t rows, size_t k,
                         float *out, size_t n)
{
    for (size_t i = 0; i < n; i += 4) {
        sums s0 = sum_one(b, palette, width, groups, k, i), s1 = sum_one(b, palette, width, groups, k, i + 1);
        sums s2 = sum_one(b, palette, width, groups, k, i + 2), s3 = sum_one(b, palette, width, groups, k, i + 3);
        for (size_t g = 0; g < groups / PAIR; g++) {
            vector low01 = LOW_IN_TURN(s0.v[g], s1.v[g]), high01 = HIGH_IN_TURN(s0.v[g], s1.v[g]);
            vector low23 = LOW_IN_TURN(s2.v[g], s3.v[g]), high23 = HIGH_IN_TURN(s2.v[g], s3.v[g]);
            store_row(out + i, rows, g, 0, LOW_HALVES(low01, low23));
            store_row(out + i, rows, g, 1, HIGH_HALVES(low01, low23));
            store_row(out + i, rows, g, 2, LOW_HALVES(high01, high23));
            if (rows == 4)
                store_row(out + i, rows, g, 3, HIGH_HALVES(high01, high23));
        }
    }
}

#endif

/* The sum of one element: what the vectors above do with many. */
static inline void blend_element(const skin_block *b, const float *palette, size_t width, size_t k, float *out,
                                 size_t n)
{
    for (size_t i = 0; i < n; i++) {
        const float *w = b->weight + i * k;
        const uint32_t *joint = b->joint + i * k;
        float sum = w[0] * palette[width * joint[0]];
        for (size_t e = 1; e < k; e++)
            sum += w[e] * palette[width * joint[e]];
        out[i] = sum;
    }
}

#if !defined(SKIN_VECTORS)

static inline void blend(const skin_block *b, const float *palette, size_t width, size_t groups, size_t rows, size_t k,
                         float *out, size_t n)
{
    for (size_t a = 0; a < groups * rows; a++)
        blend_element(b, palette + a / rows * 4 + a % rows, width, k, out + a * SKIN_BLOCK, n);
}

#endif

/* The usual counts as constants. */
static inline void blend_by_count(const skin_block *b, const float *palette, size_t width, size_t groups, size_t rows,
                                  size_t k, float *out, size_t n)
{
    if (k == 4)
        blend(b, palette, width, groups, rows, 4, out, n);
    else if (k == 1)
        blend(b, palette, width, groups, rows, 1, out, n);
    else if (k == 2)
        blend(b, palette, width, groups, rows, 2, out, n);
    else
        blend(b, palette, width, groups, rows, k, out, n);
}

/* n is a multiple of 4 in all three. */
NKW_LOOP(nkwi_skin_blend)(skin_block *b, const nkw_mat4 *palette, size_t k, size_t n)
{
    blend_by_count(b, palette->m, 16, 4, 3, k, b->matrix, n);
}

NKW_LOOP(nkwi_skin_blend_normals)(skin_block *b, const nkw_mat3 *palette, size_t k, size_t n)
{
    blend_by_count(b, palette->m, 9, 2, 4, k, b->normal, n);
    blend_element(b, palette->m + 8, 9, k, b->normal + 8 * SKIN_BLOCK, n);
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

NKW_LOOP(nkwi_skin_blend_dual_quats)(skin_block *b, const nkw_dual_quat *palette, size_t k, size_t n)
{
    if (k == 4)
        align_weights(b, palette, 4, n);
    else
        align_weights(b, palette, k, n);
    blend_by_count(b, &palette->real.x, 8, 2, 4, k, b->matrix, n);
    float *m = b->matrix;
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        nkw_quat real = {m[i], m[SKIN_BLOCK + i], m[2 * SKIN_BLOCK + i], m[3 * SKIN_BLOCK + i]};
        nkw_quat dual = {m[4 * SKIN_BLOCK + i], m[5 * SKIN_BLOCK + i], m[6 * SKIN_BLOCK + i], m[7 * SKIN_BLOCK + i]};
        float n2 = nkw_quat_dot(real, real);
        nkw_quat r = lane_skin_rotation(real, n2);
        nkw_mat3 rotation = nkw_mat3_from_quat(r);
        nkw_vec3 translation = lane_skin_translation(r, dual, n2);
        for (size_t e = 0; e < 9; e++)
            m[e * SKIN_BLOCK + i] = rotation.m[e];
        m[9 * SKIN_BLOCK + i] = translation.x;
        m[10 * SKIN_BLOCK + i] = translation.y;
        m[11 * SKIN_BLOCK + i] = translation.z;
    }
}

NKW_LOOP(nkwi_skin_points)(const skin_block *b, nkw_vec3_view in, nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        nkw_vec3 p = at_vec3(in, i);
        put_vec3(out, i, lane_vec3_choose(b->moved[i], lane_skin_point(b->matrix + i, p), p));
    }
}

/* raw is a constant in the loops that this is inlined into. */
static inline void move_directions(const skin_block *b, const float *m, int raw, nkw_vec3_view in, nkw_vec3_span out,
                                   size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        nkw_vec3 d = at_vec3(in, i), r = lane_skin_direction(m + i, d);
        put_vec3(out, i, lane_vec3_choose(b->moved[i], raw ? r : lane_skin_unit(r), d));
    }
}

NKW_LOOP(nkwi_skin_directions)
(const skin_block *b, const float *m, int raw, nkw_vec3_view in, nkw_vec3_span out, size_t n)
{
    if (raw)
        move_directions(b, m, 1, in, out, n);
    else
        move_directions(b, m, 0, in, out, n);
}

/*
 * Three floats of each vertex into component arrays, and back. Those that lie one behind the other go by a copy in
 * whole.
 */

NKW_LOOP(nkwi_skin_read)(const unsigned char *data, size_t stride, float *out, size_t n)
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

NKW_LOOP(nkwi_skin_write)(const float *in, unsigned char *data, size_t stride, size_t n)
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
