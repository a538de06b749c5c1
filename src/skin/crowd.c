/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/crowd.h>
#include <nakawari/mat.h>
#include <nakawari/pose.h>
#include <nakawari/segment.h>

#include "batch/crowd.h"
#include "lane/scalar.h"
#include "report.h"
#include "skin_job.h"
#include "work.h"

nkw_result nkw_crowd_from_poses(const nkw_pose_view *poses, nkw_crowd_poses_span crowd)
{
    const float *data[NKW_CROWD];
    for (size_t i = 0; i < NKW_CROWD; i++) {
        if (poses[i].data && poses[i].joint_count != crowd.joint_count)
            return NKW_MISMATCHED;
        data[i] = poses[i].data;
    }
    nkwi_crowd_from_poses(data, crowd.joint_count, NKW_POSE_STRIDE(crowd.joint_count), crowd.data);
    return NKW_OK;
}

/* Copies the rows 0..2 of joint_count matrices of each lane into the layout of crowd.h; the identity for NULL. */
static void gather(const nkw_mat4 *const *matrices, size_t joint_count, float *crowd)
{
    nkw_mat4 identity = nkw_mat4_identity();
    for (size_t j = 0; j < joint_count; j++)
        for (size_t i = 0; i < NKW_CROWD; i++) {
            const nkw_mat4 *m = matrices[i] ? &matrices[i][j] : &identity;
            for (size_t k = 0; k < 12; k++)
                crowd[(12 * j + k) * NKW_CROWD + i] = m->m[k / 3 * 4 + k % 3];
        }
}

void nkw_crowd_from_matrices(const nkw_mat4 *const *matrices, nkw_crowd_matrices_span crowd)
{
    gather(matrices, crowd.joint_count, crowd.data);
}

void nkw_crowd_to_matrices(nkw_crowd_matrices_view crowd, nkw_mat4 *const *matrices)
{
    nkwi_crowd_to_matrices(crowd.data, crowd.joint_count, matrices);
}

nkw_result nkw_crowd_models_from_pose(const nkw_skeleton *skeleton, nkw_crowd_poses_view poses,
                                      nkw_crowd_matrices_view roots, nkw_crowd_matrices_span models)
{
    size_t joints = skeleton->joint_count;
    if (poses.joint_count != joints || models.joint_count != joints || (roots.data && roots.joint_count != 1))
        return NKW_MISMATCHED;
    nkwi_crowd_models(skeleton->parents, joints, poses.data, roots.data, models.data);
    return NKW_OK;
}

void nkw_crowd_palette_from_models(nkw_crowd_matrices_view models, const int32_t *joints, const nkw_mat4 *inverse_bind,
                                   nkw_crowd_matrices_span palette)
{
    const size_t size = NKW_CROWD_MATRIX_FLOATS(1);
    const nkw_mat4 *const none[NKW_CROWD] = {NULL};
    for (size_t k = 0; k < palette.joint_count; k++) {
        size_t j = joints ? (size_t)joints[k] : k;
        if (j >= models.joint_count)
            gather(none, 1, palette.data + k * size);
        else if (inverse_bind)
            nkwi_crowd_bind(models.data + j * size, &inverse_bind[k], palette.data + k * size);
        else
            memmove(palette.data + k * size, models.data + j * size, size * sizeof(float));
    }
}

/* The stream v of each lane. Lanes without it write to `spare`. */
static crowd_stream stream_of(const nkw_vertices_view *in, const nkw_vertices_span *outs, size_t v, float spare[12])
{
    const nkw_vec3_stream_view *from = skin_in(in, v);
    crowd_stream r = {NULL, skin_vector_stride(from->stride), {NULL}, {0}, 1};
    for (size_t i = 0; i < NKW_CROWD; i++) {
        const nkw_vec3_stream_span *to = skin_out(&outs[i], v);
        r.out[i] = to->data ? (unsigned char *)to->data : (unsigned char *)spare;
        r.out_stride[i] = to->data ? skin_vector_stride(to->stride) : 0;
        r.packed = r.packed && (!to->data || r.out_stride[i] == sizeof(nkw_vec3));
        if (to->data)
            r.in = (const unsigned char *)from->data;
    }
    return r;
}

nkw_result nkw_crowd_skin(nkw_crowd_matrices_view palette, const nkw_skin *skin, nkw_vertices_view in,
                          nkw_skin_options options, const nkw_vertices_span *outs)
{
    const int fit = skin_formats_fit(skin);
    skin_job job = skin_job_of(skin, fit ? palette.joint_count : 0);
    crowd_stream streams[SKIN_STREAMS];
    float spare[12];
    job.palette = (const unsigned char *)palette.data;
    job.options = options;
    for (size_t v = 0; v < SKIN_STREAMS; v++)
        streams[v] = stream_of(&in, outs, v, spare);
    nkwi_crowd_skin(&job, streams);
    return fit ? NKW_OK : NKW_BAD_FORMAT;
}

nkw_result nkw_crowd_sample(const nkw_crowd_players *players, const nkw_clip *clip, nkw_crowd_poses_span crowd,
                            nkw_work work)
{
    float *lanes = (float *)work.data;
    nkw_pose_view poses[NKW_CROWD] = {{NULL, 0}};
    const nkw_clip_description described = nkw_clip_describe(clip);
    size_t joints = described.joint_count, step = described.cursor_count;
    if (crowd.joint_count != joints)
        return NKW_MISMATCHED;
    if (!work_fits(work, NKW_CROWD_SAMPLE_WORK(joints)))
        return NKW_TOO_SMALL;
    for (size_t i = 0; i < players->character_count && i < NKW_CROWD; i++) {
        nkw_pose_span pose = {joints ? lanes + i * NKW_POSE_FLOATS(joints) : lanes, joints};
        nkw_clip_sample(clip, players->times[i], players->cursors ? players->cursors + i * step : NULL, pose, NULL);
        poses[i] = NKW_VIEW(nkw_pose, pose);
    }
    return nkw_crowd_from_poses(poses, crowd);
}

static nkw_result check_frames(const nkw_crowd_source *source)
{
    const nkw_palette_view root = {source->root, 1, NKW_PALETTE_MAT4};
    nkw_result result = source->root ? nkw_palette_validate(root, NULL) : NKW_OK;
    if (result != NKW_OK || !lane_is_finite(source->start) || !lane_is_finite(source->rate))
        return NKW_NOT_FINITE;
    return source->rate == 0.0f ? NKW_OUT_OF_RANGE : NKW_OK;
}

static nkw_result check_source(const nkw_crowd_source *source, size_t *bad)
{
    size_t joints = source->skeleton->joint_count;
    const nkw_palette_source skin = {NULL, joints, source->joints, source->inverse_bind, NULL, source->joint_count};
    nkw_result result = nkw_skeleton_validate(source->skeleton, bad);
    if (result == NKW_OK && nkw_clip_describe(source->clip).joint_count != joints)
        result = NKW_MISMATCHED;
    if (result == NKW_OK)
        result = check_frames(source);
    return result == NKW_OK ? nkw_palette_source_validate(&skin, bad) : result;
}

/* The working memory of nkw_crowd_bake, one section for the output of each step. */
typedef struct bake_work {
    nkw_work poses;
    nkw_crowd_poses_span crowd;
    nkw_crowd_matrices_span models, palette;
} bake_work;

static bake_work bake_work_in(float *work, size_t joints, size_t skin_joints)
{
    bake_work w;
    w.poses.data = work;
    w.poses.bytes = NKW_CROWD_SAMPLE_WORK(joints);
    w.crowd.data = work + w.poses.bytes / sizeof *work;
    w.models.data = w.crowd.data + NKW_CROWD_POSE_FLOATS(joints);
    w.palette.data = w.models.data + NKW_CROWD_MATRIX_FLOATS(joints);
    w.crowd.joint_count = w.models.joint_count = joints;
    w.palette.joint_count = skin_joints;
    return w;
}

/* Bakes `count` frames from `frame` on, at most NKW_CROWD: frame + i is lane i. */
static void bake_lanes(const nkw_crowd_source *source, const nkw_palette_chunk *chunk, nkw_crowd_matrices_view roots,
                       size_t frame, size_t count, const bake_work *w, nkw_mat4 *buffer)
{
    float times[NKW_CROWD];
    const nkw_crowd_players players = {times, NULL, count};
    nkw_mat4 *out[NKW_CROWD] = {NULL};
    for (size_t i = 0; i < count; i++) {
        times[i] = nkw_timeline_time((nkw_timeline){source->start, source->rate, 0}, frame + i);
        out[i] = buffer + chunk->first + (frame + i) * chunk->joint_count;
    }
    nkw_crowd_sample(&players, source->clip, w->crowd, w->poses);
    nkw_crowd_models_from_pose(source->skeleton, NKW_VIEW(nkw_crowd_poses, w->crowd), roots, w->models);
    nkw_crowd_palette_from_models(NKW_VIEW(nkw_crowd_matrices, w->models), source->joints, source->inverse_bind,
                                  w->palette);
    nkw_crowd_to_matrices(NKW_VIEW(nkw_crowd_matrices, w->palette), out);
}

static nkw_result check_bake(const nkw_crowd_source *source, const nkw_palette_chunk *chunk, size_t *bad, nkw_work work)
{
    size_t joints = source->skeleton->joint_count, at = 0;
    nkw_result result = check_source(source, &at);
    if (result == NKW_OK && chunk->joint_count != source->joint_count)
        result = NKW_MISMATCHED;
    if (result == NKW_OK && !work_fits(work, NKW_CROWD_BAKE_WORK(joints, source->joint_count)))
        result = NKW_TOO_SMALL;
    return report(result, at, bad);
}

nkw_result nkw_crowd_bake(const nkw_crowd_source *source, const nkw_palette_chunk *chunk, const nkw_range *frames,
                          nkw_mat4 *buffer, size_t *bad, nkw_work work)
{
    nkw_result result = check_bake(source, chunk, bad, work);
    if (result != NKW_OK)
        return result;
    const bake_work w = bake_work_in((float *)work.data, source->skeleton->joint_count, source->joint_count);
    float root_floats[NKW_CROWD_MATRIX_FLOATS(1)];
    const nkw_mat4 *root[NKW_CROWD];
    for (size_t i = 0; i < NKW_CROWD; i++)
        root[i] = source->root;
    gather(root, 1, root_floats);
    const nkw_crowd_matrices_view roots = {source->root ? root_floats : NULL, 1};
    size_t from = frames ? frames->from : 0, to = frames ? frames->to : chunk->frame_count;
    to = to < chunk->frame_count ? to : chunk->frame_count;
    for (size_t frame = from, count; frame < to; frame += count) {
        count = to - frame < NKW_CROWD ? to - frame : NKW_CROWD;
        bake_lanes(source, chunk, roots, frame, count, &w, buffer);
    }
    return NKW_OK;
}
