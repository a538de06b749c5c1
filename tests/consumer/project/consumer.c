/* SPDX-License-Identifier: MIT */
#include <nakawari/nakawari.h>
#include <stdio.h>

int main(void)
{
    const nkw_keyframe keys[2] = {
        {0.0f, {0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f, 1.0f}},
        {2.0f, {4.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f, 0.0f}},
    };
    nkw_mat4 m;
    nkw_result result =
        nkw_keyframes_sample(keys, 2, 1.0f, NKW_POSITION_LINEAR, NKW_ORIENTATION_SLERP, &m);
    nkw_vec3 p = {1.0f, 0.0f, 0.0f};
    nkw_vec3 q = nkw_mat4_transform_point(&m, p);
    printf("C: version %u, %s, (%g, %g, %g)\n", nkw_version(), nkw_result_text(result), (double)q.x, (double)q.y,
           (double)q.z);
    return !(result == NKW_OK && nkw_abs(q.x - 2.0f) < 1e-6f && nkw_abs(q.y - 1.0f) < 1e-6f);
}
