/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/scalar.h>
#include <nakawari/spline.h>

#include "finite.h"
#include "lane/f64.h"
#include "lane/scalar.h"
#include "report.h"
#include "spline_c2.h"
#include "work.h"

/* ---- Validation ---- */

static nkw_result check_shape(const nkw_spline *s, size_t stride, nkw_work work)
{
    if (s->count == 0 || s->width == 0)
        return NKW_EMPTY;
    if ((unsigned)s->method > NKW_SPLINE_C2 || (unsigned)s->ends > NKW_SPLINE_ENDS_PERIODIC)
        return NKW_BAD_METHOD;
    if (s->stride < s->width || stride < s->width)
        return NKW_BAD_WIDTH;
    if (s->method == NKW_SPLINE_C2 && !work_fits_each(work, s->count, NKW_SPLINE_WORK(1)))
        return NKW_TOO_SMALL;
    return s->method == NKW_SPLINE_CARDINAL && !lane_is_finite(s->tension) ? NKW_NOT_FINITE : NKW_OK;
}

/* Whether the parameters and the given tangent of key k are finite. */
static int has_finite_parameters(const nkw_spline *s, size_t k)
{
    const nkw_tcb *tcb = s->method == NKW_SPLINE_TCB ? s->tcb : NULL;
    const float *ends = s->ends == NKW_SPLINE_ENDS_CLAMPED ? s->end_tangents : NULL;
    if (tcb && !are_finite(&tcb[k].tension, 3))
        return 0;
    if (ends && k == 0 && !are_finite(ends, s->width))
        return 0;
    return !(ends && k == s->count - 1) || are_finite(ends + s->width, s->width);
}

static nkw_result check_key(const nkw_spline *s, size_t k)
{
    if (!lane_is_finite(s->times[k]) || !are_finite(s->values + k * s->stride, s->width) ||
        !has_finite_parameters(s, k))
        return NKW_NOT_FINITE;
    return k > 0 && s->times[k] < s->times[k - 1] ? NKW_NOT_ASCENDING : NKW_OK;
}

/* ---- Knots ---- */

/* |values[k + 1] - values[k]|. */
static double distance(const nkw_spline *s, size_t k)
{
    const float *a = s->values + k * s->stride, *b = a + s->stride;
    double sum = 0.0;
    for (size_t c = 0; c < s->width; c++) {
        double d = (double)b[c] - (double)a[c];
        sum += d * d;
    }
    return lane_sqrt64(sum);
}

/* length^alpha; 0 for a length of 0. */
static double knot_step(double length, float alpha)
{
    if (alpha == 0.0f)
        return 1.0;
    if (!(length > 0.0))
        return 0.0;
    if (alpha == 1.0f)
        return length;
    return alpha == 0.5f ? lane_sqrt64(length) : (double)nkw_pow((float)length, alpha);
}

nkw_result nkw_spline_knots(const nkw_spline *spline, float alpha, float *knots)
{
    double sum = 0.0;
    if (spline->count == 0 || spline->width == 0)
        return NKW_EMPTY;
    if (spline->stride < spline->width)
        return NKW_BAD_WIDTH;
    if (!lane_is_finite(alpha))
        return NKW_NOT_FINITE;
    for (size_t k = 0; k < spline->count; k++) {
        knots[k] = spline_rounded(sum);
        if (k + 1 < spline->count)
            sum += knot_step(distance(spline, k), alpha);
    }
    return NKW_OK;
}

/* ---- Tangents of one key from its neighbours ---- */

/* Segments k - 2 .. k + 1 about key k: whether they exist, their first and last key, their duration and knot step. */
typedef struct stencil {
    int has[4];
    size_t key[4];
    double h[4], knot[4];
} stencil;

static stencil stencil_at(const spline_piece *p, size_t k)
{
    const nkw_spline *s = p->spline;
    int by_knots = s->method == NKW_SPLINE_CENTRIPETAL || s->method == NKW_SPLINE_CHORDAL;
    float alpha = s->method == NKW_SPLINE_CENTRIPETAL ? 0.5f : 1.0f;
    size_t at = k - p->first, n = p->last - p->first;
    stencil r = {{0, 0, 0, 0}, {0, 0, 0, 0}, {1.0, 1.0, 1.0, 1.0}, {0.0, 0.0, 0.0, 0.0}};
    for (size_t i = 0; i < 4; i++) {
        size_t segment = p->periodic ? (at + i + 2 * n - 2) % n : at + i - 2;
        r.has[i] = p->periodic || (at + i >= 2 && segment < n);
        if (!r.has[i])
            continue;
        r.key[i] = p->first + segment;
        r.h[i] = spline_duration(s, r.key[i]);
        r.knot[i] = by_knots ? knot_step(distance(s, r.key[i]), alpha) : 0.0;
    }
    return r;
}

/* The two tangents of a key. */
typedef struct sides {
    double in, out;
} sides;

static sides both(double v)
{
    sides r = {v, v};
    return r;
}

/* The slopes of the four segments; of one that is missing, that of its neighbour. */
static void slopes(const spline_piece *p, const stencil *a, size_t component, double d[4])
{
    for (size_t i = 0; i < 4; i++)
        d[i] = a->has[i] ? spline_slope(p->spline, a->key[i], component) : 0.0;
    d[1] = a->has[1] ? d[1] : d[2];
    d[2] = a->has[2] ? d[2] : d[1];
    d[0] = a->has[0] ? d[0] : d[1];
    d[3] = a->has[3] ? d[3] : d[2];
}

/* The durations beside the key; of one that is missing, that of the other. */
static double duration_before(const stencil *a)
{
    return a->has[1] ? a->h[1] : a->h[2];
}

static double duration_after(const stencil *a)
{
    return a->has[2] ? a->h[2] : a->h[1];
}

static double parabola(double d0, double d1, double h0, double h1)
{
    return (d0 * h1 + d1 * h0) / (h0 + h1);
}

static sides tcb(const nkw_spline *s, size_t k, const stencil *a, const double d[4])
{
    const nkw_tcb none = {0.0f, 0.0f, 0.0f}, *key = s->tcb ? &s->tcb[k] : &none;
    double h0 = duration_before(a), h1 = duration_after(a), t = 1.0 - (double)key->tension;
    double c = key->continuity, b = key->bias, back = (1.0 + b) * (d[1] * h0), on = (1.0 - b) * (d[2] * h1);
    sides r = {t * ((1.0 - c) * back + (1.0 + c) * on) / (h0 + h1),
               t * ((1.0 + c) * back + (1.0 - c) * on) / (h0 + h1)};
    return r;
}

/* The Catmull-Rom tangent by the knots, and as a velocity in the durations of both segments. */
static sides by_knots(const stencil *a, const double d[4])
{
    double h0 = duration_before(a), h1 = duration_after(a);
    double k0 = a->has[1] ? a->knot[1] : a->knot[2], k1 = a->has[2] ? a->knot[2] : a->knot[1];
    double d0 = k0 > 0.0 ? d[1] * h0 / k0 : 0.0, d1 = k1 > 0.0 ? d[2] * h1 / k1 : 0.0;
    double v = k0 > 0.0 && k1 > 0.0 ? parabola(d0, d1, k0, k1) : d0 + d1;
    sides r = {v * k0 / h0, v * k1 / h1};
    return r;
}

static int differ_in_sign(double a, double b)
{
    return !((a > 0.0 && b > 0.0) || (a < 0.0 && b < 0.0));
}

/* The slope of the parabola at its end, limited to keep monotone. d0, h0 is the segment at the end. */
static double pchip_end(double d0, double d1, double h0, double h1)
{
    double v = ((2.0 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
    if (differ_in_sign(v, d0))
        return 0.0;
    return differ_in_sign(d0, d1) && lane_abs64(v) > 3.0 * lane_abs64(d0) ? 3.0 * d0 : v;
}

static double pchip(const stencil *a, const double d[4])
{
    if (!a->has[1])
        return a->has[3] ? pchip_end(d[2], d[3], a->h[2], a->h[3]) : d[2];
    if (!a->has[2])
        return a->has[0] ? pchip_end(d[1], d[0], a->h[1], a->h[0]) : d[1];
    double w0 = 2.0 * a->h[2] + a->h[1], w1 = a->h[2] + 2.0 * a->h[1];
    return differ_in_sign(d[1], d[2]) ? 0.0 : (w0 + w1) / (w0 / d[1] + w1 / d[2]);
}

/* Slopes beyond the ends continue linearly. */
static void extrapolate(const stencil *a, double d[4])
{
    if (!a->has[1])
        d[1] = a->has[3] ? 2.0 * d[2] - d[3] : d[2];
    if (!a->has[2])
        d[2] = a->has[0] ? 2.0 * d[1] - d[0] : d[1];
    d[0] = a->has[0] ? d[0] : 2.0 * d[1] - d[2];
    d[3] = a->has[3] ? d[3] : 2.0 * d[2] - d[1];
}

static double akima(const stencil *a, double d[4], double modified)
{
    extrapolate(a, d);
    double w0 = lane_abs64(d[3] - d[2]) + modified * lane_abs64(d[3] + d[2]);
    double w1 = lane_abs64(d[1] - d[0]) + modified * lane_abs64(d[1] + d[0]);
    double size = (lane_abs64(d[0]) + lane_abs64(d[1])) + (lane_abs64(d[2]) + lane_abs64(d[3]));
    return w0 + w1 > 1e-9 * size ? (w0 * d[1] + w1 * d[2]) / (w0 + w1) : 0.5 * (d[1] + d[2]);
}

static sides tangents_of(const spline_piece *p, size_t k, const stencil *a, size_t component)
{
    const nkw_spline *s = p->spline;
    double d[4], h0 = duration_before(a), h1 = duration_after(a);
    slopes(p, a, component, d);
    switch (s->method) {
    case NKW_SPLINE_CARDINAL:
        return both((1.0 - (double)s->tension) * (d[1] * h0 + d[2] * h1) / (h0 + h1));
    case NKW_SPLINE_TCB:
        return tcb(s, k, a, d);
    case NKW_SPLINE_CENTRIPETAL:
    case NKW_SPLINE_CHORDAL:
        return by_knots(a, d);
    case NKW_SPLINE_PCHIP:
        return both(pchip(a, d));
    case NKW_SPLINE_AKIMA:
        return both(akima(a, d, 0.0));
    case NKW_SPLINE_MAKIMA:
        return both(akima(a, d, 0.5));
    case NKW_SPLINE_C2:
    case NKW_SPLINE_CATMULL_ROM:
    default:
        return both(parabola(d[1], d[2], h0, h1));
    }
}

/* ---- Pieces between jumps ---- */

static void put(nkw_tangent_span out, size_t k, size_t component, sides v)
{
    out.in[k * out.stride + component] = spline_rounded(v.in);
    out.out[k * out.stride + component] = spline_rounded(v.out);
}

static void local_piece(const spline_piece *p, nkw_tangent_span out)
{
    for (size_t k = p->first; k <= p->last; k++) {
        stencil a = stencil_at(p, k);
        for (size_t c = 0; c < p->spline->width; c++)
            put(out, k, c, tangents_of(p, k, &a, c));
    }
}

static void c2_piece(const spline_piece *p, nkw_tangent_span out, double *work)
{
    for (size_t c = 0; c < p->spline->width; c++) {
        nkwi_spline_c2(p, c, work);
        for (size_t k = p->first; k <= p->last; k++)
            put(out, k, c, both(work[k - p->first]));
    }
}

static void alone(const nkw_spline *s, size_t k, nkw_tangent_span out)
{
    for (size_t c = 0; c < s->width; c++)
        put(out, k, c, both(0.0));
}

static void clamp_end(const nkw_spline *s, size_t k, size_t end, nkw_tangent_span out)
{
    for (size_t c = 0; c < s->width; c++)
        put(out, k, c, both(spline_end(s, end, c)));
}

/* The last key of the piece that begins at `first`: the last one before two equal times. */
static size_t piece_end(const nkw_spline *s, size_t first)
{
    size_t last = first;
    while (last + 1 < s->count && s->times[last] < s->times[last + 1])
        last++;
    return last;
}

nkw_result nkw_spline_tangents(const nkw_spline *spline, nkw_tangent_span tangents, size_t *bad, nkw_work work)
{
    nkw_result result = check_shape(spline, tangents.stride, work);
    size_t key = 0;
    for (size_t k = 0; k < spline->count && result == NKW_OK; k++) {
        result = check_key(spline, k);
        key = k;
    }
    for (size_t first = 0, last; result == NKW_OK && first < spline->count; first = last + 1) {
        last = piece_end(spline, first);
        int whole = first == 0 && last == spline->count - 1 && first < last;
        spline_piece p = {spline, first, last, whole && spline->ends == NKW_SPLINE_ENDS_PERIODIC};
        if (first == last)
            alone(spline, first, tangents);
        else if (spline->method == NKW_SPLINE_C2)
            c2_piece(&p, tangents, (double *)work.data);
        else
            local_piece(&p, tangents);
    }
    if (result == NKW_OK && spline->ends == NKW_SPLINE_ENDS_CLAMPED) {
        clamp_end(spline, 0, 0, tangents);
        clamp_end(spline, spline->count - 1, 1, tangents);
    }
    return report(result, key, bad);
}
