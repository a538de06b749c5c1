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

nkw_vec3 nkw_vec3_cubic_sum(const nkw_vec3_cubic *cubic, nkw_weights weights)
{
    const nkw_vec3 *c = cubic->c;
    nkw_vec3 r = {
        lane_weigh(weights, c[0].x, c[1].x, c[2].x, c[3].x),
        lane_weigh(weights, c[0].y, c[1].y, c[2].y, c[3].y),
        lane_weigh(weights, c[0].z, c[1].z, c[2].z, c[3].z),
    };
    return r;
}

void nkw_cubic_from_catmull_rom(const float keys[4], const float times[4], float cubic[4])
{
    const float h0 = times[1] - times[0], h1 = times[2] - times[1], h2 = times[3] - times[2];
    const float p0 = keys[0], p1 = keys[1], p2 = keys[2], p3 = keys[3];
    cubic[0] = p1;
    cubic[1] = lane_catmull_rom_tangent(p0, p1, p2, h0, h1) * h1;
    cubic[2] = p2;
    cubic[3] = lane_catmull_rom_tangent(p1, p2, p3, h1, h2) * h1;
}

nkw_vec3_cubic nkw_vec3_cubic_from_catmull_rom(const nkw_vec3 keys[4], const float times[4])
{
    nkw_vec3_cubic r;
    for (size_t k = 0; k < 3; k++) {
        const float *p = (const float *)(const void *)keys + k, of[4] = {p[0], p[3], p[6], p[9]};
        float cubic[4], *c = (float *)(void *)&r + k;
        nkw_cubic_from_catmull_rom(of, times, cubic);
        for (size_t i = 0; i < 4; i++)
            c[3 * i] = cubic[i];
    }
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

static lane_f64_cubic to_bezier(lane_f64_cubic c, nkw_cubic_kind from)
{
    switch (from) {
#define TO_BEZIER(KIND, name, first, last)                                                                             \
    case NKW_CUBIC_##KIND:                                                                                             \
        return lane_bezier_from_##name(c);
        LANE_CUBICS(TO_BEZIER)
#undef TO_BEZIER
    case NKW_CUBIC_KIND_MAX_ENUM:
        break;
    }
    return lane_bezier_from_hermite(c);
}

static lane_f64_cubic from_bezier(lane_f64_cubic b, nkw_cubic_kind to)
{
    switch (to) {
#define FROM_BEZIER(KIND, name, first, last)                                                                           \
    case NKW_CUBIC_##KIND:                                                                                             \
        return lane_##name##_from_bezier(b);
        LANE_CUBICS(FROM_BEZIER)
#undef FROM_BEZIER
    case NKW_CUBIC_KIND_MAX_ENUM:
        break;
    }
    return lane_hermite_from_bezier(b);
}

/* NKW_CUBIC_HERMITE for a number that is no kind. */
static nkw_cubic_kind known(nkw_cubic_kind kind)
{
    switch (kind) {
#define KNOWN(KIND, name, first, last) case NKW_CUBIC_##KIND:
        LANE_CUBICS(KNOWN)
#undef KNOWN
        return kind;
    case NKW_CUBIC_KIND_MAX_ENUM:
        break;
    }
    return NKW_CUBIC_HERMITE;
}

nkw_vec3_cubic nkw_vec3_cubic_convert(const nkw_vec3_cubic *cubic, nkw_cubic_kind from, nkw_cubic_kind to)
{
    nkw_vec3_cubic r = *cubic;
    if (known(from) == known(to))
        return r;
    for (size_t k = 0; k < 3; k++)
        set_component(&r, k, from_bezier(to_bezier(component(cubic, k), from), to));
    return r;
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
