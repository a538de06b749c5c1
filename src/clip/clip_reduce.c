/* SPDX-License-Identifier: MIT */
/* Reduces a clip: finds the steps of its packed tracks (clip_packed.h) by trials (clip_reduction.h). */
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
    void *block;
    size_t bytes;
    nkw_clip_source trial; /* the tracks of this trial: constant ones have two equal keys */
    nkw_clip_track *tracks;
    float *steps, *values, *times; /* of each track: its step; two values and times, if it is constant */
    uint32_t *order; /* working memory of the builder */
    reduce_trials trials;
    reduce_form form; /* of the next trial */
    nkw_clip_reduced reached;
} reducer;

static void set_memory(reducer *r, double *work)
{
    const nkw_clip_source *s = r->trials.source;
    const size_t tracks = s->track_count;
    r->tracks = (nkw_clip_track *)reduce_take(&work, tracks, sizeof *r->tracks);
    r->steps = (float *)reduce_take(&work, tracks, sizeof(float));
    r->values = (float *)reduce_take(&work, 2 * (4 * tracks + s->float_count), sizeof(float));
    r->times = (float *)reduce_take(&work, 2 * tracks, sizeof(float));
    r->order = (uint32_t *)reduce_take(&work, NKW_CLIP_WORK(tracks), sizeof(uint32_t));
    r->trial = *s;
    r->trial.tracks = r->tracks;
    nkwi_reduce_begin(&r->trials, &work);
}

/* Sets the tracks of a trial: constant, packed, or as they are. */
static void set_tracks(reducer *r)
{
    float *value = r->values;
    r->reached.constant_count = r->reached.packed_count = 0;
    for (size_t i = 0; i < r->trial.track_count; i++) {
        const nkw_clip_track *c = &r->trials.source->tracks[i];
        const size_t width = c->track.width;
        float step = r->form.is_exact ? 0.0f : nkwi_reduce_step(&r->trials, i), *times = r->times + 2 * i;
        packed_survey survey = {0, 0};
        if (step > 0.0f)
            survey = nkwi_packed_survey(c, step, value);
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

/* Sets the source of a trial, and the bytes of its clip. */
static nkw_result measure(reducer *r, size_t *bad)
{
    const clip_packing packing = {r->steps};
    set_tracks(r);
    r->trial.format = r->form.format;
    r->reached.bytes = 0;
    return nkwi_clip_measure(&r->trial, r->form.is_packed ? &packing : NULL, &r->reached.bytes, bad, r->order,
                             NKW_CLIP_WORK(r->trial.track_count));
}

/* Builds the clip with the current shares. */
static nkw_result make(void *user, reduce_made *made, size_t *size, size_t *bad)
{
    reducer *r = (reducer *)user;
    const clip_packing packing = {r->steps};
    nkw_result result = measure(r, bad);
    if (result == NKW_OK)
        result = nkwi_clip_build(&r->trial, r->form.is_packed ? &packing : NULL, r->block, r->bytes, bad, r->order,
                                 NKW_CLIP_WORK(r->trial.track_count));
    made->clip = (const nkw_clip *)r->block;
    made->parts = 2;
    *size = r->reached.bytes;
    return result;
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
        if (measure(r, bad) != NKW_OK || r->reached.bytes >= least)
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

nkw_result nkw_clip_reduce_measure(const nkw_clip_source *source, size_t *bytes, size_t *bad_track, double *work,
                                   size_t work_count)
{
    const clip_packing packing = {NULL};
    size_t packed = 0, count = NKW_CLIP_WORK(source->track_count);
    uint32_t *order = (uint32_t *)(void *)work;
    if (source->format != NKW_CLIP_FLOAT32)
        return NKW_BAD_FORMAT;
    if (!nkwi_reduce_has_work(source, work_count))
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
    result = nkwi_reduce_check(source, reduction);
    if (result == NKW_OK && memory->bytes < bound)
        result = NKW_TOO_SMALL;
    if (result != NKW_OK)
        return result;
    memset(&r, 0, sizeof r);
    r.block = memory->block, r.bytes = memory->bytes;
    r.trials.source = source, r.trials.reduction = reduction, r.trials.make = make, r.trials.user = &r;
    r.trials.limit = 1.0;
    r.form.is_packed = 1;
    set_memory(&r, memory->work);
    result = nkwi_reduce_search(&r.trials, offender);
    if (result == NKW_OK)
        result = make_smallest(&r, offender);
    r.reached.distance = (float)r.trials.errors.distance;
    r.reached.floats = (float)r.trials.errors.floats;
    r.reached.share = (float)r.trials.share;
    if (result == NKW_OK && reduced)
        *reduced = r.reached;
    return result;
}
