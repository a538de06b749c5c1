/* SPDX-License-Identifier: MIT */
/* Clips and their poses, for the tests of clips. */
#ifndef NAKAWARI_TESTS_CLIPS_H
#define NAKAWARI_TESTS_CLIPS_H

#include <stdlib.h>

#include "expect.h"

/* A clip of the source, in memory of exactly its size; to be freed. */
static inline nkw_clip *clip_build(const nkw_clip_source *source, uint32_t *work, size_t *bytes)
{
    size_t bad = 99;
    assert_int_equal(nkw_clip_measure(source, bytes, &bad, work, NKW_CLIP_WORK(source->track_count)), NKW_OK);
    assert_int_equal(bad, 0);
    void *block = malloc(*bytes);
    assert_non_null(block);
    assert_int_equal(nkw_clip_build(source, block, *bytes, &bad, work, NKW_CLIP_WORK(source->track_count)), NKW_OK);
    const nkw_clip *clip;
    assert_int_equal(nkw_clip_open(block, *bytes, &clip), NKW_OK);
    assert_ptr_equal(clip, block);
    assert_int_equal(nkw_clip_bytes(clip), *bytes);
    return (nkw_clip *)block;
}

/* All joints, bit for bit; not the padding. */
static inline void expect_same_pose(const float *got, const float *want, size_t joints)
{
    for (size_t c = 0; c < 10; c++)
        expect_floats_bits(got + c * NKW_POSE_STRIDE(joints), want + c * NKW_POSE_STRIDE(joints), joints);
}

#endif
