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
    /* The nearer end, and how far from it: selected by masks, for a branch on t would be a guess. */
    int first = t < 0.5f;
    float end = nkw_select(first, a, b), x = nkw_select(first, t, t - 1.0f);
    float inside = end + NKW_MUL(x, b - a);
    return nkw_select(x == 0.0f, end, inside);
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
