/* SPDX-License-Identifier: MIT */
#include "clip_parts.h"

#include <string.h>

#include <nakawari/clip.h>

#include "batch/clip_packed.h"
#include "clip_layout.h"
#include "clip_packed.h"

/* left: words of the block minus those of all parts so far; parts that overlap run out of it. */
typedef struct walk {
    const uint32_t *words;
    uint64_t count, left;
    clip_visit visit;
    void *user;
} walk;

/* Whether `count` words from `at` on are inside the block. */
static int fits(walk *w, uint64_t at, uint64_t count)
{
    if (at > w->count || count > w->count - at || count > w->left)
        return 0;
    w->left -= count;
    return 1;
}

static void visit(walk *w, clip_part part, uint64_t at, uint64_t count)
{
    if (fits(w, at, count))
        w->visit(w->user, part, at, count);
}

/* The widths and slots of a stream: of each 8 columns, levels and 8 bytes. */
static void walk_stream(walk *w, uint64_t at)
{
    if (!fits(w, at, 1))
        return;
    uint64_t blocks = ((uint64_t)w->words[at] + PACKED_COLUMNS - 1) / PACKED_COLUMNS;
    visit(w, PART_BYTES, at + 1, blocks * (PACKED_LEVELS + PACKED_COLUMNS) / 4);
}

static void walk_packed(walk *w, const clip_group *g, uint32_t count)
{
    uint64_t numbers = clip_rows(g) * (uint64_t)g->lanes, segments = packed_segments(count);
    if (!fits(w, g->keys, segments + 1) || numbers > PACKED_SLOTS)
        return;
    uint32_t wide = w->words[g->keys + segments];
    visit(w, PART_HALVES, g->ranges, numbers);
    uint64_t at = g->keys + segments + 1, knot = packed_knot_words((size_t)numbers, wide);
    for (uint64_t k = 0; k <= segments; k++, at += knot) {
        visit(w, PART_HALVES, at, numbers / 2);
        visit(w, PART_BYTES, at + numbers / 2, knot - numbers / 2);
    }
    for (uint64_t s = 0; s < segments; s++)
        walk_stream(w, g->keys + (uint64_t)w->words[g->keys + s]);
}

static void walk_group(walk *w, const nkw_clip *clip, uint64_t i)
{
    const uint64_t at = clip->groups + i * (sizeof(clip_group) / 4);
    clip_group g;
    clip_timeline line;
    memcpy(&g, w->words + at, sizeof g);
    const uint64_t line_at = clip->timelines + g.timeline * (uint64_t)(sizeof line / 4);
    if (!g.ranges || line_at + sizeof line / 4 > w->count)
        return;
    memcpy(&line, w->words + line_at, sizeof line);
    if (g.packed && line.count > 0)
        walk_packed(w, &g, line.count);
    else if (!g.packed)
        visit(w, PART_HALVES, g.keys, line.count * (uint64_t)g.key_words);
}

void nkwi_clip_parts(const uint32_t *words, uint64_t count, clip_visit take, void *user)
{
    walk w = {words, count, count, take, user};
    nkw_clip head;
    memcpy(&head, words, sizeof head);
    const uint64_t texts = head.names < count ? words[head.names] / 4 : 0; /* after the offsets */
    if (texts > 0 && head.name_words > texts)
        visit(&w, PART_BYTES, head.names + texts, head.name_words - texts);
    if (fits(&w, head.groups, head.group_count * (uint64_t)(sizeof(clip_group) / 4)))
        for (uint32_t i = 0; i < head.group_count; i++)
            walk_group(&w, &head, i);
}
