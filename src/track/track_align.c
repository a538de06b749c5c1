/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/quat.h>
#include <nakawari/track.h>

#include "lane/quat.h"
#include "track_keys.h"

/* Where the value of key k begins, and the floats of a key. */
typedef struct rotation_keys {
    const float *first;
    size_t stride;
} rotation_keys;

static rotation_keys keys_of(const nkw_track *track, const float *values)
{
    rotation_keys k = {values + (track_is_cubic(track) ? 4 : 0), track_key_size(track)};
    return k;
}

/* In binary64: products of floats are exact, and so is the sign of a sum that does not cancel to rounding. */
static int are_opposed(const float *a, const float *b)
{
    lane_f64_quat p = {a[0], a[1], a[2], a[3]}, q = {b[0], b[1], b[2], b[3]};
    return lane_f64_quat_dot(p, q) < 0.0;
}

static int is_cubic_at(const nkw_track *track, size_t k)
{
    return track_is_cubic(track) && track_interpolation_at(track, k) == NKW_INTERPOLATION_CUBICSPLINE;
}

size_t nkw_track_long_arc(const nkw_track *track, size_t first)
{
    if (track->count == 0 || !track_is_rotation(track) || track->width != 4)
        return track->count;
    rotation_keys keys = keys_of(track, track->values);
    for (size_t k = first; k < track->count && k + 1 < track->count; k++) {
        const float *value = keys.first + k * keys.stride;
        if (is_cubic_at(track, k) && are_opposed(value, value + keys.stride))
            return k;
    }
    return track->count;
}

static void negate(float *v, size_t n)
{
    for (size_t i = 0; i < n; i++)
        v[i] = -v[i];
}

nkw_result nkw_track_align(const nkw_track *track, float *values, size_t *negated)
{
    size_t count = 0;
    if (negated)
        *negated = 0;
    if (track->count == 0 || track->width == 0)
        return NKW_EMPTY;
    if (track_is_rotation(track) && track->width != 4)
        return NKW_BAD_WIDTH;
    if (values != track->values)
        memcpy(values, track->values, nkw_track_value_count(track) * sizeof *values);
    rotation_keys keys = keys_of(track, values);
    for (size_t k = 1; track_is_rotation(track) && k < track->count; k++) {
        const float *value = keys.first + k * keys.stride;
        if (are_opposed(value - keys.stride, value)) {
            negate(values + k * keys.stride, keys.stride);
            count++;
        }
    }
    if (negated)
        *negated = count;
    return NKW_OK;
}
