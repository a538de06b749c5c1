/* SPDX-License-Identifier: MIT */
/*
 * Poses of records (nkw_trs) to component arrays, and back: a register of joints at a time.
 *
 *     a record     | tx ty tz rx | ry rz rw sx | sy sz |
 *     read from    0             4        6              four floats each; the last four begin with two known ones
 *
 * The last register overlaps the one before. All bits are copied.
 */
#ifndef NAKAWARI_BATCH_RECORD_ROWS_H
#define NAKAWARI_BATCH_RECORD_ROWS_H

#include "lane/strict.h"

#include <nakawari/types.h>

#include "batch/isa.h"
#include "pack/record.h"

/* A register of joints to rows, `stride` floats apart. */
NKW_ALWAYS_INLINE void read_joints(const float *p, float *rows, size_t stride)
{
    for (size_t c = 0; c < 3; c++) {
        const size_t at = c < 2 ? 4 * c : RECORD_FLOATS - 4;
        f32xN m[4];
        f32xN_read_records(p + at, m);
        for (size_t k = c < 2 ? 0 : 2; k < 4; k++)
            f32xN_store(rows + (at + k) * stride, m[k]);
    }
}

NKW_ALWAYS_INLINE void write_joints(const float *rows, size_t stride, float *p)
{
    for (size_t c = 0; c < 3; c++) {
        const size_t at = c < 2 ? 4 * c : RECORD_FLOATS - 4;
        f32xN m[4];
        for (size_t k = 0; k < 4; k++)
            m[k] = f32xN_load(rows + (at + k) * stride);
        f32xN_write_records(p + at, m);
    }
}

/* The first joint of the next register: that of the last one is such that it ends with joint n - 1. */
NKW_ALWAYS_INLINE size_t register_at(size_t j, size_t n)
{
    return j + F32XN <= n ? j : n - F32XN;
}

/* n joints to rows, `stride` floats apart. */
NKW_ALWAYS_INLINE void rows_from_records(const nkw_trs *trs, size_t n, float *rows, size_t stride)
{
    const float *p = (const float *)(const void *)trs;
    for (size_t j = 0; n >= F32XN && j < n; j += F32XN) {
        const size_t at = register_at(j, n);
        read_joints(p + RECORD_FLOATS * at, rows + at, stride);
    }
    for (size_t j = 0; n < F32XN && j < n; j++)
        for (size_t c = 0; c < RECORD_FLOATS; c++)
            memcpy(rows + c * stride + j, p + RECORD_FLOATS * j + c, sizeof *p);
}

NKW_ALWAYS_INLINE void records_from_rows(const float *rows, size_t stride, size_t n, nkw_trs *trs)
{
    float *p = (float *)(void *)trs;
    for (size_t j = 0; n >= F32XN && j < n; j += F32XN) {
        const size_t at = register_at(j, n);
        write_joints(rows + at, stride, p + RECORD_FLOATS * at);
    }
    for (size_t j = 0; n < F32XN && j < n; j++)
        for (size_t c = 0; c < RECORD_FLOATS; c++)
            memcpy(p + RECORD_FLOATS * j + c, rows + c * stride + j, sizeof *p);
}

#endif
