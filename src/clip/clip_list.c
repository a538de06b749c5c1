/* SPDX-License-Identifier: MIT */
/*
 * The tracks of a clip: listed, and taken out again.
 *
 * Invariant: tracks are numbered by the lanes in which they begin, in the order of groups and blocks. `first` of
 * a block counts those of all blocks before it, so a number is found by bisection of groups, then of blocks.
 *
 *     block            0                  1                  2
 *     lanes            t0 t1 t2 . t3 .    . . t4 t5          t6
 *     starts           1  1  1  0 1  0    0 0 1  1           1       y and z, gaps and padding begin no track
 *     first            0                  4                  6
 *
 * A track's other components are at place + stride and place + 2 stride: its lanes are found by their places.
 */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/clip.h>

#include "clip_keys.h"
#include "clip_layout.h"
#include "clip_sample.h"
#include "clip_tracks.h"
#include "lane/compact.h"
#include "lane/slerp.h"
#include "work.h"

/* A track of a clip: the group of its lanes, and the place of its first number. */
typedef struct listed {
    const clip_group *group;
    nkw_clip_target target;
    uint32_t index, place;
} listed;

static size_t stride_of(const nkw_clip *clip)
{
    return NKW_POSE_STRIDE((size_t)clip->joints);
}

static const clip_timeline *timeline_of(const nkw_clip *clip, const clip_group *g)
{
    return clip_timelines(clip) + g->timeline;
}

static int is_cubic(const clip_group *g)
{
    return g->interpolation == NKW_INTERPOLATION_CUBICSPLINE;
}

/* The property whose first number is at a place. */
static listed listed_at(const nkw_clip *clip, const clip_group *g, uint32_t place)
{
    listed t = {g, NKW_CLIP_FLOATS, place, place};
    if (g->kind == GROUP_FLOATS)
        return t;
    t.index = (uint32_t)(place % stride_of(clip));
    t.target = g->kind == GROUP_ROTATIONS ? NKW_CLIP_ROTATION
               : place < stride_of(clip)  ? NKW_CLIP_TRANSLATION
                                          : NKW_CLIP_SCALE;
    return t;
}

/* The last group whose first track is at most `index`; the groups are not none. */
static const clip_group *group_of(const nkw_clip *clip, size_t index)
{
    const clip_group *groups = clip_groups(clip);
    size_t low = 0, high = clip->group_count;
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2;
        if (clip_blocks(clip, &groups[middle])->first <= index)
            low = middle;
        else
            high = middle;
    }
    return groups + low;
}

/* The last block of the group whose first track is at most `index`. */
static const clip_block *block_of(const nkw_clip *clip, const clip_group *g, size_t index)
{
    const clip_block *blocks = clip_blocks(clip, g);
    size_t low = 0, high = g->block_count;
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2;
        if (blocks[middle].first <= index)
            low = middle;
        else
            high = middle;
    }
    return blocks + low;
}

/* Finds track `index`, by bisection. Returns 0 if it does not exist. */
static int find(const nkw_clip *clip, size_t index, listed *out)
{
    if (index >= clip_track_count(clip))
        return 0;
    const clip_group *g = group_of(clip, index);
    const clip_block *b = block_of(clip, g, index);
    uint32_t lane = 0, starts = b->starts;
    for (size_t k = b->first; k < index; k++)
        starts &= starts - 1;
    while (!(starts >> lane & 1))
        lane++;
    *out = listed_at(clip, g, clip_place_of(b, lane));
    return 1;
}

static nkw_clip_track shape_of(const nkw_clip *clip, const listed *t)
{
    const clip_timeline *line = timeline_of(clip, t->group);
    nkw_clip_track c;
    memset(&c, 0, sizeof c);
    c.target = t->target;
    c.index = t->index;
    c.track.times = clip_floats(clip, line->times);
    c.track.count = line->count;
    c.track.width = t->target == NKW_CLIP_FLOATS ? 1 : t->target == NKW_CLIP_ROTATION ? 4 : 3;
    c.track.kind = t->target != NKW_CLIP_ROTATION ? NKW_TRACK_FLOATS
                   : t->group->normalized         ? NKW_TRACK_ROTATION_NORMALIZED
                                                  : NKW_TRACK_ROTATION;
    c.track.interpolation = (nkw_interpolation)t->group->interpolation;
    return c;
}

/*
 * Writes key k of a rotation that was rounded. sign: 1, or -1 if slerp in the clip negates q from the key before on; 0
 * without slerp.
 *
 * The slerp of the track computes this sign from the dot product c, of the key before and sign q. Rounding may make c
 * negative, of keys about half a turn apart. Then q is moved, so that the track turns in the direction of the clip:
 *
 *     sign q + (2^-21 - c) a, normalised; its dot product with a is 2^-21
 *
 * No clip that was built has a c below -1/2.
 */
static void align(float *values, size_t k, nkw_quat q, float sign)
{
    const nkw_quat a = k > 0 ? track_read_quat(values + 4 * (k - 1)) : q;
    const double c = lane_f64_quat_dot(lane_f64_quat_from(a), lane_f64_quat_from(q)) * (double)sign;
    if (k > 0 && sign != 0.0f && (lane_slerp_cosine(a, q) < 0.0f) != (sign < 0.0f) && c > -0.5) {
        const double part = (double)sign * (0x1p-21 - c);
        lane_f64_quat moved = {(double)q.x + part * (double)a.x, (double)q.y + part * (double)a.y,
                               (double)q.z + part * (double)a.z, (double)q.w + part * (double)a.w};
        q = lane_quat_from_f64(lane_f64_quat_normalize(moved));
    }
    track_write_quat(q, values + 4 * k);
}

/* The lanes of the numbers of a track: one of a rotation or a float, three of the others. Returns 0 if one is missing. */
static int find_lanes(const nkw_clip *clip, const listed *t, size_t lanes[3])
{
    const size_t count = t->group->kind == GROUP_NUMBERS ? 3 : 1;
    for (size_t i = 0; i < count; i++) {
        lanes[i] = clip_lane_of(clip, t->group, t->place + i * stride_of(clip));
        if (lanes[i] == t->group->lanes)
            return 0;
    }
    return 1;
}

/*
 * The triples of the keys, from the lanes of a CUBICSPLINE group.
 *
 *     clip     key k: | in-tangents of all lanes | values | out-tangents |      `part` floats each
 *     track    key k: | in-tangent, width floats | value  | out-tangent  |
 */
static void get_cubic(const nkw_clip *clip, const listed *t, const size_t *lanes, size_t first, const nkw_track *shape,
                      float *values)
{
    const clip_group *g = t->group;
    int is_rotation = g->kind == GROUP_ROTATIONS;
    size_t part = clip_rows(g) * g->lanes;
    for (size_t i = 0; i < shape->width; i++) {
        size_t at = nkwi_clip_lane_at(g, clip_rows(g), is_rotation ? i : 0, lanes[is_rotation ? 0 : i]);
        for (size_t k = 0; k < shape->count; k++)
            for (size_t p = 0; p < 3; p++)
                values[(3 * k + p) * shape->width + i] =
                    clip_floats(clip, g->keys)[(first + k) * g->key_words + p * part + at];
    }
}

int nkwi_clip_cubic_keys(const nkw_clip *clip, const clip_group *g, uint32_t place, size_t k, float values[24])
{
    const listed t = listed_at(clip, g, place);
    nkw_track shape = shape_of(clip, &t).track;
    size_t lanes[3];
    shape.count = 2;
    if (!find_lanes(clip, &t, lanes))
        return 0;
    get_cubic(clip, &t, lanes, k, &shape, values);
    return 1;
}

/* The values of keys of floats. */
static void get_floats(const nkw_clip *clip, const listed *t, const size_t *lanes, const nkw_track *shape,
                       float *values)
{
    const clip_group *g = t->group;
    int is_rotation = g->kind == GROUP_ROTATIONS;
    for (size_t i = 0; i < shape->width; i++) {
        size_t at = nkwi_clip_lane_at(g, clip_key_rows(g), is_rotation ? i : 0, lanes[is_rotation ? 0 : i]);
        for (size_t k = 0; k < shape->count; k++)
            values[k * shape->width + i] = clip_floats(clip, g->keys + (uint32_t)k * g->key_words)[at];
    }
}

/* The rotation of a compact key, as a sample at its time has it. negated: the sign bit if the parity of the key is 1. */
static nkw_quat compact_rotation(nkw_vec3 p, uint32_t negated)
{
    const lane_compact_series series = lane_compact_series_at(0.0f);
    nkw_quat q = lane_compact_quat(p);
    lane_compact_arc arc = lane_compact_arc_between(q, q, negated);
    return lane_compact_slerp(q, q, arc.v, arc.scale_a, arc.scale_b, &series);
}

/*
 * The values of 16-bit keys: base + step key, of a rotation its three numbers. `sum` has the parity of their sum, the
 * sign by which slerp takes the key (clip_layout.h).
 */
static void get_compact(const nkw_clip *clip, const listed *t, const size_t *lanes, const nkw_track *shape,
                        float *values)
{
    const clip_group *g = t->group;
    const float *base = clip_floats(clip, g->ranges), *step = base + clip_rows(g) * g->lanes;
    const int is_rotation = g->kind == GROUP_ROTATIONS, is_linear = g->interpolation == NKW_INTERPOLATION_LINEAR;
    for (size_t k = 0; k < shape->count; k++) {
        const uint16_t *key = (const uint16_t *)(const void *)(clip_words(clip) + g->keys + k * g->key_words);
        float x[3] = {0.0f, 0.0f, 0.0f};
        uint32_t sum = 0;
        for (size_t i = 0; i < (is_rotation ? 3 : shape->width); i++) {
            size_t at = nkwi_clip_lane_at(g, clip_rows(g), is_rotation ? i : 0, lanes[is_rotation ? 0 : i]);
            x[i] = base[at] + step[at] * (float)key[at];
            sum ^= key[at];
        }
        const nkw_vec3 p = {x[0], x[1], x[2]};
        if (is_rotation)
            align(values, k, compact_rotation(p, sum << 31), is_linear ? sum & 1 ? -1.0f : 1.0f : 0.0f);
        else
            memcpy(values + k * shape->width, x, shape->width * sizeof *x);
    }
}

/* The values of packed keys, by a sample of the group, which is small, at each. */
static void get_packed(const nkw_clip *clip, const listed *t, const nkw_track *shape, float *values, float *work)
{
    const clip_group *g = t->group;
    size_t stride = stride_of(clip), pose = NKW_POSE_FLOATS((size_t)clip->joints);
    float *out = work + (g->kind == GROUP_FLOATS ? pose : g->kind == GROUP_ROTATIONS ? 3 * stride : 0);
    for (size_t k = 0; k < shape->count; k++) {
        int is_last = k + 1 == shape->count && k > 0;
        nkw_segment at = {is_last ? k - 1 : k, is_last ? 1.0f : 0.0f};
        nkwi_clip_sample_group(clip, g, timeline_of(clip, g), at, out, stride);
        float x[4];
        for (size_t i = 0; i < shape->width; i++)
            x[i] = out[t->place + i * stride];
        if (g->kind == GROUP_ROTATIONS)
            align(values, k, track_read_quat(x), 1.0f);
        else
            memcpy(values + k * shape->width, x, shape->width * sizeof *x);
    }
}

nkw_result nkw_clip_track_get(const nkw_clip *clip, size_t index, nkw_track_span span, nkw_clip_track *out,
                              nkw_work work)
{
    listed t;
    size_t lanes[3];
    if (!find(clip, index, &t) || !find_lanes(clip, &t, lanes))
        return NKW_OUT_OF_RANGE;
    nkw_clip_track c = shape_of(clip, &t);
    const uint32_t modes = timeline_of(clip, t.group)->modes;
    *out = c;
    if (!span.times || span.key_capacity < c.track.count || (modes && !span.key_interpolation) ||
        !work_fits(work, NKW_CLIP_TRACK_GET_WORK((size_t)clip->joints, (size_t)clip->floats)))
        return NKW_TOO_SMALL;
    if (is_cubic(t.group))
        get_cubic(clip, &t, lanes, 0, &c.track, span.values);
    else if (t.group->packed)
        get_packed(clip, &t, &c.track, span.values, (float *)work.data);
    else if (t.group->ranges)
        get_compact(clip, &t, lanes, &c.track, span.values);
    else
        get_floats(clip, &t, lanes, &c.track, span.values);
    memcpy(span.times, c.track.times, c.track.count * sizeof(float));
    for (size_t k = 0; modes && k < c.track.count; k++)
        span.key_interpolation[k] = (unsigned char)clip_words(clip)[modes + k];
    out->track.times = span.times;
    out->track.values = span.values;
    out->track.key_interpolation = modes ? span.key_interpolation : NULL;
    return NKW_OK;
}
