/* SPDX-License-Identifier: MIT */
/*
 * Reduces the keys of a clip: finds the tolerances of its tracks by trials (clip_reduction.h).
 *
 * Invariant: a track never has more keys than its source, or than a slice of it in a window, so each trial writes its
 * keys over those of the one before.
 *
 *     block    | nkw_clip_track, n of them | times 0 | values 0 | times 1 | values 1 | ... | modes 0 | modes 1 | ... |
 *                                            count     count * floats of a key               count bytes each, if any
 *
 * The result is the source itself where no trial, not even that of shares 0, is within the tolerance.
 */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/clip_reduce.h>
#include <nakawari/reduce.h>

#include "clip_reduction.h"

#define QUARTERS 4 /* errors are measured at the keys and at 3 times between two */
#define LIMIT    0.98 /* a margin: at 64 times of a segment errors were at most 1e-5 larger than at these four */

/* The block: the tracks; times and values of each track, with as many keys as its source; the modes per key. */
typedef struct key_reducer {
    nkw_clip_track *tracks;
    float *floats;
    unsigned char *modes;
    nkw_clip_source made;
    reduce_trials trials;
    size_t key_count;
} key_reducer;

static size_t add(size_t a, size_t b)
{
    return a <= SIZE_MAX - b ? a + b : SIZE_MAX;
}

static size_t count_keys(const nkw_clip_source *s)
{
    size_t keys = 0;
    for (size_t i = 0; i < s->track_count; i++)
        keys += s->tracks[i].track.count;
    return keys;
}

/* The number of floats of all keys, and the number of keys with a mode of their own; SIZE_MAX if it exceeds size_t. */
static size_t count_floats(const nkw_clip_source *s, size_t *modes)
{
    size_t floats = 0;
    *modes = 0;
    for (size_t i = 0; i < s->track_count; i++) {
        const nkw_track *t = &s->tracks[i].track;
        floats = add(floats, add(t->count, nkw_track_value_count(t)));
        *modes = add(*modes, t->key_interpolation ? t->count : 0);
    }
    return floats;
}

/* Checks the source, as nkw_clip_build does without a block, and computes the bytes of the block of reduced tracks. */
static nkw_result measure(const nkw_clip_source *source, size_t *bytes, size_t *bad, nkw_work work)
{
    const nkw_bytes_span none = {NULL, 0};
    size_t clip_bytes = 0, modes, most = SIZE_MAX / 16;
    if (!nkwi_reduce_has_work(source, work))
        return NKW_TOO_SMALL;
    nkw_result result = nkw_clip_build(source, none, &clip_bytes, bad, work);
    if (!clip_bytes)
        return result;
    const size_t floats = count_floats(source, &modes);
    if (floats > most || modes > most || source->track_count > most / sizeof *source->tracks)
        return NKW_TOO_SMALL;
    *bytes = source->track_count * sizeof *source->tracks + floats * sizeof(float) + modes;
    return NKW_OK;
}

/*
 * Reduces all tracks with the current shares. The size that the search compares is the number of keys, and one more, so
 * that it is never 0: a size of 0 means that there is none yet.
 */
static nkw_result make(void *user, reduce_made *made, size_t *size, size_t *bad)
{
    key_reducer *r = (key_reducer *)user;
    const nkw_clip_source *s = &r->trials.part;
    float *floats = r->floats;
    unsigned char *modes = r->modes;
    r->key_count = 0;
    for (size_t i = 0; i < s->track_count; i++) {
        const nkw_track *t = &s->tracks[i].track;
        const nkw_track_span span = {floats, floats + t->count, modes, t->count};
        r->tracks[i] = s->tracks[i];
        nkw_result result = nkw_track_reduce(t, nkwi_reduce_step(&r->trials, i), span, &r->tracks[i].track, NULL);
        *bad = i;
        if (result != NKW_OK)
            return result;
        floats += t->count + nkw_track_value_count(t);
        modes += t->key_interpolation ? t->count : 0;
        r->key_count += r->tracks[i].track.count;
    }
    *bad = 0;
    *size = r->key_count + 1;
    made->tracks = &r->made;
    made->parts = QUARTERS;
    return NKW_OK;
}

static nkw_result reduce(const nkw_clip_source *source, const nkw_clip_reduction *reduction, void *block,
                         key_reducer *r, size_t *bad, double *work)
{
    size_t modes, floats = count_floats(source, &modes);
    memset(r, 0, sizeof *r);
    r->tracks = (nkw_clip_track *)block;
    r->floats = (float *)(void *)(r->tracks + source->track_count);
    r->modes = (unsigned char *)(void *)(r->floats + floats);
    r->made = *source;
    r->made.tracks = r->tracks;
    r->trials.source = source, r->trials.reduction = reduction, r->trials.make = make, r->trials.user = r;
    r->trials.limit = LIMIT;
    nkwi_reduce_begin(&r->trials, &work);
    return nkwi_reduce_search(&r->trials, bad);
}

nkw_result nkw_clip_source_reduce(const nkw_clip_source *source, const nkw_clip_reduction *reduction,
                                  nkw_bytes_span block, nkw_clip_source_reduced *reduced, size_t *bad, nkw_work work)
{
    const nkw_reduced none = {0, 0, 0.0f, 0.0f, 0.0f};
    const nkw_clip_source from = *source; /* `source` may be that of `reduced` */
    key_reducer r;
    size_t bytes = 0, ignored = 0, *offender = bad ? bad : &ignored;
    reduced->source = from;
    reduced->source.track_count = 0;
    reduced->reached = none;
    reduced->bytes = 0;
    nkw_result result = measure(&from, &bytes, offender, work);
    if (result == NKW_OK)
        result = nkwi_reduce_check(&from, reduction);
    if (result != NKW_OK)
        return result;
    reduced->bytes = bytes;
    if (!block.data || block.bytes < bytes)
        return NKW_TOO_SMALL;
    result = reduce(&from, reduction, block.data, &r, offender, (double *)work.data);
    if (result != NKW_OK) {
        reduced->bytes = 0;
        return result;
    }
    const size_t count = count_keys(&from);
    const nkw_reduced reached = {count, r.key_count, (float)r.trials.errors.distance, (float)r.trials.share,
                                 (float)r.trials.errors.floats};
    const nkw_reduced unchanged = {count, count, 0.0f, 0.0f, 0.0f};
    const int is_within = r.trials.share <= 1.0;
    reduced->source = is_within ? r.made : from;
    reduced->reached = is_within ? reached : unchanged;
    return NKW_OK;
}

/* Adds the differences of `other` at the times of the source; both directions together see the keys of both. */
static void add_difference(const nkw_clip_source *source, const nkw_clip_source *other, reduce_trials *t,
                           nkw_reduced *d)
{
    const reduce_made made = {NULL, other, QUARTERS};
    nkwi_reduce_no_errors(source, &t->errors);
    nkwi_reduce_errors(source, t->reduction, &made, &t->errors);
    float distance = (float)t->errors.distance, floats = (float)t->errors.floats;
    d->distance = distance > d->distance ? distance : d->distance;
    d->floats = floats > d->floats ? floats : d->floats;
    for (size_t i = 0; i < source->joint_count + source->track_count; i++)
        d->share = (float)t->errors.errors[i] > d->share ? (float)t->errors.errors[i] : d->share;
}

nkw_result nkw_clip_source_difference(const nkw_clip_source *source, const nkw_clip_source *other,
                                      const nkw_clip_reduction *reduction, nkw_reduced *difference, nkw_work work)
{
    const nkw_clip_source *larger = source->track_count < other->track_count ? other : source;
    nkw_reduced d = {count_keys(source), count_keys(other), 0.0f, 0.0f, 0.0f};
    reduce_trials trials;
    double *memory = (double *)work.data;
    size_t bytes;
    nkw_result result = measure(source, &bytes, NULL, work);
    if (result == NKW_OK)
        result = measure(other, &bytes, NULL, work);
    if (result == NKW_OK && (source->joint_count != other->joint_count || source->float_count != other->float_count))
        result = NKW_MISMATCHED;
    if (result == NKW_OK)
        result = nkwi_reduce_check(source, reduction);
    if (result != NKW_OK)
        return result;
    memset(&trials, 0, sizeof trials);
    trials.source = larger, trials.reduction = reduction;
    nkwi_reduce_begin(&trials, &memory);
    nkwi_reduce_reach(source, reduction, &trials.errors);
    add_difference(source, other, &trials, &d);
    add_difference(other, source, &trials, &d);
    *difference = d;
    return NKW_OK;
}
