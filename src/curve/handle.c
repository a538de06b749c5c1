/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <math.h>

#include <nakawari/handle.h>

#include "handle_solve.h"
#include "lane/scalar.h"

static int has_finite_times(const nkw_handle_segment *s)
{
    return lane_is_finite(s->time0) && lane_is_finite(s->time1) && lane_is_finite(s->out.time) &&
           lane_is_finite(s->in.time);
}

/* The parameter of a time in the closed segment; of finite times. */
static double parameter_at(const handle_cubic *c, const nkw_handle_segment *s, float time)
{
    if (time <= s->time0)
        return 0.0;
    return time < s->time1 ? handle_parameter(c, (double)time - (double)s->time0) : 1.0;
}

nkw_motion nkw_handle_sample(const nkw_handle_segment *segment, float time)
{
    handle_cubic c = handle_cubic_of(segment);
    nkw_motion none = {NAN, NAN, NAN},
                    held = {time < segment->time1 ? segment->value0 : segment->value1, 0.0f, 0.0f};
    if (time != time || !has_finite_times(segment))
        return none;
    if (!(c.h > 0.0) || time < segment->time0 || time > segment->time1)
        return held;
    return handle_rounded(handle_point_at(&c, parameter_at(&c, segment, time)));
}

float nkw_handle_parameter(const nkw_handle_segment *segment, float time)
{
    handle_cubic c = handle_cubic_of(segment);
    if (time != time || !has_finite_times(segment))
        return NAN;
    if (!(c.h > 0.0))
        return time < segment->time1 ? 0.0f : 1.0f;
    return (float)parameter_at(&c, segment, time);
}

int nkw_handle_runs_back(const nkw_handle_segment *segment)
{
    handle_cubic c = handle_cubic_of(segment);
    return handle_runs_back(&c);
}

/* The handle with another time and the same slope. A vertical one stays. */
static nkw_handle with_time(nkw_handle handle, float time)
{
    nkw_handle r = {time, handle.value};
    if (handle.time != 0.0f && handle.time != time)
        r.value = (float)((double)handle.value * ((double)time / (double)handle.time));
    return r;
}

static void set_lengths(nkw_handle_segment *s, float p, float q)
{
    s->out = with_time(s->out, p);
    s->in = with_time(s->in, -q);
}

/* The largest float that is not greater than x, positive. */
static float rounded_down(double x)
{
    float r = (float)x;
    return (double)r > x ? lane_float(lane_bits(r) - 1u) : r;
}

static void contain(nkw_handle_segment *s, const handle_cubic *c)
{
    float longest = rounded_down(c->h);
    set_lengths(s, c->p > c->h ? longest : (float)c->p, c->q > c->h ? longest : (float)c->q);
}

/* Positive lengths for which time does not run back, at most four ULPs from p, q; or contained ones. */
static void set_limited(nkw_handle_segment *s, float p, float q, int32_t p_step, int32_t q_step)
{
    nkw_handle_segment tried = *s;
    for (uint32_t i = 0; i < 5; i++) {
        tried.out.time = lane_float(lane_bits(p) + i * (uint32_t)p_step);
        tried.in.time = -lane_float(lane_bits(q) + i * (uint32_t)q_step);
        if (!nkw_handle_runs_back(&tried)) {
            set_lengths(s, tried.out.time, -tried.in.time);
            return;
        }
    }
    handle_cubic c = handle_cubic_of(s);
    contain(s, &c);
}

/* The ray through (p, q) meets the ellipse at the factor (p + q + sqrt(p q))/(p^2 + p q + q^2). */
static void keep_ratio(nkw_handle_segment *s, const handle_cubic *c)
{
    double p = c->p / c->h, q = c->q / c->h;
    double factor = c->h * (((p + q) + lane_sqrt64(p * q)) / ((p * p + p * q) + q * q));
    set_limited(s, rounded_down(factor * p), rounded_down(factor * q), p > 0.0 ? -1 : 0, q > 0.0 ? -1 : 0);
}

/* The ellipse has q = (2 - p +- sqrt(p (4 - 3 p)))/2: the branch nearer to q is taken. */
static void keep_start(nkw_handle_segment *s, const handle_cubic *c)
{
    double p = c->p / c->h, q = c->q / c->h, middle = 0.5 * (2.0 - p), square = p * (4.0 - 3.0 * p);
    double half = 0.5 * lane_sqrt64(square > 0.0 ? square : 0.0);
    if (p >= 4.0 / 3.0)
        set_limited(s, rounded_down(c->h * (4.0 / 3.0)), rounded_down(c->h / 3.0), -1, 0);
    else if (q > middle)
        set_limited(s, s->out.time, rounded_down(c->h * (middle + half)), 0, -1);
    else
        set_limited(s, s->out.time, (float)(c->h * (middle - half)), 0, 1);
}

static void turn_outside_handles_off(nkw_handle_segment *s)
{
    const nkw_handle none = {0.0f, 0.0f};
    s->out = s->out.time < 0.0f ? none : s->out;
    s->in = s->in.time > 0.0f ? none : s->in;
}

nkw_handle_segment nkw_handle_limit(const nkw_handle_segment *segment, nkw_handle_policy policy)
{
    nkw_handle_segment s = *segment;
    int is_known = policy == NKW_HANDLE_CONTAIN || policy == NKW_HANDLE_KEEP_RATIO || policy == NKW_HANDLE_KEEP_START;
    if (!is_known || !has_finite_times(&s) || !(s.time0 < s.time1))
        return s;
    turn_outside_handles_off(&s);
    handle_cubic c = handle_cubic_of(&s);
    if (policy == NKW_HANDLE_CONTAIN)
        contain(&s, &c);
    else if (handle_runs_back(&c) && policy == NKW_HANDLE_KEEP_RATIO)
        keep_ratio(&s, &c);
    else if (handle_runs_back(&c))
        keep_start(&s, &c);
    return s;
}

/* One coordinate, relative to the first key: the handles of both halves, relative to their keys. */
typedef struct split_handles {
    double left_out, left_in, right_out, right_in;
} split_handles;

static split_handles split_at(double length, double out, double in, double s)
{
    double r = 1.0 - s, end = length - in;
    double middle = r * out + s * end, before = r * (s * out) + s * middle, after = r * middle + s * (length - r * in);
    double point = r * before + s * after;
    split_handles h = {s * out, before - point, after - point, -r * in};
    return h;
}

void nkw_handle_split(const nkw_handle_segment *segment, float time, nkw_handle_segment *left,
                      nkw_handle_segment *right)
{
    const nkw_handle_segment s = *segment;
    float clamped = time < s.time0 ? s.time0 : time > s.time1 ? s.time1 : time;
    handle_cubic c = handle_cubic_of(&s);
    double at = !(c.h > 0.0) || !has_finite_times(&s) || time != time ? 1.0 : parameter_at(&c, &s, clamped);
    split_handles x = split_at(c.h, c.p, c.q, at), y = split_at(c.v1 - c.v0, c.d0, c.d2, at);
    nkw_handle_segment a = s, b = s;
    a.time1 = b.time0 = clamped;
    a.value1 = b.value0 = nkw_handle_sample(&s, clamped).value;
    a.out = handle_from_f64(x.left_out, y.left_out);
    a.in = handle_from_f64(x.left_in, y.left_in);
    b.out = handle_from_f64(x.right_out, y.right_out);
    b.in = handle_from_f64(x.right_in, y.right_in);
    *left = a;
    *right = b;
}
