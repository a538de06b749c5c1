/* SPDX-License-Identifier: MIT */
/*
 * LANE_FOURS columns of 4x4 matrices, fours, side by side in a register: 1, 2 or 4. A matrix is LANE_PARTS registers.
 * Each float is what the same line of four.h says of it.
 */
#ifndef NAKAWARI_LANE_FOURS_H
#define NAKAWARI_LANE_FOURS_H

#include <math.h>

#include "four.h"

#if defined(LANE_FOUR) && defined(__has_builtin) && defined(__AVX__)
#if __has_builtin(__builtin_shufflevector)
#if defined(__AVX512F__)
#define LANE_FOURS 4
#else
#define LANE_FOURS 2
#endif
#endif
#endif
#if !defined(LANE_FOURS)
#define LANE_FOURS 1
#endif
#define LANE_WIDE  (4 * LANE_FOURS)
#define LANE_PARTS (4 / LANE_FOURS)

#if LANE_FOURS == 1
typedef lane_four lane_wide;
#else
typedef float lane_eight __attribute__((vector_size(32)));
typedef float lane_wide __attribute__((vector_size(4 * LANE_WIDE)));
#endif

/* One matrix, its columns in turn. */
typedef struct lane_wide_matrix {
    lane_wide part[LANE_PARTS];
} lane_wide_matrix;

/* LANE_FOURS matrices: their first columns side by side, their second ones, ... */
typedef struct lane_wide_columns {
    lane_wide x, y, z, t;
} lane_wide_columns;

/* LANE_FOURS vectors: each component four times. */
typedef struct lane_wide_vectors {
    lane_wide x, y, z;
} lane_wide_vectors;

static inline lane_wide lane_wide_load(const float *p)
{
    lane_wide r;
    memcpy(&r, p, sizeof r);
    return r;
}

/*
 * The same, into a register at once. Otherwise x86 compilers read memory at each use, which takes two steps where an
 * address has two parts.
 */
static inline lane_wide lane_wide_load_once(const float *p)
{
    lane_wide r = lane_wide_load(p);
#if defined(LANE_FOUR) && defined(__AVX512F__)
    __asm__("" : "+v"(r));
#elif defined(LANE_FOUR) && defined(__SSE2__)
    __asm__("" : "+x"(r));
#endif
    return r;
}

static inline void lane_wide_store(float *p, lane_wide a)
{
    memcpy(p, &a, sizeof a);
}

static inline lane_wide lane_wide_load_bytes(const unsigned char *p)
{
    lane_wide r;
    memcpy(&r, p, sizeof r);
    return r;
}

#if LANE_FOURS == 1

#define lane_wide_add(a, b)         lane_four_add(a, b)
#define lane_wide_sub(a, b)         lane_four_sub(a, b)
#define lane_wide_mul(a, b)         lane_four_mul(a, b)
#define lane_wide_div(a, b)         lane_four_div(a, b)
#define lane_wide_all(x)            lane_four_all(x)
#define lane_wide_all_of(p)         lane_four_all_of(p)
#define lane_wide_turn(a, b)        lane_four_turn(a, b)
#define lane_wide_mark(b, a)        lane_four_mark(b, a)
#define lane_wide_unless_zero(a, b) lane_four_unless_zero(a, b)
#define lane_wide_splat(a, i)       lane_four_splat(a, i)
#define lane_wide_transpose(m)      lane_four_transpose(m)

static inline lane_wide_columns lane_wide_columns_of(const lane_wide_matrix *m)
{
    lane_wide_columns r = {m->part[0], m->part[1], m->part[2], m->part[3]};
    return r;
}

#else

typedef int32_t lane_wide_bits __attribute__((vector_size(4 * LANE_WIDE)));
typedef uint32_t lane_wide_words __attribute__((vector_size(4 * LANE_WIDE)));

#define lane_wide_add(a, b) ((a) + (b))
#define lane_wide_sub(a, b) ((a) - (b))
#define lane_wide_mul(a, b) ((a) * (b))
#define lane_wide_div(a, b) ((a) / (b))

static inline lane_wide lane_wide_all(float x)
{
    const lane_wide zero = {0.0f};
    return x - zero;
}

/* The float at p, of any alignment. */
static inline lane_wide lane_wide_all_of(const unsigned char *p)
{
    float x;
    memcpy(&x, p, sizeof x);
    return lane_wide_all(x);
}

static inline lane_wide lane_wide_turn(lane_wide a, lane_wide b)
{
    const lane_wide zero = {0.0f};
    return (lane_wide)((lane_wide_bits)b ^ ((lane_wide_bits)(a < zero) & INT32_MIN));
}

static inline lane_wide lane_wide_mark(lane_wide b, lane_wide a)
{
    return (lane_wide)((lane_wide_words)b | ((lane_wide_words)a - 1));
}

static inline lane_wide lane_wide_unless_zero(lane_wide a, lane_wide b)
{
    const lane_wide zero = {0.0f};
    return (lane_wide)((lane_wide_bits)b & (lane_wide_bits)(a != zero));
}

/* LANE_EACH(a, b, i, j, k, l): of each four of a, or LANE_WIDE + i: of each of b. */
#define LANE_MIX(a, b, ...) __builtin_shufflevector(a, b, __VA_ARGS__)
#if LANE_FOURS == 2
#define LANE_EACH(a, b, i, j, k, l) LANE_MIX(a, b, i, j, k, l, 4 + (i), 4 + (j), 4 + (k), 4 + (l))
#else
#define LANE_EACH(a, b, i, j, k, l)                                                                                    \
    LANE_MIX(a, b, i, j, k, l, 4 + (i), 4 + (j), 4 + (k), 4 + (l), 8 + (i), 8 + (j), 8 + (k), 8 + (l), 12 + (i),       \
             12 + (j), 12 + (k), 12 + (l))
#endif
#define lane_wide_splat(a, i) LANE_EACH(a, a, i, i, i, i)

/* lane_four_transpose of each of the fours. */
static inline void lane_wide_transpose(lane_wide m[4])
{
    lane_wide a = LANE_EACH(m[0], m[1], 0, LANE_WIDE, 1, LANE_WIDE + 1);
    lane_wide b = LANE_EACH(m[2], m[3], 0, LANE_WIDE, 1, LANE_WIDE + 1);
    lane_wide c = LANE_EACH(m[0], m[1], 2, LANE_WIDE + 2, 3, LANE_WIDE + 3);
    lane_wide d = LANE_EACH(m[2], m[3], 2, LANE_WIDE + 2, 3, LANE_WIDE + 3);
    m[0] = LANE_EACH(a, b, 0, 1, LANE_WIDE, LANE_WIDE + 1);
    m[1] = LANE_EACH(a, b, 2, 3, LANE_WIDE + 2, LANE_WIDE + 3);
    m[2] = LANE_EACH(c, d, 0, 1, LANE_WIDE, LANE_WIDE + 1);
    m[3] = LANE_EACH(c, d, 2, 3, LANE_WIDE + 2, LANE_WIDE + 3);
}

#if LANE_FOURS == 2

static inline lane_wide_columns lane_wide_columns_of(const lane_wide_matrix *m)
{
    const lane_wide *a = m[0].part, *b = m[1].part;
    lane_wide_columns r = {
        LANE_MIX(a[0], b[0], 0, 1, 2, 3, 8, 9, 10, 11),
        LANE_MIX(a[0], b[0], 4, 5, 6, 7, 12, 13, 14, 15),
        LANE_MIX(a[1], b[1], 0, 1, 2, 3, 8, 9, 10, 11),
        LANE_MIX(a[1], b[1], 4, 5, 6, 7, 12, 13, 14, 15),
    };
    return r;
}

#else

/* The fours that begin at i, j, k, l. */
#define LANE_TAKE(a, b, i, j, k, l)                                                                                    \
    LANE_MIX(a, b, i, i + 1, i + 2, i + 3, j, j + 1, j + 2, j + 3, k, k + 1, k + 2, k + 3, l, l + 1, l + 2, l + 3)

static inline lane_wide_columns lane_wide_columns_of(const lane_wide_matrix *m)
{
    const lane_wide a = m[0].part[0], b = m[1].part[0], c = m[2].part[0], d = m[3].part[0];
    lane_wide xy = LANE_TAKE(a, b, 0, 4, 16, 20), xy2 = LANE_TAKE(c, d, 0, 4, 16, 20);
    lane_wide zt = LANE_TAKE(a, b, 8, 12, 24, 28), zt2 = LANE_TAKE(c, d, 8, 12, 24, 28);
    lane_wide_columns r = {
        LANE_TAKE(xy, xy2, 0, 8, 16, 24),
        LANE_TAKE(xy, xy2, 4, 12, 20, 28),
        LANE_TAKE(zt, zt2, 0, 8, 16, 24),
        LANE_TAKE(zt, zt2, 4, 12, 20, 28),
    };
    return r;
}

#endif
#endif

/* Whether lane_wide_mark has marked one. */
static inline int lane_wide_is_marked(lane_wide a)
{
    uint32_t v[LANE_WIDE], any = 0;
    memcpy(v, &a, sizeof v);
    for (int i = 0; i < LANE_WIDE; i++)
        any |= v[i];
    return any >> 30 != 0;
}

/* LANE_FOURS vectors from `stride` to `stride` bytes, and the four bytes after each. */
static inline lane_wide_vectors lane_wide_read3(const unsigned char *p, size_t stride)
{
#if LANE_FOURS == 1
    const lane_wide v = lane_wide_load_bytes(p);
    (void)stride;
#elif LANE_FOURS == 2
    const lane_four a = lane_four_load_bytes(p), b = lane_four_load_bytes(p + stride);
    const lane_wide v = LANE_MIX(a, b, 0, 1, 2, 3, 4, 5, 6, 7);
#else
    const lane_four a = lane_four_load_bytes(p), b = lane_four_load_bytes(p + stride);
    const lane_four c = lane_four_load_bytes(p + 2 * stride), d = lane_four_load_bytes(p + 3 * stride);
    const lane_eight ab = LANE_MIX(a, b, 0, 1, 2, 3, 4, 5, 6, 7), cd = LANE_MIX(c, d, 0, 1, 2, 3, 4, 5, 6, 7);
    const lane_wide v = LANE_TAKE(ab, cd, 0, 4, 8, 12);
#endif
    lane_wide_vectors r = {lane_wide_splat(v, 0), lane_wide_splat(v, 1), lane_wide_splat(v, 2)};
    return r;
}

/* LANE_FOURS vectors one behind the other; where it is 1, and the four bytes after it. */
static inline lane_wide_vectors lane_wide_read3_tight(const unsigned char *p)
{
#if LANE_FOURS == 1
    return lane_wide_read3(p, 0);
#elif LANE_FOURS == 2
    const lane_four a = lane_four_load_bytes(p), b = lane_four_load_bytes(p + 8);
    const lane_wide v = LANE_MIX(a, b, 0, 1, 2, 3, 4, 5, 6, 7);
    lane_wide_vectors r = {
        LANE_MIX(v, v, 0, 0, 0, 0, 5, 5, 5, 5),
        LANE_MIX(v, v, 1, 1, 1, 1, 6, 6, 6, 6),
        LANE_MIX(v, v, 2, 2, 2, 2, 7, 7, 7, 7),
    };
    return r;
#else
    const lane_four c = lane_four_load_bytes(p + 32);
    const lane_eight b = LANE_MIX(c, c, 0, 1, 2, 3, 0, 1, 2, 3);
    lane_eight a;
    memcpy(&a, p, sizeof a);
    const lane_wide v = LANE_MIX(a, b, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    lane_wide_vectors r = {
        LANE_MIX(v, v, 0, 0, 0, 0, 3, 3, 3, 3, 6, 6, 6, 6, 9, 9, 9, 9),
        LANE_MIX(v, v, 1, 1, 1, 1, 4, 4, 4, 4, 7, 7, 7, 7, 10, 10, 10, 10),
        LANE_MIX(v, v, 2, 2, 2, 2, 5, 5, 5, 5, 8, 8, 8, 8, 11, 11, 11, 11),
    };
    return r;
#endif
}

/* Three floats of each four, from `stride` to `stride` bytes. */
static inline void lane_wide_write3(unsigned char *p, size_t stride, lane_wide a)
{
#if LANE_FOURS == 1
    (void)stride;
    lane_four_store3(p, a);
#elif LANE_FOURS == 2
    const lane_four v[LANE_FOURS] = {LANE_MIX(a, a, 0, 1, 2, 3), LANE_MIX(a, a, 4, 5, 6, 7)};
#else
    const lane_four v[LANE_FOURS] = {LANE_MIX(a, a, 0, 1, 2, 3), LANE_MIX(a, a, 4, 5, 6, 7),
                                     LANE_MIX(a, a, 8, 9, 10, 11), LANE_MIX(a, a, 12, 13, 14, 15)};
#endif
#if LANE_FOURS > 1
    for (size_t i = 0; i < LANE_FOURS; i++) {
        memcpy(p + i * stride, &v[i], 8);
        memcpy(p + i * stride + 8, (const unsigned char *)&v[i] + 8, 4);
    }
#endif
}

/* The same one behind the other. */
static inline void lane_wide_write3_tight(unsigned char *p, lane_wide a)
{
#if LANE_FOURS == 1
    lane_four_store3(p, a);
#elif LANE_FOURS == 2
    lane_four_store_bytes(p, LANE_MIX(a, a, 0, 1, 2, 3));
    lane_four_store_bytes(p + 8, LANE_MIX(a, a, 2, 4, 5, 6));
#else
    const lane_wide v = LANE_MIX(a, a, 0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, 0, 0, 0, 0);
    const lane_eight low = LANE_MIX(v, v, 0, 1, 2, 3, 4, 5, 6, 7);
    memcpy(p, &low, sizeof low);
    lane_four_store_bytes(p + sizeof low, LANE_MIX(v, v, 8, 9, 10, 11));
#endif
}

static inline lane_wide lane_wide_sqrt(lane_wide a)
{
    float v[LANE_WIDE];
    memcpy(v, &a, sizeof v);
    for (int i = 0; i < LANE_WIDE; i++)
        v[i] = sqrtf(v[i]);
    memcpy(&a, v, sizeof a);
    return a;
}

#endif
