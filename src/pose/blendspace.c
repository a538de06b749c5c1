/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/blendspace.h>

#include "finite.h"
#include "lane/f64.h"
#include "lane/scalar.h"
#include "report.h"

/* The weight of the angle against the relative difference of lengths, of Johansen. */
#define POLAR_ANGLE 2.0

/* The products (p - a).(b - a) and |b - a|^2. */
typedef struct band {
    double dot, n2;
} band;

static band cartesian_band(const float *p, const float *a, const float *b, size_t dimension)
{
    band r = {0.0, 0.0};
    for (size_t k = 0; k < dimension; k++) {
        double to = (double)b[k] - (double)a[k];
        r.dot += ((double)p[k] - (double)a[k]) * to;
        r.n2 += to * to;
    }
    return r;
}

static double length2(const float *v)
{
    return lane_sqrt64((double)v[0] * (double)v[0] + (double)v[1] * (double)v[1]);
}

/* The angle from a to b, 0 where either is zero. */
static double angle2(const float *a, const float *b)
{
    double cosine = (double)a[0] * (double)b[0] + (double)a[1] * (double)b[1];
    double sine = (double)a[0] * (double)b[1] - (double)a[1] * (double)b[0];
    return sine == 0.0 && cosine == 0.0 ? 0.0 : POLAR_ANGLE * lane_atan2_64(sine, cosine);
}

/* The weight of a sample against another: 1 - (p - a).(b - a) / |b - a|^2. Samples at one place do not compete. */
static double weight_in(band r)
{
    return r.n2 > 0.0 ? 1.0 - r.dot / r.n2 : 1.0;
}

/* In the plane of relative length and angle, seen from a: twice the differences of lengths over the sum of both. */
static double polar_weight(const float *p, const float *a, const float *b)
{
    double la = length2(a), lb = length2(b), mean = 0.5 * (la + lb);
    double to_length = mean > 0.0 ? (lb - la) / mean : 0.0, to_angle = angle2(a, b);
    double length = mean > 0.0 ? (length2(p) - la) / mean : 0.0, angle = angle2(a, p);
    double round = to_angle - lane_copysign64(2.0 * LANE_PI * POLAR_ANGLE, to_angle);
    band near_side = {length * to_length + angle * to_angle, to_length * to_length + to_angle * to_angle};
    band far_side = {length * to_length + angle * round, to_length * to_length + round * round};
    double h = weight_in(near_side), other = weight_in(far_side);
    /* A sample a quarter turn or more away counts in both directions around the circle. */
    return lane_abs64(to_angle) >= LANE_HALF_PI * POLAR_ANGLE && other < h ? other : h;
}

static int is_polar(const nkw_blendspace *space)
{
    return space->kind == NKW_BLENDSPACE_POLAR && space->dimension == 2;
}

static const float *sample_at(const nkw_blendspace *space, size_t i)
{
    return space->samples + i * space->dimension;
}

static double influence_of(const nkw_blendspace *space, const float *point, size_t i)
{
    const float *a = sample_at(space, i);
    double least = 1.0;
    if (!are_finite(a, space->dimension))
        return 0.0;
    for (size_t j = 0; j < space->count; j++) {
        const float *b = sample_at(space, j);
        if (j == i || !are_finite(b, space->dimension))
            continue;
        double h =
            is_polar(space) ? polar_weight(point, a, b) : weight_in(cartesian_band(point, a, b, space->dimension));
        least = h < least ? h : least;
    }
    return least > 0.0 ? least : 0.0;
}

static double sum_of(const float *weights, size_t count)
{
    double sum = 0.0;
    for (size_t i = 0; i < count; i++)
        sum += (double)weights[i];
    return sum;
}

static nkw_result check_kind(const nkw_blendspace *space)
{
    if (space->count == 0 || space->dimension == 0)
        return NKW_EMPTY;
    return space->kind == NKW_BLENDSPACE_CARTESIAN || is_polar(space) ? NKW_OK : NKW_BAD_METHOD;
}

nkw_result nkw_blendspace_weights(const nkw_blendspace *space, const float *point, float *weights)
{
    nkw_result result = check_kind(space);
    if (result != NKW_OK)
        return result;
    int known = are_finite(point, space->dimension);
    for (size_t i = 0; i < space->count; i++)
        weights[i] = known ? (float)influence_of(space, point, i) : 0.0f;
    double sum = sum_of(weights, space->count);
    if (sum == 0.0) {
        for (size_t i = 0; i < space->count; i++)
            weights[i] = are_finite(sample_at(space, i), space->dimension) ? 1.0f : 0.0f;
        sum = sum_of(weights, space->count);
    }
    for (size_t i = 0; sum > 0.0 && i < space->count; i++)
        weights[i] = (float)((double)weights[i] / sum);
    return NKW_OK;
}

static int is_repeated(const nkw_blendspace *space, size_t i)
{
    for (size_t j = 0; j < i; j++) {
        size_t k = 0;
        while (k < space->dimension && sample_at(space, i)[k] == sample_at(space, j)[k])
            k++;
        if (k == space->dimension)
            return 1;
    }
    return 0;
}

nkw_result nkw_blendspace_validate(const nkw_blendspace *space, size_t *bad)
{
    nkw_result result = check_kind(space);
    size_t i = 0;
    for (; result == NKW_OK && i < space->count; i++) {
        if (!are_finite(sample_at(space, i), space->dimension))
            result = NKW_NOT_FINITE;
        else if (is_repeated(space, i))
            result = NKW_REPEATED;
    }
    return report(result, i ? i - 1 : 0, bad);
}
