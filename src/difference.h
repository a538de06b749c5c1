/* SPDX-License-Identifier: MIT */
/* How far two samples are apart, and the moments at which a track is compared. */
#ifndef NAKAWARI_DIFFERENCE_H
#define NAKAWARI_DIFFERENCE_H

#include <nakawari/scalar.h>
#include <nakawari/track.h>

#define DIFFERENCE_QUARTERS 4

/* The larger of two, NaN if either is. */
static inline float difference_worse(float a, float b)
{
    return b > a || b != b ? b : a;
}

static inline float difference_farthest(const float *a, const float *b, size_t n)
{
    float far = 0.0f;
    for (size_t i = 0; i < n; i++)
        far = difference_worse(far, nkw_abs(a[i] - b[i]));
    return far;
}

/* The time of key k, and of the quarters from there to the next key. */
static inline float difference_moment(const nkw_track *track, size_t k, int quarter)
{
    float from = track->times[k], to = track->times[k + 1 < track->count ? k + 1 : k];
    return nkw_lerp(from, to, 0.25f * (float)quarter);
}

#endif
