/* SPDX-License-Identifier: MIT */
#include "fuzz.h"

#include <nakawari/nakawari.h>

#include <string.h>

enum { JOINTS = 3, FLOATS = 2, CLIPS = 2, KEYS = 3, EVENTS = 12 };

/* Clips, masks and marks in blocks of their very sizes. */
typedef struct scene {
    nkw_mixer_set set;
    nkw_mixer_frame frame;
    nkw_work work;
} scene;

static const nkw_clip *draw_clip(fuzz *f, nkw_pose_view rest)
{
    float *times = fuzz_room(f, KEYS), *rotations = fuzz_room(f, 4 * KEYS), *values = fuzz_floats(f, KEYS, 0);
    const float start = (float)fuzz_upto(f, 8) / 8.0f;
    random_source r = fuzz_source(f);
    for (size_t k = 0; k < KEYS; k++) {
        const nkw_quat q = random_rotation(&r);
        times[k] = start + (float)k / 4.0f;
        memcpy(rotations + 4 * k, &q, sizeof q);
    }
    const nkw_clip_track tracks[2] = {
        {NKW_CLIP_ROTATION,
         0,
         {.times = times, .values = rotations, .count = KEYS, .width = 4, .kind = NKW_TRACK_ROTATION}},
        {NKW_CLIP_FLOATS, 1, {.times = times, .values = values, .count = KEYS, .width = 1}},
    };
    const nkw_clip_source source = {
        .tracks = tracks, .track_count = 2, .joint_count = JOINTS, .float_count = FLOATS, .rest = rest};
    nkw_bytes_span block = {NULL, 0};
    const nkw_work work = fuzz_work(f, NKW_CLIP_BUILD_WORK(2));
    size_t bytes = 0;
    FUZZ_CHECK(nkw_clip_build(&source, block, &bytes, NULL, work) == NKW_TOO_SMALL);
    block.data = fuzz_block(f, bytes);
    block.bytes = bytes;
    FUZZ_CHECK(nkw_clip_build(&source, block, &bytes, NULL, work) == NKW_OK);
    return (const nkw_clip *)block.data;
}

static void draw_mixer_clip(fuzz *f, nkw_pose_view rest, int wild, nkw_mixer_clip *c)
{
    memset(c, 0, sizeof *c);
    c->clip = draw_clip(f, rest);
    c->event_count = fuzz_upto(f, 3);
    nkw_mixer_mark *marks = fuzz_block(f, c->event_count * sizeof *marks);
    for (size_t i = 0; i < c->event_count; i++) {
        marks[i].time = wild ? fuzz_float(f) : (float)fuzz_upto(f, 16) / 8.0f;
        marks[i].duration = wild ? fuzz_float(f) : (float)fuzz_upto(f, 4) / 8.0f;
    }
    c->events = marks;
    c->marker_count = fuzz_upto(f, 2);
    float *markers = fuzz_room(f, c->marker_count);
    for (size_t i = 0; i < c->marker_count; i++)
        markers[i] = wild ? fuzz_float(f) : nkw_clip_describe(c->clip).start + (float)i / 4.0f;
    c->markers = markers;
    if (wild && fuzz_byte(f) % 4 == 0)
        c->start = fuzz_float(f), c->end = fuzz_float(f);
    if (fuzz_byte(f) % 4 == 0)
        c->reference = rest;
}

static scene draw_scene(fuzz *f, int wild)
{
    scene s;
    memset(&s, 0, sizeof s);
    nkw_mixer_clip *clips = fuzz_block(f, CLIPS * sizeof *clips);
    nkw_mask_view *masks = fuzz_block(f, 2 * sizeof *masks);
    s.set.rest.data = fuzz_pose(f, JOINTS, 0);
    s.set.rest.joint_count = JOINTS;
    for (size_t i = 0; i < CLIPS; i++)
        draw_mixer_clip(f, s.set.rest, wild, &clips[i]);
    memset(masks, 0, 2 * sizeof *masks);
    masks[1].data = fuzz_floats(f, NKW_POSE_STRIDE(JOINTS), wild);
    masks[1].joint_count = JOINTS;
    s.set.clips = clips;
    s.set.clip_count = CLIPS;
    s.set.masks = masks;
    s.set.mask_count = fuzz_upto(f, 2);
    s.set.float_count = FLOATS;
    s.set.root = fuzz_upto(f, JOINTS - 1);
    s.set.up.y = wild ? fuzz_float(f) : 1.0f;
    s.set.root_parts = fuzz_byte(f) % 16;
    s.frame.pose.data = fuzz_room(f, NKW_POSE_FLOATS(JOINTS));
    s.frame.pose.joint_count = JOINTS;
    s.frame.floats = fuzz_byte(f) % 4 ? fuzz_room(f, FLOATS) : NULL;
    s.frame.poses = fuzz_byte(f) % 4 ? fuzz_room(f, NKW_MIXER_POSES_FLOATS(JOINTS)) : NULL;
    s.frame.event_capacity = fuzz_upto(f, EVENTS);
    s.frame.events = fuzz_block(f, s.frame.event_capacity * sizeof *s.frame.events);
    s.work = fuzz_work(f, NKW_MIXER_WORK(NKW_MIXER_SLOTS, JOINTS, FLOATS));
    return s;
}

static void act(fuzz *f, nkw_mixer *m, const scene *s, int wild)
{
    nkw_mixer_options o;
    memset(&o, 0, sizeof o);
    o.clip = (uint32_t)fuzz_upto(f, CLIPS);
    o.mask = (uint32_t)fuzz_upto(f, 2);
    o.layer = (uint32_t)fuzz_upto(f, 1);
    o.group = (uint32_t)fuzz_upto(f, 1);
    o.mode = (nkw_playback)fuzz_choice(f, 3);
    o.blend = (nkw_mixer_blend)fuzz_choice(f, 2);
    o.sync = (nkw_mixer_sync)fuzz_choice(f, 3);
    o.transition = (nkw_mixer_transition)fuzz_choice(f, 4);
    o.fade = wild ? fuzz_float(f) : (float)fuzz_upto(f, 8) / 8.0f;
    o.time = wild ? fuzz_float(f) : 0.0f;
    size_t slot = 0;
    if (nkw_mixer_play(m, &s->set, &o, &slot) == NKW_OK && fuzz_byte(f) % 2) {
        m->slot[slot].weight = fuzz_float(f);
        m->slot[slot].speed = fuzz_float(f);
    }
    if (fuzz_byte(f) % 4 == 0)
        nkw_mixer_stop(m, fuzz_upto(f, NKW_MIXER_SLOTS), o.fade);
}

/* A step is refused, and changes nothing; or the state is valid after it, if the set is. */
static void step(fuzz *f, nkw_mixer *m, scene *s, int is_valid)
{
    const nkw_mixer before = *m;
    const double seconds = fuzz_byte(f) % 8 ? (double)fuzz_upto(f, 100) / 64.0 : (double)fuzz_float(f);
    const nkw_result result = nkw_mixer_advance(m, &s->set, seconds, &s->frame, s->work);
    if (result == NKW_OK)
        FUZZ_CHECK(!is_valid || nkw_mixer_validate(m, &s->set, NULL) == NKW_OK);
    else
        FUZZ_CHECK(memcmp(&before, m, sizeof before) == 0);
    const uint64_t print = nkw_mixer_fingerprint(m, s->frame.poses, JOINTS, 0);
    FUZZ_CHECK(print == nkw_mixer_fingerprint(m, s->frame.poses, JOINTS, 0));
    FUZZ_CHECK(s->frame.poses || print == nkw_mixer_fingerprint(m, NULL, 0, 0));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz f = fuzz_begin(data, size);
    const int wild = fuzz_byte(&f) % 2;
    scene s = draw_scene(&f, wild);
    nkw_mixer m;
    memset(&m, 0, sizeof m);
    if (wild && fuzz_byte(&f) % 4 == 0)
        memcpy(&m, fuzz_bytes(&f, sizeof m), sizeof m);
    size_t bad = 0;
    const int is_valid = nkw_mixer_set_validate(&s.set, &bad) == NKW_OK;
    FUZZ_CHECK(is_valid || bad < CLIPS);
    for (int k = 0; k < 12; k++) {
        if (fuzz_byte(&f) % 2)
            act(&f, &m, &s, wild);
        step(&f, &m, &s, is_valid);
    }
    return fuzz_end(&f);
}
