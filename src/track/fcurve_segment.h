/* SPDX-License-Identifier: MIT */
/* One segment of an fcurve, in binary64. */
#ifndef NAKAWARI_FCURVE_SEGMENT_H
#define NAKAWARI_FCURVE_SEGMENT_H

#include "lane/strict.h"

#include <nakawari/fcurve.h>

#include "curve/ease_point.h"
#include "curve/handle_solve.h"

static inline nkw_handle_segment fcurve_handles(const nkw_fcurve_key *key)
{
    nkw_handle_segment s = {key[0].time, key[0].value, key[0].out, key[1].in, key[1].time, key[1].value};
    return s;
}

/* The Bezier segment of two keys as the policy limits it. */
static inline handle_cubic fcurve_cubic(const nkw_fcurve_key *key, nkw_handle_policy policy)
{
    nkw_handle_segment s = fcurve_handles(key);
    s = nkw_handle_limit(&s, policy);
    return handle_cubic_of(&s);
}

/* 0 < x < h, the duration of the segment. */
static inline handle_point fcurve_bezier(const nkw_fcurve_key *key, nkw_handle_policy policy, double x)
{
    handle_cubic c = fcurve_cubic(key, policy);
    double s = x <= 0.0 ? 0.0 : x < c.h ? handle_parameter(&c, x) : 1.0;
    return handle_point_at(&c, s);
}

/* The derivative of an ease in `rise`; of none 0, also where the ease is vertical. */
static inline double fcurve_part(double rise, double slope)
{
    return rise == 0.0 ? 0.0 : rise * slope;
}

static inline handle_point fcurve_ease(const nkw_fcurve_key *key, double x, double h)
{
    handle_point e = nkwi_ease_point(key->ease, x / h);
    double rise = (double)key[1].value - (double)key[0].value;
    handle_point r = {(double)key->value + rise * e.value, fcurve_part(rise, e.first / h),
                      fcurve_part(rise, (e.second / h) / h)};
    return r;
}

/* The point x seconds after the first of two keys, 0 <= x <= h. The values of the keys at their times are exact. */
static inline handle_point fcurve_point(const nkw_fcurve_key *key, nkw_handle_policy policy, double x)
{
    double h = (double)key[1].time - (double)key[0].time, a = (double)key[0].value, b = (double)key[1].value;
    handle_point r = {x > 0.0 && key->kind == NKW_FCURVE_CONSTANT_NEXT ? b : a, 0.0, 0.0};
    if (h > 0.0 && key->kind == NKW_FCURVE_LINEAR) {
        r.value = a + (b - a) * (x / h);
        r.first = (b - a) / h;
    } else if (h > 0.0 && key->kind == NKW_FCURVE_BEZIER) {
        r = fcurve_bezier(key, policy, x);
    } else if (h > 0.0 && key->kind == NKW_FCURVE_EASE) {
        r = fcurve_ease(key, x, h);
    }
    r.value = x >= h ? b : x > 0.0 ? r.value : a;
    return r;
}

#endif
