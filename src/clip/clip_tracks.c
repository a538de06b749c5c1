/* SPDX-License-Identifier: MIT */
/*
 * The tracks of a source in the orders that the builder walks (clip_tracks.h).
 *
 * Invariant: the orders depend on targets, indices, key times and modes, not on the order of the source: equal tracks
 * make equal blocks, bit for bit.
 *
 *     source       0: rotation of joint 2    1: translation of joint 0    2: rotation of joint 1    3: constant
 *                  times A                   times B                      times A                   rotation of joint 0
 *     by_place     1 3 2 0                   translations first, then rotations by joint
 *     timeline     of track 0: 2, of 1: 0, of 2: 2, of 3: CLIP_CONSTANT       an index in by_place
 *     by_group     1 | 2 0 | 3               a group is a run of equal timeline and group number
 *
 *     group number    packed * 64 + kind * 16 + interpolation * 2 + normalised CUBICSPLINE
 */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/quat.h>

#include "clip_tracks.h"
#include "lane/scalar.h"
#include "sort.h"
#include "sizes.h"
#include "work.h"

#define TIMELINE_SAMPLES 16 /* times of a hash, from the first to the last */

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

/*
 * Between its keys a cubic normalises its rotation; at its keys only if the track is normalised. Whether the bits of
 * both are equal.
 */
static int is_normalize_exact(const nkw_track *t, const float *v)
{
    nkw_quat q = {v[0], v[1], v[2], v[3]}, unit = nkw_quat_normalize(q);
    return clip_is_normalized(t) || memcmp(&unit, v, sizeof unit) == 0;
}

/*
 * Whether sampling returns the same bits at every time: one key; or equal keys, and for cubics tangents of 0.
 * Not constant: numbers and cubics with a component -0, of which interpolation may return +0; rotations of cubics
 * that normalisation changes.
 */
static int is_constant(const nkw_clip_track *c)
{
    const nkw_track *t = &c->track;
    const float *first = track_value_at(t, 0);
    int is_rotation = c->target == NKW_CLIP_ROTATION;
    if (t->count == 1)
        return 1;
    if ((!is_rotation || track_is_cubic(t)) && any(first, t->width, clip_is_minus_zero))
        return 0;
    if (is_rotation && track_is_cubic(t) && !is_normalize_exact(t, first))
        return 0;
    for (size_t k = 1; k < t->count; k++) {
        const float *v = track_value_at(t, k), *before = track_value_at(t, k - 1);
        float duration = t->times[k] - t->times[k - 1];
        if (!same_bits(v, first, t->width))
            return 0;
        /* 0 times a duration that overflows to infinity is NaN. */
        if (track_is_cubic(t) && !lane_is_finite(duration))
            return 0;
        if (track_is_cubic(t) &&
            (any(before + t->width, t->width, is_not_zero) || any(v - t->width, t->width, is_not_zero)))
            return 0;
    }
    return 1;
}

int nkwi_clip_tracks_is_still(const nkw_clip_track *c, size_t component)
{
    const float first = track_value_at(&c->track, 0)[component];
    int still = !track_is_cubic(&c->track) && clip_is_invariant(c->target, first);
    for (size_t k = 1; still && k < c->track.count; k++)
        still = lane_bits(track_value_at(&c->track, k)[component]) == lane_bits(first);
    return still;
}

/* Whether two tracks have the same key times and, if they have modes, the same modes. */
static int same_timeline(const nkw_track *a, const nkw_track *b)
{
    if (!clip_same_times(a, b) || !a->key_interpolation != !b->key_interpolation)
        return 0;
    return !a->key_interpolation || memcmp(a->key_interpolation, b->key_interpolation, a->count) == 0;
}

int nkwi_clip_tracks_is_packed(const clip_tracks *t, const nkw_clip_track *c)
{
    if (!t->packing || c->track.interpolation != NKW_INTERPOLATION_LINEAR || c->track.key_interpolation)
        return 0;
    return t->packing->steps ? t->packing->steps[c - t->source->tracks] > 0.0f : 3 * c->track.width <= PACKED_SLOTS;
}

uint32_t nkwi_clip_tracks_group(const clip_tracks *t, const nkw_clip_track *c)
{
    uint32_t cubic_unit = track_is_cubic(&c->track) && clip_is_normalized(&c->track);
    return (uint32_t)nkwi_clip_tracks_is_packed(t, c) * 64u + (uint32_t)clip_kind_of(c) * 16u +
           (uint32_t)clip_interpolation_of(&c->track) * 2u + cubic_unit;
}

/* Sorting. Both orders are total, so the result does not depend on the algorithm. */

static int before_by_place(const void *context, uint32_t i, uint32_t j)
{
    const clip_tracks *b = (const clip_tracks *)context;
    const nkw_clip_track *p = &b->source->tracks[i], *q = &b->source->tracks[j];
    return p->target != q->target ? p->target < q->target : p->index != q->index ? p->index < q->index : i < j;
}

static int before_by_group(const void *context, uint32_t i, uint32_t j)
{
    const clip_tracks *b = (const clip_tracks *)context;
    uint32_t p = nkwi_clip_tracks_group(b, &b->source->tracks[i]), q = nkwi_clip_tracks_group(b, &b->source->tracks[j]);
    if (b->timeline[i] != b->timeline[j])
        return b->timeline[i] < b->timeline[j];
    return p != q ? p < q : before_by_place(b, i, j);
}

static void sort(const clip_tracks *b, uint32_t *order, sort_before *before)
{
    for (size_t i = 0; i < b->source->track_count; i++)
        order[i] = (uint32_t)i;
    sort_indices(order, b->source->track_count, before, b);
}

/* A number of at most 31 bits, equal for equal times and modes: of their count and of TIMELINE_SAMPLES times. */
static uint32_t hash_of_times(const nkw_track *t)
{
    uint32_t hash = (uint32_t)t->count * 2u + (t->key_interpolation != NULL);
    for (size_t i = 0; i < TIMELINE_SAMPLES; i++)
        hash = (hash ^ lane_bits(t->times[(uint64_t)(t->count - 1) * i / (TIMELINE_SAMPLES - 1)])) * 0x9e3779b1u;
    return hash >> 1;
}

static int before_by_timeline(const void *context, uint32_t i, uint32_t j)
{
    const clip_tracks *b = (const clip_tracks *)context;
    return b->timeline[i] != b->timeline[j] ? b->timeline[i] < b->timeline[j] : before_by_place(b, i, j);
}

/* The first of the tracks from..end - 1 with the key times and modes of track i, all of which are leaders or have one. */
static uint32_t leader_of(const clip_tracks *b, const uint32_t *from, const uint32_t *end, uint32_t i)
{
    const nkw_clip_track *tracks = b->source->tracks;
    for (; from < end; from++)
        if (b->timeline[*from] == *from && same_timeline(&tracks[i].track, &tracks[*from].track))
            return *from;
    return i;
}

/*
 * The timeline of a track is the first index in by_place with the same key times and modes. It does not depend on the
 * order of the tracks in the source, so neither does the block. n log n, where times that differ have other hashes:
 *
 *     1. timeline[i] = hash            by_group: sorted by hash, then by place
 *     2. timeline[i] = leader          the first track of the same hash with equal times
 *     3. by_group[leader] = place      timeline[i] = place of the leader, which is before all others
 */
static void find_timelines(clip_tracks *b)
{
    const size_t n = b->source->track_count;
    uint32_t *order = b->by_group, *timeline = b->timeline;
    for (uint32_t i = 0; i < n; i++)
        timeline[i] = is_constant(&b->source->tracks[i]) ? CLIP_CONSTANT : hash_of_times(&b->source->tracks[i].track);
    sort(b, order, before_by_timeline);
    for (size_t from = 0, to = 0; from < n && timeline[order[from]] != CLIP_CONSTANT; from = to) {
        const uint32_t hash = timeline[order[from]];
        for (; to < n && timeline[order[to]] == hash; to++)
            continue;
        for (size_t m = from; m < to; m++)
            timeline[order[m]] = leader_of(b, order + from, order + m, order[m]);
    }
    for (uint32_t k = 0; k < n; k++) {
        const uint32_t i = b->by_place[k];
        if (timeline[i] == i)
            order[i] = k;
        timeline[i] = timeline[i] == CLIP_CONSTANT ? CLIP_CONSTANT : order[timeline[i]];
    }
}

/* Validation. First the source, then each track, then targets that occur twice. */

nkw_result nkwi_clip_tracks_check_target(const nkw_clip_source *s, const nkw_clip_track *c)
{
    int is_rotation = c->target == NKW_CLIP_ROTATION;
    if (c->track.count >= CLIP_CONSTANT)
        return NKW_OUT_OF_RANGE;
    if ((unsigned)c->target > NKW_CLIP_FLOATS)
        return NKW_BAD_METHOD;
    if ((c->track.kind != NKW_TRACK_FLOATS) != is_rotation)
        return NKW_MISMATCHED;
    if (c->target == NKW_CLIP_FLOATS)
        return c->index <= s->float_count && c->track.width <= s->float_count - c->index ? NKW_OK : NKW_OUT_OF_RANGE;
    if (c->track.width != (is_rotation ? 4u : 3u))
        return NKW_BAD_WIDTH;
    return c->index < s->joint_count ? NKW_OK : NKW_OUT_OF_RANGE;
}

static nkw_result check_tracks(const nkw_clip_source *s, size_t *bad)
{
    nkw_result result = s->joint_count + s->float_count == 0                    ? NKW_EMPTY
                        : (unsigned)s->format > (unsigned)NKW_CLIP_UNORM16      ? NKW_BAD_FORMAT
                        : s->rest.data && s->rest.joint_count != s->joint_count ? NKW_MISMATCHED
                                                                                : NKW_OK;
    if (s->track_count >= CLIP_CONSTANT || s->joint_count > CLIP_MAX_JOINTS || s->float_count > CLIP_MAX_FLOATS)
        result = NKW_OUT_OF_RANGE;
    for (size_t i = 0; result == NKW_OK && i < s->track_count; i++) {
        *bad = i;
        result = nkw_track_validate(&s->tracks[i].track, NULL);
        result = result == NKW_OK ? nkwi_clip_tracks_check_target(s, &s->tracks[i]) : result;
    }
    *bad = result == NKW_OK ? 0 : *bad;
    return result;
}

static int have_same_target(const nkw_clip_track *a, const nkw_clip_track *b)
{
    const nkw_clip_track *p = a->index <= b->index ? a : b, *q = p == a ? b : a;
    size_t taken = p->target == NKW_CLIP_FLOATS ? p->track.width : 1;
    return p->target == q->target && q->index - p->index < taken;
}

/* The first track with the same target as an earlier one. The caller has found that there is one. */
static size_t first_repeated(const nkw_clip_track *tracks)
{
    for (size_t i = 1;; i++)
        for (size_t j = 0; j < i; j++)
            if (have_same_target(&tracks[j], &tracks[i]))
                return i;
}

/* In by_place, tracks with the same target are neighbours. */
static nkw_result check_repeated(const clip_tracks *b, size_t *bad)
{
    const nkw_clip_track *tracks = b->source->tracks;
    for (size_t i = 1; i < b->source->track_count; i++) {
        if (!have_same_target(&tracks[b->by_place[i - 1]], &tracks[b->by_place[i]]))
            continue;
        *bad = first_repeated(tracks);
        return NKW_REPEATED;
    }
    return NKW_OK;
}

/*
 * Bisection in by_place: the last track whose (target, index) is at most the given one. A track of several floats
 * contains index..index + width - 1.
 */
const nkw_clip_track *nkwi_clip_tracks_find(const clip_tracks *t, nkw_clip_target target, size_t index)
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

/* Gaps (clip_tracks.h). */

const nkw_clip_track *nkwi_clip_tracks_find_animated(const clip_tracks *t, nkw_clip_target target, size_t index)
{
    const nkw_clip_track *c = nkwi_clip_tracks_find(t, target, index);
    return c && t->timeline[c - t->source->tracks] != CLIP_CONSTANT ? c : NULL;
}

int nkwi_clip_tracks_same_group(const clip_tracks *t, const nkw_clip_track *a, const nkw_clip_track *b)
{
    const nkw_clip_track *tracks = t->source->tracks;
    return a && b && t->timeline[a - tracks] == t->timeline[b - tracks] &&
           nkwi_clip_tracks_group(t, a) == nkwi_clip_tracks_group(t, b);
}

/* clip_is_invariant for all components of the constant value of a joint; the identity is invariant. */
static int is_joint_invariant(const clip_tracks *t, nkw_clip_target target, size_t joint)
{
    const nkw_clip_track *c = nkwi_clip_tracks_find(t, target, joint);
    const float *rest = t->source->rest.data;
    size_t stride = NKW_POSE_STRIDE(t->source->joint_count), width = target == NKW_CLIP_ROTATION ? 4 : 3;
    for (size_t i = 0; i < width && (c || rest); i++)
        if (!clip_is_invariant(target,
                               c ? track_value_at(&c->track, 0)[i] : rest[clip_array_of(target, i) * stride + joint]))
            return 0;
    return 1;
}

/*
 *     joint     first - 1 | first ... joint ... end - 1 | end
 *               before    | no animated track           | after
 *
 * The gap first..end - 1 is filled if it has at most CLIP_GAP joints; if `before` and `after` are of one group, or only
 * one of them exists; if this group is not CUBICSPLINE; and if interpolation returns the constant value of every joint.
 */
const nkw_clip_track *nkwi_clip_tracks_find_gap(const clip_tracks *t, nkw_clip_target target, size_t joint)
{
    size_t first = joint, end = joint + 1, joints = t->source->joint_count;
    if (target == NKW_CLIP_FLOATS || !t->fills_gaps[target] || nkwi_clip_tracks_find_animated(t, target, joint))
        return NULL;
    while (first > 0 && joint - first < CLIP_GAP && !nkwi_clip_tracks_find_animated(t, target, first - 1))
        first--;
    while (end < joints && end - first <= CLIP_GAP && !nkwi_clip_tracks_find_animated(t, target, end))
        end++;
    size_t gap = end - first;
    const nkw_clip_track *before = first > 0 ? nkwi_clip_tracks_find_animated(t, target, first - 1) : NULL;
    const nkw_clip_track *after = end < joints ? nkwi_clip_tracks_find_animated(t, target, end) : NULL;
    const nkw_clip_track *neighbour = before ? before : after;
    if (gap > CLIP_GAP || !neighbour || track_is_cubic(&neighbour->track) ||
        (before && after && !nkwi_clip_tracks_same_group(t, before, after)))
        return NULL;
    for (size_t i = first; i < end; i++)
        if (!is_joint_invariant(t, target, i))
            return NULL;
    return neighbour;
}

/*
 * Gaps get lanes if there are at most as many joints in gaps as animated joints. Compact rotations have none: encoding
 * changes the bits of a constant rotation.
 */
static void choose_gaps(clip_tracks *t)
{
    for (int target = 0; target < NKW_CLIP_FLOATS; target++) {
        size_t animated = 0, in_gaps = 0;
        t->fills_gaps[target] = t->source->format == NKW_CLIP_FLOAT32 || target != NKW_CLIP_ROTATION;
        for (size_t j = 0; j < t->source->joint_count; j++) {
            animated += nkwi_clip_tracks_find_animated(t, (nkw_clip_target)target, j) != NULL;
            in_gaps += nkwi_clip_tracks_find_gap(t, (nkw_clip_target)target, j) != NULL;
        }
        t->fills_gaps[target] &= in_gaps <= animated;
    }
}

nkw_result nkwi_clip_tracks_order(const nkw_clip_source *source, const clip_packing *packing, clip_tracks *out,
                                  size_t *bad, nkw_work work)
{
    const size_t n = source->track_count; /* if 0, the memory may be NULL: NULL + n is not computed */
    uint32_t *order = (uint32_t *)work.data;
    clip_tracks tracks = {source, order, n ? order + n : order, n ? order + 2 * n : order, {0, 0, 0}, packing};
    *out = tracks;
    *bad = 0;
    nkw_result result = check_tracks(source, bad);
    if (result == NKW_OK && !work_fits_each(work, n, NKW_CLIP_BUILD_WORK(1)))
        result = NKW_TOO_SMALL;
    if (result != NKW_OK)
        return result;
    sort(out, out->by_place, before_by_place);
    result = check_repeated(out, bad);
    if (result != NKW_OK)
        return result;
    find_timelines(out);
    sort(out, out->by_group, before_by_group);
    if (!packing)
        choose_gaps(out);
    return NKW_OK;
}
