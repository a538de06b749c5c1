/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Floor 6: skinning: vertices moved by the joints that they hang on.
 *
 * A vertex has 1 to 8 influences, each a joint's number and a weight. The palette holds a matrix for each joint,
 * from bind pose to where the joint is now (global * inverse bind), whose last row is 0 0 0 1.
 *
 *     linear blend        M = ((w0 M0 + w1 M1) + w2 M2) + ...         summed in the order of the influences
 *     dual quaternions    M = the rotation and translation of ((w0 s0 q0 + w1 s1 q1) + ...) made unit,
 *                         s = -1 where q is on the other half sphere than the q of the largest weight, else 1
 *
 *     position  p' = M p          as nkw_mat4_transform_point
 *     normal    n' = M n / |M n|  as nkw_mat4_transform_direction; zero stays zero; M n where raw_directions is set
 *     tangent, bitangent          as the normal
 *
 * Linear blend shears and scales as the matrices do, and loses volume at joints that twist; dual quaternions keep
 * volume, and know no scale. Weights are used as they are: a vertex whose weights sum to 0.9 is drawn towards the
 * origin.
 *
 * Defined on any data, validated or not, and always in bounds:
 *
 *     all weights 0                  the vertex is not moved: every vector comes out bit for bit as it came in
 *     a joint beyond the palette     the influence counts as weight 0, joint 0
 *     influences beyond the eighth   are not read
 *     an unknown format              counts as weights of 0
 *     a palette of NaN               NaN
 *
 * An influence of weight 0 still adds 0 times its matrix: it must be finite. One vertex's result depends on nothing
 * but its own numbers: not on how the arrays lie, how many vertices there are, or the processor.
 *
 * Directions whose squared length leaves the normal floats, 1e-38 to 1e38, are not made unit; far below they become
 * zero.
 *
 * Source Magnenat-Thalmann, Laperriere, Thalmann, Joint-Dependent Local Deformations, 1988 (linear blend);
 *        Kavan, Collins, Zara, O'Sullivan, Skinning with Dual Quaternions, 2007.
 */
#ifndef NAKAWARI_SKIN_H
#define NAKAWARI_SKIN_H

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The most influences that a vertex can have. */
#define NKW_SKIN_INFLUENCES 8

/** How a joint's number or a weight is stored. Weights in whole numbers are w / 255 and w / 65535, rounded once. */
typedef enum nkw_skin_format {
    NKW_SKIN_U8, /**< joints 0..255; weights 0..255 for 0..1 */
    NKW_SKIN_U16, /**< joints 0..65535; weights 0..65535 for 0..1 */
    NKW_SKIN_U32, /**< joints only */
    NKW_SKIN_F32 /**< weights only */
} nkw_skin_format;

/**
 * `influences` numbers for each vertex, those of vertex i at data + i * stride. Any alignment will do. A stride of 0
 * says that they lie one behind the other.
 */
typedef struct nkw_skin_view {
    const void *data;
    size_t stride; /**< bytes from vertex to vertex, or 0 */
    nkw_skin_format format;
} nkw_skin_view;
typedef struct nkw_skin_span {
    void *data;
    size_t stride;
    nkw_skin_format format;
} nkw_skin_span;

/** Which joints move which vertices. Nothing is owned. */
typedef struct nkw_skin {
    size_t vertices;
    size_t influences; /**< of every vertex: 1..8; fewer are filled up with weights of 0 */
    nkw_skin_view joints;
    nkw_skin_view weights;
} nkw_skin;

/**
 * One vec3 for each vertex, three floats at data + i * stride; a part of interleaved vertices or an array of its
 * own. Any alignment will do. A stride of 0 says 12. What lies between is not written: the w of vec4 tangents stays.
 * But the four bytes behind a vector may be read where another vertex follows, so threads share out vertices, not the
 * vectors of interleaved ones.
 * data NULL: the vertices have none.
 */
typedef struct nkw_vec3_stream {
    const void *data;
    size_t stride; /**< bytes from vertex to vertex, or 0 */
} nkw_vec3_stream;
typedef struct nkw_vec3_stream_span {
    void *data;
    size_t stride;
} nkw_vec3_stream_span;

/** The vectors of the vertices as they lie in vertex buffers. Those that are NULL on either side are left out. */
typedef struct nkw_vertices {
    nkw_vec3_stream positions, normals, tangents, bitangents;
} nkw_vertices;
typedef struct nkw_vertices_span {
    nkw_vec3_stream_span positions, normals, tangents, bitangents;
} nkw_vertices_span;

/** The same in component arrays; x NULL: there are none. */
typedef struct nkw_vertices_arrays {
    nkw_vec3_view positions, normals, tangents, bitangents;
} nkw_vertices_arrays;
typedef struct nkw_vertices_arrays_span {
    nkw_vec3_span positions, normals, tangents, bitangents;
} nkw_vertices_arrays_span;

/** The joints' transforms from bind pose, `joints` of each. */
typedef struct nkw_skin_palette {
    const nkw_mat4 *matrices;
    /**
     * NULL, or the inverse transposes of the 3x3 blocks (nkw_mat3_normal): normals are then taken by the blend of
     * these. Needed where matrices shear or scale unevenly; with rotations and even scale it makes no difference.
     */
    const nkw_mat3 *normals;
    size_t joints;
    /** 0: directions come out unit, M n / |M n|. Else as blended, M n: for those who make them unit later. */
    int raw_directions;
} nkw_skin_palette;

/**
 * Linear blend skinning. `out` may be the very streams of `in`, or share no vector with them. A skin of no vertices,
 * and a palette of no joints, are allowed.
 *
 * Error  6.2 u of normals, with rigid joints up to 1 rad apart (4.5 u up to four influences), 3.2 u of their length; of
 *        positions 4.8 u of |w0| |M0| |p| + |w1| |M1| |p| + ..., |M| the Frobenius norm of three rows, |p| that of
 *        (p, 1). 1 to 8 influences.
 */
NKW_API void nkw_skin_linear(const nkw_skin *skin, const nkw_skin_palette *palette, const nkw_vertices *in,
                             const nkw_vertices_span *out);
NKW_API void nkw_skin_linear_arrays(const nkw_skin *skin, const nkw_skin_palette *palette,
                                    const nkw_vertices_arrays *in, const nkw_vertices_arrays_span *out);

/**
 * Skinning by dual quaternions, which should be unit. A blend whose rotation cancels to zero moves nothing, and
 * weights must not make blends shorter than 1e-19 or longer than 1e19. Where two weights are the largest, the first
 * one's half sphere counts.
 *
 * Error  10.6 u of normals (8.4 u up to four influences), 2.9 u of their length; of positions 8.8 u of |p| +
 *        |w0| |t0| + |w1| |t1| + ..., t the translations; joints up to 1 rad apart, 1 to 8 influences.
 */
NKW_API void nkw_skin_dual_quat(const nkw_skin *skin, const nkw_dual_quat *palette, size_t joints,
                                const nkw_vertices *in, const nkw_vertices_span *out);
NKW_API void nkw_skin_dual_quat_arrays(const nkw_skin *skin, const nkw_dual_quat *palette, size_t joints,
                                       const nkw_vertices_arrays *in, const nkw_vertices_arrays_span *out);

/**
 * Checks a skin for a palette of `joints`: NKW_EMPTY without influences; NKW_TOO_MANY with more than 8;
 * NKW_BAD_METHOD where joints or weights are not in a format for them. Then for each vertex: NKW_NOT_FINITE where a
 * weight is not finite; NKW_BAD_WEIGHTS where one is negative, or they are not all 0 and do not sum to 255, to
 * 65535, or to within 1e-3 of 1; NKW_OUT_OF_RANGE where a joint's number, of weight 0 too, is not less than
 * `joints`. *bad_vertex becomes the first offending vertex, 0 if there is none; it may be NULL.
 */
NKW_API nkw_result nkw_skin_validate(const nkw_skin *skin, size_t joints, size_t *bad_vertex);

/**
 * Weights that sum to 1 exactly: to 255, to 65535, or, as floats, to 1 in whatever order they are summed.
 *
 *     q = w total / sum,   total = 255, 65535 or 2^24;   n = floor(q)
 *
 * and what is missing to the total goes, one each, to those of the largest q - n, the first of equals (largest
 * remainder). A float is n / 2^24. Weights that are negative or not finite count as 0. Where all are 0 they stay so.
 * Between formats too. `vertices` times `influences` (1..8) weights of each; out may be in, with the same stride and
 * format. With more influences, none, or a format that is not for weights, nothing is written.
 */
NKW_API void nkw_skin_normalize_weights(nkw_skin_view in, size_t influences, nkw_skin_span out, size_t vertices);

/**
 * Keeps the `keep` largest weights of each vertex, the first of equals, in their order, and normalises them as
 * nkw_skin_normalize_weights does. With fewer influences than `keep` the rest is joint 0, weight 0. A joint whose
 * number the format of `joints` cannot hold has no weight, and becomes joint 0. The outputs may be the inputs, of the
 * same stride and format; with strides of 0 `keep` is then at most the skin's influences. `keep` is 1..8, the
 * influences any number from 1 on, formats as in nkw_skin_validate; else nothing is written.
 */
NKW_API void nkw_skin_prune(const nkw_skin *skin, size_t keep, nkw_skin_span joints, nkw_skin_span weights);

#ifdef __cplusplus
}
#endif

#endif
