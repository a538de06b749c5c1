/* SPDX-License-Identifier: MIT */
/* A component of a moving vector: its value and velocity are contiguous floats. */
#ifndef NAKAWARI_MOTION_COMPONENT_H
#define NAKAWARI_MOTION_COMPONENT_H

#include "lane/strict.h"

#include <nakawari/spring.h>

static inline nkw_state motion_component(const nkw_vec3_state *m, size_t k)
{
    const float *c = (const float *)(const void *)m + k;
    nkw_state r = {c[0], c[3]};
    return r;
}

#endif
