/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "random.h"
#include "random_clip.h"
#include "support/expect.h"
#include "views.h"

enum { CHUNKS = 6, WORDS = 128 * 1024 };

static random_clip drawn;
static uint32_t whole_block[WORDS], blocks[CHUNKS][WORDS];
static unsigned char memory[NKW_CLIP_BUILD_WORK(RANDOM_CLIP_TRACKS)];
static float pose[NKW_POSE_FLOATS(RANDOM_CLIP_JOINTS)], part[NKW_POSE_FLOATS(RANDOM_CLIP_JOINTS)];
static float floats[RANDOM_CLIP_FLOATS], part_floats[RANDOM_CLIP_FLOATS];
static nkw_chunk manifest[CHUNKS];
static const nkw_clip *clips[CHUNKS];
static const nkw_chunks chunks = {manifest, clips, CHUNKS};

static const nkw_clip *build(const nkw_clip_source *source, uint32_t *block)
{
    size_t bytes, bad;
    assert_int_equal(nkw_clip_build(source, bytes_span(block, WORDS * 4), &bytes, &bad, work_in(memory, sizeof memory)),
                     NKW_OK);
    return (const nkw_clip *)(const void *)block;
}

/* The first chunk is one pose; some of the others end at a key. */
static const nkw_clip *build_all(random_source *r)
{
    const nkw_clip *whole = build(&drawn.source, whole_block);
    const nkw_clip_description d = nkw_clip_describe(whole);
    float from = d.start;
    for (size_t k = 0; k < CHUNKS; k++) {
        const float even = d.start + (d.end - d.start) * (float)k / (CHUNKS - 1);
        const float key = drawn.times[k % RANDOM_CLIP_LINES][3 * k];
        const float to = k + 1 == CHUNKS ? d.end : k > 0 && random_bits(r) % 2 && key > from ? key : fmaxf(even, from);
        nkw_clip_track tracks[RANDOM_CLIP_TRACKS];
        nkw_clip_source source;
        assert_int_equal(nkw_clip_source_part(&drawn.source, from, fmaxf(to, from), tracks, &source), NKW_OK);
        clips[k] = build(&source, blocks[k]);
        manifest[k] = nkw_chunk_from_clip(clips[k], from, fmaxf(to, from));
        from = manifest[k].end;
    }
    return whole;
}

static void expect_same(size_t joints, size_t float_count)
{
    for (size_t c = 0; c < 10; c++)
        assert_memory_equal(pose + c * NKW_POSE_STRIDE(joints), part + c * NKW_POSE_STRIDE(joints),
                            joints * sizeof(float));
    assert_memory_equal(floats, part_floats, float_count * sizeof(float));
}

static void chunks_have_the_bits_of_the_whole_clip(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int i = 0; i < 60; i++) {
        const size_t joints = 1 + random_bits(&r) % RANDOM_CLIP_JOINTS;
        random_clip_draw(&r, joints, i % 5, &drawn);
        const nkw_clip *whole = build_all(&r);
        size_t bad = 7, used;
        assert_int_equal(nkw_chunks_validate(manifest, CHUNKS, &bad), NKW_OK);
        assert_int_equal(bad, 0);
        for (int k = 0; k < 200; k++) {
            const float time = k < 4 * CHUNKS ? manifest[k / 4].end : random_clip_time(&r, &drawn, k);
            nkw_clip_sample(whole, time, NULL, pose_span(pose, joints), floats);
            assert_int_equal(nkw_chunks_sample(&chunks, time, pose_span(part, joints), part_floats, &used), NKW_OK);
            expect_same(joints, drawn.source.float_count);
            assert_true(used == 0 || manifest[used].start <= time);
            assert_true(used + 1 == CHUNKS || !(manifest[used + 1].start <= time));
        }
    }
}

/* A pose at a time is one value of each track. */
static void a_chunk_of_no_length_is_a_pose(void **state)
{
    (void)state;
    random_source r = random_from(2);
    random_clip_draw(&r, RANDOM_CLIP_JOINTS, 0, &drawn);
    build_all(&r);
    assert_true(manifest[0].start == manifest[0].end);
    assert_int_equal(nkw_clip_describe(clips[0]).track_count, 0);
    assert_true(manifest[0].bytes < nkw_clip_describe((const nkw_clip *)(const void *)whole_block).bytes / 10);
}

static void expect_nearest(size_t joints, float time, size_t expected, float at)
{
    size_t used = 99;
    assert_int_equal(nkw_chunks_sample(&chunks, time, pose_span(part, joints), part_floats, &used), NKW_EMPTY);
    assert_int_equal(used, expected);
    nkw_clip_sample((const nkw_clip *)(const void *)whole_block, at, NULL, pose_span(pose, joints), floats);
    expect_same(joints, drawn.source.float_count);
}

static void a_missing_chunk_is_replaced_by_the_nearest_time(void **state)
{
    (void)state;
    random_source r = random_from(3);
    const size_t joints = 20;
    random_clip_draw(&r, joints, 1, &drawn);
    build_all(&r);
    const float start = manifest[3].start, end = manifest[3].end;
    const float early = start + 0.25f * (end - start), late = start + 0.75f * (end - start);
    clips[3] = NULL;
    expect_nearest(joints, early, 2, start);
    expect_nearest(joints, late, 4, end);
    clips[4] = clips[5] = NULL;
    expect_nearest(joints, late, 2, start);
    expect_nearest(joints, INFINITY, 2, start);
    clips[0] = clips[1] = NULL;
    expect_nearest(joints, -1, 2, manifest[2].start);
    expect_nearest(joints, NAN, 2, manifest[2].start);
    clips[2] = NULL;
    size_t used;
    memset(part, 0x11, sizeof part);
    memcpy(pose, part, sizeof pose);
    assert_int_equal(nkw_chunks_sample(&chunks, late, pose_span(part, joints), part_floats, &used), NKW_EMPTY);
    assert_int_equal(used, CHUNKS);
    expect_same(joints, drawn.source.float_count);
    const nkw_chunks none = {NULL, NULL, 0};
    assert_int_equal(nkw_chunks_sample(&none, 0, pose_span(part, joints), NULL, NULL), NKW_EMPTY);
}

static void a_chunk_must_be_that_of_the_manifest(void **state)
{
    const nkw_clip *clip;
    (void)state;
    random_source r = random_from(4);
    random_clip_draw(&r, 20, 1, &drawn);
    build_all(&r);
    for (size_t k = 0; k < CHUNKS; k++) {
        assert_int_equal(nkw_chunk_open(&manifest[k], blocks[k], sizeof blocks[k], &clip), NKW_OK);
        assert_ptr_equal(clip, blocks[k]);
        assert_int_equal(nkw_chunk_open(&manifest[k], blocks[(k + 1) % CHUNKS], sizeof blocks[k], &clip),
                         NKW_MISMATCHED);
        assert_null(clip);
        assert_int_equal(nkw_chunk_open(&manifest[k], blocks[k], manifest[k].bytes - 1, &clip), NKW_TOO_SMALL);
        nkw_chunk other = manifest[k];
        other.fingerprint[k % 2] ^= 1;
        assert_int_equal(nkw_chunk_open(&other, blocks[k], sizeof blocks[k], &clip), NKW_MISMATCHED);
    }
    random_clip_draw(&r, 21, 1, &drawn);
    clips[1] = build(&drawn.source, whole_block);
    assert_int_equal(nkw_chunks_sample(&chunks, manifest[1].end / 2, pose_span(part, 21), NULL, NULL), NKW_MISMATCHED);
}

static void each_error_of_a_manifest_is_found(void **state)
{
    size_t bad;
    (void)state;
    const nkw_chunk good[3] = {{0, 0, 100, 3, 1, {0, 0}}, {0, 1, 100, 3, 1, {0, 0}}, {1, 2, 100, 3, 1, {0, 0}}};
    nkw_chunk c[3];
    assert_int_equal(nkw_chunks_validate(good, 3, &bad), NKW_OK);
    assert_int_equal(nkw_chunks_validate(good, 0, &bad), NKW_EMPTY);
    for (int i = 0; i < 6; i++) {
        const nkw_result expected[6] = {NKW_NOT_FINITE, NKW_NOT_ASCENDING, NKW_NOT_ASCENDING,
                                        NKW_MISMATCHED, NKW_MISMATCHED,    NKW_OUT_OF_RANGE};
        memcpy(c, good, sizeof c);
        c[2].end = i == 0 ? NAN : i == 1 ? 0.5f : 2;
        c[2].start = i == 2 ? 1.5f : 1;
        c[2].joint_count = i == 3 ? 4 : 3;
        c[2].float_count = i == 4 ? 0 : 1;
        c[2].bytes = i == 5 ? 4 : 100;
        assert_int_equal(nkw_chunks_validate(c, 3, &bad), expected[i]);
        assert_int_equal(bad, 2);
    }
    nkw_clip_source source = drawn.source, out = source;
    out.track_count = 99;
    assert_int_equal(nkw_clip_source_part(&source, 1, 0, NULL, &out), NKW_NOT_ASCENDING);
    assert_int_equal(nkw_clip_source_part(&source, NAN, 0, NULL, &out), NKW_NOT_ASCENDING);
    assert_int_equal(out.track_count, 99);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(chunks_have_the_bits_of_the_whole_clip),
        cmocka_unit_test(a_chunk_of_no_length_is_a_pose),
        cmocka_unit_test(a_missing_chunk_is_replaced_by_the_nearest_time),
        cmocka_unit_test(a_chunk_must_be_that_of_the_manifest),
        cmocka_unit_test(each_error_of_a_manifest_is_found),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
