/* SPDX-License-Identifier: MIT */
/*
 * Quaternions between arguments, results and registers.
 *
 * The x86-64 ABI passes a quaternion as two pairs of floats. GCC stores both and loads all four numbers at once; such a
 * load waits until both stores have left the processor, some 30 cycles. The empty assembly keeps the pairs in
 * registers.
 */
#ifndef NAKAWARI_PACK_QUAT_H
#define NAKAWARI_PACK_QUAT_H

#include "lane/strict.h"

#include <nakawari/types.h>

#include "pack/f32x4.h"
#include "pack/f64x2.h"

#if NKW_F32X4
#if !defined(__clang__) && defined(__SSE2__) && defined(__x86_64__)
#define PACK_QUAT_PAIRS
#endif

static inline f32x4 f32x4_from_quat(nkw_quat q)
{
#if defined(PACK_QUAT_PAIRS)
    double xy, zw;
    memcpy(&xy, &q.x, sizeof xy);
    memcpy(&zw, &q.z, sizeof zw);
    __asm__("" : "+x"(xy), "+x"(zw));
    return (f32x4)f64x2_of(xy, zw);
#else
    f32x4 r = {q.x, q.y, q.z, q.w};
    return r;
#endif
}

static inline nkw_quat quat_from_f32x4(f32x4 a)
{
#if defined(PACK_QUAT_PAIRS)
    nkw_quat r;
    int64_t xy = ((i64x2)a)[0], zw = ((i64x2)a)[1]; /* as integers: GCC leaves them where they are */
    __asm__("" : "+x"(xy), "+x"(zw));
    memcpy(&r.x, &xy, sizeof xy);
    memcpy(&r.z, &zw, sizeof zw);
#else
    nkw_quat r = {a[0], a[1], a[2], a[3]};
#endif
    return r;
}
#endif

/* A result of three floats: the ABI returns x and y as a pair. */
static inline nkw_vec3 vec3_result(float x, float y, float z)
{
#if defined(PACK_QUAT_PAIRS)
    const f32x4 both = {x, y, 0.0f, 0.0f};
    nkw_vec3 r;
    int64_t xy = ((i64x2)both)[0];
    __asm__("" : "+x"(xy));
    memcpy(&r.x, &xy, sizeof xy);
    r.z = z;
#else
    nkw_vec3 r = {x, y, z};
#endif
    return r;
}

/* An argument whose components are used one by one. */
static inline nkw_quat quat_argument(nkw_quat q)
{
#if NKW_F32X4
    const f32x4 a = f32x4_from_quat(q);
    nkw_quat r = {a[0], a[1], a[2], a[3]};
    return r;
#else
    return q;
#endif
}

#endif
