/* SPDX-License-Identifier: MIT */
/* Compiled once for each instruction set, PROBE_ISA its name. The last elements go through vectors as well, padded. */
#include <string.h>

#include <sleef.h>

#include "peer_sleef.h"

#define JOIN(name, isa)     name##_##isa
#define JOIN_ISA(name, isa) JOIN(name, isa)

#if PROBE_BYTES == 64
typedef __m512 wide;
#define LOAD(p)     _mm512_loadu_ps(p)
#define STORE(p, v) _mm512_storeu_ps(p, v)
#define CALL(name)  Sleef_##name##f16_u10
typedef Sleef___m512_2 pair;
#elif PROBE_BYTES == 32
typedef __m256 wide;
#define LOAD(p)     _mm256_loadu_ps(p)
#define STORE(p, v) _mm256_storeu_ps(p, v)
#define CALL(name)  Sleef_##name##f8_u10
typedef Sleef___m256_2 pair;
#else
typedef __m128 wide;
#define LOAD(p)     _mm_loadu_ps(p)
#define STORE(p, v) _mm_storeu_ps(p, v)
#define CALL(name)  Sleef_##name##f4_u10
typedef Sleef___m128_2 pair;
#endif

enum { LANES = sizeof(wide) / sizeof(float) };

static void one(wide (*f)(wide), const float *x, float *out, size_t n)
{
    size_t i = 0;
    float rest[LANES] = {0};
    for (; i + LANES <= n; i += LANES)
        STORE(out + i, f(LOAD(x + i)));
    if (i == n)
        return;
    memcpy(rest, x + i, (n - i) * sizeof *x);
    STORE(rest, f(LOAD(rest)));
    memcpy(out + i, rest, (n - i) * sizeof *out);
}

static void two(wide (*f)(wide, wide), const float *x, const float *y, float *out, size_t n)
{
    size_t i = 0;
    float rest[LANES] = {0}, other[LANES] = {0};
    for (; i + LANES <= n; i += LANES)
        STORE(out + i, f(LOAD(x + i), LOAD(y + i)));
    if (i == n)
        return;
    memcpy(rest, x + i, (n - i) * sizeof *x);
    memcpy(other, y + i, (n - i) * sizeof *y);
    STORE(rest, f(LOAD(rest), LOAD(other)));
    memcpy(out + i, rest, (n - i) * sizeof *out);
}

static void sincos_(const float *x, float *sine, float *cosine, size_t n)
{
    size_t i = 0;
    float rest[LANES] = {0}, s[LANES], c[LANES];
    for (; i + LANES <= n; i += LANES) {
        pair p = CALL(sincos)(LOAD(x + i));
        STORE(sine + i, p.x);
        STORE(cosine + i, p.y);
    }
    memcpy(rest, x + i, (n - i) * sizeof *x);
    pair p = CALL(sincos)(LOAD(rest));
    STORE(s, p.x);
    STORE(c, p.y);
    memcpy(sine + i, s, (n - i) * sizeof *s);
    memcpy(cosine + i, c, (n - i) * sizeof *c);
}

/* SLEEF declares its results const, which makes its functions another type. */
#define ONE(name)                                                                                                      \
    static wide name##_wide(wide x)                                                                                    \
    {                                                                                                                  \
        return CALL(name)(x);                                                                                          \
    }                                                                                                                  \
    static void name##_(const float *x, float *out, size_t n)                                                          \
    {                                                                                                                  \
        one(name##_wide, x, out, n);                                                                                   \
    }
#define TWO(name)                                                                                                      \
    static wide name##_wide(wide x, wide y)                                                                            \
    {                                                                                                                  \
        return CALL(name)(x, y);                                                                                       \
    }                                                                                                                  \
    static void name##_(const float *x, const float *y, float *out, size_t n)                                          \
    {                                                                                                                  \
        two(name##_wide, x, y, out, n);                                                                                \
    }
ONE(sin)
ONE(tan)
ONE(asin)
ONE(acos)
ONE(atan)
ONE(exp)
ONE(log)
TWO(atan2)
TWO(pow)

const peer_sleef JOIN_ISA(peer_sleef, PROBE_ISA) = {sin_, tan_, asin_, acos_, atan_, exp_, log_, atan2_, pow_, sincos_};
