/* SPDX-License-Identifier: MIT */
/* A cubic Bezier segment in the plane of time and value, in binary64. */
#ifndef NAKAWARI_HANDLE_SOLVE_H
#define NAKAWARI_HANDLE_SOLVE_H

#include "lane/strict.h"

#include <nakawari/handle.h>

#include "lane/f64.h"

/*
 * Time from the start, and value, by the parameter s in 0..1, with r = 1 - s:
 *
 *     time  = 3 p s r^2 + 3 (h - q) s^2 r + h s^3
 *     value = v0 r^3 + 3 (v0 + d0) s r^2 + 3 (v1 - d2) s^2 r + v1 s^3
 */
typedef struct handle_cubic {
    double h; /* the duration, positive */
    double p, q; /* the lengths of the handles in time, positive into the segment */
    double v0, v1; /* the values at the ends */
    double d0, d2; /* the value of the out-handle, and minus that of the in-handle */
} handle_cubic;

static inline handle_cubic handle_cubic_of(const nkw_handle_segment *s)
{
    handle_cubic c;
    c.h = (double)s->time1 - (double)s->time0;
    c.p = (double)s->out.time;
    c.q = -(double)s->in.time;
    c.v0 = (double)s->value0;
    c.v1 = (double)s->value1;
    c.d0 = (double)s->out.value;
    c.d2 = -(double)s->in.value;
    return c;
}

static inline nkw_handle handle_from_f64(double time, double value)
{
    nkw_handle r = {(float)time, (float)value};
    return r;
}

static inline double handle_time(const handle_cubic *c, double s)
{
    double r = 1.0 - s;
    return s * ((3.0 * c->p) * (r * r) + s * ((3.0 * (c->h - c->q)) * r + c->h * s));
}

static inline double handle_value(const handle_cubic *c, double s)
{
    double r = 1.0 - s, rr = r * r, ss = s * s;
    return (c->v0 * (rr * r) + (3.0 * (c->v0 + c->d0)) * (rr * s)) +
           ((3.0 * (c->v1 - c->d2)) * (r * ss) + c->v1 * (ss * s));
}

/* A cubic polynomial's first, second and third derivative by s, from the differences of its Bezier control values. */
typedef struct handle_rates {
    double first, second, third;
} handle_rates;

static inline handle_rates handle_rates_of(double a, double b, double c, double s)
{
    double r = 1.0 - s;
    handle_rates d = {3.0 * ((a * (r * r) + (2.0 * b) * (r * s)) + c * (s * s)), 6.0 * ((b - a) * r + (c - b) * s),
                      6.0 * ((c - 2.0 * b) + a)};
    return d;
}

static inline handle_rates handle_time_rates(const handle_cubic *c, double s)
{
    return handle_rates_of(c->p, (c->h - c->p) - c->q, c->q, s);
}

static inline handle_rates handle_value_rates(const handle_cubic *c, double s)
{
    return handle_rates_of(c->d0, ((c->v1 - c->v0) - c->d2) - c->d0, c->d2, s);
}

/*
 * The derivative of time by s is 3 (p r^2 + 2 b r s + q s^2), b = h - p - q. Where that has real roots, with
 * e = sqrt(b^2 - p q), time turns from falling to rising at s/r = (e - b)/q = -p/(e + b), and from rising to falling at
 * s/r = p/(e - b) = -(e + b)/q: the form without a difference of numbers of equal sign is computed.
 */
typedef struct handle_turns {
    double rising, falling;
} handle_turns;

static inline handle_turns handle_turns_of(const handle_cubic *c, double b)
{
    double e = lane_sqrt64(b * b - c->p * c->q);
    handle_turns t;
    t.rising = b < 0.0 ? (e - b) / ((e - b) + c->q) : c->p / (c->p - (e + b));
    t.falling = b < 0.0 ? c->p / (c->p + (e - b)) : (e + b) / ((e + b) - c->q);
    return t;
}

static inline int handle_runs_back(const handle_cubic *c)
{
    double b = (c->h - c->p) - c->q;
    return c->h > 0.0 && (c->p < 0.0 || c->q < 0.0 || (b < 0.0 && b * b > c->p * c->q));
}

/* The interval of s in which time rises, and first reaches x, 0 < x < h. */
typedef struct handle_bracket {
    double low, high;
} handle_bracket;

static inline handle_bracket handle_bracket_of(const handle_cubic *c, double x)
{
    handle_bracket k = {0.0, 1.0};
    if (!handle_runs_back(c))
        return k;
    handle_turns turns = handle_turns_of(c, (c->h - c->p) - c->q);
    if (c->p < 0.0)
        k.low = turns.rising;
    if (c->q < 0.0)
        k.high = turns.falling;
    if (c->p < 0.0 || c->q < 0.0)
        return k;
    if (x <= handle_time(c, turns.falling))
        k.high = turns.falling;
    else
        k.low = turns.rising;
    return k;
}

/* More than the steps of any float times: at most 159 were found, for p = 0, q = h, x near 2^-149 h; 3 are the mean. */
#define HANDLE_STEPS 256

/*
 * Halley's step from s, where time is off by f: to the root of the hyperbola that has time's value and two derivatives,
 *
 *     step = f t' / (t'^2 - f t''/2)
 *
 * which leaves an error of at most about |step|^3 (t''^2/4 + |t' t'''|/6)/t'^2. is_last where that is below 2^-54 s.
 */
typedef struct handle_step {
    double to;
    int is_last;
} handle_step;

static inline handle_step handle_step_from(handle_rates t, double f, double s)
{
    double square = t.first * t.first, scale = square - 0.5 * (f * t.second), step = f * t.first / scale;
    double bend = 0.25 * (t.second * t.second) + (1.0 / 6.0) * lane_abs64(t.first * t.third);
    handle_step r = {s - step, lane_abs64(step * step * step) * bend <= 0x1p-54 * (s * square)};
    return r;
}

/*
 * The least s at which time is x, 0 < x < h. Halley's steps, and bisection where a step would leave the bracket or is
 * no number. To a root of third order each step halves the distance.
 */
static inline double handle_parameter(const handle_cubic *c, double x)
{
    handle_bracket k = handle_bracket_of(c, x);
    double s = x / c->h;
    s = s > k.low && s < k.high ? s : k.low + 0.5 * (k.high - k.low);
    for (int i = 0; i < HANDLE_STEPS; i++) {
        double f = handle_time(c, s) - x;
        if (f == 0.0)
            return s;
        handle_step next = handle_step_from(handle_time_rates(c, s), f, s);
        if (f < 0.0)
            k.low = s;
        else
            k.high = s;
        if (!(next.to > k.low && next.to < k.high)) {
            next.to = k.low + 0.5 * (k.high - k.low);
            next.is_last = 0;
        }
        if (next.is_last || lane_abs64(next.to - s) <= 0x1p-52 * s)
            return next.to;
        s = next.to;
    }
    return s;
}

/* n/d of d >= 0, with infinities for d = 0; 0/0 is 0. */
static inline double handle_quotient(double n, double d)
{
    if (d != 0.0)
        return n / d;
    return n > 0.0 ? (double)INFINITY : n < 0.0 ? -(double)INFINITY : n == 0.0 ? 0.0 : n;
}

/*
 * Derivatives by time of value y and time x, from those by s:
 *
 *     first = y'/x',     second = (y'' x' - y' x'')/x'^3
 *
 * Where x' = y' = 0, the limits: first = y''/x'', second 0 if (y''' x'' - y'' x''') = 0, otherwise infinite with its
 * sign. Where those are 0 too, first = y'''/x''', second = 0. At the end of a segment x'' < 0.
 */
static inline void handle_slopes(handle_rates x, handle_rates y, int at_end, double *first, double *second)
{
    double zero = 0.0;
    if (x.first != 0.0 || y.first != 0.0) {
        *first = handle_quotient(y.first, lane_abs64(x.first));
        *second = handle_quotient(y.second * x.first - y.first * x.second, lane_abs64((x.first * x.first) * x.first));
    } else if (x.second != 0.0 || y.second != 0.0) {
        double sign = at_end ? -1.0 : 1.0;
        *first = handle_quotient(sign * y.second, lane_abs64(x.second));
        *second = handle_quotient(y.third * x.second - y.second * x.third, zero);
    } else {
        *first = handle_quotient(x.third < 0.0 ? -y.third : y.third, lane_abs64(x.third));
        *second = 0.0;
    }
}

/* Value and derivatives by time before their rounding. */
typedef struct handle_point {
    double value, first, second;
} handle_point;

static inline handle_point handle_point_at(const handle_cubic *c, double s)
{
    handle_point r;
    handle_slopes(handle_time_rates(c, s), handle_value_rates(c, s), s > 0.5, &r.first, &r.second);
    r.value = s == 0.0 ? c->v0 : s == 1.0 ? c->v1 : handle_value(c, s);
    return r;
}

static inline nkw_motion handle_rounded(handle_point p)
{
    nkw_motion r = {(float)p.value, (float)p.first, (float)p.second};
    return r;
}

#endif
