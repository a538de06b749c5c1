/* SPDX-License-Identifier: MIT */
#include <nakawari/nakawari.h>
#include <cstdio>

int main()
{
    const nkw_quat from = nkw_quat_identity();
    const nkw_quat to = nkw_quat_from_axis_angle(nkw_vec3{0.0f, 0.0f, 1.0f}, 1.0f);
    const nkw_quat half = nkw_quat_slerp(from, to, 0.5f);
    const nkw_vec3 v = nkw_quat_rotate(half, nkw_vec3{1.0f, 0.0f, 0.0f});
    std::printf("C++: version %u, (%g, %g, %g)\n", nkw_version(), v.x, v.y, v.z);
    return !(nkw_abs(v.x - nkw_cos(0.5f)) < 1e-6f && nkw_abs(v.y - nkw_sin(0.5f)) < 1e-6f);
}
