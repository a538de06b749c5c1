/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/fit.h>
#include <nakawari/quat.h>

#include "difference.h"
#include "finite.h"
#include "lane/cubic.h"
#include "track_keys.h"
#include "work.h"

/*
 * The keys 0..n - 1 of the fit, and the equations of their tangents m:
 *
 *     next[k-1] m[k-1] + diagonal[k] m[k] + next[k] m[k+1] = right[k]      for each component
 */
typedef struct fit {
    nkw_track source, out;
    float *times, *values;
    size_t n;
    double *is_key; /* of each sample: 1 or 0 */
    double *index; /* of each key its sample */
    double *diagonal, *next, *sign, *right; /* right: width numbers for each key */
} fit;

static size_t sample_of(const fit *f, size_t key)
{
    return (size_t)f->index[key];
}

static double time_of(const fit *f, size_t sample)
{
    return (double)f->source.times[sample];
}

/* Whether a later sample follows; the last sample, and the first one of a jump, have none. */
static int has_duration(const fit *f, size_t s)
{
    return s + 1 < f->source.count && time_of(f, s) < time_of(f, s + 1);
}

/* Component i of a sample, with the sign that is nearer to the sample before. */
static double value_of(const fit *f, size_t sample, size_t i)
{
    return f->sign[sample] * (double)f->source.values[sample * f->source.width + i];
}

static void choose_signs(fit *f)
{
    for (size_t s = 0; s < f->source.count; s++) {
        f->sign[s] = s > 0 ? f->sign[s - 1] : 1.0;
        if (s > 0 && track_is_rotation(&f->source)) {
            nkw_quat a = track_read_quat(track_key_at(&f->source, s - 1)),
                     b = track_read_quat(track_key_at(&f->source, s));
            f->sign[s] = nkw_quat_dot(a, b) < 0.0f ? -f->sign[s] : f->sign[s];
        }
    }
}

/* The first and the last sample, and both samples of a jump. */
static void mark_ends(fit *f)
{
    for (size_t s = 0; s < f->source.count; s++)
        f->is_key[s] = s == 0 || !has_duration(f, s - 1) || !has_duration(f, s) ? 1.0 : 0.0;
}

static void list_keys(fit *f)
{
    f->n = 0;
    for (size_t s = 0; s < f->source.count; s++)
        if (f->is_key[s] > 0.0)
            f->index[f->n++] = (double)s;
}

/* The slope from sample s to the next one, per second; 0 for a jump and after the last. */
static double slope_after(const fit *f, size_t s, size_t i)
{
    if (!has_duration(f, s))
        return 0.0;
    return (value_of(f, s + 1, i) - value_of(f, s, i)) / (time_of(f, s + 1) - time_of(f, s));
}

/* The mean of the slopes on both sides; the slope of the side that has a duration. */
static double slope_at(const fit *f, size_t s, size_t i)
{
    int before = s > 0 && has_duration(f, s - 1), after = has_duration(f, s);
    if (before && after)
        return 0.5 * (slope_after(f, s - 1, i) + slope_after(f, s, i));
    return before ? slope_after(f, s - 1, i) : slope_after(f, s, i);
}

/* Adds the sample s between key k and the next one to the equations. */
static void add_sample(fit *f, size_t k, size_t s)
{
    size_t a = sample_of(f, k), b = sample_of(f, k + 1), width = f->source.width;
    double d = time_of(f, b) - time_of(f, a), u = (time_of(f, s) - time_of(f, a)) / d;
    lane_f64_slopes weights = lane_f64_hermite_weights(u);
    double at_a = d * weights.v0, at_b = d * weights.v1, part = weights.f;
    f->diagonal[k] += at_a * at_a;
    f->next[k] += at_a * at_b;
    f->diagonal[k + 1] += at_b * at_b;
    for (size_t i = 0; i < width; i++) {
        double from = value_of(f, a, i), rest = (value_of(f, s, i) - from) - part * (value_of(f, b, i) - from);
        f->right[k * width + i] += at_a * rest;
        f->right[(k + 1) * width + i] += at_b * rest;
    }
}

/*
 * The equations. A tangent with few samples around it is not determined by them, so each is also weakly equal to the
 * slope of the samples there.
 */
static void set_equations(fit *f)
{
    size_t width = f->source.width;
    for (size_t k = 0; k < f->n; k++)
        f->diagonal[k] = f->next[k] = 0.0;
    for (size_t k = 0; k < f->n * width; k++)
        f->right[k] = 0.0;
    for (size_t k = 0; k + 1 < f->n; k++)
        for (size_t s = sample_of(f, k) + 1; s < sample_of(f, k + 1); s++)
            add_sample(f, k, s);
    for (size_t k = 0; k < f->n; k++) {
        double weight = 0x1p-20 * f->diagonal[k] + 0x1p-100;
        f->diagonal[k] += weight;
        for (size_t i = 0; i < width; i++)
            f->right[k * width + i] += weight * slope_at(f, sample_of(f, k), i);
    }
}

/* Elimination, then substitution: the tangents replace the right sides. The matrix is positive definite. */
static void solve(fit *f)
{
    size_t width = f->source.width;
    for (size_t k = 1; k < f->n; k++) {
        double factor = f->next[k - 1] / f->diagonal[k - 1];
        f->diagonal[k] -= factor * f->next[k - 1];
        for (size_t i = 0; i < width; i++)
            f->right[k * width + i] -= factor * f->right[(k - 1) * width + i];
    }
    for (size_t k = f->n; k-- > 0;)
        for (size_t i = 0; i < width; i++) {
            double later = k + 1 < f->n ? f->next[k] * f->right[(k + 1) * width + i] : 0.0;
            f->right[k * width + i] = (f->right[k * width + i] - later) / f->diagonal[k];
        }
}

static void write_keys(fit *f)
{
    size_t width = f->source.width;
    for (size_t k = 0; k < f->n; k++) {
        size_t s = sample_of(f, k);
        float *key = f->values + 3 * width * k;
        f->times[k] = f->source.times[s];
        for (size_t i = 0; i < width; i++) {
            key[i] = key[2 * width + i] = (float)f->right[k * width + i];
            key[width + i] = (float)value_of(f, s, i);
        }
    }
    f->out.count = f->n;
}

/* The difference of sample s, in the segment of key k. room: width floats. */
static float difference_at(const fit *f, size_t k, size_t s, float *room)
{
    double first = time_of(f, sample_of(f, k)), last = time_of(f, sample_of(f, k + 1));
    nkw_segment at = {k, (float)((time_of(f, s) - first) / (last - first))};
    const float *value = track_key_at(&f->source, s);
    nkw_track_sample_segment(&f->out, at, room);
    return track_is_rotation(&f->source) ? nkw_quat_angle(track_read_quat(value), track_read_quat(room))
                                         : difference_largest(value, room, f->source.width);
}

/* The largest difference of the samples between key k and the next one. */
static float worst_of(const fit *f, size_t k, float *room)
{
    float worst = 0.0f;
    for (size_t s = sample_of(f, k) + 1; s < sample_of(f, k + 1); s++)
        worst = difference_worse(worst, difference_at(f, k, s, room));
    return worst;
}

/*
 * Adds keys. Of neighbouring segments beyond the tolerance the worst one gets a key in its middle, because that
 * improves the others too. Returns the largest difference of all.
 */
static float add_keys(fit *f, float tolerance, float *room, size_t *added)
{
    float largest = 0.0f, before = 0.0f, here = 0.0f, after = f->n > 1 ? worst_of(f, 0, room) : 0.0f;
    for (size_t k = 0; k + 1 < f->n; k++) {
        before = here;
        here = after;
        after = k + 2 < f->n ? worst_of(f, k + 1, room) : 0.0f;
        largest = difference_worse(largest, here);
        if (!(here <= tolerance) && !(here < before) && !(here < after)) {
            size_t middle = (sample_of(f, k) + sample_of(f, k + 1)) / 2;
            *added += middle > sample_of(f, k);
            f->is_key[middle] = 1.0;
        }
    }
    return largest;
}

static float fit_within(fit *f, float tolerance, float *room)
{
    float difference = 0.0f;
    choose_signs(f);
    mark_ends(f);
    for (size_t added = 1; added > 0;) {
        added = 0;
        list_keys(f);
        set_equations(f);
        solve(f);
        write_keys(f);
        difference = add_keys(f, tolerance, room, &added);
    }
    return difference;
}

static nkw_result check(const nkw_track *track, float tolerance, nkw_track_span span, nkw_work work)
{
    nkw_result result = nkw_track_validate(track, NULL);
    if (result != NKW_OK)
        return result;
    if (track->interpolation != NKW_INTERPOLATION_LINEAR || track->key_interpolation)
        return NKW_MISMATCHED;
    if (!(tolerance >= 0.0f))
        return NKW_OUT_OF_RANGE;
    size_t width = track->width, count = track->count, most = SIZE_MAX / sizeof(double);
    if (span.key_capacity < count || width > most - 5 || count > (most - width) / (width + 5))
        return NKW_TOO_SMALL;
    return work_fits(work, NKW_FIT_WORK(count, width)) ? NKW_OK : NKW_TOO_SMALL;
}

nkw_result nkw_track_fit(const nkw_track *track, float tolerance, nkw_track_span span, nkw_track *out, float *difference,
                         nkw_work work)
{
    const size_t count = track->count;
    double *numbers = (double *)work.data;
    float worst = INFINITY;
    fit f;
    memset(&f, 0, sizeof f);
    f.source = f.out = *track;
    f.out.times = f.times = span.times;
    f.out.values = f.values = span.values;
    f.out.interpolation = NKW_INTERPOLATION_CUBICSPLINE;
    f.out.key_interpolation = NULL;
    f.out.count = 0;
    nkw_result result = check(track, tolerance, span, work);
    if (result == NKW_OK) {
        f.is_key = numbers;
        f.index = numbers + count;
        f.diagonal = numbers + 2 * count;
        f.next = numbers + 3 * count;
        f.sign = numbers + 4 * count;
        f.right = numbers + 5 * count;
        float *room = (float *)(void *)(f.right + count * track->width); /* width floats */
        worst = fit_within(&f, tolerance, room);
        if (!are_finite(f.values, 3 * track->width * f.n)) {
            result = NKW_NOT_FINITE;
            worst = INFINITY;
            f.out.count = 0;
        }
    }
    if (difference)
        *difference = worst;
    *out = f.out;
    return result;
}
