/* SPDX-License-Identifier: MIT */
/* Tangents, key times and keys that lie far from those around them. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

/* ---- tangents ---- */

/* The largest component of a tangent. */
static double largest(const float *tangent, size_t width)
{
    double most = 0.0;
    for (size_t i = 0; i < width; i++)
        most = fmax(most, fabs((double)tangent[i]));
    return most;
}

/* The largest difference of a component of two keys, of all keys to the first. */
static double spread(const nkw_track *track)
{
    double most = 0.0;
    for (size_t k = 1; k < track->count; k++)
        for (size_t i = 0; i < track->width; i++)
            most = fmax(most, fabs((double)check_value(track, k)[i] - (double)check_value(track, 0)[i]));
    return most;
}

/* What a tangent may move a curve: a quaternion by its length, others by ten times what the keys or the model span. */
static double most_bulge(const check *c, const nkw_clip_track *track)
{
    if (track->target == NKW_CLIP_ROTATION)
        return 1.0;
    const double size = track->target == NKW_CLIP_TRANSLATION ? (double)c->extent.size : 1.0;
    return 10.0 * fmax(spread(&track->track), size);
}

/* A tangent m moves CUBICSPLINE by at most 4/27 m times the length of its segment. */
static void check_tangents(check *c, size_t animation, size_t index)
{
    const nkw_clip_track *clip_track = &c->document->animations[animation].tracks[index];
    const nkw_track *track = &clip_track->track;
    const double most = most_bulge(c, clip_track);
    const size_t width = track->width;
    for (size_t k = 0; k < track->count; k++) {
        const float *value = check_value(track, k);
        const double before = k > 0 ? (double)track->times[k] - (double)track->times[k - 1] : 0.0;
        const double after = k + 1 < track->count ? (double)track->times[k + 1] - (double)track->times[k] : 0.0;
        const double in = before * largest(value - width, width), out = after * largest(value + width, width);
        finding f = check_finding(c, animation, index, (long)k, SEVERITY_WARNING, "overshoot");
        f.amount = 4.0 / 27.0 * fmax(in, out);
        if (f.amount <= most)
            continue;
        snprintf(f.detail, sizeof f.detail, "the %s-tangent moves the curve by up to %.3g", in > out ? "in" : "out",
                 f.amount);
        findings_add(&c->found, &f);
    }
}

/* ---- times ---- */

/* The first or the last key, farther from the next one than ten times the span of the others. */
static void check_span(check *c, size_t animation, size_t index)
{
    const nkw_track *track = &c->document->animations[animation].tracks[index].track;
    const size_t n = track->count;
    const float *t = track->times;
    if (n < 4)
        return;
    for (int last = 0; last < 2; last++) {
        const double gap = last ? (double)t[n - 1] - (double)t[n - 2] : (double)t[1] - (double)t[0];
        const double rest = last ? (double)t[n - 2] - (double)t[0] : (double)t[n - 1] - (double)t[1];
        finding f = check_finding(c, animation, index, last ? (long)n - 1 : 0, SEVERITY_WARNING, "outlier-time");
        f.amount = gap;
        if (gap <= 10.0 * rest || gap < 1.0)
            continue;
        snprintf(f.detail, sizeof f.detail, "%.6g s from its neighbour; the other keys span %.6g s", gap, rest);
        findings_add(&c->found, &f);
    }
}

/* ---- keys ---- */

/* The distance of two keys of a track, 0 where one of them does not exist. */
static double step_of(const check *c, const nkw_clip_track *track, size_t joint, size_t a, size_t b)
{
    return b < track->track.count
               ? check_distance(c, track, joint, check_value(&track->track, a), check_value(&track->track, b))
               : 0.0;
}

/*
 * For each inner key, how far it is at least from both neighbours; 0 unless that is four times the steps before and after
 * these, and half the way between them: a spike, not the turning point of a fast motion.
 */
static void measure_spikes(const check *c, const nkw_clip_track *track, size_t joint, double *heights)
{
    for (size_t k = 1; k + 1 < track->track.count; k++) {
        const double there = step_of(c, track, joint, k - 1, k), back = step_of(c, track, joint, k, k + 1);
        const double before = k > 1 ? step_of(c, track, joint, k - 2, k - 1) : 0.0;
        const double after = step_of(c, track, joint, k + 1, k + 2),
                     between = 0.5 * step_of(c, track, joint, k - 1, k + 1);
        const double height = fmin(there, back);
        heights[k] = height > 4.0 * fmax(between, fmax(before, after)) ? height : 0.0;
    }
}

/* Spikes of more than a 25th of the model's size, of which a track has few. */
static void check_spikes(check *c, size_t animation, size_t index)
{
    const nkw_document_animation *a = &c->document->animations[animation];
    const nkw_clip_track *track = &a->tracks[index];
    const size_t n = track->track.count, joint = (size_t)a->channels[index].joint;
    const double least = 0.04 * (double)c->extent.size;
    if (n < 6 || track->target == NKW_CLIP_FLOATS || track->track.interpolation == NKW_INTERPOLATION_STEP)
        return;
    double *heights = calloc(n, sizeof *heights);
    size_t count = 0;
    c->found.failed |= !heights;
    if (heights)
        measure_spikes(c, track, joint, heights);
    for (size_t k = 0; heights && k < n; k++)
        count += heights[k] > least;
    for (size_t k = 0; heights && k < n && count <= 1 + n / 300; k++) {
        finding f = check_finding(c, animation, index, (long)k, SEVERITY_WARNING, "spike");
        f.amount = heights[k];
        snprintf(f.detail, sizeof f.detail, "%.3g from both keys beside it, which are close to one another", f.amount);
        if (heights[k] > least)
            findings_add(&c->found, &f);
    }
    free(heights);
}

void check_outliers(check *c, size_t animation, size_t index)
{
    const nkw_track *track = &c->document->animations[animation].tracks[index].track;
    check_span(c, animation, index);
    check_spikes(c, animation, index);
    if (track->interpolation == NKW_INTERPOLATION_CUBICSPLINE)
        check_tangents(c, animation, index);
}
