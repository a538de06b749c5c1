/* SPDX-License-Identifier: MIT */
#include "size.h"

#include <stdint.h>
#include <stdlib.h>

static size_t measure(nkw_clip_source source, nkw_clip_format format)
{
    size_t count = NKW_CLIP_WORK(source.track_count), bytes;
    uint32_t *work = calloc(count ? count : 1, sizeof *work);
    source.format = format;
    if (!work || nkw_clip_measure(&source, &bytes, NULL, work, count) != NKW_OK)
        bytes = SIZE_MAX;
    free(work);
    return bytes;
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
    nkw_clip_memory memory = {NULL, 0, NULL, 0};
    nkw_clip_reduced reduced = {SIZE_MAX, 0, 0, 0.0f, 0.0f, 0.0f};
    memory.work_count = NKW_CLIP_REDUCE_WORK(source.track_count, source.joint_count, source.float_count);
    memory.work = calloc(memory.work_count, sizeof *memory.work);
    if (memory.work && nkw_clip_reduce_measure(&source, &memory.bytes, NULL, memory.work, memory.work_count) == NKW_OK)
        memory.block = malloc(memory.bytes);
    if (memory.block && nkw_clip_reduce(&source, &reduction, &memory, &reduced, NULL) != NKW_OK) {
        free(memory.block);
        memory.block = NULL;
    }
    free(memory.work);
    *bytes = memory.block ? reduced.bytes : SIZE_MAX;
    return memory.block;
}

size_t size_of_reduced(const nkw_document *d, size_t animation, const extent *e, float tolerance)
{
    size_t bytes;
    free(reduced_clip(d, animation, e, tolerance, &bytes));
    return bytes;
}
