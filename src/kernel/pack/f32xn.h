/* SPDX-License-Identifier: MIT */
/*
 * The widest register of floats of the instruction set: F32XN floats, 16 (AVX-512), 8 (AVX), 4 (SSE2, NEON, simd128),
 * or 1, a plain float, where there is no vector type. + - * / act on each float separately and round once, so one text
 * serves every width, the scalar one included.
 *
 * A mask has all bits set in the floats where a comparison holds.
 */
#ifndef NAKAWARI_PACK_F32XN_H
#define NAKAWARI_PACK_F32XN_H

#include "pack/f32x4.h"

#if NKW_F32X4 && NKW_REGISTER_BITS > 128 && defined(__has_builtin)
#if __has_builtin(__builtin_shufflevector)
#define PACK_SHUFFLEVECTOR
#endif
#endif

#if defined(PACK_SHUFFLEVECTOR) && NKW_REGISTER_BITS == 512
#define F32XN 16
#elif defined(PACK_SHUFFLEVECTOR)
#define F32XN 8
#elif NKW_F32X4
#define F32XN 4
#else
#define F32XN 1
#endif

#if F32XN == 1
typedef float f32xN;
typedef int32_t i32xN;
typedef uint32_t u32xN;
#elif F32XN == 4
typedef f32x4 f32xN;
typedef i32x4 i32xN;
typedef uint32_t u32xN __attribute__((vector_size(16)));
#else
typedef float f32xN __attribute__((vector_size(4 * F32XN)));
typedef int32_t i32xN __attribute__((vector_size(4 * F32XN)));
typedef uint32_t u32xN __attribute__((vector_size(4 * F32XN)));
#endif

static inline f32xN f32xN_load(const void *from)
{
    f32xN r;
    memcpy(&r, from, sizeof r);
    return r;
}

#if defined(__has_feature)
#if __has_feature(memory_sanitizer)
#define NKWI_MEMORY_SANITIZER 1
#endif
#endif
#if !defined(NKWI_MEMORY_SANITIZER)
#define NKWI_MEMORY_SANITIZER 0
#endif

/*
 * The same, in a register from here on. x86 compilers would otherwise read memory at each use, which is split in two
 * operations where the address is a sum.
 */
static inline f32xN f32xN_load_once(const void *from)
{
    f32xN r = f32xN_load(from);
#if NKWI_MEMORY_SANITIZER /* it takes the statement for a use of lanes that are dropped later */
#elif NKW_F32X4 && NKW_REGISTER_BITS == 512
    __asm__("" : "+v"(r));
#elif NKW_F32X4 && defined(__SSE2__)
    __asm__("" : "+x"(r));
#endif
    return r;
}

/*
 * All bits in the first n floats, none in the others: what f32xN_keep lets through. 0 < n <= 16.
 */
static inline i32xN f32xN_first(int n)
{
    static const int32_t window[32] = {-1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1};
    i32xN r;
    memcpy(&r, window + 16 - n, sizeof r);
    return r;
}

static inline void f32xN_store(void *to, f32xN a)
{
    memcpy(to, &a, sizeof a);
}

static inline f32xN f32xN_splat(float x)
{
#if F32XN == 1
    return x;
#elif F32XN == 4
    return f32x4_splat(x);
#else
    const f32xN zero = {0.0f};
    return x - zero; /* exact, and one instruction */
#endif
}

static inline i32xN i32xN_from_f32xN(f32xN a)
{
    i32xN r;
    memcpy(&r, &a, sizeof r);
    return r;
}

static inline u32xN u32xN_from_f32xN(f32xN a)
{
    u32xN r;
    memcpy(&r, &a, sizeof r);
    return r;
}

static inline f32xN f32xN_from_i32xN(i32xN a)
{
    f32xN r;
    memcpy(&r, &a, sizeof r);
    return r;
}

/* a where the mask is set, otherwise 0. */
static inline f32xN f32xN_keep(i32xN mask, f32xN a)
{
    return f32xN_from_i32xN(i32xN_from_f32xN(a) & mask);
}

/* a < b */
static inline i32xN f32xN_less(f32xN a, f32xN b)
{
#if F32XN == 1
    return -(a < b);
#else
    return a < b;
#endif
}

/* a == b */
static inline i32xN f32xN_equal(f32xN a, f32xN b)
{
#if F32XN == 1
    return -(a == b);
#else
    return a == b;
#endif
}

/* a where the mask is set, otherwise b. */
static inline f32xN f32xN_select(i32xN mask, f32xN a, f32xN b)
{
    i32xN x = i32xN_from_f32xN(a), y = i32xN_from_f32xN(b);
    return f32xN_from_i32xN(((x ^ y) & mask) ^ y);
}

/* lane_divisor, of what is not -0. */
static inline f32xN f32xN_divisor(f32xN a)
{
    const i32xN bits = i32xN_from_f32xN(a);
#if F32XN == 1
    const i32xN is_none = -(bits == 0);
#else
    const i32xN is_none = bits == 0;
#endif
    return f32xN_from_i32xN(bits | (is_none & 0x3F800000));
}

/* a, negated where the mask is set. */
static inline f32xN f32xN_negate_where(i32xN mask, f32xN a)
{
    return f32xN_from_i32xN(i32xN_from_f32xN(a) ^ (mask & INT32_MIN));
}

/* |a| */
static inline f32xN f32xN_magnitude(f32xN a)
{
    return f32xN_from_i32xN(i32xN_from_f32xN(a) & INT32_MAX);
}

/* The bits that are set in any of the elements. */
static inline uint32_t u32xN_any(u32xN a)
{
    uint32_t v[F32XN], any = 0;
    memcpy(v, &a, sizeof v);
    for (int i = 0; i < F32XN; i++)
        any |= v[i];
    return any;
}

static inline f32xN f32xN_sqrt(f32xN a)
{
    float v[F32XN];
    memcpy(v, &a, sizeof v);
    for (int i = 0; i < F32XN; i++)
        v[i] = sqrtf(v[i]);
    memcpy(&a, v, sizeof a);
    return a;
}

/* 1 / |v| by n2 = v.v; 0 where n2 = 0. */
static inline f32xN f32xN_inverse_length(f32xN n2)
{
    const f32xN zero = f32xN_splat(0.0f);
    return f32xN_select(f32xN_equal(n2, zero), zero, f32xN_splat(1.0f) / f32xN_sqrt(f32xN_divisor(n2)));
}

#endif
