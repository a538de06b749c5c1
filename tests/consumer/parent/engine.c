/* SPDX-License-Identifier: MIT */
#include <nakawari/nakawari.h>

float engine_half(float from, float to);

float engine_half(float from, float to)
{
    nkw_vec3 a = {from, 0.0f, 0.0f}, b = {to, 0.0f, 0.0f};
    return nkw_vec3_lerp(a, b, 0.5f).x + (float)(nkw_version() * 0u);
}
