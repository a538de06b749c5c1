/* SPDX-License-Identifier: MIT */
/* Sine and cosine of three angles in one register, for single calls. Loops take the lanes. */
#ifndef NAKAWARI_PACK_ANGLES_H
#define NAKAWARI_PACK_ANGLES_H

#include "lane/strict.h"

#include "lane/euler.h"
#include "pack/f32x4.h"

#if NKW_F32X4
/* c in the first three floats. In all four GCC would not read the constant from memory, but broadcast it each time. */
static inline f32x4 f32x4_three(float c)
{
    f32x4 r = {c, c, c, 0.0f};
    return r;
}

/* c[0] + z (c[1] + z c[2]) */
static inline f32x4 f32x4_three_terms(const float *c, f32x4 z)
{
    return f32x4_three(c[0]) + z * (f32x4_three(c[1]) + z * f32x4_three(c[2]));
}

/* Second text of lane_sincos32_of; 1.4 times faster. */
static inline lane_turns32 f32x4_turns(float i, float j, float k)
{
    const f32x4 x = {i, j, k, 0.0f}, magic = f32x4_three(0x1.8p23f), one = f32x4_three(1.0f);
    f32x4 rounded = x * f32x4_three(LANE_TWO_OVER_PI) + magic, n = rounded - magic;
    f32x4 exact = (x - n * f32x4_three(LANE_HALF_PI_HIGH)) - n * f32x4_three(LANE_HALF_PI_MIDDLE);
    f32x4 low = n * f32x4_three(LANE_HALF_PI_LOW), r = exact - low, tail = (exact - r) - low;
    f32x4 z = r * r, half = f32x4_three(0.5f) * z, leading = one - half;
    f32x4 sine = r + ((r * z) * f32x4_three_terms(LANE_SIN32, z) + tail);
    f32x4 cosine = leading + (((one - leading) - half) + ((z * z) * f32x4_three_terms(LANE_COS32, z) - r * tail));
    i32x4 quarters = (i32x4)rounded, odd = -(quarters & 1);
    f32x4 s = f32x4_flip(f32x4_select(odd, cosine, sine), quarters << 30);
    f32x4 c = f32x4_flip(f32x4_select(odd, sine, cosine), (quarters + 1) << 30);
    lane_turns32 t = {{s[0], c[0]}, {s[1], c[1]}, {s[2], c[2]}};
    return t;
}
#else
static inline lane_turns32 f32x4_turns(float i, float j, float k)
{
    lane_turns32 t = {lane_sincos32_of(i), lane_sincos32_of(j), lane_sincos32_of(k)};
    return t;
}
#endif

#endif
