/* SPDX-License-Identifier: MIT */
/* Floor 6: joint matrices. */
#ifndef NAKAWARI_LANE_PALETTE_H
#define NAKAWARI_LANE_PALETTE_H

#include "strict.h"

#include <nakawari/palette.h>

#include "four.h"

/* An affine matrix by its columns x, y, z and translation. The fourth row may hold anything. */
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

/* (x u + y v) + z w: the sum of nkw_mat4_mul_affine, of all rows at once. */
static inline lane_four lane_columns_sum(const lane_columns *a, const float *b, lane_four z)
{
    return lane_four_add(
        lane_four_add(lane_four_mul(a->c[0], lane_four_all(b[0])), lane_four_mul(a->c[1], lane_four_all(b[1]))), z);
}

/* nkw_mat4_mul_affine. */
static inline lane_columns lane_columns_mul(const lane_columns *a, const nkw_mat4 *b)
{
    lane_columns r;
    for (int c = 0; c < 3; c++)
        r.c[c] = lane_columns_sum(a, b->m + 4 * c, lane_four_mul(a->c[2], lane_four_all(b->m[4 * c + 2])));
    r.c[3] = lane_columns_sum(a, b->m + 12, lane_four_add(lane_four_mul(a->c[2], lane_four_all(b->m[14])), a->c[3]));
    return r;
}

/* (global inverse * model) * inverse bind, each but the model left out where it is NULL. */
static inline lane_columns lane_joint_columns(const lane_columns *global_inverse, const nkw_mat4 *model,
                                              const nkw_mat4 *inverse_bind)
{
    lane_columns m = global_inverse ? lane_columns_mul(global_inverse, model) : lane_columns_from(model);
    return inverse_bind ? lane_columns_mul(&m, inverse_bind) : m;
}

static inline void lane_mat4_from_columns(const lane_columns *m, nkw_mat4 *out)
{
    for (int c = 0; c < 4; c++)
        lane_four_store(out->m + 4 * c, lane_four_end(m->c[c], c == 3));
}

static inline void lane_mat3x4_from_columns(const lane_columns *m, nkw_mat3x4 *out)
{
    lane_columns rows = *m;
    lane_four_transpose(rows.c);
    for (int r = 0; r < 3; r++)
        lane_four_store(out->m + 4 * r, rows.c[r]);
}

#endif
