/* SPDX-License-Identifier: MIT */
/* The first program with the two files: a pose between two, its model matrices, and an array, as hexadecimal floats. */
#include <stdio.h>

#include "nakawari.h"

enum { JOINTS = 3, COUNT = 37 };

static void print_models(void)
{
    static const int32_t parents[JOINTS] = {NKW_NO_JOINT, 0, 1};
    static float a[10 * 16], b[10 * 16], out[10 * 16];
    const nkw_vec3 y = {0.0f, 1.0f, 0.0f}, z = {0.0f, 0.0f, 1.0f}, one = {1.0f, 1.0f, 1.0f};
    nkw_pose_span pa = {a, JOINTS}, pb = {b, JOINTS}, po = {out, JOINTS};
    nkw_pose_view va = {a, JOINTS}, vb = {b, JOINTS}, vo = {out, JOINTS};
    nkw_mask_view all = {NULL, JOINTS};
    nkw_skeleton skeleton = {parents, JOINTS};
    nkw_mat4 models[JOINTS];
    size_t i, k;
    for (i = 0; i < JOINTS; i++) {
        nkw_trs ta, tb;
        ta.translation = y, ta.rotation = nkw_quat_from_axis_angle(z, 0.3f * (float)i), ta.scale = one;
        tb.translation = y, tb.rotation = nkw_quat_from_axis_angle(y, 1.1f + (float)i), tb.scale = one;
        nkw_pose_set(pa, i, &ta);
        nkw_pose_set(pb, i, &tb);
    }
    nkw_pose_blend(va, vb, 0.375f, all, po);
    nkw_skeleton_models_from_pose(&skeleton, vo, NULL, NULL, models);
    for (i = 0; i < JOINTS; i++)
        for (k = 0; k < 16; k++)
            printf("%a%c", (double)models[i].m[k], k % 4 < 3 ? ' ' : '\n');
}

static void print_array(void)
{
    static float data[9][COUNT];
    nkw_quat_view a = {data[0], data[1], data[2], data[3]}, b = {data[4], data[5], data[6], data[7]};
    nkw_quat_span out = {data[0], data[1], data[2], data[3]};
    size_t i, k;
    for (i = 0; i < COUNT; i++) {
        nkw_vec3 axis = {1.0f, (float)i, -2.0f};
        nkw_quat p = nkw_quat_from_axis_angle(axis, 0.1f * (float)i), q = nkw_quat_from_axis_angle(axis, 1.5f);
        data[0][i] = p.x, data[1][i] = p.y, data[2][i] = p.z, data[3][i] = p.w;
        data[4][i] = q.z, data[5][i] = q.y, data[6][i] = q.x, data[7][i] = q.w;
        data[8][i] = 0.03f * (float)i;
    }
    nkw_quat_slerp_n(a, b, data[8], out, COUNT);
    for (i = 0; i < COUNT; i++)
        for (k = 0; k < 4; k++)
            printf("%a%c", (double)data[k][i], k < 3 ? ' ' : '\n');
}

int main(void)
{
    print_models();
    print_array();
    return 0;
}
