/* SPDX-License-Identifier: MIT */
#include "data.h"
#include "mixer_scene.h"

static uint64_t hash_events(uint64_t hash, const nkw_mixer_frame *frame)
{
    float e[6 * MIXER_EVENTS];
    const size_t count = frame->event_count < MIXER_EVENTS ? frame->event_count : MIXER_EVENTS;
    for (size_t i = 0; i < count; i++) {
        const nkw_mixer_event *event = &frame->events[i];
        const float row[6] = {(float)event->slot, (float)event->clip, (float)event->event,
                              (float)event->kind, event->weight,      event->moment};
        memcpy(e + 6 * i, row, sizeof row);
    }
    return nkw_fingerprint_floats(e, 6 * count, hash);
}

static uint64_t hash_frame(uint64_t hash, const mixer_scene *s)
{
    hash = nkw_pose_fingerprint(pose_view(s->pose, MIXER_JOINTS), hash);
    hash = nkw_fingerprint_floats(s->floats, RANDOM_CLIP_FLOATS, hash);
    hash = nkw_fingerprint_floats(&s->frame.motion.translation.x, 10, hash);
    return hash_events(nkw_mixer_fingerprint(&s->mixer, s->poses, MIXER_JOINTS, hash), &s->frame);
}

uint64_t data_mixer(void)
{
    static mixer_scene s;
    random_source r = random_from(0x6d69);
    uint64_t hash = 0;
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
