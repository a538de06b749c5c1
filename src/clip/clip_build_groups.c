/* SPDX-License-Identifier: MIT */
/*
 * The timelines and groups of a clip (clip_build.h).
 *
 * Invariant: by_group lists the tracks of a timeline one after another, and in it those of a group; constant tracks are
 * last (clip_tracks.h). So a group is a range, and one walk emits everything.
 *
 *     by_group      | 4  7 | 0  2  9 | 1  3 | 5  6 | 8 |
 *     timeline      | A  A | A  A  A | B  B | B  B | constant: a run (clip_build_constants.c)
 *     group         | 0    | 1       | 2    | 3    |
 *     emitted       A 0      1         B 2    3
 *
 * The widths of blocks and the words of a key follow from the number of lanes, which is known only when all are emitted:
 * emit_group and fits_packed run nkwi_clip_build_lanes on a copy of the builder, `probe`, that writes nothing.
 */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/segment.h>

#include "clip_build.h"
#include "clip_keys.h"
#include "curve/segment_even.h"

/* A timeline: its times, and the mode of each segment if the tracks have them. */
static void emit_timeline(clip_builder *b, const nkw_track *t)
{
    size_t at = clip_take(b, SECTION_TIMELINES, sizeof(clip_timeline) / 4);
    size_t times = clip_take(b, SECTION_TIMES, t->count);
    size_t modes = t->key_interpolation ? clip_take(b, SECTION_TIMES, t->count) : 0;
    if (!b->words)
        return;
    clip_timeline line = {(uint32_t)times, (uint32_t)t->count, (uint32_t)modes, 0.0f};
    (void)nkwi_segment_even_rate(t->times, t->count, &line.rate); /* 0 if there is none */
    memcpy(b->words + at, &line, sizeof line);
    memcpy(b->words + times, t->times, t->count * sizeof(float));
    for (size_t k = 0; modes && k < t->count; k++)
        b->words[modes + k] = t->key_interpolation[k];
}

/* Adds the contiguous lanes of a following block whose places continue those of this one; from the last block on. */
static void join_blocks(clip_block *blocks, size_t count)
{
    for (size_t i = count; i-- > 1;)
        if (blocks[i - 1].contiguous && blocks[i].contiguous && blocks[i].place == blocks[i - 1].place + CLIP_BLOCK)
            blocks[i - 1].contiguous += blocks[i].contiguous;
}

/* Ranges and keys of a packed group follow what is before them: few keys are read at once. */
static uint64_t range_words(const clip_group *g)
{
    const uint64_t numbers = (uint64_t)clip_rows(g) * g->lanes;
    return g->packed ? numbers : clip_round_up(2 * numbers, CLIP_ALIGN);
}

/* Whether the keys of the group, stored as floats so far, take less memory as compact keys with their ranges. */
static int is_smaller_compact(const clip_group *g, size_t keys)
{
    clip_group compact = *g;
    compact.ranges = CLIP_ALIGN; /* any value but 0, for clip_rows */
    return range_words(&compact) + clip_round_up(keys * clip_key_words(&compact), CLIP_ALIGN) <
           clip_round_up(keys * clip_key_words(g), CLIP_ALIGN);
}

/* The words of the ranges and keys of a group; then the keys of a packed group, of the tracks of `packed`. */
static void take_keys(clip_builder *b, clip_group *g, const packed_lanes *packed, size_t key_count)
{
    const nkw_clip_source *s = b->tracks.source;
    const uint64_t values = b->start[SECTION_VALUES] + b->used[SECTION_VALUES];
    const int is_counted = b->tracks.packing && !b->words; /* the values do not begin at a multiple of CLIP_ALIGN */
    g->packed = packed != NULL;
    if (!packed)
        clip_take(b, SECTION_VALUES, is_counted ? CLIP_ALIGN - 1 : clip_round_up(values, CLIP_ALIGN) - values);
    if (packed || (s->format == NKW_CLIP_UNORM16 && g->interpolation != NKW_INTERPOLATION_CUBICSPLINE &&
                   is_smaller_compact(g, key_count))) {
        g->ranges = CLIP_ALIGN; /* any value but 0, for clip_rows: the offset follows from the size */
        g->ranges = (uint32_t)clip_take(b, SECTION_VALUES, range_words(g));
    }
    g->key_words = packed ? 0 : (uint32_t)clip_key_words(g);
    g->keys = (uint32_t)clip_take(b, SECTION_VALUES, (uint64_t)g->key_words * key_count);
    if (packed)
        clip_took(b, nkwi_packed_fill(b->words, g, packed, s->tracks, b->tracks.packing));
}

/*
 * A group: `count` tracks with the same key times. The number of lanes determines the widths of blocks and the size of
 * keys, so the lanes are emitted twice: to a copy of the clip_builder that writes nothing, to count them, then to b.
 * packed: NULL, or cleared.
 */
static void emit_group(clip_builder *b, uint32_t timeline, const uint32_t *members, size_t count, packed_lanes *packed)
{
    const nkw_track *first = &b->tracks.source->tracks[members[0]].track;
    clip_group g;
    clip_builder probe = *b;
    probe.words = NULL;
    memset(&g, 0, sizeof g);
    g.timeline = timeline;
    g.kind = (uint32_t)clip_kind_of(&b->tracks.source->tracks[members[0]]);
    g.interpolation = (uint32_t)clip_interpolation_of(first);
    g.normalized = track_is_cubic(first) && clip_is_normalized(first);
    g.lanes = (uint32_t)clip_lanes(nkwi_clip_build_lanes(&probe, &g, members, count, packed).count);
    take_keys(b, &g, packed, first->count);
    const clip_built_lanes l = nkwi_clip_build_lanes(b, &g, members, count, packed);
    size_t at = clip_take(b, SECTION_GROUPS, sizeof g / 4);
    g.blocks = (uint32_t)l.blocks;
    g.block_count = (uint32_t)clip_round_up(l.count, CLIP_BLOCK) / CLIP_BLOCK;
    if (!b->words)
        return;
    join_blocks((clip_block *)(void *)(b->words + g.blocks), g.block_count);
    if (g.kind == GROUP_ROTATIONS && g.interpolation == NKW_INTERPOLATION_LINEAR && !g.ranges)
        nkwi_clip_fill_arcs(b->words, &g, first->count);
    memcpy(b->words + at, &g, sizeof g);
}

/* Whether `count` members have at most PACKED_SLOTS numbers, with all padding. */
static int fits_packed(const clip_builder *b, const uint32_t *members, size_t count)
{
    clip_builder probe = *b;
    packed_lanes ignored;
    clip_group g;
    memset(&g, 0, sizeof g);
    probe.words = NULL;
    size_t rows = b->tracks.source->tracks[members[0]].target == NKW_CLIP_ROTATION ? 3 : 1;
    return rows * clip_lanes(nkwi_clip_build_lanes(&probe, &g, members, count, &ignored).count) <= PACKED_SLOTS;
}

/* Groups of as many members as a packed group may have. */
static void emit_packed_groups(clip_builder *b, uint32_t timeline, const uint32_t *members, size_t count)
{
    while (count > 0) {
        size_t n = count < PACKED_SLOTS / 3 ? count : PACKED_SLOTS / 3;
        packed_lanes packed;
        memset(&packed, 0, sizeof packed);
        while (n > 1 && !fits_packed(b, members, n))
            n--;
        emit_group(b, timeline, members, n, &packed);
        members += n;
        count -= n;
    }
}

/* A group is a range of by_group with equal timeline and equal nkwi_clip_tracks_group. Constant tracks are last. */
void nkwi_clip_build_groups(clip_builder *b)
{
    const clip_tracks *t = &b->tracks;
    const nkw_clip_track *tracks = t->source->tracks;
    size_t from = 0, to = 0, count = t->source->track_count;
    int is_any_packed = 0;
    for (uint32_t lines = 0; from < count && t->timeline[t->by_group[from]] != CLIP_CONSTANT; from = to) {
        uint32_t first = t->by_group[from], line = t->timeline[first];
        while (to < count && t->timeline[t->by_group[to]] == line &&
               nkwi_clip_tracks_group(t, &tracks[t->by_group[to]]) == nkwi_clip_tracks_group(t, &tracks[first]))
            to++;
        if (from == 0 || t->timeline[t->by_group[from - 1]] != line) {
            emit_timeline(b, &tracks[first].track);
            lines++;
        }
        const int is_packed = nkwi_clip_tracks_is_packed(t, &tracks[first]);
        is_any_packed |= is_packed;
        if (is_packed)
            emit_packed_groups(b, lines - 1, t->by_group + from, to - from);
        else
            emit_group(b, lines - 1, t->by_group + from, to - from, NULL);
    }
    clip_take(b, SECTION_VALUES, is_any_packed ? PACKED_PADDING : 0);
}
