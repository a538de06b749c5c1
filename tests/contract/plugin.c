/* SPDX-License-Identifier: MIT */
/* A plug-in of a user, with the static library inside: of a small function, a loop and its dispatch. */
#include <nakawari/nakawari.h>

float plugin_angle(nkw_quat a, nkw_quat b);

float plugin_angle(nkw_quat a, nkw_quat b)
{
    float x[2] = {a.x, b.x}, y[2] = {a.y, b.y}, z[2] = {a.z, b.z}, w[2] = {a.w, b.w};
    const float t[2] = {0.25f, 0.75f};
    nkw_quat_slerp_n((nkw_quat_view){x, y, z, w}, (nkw_quat_view){x, y, z, w}, t, (nkw_quat_span){x, y, z, w}, 2);
    nkw_quat between = {x[0], y[0], z[0], w[0]};
    return nkw_quat_angle(between, nkw_quat_mul(a, b));
}
