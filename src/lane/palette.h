/* SPDX-License-Identifier: MIT */
/* Floor 6: joint matrices. */
#ifndef NAKAWARI_LANE_PALETTE_H
#define NAKAWARI_LANE_PALETTE_H

#include "strict.h"

#include <nakawari/palette.h>

#include "affine.h"

/* (global inverse * model) * inverse bind, each but the model left out where it is NULL. */
static inline lane_columns lane_joint_columns(const lane_columns *global_inverse, const nkw_mat4 *model,
                                              const nkw_mat4 *inverse_bind)
{
    lane_columns m = global_inverse ? lane_columns_mul(global_inverse, model) : lane_columns_from(model);
    return inverse_bind ? lane_columns_mul(&m, inverse_bind) : m;
}

static inline void lane_mat3x4_from_columns(const lane_columns *m, nkw_mat3x4 *out)
{
    lane_columns rows = *m;
    lane_four_transpose(rows.c);
    for (int r = 0; r < 3; r++)
        lane_four_store(out->m + 4 * r, rows.c[r]);
}

#endif
