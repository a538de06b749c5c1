/* SPDX-License-Identifier: MIT */
/* The keys of a spline as numbers in binary64, and the tangents with continuous acceleration. */
#ifndef NAKAWARI_SPLINE_C2_H
#define NAKAWARI_SPLINE_C2_H

#include "lane/strict.h"

#include <nakawari/spline.h>

/* The keys first..last, first < last, with strictly ascending times. */
typedef struct spline_piece {
    const nkw_spline *spline;
    size_t first, last;
    int periodic;
} spline_piece;

static inline double spline_duration(const nkw_spline *s, size_t k)
{
    return (double)s->times[k + 1] - (double)s->times[k];
}

/* The slope of a component from key k to the next. */
static inline double spline_slope(const nkw_spline *s, size_t k, size_t component)
{
    const float *a = s->values + k * s->stride + component;
    return ((double)a[s->stride] - (double)a[0]) / spline_duration(s, k);
}

/* The given tangent of the first (end 0) or last key (end 1). */
static inline double spline_end(const nkw_spline *s, size_t end, size_t component)
{
    return s->end_tangents ? (double)s->end_tangents[end * s->width + component] : 0.0;
}

/* The nearest float within the range of floats. */
static inline float spline_rounded(double x)
{
    double above = x > -(double)FLT_MAX ? x : -(double)FLT_MAX;
    return (float)(above < (double)FLT_MAX ? above : (double)FLT_MAX);
}

/*
 * Stores the tangents of one component of the piece in work[0 .. last - first], the first of NKW_SPLINE_WORK(count)
 * bytes.
 */
void nkwi_spline_c2(const spline_piece *p, size_t component, double *work);

#endif
