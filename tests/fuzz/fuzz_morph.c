/* SPDX-License-Identifier: MIT */
/* Morph targets and bounds: in bounds for any strides, indices and formats; bounds contain what is skinned. */
#include "fuzz.h"
#include "../support/views.h"

#include <string.h>

static void morphs(fuzz *f, int wild)
{
    size_t n = fuzz_upto(f, 700), targets = fuzz_upto(f, 6), stride = 12 + fuzz_upto(f, 20), bad;
    size_t base_stride = fuzz_byte(f) % 2 ? 12 : stride;
    nkw_morph_target *all = fuzz_block(f, targets * sizeof *all);
    memset(all, 0, targets * sizeof *all);
    for (size_t t = 0; t < targets; t++) {
        size_t count = fuzz_byte(f) % 2 ? fuzz_upto(f, 30) : n, own = fuzz_byte(f) % 2 ? 12 : stride;
        all[t].count = count;
        all[t].deltas.positions.data = fuzz_byte(f) % 8 ? fuzz_bytes(f, (count == n ? n : count) * own) : NULL;
        all[t].deltas.positions.stride = own == 12 ? 0 : own;
        all[t].indices = count == n ? NULL : (const uint32_t *)(const void *)fuzz_links(f, count, n, 1);
    }
    nkw_morph morph = {all, targets, n};
    nkw_vertices_view in = {{fuzz_bytes(f, n * base_stride), base_stride}, {NULL, 0}, {NULL, 0}, {NULL, 0}};
    nkw_vertices_span out = {{fuzz_block(f, n * stride), stride}, {NULL, 0}, {NULL, 0}, {NULL, 0}};
    nkw_morph_apply(&morph, fuzz_floats(f, targets, wild), in, out);
    nkw_morph_validate(&morph, &bad);
    FUZZ_CHECK(bad == 0 || bad < targets);
}

static void bounds(fuzz *f, int wild)
{
    size_t n = fuzz_upto(f, 60), joints = fuzz_upto(f, 12), influences = fuzz_upto(f, 10);
    nkw_skin skin = {n, influences, {fuzz_bytes(f, 4 * n * influences), 0, NKW_SKIN_U32}, {NULL, 0, NKW_SKIN_U8}};
    skin.joints.format = (nkw_skin_format)fuzz_choice(f, 3);
    skin.weights.format = (nkw_skin_format)fuzz_choice(f, 3);
    skin.weights.data = fuzz_bytes(f, 4 * n * influences);
    nkw_vec3_stream_view positions = {fuzz_floats(f, 3 * n, wild), 0};
    nkw_box *boxes = fuzz_block(f, (joints + 1) * sizeof *boxes), box;
    if (nkw_box_from_skin(&skin, positions, boxes, joints) != NKW_OK)
        return;
    nkw_mat4 *palette = fuzz_matrices(f, joints, wild);
    nkw_palette_view view = palette_view(NKW_PALETTE_MAT4, palette, joints);
    FUZZ_CHECK(nkw_box_from_palette(view, boxes, &box) == NKW_OK);
    for (size_t j = 0; j < joints; j++) {
        nkw_box moved = nkw_box_transform(&boxes[j], &palette[j]);
        nkw_box joined = nkw_box_union(&box, &moved);
        FUZZ_CHECK(fuzz_same(&joined.low.x, &box.low.x, 6));
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz f = fuzz_begin(data, size);
    int wild = fuzz_byte(&f) % 2;
    morphs(&f, wild);
    bounds(&f, wild);
    return fuzz_end(&f);
}
