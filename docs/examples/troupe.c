/* SPDX-License-Identifier: MIT */
#include "troupe.h"

#include <stdlib.h>
#include <string.h>

#include <nakawari/playback.h>
#include <nakawari/quat.h>
#include <nakawari/transform.h>

/* ---- a skeleton and a motion of our own making ---- */

enum { KEYS = 31, LIMB = 8 };
static const float duration = 2.0f;

/* Limbs of up to LIMB joints that hang from joint 0. */
static void set_parents(troupe *t)
{
    for (size_t j = 0; j < t->joints; j++)
        t->parents[j] = j == 0 ? NKW_NO_JOINT : (j - 1) % LIMB == 0 ? 0 : (int32_t)(j - 1);
}

/* The pose without motion: a joint a tenth of a metre from its parent, turned a little from limb to limb. */
static void rest_pose(size_t joints, float *pose)
{
    nkw_vec3 z = {0.0f, 0.0f, 1.0f};
    for (size_t j = 0; j < joints; j++) {
        nkw_trs trs = nkw_trs_identity();
        trs.translation.y = 0.1f;
        trs.rotation = nkw_quat_from_axis_angle(z, (j + LIMB - 1) % LIMB == 0 ? 0.7f * (float)(j / LIMB) : 0.0f);
        nkw_pose_set((nkw_pose_span){pose, joints}, j, &trs);
    }
}

/* -1..1, by whole numbers alone. */
static float noise(uint32_t a, uint32_t b)
{
    uint32_t h = (a * 0x9e3779b9u) ^ (b * 0x85ebca6bu);
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    h ^= h >> 13;
    return (float)(h >> 8) / 8388608.0f - 1.0f;
}

/* Every joint turns, its last key as its first, so that the motion loops. */
static void set_rotation(size_t joint, size_t key, float out[4])
{
    uint32_t seed = (uint32_t)joint * 4;
    uint32_t k = key == KEYS - 1 ? 0 : (uint32_t)key;
    nkw_vec3 axis = {1.0f + 0.3f * noise(seed, k), 0.3f * noise(seed + 1, k), 0.3f * noise(seed + 2, k)};
    nkw_quat q = nkw_quat_from_axis_angle(axis, 0.5f * noise(seed + 3, k));
    out[0] = q.x;
    out[1] = q.y;
    out[2] = q.z;
    out[3] = q.w;
}

/* ---- building ---- */

static const char *const no_memory = "not enough memory";

static void set_keys(size_t joints, float *times, float *rotations, nkw_clip_track *tracks)
{
    for (size_t k = 0; k < KEYS; k++)
        times[k] = duration * (float)k / (float)(KEYS - 1);
    for (size_t j = 0; j < joints; j++) {
        float *values = rotations + j * KEYS * 4;
        const nkw_clip_track turning = {NKW_CLIP_ROTATION,
                                        (uint32_t)j,
                                        {times, values, KEYS, 4, NKW_TRACK_ROTATION, NKW_INTERPOLATION_LINEAR, NULL}};
        for (size_t k = 0; k < KEYS; k++)
            set_rotation(j, k, values + 4 * k);
        tracks[j] = turning;
    }
}

static const char *build_clip(troupe *t, const nkw_clip_track *tracks, const float *rest, nkw_work work)
{
    const nkw_clip_source source = {tracks, t->joints, t->joints, 0, {rest, t->joints}, NULL, NKW_CLIP_FLOAT32, NULL};
    size_t bytes;
    nkw_result result = nkw_clip_build(&source, (nkw_bytes_span){NULL, 0}, &bytes, NULL, work);
    if (bytes > 0) {
        t->clip = malloc(bytes);
        if (!t->clip)
            return no_memory;
        result = nkw_clip_build(&source, (nkw_bytes_span){t->clip, bytes}, &bytes, NULL, work);
    }
    return result == NKW_OK ? NULL : nkw_result_text(result);
}

/* Skeleton, clip and inverse bind matrices. */
static const char *build_motion(troupe *t)
{
    size_t joints = t->joints;
    float times[KEYS], *rotations = malloc(joints * KEYS * 4 * sizeof *rotations);
    float *rest = malloc(nkw_pose_floats(joints) * sizeof *rest);
    nkw_clip_track *tracks = malloc(joints * sizeof *tracks);
    const nkw_work work = {malloc(NKW_CLIP_BUILD_WORK(joints)), NKW_CLIP_BUILD_WORK(joints)};
    const char *wrong = no_memory;
    t->parents = malloc(joints * sizeof *t->parents);
    t->inverse_bind = malloc(joints * sizeof *t->inverse_bind);
    if (rotations && rest && tracks && work.data && t->parents && t->inverse_bind) {
        set_parents(t);
        set_keys(joints, times, rotations, tracks);
        rest_pose(joints, rest);
        t->skeleton.parents = t->parents;
        t->skeleton.joint_count = joints;
        nkw_skeleton_models_from_pose(&t->skeleton, (nkw_pose_view){rest, t->skeleton.joint_count}, NULL, NULL,
                                      t->inverse_bind);
        const nkw_palette_source bound = {t->inverse_bind, joints, NULL, NULL, NULL, joints};
        nkw_palette_inverse_bind(&bound, t->inverse_bind);
        wrong = build_clip(t, tracks, rest, work);
    }
    free(rotations);
    free(rest);
    free(tracks);
    free(work.data);
    return wrong;
}

/* One buffer: the baked frames first, then a chunk of one frame for each character, each at a multiple of 256 bytes. */
static const char *build_buffer(troupe *t)
{
    size_t cursors = nkw_clip_describe(t->clip).cursor_count;
    t->chunks = malloc((1 + t->characters) * sizeof *t->chunks);
    t->cursors = calloc(t->characters * cursors + 1, sizeof *t->cursors);
    if (!t->chunks || !t->cursors)
        return no_memory;
    for (size_t i = 0; i <= t->characters; i++) {
        t->chunks[i].frame_count = i ? 1 : t->frames;
        t->chunks[i].joint_count = t->joints;
    }
    nkw_result result = nkw_palette_chunks_place(t->chunks, 1 + t->characters, 4, &t->total, NULL);
    if (result != NKW_OK)
        return nkw_result_text(result);
    t->buffer = malloc(t->total * sizeof *t->buffer);
    return t->buffer ? NULL : no_memory;
}

const char *troupe_build(troupe *t, size_t characters, size_t joints)
{
    const troupe empty = {0};
    *t = empty;
    t->joints = joints;
    t->characters = characters;
    t->frames = (size_t)(duration * TROUPE_RATE) + 1;
    const char *wrong = build_motion(t);
    return wrong ? wrong : build_buffer(t);
}

void troupe_free(troupe *t)
{
    free(t->parents);
    free(t->clip);
    free(t->inverse_bind);
    free(t->cursors);
    free(t->chunks);
    free(t->buffer);
}

int troupe_scratch_make(troupe_scratch *s, size_t joints)
{
    s->poses = malloc(NKW_CROWD * nkw_pose_floats(joints) * sizeof *s->poses);
    s->lane_poses = malloc(NKW_CROWD_POSE_FLOATS(joints) * sizeof *s->lane_poses);
    s->lane_matrices = malloc(NKW_CROWD_MATRIX_FLOATS(joints) * sizeof *s->lane_matrices);
    s->models = malloc(NKW_CROWD * joints * sizeof *s->models);
    return s->poses && s->lane_poses && s->lane_matrices && s->models;
}

void troupe_scratch_free(troupe_scratch *s)
{
    free(s->poses);
    free(s->lane_poses);
    free(s->lane_matrices);
    free(s->models);
}

/* ---- the work ---- */

static size_t count(const troupe *t, troupe_task task)
{
    return task == TROUPE_FRAMES ? t->frames : t->characters;
}

size_t troupe_pieces(const troupe *t, troupe_task task)
{
    return (count(t, task) + NKW_CROWD - 1) / NKW_CROWD;
}

/* Where the matrices of a character or frame belong. */
static nkw_mat4 *place(const troupe *t, troupe_task task, size_t i)
{
    const nkw_palette_chunk *frames = &t->chunks[0];
    return t->buffer + (task == TROUPE_FRAMES ? frames->first + i * frames->joint_count : t->chunks[1 + i].first);
}

/* A character is ahead of the one before it by a part of the clip that never meets the keys' rate. */
static float clip_time(troupe_task task, size_t i, float time)
{
    if (task == TROUPE_FRAMES)
        return (float)i / (float)TROUPE_RATE;
    return nkw_playback_head(NKW_PLAYBACK_LOOP, 0.0f, duration, time + 0.618034f * (float)i).time;
}

static void sample(const troupe *t, troupe_task task, size_t i, float time, float *pose)
{
    uint32_t *cursors = task == TROUPE_FRAMES ? NULL : t->cursors + i * nkw_clip_describe(t->clip).cursor_count;
    nkw_clip_sample(t->clip, clip_time(task, i, time), cursors, (nkw_pose_span){pose, t->joints}, NULL);
}

/* The steps of the lanes: `first` is the piece's first character or frame, `end` the end of its last. */
static void enter(const troupe *t, size_t first, size_t end, troupe_scratch *s)
{
    nkw_pose_view poses[NKW_CROWD];
    for (size_t i = 0; i < NKW_CROWD; i++) {
        poses[i].data = first + i < end ? s->poses + i * nkw_pose_floats(t->joints) : NULL;
        poses[i].joint_count = t->joints;
    }
    nkw_crowd_from_poses(poses, (nkw_crowd_poses_span){s->lane_poses, t->joints});
}

static void leave(const troupe *t, troupe_task task, size_t first, size_t end, troupe_scratch *s)
{
    nkw_mat4 *out[NKW_CROWD];
    for (size_t i = 0; i < NKW_CROWD; i++)
        out[i] = first + i < end ? place(t, task, first + i) : NULL;
    nkw_crowd_to_matrices((nkw_crowd_matrices_view){s->lane_matrices, t->joints}, out);
}

static void make_palette(const troupe *t, const nkw_mat4 *models, nkw_mat4 *out)
{
    const nkw_palette_source source = {models, t->joints, NULL, t->inverse_bind, NULL, t->joints};
    nkw_palette_from_models(&source, (nkw_palette_span){out, t->joints, NKW_PALETTE_MAT4});
}

/* The steps of one character or frame, the i-th of its piece. */
static void single(const troupe *t, troupe_task task, troupe_step step, size_t first, size_t i, float time,
                   troupe_scratch *s)
{
    float *pose = s->poses + i * nkw_pose_floats(t->joints);
    nkw_mat4 *models = s->models + i * t->joints;
    if (step == TROUPE_SAMPLE)
        sample(t, task, first + i, time, pose);
    else if (step == TROUPE_MODELS)
        nkw_skeleton_models_from_pose(&t->skeleton, (nkw_pose_view){pose, t->skeleton.joint_count}, NULL, NULL, models);
    else
        make_palette(t, models, place(t, task, first + i));
}

void troupe_do(const troupe *t, troupe_task task, troupe_step step, size_t piece, float time, troupe_scratch *s)
{
    size_t first = piece * NKW_CROWD, end = first + NKW_CROWD;
    end = end < count(t, task) ? end : count(t, task);
    const nkw_crowd_poses_view poses = {s->lane_poses, t->joints};
    const nkw_crowd_matrices_span matrices = {s->lane_matrices, t->joints};
    const nkw_crowd_matrices_view no_roots = {NULL, 0};
    if (step == TROUPE_ENTER)
        enter(t, first, end, s);
    else if (step == TROUPE_LANE_MODELS)
        nkw_crowd_models_from_pose(&t->skeleton, poses, no_roots, matrices);
    else if (step == TROUPE_LANE_PALETTE)
        nkw_crowd_palette_from_models(NKW_VIEW(nkw_crowd_matrices, matrices), NULL, t->inverse_bind, matrices);
    else if (step == TROUPE_LEAVE)
        leave(t, task, first, end, s);
    else
        for (size_t i = 0; first + i < end; i++)
            single(t, task, step, first, i, time, s);
}

void troupe_piece(const troupe *t, troupe_task task, int lanes, size_t piece, float time, troupe_scratch *s)
{
    troupe_do(t, task, TROUPE_SAMPLE, piece, time, s);
    int step = lanes ? TROUPE_ENTER : TROUPE_MODELS, last = lanes ? TROUPE_LEAVE : TROUPE_PALETTE;
    for (; step <= last; step++)
        troupe_do(t, task, (troupe_step)step, piece, time, s);
}

/* ---- */

uint64_t troupe_hash(const troupe *t)
{
    uint64_t hash = 0xcbf29ce484222325u;
    for (size_t i = 0; i < t->total; i++) {
        uint32_t words[16];
        memcpy(words, t->buffer[i].m, sizeof words);
        for (int k = 0; k < 16; k++)
            hash = (hash ^ words[k]) * 0x100000001b3u;
    }
    return hash;
}

void troupe_clear(const troupe *t)
{
    memset(t->buffer, 0xff, t->total * sizeof *t->buffer);
}
