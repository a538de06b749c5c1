/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/curve.h>

#include "lane/cubic.h"

nkw_weights nkw_cubic_weights(nkw_cubic_kind kind, int derivative, float t)
{
    switch (kind) {
#define WEIGHTS(KIND, name, first, last)                                                                               \
    case NKW_CUBIC_##KIND:                                                                                             \
        return derivative == 1   ? lane_##name##_velocity_weights(t)                                                   \
               : derivative == 2 ? lane_##name##_acceleration_weights(t)                                               \
                                 : lane_##name##_weights(t);
        LANE_CUBICS(WEIGHTS)
#undef WEIGHTS
    case NKW_CUBIC_KIND_MAX_ENUM:
        break;
    }
    return nkw_cubic_weights(NKW_CUBIC_HERMITE, derivative, t);
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

/* Component k of four control points: vectors are contiguous floats. */
static lane_f64_cubic component(const nkw_vec3_cubic *a, size_t k)
{
    const float *c = (const float *)(const void *)a + k;
    lane_f64_cubic r = {{c[0], c[3], c[6], c[9]}};
    return r;
}

static void set_component(nkw_vec3_cubic *a, size_t k, lane_f64_cubic x)
{
    float *c = (float *)(void *)a + k;
    for (size_t i = 0; i < 4; i++)
        c[3 * i] = (float)x.c[i];
}

static nkw_vec3_cubic converted(const nkw_vec3_cubic *a, lane_f64_cubic (*convert)(lane_f64_cubic))
{
    nkw_vec3_cubic r;
    for (size_t k = 0; k < 3; k++)
        set_component(&r, k, convert(component(a, k)));
    return r;
}

nkw_vec3_cubic nkw_vec3_bezier_from_hermite(const nkw_vec3_cubic *hermite)
{
    return converted(hermite, lane_bezier_from_hermite);
}

nkw_vec3_cubic nkw_vec3_hermite_from_bezier(const nkw_vec3_cubic *bezier)
{
    return converted(bezier, lane_hermite_from_bezier);
}

nkw_vec3_cubic nkw_vec3_bezier_from_bspline(const nkw_vec3_cubic *bspline)
{
    return converted(bspline, lane_bezier_from_bspline);
}

void nkw_vec3_bezier_split(const nkw_vec3_cubic *bezier, float t, nkw_vec3_cubic *left, nkw_vec3_cubic *right)
{
    const nkw_vec3_cubic whole = *bezier;
    for (size_t k = 0; k < 3; k++) {
        lane_f64_cubic before, after;
        lane_bezier_split(component(&whole, k), t, &before, &after);
        set_component(left, k, before);
        set_component(right, k, after);
    }
}
