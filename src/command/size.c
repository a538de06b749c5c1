/* SPDX-License-Identifier: MIT */
#include "size.h"

#include <stdint.h>
#include <stdlib.h>

static size_t measure(nkw_clip_source source, nkw_clip_format format)
{
    const size_t work_bytes = NKW_CLIP_BUILD_WORK(source.track_count);
    const nkw_work work = {malloc(work_bytes ? work_bytes : 1), work_bytes};
    const nkw_bytes_span none = {NULL, 0};
    size_t bytes = 0;
    source.format = format;
    if (work.data)
        (void)nkw_clip_build(&source, none, &bytes, NULL, work);
    free(work.data);
    return bytes ? bytes : SIZE_MAX;
}

clip_size size_of_clip(const nkw_document *d, size_t animation)
{
    nkw_clip_source source = nkw_document_clip_source(d, animation, NKW_CLIP_FLOAT32);
    clip_size size = {measure(source, NKW_CLIP_FLOAT32), measure(source, NKW_CLIP_UNORM16)};
    return size;
}

/* Lanes are stored in groups of 16 at most, so the share in 16 equal channels has no unused lanes. */
enum { COPIES = 16 };

static size_t share(const nkw_clip_source *source, nkw_clip_format format)
{
    nkw_clip_source none = *source;
    none.track_count = 0;
    size_t with = measure(*source, format), without = measure(none, format);
    if (with == SIZE_MAX || without == SIZE_MAX)
        return SIZE_MAX;
    return with > without ? (with - without + COPIES - 1) / COPIES : 0;
}

clip_size size_of_channel(const nkw_document *d, size_t animation, size_t track)
{
    nkw_clip_track copies[COPIES];
    nkw_clip_source source = {copies, COPIES, COPIES, 0, {NULL, COPIES}, NULL, NKW_CLIP_FLOAT32, NULL};
    for (uint32_t i = 0; i < COPIES; i++) {
        copies[i] = d->animations[animation].tracks[track];
        copies[i].index = i;
    }
    const size_t width = copies[0].track.width;
    if (copies[0].target == NKW_CLIP_FLOATS && width < UINT32_MAX / COPIES) {
        source.float_count = COPIES * width;
        for (uint32_t i = 0; i < COPIES; i++)
            copies[i].index = i * (uint32_t)width;
    }
    clip_size size = {share(&source, NKW_CLIP_FLOAT32), share(&source, NKW_CLIP_UNORM16)};
    return size;
}

void *reduced_clip(const nkw_document *d, size_t animation, const extent *e, float tolerance, size_t *bytes)
{
    nkw_clip_source source = nkw_document_clip_source(d, animation, NKW_CLIP_FLOAT32);
    const nkw_clip_reduction reduction = extent_reduction(e, d, tolerance);
    const size_t work_bytes = NKW_CLIP_REDUCE_WORK(source.track_count, source.joint_count, source.float_count);
    const nkw_work work = {malloc(work_bytes), work_bytes};
    nkw_bytes_span block = {NULL, 0};
    nkw_clip_reduced reduced = {0, 0, 0, 0.0f, 0.0f, 0.0f};
    if (work.data)
        (void)nkw_clip_reduce(&source, &reduction, block, &reduced, NULL, work);
    block.bytes = reduced.bytes;
    block.data = block.bytes ? malloc(block.bytes) : NULL;
    if (block.data && nkw_clip_reduce(&source, &reduction, block, &reduced, NULL, work) != NKW_OK) {
        free(block.data);
        block.data = NULL;
    }
    free(work.data);
    *bytes = block.data ? reduced.bytes : SIZE_MAX;
    return block.data;
}

size_t size_of_reduced(const nkw_document *d, size_t animation, const extent *e, float tolerance)
{
    size_t bytes;
    free(reduced_clip(d, animation, e, tolerance, &bytes));
    return bytes;
}
