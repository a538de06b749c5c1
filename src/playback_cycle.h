/* SPDX-License-Identifier: MIT */
/* Floor 4: the cycle of a time, and the time within it. */
#ifndef NAKAWARI_PLAYBACK_CYCLE_H
#define NAKAWARI_PLAYBACK_CYCLE_H

#include "lane/f64.h"

/* The remainder r of n periods, where n is a rounded quotient: one too large or too small. 0 <= result < period. */
static inline double playback_corrected(double n, double r, double period, double *cycle)
{
    if (r < 0.0) {
        n -= 1.0;
        r += period;
    } else if (r >= period) {
        n += 1.0;
        r -= period;
    }
    *cycle = n;
    return r > 0.0 && r < period ? r : 0.0;
}

/* x = cycle period + r, returns r, 0 <= r < period. Exact if cycle has at most 29 bits. */
static inline double playback_remainder(double x, double period, double *cycle)
{
    double n = lane_floor64(x / period);
    return playback_corrected(n, x - n * period, period, cycle);
}

#endif
