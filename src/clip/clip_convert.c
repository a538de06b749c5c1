/* SPDX-License-Identifier: MIT */
/*
 * A block in the other byte order. Its words are converted one by one; then the parts that are not words:
 *
 *     16-bit keys of compact groups, knots of packed ones    a word has two, in the order of the memory
 *     high bytes of knots, widths and slots of a stream,     bytes, in the order of the memory
 *     texts of names
 *
 * Invariant: a word that is read as an offset or a count is in the order of this machine. The header, groups, timelines
 * and offsets are whole words, right after the first loop; parts are found through them.
 *
 *     memory of the other machine     11 22 33 44      a word                   two 16-bit numbers       four bytes
 *     after the first loop            44 33 22 11      right                    their order is wrong     reversed
 *     then                                             -                        22 11 44 33: halves      11 22 33 44
 *
 * The sizes of these parts are those of the block, which is not checked before all are converted. So each part is
 * converted only where it is inside the block, and nkw_clip_open then refuses the block if one was not.
 */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/clip.h>

#include "batch/clip_packed.h"
#include "clip_layout.h"
#include "clip_packed.h"

static uint32_t swapped(uint32_t w)
{
    return w >> 24 | (w >> 8 & 0xff00u) | (w << 8 & 0xff0000u) | w << 24;
}

/* A block whose words are converted. left: words minus those of all parts so far; parts that overlap run out of it. */
typedef struct converter {
    uint32_t *words;
    uint64_t count, left;
} converter;

/* Whether `count` words from `at` on are inside the block. */
static int fits(converter *c, uint64_t at, uint64_t count)
{
    if (at > c->count || count > c->count - at || count > c->left)
        return 0;
    c->left -= count;
    return 1;
}

/* Exchanges the halves of words: two 16-bit numbers. */
static void swap_halves(converter *c, uint64_t at, uint64_t count)
{
    if (!fits(c, at, count))
        return;
    uint32_t *w = c->words + at;
    for (uint64_t i = 0; i < count; i++)
        w[i] = w[i] << 16 | w[i] >> 16;
}

/* Restores the order of bytes. */
static void swap_bytes(converter *c, uint64_t at, uint64_t count)
{
    if (!fits(c, at, count))
        return;
    uint32_t *w = c->words + at;
    for (uint64_t i = 0; i < count; i++)
        w[i] = swapped(w[i]);
}

/* The widths and slots of a stream: of each 8 columns, levels and 8 bytes. */
static void convert_stream(converter *c, uint64_t at)
{
    if (!fits(c, at, 1))
        return;
    uint64_t blocks = ((uint64_t)c->words[at] + PACKED_COLUMNS - 1) / PACKED_COLUMNS;
    swap_bytes(c, at + 1, blocks * (PACKED_LEVELS + PACKED_COLUMNS) / 4);
}

static void convert_packed(converter *c, const clip_group *g, uint32_t count)
{
    uint64_t numbers = clip_rows(g) * (uint64_t)g->lanes, segments = packed_segments(count);
    if (!fits(c, g->keys, segments + 1) || numbers > PACKED_SLOTS)
        return;
    uint32_t wide = c->words[g->keys + segments];
    uint64_t at = g->keys + segments + 1, knot = packed_knot_words((size_t)numbers, wide);
    for (uint64_t k = 0; k <= segments; k++, at += knot) {
        swap_halves(c, at, numbers / 2);
        swap_bytes(c, at + numbers / 2, knot - numbers / 2);
    }
    for (uint64_t s = 0; s < segments; s++)
        convert_stream(c, g->keys + (uint64_t)c->words[g->keys + s]);
}

static void convert_group(converter *c, const nkw_clip *clip, uint64_t i)
{
    const uint64_t at = clip->groups + i * (sizeof(clip_group) / 4);
    clip_group g;
    clip_timeline line;
    memcpy(&g, c->words + at, sizeof g);
    const uint64_t line_at = clip->timelines + g.timeline * (uint64_t)(sizeof line / 4);
    if (!g.ranges || line_at + sizeof line / 4 > c->count)
        return;
    memcpy(&line, c->words + line_at, sizeof line);
    if (g.packed && line.count > 0)
        convert_packed(c, &g, line.count);
    else if (!g.packed)
        swap_halves(c, g.keys, line.count * (uint64_t)g.key_words);
}

static void convert_parts(converter *c)
{
    nkw_clip head;
    memcpy(&head, c->words, sizeof head);
    if (head.name_words > head.joints)
        swap_bytes(c, head.names + (uint64_t)head.joints + 1, (uint64_t)head.name_words - head.joints - 1);
    if (fits(c, head.groups, head.group_count * (uint64_t)(sizeof(clip_group) / 4)))
        for (uint32_t i = 0; i < head.group_count; i++)
            convert_group(c, &head, i);
}

nkw_result nkw_clip_convert(const void *block, size_t bytes, void *out, const nkw_clip **clip)
{
    converter c = {(uint32_t *)out, bytes / 4, bytes / 4};
    *clip = NULL;
    if (bytes < sizeof(nkw_clip))
        return NKW_TOO_SMALL;
    if ((uintptr_t)out % sizeof(float) != 0)
        return NKW_NOT_A_CLIP;
    memmove(out, block, bytes);
    if (c.words[0] == swapped(CLIP_MAGIC)) {
        for (uint64_t i = 0; i < c.count; i++)
            c.words[i] = swapped(c.words[i]);
        if (c.words[1] == CLIP_VERSION)
            convert_parts(&c);
    }
    return nkw_clip_open(out, bytes, clip);
}
