/* SPDX-License-Identifier: MIT */
/* The part of skin.h that prepares and checks weights. */
#include <math.h>

#include "random.h"
#include "support/expect.h"
#include "support/skin_mesh.h"

static void normalised_weights_sum_exactly(void **state)
{
    (void)state;
    random_source r = random_from(21);
    for (size_t n = 0; n < 4000; n++) {
        size_t k = 1 + n % 8;
        float in[8], f[8], sum = 0, back = 0;
        uint8_t b[8];
        uint16_t s[8];
        unsigned bytes = 0, shorts = 0;
        for (size_t e = 0; e < k; e++)
            in[e] = n % 3 ? random_unit(&r) + 1e-3f : random_scaled(&r, -60, 60);
        in[0] = in[0] < 0 ? -in[0] : in[0];
        nkw_skin_view view = {in, 0, NKW_SKIN_F32};
        nkw_skin_span to_f = {f, 0, NKW_SKIN_F32}, to_b = {b, 0, NKW_SKIN_U8}, to_s = {s, 0, NKW_SKIN_U16};
        nkw_skin_normalize_weights(view, k, 1, to_f);
        nkw_skin_normalize_weights(view, k, 1, to_b);
        nkw_skin_normalize_weights(view, k, 1, to_s);
        for (size_t e = 0; e < k; e++) {
            sum += f[e];
            back += f[k - 1 - e];
            bytes += b[e];
            shorts += s[e];
            expect_near((double)b[e] / 255, f[e], 1.0 / 255 + 1e-6);
            expect_near((double)s[e] / 65535, f[e], 1.0 / 65535 + 1e-6);
        }
        expect_bits(sum, 1);
        expect_bits(back, 1);
        assert_int_equal(bytes, 255);
        assert_int_equal(shorts, 65535);
    }
}

static void the_largest_remainder_gets_what_is_missing_and_the_first_of_equals(void **state)
{
    (void)state;
    const float in[3][4] = {{1, 1, 1, 1}, {1, 1, 1, 0}, {0.5f, 0.25f, 0.125f, 0.125f}};
    const uint8_t want[3][4] = {{64, 64, 64, 63}, {85, 85, 85, 0}, {127, 64, 32, 32}};
    uint8_t got[3][4];
    nkw_skin_view view = {in, 0, NKW_SKIN_F32};
    nkw_skin_span span = {got, 0, NKW_SKIN_U8};
    assert_int_equal(nkw_skin_normalize_weights(view, 4, 3, span), NKW_OK);
    assert_memory_equal(got, want, sizeof want);
}

/* The largest remainder in whole numbers: of w total / sum, w total mod sum. */
static void share_out(const uint8_t *w, size_t k, uint32_t total, uint32_t *n)
{
    uint64_t sum = 0, rest[NKW_SKIN_INFLUENCES];
    uint32_t missing = total;
    for (size_t e = 0; e < k; e++)
        sum += w[e];
    for (size_t e = 0; e < k; e++) {
        n[e] = (uint32_t)((uint64_t)w[e] * total / sum);
        rest[e] = (uint64_t)w[e] * total % sum + 1;
        missing -= n[e];
    }
    for (; missing > 0; missing--) {
        size_t most = 0;
        for (size_t e = 1; e < k; e++)
            most = rest[e] > rest[most] ? e : most;
        rest[most] = 0;
        n[most]++;
    }
}

static void whole_numbers_are_shared_out_as_whole_numbers_are(void **state)
{
    (void)state;
    random_source r = random_from(11);
    for (int i = 0; i < 20000; i++) {
        size_t k = 1 + random_bits(&r) % NKW_SKIN_INFLUENCES;
        uint8_t w[NKW_SKIN_INFLUENCES], bytes[NKW_SKIN_INFLUENCES];
        uint16_t shorts[NKW_SKIN_INFLUENCES];
        float floats[NKW_SKIN_INFLUENCES];
        uint32_t n[NKW_SKIN_INFLUENCES];
        for (size_t e = 0; e < k; e++)
            w[e] = (uint8_t)(random_bits(&r) % (i % 2 ? 6 : 256));
        w[0] = w[0] ? w[0] : 1;
        nkw_skin_view view = {w, 0, NKW_SKIN_U8};
        nkw_skin_span to_bytes = {bytes, 0, NKW_SKIN_U8}, to_shorts = {shorts, 0, NKW_SKIN_U16},
                      to_floats = {floats, 0, NKW_SKIN_F32};
        nkw_skin_normalize_weights(view, k, 1, to_bytes);
        nkw_skin_normalize_weights(view, k, 1, to_shorts);
        nkw_skin_normalize_weights(view, k, 1, to_floats);
        for (size_t e = 0; e < k; e++) {
            share_out(w, k, 255, n);
            assert_int_equal(bytes[e], n[e]);
            share_out(w, k, 65535, n);
            assert_int_equal(shorts[e], n[e]);
            share_out(w, k, 1u << 24, n);
            assert_true(floats[e] == (float)n[e] * 0x1p-24f);
        }
    }
}

static void weights_that_cannot_be_used_count_as_zero(void **state)
{
    (void)state;
    float w[3][4] = {{-1, NAN, INFINITY, 2}, {0, -3, NAN, 0}, {0.25f, 0.25f, 0.25f, 0.25f}};
    const float want[3][4] = {{0, 0, 0, 1}, {0, 0, 0, 0}, {0.25f, 0.25f, 0.25f, 0.25f}};
    nkw_skin_view view = {w, 0, NKW_SKIN_F32};
    nkw_skin_span span = {w, 0, NKW_SKIN_F32};
    assert_int_equal(nkw_skin_normalize_weights(view, 4, 3, span), NKW_OK);
    expect_floats_bits(w[0], want[0], 12);
}

static void pruning_keeps_the_largest_in_their_order(void **state)
{
    (void)state;
    const uint16_t joints[2][6] = {{10, 11, 12, 13, 14, 15}, {300, 21, 22, 23, 24, 25}};
    const float weights[2][6] = {{0.125f, 0.25f, 0.0625f, 0.25f, 0.0625f, 0.25f}, {0.25f, 0, 0, 0, 0, 0.75f}};
    nkw_skin skin = {2, 6, {joints, 0, NKW_SKIN_U16}, {weights, 0, NKW_SKIN_F32}};
    uint8_t j[2][3], w[2][3];
    const uint8_t want_j[2][3] = {{11, 13, 15}, {0, 21, 25}}, want_w[2][3] = {{85, 85, 85}, {0, 0, 255}};
    nkw_skin_span to_j = {j, 0, NKW_SKIN_U8}, to_w = {w, 0, NKW_SKIN_U8};
    nkw_skin_prune(&skin, 3, to_j, to_w);
    assert_memory_equal(j, want_j, sizeof j);
    assert_memory_equal(w, want_w, sizeof w);
}

/* 1 1 1 2 2 3 3 0 by .2 .2 .1 .15 .15 .1 .05 .05 are 1 2 3 0 by .5 .3 .15 .05. */
static void pruning_adds_the_weights_of_equal_joints_first(void **state)
{
    (void)state;
    const uint16_t joints[8] = {1, 1, 1, 2, 2, 3, 3, 0};
    const float weights[8] = {0.2f, 0.2f, 0.1f, 0.15f, 0.15f, 0.1f, 0.05f, 0.05f};
    const nkw_skin skin = {1, 8, {joints, 0, NKW_SKIN_U16}, {weights, 0, NKW_SKIN_F32}};
    uint16_t j[4];
    float w[4];
    const nkw_skin_span to_j = {j, 0, NKW_SKIN_U16}, to_w = {w, 0, NKW_SKIN_F32};
    const float want[3][4] = {{0.625f, 0.375f}, {10 / 19.0f, 6 / 19.0f, 3 / 19.0f}, {0.5f, 0.3f, 0.15f, 0.05f}};
    const uint16_t order[4] = {1, 2, 3, 0};
    for (size_t keep = 2; keep <= 4; keep++) {
        assert_int_equal(nkw_skin_prune(&skin, keep, to_j, to_w), NKW_OK);
        assert_memory_equal(j, order, keep * sizeof *j);
        for (size_t e = 0; e < keep; e++)
            assert_float_equal(w[e], want[keep - 2][e], 0x1p-23f);
    }
    const uint8_t bytes[4] = {4, 9, 4, 9}, shares[4] = {100, 50, 55, 50};
    const nkw_skin small = {1, 4, {bytes, 0, NKW_SKIN_U8}, {shares, 0, NKW_SKIN_U8}};
    nkw_skin_prune(&small, 1, to_j, to_w);
    assert_true(j[0] == 4 && w[0] == 1.0f);
    const float most[3] = {3e38f, 3e38f, 1.0f};
    const nkw_skin large = {1, 3, {joints, 0, NKW_SKIN_U16}, {most, 0, NKW_SKIN_F32}};
    nkw_skin_prune(&large, 2, to_j, to_w);
    assert_true(j[0] == 1 && w[0] == 1.0f && w[1] == 0.0f);
}

static void a_joint_that_the_format_cannot_hold_has_no_weight(void **state)
{
    (void)state;
    const uint32_t joints[4] = {70000, 65535, 300, 70000};
    const float weights[4] = {0.5f, 0.125f, 0.125f, 0.25f};
    uint16_t j[2];
    float w[2];
    nkw_skin skin = {1, 4, {joints, 0, NKW_SKIN_U32}, {weights, 0, NKW_SKIN_F32}};
    nkw_skin_span to_j = {j, 0, NKW_SKIN_U16}, to_w = {w, 0, NKW_SKIN_F32};
    nkw_skin_prune(&skin, 2, to_j, to_w);
    assert_int_equal(j[0], 65535);
    assert_int_equal(j[1], 300);
    expect_bits(w[0], 0.5f);
    expect_bits(w[1], 0.5f);
    uint8_t small[2];
    nkw_skin_span to_small = {small, 0, NKW_SKIN_U8};
    nkw_skin_prune(&skin, 2, to_small, to_w);
    assert_true(small[0] == 0 && small[1] == 0 && w[0] == 0.0f && w[1] == 0.0f);
}

/* As an importer without a limit returns them. */
static void pruning_takes_any_number_of_influences(void **state)
{
    (void)state;
    random_source r = random_from(4);
    for (size_t k = 1; k <= 40; k++) {
        uint16_t joints[40], j[8];
        float weights[40], w[8];
        for (size_t e = 0; e < k; e++) {
            joints[e] = (uint16_t)(e + 1);
            weights[e] = (float)(random_bits(&r) % 8);
        }
        nkw_skin skin = {1, k, {joints, 0, NKW_SKIN_U16}, {weights, 0, NKW_SKIN_F32}};
        nkw_skin_span to_j = {j, 0, NKW_SKIN_U16}, to_w = {w, 0, NKW_SKIN_F32};
        nkw_skin_prune(&skin, 8, to_j, to_w);
        size_t at = 0;
        for (size_t e = 0; e < k; e++) {
            size_t before = 0;
            for (size_t o = 0; o < k; o++)
                before += weights[o] > weights[e] || (weights[o] == weights[e] && o < e);
            if (before < 8)
                assert_int_equal(j[at++], e + 1);
        }
        for (; at < 8; at++)
            assert_true(j[at] == 0 && w[at] == 0.0f);
    }
}

static void pruning_to_more_fills_up_with_weight_zero(void **state)
{
    (void)state;
    const uint8_t joints[2] = {7, 9};
    const float weights[2] = {1, 3};
    uint16_t j[4] = {1, 1, 1, 1}, w[4] = {1, 1, 1, 1};
    const uint16_t want_j[4] = {7, 9, 0, 0}, want_w[4] = {16384, 49151, 0, 0};
    nkw_skin skin = {1, 2, {joints, 0, NKW_SKIN_U8}, {weights, 0, NKW_SKIN_F32}};
    nkw_skin_span to_j = {j, 0, NKW_SKIN_U16}, to_w = {w, 0, NKW_SKIN_U16};
    nkw_skin_prune(&skin, 4, to_j, to_w);
    assert_memory_equal(j, want_j, sizeof j);
    assert_memory_equal(w, want_w, sizeof w);
}

/* u8 joints of interleaved vertices to u16 ones, packed: nothing is dropped. */
static void keeping_all_influences_widens_and_packs_them(void **state)
{
    (void)state;
    const uint8_t vertices[3][8] = {
        {3, 1, 255, 0, 200, 55, 0, 9}, {2, 4, 6, 8, 51, 51, 51, 102}, {1, 1, 1, 1, 0, 0, 0, 0}};
    nkw_skin skin = {3, 4, {vertices[0], 8, NKW_SKIN_U8}, {vertices[0] + 4, 8, NKW_SKIN_U8}};
    uint16_t j[3][4], w[3][4];
    const uint16_t want_w[3][4] = {{49648, 13653, 0, 2234}, {13107, 13107, 13107, 26214}, {0, 0, 0, 0}};
    nkw_skin_span to_j = {j, 0, NKW_SKIN_U16}, to_w = {w, 0, NKW_SKIN_U16};
    assert_int_equal(nkw_skin_prune(&skin, 4, to_j, to_w), NKW_OK);
    for (size_t i = 0; i < 3; i++)
        for (size_t e = 0; e < 4; e++)
            assert_int_equal(j[i][e], vertices[i][e]);
    assert_memory_equal(w, want_w, sizeof w);
}

static void pruning_in_place_is_as_elsewhere(void **state)
{
    (void)state;
    random_source r = random_from(3);
    uint16_t joints[40 * 8], j[40 * 8];
    float weights[40 * 8], w[40 * 8];
    for (size_t i = 0; i < 40 * 8; i++) {
        joints[i] = (uint16_t)(random_bits(&r) % 100);
        weights[i] = random_unit(&r);
    }
    for (size_t keep = 1; keep <= 8; keep++) {
        uint16_t own_j[40 * 8];
        float own_w[40 * 8];
        memcpy(own_j, joints, sizeof joints);
        memcpy(own_w, weights, sizeof weights);
        nkw_skin skin = {40, 8, {joints, 0, NKW_SKIN_U16}, {weights, 0, NKW_SKIN_F32}}, own = skin;
        own.joints.data = own_j;
        own.weights.data = own_w;
        nkw_skin_span to_j = {j, 0, NKW_SKIN_U16}, to_w = {w, 0, NKW_SKIN_F32};
        nkw_skin_span to_own_j = {own_j, 0, NKW_SKIN_U16}, to_own_w = {own_w, 0, NKW_SKIN_F32};
        nkw_skin_prune(&skin, keep, to_j, to_w);
        nkw_skin_prune(&own, keep, to_own_j, to_own_w);
        assert_memory_equal(own_j, j, 40 * keep * sizeof *j);
        expect_floats_bits(own_w, w, 40 * keep);
    }
}

static void what_cannot_be_pruned_or_normalised_writes_nothing(void **state)
{
    (void)state;
    const uint8_t joints[9] = {1, 2, 3, 4, 5, 6, 7, 8, 9}, weights[9] = {9, 8, 7, 6, 5, 4, 3, 2, 1};
    uint8_t j[9] = {0}, w[9] = {0};
    const uint8_t nothing[9] = {0};
    nkw_skin skin = {1, 4, {joints, 0, NKW_SKIN_U8}, {weights, 0, NKW_SKIN_U8}};
    nkw_skin none = skin, bad_joints = skin, bad_weights = skin;
    none.influence_count = 0;
    bad_joints.joints.format = NKW_SKIN_FORMAT_MAX_ENUM;
    bad_weights.weights.format = NKW_SKIN_U32;
    const nkw_skin *const refused[] = {&none, &bad_joints, &bad_weights};
    const nkw_result why[] = {NKW_EMPTY, NKW_BAD_FORMAT, NKW_BAD_FORMAT};
    nkw_skin_span to_j = {j, 0, NKW_SKIN_U8}, to_w = {w, 0, NKW_SKIN_U8};
    nkw_skin_span unknown = {j, 0, NKW_SKIN_FORMAT_MAX_ENUM}, wide = {w, 0, NKW_SKIN_U32};
    for (size_t i = 0; i < 3; i++)
        assert_int_equal(nkw_skin_prune(refused[i], 2, to_j, to_w), why[i]);
    assert_int_equal(nkw_skin_prune(&skin, 0, to_j, to_w), NKW_EMPTY);
    assert_int_equal(nkw_skin_prune(&skin, 9, to_j, to_w), NKW_TOO_MANY);
    assert_int_equal(nkw_skin_prune(&skin, 2, unknown, to_w), NKW_BAD_FORMAT);
    assert_int_equal(nkw_skin_prune(&skin, 2, to_j, wide), NKW_BAD_FORMAT);
    assert_int_equal(nkw_skin_normalize_weights(skin.weights, 9, 1, to_w), NKW_TOO_MANY);
    assert_int_equal(nkw_skin_normalize_weights(skin.weights, 0, 1, to_w), NKW_EMPTY);
    assert_int_equal(nkw_skin_normalize_weights(skin.weights, 4, 1, wide), NKW_BAD_FORMAT);
    assert_int_equal(nkw_skin_normalize_weights(bad_weights.weights, 4, 1, to_w), NKW_BAD_FORMAT);
    assert_memory_equal(j, nothing, sizeof j);
    assert_memory_equal(w, nothing, sizeof w);
}

static void expect_invalid(const nkw_skin *skin, nkw_result result, size_t vertex)
{
    size_t bad = 99;
    assert_int_equal(nkw_skin_validate(skin, JOINTS, &bad), result);
    assert_int_equal(bad, vertex);
    assert_int_equal(nkw_skin_validate(skin, JOINTS, NULL), result);
}

static void validate_names_the_first_offender_among_floats(void **state)
{
    (void)state;
    mesh m = draw(22, 4, 0);
    nkw_skin skin = skin_of(&m, 4);
    expect_invalid(&skin, NKW_OK, 0);
    memset(m.weights + 40, 0, 16);
    expect_invalid(&skin, NKW_OK, 0);
    m.weights[4 * 90 + 2] += 0.0011f;
    expect_invalid(&skin, NKW_BAD_WEIGHTS, 90);
    m.weights[4 * 90 + 2] -= 2 * 0.0011f;
    expect_invalid(&skin, NKW_BAD_WEIGHTS, 90);
    m.weights[4 * 80 + 1] = -m.weights[4 * 80 + 1];
    expect_invalid(&skin, NKW_BAD_WEIGHTS, 80);
    m.weights[4 * 70 + 3] = INFINITY;
    expect_invalid(&skin, NKW_NOT_FINITE, 70);
    m.weights[4 * 60] = NAN;
    expect_invalid(&skin, NKW_NOT_FINITE, 60);
    m.joints[4 * 50 + 3] = JOINTS;
    expect_invalid(&skin, NKW_OUT_OF_RANGE, 50);
    m.weights[4 * 30] += 0.0009f;
    expect_invalid(&skin, NKW_OUT_OF_RANGE, 50);
}

static void validate_wants_whole_numbers_to_sum_exactly(void **state)
{
    (void)state;
    mesh m = draw(23, 8, 0);
    uint8_t bytes[VERTICES * 8];
    uint16_t shorts[VERTICES * 8];
    nkw_skin_view from = {m.weights, 0, NKW_SKIN_F32};
    nkw_skin_span to_bytes = {bytes, 0, NKW_SKIN_U8}, to_shorts = {shorts, 0, NKW_SKIN_U16};
    nkw_skin_normalize_weights(from, 8, VERTICES, to_bytes);
    nkw_skin_normalize_weights(from, 8, VERTICES, to_shorts);
    nkw_skin skin = {VERTICES, 8, {m.joints, 0, NKW_SKIN_U16}, {bytes, 0, NKW_SKIN_U8}};
    expect_invalid(&skin, NKW_OK, 0);
    bytes[8 * 77] ^= 1;
    expect_invalid(&skin, NKW_BAD_WEIGHTS, 77);
    skin.weights.data = shorts;
    skin.weights.format = NKW_SKIN_U16;
    expect_invalid(&skin, NKW_OK, 0);
    shorts[8 * 66 + 5] ^= 1;
    expect_invalid(&skin, NKW_BAD_WEIGHTS, 66);
}

static void validate_checks_the_shape(void **state)
{
    (void)state;
    mesh m = draw(24, 4, 0);
    nkw_skin skin = skin_of(&m, 4);
    skin.influence_count = 0;
    expect_invalid(&skin, NKW_EMPTY, 0);
    skin.influence_count = 9;
    expect_invalid(&skin, NKW_TOO_MANY, 0);
    skin = skin_of(&m, 4);
    skin.joints.format = NKW_SKIN_FORMAT_MAX_ENUM;
    expect_invalid(&skin, NKW_BAD_FORMAT, 0);
    skin = skin_of(&m, 4);
    skin.weights.format = NKW_SKIN_U32;
    expect_invalid(&skin, NKW_BAD_FORMAT, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(normalised_weights_sum_exactly),
        cmocka_unit_test(the_largest_remainder_gets_what_is_missing_and_the_first_of_equals),
        cmocka_unit_test(whole_numbers_are_shared_out_as_whole_numbers_are),
        cmocka_unit_test(weights_that_cannot_be_used_count_as_zero),
        cmocka_unit_test(pruning_keeps_the_largest_in_their_order),
        cmocka_unit_test(pruning_adds_the_weights_of_equal_joints_first),
        cmocka_unit_test(a_joint_that_the_format_cannot_hold_has_no_weight),
        cmocka_unit_test(pruning_takes_any_number_of_influences),
        cmocka_unit_test(pruning_to_more_fills_up_with_weight_zero),
        cmocka_unit_test(keeping_all_influences_widens_and_packs_them),
        cmocka_unit_test(pruning_in_place_is_as_elsewhere),
        cmocka_unit_test(what_cannot_be_pruned_or_normalised_writes_nothing),
        cmocka_unit_test(validate_names_the_first_offender_among_floats),
        cmocka_unit_test(validate_wants_whole_numbers_to_sum_exactly),
        cmocka_unit_test(validate_checks_the_shape),
    };
    return cmocka_run_group_tests_name("skin_weights", tests, NULL, NULL);
}
