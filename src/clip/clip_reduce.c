/* SPDX-License-Identifier: MIT */
/*
 * Reduces a clip: finds the steps of its packed tracks (clip_packed.h) by trials (clip_reduction.h).
 *
 * Invariant: after the search and after each form the block has a clip whose error was measured. A form is built only
 * where it is smaller than the best so far; the source as floats is always within the tolerance.
 *
 *     form                   1             2            3             4             5
 *     keys                   packed        floats       floats        16 bits       16 bits
 *     constant tracks        by tolerance  bit for bit  by tolerance  bit for bit   by tolerance
 *
 *     shares -> step of each track -> survey:  constant   two equal keys, from the first time to the last
 *                                              fits       packed with this step
 *                                              neither    floats, as they are
 */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/clip_reduce.h>

#include "clip_packed.h"
#include "clip_reduction.h"
#include "clip_tracks.h"

/*
 * A form of the clip. The packed one has the smallest keys, but more around them: a clip of few keys is smaller as
 * floats or in 16 bits.
 */
typedef struct reduce_form {
    int is_packed, is_exact; /* is_exact: no track becomes constant */
    nkw_clip_format format;
} reduce_form;

typedef struct reducer {
    nkw_bytes_span block;
    nkw_clip_source trial; /* the tracks of this trial: constant ones have two equal keys */
    nkw_clip_track *tracks;
    float *steps, *values, *times; /* of each track: its step; two values and times, if it is constant */
    packed_extents extents; /* of the tracks of the part */
    int is_measured; /* whether the extents are those of the whole source */
    nkw_work order; /* of the builder */
    reduce_trials trials;
    reduce_form form; /* of the next trial */
    nkw_clip_reduced reached;
} reducer;

/* The memory of the builder is first, because it is aligned to 16 bytes. */
static void set_memory(reducer *r, double *work)
{
    const nkw_clip_source *s = r->trials.source;
    const size_t tracks = s->track_count;
    r->order.bytes = NKW_CLIP_BUILD_WORK(tracks);
    r->order.data = reduce_take(&work, r->order.bytes, 1);
    r->tracks = (nkw_clip_track *)reduce_take(&work, tracks, sizeof *r->tracks);
    r->steps = (float *)reduce_take(&work, tracks, sizeof(float));
    r->values = (float *)reduce_take(&work, 2 * (4 * tracks + s->float_count), sizeof(float));
    r->times = (float *)reduce_take(&work, 2 * tracks, sizeof(float));
    r->extents.tracks = (packed_extent *)reduce_take(&work, tracks, sizeof *r->extents.tracks);
    r->extents.floats = (double *)reduce_take(&work, 2 * s->float_count, sizeof *r->extents.floats);
    r->trial = *s;
    r->trial.tracks = r->tracks;
    nkwi_reduce_begin(&r->trials, &work);
}

/*
 * Sets the tracks of a trial: constant, packed, or as they are. A constant track keeps its first and last time, so the
 * clip begins and ends where its source does; `value` is its middle, twice, in 2 * width floats of each track.
 */
static void set_tracks(reducer *r)
{
    float *value = r->values;
    r->reached.constant_count = r->reached.packed_count = 0;
    for (size_t i = 0; i < r->trial.track_count; i++) {
        const nkw_clip_track *c = &r->trials.part.tracks[i];
        const size_t width = c->track.width;
        float step = r->form.is_exact ? 0.0f : nkwi_reduce_step(&r->trials, i), *times = r->times + 2 * i;
        packed_survey survey = {0, 0};
        if (step > 0.0f)
            survey = nkwi_packed_survey(&r->extents, r->trials.part.tracks, i, step, value);
        r->tracks[i] = *c;
        r->steps[i] = r->form.is_packed && survey.fits && !survey.is_constant ? step : 0.0f;
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

/* Builds a trial into the block and sets the bytes of its clip; without a block it sets the bytes only. */
static nkw_result build(reducer *r, nkw_bytes_span block, size_t *bad)
{
    const clip_packing packing = {r->steps, &r->extents, 0};
    if (!r->is_measured || r->trials.windows)
        nkwi_packed_measure(&r->trials.part, &r->extents);
    r->is_measured = !r->trials.windows;
    set_tracks(r);
    r->trial.format = r->form.format;
    return nkwi_clip_build(&r->trial, r->form.is_packed ? &packing : NULL, block, &r->reached.bytes, bad, r->order);
}

/* Builds the clip with the current shares. */
static nkw_result make(void *user, reduce_made *made, size_t *size, size_t *bad)
{
    reducer *r = (reducer *)user;
    nkw_result result = build(r, r->block, bad);
    made->clip = (const nkw_clip *)r->block.data;
    made->parts = 2;
    *size = r->reached.bytes;
    return result;
}

/* Whether the clip of the current form has less than `least` bytes. */
static int is_smaller(reducer *r, size_t least, size_t *bad)
{
    const nkw_bytes_span none = {NULL, 0};
    (void)build(r, none, bad);
    return r->reached.bytes > 0 && r->reached.bytes < least;
}

/* Builds the smallest form that is within the tolerance, after the search built the smallest packed one. */
static nkw_result make_smallest(reducer *r, size_t *bad)
{
    static const reduce_form forms[] = {
        {0, 1, NKW_CLIP_FLOAT32}, {0, 0, NKW_CLIP_FLOAT32}, {0, 1, NKW_CLIP_UNORM16}, {0, 0, NKW_CLIP_UNORM16}};
    const nkw_clip_reduced packed = r->reached;
    reduce_form best = r->form;
    size_t least = packed.bytes;
    int is_built = 1; /* the packed clip is still in the block */
    for (size_t i = 0; i < sizeof forms / sizeof *forms; i++) {
        r->form = forms[i];
        if (!is_smaller(r, least, bad))
            continue;
        nkw_result result = nkwi_reduce_try(&r->trials, bad);
        if (result != NKW_OK)
            return result;
        is_built = 0;
        if ((float)r->trials.share <= (float)r->trials.limit)
            best = r->form, least = r->reached.bytes;
    }
    r->form = best;
    r->reached = packed;
    *bad = 0;
    return is_built ? NKW_OK : nkwi_reduce_try(&r->trials, bad);
}

/* A bound of the bytes of all trials; 0 after an error. */
static nkw_result bound(const nkw_clip_source *source, size_t *bytes, size_t *bad, nkw_work work)
{
    const clip_packing packing = {NULL, NULL, 1};
    const nkw_bytes_span none = {NULL, 0};
    size_t floats = 0, packed = 0;
    *bytes = 0;
    if (source->format != NKW_CLIP_FLOAT32)
        return NKW_BAD_FORMAT;
    if (!nkwi_reduce_has_work(source, work))
        return NKW_TOO_SMALL;
    nkw_result result = nkw_clip_build(source, none, &floats, bad, work);
    if (floats)
        result = nkwi_clip_build(source, &packing, none, &packed, bad, work);
    if (!packed)
        return result;
    *bytes = floats <= SIZE_MAX - packed ? floats + packed : SIZE_MAX;
    return NKW_OK;
}

nkw_result nkw_clip_reduce(const nkw_clip_source *source, const nkw_clip_reduction *reduction, nkw_bytes_span block,
                           nkw_clip_reduced *reduced, size_t *bad, nkw_work work)
{
    const nkw_clip_reduced none = {0, 0, 0, 0.0f, 0.0f, 0.0f};
    reducer r;
    size_t needed = 0, ignored = 0, *offender = bad ? bad : &ignored;
    *reduced = none;
    nkw_result result = bound(source, &needed, offender, work);
    if (result == NKW_OK)
        result = nkwi_reduce_check(source, reduction);
    if (result != NKW_OK)
        return result;
    reduced->bytes = needed;
    if (!block.data || block.bytes < needed)
        return NKW_TOO_SMALL;
    reduced->bytes = 0;
    memset(&r, 0, sizeof r);
    r.block = block;
    r.trials.source = source, r.trials.reduction = reduction, r.trials.make = make, r.trials.user = &r;
    r.trials.limit = 1.0;
    r.form.is_packed = 1;
    set_memory(&r, (double *)work.data);
    result = nkwi_reduce_search(&r.trials, offender);
    if (result == NKW_OK)
        result = make_smallest(&r, offender);
    r.reached.distance = (float)r.trials.errors.distance;
    r.reached.floats = (float)r.trials.errors.floats;
    r.reached.share = (float)r.trials.share;
    if (result == NKW_OK)
        *reduced = r.reached;
    return result;
}
