/* SPDX-License-Identifier: MIT */
/*
 * The search for the shares of joints by trials (clip_reduction.h).
 *
 * Invariant: `best` has the shares of the smallest result so far whose error is at most `limit`; `least` is its size, 0
 * while there is none. The result of the last call is made from `best`, or from shares 0.
 *
 *     arrays    | joints ...        | tracks ...    |      shares, best, worst, errors; of tracks only those of floats
 *
 *     trials, of up to 1024 intervals     16 whole                all shares change towards AIM, both ways
 *     of more                             16 of windows           the same
 *                                         2 whole                 the same
 *                                         up to 3 whole           until one is within: shares beyond it shrink
 *     of both                             up to 12 whole          the same, by AIM / 2^i more
 *
 *     error E   4       1.5     1       0.8     1/4       of the joints below a joint, in AIM limits
 *     share *   0.35    0.74    1       1.12    1.5       E^(-3/4) above 1, E^(-1/2) below, at most 3/2
 *
 *     windows   8 of 64 intervals, evenly spaced in the track with the most keys, at multiples of a packed segment
 */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/clip_reduce.h>

#include "clip_reduction.h"
#include "lane/f64.h"
#include "lane/scalar.h"
#include "sizes.h"
#include "track/track_keys.h"
#include "work.h"

#define TRIALS        16
#define WHOLE_TRIALS  2 /* of the whole clip, after windows */
#define SHRINK_TRIALS 3 /* in which shares beyond the tolerance are reduced towards AIM */
#define LAST_TRIALS   12 /* in which they are reduced by more and more */
#define AIM           0.97
#define WINDOWS       8
#define WINDOW_KEYS   (4 * (size_t)PACKED_KEYS)
#define LEAST_WINDOWS (2 * WINDOWS * WINDOW_KEYS) /* intervals, from which on there are windows */

/*
 * Shares to begin with. Errors of the d joints of a chain add up like the steps of a random walk, so each has 1/sqrt d;
 * d is the largest number of joints in a chain through the joint, kept in `worst` meanwhile.
 */
static void set_shares(reduce_trials *r)
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

/* The smallest, not 0, of the largest magnitudes of the components of a track of scales; 1 if all are 0. */
static double size_of_scales(const nkw_track *t)
{
    double largest[3] = {0.0, 0.0, 0.0}, size = 0.0;
    for (size_t k = 0; k < t->count; k++)
        for (size_t i = 0; i < 3; i++) {
            double s = lane_abs64((double)track_value_at(t, k)[i]);
            largest[i] = s > largest[i] ? s : largest[i];
        }
    for (size_t i = 0; i < 3; i++)
        size = largest[i] > 0.0 && (size == 0.0 || largest[i] < size) ? largest[i] : size;
    return size > 0.0 ? size : 1.0;
}

void nkwi_reduce_begin(reduce_trials *t, double **work)
{
    const size_t tracks = t->source->track_count, joints = t->source->joint_count, floats = t->source->float_count;
    const size_t pose = NKW_POSE_FLOATS(joints), number = sizeof(double);
    t->shares = (double *)reduce_take(work, joints + tracks, number);
    t->best = (double *)reduce_take(work, joints + tracks, number);
    t->worst = (double *)reduce_take(work, joints + tracks, number);
    t->sizes = (double *)reduce_take(work, tracks, number);
    t->slices = (nkw_clip_track *)reduce_take(work, tracks, sizeof *t->slices);
    t->errors.errors = (double *)reduce_take(work, joints + tracks, number);
    t->errors.reach = (double *)reduce_take(work, joints, number);
    t->errors.tight = (double *)reduce_take(work, joints, number);
    t->errors.scale = (double *)reduce_take(work, joints, number);
    t->errors.axes = (double *)reduce_take(work, 3 * joints, number);
    for (int i = 0; i < 2; i++) {
        reduce_pose *p = i ? &t->errors.got : &t->errors.want;
        p->pose = (float *)reduce_take(work, pose, sizeof(float));
        p->floats = (float *)reduce_take(work, floats, sizeof(float));
        p->cursors = (uint32_t *)reduce_take(work, tracks, sizeof *p->cursors);
        memset(p->cursors, 0, tracks * sizeof *p->cursors);
        p->models = (lane_f64_affine *)reduce_take(work, joints, sizeof *p->models);
    }
    nkwi_reduce_reach(t->source, t->reduction, &t->errors);
    set_shares(t);
    for (size_t i = 0; i < tracks; i++)
        if (t->source->tracks[i].target == NKW_CLIP_SCALE)
            t->sizes[i] = size_of_scales(&t->source->tracks[i].track);
}

/*
 * translation    share / (tight scale)     in the unit of positions; the parent makes it `scale` times longer at most
 * rotation       share / reach             in radians; one moves a point by `reach` tolerances
 * scale          share / reach * size      a change d of a scale s moves a point by d/s of its distance
 */
float nkwi_reduce_step(const reduce_trials *r, size_t track)
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
    if (c->target == NKW_CLIP_SCALE)
        step *= r->sizes[track];
    return step < 1e30 ? step > 1e-30 ? (float)step : 0.0f : 1e30f;
}

/* ---- windows ---- */

static const nkw_track *longest_track(const nkw_clip_source *s)
{
    const nkw_track *longest = NULL;
    for (size_t i = 0; i < s->track_count; i++)
        if (!longest || s->tracks[i].track.count > longest->count)
            longest = &s->tracks[i].track;
    return longest;
}

/* The keys of a track from the last one that is not after `from` to the first that is not before `to`. */
static nkw_track slice_of(const nkw_track *t, float from, float to)
{
    const size_t low = nkw_segment_find(t->times, t->count, from).index;
    const size_t high = nkw_segment_find(t->times, t->count, to).index;
    const size_t end = high + (t->times[high] < to && high + 1 < t->count);
    nkw_track slice = *t;
    slice.times += low;
    slice.values += low * track_key_size(t);
    slice.key_interpolation = t->key_interpolation ? t->key_interpolation + low : NULL;
    slice.count = end - low + 1;
    return slice;
}

/* The tracks of window w, whose times are measured. Tracks that share their times share one search. */
static void set_window(reduce_trials *r, size_t w)
{
    const nkw_track *longest = longest_track(r->source);
    const size_t last = longest->count - 1 - WINDOW_KEYS;
    const size_t first = last * w / (r->windows - 1) / PACKED_KEYS * PACKED_KEYS;
    r->errors.from = longest->times[first];
    r->errors.to = longest->times[first + WINDOW_KEYS];
    r->part.tracks = r->slices;
    for (size_t i = 0; i < r->source->track_count; i++) {
        r->slices[i] = r->source->tracks[i];
        r->slices[i].track = slice_of(&r->source->tracks[i].track, r->errors.from, r->errors.to);
    }
}

/* ---- trials ---- */

nkw_result nkwi_reduce_try(reduce_trials *r, size_t *bad)
{
    r->size = 0;
    r->part = *r->source;
    nkwi_reduce_no_errors(r->source, &r->errors);
    for (size_t w = 0; w < (r->windows ? r->windows : 1); w++) {
        reduce_made made = {NULL, NULL, 1};
        size_t size = 0;
        if (r->windows)
            set_window(r, w);
        nkw_result result = r->make(r->user, &made, &size, bad);
        if (result != NKW_OK)
            return result;
        nkwi_reduce_errors(&r->part, r->reduction, &made, &r->errors);
        r->size += size;
    }
    r->share = 0.0;
    for (size_t i = 0; i < r->source->joint_count + r->source->track_count; i++)
        r->share = r->errors.errors[i] > r->share ? r->errors.errors[i] : r->share;
    return NKW_OK;
}

static void set_worst(reduce_trials *r)
{
    const size_t joints = r->source->joint_count;
    memcpy(r->worst, r->errors.errors, (joints + r->source->track_count) * sizeof *r->worst);
    for (size_t j = joints; j-- > 0;) {
        size_t parent = reduce_parent(r->reduction, j);
        r->worst[parent] = r->worst[j] > r->worst[parent] ? r->worst[j] : r->worst[parent];
    }
}

/*
 * last: 0 both ways; 1, 2, 3 ... only shares beyond the tolerance are changed, by a factor that decreases, so that
 * tracks whose rounding alone exceeds the tolerance soon have too many steps, and are stored as floats.
 */
static void change_shares(reduce_trials *r, int last)
{
    double factor = AIM;
    for (int i = 1; i < last; i++)
        factor *= 0.5;
    set_worst(r);
    for (size_t i = 0; i < r->source->joint_count + r->source->track_count; i++) {
        double e = r->worst[i] / (AIM * r->limit), root = lane_sqrt64(e);
        double growth = e > 1.0 ? 1.0 / (root * lane_sqrt64(root)) : root > 2.0 / 3.0 ? 1.0 / root : 1.5;
        if (!last || r->worst[i] > r->limit)
            r->shares[i] *= last ? factor * growth : growth;
    }
}

/*
 * both      trials that change shares both ways
 * shrink    trials after them that only reduce shares, while nothing is within the limit; then `last` more, by more
 * least     size of the best, 0: none yet
 * is_best   receives whether the last trial is the best one
 */
typedef struct reduce_round {
    int both, shrink, last;
    size_t least;
    int is_best;
} reduce_round;

static nkw_result try_shares(reduce_trials *r, reduce_round *round, size_t *bad)
{
    const size_t count = r->source->joint_count + r->source->track_count;
    for (int trial = 1; trial <= round->both + round->shrink + round->last; trial++) {
        nkw_result result = nkwi_reduce_try(r, bad);
        if (result != NKW_OK)
            return result;
        const int is_within = (float)r->share <= (float)r->limit;
        round->is_best = is_within && (round->least == 0 || r->size < round->least);
        if (round->is_best) {
            round->least = r->size;
            memcpy(r->best, r->shares, count * sizeof *r->best);
        }
        const int shrinks = trial + 1 - round->both;
        if (trial >= round->both && round->least > 0)
            break;
        change_shares(r, shrinks <= 0 ? 0 : shrinks <= round->shrink ? 1 : shrinks - round->shrink + 1);
    }
    return NKW_OK;
}

/* Whether trials of windows take much less time than those of the whole clip. */
static int has_windows(const nkw_clip_source *s)
{
    const nkw_track *longest = longest_track(s);
    return longest && longest->count > LEAST_WINDOWS;
}

nkw_result nkwi_reduce_search(reduce_trials *r, size_t *bad)
{
    const size_t count = r->source->joint_count + r->source->track_count;
    reduce_round windows = {TRIALS, 0, 0, 0, 0}, whole = {TRIALS, 1, LAST_TRIALS - 1, 0, 0};
    nkw_result result = NKW_OK;
    if (has_windows(r->source)) {
        r->windows = WINDOWS;
        result = try_shares(r, &windows, bad);
        if (windows.least > 0)
            memcpy(r->shares, r->best, count * sizeof *r->shares);
        whole.both = WHOLE_TRIALS, whole.shrink = SHRINK_TRIALS;
    }
    r->windows = 0;
    if (result == NKW_OK)
        result = try_shares(r, &whole, bad);
    for (size_t i = 0; i < count; i++)
        r->shares[i] = whole.least > 0 ? r->best[i] : 0.0;
    return result != NKW_OK || whole.is_best ? result : nkwi_reduce_try(r, bad);
}

static nkw_result check_number(float x)
{
    return !lane_is_finite(x) ? NKW_NOT_FINITE : x < 0.0f ? NKW_OUT_OF_RANGE : NKW_OK;
}

nkw_result nkwi_reduce_check(const nkw_clip_source *source, const nkw_clip_reduction *r)
{
    const float numbers[3] = {r->tolerance, r->distance, r->float_tolerance};
    nkw_result result = NKW_OK;
    for (size_t i = 0; result == NKW_OK && i < 3; i++)
        result = check_number(numbers[i]);
    for (size_t j = 0; result == NKW_OK && j < source->joint_count; j++) {
        result = r->tolerances ? check_number(r->tolerances[j]) : NKW_OK;
        if (result == NKW_OK && r->distances)
            result = check_number(r->distances[j]);
    }
    return result;
}

int nkwi_reduce_has_work(const nkw_clip_source *s, nkw_work work)
{
    const size_t most = (size_t)-1 / 4096;
    return s->track_count < most && s->joint_count < most && s->float_count < most &&
           work_fits(work, NKW_CLIP_REDUCE_WORK(s->track_count, s->joint_count, s->float_count));
}
