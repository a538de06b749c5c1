/* SPDX-License-Identifier: MIT */
/* Fingerprints: XXH64 of the words, and what they leave out. */
#include <math.h>

#include "mixer_scene.h"
#include "support/expect.h"

#define SEED UINT64_C(0x0123456789abcdef)

/* XXH64 of the floats 0.5 i - 3 by a program of its own after the specification, and by xxhash-wasm 1.1.0. */
static const struct known {
    size_t count;
    uint64_t of, from_seed;
} known[] = {
    {0, UINT64_C(0xef46db3751d8e999), UINT64_C(0x51e24c0e9077a48c)},
    {1, UINT64_C(0x477a7e4f0e7690dd), UINT64_C(0xf88707544efc4196)},
    {2, UINT64_C(0x909ae08e5f809693), UINT64_C(0x5f31a532705c0cb0)},
    {3, UINT64_C(0x926982c891362c8c), UINT64_C(0xa239c80347c31848)},
    {7, UINT64_C(0x5c7443f8463ac947), UINT64_C(0x7f34b2eacd5dde43)},
    {8, UINT64_C(0xc91c2a4007dc13d0), UINT64_C(0x67a23bb9edfc2477)},
    {9, UINT64_C(0x1e54ca1d41e5e76a), UINT64_C(0xbe61eaa242880ebd)},
    {31, UINT64_C(0xbe1b20085d030233), UINT64_C(0xf57762c85b1dec1d)},
    {64, UINT64_C(0x231988628138411c), UINT64_C(0x76562c0e299f961c)},
    {65, UINT64_C(0x2f366c8ee85a591d), UINT64_C(0x28064fd3468bb4e0)},
    {200, UINT64_C(0xc6bbf7f4d221c22f), UINT64_C(0xdbc8d246b39c4229)},
};

static void floats_have_the_hash_of_the_specification(void **state)
{
    (void)state;
    float values[200];
    for (size_t i = 0; i < 200; i++)
        values[i] = 0.5f * (float)i - 3.0f;
    for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
        assert_true(nkw_fingerprint_floats(values, known[k].count, 0) == known[k].of);
        assert_true(nkw_fingerprint_floats(values, known[k].count, SEED) == known[k].from_seed);
    }
}

static void zeros_differ_by_sign_and_every_nan_is_the_same(void **state)
{
    (void)state;
    const float zero = 0.0f, negative = -0.0f;
    assert_true(nkw_fingerprint_floats(&zero, 1, 0) == UINT64_C(0x3aefa6fd5cf2deb4));
    assert_true(nkw_fingerprint_floats(&negative, 1, 0) == UINT64_C(0x822e51211bf08373));
    const uint32_t nans[] = {0x7fc00000, 0xffc00000, 0x7f800001, 0xffffffff};
    for (size_t k = 0; k < 4; k++) {
        const float nan = float_of(nans[k]);
        assert_true(nkw_fingerprint_floats(&nan, 1, 0) == UINT64_C(0xd65166e46df1863e));
    }
    const float infinite[] = {float_of(0x7f800000), float_of(0xff800000)};
    assert_true(nkw_fingerprint_floats(infinite, 1, 0) != nkw_fingerprint_floats(infinite + 1, 1, 0));
}

enum { JOINTS = 3 };

static void a_pose_is_its_ten_arrays_without_padding(void **state)
{
    (void)state;
    float data[NKW_POSE_FLOATS(JOINTS)];
    for (size_t i = 0; i < NKW_POSE_FLOATS(JOINTS); i++)
        data[i] = (float)(i / NKW_POSE_STRIDE(JOINTS)) + 0.25f * (float)(i % NKW_POSE_STRIDE(JOINTS));
    const uint64_t known_pose = UINT64_C(0x56755e0fb8f0975b);
    assert_true(nkw_pose_fingerprint(pose_view(data, JOINTS), 0) == known_pose);
    for (size_t i = 0; i < NKW_POSE_FLOATS(JOINTS); i++) {
        const float kept = data[i];
        const int is_padding = i % NKW_POSE_STRIDE(JOINTS) >= JOINTS;
        data[i] = nextafterf(kept, INFINITY);
        assert_true((nkw_pose_fingerprint(pose_view(data, JOINTS), 0) == known_pose) == is_padding);
        data[i] = kept;
    }
    assert_true(nkw_pose_fingerprint(pose_view(data, 0), 0) != known_pose);
}

/* ---- Mixers ---- */

static mixer_scene scene, other;

static uint64_t of_state(const mixer_scene *s)
{
    return nkw_mixer_fingerprint(&s->mixer, s->poses, MIXER_JOINTS, 0);
}

static void a_mixer_of_zeros_has_the_hash_of_eight_words(void **state)
{
    (void)state;
    static const nkw_mixer none;
    const float zeros[9] = {0};
    assert_true(nkw_mixer_fingerprint(&none, NULL, 0, SEED) == nkw_fingerprint_floats(zeros, 8, SEED));
    assert_true(nkw_mixer_fingerprint(&none, NULL, 0, SEED) != nkw_fingerprint_floats(zeros, 9, SEED));
}

/* Two machines: one has other memory in all that is left out. Their frames and fingerprints are the same. */
static void what_is_left_out_changes_no_frame(void **state)
{
    (void)state;
    random_source r = random_from(3), noise = random_from(4);
    mixer_scene_draw(&scene, &r, 7);
    for (int frame = 0; frame < 3000; frame++) {
        mixer_scene_act(&scene, &r);
        other = scene;
        other.set.clips = scene.clips;
        other.frame.pose.data = other.pose;
        other.frame.floats = other.floats;
        other.frame.poses = other.poses;
        other.frame.events = other.events;
        nkw_mixer *m = &other.mixer;
        for (size_t i = 0; i < NKW_MIXER_SLOTS; i++)
            if (!m->slot[i].playing || i >= m->slot_count) {
                m->slot[i].time = random_unit(&noise);
                m->slot[i].motion = nkw_trs_identity();
                m->slot[i].clip = (uint32_t)random_bits(&noise);
            }
        if (m->transition == NKW_MIXER_CROSS_FADE)
            m->elapsed = m->duration = random_unit(&noise);
        for (size_t i = 0; i < NKW_MIXER_POSES_FLOATS(MIXER_JOINTS); i++) {
            const size_t row = i / NKW_POSE_STRIDE(MIXER_JOINTS);
            const int is_kept = row < 20 ? m->shown > 1 || (m->shown == 1 && row / 10 == m->shown_at)
                                         : m->transition != NKW_MIXER_CROSS_FADE && !m->pending;
            if (!is_kept || i % NKW_POSE_STRIDE(MIXER_JOINTS) >= MIXER_JOINTS)
                other.poses[i] = random_unit(&noise);
        }
        assert_true(of_state(&scene) == of_state(&other));
        const double seconds = (double)random_unit(&r) / 16.0;
        assert_int_equal(mixer_scene_advance(&scene, seconds), mixer_scene_advance(&other, seconds));
        assert_true(nkw_pose_fingerprint(pose_view(scene.pose, MIXER_JOINTS), 0) ==
                    nkw_pose_fingerprint(pose_view(other.pose, MIXER_JOINTS), 0));
    }
}

#define EXPECT_SEEN(member)                                                                                            \
    do {                                                                                                               \
        other = scene;                                                                                                 \
        unsigned char *byte = (unsigned char *)&other.mixer.member;                                                    \
        *byte ^= 1;                                                                                                    \
        assert_true(of_state(&other) != of_state(&scene));                                                             \
    } while (0)

static void every_number_of_a_playing_slot_is_seen(void **state)
{
    (void)state;
    random_source r = random_from(5);
    mixer_scene_draw(&scene, &r, 7);
    nkw_mixer_options o = {0};
    assert_int_equal(nkw_mixer_play(&scene.mixer, &scene.set, &o, NULL), NKW_OK);
    assert_int_equal(mixer_scene_advance(&scene, 0.125), NKW_OK);
    assert_int_equal(mixer_scene_advance(&scene, 0.125), NKW_OK);
    o.transition = NKW_MIXER_INERTIA;
    o.fade = 1.0f;
    assert_int_equal(nkw_mixer_play(&scene.mixer, &scene.set, &o, NULL), NKW_OK);
    EXPECT_SEEN(pending);
    assert_int_equal(mixer_scene_advance(&scene, 0.125), NKW_OK);
    EXPECT_SEEN(slot[1].time);
    EXPECT_SEEN(slot[1].fade.elapsed);
    EXPECT_SEEN(slot[1].fade.duration);
    EXPECT_SEEN(slot[1].fade.from);
    EXPECT_SEEN(slot[1].fade.to);
    EXPECT_SEEN(slot[1].cycle);
    EXPECT_SEEN(slot[1].motion);
    EXPECT_SEEN(slot[1].first.rotation.w);
    EXPECT_SEEN(slot[1].last.scale.z);
    EXPECT_SEEN(slot[1].weight);
    EXPECT_SEEN(slot[1].speed);
    EXPECT_SEEN(slot[1].clip);
    EXPECT_SEEN(slot[1].mask);
    EXPECT_SEEN(slot[1].layer);
    EXPECT_SEEN(slot[1].group);
    EXPECT_SEEN(slot[1].sync);
    EXPECT_SEEN(slot[1].mode);
    EXPECT_SEEN(slot[1].blend);
    EXPECT_SEEN(elapsed);
    EXPECT_SEEN(duration);
    EXPECT_SEEN(step);
    EXPECT_SEEN(transition);
}

static void every_float_of_the_poses_in_use_is_seen(void **state)
{
    (void)state;
    const uint64_t before = of_state(&scene);
    for (size_t c = 0; c < 50; c++)
        for (size_t j = 0; j < MIXER_JOINTS; j++) {
            float *at = &scene.poses[c * NKW_POSE_STRIDE(MIXER_JOINTS) + j];
            const float kept = *at;
            *at = kept + 1.0f;
            assert_true(of_state(&scene) != before);
            *at = kept;
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(floats_have_the_hash_of_the_specification),
        cmocka_unit_test(zeros_differ_by_sign_and_every_nan_is_the_same),
        cmocka_unit_test(a_pose_is_its_ten_arrays_without_padding),
        cmocka_unit_test(a_mixer_of_zeros_has_the_hash_of_eight_words),
        cmocka_unit_test(what_is_left_out_changes_no_frame),
        cmocka_unit_test(every_number_of_a_playing_slot_is_seen),
        cmocka_unit_test(every_float_of_the_poses_in_use_is_seen),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
