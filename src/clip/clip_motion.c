/* SPDX-License-Identifier: MIT */
/*
 * Samples of some blocks of a clip, and velocities from the two keys around a time.
 *
 *     block               16 lanes of a group, whose places ascend: first .. last
 *     place               of a rotation its joint; of a number c * stride + joint, c the component array
 *
 * A block is sampled as a group of its own: its rows in a key, and its ranges, begin `lanes before * rows` later
 * (clip_layout.h).
 */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/clip_motion.h>

#include "clip_keys.h"
#include "clip_layout.h"
#include "clip_sample.h"
#include "lane/blend.h"
#include "lane/quat.h"
#include "work.h"

/* Whether one of the joints has a place in first .. last: exact for places of one array, generous for more. */
static int is_wanted(size_t first, size_t last, size_t stride, const uint32_t *joints, size_t joint_count)
{
    const size_t from = first % stride, to = last % stride;
    if (first / stride != last / stride)
        return joint_count > 0;
    if (!joints)
        return from < joint_count;
    for (size_t i = 0; i < joint_count; i++)
        if (joints[i] >= from && joints[i] <= to)
            return 1;
    return 0;
}

/* The stride of the places of a group. */
static size_t places_of(const nkw_clip *clip, const clip_group *g)
{
    return g->kind == GROUP_FLOATS ? (size_t)clip->floats : NKW_POSE_STRIDE((size_t)clip->joints);
}

static int block_is_wanted(const nkw_clip *clip, const clip_group *g, size_t k, const uint32_t *joints,
                           size_t joint_count)
{
    const clip_block *b = clip_blocks(clip, g) + k;
    return b->count > 0 &&
           is_wanted(clip_place_of(b, 0), clip_place_of(b, b->count - 1), places_of(clip, g), joints, joint_count);
}

static void sample_joints(const nkw_clip *clip, const clip_group *g, nkw_segment at, const uint32_t *joints,
                          size_t joint_count, float *pose)
{
    const size_t stride = NKW_POSE_STRIDE((size_t)clip->joints);
    const clip_timeline *line = clip_timelines(clip) + g->timeline;
    float *out = g->kind == GROUP_ROTATIONS ? pose + 3 * stride : pose;
    int any = 0;
    for (size_t k = 0; k < g->block_count; k++)
        if (block_is_wanted(clip, g, k, joints, joint_count)) {
            any = 1;
            if (!g->packed)
                nkwi_clip_sample_block(clip, g, line, at, k, out, stride);
        }
    if (any && g->packed)
        nkwi_clip_sample_group(clip, g, line, at, out, stride);
}

nkw_result nkw_clip_sample_joints(const nkw_clip *clip, float time, const uint32_t *joints, size_t joint_count,
                                  uint32_t *cursors, nkw_pose_span pose)
{
    const clip_group *groups = clip_groups(clip);
    nkw_segment at = {0, 0.0f};
    if (pose.joint_count != clip->joints)
        return NKW_MISMATCHED;
    nkwi_clip_copy_runs(clip, clip->constants, clip->constant_count, pose.data);
    for (uint32_t g = 0; g < clip->group_count; g++) {
        const uint32_t i = groups[g].timeline;
        if (g == 0 || i != groups[g - 1].timeline)
            at = nkwi_clip_find(clip, clip_timelines(clip) + i, time, cursors ? cursors + i : NULL);
        if (groups[g].kind != GROUP_FLOATS)
            sample_joints(clip, &groups[g], at, joints, joint_count, pose.data);
    }
    return NKW_OK;
}

/* ---- one channel ---- */

/* The constant at a place of the pose or the floats; 0 if no run has it. */
static float constant_at(const nkw_clip *clip, uint32_t at, uint32_t count, size_t place)
{
    const clip_run *runs = (const clip_run *)(const void *)(clip_words(clip) + at);
    float value = 0.0f;
    for (uint32_t r = 0; r < count; r++)
        if (place >= runs[r].to && place - runs[r].to < clip_run_floats(&runs[r])) {
            const size_t i = place - runs[r].to;
            value = clip_floats(clip, runs[r].values)[runs[r].count & CLIP_IS_FILL ? i / CLIP_FILL : i];
        }
    return value;
}

/* The numbers of a channel: of a rotation those of one lane, otherwise the lanes at place, place + stride, ... */
typedef struct channel {
    clip_kind kind;
    size_t place, stride, width;
} channel;

/* Writes the numbers that a group has. */
static void sample_channel(const nkw_clip *clip, const clip_group *g, nkw_segment at, const channel *c, float *values)
{
    const clip_timeline *line = clip_timelines(clip) + g->timeline;
    float lanes[4 * CLIP_BLOCK];
    for (size_t i = 0; i < (c->kind == GROUP_ROTATIONS ? 1 : c->width); i++) {
        const size_t lane = clip_lane_of(clip, g, c->place + i * c->stride);
        if (lane == g->lanes)
            continue;
        nkwi_clip_sample_lanes(clip, g, line, at, lane / CLIP_BLOCK, lanes);
        for (size_t r = 0; r < (c->kind == GROUP_ROTATIONS ? 4 : 1); r++)
            values[i + r] = lanes[CLIP_BLOCK * r + lane % CLIP_BLOCK];
    }
}

nkw_result nkw_clip_sample_channel(const nkw_clip *clip, float time, nkw_clip_target target, uint32_t index,
                                   uint32_t *cursors, float *values)
{
    const size_t stride = NKW_POSE_STRIDE((size_t)clip->joints);
    const int is_float = target == NKW_CLIP_FLOATS, is_rotation = target == NKW_CLIP_ROTATION;
    const channel c = {is_float      ? GROUP_FLOATS
                       : is_rotation ? GROUP_ROTATIONS
                                     : GROUP_NUMBERS,
                       index + (target == NKW_CLIP_SCALE ? 7 * stride : 0), stride,
                       is_float      ? 1u
                       : is_rotation ? 4u
                                     : 3u};
    if (target != NKW_CLIP_TRANSLATION && target != NKW_CLIP_SCALE && !is_float && !is_rotation)
        return NKW_BAD_METHOD;
    if (index >= (is_float ? clip->floats : clip->joints))
        return NKW_OUT_OF_RANGE;
    for (size_t i = 0; i < c.width; i++)
        values[i] = is_float ? constant_at(clip, clip->float_constants, clip->float_constant_count, c.place)
                             : constant_at(clip, clip->constants, clip->constant_count,
                                           c.place + (i + (is_rotation ? 3 : 0)) * stride);
    for (const clip_group *g = clip_groups(clip), *end = g + clip->group_count; g < end; g++)
        if (g->kind == (uint32_t)c.kind) {
            uint32_t *cursor = cursors ? cursors + g->timeline : NULL;
            sample_channel(clip, g, nkwi_clip_find(clip, clip_timelines(clip) + g->timeline, time, cursor), &c, values);
        }
    return NKW_OK;
}

/* ---- velocities ---- */

/* What receives velocities, and memory for the values of two keys. */
typedef struct velocities {
    float *out, *floats;
    float *pose[2], *values[2];
    float time;
} velocities;

/* The track of two keys around the time; values: 6 * 4 floats at most. */
typedef struct two_keys {
    nkw_track track;
    float times[2], values[24];
    unsigned char modes[2];
} two_keys;

/* The first key of the segment at the time; 0 where all velocities are 0: outside of the keys, and for STEP. */
static int segment_moves(const nkw_clip *clip, const clip_group *g, float time, size_t *k, unsigned char *mode)
{
    const clip_timeline *line = clip_timelines(clip) + g->timeline;
    const float *times = clip_floats(clip, line->times);
    if (line->count < 2 || !(time >= times[0]) || time > times[line->count - 1])
        return 0;
    *k = nkwi_clip_find(clip, line, time, NULL).index;
    *k = *k < line->count - 2 ? *k : line->count - 2;
    *mode = (unsigned char)(line->modes ? clip_words(clip)[line->modes + *k] : g->interpolation);
    return *mode != NKW_INTERPOLATION_STEP;
}

/* The values of the track that begins at a place, at both keys. Returns 0 if a part of a track is missing. */
static int read_keys(const nkw_clip *clip, const clip_group *g, uint32_t place, size_t k, const velocities *v,
                     two_keys *keys)
{
    const size_t stride = NKW_POSE_STRIDE((size_t)clip->joints), width = keys->track.width;
    if (g->interpolation == NKW_INTERPOLATION_CUBICSPLINE)
        return nkwi_clip_cubic_keys(clip, g, place, k, keys->values);
    for (size_t i = 0; i < 2 * width; i++) {
        const float *pose = v->pose[i / width] + (g->kind == GROUP_ROTATIONS ? 3 * stride : 0);
        keys->values[i] = g->kind == GROUP_FLOATS ? v->values[i / width][place] : pose[place + i % width * stride];
    }
    return 1;
}

static void put_velocity(const nkw_clip *clip, const clip_group *g, uint32_t place, const velocities *v, two_keys *keys)
{
    const size_t stride = NKW_POSE_STRIDE((size_t)clip->joints); /* 0 where the clip has floats only */
    const size_t row = g->kind == GROUP_ROTATIONS ? 3 : place < stride ? 0 : 6;
    float velocity[4];
    const nkw_motion_span motion = {NULL, velocity, NULL};
    nkw_track_sample_motion(&keys->track, v->time, motion);
    if (g->kind == GROUP_FLOATS)
        v->floats[place] = velocity[0];
    else
        for (size_t i = 0; i < 3; i++)
            v->out[(row + i) * stride + place % stride] = velocity[i];
}

/* All tracks of a group: each begins in a lane. */
static void add_group(const nkw_clip *clip, const clip_group *g, size_t k, unsigned char mode, const velocities *v)
{
    const clip_timeline *line = clip_timelines(clip) + g->timeline;
    const float *times = clip_floats(clip, line->times) + k;
    const size_t stride = NKW_POSE_STRIDE((size_t)clip->joints);
    const int is_rotation = g->kind == GROUP_ROTATIONS;
    two_keys keys;
    memset(&keys, 0, sizeof keys);
    memcpy(keys.times, times, sizeof keys.times);
    memset(keys.modes, mode, sizeof keys.modes);
    keys.track.times = keys.times;
    keys.track.values = keys.values;
    keys.track.key_interpolation = keys.modes;
    keys.track.count = 2;
    keys.track.width = is_rotation ? 4 : g->kind == GROUP_FLOATS ? 1 : 3;
    keys.track.kind = is_rotation ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS;
    keys.track.interpolation = (nkw_interpolation)g->interpolation;
    for (size_t i = 0; i < 2 && g->interpolation != NKW_INTERPOLATION_CUBICSPLINE; i++) {
        const nkw_segment at = {k, (float)i};
        float *out = g->kind == GROUP_FLOATS ? v->values[i] : v->pose[i] + (is_rotation ? 3 * stride : 0);
        nkwi_clip_sample_group(clip, g, line, at, out, stride);
    }
    for (const clip_block *b = clip_blocks(clip, g), *end = b + g->block_count; b < end; b++)
        for (uint32_t i = 0; i < b->count; i++)
            if (b->starts >> i & 1 && read_keys(clip, g, clip_place_of(b, i), k, v, &keys))
                put_velocity(clip, g, clip_place_of(b, i), v, &keys);
}

nkw_result nkw_clip_sample_velocity(const nkw_clip *clip, float time, nkw_pose_velocity_span velocity, float *floats,
                                    nkw_work work)
{
    const size_t pose = NKW_POSE_FLOATS((size_t)clip->joints), count = clip->floats;
    float *memory = (float *)work.data;
    if (velocity.data && velocity.joint_count != clip->joints)
        return NKW_MISMATCHED;
    if (!work_fits(work, NKW_CLIP_VELOCITY_WORK((size_t)clip->joints, count)))
        return NKW_TOO_SMALL;
    const velocities v = {
        velocity.data, floats, {memory, memory + pose}, {memory + 2 * pose, memory + 2 * pose + count}, time};
    if (work.data) /* a block that was damaged may miss parts of tracks */
        memset(work.data, 0, NKW_CLIP_VELOCITY_WORK((size_t)clip->joints, count));
    if (velocity.data)
        memset(velocity.data, 0, NKW_POSE_VELOCITY_FLOATS((size_t)clip->joints) * sizeof *velocity.data);
    if (floats)
        memset(floats, 0, count * sizeof *floats);
    for (const clip_group *g = clip_groups(clip), *end = g + clip->group_count; g < end; g++) {
        size_t k;
        unsigned char mode;
        if ((g->kind == GROUP_FLOATS ? floats : velocity.data) && segment_moves(clip, g, time, &k, &mode))
            add_group(clip, g, k, mode, &v);
    }
    return NKW_OK;
}

/* ---- through a blend ---- */

/* (omega / 2) q */
static lane_f64_quat derivative_of(lane_f64_quat q, nkw_vec3 omega)
{
    const lane_f64_quat half = {0.5 * (double)omega.x, 0.5 * (double)omega.y, 0.5 * (double)omega.z, 0.0};
    return lane_f64_quat_mul(half, q);
}

/* 2 Im(n' n*) / |n|^2 of n = (1 - w) a + w c; change: w'. */
static nkw_vec3 turn_of_blend(nkw_quat from, nkw_vec3 va, nkw_quat to, nkw_vec3 vb, double w, double change)
{
    const lane_f64_quat a = lane_f64_quat_from(from), b = lane_f64_quat_from(to);
    const lane_f64_quat c = lane_f64_quat_scale(b, lane_f64_quat_dot(a, b) < 0.0 ? -1.0 : 1.0);
    const lane_f64_quat n = lane_f64_quat_add(lane_f64_quat_scale(a, 1.0 - w), lane_f64_quat_scale(c, w));
    const lane_f64_quat own = lane_f64_quat_add(lane_f64_quat_scale(derivative_of(a, va), 1.0 - w),
                                                lane_f64_quat_scale(derivative_of(c, vb), w));
    const lane_f64_quat by_weight = lane_f64_quat_scale(lane_f64_quat_sub(c, a), change);
    const lane_f64_quat turn = lane_f64_quat_mul(lane_f64_quat_add(own, by_weight), lane_f64_quat_conjugate(n));
    const double n2 = lane_f64_quat_dot(n, n), part = n2 > 0.0 ? 2.0 / n2 : 0.0;
    const nkw_vec3 r = {(float)(part * turn.x), (float)(part * turn.y), (float)(part * turn.z)};
    return r;
}

/* (va + w (vb - va)) + w' (b - a) */
static float rate_of_blend(float a, float va, float b, float vb, double w, double change)
{
    const double own = (double)va + w * ((double)vb - (double)va);
    return (float)(own + change * ((double)b - (double)a));
}

static nkw_vec3 vec3_rate_of_blend(nkw_vec3 a, nkw_vec3 va, nkw_vec3 b, nkw_vec3 vb, double w, double change)
{
    const nkw_vec3 r = {rate_of_blend(a.x, va.x, b.x, vb.x, w, change), rate_of_blend(a.y, va.y, b.y, vb.y, w, change),
                        rate_of_blend(a.z, va.z, b.z, vb.z, w, change)};
    return r;
}

static nkw_vec3 velocity_at(nkw_pose_velocity_view v, size_t row, size_t j)
{
    const size_t stride = NKW_POSE_STRIDE(v.joint_count);
    const nkw_vec3 none = {0.0f, 0.0f, 0.0f};
    if (!v.data)
        return none;
    const nkw_vec3 r = {v.data[row * stride + j], v.data[(row + 1) * stride + j], v.data[(row + 2) * stride + j]};
    return r;
}

static void put_vector(nkw_pose_velocity_span v, size_t row, size_t j, nkw_vec3 x)
{
    const size_t stride = NKW_POSE_STRIDE(v.joint_count);
    v.data[row * stride + j] = x.x;
    v.data[(row + 1) * stride + j] = x.y;
    v.data[(row + 2) * stride + j] = x.z;
}

static void blend_joint(const nkw_pose_state *a, const nkw_pose_state *b, double w, double change, size_t j,
                        nkw_pose_velocity_span out)
{
    const nkw_trs p = nkw_pose_get(a->pose, j), q = nkw_pose_get(b->pose, j);
    const nkw_vec3 va = velocity_at(a->velocity, 0, j), vb = velocity_at(b->velocity, 0, j);
    const nkw_vec3 wa = velocity_at(a->velocity, 3, j), wb = velocity_at(b->velocity, 3, j);
    const nkw_vec3 sa = velocity_at(a->velocity, 6, j), sb = velocity_at(b->velocity, 6, j);
    put_vector(out, 0, j, vec3_rate_of_blend(p.translation, va, q.translation, vb, w, change));
    put_vector(out, 3, j, turn_of_blend(p.rotation, wa, q.rotation, wb, w, change));
    put_vector(out, 6, j, vec3_rate_of_blend(p.scale, sa, q.scale, sb, w, change));
}

static int state_fits(const nkw_pose_state *s, size_t joints)
{
    return s->pose.joint_count == joints && (!s->velocity.data || s->velocity.joint_count == joints);
}

nkw_result nkw_pose_velocity_blend(const nkw_pose_state *a, const nkw_pose_state *b, float t, float rate,
                                   nkw_mask_view mask, nkw_pose_velocity_span out)
{
    const size_t joints = out.joint_count, stride = NKW_POSE_STRIDE(joints);
    const float known = t == t ? t : 0.0f;
    if (!state_fits(a, joints) || !state_fits(b, joints) || (mask.data && mask.joint_count != joints))
        return NKW_MISMATCHED;
    for (size_t j = 0; j < joints; j++) {
        const float share = mask.data ? lane_mask(mask.data[j]) : 1.0f;
        blend_joint(a, b, (double)(known * share), share > 0.0f ? (double)rate * (double)share : 0.0, j, out);
    }
    for (size_t c = 0; c < 9 && joints > 0; c++)
        memset(out.data + c * stride + joints, 0, (stride - joints) * sizeof *out.data);
    return NKW_OK;
}
