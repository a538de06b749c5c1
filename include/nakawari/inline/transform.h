/* SPDX-License-Identifier: MIT */
/* The small algebra of transform.h, once: inlined into the caller, and compiled into the library as symbols. */
#ifndef NAKAWARI_INLINE_TRANSFORM_H
#define NAKAWARI_INLINE_TRANSFORM_H

#include "../mat.h"
#include "../quat.h"
#include "../transform.h"
#include "../vec.h"

#ifdef __cplusplus
extern "C" {
#endif

NKW_BODY nkw_trs nkw_trs_identity(void)
{
    nkw_trs r = {{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f, 1.0f}, {1.0f, 1.0f, 1.0f}};
    return r;
}

NKW_BODY nkw_mat3 nkw_mat3_from_quat_scale(nkw_quat q, nkw_vec3 s)
{
    NKW_EXACT
    nkw_mat3 r = nkw_mat3_from_quat(q);
    /*
     * The rounding k of |q| shows in the matrix twice over, and is taken out. What 1 - |q|^2 has beyond, off, is meant:
     * 1 - 2 (yy + zz) = (ww - yy) + (xx - zz) + off.
     */
    float m = NKW_QUAT_DEFECT(q), off = NKW_QUAT_OFF(m), k = m - off;
    for (size_t i = 0; i < 3; i++) {
        float x = r.m[i] + NKW_MUL(r.m[i], k), y = r.m[3 + i] + NKW_MUL(r.m[3 + i], k);
        float z = r.m[6 + i] + NKW_MUL(r.m[6 + i], k);
        r.m[i] = NKW_MUL(i == 0 ? x + off : x, s.x);
        r.m[3 + i] = NKW_MUL(i == 1 ? y + off : y, s.y);
        r.m[6 + i] = NKW_MUL(i == 2 ? z + off : z, s.z);
    }
    return r;
}

/*
 * nkw_mat3_from_quat_scale, with its nine numbers in three columns: d those of the diagonal, s those below it and t
 * those above it, in turn from the first, that is d0 d1 d2, s10 s21 s02 and t01 t12 t20.
 */
NKW_BODY nkw_mat4 nkw_mat4_from_trs(const nkw_trs *trs)
{
    NKW_EXACT
    const float *a = (const float *)trs;
    const nkw_column quarter = {0.25f, 0.25f, 0.25f, 0.25f};
    const nkw_column rounds = {NKW_QUAT_ROUNDS, NKW_QUAT_ROUNDS, NKW_QUAT_ROUNDS, NKW_QUAT_ROUNDS};
    nkw_column q, twice, w, yzx, zxy, qq, qq_yzx, qq_zxy, m, off, d, s, t, scale, origin, x, y, z;
    NKW_COLUMN_LOAD(q, a + 3);
    NKW_COLUMN(twice, NKW_TERM(q) + NKW_TERM(q));
    NKW_COLUMN_MIX(w, q, q, 3, 3, 3, 3);
    NKW_COLUMN_MIX(yzx, twice, twice, 1, 2, 0, 3);
    NKW_COLUMN_MIX(zxy, twice, twice, 2, 0, 1, 3);
    NKW_COLUMN(qq, NKW_PRODUCT(q, q));
    NKW_COLUMN_MIX(qq_yzx, qq, qq, 1, 2, 0, 3);
    NKW_COLUMN_MIX(qq_zxy, qq, qq, 2, 0, 1, 3);
    NKW_COLUMN(d, (NKW_PRODUCT(w, w) - NKW_TERM(qq_yzx)) + (NKW_TERM(qq) - NKW_TERM(qq_zxy)));
    NKW_COLUMN(s, NKW_PRODUCT(q, yzx) + NKW_PRODUCT(w, zxy));
    NKW_COLUMN(t, NKW_PRODUCT(q, yzx) - NKW_PRODUCT(w, zxy));
    /* NKW_QUAT_DEFECT */
    NKW_COLUMN(m, NKW_TERM(quarter) - NKW_TERM(qq));
    NKW_COLUMN_MIX(x, m, m, 1, 0, 3, 2);
    NKW_COLUMN(m, NKW_TERM(m) + NKW_TERM(x));
    NKW_COLUMN_MIX(x, m, m, 2, 3, 0, 1);
    NKW_COLUMN(m, NKW_TERM(m) + NKW_TERM(x));
    NKW_COLUMN(off, (NKW_TERM(m) + NKW_TERM(rounds)) - NKW_TERM(rounds));
    if (off[0] != 0.0f) {
        NKW_COLUMN(m, NKW_TERM(m) - NKW_TERM(off));
        NKW_COLUMN(d, (NKW_TERM(d) + NKW_PRODUCT(d, m)) + NKW_TERM(off));
    } else {
        NKW_COLUMN(d, NKW_TERM(d) + NKW_PRODUCT(d, m));
    }
    NKW_COLUMN(s, NKW_TERM(s) + NKW_PRODUCT(s, m));
    NKW_COLUMN(t, NKW_TERM(t) + NKW_PRODUCT(t, m));
    NKW_COLUMN_LOAD(scale, a + 6);
    NKW_COLUMN_MIX(x, scale, scale, 1, 2, 3, 0);
    NKW_COLUMN_MIX(y, scale, scale, 2, 3, 1, 0);
    NKW_COLUMN(d, NKW_PRODUCT(d, x));
    NKW_COLUMN(s, NKW_PRODUCT(s, x));
    NKW_COLUMN(t, NKW_PRODUCT(t, y));
    NKW_COLUMN_MIX(s, s, s, 2, 0, 1, 3);
    NKW_COLUMN_END(d, 0);
    NKW_COLUMN_END(s, 0);
    NKW_COLUMN_END(t, 0);
    NKW_COLUMN_MIX(x, s, d, 4, 1, 2, 3);
    NKW_COLUMN_MIX(y, d, t, 4, 1, 2, 3);
    NKW_COLUMN_MIX(z, t, s, 4, 1, 2, 3);
    NKW_COLUMN_MIX(x, x, t, 0, 1, 6, 7);
    NKW_COLUMN_MIX(y, y, s, 0, 1, 6, 7);
    NKW_COLUMN_MIX(z, z, d, 0, 1, 6, 7);
    NKW_COLUMN_LOAD(origin, a);
    NKW_COLUMN_END(origin, 1);
    nkw_mat4 r;
    NKW_COLUMNS_STORE(&r, x, y, z, origin);
    return r;
}

NKW_BODY nkw_vec3 nkw_trs_transform_point(const nkw_trs *trs, nkw_vec3 p)
{
    nkw_vec3 scaled = nkw_vec3_mul(trs->scale, p);
    return nkw_vec3_add(trs->translation, nkw_quat_rotate(trs->rotation, scaled));
}

NKW_BODY nkw_trs nkw_trs_mul(const nkw_trs *a, const nkw_trs *b)
{
    nkw_trs r;
    r.translation = nkw_trs_transform_point(a, b->translation);
    r.rotation = nkw_quat_mul(a->rotation, b->rotation);
    r.scale = nkw_vec3_mul(a->scale, b->scale);
    return r;
}

#ifdef __cplusplus
}
#endif

#endif
