/* SPDX-License-Identifier: MIT */
/*
 * Blends of poses of records, a block of at most BLEND_BLOCK joints at a time: the texts of batch/blend.c, by other
 * loads and stores.
 *
 *     rotations     four registers of joints from each pose -> sums on the stack      all before anything is written
 *     all floats    lerp, ten registers of floats as they are in memory               rotations too, for nothing
 *     rotations     sum / length                                                      over those lerps
 *
 * The last register overlaps the one before. out may be a or b.
 */
#include "lane/strict.h"

#include <nakawari/scalar.h>

#include "batch/block.h"
#include "batch/nlerp_sums.h"
#include "batch/pose_sums.h"
#include "batch/records.h"
#include "pack/record.h"
#include "sizes.h"

NKW_LOOPS_RECORDS(NKW_DECLARE_LOOP)

#define REGISTER_FLOATS (F32XN * RECORD_FLOATS)

/* The next joints of two poses and of the result, and their sums, SUM_STRIDE floats apart. */
typedef struct record_lanes {
    const float *a, *b;
    float *out, *sum;
} record_lanes;

/* Those `joints` later. */
NKW_ALWAYS_INLINE record_lanes lanes_from(record_lanes l, int joints)
{
    l.a += RECORD_FLOATS * joints;
    l.b += RECORD_FLOATS * joints;
    l.out += RECORD_FLOATS * joints;
    l.sum += joints;
    return l;
}

NKW_ALWAYS_INLINE f32xN_quat rotations_of(const float *records)
{
    f32xN m[4];
    f32xN_read_records(records + 3, m);
    f32xN_quat r = {m[0], m[1], m[2], m[3]};
    return r;
}

NKW_ALWAYS_INLINE void sum_register(record_lanes l, f32xN_weights at, int inside)
{
    put_register_sum(l.sum, l.sum + 4 * SUM_STRIDE, SUM_STRIDE,
                     f32xN_nlerp_of(rotations_of(l.a), rotations_of(l.b), at, inside));
}

NKW_ALWAYS_INLINE void divide_register(record_lanes l, u32xN *far)
{
    const f32xN_quat q = divided_sum(l.sum, l.sum + 4 * SUM_STRIDE, SUM_STRIDE, far);
    f32xN m[4] = {q.x, q.y, q.z, q.w};
    f32xN_write_records(l.out + 3, m);
}

NKW_ALWAYS_INLINE void lerp_floats(record_lanes l, size_t k, f32xN_weights at, int inside)
{
    const size_t i = F32XN * k;
    f32xN_store(l.out + i, f32xN_lerp(f32xN_load(l.a + i), f32xN_load(l.b + i), at, inside));
}

/* All floats by one t. */
NKW_ALWAYS_INLINE void lerp_register(record_lanes l, f32xN_weights at)
{
    for (size_t k = 0; k < RECORD_FLOATS; k++)
        lerp_floats(l, k, at, 1);
}

/* What lerp uses of the weights of each joint, beside each of its floats. */
#define SPREAD_WEIGHTS(at, k)                                                                                          \
    ((f32xN_weights){at.t, at.s, f32xN_spread(at.back, k),                                                             \
                     i32xN_from_f32xN(f32xN_spread(f32xN_from_i32xN(at.first), k)), at.is_first, at.is_last})

/* All floats by the t of each joint. */
NKW_ALWAYS_INLINE void lerp_each(record_lanes l, f32xN t)
{
    const f32xN_weights at = f32xN_weights_of(t, 0);
    lerp_floats(l, 0, SPREAD_WEIGHTS(at, 0), 0);
    lerp_floats(l, 1, SPREAD_WEIGHTS(at, 1), 0);
    lerp_floats(l, 2, SPREAD_WEIGHTS(at, 2), 0);
    lerp_floats(l, 3, SPREAD_WEIGHTS(at, 3), 0);
    lerp_floats(l, 4, SPREAD_WEIGHTS(at, 4), 0);
    lerp_floats(l, 5, SPREAD_WEIGHTS(at, 5), 0);
    lerp_floats(l, 6, SPREAD_WEIGHTS(at, 6), 0);
    lerp_floats(l, 7, SPREAD_WEIGHTS(at, 7), 0);
    lerp_floats(l, 8, SPREAD_WEIGHTS(at, 8), 0);
    lerp_floats(l, 9, SPREAD_WEIGHTS(at, 9), 0);
}

/* All rotations again by the general formula of nlerp; rare. */
NKW_NOINLINE LANE_FLAT static void normalize_again(const float *sum, int used, float *out)
{
    float q[4 * BLEND_BLOCK];
    normalize_sums(block_rows(sum, SUM_STRIDE), sum + 4 * SUM_STRIDE, 1, block_rows_to(q, BLEND_BLOCK), (size_t)used);
    for (int i = 0; i < used; i++)
        for (int c = 0; c < 4; c++)
            out[RECORD_FLOATS * i + 3 + c] = q[BLEND_BLOCK * c + i];
}

/* The weights: one for all joints where `each`, a constant, is NULL; otherwise by the t of each joint, any. */
typedef struct record_weights {
    f32xN_weights at;
    const float *each;
} record_weights;

NKW_ALWAYS_INLINE void sum_at(record_lanes l, record_weights w, int i)
{
    sum_register(l, w.each ? f32xN_weights_of(f32xN_load(w.each + i), 0) : w.at, !w.each);
}

NKW_ALWAYS_INLINE void lerp_at(record_lanes l, record_weights w, int i)
{
    if (w.each)
        lerp_each(l, f32xN_load(w.each + i));
    else
        lerp_register(l, w.at);
}

/*
 * At least a register of joints. The last register overlaps the one before; its lerps are computed before anything is
 * written, since out may be a or b.
 */
NKW_ALWAYS_INLINE int blend_registers(record_lanes begin, record_weights w, int used)
{
    float lerps[REGISTER_FLOATS];
    const int whole = used / F32XN * F32XN, left = used - F32XN;
    u32xN far = u32xN_from_f32xN(f32xN_splat(0.0f));
    record_lanes l = begin, end = lanes_from(begin, left);
    for (int i = 0; i < whole; i += F32XN, l = lanes_from(l, F32XN))
        sum_at(l, w, i);
    l = begin;
    if (whole < used) {
        const record_lanes aside = {end.a, end.b, lerps, end.sum};
        sum_at(end, w, left);
        lerp_at(aside, w, left);
    }
    for (int i = 0; i < whole; i += F32XN, l = lanes_from(l, F32XN)) {
        lerp_at(l, w, i);
        divide_register(l, &far);
    }
    if (whole < used) {
        for (size_t k = 0; k < RECORD_FLOATS; k++)
            f32xN_store(end.out + F32XN * k, f32xN_load_once(lerps + F32XN * k)); /* no call of memcpy */
        divide_register(end, &far);
    }
    return u32xN_any(far) >> 30 != 0;
}

/* Fewer joints than a register, in memory of their own, with identities behind them. */
NKW_ALWAYS_INLINE int blend_few(record_lanes l, record_weights w, int used)
{
    float a[REGISTER_FLOATS] = {0.0f}, b[REGISTER_FLOATS] = {0.0f}, out[REGISTER_FLOATS];
    const size_t bytes = (size_t)used * sizeof(nkw_trs);
    const record_lanes aside = {a, b, out, l.sum};
    u32xN far = u32xN_from_f32xN(f32xN_splat(0.0f));
    memcpy(a, l.a, bytes);
    memcpy(b, l.b, bytes);
    sum_at(aside, w, 0);
    end_sums(l.sum, l.sum + 4 * SUM_STRIDE, SUM_STRIDE, used);
    lerp_at(aside, w, 0);
    divide_register(aside, &far);
    memcpy(l.out, out, bytes);
    return u32xN_any(far) >> 30 != 0;
}

NKW_ALWAYS_INLINE void blend_block(const nkw_trs *a, const nkw_trs *b, record_weights w, int used, nkw_trs *out)
{
    float sum[5 * SUM_STRIDE];
    const record_lanes l = {(const float *)(const void *)a, (const float *)(const void *)b, (float *)(void *)out, sum};
    if (used < F32XN ? blend_few(l, w, used) : blend_registers(l, w, used))
        normalize_again(sum, used, l.out);
}

/* nkw_pose_blend of a block by a t inside 0..1. */
NKW_LOOP(nkwi_records_blend)(const nkw_trs *a, const nkw_trs *b, float t, int used, nkw_trs *out)
{
    const record_weights first = {f32xN_weights_from(t, 1), NULL}, second = {f32xN_weights_from(t, 0), NULL};
    if (t < 0.5f)
        blend_block(a, b, first, used, out);
    else
        blend_block(a, b, second, used, out);
}

/* By a t for each joint, any: BLEND_BLOCK floats. */
NKW_LOOP(nkwi_records_blend_each)(const nkw_trs *a, const nkw_trs *b, const float *t, int used, nkw_trs *out)
{
    const record_weights w = {f32xN_weights_of(f32xN_splat(0.0f), 0), t};
    blend_block(a, b, w, used, out);
}
