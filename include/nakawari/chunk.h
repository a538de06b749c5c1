/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Chunks of a clip that arrive later: clips of the keys that touch an interval of time, sampled while some are missing.
 *
 * A list of chunks, the manifest, comes first: 28 bytes for each, plain 32-bit words. Each chunk is an ordinary clip
 * with all joints and floats, so nkw_clip_open, nkw_clip_convert and nkw_clip_reduce take it as any other.
 *
 *     nkw_clip_source_part(&source, from, to, tracks, &part);      the keys of an interval
 *     nkw_clip_build(&part, block, &bytes, &bad, work);            its clip
 *     manifest[k] = nkw_chunk_from_clip(clip, from, to);           its line of the manifest
 *
 *     nkw_chunks_validate(manifest, count, &bad);                  where the manifest arrives
 *     nkw_chunk_open(&manifest[k], block, bytes, &clips[k]);       where a chunk arrives
 *     nkw_chunks_sample(&chunks, time, pose, floats, &used);       at any time
 */
#ifndef NAKAWARI_CHUNK_H
#define NAKAWARI_CHUNK_H

#include <stdint.h>

#include "clip.h"
#include "fingerprint.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A line of the manifest. A manifest of the other byte order is converted word by word. */
typedef struct nkw_chunk {
    float start; /**< seconds */
    float end; /**< that of the last chunk included, otherwise the start of the next one */
    uint32_t bytes; /**< of its block */
    uint32_t joint_count, float_count; /**< the same of all chunks */
    uint32_t fingerprint[2]; /**< nkw_clip_fingerprint(clip, 0), low word first */
} nkw_chunk;
NKW_SIZE(nkw_chunk, 28, 28);

/** A manifest and the chunks that are there. */
typedef struct nkw_chunks {
    const nkw_chunk *manifest; /**< count lines */
    const nkw_clip *const *clips; /**< count clips of nkw_chunk_open; NULL: not yet there */
    size_t count;
} nkw_chunks;
NKW_SIZE(nkw_chunks, 24, 12);

/**
 * The source of a chunk: of each track the keys that its samples from `from` to `to` depend on, in the arrays of the
 * source. A FLOAT32 clip of them has the bits of the clip of the source at these times. Joints, floats, rest values,
 * format and names are those of the source; set names to NULL in all chunks but one.
 *
 * from, to  seconds. With from = to it is one pose, all constant: a first chunk of this kind is small
 * tracks    receives source->track_count tracks, which refer to the keys of the source
 * out       receives the source of the chunk, which refers to `tracks`
 * Returns   NKW_OK; NKW_NOT_ASCENDING for a NaN or to < from: nothing is then written
 */
NKW_API nkw_result nkw_clip_source_part(const nkw_clip_source *source, float from, float to, nkw_clip_track *tracks,
                                        nkw_clip_source *out);

/**
 * The line of the manifest of a chunk.
 *
 * start, end  the interval of nkw_clip_source_part, in seconds
 *
 * Stack  at most 2 KiB.
 */
NKW_API nkw_chunk nkw_chunk_from_clip(const nkw_clip *clip, float start, float end);

/**
 * Checks a manifest.
 *
 * bad      receives the index of the first line with an error; may be NULL
 * Returns  NKW_OK; NKW_EMPTY for no chunks; NKW_NOT_FINITE; NKW_NOT_ASCENDING for a chunk that ends before its start or
 *          does not begin at the end of the one before; NKW_MISMATCHED for other numbers of joints or floats than those
 *          of the first chunk; NKW_OUT_OF_RANGE for more joints and floats than a clip of these bytes may have
 */
NKW_API nkw_result nkw_chunks_validate(const nkw_chunk *manifest, size_t count, size_t *bad);

/**
 * Checks a chunk that has arrived: nkw_clip_open, and that it is the one of the manifest.
 *
 * clip     receives the block as a clip; NULL after an error
 * Returns  as nkw_clip_open; NKW_MISMATCHED for another clip than that of the manifest
 *
 * Stack  at most 2 KiB.
 */
NKW_API nkw_result nkw_chunk_open(const nkw_chunk *chunk, const void *block, size_t bytes, const nkw_clip **clip);

/**
 * Samples the chunk of a time: the last one that begins at or before it; before the start the first one. If it is not
 * there, the pose is that of the nearest time that is there: the end of the chunk before, or the start of the chunk
 * after, the former where both are equally far.
 *
 * pose     as that of nkw_clip_sample; data may be NULL
 * floats   float_count floats of the manifest; may be NULL
 * used     receives the index of the chunk that was sampled, or count if there is none; may be NULL
 * Returns  NKW_OK; NKW_EMPTY if the chunk of the time is not there: the pose is then that of chunk *used, and nothing is
 *          written if there is none; NKW_MISMATCHED for another number of joints, or a clip with other numbers of joints
 *          or floats than the first line of the manifest: nothing is written
 *
 * Stack  at most 15 KiB.
 */
NKW_API nkw_result nkw_chunks_sample(const nkw_chunks *chunks, float time, nkw_pose_span pose, float *floats,
                                     size_t *used);

#ifdef __cplusplus
}
#endif

#endif
