/* SPDX-License-Identifier: MIT */
/* Key times and key values. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "check.h"

static const char *const objects[] = {"translation", "rotation", "scale", "weights"};

finding check_finding(const check *c, size_t animation, size_t track, long key, severity level, const char *what)
{
    const nkw_document_animation *a = &c->document->animations[animation];
    const nkw_document_node *node = &c->document->nodes[a->channels[track].joint];
    finding f = finding_of(level, what);
    f.clip = (long)animation;
    f.object = objects[a->tracks[track].target];
    f.joint = node->name;
    f.number = (long)node->number;
    f.key = key;
    if (key >= 0)
        f.time = a->tracks[track].track.times[key];
    return f;
}

const float *check_value(const nkw_track *track, size_t key)
{
    size_t cubic = track->interpolation == NKW_INTERPOLATION_CUBICSPLINE;
    return track->values + (cubic ? 3 * key + 1 : key) * track->width;
}

/* ---- times ---- */

static void check_times(check *c, size_t animation, size_t index)
{
    const nkw_track *track = &c->document->animations[animation].tracks[index].track;
    if (track->count > 0 && track->times[0] < 0.0f) {
        finding f = check_finding(c, animation, index, 0, SEVERITY_WARNING, "negative-time");
        f.amount = -(double)track->times[0];
        snprintf(f.detail, sizeof f.detail, "the first key is before 0: glTF has no such times");
        findings_add(&c->found, &f);
    }
    for (size_t k = 1; k < track->count; k++) {
        float before = track->times[k - 1], time = track->times[k], step = time - before;
        finding f = check_finding(c, animation, index, (long)k, SEVERITY_WARNING, "duplicate-time");
        f.amount = (double)step;
        if (!isfinite(step))
            continue;
        if (step < 0.0f) {
            f.level = SEVERITY_ERROR;
            f.what = "unsorted-time";
            snprintf(f.detail, sizeof f.detail, "%.9g s before the key before it", (double)-step);
        } else if (step == 0.0f)
            snprintf(f.detail, sizeof f.detail, "the time of the key before it: a segment of zero length");
        else if (step <= 4.0f * FLT_EPSILON * fabsf(time)) {
            f.what = "short-segment";
            snprintf(f.detail, sizeof f.detail, "%.3g s after the key before it: not more than rounding", (double)step);
        } else
            continue;
        findings_add(&c->found, &f);
    }
}

/* ---- finite numbers ---- */

static int finite_key(const nkw_track *track, size_t k)
{
    size_t width = track->width * (track->interpolation == NKW_INTERPOLATION_CUBICSPLINE ? 3 : 1);
    int finite = isfinite(track->times[k]);
    for (size_t i = 0; finite && i < width; i++)
        finite = isfinite(track->values[k * width + i]);
    return finite;
}

static void check_finite(check *c, size_t animation, size_t index)
{
    const nkw_track *track = &c->document->animations[animation].tracks[index].track;
    for (size_t k = 0; k < track->count; k++) {
        finding f = check_finding(c, animation, index, (long)k, SEVERITY_ERROR, "not-finite");
        if (finite_key(track, k))
            continue;
        f.amount = (double)NAN;
        snprintf(f.detail, sizeof f.detail, "its time or a number of it is infinite or not a number");
        findings_add(&c->found, &f);
    }
}

/* ---- rotations ---- */

/* The bytes of a component in the file: 1, 2 or 4. */
static double component_bytes(const nkw_document_animation *a, size_t index)
{
    const nkw_track *track = &a->tracks[index].track;
    double numbers = (double)track->count * (track->interpolation == NKW_INTERPOLATION_CUBICSPLINE ? 12.0 : 4.0);
    return numbers > 0.0 ? ((double)a->channels[index].bytes - 4.0 * (double)track->count) / numbers : 4.0;
}

/* How far the length of a quaternion may be from 1: four components in 8 bits, in 16 bits, with three decimals. */
static double length_bound(const nkw_document_animation *a, size_t index)
{
    return component_bytes(a, index) < 1.5 ? 1.0 / 127.0 : 1e-3;
}

/* Differences of lengths from 1 by the rounding of floats. */
#define ROUNDED_UNIT 1e-5

static void check_units(check *c, size_t animation, size_t index)
{
    const nkw_document_animation *a = &c->document->animations[animation];
    const nkw_track *track = &a->tracks[index].track;
    double bound = length_bound(a, index), worst = 0.0;
    long at = -1;
    for (size_t k = 0; k < track->count; k++) {
        const float *q = check_value(track, k);
        double squares = 0.0;
        for (int i = 0; i < 4; i++)
            squares += (double)q[i] * (double)q[i];
        double off = fabs(sqrt(squares) - 1.0);
        if (off > bound) {
            finding f = check_finding(c, animation, index, (long)k, SEVERITY_WARNING, "not-unit");
            f.level = off > 1e-2 ? SEVERITY_ERROR : SEVERITY_WARNING;
            f.amount = sqrt(squares);
            snprintf(f.detail, sizeof f.detail, "the length of the quaternion is %.6g", sqrt(squares));
            findings_add(&c->found, &f);
        } else if (off > worst) {
            worst = off;
            at = (long)k;
        }
    }
    if (worst <= ROUNDED_UNIT || track->kind == NKW_TRACK_ROTATION_NORMALIZED)
        return;
    finding f = check_finding(c, animation, index, at, SEVERITY_NOTE, "rounded-unit");
    f.amount = worst;
    snprintf(f.detail, sizeof f.detail, "lengths of quaternions differ from 1 by up to %.2g", worst);
    findings_add(&c->found, &f);
}

/* Two neighbouring keys, the arc as given in 0..360 degrees: 2 acos (a.b / |a||b|). */
static void check_arc(check *c, size_t animation, size_t index, size_t k, int cubic)
{
    const nkw_track *track = &c->document->animations[animation].tracks[index].track;
    const float *a = check_value(track, k - 1), *b = check_value(track, k);
    double dot = 0.0, aa = 0.0, bb = 0.0;
    for (int i = 0; i < 4; i++) {
        dot += (double)a[i] * (double)b[i];
        aa += (double)a[i] * (double)a[i];
        bb += (double)b[i] * (double)b[i];
    }
    double cosine = dot / sqrt(aa * bb), angle = 2.0 * acos(fmax(-1.0, fmin(1.0, cosine))) * 57.29577951308232;
    finding f = check_finding(c, animation, index, (long)k, SEVERITY_WARNING, "sign-flip");
    f.amount = angle;
    if (!(cosine < 1e-6))
        return;
    if (cosine > -1e-6) {
        f.level = SEVERITY_NOTE;
        f.what = "half-turn";
        snprintf(f.detail, sizeof f.detail, "half a turn from the key before it: rounding decides the direction");
    } else if (cubic) {
        f.what = "long-way";
        snprintf(f.detail, sizeof f.detail, "CUBICSPLINE turns %.6g degrees from the key before it, not %.6g", angle,
                 360.0 - angle);
    } else if (angle > 269.9) {
        f.level = SEVERITY_NOTE;
        snprintf(f.detail, sizeof f.detail, "its sign is opposite to the key before it, %.6g %s away", 360.0 - angle,
                 fabs(359.0 - angle) < 5e-7 ? "degree" : "degrees");
    } else {
        f.what = "over-half-turn";
        snprintf(f.detail, sizeof f.detail, "%.6g degrees from the key before it: LINEAR turns back by %.6g", angle,
                 360.0 - angle);
    }
    findings_add(&c->found, &f);
}

static void check_arcs(check *c, size_t animation, size_t index)
{
    const nkw_track *track = &c->document->animations[animation].tracks[index].track;
    for (size_t k = 1; k < track->count; k++) {
        nkw_interpolation mode =
            track->key_interpolation ? (nkw_interpolation)track->key_interpolation[k - 1] : track->interpolation;
        if (mode != NKW_INTERPOLATION_STEP)
            check_arc(c, animation, index, k, mode == NKW_INTERPOLATION_CUBICSPLINE);
    }
}

/* ---- scales ---- */

static void check_scales(check *c, size_t animation, size_t index)
{
    const nkw_track *track = &c->document->animations[animation].tracks[index].track;
    for (size_t k = 0; k < track->count; k++) {
        const float *v = check_value(track, k);
        double least = fmin((double)v[0], fmin((double)v[1], (double)v[2]));
        if (!(least <= 0.0))
            continue;
        const severity level = least < 0.0 ? SEVERITY_WARNING : SEVERITY_NOTE;
        finding f = check_finding(c, animation, index, (long)k, level, "non-positive-scale");
        f.amount = least;
        snprintf(f.detail, sizeof f.detail, "scale %.6g %.6g %.6g", (double)v[0], (double)v[1], (double)v[2]);
        findings_add(&c->found, &f);
    }
}

static void check_added(check *c, size_t animation, size_t index)
{
    const size_t added = c->document->animations[animation].channels[index].added;
    if (added == 0)
        return;
    finding f = check_finding(c, animation, index, -1, SEVERITY_NOTE, "added-keys");
    f.amount = (double)added;
    snprintf(f.detail, sizeof f.detail, "%zu %s between angles that turn by half a turn or more",
             COUNT(added, "key", "keys"));
    findings_add(&c->found, &f);
}

void check_track(check *c, size_t animation, size_t index)
{
    const nkw_clip_track *track = &c->document->animations[animation].tracks[index];
    size_t errors = c->found.counts[SEVERITY_ERROR];
    check_times(c, animation, index);
    check_finite(c, animation, index);
    if (c->found.counts[SEVERITY_ERROR] != errors)
        return;
    check_added(c, animation, index);
    if (track->target == NKW_CLIP_ROTATION) {
        check_units(c, animation, index);
        check_arcs(c, animation, index);
    }
    if (track->target == NKW_CLIP_SCALE)
        check_scales(c, animation, index);
}
