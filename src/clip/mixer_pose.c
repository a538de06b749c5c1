/* SPDX-License-Identifier: MIT */
/* The pose of a frame: samples of the slots, layers, the motion of the root, transitions. */
#include "mixer_state.h"

#include <string.h>

#include <nakawari/root.h>
#include <nakawari/scalar.h>
#include <nakawari/transform.h>
#include <nakawari/transition.h>

#include "lane/blend.h"
#include "track/playback_cycle.h"

/* The velocity of the old motion of a dead blend is halved in this part of its duration. */
#define HALF_LIFE_PART 0.25f

/* ---- Samples ---- */

typedef struct mix {
    const nkw_mixer_set *set;
    const mixer_room *room;
    nkw_pose_view so_far; /* the rest pose; from the first layer on the pose */
    nkw_pose_span pose;
    float *floats;
} mix;

static nkw_root_rule rule_of(const nkw_mixer_set *set)
{
    const nkw_root_rule rule = {set->up, set->root_parts};
    return rule;
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

/* Samples a clip. With root parts *motion receives the motion of the root. */
static void sample_clip(const nkw_mixer_set *set, const nkw_clip *clip, float time, uint32_t *cursors,
                        nkw_pose_span pose, float *floats, nkw_trs *motion)
{
    nkw_clip_sample(clip, time, cursors, pose, floats);
    if (set->root_parts)
        *motion = split_root(set, pose);
}

/* nkw_playback_head_f64 of a slot. A loop without a closing or a last cycle is its remainder alone. */
static nkw_play_head_f64 head_of(const nkw_mixer_slot *s, double length)
{
    const double cycles = s->mode == NKW_PLAYBACK_LOOP && length >= 0x1p-900 ? s->time / length : INFINITY;
    if (cycles > -0x1p51 && cycles < 0x1p51) {
        nkw_play_head_f64 head = {0.0, 0.0, 0.0};
        head.time = playback_remainder(s->time, length, &head.cycle);
        return head;
    }
    const nkw_playback_range range = {0.0, length, 0.0, s->mode, s->mode, 0.0, 0.0};
    return nkw_playback_head_f64(&range, s->time);
}

static void sample_voice(const nkw_mixer_set *set, mixer_voice *v, nkw_pose_span pose, float *floats)
{
    nkw_mixer_slot *s = v->slot;
    const nkw_play_head_f64 head = head_of(s, v->range.length);
    const float time = (float)((double)v->range.start + head.time);
    uint32_t *cursors = v->clip->clip->timeline_count <= NKW_MIXER_CURSORS ? s->cursors : NULL;
    v->cycle = s->mode == NKW_PLAYBACK_LOOP ? head.cycle : 0.0;
    sample_clip(set, v->clip->clip, time, cursors, pose, floats, &v->motion);
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
static int is_sampled(const mix *x, const mixer_voice *v)
{
    return v->weight > 0.0f || x->set->root_parts;
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

/* Samples the blended slots of a layer, from v to end. Returns their number. */
static size_t sample_layer(mix *x, mixer_voice *v, const mixer_voice *end, nkw_pose_layer *layers)
{
    float total = 0.0f;
    size_t count = 0;
    if (x->floats && x->set->float_count)
        memset(x->room->mean_floats, 0, x->set->float_count * sizeof(float));
    for (; v < end; v++) {
        if (!is_sampled(x, v))
            continue;
        const nkw_pose_span sample = sample_at(x, count);
        const nkw_pose_layer one = {NKW_VIEW(nkw_pose, sample), v->weight, mask_of(x->set, v->slot)};
        sample_voice(x->set, v, sample, x->floats ? x->room->sample_floats : NULL);
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

static void blend_layer(mix *x, mixer_voice *v, const mixer_voice *end)
{
    nkw_pose_layer layers[NKW_MIXER_SLOTS];
    const size_t count = sample_layer(x, v, end, layers);
    if (count == 0)
        return;
    if (!blend_few(x, layers, count))
        nkw_pose_layers_blend(layers, count, x->so_far, MIXER_WHOLE, x->pose);
    x->so_far = NKW_VIEW(nkw_pose, x->pose);
}

/* The reference of an added slot: the caller's, or the start of its clip; without the motion of its root in `room`. */
static nkw_pose_view reference_of(const mix *x, const mixer_voice *v, nkw_pose_span room, float *floats)
{
    const nkw_mixer_clip *clip = v->clip;
    nkw_trs motion;
    if (!clip->reference.data) {
        sample_clip(x->set, clip->clip, v->range.start, NULL, room, floats, &motion);
        return NKW_VIEW(nkw_pose, room);
    }
    if (floats)
        nkw_clip_sample(clip->clip, v->range.start, NULL, (nkw_pose_span){NULL, room.joint_count}, floats);
    if (!x->set->root_parts)
        return clip->reference;
    memcpy(room.data, clip->reference.data, NKW_POSE_FLOATS(room.joint_count) * sizeof(float));
    split_root(x->set, room);
    return NKW_VIEW(nkw_pose, room);
}

static void add_voice(mix *x, mixer_voice *v)
{
    const mixer_room *room = x->room;
    const nkw_pose_span sample = span_at(x, room->samples);
    float *floats = x->floats ? room->reference_floats : NULL;
    const nkw_pose_view reference = reference_of(x, v, span_at(x, room->reference), floats);
    sample_voice(x->set, v, sample, x->floats ? room->sample_floats : NULL);
    nkw_pose_additive_build(NKW_VIEW(nkw_pose, sample), reference, NKW_ADDITIVE_LOCAL, sample);
    nkw_pose_additive_apply(x->so_far, NKW_VIEW(nkw_pose, sample), v->weight, mask_of(x->set, v->slot),
                            NKW_ADDITIVE_LOCAL, x->pose);
    x->so_far = NKW_VIEW(nkw_pose, x->pose);
    for (size_t i = 0; x->floats && i < x->set->float_count; i++)
        x->floats[i] = x->floats[i] + v->weight * (room->sample_floats[i] - room->reference_floats[i]);
}

/* Whether the first slot is the only one and its sample the pose, with the bits of nkw_pose_layers_blend. */
static int is_alone(const mixer_voices *all, const nkw_mixer_set *set)
{
    const mixer_voice *v = all->voice;
    return all->count == 1 && v->weight >= MIXER_WHOLE && !mixer_is_added(v->slot) && !mask_of(set, v->slot).data;
}

/* The blended and the added slots of each layer follow one another. */
void nkwi_mixer_mix(mixer_voices *all, const nkw_mixer_set *set, const mixer_room *room, nkw_pose_span pose,
                    float *floats)
{
    mix x = {set, room, set->rest, pose, floats};
    mixer_voice *v = all->voice, *const end = v + all->count;
    if (!floats && is_alone(all, set)) {
        sample_voice(set, v, pose, NULL);
        return;
    }
    for (size_t i = 0; floats && i < set->float_count; i++)
        floats[i] = set->rest_floats ? set->rest_floats[i] : 0.0f;
    while (v < end) {
        mixer_voice *next = v + 1;
        while (next < end && next->rank == v->rank)
            next++;
        if (!mixer_is_added(v->slot))
            blend_layer(&x, v, next);
        else
            for (; v < next; v++)
                if (is_sampled(&x, v))
                    add_voice(&x, v);
        v = next;
    }
    if (x.so_far.data != pose.data)
        memcpy(pose.data, x.so_far.data, NKW_POSE_FLOATS(pose.joint_count) * sizeof(float));
}

/* ---- The motion of the root ---- */

void nkwi_mixer_begin_root(mixer_voice *v, const nkw_mixer_set *set, const mixer_room *room)
{
    const nkw_pose_span pose = {room->samples, set->rest.joint_count};
    sample_clip(set, v->clip->clip, v->range.start, NULL, pose, NULL, &v->slot->first);
    sample_clip(set, v->clip->clip, v->range.end, NULL, pose, NULL, &v->slot->last);
    sample_voice(set, v, pose, NULL);
    v->slot->motion = v->motion;
    v->slot->cycle = v->cycle;
}

static float weight_of_motion(const nkw_mixer_set *set, const mixer_voice *v)
{
    const nkw_mask_view mask = mask_of(set, v->slot);
    const float part = mask.data ? nkw_clamp(mask.data[set->root], 0.0f, 1.0f) : 1.0f;
    return v->weight * part;
}

nkw_trs nkwi_mixer_take_motion(mixer_voices *all, const nkw_mixer_set *set)
{
    nkw_trs steps[NKW_MIXER_SLOTS + 1];
    float weights[NKW_MIXER_SLOTS + 1];
    double total = 0.0;
    size_t count = 0;
    for (const mixer_voice *v = all->voice; v < all->voice + all->count; v++) {
        nkw_mixer_slot *s = v->slot;
        const nkw_root_cycle cycle = {s->first, s->last};
        const nkw_trs step = nkw_root_delta(&cycle, &s->motion, &v->motion, v->cycle - s->cycle);
        s->motion = v->motion;
        s->cycle = v->cycle;
        if (mixer_is_added(s) || s->layer != 0)
            continue;
        steps[count] = step;
        weights[count] = weight_of_motion(set, v);
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
    keep_shown(m, seconds, frame);
}
