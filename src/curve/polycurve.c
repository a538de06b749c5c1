/* SPDX-License-Identifier: MIT */
#include "polycurve_slopes.h"

#include "lane/scalar.h"

/* Intervals of 2^-POLYCURVE_LEVELS are not halved. */
#define POLYCURVE_LEVELS 22
/* The lengths of both halves and of the whole interval agree to within this times largest_length. */
#define POLYCURVE_TOLERANCE 0x1p-44
/* Steps of Newton's method or of bisection: enough for bisection alone. */
#define POLYCURVE_STEPS 48

/* |p'(t)|. */
static double speed(const polycurve_slopes *a, double t)
{
    return lane_f64_vec3_length(polycurve_first(a, t));
}

/* The integral of |p'| from a to b by 8 points: exact for polynomials of degree 15. */
static double gauss(const polycurve_slopes *c, double a, double b)
{
    static const double at[4] = {0.18343464249564980494, 0.52553240991632898582, 0.79666647741362673959,
                                 0.96028985649753623168};
    static const double weight[4] = {0.36268378337836198297, 0.31370664587788728734, 0.22238103445337447054,
                                     0.10122853629037625915};
    double middle = 0.5 * (a + b), half = 0.5 * (b - a), sum = 0.0;
    for (size_t i = 4; i-- > 0;)
        sum += weight[i] * (speed(c, middle - half * at[i]) + speed(c, middle + half * at[i]));
    return half * sum;
}

/* A length that the one from a to b does not exceed by much, for the size of rounding errors: |p'| grows like t^2. */
static double largest_length(const polycurve_slopes *c, double a, double b)
{
    double reach = 1.0 + (lane_abs64(a) + lane_abs64(b));
    return polycurve_size(c) * (reach * reach) * lane_abs64(b - a);
}

/*
 * The length from a to b, to within `most`, where |p'| has no minimum between them. Interval i of level l is
 * [i, i + 1] 2^-l of the whole; an interval that is done is followed by the next one, at the level of which it is the
 * start.
 */
static double piece(const polycurve_slopes *c, double a, double b, double most)
{
    double sum = 0.0, width = b - a;
    unsigned level = 0, i = 0;
    do {
        double low = a + width * (double)i, high = a + width * ((double)i + 1.0), middle = 0.5 * (low + high);
        double halves = gauss(c, low, middle) + gauss(c, middle, high);
        if (level < POLYCURVE_LEVELS && lane_abs64(halves - gauss(c, low, high)) > most) {
            level++;
            i *= 2;
            width *= 0.5;
            continue;
        }
        sum += halves;
        i++;
        while (level > 0 && i % 2 == 0) {
            level--;
            i /= 2;
            width *= 2.0;
        }
    } while (level > 0);
    return sum;
}

/* p'.p'', half the derivative of |p'|^2. */
static double growth(const polycurve_slopes *c, double t)
{
    return lane_f64_vec3_dot(polycurve_first(c, t), polycurve_second(c, t));
}

/* Its derivative |p''|^2 + p'.p'''. */
static double growth_rate(const polycurve_slopes *c, double t)
{
    lane_f64_vec3 second = polycurve_second(c, t);
    return lane_f64_vec3_dot(second, second) + lane_f64_vec3_dot(polycurve_first(c, t), polycurve_third(c));
}

/* The zero of a growth that rises from low to high, to 2^-30 of the interval. */
static double standstill(const polycurve_slopes *c, double low, double high)
{
    double t = 0.5 * (low + high), step = high - low, least = 0x1p-30 * step;
    for (int i = 0; i < POLYCURVE_STEPS && lane_abs64(step) > least; i++) {
        double g = growth(c, t), next = t - g / growth_rate(c, t);
        low = g > 0.0 ? low : t;
        high = g > 0.0 ? t : high;
        next = next >= low && next <= high ? next : 0.5 * (low + high);
        step = next - t;
        t = next;
    }
    return t;
}

/* A segment, and the minima of |p'| in an interval of it, in order. */
typedef struct divided {
    polycurve_slopes c;
    double at[2];
    size_t count;
} divided;

/*
 * The minima of |p'| between low and high, in order; there are two at most. Half the derivative of |p'|^2 is a cubic
 * whose derivative is a parabola, least at m and negative within w of it:
 *
 *     |p''|^2 + p'.p''' = 3/2 |p'''|^2 ((t - m)^2 - w^2),     m = -p''(0).p'''/|p'''|^2
 *
 * So the cubic rises up to m - w, and from m + w on, and has at most one zero in each of these intervals.
 */
static divided divided_between(const polycurve_slopes *c, double low, double high)
{
    divided r = {*c, {0.0, 0.0}, 0};
    lane_f64_vec3 third = polycurve_third(c);
    double n2 = lane_f64_vec3_dot(third, third), m = low, w = 0.0;
    if (n2 > 0.0) {
        m = -lane_f64_vec3_dot(polycurve_second(c, 0.0), third) / n2;
        double w2 = growth_rate(c, m) / (-1.5 * n2);
        w = w2 > 0.0 ? lane_sqrt64(w2) : 0.0;
    }
    double end = m - w < high ? m - w : high, begin = m + w > low ? m + w : low;
    if (low < end && growth(c, low) < 0.0 && growth(c, end) >= 0.0)
        r.at[r.count++] = standstill(c, low, end);
    if (begin < high && growth(c, begin) < 0.0 && growth(c, high) > 0.0)
        r.at[r.count++] = standstill(c, begin, high);
    return r;
}

/*
 * The length from a to b, which lie in the interval. |p'| bends sharply only at its minima, near cusps and where the
 * point turns back on a line; an interval that has one inside may hide it between the 24 points of both rules.
 */
static double arc(const divided *d, double a, double b)
{
    double low = b < a ? b : a, high = b < a ? a : b, sum = 0.0;
    double most = POLYCURVE_TOLERANCE * largest_length(&d->c, low, high);
    for (size_t i = 0; i < d->count; i++) {
        if (d->at[i] > low && d->at[i] < high) {
            sum += piece(&d->c, low, d->at[i], most);
            low = d->at[i];
        }
    }
    sum += piece(&d->c, low, high, most);
    return b < a ? -sum : sum;
}

float nkw_vec3_cubic_length(const nkw_vec3_cubic *cubic, float from, float to, nkw_cubic_kind kind)
{
    polycurve_slopes c = polycurve_slopes_of(kind, cubic);
    divided d = divided_between(&c, from < to ? from : to, from < to ? to : from);
    return (float)arc(&d, from, to);
}

nkw_vec3_motion nkw_polycurve_evaluate(const nkw_polycurve *curve, nkw_segment at)
{
    const nkw_vec3_motion none = {{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}};
    size_t last = curve->count - 1;
    if (curve->count == 0)
        return none;
    return nkw_vec3_cubic_evaluate(&curve->cubics[at.index < last ? at.index : last], at.t, curve->kind);
}

nkw_result nkw_polycurve_measure(const nkw_polycurve *curve, size_t steps, float *lengths, size_t length_count)
{
    if (curve->count == 0 || steps == 0)
        return NKW_EMPTY;
    if (length_count == 0 || (length_count - 1) / steps < curve->count)
        return NKW_TOO_SMALL;
    nkw_result result = NKW_OK;
    double sum = 0.0;
    lengths[0] = 0.0f;
    for (size_t k = 0; k < curve->count; k++) {
        polycurve_slopes c = polycurve_slopes_of(curve->kind, &curve->cubics[k]);
        divided d = divided_between(&c, 0.0, 1.0);
        for (size_t i = 0; i < steps; i++) {
            if (result == NKW_OK)
                sum += arc(&d, (double)i / (double)steps, (double)(i + 1) / (double)steps);
            if (!(sum <= (double)FLT_MAX))
                result = NKW_NOT_FINITE;
            lengths[k * steps + i + 1] = result == NKW_OK ? (float)sum : lengths[k * steps + i];
        }
    }
    return result;
}

/* The t in low..high with L(t) - L(low) = length, from a first guess; within `most`, or to 2^-40 of the bracket. */
static double at_length(const polycurve_slopes *c, double low, double high, double guess, double length, double most)
{
    divided d = divided_between(c, low, high);
    double start = low, t = guess;
    for (int i = 0; i < POLYCURVE_STEPS && high - low > 0x1p-40; i++) {
        double error = arc(&d, start, t) - length, next = t - error / speed(c, t);
        if (lane_abs64(error) <= most)
            break;
        if (error > 0.0)
            high = t;
        else
            low = t;
        t = next > low && next < high ? next : 0.5 * (low + high);
    }
    return t;
}

nkw_segment nkw_polycurve_at_length(const nkw_polycurve *curve, const float *lengths, size_t length_count, float length)
{
    nkw_segment at = {0, 0.0f};
    if (curve->count == 0 || length_count <= curve->count)
        return at;
    size_t steps = (length_count - 1) / curve->count, count = curve->count * steps;
    nkw_segment found = nkw_segment_find(lengths, count + 1, length);
    at.index = found.index / steps;
    at.t = found.t;
    if (found.t > 0.0f || found.index % steps > 0) {
        polycurve_slopes c = polycurve_slopes_of(curve->kind, &curve->cubics[at.index]);
        double low = (double)(found.index % steps) / (double)steps,
               high = (double)(found.index % steps + 1) / (double)steps;
        double guess = low + (double)found.t * (high - low), most = 0x1p-28 * (double)lengths[count];
        double rest = (double)length - (double)lengths[found.index];
        if (found.t > 0.0f && found.t < 1.0f)
            guess = at_length(&c, low, high, guess, rest, most);
        at.t = (float)guess;
    }
    return at;
}
