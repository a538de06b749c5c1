/* SPDX-License-Identifier: MIT */
#include "data.h"
#include "hash.h"
#include "random.h"
#include "views.h"

enum { VERTICES = 200, JOINTS = 9 };

uint64_t data_bounds(void)
{
    random_source r = random_from(15);
    uint64_t hash = HASH_START;
    for (int round = 0; round < 50; round++) {
        nkw_vec3 positions[VERTICES];
        unsigned char joints[2 * VERTICES], weights[2 * VERTICES];
        nkw_mat4 palette[JOINTS];
        nkw_box boxes[JOINTS + 1], box;
        for (int i = 0; i < VERTICES; i++) {
            positions[i] = random_vec3(&r, -3, 3);
            joints[2 * i] = (unsigned char)(random_bits(&r) % (JOINTS + 1));
            joints[2 * i + 1] = (unsigned char)(random_bits(&r) % JOINTS);
            weights[2 * i] = (unsigned char)(random_bits(&r) % 256);
            weights[2 * i + 1] = (unsigned char)(255 - weights[2 * i]);
        }
        for (int j = 0; j < JOINTS; j++) {
            nkw_trs trs = {random_vec3(&r, -3, 3), random_rotation(&r), random_vec3(&r, 0.5f, 2)};
            palette[j] = nkw_mat4_from_trs(&trs);
        }
        nkw_skin skin = {VERTICES, 2, {joints, 0, NKW_SKIN_U8}, {weights, 0, NKW_SKIN_U8}};
        nkw_vec3_stream_view stream = {positions, 0};
        nkw_box_from_skin(&skin, stream, boxes, JOINTS);
        nkw_box_from_palette(palette_view(NKW_PALETTE_MAT4, palette, JOINTS), boxes, &box);
        hash = hash_floats(hash, &boxes[0].low.x, 6 * JOINTS);
        hash = hash_floats(hash, &box.low.x, 6);
    }
    return hash;
}
