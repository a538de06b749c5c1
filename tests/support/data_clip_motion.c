/* SPDX-License-Identifier: MIT */
#include <string.h>

#include "data.h"
#include "hash.h"
#include "random.h"
#include "views.h"

#define JOINTS 67
#define KEYS   5
#define TRACKS (2 * JOINTS + 1)

typedef struct scene {
    nkw_clip_track tracks[TRACKS];
    float times[KEYS], values[TRACKS][12 * KEYS];
    uint32_t block[32 * 1024];
    unsigned char work[128 * 1024];
    float pose[NKW_POSE_FLOATS(JOINTS)], to[NKW_POSE_FLOATS(JOINTS)];
    float velocity[NKW_POSE_VELOCITY_FLOATS(JOINTS)];
} scene;

static void draw(random_source *r, scene *s, nkw_interpolation interpolation)
{
    memset(s->tracks, 0, sizeof s->tracks);
    for (size_t k = 0; k < KEYS; k++)
        s->times[k] = 0.25f * (float)k;
    for (size_t i = 0; i < TRACKS; i++) {
        nkw_clip_track *c = &s->tracks[i];
        c->target = i < JOINTS ? NKW_CLIP_ROTATION : i < 2 * JOINTS ? NKW_CLIP_TRANSLATION : NKW_CLIP_FLOATS;
        c->index = i < 2 * JOINTS ? (uint32_t)(i % JOINTS) : 0;
        c->track.width = i < JOINTS ? 4 : i < 2 * JOINTS ? 3 : 1;
        c->track.kind = i < JOINTS ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS;
        c->track.interpolation = interpolation;
        c->track.times = s->times;
        c->track.values = s->values[i];
        c->track.count = KEYS;
        for (size_t k = 0; k < 3 * KEYS; k++) {
            nkw_quat q = random_rotation(r);
            memcpy(s->values[i] + k * c->track.width, &q, c->track.width * sizeof(float));
        }
    }
}

static const nkw_clip *build(scene *s, nkw_clip_format format)
{
    nkw_clip_source source;
    size_t bytes;
    memset(&source, 0, sizeof source);
    source.tracks = s->tracks;
    source.track_count = TRACKS;
    source.joint_count = JOINTS;
    source.float_count = 1;
    source.format = format;
    nkw_clip_build(&source, bytes_span(s->block, sizeof s->block), &bytes, NULL, work_in(s->work, sizeof s->work));
    return (const nkw_clip *)(const void *)s->block;
}

static uint64_t hash_rows(uint64_t hash, const float *rows, size_t count)
{
    for (size_t c = 0; c < count; c++)
        hash = hash_floats(hash, rows + c * NKW_POSE_STRIDE(JOINTS), JOINTS);
    return hash;
}

static uint64_t hash_clip(uint64_t hash, scene *s, const nkw_clip *clip, float time)
{
    float number, channel[4] = {0, 0, 0, 0};
    for (uint32_t k = 0; k < 4 * JOINTS; k += 5) {
        nkw_clip_sample_channel(clip, time, (nkw_clip_target)(k % 4), k / 4, NULL, channel);
        hash = hash_floats(hash, channel, 4);
    }
    nkw_pose_velocity_span velocity = {s->velocity, JOINTS};
    nkw_clip_sample_joints(clip, time, NULL, 20, NULL, pose_span(s->pose, JOINTS));
    for (size_t c = 0; c < 10; c++)
        hash = hash_floats(hash, s->pose + c * NKW_POSE_STRIDE(JOINTS), 20);
    nkw_clip_sample_velocity(clip, time, velocity, &number, work_in(s->work, sizeof s->work));
    hash = hash_floats(hash_rows(hash, s->velocity, 9), &number, 1);
    nkw_clip_sample(clip, 0.0f, NULL, pose_span(s->to, JOINTS), NULL);
    nkw_clip_sample(clip, time, NULL, pose_span(s->pose, JOINTS), NULL);
    nkw_pose_state a = {pose_view(s->pose, JOINTS), {s->velocity, JOINTS}}, b = {pose_view(s->to, JOINTS), {NULL, 0}};
    nkw_pose_velocity_blend(&a, &b, 0.25f, 1.5f, mask_view(NULL, JOINTS), velocity);
    return hash_rows(hash, s->velocity, 9);
}

uint64_t data_clip_motion(void)
{
    static scene s;
    uint64_t hash = HASH_START;
    random_source r = random_from(37);
    for (int i = 0; i < 6; i++) {
        draw(&r, &s, (nkw_interpolation)(i % 3));
        const nkw_clip *clip = build(&s, i < 3 ? NKW_CLIP_FLOAT32 : NKW_CLIP_UNORM16);
        hash = hash_clip(hash_clip(hash, &s, clip, 0.375f), &s, clip, 0.9375f);
    }
    return hash;
}
