/* SPDX-License-Identifier: MIT */
/*
 * Builds the block of a clip: both passes, names and header (clip_build.h). Without a block, nkw_clip_build is pass 1
 * alone.
 */
#include "lane/strict.h"

#include <string.h>

#include "clip_build.h"
#include "track/track_keys.h"

/* Names. */

/* Name 0 is that of the clip, name 1 + j that of joint j, name 1 + joints + i that of float i. */
static const char *name_at(const nkw_clip_names *names, size_t joints, size_t k)
{
    const char *name = k == 0          ? names->clip
                       : k > joints    ? names->floats[k - 1 - joints]
                       : names->joints ? names->joints[k - 1]
                                       : NULL;
    return name ? name : "";
}

static void emit_names(clip_builder *b)
{
    const nkw_clip_names *names = b->tracks.source->names;
    const size_t joints = b->tracks.source->joint_count;
    if (!names)
        return;
    const size_t count = 1 + joints + (names->floats ? b->tracks.source->float_count : 0);
    uint32_t *offsets = b->words ? b->words + b->start[SECTION_NAMES] : NULL;
    uint64_t bytes = 4 * (uint64_t)count;
    for (size_t k = 0; k < count; k++) {
        const char *name = name_at(names, joints, k);
        if (offsets)
            offsets[k] = (uint32_t)bytes;
        do { /* one byte at a time: the library does not import strlen */
            if (offsets)
                ((char *)offsets)[bytes] = *name;
            bytes++;
        } while (*name++);
    }
    clip_take(b, SECTION_NAMES, bytes <= UINT32_MAX ? clip_round_up(bytes, 4) / 4 : (uint64_t)UINT32_MAX + 1);
}

static void emit_header(clip_builder *b, size_t pose_runs, size_t float_runs)
{
    nkw_clip head;
    const nkw_clip_source *s = b->tracks.source;
    memset(&head, 0, sizeof head);
    head.magic = CLIP_MAGIC;
    head.version = CLIP_VERSION;
    head.words = (uint32_t)(b->start[SECTION_VALUES] + b->used[SECTION_VALUES]);
    head.joints = (uint32_t)s->joint_count;
    head.floats = (uint32_t)s->float_count;
    for (size_t i = 0; i < s->track_count; i++) {
        const nkw_track *t = &s->tracks[b->tracks.by_place[i]].track;
        float first = t->times[0], last = t->times[t->count - 1];
        head.start = i == 0 || first < head.start ? first : head.start;
        head.end = i == 0 || last > head.end ? last : head.end;
    }
    head.timelines = (uint32_t)b->start[SECTION_TIMELINES];
    head.timeline_count = (uint32_t)(b->used[SECTION_TIMELINES] / (sizeof(clip_timeline) / 4));
    head.groups = (uint32_t)b->start[SECTION_GROUPS];
    head.group_count = (uint32_t)(b->used[SECTION_GROUPS] / (sizeof(clip_group) / 4));
    head.constants = (uint32_t)b->start[SECTION_RUNS];
    head.constant_count = (uint32_t)pose_runs;
    head.float_constants = (uint32_t)(b->start[SECTION_RUNS] + pose_runs * (sizeof(clip_run) / 4));
    head.float_constant_count = (uint32_t)float_runs;
    head.names = (uint32_t)b->start[SECTION_NAMES];
    head.name_words = (uint32_t)b->used[SECTION_NAMES];
    memcpy(b->words, &head, sizeof head);
}

/* The order of these calls is the order of the elements in each section. */
static void emit_clip(clip_builder *b)
{
    size_t pose_runs = nkwi_clip_build_pose_constants(b), float_runs = nkwi_clip_build_float_constants(b);
    nkwi_clip_build_groups(b);
    emit_names(b);
    if (b->words)
        emit_header(b, pose_runs, float_runs);
}

/*
 * Pass 1: measures all sections, then sets their starts in the order of the enumeration. Leaves `used` at 0 for pass 2.
 * A block must have less than 2^32 - 1 words and fit size_t bytes.
 */
static nkw_result plan(clip_builder *b, const nkw_clip_source *source, const clip_packing *packing, size_t *bytes,
                       size_t *bad, nkw_work work)
{
    memset(b, 0, sizeof *b);
    b->start[SECTION_VALUES] = CLIP_ALIGN; /* any value but 0: an offset 0 of ranges means that there are none */
    nkw_result result = nkwi_clip_tracks_order(source, packing, &b->tracks, bad, work);
    if (result != NKW_OK)
        return result;
    emit_clip(b);
    uint64_t at = sizeof(nkw_clip) / 4;
    for (int s = 0; s < SECTION_COUNT; s++) {
        b->start[s] = at = s == SECTION_VALUES && !packing ? clip_round_up(at, CLIP_ALIGN) : at;
        at += b->used[s];
        b->used[s] = 0;
    }
    b->listed = 0;
    if (at >= UINT32_MAX || at > SIZE_MAX / 4)
        return NKW_OUT_OF_RANGE;
    *bytes = (size_t)at * 4;
    return NKW_OK;
}

/* The same; a compact clip that is not smaller than one of floats becomes one. source: of the caller, in its format. */
static nkw_result plan_smaller(clip_builder *b, nkw_clip_source *source, const clip_packing *packing, size_t *bytes,
                               size_t *bad, nkw_work work)
{
    size_t floats = 0;
    if (source->format != NKW_CLIP_UNORM16)
        return plan(b, source, packing, bytes, bad, work);
    source->format = NKW_CLIP_FLOAT32;
    const nkw_result of_floats = plan(b, source, packing, &floats, bad, work);
    source->format = NKW_CLIP_UNORM16;
    nkw_result result = plan(b, source, packing, bytes, bad, work);
    if (result == NKW_OK && of_floats == NKW_OK && floats <= *bytes) {
        source->format = NKW_CLIP_FLOAT32;
        result = plan(b, source, packing, bytes, bad, work);
    }
    return result;
}

/* With packed tracks: the most words if the block has them, otherwise those that their keys need, which takes longer. */
static nkw_result plan_packed(clip_builder *b, nkw_clip_source *source, clip_packing *packing, nkw_bytes_span block,
                              size_t *bytes, size_t *bad, nkw_work work)
{
    const int counts_only = !block.data && packing->steps;
    packing->is_most = !counts_only;
    nkw_result result = plan_smaller(b, source, packing, bytes, bad, work);
    if (packing->steps && !counts_only && (result == NKW_OUT_OF_RANGE || (result == NKW_OK && block.bytes < *bytes))) {
        packing->is_most = 0;
        result = plan_smaller(b, source, packing, bytes, bad, work);
    }
    return result;
}

nkw_result nkwi_clip_build(const nkw_clip_source *source, const clip_packing *packing, nkw_bytes_span block,
                           size_t *bytes, size_t *bad, nkw_work work)
{
    clip_builder b;
    nkw_clip_source chosen = *source;
    clip_packing copy = {NULL, NULL, 0};
    size_t ignored = 0, needed = 0, *offender = bad ? bad : &ignored;
    *bytes = 0;
    if (packing)
        copy = *packing;
    nkw_result result = packing ? plan_packed(&b, &chosen, &copy, block, &needed, offender, work)
                                : plan_smaller(&b, &chosen, NULL, &needed, offender, work);
    if (result != NKW_OK)
        return result;
    *bytes = needed;
    if (!block.data || block.bytes < needed)
        return NKW_TOO_SMALL;
    memset(block.data, 0, (size_t)b.start[SECTION_VALUES] * sizeof *b.words);
    b.words = (uint32_t *)block.data;
    emit_clip(&b);
    *bytes = (size_t)(b.start[SECTION_VALUES] + b.used[SECTION_VALUES]) * sizeof *b.words;
    return NKW_OK;
}

nkw_result nkw_clip_build(const nkw_clip_source *source, nkw_bytes_span block, size_t *bytes, size_t *bad,
                          nkw_work work)
{
    const nkw_result result = nkwi_clip_build(source, NULL, block, bytes, bad, work);
    for (size_t i = 0; result == NKW_OK && bad && i < source->track_count; i++)
        *bad += nkwi_track_long_way(&source->tracks[i].track) > 0;
    return result;
}
