/* SPDX-License-Identifier: MIT */
/* The curves of curve.h, once: inlined into the caller, and compiled into the library as symbols. */
#ifndef NAKAWARI_INLINE_CURVE_H
#define NAKAWARI_INLINE_CURVE_H

#include "../curve.h"
#include "../scalar.h"

#ifdef __cplusplus
extern "C" {
#endif

/*
 * All curves but Bezier look from the end nearer to t: x is the way from there, y = 1 - x, a and b the near and the
 * far end. From t = 1/2 on the controls are mirrored; 1 - t is then exact. At x = 0 the end comes back as it is, the
 * sign of a zero too. One nkw_select is enough for GCC to make vectors of a loop over a curve.
 */

/* With the chord f = b - a and the tangents u, v: p = a + x (f + y (y (u - f) - x (v - f))). */
NKW_BODY float nkw_hermite(float p0, float v0, float p1, float v1, float t)
{
    NKW_EXACT
    int first = t < 0.5f;
    float s = 1.0f - t;
    float x = first ? t : s, y = first ? s : t;
    float a = first ? p0 : p1, b = first ? p1 : p0;
    float n0 = NKW_MUL(-1.0f, v0), n1 = NKW_MUL(-1.0f, v1);
    float u = first ? v0 : n1, v = first ? v1 : n0;
    float f = b - a;
    float w = f + NKW_MUL(y, NKW_MUL(y, u - f) - NKW_MUL(x, v - f));
    return nkw_select(x == 0.0f, a, a + NKW_MUL(x, w));
}

/* The distances from p0, by the weights of the other three, in binary64; rounded once. */
NKW_BODY float nkw_bezier(float p0, float p1, float p2, float p3, float t)
{
    NKW_EXACT
    double x = (double)t, s = 1.0 - x, ss = NKW_MUL64(s, s), xx = NKW_MUL64(x, x);
    double w1 = NKW_MUL64(3.0 * ss, x), w2 = NKW_MUL64(3.0 * xx, s), w3 = NKW_MUL64(xx, x);
    double d1 = (double)p1 - (double)p0, d2 = (double)p2 - (double)p0, d3 = (double)p3 - (double)p0;
    double p = (double)p0 + ((NKW_MUL64(w1, d1) + NKW_MUL64(w2, d2)) + NKW_MUL64(w3, d3));
    return nkw_select(t == 0.0f, p0, nkw_select(t == 1.0f, p3, (float)p));
}

/* With f = b - a and the second differences h and m at the ends: p = a + (x f + (y^3 h + x^3 m)/6). */
NKW_BODY float nkw_bspline(float p0, float p1, float p2, float p3, float t)
{
    NKW_EXACT
    int first = t < 0.5f;
    float s = 1.0f - t;
    float x = first ? t : s, y = first ? s : t;
    float a = first ? p1 : p2, b = first ? p2 : p1, c = first ? p0 : p3;
    float d = nkw_select(first, p3, p0);
    float f = b - a;
    float h = f + (c - a), m = (d - b) - f;
    float xx = NKW_MUL(x, x), yy = (1.0f - (x + x)) + xx;
    return a + (NKW_MUL(x, f) + (NKW_MUL(NKW_MUL(yy, y), h) + NKW_MUL(NKW_MUL(xx, x), m)) / 6.0f);
}

/* The same letters: Hermite with the tangents (b - c)/2 and (d - a)/2 is p = a + x (f - y (y h + x m)/2). */
NKW_BODY float nkw_catmull_rom(float p0, float p1, float p2, float p3, float t)
{
    NKW_EXACT
    int first = t < 0.5f;
    float s = 1.0f - t;
    float x = first ? t : s, y = first ? s : t;
    float a = first ? p1 : p2, b = first ? p2 : p1, c = first ? p0 : p3, d = first ? p3 : p0;
    float f = b - a;
    float h = f + (c - a), m = (d - b) - f;
    float w = f - NKW_MUL(NKW_MUL(0.5f, y), NKW_MUL(y, h) + NKW_MUL(x, m));
    return nkw_select(x == 0.0f, a, a + NKW_MUL(x, w));
}

NKW_BODY nkw_vec3 nkw_vec3_hermite(nkw_vec3 p0, nkw_vec3 v0, nkw_vec3 p1, nkw_vec3 v1, float t)
{
    nkw_vec3 r = {
        nkw_hermite(p0.x, v0.x, p1.x, v1.x, t),
        nkw_hermite(p0.y, v0.y, p1.y, v1.y, t),
        nkw_hermite(p0.z, v0.z, p1.z, v1.z, t),
    };
    return r;
}

NKW_BODY nkw_vec3 nkw_vec3_bezier(nkw_vec3 p0, nkw_vec3 p1, nkw_vec3 p2, nkw_vec3 p3, float t)
{
    nkw_vec3 r = {
        nkw_bezier(p0.x, p1.x, p2.x, p3.x, t),
        nkw_bezier(p0.y, p1.y, p2.y, p3.y, t),
        nkw_bezier(p0.z, p1.z, p2.z, p3.z, t),
    };
    return r;
}

NKW_BODY nkw_vec3 nkw_vec3_bspline(nkw_vec3 p0, nkw_vec3 p1, nkw_vec3 p2, nkw_vec3 p3, float t)
{
    nkw_vec3 r = {
        nkw_bspline(p0.x, p1.x, p2.x, p3.x, t),
        nkw_bspline(p0.y, p1.y, p2.y, p3.y, t),
        nkw_bspline(p0.z, p1.z, p2.z, p3.z, t),
    };
    return r;
}

NKW_BODY nkw_vec3 nkw_vec3_catmull_rom(nkw_vec3 p0, nkw_vec3 p1, nkw_vec3 p2, nkw_vec3 p3, float t)
{
    nkw_vec3 r = {
        nkw_catmull_rom(p0.x, p1.x, p2.x, p3.x, t),
        nkw_catmull_rom(p0.y, p1.y, p2.y, p3.y, t),
        nkw_catmull_rom(p0.z, p1.z, p2.z, p3.z, t),
    };
    return r;
}

#ifdef __cplusplus
}
#endif

#endif
