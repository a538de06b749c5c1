/* SPDX-License-Identifier: MIT */
#include "fuzz.h"
#include "../support/views.h"

#include <string.h>

enum { JOINTS = 150, LAYERS = 5 };

/* A pose, and the same in records. */
typedef struct both {
    nkw_pose_view pose;
    nkw_records_view records;
} both;

static both draw(fuzz *f, size_t n)
{
    nkw_trs *trs = fuzz_block(f, n * sizeof *trs);
    const float *pose = fuzz_pose(f, n, 1);
    nkw_trs_from_pose(pose_view(pose, n), trs);
    both r = {pose_view(pose, n), {trs, n}};
    return r;
}

static int same(fuzz *f, nkw_records_span records, nkw_pose_span pose, size_t n)
{
    float *numbers = fuzz_room(f, NKW_POSE_FLOATS(n));
    nkw_pose_from_trs(records.data, pose_span(numbers, n));
    for (size_t c = 0; c < 10; c++)
        if (!fuzz_same(numbers + c * NKW_POSE_STRIDE(n), pose.data + c * NKW_POSE_STRIDE(n), n))
            return 0;
    return 1;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz f = fuzz_begin(data, size);
    const size_t n = fuzz_upto(&f, JOINTS), count = fuzz_upto(&f, LAYERS);
    both p[LAYERS];
    nkw_pose_layer layers[LAYERS];
    nkw_records_layer record_layers[LAYERS];
    const nkw_mask_view mask = mask_view(fuzz_byte(&f) % 2 ? NULL : fuzz_floats(&f, NKW_POSE_STRIDE(n), 1), n);
    for (size_t i = 0; i < LAYERS; i++) {
        p[i] = draw(&f, n);
        const float weight = fuzz_float(&f);
        const nkw_pose_layer layer = {p[i].pose, weight, mask};
        const nkw_records_layer record = {p[i].records, weight, mask};
        layers[i] = layer;
        record_layers[i] = record;
    }
    const nkw_pose_span out = pose_span(fuzz_room(&f, NKW_POSE_FLOATS(n)), n);
    const nkw_records_span to = {fuzz_block(&f, n * sizeof(nkw_trs)), n};
    const float t = fuzz_byte(&f) % 2 ? (float)fuzz_byte(&f) / 255.0f : fuzz_float(&f);
    const nkw_additive side = (nkw_additive)(fuzz_byte(&f) % 2);

    nkw_pose_blend(p[0].pose, p[1].pose, t, mask, out);
    FUZZ_CHECK(nkw_records_blend(p[0].records, p[1].records, t, mask, to) == NKW_OK);
    FUZZ_CHECK(same(&f, to, out, n));
    nkw_work work = {fuzz_block(&f, NKW_RECORDS_LAYERS_WORK(LAYERS)), NKW_RECORDS_LAYERS_WORK(LAYERS)};
    nkw_pose_layers_blend(layers, count, p[2].pose, t, out);
    FUZZ_CHECK(nkw_records_layers_blend(record_layers, count, p[2].records, t, to, work) == NKW_OK);
    FUZZ_CHECK(same(&f, to, out, n));
    nkw_pose_additive_build(p[0].pose, p[1].pose, side, out);
    nkw_records_additive_build(p[0].records, p[1].records, side, to);
    FUZZ_CHECK(same(&f, to, out, n));
    nkw_pose_additive_apply(p[0].pose, p[1].pose, t, mask, side, out);
    nkw_records_additive_apply(p[0].records, p[1].records, t, mask, side, to);
    FUZZ_CHECK(same(&f, to, out, n));
    return fuzz_end(&f);
}
