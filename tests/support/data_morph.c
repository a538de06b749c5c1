/* SPDX-License-Identifier: MIT */
#include "data.h"
#include "hash.h"
#include "random.h"
#include "views.h"

enum { VERTICES = 777, TARGETS = 6, SPARSE = 40 };

/* Dense and sparse targets, contiguous and interleaved. */
uint64_t data_morph(void)
{
    static float base[6 * VERTICES], out[6 * VERTICES], deltas[TARGETS][3 * VERTICES];
    random_source r = random_from(14);
    uint64_t hash = HASH_START;
    uint32_t indices[SPARSE];
    nkw_morph_target targets[TARGETS];
    const nkw_vec3_stream_view none = {0, 0};
    const nkw_vec3_stream_span none_out = {0, 0};
    for (int i = 0; i < 6 * VERTICES; i++)
        base[i] = random_between(&r, -2, 2);
    for (int k = 0; k < SPARSE; k++)
        indices[k] = (uint32_t)(random_bits(&r) % (VERTICES + 9));
    for (int round = 0; round < 8; round++) {
        float weights[TARGETS];
        size_t stride = round % 2 ? 24 : 12;
        for (int t = 0; t < TARGETS; t++) {
            for (int i = 0; i < 3 * VERTICES; i++)
                deltas[t][i] = random_between(&r, -1, 1);
            weights[t] = random_bits(&r) % 4 ? random_between(&r, -1, 1) : 0.0f;
            nkw_morph_target target = {{{deltas[t], 0}, none, none, none}, t % 4 == 2 ? indices : 0, SPARSE};
            targets[t] = target;
        }
        nkw_morph morph = {targets, TARGETS, VERTICES};
        nkw_vertices_view in = {{base, stride}, none, none, none};
        nkw_vertices_span to = {{out, stride}, none_out, none_out, none_out};
        nkw_morph_apply(&morph, weights, in, to);
        hash = hash_floats(hash, out, 3 * VERTICES);
    }
    return hash;
}
