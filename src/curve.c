/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/curve.h>
#include <nakawari/vec.h>

#include "lane/curve.h"

nkw_weights nkw_hermite_weights(float t)
{
    return lane_hermite_weights(t);
}

nkw_weights nkw_hermite_velocity_weights(float t)
{
    return lane_hermite_velocity_weights(t);
}

nkw_weights nkw_hermite_acceleration_weights(float t)
{
    return lane_hermite_acceleration_weights(t);
}

nkw_weights nkw_bezier_weights(float t)
{
    return lane_bezier_weights(t);
}

nkw_weights nkw_bezier_velocity_weights(float t)
{
    return lane_bezier_velocity_weights(t);
}

nkw_weights nkw_bezier_acceleration_weights(float t)
{
    return lane_bezier_acceleration_weights(t);
}

nkw_weights nkw_bspline_weights(float t)
{
    return lane_bspline_weights(t);
}

nkw_weights nkw_bspline_velocity_weights(float t)
{
    return lane_bspline_velocity_weights(t);
}

nkw_weights nkw_bspline_acceleration_weights(float t)
{
    return lane_bspline_acceleration_weights(t);
}

nkw_weights nkw_catmull_rom_weights(float t)
{
    return lane_catmull_rom_weights(t);
}

nkw_weights nkw_catmull_rom_velocity_weights(float t)
{
    return lane_catmull_rom_velocity_weights(t);
}

nkw_weights nkw_catmull_rom_acceleration_weights(float t)
{
    return lane_catmull_rom_acceleration_weights(t);
}

float nkw_weigh(nkw_weights weights, float c0, float c1, float c2, float c3)
{
    return lane_weigh(weights, c0, c1, c2, c3);
}

nkw_vec3 nkw_vec3_weigh(nkw_weights weights, nkw_vec3 c0, nkw_vec3 c1, nkw_vec3 c2, nkw_vec3 c3)
{
    nkw_vec3 r = {
        lane_weigh(weights, c0.x, c1.x, c2.x, c3.x),
        lane_weigh(weights, c0.y, c1.y, c2.y, c3.y),
        lane_weigh(weights, c0.z, c1.z, c2.z, c3.z),
    };
    return r;
}

float nkw_catmull_rom_tangent(float p0, float p1, float p2, float h0, float h1)
{
    return lane_catmull_rom_tangent(p0, p1, p2, h0, h1);
}

nkw_vec3 nkw_vec3_catmull_rom_tangent(nkw_vec3 p0, nkw_vec3 p1, nkw_vec3 p2, float h0, float h1)
{
    nkw_vec3 r = {
        lane_catmull_rom_tangent(p0.x, p1.x, p2.x, h0, h1),
        lane_catmull_rom_tangent(p0.y, p1.y, p2.y, h0, h1),
        lane_catmull_rom_tangent(p0.z, p1.z, p2.z, h0, h1),
    };
    return r;
}

float nkw_catmull_rom_timed(const float times[4], float p0, float p1, float p2, float p3, float t)
{
    float h0 = times[1] - times[0], h1 = times[2] - times[1], h2 = times[3] - times[2];
    float v1 = lane_catmull_rom_tangent(p0, p1, p2, h0, h1) * h1;
    float v2 = lane_catmull_rom_tangent(p1, p2, p3, h1, h2) * h1;
    return nkw_hermite(p1, v1, p2, v2, t);
}

nkw_vec3 nkw_vec3_catmull_rom_timed(const float times[4], nkw_vec3 p0, nkw_vec3 p1, nkw_vec3 p2, nkw_vec3 p3,
                                    float t)
{
    nkw_vec3 r = {
        nkw_catmull_rom_timed(times, p0.x, p1.x, p2.x, p3.x, t),
        nkw_catmull_rom_timed(times, p0.y, p1.y, p2.y, p3.y, t),
        nkw_catmull_rom_timed(times, p0.z, p1.z, p2.z, p3.z, t),
    };
    return r;
}

/* One kind of curve in the terms of another. */
typedef lane_wcubic conversion(lane_wcubic);

static nkw_cubic convert(const nkw_cubic *from, conversion *to)
{
    return lane_cubic_from_wide(to(lane_wcubic_from(*from)));
}

static nkw_cubic component_x(const nkw_vec3_cubic *a)
{
    nkw_cubic r = {{a->c[0].x, a->c[1].x, a->c[2].x, a->c[3].x}};
    return r;
}

static nkw_cubic component_y(const nkw_vec3_cubic *a)
{
    nkw_cubic r = {{a->c[0].y, a->c[1].y, a->c[2].y, a->c[3].y}};
    return r;
}

static nkw_cubic component_z(const nkw_vec3_cubic *a)
{
    nkw_cubic r = {{a->c[0].z, a->c[1].z, a->c[2].z, a->c[3].z}};
    return r;
}

static nkw_vec3_cubic from_components(nkw_cubic x, nkw_cubic y, nkw_cubic z)
{
    nkw_vec3_cubic r;
    for (size_t i = 0; i < 4; i++) {
        nkw_vec3 c = {x.c[i], y.c[i], z.c[i]};
        r.c[i] = c;
    }
    return r;
}

static nkw_vec3_cubic convert_vec3(const nkw_vec3_cubic *from, conversion *to)
{
    nkw_cubic x = component_x(from), y = component_y(from), z = component_z(from);
    return from_components(convert(&x, to), convert(&y, to), convert(&z, to));
}

nkw_cubic nkw_bezier_from_hermite(const nkw_cubic *hermite)
{
    return convert(hermite, lane_bezier_from_hermite);
}

nkw_vec3_cubic nkw_vec3_bezier_from_hermite(const nkw_vec3_cubic *hermite)
{
    return convert_vec3(hermite, lane_bezier_from_hermite);
}

nkw_cubic nkw_hermite_from_bezier(const nkw_cubic *bezier)
{
    return convert(bezier, lane_hermite_from_bezier);
}

nkw_vec3_cubic nkw_vec3_hermite_from_bezier(const nkw_vec3_cubic *bezier)
{
    return convert_vec3(bezier, lane_hermite_from_bezier);
}

nkw_cubic nkw_bezier_from_bspline(const nkw_cubic *bspline)
{
    return convert(bspline, lane_bezier_from_bspline);
}

nkw_vec3_cubic nkw_vec3_bezier_from_bspline(const nkw_vec3_cubic *bspline)
{
    return convert_vec3(bspline, lane_bezier_from_bspline);
}

nkw_cubic nkw_bspline_from_bezier(const nkw_cubic *bezier)
{
    return convert(bezier, lane_bspline_from_bezier);
}

nkw_vec3_cubic nkw_vec3_bspline_from_bezier(const nkw_vec3_cubic *bezier)
{
    return convert_vec3(bezier, lane_bspline_from_bezier);
}

nkw_cubic nkw_hermite_from_bspline(const nkw_cubic *bspline)
{
    return convert(bspline, lane_hermite_from_bspline);
}

nkw_vec3_cubic nkw_vec3_hermite_from_bspline(const nkw_vec3_cubic *bspline)
{
    return convert_vec3(bspline, lane_hermite_from_bspline);
}

nkw_cubic nkw_bspline_from_hermite(const nkw_cubic *hermite)
{
    return convert(hermite, lane_bspline_from_hermite);
}

nkw_vec3_cubic nkw_vec3_bspline_from_hermite(const nkw_vec3_cubic *hermite)
{
    return convert_vec3(hermite, lane_bspline_from_hermite);
}

void nkw_bezier_split(const nkw_cubic *bezier, float t, nkw_cubic *left, nkw_cubic *right)
{
    lane_wcubic before, after;
    lane_bezier_split(lane_wcubic_from(*bezier), t, &before, &after);
    *left = lane_cubic_from_wide(before);
    *right = lane_cubic_from_wide(after);
}

void nkw_vec3_bezier_split(const nkw_vec3_cubic *bezier, float t, nkw_vec3_cubic *left, nkw_vec3_cubic *right)
{
    nkw_cubic x = component_x(bezier), y = component_y(bezier), z = component_z(bezier);
    nkw_cubic after_x, after_y, after_z;
    nkw_bezier_split(&x, t, &x, &after_x);
    nkw_bezier_split(&y, t, &y, &after_y);
    nkw_bezier_split(&z, t, &z, &after_z);
    *left = from_components(x, y, z);
    *right = from_components(after_x, after_y, after_z);
}

nkw_vec3 nkw_per_segment_from_per_second(nkw_vec3 tangent, float duration)
{
    return nkw_vec3_scale(tangent, duration);
}

nkw_vec3 nkw_per_second_from_per_segment(nkw_vec3 tangent, float duration)
{
    return duration == 0.0f ? nkw_vec3_zero() : nkw_vec3_divide(tangent, duration);
}
