/* SPDX-License-Identifier: MIT */
#include "random_clip.h"

#include <string.h>

#include "tracks.h"
#include "views.h"

static void draw_times(random_source *r, random_clip *c)
{
    for (int k = 0; k < RANDOM_CLIP_KEYS; k++) {
        c->times[0][k] = nkw_timeline_time((nkw_timeline){0.0f, 30.0f, 0}, (size_t)k);
        for (int line = 1; line < RANDOM_CLIP_LINES; line++)
            c->times[line][k] =
                k == 0 ? 0.125f * (float)(line - 1) : c->times[line][k - 1] + 0.01f + 0.05f * random_unit(r);
        c->modes[k] = (unsigned char)(random_bits(r) % 2);
        c->cubic_modes[k] = (unsigned char)(random_bits(r) % 3);
    }
}

/*
 * Rotations that go on from key to key by a right angle at most, now and then anywhere, some with the sign turned; of
 * some tracks rounded to three digits.
 */
static void draw_rotations(random_source *r, float *v, size_t count)
{
    nkw_quat q = random_rotation(r);
    int rounded = random_bits(r) % 4 == 0;
    for (size_t k = 0; k < count; k++) {
        uint64_t kind = random_bits(r) % 8;
        q = kind == 0 ? random_rotation(r) : kind == 1 ? nkw_quat_negate(q) : random_near(r, q, 0.3f * random_unit(r));
        nkw_quat kept = q;
        if (rounded) {
            const float *from = &q.x;
            float *to = &kept.x;
            for (size_t i = 0; i < 4; i++)
                to[i] = (float)(int)(1000.0f * from[i]) / 1000.0f;
        }
        memcpy(v + 4 * k, &kept, sizeof kept);
    }
}

static void draw_values(random_source *r, nkw_track *t, float *v, int constant)
{
    size_t count = nkw_track_value_count(t);
    if (t->kind == NKW_TRACK_FLOATS)
        for (size_t i = 0; i < count; i++)
            v[i] = random_bits(r) % 32 == 0 ? -0.0f : random_between(r, -3, 3);
    else
        draw_rotations(r, v, count / 4);
    if (!constant)
        return;
    size_t key = count / t->count, width = t->width;
    for (size_t i = 0; i < count; i++)
        v[i] = t->interpolation != NKW_INTERPOLATION_CUBICSPLINE ? v[i % key]
               : i % key >= width && i % key < 2 * width         ? v[width + i % width]
                                                                 : 0.0f;
}

static void add_track(random_source *r, random_clip *c, nkw_clip_target target, size_t index, size_t width, int variety)
{
    size_t i = c->source.track_count++;
    nkw_clip_track *track = &c->tracks[i];
    uint64_t bits = random_bits(r);
    size_t line = variety == 0 ? 0 : variety != 2 ? 1 : (size_t)(bits % RANDOM_CLIP_LINES);
    int is_normalized = variety == 2 ? (bits >> 16) % 4 == 0 : variety > 2 && c->source.joint_count % 2 == 1;
    track->target = target;
    track->index = (uint32_t)index;
    track->track.times = c->times[line];
    track->track.values = c->values[i];
    track->track.count = variety == 2 && (bits >> 8) % 16 == 0 ? 1 : RANDOM_CLIP_KEYS;
    track->track.width = width;
    track->track.kind = target != NKW_CLIP_ROTATION ? NKW_TRACK_FLOATS
                        : is_normalized             ? NKW_TRACK_ROTATION_NORMALIZED
                                                    : NKW_TRACK_ROTATION;
    track->track.interpolation = variety < 2    ? NKW_INTERPOLATION_LINEAR
                                 : variety == 2 ? (nkw_interpolation)((bits >> 24) % 3)
                                                : NKW_INTERPOLATION_CUBICSPLINE;
    track->track.key_interpolation = variety == 4 ? c->cubic_modes : NULL;
    if (variety == 2 && track->track.interpolation != NKW_INTERPOLATION_LINEAR && (bits >> 32) % 2 == 0)
        track->track.key_interpolation =
            track->track.interpolation == NKW_INTERPOLATION_STEP ? c->modes : c->cubic_modes;
    draw_values(r, &track->track, c->values[i], variety > 0 && variety < 3 && (bits >> 40) % 4 == 0);
}

void random_clip_draw(random_source *r, size_t joints, int variety, random_clip *c)
{
    nkw_clip_source source = {
        c->tracks,        0,   joints, variety == 2 ? RANDOM_CLIP_FLOATS : 0, {c->rest, joints}, c->rest_floats,
        NKW_CLIP_FLOAT32, NULL};
    c->source = source;
    draw_times(r, c);
    for (size_t j = 0; j < joints; j++) {
        nkw_trs trs = {random_vec3(r, -1, 1), random_rotation(r), random_vec3(r, 0.5f, 2)};
        nkw_pose_set(pose_span(c->rest, joints), j, &trs);
    }
    for (size_t i = 0; i < RANDOM_CLIP_FLOATS; i++)
        c->rest_floats[i] = random_unit(r);
    /* Backwards, for tracks may stand in any order. */
    for (size_t j = joints; j-- > 0;) {
        uint64_t bits = variety == 1 || variety == 2 ? random_bits(r) : 0;
        if (bits % 4 != 1)
            add_track(r, c, NKW_CLIP_ROTATION, j, 4, variety);
        if ((bits >> 4) % 4 != 1)
            add_track(r, c, NKW_CLIP_SCALE, j, 3, variety);
        if ((bits >> 8) % 4 != 1)
            add_track(r, c, NKW_CLIP_TRANSLATION, j, 3, variety);
    }
    if (variety == 2) {
        add_track(r, c, NKW_CLIP_FLOATS, 7, 3, variety);
        add_track(r, c, NKW_CLIP_FLOATS, 1, 4, variety);
        add_track(r, c, NKW_CLIP_FLOATS, 0, 1, variety);
    }
}

void random_clip_sample(const random_clip *c, float time, float *pose, float *floats)
{
    size_t joints = c->source.joint_count;
    for (size_t j = 0; j < joints; j++) {
        nkw_trs trs = nkw_pose_get(pose_view(c->rest, joints), j);
        nkw_pose_set(pose_span(pose, joints), j, &trs);
    }
    memcpy(floats, c->rest_floats, c->source.float_count * sizeof *floats);
    for (size_t i = 0; i < c->source.track_count; i++)
        track_sample_to(&c->tracks[i], time, joints, pose, floats);
}
