/* SPDX-License-Identifier: MIT */
#include "distance.h"

#include <math.h>
#include <string.h>

double matrix_distance(const nkw_mat4 *a, const nkw_mat4 *b, float reach)
{
    double worst = 0.0;
    if (memcmp(a, b, sizeof *a) == 0)
        return worst;
    for (int axis = -1; axis < 3; axis++) {
        double squares = 0.0;
        for (int r = 0; r < 3; r++) {
            double d = (double)a->m[12 + r] - (double)b->m[12 + r];
            if (axis >= 0)
                d += (double)reach * ((double)a->m[4 * axis + r] - (double)b->m[4 * axis + r]);
            squares += d * d;
        }
        double distance = isnan(squares) ? (double)INFINITY : sqrt(squares);
        worst = distance > worst ? distance : worst;
    }
    return worst;
}
