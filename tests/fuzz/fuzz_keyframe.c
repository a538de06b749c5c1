/* SPDX-License-Identifier: MIT */
#include "fuzz.h"

#include <string.h>

enum { KEYS = 30 };

static nkw_keyframe *draw_keys(fuzz *f, size_t count, int wild)
{
    nkw_keyframe *keys = fuzz_block(f, count * sizeof *keys);
    const float *values = fuzz_floats(f, 8 * count, wild);
    random_source r = fuzz_source(f);
    memcpy(keys, values, count * sizeof *keys);
    for (size_t k = 0; k < count && !wild; k++) {
        keys[k].time = k ? keys[k - 1].time + 0.25f * (float)(random_bits(&r) % 4) : keys[k].time;
        keys[k].orientation = random_rotation(&r);
    }
    return keys;
}

static void check_trace(const nkw_keyframe_trace *t, size_t count)
{
    FUZZ_CHECK(t->segment.index + 1 < count || t->segment.index == 0);
    FUZZ_CHECK(t->segment.t >= 0.0f && t->segment.t <= 1.0f);
    FUZZ_CHECK(t->control_count <= 4);
    for (size_t i = 0; i < t->control_count; i++)
        FUZZ_CHECK(t->key[i] < count);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz f = fuzz_begin(data, size);
    int wild = fuzz_byte(&f) % 2;
    size_t count = fuzz_upto(&f, KEYS), bad;
    const nkw_keyframe *keys = draw_keys(&f, count, wild);
    nkw_result sound = nkw_keyframes_validate(keys, count, &bad);
    FUZZ_CHECK(bad < count || bad == 0);
    for (int i = 0; i < 12; i++) {
        nkw_position_method position = (nkw_position_method)fuzz_choice(&f, NKW_POSITION_MAKIMA);
        nkw_orientation_method orientation = (nkw_orientation_method)fuzz_choice(&f, NKW_ORIENTATION_BSPLINE);
        float time = fuzz_float(&f);
        nkw_mat4 out = nkw_mat4_identity(), again;
        nkw_keyframe_trace trace;
        nkw_keyframe_options options = {position, orientation,
                                        (nkw_keyframe_rule)fuzz_choice(&f, NKW_KEYFRAME_RULE_EXERCISE)};
        nkw_result result = nkw_keyframes_sample_as(keys, count, time, &options, &out);
        FUZZ_CHECK(result == nkw_keyframes_trace(keys, count, time, &options, &trace));
        FUZZ_CHECK(options.rule != NKW_KEYFRAME_RULE_LIBRARY ||
                   result == nkw_keyframes_sample(keys, count, time, position, orientation, &again));
        FUZZ_CHECK(fuzz_affine(&out, 1));
        FUZZ_CHECK(count > 0 || result == NKW_EMPTY);
        if (result != NKW_OK)
            continue;
        check_trace(&trace, count);
        nkw_mat3 block = nkw_mat3_from_mat4(&out);
        nkw_vec3 at = nkw_mat4_translation(&out);
        FUZZ_CHECK(fuzz_same(block.m, trace.rotation.m, 9) && fuzz_same(&at.x, &trace.position.x, 3));
        /* By the exercise's rule a Bezier curve continues, up to infinity. */
        FUZZ_CHECK(wild || sound != NKW_OK || options.rule == NKW_KEYFRAME_RULE_EXERCISE || fuzz_finite(out.m, 16));
    }
    return fuzz_end(&f);
}
