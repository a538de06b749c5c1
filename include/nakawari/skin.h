/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Skinning: the vectors of vertices transformed by a weighted sum of joint matrices.
 *
 * A vertex has 1 to 8 influences, each a joint index and a weight. The palette (palette.h) holds the joint matrix of
 * each joint, from the bind pose to the current pose. Last rows are 0 0 0 1.
 *
 *     linear blend        M = ((w0 M0 + w1 M1) + w2 M2) + ...         summed in the order of the influences
 *     dual quaternions    M = the rotation and translation of ((w0 s0 q0 + w1 s1 q1) + ...) made unit,
 *                         s = -1 where q is on the other half sphere than the q of the largest weight, else 1
 *
 *     position  p' = M p          as nkw_mat4_transform_point
 *     normal    n' = M n / |M n|  M n as nkw_mat4_transform_direction; 0 where |M n| = 0; or as nkw_skin_options states
 *     tangent, bitangent          as the normal
 *
 * Linear blend shears and scales as the matrices do, and loses volume where joints twist; dual quaternions keep volume
 * and have no scale. Weights are used as given: a vertex whose weights sum to 0.9 is drawn towards the origin.
 *
 * Defined on any data, validated or not, and always in bounds:
 *
 *     all weights 0                  every vector is copied bit for bit
 *     a joint beyond the palette     the influence counts as weight 0, joint 0; so does a joint from 2^26 on, and a
 *                                    float that is no joint: NaN, negative, with a fraction, more than 2^24
 *     influences beyond the eighth   are not read
 *     a format that does not fit     every vector is copied bit for bit, NKW_BAD_FORMAT is returned
 *     a palette of NaN               NaN
 *
 * An influence of weight 0 still adds 0 times its matrix, so the matrix must be finite. The result of a vertex depends
 * on the numbers of this vertex only: not on strides, on the vertex count or on the processor.
 *
 * Directions whose squared length leaves the normal floats, 1e-38 to 1e38, are not normalized; far below they become
 * zero.
 *
 * Source Magnenat-Thalmann, Laperriere, Thalmann, Joint-Dependent Local Deformations, 1988 (linear blend);
 *        Kavan, Collins, Zara, O'Sullivan, Skinning with Dual Quaternions, 2007.
 *
 * Example  nkw_skin skin; nkw_skin_palette palette; nkw_palette_view dual; nkw_vertices_view in;
 *          nkw_vertices_span out; nkw_skin_view weights; nkw_skin_span joints, fewer; size_t bad;
 *
 *     nkw_skin_linear(&skin, &palette, in, out);             blends joint matrices
 *     nkw_skin_dual_quat(&skin, dual, in, out);              blends dual quaternions: no collapse at twists
 *     nkw_skin_validate(&skin, 24, &bad);                    which vertex is wrong
 *     nkw_skin_normalize_weights(weights, 4, 100, fewer);    sums become 1
 *     nkw_skin_prune(&skin, 4, joints, fewer);               keeps the heaviest four
 */
#ifndef NAKAWARI_SKIN_H
#define NAKAWARI_SKIN_H

#include "palette.h"
#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The most influences that a vertex can have. */
#define NKW_SKIN_INFLUENCES 8

/** How a joint index or a weight is stored. Integer weights are w / 255 and w / 65535, rounded once. */
typedef enum nkw_skin_format {
    NKW_SKIN_U8, /**< joints 0..255; weights 0..255 for 0..1 */
    NKW_SKIN_U16, /**< joints 0..65535; weights 0..65535 for 0..1 */
    NKW_SKIN_U32, /**< joints only; 2^32 - 1 is no joint */
    NKW_SKIN_F32, /**< weights; joints 0.0 .. 2^24, whole numbers, any other float is no joint */
    NKW_SKIN_FORMAT_MAX_ENUM = 0x7fffffff
} nkw_skin_format;

/**
 * influence_count numbers for each vertex, those of vertex i at data + i * stride. Any alignment. A stride of 0 means
 * contiguous.
 */
typedef struct nkw_skin_view {
    const void *data;
    size_t stride; /**< bytes from vertex to vertex, or 0 */
    nkw_skin_format format;
} nkw_skin_view;
NKW_SIZE(nkw_skin_view, 24, 12);
typedef struct nkw_skin_span {
    void *data;
    size_t stride;
    nkw_skin_format format;
} nkw_skin_span;
NKW_SIZE(nkw_skin_span, 24, 12);

/** Which joints move which vertices. Nothing is owned. */
typedef struct nkw_skin {
    size_t vertex_count;
    size_t influence_count; /**< of every vertex: 1..8; vertices with fewer are padded with weights of 0 */
    nkw_skin_view joints;
    nkw_skin_view weights;
} nkw_skin;
NKW_SIZE(nkw_skin, 64, 32);

/**
 * One vec3 for each vertex, three floats at data + i * stride: a part of interleaved vertices, or a separate array. Any
 * alignment. A stride of 0 means 12. The bytes between the vectors are not written: the w of vec4 tangents is kept.
 * The four bytes after a vector may be read if another vertex follows: split the work of threads by vertex range, not
 * by the vectors of interleaved vertices. data NULL: the vertices have no such vector.
 */
typedef struct nkw_vec3_stream_view {
    const void *data;
    size_t stride; /**< bytes from vertex to vertex, or 0 */
} nkw_vec3_stream_view;
NKW_SIZE(nkw_vec3_stream_view, 16, 8);
typedef struct nkw_vec3_stream_span {
    void *data;
    size_t stride;
} nkw_vec3_stream_span;
NKW_SIZE(nkw_vec3_stream_span, 16, 8);

/** The vectors of vertices, as in vertex buffers. A vector that is NULL in the view or in the span is skipped. */
typedef struct nkw_vertices_view {
    nkw_vec3_stream_view positions, normals, tangents, bitangents;
} nkw_vertices_view;
NKW_SIZE(nkw_vertices_view, 64, 32);
typedef struct nkw_vertices_span {
    nkw_vec3_stream_span positions, normals, tangents, bitangents;
} nkw_vertices_span;
NKW_SIZE(nkw_vertices_span, 64, 32);

/** What linear blend skinning computes otherwise; zero is the usual choice. */
typedef struct nkw_skin_options {
    int keep_length; /**< directions are M n, not M n / |M n|: for shaders that normalize them */
    /**
     * normals are n' = (M^-1)^T n / |(M^-1)^T n| of the blended M. M n, and the blend of inverse transposes, differ from
     * it where joints of different rotations or scales are blended. With the columns a, b, c of the 3x3 block of M,
     *
     *     n' = s (b x c, c x a, a x b) n,      made unit; with keep_length as it is, |det M| (M^-1)^T n
     *     s  = -1 where det M < -2^-20 T, else 1;   T = the sum of the magnitudes of the six products in det M
     *
     * Of a flat M (rank 2) n' is the normal of its plane, with s = 1, as of nkw_mat3_normal. Of rank below 2 the
     * cofactors are rounding errors or 0, and n' is the direction of these errors or 0. Scales of M: 1e-9 to 1e9.
     */
    int inverse_normals;
    /** positions are M p / w, w the last element of M: the sum of the weights. Weights that cancel: M p / 0 */
    int divide_by_weights;
} nkw_skin_options;
NKW_SIZE(nkw_skin_options, 12, 12);

/** The palettes of linear blend skinning. */
typedef struct nkw_skin_palette {
    nkw_palette_view matrices; /**< joint matrices, NKW_PALETTE_MAT4 */
    /**
     * data NULL, or the normal matrices of the same joints, NKW_PALETTE_NORMAL_MAT3: normals are then transformed by
     * the blend of these. The smaller of the two joint counts limits the joints of every influence. Not read with
     * options.inverse_normals.
     */
    nkw_palette_view normals;
    nkw_skin_options options;
} nkw_skin_palette;
NKW_SIZE(nkw_skin_palette, 64, 36);

/**
 * Linear blend skinning. `out` may be the same streams as `in`, or share no vector with them. A skin without vertices
 * and a palette without joints are allowed. Returns NKW_OK, or NKW_BAD_FORMAT if a palette, the joints or the weights
 * have a format that does not fit; all vectors are then copied.
 *
 * Error  6.2 u of normals, with rigid joints up to 1 rad apart (4.5 u up to four influences), with inverse_normals also
 *        of scales 0.5 to 2; 3.2 u of their length; of positions, also of those divided by a sum of 1, 4.8 u of
 *        |w0| |M0| |p| + |w1| |M1| |p| + ..., |M| the Frobenius norm of three rows, |p| that of (p, 1). 1 to 8
 *        influences.
 * Stack  at most 16 KiB.
 */
NKW_API nkw_result nkw_skin_linear(const nkw_skin *skin, const nkw_skin_palette *palette, nkw_vertices_view in,
                                   nkw_vertices_span out);

/**
 * Skinning by unit dual quaternions: palette has the format NKW_PALETTE_DUAL_QUAT. Returns the results of
 * nkw_skin_linear. A blend whose rotation cancels to zero is the identity. The length of a blend must be in
 * 1e-19..1e19. Of equal largest weights the first determines the half sphere.
 *
 * With scale, in two phases (Kavan et al., 2008): nkw_skin_linear of the bind pose with the scales of the pose, then
 * nkw_skin_dual_quat in place with the rigid rest of each joint matrix. docs/subjects/skin/skin.md has the program.
 *
 * Error  10.6 u of normals (8.4 u up to four influences), 3.1 u of their length; of positions 10.5 u of |p| +
 *        |w0| |t0| + |w1| |t1| + ..., t the translations; joints up to 1 rad apart, 1 to 8 influences.
 * Stack  at most 17 KiB.
 */
NKW_API nkw_result nkw_skin_dual_quat(const nkw_skin *skin, nkw_palette_view palette, nkw_vertices_view in,
                                      nkw_vertices_span out);

/**
 * Checks a skin for a palette of joint_count joints.
 *
 * Returns  NKW_EMPTY without influences; NKW_TOO_MANY with more than 8; NKW_BAD_FORMAT if joints or weights have a
 *          format that does not fit. Then for each vertex: NKW_NOT_FINITE if a weight is not finite; NKW_BAD_WEIGHTS if
 *          one is negative, or if they are not all 0 and do not sum to 255, to 65535, or to within 1e-3 of 1;
 *          NKW_OUT_OF_RANGE if a joint index, of weight 0 too, is not less than joint_count, or a float is no joint.
 *          *bad becomes the first offending vertex, 0 if there is none; it may be NULL.
 */
NKW_API nkw_result nkw_skin_validate(const nkw_skin *skin, size_t joint_count, size_t *bad);

/**
 * Weights that sum to 1 exactly: to 255, to 65535, or, as floats, to 1 in every order of the sum.
 *
 *     q = w total / sum,   total = 255, 65535 or 2^24;   n = floor(q)
 *
 * The difference of the total and the sum of n is added, 1 to each, to the weights of the largest q - n, of equal ones
 * to the first (largest remainder). A float is n / 2^24. Weights that are negative or not finite count as 0. If all are
 * 0 they stay 0. It also converts: `out` may have another format and stride than `in`. With the same ones it may be
 * `in`.
 *
 * Returns NKW_OK; or, and then nothing is written: NKW_EMPTY without influences, NKW_TOO_MANY with more than 8,
 * NKW_BAD_FORMAT where a format is not one for weights.
 */
NKW_API nkw_result nkw_skin_normalize_weights(nkw_skin_view in, size_t influence_count, size_t vertex_count,
                                              nkw_skin_span out);

/**
 * Adds the weights of influences of one joint, at the first of them, keeps the keep_count largest weights of each
 * vertex, the first of equals, in their order, and normalizes them as nkw_skin_normalize_weights does. keep_count is
 * 1..8, the influence count of the skin any number from 1 on. Files have equal joints after bones were merged.
 *
 * Every output vertex has keep_count influences: where the skin has fewer joints, the others have weight 0. So with
 * keep_count equal to the influence count, no joint is dropped, and the call converts: to other formats (u8 joints
 * to u16), and from interleaved or separate to the layout of the spans.
 *
 * A joint index that the format of `joints` cannot hold has weight 0 and becomes joint 0. The outputs may be the
 * inputs, with the same stride and format; with strides of 0 keep_count is then at most the skin's influence count.
 *
 * Returns NKW_OK; or, and then nothing is written: NKW_EMPTY where keep_count or the influence count is 0, NKW_TOO_MANY
 * where keep_count is more than 8, NKW_BAD_FORMAT where a format is not one for joints or for weights.
 */
NKW_API nkw_result nkw_skin_prune(const nkw_skin *skin, size_t keep_count, nkw_skin_span joints, nkw_skin_span weights);

#ifdef __cplusplus
}
#endif

#endif
