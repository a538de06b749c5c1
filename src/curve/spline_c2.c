/* SPDX-License-Identifier: MIT */
#include "spline_c2.h"

/*
 * The acceleration is continuous at an inner key i if
 *
 *     l v(i-1) + 2 v(i) + m v(i+1) = 3 (l d0 + m d1),     l = h1/(h0 + h1),  m = h0/(h0 + h1)
 *
 * with the durations and slopes before (h0, d0) and after (h1, d1) it. At a free end, 2 v0 + v1 = 3 d0: no
 * acceleration.
 */
typedef struct row {
    double before, diagonal, after, right;
} row;

/* The row of a key between segments i and j. */
static row inner_row(const nkw_spline *s, size_t i, size_t j, size_t component)
{
    double h0 = spline_duration(s, i), h1 = spline_duration(s, j), l = h1 / (h0 + h1), m = h0 / (h0 + h1);
    row r = {l, 2.0, m, 3.0 * (l * spline_slope(s, i, component) + m * spline_slope(s, j, component))};
    return r;
}

/* The row of the first (end 0) or last key (end 1). */
static row end_row(const spline_piece *p, size_t end, size_t component)
{
    const nkw_spline *s = p->spline;
    size_t outermost = end ? s->count - 1 : 0, segment = end ? p->last - 1 : p->first;
    row clamped = {0.0, 1.0, 0.0, 0.0}, open = {1.0, 2.0, 1.0, 0.0};
    if (s->ends == NKW_SPLINE_ENDS_CLAMPED && (end ? p->last : p->first) == outermost) {
        clamped.right = spline_end(s, end, component);
        return clamped;
    }
    open.right = 3.0 * spline_slope(s, segment, component);
    return open;
}

static row row_at(const spline_piece *p, size_t i, size_t component)
{
    size_t n = p->last - p->first;
    if (p->periodic)
        return inner_row(p->spline, p->first + (i + n - 1) % n, p->first + i, component);
    if (i == 0 || i == n)
        return end_row(p, i > 0, component);
    return inner_row(p->spline, p->first + i - 1, p->first + i, component);
}

/* Elimination forward, substitution backward (Thomas); diagonally dominant, so without pivots. */
static void solve_open(const spline_piece *p, size_t component, double *v, double *upper)
{
    size_t n = p->last - p->first;
    for (size_t i = 0; i <= n; i++) {
        row r = row_at(p, i, component);
        double before = i > 0 ? r.before : 0.0, pivot = r.diagonal - before * (i > 0 ? upper[i - 1] : 0.0);
        upper[i] = r.after / pivot;
        v[i] = (r.right - before * (i > 0 ? v[i - 1] : 0.0)) / pivot;
    }
    for (size_t i = n; i-- > 0;)
        v[i] -= upper[i] * v[i + 1];
}

/*
 * Periodic, n >= 3 unknowns: the matrix is A + u w^T with A tridiagonal, u = (-2, 0 .. 0, m), w = (1, 0 .. 0, -l/2),
 * l and m the corners. v = x - z (w.x)/(1 + w.z), A x = right, A z = u (Sherman, Morrison, 1950).
 */
static void solve_cyclic(const spline_piece *p, size_t component, double *v, double *upper, double *z)
{
    size_t n = p->last - p->first;
    double l = row_at(p, 0, component).before, m = row_at(p, n - 1, component).after;
    for (size_t i = 0; i < n; i++) {
        row r = row_at(p, i, component);
        double before = i > 0 ? r.before : 0.0, u = i == 0 ? -2.0 : i == n - 1 ? m : 0.0;
        double diagonal = i == 0 ? 4.0 : i == n - 1 ? 2.0 + 0.5 * (l * m) : 2.0;
        double pivot = diagonal - before * (i > 0 ? upper[i - 1] : 0.0);
        upper[i] = r.after / pivot;
        v[i] = (r.right - before * (i > 0 ? v[i - 1] : 0.0)) / pivot;
        z[i] = (u - before * (i > 0 ? z[i - 1] : 0.0)) / pivot;
    }
    for (size_t i = n - 1; i-- > 0;) {
        v[i] -= upper[i] * v[i + 1];
        z[i] -= upper[i] * z[i + 1];
    }
    double factor = (v[0] - 0.5 * (l * v[n - 1])) / (1.0 + (z[0] - 0.5 * (l * z[n - 1])));
    for (size_t i = 0; i < n; i++)
        v[i] -= factor * z[i];
    v[n] = v[0];
}

/* One or two segments: 3 v0 = r0; 2 v0 + v1 = r0, v0 + 2 v1 = r1. */
static void solve_short(const spline_piece *p, size_t component, double *v)
{
    size_t n = p->last - p->first;
    double r0 = row_at(p, 0, component).right, r1 = row_at(p, n - 1, component).right;
    v[0] = (2.0 * r0 - r1) / 3.0;
    v[1] = (2.0 * r1 - r0) / 3.0;
    v[n] = v[0];
}

void nkwi_spline_c2(const spline_piece *p, size_t component, double *work)
{
    size_t n = p->last - p->first, count = p->spline->count;
    if (!p->periodic)
        solve_open(p, component, work, work + count);
    else if (n < 3)
        solve_short(p, component, work);
    else
        solve_cyclic(p, component, work, work + count, work + 2 * count);
}
