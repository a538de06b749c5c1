/* SPDX-License-Identifier: MIT */
/* The small algebra of scalar.h: inlined into the caller, and compiled into the library as symbols. */
#ifndef NAKAWARI_INLINE_SCALAR_H
#define NAKAWARI_INLINE_SCALAR_H

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "../scalar.h"
#include "product.h"

#ifdef __cplusplus
extern "C" {
#endif

/*
 * a if `first` is not 0, otherwise b. By a mask: GCC compiles several ?: with one condition to a branch, which a
 * processor mispredicts for half of the random t, and which keeps a loop from vectorising.
 */
NKW_PART float nkw_select(int first, float a, float b)
{
    uint32_t x, y, mask = 0u - (uint32_t)(first != 0);
    memcpy(&x, &a, sizeof x);
    memcpy(&y, &b, sizeof y);
    x = y ^ ((x ^ y) & mask);
    memcpy(&a, &x, sizeof a);
    return a;
}

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

#if NKW_ROOT
NKW_BODY float nkw_sqrt(float x)
{
#if defined(NKW_LIBRARY)
    return sqrtf(x);
#else
    typedef float four __attribute__((vector_size(16)));
    four v = {x, 0.0f, 0.0f, 0.0f};
    v = __builtin_ia32_sqrtss(v);
    return v[0];
#endif
}
#endif

NKW_BODY float nkw_clamp(float x, float low, float high)
{
    NKW_EXACT
    return nkw_min(nkw_max(x, low), high);
}

/*
 *     p = a + t (b - a) = b - (1 - t) (b - a)
 *
 * from the end nearer to t, which is a if `first` is not 0: p = end - back (b - a). `back`, -t or 1 - t, is exact. At
 * back = 0, p is the end, with the sign of a zero. `inside`, a constant, states that t is neither 0 nor 1.
 */
NKW_PART float nkw_lerp_from(int first, int inside, float a, float b, float t)
{
    NKW_EXACT
    float end = nkw_select(first, a, b), back = nkw_select(first, 0.0f, 1.0f) - t, step = nkw_mul(back, b - a);
    return end - (inside ? step : nkw_select(back == 0.0f, 0.0f, step));
}

NKW_BODY float nkw_lerp(float a, float b, float t)
{
    return nkw_lerp_from(t < 0.5f, 0, a, b, t);
}

NKW_BODY float nkw_inverse_lerp(float a, float b, float x)
{
    NKW_EXACT
    float d = b - a;
    return a == b ? 0.0f : (x - a) / d;
}

NKW_BODY float nkw_smoothstep(float t)
{
    NKW_EXACT
    float s = nkw_clamp(t, 0.0f, 1.0f);
    float u = 1.0f - s;
    return nkw_select(s < 0.5f, nkw_mul(s * s, 3.0f - (s + s)), 1.0f - nkw_mul(u * u, 3.0f - (u + u)));
}

/* The suffix L: with -fsingle-precision-constant, GCC rounds a constant without a suffix to float. */
NKW_BODY float nkw_degrees_from_radians(float radians)
{
    NKW_EXACT
    return (float)((double)radians * (double)57.295779513082320877L);
}

NKW_BODY float nkw_radians_from_degrees(float degrees)
{
    NKW_EXACT
    return (float)((double)degrees * (double)0.017453292519943295769L);
}

#ifdef __cplusplus
}
#endif

#endif
