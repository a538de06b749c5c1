/* SPDX-License-Identifier: MIT */
/*
 * Registers of joints from poses of records (nkw_trs: ten floats, 40 bytes), and back.
 *
 *     memory, floats       | tx ty tz rx ry rz rw sx sy sz | tx ty ...
 *     four of each record  m[0..3], the floats from an offset on: one register for each float, one element for each record
 *
 * All functions move bits and compute nothing.
 */
#ifndef NAKAWARI_PACK_RECORD_H
#define NAKAWARI_PACK_RECORD_H

#include "pack/columns.h"

#if F32XN >= 8
#include <immintrin.h>
#endif

#define RECORD_FLOATS 10

#if F32XN >= 8
/* Four floats, then four of the fourth record after. GCC makes one instruction of the intrinsic, two of a shuffle. */
static inline f32x8 f32x8_read_fours(const float *p)
{
    const f32x4 a = f32x4_load(p), b = f32x4_load(p + 4 * RECORD_FLOATS);
    return (f32x8)_mm256_insertf128_ps(_mm256_castps128_ps256((__m128)a), (__m128)b, 1);
}
#endif

/* Four floats of each of F32XN / 4 records, each the fourth after the one before. */
static inline f32xN f32xN_read_fours(const float *p)
{
#if F32XN == 1
    return *p;
#elif F32XN == 4
    return f32x4_load(p);
#elif F32XN == 8
    return f32x8_read_fours(p);
#else
    return F32XN_SHUFFLE(f32x8_read_fours(p), f32x8_read_fours(p + 8 * RECORD_FLOATS), 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10,
                         11, 12, 13, 14, 15);
#endif
}

static inline void f32xN_write_fours(float *p, f32xN a)
{
#if F32XN == 1
    *p = a;
#elif F32XN == 4
    f32x4_store(p, a);
#else
    f32x4 part[F32XN / 4];
    memcpy(part, &a, sizeof a);
    for (int g = 0; g < F32XN / 4; g++)
        f32x4_store(p + 4 * g * RECORD_FLOATS, part[g]);
#endif
}

/* The floats from p on, four of each of F32XN records: m[k] has float k. */
static inline void f32xN_read_records(const float *p, f32xN m[4])
{
    for (int k = 0; k < 4; k++)
        m[k] = f32xN_read_fours(F32XN == 1 ? p + k : p + k * RECORD_FLOATS);
    f32xN_transpose(m);
}

static inline void f32xN_write_records(float *p, f32xN m[4])
{
    f32xN_transpose(m);
    for (int k = 0; k < 4; k++)
        f32xN_write_fours(F32XN == 1 ? p + k : p + k * RECORD_FLOATS, m[k]);
}

/*
 * A number of each joint beside each float of its record: register k of the RECORD_FLOATS registers that F32XN records
 * take. k is a constant.
 *
 *     F32XN = 8, k = 1      t0 t0 t1 t1 t1 t1 t1 t1      floats 8 .. 15
 */
#define RECORD_OF(k, i) ((F32XN * (k) + (i)) / RECORD_FLOATS)
#if F32XN == 1
#define f32xN_spread(t, k) (t)
#elif F32XN == 4
#define f32xN_spread(t, k) F32X4_SHUFFLE(t, t, RECORD_OF(k, 0), RECORD_OF(k, 1), RECORD_OF(k, 2), RECORD_OF(k, 3))
#elif F32XN == 8
#define f32xN_spread(t, k)                                                                                             \
    F32XN_SHUFFLE(t, t, RECORD_OF(k, 0), RECORD_OF(k, 1), RECORD_OF(k, 2), RECORD_OF(k, 3), RECORD_OF(k, 4),           \
                  RECORD_OF(k, 5), RECORD_OF(k, 6), RECORD_OF(k, 7))
#else
#define f32xN_spread(t, k)                                                                                             \
    F32XN_SHUFFLE(t, t, RECORD_OF(k, 0), RECORD_OF(k, 1), RECORD_OF(k, 2), RECORD_OF(k, 3), RECORD_OF(k, 4),           \
                  RECORD_OF(k, 5), RECORD_OF(k, 6), RECORD_OF(k, 7), RECORD_OF(k, 8), RECORD_OF(k, 9),                 \
                  RECORD_OF(k, 10), RECORD_OF(k, 11), RECORD_OF(k, 12), RECORD_OF(k, 13), RECORD_OF(k, 14),            \
                  RECORD_OF(k, 15))
#endif

#endif
