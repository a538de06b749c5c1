/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/curve_point.h>

#include "lane/cubic.h"

static float value_of(nkw_cubic_kind kind, const float c[4], float t)
{
    switch (kind) {
    case NKW_CUBIC_BEZIER:
        return nkw_bezier(c[0], c[1], c[2], c[3], t);
    case NKW_CUBIC_BSPLINE:
        return nkw_bspline(c[0], c[1], c[2], c[3], t);
    case NKW_CUBIC_CATMULL_ROM:
        return nkw_catmull_rom(c[0], c[1], c[2], c[3], t);
    case NKW_CUBIC_HERMITE:
    default:
        return nkw_hermite(c[0], c[1], c[2], c[3], t);
    }
}

nkw_curve_point nkw_cubic_point(nkw_cubic_kind kind, const float c[4], float t)
{
    lane_f64_slopes slopes = lane_slopes_of(kind, c);
    nkw_curve_point r = {value_of(kind, c, t), (float)lane_f64_first(slopes, t), (float)lane_f64_second(slopes, t)};
    return r;
}

static nkw_vec3_curve_point from_components(nkw_curve_point x, nkw_curve_point y, nkw_curve_point z)
{
    nkw_vec3_curve_point r = {
        {x.value, y.value, z.value},
        {x.first, y.first, z.first},
        {x.second, y.second, z.second},
    };
    return r;
}

nkw_vec3_curve_point nkw_vec3_cubic_point(nkw_cubic_kind kind, const nkw_vec3_cubic *cubic, float t)
{
    const nkw_vec3 *c = cubic->c;
    const float x[4] = {c[0].x, c[1].x, c[2].x, c[3].x}, y[4] = {c[0].y, c[1].y, c[2].y, c[3].y},
                z[4] = {c[0].z, c[1].z, c[2].z, c[3].z};
    return from_components(nkw_cubic_point(kind, x, t), nkw_cubic_point(kind, y, t), nkw_cubic_point(kind, z, t));
}

nkw_curve_point nkw_catmull_rom_nonuniform_point(const float times[4], float p0, float p1, float p2, float p3, float t)
{
    float h0 = times[1] - times[0], h1 = times[2] - times[1], h2 = times[3] - times[2];
    const float c[4] = {p1, lane_catmull_rom_tangent(p0, p1, p2, h0, h1) * h1, p2,
                        lane_catmull_rom_tangent(p1, p2, p3, h1, h2) * h1};
    return nkw_cubic_point(NKW_CUBIC_HERMITE, c, t);
}

nkw_vec3_curve_point nkw_vec3_catmull_rom_nonuniform_point(const float times[4], nkw_vec3 p0, nkw_vec3 p1, nkw_vec3 p2,
                                                           nkw_vec3 p3, float t)
{
    return from_components(nkw_catmull_rom_nonuniform_point(times, p0.x, p1.x, p2.x, p3.x, t),
                           nkw_catmull_rom_nonuniform_point(times, p0.y, p1.y, p2.y, p3.y, t),
                           nkw_catmull_rom_nonuniform_point(times, p0.z, p1.z, p2.z, p3.z, t));
}

/* The value less that of the end nearer to t, which is p0 if `near` is 0; see nkw_quintic_hermite. */
static double quintic_value(nkw_curve_point p0, nkw_curve_point p1, double f, double t, int near)
{
    double s = 1.0 - t, ss = s * s, tt = t * t;
    double line = near ? -(s * ss) * (10.0 - s * (15.0 - 6.0 * s)) : (t * tt) * (10.0 - t * (15.0 - 6.0 * t));
    double velocity =
        (t * ss) * (s * (1.0 + 3.0 * t)) * (double)p0.first - (s * tt) * (t * (1.0 + 3.0 * s)) * (double)p1.first;
    return line * f + (velocity + (0.5 * (tt * ss)) * (s * (double)p0.second + t * (double)p1.second));
}

static double quintic_first(nkw_curve_point p0, nkw_curve_point p1, double f, double t)
{
    double s = 1.0 - t, ts = t * s;
    double velocity = (s * s) * (1.0 + t * (2.0 - 15.0 * t)) * (double)p0.first +
                      (t * t) * (1.0 + s * (2.0 - 15.0 * s)) * (double)p1.first;
    double acceleration = s * (2.0 - 5.0 * t) * (double)p0.second - t * (2.0 - 5.0 * s) * (double)p1.second;
    return (30.0 * (ts * ts)) * f + (velocity + (0.5 * ts) * acceleration);
}

static double quintic_second(nkw_curve_point p0, nkw_curve_point p1, double f, double t)
{
    double s = 1.0 - t, ts = t * s;
    double velocity = (3.0 - 5.0 * t) * (double)p0.first - (3.0 - 5.0 * s) * (double)p1.first;
    double acceleration =
        s * (1.0 + t * (10.0 * t - 8.0)) * (double)p0.second + t * (1.0 + s * (10.0 * s - 8.0)) * (double)p1.second;
    return (60.0 * ts) * ((s - t) * f) + (acceleration - (12.0 * ts) * velocity);
}

nkw_curve_point nkw_quintic_hermite(nkw_curve_point p0, nkw_curve_point p1, float t)
{
    int near = t >= 0.5f;
    double f = (double)p1.value - (double)p0.value, end = near ? p1.value : p0.value;
    nkw_curve_point r = {(float)(end + quintic_value(p0, p1, f, t, near)), (float)quintic_first(p0, p1, f, t),
                         (float)quintic_second(p0, p1, f, t)};
    return r;
}

/* The x, y and z of a point. */
static nkw_curve_point component_x(const nkw_vec3_curve_point *p)
{
    nkw_curve_point r = {p->value.x, p->first.x, p->second.x};
    return r;
}

static nkw_curve_point component_y(const nkw_vec3_curve_point *p)
{
    nkw_curve_point r = {p->value.y, p->first.y, p->second.y};
    return r;
}

static nkw_curve_point component_z(const nkw_vec3_curve_point *p)
{
    nkw_curve_point r = {p->value.z, p->first.z, p->second.z};
    return r;
}

nkw_vec3_curve_point nkw_vec3_quintic_hermite(const nkw_vec3_curve_point *p0, const nkw_vec3_curve_point *p1, float t)
{
    return from_components(nkw_quintic_hermite(component_x(p0), component_x(p1), t),
                           nkw_quintic_hermite(component_y(p0), component_y(p1), t),
                           nkw_quintic_hermite(component_z(p0), component_z(p1), t));
}
