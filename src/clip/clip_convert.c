/* SPDX-License-Identifier: MIT */
/*
 * A block in the other byte order. Its words are converted one by one; then the parts that are not words (clip_parts.h).
 *
 * Invariant: a word that is read as an offset or a count is in the order of this machine. The header, groups, timelines
 * and offsets are whole words, right after the first loop; parts are found through them.
 *
 *     memory of the other machine     11 22 33 44      a word                   two 16-bit numbers       four bytes
 *     after the first loop            44 33 22 11      right                    their order is wrong     reversed
 *     then                                             -                        22 11 44 33: halves      11 22 33 44
 *
 * The sizes of these parts are those of the block, which is not checked before all are converted. So each part is
 * converted only where it is inside the block, and nkw_clip_open then refuses the block if one was not.
 */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/clip.h>

#include "clip_layout.h"
#include "clip_parts.h"

static void convert_part(void *user, clip_part part, uint64_t at, uint64_t count)
{
    uint32_t *w = (uint32_t *)user + at;
    for (uint64_t i = 0; i < count; i++)
        w[i] = part == PART_HALVES ? clip_swapped_halves(w[i]) : clip_swapped_bytes(w[i]);
}

nkw_result nkw_clip_convert(const void *block, size_t bytes, void *out, const nkw_clip **clip)
{
    uint32_t *words = (uint32_t *)out;
    const size_t count = bytes / 4;
    *clip = NULL;
    if (bytes < sizeof(nkw_clip))
        return NKW_TOO_SMALL;
    if ((uintptr_t)out % sizeof(float) != 0)
        return NKW_NOT_A_CLIP;
    memmove(out, block, bytes);
    if (words[0] == clip_swapped_bytes(CLIP_MAGIC)) {
        for (size_t i = 0; i < count; i++)
            words[i] = clip_swapped_bytes(words[i]);
        if (words[1] == CLIP_VERSION)
            nkwi_clip_parts(words, count, convert_part, words);
    }
    return nkw_clip_open(out, bytes, clip);
}
