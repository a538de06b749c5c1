/* SPDX-License-Identifier: MIT */
/*
 * Small algebra one upon the other, as C and as C++: compiled once inlined, under flags that may fuse, and once with
 * NKW_NO_INLINE. golden.c has each function alone; here a product of one function goes into the sum of the next, and a
 * sum of each takes a product.
 */
#if defined(FUSED)
#pragma clang fp contract(fast)
#endif

#include <nakawari/nakawari.h>

#ifdef NKW_NO_INLINE
#define RESULT(name) called_##name
#else
#define RESULT(name) inlined_##name
#if !NKW_INLINE
#error "the small algebra is not inlined"
#endif
#endif

#ifdef __cplusplus
extern "C" {
#endif
void RESULT(vectors)(const float *in, float *out);
void RESULT(quats)(const float *in, float *out);
void RESULT(matrices)(const float *in, float *out);
void RESULT(curves)(const float *in, float *out);
void RESULT(scalars)(const float *in, float *out);
void RESULT(rotations)(const float *in, float *out);
void RESULT(many)(const float *in, float *out, size_t n);
#ifdef __cplusplus
}
#endif

static nkw_vec3 vec3_at(const float *p)
{
    nkw_vec3 r = {p[0], p[1], p[2]};
    return r;
}

static nkw_quat quat_at(const float *p)
{
    nkw_quat r = {p[0], p[1], p[2], p[3]};
    return r;
}

static void put_vec3(float *out, nkw_vec3 v)
{
    out[0] = v.x;
    out[1] = v.y;
    out[2] = v.z;
}

static void put_quat(float *out, nkw_quat q)
{
    out[0] = q.x;
    out[1] = q.y;
    out[2] = q.z;
    out[3] = q.w;
}

void RESULT(vectors)(const float *in, float *out)
{
    nkw_vec3 a = vec3_at(in), b = vec3_at(in + 3), c = vec3_at(in + 6);
    float s = in[9];
    put_vec3(out, nkw_vec3_add(nkw_vec3_scale(a, s), nkw_vec3_mul(b, c)));
    put_vec3(out + 3, nkw_vec3_sub(nkw_vec3_cross(a, b), nkw_vec3_scale(c, nkw_vec3_dot(a, b))));
    put_vec3(out + 6, nkw_vec3_negate(nkw_vec3_scale(a, s)));
    put_vec3(out + 9, nkw_vec3_reflect(nkw_vec3_lerp(a, b, s), nkw_vec3_negate(nkw_vec3_mul(a, c))));
    out[12] = nkw_radians_from_degrees(nkw_smoothstep(s)) + nkw_vec3_dot(a, a);
    out[13] = nkw_degrees_from_radians(nkw_lerp(in[2], in[3], nkw_inverse_lerp(in[0], in[1], s)));
    put_vec3(out + 14, nkw_vec3_normalize(nkw_vec3_sub(nkw_vec3_mul(a, b), nkw_vec3_scale(c, nkw_sqrt(nkw_abs(s))))));
}

void RESULT(quats)(const float *in, float *out)
{
    nkw_quat a = quat_at(in), b = quat_at(in + 4);
    float s = in[9];
    put_quat(out, nkw_quat_add(nkw_quat_scale(a, s), nkw_quat_mul(a, b)));
    put_quat(out + 4, nkw_quat_conjugate(nkw_quat_scale(a, s)));
    put_quat(out + 8, nkw_quat_negate(nkw_quat_sub(nkw_quat_scale(b, s), nkw_quat_scale(a, nkw_quat_dot(a, b)))));
    put_vec3(out + 12, nkw_vec3_add(nkw_quat_rotate(a, vec3_at(in + 4)), nkw_vec3_scale(vec3_at(in), s)));
    put_quat(out + 15, nkw_quat_normalize(nkw_quat_add(nkw_quat_mul(a, b), nkw_quat_scale(b, s))));
    put_quat(out + 19, nkw_quat_nlerp(nkw_quat_mul(a, b), nkw_quat_scale(b, s), s * in[0]));
}

void RESULT(matrices)(const float *in, float *out)
{
    nkw_trs trs = {{in[0], in[1], in[2]}, {in[3], in[4], in[5], in[6]}, {in[7], in[8], in[9]}};
    nkw_trs twice = nkw_trs_mul(&trs, &trs);
    nkw_mat4 a = nkw_mat4_from_trs(&trs), b = nkw_mat4_from_trs(&twice), c = nkw_mat4_mul_affine(&a, &b);
    nkw_mat4 d = nkw_mat4_mul(&c, &b), e = nkw_mat4_inverse_rigid(&d), f = nkw_mat4_transpose(&e);
    nkw_mat4 g = nkw_mat4_mul(&f, &d);
    nkw_mat3 m = nkw_mat3_from_mat4(&g), k = nkw_mat3_mul(&m, &m);
    put_vec3(out, nkw_mat4_transform_point(&g, trs.scale));
    put_vec3(out + 3, nkw_mat4_transform_direction(&e, trs.scale));
    put_vec3(out + 6, nkw_mat3_transform(&k, nkw_trs_transform_point(&twice, trs.scale)));
    for (int i = 0; i < 4; i++)
        out[9 + i] = g.m[5 * i];
}

void RESULT(curves)(const float *in, float *out)
{
    nkw_vec3 a = vec3_at(in), b = vec3_at(in + 3), c = vec3_at(in + 6), d = vec3_at(in + 9);
    nkw_vec3 h = nkw_vec3_hermite(nkw_vec3_scale(a, in[1]), b, c, d, in[0]);
    put_vec3(out, h);
    put_vec3(out + 3, nkw_vec3_bezier(h, b, nkw_vec3_mul(c, a), d, in[0]));
    put_vec3(out + 6, nkw_vec3_bspline(a, h, c, nkw_vec3_mul(d, b), in[0]));
    put_vec3(out + 9, nkw_vec3_add(a, nkw_vec3_catmull_rom(a, b, h, nkw_vec3_scale(d, in[1]), in[0])));
}

void RESULT(scalars)(const float *in, float *out)
{
    float a = in[0], b = in[1], c = in[2], d = in[3], t = nkw_clamp(in[4], 0.0f, 1.0f);
    out[0] = nkw_hermite(a, b, c, d, t);
    out[1] = nkw_bezier(a, b, c, d, t);
    out[2] = nkw_bspline(a, b, c, d, t);
    out[3] = nkw_catmull_rom(a, b, c, d, t);
    out[4] = nkw_lerp(nkw_lerp(a, b, t), nkw_lerp(c, d, t), t);
    out[5] = nkw_smoothstep(t) + nkw_inverse_lerp(a, b, c);
    out[6] = nkw_lerp(a, b, in[5]) - nkw_hermite(a, b, c, d, in[5]);
    out[7] = nkw_vec3_dot(vec3_at(in), vec3_at(in + 3)) + nkw_quat_dot(quat_at(in), quat_at(in + 4));
}

void RESULT(rotations)(const float *in, float *out)
{
    nkw_quat q = quat_at(in), p = quat_at(in + 4);
    nkw_vec3 v = vec3_at(in + 8), w = nkw_quat_rotate_inverse(q, nkw_vec3_add_scaled(v, vec3_at(in), in[11]));
    nkw_mat3 a = nkw_mat3_from_quat(q), b = nkw_mat3_from_quat_scale(p, v), c = nkw_mat3_mul(&a, &b);
    nkw_mat4 d = nkw_mat4_from_quat(p), e = nkw_mat4_from_mat3(&c, w), f = nkw_mat4_mul(&e, &d);
    nkw_mat4 g = nkw_mat4_inverse_rigid(&e), h = nkw_mat4_mul_affine(&e, &g), k, l;
    put_vec3(out, nkw_vec3_add(nkw_mat3_transform(&c, w), nkw_mat4_transform_direction(&f, v)));
    put_vec3(out + 3, nkw_vec3_sub(nkw_mat4_transform_point(&h, w), nkw_vec3_normalize(nkw_vec3_scale(v, in[12]))));
    put_quat(out + 6, nkw_quat_nlerp(q, p, nkw_clamp(in[13], 0.0f, 1.0f)));
    for (size_t i = 0; i < 9; i++)
        out[10 + i] = a.m[i] + b.m[i];
    for (size_t i = 0; i < 16; i++)
        out[19 + i] = d.m[i] + g.m[i];
    for (size_t i = 0; i < 16; i++)
        out[35 + i] = f.m[i] - h.m[i];
    for (size_t i = 0; i < 16; i++) {
        k.m[i] = in[14 + i];
        l.m[i] = in[30 + i];
    }
    d = nkw_mat4_mul(&k, &l);
    for (size_t i = 0; i < 16; i++)
        out[51 + i] = d.m[i];
}

/* A loop, which compilers make vectors of. */
void RESULT(many)(const float *in, float *out, size_t n)
{
    for (size_t i = 0; i + 2 < n; i++) {
        nkw_vec3 a = vec3_at(in + i);
        put_vec3(out + 3 * i, nkw_vec3_add(nkw_vec3_mul(a, a), nkw_vec3_scale(nkw_vec3_cross(a, vec3_at(in)), in[i])));
    }
}
