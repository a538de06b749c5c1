/* SPDX-License-Identifier: MIT */
#include "inplace.h"

#include <stdlib.h>
#include <string.h>

#include <nakawari/mat.h>
#include <nakawari/quat.h>
#include <nakawari/transform.h>

int inplace_parts(const char *text, unsigned *parts)
{
    static const struct {
        const char *name;
        unsigned part;
    } names[] = {
        {"plane", NKW_ROOT_PLANE}, {"height", NKW_ROOT_HEIGHT}, {"yaw", NKW_ROOT_YAW}, {"rotation", NKW_ROOT_ROTATION}};
    *parts = 0;
    while (*text) {
        const size_t length = strcspn(text, ",");
        size_t i = 0;
        while (i < 4 && (strlen(names[i].name) != length || memcmp(names[i].name, text, length) != 0))
            i++;
        if (i == 4)
            return 0;
        *parts |= names[i].part;
        text += length + (text[length] == ',');
    }
    return *parts != 0;
}

/* The track of a joint; of any joint for -1. SIZE_MAX if there is none. */
static size_t find_track(const nkw_document_animation *a, int32_t joint, nkw_clip_target target)
{
    for (size_t i = 0; i < a->track_count; i++)
        if (a->tracks[i].target == target && (joint < 0 || a->channels[i].joint == joint))
            return i;
    return SIZE_MAX;
}

static int32_t find_joint(const model *m, size_t animation, const char *name)
{
    const nkw_document_animation *a = &m->animations[animation];
    const size_t first = find_track(a, -1, NKW_CLIP_TRANSLATION);
    for (size_t j = 0; name && j < m->document.skeleton.joint_count; j++)
        if (input_is_joint(&m->document, j, name, strlen(name)))
            return (int32_t)j;
    return name || first == SIZE_MAX ? NKW_NO_JOINT : a->channels[first].joint;
}

static int before(const void *a, const void *b)
{
    const float x = *(const float *)a, y = *(const float *)b;
    return x < y ? -1 : x > y;
}

/* The key times of both, each once. */
static float *merge_times(model *m, const nkw_track *const tracks[2], size_t *count)
{
    const size_t first = tracks[0] ? tracks[0]->count : 0, second = tracks[1] ? tracks[1]->count : 0;
    float *times = model_take(m, first + second, sizeof *times);
    *count = 0;
    if (!times)
        return NULL;
    if (first)
        memcpy(times, tracks[0]->times, first * sizeof *times);
    if (second)
        memcpy(times + first, tracks[1]->times, second * sizeof *times);
    qsort(times, first + second, sizeof *times, before);
    for (size_t i = 0; i < first + second; i++)
        if (*count == 0 || times[i] > times[*count - 1])
            times[(*count)++] = times[i];
    return times;
}

/* Samples of the track at the times; the rest value without a track. */
static void sample_all(const nkw_track *t, const float *rest, size_t width, const float *times, size_t count,
                       float *out)
{
    uint32_t cursor = 0;
    for (size_t k = 0; k < count; k++) {
        memcpy(out + width * k, rest, width * sizeof *rest);
        if (t)
            nkw_track_sample(t, times[k], &cursor, out + width * k);
    }
}

/* The local transform of a joint at a time: its tracks, or its rest. */
static nkw_trs local_at(const model *m, const nkw_document_animation *a, int32_t joint, float time)
{
    nkw_trs local = nkw_pose_get(m->document.rest, (size_t)joint);
    float *const parts[] = {&local.translation.x, &local.rotation.x, &local.scale.x};
    const nkw_clip_target targets[] = {NKW_CLIP_TRANSLATION, NKW_CLIP_ROTATION, NKW_CLIP_SCALE};
    for (size_t i = 0; i < 3; i++) {
        const size_t track = find_track(a, joint, targets[i]);
        if (track != SIZE_MAX)
            nkw_track_sample(&a->tracks[track].track, time, NULL, parts[i]);
    }
    return local;
}

/* The space that a joint moves in, in the space of the model. */
static nkw_mat4 space_above(const model *m, const nkw_document_animation *a, int32_t joint, float time)
{
    const int32_t *parents = m->document.skeleton.parents;
    nkw_mat4 space = nkw_mat4_identity();
    for (int32_t p = parents[joint]; p >= 0; p = parents[p]) {
        const nkw_trs local = local_at(m, a, p, time);
        const nkw_mat4 matrix = nkw_mat4_from_trs(&local);
        space = nkw_mat4_mul_affine(&matrix, &space);
    }
    return space;
}

/*
 * Removes the motion that the joint has in the space of the model, where up is up: into it by the space P above the
 * joint, t' = P t, q' = R q with R the rotation of P; and back.
 */
static void remove_motion(const model *m, size_t animation, int32_t joint, const nkw_root_rule *rule,
                          const float *times, nkw_vec3 *translations, nkw_quat *rotations, size_t count)
{
    for (size_t k = 0; k < count; k++) {
        const nkw_mat4 space = space_above(m, &m->animations[animation], joint, times[k]);
        const nkw_mat4 back = nkw_mat4_inverse(&space);
        const nkw_quat turn = nkw_trs_from_mat4(&space).rotation;
        nkw_vec3 t = nkw_mat4_transform_point(&space, translations[k]);
        nkw_quat q = nkw_quat_mul(turn, rotations[k]);
        nkw_root_split_keys(rule, &t, &q, NULL, 1);
        translations[k] = nkw_mat4_transform_point(&back, t);
        rotations[k] = nkw_quat_mul(nkw_quat_conjugate(turn), q);
    }
}

static void set_keys(nkw_track *t, const float *times, const float *values, size_t count)
{
    t->times = times;
    t->values = values;
    t->count = count;
    t->interpolation = NKW_INTERPOLATION_LINEAR;
    t->key_interpolation = NULL;
}

static const nkw_track *linear_track(const nkw_document_animation *a, size_t track, int *fine)
{
    const nkw_track *t = track == SIZE_MAX ? NULL : &a->tracks[track].track;
    if (t)
        *fine = *fine && t->interpolation != NKW_INTERPOLATION_CUBICSPLINE && nkw_track_validate(t, NULL) == NKW_OK;
    return t;
}

int inplace_clip(model *m, size_t animation, const char *joint, const nkw_root_rule *rule)
{
    nkw_clip_track *list = model_tracks(m, animation);
    const nkw_document_animation *a = &m->animations[animation];
    const int32_t j = find_joint(m, animation, joint);
    int fine = 1;
    if (j == NKW_NO_JOINT)
        return model_complain(m, animation, joint ? "has no such joint" : "no joint has an animated translation");
    const size_t move = find_track(a, j, NKW_CLIP_TRANSLATION), turn = find_track(a, j, NKW_CLIP_ROTATION);
    const nkw_track *tracks[2] = {linear_track(a, move, &fine), linear_track(a, turn, &fine)};
    if (!fine)
        return model_complain(m, animation, "the joint has CUBICSPLINE keys: use --rate; or keys that check refuses");
    size_t count;
    float *times = merge_times(m, tracks, &count);
    const nkw_trs rest = nkw_pose_get(m->document.rest, (size_t)j);
    nkw_vec3 *translations = model_take(m, count, sizeof *translations);
    nkw_quat *rotations = model_take(m, count, sizeof *rotations);
    if (!times || !translations || !rotations)
        return 0;
    sample_all(tracks[0], &rest.translation.x, 3, times, count, (float *)translations);
    sample_all(tracks[1], &rest.rotation.x, 4, times, count, (float *)rotations);
    remove_motion(m, animation, j, rule, times, translations, rotations, count);
    if (move != SIZE_MAX)
        set_keys(&list[move].track, times, (const float *)translations, count);
    if (turn != SIZE_MAX)
        set_keys(&list[turn].track, times, (const float *)rotations, count);
    return 1;
}
