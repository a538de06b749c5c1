/* SPDX-License-Identifier: MIT */
/*
 * Sampling a clip (clip_layout.h): constants first, then group after group.
 *
 * Invariant: a block that nkw_clip_open or nkw_clip_build returned has every index inside itself, so sampling checks
 * only the size of the pose. Groups come after the constants, so a lane replaces the zero that a run has in its place.
 *
 *     time, seconds                       one search for each timeline
 *       |  find                           nkw_segment: index k, t in 0..1
 *       v
 *     key k, key k + 1                    words g->keys + k * g->key_words
 *       |  hold, linear, cubic,           one loop for each group and mode (batch/clip.c)
 *       |  compact, packed
 *       v
 *     pose, ten component arrays          0      3 s       7 s      10 s         s = stride, in floats
 *                                         | tx ty tz | rx ry rz rw | sx sy sz |
 *
 * Places of numbers count from the beginning of the pose, places of rotations from rx, places of floats from theirs.
 *
 *     case          where             stored keys            loop
 *     float keys    !g->ranges        key_words floats       hold, or linear, or cubic
 *     compact       g->ranges         2 key_words numbers    compact: 16 bits, also where one key is held
 *     packed        g->packed         knots, residuals       packed: both keys are decoded, then interpolated
 */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/arrays.h>
#include <nakawari/clip.h>
#include <nakawari/segment.h>

#include "batch/clip.h"
#include "clip_cache.h"
#include "clip_layout.h"
#include "clip_packed.h"
#include "clip_sample.h"
#include "curve/segment_even.h"
#include "curve/segment_search.h"
#include "pack/slerp.h"

nkw_clip_description nkw_clip_describe(const nkw_clip *clip)
{
    nkw_clip_description d;
    d.joint_count = clip->joints;
    d.float_count = clip->floats;
    d.track_count = clip_track_count(clip);
    d.cursor_count = clip->timeline_count;
    d.cache_bytes = clip_cache_bytes(clip);
    d.bytes = (size_t)clip->words * 4;
    d.start = clip->start;
    d.end = clip->end;
    d.name = clip_name(clip, 0);
    return d;
}

const char *nkw_clip_joint_name(const nkw_clip *clip, size_t joint)
{
    return joint < clip->joints ? clip_name(clip, 1 + joint) : "";
}

const char *nkw_clip_float_name(const nkw_clip *clip, size_t index)
{
    const size_t before = 1 + (size_t)clip->joints;
    return index < clip->floats && clip_name_count(clip) > before ? clip_name(clip, before + index) : "";
}

/* A fill of n floats, at least CLIP_FILL: whole vectors only, so the last ones may be written twice. */
static void copy_fill(const float *values, uint32_t n, float *out)
{
    for (uint32_t i = 0; i < n; i += CLIP_FILL) {
        const float value = values[i / CLIP_FILL];
        float *to = out + (i < n - CLIP_FILL ? i : n - CLIP_FILL);
        for (uint32_t k = 0; k < CLIP_FILL; k++)
            to[k] = value;
    }
}

/* Copies the runs at `at`: the constants, and short gaps between them, which the groups then overwrite. */
void nkwi_clip_copy_runs(const nkw_clip *clip, uint32_t at, uint32_t count, float *out)
{
    const clip_run *runs = (const clip_run *)(const void *)(clip_words(clip) + at);
    for (uint32_t r = 0; r < count; r++) {
        const float *values = clip_floats(clip, runs[r].values);
        const uint32_t n = clip_run_floats(&runs[r]);
        float *to = out + runs[r].to;
        if (runs[r].count & CLIP_IS_FILL)
            copy_fill(values, n, to);
        else
            memcpy(to, values, n * sizeof *to);
    }
}

/*
 * The segment of the time: that of the cursor or a neighbour of it, the one by the rate, or by a search of all keys,
 * all with the same result. The cursor is a hint only: any number is safe. Its segment is tried first, because the rest
 * of the sample then does not wait for the conversion of the time to an index.
 */
nkw_segment nkwi_clip_find(const nkw_clip *clip, const clip_timeline *line, float time, uint32_t *cursor)
{
    const float *times = clip_floats(clip, line->times);
    const segment_times all = segment_times_of(times, line->count);
    nkw_segment segment;
    size_t k;
    if (cursor && line->count > 1 && segment_is_near(all, time, *cursor, &k))
        segment = segment_at(all, time, k);
    else if (line->rate > 0.0f)
        segment = nkwi_segment_find_even(times, line->count, line->rate, time);
    else
        segment = nkw_segment_find(times, line->count, time);
    if (cursor)
        *cursor = (uint32_t)segment.index;
    return segment;
}

/* The first value of a key: at its start; in CUBICSPLINE keys after the in-tangents of all lanes. */
static const float *values_of(const clip_group *g, const float *key)
{
    return key + (g->interpolation == NKW_INTERPOLATION_CUBICSPLINE ? clip_rows(g) * g->lanes : 0);
}

/* The blocks of a group that are sampled, and the lanes before them. */
typedef struct window {
    const clip_block *blocks;
    size_t block_count, lanes;
} window;

/* The rows of a lane that follow one another in a key: of a value, in LINEAR rotations with its arc. */
static size_t rows_together(const clip_group *g)
{
    return g->interpolation == NKW_INTERPOLATION_CUBICSPLINE ? clip_rows(g) : clip_key_rows(g);
}

/* The values of one key: STEP, and at the time of a key. CUBICSPLINE rotations have 4 rows in a value, LINEAR 5. */
static void hold(const clip_group *g, const float *key, const window *w, float *out, size_t stride)
{
    const float *values = values_of(g, key);
    if (g->kind == GROUP_ROTATIONS)
        nkwi_clip_quat_hold(values, rows_together(g), (int)g->normalized, w->blocks, w->block_count, out, stride);
    else
        nkwi_clip_hold(values, w->blocks, w->block_count, out);
}

/* Hermite between the keys a and b. duration: seconds from a to b. */
static void cubic(const clip_group *g, const float *a, const float *b, float duration, float t, const window *w,
                  float *out, size_t stride)
{
    size_t words = clip_rows(g) * g->lanes;
    if (g->kind == GROUP_ROTATIONS)
        nkwi_clip_quat_hermite(a, b, words, duration, t, w->blocks, w->block_count, out, stride);
    else
        nkwi_clip_hermite(a, b, words, duration, t, w->blocks, w->block_count, out);
}

/*
 * A LINEAR segment of rotations that are stored as CUBICSPLINE: they have no arcs, so slerp computes them. a and b are
 * values, 4 rows of `width` lanes for each block; `unit` has those of a, then of b, where keys are not of unit length.
 */
static void slerp_values(const clip_group *g, const float *a, const float *b, float t, const window *w, float *out,
                         size_t stride)
{
    const clip_block *block = w->blocks, *end = block + w->block_count;
    for (; block < end; a += 4 * CLIP_BLOCK, b += 4 * CLIP_BLOCK, block++) {
        const size_t n = block->width;
        float unit[8 * CLIP_BLOCK];
        nkw_quat_view from = block_rows(a, n), to = block_rows(b, n);
        if (g->normalized) {
            nkw_quat_normalize_n(from, block_rows_to(unit, n), n);
            nkw_quat_normalize_n(to, block_rows_to(unit + 4 * n, n), n);
            from = block_rows(unit, n), to = block_rows(unit + 4 * n, n);
        }
        for (size_t i = 0; i < block->count; i++) {
            nkw_quat p = {from.x[i], from.y[i], from.z[i], from.w[i]}, q = {to.x[i], to.y[i], to.z[i], to.w[i]};
            nkw_quat r = quat_slerp_keys(p, q, t);
            float *o = out + (block->contiguous ? block->place + i : block_places(block)[i]);
            o[0] = r.x, o[stride] = r.y, o[2 * stride] = r.z, o[3 * stride] = r.w;
        }
    }
}

/* Lerp or slerp between the keys a and b. */
static void linear(const clip_group *g, const float *a, const float *b, float t, const window *w, float *out,
                   size_t stride)
{
    if (g->kind != GROUP_ROTATIONS)
        nkwi_clip_lerp(values_of(g, a), values_of(g, b), t, w->blocks, w->block_count, out);
    else if (g->interpolation == NKW_INTERPOLATION_CUBICSPLINE)
        slerp_values(g, values_of(g, a), values_of(g, b), t, w, out, stride);
    else
        nkwi_clip_slerp(a, b, t, w->blocks, w->block_count, out, stride);
}

/*
 * Lerp or slerp between the compact keys a and b. If one key is held, a == b and t = 0.
 *
 *     ranges    base of all rows, then step of all rows: number = base + step key, key in 0..65535
 */
static void compact(const nkw_clip *clip, const clip_group *g, const uint16_t *a, const uint16_t *b, float t,
                    const window *w, float *out, size_t stride)
{
    const float *base = clip_floats(clip, g->ranges) + clip_rows(g) * w->lanes, *step = base + clip_rows(g) * g->lanes;
    if (g->kind == GROUP_ROTATIONS)
        nkwi_clip_slerp16(a, b, base, step, t, w->blocks, w->block_count, out, stride);
    else
        nkwi_clip_lerp16(a, b, base, step, t, w->blocks, w->block_count, out);
}

/*
 * Lerp or slerp between the packed keys k and k + 1 of `count` keys, or the value of one of them at its time.
 *
 * What a cache would keep is computed on the stack: at most PACKED_SLOTS / 3 rotations, and the padding of a block. At
 * t = 1 both kept keys are key k + 1 and t becomes 0, which returns it without a rounding of the other key.
 */
static void packed(const nkw_clip *clip, const clip_group *g, uint32_t count, uint32_t k, float t, const window *w,
                   float *out, size_t stride)
{
    const packed_at p = packed_at_key(clip, g, count, k);
    const int held = t == 1.0f;
    float kept[CLIP_KEPT_ROWS * (PACKED_SLOTS / 3 + CLIP_BLOCK)];
    if (g->kind == GROUP_ROTATIONS) {
        nkwi_clip_keep_packed_rotations(&p, held, clip_blocks(clip, g), g->block_count, kept);
        nkwi_clip_kept_slerp16(kept + CLIP_KEPT_ROWS * w->lanes, held ? 0.0f : t, w->blocks, w->block_count, out,
                               stride);
    } else {
        nkwi_clip_keep_packed(&p, held, kept);
        nkwi_clip_lerp(kept + w->lanes, kept + p.numbers + w->lanes, held ? 0.0f : t, w->blocks, w->block_count, out);
    }
}

/*
 * One group at one segment: the cases of nkw_track_sample_segment, in the same order.
 *
 *     last key, or t = 0     hold key k
 *     t = 1                  hold key k + 1
 *     STEP                   hold key k
 *     CUBICSPLINE, LINEAR    interpolate keys k and k + 1
 *
 * a is key k. b is key k + 1, or key k if key k is held, so that no key after the last is read.
 * stride: the distance of the component arrays of rotations, in floats.
 */
static void sample_window(const nkw_clip *clip, const clip_group *g, const clip_timeline *line, nkw_segment at,
                          const window *w, float *out, size_t stride)
{
    const size_t last = line->count - 1, k = at.index < last ? at.index : last, skipped = rows_together(g) * w->lanes;
    const float *times = clip_floats(clip, line->times);
    const uint32_t *a = clip_words(clip) + g->keys + k * g->key_words;
    uint32_t mode = line->modes ? clip_words(clip)[line->modes + k] : g->interpolation;
    int at_end = k < last && at.t == 1.0f,
        at_key = k == last || at.t == 0.0f || at_end || mode == NKW_INTERPOLATION_STEP;
    const uint32_t *b = at_key && !at_end ? a : a + g->key_words;
    const float *p = (const float *)(const void *)a + skipped, *q = (const float *)(const void *)b + skipped;
    if (g->packed) /* at least two keys, so at.index < last */
        packed(clip, g, line->count, (uint32_t)at.index, at.t, w, out, stride);
    else if (g->ranges)
        compact(clip, g, (const uint16_t *)(const void *)(at_end ? b : a) + skipped,
                (const uint16_t *)(const void *)b + skipped, at_key ? 0.0f : at.t, w, out, stride);
    else if (at_key)
        hold(g, q, w, out, stride);
    else if (mode == NKW_INTERPOLATION_CUBICSPLINE)
        cubic(g, p, q, times[k + 1] - times[k], at.t, w, out, stride);
    else
        linear(g, p, q, at.t, w, out, stride);
}

void nkwi_clip_sample_group(const nkw_clip *clip, const clip_group *g, const clip_timeline *line, nkw_segment at,
                            float *out, size_t stride)
{
    const window all = {clip_blocks(clip, g), g->block_count, 0};
    sample_window(clip, g, line, at, &all, out, stride);
}

void nkwi_clip_sample_block(const nkw_clip *clip, const clip_group *g, const clip_timeline *line, nkw_segment at,
                            size_t block, float *out, size_t stride)
{
    const clip_block *b = clip_blocks(clip, g) + block;
    clip_block alone = *b;
    alone.contiguous = alone.contiguous < alone.width ? alone.contiguous : alone.width;
    const window w = {b->contiguous ? &alone : b, 1, block * CLIP_BLOCK};
    sample_window(clip, g, line, at, &w, out, stride);
}

void nkwi_clip_sample_lanes(const nkw_clip *clip, const clip_group *g, const clip_timeline *line, nkw_segment at,
                            size_t block, float out[4 * CLIP_BLOCK])
{
    clip_block alone = clip_blocks(clip, g)[block];
    alone.contiguous = alone.width;
    alone.place = 0;
    const window w = {&alone, 1, block * CLIP_BLOCK};
    sample_window(clip, g, line, at, &w, out, CLIP_BLOCK);
}

/*
 * nkwi_clip_sample_kept, or NULL: without a cache it is not linked. `cursors` are then the words of a cache
 * (clip_cache.h), of which the first timeline_count are the cursors:
 *
 *     words    | cursors | segments | padding | kept floats of group 0 | of group 1 | ...
 *              0         timelines            clip_cache_head           + clip_kept_floats
 */
typedef int sample_kept(const nkw_clip *clip, const clip_group *g, nkw_segment at, uint32_t *segment, float *kept,
                        float *out, size_t stride);

static nkw_result sample(const nkw_clip *clip, float time, uint32_t *cursors, sample_kept *cached, nkw_pose_span pose,
                         float *floats)
{
    size_t stride = NKW_POSE_STRIDE((size_t)clip->joints);
    if (pose.data && pose.joint_count != clip->joints)
        return NKW_MISMATCHED;
    if (pose.data)
        nkwi_clip_copy_runs(clip, clip->constants, clip->constant_count, pose.data);
    if (floats)
        nkwi_clip_copy_runs(clip, clip->float_constants, clip->float_constant_count, floats);
    const clip_group *groups = clip_groups(clip);
    nkw_segment at = {0, 0.0f};
    uint32_t *kept = cached ? cursors + clip_cache_head(clip) : NULL;
    for (uint32_t g = 0; g < clip->group_count; g++) {
        uint32_t i = groups[g].timeline;
        const clip_timeline *line = clip_timelines(clip) + i;
        float *out = groups[g].kind == GROUP_FLOATS ? floats : pose.data;
        size_t kept_words = cached ? clip_kept_floats(&groups[g]) : 0;
        if (g == 0 || i != groups[g - 1].timeline) /* groups of one timeline are neighbours: one search */
            at = nkwi_clip_find(clip, line, time, cursors ? cursors + i : NULL);
        out = out && groups[g].kind == GROUP_ROTATIONS ? out + 3 * stride : out;
        if (out && (!kept_words || !cached(clip, &groups[g], at, cursors + clip->timeline_count + g,
                                           (float *)(void *)kept, out, stride)))
            nkwi_clip_sample_group(clip, &groups[g], line, at, out, stride);
        kept = kept ? kept + kept_words : NULL;
    }
    return NKW_OK;
}

nkw_result nkw_clip_sample(const nkw_clip *clip, float time, uint32_t *cursors, nkw_pose_span pose, float *floats)
{
    return sample(clip, time, cursors, NULL, pose, floats);
}

nkw_result nkw_clip_sample_cached(const nkw_clip *clip, float time, nkw_bytes_span cache, nkw_pose_span pose,
                                  float *floats)
{
    if (!cache.data || cache.bytes < clip_cache_bytes(clip))
        return NKW_TOO_SMALL;
    return sample(clip, time, (uint32_t *)cache.data, nkwi_clip_sample_kept, pose, floats);
}
