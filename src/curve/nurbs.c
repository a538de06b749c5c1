/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/nurbs.h>

#include "lane/scalar.h"
#include "report.h"

/* ---- Validation ---- */

static nkw_result check_shape(const nkw_nurbs *c)
{
    if (c->count == 0 || c->width == 0)
        return NKW_EMPTY;
    if (c->degree > NKW_NURBS_DEGREE)
        return NKW_TOO_MANY;
    if (c->count < c->degree + 1)
        return NKW_TOO_SMALL;
    return c->stride < c->width ? NKW_BAD_WIDTH : NKW_OK;
}

static nkw_result check_knot(const nkw_nurbs *c, size_t k)
{
    const float *u = c->knots;
    if (!lane_is_finite(u[k]))
        return NKW_NOT_FINITE;
    if ((k > 0 && u[k] < u[k - 1]) || (k == c->count && !(u[c->degree] < u[k])))
        return NKW_NOT_ASCENDING;
    return k > c->degree && u[k] == u[k - c->degree - 1] ? NKW_TOO_MANY : NKW_OK;
}

static nkw_result check_point(const nkw_nurbs *c, size_t i)
{
    for (size_t k = 0; k < c->width; k++)
        if (!lane_is_finite(c->points[i * c->stride + k]))
            return NKW_NOT_FINITE;
    if (!c->weights)
        return NKW_OK;
    if (!lane_is_finite(c->weights[i]))
        return NKW_NOT_FINITE;
    return c->weights[i] > 0.0f ? NKW_OK : NKW_BAD_WEIGHTS;
}

nkw_result nkw_nurbs_validate(const nkw_nurbs *curve, size_t *bad)
{
    nkw_result result = check_shape(curve);
    size_t at = 0;
    for (size_t k = 0; result == NKW_OK && k < NKW_NURBS_KNOTS(curve->count, curve->degree); k++) {
        result = check_knot(curve, k);
        at = k;
    }
    for (size_t i = 0; result == NKW_OK && i < curve->count; i++) {
        result = check_point(curve, i);
        at = i;
    }
    return report(result, at, bad);
}

/* ---- Basis functions ---- */

/* The degree + 1 basis functions that are not 0 at u, and their first two derivatives. Row d is derivative d. */
typedef struct basis {
    double n[3][NKW_NURBS_DEGREE + 1];
} basis;

/* The last k in degree .. count - 1 with u[k] <= u and u[k] < u[k + 1]: the span of u. */
static size_t span_of(const nkw_nurbs *c, float u)
{
    size_t low = c->degree, high = c->count;
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2;
        if (c->knots[middle] <= u)
            low = middle;
        else
            high = middle;
    }
    while (low > c->degree && !(c->knots[low] < c->knots[low + 1]))
        low--;
    return low;
}

static double over(double a, double b)
{
    return b > 0.0 ? a / b : 0.0;
}

/* Raises the d functions of degree d - 1 on the span k in n[0 .. d - 1] to the d + 1 of degree d. */
static void raise(const float *knots, size_t k, size_t d, double u, double *n)
{
    double carried = 0.0;
    for (size_t r = 0; r < d; r++) {
        double right = (double)knots[k + r + 1] - u, left = u - (double)knots[k + 1 + r - d];
        double part = over(n[r], right + left);
        n[r] = carried + right * part;
        carried = left * part;
    }
    n[d] = carried;
}

/* The same for derivatives: N' of degree d = d (N(i)/(u[i + d] - u[i]) - N(i + 1)/(u[i + d + 1] - u[i + 1])). */
static void differentiate(const float *knots, size_t k, size_t d, double *n)
{
    double carried = 0.0;
    for (size_t r = 0; r < d; r++) {
        double length = (double)knots[k + r + 1] - (double)knots[k + 1 + r - d];
        double part = over((double)(int)d * n[r], length);
        n[r] = carried - part;
        carried = part;
    }
    n[d] = carried;
}

static basis basis_at(const nkw_nurbs *c, size_t k, double u)
{
    basis b = {{{1.0}, {1.0}, {1.0}}};
    for (size_t d = 1; d <= c->degree; d++) {
        raise(c->knots, k, d, u, b.n[0]);
        if (d == c->degree)
            differentiate(c->knots, k, d, b.n[1]);
        else
            raise(c->knots, k, d, u, b.n[1]);
        if (d + 1 >= c->degree)
            differentiate(c->knots, k, d, b.n[2]);
        else
            raise(c->knots, k, d, u, b.n[2]);
    }
    for (size_t d = c->degree + 1; d < 3; d++)
        b.n[d][0] = b.n[d][1] = 0.0; /* degrees 0 and 1 */
    return b;
}

/* ---- Sums ---- */

/* A weighted sum and its derivatives by u. */
typedef struct sum {
    double d[3];
} sum;

/* The sum of Ni wi over the span that begins at control point `first`. */
static sum weight_at(const nkw_nurbs *c, const basis *b, size_t first)
{
    sum r = {{0.0, 0.0, 0.0}};
    for (size_t i = 0; i <= c->degree; i++) {
        double w = c->weights ? (double)c->weights[first + i] : 1.0;
        for (size_t d = 0; d < 3; d++)
            r.d[d] += b->n[d][i] * w;
    }
    return r;
}

/* The sum of Ni wi (pi - origin) of a component. */
static sum point_at(const nkw_nurbs *c, const basis *b, size_t first, size_t component, double origin)
{
    sum r = {{0.0, 0.0, 0.0}};
    for (size_t i = 0; i <= c->degree; i++) {
        double w = c->weights ? (double)c->weights[first + i] : 1.0;
        double p = (double)c->points[(first + i) * c->stride + component] - origin;
        for (size_t d = 0; d < 3; d++)
            r.d[d] += b->n[d][i] * (w * p);
    }
    return r;
}

/* c = a/w,  c' = (a' - w' c)/w,  c'' = (a'' - 2 w' c' - w'' c)/w. */
static sum quotient(sum a, sum w)
{
    sum r;
    r.d[0] = a.d[0] / w.d[0];
    r.d[1] = (a.d[1] - w.d[1] * r.d[0]) / w.d[0];
    r.d[2] = (a.d[2] - (2.0 * w.d[1] * r.d[1] + w.d[2] * r.d[0])) / w.d[0];
    return r;
}

nkw_result nkw_nurbs_evaluate(const nkw_nurbs *curve, float u, nkw_motion_span out)
{
    const nkw_result result = check_shape(curve);
    if (result != NKW_OK)
        return result;
    float low = curve->knots[curve->degree], high = curve->knots[curve->count];
    float at = u > low ? u : low;
    at = at < high ? at : high;
    size_t span = span_of(curve, at), begin = span - curve->degree;
    basis b = basis_at(curve, span, at);
    sum w = weight_at(curve, &b, begin);
    for (size_t c = 0; c < curve->width; c++) {
        double origin = curve->points[begin * curve->stride + c];
        sum p = quotient(point_at(curve, &b, begin, c, origin), w);
        if (out.value)
            out.value[c] = (float)(origin + p.d[0]);
        if (out.velocity)
            out.velocity[c] = (float)p.d[1];
        if (out.acceleration)
            out.acceleration[c] = (float)p.d[2];
    }
    return NKW_OK;
}

/* ---- Knots ---- */

nkw_result nkw_nurbs_make_knots(size_t count, size_t degree, float from, float to, nkw_nurbs_knots_kind kind,
                                float *knots)
{
    if (degree > NKW_NURBS_DEGREE)
        return NKW_TOO_MANY;
    if (count < degree + 1)
        return NKW_TOO_SMALL;
    if (!lane_is_finite(from) || !lane_is_finite(to))
        return NKW_NOT_FINITE;
    if (!(from < to))
        return NKW_NOT_ASCENDING;
    double step = ((double)to - (double)from) / (double)(count - degree);
    for (size_t k = 0; k < NKW_NURBS_KNOTS(count, degree); k++) {
        double even = (double)from + ((double)k - (double)degree) * step;
        double low = kind == NKW_NURBS_KNOTS_UNIFORM ? -(double)FLT_MAX : (double)from;
        double high = kind == NKW_NURBS_KNOTS_UNIFORM ? (double)FLT_MAX : (double)to;
        even = even > low ? even : low;
        even = even < high ? even : high;
        knots[k] = k == degree ? from : k == count ? to : (float)even;
    }
    return NKW_OK;
}
