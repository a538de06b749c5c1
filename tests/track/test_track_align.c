/* SPDX-License-Identifier: MIT */
/* Signs of rotations: which arc CUBICSPLINE takes, and keys of aligned signs. */
#include <math.h>
#include <string.h>

#include "random.h"
#include "support/expect.h"

enum { KEYS = 5, TRIPLE = 12 };

static const float times[KEYS] = {0, 1, 2, 2.5f, 4};

static void put(float *v, nkw_quat q)
{
    v[0] = q.x, v[1] = q.y, v[2] = q.z, v[3] = q.w;
}

static nkw_track cubic(const float *values, size_t count)
{
    nkw_track t = {times, values, count, 4, NKW_TRACK_ROTATION, NKW_INTERPOLATION_CUBICSPLINE, NULL};
    return t;
}

static nkw_quat about_z(float degrees)
{
    const nkw_vec3 z = {0, 0, 1};
    return nkw_quat_from_axis_angle(z, nkw_radians_from_degrees(degrees));
}

static nkw_quat sample(const nkw_track *t, float time)
{
    float v[4];
    nkw_track_sample(t, time, NULL, v);
    nkw_quat q = {v[0], v[1], v[2], v[3]};
    return q;
}

/* By glTF's formula: 90 degrees, the second key negated, without tangents. */
static void a_negated_key_sends_cubicspline_the_long_way(void **state)
{
    (void)state;
    float values[2 * TRIPLE] = {0}, aligned[2 * TRIPLE];
    size_t negated, first;
    put(values + 4, about_z(0));
    put(values + TRIPLE + 4, nkw_quat_negate(about_z(90)));
    nkw_track t = cubic(values, 2);
    assert_int_equal(nkw_track_validate(&t, &first), NKW_OK);
    assert_int_equal(first, 1);
    expect_rotation_near(sample(&t, 0.5f), about_z(-135), 1e-6);
    assert_int_equal(nkw_track_align(&t, NULL, &negated, &first), NKW_OK);
    assert_true(negated == 1 && first == 1);
    assert_int_equal(nkw_track_align(&t, aligned, &negated, &first), NKW_OK);
    assert_true(negated == 1 && first == 1);
    t.values = aligned;
    expect_rotation_near(sample(&t, 0.5f), about_z(45), 1e-6);
    assert_int_equal(nkw_track_align(&t, NULL, &negated, &first), NKW_OK);
    assert_true(negated == 0 && first == 0);
    assert_int_equal(nkw_track_validate(&t, &first), NKW_OK);
    assert_int_equal(first, 0);
}

static void draw(random_source *r, float *values, nkw_quat *keys, int any_sign)
{
    for (int k = 0; k < KEYS; k++) {
        nkw_quat q = k ? random_near(r, keys[k - 1], random_between(r, 0.0f, 1.0f)) : random_rotation(r);
        keys[k] = nkw_quat_normalize(q);
        float sign = any_sign && random_bits(r) & 1 ? -1.0f : 1.0f;
        for (int i = 0; i < TRIPLE; i++)
            values[TRIPLE * k + i] = sign * random_between(r, -0.2f, 0.2f);
        put(values + TRIPLE * k + 4, nkw_quat_scale(keys[k], sign));
    }
}

static void aligned_keys_have_no_long_arcs_and_the_same_rotations(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int i = 0; i < 2000; i++) {
        float values[KEYS * TRIPLE], original[KEYS * TRIPLE];
        nkw_quat keys[KEYS];
        size_t counted, negated, first, opposed = 0;
        draw(&r, values, keys, 1);
        memcpy(original, values, sizeof values);
        nkw_track t = cubic(values, KEYS);
        assert_int_equal(nkw_track_align(&t, NULL, &counted, &first), NKW_OK);
        assert_memory_equal(values, original, sizeof values);
        assert_int_equal(nkw_track_align(&t, values, &negated, NULL), NKW_OK);
        assert_int_equal(counted, negated);
        for (int k = 0; k < KEYS; k++) {
            int flipped = values[TRIPLE * k + 4] != original[TRIPLE * k + 4];
            for (int c = 0; c < TRIPLE; c++)
                expect_bits(values[TRIPLE * k + c], flipped ? -original[TRIPLE * k + c] : original[TRIPLE * k + c]);
            assert_int_equal(flipped && opposed == 0 ? k : (int)first, (int)first);
            opposed += (size_t)flipped;
        }
        assert_int_equal(negated, opposed);
        assert_int_equal(nkw_track_align(&t, values, &negated, &first), NKW_OK);
        assert_true(negated == 0 && first == 0);
    }
}

/* Negating whole triples leaves the curve of aligned keys as it is. */
static void signs_of_triples_do_not_change_the_aligned_curve(void **state)
{
    (void)state;
    random_source r = random_from(2);
    for (int i = 0; i < 500; i++) {
        float values[KEYS * TRIPLE], flipped[KEYS * TRIPLE];
        nkw_quat keys[KEYS];
        draw(&r, values, keys, 0);
        for (int k = 0; k < KEYS; k++)
            for (int c = 0; c < TRIPLE; c++)
                flipped[TRIPLE * k + c] = (i >> k) & 1 ? -values[TRIPLE * k + c] : values[TRIPLE * k + c];
        nkw_track a = cubic(values, KEYS), b = cubic(flipped, KEYS);
        nkw_track_align(&a, values, NULL, NULL);
        nkw_track_align(&b, flipped, NULL, NULL);
        float time = random_between(&r, 0.0f, 4.0f);
        expect_rotation_near(sample(&a, time), sample(&b, time), 0);
    }
}

static void linear_tracks_keep_their_rotations(void **state)
{
    (void)state;
    random_source r = random_from(3);
    for (int i = 0; i < 500; i++) {
        float values[KEYS * 4], aligned[KEYS * 4];
        for (int k = 0; k < KEYS; k++)
            put(values + 4 * k, nkw_quat_normalize(random_rotation(&r)));
        nkw_track t = {times, values, KEYS, 4, NKW_TRACK_ROTATION, NKW_INTERPOLATION_LINEAR, NULL}, u = t;
        u.values = aligned;
        assert_int_equal(nkw_track_align(&t, aligned, NULL, NULL), NKW_OK);
        float time = random_between(&r, 0.0f, 4.0f);
        expect_rotation_near(sample(&t, time), sample(&u, time), 0);
    }
}

static void other_tracks_are_copied_or_refused(void **state)
{
    (void)state;
    const float values[8] = {1, 2, 3, 4, -1, -2, -3, -4};
    float out[8] = {0};
    size_t negated = 7, first = 7;
    nkw_track t = {times, values, 2, 4, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR, NULL};
    assert_int_equal(nkw_track_align(&t, out, &negated, &first), NKW_OK);
    assert_true(negated == 0 && first == 0);
    assert_memory_equal(out, values, sizeof values);
    t.kind = NKW_TRACK_ROTATION;
    t.width = 3;
    negated = first = 7;
    out[0] = 9.0f;
    assert_int_equal(nkw_track_align(&t, out, &negated, &first), NKW_BAD_WIDTH);
    assert_true(negated == 0 && first == 0);
    t.count = 0;
    t.values = NULL;
    assert_int_equal(nkw_track_align(&t, out, NULL, NULL), NKW_EMPTY);
    expect_bits(out[0], 9.0f);
}

/* A key is aligned with the one before, whatever the interpolation between them. */
static void keys_of_all_modes_are_aligned(void **state)
{
    (void)state;
    float values[3 * TRIPLE] = {0};
    const unsigned char modes[3] = {NKW_INTERPOLATION_LINEAR, NKW_INTERPOLATION_CUBICSPLINE,
                                    NKW_INTERPOLATION_CUBICSPLINE};
    put(values + 4, about_z(0));
    put(values + TRIPLE + 4, nkw_quat_negate(about_z(90)));
    put(values + 2 * TRIPLE + 4, about_z(100));
    nkw_track t = cubic(values, 3);
    t.key_interpolation = modes;
    size_t negated, first;
    assert_int_equal(nkw_track_align(&t, NULL, &negated, &first), NKW_OK);
    assert_true(negated == 1 && first == 1);
    /* The first segment is LINEAR; from the negated key on the curve takes the longer arc. */
    assert_int_equal(nkw_track_validate(&t, &first), NKW_OK);
    assert_int_equal(first, 2);
    t.interpolation = NKW_INTERPOLATION_LINEAR;
    t.key_interpolation = NULL;
    assert_int_equal(nkw_track_validate(&t, &first), NKW_NOT_UNIT);
}

/* The number of tracks, of three whose second and third take the longer arc. */
static void the_build_of_a_clip_tells_of_long_arcs(void **state)
{
    (void)state;
    float even[2 * TRIPLE] = {0}, odd[2 * TRIPLE] = {0};
    NKW_STACK_WORK(work, NKW_CLIP_BUILD_WORK(3));
    static uint64_t block[128];
    size_t bytes, bad = 9;
    put(even + 4, about_z(0));
    put(even + TRIPLE + 4, about_z(90));
    put(odd + 4, about_z(0));
    put(odd + TRIPLE + 4, nkw_quat_negate(about_z(90)));
    nkw_clip_track tracks[3] = {{NKW_CLIP_ROTATION, 0, cubic(even, 2)},
                                {NKW_CLIP_ROTATION, 1, cubic(odd, 2)},
                                {NKW_CLIP_ROTATION, 2, cubic(odd, 2)}};
    const nkw_clip_source source = {tracks, 3, 3, 0, {NULL, 0}, NULL, NKW_CLIP_FLOAT32, NULL};
    const nkw_bytes_span whole = {block, sizeof block}, none = {NULL, 0};
    assert_int_equal(nkw_clip_build(&source, none, &bytes, &bad, work), NKW_TOO_SMALL);
    assert_true(bytes <= sizeof block && bad == 0);
    assert_int_equal(nkw_clip_build(&source, whole, &bytes, &bad, work), NKW_OK);
    assert_int_equal(bad, 2);
    tracks[1].track.values = tracks[2].track.values = even;
    assert_int_equal(nkw_clip_build(&source, whole, &bytes, &bad, work), NKW_OK);
    assert_int_equal(bad, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_negated_key_sends_cubicspline_the_long_way),
        cmocka_unit_test(the_build_of_a_clip_tells_of_long_arcs),
        cmocka_unit_test(aligned_keys_have_no_long_arcs_and_the_same_rotations),
        cmocka_unit_test(signs_of_triples_do_not_change_the_aligned_curve),
        cmocka_unit_test(linear_tracks_keep_their_rotations),
        cmocka_unit_test(other_tracks_are_copied_or_refused),
        cmocka_unit_test(keys_of_all_modes_are_aligned),
    };
    return cmocka_run_group_tests_name("track_align", tests, NULL, NULL);
}
