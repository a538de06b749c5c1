/* SPDX-License-Identifier: MIT */
/* Chunks of drawn tracks, in an order of any sort, some missing; manifests of any words. */
#include "fuzz.h"

#include <string.h>

#include "../support/random_clip.h"
#include "../support/views.h"

enum { CHUNKS = 4, JOINTS = 8 };

static const nkw_clip *build(fuzz *f, const nkw_clip_source *source)
{
    size_t bytes, bad;
    const nkw_work work = fuzz_work(f, NKW_CLIP_BUILD_WORK(source->track_count));
    const nkw_result asked = nkw_clip_build(source, bytes_span(NULL, 0), &bytes, &bad, work);
    if (source->joint_count + source->float_count == 0) {
        FUZZ_CHECK(asked == NKW_EMPTY);
        return NULL;
    }
    void *block = fuzz_block(f, bytes);
    FUZZ_CHECK(nkw_clip_build(source, bytes_span(block, bytes), &bytes, &bad, work) == NKW_OK);
    return block;
}

static void sample(fuzz *f, const nkw_chunks *chunks, size_t joints, size_t float_count)
{
    float *pose = fuzz_room(f, NKW_POSE_FLOATS(joints)), *floats = fuzz_room(f, float_count);
    for (int i = 0; i < 4; i++) {
        size_t used = 99;
        const nkw_result result = nkw_chunks_sample(chunks, fuzz_float(f), pose_span(pose, joints), floats, &used);
        FUZZ_CHECK(used <= chunks->count);
        FUZZ_CHECK(used < chunks->count || result == NKW_EMPTY);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz f = fuzz_begin(data, size);
    random_source r = fuzz_source(&f);
    random_clip *c = fuzz_block(&f, sizeof *c);
    const size_t joints = fuzz_upto(&f, JOINTS), count = fuzz_upto(&f, CHUNKS);
    random_clip_draw(&r, joints, fuzz_byte(&f) % 5, c);
    nkw_chunk *manifest = fuzz_block(&f, count * sizeof *manifest);
    const nkw_clip *clips[CHUNKS];
    for (size_t k = 0; k < count; k++) {
        nkw_clip_source source;
        nkw_clip_track *tracks = fuzz_block(&f, c->source.track_count * sizeof *tracks);
        const float from = fuzz_byte(&f) % 2 ? fuzz_float(&f) : (float)k,
                    to = fuzz_byte(&f) % 2 ? from : fuzz_float(&f);
        clips[k] = NULL;
        if (nkw_clip_source_part(&c->source, from, to, tracks, &source) == NKW_OK)
            clips[k] = build(&f, &source);
        if (!clips[k]) {
            memset(&manifest[k], fuzz_byte(&f), sizeof manifest[k]);
            continue;
        }
        manifest[k] = nkw_chunk_from_clip(clips[k], from, to);
        const nkw_clip *opened;
        FUZZ_CHECK(nkw_chunk_open(&manifest[k], clips[k], manifest[k].bytes, &opened) == NKW_OK && opened == clips[k]);
        if (fuzz_byte(&f) % 4 == 0)
            clips[k] = NULL;
    }
    const nkw_chunks chunks = {manifest, clips, count};
    size_t bad = 99;
    const nkw_result result = nkw_chunks_validate(manifest, count, &bad);
    FUZZ_CHECK(result == NKW_OK ? bad == 0 : bad < count || count == 0);
    sample(&f, &chunks, joints, c->source.float_count);
    for (size_t i = fuzz_byte(&f) % 8; i > 0 && count > 0; i--) {
        const size_t k = fuzz_upto(&f, count - 1);
        memcpy((unsigned char *)&manifest[k] + 4 * (fuzz_byte(&f) % 7), &(uint32_t){fuzz_bits(&f)}, 4);
    }
    nkw_chunks_validate(manifest, count, NULL);
    sample(&f, &chunks, joints, c->source.float_count);
    return fuzz_end(&f);
}
