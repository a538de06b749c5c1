/* SPDX-License-Identifier: MIT */
/* Vectors of vertices stored in integers of `bits` bits, and read again: the nearest value that the integers have. */
#ifndef NAKAWARI_TESTS_QUANTIZED_H
#define NAKAWARI_TESTS_QUANTIZED_H

#include <math.h>

#include <nakawari/nakawari.h>

/* Unsigned, 0 at `low` and 2^bits - 1 at `high`. */
static inline float quantized_between(float x, float low, float high, int bits)
{
    double steps = ldexp(1.0, bits) - 1.0, side = (double)high - (double)low;
    return side > 0.0 ? (float)((double)low + round(((double)x - (double)low) / side * steps) / steps * side) : low;
}

/* Within the box of the mesh, each axis by itself. */
static inline nkw_vec3 quantized_position(nkw_vec3 p, const nkw_box *box, int bits)
{
    nkw_vec3 r = {quantized_between(p.x, box->low.x, box->high.x, bits),
                  quantized_between(p.y, box->low.y, box->high.y, bits),
                  quantized_between(p.z, box->low.z, box->high.z, bits)};
    return r;
}

/* Signed, as GL's normalised integers: n / (2^(bits - 1) - 1). */
static inline nkw_vec3 quantized_direction(nkw_vec3 d, int bits)
{
    double most = ldexp(1.0, bits - 1) - 1.0;
    nkw_vec3 r = {(float)(round((double)d.x * most) / most), (float)(round((double)d.y * most) / most),
                  (float)(round((double)d.z * most) / most)};
    return r;
}

/* The distance of two points; the angle of two directions, degrees. */
static inline double quantized_distance(nkw_vec3 a, nkw_vec3 b)
{
    double x = (double)a.x - (double)b.x, y = (double)a.y - (double)b.y, z = (double)a.z - (double)b.z;
    return sqrt(x * x + y * y + z * z);
}

static inline double quantized_angle(nkw_vec3 a, nkw_vec3 b)
{
    double x = (double)a.y * (double)b.z - (double)a.z * (double)b.y;
    double y = (double)a.z * (double)b.x - (double)a.x * (double)b.z;
    double z = (double)a.x * (double)b.y - (double)a.y * (double)b.x;
    double dot = (double)a.x * (double)b.x + (double)a.y * (double)b.y + (double)a.z * (double)b.z;
    return atan2(sqrt(x * x + y * y + z * z), dot) * (180.0 / 3.14159265358979323846);
}

#endif
