/* SPDX-License-Identifier: MIT */
#ifndef NAKAWARI_FINITE_H
#define NAKAWARI_FINITE_H

#include "lane/scalar.h"

/* Whether n floats are finite. */
static inline int are_finite(const float *x, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (!lane_is_finite(x[i]))
            return 0;
    return 1;
}

#endif
