/* SPDX-License-Identifier: MIT */
#include "data.h"
#include "hash.h"
#include "mixer_scene.h"

static uint64_t hash_events(uint64_t hash, const nkw_mixer_frame *frame)
{
    float e[5 * MIXER_EVENTS];
    const size_t count = frame->event_count < MIXER_EVENTS ? frame->event_count : MIXER_EVENTS;
    for (size_t i = 0; i < count; i++) {
        const nkw_mixer_event *event = &frame->events[i];
        const float row[5] = {(float)event->slot, (float)event->clip, (float)event->event, (float)event->kind,
                              event->weight};
        memcpy(e + 5 * i, row, sizeof row);
    }
    return hash_floats(hash, e, 5 * count);
}

/* The joints alone: padding is not promised. Times are hashed in two parts, so that every bit counts. */
static uint64_t hash_frame(uint64_t hash, const mixer_scene *s)
{
    for (size_t c = 0; c < 10; c++)
        hash = hash_floats(hash, s->pose + c * NKW_POSE_STRIDE(MIXER_JOINTS), MIXER_JOINTS);
    hash = hash_floats(hash, s->floats, RANDOM_CLIP_FLOATS);
    hash = hash_floats(hash, &s->frame.motion.translation.x, 10);
    for (size_t i = 0; i < NKW_MIXER_SLOTS; i++) {
        const double time = s->mixer.slot[i].time;
        const float parts[2] = {(float)time, (float)(time - (double)(float)time)};
        hash = hash_floats(hash, parts, 2);
    }
    return hash_events(hash, &s->frame);
}

uint64_t data_mixer(void)
{
    static mixer_scene s;
    random_source r = random_from(0x6d69);
    uint64_t hash = HASH_START;
    for (int round = 0; round < 4; round++) {
        mixer_scene_draw(&s, &r, round % 2 ? NKW_ROOT_PLANE | NKW_ROOT_YAW : 0);
        for (int frame = 0; frame < 150; frame++) {
            mixer_scene_act(&s, &r);
            mixer_scene_advance(&s, (double)random_unit(&r) / 16.0);
            hash = hash_frame(hash, &s);
        }
    }
    return hash;
}
