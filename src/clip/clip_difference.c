/* SPDX-License-Identifier: MIT */
/*
 * The largest differences between a clip and the tracks from which it was built.
 *
 * Invariant: every key time of a track and of a clip is compared, and DIFFERENCE_QUARTERS - 1 times between neighbours.
 * Tracks with equal times are compared together: a sample of the clip serves all of them.
 *
 *     times of           compared                        at
 *     the tracks         those that have these times     t0, t0 + d/4, t0 + d/2, t0 + 3 d/4, t1 ...    d = t1 - t0
 *     the clip only      all that cover the time         the same; a wrong clip may have keys of its own
 */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/clip.h>
#include <nakawari/quat.h>
#include <nakawari/segment.h>

#include "clip_layout.h"
#include "clip_tracks.h"
#include "track/difference.h"
#include "lane/scalar.h"
#include "work.h"

static float largest(nkw_vec3 got, const float want[3])
{
    const float numbers[3] = {got.x, got.y, got.z};
    return difference_largest(numbers, want, 3);
}

/* Compares the sample of a track with that of the clip. */
static void compare(const nkw_clip *clip, const nkw_clip_track *c, nkw_segment segment, const float *pose,
                    float *floats, nkw_clip_error *error)
{
    /* floats: the sample of the clip, then room for the sample of the track */
    float *of_floats = floats ? floats + clip->floats : NULL, of_joint[4] = {0.0f, 0.0f, 0.0f, 0.0f};
    nkw_track_sample_segment(&c->track, segment, c->target == NKW_CLIP_FLOATS ? of_floats : of_joint);
    const nkw_pose_view whole = {pose, clip->joints};
    nkw_trs got = nkw_pose_get(whole, c->index);
    nkw_quat rotation = {of_joint[0], of_joint[1], of_joint[2], of_joint[3]};
    if (c->target == NKW_CLIP_TRANSLATION)
        error->translation = difference_worse(error->translation, largest(got.translation, of_joint));
    else if (c->target == NKW_CLIP_SCALE)
        error->scale = difference_worse(error->scale, largest(got.scale, of_joint));
    else if (c->target == NKW_CLIP_ROTATION)
        error->rotation = difference_worse(error->rotation, nkw_quat_angle(got.rotation, rotation));
    else
        error->floats =
            difference_worse(error->floats, difference_largest(floats + c->index, of_floats, c->track.width));
}

/* The first track with these key times; track_count if there is none. */
static size_t first_with_times(const nkw_clip_source *source, const nkw_track *keys)
{
    size_t i = 0;
    while (i < source->track_count && !clip_same_times(&source->tracks[i].track, keys))
        i++;
    return i;
}

/* The key times of a timeline of the clip, as a track without values. */
static nkw_track timeline_keys(const nkw_clip *clip, const clip_timeline *line)
{
    nkw_track r = {clip_floats(clip, line->times), NULL, line->count, 0, NKW_TRACK_FLOATS,
                   NKW_INTERPOLATION_STEP,         NULL};
    return r;
}

static int covers(const nkw_track *t, float time)
{
    return t->count > 0 && time >= t->times[0] && time <= t->times[t->count - 1];
}

/*
 * Compares at one time the tracks that have these key times. If `own`, the times are those of a timeline of the clip
 * that no track has: compares all tracks, each from its first to its last key.
 */
static void compare_at(const nkw_clip *clip, const nkw_clip_source *source, const nkw_track *keys, int own, float time,
                       float *pose, float *floats, nkw_clip_error *error)
{
    nkw_pose_span span = {pose, clip->joints};
    nkw_clip_sample(clip, time, NULL, span, floats);
    for (size_t i = 0; i < source->track_count; i++) {
        const nkw_track *t = &source->tracks[i].track;
        if (own ? covers(t, time) : clip_same_times(t, keys))
            compare(clip, &source->tracks[i], nkw_segment_find(t->times, t->count, time), pose, floats, error);
    }
}

static void compare_along(const nkw_clip *clip, const nkw_clip_source *source, const nkw_track *keys, int own,
                          float *pose, float *floats, nkw_clip_error *error)
{
    for (size_t k = 0; k < keys->count; k++)
        for (int quarter = 0; quarter < DIFFERENCE_QUARTERS; quarter++)
            compare_at(clip, source, keys, own, difference_time(keys, k, quarter), pose, floats, error);
}

/* Whether the clip can have been built from these tracks: equal counts, and valid targets. */
static int is_match(const nkw_clip *clip, const nkw_clip_source *source)
{
    int match = source->joint_count == clip->joints && source->float_count == clip->floats;
    for (size_t i = 0; match && i < source->track_count; i++)
        match = nkw_track_value_count(&source->tracks[i].track) > 0 &&
                nkwi_clip_tracks_check_target(source, &source->tracks[i]) == NKW_OK;
    return match;
}

static void compare_all(const nkw_clip *clip, const nkw_clip_source *source, float *pose, float *floats,
                        nkw_clip_error *error)
{
    for (size_t i = 0; i < source->track_count; i++)
        if (first_with_times(source, &source->tracks[i].track) == i)
            compare_along(clip, source, &source->tracks[i].track, 0, pose, floats, error);
    for (uint32_t i = 0; i < clip->timeline_count; i++) {
        nkw_track keys = timeline_keys(clip, clip_timelines(clip) + i);
        if (first_with_times(source, &keys) == source->track_count)
            compare_along(clip, source, &keys, 1, pose, floats, error);
    }
}

nkw_result nkw_clip_difference(const nkw_clip *clip, const nkw_clip_source *source, nkw_clip_error *error,
                               nkw_work work)
{
    const nkw_clip_error none = {0.0f, 0.0f, 0.0f, 0.0f};
    size_t joint_count = clip->joints, float_count = clip->floats;
    float *pose = (float *)work.data;
    if (!is_match(clip, source))
        return NKW_MISMATCHED;
    if (!work_fits(work, NKW_CLIP_DIFFERENCE_WORK(joint_count, float_count)))
        return NKW_TOO_SMALL;
    *error = none;
    compare_all(clip, source, pose, float_count ? pose + NKW_POSE_FLOATS(joint_count) : NULL, error);
    return NKW_OK;
}
