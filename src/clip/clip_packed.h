/* SPDX-License-Identifier: MIT */
/*
 * Packed groups of a clip: LINEAR keys with as many bits as each segment of them needs.
 *
 * A slot is one number of a lane: the lane itself, or x, y or z of a rotation (lane/compact.h). Slots are in the order
 * of a compact key. Each has a base and a step, of which the upper 16 bits of a float are stored: both are rounded down
 * to 8 binary digits, so steps are up to 1/128 shorter, and the lowest knot is not always 0.
 *
 * Keys are split into segments of PACKED_KEYS intervals; the last one may have fewer. The keys at both ends of
 * a segment are its knots, whole numbers of steps. Between them, the segment is halved again and again: the key in the
 * middle is that of the line between both ends plus a residual, a whole number of steps.
 *
 *     key       0        2        4        6        8       10       12       14       16
 *     level          3   2    3   1   3    2   3    0   3    2   3    1   3    2   3
 *
 * So the two keys around a time depend on two knots and one residual of each level, that of the part lo..hi which
 * contains both and is halved at m:
 *
 *     key k = base + step (line between the knots at k + sum over levels of residual hat(k))
 *     hat(k) = (k - lo)/(m - lo) for k < m, (hi - k)/(hi - m) from m on
 *
 * A segment of n intervals has ceil(log2 n) levels; a part of one interval has no middle, and its residual is 0. A
 * number of a key differs from its track by at most half a step, and motion that is straight for a while needs no
 * bits. Equal knots have equal bits, also the first key and the last. Between two keys numbers are interpolated
 * linearly; rotations are computed at both keys, then slerped. The rotations of a track have the sign that makes each
 * dot product with the key before positive.
 *
 *     group                       words
 *     offset of each segment      1 each, from g->keys on
 *     wide                        1: a bit for each 8 slots, whether their knots have 24 bits
 *     knots                       of each knot: 16 bits of all slots, then 8 more of the wide ones
 *     segments                    a stream each
 *
 * The block ends with two rows of padding, or more: unpacking reads beyond a stream.
 *
 *     stream                      words
 *     columns                     1: how many slots have a residual that is not 0
 *     widths of residuals         of each 8 columns 4 bytes, of levels 0..3
 *     slots of the columns        of each 8 columns 8 bytes
 *     rows                        of 8 columns
 *
 * Rows are words of all columns. A column is a string of bits, from the lowest bit of its first word on. Column i has
 * the residual of level 0 of the slots i, 8 + i, 16 + i ..., then the first of level 1 of these slots, the second one,
 * the first of level 2 ... A residual r of w bits is stored as r + 2^(w-1). Columns are in the order of ascending
 * bits, so that 8 neighbours need about the same.
 */
#ifndef NAKAWARI_CLIP_PACKED_H
#define NAKAWARI_CLIP_PACKED_H

#include <stdint.h>

#include <nakawari/clip.h>

#include "batch/clip_packed.h"
#include "clip_layout.h"

#define PACKED_PADDING (2 * PACKED_COLUMNS) /* words, once at the end of a block with packed groups */

static inline uint32_t packed_segments(uint32_t count)
{
    return (count - 1 + PACKED_KEYS - 1) / PACKED_KEYS;
}

/* The intervals of segment s of `count` keys. */
static inline uint32_t packed_intervals(uint32_t count, uint32_t s)
{
    uint32_t left = count - 1 - s * PACKED_KEYS;
    return left < PACKED_KEYS ? left : PACKED_KEYS;
}

/* The levels of a segment: 2^levels is at least its intervals. */
static inline uint32_t packed_levels(uint32_t intervals)
{
    uint32_t levels = 0;
    while ((uint32_t)1 << levels < intervals)
        levels++;
    return levels;
}

/* The words from the keys of a group to its knots. */
static inline size_t packed_knots(uint32_t count)
{
    return packed_segments(count) + 1;
}

/* What a sample between the keys k and k + 1 of `count` keys reads. */
static inline packed_at packed_at_key(const nkw_clip *clip, const clip_group *g, uint32_t count, uint32_t k)
{
    const uint32_t *keys = clip_words(clip) + g->keys;
    const uint32_t s = k / PACKED_KEYS, wide = keys[packed_segments(count)];
    packed_at p;
    p.numbers = clip_rows(g) * g->lanes;
    p.ranges = (const uint16_t *)(const void *)(clip_words(clip) + g->ranges);
    p.wide = wide;
    p.knots = keys + packed_knots(count) + s * packed_knot_words(p.numbers, wide);
    p.stream = keys + keys[s];
    p.intervals = packed_intervals(count, s);
    p.key = k - s * PACKED_KEYS;
    return p;
}

/* The lanes of a group: of each lane its track, NULL for padding, and its component. */
typedef struct packed_lanes {
    const nkw_clip_track *track[PACKED_SLOTS];
    uint32_t component[PACKED_SLOTS];
} packed_lanes;

/* What one step makes of a track. */
typedef struct packed_survey {
    int fits; /* whether a packed group can store it: its rotations are unit */
    int is_constant; /* whether no number, and no length, leaves the middle of its range by more than half a step */
} packed_survey;

/*
 * The limits of the numbers of all keys of a track: of each component of a translation or scale; of the three of
 * rotations, in the sign in which the lowest w is highest, `sign` of key 0; of w, and of the squared length.
 */
typedef struct packed_extent {
    double low[3], high[3];
    double lowest, highest, shortest, longest, sign;
} packed_extent;

/* Of all tracks of a source. floats: the lowest and the highest of each separate float. */
typedef struct packed_extents {
    packed_extent *tracks;
    double *floats;
} packed_extents;

void nkwi_packed_measure(const nkw_clip_source *source, const packed_extents *out);

/*
 * track   index of the track in the source of the extents
 * step    of numbers; of rotations in radians
 * middle  receives the value in the middle of the range of all keys: width floats
 */
packed_survey nkwi_packed_survey(const packed_extents *extents, const nkw_clip_track *tracks, size_t track, float step,
                                 float *middle);

/*
 * Which tracks are packed.
 *
 * steps    of each track, 0 if it is not; NULL: all that may be
 * extents  of the tracks
 * is_most  whether the words that are only counted are the most that the keys may need
 */
typedef struct clip_packing {
    const float *steps;
    const packed_extents *extents;
    int is_most;
} clip_packing;

/*
 * The keys of a group: writes ranges and keys to `words`, if that is not NULL, whatever was there before.
 *
 * g       with its lanes, and ranges and keys of this block
 * tracks  of the source, in the order of the steps
 * Returns the words of the keys
 */
uint64_t nkwi_packed_fill(uint32_t *words, const clip_group *g, const packed_lanes *lanes, const nkw_clip_track *tracks,
                          const clip_packing *packing);

/* Whether the keys of a packed group of `count` keys are inside the block; `words` receives their sum. */
int nkwi_packed_check(const nkw_clip *clip, const clip_group *g, uint32_t count, uint64_t *words);

#endif
