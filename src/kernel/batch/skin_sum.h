/* SPDX-License-Identifier: MIT */
/* The weighted sum of the palette entries of a vertex, of any kind of entry. */
#ifndef NAKAWARI_BATCH_SKIN_SUM_H
#define NAKAWARI_BATCH_SKIN_SUM_H

#include "batch/skin_decode.h"
#include "pack/columns.h"

/* The width of a crowd's matrix: 12 rows of 16 lanes; crowd.c has the check against its header. */
#define CROWD_ROW   16
#define CROWD_WIDTH (12 * CROWD_ROW)

/*
 * An entry of `width` floats (16: nkw_mat4, 9: nkw_mat3, 8: nkw_dual_quat) in registers, at every PART floats; the last
 * one ends with the entry, so it overlaps the one before where PART does not divide the width. Of a crowd's, one
 * register of each row: its palette begins at the first of these lanes.
 *
 *     F32XN    nkw_mat4                   nkw_mat3           nkw_dual_quat      crowd
 *     4        0-3 4-7 8-11 12-15         0-3 4-7 5-8        0-3 4-7            0-3  16-19 ... 176-179
 *     8        0-7 8-15                   0-7 1-8            0-7                0-7  16-23 ... 176-183
 *     16       0-15                       0-7 1-8            0-7                0-15 16-31 ... 176-191
 */
#define PART(width)       ((width) < F32XN ? 8 : (width) == CROWD_WIDTH ? CROWD_ROW : F32XN)
#define PARTS(width)      (((width) + PART(width) - 1) / PART(width))
#define PART_AT(width, a) ((a)*PART(width) + PART(width) > (width) ? (width)-PART(width) : (a)*PART(width))

NKW_ALWAYS_INLINE f32xN load_part(const unsigned char *entry, size_t width, size_t a)
{
    const unsigned char *p = entry + PART_AT(width, a) * sizeof(float);
    return PART(width) < F32XN ? f32xN_load8(p) : f32xN_load(p);
}

NKW_ALWAYS_INLINE void store_part(float *to, size_t width, size_t a, f32xN part)
{
    if (PART(width) < F32XN)
        f32xN_store8(to + PART_AT(width, a), part);
    else
        f32xN_store(to + PART_AT(width, a), part);
}

/* The entry of a joint by the offset of its nkw_mat4, 64 joint bytes; of `width` floats, 4 width joint bytes. */
NKW_ALWAYS_INLINE const unsigned char *entry_at(const unsigned char *palette, size_t width, size_t offset)
{
    return palette + (width % 16 == 0 ? offset * (width / 16) : offset / 16 * width);
}

/* (w0 m0 + w1 m1) + w2 m2 ... of vertex i, k at least 1. */
NKW_ALWAYS_INLINE void weighted_sum(const influences *f, size_t width, size_t k, size_t i, f32xN *sum)
{
    const uint32_t *offset = f->offset + i * k;
    const unsigned char *weights = f->weights + i * f->weight_stride, *entry = entry_at(f->palette, width, offset[0]);
    f32xN w = f32xN_splat(load_float(weights));
    for (size_t a = 0; a < PARTS(width); a++)
        sum[a] = load_part(entry, width, a) * w;
    for (size_t e = 1; e < k; e++) {
        entry = entry_at(f->palette, width, offset[e]);
        w = f32xN_splat(load_float(weights + e * sizeof(float)));
        for (size_t a = 0; a < PARTS(width); a++)
            sum[a] = sum[a] + load_part(entry, width, a) * w;
    }
}

#endif
