/* SPDX-License-Identifier: MIT */
#include "data.h"
#include "hash.h"
#include "random.h"
#include "views.h"

enum { SAMPLES = 9 };

uint64_t data_blendspace(void)
{
    random_source r = random_from(13);
    uint64_t hash = HASH_START;
    for (int i = 0; i < 2000; i++) {
        float samples[3 * SAMPLES], point[3], weights[SAMPLES];
        for (int k = 0; k < 3 * SAMPLES; k++)
            samples[k] = random_between(&r, -4, 4);
        for (int k = 0; k < 3; k++)
            point[k] = random_between(&r, -5, 5);
        const nkw_blendspace_kind kind = i % 3 == 1 ? (nkw_blendspace_kind)(i / 3 % 2) : NKW_BLENDSPACE_CARTESIAN;
        nkw_blendspace space = {samples, SAMPLES, 1 + (size_t)i % 3, kind};
        nkw_blendspace_weights(&space, i % 7 ? point : samples, weights);
        hash = hash_floats(hash, weights, SAMPLES);
    }
    return hash;
}
