/* SPDX-License-Identifier: MIT */
/* Floor 4: the cycle of a time, and the time within it. */
#ifndef NAKAWARI_PLAYBACK_CYCLE_H
#define NAKAWARI_PLAYBACK_CYCLE_H

#include "lane/f64.h"

/* x = cycle period + r, returns r, 0 <= r < period. Exact if cycle has at most 29 bits. */
static inline double playback_remainder(double x, double period, double *cycle)
{
    double n = lane_floor64(x / period);
    double r = x - n * period;
    /* x / period may be rounded up or down to a whole number. */
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

#endif
