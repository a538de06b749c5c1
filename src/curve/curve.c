/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/curve.h>

#include "lane/cubic.h"

nkw_weights nkw_cubic_weights(nkw_cubic_kind kind, int derivative, float t)
{
    switch (kind) {
    case NKW_CUBIC_BEZIER:
        return derivative == 1   ? lane_bezier_velocity_weights(t)
               : derivative == 2 ? lane_bezier_acceleration_weights(t)
                                 : nkw_bezier_weights(t);
    case NKW_CUBIC_BSPLINE:
        return derivative == 1   ? lane_bspline_velocity_weights(t)
               : derivative == 2 ? lane_bspline_acceleration_weights(t)
                                 : lane_bspline_weights(t);
    case NKW_CUBIC_CATMULL_ROM:
        return derivative == 1   ? lane_catmull_rom_velocity_weights(t)
               : derivative == 2 ? lane_catmull_rom_acceleration_weights(t)
                                 : lane_catmull_rom_weights(t);
    case NKW_CUBIC_HERMITE:
    default:
        return derivative == 1   ? lane_hermite_velocity_weights(t)
               : derivative == 2 ? lane_hermite_acceleration_weights(t)
                                 : lane_hermite_weights(t);
    }
}

float nkw_weighted_sum(nkw_weights weights, float c0, float c1, float c2, float c3)
{
    return lane_weigh(weights, c0, c1, c2, c3);
}

nkw_vec3 nkw_vec3_weighted_sum(nkw_weights weights, nkw_vec3 c0, nkw_vec3 c1, nkw_vec3 c2, nkw_vec3 c3)
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

float nkw_catmull_rom_nonuniform(const float times[4], float p0, float p1, float p2, float p3, float t)
{
    float h0 = times[1] - times[0], h1 = times[2] - times[1], h2 = times[3] - times[2];
    float v1 = lane_catmull_rom_tangent(p0, p1, p2, h0, h1) * h1;
    float v2 = lane_catmull_rom_tangent(p1, p2, p3, h1, h2) * h1;
    return nkw_hermite(p1, v1, p2, v2, t);
}

nkw_vec3 nkw_vec3_catmull_rom_nonuniform(const float times[4], nkw_vec3 p0, nkw_vec3 p1, nkw_vec3 p2, nkw_vec3 p3,
                                         float t)
{
    nkw_vec3 r = {
        nkw_catmull_rom_nonuniform(times, p0.x, p1.x, p2.x, p3.x, t),
        nkw_catmull_rom_nonuniform(times, p0.y, p1.y, p2.y, p3.y, t),
        nkw_catmull_rom_nonuniform(times, p0.z, p1.z, p2.z, p3.z, t),
    };
    return r;
}

/* The components of four control points. */
static lane_f64_cubic component_x(const nkw_vec3_cubic *a)
{
    lane_f64_cubic r = {{a->c[0].x, a->c[1].x, a->c[2].x, a->c[3].x}};
    return r;
}

static lane_f64_cubic component_y(const nkw_vec3_cubic *a)
{
    lane_f64_cubic r = {{a->c[0].y, a->c[1].y, a->c[2].y, a->c[3].y}};
    return r;
}

static lane_f64_cubic component_z(const nkw_vec3_cubic *a)
{
    lane_f64_cubic r = {{a->c[0].z, a->c[1].z, a->c[2].z, a->c[3].z}};
    return r;
}

static nkw_vec3_cubic from_components(lane_f64_cubic x, lane_f64_cubic y, lane_f64_cubic z)
{
    nkw_vec3_cubic r;
    for (size_t i = 0; i < 4; i++) {
        nkw_vec3 c = {(float)x.c[i], (float)y.c[i], (float)z.c[i]};
        r.c[i] = c;
    }
    return r;
}

nkw_vec3_cubic nkw_vec3_bezier_from_hermite(const nkw_vec3_cubic *hermite)
{
    return from_components(lane_bezier_from_hermite(component_x(hermite)),
                           lane_bezier_from_hermite(component_y(hermite)),
                           lane_bezier_from_hermite(component_z(hermite)));
}

nkw_vec3_cubic nkw_vec3_hermite_from_bezier(const nkw_vec3_cubic *bezier)
{
    return from_components(lane_hermite_from_bezier(component_x(bezier)), lane_hermite_from_bezier(component_y(bezier)),
                           lane_hermite_from_bezier(component_z(bezier)));
}

nkw_vec3_cubic nkw_vec3_bezier_from_bspline(const nkw_vec3_cubic *bspline)
{
    return from_components(lane_bezier_from_bspline(component_x(bspline)),
                           lane_bezier_from_bspline(component_y(bspline)),
                           lane_bezier_from_bspline(component_z(bspline)));
}

void nkw_vec3_bezier_split(const nkw_vec3_cubic *bezier, float t, nkw_vec3_cubic *left, nkw_vec3_cubic *right)
{
    lane_f64_cubic x[2], y[2], z[2];
    lane_bezier_split(component_x(bezier), t, &x[0], &x[1]);
    lane_bezier_split(component_y(bezier), t, &y[0], &y[1]);
    lane_bezier_split(component_z(bezier), t, &z[0], &z[1]);
    *left = from_components(x[0], y[0], z[0]);
    *right = from_components(x[1], y[1], z[1]);
}
