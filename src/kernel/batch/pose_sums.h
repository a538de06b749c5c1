/* SPDX-License-Identifier: MIT */
/* The sums of nlerp of a block of a pose, a register at a time, and their division by their lengths. */
#ifndef NAKAWARI_BATCH_POSE_SUMS_H
#define NAKAWARI_BATCH_POSE_SUMS_H

#include "lane/strict.h"

#include "batch/isa.h"
#include "pack/nlerp.h"
#include "sizes.h"

/*
 * Floats from one component of the sums of a block to the next: a register more than the block has joints.
 *
 *     sum    | x of used joints | 0 | ... | y | 0 | z | 0 | w | 1 | length | 1 |        |0|, |1|: end_sums
 *            0                        SUM_STRIDE            4 SUM_STRIDE
 *
 * The last, masked register divides by these identities: 1/1, no flag of a division is raised.
 */
#define SUM_STRIDE (BLEND_BLOCK + F32XN)

NKW_ALWAYS_INLINE void put_register_sum(float *sum, float *length, size_t sums, f32xN_nlerp r)
{
    f32xN_quat_store(sum, sums, r.v);
    f32xN_store(length, f32xN_sqrt(r.n2));
}

/* Identities from joint `used` on, whose lengths are 1. */
NKW_ALWAYS_INLINE void end_sums(float *sum, float *length, size_t sums, int used)
{
    const f32xN zero = f32xN_splat(0.0f), one = f32xN_splat(1.0f);
    f32xN_quat identity = {zero, zero, zero, one};
    f32xN_quat_store(sum + used, sums, identity);
    f32xN_store(length + used, one);
}

/*
 * Divides the next sums by their lengths. Sets bits 30 or 31 of *far where one is not in 1 .. 2^128.
 *
 *     n             bits of n - bits of 1
 *     1 .. 2^128    0 .. 2^30 - 1         exponents 127 .. 254
 *     inf, NaN      from 2^30 on          exponent 255
 *     below 1       from 2^31 on          borrows
 *
 * Sums are made 2^60 times as long (NKW_NLERP_SCALE): those of two unit rotations along the shorter arc have lengths of
 * 0.7 to 1 times 2^60. The general formula is right for all lengths, and rarely needed.
 */
NKW_ALWAYS_INLINE f32xN_quat divided_sum(const float *sum, const float *length, size_t sums, u32xN *far)
{
    const f32xN n = f32xN_load_once(length);
    *far |= u32xN_from_f32xN(n) - (UINT32_C(127) << 23);
    return f32xN_quat_over(f32xN_quat_load(sum, sums), n);
}

#endif
