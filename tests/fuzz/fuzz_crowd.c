/* SPDX-License-Identifier: MIT */
/* Every lane has the bits of its character alone, on whatever skeleton. */
#include "fuzz.h"

#include <string.h>

enum { JOINTS = 24 };

static void check_lanes(fuzz *f, const float *crowd, size_t n, const nkw_mat4 *const *want)
{
    nkw_mat4 *out[NKW_CROWD];
    for (size_t i = 0; i < NKW_CROWD; i++)
        out[i] = want[i] ? fuzz_block(f, n * sizeof **out) : NULL;
    nkw_matrices_from_crowd(crowd, n, out);
    for (size_t i = 0; i < NKW_CROWD; i++)
        FUZZ_CHECK(!out[i] || fuzz_same((const float *)out[i], (const float *)want[i], 16 * n));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz f = fuzz_begin(data, size);
    size_t n = fuzz_upto(&f, JOINTS), count = fuzz_upto(&f, JOINTS), characters = fuzz_upto(&f, NKW_CROWD);
    int wild = fuzz_byte(&f) % 2;
    nkw_skeleton s = {fuzz_parents(&f, n, wild), n};
    const int32_t *joints = fuzz_byte(&f) % 2 ? fuzz_links(&f, count, n, 1) : NULL;
    const nkw_mat4 *inverse_bind = fuzz_byte(&f) % 2 ? fuzz_matrices(&f, count, wild) : NULL;
    const nkw_mat4 *root = fuzz_matrices(&f, 1, wild), *roots[NKW_CROWD];
    const float *poses[NKW_CROWD] = {NULL};
    const nkw_mat4 *models[NKW_CROWD] = {NULL}, *palettes[NKW_CROWD] = {NULL};
    for (size_t i = 0; i < NKW_CROWD; i++)
        roots[i] = root;
    for (size_t i = 0; i < characters; i++) {
        nkw_mat4 *m = fuzz_block(&f, n * sizeof *m), *p = fuzz_block(&f, count * sizeof *p);
        poses[i] = fuzz_pose(&f, n, wild);
        nkw_models_from_pose(&s, poses[i], root, m);
        nkw_palette_from_models(m, n, joints, inverse_bind, NULL, count, p);
        models[i] = m;
        palettes[i] = p;
    }
    float *lanes = fuzz_room(&f, NKW_CROWD_POSE_FLOATS(n)), *placed = fuzz_room(&f, NKW_CROWD_MATRIX_FLOATS(1));
    float *all = fuzz_room(&f, NKW_CROWD_MATRIX_FLOATS(n)), *palette = fuzz_room(&f, NKW_CROWD_MATRIX_FLOATS(count));
    nkw_crowd_from_poses(poses, n, lanes);
    nkw_crowd_from_matrices(roots, 1, placed);
    nkw_crowd_models_from_pose(&s, lanes, placed, all);
    check_lanes(&f, all, n, models);
    nkw_crowd_palette_from_models(all, n, joints, inverse_bind, count, palette);
    check_lanes(&f, palette, count, palettes);
    nkw_crowd_models_from_pose(&s, lanes, NULL, all);
    return fuzz_end(&f);
}
