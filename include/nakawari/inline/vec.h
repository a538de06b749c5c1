/* SPDX-License-Identifier: MIT */
/* The small algebra of vec.h, once: inlined into the caller, and compiled into the library as symbols. */
#ifndef NAKAWARI_INLINE_VEC_H
#define NAKAWARI_INLINE_VEC_H

#include "../scalar.h"
#include "../vec.h"

/*
 * The three of a vector side by side in a register, and 0: for what does the same with each, where the compiler makes
 * no vectors of a loop over arrays of nkw_vec3. GCC does from SSSE3 on. The library's loops go over many vectors.
 */
#if defined(__GNUC__) && defined(__SSE2__) && (defined(__clang__) || !defined(__SSSE3__)) && !defined(NKW_ISA) &&      \
    !defined(NKW_FUSES)
#define NKW_XYZ
typedef float nkw_xyz __attribute__((vector_size(16)));
typedef int nkw_xyz_flags __attribute__((vector_size(16)));
typedef double nkw_xyz_halves __attribute__((vector_size(16)));
#define NKW_XYZ_LOAD(r, v)                                                                                             \
    do {                                                                                                               \
        const nkw_xyz third = {(v).z};                                                                                 \
        double xy;                                                                                                     \
        memcpy(&xy, &(v), sizeof xy);                                                                                  \
        const nkw_xyz_halves both = {xy, ((nkw_xyz_halves)third)[0]};                                                  \
        r = (nkw_xyz)both;                                                                                             \
    } while (0)
#define NKW_XYZ_STORE(v, a)                                                                                            \
    do {                                                                                                               \
        const double xy = ((nkw_xyz_halves)(a))[0];                                                                    \
        memcpy(&(v), &xy, sizeof xy);                                                                                  \
        (v).z = (a)[2];                                                                                                \
    } while (0)
#define NKW_XYZ_PICK(c, a, b) ((nkw_xyz)(((nkw_xyz_flags)(a) & (c)) | ((nkw_xyz_flags)(b) & ~(c))))
#endif

#ifdef __cplusplus
extern "C" {
#endif

NKW_BODY nkw_vec3 nkw_vec3_zero(void)
{
    nkw_vec3 r = {0.0f, 0.0f, 0.0f};
    return r;
}

NKW_BODY nkw_vec3 nkw_vec3_add(nkw_vec3 a, nkw_vec3 b)
{
    nkw_vec3 r = {a.x + b.x, a.y + b.y, a.z + b.z};
    return r;
}

NKW_BODY nkw_vec3 nkw_vec3_sub(nkw_vec3 a, nkw_vec3 b)
{
    nkw_vec3 r = {a.x - b.x, a.y - b.y, a.z - b.z};
    return r;
}

NKW_BODY nkw_vec3 nkw_vec3_negate(nkw_vec3 a)
{
    NKW_EXACT
    nkw_vec3 r = {NKW_MUL(-1.0f, a.x), NKW_MUL(-1.0f, a.y), NKW_MUL(-1.0f, a.z)};
    return r;
}

NKW_BODY nkw_vec3 nkw_vec3_scale(nkw_vec3 a, float s)
{
    NKW_EXACT
    nkw_vec3 r = {NKW_MUL(a.x, s), NKW_MUL(a.y, s), NKW_MUL(a.z, s)};
    return r;
}

NKW_BODY nkw_vec3 nkw_vec3_divide(nkw_vec3 a, float s)
{
    nkw_vec3 r = {a.x / s, a.y / s, a.z / s};
    return r;
}

NKW_BODY nkw_vec3 nkw_vec3_mul(nkw_vec3 a, nkw_vec3 b)
{
    NKW_EXACT
    nkw_vec3 r = {NKW_MUL(a.x, b.x), NKW_MUL(a.y, b.y), NKW_MUL(a.z, b.z)};
    return r;
}

NKW_BODY nkw_vec3 nkw_vec3_add_scaled(nkw_vec3 a, nkw_vec3 b, float s)
{
    NKW_EXACT
    nkw_vec3 r = {a.x + NKW_MUL(b.x, s), a.y + NKW_MUL(b.y, s), a.z + NKW_MUL(b.z, s)};
    return r;
}

NKW_BODY nkw_vec3 nkw_vec3_min(nkw_vec3 a, nkw_vec3 b)
{
    nkw_vec3 r = {nkw_min(a.x, b.x), nkw_min(a.y, b.y), nkw_min(a.z, b.z)};
    return r;
}

NKW_BODY nkw_vec3 nkw_vec3_max(nkw_vec3 a, nkw_vec3 b)
{
    nkw_vec3 r = {nkw_max(a.x, b.x), nkw_max(a.y, b.y), nkw_max(a.z, b.z)};
    return r;
}

NKW_BODY float nkw_vec3_dot(nkw_vec3 a, nkw_vec3 b)
{
    NKW_EXACT
    return (NKW_MUL(a.x, b.x) + NKW_MUL(a.y, b.y)) + NKW_MUL(a.z, b.z);
}

NKW_BODY nkw_vec3 nkw_vec3_cross(nkw_vec3 a, nkw_vec3 b)
{
    NKW_EXACT
    nkw_vec3 r = {
        NKW_MUL(a.y, b.z) - NKW_MUL(a.z, b.y),
        NKW_MUL(a.z, b.x) - NKW_MUL(a.x, b.z),
        NKW_MUL(a.x, b.y) - NKW_MUL(a.y, b.x),
    };
    return r;
}

NKW_BODY float nkw_vec3_length_squared(nkw_vec3 a)
{
    return nkw_vec3_dot(a, a);
}

#if NKW_ROOT_INLINE || defined(NKW_DEFINE_ALGEBRA)
NKW_BODY nkw_vec3 nkw_vec3_normalize(nkw_vec3 a)
{
    NKW_EXACT
    double n2 = (NKW_SQUARE64(a.x) + NKW_SQUARE64(a.y)) + NKW_SQUARE64(a.z);
    if (!NKW_IS_NEAR(n2)) {
        nkw_vec3 r = a; /* so that a itself stays in registers */
        nkw_vec3_view from = {&r.x, &r.y, &r.z};
        nkw_vec3_span to = {&r.x, &r.y, &r.z};
        nkw_vec3_normalize_n(from, to, 1);
        return r;
    }
    return nkw_vec3_divide(a, nkw_sqrt((float)n2));
}
#endif

NKW_BODY nkw_vec3 nkw_vec3_lerp(nkw_vec3 a, nkw_vec3 b, float t)
{
#if defined(NKW_XYZ)
    NKW_EXACT
    nkw_xyz from, to;
    NKW_XYZ_LOAD(from, a);
    NKW_XYZ_LOAD(to, b);
    NKW_LERP(nkw_xyz, nkw_xyz_flags, NKW_XYZ_PICK, from, to);
    nkw_vec3 r;
    NKW_XYZ_STORE(r, p);
#else
    nkw_vec3 r = {nkw_lerp(a.x, b.x, t), nkw_lerp(a.y, b.y, t), nkw_lerp(a.z, b.z, t)};
#endif
    return r;
}

NKW_BODY nkw_vec3 nkw_vec3_reflect(nkw_vec3 a, nkw_vec3 n)
{
    NKW_EXACT
    return nkw_vec3_add_scaled(a, n, NKW_MUL(-2.0f, nkw_vec3_dot(a, n)));
}

NKW_BODY int nkw_vec3_is_finite(nkw_vec3 a)
{
    /* x - x is 0 for a finite x, else NaN. */
    return a.x - a.x == 0.0f && a.y - a.y == 0.0f && a.z - a.z == 0.0f;
}

#ifdef __cplusplus
}
#endif

#endif
