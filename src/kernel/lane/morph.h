/* SPDX-License-Identifier: MIT */
/* The formula of morph.h. */
#ifndef NAKAWARI_LANE_MORPH_H
#define NAKAWARI_LANE_MORPH_H

#include "strict.h"

static inline float lane_morph(float v, float weight, float delta)
{
    return v + weight * delta;
}

#endif
