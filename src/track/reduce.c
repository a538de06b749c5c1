/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/quat.h>
#include <nakawari/reduce.h>
#include <nakawari/scalar.h>

#include "difference.h"
#include "lane/f64.h"
#include "lane/scalar.h"
#include "track_keys.h"

#define LEAST_COSINE 1e-3
#define MARGIN       (17.0 / 16.0) /* of an angle that is measured at the quarters of a segment */

/* ---- what a segment must not contain ---- */

/* Whether all values are equal; for CUBICSPLINE also the inner tangents 0. */
static int are_equal(const nkw_track *t, size_t a, size_t b)
{
    const float *x = track_value_at(t, a), *y = track_value_at(t, b);
    int cubic = track_interpolation_at(t, a) == NKW_INTERPOLATION_CUBICSPLINE, equal = 1;
    for (size_t i = 0; equal && i < t->width; i++)
        equal = x[i] == y[i] && (!cubic || (x[t->width + i] == 0.0f && y[(ptrdiff_t)i - (ptrdiff_t)t->width] == 0.0f));
    return equal;
}

static int is_jump(const nkw_track *t, size_t k)
{
    const float *x = track_value_at(t, k), *y = x + track_key_size(t);
    int equal = 1;
    for (size_t i = 0; equal && i < t->width; i++)
        equal = x[i] == y[i];
    return t->times[k] == t->times[k + 1] && !equal;
}

static double cosine(const float *a, const float *b)
{
    return ((double)a[0] * (double)b[0] + (double)a[1] * (double)b[1]) +
           ((double)a[2] * (double)b[2] + (double)a[3] * (double)b[3]);
}

/* Whether the keys between a and b may be removed, whatever the tolerance. A duration is a float for CUBICSPLINE. */
static int is_one_way(const nkw_track *t, size_t a, size_t b)
{
    const nkw_interpolation mode = track_interpolation_at(t, a);
    double sign = 1.0;
    if (mode == NKW_INTERPOLATION_CUBICSPLINE && !lane_is_finite(t->times[b] - t->times[a]))
        return 0;
    for (size_t k = a; k < b; k++) {
        const float *q = track_value_at(t, k), *next = track_value_at(t, k + 1);
        if (track_interpolation_at(t, k) != mode || is_jump(t, k))
            return 0;
        if (!track_is_rotation(t) || mode == NKW_INTERPOLATION_STEP)
            continue;
        sign = mode == NKW_INTERPOLATION_LINEAR && cosine(q, next) < 0.0 ? -sign : sign;
        if (!(sign * cosine(track_value_at(t, a), next) > LEAST_COSINE))
            return 0;
    }
    return 1;
}

/* ---- the error of numbers: the difference of two cubics ---- */

/* A cubic over 0..1: values and slopes at both ends. */
typedef struct cubic64 {
    double p0, m0, p1, m1;
} cubic64;

static cubic64 cubic_of(const nkw_track *t, size_t a, size_t b, size_t i)
{
    const float *x = track_value_at(t, a) + i, *y = track_value_at(t, b) + i;
    const double duration = (double)t->times[b] - (double)t->times[a], p0 = (double)*x, p1 = (double)*y;
    const nkw_interpolation mode = track_interpolation_at(t, a);
    cubic64 r = {p0, p1 - p0, p1, p1 - p0};
    if (mode == NKW_INTERPOLATION_STEP)
        r.p1 = p0, r.m0 = r.m1 = 0.0;
    if (mode == NKW_INTERPOLATION_CUBICSPLINE) {
        r.m0 = duration * (double)x[t->width];
        r.m1 = duration * (double)*(y - t->width);
    }
    return r;
}

/* c0 + c1 u + c2 u^2 + c3 u^3 */
static void coefficients(const cubic64 *h, double c[4])
{
    const double d = h->p1 - h->p0;
    c[0] = h->p0;
    c[1] = h->m0;
    c[2] = (3.0 * d - 2.0 * h->m0) - h->m1;
    c[3] = (h->m0 + h->m1) - 2.0 * d;
}

static double value_at(const double c[4], double u)
{
    return ((c[3] * u + c[2]) * u + c[1]) * u + c[0];
}

static double slope_at(const double c[4], double u)
{
    return (3.0 * c[3] * u + 2.0 * c[2]) * u + c[1];
}

/* The part of the cubic from u to v. */
static cubic64 part_of(const cubic64 *h, double u, double v)
{
    double c[4];
    coefficients(h, c);
    cubic64 r = {value_at(c, u), (v - u) * slope_at(c, u), value_at(c, v), (v - u) * slope_at(c, v)};
    return r;
}

static double larger(double a, double b)
{
    return b > a ? b : a;
}

/* The magnitude of the cubic at u = n/d, if this is in 0..1. */
static double inner_size(const double c[4], double n, double d)
{
    const double u = n / lane_divisor64(d);
    return d != 0.0 && u > 0.0 && u < 1.0 ? lane_abs64(value_at(c, u)) : 0.0;
}

/*
 * max |cubic| over 0..1: at the ends, and where 3 c3 u^2 + 2 c2 u + c1 = 0:
 *
 *     s = -(c2 + sign(c2) sqrt(c2^2 - 3 c3 c1)),  u = s / (3 c3), c1 / s
 */
static double largest_of(const cubic64 *h)
{
    double c[4], largest = larger(lane_abs64(h->p0), lane_abs64(h->p1));
    coefficients(h, c);
    double under = c[2] * c[2] - 3.0 * (c[3] * c[1]);
    if (!(under > 1e-290))
        return largest;
    double s = -(c[2] + lane_copysign64(lane_sqrt64(under), c[2]));
    return larger(larger(largest, inner_size(c, s, 3.0 * c[3])), inner_size(c, c[1], s));
}

/* The largest difference of component i in segment k of the source from the segment a..b. */
static double number_error(const nkw_track *t, const cubic64 *whole, size_t a, size_t b, size_t k, size_t i)
{
    const double start = (double)t->times[a], duration = (double)t->times[b] - start;
    const double u = ((double)t->times[k] - start) / duration, v = ((double)t->times[k + 1] - start) / duration;
    const cubic64 want = cubic_of(t, k, k + 1, i);
    cubic64 d = part_of(whole, u, v);
    d.p0 -= want.p0, d.m0 -= want.m0, d.p1 -= want.p1, d.m1 -= want.m1;
    return largest_of(&d);
}

/*
 * Whether samples of the segment do not overflow. nkw_lerp computes p1 - p0, the Hermite curve up to 6 times the largest
 * of this and of both tangents.
 */
static int is_in_range(const nkw_track *t, const cubic64 *whole)
{
    const double most = track_is_cubic(t) ? 0x1p125 : (double)FLT_MAX;
    return lane_abs64(whole->p1 - whole->p0) <= most && lane_abs64(whole->m0) <= most && lane_abs64(whole->m1) <= most;
}

static double numbers_error(const nkw_track *t, size_t a, size_t b, double tolerance)
{
    double largest = 0.0;
    for (size_t i = 0; i < t->width && largest <= tolerance; i++) {
        const cubic64 whole = cubic_of(t, a, b, i);
        if (!is_in_range(t, &whole))
            return INFINITY;
        for (size_t k = a; k < b && largest <= tolerance; k++)
            if (t->times[k] < t->times[k + 1])
                largest = larger(largest, number_error(t, &whole, a, b, k, i));
    }
    return largest;
}

/* ---- the error of rotations ---- */

/* Keys a and b as a track of two keys. */
typedef struct two_keys {
    float times[2], values[24];
    unsigned char modes[2];
    nkw_track track;
} two_keys;

static void set_two_keys(const nkw_track *t, size_t a, size_t b, two_keys *two)
{
    const size_t size = track_key_size(t);
    two->track = *t;
    two->times[0] = t->times[a], two->times[1] = t->times[b];
    memcpy(two->values, t->values + size * a, size * sizeof(float));
    memcpy(two->values + size, t->values + size * b, size * sizeof(float));
    two->modes[0] = two->modes[1] = (unsigned char)track_interpolation_at(t, a);
    two->track.times = two->times;
    two->track.values = two->values;
    two->track.key_interpolation = two->modes;
    two->track.count = 2;
}

static double turn_error(const nkw_track *t, const two_keys *two, size_t k, int quarter)
{
    const float part = 0.25f * (float)quarter;
    const double start = (double)two->times[0], from = (double)t->times[k];
    const double time = from + (double)part * ((double)t->times[k + 1] - from);
    const nkw_segment whole = {0, (float)((time - start) / ((double)two->times[1] - start))}, segment = {k, part};
    nkw_quat got, want;
    nkw_track_sample_segment(&two->track, whole, &got.x);
    nkw_track_sample_segment(t, segment, &want.x);
    double angle = (double)nkw_quat_angle(got, want);
    return angle >= 0.0 ? angle : INFINITY; /* infinite for NaN: tangents whose sums overflow */
}

/* At the keys first: most segments that are too long fail there. */
static double turns_error(const nkw_track *t, size_t a, size_t b, double tolerance)
{
    static const int order[DIFFERENCE_QUARTERS] = {0, 2, 1, 3};
    two_keys two;
    double largest = 0.0;
    set_two_keys(t, a, b, &two);
    for (int i = 0; i < DIFFERENCE_QUARTERS; i++)
        for (size_t k = a; k < b && largest <= tolerance; k++)
            if (t->times[k] < t->times[k + 1])
                largest = larger(largest, turn_error(t, &two, k, order[i]));
    return largest;
}

/* ---- the longest segments ---- */

/* The error of the segment a..b in place of those of the source; infinity if it is not allowed. */
static double segment_error(const nkw_track *t, size_t a, size_t b, double tolerance)
{
    int equal = 1, is_step = track_interpolation_at(t, a) == NKW_INTERPOLATION_STEP;
    if (b == a + 1)
        return 0.0;
    if (!is_one_way(t, a, b))
        return INFINITY;
    for (size_t k = a; equal && k + (is_step ? 1u : 0u) < b; k++)
        equal = are_equal(t, k, k + 1);
    if (equal || tolerance == 0.0)
        return equal ? 0.0 : INFINITY;
    return track_is_rotation(t) ? turns_error(t, a, b, tolerance / MARGIN) : numbers_error(t, a, b, tolerance);
}

static int is_within(const nkw_track *t, double error, double tolerance)
{
    return track_is_rotation(t) ? error * MARGIN <= tolerance : error <= tolerance;
}

/* The next key to keep after key a. Adds the error of the segment. */
static size_t next_kept(const nkw_track *t, size_t a, double tolerance, double *largest)
{
    const size_t last = t->count - 1;
    size_t good = a + 1, bad = last + 1;
    double error = 0.0;
    for (size_t length = 2; good < last && bad > last; length *= 2) {
        size_t b = last - a < length ? last : a + length;
        double e = segment_error(t, a, b, tolerance);
        if (is_within(t, e, tolerance))
            good = b, error = e;
        else
            bad = b;
    }
    while (bad - good > 1 && bad <= last) {
        size_t b = good + (bad - good) / 2;
        double e = segment_error(t, a, b, tolerance);
        if (is_within(t, e, tolerance))
            good = b, error = e;
        else
            bad = b;
    }
    *largest = larger(*largest, error);
    return good;
}

static void copy_key(const nkw_track *t, size_t from, nkw_track_span span, size_t to)
{
    const size_t size = track_key_size(t);
    span.times[to] = t->times[from];
    memcpy(span.values + size * to, t->values + size * from, size * sizeof(float));
    if (t->key_interpolation)
        span.key_interpolation[to] = t->key_interpolation[from];
}

static double reduce(const nkw_track *t, double tolerance, nkw_track_span span, size_t *count)
{
    double largest = 0.0;
    size_t k = 0, n = 0;
    copy_key(t, 0, span, n++);
    while (k + 1 < t->count) {
        k = next_kept(t, k, tolerance, &largest);
        copy_key(t, k, span, n++);
    }
    *count = n;
    return largest;
}

nkw_result nkw_track_reduce(const nkw_track *track, float tolerance, nkw_track_span span, nkw_track *out,
                            float *difference)
{
    const nkw_track source = *track;
    nkw_result result = nkw_track_validate(&source, NULL);
    double worst = INFINITY;
    size_t count = 0;
    if (result == NKW_OK && !(tolerance >= 0.0f && lane_is_finite(tolerance)))
        result = NKW_OUT_OF_RANGE;
    if (result == NKW_OK &&
        (span.key_capacity < source.count || (source.key_interpolation && !span.key_interpolation)))
        result = NKW_TOO_SMALL;
    if (result == NKW_OK)
        worst = reduce(&source, (double)tolerance, span, &count);
    *out = source;
    out->times = span.times;
    out->values = span.values;
    out->key_interpolation = source.key_interpolation ? span.key_interpolation : NULL;
    out->count = count;
    if (difference)
        *difference = (float)worst;
    return result;
}
