/* SPDX-License-Identifier: MIT */
/*
 * Four floats side by side, for matrices in arrays of structs: one column of a 4x4 matrix. Each of the four is what
 * the same line says of one float.
 *
 * Compilers do not find these in loops over matrices by themselves: they turn sixteen floats of several matrices around
 * instead, which costs more than it saves. ARMv7's vectors flush subnormals, so floats go one by one there, and with
 * compilers that have no such type.
 */
#ifndef NAKAWARI_LANE_FOUR_H
#define NAKAWARI_LANE_FOUR_H

#include "strict.h"

#include <stdint.h>
#include <string.h>

#if defined(__GNUC__) && !defined(__arm__) && !defined(NKW_PLAIN_FOUR)
#define LANE_FOUR /* lane_four has the operators of numbers */

typedef float lane_four __attribute__((vector_size(16)));
typedef int32_t lane_four_bits __attribute__((vector_size(16)));
typedef uint32_t lane_four_words __attribute__((vector_size(16)));
typedef int64_t lane_four_pair __attribute__((vector_size(16)));

static inline lane_four lane_four_all(float x)
{
    lane_four r = {x, x, x, x};
    return r;
}

static inline lane_four lane_four_add(lane_four a, lane_four b)
{
    return a + b;
}

static inline lane_four lane_four_sub(lane_four a, lane_four b)
{
    return a - b;
}

static inline lane_four lane_four_mul(lane_four a, lane_four b)
{
    return a * b;
}

static inline lane_four lane_four_div(lane_four a, lane_four b)
{
    return a / b;
}

/* -b where a < 0, else b. */
static inline lane_four lane_four_turn(lane_four a, lane_four b)
{
    const lane_four zero = {0.0f, 0.0f, 0.0f, 0.0f};
    return (lane_four)((lane_four_bits)b ^ ((lane_four_bits)(a < zero) & INT32_MIN));
}

/* b, its bit 30 or 31 set where not 0 < a <= 2: all others' bits are below 2^30 once 1 is taken off them. */
static inline lane_four lane_four_mark(lane_four b, lane_four a)
{
    return (lane_four)((lane_four_words)b | ((lane_four_words)a - 1));
}

/* b where a is 0. */
static inline lane_four lane_four_unless_zero(lane_four a, lane_four b)
{
    const lane_four zero = {0.0f, 0.0f, 0.0f, 0.0f};
    return (lane_four)((lane_four_bits)b & (lane_four_bits)(a != zero));
}

#if defined(__clang__)
#define LANE_FOUR_MIX(a, b, i, j, k, l) __builtin_shufflevector(a, b, i, j, k, l)
#else
#define LANE_FOUR_MIX(a, b, i, j, k, l) __builtin_shuffle(a, b, (lane_four_bits){i, j, k, l})
#endif

/* a[0] a[1] a[2] and 0 or 1. */
static inline lane_four lane_four_end(lane_four a, int one)
{
#if defined(__AVX__)
    const lane_four last = {0.0f, 0.0f, 0.0f, one ? 1.0f : 0.0f};
    return LANE_FOUR_MIX(a, last, 0, 1, 2, 7);
#else
    const lane_four_bits keep = {-1, -1, -1, 0}, last = {0, 0, 0, one ? 0x3f800000 : 0};
    return (lane_four)(((lane_four_bits)a & keep) | last);
#endif
}

/* x where mask is all ones, y where it is 0. */
static inline lane_four lane_four_select(lane_four_bits mask, lane_four x, lane_four y)
{
    return (lane_four)((((lane_four_bits)x ^ (lane_four_bits)y) & mask) ^ (lane_four_bits)y);
}

static inline lane_four lane_four_flip(lane_four a, lane_four_bits sign_bits)
{
    return (lane_four)((lane_four_bits)a ^ sign_bits);
}

/* (a[0] + a[1]) + (a[2] + a[3]), four times. */
static inline lane_four lane_four_sum(lane_four a)
{
    lane_four pairs = a + LANE_FOUR_MIX(a, a, 1, 0, 3, 2);
    return pairs + LANE_FOUR_MIX(pairs, pairs, 2, 3, 0, 1);
}

/* Columns become rows. */
static inline void lane_four_transpose(lane_four m[4])
{
    lane_four a = LANE_FOUR_MIX(m[0], m[1], 0, 4, 1, 5), b = LANE_FOUR_MIX(m[2], m[3], 0, 4, 1, 5);
    lane_four c = LANE_FOUR_MIX(m[0], m[1], 2, 6, 3, 7), d = LANE_FOUR_MIX(m[2], m[3], 2, 6, 3, 7);
    m[0] = LANE_FOUR_MIX(a, b, 0, 1, 4, 5);
    m[1] = LANE_FOUR_MIX(a, b, 2, 3, 6, 7);
    m[2] = LANE_FOUR_MIX(c, d, 0, 1, 4, 5);
    m[3] = LANE_FOUR_MIX(c, d, 2, 3, 6, 7);
}

/* a[0] a[1] a[2] */
static inline void lane_four_store3(unsigned char *p, lane_four a)
{
    const lane_four_pair pairs = (lane_four_pair)a;
    const int64_t low = pairs[0];
    const float high = a[2];
    memcpy(p, &low, sizeof low);
    memcpy(p + sizeof low, &high, sizeof high);
}

/* a[i] a[i] a[i] a[i] */
#if defined(__SSE2__) && !defined(__AVX__)
/* As whole numbers it is one instruction; as floats it would need a copy. */
#define lane_four_splat(a, i) ((lane_four)LANE_FOUR_MIX((lane_four_bits)(a), (lane_four_bits)(a), i, i, i, i))
#else
#define lane_four_splat(a, i) LANE_FOUR_MIX(a, a, i, i, i, i)
#endif

#else

typedef struct lane_four {
    float v[4];
} lane_four;

static inline lane_four lane_four_all(float x)
{
    lane_four r = {{x, x, x, x}};
    return r;
}

static inline lane_four lane_four_add(lane_four a, lane_four b)
{
    lane_four r = {{a.v[0] + b.v[0], a.v[1] + b.v[1], a.v[2] + b.v[2], a.v[3] + b.v[3]}};
    return r;
}

static inline lane_four lane_four_sub(lane_four a, lane_four b)
{
    lane_four r = {{a.v[0] - b.v[0], a.v[1] - b.v[1], a.v[2] - b.v[2], a.v[3] - b.v[3]}};
    return r;
}

static inline lane_four lane_four_mul(lane_four a, lane_four b)
{
    lane_four r = {{a.v[0] * b.v[0], a.v[1] * b.v[1], a.v[2] * b.v[2], a.v[3] * b.v[3]}};
    return r;
}

static inline lane_four lane_four_div(lane_four a, lane_four b)
{
    lane_four r = {{a.v[0] / b.v[0], a.v[1] / b.v[1], a.v[2] / b.v[2], a.v[3] / b.v[3]}};
    return r;
}

static inline lane_four lane_four_turn(lane_four a, lane_four b)
{
    lane_four r;
    for (int i = 0; i < 4; i++)
        r.v[i] = a.v[i] < 0.0f ? -b.v[i] : b.v[i];
    return r;
}

static inline lane_four lane_four_mark(lane_four b, lane_four a)
{
    lane_four r;
    for (int i = 0; i < 4; i++)
        r.v[i] = a.v[i] > 0.0f && a.v[i] <= 2.0f ? b.v[i] : 2.0f;
    return r;
}

static inline lane_four lane_four_unless_zero(lane_four a, lane_four b)
{
    lane_four r;
    for (int i = 0; i < 4; i++)
        r.v[i] = a.v[i] == 0.0f ? 0.0f : b.v[i];
    return r;
}

static inline void lane_four_store3(unsigned char *p, lane_four a)
{
    memcpy(p, a.v, 3 * sizeof(float));
}

static inline lane_four lane_four_splat(lane_four a, int i)
{
    return lane_four_all(a.v[i]);
}

static inline lane_four lane_four_end(lane_four a, int one)
{
    lane_four r = {{a.v[0], a.v[1], a.v[2], one ? 1.0f : 0.0f}};
    return r;
}

static inline void lane_four_transpose(lane_four m[4])
{
    lane_four t[4] = {m[0], m[1], m[2], m[3]};
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 4; k++)
            m[i].v[k] = t[k].v[i];
}

#endif

static inline lane_four lane_four_load(const float *p)
{
    lane_four r;
    memcpy(&r, p, sizeof r);
    return r;
}

static inline lane_four lane_four_load_bytes(const unsigned char *p)
{
    lane_four r;
    memcpy(&r, p, sizeof r);
    return r;
}

/* Four times the float at p, of any alignment. */
static inline lane_four lane_four_all_of(const unsigned char *p)
{
    float x;
    memcpy(&x, p, sizeof x);
    return lane_four_all(x);
}

static inline void lane_four_store(float *p, lane_four a)
{
    memcpy(p, &a, sizeof a);
}

static inline void lane_four_store_bytes(unsigned char *p, lane_four a)
{
    memcpy(p, &a, sizeof a);
}

#endif
