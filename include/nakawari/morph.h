/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Morph targets (blend shapes): vectors of vertices moved by a weighted sum of differences, before skinning.
 *
 *     v' = ((v + w0 d0) + w1 d1) + ...        summed in the order of the targets; one product, one sum each
 *
 * A target is dense, with a difference for every vertex, or sparse, with differences for the vertices of a list.
 * Directions are not normalised: skinning does that (skin.h).
 *
 * Defined on any data, validated or not, and always in bounds:
 *
 *     weight 0, also -0              the target has no effect and is not read, even if it contains NaN
 *     an index after the last        the difference is not used
 *     a vertex listed twice          both differences are added
 *
 * The result of a vertex depends on the numbers of this vertex only: not on strides, on the vertex count or on the
 * processor.
 *
 * Source Khronos Group, glTF 2.0 Specification, section 3.7.2.2, 2021.
 */
#ifndef NAKAWARI_MORPH_H
#define NAKAWARI_MORPH_H

#include <stdint.h>

#include "skin.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The differences of one target. Nothing is owned. */
typedef struct nkw_morph_target {
    nkw_vertices_view deltas; /**< differences of positions, normals, ...; data NULL: none */
    const uint32_t *indices; /**< NULL: dense. Otherwise `count` vertices, delta k is of vertex indices[k] */
    size_t count; /**< of a sparse target; not read if dense */
} nkw_morph_target;
NKW_SIZE(nkw_morph_target, 80, 40);

/** The targets of a mesh. */
typedef struct nkw_morph {
    const nkw_morph_target *targets; /**< target_count */
    size_t target_count;
    size_t vertex_count;
} nkw_morph;
NKW_SIZE(nkw_morph, 24, 12);

/**
 * The morphed vectors.
 *
 * weights  target_count numbers
 * in       the vectors without morphing; a vector that is NULL in `in` or `out` is skipped
 * out      may be the same streams as `in`, or share no vector with them, nor with the targets
 *
 * Dense targets take 0.2 to 0.3 ns for a vector and a target in a near cache if all strides are 0 or 12; targets of
 * weight 0 take none. For many characters call it for each: the vertices of one are already many lanes.
 *
 * Error  1.0 u of |v| + the sum of |w d|, for each component, n + 1 times for n targets that have a weight: one
 *        rounding of each product and of each sum (2.0 u of one target: v -0x1p+26, d 0x1.000002p+24, w
 *        -0x1.fffffep+25).
 */
NKW_API void nkw_morph_apply(const nkw_morph *morph, const float *weights, nkw_vertices_view in, nkw_vertices_span out);

/**
 * Checks targets.
 *
 * Returns  NKW_EMPTY without vertices; NKW_OUT_OF_RANGE for an index that is not less than vertex_count; NKW_NOT_FINITE
 *          for a difference that is not finite. *bad becomes the first offending target, 0 if there is none; it
 *          may be NULL
 */
NKW_API nkw_result nkw_morph_validate(const nkw_morph *morph, size_t *bad);

#ifdef __cplusplus
}
#endif

#endif
