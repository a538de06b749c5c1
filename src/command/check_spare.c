/* SPDX-License-Identifier: MIT */
/* Keys that a tolerance would drop, constant tracks. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

double check_distance(const check *c, const nkw_clip_track *track, size_t joint, const float *a, const float *b)
{
    double sum = 0.0, other = 0.0, lever = (double)c->extent.lever[joint];
    for (size_t i = 0; i < track->track.width; i++) {
        double minus = (double)a[i] - (double)b[i], plus = (double)a[i] + (double)b[i];
        sum = track->target == NKW_CLIP_FLOATS ? fmax(sum, minus * minus) : sum + minus * minus;
        other += plus * plus;
    }
    switch (track->target) {
    case NKW_CLIP_ROTATION: /* a chord of 2 sin(angle / 4); the farthest point moves by at most angle times lever */
        return 2.0 * sqrt(fmin(sum, other)) * lever;
    case NKW_CLIP_TRANSLATION:
        return sqrt(sum) * (double)c->extent.stretch[joint];
    case NKW_CLIP_SCALE:
        return sqrt(sum) * lever;
    default: /* morph weights: the whole model at a weight of 1, at most */
        return sqrt(sum) * (double)c->extent.size;
    }
}

enum { WIDEST = 64, WINDOW = 256 };

/* Whether the keys between i and j are what LINEAR or STEP between them would be. */
static int spans(const check *c, const nkw_clip_track *track, size_t joint, size_t i, size_t j)
{
    float value[WIDEST], times[2] = {track->track.times[i], track->track.times[j]}, values[2 * WIDEST];
    const size_t width = track->track.width;
    nkw_track pair = track->track;
    memcpy(values, check_value(&track->track, i), width * sizeof *values);
    memcpy(values + width, check_value(&track->track, j), width * sizeof *values);
    pair.times = times, pair.values = values, pair.count = 2;
    for (size_t k = i + 1; k < j; k++) {
        nkw_track_sample(&pair, track->track.times[k], NULL, value);
        if (!(check_distance(c, track, joint, value, check_value(&track->track, k)) <= (double)c->tolerance))
            return 0;
    }
    return 1;
}

/*
 * A key j up to which the key i spans all between, and not up to j + 1 or the end of the window. Spans of 1, 2, 4 ... are
 * tried, then halves of what is left: a key is compared 2 log2(WINDOW) times at most, not WINDOW / 2 times.
 */
static size_t reach(const check *c, const nkw_clip_track *track, size_t joint, size_t i)
{
    const size_t last = track->track.count - 1, most = last - i < WINDOW ? last : i + WINDOW;
    size_t good = i + 1, bad = most + 1, step = 2;
    while (bad - good > 1) {
        const size_t next = step && i + step < bad ? i + step : step ? most : good + (bad - good) / 2;
        if (next > good && spans(c, track, joint, i, next)) {
            good = next;
            step = 2 * step;
        } else {
            bad = next > good ? next : bad;
            step = 0;
        }
    }
    return good;
}

/* Greedy: from a key that is kept, a far key that spans all between. */
static size_t count_spare(const check *c, const nkw_clip_track *track, size_t joint)
{
    size_t kept = 1;
    for (size_t i = 0; i + 1 < track->track.count; kept++)
        i = reach(c, track, joint, i);
    return track->track.count - kept;
}

/* How far a tangent moves CUBICSPLINE from the values of its segment: u (1 - u)^2 is at most 4/27. */
static double bulge_of(const check *c, const nkw_clip_track *track, size_t joint, const float *tangent, float step)
{
    const float zero[WIDEST] = {0};
    float move[WIDEST];
    for (size_t i = 0; i < track->track.width; i++)
        move[i] = 4.0f / 27.0f * step * tangent[i];
    return check_distance(c, track, joint, move, zero);
}

/* A bound of the distance between the first value and those of any time. */
static double range_of(const check *c, const nkw_clip_track *clip_track, size_t joint, int cubic)
{
    const nkw_track *track = &clip_track->track;
    const size_t width = track->width;
    double most = 0.0, bulge = 0.0;
    for (size_t k = 1; k < track->count; k++) {
        const float *before = check_value(track, k - 1), *value = check_value(track, k);
        const float step = track->times[k] - track->times[k - 1];
        most = fmax(most, check_distance(c, clip_track, joint, check_value(track, 0), value));
        if (cubic)
            bulge = fmax(bulge, bulge_of(c, clip_track, joint, before + width, step) +
                                    bulge_of(c, clip_track, joint, value - width, step));
    }
    return most + bulge;
}

void check_spare_keys(check *c, size_t animation, size_t index)
{
    const nkw_document_animation *a = &c->document->animations[animation];
    const nkw_clip_track *track = &a->tracks[index];
    const size_t joint = (size_t)a->channels[index].joint;
    finding f = check_finding(c, animation, index, -1, SEVERITY_NOTE, "constant");
    int cubic = track->track.interpolation == NKW_INTERPOLATION_CUBICSPLINE;
    if (track->track.count < 2 || track->track.width > WIDEST || track->track.key_interpolation)
        return;
    f.amount = range_of(c, track, joint, cubic);
    if (f.amount <= (double)c->tolerance) {
        snprintf(f.detail, sizeof f.detail, "%zu keys within a distance of %.3g: one is enough", track->track.count,
                 f.amount);
        findings_add(&c->found, &f);
        return;
    }
    size_t spare = cubic ? 0 : count_spare(c, track, joint);
    if (!spare)
        return;
    f.what = "spare-keys";
    f.amount = (double)spare;
    snprintf(f.detail, sizeof f.detail, "%zu of %zu keys can be dropped within a distance of %.3g", spare,
             track->track.count, (double)c->tolerance);
    findings_add(&c->found, &f);
}
