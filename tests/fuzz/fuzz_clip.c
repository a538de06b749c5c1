/* SPDX-License-Identifier: MIT */
/* Clips of drawn tracks; the same with bytes of the block changed; any bytes as a block; tracks that are not sound. */
#include "fuzz.h"

#include <string.h>

#include "../support/random_clip.h"
#include "../support/views.h"

enum { MOST_JOINTS = 12 };

/* Any channel: the numbers of the pose and of the floats. */
static void sample_channel(fuzz *f, const nkw_clip *clip, float time, nkw_pose_view pose, const float *floats)
{
    const nkw_clip_target target = (nkw_clip_target)fuzz_choice(f, 4);
    const uint32_t index = fuzz_byte(f) % 2 ? fuzz_byte(f) % 16 : fuzz_bits(f);
    float values[4];
    if (nkw_clip_sample_channel(clip, time, target, index, NULL, values) != NKW_OK)
        return;
    if (target == NKW_CLIP_FLOATS) {
        FUZZ_CHECK(fuzz_same(values, floats + index, 1));
        return;
    }
    const nkw_trs all = nkw_pose_get(pose, index);
    const float *expected = target == NKW_CLIP_ROTATION      ? &all.rotation.x
                            : target == NKW_CLIP_TRANSLATION ? &all.translation.x
                                                             : &all.scale.x;
    FUZZ_CHECK(fuzz_same(values, expected, target == NKW_CLIP_ROTATION ? 4 : 3));
}

static void sample(fuzz *f, const nkw_clip *clip)
{
    const nkw_clip_description d = nkw_clip_describe(clip);
    size_t joints = d.joint_count, floats = d.float_count;
    FUZZ_CHECK(joints + floats <= d.bytes);
    float *pose = fuzz_room(f, NKW_POSE_FLOATS(joints)), *pose_again = fuzz_room(f, NKW_POSE_FLOATS(joints));
    float *out = fuzz_room(f, floats);
    uint32_t *cursor = fuzz_block(f, d.cursor_count * sizeof *cursor);
    const nkw_bytes_span cache = {fuzz_room(f, d.cache_bytes / sizeof(float)), d.cache_bytes};
    memset(cache.data, 0, cache.bytes);
    FUZZ_CHECK(d.start <= d.end);
    const nkw_work work = fuzz_work(f, NKW_CLIP_VELOCITY_WORK(joints, floats));
    const nkw_pose_velocity_span velocity = {fuzz_room(f, NKW_POSE_VELOCITY_FLOATS(joints)), joints};
    for (int i = 0; i < 4; i++) {
        float time = fuzz_float(f);
        const uint32_t some[3] = {0, (uint32_t)fuzz_upto(f, 20), fuzz_byte(f)};
        nkw_clip_sample_velocity(clip, time, velocity, out, work);
        nkw_clip_sample_joints(clip, time, fuzz_byte(f) % 2 ? some : NULL, 3, cursor, pose_span(pose_again, joints));
        nkw_clip_sample(clip, time, cursor, pose_span(pose, joints), out);
        sample_channel(f, clip, time, pose_view(pose, joints), out);
        nkw_clip_sample(clip, time, NULL, pose_span(pose_again, joints), NULL);
        FUZZ_CHECK(fuzz_same(pose, pose_again, NKW_POSE_FLOATS(joints)));
        sample_channel(f, clip, time, pose_view(pose, joints), out);
        for (int again = 0; again < 2; again++) {
            nkw_clip_sample_cached(clip, time, cache, pose_span(pose_again, joints), out);
            FUZZ_CHECK(fuzz_same(pose, pose_again, NKW_POSE_FLOATS(joints)));
        }
    }
}

/* Some tracks of a clip, taken out, and its names. */
static void list(fuzz *f, const nkw_clip *clip)
{
    const nkw_clip_description d = nkw_clip_describe(clip);
    const size_t any = fuzz_huge(f), count = d.track_count;
    const nkw_work work = fuzz_work(f, NKW_CLIP_TRACK_GET_WORK(d.joint_count, d.float_count)), none = {NULL, 0};
    const nkw_track_span nowhere = {NULL, NULL, NULL, 0};
    for (size_t i = 0; i < 3 && i < count; i++) {
        nkw_clip_track shape, out;
        nkw_result asked = nkw_clip_track_get(clip, i * (count / 3), nowhere, &shape, none);
        FUZZ_CHECK(asked != NKW_OK);
        if (asked != NKW_TOO_SMALL)
            continue; /* a damaged clip */
        size_t keys = shape.track.count, capacity = keys - (fuzz_byte(f) % 8 == 0);
        nkw_track_span m = {fuzz_room(f, capacity), fuzz_room(f, 3 * capacity * shape.track.width),
                            fuzz_block(f, capacity), capacity};
        nkw_result result = nkw_clip_track_get(clip, i * (count / 3), m, &out, work);
        FUZZ_CHECK((result == NKW_TOO_SMALL) == (capacity < keys) || result == NKW_OUT_OF_RANGE);
    }
    FUZZ_CHECK(strlen(d.name) + strlen(nkw_clip_joint_name(clip, any)) <= d.bytes);
    FUZZ_CHECK(strlen(nkw_clip_float_name(clip, any % (d.float_count + 1))) <= d.bytes);
}

/* A block in any byte order, at any address. */
static void convert(fuzz *f, const void *block, size_t bytes)
{
    const nkw_clip *clip, *same;
    unsigned char *out = fuzz_block(f, bytes), *again = fuzz_block(f, bytes), *other = fuzz_block(f, bytes);
    for (size_t i = 0; i < bytes; i++)
        other[i] = ((const unsigned char *)block)[(i ^ 3) < bytes ? (i ^ 3) : i];
    nkw_clip_convert(other, bytes, out, &clip);
    if (nkw_clip_convert(block, bytes, out, &clip) != NKW_OK)
        return;
    FUZZ_CHECK(nkw_clip_convert(out, bytes, again, &same) == NKW_OK && memcmp(out, again, bytes) == 0);
    list(f, clip);
}

static void open_and_sample(fuzz *f, const void *block, size_t bytes)
{
    const nkw_clip *clip;
    convert(f, block, bytes);
    nkw_result result = nkw_clip_open(block, bytes, &clip);
    FUZZ_CHECK((result == NKW_OK) == (clip != NULL));
    if (!clip)
        return;
    FUZZ_CHECK((const void *)clip == block && nkw_clip_describe(clip).bytes <= bytes);
    sample(f, clip);
    list(f, clip);
}

/* What is in the block the tracks gave: the same bits, while nothing of them is off. */
static void compare(fuzz *f, const random_clip *c, const nkw_clip *clip)
{
    size_t joints = c->source.joint_count, floats = c->source.float_count;
    float *got = fuzz_room(f, NKW_POSE_FLOATS(joints)), *want = fuzz_room(f, NKW_POSE_FLOATS(joints));
    float *got_floats = fuzz_room(f, floats), *want_floats = fuzz_room(f, floats);
    for (int i = 0; i < 3; i++) {
        float time = fuzz_float(f);
        nkw_clip_sample(clip, time, NULL, pose_span(got, nkw_clip_describe(clip).joint_count), got_floats);
        random_clip_sample(c, time, want, want_floats);
        for (size_t k = 0; k < 10; k++)
            FUZZ_CHECK(fuzz_same(got + k * NKW_POSE_STRIDE(joints), want + k * NKW_POSE_STRIDE(joints), joints));
        FUZZ_CHECK(fuzz_same(got_floats, want_floats, floats));
    }
    nkw_clip_error error;
    const nkw_work work = fuzz_work(f, NKW_CLIP_DIFFERENCE_WORK(joints, floats));
    FUZZ_CHECK(nkw_clip_difference(clip, &c->source, &error, work) == NKW_OK);
}

/* Changes words of the block: to anything, by a little, to another of its words. */
static void damage(fuzz *f, uint32_t *words, size_t count)
{
    for (size_t i = fuzz_byte(f) % 6; i > 0; i--) {
        size_t at = fuzz_byte(f) % 2 ? fuzz_upto(f, 255) % count : fuzz_bits(f) % count;
        unsigned how = fuzz_byte(f);
        words[at] = how % 4 == 0   ? fuzz_bits(f)
                    : how % 4 == 1 ? words[at] + 1u + how / 4u
                    : how % 4 == 2 ? words[at] - 1u - how / 4u
                                   : words[fuzz_bits(f) % count];
    }
}

/* Tracks with wrong targets, joints, widths, methods, and counts; pointers stay within their arrays. */
static void spoil(fuzz *f, random_clip *c)
{
    for (size_t i = fuzz_byte(f) % 4; i > 0 && c->source.track_count; i--) {
        nkw_clip_track *t = &c->tracks[fuzz_upto(f, c->source.track_count - 1)];
        switch (fuzz_byte(f) % 6) {
        case 0:
            t->target = (nkw_clip_target)fuzz_choice(f, 3);
            break;
        case 1:
            t->index = fuzz_byte(f) % 2 ? fuzz_byte(f) : fuzz_bits(f);
            break;
        case 2:
            t->track.width = fuzz_upto(f, 4);
            break;
        case 3:
            t->track.kind = (nkw_track_kind)fuzz_choice(f, 2);
            break;
        case 4:
            t->track.count = fuzz_upto(f, RANDOM_CLIP_KEYS);
            break;
        default:
            c->values[t - c->tracks][fuzz_byte(f)] = fuzz_float(f);
        }
    }
    if (fuzz_byte(f) % 8 == 0)
        c->source.joint_count = fuzz_upto(f, MOST_JOINTS);
    c->source.rest = pose_view(fuzz_byte(f) % 4 == 0 ? NULL : c->rest, c->source.joint_count);
    c->source.format = (nkw_clip_format)fuzz_choice(f, 1);
}

static void *build(fuzz *f, const random_clip *c, size_t *bytes)
{
    size_t bad, again, tracks = c->source.track_count;
    const nkw_work work = fuzz_work(f, NKW_CLIP_BUILD_WORK(tracks));
    FUZZ_CHECK(nkw_clip_build(&c->source, bytes_span(NULL, 0), bytes, &bad, work) != NKW_OK);
    FUZZ_CHECK(bad < tracks || bad == 0);
    if (*bytes == 0)
        return NULL;
    void *block = fuzz_block(f, *bytes);
    FUZZ_CHECK(nkw_clip_build(&c->source, bytes_span(block, *bytes - 1), &again, &bad, work) == NKW_TOO_SMALL);
    FUZZ_CHECK(nkw_clip_build(&c->source, bytes_span(block, *bytes), &again, &bad, work) == NKW_OK);
    FUZZ_CHECK(again == *bytes);
    return block;
}

/* A reduced clip: within any tolerance that is sound; the same with words of the block changed. */
static void reduce(fuzz *f, const random_clip *c)
{
    size_t bad, joints = c->source.joint_count;
    const nkw_work work = fuzz_work(f, NKW_CLIP_REDUCE_WORK(c->source.track_count, joints, c->source.float_count));
    int32_t *parents = fuzz_block(f, joints * sizeof *parents);
    for (size_t j = 0; j < joints; j++)
        parents[j] = (int32_t)fuzz_byte(f) % 16 - 2;
    const nkw_clip_reduction reduction = {
        fuzz_byte(f) % 4 ? parents : NULL, fuzz_float(f), fuzz_float(f), NULL, NULL, fuzz_float(f)};
    nkw_clip_reduced reduced;
    FUZZ_CHECK(nkw_clip_reduce(&c->source, &reduction, bytes_span(NULL, 0), &reduced, &bad, work) != NKW_OK);
    if (reduced.bytes == 0)
        return;
    const size_t bytes = reduced.bytes;
    void *block = fuzz_block(f, bytes);
    if (nkw_clip_reduce(&c->source, &reduction, bytes_span(block, bytes), &reduced, &bad, work) != NKW_OK)
        return;
    const nkw_clip *clip;
    FUZZ_CHECK(nkw_clip_open(block, reduced.bytes, &clip) == NKW_OK && reduced.bytes <= bytes);
    sample(f, clip);
    damage(f, block, reduced.bytes / 4);
    void *copy = fuzz_block(f, reduced.bytes);
    memcpy(copy, block, reduced.bytes);
    open_and_sample(f, copy, reduced.bytes);
}

/* Tracks with fewer keys, from which a clip can be built. */
static void reduce_keys(fuzz *f, const random_clip *c)
{
    size_t bytes, bad, joints = c->source.joint_count;
    const nkw_work work = fuzz_work(f, NKW_CLIP_REDUCE_WORK(c->source.track_count, joints, c->source.float_count));
    const nkw_clip_reduction reduction = {NULL, fuzz_float(f), fuzz_float(f), NULL, NULL, fuzz_float(f)};
    nkw_clip_source_reduced out;
    out.bytes = 0;
    nkw_result result = nkw_clip_source_reduce(&c->source, &reduction, bytes_span(NULL, 0), &out, &bad, work);
    const nkw_bytes_span block = {fuzz_block(f, out.bytes), out.bytes};
    if (out.bytes)
        result = nkw_clip_source_reduce(&c->source, &reduction, block, &out, &bad, work);
    if (result != NKW_OK)
        return;
    FUZZ_CHECK(out.reached.key_count <= out.reached.source_key_count && out.reached.share <= 1.0f);
    FUZZ_CHECK(nkw_clip_build(&out.source, bytes_span(NULL, 0), &bytes, &bad, work) == NKW_TOO_SMALL && bytes > 0);
}

/* Counts alone: those that a clip may have, and none of those beyond. */
static void counts(fuzz *f)
{
    nkw_clip_source source = {NULL, 0, fuzz_huge(f), fuzz_huge(f), {NULL, 0}, NULL, (nkw_clip_format)(fuzz_byte(f) % 2),
                              NULL};
    size_t bytes = 0, bad;
    if (source.joint_count > 4096 && source.joint_count < (size_t)1 << 27)
        source.joint_count %= 4096;
    if (source.float_count > 4096 && source.float_count < (size_t)1 << 30)
        source.float_count %= 4096;
    const nkw_work none = {NULL, 0};
    FUZZ_CHECK(nkw_clip_build(&source, bytes_span(NULL, 0), &bytes, &bad, none) != NKW_OK && bad == 0);
    FUZZ_CHECK((bytes > 0) == (source.joint_count + source.float_count > 0 && source.joint_count <= 4096 &&
                               source.float_count <= 4096));
}

static void any_block(fuzz *f)
{
    size_t bytes = f->size;
    unsigned char *block = fuzz_block(f, bytes);
    if (bytes)
        memcpy(block, f->data, bytes);
    open_and_sample(f, block, bytes);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz f = fuzz_begin(data, size);
    counts(&f);
    random_source r = fuzz_source(&f);
    random_clip *c = fuzz_block(&f, sizeof *c);
    size_t bytes, joints = fuzz_upto(&f, MOST_JOINTS);
    memset(c, 0, sizeof *c);
    random_clip_draw(&r, joints, fuzz_byte(&f) % 3, c);
    int is_sound = fuzz_byte(&f) % 2;
    if (!is_sound)
        spoil(&f, c);
    void *block = build(&f, c, &bytes);
    if (!block)
        return fuzz_end(&f);
    const nkw_clip *clip;
    FUZZ_CHECK(nkw_clip_open(block, bytes, &clip) == NKW_OK);
    if (is_sound)
        compare(&f, c, clip);
    if (fuzz_byte(&f) % 4 == 0)
        reduce(&f, c);
    if (fuzz_byte(&f) % 4 == 0)
        reduce_keys(&f, c);
    damage(&f, block, bytes / 4);
    size_t cut = fuzz_byte(&f) % 8 ? 0 : fuzz_upto(&f, 4096) % (bytes + 1), odd = fuzz_byte(&f) % 32 ? 0 : 1;
    unsigned char *copy = fuzz_block(&f, bytes - cut + odd);
    memcpy(copy + odd, block, bytes - cut);
    open_and_sample(&f, copy + odd, bytes - cut);
    any_block(&f);
    return fuzz_end(&f);
}
