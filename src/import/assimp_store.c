/* SPDX-License-Identifier: MIT */
/* Keys that were made of curves, as a track of the document. */
#include <string.h>

#include "assimp.h"
#include "fbx_bake.h"

int nkwi_assimp_store(nkwi_assimp *a, nkw_document_animation *out, nkw_clip_target target, int32_t joint, size_t width,
                      const nkwi_fbx_baked *baked)
{
    const nkw_document *d = &a->document->all;
    const size_t values = baked->count * baked->width;
    float *times = (float *)nkwi_assimp_take(a, "animations", baked->count, sizeof *times);
    float *numbers = (float *)nkwi_assimp_take(a, "animations", values, sizeof *numbers);
    if (!times || !numbers)
        return 0;
    memcpy(times, baked->times, baked->count * sizeof *times);
    memcpy(numbers, baked->values, values * sizeof *numbers);
    const nkw_track track = {times,
                             numbers,
                             baked->count,
                             width,
                             target == NKW_CLIP_ROTATION ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS,
                             baked->interpolation,
                             NULL};
    const uint32_t at = target == NKW_CLIP_FLOATS ? d->nodes[joint].float_first : (uint32_t)joint;
    const nkw_clip_track one = {target, at, track};
    const size_t bytes = (baked->count + values) * sizeof(float);
    const nkw_document_channel channel = {out->track_count, joint, 0, 0, bytes, baked->added, baked->difference};
    /* Both lists are memory of the document, which the caller has taken. */
    ((nkw_clip_track *)out->tracks)[out->track_count] = one;
    ((nkw_document_channel *)out->channels)[out->track_count++] = channel;
    return 1;
}
