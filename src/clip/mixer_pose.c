/* SPDX-License-Identifier: MIT */
/* The pose of a frame: samples of the slots, layers, the motion of the root, transitions. */
#include "mixer_state.h"

#include <string.h>

#include <nakawari/root.h>
#include <nakawari/scalar.h>
#include <nakawari/transform.h>
#include <nakawari/transition.h>

#include "lane/blend.h"

/* The velocity of the old motion of a dead blend is halved in this part of its duration. */
#define HALF_LIFE_PART 0.25f

/* ---- Samples ---- */

typedef struct mix {
    const nkw_mixer *m;
    const nkw_mixer_set *set;
    const mixer_room *room;
    nkw_pose_view so_far; /* the rest pose; from the first layer on the pose */
    nkw_pose_span pose;
    float *floats;
    mixer_roots *roots;
} mix;

static nkw_root_rule rule_of(const nkw_mixer_set *set)
{
    const nkw_root_rule rule = {set->up, set->root_parts};
    return rule;
}

static nkw_play_head_f64 head_of(const nkw_mixer_slot *s, double length)
{
    const nkw_playback_range range = {0.0, length, 0.0, s->mode, s->mode, 0.0, 0.0};
    return nkw_playback_head_f64(&range, s->time);
}

/* Divides the root of a pose, which keeps the rest. Returns the motion. */
static nkw_trs split_root(const nkw_mixer_set *set, nkw_pose_span pose)
{
    const nkw_root_rule rule = rule_of(set);
    const nkw_trs root = nkw_pose_get(NKW_VIEW(nkw_pose, pose), set->root);
    const nkw_root_motion parts = nkw_root_split(&rule, &root);
    nkw_pose_set(pose, set->root, &parts.rest);
    return parts.motion;
}

/* Samples the clip of a slot. Returns the motion of the root; the identity without root parts. */
static nkw_trs sample_clip(const nkw_mixer_set *set, const nkw_mixer_slot *s, float time, nkw_pose_span pose,
                           float *floats)
{
    nkw_clip_sample(set->clips[s->clip].clip, time, NULL, pose, floats);
    return set->root_parts ? split_root(set, pose) : nkw_trs_identity();
}

static nkw_trs sample_slot(const nkw_mixer_set *set, const nkw_mixer_slot *s, nkw_pose_span pose, float *floats,
                           double *cycle)
{
    const mixer_range range = mixer_range_of(set, s);
    const nkw_play_head_f64 head = head_of(s, range.length);
    *cycle = s->mode == NKW_PLAYBACK_LOOP ? head.cycle : 0.0;
    return sample_clip(set, s, (float)((double)range.start + head.time), pose, floats);
}

/* ---- Layers ---- */

static nkw_mask_view mask_of(const nkw_mixer_set *set, const nkw_mixer_slot *s)
{
    const nkw_mask_view whole = {NULL, set->rest.joint_count};
    return set->mask_count ? set->masks[s->mask] : whole;
}

static nkw_pose_span span_at(const mix *x, float *data)
{
    const nkw_pose_span span = {data, x->pose.joint_count};
    return span;
}

/* Without weight a slot is sampled for the motion of its root only. */
static int is_in_layer(const mix *x, size_t slot, uint32_t layer, int added)
{
    const nkw_mixer_slot *s = &x->m->slot[slot];
    return mixer_plays(s) && s->layer == layer && mixer_is_added(s) == added &&
           (x->set->root_parts || mixer_weight(s) > 0.0f);
}

/* mean = lerp(mean, floats of the sample, weight / (total + weight)) */
static void add_floats(const mix *x, float weight, float *total)
{
    const float share = lane_share(weight, *total);
    *total = *total + weight;
    for (size_t i = 0; i < x->set->float_count; i++)
        x->room->mean_floats[i] = nkw_lerp(x->room->mean_floats[i], x->room->sample_floats[i], share);
}

/* What the weights lack is the share of the floats so far. */
static void settle_floats(const mix *x, float total)
{
    const float share = lane_share(lane_missing((double)total, MIXER_WHOLE), total);
    for (size_t i = 0; i < x->set->float_count; i++)
        x->floats[i] = nkw_lerp(x->room->mean_floats[i], x->floats[i], share);
}

/* Where sample k of a layer goes: the first one to the pose, as long as that has no layer. */
static nkw_pose_span sample_at(const mix *x, size_t k)
{
    const size_t floats = NKW_POSE_FLOATS(x->pose.joint_count);
    return k == 0 && x->so_far.data != x->pose.data ? x->pose : span_at(x, x->room->samples + k * floats);
}

/* Samples the blended slots of a layer. Returns their number. */
static size_t sample_layer(mix *x, uint32_t layer, nkw_pose_layer *layers)
{
    float total = 0.0f;
    size_t count = 0;
    for (size_t i = 0; i < x->m->slot_count; i++) {
        if (!is_in_layer(x, i, layer, 0))
            continue;
        const nkw_mixer_slot *s = &x->m->slot[i];
        const nkw_pose_span sample = sample_at(x, count);
        const nkw_pose_layer one = {NKW_VIEW(nkw_pose, sample), mixer_weight(s), mask_of(x->set, s)};
        x->roots->motion[i] =
            sample_slot(x->set, s, sample, x->floats ? x->room->sample_floats : NULL, &x->roots->cycle[i]);
        layers[count++] = one;
        if (x->floats)
            add_floats(x, one.weight, &total);
    }
    if (count && x->floats)
        settle_floats(x, total);
    return count;
}

/*
 * Layers that need no sum, with the bits of nkw_pose_layers_blend: one of the whole weight, which is in the pose; two
 * of the whole weight, from the heavier to the lighter. Returns 0 if these are others.
 */
static int blend_few(const mix *x, const nkw_pose_layer *layers, size_t count)
{
    if (count == 1)
        return layers->weight >= MIXER_WHOLE && !layers->mask.data && layers->pose.data == x->pose.data;
    if (count != 2 || layers[0].mask.data || layers[1].mask.data || layers[0].weight == layers[1].weight)
        return 0;
    const nkw_pose_layer *heavy = &layers[layers[1].weight > layers[0].weight], *light = &layers[heavy == layers];
    if (!(light->weight > 0.0f) || (double)heavy->weight + (double)light->weight < (double)MIXER_WHOLE)
        return 0;
    const float t = lane_share(light->weight, heavy->weight);
    return nkw_pose_blend(heavy->pose, light->pose, t, heavy->mask, x->pose) == NKW_OK;
}

static void blend_layer(mix *x, uint32_t layer)
{
    nkw_pose_layer layers[NKW_MIXER_SLOTS];
    if (x->floats)
        memset(x->room->mean_floats, 0, x->set->float_count * sizeof(float));
    const size_t count = sample_layer(x, layer, layers);
    if (count == 0)
        return;
    if (!blend_few(x, layers, count))
        nkw_pose_layers_blend(layers, count, x->so_far, MIXER_WHOLE, x->pose);
    x->so_far = NKW_VIEW(nkw_pose, x->pose);
}

/* The reference of an added slot: the caller's, or the start of its clip. */
static void sample_reference(const mix *x, const nkw_mixer_slot *s, nkw_pose_span out, float *floats)
{
    const nkw_mixer_clip *clip = &x->set->clips[s->clip];
    const float start = mixer_range_of(x->set, s).start;
    if (!clip->reference.data) {
        sample_clip(x->set, s, start, out, floats);
        return;
    }
    if (floats)
        nkw_clip_sample(clip->clip, start, NULL, (nkw_pose_span){NULL, out.joint_count}, floats);
    memcpy(out.data, clip->reference.data, NKW_POSE_FLOATS(out.joint_count) * sizeof(float));
    if (x->set->root_parts)
        split_root(x->set, out);
}

static void add_slot(mix *x, size_t slot)
{
    const nkw_mixer_slot *s = &x->m->slot[slot];
    const mixer_room *room = x->room;
    const nkw_pose_span sample = span_at(x, room->samples), reference = span_at(x, room->reference);
    const float weight = mixer_weight(s);
    x->roots->motion[slot] =
        sample_slot(x->set, s, sample, x->floats ? room->sample_floats : NULL, &x->roots->cycle[slot]);
    sample_reference(x, s, reference, x->floats ? room->reference_floats : NULL);
    nkw_pose_additive_build(NKW_VIEW(nkw_pose, sample), NKW_VIEW(nkw_pose, reference), NKW_ADDITIVE_LOCAL, sample);
    nkw_pose_additive_apply(x->so_far, NKW_VIEW(nkw_pose, sample), weight, mask_of(x->set, s), NKW_ADDITIVE_LOCAL,
                            x->pose);
    x->so_far = NKW_VIEW(nkw_pose, x->pose);
    for (size_t i = 0; x->floats && i < x->set->float_count; i++)
        x->floats[i] = x->floats[i] + weight * (room->sample_floats[i] - room->reference_floats[i]);
}

/* Finds the least layer from *layer on. Returns 0 if there is none. */
static int find_layer(const nkw_mixer *m, uint64_t *layer)
{
    uint64_t least = UINT64_MAX;
    for (size_t i = 0; i < m->slot_count; i++)
        if (mixer_plays(&m->slot[i]) && m->slot[i].layer >= *layer && m->slot[i].layer < least)
            least = m->slot[i].layer;
    *layer = least;
    return least != UINT64_MAX;
}

size_t nkwi_mixer_most_in_layer(const nkw_mixer *m)
{
    size_t most = 1;
    for (uint64_t layer = 0; find_layer(m, &layer); layer++) {
        size_t count = 0;
        for (size_t i = 0; i < m->slot_count; i++)
            count += mixer_plays(&m->slot[i]) && m->slot[i].layer == layer;
        most = count > most ? count : most;
    }
    return most;
}

void nkwi_mixer_mix(const nkw_mixer *m, const nkw_mixer_set *set, const mixer_room *room, nkw_pose_span pose,
                    float *floats, mixer_roots *roots)
{
    mix x = {m, set, room, set->rest, pose, floats, roots};
    for (size_t i = 0; floats && i < set->float_count; i++)
        floats[i] = set->rest_floats ? set->rest_floats[i] : 0.0f;
    for (uint64_t layer = 0; find_layer(m, &layer); layer++) {
        blend_layer(&x, (uint32_t)layer);
        for (size_t i = 0; i < m->slot_count; i++)
            if (is_in_layer(&x, i, (uint32_t)layer, 1))
                add_slot(&x, i);
    }
    if (x.so_far.data != pose.data)
        memcpy(pose.data, x.so_far.data, NKW_POSE_FLOATS(pose.joint_count) * sizeof(float));
}

/* ---- The motion of the root ---- */

void nkwi_mixer_begin_root(nkw_mixer_slot *s, const nkw_mixer_set *set, const mixer_room *room)
{
    const nkw_pose_span pose = {room->samples, set->rest.joint_count};
    const mixer_range range = mixer_range_of(set, s);
    s->first = sample_clip(set, s, range.start, pose, NULL);
    s->last = sample_clip(set, s, range.end, pose, NULL);
    s->motion = sample_slot(set, s, pose, NULL, &s->cycle);
}

static float weight_of_motion(const nkw_mixer_set *set, const nkw_mixer_slot *s)
{
    const nkw_mask_view mask = mask_of(set, s);
    const float part = mask.data ? nkw_clamp(mask.data[set->root], 0.0f, 1.0f) : 1.0f;
    return mixer_weight(s) * part;
}

nkw_trs nkwi_mixer_take_motion(nkw_mixer *m, const nkw_mixer_set *set, const mixer_roots *roots)
{
    nkw_trs steps[NKW_MIXER_SLOTS + 1];
    float weights[NKW_MIXER_SLOTS + 1];
    double total = 0.0;
    size_t count = 0;
    for (size_t i = 0; i < m->slot_count; i++) {
        nkw_mixer_slot *s = &m->slot[i];
        if (!mixer_plays(s))
            continue;
        const nkw_root_cycle cycle = {s->first, s->last};
        const nkw_trs step = nkw_root_delta(&cycle, &s->motion, &roots->motion[i], roots->cycle[i] - s->cycle);
        s->motion = roots->motion[i];
        s->cycle = roots->cycle[i];
        if (mixer_is_added(s) || s->layer != 0)
            continue;
        steps[count] = step;
        weights[count] = weight_of_motion(set, s);
        total += (double)weights[count++];
    }
    steps[count] = nkw_trs_identity();
    weights[count++] = lane_missing(total, MIXER_WHOLE);
    return nkw_root_blend(steps, weights, count);
}

/* ---- Transitions of the pose ---- */

static nkw_pose_velocity_view velocity_of(nkw_pose_view before, nkw_pose_view now, float seconds, float *memory)
{
    const nkw_pose_velocity_span velocity = {memory, now.joint_count};
    nkw_pose_velocity_from_poses(before, now, seconds, velocity);
    return NKW_VIEW(nkw_pose_velocity, velocity);
}

static nkw_pose_view shown_at(const nkw_mixer_frame *frame, uint32_t at)
{
    const size_t joints = frame->pose.joint_count;
    const nkw_pose_view view = {frame->poses + at * NKW_POSE_FLOATS(joints), joints};
    return view;
}

static float *offsets_of(const nkw_mixer_frame *frame)
{
    return frame->poses + 2 * NKW_POSE_FLOATS(frame->pose.joint_count);
}

static nkw_pose_dead_blend dead_blend_of(const nkw_mixer *m, const nkw_mixer_frame *frame)
{
    const float duration = (float)m->duration;
    const nkw_pose_dead_blend blend = {offsets_of(frame), frame->pose.joint_count, HALF_LIFE_PART * duration, duration};
    return blend;
}

/* From the pose that was shown last, to the new motion: room->first one step ago, frame->pose now. */
static void begin_transition(nkw_mixer *m, double seconds, const mixer_room *room, const nkw_mixer_frame *frame)
{
    const size_t joints = frame->pose.joint_count;
    float *memory = room->velocities;
    nkw_pose_state from = {shown_at(frame, m->shown_at), {NULL, joints}}, to = {{room->first, joints}, {NULL, joints}};
    if (m->shown > 1)
        from.velocity = velocity_of(shown_at(frame, 1 - m->shown_at), from.pose, m->step, memory);
    if (m->transition == NKW_MIXER_DEAD_BLEND) {
        const nkw_pose_dead_blend blend = dead_blend_of(m, frame);
        nkw_pose_dead_blend_begin(&blend, &from);
    } else {
        const nkw_pose_inertia inertia = {offsets_of(frame), joints};
        to.velocity = velocity_of(to.pose, NKW_VIEW(nkw_pose, frame->pose), (float)seconds,
                                  memory + NKW_POSE_VELOCITY_FLOATS(joints));
        nkw_pose_inertia_begin(inertia, &from, &to, (float)m->duration);
    }
    m->elapsed = 0.0;
}

static void keep_shown(nkw_mixer *m, double seconds, const nkw_mixer_frame *frame)
{
    const size_t floats = NKW_POSE_FLOATS(frame->pose.joint_count);
    if (seconds > 0.0 && m->shown > 0) {
        m->shown_at = 1 - m->shown_at;
        m->shown = 2;
        m->step = (float)seconds;
    } else if (m->shown == 0)
        m->shown = 1;
    memcpy(frame->poses + m->shown_at * floats, frame->pose.data, floats * sizeof(float));
}

void nkwi_mixer_show(nkw_mixer *m, double seconds, const mixer_room *room, nkw_mixer_frame *frame)
{
    const nkw_pose_view target = NKW_VIEW(nkw_pose, frame->pose);
    if (m->pending && m->shown > 0)
        begin_transition(m, seconds, room, frame);
    else if (m->pending)
        m->transition = NKW_MIXER_CROSS_FADE;
    m->pending = 0;
    m->elapsed += m->transition == NKW_MIXER_CROSS_FADE ? 0.0 : seconds;
    if (!(m->elapsed < m->duration))
        m->transition = NKW_MIXER_CROSS_FADE;
    if (m->transition == NKW_MIXER_DEAD_BLEND) {
        const nkw_pose_dead_blend blend = dead_blend_of(m, frame);
        nkw_pose_dead_blend_evaluate(&blend, target, (float)m->elapsed, frame->pose);
    } else if (m->transition == NKW_MIXER_INERTIA) {
        const nkw_pose_inertia inertia = {offsets_of(frame), frame->pose.joint_count};
        nkw_pose_inertia_evaluate(inertia, target, (float)m->elapsed, frame->pose);
    }
    if (frame->poses)
        keep_shown(m, seconds, frame);
    else
        m->shown = 0;
}
