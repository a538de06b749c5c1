/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Boxes along the axes: of points, union, affine images.
 */
#ifndef NAKAWARI_BOX_H
#define NAKAWARI_BOX_H

#include <math.h>

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The points with low <= p <= high in each component. Empty if low is greater than high. */
typedef struct nkw_box {
    nkw_vec3 low, high;
} nkw_box;
NKW_SIZE(nkw_box, 24, 24);

/**
 * The box without points: low is +infinity, high is -infinity. As an initialiser and as an argument. A box is empty if
 * not all of low.x <= high.x, low.y <= high.y, low.z <= high.z hold.
 */
#define NKW_BOX_EMPTY (NKW_LITERAL(nkw_box){{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}})

/**
 * The smallest box that contains both, exactly. A component that is NaN does not count. A point p is the box {p, p};
 * the union with NKW_BOX_EMPTY is the other box.
 */
NKW_API nkw_box nkw_box_union(const nkw_box *a, const nkw_box *b);

/**
 * The smallest box that contains all points, exactly: the least and the greatest of each component. A component that is
 * NaN does not count. Empty without points.
 */
NKW_API nkw_box nkw_box_from_points(const nkw_vec3 *points, size_t count);

/**
 * A box around the image of a box under the affine matrix m: around all M p, also as nkw_mat4_transform_point rounds
 * them.
 *
 *     centre' = M centre,   half' = |M| half,     and a margin of 2^-19 (|M| |box| + |t|)
 *
 * An empty box stays empty. If M or the box is not finite, the result is the box of all points.
 *
 * Source Arvo, Transforming Axis-Aligned Bounding Boxes, Graphics Gems, 1990.
 */
NKW_API nkw_box nkw_box_transform(const nkw_box *box, const nkw_mat4 *m);

#ifdef __cplusplus
}
#endif

#endif
