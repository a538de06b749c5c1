/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/edit.h>

nkw_result nkw_track_convert_axes(const nkw_track *track, nkw_axes_map map, nkw_axes_kind kind, float *values)
{
    size_t width = NKW_AXES_WIDTH(kind), count = nkw_track_value_count(track);
    if ((int)kind < 0 || kind >= NKW_AXES_KIND_COUNT)
        return NKW_BAD_METHOD;
    if (track->width != width)
        return NKW_BAD_WIDTH;
    if (!nkw_axes_map_is_valid(map))
        return NKW_OUT_OF_RANGE;
    if (count == SIZE_MAX)
        return NKW_TOO_SMALL;
    nkw_axes_convert_values(map, track->values, count / width, kind, values);
    return NKW_OK;
}
