/* SPDX-License-Identifier: MIT */
/*
 * Checks a block before it is sampled: all offsets, counts and places, so that sampling does not access memory outside
 * the block and the output. Values of keys, ranges and constants are not checked: they are only computed on.
 *
 * A sample at any time and with any cursors, of a block that passes:
 *
 *     reads                                          bounded by
 *     header, timelines, groups                      check_parts
 *     times[k], modes[k], k < count                  check_timeline; count >= 1, so that key 0 exists
 *     key k, and key k + 1 of k + 1 < count          check_group: count keys of key_words words, and key_words is the
 *                                                    size that lanes, kind and interpolation determine
 *     segments of a packed group                     nkwi_packed_check
 *     base and step of a compact or packed group     check_group: 2 rows * lanes numbers of 32 or 16 bits
 *     blocks; count <= width places of each          check_blocks: the widths add up to `lanes`, so the rows of a key
 *                                                    are exactly as long as its blocks
 *     values of a run                                check_constants
 *     texts of names, up to their NUL                check_names
 *
 *     writes                                         bounded by
 *     places[i]                                      check_places: less than output_limit
 *     place..place + contiguous                      check_blocks: at most output_limit
 *     to..to + count - 1 of a run                    check_constants: at most output_limit; of a fill CLIP_FILL or more
 *
 * The search accepts any finite ascending times. A mode of a segment that the group does not store would read rows that
 * do not exist: check_modes.
 */
#include "lane/strict.h"

#include <nakawari/clip.h>
#include <nakawari/segment.h>

#include "clip_layout.h"
#include "clip_packed.h"
#include "lane/scalar.h"
#include "curve/segment_search.h"

/*
 * left          words of the block minus the sizes of all parts checked so far. It does not become negative, so the
 *               time of opening and sampling is at most proportional to the size of the block, even if parts overlap.
 * tracks        of the blocks checked so far
 * pose, floats  numbers that the parts write. A clip may state no more joints and floats than that, so that a caller
 *               does not allocate much more memory than the block has.
 */
typedef struct checker {
    const nkw_clip *clip;
    uint64_t left, tracks, pose, floats;
} checker;

static void add_written(checker *o, uint32_t kind, uint64_t count)
{
    *(kind == GROUP_FLOATS ? &o->floats : &o->pose) += kind == GROUP_ROTATIONS ? 4 * count : count;
}

/* Whether `count` elements of `size` words from word `at` on are inside the block. All arguments are less than 2^32. */
static int fits(checker *o, uint64_t at, uint64_t count, uint64_t size)
{
    uint64_t words = count * size;
    if (at + words > o->clip->words || words > o->left)
        return 0;
    o->left -= words;
    return 1;
}

/* The limit of places: the floats; the whole pose; one component array of the rotations, of which there are four. */
static uint64_t output_limit(const nkw_clip *clip, uint32_t kind)
{
    uint64_t stride = NKW_POSE_STRIDE((uint64_t)clip->joints);
    return kind == GROUP_FLOATS ? clip->floats : kind == GROUP_ROTATIONS ? stride : 10 * stride;
}

/* Whether the places of block i are inside the clip, and each is less than the limit. */
static int check_places(checker *o, const clip_group *g, uint32_t i, uint64_t limit)
{
    const clip_block *b = clip_blocks(o->clip, g) + i;
    if (!fits(o, g->blocks + (uint64_t)i * (sizeof *b / 4) + b->place, b->count, 1))
        return 0;
    for (uint32_t k = 0; k < b->count; k++)
        if (block_places(b)[k] >= limit)
            return 0;
    return 1;
}

/* The index of the first track of a block whose places are checked, and the lanes in which tracks begin. */
static int check_starts(checker *o, const clip_group *g, const clip_block *b)
{
    if (b->first != o->tracks || (uint64_t)b->starts >> b->count)
        return 0;
    for (uint32_t i = 0; i < b->count; i++)
        if (b->starts >> i & 1 && !clip_begins(o->clip, g->kind, clip_place_of(b, i)))
            return 0;
    o->tracks += clip_starts(b);
    return 1;
}

/*
 * All blocks have width 16, except the last. All places, also those of contiguous lanes, are less than the limit.
 * Contiguous lanes end with a block: at a multiple of 16, or with the group.
 */
static nkw_result check_blocks(checker *o, const clip_group *g)
{
    if (!fits(o, g->blocks, g->block_count, sizeof(clip_block) / 4))
        return NKW_OUT_OF_RANGE;
    const clip_block *blocks = clip_blocks(o->clip, g);
    uint64_t limit = output_limit(o->clip, g->kind), lanes = 0;
    for (uint32_t i = 0; i < g->block_count; i++) {
        const clip_block *b = &blocks[i];
        int is_last = i + 1 == g->block_count;
        if (b->width != CLIP_BLOCK && (!is_last || (b->width != 4 && b->width != 8)))
            return NKW_OUT_OF_RANGE;
        int is_run =
            b->contiguous <= g->lanes - lanes && (b->contiguous % CLIP_BLOCK == 0 || lanes + b->contiguous == g->lanes);
        if (b->count > b->width || !is_run || (b->contiguous && (uint64_t)b->place + b->contiguous > limit) ||
            (!b->contiguous && !check_places(o, g, i, limit)) || !check_starts(o, g, b))
            return NKW_OUT_OF_RANGE;
        lanes += b->width;
        add_written(o, g->kind, b->count);
    }
    return lanes == g->lanes ? NKW_OK : NKW_OUT_OF_RANGE;
}

static nkw_result check_times(const clip_timeline *line, const float *times)
{
    for (uint32_t k = 0; k < line->count; k++) {
        if (!lane_is_finite(times[k]))
            return NKW_NOT_FINITE;
        if (k > 0 && times[k] < times[k - 1])
            return NKW_NOT_ASCENDING;
    }
    return line->rate == 0.0f || segment_is_even(times, line->count, line->rate) ? NKW_OK : NKW_NOT_ASCENDING;
}

static nkw_result check_timeline(checker *o, const clip_timeline *line)
{
    if (line->count == 0 || !fits(o, line->times, line->count, 1) ||
        (line->modes && !fits(o, line->modes, line->count, 1)))
        return NKW_OUT_OF_RANGE;
    return check_times(line, clip_floats(o->clip, line->times));
}

/* Whether the rows of the group suffice for all modes: LINEAR stores what STEP needs, CUBICSPLINE what all need. */
static int check_modes(const nkw_clip *clip, const clip_timeline *line, const clip_group *g)
{
    uint32_t most =
        g->interpolation == NKW_INTERPOLATION_CUBICSPLINE ? NKW_INTERPOLATION_CUBICSPLINE : NKW_INTERPOLATION_STEP;
    for (uint32_t k = 0; line->modes && k < line->count; k++)
        if (g->interpolation == NKW_INTERPOLATION_STEP || clip_words(clip)[line->modes + k] > most)
            return 0;
    return 1;
}

/* The keys: count keys of key_words words, or the segments of a packed group. */
static int check_keys(checker *o, const clip_group *g, const clip_timeline *line)
{
    uint64_t words = 0;
    if (!g->packed)
        return g->key_words == clip_key_words(g) && fits(o, g->keys, line->count, g->key_words);
    if (g->interpolation != NKW_INTERPOLATION_LINEAR || !g->ranges || line->modes || line->count < 2 ||
        !nkwi_packed_check(o->clip, g, line->count, &words) || words > o->left)
        return 0;
    o->left -= words;
    return 1;
}

static nkw_result check_group(checker *o, const clip_group *g)
{
    const nkw_clip *clip = o->clip;
    if (g->timeline >= clip->timeline_count || g->kind >= GROUP_KINDS ||
        g->interpolation > NKW_INTERPOLATION_CUBICSPLINE || g->lanes == 0 || g->lanes > clip->words)
        return NKW_OUT_OF_RANGE;
    if (g->normalized && g->kind != GROUP_ROTATIONS)
        return NKW_OUT_OF_RANGE;
    if (g->ranges && (g->interpolation == NKW_INTERPOLATION_CUBICSPLINE || g->lanes % 4 != 0 ||
                      !fits(o, g->ranges, g->lanes, (g->packed ? 1 : 2) * clip_rows(g))))
        return NKW_OUT_OF_RANGE;
    const clip_timeline *line = clip_timelines(clip) + g->timeline;
    if (!check_keys(o, g, line))
        return NKW_OUT_OF_RANGE;
    return check_modes(clip, line, g) ? check_blocks(o, g) : NKW_OUT_OF_RANGE;
}

static nkw_result check_constants(checker *o, uint32_t at, uint32_t count, uint32_t kind)
{
    if (!fits(o, at, count, sizeof(clip_run) / 4))
        return NKW_OUT_OF_RANGE;
    const clip_run *runs = (const clip_run *)(const void *)(clip_words(o->clip) + at);
    for (uint32_t r = 0; r < count; r++) {
        const uint32_t n = clip_run_floats(&runs[r]);
        if (!fits(o, runs[r].values, clip_run_words(&runs[r]), 1) ||
            (uint64_t)runs[r].to + n > output_limit(o->clip, kind) ||
            (n != runs[r].count && (n < CLIP_FILL || kind == GROUP_FLOATS)))
            return NKW_OUT_OF_RANGE;
        add_written(o, kind, n);
    }
    return NKW_OK;
}

/* Every text begins after the offsets and within the section, whose last byte is a NUL. */
static int check_names(checker *o)
{
    const nkw_clip *clip = o->clip;
    const uint64_t least = 1 + (uint64_t)clip->joints, bytes = 4 * (uint64_t)clip->name_words;
    if (clip->name_words == 0)
        return 1;
    if (!fits(o, clip->names, clip->name_words, 1))
        return 0;
    const uint64_t count = clip_name_count(clip);
    if ((count != least && count != least + clip->floats) || bytes <= 4 * count)
        return 0;
    const uint32_t *names = clip_words(clip) + clip->names;
    for (uint64_t k = 0; k < count; k++)
        if (names[k] < 4 * count || names[k] >= bytes)
            return 0;
    return ((const char *)names)[bytes - 1] == 0;
}

static nkw_result check_parts(const nkw_clip *clip)
{
    checker o = {clip, clip->words, 0, 0, 0};
    nkw_result result = NKW_OK;
    if (!fits(&o, clip->timelines, clip->timeline_count, sizeof(clip_timeline) / 4) ||
        !fits(&o, clip->groups, clip->group_count, sizeof(clip_group) / 4))
        return NKW_OUT_OF_RANGE;
    for (uint32_t i = 0; result == NKW_OK && i < clip->timeline_count; i++)
        result = check_timeline(&o, clip_timelines(clip) + i);
    for (uint32_t i = 0; result == NKW_OK && i < clip->group_count; i++)
        result = check_group(&o, clip_groups(clip) + i);
    if (result == NKW_OK)
        result = check_constants(&o, clip->constants, clip->constant_count, GROUP_NUMBERS);
    if (result == NKW_OK)
        result = check_constants(&o, clip->float_constants, clip->float_constant_count, GROUP_FLOATS);
    if (result == NKW_OK && !check_names(&o))
        result = NKW_OUT_OF_RANGE;
    if (result == NKW_OK && (o.pose < 10 * (uint64_t)clip->joints || o.floats < clip->floats))
        result = NKW_OUT_OF_RANGE;
    return result;
}

static nkw_result check_header(const nkw_clip *clip)
{
    if (clip->joints > CLIP_MAX_JOINTS || clip->floats > CLIP_MAX_FLOATS)
        return NKW_OUT_OF_RANGE;
    if (!lane_is_finite(clip->start) || !lane_is_finite(clip->end))
        return NKW_NOT_FINITE;
    return clip->start <= clip->end ? NKW_OK : NKW_NOT_ASCENDING;
}

nkw_result nkw_clip_open(const void *block, size_t bytes, const nkw_clip **clip)
{
    const nkw_clip *head = (const nkw_clip *)block;
    *clip = NULL;
    if (bytes < sizeof *head)
        return NKW_TOO_SMALL;
    if ((uintptr_t)block % sizeof(float) != 0)
        return NKW_NOT_A_CLIP;
    if (head->magic != CLIP_MAGIC || head->version != CLIP_VERSION)
        return NKW_NOT_A_CLIP;
    if (bytes / 4 < head->words || head->words < sizeof *head / 4)
        return NKW_TOO_SMALL;
    nkw_result result = check_header(head);
    if (result == NKW_OK)
        result = check_parts(head);
    *clip = result == NKW_OK ? head : NULL;
    return result;
}
