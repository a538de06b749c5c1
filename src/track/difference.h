/* SPDX-License-Identifier: MIT */
/* The difference of two samples, and the times at which tracks are compared. */
#ifndef NAKAWARI_DIFFERENCE_H
#define NAKAWARI_DIFFERENCE_H

#include <nakawari/scalar.h>
#include <nakawari/track.h>

#include "sizes.h"

/* The larger of a and b; NaN if either is NaN. */
static inline float difference_worse(float a, float b)
{
    return b > a || b != b ? b : a;
}

/* max |a[i] - b[i]|. */
static inline float difference_largest(const float *a, const float *b, size_t n)
{
    float largest = 0.0f;
    for (size_t i = 0; i < n; i++)
        largest = difference_worse(largest, nkw_abs(a[i] - b[i]));
    return largest;
}

/* The time at `quarter` quarters of the segment from key k to key k + 1; of the last key, its time. */
static inline float difference_time(const nkw_track *track, size_t k, int quarter)
{
    float from = track->times[k], to = track->times[k + 1 < track->count ? k + 1 : k];
    return nkw_lerp(from, to, 0.25f * (float)quarter);
}

#endif
