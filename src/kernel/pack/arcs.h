/* SPDX-License-Identifier: MIT */
/* Arc tangents of several pairs, two side by side: for scalar calls. */
#ifndef NAKAWARI_PACK_ARCS_H
#define NAKAWARI_PACK_ARCS_H

#include "lane/strict.h"

#include "lane/f64.h"
#include "pack/f64x2.h"

#if NKW_F32X4
/* LANE_ATAN at z: lane_poly8. */
static inline f64x2 f64x2_atan_series(f64x2 z)
{
    const double *c = LANE_ATAN;
    const f64x2 zz = z * z;
    return (c[0] + c[1] * z) + zz * ((c[2] + c[3] * z) + zz * ((c[4] + c[5] * z) + zz * (c[6] + c[7] * z)));
}

/*
 * Second text of lane_atan2_64; 1.5 times faster.
 *
 * For numbers below 2^1022 and pairs not below 2^-960, to which lane_atan2_64 adds 2^-1022 in vain. Of two zeros the
 * angle is that of their signs.
 */
static inline f64x2 f64x2_atan2(f64x2 y, f64x2 x)
{
    const i64x2 sx = f64x2_sign(x), sy = f64x2_sign(y), ax = (i64x2)x ^ sx, ay = (i64x2)y ^ sy;
    const i64x2 above = (f64x2)ay > (f64x2)ax;
    const f64x2 low = f64x2_min((f64x2)ay, (f64x2)ax), high = f64x2_max((f64x2)ax, (f64x2)ay);
    const i64x2 steep = low > LANE_TAN_EIGHTH_PI * high;
    const f64x2 sum = high + f64x2_where(steep, low), divisor = sum + f64x2_where(sum == 0.0, f64x2_splat(1.0));
    const f64x2 q = (low - f64x2_where(steep, high)) / divisor, z = q * q;
    f64x2 angle = f64x2_where(steep, f64x2_splat(LANE_QUARTER_PI)) + q * (1.0 + z * f64x2_atan_series(z));
    angle = f64x2_where(above, f64x2_splat(LANE_HALF_PI)) + (f64x2)((i64x2)angle ^ (above << 63));
    angle = f64x2_where((f64x2)(sx | (i64x2)f64x2_splat(1.0)) < 0.0, f64x2_splat(LANE_PI)) + (f64x2)((i64x2)angle ^ sx);
    return (f64x2)((i64x2)angle | sy);
}

/* The angles of (x[i], y[i]). */
static inline void f64x2_three_arcs(const double y[3], const double x[3], double a[3])
{
    const f64x2 first = f64x2_atan2(f64x2_of(y[0], y[1]), f64x2_of(x[0], x[1]));
    a[0] = first[0], a[1] = first[1];
    a[2] = f64x2_atan2(f64x2_splat(y[2]), f64x2_splat(x[2]))[0];
}
#else
static inline void f64x2_three_arcs(const double y[3], const double x[3], double a[3])
{
    for (size_t i = 0; i < 3; i++)
        a[i] = lane_atan2_64(y[i], x[i]);
}
#endif

#endif
