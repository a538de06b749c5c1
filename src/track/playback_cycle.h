/* SPDX-License-Identifier: MIT */
/* The cycle of a time, and the time within it. */
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

/* a b = p + e, by Veltkamp's and Dekker's products, for products far from the limits. */
static inline double playback_product_error(double a, double b, double p)
{
    double ca = 0x1.0000002p27 * a, cb = 0x1.0000002p27 * b;
    double ah = ca - (ca - a), bh = cb - (cb - b), al = a - ah, bl = b - bh;
    return ((ah * bh - p) + (ah * bl + al * bh)) + al * bl;
}

/* x = cycle period + r, returns r, 0 <= r < period, with one rounding for |cycle| < 2^51. */
static inline double playback_remainder(double x, double period, double *cycle)
{
    double n = lane_floor64(x / period), p = n * period;
    return playback_corrected(n, (x - p) - playback_product_error(n, period, p), period, cycle);
}

#endif
