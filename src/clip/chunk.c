/* SPDX-License-Identifier: MIT */
/*
 * Chunks of a clip. The keys of an interval are neighbours in their arrays, so a part of a source is views only:
 *
 *     keys        0    1    2    3    4    5         from..to of the chunk
 *     touched          1    2    3    4              the key at or before `from` .. the key at or after `to`
 *                         |---------|
 *
 * t of a segment depends on its two keys only, so samples have the bits of all keys.
 */
#include "lane/strict.h"

#include <nakawari/chunk.h>
#include <nakawari/segment.h>

#include "clip_layout.h"
#include "lane/scalar.h"
#include "track/track_keys.h"

static nkw_track touched(const nkw_track *track, float from, float to)
{
    const nkw_segment a = nkw_segment_find(track->times, track->count, from);
    const nkw_segment b = nkw_segment_find(track->times, track->count, to);
    const size_t first = a.index + (a.t == 1.0f), last = b.index + (b.t > 0.0f);
    nkw_track part = *track;
    part.times = track->times + first;
    part.values = track_key_at(track, first);
    part.key_interpolation = track->key_interpolation ? track->key_interpolation + first : NULL;
    part.count = last > first ? last - first + 1 : 1;
    return part;
}

nkw_result nkw_clip_source_part(const nkw_clip_source *source, float from, float to, nkw_clip_track *tracks,
                                nkw_clip_source *out)
{
    if (!(from <= to))
        return NKW_NOT_ASCENDING;
    for (size_t i = 0; i < source->track_count; i++) {
        tracks[i] = source->tracks[i];
        if (tracks[i].track.count > 0)
            tracks[i].track = touched(&source->tracks[i].track, from, to);
    }
    *out = *source;
    out->tracks = tracks;
    return NKW_OK;
}

nkw_chunk nkw_chunk_from_clip(const nkw_clip *clip, float start, float end)
{
    const uint64_t fingerprint = nkw_clip_fingerprint(clip, 0);
    const nkw_chunk c = {start,        end,          clip->words * 4,
                         clip->joints, clip->floats, {(uint32_t)fingerprint, (uint32_t)(fingerprint >> 32)}};
    return c;
}

static nkw_result check(const nkw_chunk *manifest, size_t k)
{
    const nkw_chunk *c = manifest + k;
    if (!lane_is_finite(c->start) || !lane_is_finite(c->end))
        return NKW_NOT_FINITE;
    if (c->end < c->start || (k > 0 && c->start != manifest[k - 1].end))
        return NKW_NOT_ASCENDING;
    if (c->joint_count != manifest->joint_count || c->float_count != manifest->float_count)
        return NKW_MISMATCHED;
    return (uint64_t)c->joint_count + c->float_count < c->bytes ? NKW_OK : NKW_OUT_OF_RANGE;
}

nkw_result nkw_chunks_validate(const nkw_chunk *manifest, size_t count, size_t *bad)
{
    nkw_result result = count > 0 ? NKW_OK : NKW_EMPTY;
    size_t k = 0;
    while (k < count && (result = check(manifest, k)) == NKW_OK)
        k++;
    if (bad)
        *bad = result == NKW_OK ? 0 : k;
    return result;
}

nkw_result nkw_chunk_open(const nkw_chunk *chunk, const void *block, size_t bytes, const nkw_clip **clip)
{
    nkw_result result = nkw_clip_open(block, bytes, clip);
    if (result != NKW_OK)
        return result;
    const nkw_chunk own = nkw_chunk_from_clip(*clip, chunk->start, chunk->end);
    if (own.bytes != chunk->bytes || own.joint_count != chunk->joint_count || own.float_count != chunk->float_count ||
        own.fingerprint[0] != chunk->fingerprint[0] || own.fingerprint[1] != chunk->fingerprint[1]) {
        *clip = NULL;
        return NKW_MISMATCHED;
    }
    return NKW_OK;
}

/* The last chunk that begins at or before the time; 0 if there is none, or for NaN. */
static size_t chunk_of(const nkw_chunks *chunks, float time)
{
    size_t low = 0, high = chunks->count;
    while (high - low > 1) {
        const size_t middle = low + (high - low) / 2;
        if (chunks->manifest[middle].start <= time)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* The nearest chunk that is there in place of chunk k, and its nearest time; count if there is none. */
static size_t nearest(const nkw_chunks *chunks, size_t k, float *time)
{
    size_t before = k, after = k + 1;
    while (before < chunks->count && !chunks->clips[before])
        before--; /* from 0 to SIZE_MAX */
    while (after < chunks->count && !chunks->clips[after])
        after++;
    if (before >= chunks->count && after >= chunks->count)
        return chunks->count;
    if (before < chunks->count && (after >= chunks->count || !((double)chunks->manifest[after].start - (double)*time <
                                                               (double)*time - (double)chunks->manifest[before].end))) {
        *time = chunks->manifest[before].end;
        return before;
    }
    *time = chunks->manifest[after].start;
    return after;
}

nkw_result nkw_chunks_sample(const nkw_chunks *chunks, float time, nkw_pose_span pose, float *floats, size_t *used)
{
    const size_t wanted = chunk_of(chunks, time);
    size_t k = wanted;
    if (k < chunks->count && !chunks->clips[k])
        k = nearest(chunks, k, &time);
    if (used)
        *used = k;
    if (k >= chunks->count)
        return NKW_EMPTY;
    const nkw_clip *clip = chunks->clips[k];
    if (clip->joints != chunks->manifest->joint_count || clip->floats != chunks->manifest->float_count)
        return NKW_MISMATCHED;
    const nkw_result result = nkw_clip_sample(clip, time, NULL, pose, floats);
    return result == NKW_OK && k != wanted ? NKW_EMPTY : result;
}
