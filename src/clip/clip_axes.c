/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/clip.h>

nkw_result nkw_clip_track_convert_axes(const nkw_clip_track *track, nkw_axes_map map, float *values)
{
    size_t count = nkw_track_value_count(&track->track);
    switch (track->target) {
    case NKW_CLIP_TRANSLATION:
        return nkw_track_convert_axes(&track->track, NKW_AXES_VEC3, map, values);
    case NKW_CLIP_ROTATION:
        return nkw_track_convert_axes(&track->track, NKW_AXES_QUAT, map, values);
    case NKW_CLIP_SCALE:
        return nkw_track_convert_axes(&track->track, NKW_AXES_SCALE, map, values);
    case NKW_CLIP_FLOATS:
        break;
    default:
        return NKW_BAD_METHOD;
    }
    if (count == SIZE_MAX)
        return NKW_TOO_SMALL;
    if (count && values != track->track.values)
        memcpy(values, track->track.values, count * sizeof *values);
    return NKW_OK;
}
