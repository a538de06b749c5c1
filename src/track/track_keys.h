/* SPDX-License-Identifier: MIT */
/* The keys of a track: their size, their place in the array of values. */
#ifndef NAKAWARI_TRACK_KEYS_H
#define NAKAWARI_TRACK_KEYS_H

#include <nakawari/track.h>

static inline int track_is_rotation(const nkw_track *track)
{
    return track->kind == NKW_TRACK_ROTATION || track->kind == NKW_TRACK_ROTATION_NORMALIZED;
}

static inline int track_is_cubic(const nkw_track *track)
{
    return track->interpolation == NKW_INTERPOLATION_CUBICSPLINE;
}

/* The number of floats of one key. */
static inline size_t track_key_size(const nkw_track *track)
{
    return track->width * (track_is_cubic(track) ? 3 : 1);
}

/* Key k: in-tangent, value and out-tangent of CUBICSPLINE, `width` floats each; otherwise only the value. */
static inline const float *track_key_at(const nkw_track *track, size_t k)
{
    return track->values + k * track_key_size(track);
}

static inline const float *track_value_at(const nkw_track *track, size_t k)
{
    return track_key_at(track, k) + (track_is_cubic(track) ? track->width : 0);
}

/* Whether the track has keys, and a rotation has width 4. nkw_track_validate rejects others. */
static inline int track_is_readable(const nkw_track *track)
{
    return track->count > 0 && track->width > 0 && (!track_is_rotation(track) || track->width == 4);
}

static inline nkw_result track_check_readable(const nkw_track *track)
{
    if (track->count == 0 || track->width == 0)
        return NKW_EMPTY;
    return track_is_readable(track) ? NKW_OK : NKW_BAD_WIDTH;
}

/* The interpolation of the segment that begins at key k. */
static inline nkw_interpolation track_interpolation_at(const nkw_track *track, size_t k)
{
    return track->key_interpolation ? (nkw_interpolation)track->key_interpolation[k] : track->interpolation;
}

/*
 * The first key whose CUBICSPLINE rotation has a negative dot product with that of the key before, so that the curve
 * between them takes the longer arc; 0 if there is none. The track must be readable.
 */
size_t nkwi_track_long_way(const nkw_track *track);

static inline nkw_quat track_read_quat(const float *v)
{
    nkw_quat q = {v[0], v[1], v[2], v[3]};
    return q;
}

static inline void track_write_quat(nkw_quat q, float *out)
{
    out[0] = q.x;
    out[1] = q.y;
    out[2] = q.z;
    out[3] = q.w;
}

#endif
