/* SPDX-License-Identifier: MIT */
/* Tracks of four keys, for the tests of tracks. */
#ifndef NAKAWARI_TESTS_FOUR_KEYS_H
#define NAKAWARI_TESTS_FOUR_KEYS_H

#include <nakawari/nakawari.h>

static const float times4[4] = {0.5f, 1.0f, 2.0f, 2.5f};

static inline nkw_track floats(const float *values, size_t width, nkw_interpolation interpolation)
{
    nkw_track t = {times4, values, 4, width, NKW_TRACK_FLOATS, interpolation, NULL};
    return t;
}

static inline nkw_track rotations(const float *values, nkw_interpolation interpolation)
{
    nkw_track t = {times4, values, 4, 4, NKW_TRACK_ROTATION, interpolation, NULL};
    return t;
}

#endif
