/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/quat.h>
#include <nakawari/track.h>

#include "lane/quat.h"
#include "track_keys.h"

/* In binary64: products of floats are exact, and so is the sign of a sum that does not cancel to rounding. */
static double cosine(nkw_quat a, nkw_quat b)
{
    lane_f64_quat p = {a.x, a.y, a.z, a.w}, q = {b.x, b.y, b.z, b.w};
    return lane_f64_quat_dot(p, q);
}

static void negate(float *v, size_t n)
{
    for (size_t i = 0; i < n; i++)
        v[i] = -v[i];
}

size_t nkwi_track_long_way(const nkw_track *track)
{
    if (!track_is_rotation(track) || !track_is_cubic(track))
        return 0;
    for (size_t k = 1; k < track->count; k++)
        if (track_interpolation_at(track, k - 1) == NKW_INTERPOLATION_CUBICSPLINE &&
            cosine(track_read_quat(track_value_at(track, k - 1)), track_read_quat(track_value_at(track, k))) < 0.0)
            return k;
    return 0;
}

/* Returns the number of keys to negate. Negates them in `values`, unless it is NULL. */
static size_t align(const nkw_track *track, float *values, size_t *first)
{
    const size_t size = track_key_size(track);
    nkw_quat before = track_read_quat(track_value_at(track, 0));
    double sign = 1.0;
    size_t count = 0;
    for (size_t k = 1; k < track->count; k++) {
        const nkw_quat q = track_read_quat(track_value_at(track, k));
        sign = sign * cosine(before, q) < 0.0 ? -1.0 : 1.0;
        before = q;
        if (sign > 0.0)
            continue;
        if (values)
            negate(values + k * size, size);
        *first = count > 0 ? *first : k;
        count++;
    }
    return count;
}

nkw_result nkw_track_align(const nkw_track *track, float *values, size_t *negated, size_t *first)
{
    const nkw_result result = track_check_readable(track);
    size_t count = 0, found = 0;
    if (result == NKW_OK && values && values != track->values)
        memcpy(values, track->values, nkw_track_value_count(track) * sizeof *values);
    if (result == NKW_OK && track_is_rotation(track))
        count = align(track, values, &found);
    if (negated)
        *negated = count;
    if (first)
        *first = found;
    return result;
}
