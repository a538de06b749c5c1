/* SPDX-License-Identifier: MIT */
/* Floor 2: affine matrices by their columns, four floats at a time. */
#ifndef NAKAWARI_LANE_AFFINE_H
#define NAKAWARI_LANE_AFFINE_H

#include "strict.h"

#include <nakawari/types.h>

#include "four.h"

/* Columns x, y, z and translation. The fourth row may hold anything: no sum of the others reads it. */
typedef struct lane_columns {
    lane_four c[4];
} lane_columns;

static inline lane_columns lane_columns_from(const nkw_mat4 *m)
{
    lane_columns r;
    for (int c = 0; c < 4; c++)
        r.c[c] = lane_four_load(m->m + 4 * c);
    return r;
}

static inline lane_columns lane_columns_none(void)
{
    static const nkw_mat4 zero = {{0.0f}};
    return lane_columns_from(&zero);
}

/* With the last row 0 0 0 1. */
static inline void lane_mat4_from_columns(const lane_columns *m, nkw_mat4 *out)
{
    for (int c = 0; c < 4; c++)
        lane_four_store(out->m + 4 * c, lane_four_end(m->c[c], c == 3));
}

/* (x u + y v) + z w: the sum of nkw_mat4_mul_affine, of all rows at once. u, v, w stand `step` floats apart. */
static inline lane_four lane_columns_direction(const lane_columns *a, const float *b, size_t step)
{
    lane_four xy =
        lane_four_add(lane_four_mul(a->c[0], lane_four_all(b[0])), lane_four_mul(a->c[1], lane_four_all(b[step])));
    return lane_four_add(xy, lane_four_mul(a->c[2], lane_four_all(b[2 * step])));
}

/* (x u + y v) + (z w + translation) */
static inline lane_four lane_columns_point(const lane_columns *a, const float *b, size_t step)
{
    lane_four xy =
        lane_four_add(lane_four_mul(a->c[0], lane_four_all(b[0])), lane_four_mul(a->c[1], lane_four_all(b[step])));
    return lane_four_add(xy, lane_four_add(lane_four_mul(a->c[2], lane_four_all(b[2 * step])), a->c[3]));
}

/* nkw_mat4_mul_affine. */
static inline lane_columns lane_columns_mul(const lane_columns *a, const nkw_mat4 *b)
{
    lane_columns r;
    for (int c = 0; c < 3; c++)
        r.c[c] = lane_columns_direction(a, b->m + 4 * c, 1);
    r.c[3] = lane_columns_point(a, b->m + 12, 1);
    return r;
}

#endif
