/* SPDX-License-Identifier: MIT */
/*
 * Writes keys into their lanes: floats as they are, compact keys of 16 bits, arcs.
 *
 * Invariant: every key that is written reads back as the track's sample at that key: floats with the same bits; compact
 * numbers to half a step, one of three to a whole step where the parity needs it.
 *
 *     lane 18 of a group of 20 rotations, 4 rows: block 1 has width 4, i = 2
 *
 *     float   0       16      32      48      64    68    72    76
 *             | x0..15 | y0..15 | z0..15 | w0..15 | x16..19 | y16.. | z16.. | w16.. |     16 * 4 + row * 4 + 2
 */
#include "lane/strict.h"

#include <nakawari/clip.h>

#include "batch/clip.h"
#include "clip_keys.h"
#include "clip_tracks.h"
#include "lane/compact.h"
#include "lane/slerp.h"

float nkwi_clip_value_component(const nkw_clip_track *c, size_t k, size_t component)
{
    nkw_segment at = {k, 0.0f};
    float rotation[4];
    if (c->target != NKW_CLIP_ROTATION)
        return track_value_at(&c->track, k)[component];
    nkw_track_sample_segment(&c->track, at, rotation);
    return rotation[component];
}

/* A component of the in-tangent, value or out-tangent (part 0, 1, 2) of key k; the value if there are no tangents. */
static float key_component(const nkw_clip_track *c, size_t k, size_t part, size_t component)
{
    const nkw_track *t = &c->track;
    if (track_is_cubic(t))
        return t->values[(3 * k + part) * t->width + component];
    return nkwi_clip_value_component(c, k, component);
}

size_t nkwi_clip_lane_at(const clip_group *g, size_t rows, size_t row, size_t lane)
{
    size_t i = lane % CLIP_BLOCK, before = lane - i, left = g->lanes - before;
    return before * rows + row * (left < CLIP_BLOCK ? left : CLIP_BLOCK) + i;
}

void nkwi_clip_fill_component(uint32_t *words, const clip_group *g, const nkw_clip_track *c, size_t component,
                              size_t row, size_t lane)
{
    int cubic = track_is_cubic(&c->track);
    size_t at = nkwi_clip_lane_at(g, cubic ? clip_rows(g) : clip_key_rows(g), row, lane);
    for (size_t k = 0; k < c->track.count; k++)
        for (size_t part = 0; part < (cubic ? 3u : 1u); part++)
            clip_floats_at(words, g->keys + k * g->key_words)[part * clip_rows(g) * g->lanes + at] =
                key_component(c, k, part, component);
}

/*
 * Compact keys. Each row of a lane has a range, base..base + 65535 step, and 16-bit keys in it.
 *
 * q and -q are the same rotation. Which of them is stored determines the three numbers, and the sign of the dot product
 * with the previous key, which slerp needs. The builder computes this sign from the source, where it is exact also near
 * half a turn, and stores it as the parity of the sum of the three numbers.
 *
 *     w of the source       0.9    0.2   -0.3   -0.1     0.4        dot products with the key before are positive
 *     stored, lowest 0      q      q     -q     -q       q
 *     negated               0      0     1      0        1          parity: slerp from the key before negates this one
 *
 * With lowest = -1/2 all five are stored as they are: their numbers are in -sqrt 3..sqrt 3, not in -1..1, but no jump
 * from q to -q widens their range.
 */

/* The iterator of the keys of a lane: next_key is called for k = 0, 1, 2, ... in this order. */
typedef struct compact_keys {
    const nkw_clip_track *c;
    size_t component;
    double lowest; /* the smallest w of a stored rotation: 0 or -1/2 */
    float sign; /* 1 or -1: the sign by which the last rotation was multiplied */
} compact_keys;

static nkw_quat value_rotation(const nkw_clip_track *c, size_t k)
{
    nkw_quat q = {nkwi_clip_value_component(c, k, 0), nkwi_clip_value_component(c, k, 1),
                  nkwi_clip_value_component(c, k, 2), nkwi_clip_value_component(c, k, 3)};
    return q;
}

/*
 * The numbers of key k: one, or three of a rotation. A rotation is multiplied by the sign that makes its dot product
 * with the previous stored key positive, as slerp does, so that the direction of the arc is that of the source also for
 * half a turn. If its w is then less than `lowest`, it is negated, and the function returns 1.
 */
static unsigned next_key(compact_keys *keys, size_t k, double numbers[3])
{
    if (keys->c->target != NKW_CLIP_ROTATION) {
        numbers[0] = (double)nkwi_clip_value_component(keys->c, k, keys->component);
        return 0;
    }
    nkw_quat q = value_rotation(keys->c, k);
    if (k > 0 && lane_slerp_cosine(value_rotation(keys->c, k - 1), q) < 0.0f)
        keys->sign = -keys->sign;
    double w = (double)keys->sign * (double)q.w, lowest = k > 0 ? keys->lowest : 0.0;
    unsigned negated = w < lowest;
    keys->sign = negated ? -keys->sign : keys->sign;
    lane_compact_numbers(lane_f64_quat_scale(lane_f64_quat_from(q), (double)keys->sign), numbers);
    return negated;
}

/* The least and greatest of each of the numbers of a lane, and the largest difference of the two. */
typedef struct compact_ranges {
    double low[3], high[3], widest;
} compact_ranges;

static compact_ranges ranges_of(compact_keys keys, size_t rows)
{
    compact_ranges r = {{0.0}, {0.0}, 0.0};
    for (size_t k = 0; k < keys.c->track.count; k++) {
        double x[3];
        next_key(&keys, k, x);
        for (size_t i = 0; i < rows; i++) {
            r.low[i] = k == 0 || x[i] < r.low[i] ? x[i] : r.low[i];
            r.high[i] = k == 0 || x[i] > r.high[i] ? x[i] : r.high[i];
            r.widest = r.high[i] - r.low[i] > r.widest ? r.high[i] - r.low[i] : r.widest;
        }
    }
    return r;
}

/* (x - base) / step, clamped to 0..65535; not rounded. base and step are floats, so x may be just outside. */
static double quantized(float base, float step, double x)
{
    double code = step > 0.0f ? (x - (double)base) / (double)step : 0.0;
    return code < 0.0 ? 0.0 : code > (double)CLIP_STEPS ? (double)CLIP_STEPS : code;
}

/*
 * Rounds each number to its nearest step. The sum of the three of a rotation must be odd if it is negated, otherwise
 * even. If it is not, one of them is rounded to its second nearest step: the one that least increases the square of the
 * error. With the rounding error e in steps, |e| <= 1/2, the increase is
 *
 *     ((1 - |e|)^2 - e^2) step^2 = (1 - 2 |e|) step^2
 *
 * If the three steps are equal, the error of the vector of the three is at most one step.
 */
static void encode(const float base[3], const float step[3], const double x[3], size_t rows, unsigned negated,
                   uint16_t codes[3])
{
    double least = 0.0;
    size_t second_row = rows;
    unsigned sum = 0, second = 0;
    for (size_t r = 0; r < rows; r++) {
        double code = quantized(base[r], step[r], x[r]);
        double rounded = code > 0.0 ? code + 0.5 : 0.0; /* no NaN is converted */
        unsigned nearest = (unsigned)rounded;
        double error = code - (double)nearest, magnitude = error < 0.0 ? -error : error;
        double increase = (1.0 - 2.0 * magnitude) * (double)step[r] * (double)step[r];
        if (second_row == rows || increase < least) {
            second_row = r;
            least = increase;
            second = error < 0.0 || nearest == 65535 ? nearest - 1 : nearest + 1;
        }
        codes[r] = (uint16_t)nearest;
        sum += nearest;
    }
    if (rows == 3 && sum % 2 != negated)
        codes[second_row] = (uint16_t)second;
}

void nkwi_clip_fill_compact(uint32_t *words, const clip_group *g, const nkw_clip_track *c, size_t component,
                            size_t lane)
{
    size_t rows = clip_rows(g), at[3];
    compact_keys keys = {c, component, 0.0, 1.0f};
    compact_ranges ranges = ranges_of(keys, rows);
    float base[3], step[3];
    if (c->target == NKW_CLIP_ROTATION) {
        compact_keys wide_keys = {c, component, -0.5, 1.0f};
        compact_ranges wide_ranges = ranges_of(wide_keys, rows);
        if (wide_ranges.widest < ranges.widest) {
            keys = wide_keys;
            ranges = wide_ranges;
        }
    }
    for (size_t r = 0; r < rows; r++) {
        at[r] = nkwi_clip_lane_at(g, rows, r, lane);
        base[r] = clip_floats_at(words, g->ranges)[at[r]] = (float)ranges.low[r];
        step[r] = clip_floats_at(words, g->ranges)[rows * g->lanes + at[r]] =
            (float)((ranges.high[r] - (double)base[r]) / (double)CLIP_STEPS);
    }
    for (size_t k = 0; k < c->track.count; k++) {
        uint16_t *key = (uint16_t *)(void *)(words + g->keys + k * g->key_words), codes[3];
        double x[3];
        unsigned negated = next_key(&keys, k, x);
        encode(base, step, x, rows, negated, codes);
        for (size_t r = 0; r < rows; r++)
            key[at[r]] = codes[r];
    }
}

void nkwi_clip_fill_arcs(uint32_t *words, const clip_group *g, size_t key_count)
{
    const clip_block *blocks = (const clip_block *)(const void *)(words + g->blocks);
    for (size_t k = 0; k + 1 < key_count; k++) {
        float *key = clip_floats_at(words, g->keys + k * g->key_words);
        nkwi_clip_arcs(key, key + g->key_words, blocks, g->block_count);
    }
}
