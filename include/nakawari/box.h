/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Boxes along the axes: union, points, affine images.
 */
#ifndef NAKAWARI_BOX_H
#define NAKAWARI_BOX_H

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The points with low <= p <= high in each component. Empty if low is greater than high. */
typedef struct nkw_box {
    nkw_vec3 low, high;
} nkw_box;
NKW_SIZE(nkw_box, 24, 24);

/** The box without points: low is +infinity, high is -infinity. */
NKW_API nkw_box nkw_box_empty(void);

/** 1 if a component of low is greater than that of high, or NaN; otherwise 0. */
NKW_API int nkw_box_is_empty(const nkw_box *box);

/** The smallest box that contains both, exactly. NaN does not count. */
NKW_API nkw_box nkw_box_union(const nkw_box *a, const nkw_box *b);

/** The smallest box that contains a box and a point. A point with NaN changes nothing. */
NKW_API nkw_box nkw_box_add_point(const nkw_box *box, nkw_vec3 p);

/**
 * A box around the affine image of a box: around all M p, also as nkw_mat4_transform_point rounds them.
 *
 *     centre' = M centre,   half' = |M| half,     and a margin of 2^-19 (|M| |box| + |t|)
 *
 * An empty box stays empty. If M or the box is not finite, the result is the box of all points.
 *
 * Source Arvo, Transforming Axis-Aligned Bounding Boxes, Graphics Gems, 1990.
 */
NKW_API nkw_box nkw_box_transform(const nkw_mat4 *m, const nkw_box *box);

#ifdef __cplusplus
}
#endif

#endif
