/* SPDX-License-Identifier: MIT */
/* Nodes and tracks of a BVH file. */
#include "bvh.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/euler.h>
#include <nakawari/quat.h>
#include <nakawari/scalar.h>
#include <nakawari/vec.h>

/* Where the file has none that can be used. */
#define FRAMES_A_SECOND 30.0

static int make_nodes(nkwi_bvh *b)
{
    static const nkwi_place root = {NULL, NULL, 0}, place = {&root, "nodes", 0};
    const nkw_trs identity = {{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f, 1.0f}, {1.0f, 1.0f, 1.0f}};
    nkw_document_node *nodes = (nkw_document_node *)calloc(b->node_count, sizeof *nodes);
    int32_t *parents = (int32_t *)calloc(b->node_count, sizeof *parents);
    int done = nodes && parents;
    if (!done)
        nkwi_fail(b->error, NULL, NKW_IMPORT_NO_MEMORY, "no memory for the joints");
    for (size_t i = 0; done && i < b->node_count; i++) {
        parents[i] = b->nodes[i].parent;
        nodes[i].name = b->nodes[i].name;
        nodes[i].number = i;
        nodes[i].mesh = nodes[i].skin = NKW_NO_JOINT;
        nodes[i].rest = identity;
        nodes[i].rest.translation = b->nodes[i].offset;
    }
    done = done && nkwi_document_nodes(b->document, b->error, &place, nodes, parents, b->node_count);
    free(nodes);
    free(parents);
    return done;
}

/* ---- A property of a joint ---- */

static int has_property(const nkwi_bvh_node *node, int property)
{
    for (size_t i = 0; i < node->channel_count; i++)
        if (node->channels[i] / 3 == property)
            return 1;
    return 0;
}

/* The channels replace the components of `start`, or are added to them. */
static nkw_vec3 vector_of(const nkwi_bvh_node *node, int property, nkw_vec3 start, const float *frame, int adds)
{
    float v[3] = {start.x, start.y, start.z};
    for (size_t i = 0; i < node->channel_count; i++)
        if (node->channels[i] / 3 == property) {
            float *at = &v[node->channels[i] % 3];
            *at = adds ? *at + frame[i] : frame[i];
        }
    nkw_vec3 r = {v[0], v[1], v[2]};
    return r;
}

/* The rotations of the channels from left to right: one order of Euler angles where all three are there. */
static nkw_quat rotation_of(const nkwi_bvh_node *node, const float *frame)
{
    static const int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    static const nkw_euler_order names[6] = {NKW_EULER_XYZ, NKW_EULER_XZY, NKW_EULER_YXZ,
                                             NKW_EULER_YZX, NKW_EULER_ZXY, NKW_EULER_ZYX};
    int axes[3] = {-1, -1, -1}, count = 0, order = 0;
    float angles[3] = {0.0f, 0.0f, 0.0f};
    for (size_t i = 0; i < node->channel_count; i++)
        if (node->channels[i] / 3 == BVH_ROTATION) {
            axes[count++] = node->channels[i] % 3;
            angles[node->channels[i] % 3] = nkw_radians_from_degrees(frame[i]);
        }
    /* The axes that are missing turn by 0: the first order that begins with those that are there. */
    while (order < 5 && memcmp(orders[order], axes, (size_t)count * sizeof *axes) != 0)
        order++;
    const nkw_vec3 all = {angles[0], angles[1], angles[2]};
    return nkw_quat_from_euler(all, names[order]);
}

/* The values of a track. Rotations have the sign of the key before. */
static void fill_track(const nkwi_bvh *b, const nkwi_bvh_node *node, int property, size_t frames, int adds,
                       float *values)
{
    const nkw_vec3 one = {1.0f, 1.0f, 1.0f};
    nkw_quat last = {0.0f, 0.0f, 0.0f, 0.0f};
    for (size_t k = 0; k < frames; k++) {
        const float *frame = b->values + k * b->channel_count + node->first;
        if (property == BVH_ROTATION) {
            nkw_quat q = rotation_of(node, frame);
            last = nkw_quat_dot(last, q) < 0.0f ? nkw_quat_negate(q) : q;
            memcpy(values + 4 * k, &last, sizeof last);
        } else {
            const nkw_vec3 v = vector_of(node, property, property == BVH_SCALE ? one : node->offset, frame,
                                         adds && property == BVH_POSITION);
            memcpy(values + 3 * k, &v, sizeof v);
        }
    }
}

static int add_track(nkwi_bvh *b, size_t joint, int property, const float *times, size_t frames, int adds,
                     nkw_document_animation *a, nkw_clip_track *tracks, nkw_document_channel *channels)
{
    static const nkw_clip_target targets[] = {NKW_CLIP_TRANSLATION, NKW_CLIP_ROTATION, NKW_CLIP_SCALE};
    const size_t width = property == BVH_ROTATION ? 4 : 3;
    nkw_clip_track *t = &tracks[a->track_count];
    nkw_document_channel *channel = &channels[a->track_count];
    float *values = (float *)nkwi_document_take(b->document, b->error, NULL, frames, width * sizeof *values);
    if (!values)
        return 0;
    fill_track(b, &b->nodes[joint], property, frames, adds, values);
    t->target = targets[property];
    channel->number = a->track_count++;
    channel->joint = b->document->all.joint_of_node[joint];
    channel->bytes = frames * (1 + width) * sizeof *values;
    t->index = (uint32_t)channel->joint;
    t->track.times = times;
    t->track.values = values;
    t->track.count = frames;
    t->track.width = width;
    t->track.kind = property == BVH_ROTATION ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS;
    t->track.interpolation = NKW_INTERPOLATION_LINEAR;
    return 1;
}

/* ---- What is odd ---- */

/* The frames that are there, and the warnings about their number and their time. Returns 0 without memory. */
static int count_frames(nkwi_bvh *b, size_t *frames)
{
    nkwi_document *d = b->document;
    const size_t whole = b->channel_count ? b->value_count / b->channel_count : b->stated;
    *frames = whole;
    if (b->channel_count == 0 && b->value_count > 0)
        return nkwi_bvh_fail(b, "there are numbers of frames, but no CHANNELS");
    if (b->channel_count && b->value_count % b->channel_count &&
        !nkwi_document_warn(d, b->error, "the last frame is not complete: %zu of %zu numbers; it is left out",
                            b->value_count % b->channel_count, b->channel_count))
        return 0;
    if (whole != b->stated &&
        !nkwi_document_warn(d, b->error, "%zu frames are stated, %zu are there and are used", b->stated, whole))
        return 0;
    if (b->frame_time > 0.0)
        return 1;
    b->frame_time = 1.0 / FRAMES_A_SECOND;
    return nkwi_document_warn(d, b->error, "Frame Time is not positive: %g frames a second are used", FRAMES_A_SECOND);
}

/* Whether the position channels of a joint are near 0 in all frames, although it has an offset. */
static int is_relative(const nkwi_bvh *b, const nkwi_bvh_node *node, size_t frames)
{
    const nkw_vec3 none = {0.0f, 0.0f, 0.0f};
    const float offset = nkw_vec3_length(node->offset);
    if (node->parent < 0 || !has_property(node, BVH_POSITION) || !(offset > 0.0f))
        return 0;
    for (size_t k = 0; k < frames; k++) {
        const float *frame = b->values + k * b->channel_count + node->first;
        if (nkw_vec3_length(vector_of(node, BVH_POSITION, none, frame, 0)) > 0.25f * offset)
            return 0;
    }
    return frames > 0;
}

static int warn_of_offsets(nkwi_bvh *b, size_t frames)
{
    size_t count = 0;
    for (size_t i = 0; i < b->node_count; i++)
        count += (size_t)is_relative(b, &b->nodes[i], frames);
    return count == 0 ||
           nkwi_document_warn(b->document, b->error,
                              "positions of %zu joints are near 0 under an OFFSET, and may add to it: --bvh-offset add",
                              count);
}

/* ---- The document ---- */

static int make_animation(nkwi_bvh *b, size_t frames, int adds)
{
    nkwi_document *d = b->document;
    nkw_document_animation *a = (nkw_document_animation *)nkwi_document_take(d, b->error, NULL, 1, sizeof *a);
    float *times = (float *)nkwi_document_take(d, b->error, NULL, frames, sizeof *times);
    const size_t most = 3 * b->node_count;
    nkw_clip_track *tracks = (nkw_clip_track *)nkwi_document_take(d, b->error, NULL, most, sizeof *tracks);
    nkw_document_channel *channels =
        (nkw_document_channel *)nkwi_document_take(d, b->error, NULL, most, sizeof *channels);
    if (!a || !times || !tracks || !channels)
        return 0;
    for (size_t k = 0; k < frames; k++)
        times[k] = (float)((double)k * b->frame_time);
    a->name = nkwi_document_text(d, b->error, "Motion");
    a->tracks = tracks;
    a->channels = channels;
    for (size_t i = 0; a->name && i < b->node_count; i++)
        for (int property = BVH_POSITION; property <= BVH_SCALE; property++)
            if (has_property(&b->nodes[i], property) &&
                !add_track(b, i, property, times, frames, adds, a, tracks, channels))
                return 0;
    d->all.animations = a;
    d->all.animation_count = 1;
    return a->name != NULL;
}

int nkwi_bvh_document(nkwi_bvh *b, int adds_offset)
{
    size_t frames;
    b->document->all.format = "BVH";
    if (!make_nodes(b) || !count_frames(b, &frames))
        return 0;
    if (!adds_offset && !warn_of_offsets(b, frames))
        return 0;
    return frames == 0 || b->channel_count == 0 || make_animation(b, frames, adds_offset);
}
