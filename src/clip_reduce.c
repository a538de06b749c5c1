/* SPDX-License-Identifier: MIT */
/*
 * Reduces a clip: finds the steps of its packed tracks (clip_packed.h) by trials.
 *
 * The share of a joint is the distance by which a step of one of its tracks moves a point in model space, in units of
 * the tolerance. A trial builds the clip with these steps and measures the error of each joint, in units of its
 * tolerance. With E, the largest error of the joints below a joint, itself included, divided by AIM, the next share is
 *
 *     E > 1    share E^(-3/4)
 *     E <= 1   share min(3/2, E^(-1/2))
 *
 * So each chain of joints soon reaches the tolerance somewhere. The smallest of the clips that are within the
 * tolerance is built again at the end. If none is, shares of joints beyond it are reduced until one is.
 */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/clip.h>

#include "clip_packed.h"
#include "clip_reduce.h"
#include "clip_tracks.h"
#include "lane/f64.h"
#include "lane/scalar.h"

#define TRIALS      16
#define LAST_TRIALS 12 /* in which shares are only reduced */
#define AIM         0.97

/* shares: of joints, then of tracks of floats; of this trial and of the smallest clip within the tolerance */
typedef struct reducer {
    const nkw_clip_source *source;
    const nkw_clip_reduction *reduction;
    void *block;
    size_t bytes;
    nkw_clip_source trial; /* the tracks of this trial: constant ones have two equal keys */
    nkw_clip_track *tracks;
    float *steps, *values, *times; /* of each track: its step; two values and times, if it is constant */
    uint32_t *order; /* working memory of the builder */
    double *shares, *best, *worst;
    reduce_errors errors;
    nkw_clip_reduced reached;
} reducer;

/* Takes n numbers of `size` bytes of the working memory. */
static void *take(double **work, size_t n, size_t size)
{
    void *at = *work;
    *work += (n * size + sizeof **work - 1) / sizeof **work;
    return at;
}

static void set_memory(reducer *r, double *work)
{
    const size_t tracks = r->source->track_count, joints = r->source->joint_count, floats = r->source->float_count;
    const size_t pose = NKW_POSE_FLOATS(joints), number = sizeof(double);
    r->tracks = (nkw_clip_track *)take(&work, tracks, sizeof *r->tracks);
    r->steps = (float *)take(&work, tracks, sizeof(float));
    r->values = (float *)take(&work, 2 * (4 * tracks + floats), sizeof(float));
    r->times = (float *)take(&work, 2 * tracks, sizeof(float));
    r->order = (uint32_t *)take(&work, NKW_CLIP_WORK(tracks), sizeof(uint32_t));
    r->shares = (double *)take(&work, joints + tracks, number);
    r->best = (double *)take(&work, joints + tracks, number);
    r->worst = (double *)take(&work, joints + tracks, number);
    r->errors.errors = (double *)take(&work, joints + tracks, number);
    r->errors.reach = (double *)take(&work, joints, number);
    r->errors.tight = (double *)take(&work, joints, number);
    r->errors.scale = (double *)take(&work, joints, number);
    for (int i = 0; i < 2; i++) {
        reduce_pose *p = i ? &r->errors.got : &r->errors.want;
        p->pose = (float *)take(&work, pose, sizeof(float));
        p->floats = (float *)take(&work, floats, sizeof(float));
        p->models = (double *)take(&work, 12 * joints, number);
    }
    r->trial = *r->source;
    r->trial.tracks = r->tracks;
}

/* The largest number of joints in a chain through each joint. At first a joint has the same share as its chain. */
static void set_shares(reducer *r)
{
    const size_t joints = r->source->joint_count;
    for (size_t j = 0; j < joints; j++)
        r->worst[j] = 0.0;
    for (size_t j = 0; j < joints; j++) {
        double depth = 1.0;
        for (size_t k = j; reduce_parent(r->reduction, k) != k; k = reduce_parent(r->reduction, k))
            depth += 1.0;
        for (size_t k = j, next = j;; k = next) {
            r->worst[k] = depth > r->worst[k] ? depth : r->worst[k];
            next = reduce_parent(r->reduction, k);
            if (next == k)
                break;
        }
    }
    for (size_t j = 0; j < joints; j++)
        r->shares[j] = 1.0 / lane_sqrt64(r->worst[j]);
    for (size_t i = 0; i < r->source->track_count; i++)
        r->shares[joints + i] = 1.0;
}

/* The step of a track, from the share of its joint. A scale moves points relative to itself. */
static float step_of(const reducer *r, size_t track)
{
    const nkw_clip_track *c = &r->source->tracks[track];
    const reduce_errors *e = &r->errors;
    size_t j = c->index;
    double step = 0.0;
    if (c->target == NKW_CLIP_FLOATS)
        step = r->shares[r->source->joint_count + track] * (double)r->reduction->float_tolerance;
    else if (c->target == NKW_CLIP_TRANSLATION)
        step = r->shares[j] / (e->tight[j] * (e->scale[j] > 0.0 ? e->scale[j] : 1.0));
    else
        step = r->shares[j] / (e->reach[j] > 1e-30 ? e->reach[j] : 1e-30);
    if (c->target == NKW_CLIP_SCALE) {
        const float *s = track_value_at(&c->track, 0);
        double size = lane_abs64((double)s[0]), y = lane_abs64((double)s[1]), z = lane_abs64((double)s[2]);
        size = y > size ? y : size;
        size = z > size ? z : size;
        step *= size > 0.0 ? size : 1.0;
    }
    return step < 1e30 ? step > 1e-30 ? (float)step : 0.0f : 1e30f;
}

/* Sets the tracks of a trial: constant, packed, or as they are. */
static void set_tracks(reducer *r)
{
    float *value = r->values;
    r->reached.constant_count = r->reached.packed_count = 0;
    for (size_t i = 0; i < r->source->track_count; i++) {
        const nkw_clip_track *c = &r->source->tracks[i];
        const size_t width = c->track.width;
        float step = step_of(r, i), *times = r->times + 2 * i;
        packed_survey survey = nkwi_packed_survey(c, step, value);
        survey.is_constant = survey.is_constant && step > 0.0f;
        r->tracks[i] = *c;
        r->steps[i] = survey.fits && !survey.is_constant ? step : 0.0f;
        r->reached.packed_count += r->steps[i] > 0.0f;
        r->reached.constant_count += (size_t)survey.is_constant;
        if (survey.is_constant && c->track.count > 1) {
            times[0] = c->track.times[0];
            times[1] = c->track.times[c->track.count - 1];
            memcpy(value + width, value, width * sizeof *value);
            r->tracks[i].track.times = times;
            r->tracks[i].track.values = value;
            r->tracks[i].track.count = 2;
            r->tracks[i].track.interpolation = NKW_INTERPOLATION_LINEAR;
            r->tracks[i].track.key_interpolation = NULL;
        }
        value += 2 * width;
    }
}

/* Builds and measures the clip with the current shares. */
static nkw_result try_shares(reducer *r, size_t *bad)
{
    set_tracks(r);
    const clip_packing packing = {r->steps};
    nkw_result result =
        nkwi_clip_build(&r->trial, &packing, r->block, r->bytes, bad, r->order, NKW_CLIP_WORK(r->source->track_count));
    if (result != NKW_OK)
        return result;
    const nkw_clip *clip = (const nkw_clip *)r->block;
    nkwi_reduce_errors(r->source, r->reduction, clip, &r->errors);
    double share = 0.0;
    for (size_t i = 0; i < r->source->joint_count + r->source->track_count; i++)
        share = r->errors.errors[i] > share ? r->errors.errors[i] : share;
    r->reached.bytes = nkw_clip_bytes(clip);
    r->reached.distance = (float)r->errors.distance;
    r->reached.floats = (float)r->errors.floats;
    r->reached.share = (float)share;
    return NKW_OK;
}

/* The errors of the joints below each joint, and of the tracks of floats. */
static void set_worst(reducer *r)
{
    const size_t joints = r->source->joint_count;
    memcpy(r->worst, r->errors.errors, (joints + r->source->track_count) * sizeof *r->worst);
    for (size_t j = joints; j-- > 0;) {
        size_t parent = reduce_parent(r->reduction, j);
        r->worst[parent] = r->worst[j] > r->worst[parent] ? r->worst[j] : r->worst[parent];
    }
}

static void change_shares(reducer *r, int only_reduce)
{
    set_worst(r);
    for (size_t i = 0; i < r->source->joint_count + r->source->track_count; i++) {
        double e = r->worst[i] / AIM, root = lane_sqrt64(e);
        double growth = e > 1.0 ? 1.0 / (root * lane_sqrt64(root)) : root > 2.0 / 3.0 ? 1.0 / root : 1.5;
        if (!only_reduce || r->worst[i] > 1.0)
            r->shares[i] *= only_reduce ? AIM * growth : growth;
    }
}

/* The trials; leaves the smallest clip within the tolerance in the block. */
static nkw_result find_shares(reducer *r, size_t *bad)
{
    const size_t count = r->source->joint_count + r->source->track_count;
    size_t least = 0; /* bytes of the best; 0: none yet */
    for (int trial = 0; trial < TRIALS + LAST_TRIALS; trial++) {
        nkw_result result = try_shares(r, bad);
        if (result != NKW_OK)
            return result;
        if (r->reached.share <= 1.0f && (least == 0 || r->reached.bytes < least)) {
            least = r->reached.bytes;
            memcpy(r->best, r->shares, count * sizeof *r->best);
        }
        if (trial + 1 >= TRIALS && least > 0)
            break;
        change_shares(r, trial + 1 >= TRIALS);
    }
    for (size_t i = 0; i < count; i++)
        r->shares[i] = least > 0 ? r->best[i] : 0.0;
    return try_shares(r, bad);
}

static int is_tolerance(float x)
{
    return lane_is_finite(x) && x >= 0.0f;
}

static int is_valid(const nkw_clip_reduction *r, size_t joints)
{
    int valid = is_tolerance(r->tolerance) && is_tolerance(r->distance) && is_tolerance(r->float_tolerance);
    for (size_t j = 0; j < joints; j++)
        valid = valid && (!r->tolerances || is_tolerance(r->tolerances[j])) &&
                (!r->distances || is_tolerance(r->distances[j]));
    return valid;
}

static int has_memory(const nkw_clip_source *s, size_t work_count)
{
    const size_t most = (size_t)-1 / 4096;
    return s->track_count < most && s->joint_count < most && s->float_count < most &&
           work_count >= NKW_CLIP_REDUCE_WORK(s->track_count, s->joint_count, s->float_count);
}

nkw_result nkw_clip_reduce_measure(const nkw_clip_source *source, size_t *bytes, size_t *bad_track, double *work,
                                   size_t work_count)
{
    const clip_packing packing = {NULL};
    size_t packed = 0, count = NKW_CLIP_WORK(source->track_count);
    uint32_t *order = (uint32_t *)(void *)work;
    if (source->format != NKW_CLIP_FLOAT32)
        return NKW_BAD_FORMAT;
    if (!has_memory(source, work_count))
        return NKW_TOO_SMALL;
    nkw_result result = nkw_clip_measure(source, bytes, bad_track, order, count);
    if (result == NKW_OK)
        result = nkwi_clip_measure(source, &packing, &packed, bad_track, order, count);
    if (result == NKW_OK)
        *bytes = *bytes <= (size_t)-1 - packed ? *bytes + packed : (size_t)-1;
    return result;
}

nkw_result nkw_clip_reduce(const nkw_clip_source *source, const nkw_clip_reduction *reduction,
                           const nkw_clip_memory *memory, nkw_clip_reduced *reduced, size_t *bad_track)
{
    reducer r;
    size_t bound = 0, bad = 0, *offender = bad_track ? bad_track : &bad;
    nkw_result result = nkw_clip_reduce_measure(source, &bound, offender, memory->work, memory->work_count);
    if (result != NKW_OK)
        return result;
    if (!is_valid(reduction, source->joint_count))
        return NKW_NOT_FINITE;
    if (memory->bytes < bound)
        return NKW_TOO_SMALL;
    memset(&r, 0, sizeof r);
    r.source = source, r.reduction = reduction, r.block = memory->block, r.bytes = memory->bytes;
    set_memory(&r, memory->work);
    nkwi_reduce_reach(source, reduction, &r.errors);
    set_shares(&r);
    result = find_shares(&r, offender);
    if (result == NKW_OK && reduced)
        *reduced = r.reached;
    return result;
}
