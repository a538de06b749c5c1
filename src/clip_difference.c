/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/clip.h>
#include <nakawari/quat.h>
#include <nakawari/scalar.h>

/* The larger of two, NaN if either is. */
static float worse(float a, float b)
{
    return b > a || b != b ? b : a;
}

static float farthest(const float *a, const float *b, size_t n)
{
    float far = 0.0f;
    for (size_t i = 0; i < n; i++)
        far = worse(far, nkw_abs(a[i] - b[i]));
    return far;
}

static void compare_at(const nkw_clip *clip, const nkw_clip_track *c, float time, float *pose, float *floats,
                       nkw_clip_error *error)
{
    float *of_floats = floats ? floats + nkw_clip_floats(clip) : NULL, of_joint[4] = {0.0f, 0.0f, 0.0f, 0.0f};
    nkw_clip_sample(clip, time, NULL, pose, floats);
    nkw_track_sample(&c->track, time, c->target == NKW_CLIP_FLOATS ? of_floats : of_joint);
    nkw_trs got = nkw_pose_get(pose, nkw_clip_joints(clip), c->index);
    nkw_quat rotation = {of_joint[0], of_joint[1], of_joint[2], of_joint[3]};
    if (c->target == NKW_CLIP_TRANSLATION)
        error->translation = worse(error->translation, farthest(&got.translation.x, of_joint, 3));
    else if (c->target == NKW_CLIP_SCALE)
        error->scale = worse(error->scale, farthest(&got.scale.x, of_joint, 3));
    else if (c->target == NKW_CLIP_ROTATION)
        error->rotation = worse(error->rotation, nkw_quat_angle(got.rotation, rotation));
    else
        error->floats = worse(error->floats, farthest(floats + c->index, of_floats, c->track.width));
}

nkw_clip_error nkw_clip_difference(const nkw_clip *clip, const nkw_clip_source *source, float *pose, float *floats)
{
    nkw_clip_error error = {0.0f, 0.0f, 0.0f, 0.0f};
    if (source->joint_count != nkw_clip_joints(clip) || source->float_count != nkw_clip_floats(clip))
        return error;
    for (size_t i = 0; i < source->track_count; i++) {
        const nkw_track *t = &source->tracks[i].track;
        for (size_t k = 0; k < t->count; k++) {
            float from = t->times[k], to = t->times[k + 1 < t->count ? k + 1 : k];
            for (int quarter = 0; quarter < 4; quarter++)
                compare_at(clip, &source->tracks[i], nkw_lerp(from, to, 0.25f * (float)quarter), pose, floats, &error);
        }
    }
    return error;
}
