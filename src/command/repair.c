/* SPDX-License-Identifier: MIT */
/* nakawari convert --repair: what `check` names, mended. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/mat.h>
#include <nakawari/transform.h>

#include "mend.h"
#include "moment.h"

static void say(const model *m, const char *part, const char *name, size_t count, const char *what)
{
    output_text(stderr, m->original->file);
    fprintf(stderr, ": repaired: %s ", part);
    output_text(stderr, name);
    fprintf(stderr, ": %zu %s\n", count, what);
}

/* ---- tracks ---- */

/* A key while they are sorted: its time, and where it was. */
typedef struct key {
    float time;
    size_t index;
} key;

static int by_time(const void *a, const void *b)
{
    const key *x = a, *y = b;
    return x->time != y->time ? (x->time > y->time) - (x->time < y->time)
                              : (x->index > y->index) - (x->index < y->index);
}

static size_t floats_of(const nkw_track *t)
{
    return t->width * (t->interpolation == NKW_INTERPOLATION_CUBICSPLINE ? 3 : 1);
}

/* The value of a key, after its in-tangent. */
static const float *value_of(const nkw_track *t, size_t k)
{
    return t->values + k * floats_of(t) + (floats_of(t) == t->width ? 0 : t->width);
}

static double length_of(const float *q)
{
    return sqrt((double)q[0] * (double)q[0] + (double)q[1] * (double)q[1] + (double)q[2] * (double)q[2] +
                (double)q[3] * (double)q[3]);
}

/* Whether a key has a time, a value, and of a rotation a length. */
static int is_usable(const nkw_clip_track *track, size_t k)
{
    const float *value = value_of(&track->track, k);
    int usable = isfinite(track->track.times[k]);
    for (size_t i = 0; i < track->track.width; i++)
        usable = usable && isfinite(value[i]);
    return usable && (track->target != NKW_CLIP_ROTATION || length_of(value) > 1e-6);
}

/* The usable keys in the order of their times; of several at one time the last one. */
static size_t sort_keys(const nkw_clip_track *track, key *keys, size_t *disorder)
{
    size_t count = 0, kept = 0;
    for (size_t k = 0; k < track->track.count; k++)
        if (is_usable(track, k)) {
            const key one = {track->track.times[k], k};
            *disorder += count > 0 && one.time < keys[count - 1].time;
            keys[count++] = one;
        }
    if (count)
        qsort(keys, count, sizeof *keys, by_time);
    for (size_t k = 0; k < count; k++)
        if (k + 1 == count || keys[k + 1].time > keys[k].time)
            keys[kept++] = keys[k];
    return kept;
}

/* Copies a key: tangents that are not finite become 0, rotations unit. Returns whether anything changed. */
static int copy_key(const nkw_clip_track *track, size_t k, float *out)
{
    const size_t n = floats_of(&track->track), width = track->track.width;
    const float *from = track->track.values + k * n;
    float *value = out + (n == width ? 0 : width);
    int changed = 0;
    for (size_t i = 0; i < n; i++) {
        out[i] = isfinite(from[i]) ? from[i] : 0.0f;
        changed |= !isfinite(from[i]);
    }
    const double length = track->target == NKW_CLIP_ROTATION ? length_of(value) : 1.0;
    if (fabs(length - 1.0) <= 1e-5)
        return changed;
    for (size_t i = 0; i < width; i++)
        value[i] = (float)((double)value[i] / length);
    return 1;
}

/* One key at 0: the rest pose. */
static int hold(model *m, const nkw_document_channel *channel, nkw_clip_track *track)
{
    const nkw_document_node *node = &m->original->nodes[channel->joint];
    const float *rest[] = {&node->rest.translation.x, &node->rest.rotation.x, &node->rest.scale.x,
                           m->original->rest_floats ? m->original->rest_floats + node->float_first : NULL};
    float *times = model_take(m, 1, sizeof *times), *values = model_take(m, track->track.width, sizeof *values);
    const float *from = rest[track->target];
    if (!times || !values)
        return 0;
    for (size_t i = 0; from && i < track->track.width; i++)
        values[i] = from[i];
    track->track.times = times;
    track->track.values = values;
    track->track.count = 1;
    track->track.interpolation = NKW_INTERPOLATION_STEP;
    track->track.key_interpolation = NULL;
    return 1;
}

/* The track of `count` keys. */
static int take_keys(model *m, nkw_clip_track *track, const key *keys, size_t count, size_t *changed)
{
    nkw_track *t = &track->track;
    const size_t n = floats_of(t);
    float *times = model_take(m, count, sizeof *times), *values = model_take(m, count * n, sizeof *values);
    unsigned char *modes = t->key_interpolation ? model_take(m, count, 1) : NULL;
    if (!times || !values || (t->key_interpolation && !modes))
        return 0;
    for (size_t k = 0; k < count; k++) {
        times[k] = keys[k].time;
        *changed += (size_t)copy_key(track, keys[k].index, values + k * n);
        if (modes)
            modes[k] = t->key_interpolation[keys[k].index];
    }
    t->times = times;
    t->values = values;
    t->key_interpolation = modes;
    t->count = count;
    return 1;
}

static int mend_track(model *m, size_t animation, size_t index)
{
    nkw_clip_track *track = &model_tracks(m, animation)[index];
    const nkw_document_channel *channel = &m->animations[animation].channels[index];
    const char *name = m->original->nodes[channel->joint].name;
    const size_t before = track->track.count;
    size_t disorder = 0, changed = 0;
    key *keys = calloc(before + 1, sizeof *keys);
    const size_t count = keys ? sort_keys(track, keys, &disorder) : 0;
    int fine = keys != NULL;
    nkw_clip_track mended = *track;
    if (fine && count == 0) {
        fine = hold(m, channel, track);
        say(m, "channel of", name, before, "keys, none of which can be used: it holds the rest pose");
    } else if (fine) {
        fine = take_keys(m, &mended, keys, count, &changed);
        if (count < before || disorder || changed)
            *track = mended;
        if (count < before)
            say(m, "channel of", name, before - count,
                "keys that are not finite, of no length or at the time of another removed");
        if (disorder)
            say(m, "channel of", name, disorder, "keys out of order sorted");
        if (changed)
            say(m, "channel of", name, changed, "keys normalised, or their tangents that are not finite set to 0");
    }
    free(keys);
    return fine;
}

/* ---- vertices ---- */

/* Of a vertex: weights of joints that are not there become 0; without any weight the first joint has all. */
static int mend_vertex(uint16_t *joints, float *weights, size_t width, size_t joint_count)
{
    double sum = 0.0, all = 0.0;
    int changed = 0;
    for (size_t i = 0; i < width; i++) {
        const int good = isfinite(weights[i]) && weights[i] >= 0.0f && joints[i] < joint_count;
        changed |= !good;
        joints[i] = joints[i] < joint_count ? joints[i] : 0;
        weights[i] = good ? weights[i] : 0.0f;
        sum += (double)weights[i];
    }
    if (sum == 0.0)
        weights[0] = 1.0f;
    for (size_t i = 0; i < width && sum > 0.0; i++) {
        weights[i] = fabs(sum - 1.0) > 1e-6 ? (float)((double)weights[i] / sum) : weights[i];
        all += (double)weights[i];
    }
    return changed || fabs(sum - 1.0) > 1e-3 || (sum > 0.0 && fabs(all - 1.0) > 1e-3);
}

static int mend_primitive(model *m, nkw_document_primitive *p, size_t joint_count, size_t *changed)
{
    const size_t count = p->vertex_count * p->influence_count;
    uint16_t *joints = model_take(m, count, sizeof *joints);
    float *weights = model_take(m, count, sizeof *weights);
    if (!joints || !weights)
        return 0;
    memcpy(joints, p->joints, count * sizeof *joints);
    memcpy(weights, p->weights, count * sizeof *weights);
    for (size_t v = 0; v < p->vertex_count; v++)
        *changed += (size_t)mend_vertex(joints + v * p->influence_count, weights + v * p->influence_count,
                                        p->influence_count, joint_count);
    p->joints = joints;
    p->weights = weights;
    return 1;
}

/* The number of joints of the smallest skin with which a mesh is drawn; 0: without one. */
static size_t joints_of_mesh(const nkw_document *d, size_t mesh)
{
    size_t least = SIZE_MAX;
    for (size_t j = 0; j < d->skeleton.joint_count; j++)
        if (d->nodes[j].mesh == (int32_t)mesh && d->nodes[j].skin != NKW_NO_JOINT &&
            d->skins[d->nodes[j].skin].joint_count < least)
            least = d->skins[d->nodes[j].skin].joint_count;
    return least == SIZE_MAX ? 0 : least;
}

static int mend_meshes(model *m)
{
    const nkw_document *d = m->original;
    nkw_document_mesh *meshes = model_take(m, d->mesh_count, sizeof *meshes);
    int fine = meshes != NULL;
    for (size_t i = 0; fine && i < d->mesh_count; i++) {
        const size_t joint_count = joints_of_mesh(d, i), n = d->meshes[i].primitive_count;
        nkw_document_primitive *list = model_take(m, n, sizeof *list);
        size_t changed = 0;
        fine = list != NULL;
        meshes[i] = d->meshes[i];
        if (fine && n)
            memcpy(list, d->meshes[i].primitives, n * sizeof *list);
        for (size_t k = 0; fine && joint_count && k < n; k++)
            fine = list[k].influence_count == 0 || mend_primitive(m, &list[k], joint_count, &changed);
        meshes[i].primitives = list;
        m->mends_meshes |= changed > 0;
        if (changed)
            say(m, "mesh", meshes[i].name, changed, "vertices whose joints or weights were wrong");
    }
    if (fine)
        m->document.meshes = meshes;
    return fine;
}

/* ---- skins ---- */

static int is_finite_matrix(const nkw_mat4 *m)
{
    for (int i = 0; i < 16; i++)
        if (!isfinite(m->m[i]))
            return 0;
    return nkw_mat4_determinant(m) != 0.0f;
}

static int is_row_by_row(const nkw_mat4 *m)
{
    return m->m[12] == 0.0f && m->m[13] == 0.0f && m->m[14] == 0.0f && fabsf(m->m[15] - 1.0f) <= 1e-5f &&
           fmaxf(fabsf(m->m[3]), fmaxf(fabsf(m->m[7]), fabsf(m->m[11]))) > 1e-5f;
}

static int mend_skin(model *m, nkw_document_skin *skin, const nkw_mat4 *models)
{
    nkw_mat4 *list = model_take(m, skin->joint_count, sizeof *list);
    size_t made = 0, turned = 0;
    for (size_t i = 0; list && i < skin->joint_count; i++) {
        const nkw_mat4 *from = skin->inverse_bind ? &skin->inverse_bind[i] : NULL;
        const int turns = from && is_row_by_row(from), lost = !from || !is_finite_matrix(from);
        list[i] = lost ? nkw_mat4_inverse(&models[skin->joints[i]]) : turns ? nkw_mat4_transpose(from) : *from;
        made += (size_t)lost;
        turned += (size_t)(turns && !lost);
    }
    skin->inverse_bind = list;
    m->mends_meshes |= made || turned;
    if (made)
        say(m, "skin", skin->name, made, "inverse bind matrices made of the rest pose");
    if (turned)
        say(m, "skin", skin->name, turned, "inverse bind matrices transposed");
    return list != NULL;
}

static int mend_skins(model *m)
{
    const nkw_document *d = m->original;
    nkw_document_skin *skins = model_take(m, d->skin_count, sizeof *skins);
    moment rest;
    int fine = moment_open(&rest, d, INPUT_REST) && skins;
    if (fine)
        moment_at(&rest, 0.0f);
    for (size_t i = 0; fine && i < d->skin_count; i++) {
        skins[i] = d->skins[i];
        fine = mend_skin(m, &skins[i], rest.models);
    }
    moment_close(&rest);
    if (fine)
        m->document.skins = skins;
    return fine;
}

int mend_all(model *m)
{
    int fine = mend_meshes(m) && mend_skins(m);
    m->mends = 1;
    for (size_t a = 0; fine && a < m->original->animation_count; a++)
        for (size_t i = 0; fine && i < m->animations[a].track_count; i++)
            fine = mend_track(m, a, i);
    return fine;
}
