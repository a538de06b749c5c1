/* SPDX-License-Identifier: MIT */
/* The curves of curve.h, once: inlined into the caller, and compiled into the library as symbols. */
#ifndef NAKAWARI_INLINE_CURVE_H
#define NAKAWARI_INLINE_CURVE_H

#include "../curve.h"
#include "../scalar.h"
#include "../vec.h"

/*
 * All curves but Bezier start from the end nearer to t, as NKW_LERP does, and are written like it for a float and for
 * the three of a vector; each leaves its point in p. s = 1 - t, f is the chord from a to b, and `on` the way to the
 * farther end, s or -t.
 */
#define NKW_CURVE(number, flags, pick, a, b)                                                                           \
    NKW_NEARER(number, flags, pick, a, b);                                                                             \
    const number s = one - at, f = b - a

/*
 *     p = p0 + t (f + s k) = p1 - s (f - t k),        f = p1 - p0,  k = s (v0 - f) - t (v1 - f)
 */
#define NKW_HERMITE(number, flags, pick, p0, v0, p1, v1)                                                               \
    NKW_CURVE(number, flags, pick, p0, p1);                                                                            \
    const number on = pick(first, one, none) - at, k = NKW_MUL(s, v0 - f) - NKW_MUL(at, v1 - f);                       \
    const number way = NKW_MUL(back, f + NKW_MUL(on, k)), p = NKW_FROM_END(pick, way)

/*
 *     p = p1 + (t f + bend) = p2 + (bend - s f),        f = p2 - p1,  bend = (s^3 h + t^3 m)/6
 *
 * with the second differences h and m at p1 and p2. The squares are x^2 and 1 - 2 x + x^2, x the smaller of s and t.
 */
#define NKW_BSPLINE(number, flags, pick, p0, p1, p2, p3)                                                               \
    NKW_CURVE(number, flags, pick, p1, p2);                                                                            \
    const number h = f + (p0 - p1), m = (p3 - p2) - f;                                                                 \
    const number x = pick(first, at, s), xx = NKW_MUL(x, x), yy = (one - (x + x)) + xx;                                \
    const number ss = pick(first, yy, xx), tt = pick(first, xx, yy);                                                   \
    const number bend = (NKW_MUL(NKW_MUL(ss, s), h) + NKW_MUL(NKW_MUL(tt, at), m)) / 6.0f;                             \
    const number p = end + (bend - NKW_MUL(back, f))

/* The same letters: Hermite with the tangents (p2 - p0)/2 and (p3 - p1)/2, so k = -(s h + t m)/2. */
#define NKW_CATMULL_ROM(number, flags, pick, p0, p1, p2, p3)                                                           \
    NKW_CURVE(number, flags, pick, p1, p2);                                                                            \
    const number h = f + (p0 - p1), m = (p3 - p2) - f;                                                                 \
    const number on = pick(first, one, none) - at, k = NKW_MUL(s, h) + NKW_MUL(at, m);                                 \
    const number way = NKW_MUL(back, f - NKW_MUL(NKW_MUL(0.5f, on), k)), p = NKW_FROM_END(pick, way)

#if defined(NKW_XYZ)
#define NKW_VEC3_CURVE(TEXT, curve, a, b, c, d)                                                                        \
    nkw_xyz a3, b3, c3, d3;                                                                                            \
    NKW_XYZ_LOAD(a3, a);                                                                                               \
    NKW_XYZ_LOAD(b3, b);                                                                                               \
    NKW_XYZ_LOAD(c3, c);                                                                                               \
    NKW_XYZ_LOAD(d3, d);                                                                                               \
    TEXT(nkw_xyz, nkw_xyz_flags, NKW_XYZ_PICK, a3, b3, c3, d3);                                                        \
    nkw_vec3 r;                                                                                                        \
    NKW_XYZ_STORE(r, p);                                                                                               \
    return r
#else
#define NKW_VEC3_CURVE(TEXT, curve, a, b, c, d)                                                                        \
    nkw_vec3 r = {curve((a).x, (b).x, (c).x, (d).x, t), curve((a).y, (b).y, (c).y, (d).y, t),                          \
                  curve((a).z, (b).z, (c).z, (d).z, t)};                                                               \
    return r
#endif

#ifdef __cplusplus
extern "C" {
#endif

NKW_BODY float nkw_hermite(float p0, float v0, float p1, float v1, float t)
{
    NKW_EXACT
    NKW_HERMITE(float, int, nkw_select, p0, v0, p1, v1);
    return p;
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

NKW_BODY float nkw_bspline(float p0, float p1, float p2, float p3, float t)
{
    NKW_EXACT
    NKW_BSPLINE(float, int, nkw_select, p0, p1, p2, p3);
    return p;
}

NKW_BODY float nkw_catmull_rom(float p0, float p1, float p2, float p3, float t)
{
    NKW_EXACT
    NKW_CATMULL_ROM(float, int, nkw_select, p0, p1, p2, p3);
    return p;
}

NKW_BODY nkw_vec3 nkw_vec3_hermite(nkw_vec3 p0, nkw_vec3 v0, nkw_vec3 p1, nkw_vec3 v1, float t)
{
    NKW_EXACT
    NKW_VEC3_CURVE(NKW_HERMITE, nkw_hermite, p0, v0, p1, v1);
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
    NKW_EXACT
    NKW_VEC3_CURVE(NKW_BSPLINE, nkw_bspline, p0, p1, p2, p3);
}

NKW_BODY nkw_vec3 nkw_vec3_catmull_rom(nkw_vec3 p0, nkw_vec3 p1, nkw_vec3 p2, nkw_vec3 p3, float t)
{
    NKW_EXACT
    NKW_VEC3_CURVE(NKW_CATMULL_ROM, nkw_catmull_rom, p0, p1, p2, p3);
}

#ifdef __cplusplus
}
#endif

#endif
