/* SPDX-License-Identifier: MIT */
/* A cubic segment of vectors in binary64. */
#ifndef NAKAWARI_POLYCURVE_SLOPES_H
#define NAKAWARI_POLYCURVE_SLOPES_H

#include "lane/strict.h"

#include <nakawari/polycurve.h>

#include "lane/cubic.h"
#include "lane/vec.h"

/* The differences of the control values of each component. */
typedef struct polycurve_slopes {
    lane_f64_slopes x, y, z;
} polycurve_slopes;

static inline polycurve_slopes polycurve_slopes_of(nkw_cubic_kind kind, const nkw_vec3_cubic *cubic)
{
    const nkw_vec3 *c = cubic->c;
    const float x[4] = {c[0].x, c[1].x, c[2].x, c[3].x}, y[4] = {c[0].y, c[1].y, c[2].y, c[3].y},
                z[4] = {c[0].z, c[1].z, c[2].z, c[3].z};
    polycurve_slopes r = {lane_slopes_of(kind, x), lane_slopes_of(kind, y), lane_slopes_of(kind, z)};
    return r;
}

static inline lane_f64_vec3 polycurve_first(const polycurve_slopes *a, double t)
{
    lane_f64_vec3 r = {lane_f64_first(a->x, t), lane_f64_first(a->y, t), lane_f64_first(a->z, t)};
    return r;
}

static inline lane_f64_vec3 polycurve_second(const polycurve_slopes *a, double t)
{
    lane_f64_vec3 r = {lane_f64_second(a->x, t), lane_f64_second(a->y, t), lane_f64_second(a->z, t)};
    return r;
}

/* |f| + |v0| + |v1|: what the derivatives for t in 0..1 do not exceed by much. */
static inline double polycurve_size(const polycurve_slopes *a)
{
    lane_f64_vec3 f = {a->x.f, a->y.f, a->z.f}, v0 = {a->x.v0, a->y.v0, a->z.v0}, v1 = {a->x.v1, a->y.v1, a->z.v1};
    return (lane_f64_vec3_length(f) + lane_f64_vec3_length(v0)) + lane_f64_vec3_length(v1);
}

/* The third derivative, the same at every t. */
static inline lane_f64_vec3 polycurve_third(const polycurve_slopes *a)
{
    lane_f64_vec3 r = {6.0 * (a->x.v0 + a->x.v1) - 12.0 * a->x.f, 6.0 * (a->y.v0 + a->y.v1) - 12.0 * a->y.f,
                       6.0 * (a->z.v0 + a->z.v1) - 12.0 * a->z.f};
    return r;
}

#endif
