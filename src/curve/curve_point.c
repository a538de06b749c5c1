/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/curve.h>

#include "lane/cubic.h"

static float value_of(nkw_cubic_kind kind, const float c[4], float t)
{
    switch (kind) {
#define VALUE(KIND, name, first, last)                                                                                 \
    case NKW_CUBIC_##KIND:                                                                                             \
        return nkw_##name(c[0], c[1], c[2], c[3], t);
        LANE_CUBICS(VALUE)
#undef VALUE
    case NKW_CUBIC_KIND_MAX_ENUM:
        break;
    }
    return nkw_hermite(c[0], c[1], c[2], c[3], t);
}

nkw_motion nkw_cubic_evaluate(const float cubic[4], float t, nkw_cubic_kind kind)
{
    lane_f64_slopes slopes = lane_slopes_of(kind, cubic);
    nkw_motion r = {value_of(kind, cubic, t), (float)lane_f64_first(slopes, t), (float)lane_f64_second(slopes, t)};
    return r;
}

/* Component k of a point: vectors are contiguous floats. */
static nkw_motion component(const nkw_vec3_motion *p, size_t k)
{
    const float *c = (const float *)(const void *)p + k;
    nkw_motion r = {c[0], c[3], c[6]};
    return r;
}

static void set_component(nkw_vec3_motion *p, size_t k, nkw_motion x)
{
    float *c = (float *)(void *)p + k;
    c[0] = x.value;
    c[3] = x.velocity;
    c[6] = x.acceleration;
}

nkw_vec3_motion nkw_vec3_cubic_evaluate(const nkw_vec3_cubic *cubic, float t, nkw_cubic_kind kind)
{
    nkw_vec3_motion r;
    for (size_t k = 0; k < 3; k++) {
        const float *c = (const float *)(const void *)cubic + k, of[4] = {c[0], c[3], c[6], c[9]};
        set_component(&r, k, nkw_cubic_evaluate(of, t, kind));
    }
    return r;
}

/* The value minus that of the end nearer to t: p1 if `last` is not 0, otherwise p0; see nkw_quintic_evaluate. */
static double quintic_value(nkw_motion p0, nkw_motion p1, double f, double t, int last)
{
    double s = 1.0 - t, ss = s * s, tt = t * t;
    double line = last ? -(s * ss) * (10.0 - s * (15.0 - 6.0 * s)) : (t * tt) * (10.0 - t * (15.0 - 6.0 * t));
    double velocity =
        (t * ss) * (s * (1.0 + 3.0 * t)) * (double)p0.velocity - (s * tt) * (t * (1.0 + 3.0 * s)) * (double)p1.velocity;
    return line * f + (velocity + (0.5 * (tt * ss)) * (s * (double)p0.acceleration + t * (double)p1.acceleration));
}

static double quintic_first(nkw_motion p0, nkw_motion p1, double f, double t)
{
    double s = 1.0 - t, ts = t * s;
    double velocity = (s * s) * (1.0 + t * (2.0 - 15.0 * t)) * (double)p0.velocity +
                      (t * t) * (1.0 + s * (2.0 - 15.0 * s)) * (double)p1.velocity;
    double acceleration = s * (2.0 - 5.0 * t) * (double)p0.acceleration - t * (2.0 - 5.0 * s) * (double)p1.acceleration;
    return (30.0 * (ts * ts)) * f + (velocity + (0.5 * ts) * acceleration);
}

static double quintic_second(nkw_motion p0, nkw_motion p1, double f, double t)
{
    double s = 1.0 - t, ts = t * s;
    double velocity = (3.0 - 5.0 * t) * (double)p0.velocity - (3.0 - 5.0 * s) * (double)p1.velocity;
    double acceleration =
        s * (1.0 + t * (10.0 * t - 8.0)) * (double)p0.acceleration + t * (1.0 + s * (10.0 * s - 8.0)) * (double)p1.acceleration;
    return (60.0 * ts) * ((s - t) * f) + (acceleration - (12.0 * ts) * velocity);
}

nkw_motion nkw_quintic_evaluate(nkw_motion p0, nkw_motion p1, float t)
{
    int last = t >= 0.5f;
    double f = (double)p1.value - (double)p0.value, end = last ? p1.value : p0.value;
    nkw_motion r = {(float)(end + quintic_value(p0, p1, f, t, last)), (float)quintic_first(p0, p1, f, t),
                    (float)quintic_second(p0, p1, f, t)};
    return r;
}

nkw_vec3_motion nkw_vec3_quintic_evaluate(const nkw_vec3_motion *p0, const nkw_vec3_motion *p1, float t)
{
    nkw_vec3_motion r;
    for (size_t k = 0; k < 3; k++)
        set_component(&r, k, nkw_quintic_evaluate(component(p0, k), component(p1, k), t));
    return r;
}
