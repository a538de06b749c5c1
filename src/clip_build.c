/* SPDX-License-Identifier: MIT */
/* Builds a clip's block. Laid out twice by the same code: first to measure, without a block, then to write. */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/clip.h>
#include <nakawari/segment.h>

#include "clip_layout.h"
#include "lane/scalar.h"
#include "simd/select.h"

#define CONSTANT UINT32_MAX /* in place of a timeline */

typedef enum section { TIMELINES, GROUPS, RUNS, TIMES, VALUES, SECTIONS } section;

typedef struct builder {
    const nkw_clip_source *source;
    uint32_t *by_group; /* tracks by timeline, then by group, then by target and index; constant ones last */
    uint32_t *by_place; /* tracks by target and index */
    uint32_t *timeline; /* of each track: the first track with the same one, or CONSTANT */
    uint32_t *words; /* the block; NULL while measuring */
    size_t start[SECTIONS], used[SECTIONS];
} builder;

/* Tracks: what they are. */

static int is_cubic(const nkw_track *t)
{
    return t->interpolation == NKW_INTERPOLATION_CUBICSPLINE;
}

static const float *track_value(const nkw_track *t, size_t k)
{
    return t->values + (is_cubic(t) ? (3 * k + 1) * t->width : k * t->width);
}

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

/* The same bits at every time. Numbers that are -0 may come out of a lerp as 0; rotations of a cubic are normalised. */
static int is_constant(const nkw_clip_track *c)
{
    const nkw_track *t = &c->track;
    const float *first = track_value(t, 0);
    if (t->count > 1 && c->target == NKW_CLIP_ROTATION ? is_cubic(t) : any(first, t->width, is_minus_zero))
        return t->count == 1;
    for (size_t k = 1; k < t->count; k++) {
        const float *v = track_value(t, k), *before = track_value(t, k - 1);
        if (!same_bits(v, first, t->width))
            return 0;
        if (is_cubic(t) && (any(before + t->width, t->width, is_not_zero) || any(v - t->width, t->width, is_not_zero)))
            return 0;
    }
    return 1;
}

static int same_timeline(const nkw_track *a, const nkw_track *b)
{
    if (a->count != b->count || !a->key_interpolation != !b->key_interpolation)
        return 0;
    if (a->times != b->times && !same_bits(a->times, b->times, a->count))
        return 0;
    return !a->key_interpolation || memcmp(a->key_interpolation, b->key_interpolation, a->count) == 0;
}

static clip_kind kind_of(const nkw_clip_track *c)
{
    return c->target == NKW_CLIP_ROTATION ? GROUP_ROTATIONS
           : c->target == NKW_CLIP_FLOATS ? GROUP_FLOATS
                                          : GROUP_NUMBERS;
}

/* Tracks that choose key by key are laid out as LINEAR, which serves STEP too. */
static nkw_interpolation interpolation_of(const nkw_track *t)
{
    return t->key_interpolation ? NKW_INTERPOLATION_LINEAR : t->interpolation;
}

static int is_normalized(const nkw_track *t)
{
    return t->kind == NKW_TRACK_ROTATION_NORMALIZED;
}

/* What tracks of one timeline must have in common to be a group. */
static uint32_t group_of(const nkw_clip_track *c)
{
    uint32_t cubic_unit = is_cubic(&c->track) && is_normalized(&c->track);
    return (uint32_t)kind_of(c) * 16u + (uint32_t)interpolation_of(&c->track) * 2u + cubic_unit;
}

/* Orders: heap sort over indices of tracks. */

typedef int comes_before(const builder *b, uint32_t i, uint32_t j);

static int before_by_place(const builder *b, uint32_t i, uint32_t j)
{
    const nkw_clip_track *p = &b->source->tracks[i], *q = &b->source->tracks[j];
    return p->target != q->target ? p->target < q->target : p->index != q->index ? p->index < q->index : i < j;
}

static int before_by_group(const builder *b, uint32_t i, uint32_t j)
{
    uint32_t p = group_of(&b->source->tracks[i]), q = group_of(&b->source->tracks[j]);
    if (b->timeline[i] != b->timeline[j])
        return b->timeline[i] < b->timeline[j];
    return p != q ? p < q : before_by_place(b, i, j);
}

static void sift(const builder *b, uint32_t *order, size_t root, size_t count, comes_before *before)
{
    for (size_t child = 2 * root + 1; child < count; child = 2 * root + 1) {
        if (child + 1 < count && before(b, order[child], order[child + 1]))
            child++;
        if (!before(b, order[root], order[child]))
            return;
        uint32_t swap = order[root];
        order[root] = order[child];
        order[child] = swap;
        root = child;
    }
}

static void sort(const builder *b, uint32_t *order, comes_before *before)
{
    size_t n = b->source->track_count;
    for (size_t i = 0; i < n; i++)
        order[i] = (uint32_t)i;
    for (size_t i = n / 2; i-- > 0;)
        sift(b, order, i, n, before);
    for (size_t end = n; end-- > 1;) {
        uint32_t swap = order[0];
        order[0] = order[end];
        order[end] = swap;
        sift(b, order, 0, end, before);
    }
}

static void find_timelines(builder *b)
{
    const nkw_clip_track *tracks = b->source->tracks;
    for (uint32_t i = 0; i < b->source->track_count; i++) {
        b->timeline[i] = is_constant(&tracks[i]) ? CONSTANT : i;
        for (uint32_t j = 0; j < i && b->timeline[i] == i; j++)
            if (b->timeline[j] == j && same_timeline(&tracks[i].track, &tracks[j].track))
                b->timeline[i] = j;
    }
}

/* Validation. */

static nkw_result check_place(const nkw_clip_source *s, const nkw_clip_track *c)
{
    int turns = c->target == NKW_CLIP_ROTATION;
    if ((unsigned)c->target > NKW_CLIP_FLOATS || (c->track.kind != NKW_TRACK_FLOATS) != turns)
        return NKW_BAD_METHOD;
    if (c->target == NKW_CLIP_FLOATS)
        return c->index <= s->float_count && c->track.width <= s->float_count - c->index ? NKW_OK : NKW_OUT_OF_RANGE;
    if (c->track.width != (turns ? 4u : 3u))
        return NKW_BAD_METHOD;
    return c->index < s->joint_count ? NKW_OK : NKW_OUT_OF_RANGE;
}

static nkw_result check_tracks(const nkw_clip_source *s, size_t *bad)
{
    nkw_result result = s->joint_count + s->float_count == 0 ? NKW_EMPTY : NKW_OK;
    if (s->track_count >= CONSTANT || s->joint_count >= CONSTANT / 16 || s->float_count >= CONSTANT)
        result = NKW_OUT_OF_RANGE;
    for (size_t i = 0; result == NKW_OK && i < s->track_count; i++) {
        *bad = i;
        result = nkw_track_validate(&s->tracks[i].track, NULL);
        result = result == NKW_OK ? check_place(s, &s->tracks[i]) : result;
    }
    *bad = result == NKW_OK ? 0 : *bad;
    return result;
}

/* In the order of places, what two tracks move lies next to each other. */
static nkw_result check_repeated(const builder *b, size_t *bad)
{
    const nkw_clip_track *tracks = b->source->tracks;
    for (size_t i = 1; i < b->source->track_count; i++) {
        const nkw_clip_track *p = &tracks[b->by_place[i - 1]], *q = &tracks[b->by_place[i]];
        size_t taken = p->target == NKW_CLIP_FLOATS ? p->track.width : 1;
        if (p->target == q->target && q->index - p->index < taken) {
            *bad = b->by_place[i] > b->by_place[i - 1] ? b->by_place[i] : b->by_place[i - 1];
            return NKW_REPEATED;
        }
    }
    return NKW_OK;
}

/* Room in a section: where it begins, in words from the beginning of the block. */
static size_t take(builder *b, section s, size_t words)
{
    size_t at = b->start[s] + b->used[s];
    b->used[s] += words;
    return at;
}

static size_t round_up(size_t n, size_t to)
{
    return (n + to - 1) / to * to;
}

static float *floats_at(const builder *b, size_t at)
{
    return (float *)(void *)(b->words + at);
}

/* Lanes: where they go, in runs. */

typedef struct lanes {
    builder *b;
    size_t count, runs, run_count;
    size_t next, length; /* where the last run would go on, and how long it is */
} lanes;

static lanes lanes_begin(builder *b)
{
    lanes l = {b, 0, b->start[RUNS] + b->used[RUNS], 0, 0, 0};
    return l;
}

/* One more lane, that goes to the float `to`; gives its number. */
static size_t add_lane(lanes *l, size_t to)
{
    int goes_on = l->run_count > 0 && to == l->next;
    if (!goes_on) {
        take(l->b, RUNS, sizeof(nkw_run) / 4);
        l->run_count++;
        l->length = 0;
    }
    l->next = to + 1;
    l->length++;
    if (l->b->words) {
        nkw_run *run = (nkw_run *)(void *)(l->b->words + l->runs) + l->run_count - 1;
        run->lane = (uint32_t)(l->count + 1 - l->length);
        run->to = (uint32_t)(l->next - l->length);
        run->count = (uint32_t)l->length;
    }
    return l->count++;
}

/* A long run that ends with the last joint of a component array goes on over the padding, into the next array. */
static void add_padding(lanes *l)
{
    size_t joints = l->b->source->joint_count, stride = NKW_POSE_STRIDE(joints);
    if (l->length >= 8 && l->next % stride == joints % stride)
        while (l->next % stride != 0)
            add_lane(l, l->next);
}

/* Keys. */

/* A component of what the track gives at key k. */
static float held_component(const nkw_clip_track *c, size_t k, size_t component)
{
    nkw_segment at = {k, 0.0f};
    float rotation[4];
    if (c->target != NKW_CLIP_ROTATION)
        return track_value(&c->track, k)[component];
    nkw_track_sample_at(&c->track, at, rotation);
    return rotation[component];
}

/* Component c of key k's in-tangent, value or out-tangent (part 0, 1, 2); without tangents of the value. */
static float key_component(const nkw_clip_track *c, size_t k, size_t part, size_t component)
{
    const nkw_track *t = &c->track;
    if (is_cubic(t))
        return t->values[(3 * k + part) * t->width + component];
    return held_component(c, k, component);
}

/* Writes a component of a track into every key, `at` floats into the value. */
static void fill_component(const builder *b, const clip_group *g, const nkw_clip_track *c, size_t component, size_t at)
{
    for (size_t k = 0; k < c->track.count; k++)
        for (size_t part = 0; part < (is_cubic(&c->track) ? 3u : 1u); part++)
            floats_at(b, g->keys + k * g->key_words)[part * clip_value_words(g) + at] =
                key_component(c, k, part, component);
}

static void fill_arcs(const builder *b, const clip_group *g, size_t key_count)
{
    for (size_t k = 0; k + 1 < key_count; k++) {
        float *key = floats_at(b, g->keys + k * g->key_words);
        nkw_batch_selected()->clip_arcs(key, key + g->key_words, g->lanes, key + 4 * (size_t)g->lanes);
    }
}

/* Where component c of a track goes: in the pose, in its rotations, or in the floats. */
static size_t place_of(const builder *b, const nkw_clip_track *c, size_t component)
{
    size_t stride = NKW_POSE_STRIDE(b->source->joint_count);
    if (c->target == NKW_CLIP_FLOATS)
        return c->index + component;
    if (c->target == NKW_CLIP_ROTATION)
        return c->index;
    return (component + (c->target == NKW_CLIP_SCALE ? 7u : 0u)) * stride + c->index;
}

/* The lanes of a track in pass 0, 1 or 2: one component, or all four of a rotation, or all the floats, one after the other. */
static void lay_track(lanes *l, const clip_group *g, const nkw_clip_track *c, size_t pass)
{
    int turns = c->target == NKW_CLIP_ROTATION, floats = c->target == NKW_CLIP_FLOATS;
    size_t first = turns || floats ? 0 : pass, end = floats ? c->track.width : first + 1;
    for (size_t component = first; component < end; component++) {
        size_t lane = add_lane(l, place_of(l->b, c, component));
        for (size_t row = 0; l->b->words && row < (turns ? 4u : 1u); row++)
            fill_component(l->b, g, c, component + row, row * g->lanes + lane);
    }
}

/* The lanes of a group's tracks: translations x, y, z, rotations, scales x, y, z, each in the order of joints; floats. */
static lanes lay_lanes(builder *b, const clip_group *g, const uint32_t *members, size_t count)
{
    lanes l = lanes_begin(b);
    for (int target = NKW_CLIP_TRANSLATION; target <= NKW_CLIP_FLOATS; target++) {
        int in_passes = target == NKW_CLIP_TRANSLATION || target == NKW_CLIP_SCALE;
        for (size_t pass = 0; pass < (in_passes ? 3u : 1u); pass++) {
            for (size_t i = 0; i < count; i++)
                if ((int)b->source->tracks[members[i]].target == target)
                    lay_track(&l, g, &b->source->tracks[members[i]], pass);
            if (target != NKW_CLIP_FLOATS)
                add_padding(&l);
        }
    }
    return l;
}

/* Groups and timelines. */

/* Keys per second, if nkw_segment_uniform_time gives the very times; else 0. */
static float rate_of(const nkw_track *t)
{
    double mean = t->count > 1 ? (double)(t->count - 1) / ((double)t->times[t->count - 1] - (double)t->times[0]) : 0.0;
    const float candidates[2] = {mean > 0.0 && mean < 1e9 ? (float)(uint32_t)(mean + 0.5) : 0.0f,
                                 mean < 1e9 ? (float)mean : 0.0f};
    for (int i = 0; i < 2; i++) {
        size_t k = 0;
        while (candidates[i] > 0.0f && k < t->count &&
               nkw_segment_uniform_time(t->times[0], candidates[i], k) == t->times[k] &&
               (k == 0 || t->times[k - 1] < t->times[k]))
            k++;
        if (k == t->count)
            return candidates[i];
    }
    return 0.0f;
}

static void lay_timeline(builder *b, const nkw_track *t)
{
    size_t at = take(b, TIMELINES, sizeof(clip_timeline) / 4), times = take(b, TIMES, t->count);
    size_t modes = t->key_interpolation ? take(b, TIMES, t->count) : 0;
    if (!b->words)
        return;
    clip_timeline line = {(uint32_t)times, (uint32_t)t->count, (uint32_t)modes, rate_of(t)};
    memcpy(b->words + at, &line, sizeof line);
    memcpy(b->words + times, t->times, t->count * sizeof(float));
    for (size_t k = 0; modes && k < t->count; k++)
        b->words[modes + k] = t->key_interpolation[k];
}

static size_t lane_stride(size_t count)
{
    return round_up(count, count > CLIP_ALIGN ? CLIP_ALIGN : 4);
}

static void lay_group(builder *b, uint32_t timeline, const uint32_t *members, size_t count)
{
    const nkw_clip_track *first = &b->source->tracks[members[0]];
    clip_group g = {timeline,
                    kind_of(first),
                    interpolation_of(&first->track),
                    is_cubic(&first->track) && is_normalized(&first->track),
                    0,
                    0,
                    0,
                    0,
                    0};
    builder probe = *b;
    probe.words = NULL;
    lanes counted = lay_lanes(&probe, &g, members, count);
    g.lanes = (uint32_t)lane_stride(counted.count);
    g.key_words = clip_key_words(&g);
    take(b, VALUES, round_up(b->used[VALUES], CLIP_ALIGN) - b->used[VALUES]);
    g.keys = (uint32_t)take(b, VALUES, g.key_words * first->track.count);
    lanes l = lay_lanes(b, &g, members, count);
    size_t at = take(b, GROUPS, sizeof g / 4);
    if (!b->words)
        return;
    g.runs = (uint32_t)l.runs;
    g.run_count = (uint32_t)l.run_count;
    if (g.kind == GROUP_ROTATIONS && g.interpolation == NKW_INTERPOLATION_LINEAR)
        fill_arcs(b, &g, first->track.count);
    memcpy(b->words + at, &g, sizeof g);
}

static void lay_groups(builder *b)
{
    const nkw_clip_track *tracks = b->source->tracks;
    uint32_t lines = 0;
    for (size_t from = 0, to; from < b->source->track_count && b->timeline[b->by_group[from]] != CONSTANT; from = to) {
        uint32_t first = b->by_group[from], line = b->timeline[first];
        to = from + 1;
        while (to < b->source->track_count && b->timeline[b->by_group[to]] == line &&
               group_of(&tracks[b->by_group[to]]) == group_of(&tracks[first]))
            to++;
        if (from == 0 || b->timeline[b->by_group[from - 1]] != line) {
            lay_timeline(b, &tracks[first].track);
            lines++;
        }
        lay_group(b, lines - 1, b->by_group + from, to - from);
    }
}

/* What never changes: constant tracks, and the rest where there is no track. */

static void add_constant(lanes *l, size_t to, float value)
{
    add_lane(l, to);
    size_t at = take(l->b, VALUES, 1);
    if (l->b->words)
        floats_at(l->b, at)[0] = value;
}

/* One component array of the pose. `target` and `row` say which tracks move it; *p goes through the tracks by place. */
static void lay_constant_array(lanes *l, nkw_clip_target target, size_t row, size_t array, size_t p)
{
    const builder *b = l->b;
    const nkw_clip_source *s = b->source;
    size_t stride = NKW_POSE_STRIDE(s->joint_count);
    float identity = array >= 6 ? 1.0f : 0.0f;
    int held = 0;
    for (size_t j = 0; j < s->joint_count; j++) {
        while (p < s->track_count && s->tracks[b->by_place[p]].target == target && s->tracks[b->by_place[p]].index < j)
            p++;
        uint32_t i = p < s->track_count ? b->by_place[p] : 0;
        int has_track = p < s->track_count && s->tracks[i].target == target && s->tracks[i].index == j;
        float rest = s->rest ? s->rest[array * stride + j] : identity;
        held = !has_track || b->timeline[i] == CONSTANT;
        if (held)
            add_constant(l, array * stride + j, has_track ? held_component(&s->tracks[i], 0, row) : rest);
    }
    for (size_t j = s->joint_count; held && j < stride; j++)
        add_constant(l, array * stride + j, identity);
}

/* The first track by place that moves the target. */
static size_t first_of(const builder *b, nkw_clip_target target)
{
    size_t p = 0;
    while (p < b->source->track_count && b->source->tracks[b->by_place[p]].target < target)
        p++;
    return p;
}

static lanes lay_constants(builder *b)
{
    lanes l = lanes_begin(b);
    for (size_t array = 0; array < 10; array++) {
        nkw_clip_target target = array < 3 ? NKW_CLIP_TRANSLATION : array < 7 ? NKW_CLIP_ROTATION : NKW_CLIP_SCALE;
        size_t row = array < 3 ? array : array < 7 ? array - 3 : array - 7;
        lay_constant_array(&l, target, row, array, first_of(b, target));
    }
    return l;
}

static lanes lay_float_constants(builder *b)
{
    const nkw_clip_source *s = b->source;
    lanes l = lanes_begin(b);
    size_t p = first_of(b, NKW_CLIP_FLOATS);
    for (size_t f = 0; f < s->float_count; f++) {
        const nkw_clip_track *c = NULL;
        while (p < s->track_count && s->tracks[b->by_place[p]].index + s->tracks[b->by_place[p]].track.width <= f)
            p++;
        if (p < s->track_count && s->tracks[b->by_place[p]].index <= f)
            c = &s->tracks[b->by_place[p]];
        if (!c)
            add_constant(&l, f, s->rest_floats ? s->rest_floats[f] : 0.0f);
        else if (b->timeline[b->by_place[p]] == CONSTANT)
            add_constant(&l, f, held_component(c, 0, f - c->index));
    }
    return l;
}

/* The whole block. */

static void lay_head(builder *b, const lanes *pose, size_t pose_values, const lanes *floats, size_t float_values)
{
    nkw_clip head;
    const nkw_clip_source *s = b->source;
    memset(&head, 0, sizeof head);
    head.magic = CLIP_MAGIC;
    head.version = CLIP_VERSION;
    head.words = (uint32_t)(b->start[VALUES] + b->used[VALUES]);
    head.joints = (uint32_t)s->joint_count;
    head.floats = (uint32_t)s->float_count;
    for (size_t i = 0; i < s->track_count; i++) {
        const nkw_track *t = &s->tracks[i].track;
        float first = t->times[0], last = t->times[t->count - 1];
        head.start = i == 0 || first < head.start ? first : head.start;
        head.end = i == 0 || last > head.end ? last : head.end;
    }
    head.timelines = (uint32_t)b->start[TIMELINES];
    head.timeline_count = (uint32_t)(b->used[TIMELINES] / (sizeof(clip_timeline) / 4));
    head.groups = (uint32_t)b->start[GROUPS];
    head.group_count = (uint32_t)(b->used[GROUPS] / (sizeof(clip_group) / 4));
    head.constants = (uint32_t)pose_values;
    head.constant_runs = (uint32_t)pose->runs;
    head.constant_run_count = (uint32_t)pose->run_count;
    head.float_constants = (uint32_t)float_values;
    head.float_runs = (uint32_t)floats->runs;
    head.float_run_count = (uint32_t)floats->run_count;
    memcpy(b->words, &head, sizeof head);
}

static void lay_clip(builder *b)
{
    size_t pose_values = b->start[VALUES];
    lanes pose = lay_constants(b);
    size_t float_values = b->start[VALUES] + b->used[VALUES];
    lanes floats = lay_float_constants(b);
    lay_groups(b);
    if (b->words)
        lay_head(b, &pose, pose_values, &floats, float_values);
}

/* Measures, so that each section's beginning is known. */
static nkw_result plan(builder *b, const nkw_clip_source *source, uint32_t *work, size_t *bytes, size_t *bad)
{
    memset(b, 0, sizeof *b);
    b->source = source;
    b->by_group = work;
    b->by_place = work + source->track_count;
    b->timeline = work + 2 * source->track_count;
    *bad = 0;
    nkw_result result = check_tracks(source, bad);
    if (result != NKW_OK)
        return result;
    sort(b, b->by_place, before_by_place);
    result = check_repeated(b, bad);
    if (result != NKW_OK)
        return result;
    find_timelines(b);
    sort(b, b->by_group, before_by_group);
    lay_clip(b);
    size_t at = sizeof(nkw_clip) / 4;
    for (int s = 0; s < SECTIONS; s++) {
        b->start[s] = at = s == VALUES ? round_up(at, CLIP_ALIGN) : at;
        at += b->used[s];
        b->used[s] = 0;
    }
    *bytes = at * 4;
    return at < CONSTANT ? NKW_OK : NKW_OUT_OF_RANGE;
}

nkw_result nkw_clip_measure(const nkw_clip_source *source, uint32_t *work, size_t *bytes, size_t *bad_track)
{
    builder b;
    size_t bad = 0;
    return plan(&b, source, work, bytes, bad_track ? bad_track : &bad);
}

nkw_result nkw_clip_build(const nkw_clip_source *source, uint32_t *work, void *block, size_t bytes, size_t *bad_track)
{
    builder b;
    size_t bad = 0, needed = 0;
    nkw_result result = plan(&b, source, work, &needed, bad_track ? bad_track : &bad);
    if (result != NKW_OK)
        return result;
    if (bytes < needed)
        return NKW_TOO_SMALL;
    memset(block, 0, needed);
    b.words = (uint32_t *)block;
    lay_clip(&b);
    return NKW_OK;
}
