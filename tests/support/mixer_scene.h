/* SPDX-License-Identifier: MIT */
/* A mixer with three random clips, masks, events and markers, and random calls of it; for C and C++. */
#ifndef NAKAWARI_TESTS_MIXER_SCENE_H
#define NAKAWARI_TESTS_MIXER_SCENE_H

#include <string.h>

#include "random_clip.h"
#include "views.h"

enum { MIXER_JOINTS = 9, MIXER_CLIPS = 3, MIXER_EVENTS = 40, MIXER_BLOCK = 1 << 16 };
#define MIXER_POSE NKW_POSE_FLOATS(MIXER_JOINTS)

typedef struct mixer_scene {
    random_clip drawn;
    float blocks[MIXER_CLIPS][MIXER_BLOCK / 4], rest[MIXER_POSE], rest_floats[RANDOM_CLIP_FLOATS];
    float mask[NKW_POSE_STRIDE(MIXER_JOINTS)];
    nkw_mixer_clip clips[MIXER_CLIPS];
    nkw_mixer_mark marks[MIXER_CLIPS][3];
    float markers[MIXER_CLIPS][2];
    nkw_mask_view masks[2];
    nkw_mixer_set set;
    nkw_mixer mixer;
    float poses[NKW_MIXER_POSES_FLOATS(MIXER_JOINTS)], pose[MIXER_POSE], floats[RANDOM_CLIP_FLOATS];
    nkw_mixer_event events[MIXER_EVENTS];
    nkw_mixer_frame frame;
    unsigned char memory[NKW_MIXER_WORK(NKW_MIXER_SLOTS, MIXER_JOINTS, RANDOM_CLIP_FLOATS) + 16];
} mixer_scene;

static inline nkw_work mixer_scene_work(mixer_scene *s)
{
    return work_in(s->memory, sizeof s->memory);
}

/* Clips of different lengths; clip 1 is played in part. */
static inline void mixer_scene_draw_clip(mixer_scene *s, random_source *r, size_t i)
{
    unsigned char build[NKW_CLIP_BUILD_WORK(RANDOM_CLIP_TRACKS) + 16];
    size_t bytes = 0;
    random_clip_draw(r, MIXER_JOINTS, 2, &s->drawn);
    nkw_clip_build(&s->drawn.source, bytes_span(s->blocks[i], sizeof s->blocks[i]), &bytes, NULL,
                   work_in(build, sizeof build));
    nkw_mixer_clip *clip = &s->clips[i];
    clip->clip = (const nkw_clip *)(const void *)s->blocks[i];
    if (i == 1) {
        clip->start = 0.25f;
        clip->end = 0.625f;
    }
    const float start = i == 1 ? 0.25f : 0.0f, end = i == 1 ? 0.625f : nkw_clip_describe(clip->clip).end;
    for (int k = 0; k < 3; k++) {
        s->marks[i][k].time = nkw_lerp(start, end, 0.5f * (float)k);
        s->marks[i][k].duration = k == 1 ? 0.125f : 0.0f;
    }
    s->markers[i][0] = nkw_lerp(start, end, 0.125f * (float)(1 + i));
    s->markers[i][1] = nkw_lerp(start, end, 0.75f);
    clip->events = s->marks[i];
    clip->event_count = 3;
    clip->markers = s->markers[i];
    clip->marker_count = 2;
}

static inline void mixer_scene_draw(mixer_scene *s, random_source *r, uint32_t root_parts)
{
    memset(s, 0, sizeof *s);
    for (size_t i = 0; i < MIXER_CLIPS; i++)
        mixer_scene_draw_clip(s, r, i);
    memcpy(s->rest, s->drawn.rest, sizeof s->rest);
    memcpy(s->rest_floats, s->drawn.rest_floats, sizeof s->rest_floats);
    for (size_t j = 0; j < MIXER_JOINTS; j++)
        s->mask[j] = (float)(j % 3) * 0.5f;
    s->masks[1] = mask_view(s->mask, MIXER_JOINTS);
    s->set.clips = s->clips;
    s->set.clip_count = MIXER_CLIPS;
    s->set.masks = s->masks;
    s->set.mask_count = 2;
    s->set.rest = pose_view(s->rest, MIXER_JOINTS);
    s->set.rest_floats = s->rest_floats;
    s->set.float_count = RANDOM_CLIP_FLOATS;
    s->set.root_parts = root_parts;
    s->frame.pose = pose_span(s->pose, MIXER_JOINTS);
    s->frame.floats = s->floats;
    s->frame.poses = s->poses;
    s->frame.events = s->events;
    s->frame.event_capacity = MIXER_EVENTS;
}

static inline nkw_result mixer_scene_advance(mixer_scene *s, double seconds)
{
    return nkw_mixer_advance(&s->mixer, &s->set, seconds, &s->frame, mixer_scene_work(s));
}

static inline nkw_mixer_options mixer_scene_options(random_source *r)
{
    nkw_mixer_options o;
    memset(&o, 0, sizeof o);
    o.clip = (uint32_t)(random_bits(r) % MIXER_CLIPS);
    o.mask = (uint32_t)(random_bits(r) % 4 == 0);
    o.layer = (uint32_t)(random_bits(r) % 4 == 0);
    o.group = (uint32_t)(random_bits(r) % 3);
    o.mode = (nkw_playback)(random_bits(r) % 3);
    o.blend = random_bits(r) % 4 ? NKW_MIXER_BLEND : NKW_MIXER_ADD;
    o.sync = (nkw_mixer_sync)(random_bits(r) % 3);
    o.transition = (nkw_mixer_transition)(random_bits(r) % 4);
    o.fade = (float)(random_bits(r) % 64) / 64.0f;
    o.time = random_between(r, -1.0f, 1.0f);
    return o;
}

/* A random call, or none: plays, stops, another weight or speed. */
static inline void mixer_scene_act(mixer_scene *s, random_source *r)
{
    const size_t slot = random_bits(r) % NKW_MIXER_SLOTS;
    const uint64_t kind = random_bits(r) % 16;
    if (kind < 3) {
        const nkw_mixer_options o = mixer_scene_options(r);
        nkw_mixer_play(&s->mixer, &s->set, &o, NULL);
    } else if (kind == 3)
        nkw_mixer_stop(&s->mixer, slot, (float)(random_bits(r) % 32) / 64.0f);
    else if (kind == 4)
        s->mixer.slot[slot].weight = random_between(r, -0.25f, 1.5f);
    else if (kind == 5)
        s->mixer.slot[slot].speed = random_between(r, -2.0f, 2.0f);
}

#endif
