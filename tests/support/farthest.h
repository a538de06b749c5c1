/* SPDX-License-Identifier: MIT */
/* How far apart two matrices move a point of a sphere around their origin. */
#ifndef NAKAWARI_TESTS_FARTHEST_H
#define NAKAWARI_TESTS_FARTHEST_H

#include <math.h>

#include <nakawari/types.h>

/* (a - b) p, with p = reach n: the difference of the points; returns its length. */
static inline double farthest_move(const nkw_mat4 *a, const nkw_mat4 *b, double reach, const double n[3], double out[3])
{
    for (int r = 0; r < 3; r++) {
        out[r] = (double)a->m[12 + r] - (double)b->m[12 + r];
        for (int c = 0; c < 3; c++)
            out[r] += reach * n[c] * ((double)a->m[4 * c + r] - (double)b->m[4 * c + r]);
    }
    return sqrt(out[0] * out[0] + out[1] * out[1] + out[2] * out[2]);
}

/*
 * The largest over all |n| <= 1, from below: from 26 directions on, n is replaced by the direction in which the length
 * grows most, (a - b)^T of the difference, 40 times.
 */
static inline double farthest_distance(const nkw_mat4 *a, const nkw_mat4 *b, double reach)
{
    double largest = 0.0, d[3];
    for (int start = 0; start < 27; start++) {
        double n[3] = {(double)(start % 3 - 1), (double)(start / 3 % 3 - 1), (double)(start / 9 - 1)};
        for (int step = 0; step < 40; step++) {
            double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]), next[3];
            for (int i = 0; i < 3 && length > 0.0; i++)
                n[i] /= length;
            double found = farthest_move(a, b, reach, n, d);
            largest = found > largest ? found : largest;
            for (int c = 0; c < 3; c++) {
                next[c] = 0.0;
                for (int r = 0; r < 3; r++)
                    next[c] += ((double)a->m[4 * c + r] - (double)b->m[4 * c + r]) * d[r];
            }
            for (int i = 0; i < 3; i++)
                n[i] = next[i];
        }
    }
    return largest;
}

#endif
