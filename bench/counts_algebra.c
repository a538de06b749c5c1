/* SPDX-License-Identifier: MIT */
/*
 * The small algebra as callers compile it: one source, compiled with -O2 as C99, and as GNU C99 and C++ for processors
 * with fma, where GCC may contract and the headers compute products otherwise (NKW_FMA). COUNTS_AS is the name before
 * each row. Every t and every rotation is random, so no branch on one can be learnt. Runs under callgrind, as counts.c
 * does.
 */
#include "counted.h"

#ifdef __cplusplus
extern "C" {
#endif
/* What is written has external linkage, so that no compiler drops it. */
extern nkw_quat q_out[N];
extern nkw_vec3 v_out[N];
extern nkw_mat4 m_out[N];
extern float f_out[N];
nkw_quat q_out[N];
nkw_vec3 v_out[N];
nkw_mat4 m_out[N];
float f_out[N];
#ifdef __cplusplus
}
#endif

static void draw_values(random_source *r)
{
    for (size_t i = 0; i < N; i++) {
        draw_element(r, i);
        ma[i] = nkw_mat4_from_quat(qa[i]);
        draw_matrices(r, i);
    }
}

static void count_curves(void)
{
    EACH("lerp", f_out[i] = nkw_lerp(p[0][i].x, p[1][i].x, t[i]));
    EACH("smoothstep", f_out[i] = nkw_smoothstep(t[i]));
    EACH("vec3_lerp", v_out[i] = nkw_vec3_lerp(p[0][i], p[1][i], t[i]));
    EACH("vec3_hermite", v_out[i] = nkw_vec3_hermite(p[0][i], p[1][i], p[2][i], p[3][i], t[i]));
    EACH("vec3_bezier", v_out[i] = nkw_vec3_bezier(p[0][i], p[1][i], p[2][i], p[3][i], t[i]));
    EACH("vec3_bspline", v_out[i] = nkw_vec3_bspline(p[0][i], p[1][i], p[2][i], p[3][i], t[i]));
    EACH("vec3_catmull_rom", v_out[i] = nkw_vec3_catmull_rom(p[0][i], p[1][i], p[2][i], p[3][i], t[i]));
    EACH("quat_nlerp", q_out[i] = nkw_quat_nlerp(qa[i], qb[i], t[i]));
    EACH("quat_slerp", q_out[i] = nkw_quat_slerp(qa[i], qb[i], t[i]));
}

static void count_rotations(void)
{
    EACH("quat_mul", q_out[i] = nkw_quat_mul(qa[i], qb[i]));
    EACH("quat_normalize", q_out[i] = nkw_quat_normalize(qa[i]));
    EACH("quat_rotate", v_out[i] = nkw_quat_rotate(qa[i], p[0][i]));
    EACH("quat_from_mat3", q_out[i] = nkw_quat_from_mat3(&turn[i]));
    EACH("mat4_from_quat", m_out[i] = nkw_mat4_from_quat(qa[i]));
    EACH("mat4_mul", m_out[i] = nkw_mat4_mul(&ma[i], &mb[i]));
    EACH("mat4_inverse_rigid", m_out[i] = nkw_mat4_inverse_rigid(&mb[i]));
    EACH("mat4_inverse", m_out[i] = nkw_mat4_inverse(&mb[i]));
    EACH("euler_from_quat", v_out[i] = nkw_euler_from_quat(qa[i], NKW_EULER_YXZ));
    EACH("euler_from_mat3", v_out[i] = nkw_euler_from_mat3(&turn[i], NKW_EULER_YXZ));
}

int main(void)
{
    random_source r = random_from(5);
    draw_values(&r);
    count_curves();
    count_rotations();
    return 0;
}
