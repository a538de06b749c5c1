/* SPDX-License-Identifier: MIT */
/* Clips and their poses, for the tests of clips. */
#ifndef NAKAWARI_TESTS_CLIPS_H
#define NAKAWARI_TESTS_CLIPS_H

#include <stdlib.h>

#include "expect.h"
#include "views.h"

/* Builds into a block, without the size. */
static inline nkw_result clip_build_into(const nkw_clip_source *source, void *block, size_t bytes, size_t *bad)
{
    const size_t count = source->track_count ? NKW_CLIP_BUILD_WORK(source->track_count) : 1;
    const nkw_work work = {malloc(count), count};
    size_t built;
    assert_non_null(work.data);
    const nkw_result result = nkw_clip_build(source, bytes_span(block, bytes), &built, bad, work);
    free(work.data);
    return result;
}

/* The bytes of the clip; 0 if it is refused. */
static inline size_t clip_size_of(const nkw_clip_source *source)
{
    const size_t count = source->track_count ? NKW_CLIP_BUILD_WORK(source->track_count) : 1;
    const nkw_work work = {malloc(count), count};
    size_t bytes;
    assert_non_null(work.data);
    assert_int_not_equal(nkw_clip_build(source, bytes_span(NULL, 0), &bytes, NULL, work), NKW_OK);
    free(work.data);
    return bytes;
}

/* The tracks with a CUBICSPLINE rotation that takes the longer arc. */
static inline size_t clip_long_ways(const nkw_clip_source *source)
{
    size_t count = 0, key;
    for (size_t i = 0; i < source->track_count; i++)
        count += nkw_track_validate(&source->tracks[i].track, &key) == NKW_OK && key > 0;
    return count;
}

/* A clip of the source, in memory of exactly its size; to be freed. */
static inline nkw_clip *clip_build(const nkw_clip_source *source, size_t *bytes)
{
    size_t bad = 99;
    *bytes = clip_size_of(source);
    assert_true(*bytes > 0);
    void *block = malloc(*bytes);
    assert_non_null(block);
    assert_int_equal(clip_build_into(source, block, *bytes, &bad), NKW_OK);
    assert_int_equal(bad, clip_long_ways(source));
    const nkw_clip *clip;
    assert_int_equal(nkw_clip_open(block, *bytes, &clip), NKW_OK);
    assert_ptr_equal(clip, block);
    assert_int_equal(nkw_clip_describe(clip).bytes, *bytes);
    return (nkw_clip *)block;
}

/* All joints, bit for bit; not the padding. */
static inline void expect_same_pose(const float *got, const float *want, size_t joints)
{
    for (size_t c = 0; c < 10; c++)
        expect_floats_bits(got + c * NKW_POSE_STRIDE(joints), want + c * NKW_POSE_STRIDE(joints), joints);
}

#endif
