/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/scalar.h>

#include "lane/scalar.h"
#include "pack/sincos.h"

float nkw_sin(float angle)
{
    return lane_sin_any(angle);
}

float nkw_cos(float angle)
{
    return lane_cos_any(angle);
}

void nkw_sincos(float angle, float *sine, float *cosine)
{
    lane_sincos a = f64x2_sincos_any((double)angle);
    *sine = (float)a.s;
    *cosine = (float)a.c;
}

float nkw_tan(float angle)
{
    return lane_tan_any(angle);
}

float nkw_asin(float x)
{
    return lane_asin(x);
}

float nkw_acos(float x)
{
    return lane_acos(x);
}

float nkw_atan(float x)
{
    return lane_atan(x);
}

float nkw_atan2(float y, float x)
{
    return lane_atan2(y, x);
}

float nkw_exp(float x)
{
    return lane_exp(x);
}

float nkw_log(float x)
{
    return lane_log(x);
}

float nkw_pow(float x, float y)
{
    return lane_pow(x, y);
}

float nkw_wrap(float x, float period)
{
    return lane_wrap_is_far(x, period) ? lane_wrap_far(x, period) : lane_wrap(x, period);
}

float nkw_wrap_angle(float angle)
{
    return lane_wrap_angle_any(angle);
}

float nkw_angle_difference(float from, float to)
{
    int far = lane_angle_is_far(from) | lane_angle_is_far(to);
    return far ? lane_angle_difference_far(from, to) : lane_angle_difference(from, to);
}

int nkw_equal_within(float a, float b, float tolerance)
{
    return nkw_abs(a - b) <= tolerance || a == b;
}

float nkw_move_towards(float from, float to, float step)
{
    float d = to - from, s = step < 0.0f ? 0.0f : step;
    if (nkw_abs(d) <= s)
        return to;
    return d < 0.0f ? from - s : d > 0.0f ? from + s : d;
}
