/* SPDX-License-Identifier: MIT */
/* The formulas of vec.h beyond the small algebra. */
#ifndef NAKAWARI_LANE_VEC_H
#define NAKAWARI_LANE_VEC_H

#include "strict.h"

#include <nakawari/vec.h>

#include "f64.h"

/* A vector in binary64. */
typedef struct lane_f64_vec3 {
    double x, y, z;
} lane_f64_vec3;

static inline lane_f64_vec3 lane_f64_vec3_from(nkw_vec3 a)
{
    lane_f64_vec3 r = {a.x, a.y, a.z};
    return r;
}

static inline nkw_vec3 lane_vec3_from_f64(lane_f64_vec3 a)
{
    nkw_vec3 r = {(float)a.x, (float)a.y, (float)a.z};
    return r;
}

static inline lane_f64_vec3 lane_f64_vec3_scale(lane_f64_vec3 a, double s)
{
    lane_f64_vec3 r = {a.x * s, a.y * s, a.z * s};
    return r;
}

static inline lane_f64_vec3 lane_f64_vec3_add(lane_f64_vec3 a, lane_f64_vec3 b)
{
    lane_f64_vec3 r = {a.x + b.x, a.y + b.y, a.z + b.z};
    return r;
}

/* a + s b */
static inline lane_f64_vec3 lane_f64_vec3_add_scaled(lane_f64_vec3 a, lane_f64_vec3 b, double s)
{
    lane_f64_vec3 r = {a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
    return r;
}

static inline lane_f64_vec3 lane_f64_vec3_sub(lane_f64_vec3 a, lane_f64_vec3 b)
{
    lane_f64_vec3 r = {a.x - b.x, a.y - b.y, a.z - b.z};
    return r;
}

static inline double lane_f64_vec3_dot(lane_f64_vec3 a, lane_f64_vec3 b)
{
    return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

static inline lane_f64_vec3 lane_f64_vec3_cross(lane_f64_vec3 a, lane_f64_vec3 b)
{
    lane_f64_vec3 r = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    return r;
}

/* v + a r x v + b r x (r x v) */
static inline lane_f64_vec3 lane_f64_vec3_turned(lane_f64_vec3 r, lane_f64_vec3 v, double a, double b)
{
    lane_f64_vec3 c = lane_f64_vec3_cross(r, v);
    return lane_f64_vec3_add_scaled(lane_f64_vec3_add_scaled(v, c, a), lane_f64_vec3_cross(r, c), b);
}

static inline double lane_f64_vec3_length(lane_f64_vec3 a)
{
    return lane_sqrt64(lane_f64_vec3_dot(a, a));
}

static inline lane_f64_vec3 lane_f64_vec3_select(int first, lane_f64_vec3 a, lane_f64_vec3 b)
{
    lane_f64_vec3 r = {first ? a.x : b.x, first ? a.y : b.y, first ? a.z : b.z};
    return r;
}

/* a / |a|; the zero vector stays zero. The squares of floats are normal in binary64. */
static inline lane_f64_vec3 lane_f64_vec3_normalize(lane_f64_vec3 a)
{
    double n2 = lane_f64_vec3_dot(a, a);
    return lane_f64_vec3_scale(a, n2 == 0.0 ? 0.0 : lane_rsqrt64(n2));
}

/* Returns the direction of e x a, where e is the axis of the smallest component of a; the x axis for a = 0. */
static inline lane_f64_vec3 lane_f64_vec3_perpendicular(lane_f64_vec3 a)
{
    double x = a.x * a.x, y = a.y * a.y, z = a.z * a.z;
    int least_x = x <= y && x <= z;
    int least_y = y <= z || z != z;
    lane_f64_vec3 about_x = {0.0, -a.z, a.y};
    lane_f64_vec3 about_y = {a.z, 0.0, -a.x};
    lane_f64_vec3 about_z = {-a.y, a.x, 0.0};
    lane_f64_vec3 axis_x = {1.0, 0.0, 0.0};
    lane_f64_vec3 r = lane_f64_vec3_select(least_x, about_x, lane_f64_vec3_select(least_y, about_y, about_z));
    return lane_f64_vec3_normalize(lane_f64_vec3_select((x + y) + z == 0.0, axis_x, r));
}

static inline float lane_vec3_length(nkw_vec3 a)
{
    return (float)lane_f64_vec3_length(lane_f64_vec3_from(a));
}

static inline float lane_vec3_distance(nkw_vec3 a, nkw_vec3 b)
{
    return (float)lane_f64_vec3_length(lane_f64_vec3_sub(lane_f64_vec3_from(a), lane_f64_vec3_from(b)));
}

static inline float lane_vec3_angle(nkw_vec3 a, nkw_vec3 b)
{
    lane_f64_vec3 u = lane_f64_vec3_from(a), v = lane_f64_vec3_from(b);
    double sine = lane_f64_vec3_length(lane_f64_vec3_cross(u, v));
    double cosine = lane_f64_vec3_dot(u, v);
    return (float)lane_atan2_64(sine, sine == 0.0 && cosine == 0.0 ? 1.0 : cosine);
}

static inline lane_f64_vec3 lane_f64_vec3_project(lane_f64_vec3 a, lane_f64_vec3 b)
{
    double n2 = lane_f64_vec3_dot(b, b);
    return lane_f64_vec3_scale(b, n2 == 0.0 ? 0.0 : lane_f64_vec3_dot(a, b) / lane_divisor64(n2));
}

#endif
