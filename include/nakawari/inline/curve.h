/* SPDX-License-Identifier: MIT */
/*
 * The curves of curve.h: inlined into the caller, and compiled into the library as symbols. Each curve is a function on
 * single floats, applied to the three components of a vector.
 *
 * All except Bezier, a weighted sum, start from the end nearer to t, as nkw_lerp does: the first end if `first` is not
 * 0. `back`, -t or 1 - t, is exact. At back = 0 they return that end, with the sign of a zero.
 */
#ifndef NAKAWARI_INLINE_CURVE_H
#define NAKAWARI_INLINE_CURVE_H

#include "../curve.h"
#include "../scalar.h"
#include "../vec.h"
#include "f32x3.h"
#include "product.h"

#ifdef __cplusplus
extern "C" {
#endif

/*
 *     p = p0 + t (f + s k) = p1 - s (f - t k),        f = p1 - p0,  s = 1 - t,  k = s (v0 - f) - t (v1 - f)
 *
 * from the end nearer to t, which is p0 if `first` is not 0. `inside`, a constant, states that t is neither 0 nor 1.
 *
 * The textbook's sum, with v = f + (v - f) and p1 = p0 + f, begins with the chord, p0 + t f:
 *
 *     (1 + 2 t) s^2 p0 + t s^2 v0 + (1 + 2 s) t^2 p1 - s t^2 v1
 *         = p0 + (t^2 (3 - 2 t) + t s^2 - s t^2) f + t s^2 (v0 - f) - s t^2 (v1 - f)
 *         = p0 + t f + t s k,      since t^2 (3 - 2 t) + t s (s - t) = t
 */
NKW_PART float nkw_hermite_from(int first, int inside, float p0, float v0, float p1, float v1, float t)
{
    NKW_EXACT
    float s = 1.0f - t, f = p1 - p0, k = nkw_mul(s, v0 - f) - nkw_mul(t, v1 - f);
    float end = nkw_select(first, p0, p1), back = nkw_select(first, 0.0f, 1.0f) - t;
    float onward = nkw_select(first, 1.0f, 0.0f) - t; /* from t to the other end */
    float step = nkw_mul(back, f + nkw_mul(onward, k));
    return end - (inside ? step : nkw_select(back == 0.0f, 0.0f, step));
}

NKW_BODY float nkw_hermite(float p0, float v0, float p1, float v1, float t)
{
    return nkw_hermite_from(t < 0.5f, 0, p0, v0, p1, v1, t);
}

/* Bernstein: s^3, 3 s^2 t, 3 s t^2, t^3,  s = 1 - t: factors. At t = 0 and t = 1 one is 1, the others are 0. */
NKW_PART nkw_weights nkw_bezier_weights(float t)
{
    NKW_EXACT
    float s = 1.0f - t, ss = s * s, tt = t * t;
    nkw_weights r = {{ss * s, (3.0f * t) * ss, (3.0f * s) * tt, tt * t}};
    return r;
}

NKW_BODY float nkw_bezier(float p0, float p1, float p2, float p3, float t)
{
    NKW_EXACT
    nkw_weights k = nkw_bezier_weights(t);
    return (nkw_mul(k.w[0], p0) + nkw_mul(k.w[1], p1)) + (nkw_mul(k.w[2], p2) + nkw_mul(k.w[3], p3));
}

/*
 *     p = p1 + (bend + t f) = p2 + (bend - s f),        f = p2 - p1,  bend = (s^3 h + t^3 m)/6
 *
 * with the second differences h = p0 - 2 p1 + p2 and m = p1 - 2 p2 + p3: inserting p0 = h + 2 p1 - p2 and
 * p3 = m + 2 p2 - p1 into the textbook's sum leaves s p1 + t p2 + bend. The squares of s and t are x^2 and 1 - 2 x +
 * x^2, x the smaller of s and t.
 */
NKW_BODY float nkw_bspline(float p0, float p1, float p2, float p3, float t)
{
    NKW_EXACT
    int first = t < 0.5f; /* p1 is nearer to t than p2 */
    float s = 1.0f - t, f = p2 - p1, h = f + (p0 - p1), m = (p3 - p2) - f;
    float x = nkw_select(first, t, s), xx = nkw_mul(x, x), yy = (1.0f - (x + x)) + xx;
    float ss = nkw_select(first, yy, xx), tt = nkw_select(first, xx, yy);
    float bend = (nkw_mul(ss * s, h) + nkw_mul(tt * t, m)) / 6.0f;
    float end = nkw_select(first, p1, p2), back = nkw_select(first, 0.0f, 1.0f) - t;
    return end + (bend - nkw_mul(back, f));
}

/*
 * Hermite with the tangents v0 = (p2 - p0)/2 and v1 = (p3 - p1)/2. With f, h, m and s of nkw_bspline, v0 - f = -h/2 and
 * v1 - f = m/2:
 *
 *     p = p1 + t (f - s k/2) = p2 - s (f + t k/2),        k = s h + t m
 */
NKW_BODY float nkw_catmull_rom(float p0, float p1, float p2, float p3, float t)
{
    NKW_EXACT
    int first = t < 0.5f; /* p1 is nearer to t than p2 */
    float s = 1.0f - t, f = p2 - p1, h = f + (p0 - p1), m = (p3 - p2) - f;
    float k = nkw_mul(s, h) + nkw_mul(t, m);
    float end = nkw_select(first, p1, p2), back = nkw_select(first, 0.0f, 1.0f) - t;
    float onward = nkw_select(first, 1.0f, 0.0f) - t;
    return end - nkw_select(back == 0.0f, 0.0f, nkw_mul(back, f - nkw_mul(0.5f * onward, k)));
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

#if NKW_F32X3
/* Second text of nkw_hermite and nkw_catmull_rom; 1.7 times faster. */
NKW_BODY nkw_vec3 nkw_vec3_hermite(nkw_vec3 p0, nkw_vec3 v0, nkw_vec3 p1, nkw_vec3 v1, float t)
{
    NKW_EXACT
    const nkw_f32x4_nearer at = nkw_f32x4_nearer_to(t);
    const nkw_f32x4 a = nkw_f32x4_from_vec3(p0), b = nkw_f32x4_from_vec3(p1), f = b - a;
    nkw_f32x4 k = (1.0f - t) * (nkw_f32x4_from_vec3(v0) - f) - t * (nkw_f32x4_from_vec3(v1) - f);
    return nkw_f32x4_from_end(at, a, b, at.back * (f + at.onward * k));
}

NKW_BODY nkw_vec3 nkw_vec3_bspline(nkw_vec3 p0, nkw_vec3 p1, nkw_vec3 p2, nkw_vec3 p3, float t)
{
    NKW_EXACT
    const nkw_f32x4_nearer at = nkw_f32x4_nearer_to(t);
    const nkw_f32x4 a = nkw_f32x4_from_vec3(p1), b = nkw_f32x4_from_vec3(p2), f = b - a;
    nkw_f32x4 h = f + (nkw_f32x4_from_vec3(p0) - a), m = (nkw_f32x4_from_vec3(p3) - b) - f;
    const nkw_f32x4 t4 = nkw_f32x4_splat(t), s = 1.0f - t4, x = nkw_f32x4_select(at.first, t4, s), xx = x * x;
    const nkw_f32x4 yy = (1.0f - (x + x)) + xx, ss = nkw_f32x4_select(at.first, yy, xx);
    const nkw_f32x4 tt = nkw_f32x4_select(at.first, xx, yy), bend = ((ss * s) * h + (tt * t4) * m) / 6.0f;
    nkw_f32x4 p = nkw_f32x4_select(at.first, a, b) + (bend - at.back * f);
    nkw_vec3 r = {p[0], p[1], p[2]};
    return r;
}

NKW_BODY nkw_vec3 nkw_vec3_catmull_rom(nkw_vec3 p0, nkw_vec3 p1, nkw_vec3 p2, nkw_vec3 p3, float t)
{
    NKW_EXACT
    const nkw_f32x4_nearer at = nkw_f32x4_nearer_to(t);
    const nkw_f32x4 a = nkw_f32x4_from_vec3(p1), b = nkw_f32x4_from_vec3(p2), f = b - a;
    nkw_f32x4 h = f + (nkw_f32x4_from_vec3(p0) - a), m = (nkw_f32x4_from_vec3(p3) - b) - f, k = (1.0f - t) * h + t * m;
    return nkw_f32x4_from_end(at, a, b, at.back * (f - (0.5f * at.onward) * k));
}
#else
NKW_BODY nkw_vec3 nkw_vec3_hermite(nkw_vec3 p0, nkw_vec3 v0, nkw_vec3 p1, nkw_vec3 v1, float t)
{
    nkw_vec3 r = {
        nkw_hermite(p0.x, v0.x, p1.x, v1.x, t),
        nkw_hermite(p0.y, v0.y, p1.y, v1.y, t),
        nkw_hermite(p0.z, v0.z, p1.z, v1.z, t),
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
#endif

#ifdef __cplusplus
}
#endif

#endif
