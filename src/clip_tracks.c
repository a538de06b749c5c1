/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/quat.h>

#include "clip_tracks.h"
#include "lane/scalar.h"
#include "lane/sort.h"

static int same_bits(const float *a, const float *b, size_t n)
{
    return memcmp(a, b, n * sizeof *a) == 0;
}

static int any(const float *v, size_t n, int (*is)(float))
{
    for (size_t i = 0; i < n; i++)
        if (is(v[i]))
            return 1;
    return 0;
}

static int is_not_zero(float x)
{
    return x != 0.0f;
}

static int is_minus_zero(float x)
{
    return lane_bits(x) == 0x80000000u;
}

/* Whether normalising a rotation, as between the keys of a cubic, gives what stands at the keys. */
static int is_settled(const nkw_track *t, const float *v)
{
    nkw_quat q = {v[0], v[1], v[2], v[3]}, unit = nkw_quat_normalize(q);
    return clip_is_normalized(t) || memcmp(&unit, v, sizeof unit) == 0;
}

/* The same bits at every time. Numbers that are -0 may come out of a lerp or a cubic as 0. */
static int is_constant(const nkw_clip_track *c)
{
    const nkw_track *t = &c->track;
    const float *first = clip_track_value(t, 0);
    int turns = c->target == NKW_CLIP_ROTATION;
    if (t->count == 1)
        return 1;
    if ((!turns || clip_is_cubic(t)) && any(first, t->width, is_minus_zero))
        return 0;
    if (turns && clip_is_cubic(t) && !is_settled(t, first))
        return 0;
    for (size_t k = 1; k < t->count; k++) {
        const float *v = clip_track_value(t, k), *before = clip_track_value(t, k - 1);
        float duration = t->times[k] - t->times[k - 1];
        if (!same_bits(v, first, t->width))
            return 0;
        /* A tangent of 0 times a duration that overflows is NaN. */
        if (clip_is_cubic(t) && !lane_is_finite(duration))
            return 0;
        if (clip_is_cubic(t) &&
            (any(before + t->width, t->width, is_not_zero) || any(v - t->width, t->width, is_not_zero)))
            return 0;
    }
    return 1;
}

static int same_timeline(const nkw_track *a, const nkw_track *b)
{
    if (!clip_same_times(a, b) || !a->key_interpolation != !b->key_interpolation)
        return 0;
    return !a->key_interpolation || memcmp(a->key_interpolation, b->key_interpolation, a->count) == 0;
}

uint32_t nkw_clip_tracks_group(const nkw_clip_track *c)
{
    uint32_t cubic_unit = clip_is_cubic(&c->track) && clip_is_normalized(&c->track);
    return (uint32_t)clip_kind_of(c) * 16u + (uint32_t)clip_interpolation_of(&c->track) * 2u + cubic_unit;
}

/* Orders of tracks. */

static int before_by_place(const void *context, uint32_t i, uint32_t j)
{
    const clip_tracks *b = (const clip_tracks *)context;
    const nkw_clip_track *p = &b->source->tracks[i], *q = &b->source->tracks[j];
    return p->target != q->target ? p->target < q->target : p->index != q->index ? p->index < q->index : i < j;
}

static int before_by_group(const void *context, uint32_t i, uint32_t j)
{
    const clip_tracks *b = (const clip_tracks *)context;
    uint32_t p = nkw_clip_tracks_group(&b->source->tracks[i]), q = nkw_clip_tracks_group(&b->source->tracks[j]);
    if (b->timeline[i] != b->timeline[j])
        return b->timeline[i] < b->timeline[j];
    return p != q ? p < q : before_by_place(b, i, j);
}

static void sort(const clip_tracks *b, uint32_t *order, lane_before *before)
{
    for (size_t i = 0; i < b->source->track_count; i++)
        order[i] = (uint32_t)i;
    lane_sort(order, b->source->track_count, before, b);
}

/* Timelines are numbered by the places of their first tracks, not by the order in which tracks are given. */
static void find_timelines(clip_tracks *b)
{
    const nkw_clip_track *tracks = b->source->tracks;
    for (uint32_t k = 0; k < b->source->track_count; k++) {
        uint32_t i = b->by_place[k];
        b->timeline[i] = is_constant(&tracks[i]) ? CLIP_CONSTANT : k;
        for (uint32_t m = 0; m < k && b->timeline[i] == k; m++) {
            uint32_t j = b->by_place[m];
            if (b->timeline[j] == m && same_timeline(&tracks[i].track, &tracks[j].track))
                b->timeline[i] = m;
        }
    }
}

/* Validation. */

nkw_result nkw_clip_tracks_place(const nkw_clip_source *s, const nkw_clip_track *c)
{
    int turns = c->target == NKW_CLIP_ROTATION;
    if (c->track.count >= CLIP_CONSTANT)
        return NKW_OUT_OF_RANGE;
    if ((unsigned)c->target > NKW_CLIP_FLOATS || (c->track.kind != NKW_TRACK_FLOATS) != turns)
        return NKW_BAD_METHOD;
    if (c->target == NKW_CLIP_FLOATS)
        return c->index <= s->float_count && c->track.width <= s->float_count - c->index ? NKW_OK : NKW_OUT_OF_RANGE;
    if (c->track.width != (turns ? 4u : 3u))
        return NKW_BAD_WIDTH;
    return c->index < s->joint_count ? NKW_OK : NKW_OUT_OF_RANGE;
}

static nkw_result check_tracks(const nkw_clip_source *s, size_t *bad)
{
    nkw_result result = s->joint_count + s->float_count == 0                    ? NKW_EMPTY
                        : (unsigned)s->format > (unsigned)NKW_CLIP_UNORM16      ? NKW_BAD_FORMAT
                        : s->rest.data && s->rest.joint_count != s->joint_count ? NKW_MISMATCHED
                                                                                : NKW_OK;
    if (s->track_count >= CLIP_CONSTANT || s->joint_count > CLIP_MOST_JOINTS || s->float_count > CLIP_MOST_FLOATS)
        result = NKW_OUT_OF_RANGE;
    for (size_t i = 0; result == NKW_OK && i < s->track_count; i++) {
        *bad = i;
        result = nkw_track_validate(&s->tracks[i].track, NULL);
        result = result == NKW_OK ? nkw_clip_tracks_place(s, &s->tracks[i]) : result;
    }
    *bad = result == NKW_OK ? 0 : *bad;
    return result;
}

static int move_the_same(const nkw_clip_track *a, const nkw_clip_track *b)
{
    const nkw_clip_track *p = a->index <= b->index ? a : b, *q = p == a ? b : a;
    size_t taken = p->target == NKW_CLIP_FLOATS ? p->track.width : 1;
    return p->target == q->target && q->index - p->index < taken;
}

/* The first track that moves what one before it moves; there is one. */
static size_t first_repeated(const nkw_clip_track *tracks)
{
    for (size_t i = 1;; i++)
        for (size_t j = 0; j < i; j++)
            if (move_the_same(&tracks[j], &tracks[i]))
                return i;
}

/* In the order of places, what two tracks move lies next to each other. */
static nkw_result check_repeated(const clip_tracks *b, size_t *bad)
{
    const nkw_clip_track *tracks = b->source->tracks;
    for (size_t i = 1; i < b->source->track_count; i++) {
        if (!move_the_same(&tracks[b->by_place[i - 1]], &tracks[b->by_place[i]]))
            continue;
        *bad = first_repeated(tracks);
        return NKW_REPEATED;
    }
    return NKW_OK;
}

const nkw_clip_track *nkw_clip_tracks_of(const clip_tracks *t, nkw_clip_target target, size_t index)
{
    const nkw_clip_track *tracks = t->source->tracks;
    size_t low = 0, high = t->source->track_count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        const nkw_clip_track *c = &tracks[t->by_place[middle]];
        if (c->target < target || (c->target == target && c->index <= index))
            low = middle + 1;
        else
            high = middle;
    }
    const nkw_clip_track *last = low > 0 ? &tracks[t->by_place[low - 1]] : NULL;
    size_t width = target == NKW_CLIP_FLOATS && last ? last->track.width : 1;
    return last && last->target == target && index - last->index < width ? last : NULL;
}

/* Gaps between joints that a group moves. */

#define GAP 4 /* joints */

const nkw_clip_track *nkw_clip_tracks_mover(const clip_tracks *t, nkw_clip_target target, size_t index)
{
    const nkw_clip_track *c = nkw_clip_tracks_of(t, target, index);
    return c && t->timeline[c - t->source->tracks] != CLIP_CONSTANT ? c : NULL;
}

int nkw_clip_tracks_same(const clip_tracks *t, const nkw_clip_track *a, const nkw_clip_track *b)
{
    const nkw_clip_track *tracks = t->source->tracks;
    return a && b && t->timeline[a - tracks] == t->timeline[b - tracks] &&
           nkw_clip_tracks_group(a) == nkw_clip_tracks_group(b);
}

/* Whether the way from a number to itself is that number, bit for bit. */
static int is_kept(nkw_clip_target target, float x)
{
    return target == NKW_CLIP_ROTATION ? x >= -2.0f && x <= 2.0f : lane_is_finite(x) && !is_minus_zero(x);
}

static int is_joint_kept(const clip_tracks *t, nkw_clip_target target, size_t joint)
{
    const nkw_clip_track *c = nkw_clip_tracks_of(t, target, joint);
    const float *rest = t->source->rest.data;
    size_t stride = NKW_POSE_STRIDE(t->source->joint_count), width = target == NKW_CLIP_ROTATION ? 4 : 3;
    for (size_t i = 0; i < width && (c || rest); i++)
        if (!is_kept(target, c ? clip_track_value(&c->track, 0)[i] : rest[clip_array_of(target, i) * stride + joint]))
            return 0;
    return 1;
}

const nkw_clip_track *nkw_clip_tracks_beside(const clip_tracks *t, nkw_clip_target target, size_t joint)
{
    size_t first = joint, end = joint + 1, joints = t->source->joint_count;
    if (target == NKW_CLIP_FLOATS || !t->bridges[target] || nkw_clip_tracks_mover(t, target, joint))
        return NULL;
    while (first > 0 && joint - first < GAP && !nkw_clip_tracks_mover(t, target, first - 1))
        first--;
    while (end < joints && end - first <= GAP && !nkw_clip_tracks_mover(t, target, end))
        end++;
    size_t gap = end - first;
    const nkw_clip_track *before = first > 0 ? nkw_clip_tracks_mover(t, target, first - 1) : NULL;
    const nkw_clip_track *after = end < joints ? nkw_clip_tracks_mover(t, target, end) : NULL;
    const nkw_clip_track *beside = before ? before : after;
    if (gap > GAP || !beside || clip_is_cubic(&beside->track) ||
        (before && after && !nkw_clip_tracks_same(t, before, after)))
        return NULL;
    for (size_t i = first; i < end; i++)
        if (!is_joint_kept(t, target, i))
            return NULL;
    return beside;
}

/* Gaps are bridged where that does not more than double the joints that are moved; compact rotations change, so not. */
static void choose_bridges(clip_tracks *t)
{
    for (int target = 0; target < NKW_CLIP_FLOATS; target++) {
        size_t moved = 0, between = 0;
        t->bridges[target] = t->source->format == NKW_CLIP_FLOAT32 || target != NKW_CLIP_ROTATION;
        for (size_t j = 0; j < t->source->joint_count; j++) {
            moved += nkw_clip_tracks_mover(t, (nkw_clip_target)target, j) != NULL;
            between += nkw_clip_tracks_beside(t, (nkw_clip_target)target, j) != NULL;
        }
        t->bridges[target] &= between <= moved;
    }
}

nkw_result nkw_clip_tracks_order(const nkw_clip_source *source, clip_tracks *out, size_t *bad_track, uint32_t *work,
                                 size_t work_count)
{
    const size_t n = source->track_count; /* without tracks `work` may be NULL, which has no place after it */
    clip_tracks tracks = {source, work, n ? work + n : work, n ? work + 2 * n : work, {0, 0, 0}};
    *out = tracks;
    *bad_track = 0;
    nkw_result result = check_tracks(source, bad_track);
    if (result == NKW_OK && work_count / 3 < n)
        result = NKW_TOO_SMALL;
    if (result != NKW_OK)
        return result;
    sort(out, out->by_place, before_by_place);
    result = check_repeated(out, bad_track);
    if (result != NKW_OK)
        return result;
    find_timelines(out);
    sort(out, out->by_group, before_by_group);
    choose_bridges(out);
    return NKW_OK;
}
