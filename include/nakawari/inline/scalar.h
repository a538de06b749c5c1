/* SPDX-License-Identifier: MIT */
/* The small algebra of scalar.h, once: inlined into the caller, and compiled into the library as symbols. */
#ifndef NAKAWARI_INLINE_SCALAR_H
#define NAKAWARI_INLINE_SCALAR_H

#include <stdint.h>
#include <string.h>

#include "../scalar.h"

/* Within 2^-96..2^96: a vector of this squared length needs no scaling before it is normalised. */
#define NKW_IS_NEAR(n2) ((n2) >= 1.26217745e-29 && (n2) <= 7.92281625e28)

/* The square of a float, exact. */
#define NKW_SQUARE64(x) NKW_MUL64((double)(x), (double)(x))

/*
 * Lerp, and what the curves begin with as well: the steps stand here once for a float and for the three of a vector side
 * by side (NKW_XYZ in vec.h). `number` is the type of values, `flags` that of their comparisons, pick(c, a, b) gives a
 * where c holds, else b. The other arguments are names, t is the caller's.
 *
 * `end` is the end nearer to t, of a and b, and `back` the way back there, -t or 1 - t, which is exact. They are picked
 * by masks, for a branch on t would be a guess. NKW_FROM_END is end - way, and at back = 0 the end as it is, the sign of
 * a zero too.
 *
 *     p = a + t (b - a) = b + (t-1) (b - a)
 */
#define NKW_NEARER(number, flags, pick, a, b)                                                                          \
    const number none = {0.0f}, half = none + 0.5f, one = half + half, at = t - none;                                  \
    const flags first = at < half;                                                                                     \
    const number end = pick(first, a, b), back = pick(first, none, one) - at
#define NKW_FROM_END(pick, way) (end - pick(back == none, none, way))

#define NKW_LERP(number, flags, pick, a, b)                                                                            \
    NKW_NEARER(number, flags, pick, a, b);                                                                             \
    const number way = NKW_MUL(back, b - a), p = NKW_FROM_END(pick, way)

#ifdef __cplusplus
extern "C" {
#endif

NKW_BODY float nkw_abs(float x)
{
    NKW_EXACT
    return x <= 0.0f ? 0.0f - x : x;
}

NKW_BODY float nkw_min(float a, float b)
{
    NKW_EXACT
    return a < b ? a : b;
}

NKW_BODY float nkw_max(float a, float b)
{
    NKW_EXACT
    return a > b ? a : b;
}

NKW_BODY float nkw_select(int first, float a, float b)
{
    uint32_t x, y, mask = 0u - (uint32_t)(first != 0);
    float r;
    memcpy(&x, &a, sizeof x);
    memcpy(&y, &b, sizeof y);
    x = y ^ ((x ^ y) & mask);
    memcpy(&r, &x, sizeof r);
    return r;
}

#if NKW_ROOT_INLINE
NKW_BODY float nkw_sqrt(float x)
{
    typedef float four __attribute__((vector_size(16)));
    four v = {x, 0.0f, 0.0f, 0.0f};
    v = __builtin_ia32_sqrtss(v);
    return v[0];
}
#elif defined(NKW_DEFINE_ALGEBRA)
float nkw_sqrt(float x)
{
    return sqrtf(x);
}
#endif

NKW_BODY float nkw_clamp(float x, float low, float high)
{
    NKW_EXACT
    return nkw_min(nkw_max(x, low), high);
}

NKW_BODY float nkw_saturate(float x)
{
    NKW_EXACT
    return nkw_clamp(x, 0.0f, 1.0f);
}

NKW_BODY float nkw_lerp(float a, float b, float t)
{
    NKW_EXACT
    NKW_LERP(float, int, nkw_select, a, b);
    return p;
}

NKW_BODY float nkw_inverse_lerp(float a, float b, float x)
{
    NKW_EXACT
    float d = b - a;
    return a == b ? 0.0f : (x - a) / d;
}

NKW_BODY float nkw_remap(float x, float a, float b, float c, float d)
{
    NKW_EXACT
    return nkw_lerp(c, d, nkw_inverse_lerp(a, b, x));
}

NKW_BODY float nkw_smoothstep(float t)
{
    NKW_EXACT
    float s = nkw_saturate(t);
    float u = 1.0f - s;
    float ss = NKW_MUL(s, s), uu = NKW_MUL(u, u);
    return s < 0.5f ? NKW_MUL(ss, 3.0f - (s + s)) : 1.0f - NKW_MUL(uu, 3.0f - (u + u));
}

NKW_BODY float nkw_degrees_from_radians(float radians)
{
    NKW_EXACT
    return (float)((double)radians * 57.295779513082320877);
}

NKW_BODY float nkw_radians_from_degrees(float degrees)
{
    NKW_EXACT
    return (float)((double)degrees * 0.017453292519943295769);
}

#ifdef __cplusplus
}
#endif

#endif
