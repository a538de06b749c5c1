/* SPDX-License-Identifier: MIT */
/* Short chains that are reduced: distances in model space, of any scales and lengths of rotations; bytes. */
#include "support/clips.h"
#include "support/farthest.h"
#include "support/random.h"
#include "support/tracks.h"
#include "support/views.h"

/* A chain of a few joints: rotations, translations and scales of each, in this order, with the same keys. */
enum { LINKS = 3, LINK_TRACKS = 3 * LINKS, LINK_KEYS = 40 };
typedef struct chain {
    float times[LINK_KEYS], values[LINK_TRACKS][4 * LINK_KEYS];
    int32_t parents[LINKS];
    nkw_clip_track tracks[LINK_TRACKS];
    nkw_clip_source source;
} chain;

static double work[NKW_CLIP_REDUCE_WORK(LINK_TRACKS, LINKS, 0) / 8 + 2];
static float block[1 << 19], pose[NKW_POSE_FLOATS(LINKS)];

/* A waving chain with the scale `scale` of its root; lengths of rotations are 1 + `off` at every third key. */
static void draw_chain(random_source *r, size_t joints, size_t keys, nkw_vec3 scale, float off, chain *out)
{
    static const nkw_clip_target targets[3] = {NKW_CLIP_ROTATION, NKW_CLIP_TRANSLATION, NKW_CLIP_SCALE};
    const nkw_clip_source source = {out->tracks, 3 * joints, joints, 0, {NULL, 0}, NULL, NKW_CLIP_FLOAT32, NULL};
    for (size_t k = 0; k < keys; k++)
        out->times[k] = (float)k / 30.0f;
    for (size_t i = 0; i < 3 * joints; i++) {
        const nkw_clip_track c = {targets[i % 3],
                                  (uint32_t)(i / 3),
                                  {out->times, out->values[i], keys, i % 3 ? 3 : 4,
                                   i % 3 ? NKW_TRACK_FLOATS : NKW_TRACK_ROTATION, NKW_INTERPOLATION_LINEAR, NULL}};
        out->tracks[i] = c;
        for (size_t k = 0; k < keys; k++) {
            float *v = out->values[i] + c.track.width * k, length = k % 3 == 1 ? 1.0f + off : 1.0f;
            nkw_vec3 w = {random_between(r, -0.3f, 0.3f), random_between(r, -0.3f, 0.3f),
                          random_between(r, -0.3f, 0.3f)};
            nkw_quat q = nkw_quat_scale(nkw_quat_exp(w), length);
            if (i % 3 == 0)
                memcpy(v, &q, sizeof q);
            else if (i % 3 == 1)
                v[0] = 1.0f + 0.01f * w.x, v[1] = 0.01f * w.y, v[2] = 0.01f * w.z;
            else
                v[0] = (i < 3 ? scale.x : 1.0f), v[1] = i < 3 ? scale.y : 1.0f, v[2] = i < 3 ? scale.z : 1.0f;
        }
        out->parents[i / 3] = (int32_t)(i / 3) - 1;
    }
    out->source = source;
}

static void chain_models(const chain *c, const nkw_clip *clip, float time, nkw_mat4 *models)
{
    const size_t joints = c->source.joint_count;
    const nkw_skeleton skeleton = {c->parents, joints};
    float sampled[NKW_POSE_FLOATS(LINKS)], none;
    nkw_pose_identity(pose_span(sampled, joints));
    for (size_t i = 0; !clip && i < 3 * joints; i++)
        track_sample_to(&c->tracks[i], time, joints, sampled, &none);
    if (clip)
        assert_int_equal(nkw_clip_sample(clip, time, NULL, pose_span(sampled, joints), NULL), NKW_OK);
    nkw_skeleton_models_from_pose(&skeleton, pose_view(sampled, joints), NULL, NULL, models);
}

/* Reduces a chain; the largest distance of points at `reach` in the space of the joints, at keys and half-way. */
static double reduced_chain(const chain *c, float tolerance, float distance, double reach, nkw_clip_reduced *reduced)
{
    const nkw_clip_reduction r = {c->parents, tolerance, distance, NULL, NULL, 0.0f};
    const size_t keys = c->tracks[0].track.count;
    double largest = 0.0;
    assert_int_equal(
        nkw_clip_reduce(&c->source, &r, bytes_span(block, sizeof block), reduced, NULL, work_in(work, sizeof work)),
        NKW_OK);
    for (size_t k = 0; k < 2 * keys - 1; k++) {
        float time = k % 2 ? nkw_lerp(c->times[k / 2], c->times[k / 2 + 1], 0.5f) : c->times[k / 2];
        nkw_mat4 got[LINKS], wanted_models[LINKS];
        chain_models(c, (const nkw_clip *)(const void *)block, time, got);
        chain_models(c, NULL, time, wanted_models);
        for (size_t j = 0; j < c->source.joint_count; j++)
            largest = fmax(largest, farthest_distance(&got[j], &wanted_models[j], reach));
    }
    return largest;
}

/* Keys of 1e-3 off unit are |q|^2 times a rotation in model space; they are stored as they are where that is seen. */
static void lengths_of_rotations_count(void **state)
{
    static chain c;
    random_source random = random_from(31);
    const nkw_vec3 one = {1.0f, 1.0f, 1.0f};
    const float known[12] = {0, 0, 0, 1, 0, 0.7087f, 0, 0.7087f, 0, 0, 0, 1};
    nkw_clip_reduced reduced;
    (void)state;
    draw_chain(&random, 1, 3, one, 0.0f, &c);
    memcpy(c.values[0], known, sizeof known);
    assert_true(reduced_chain(&c, 1e-4f, 0.1f, 0.1, &reduced) <= 1e-4 * (1.0 + 1e-4));
    for (int i = 0; i < 20; i++) {
        const float tolerance = i % 2 ? 1e-4f : 3e-3f;
        draw_chain(&random, LINKS, LINK_KEYS, one, i < 10 ? 1e-3f : 9e-3f, &c);
        double largest = reduced_chain(&c, tolerance, 0.1f, 0.1, &reduced);
        assert_true(largest <= (double)tolerance + 1e-6 && largest >= (double)reduced.distance - 1e-6);
    }
    draw_chain(&random, LINKS, LINK_KEYS, one, 1e-3f, &c); /* at this tolerance it is not seen */
    reduced_chain(&c, 0.05f, 0.1f, 0.1, &reduced);
    assert_int_equal(reduced.packed_count + reduced.constant_count, LINK_TRACKS);
}

/* Constant keys keep their length, too. */
static void a_constant_rotation_keeps_its_length(void **state)
{
    static chain c;
    random_source random = random_from(32);
    const nkw_vec3 one = {1.0f, 1.0f, 1.0f};
    const nkw_quat q = {0.0f, 0.7087f, 1e-7f, 0.7087f};
    nkw_clip_reduced reduced;
    (void)state;
    draw_chain(&random, LINKS, LINK_KEYS, one, 0.0f, &c);
    for (size_t k = 0; k < LINK_KEYS; k++) {
        const nkw_quat noisy = {q.x, q.y, k % 2 ? q.z : 0.0f, q.w};
        memcpy(c.values[0] + 4 * k, &noisy, sizeof noisy);
    }
    assert_true(reduced_chain(&c, 1e-3f, 0.1f, 0.1, &reduced) <= 1e-3 + 1e-6);
    nkw_clip_sample((const nkw_clip *)(const void *)block, 0.5f, NULL, pose_span(pose, LINKS), NULL);
    nkw_quat got = nkw_pose_get(pose_view(pose, LINKS), 0).rotation;
    assert_true(fabsf(nkw_quat_length(got) - nkw_quat_length(q)) < 1e-6f);
    assert_int_equal(reduced.constant_count, LINKS + 1);
}

/* The unit of `distance` is that of the translations: an armature of scale 0.01 has its points at 100 times `distance`. */
static void the_distance_is_in_model_space_whatever_the_scale(void **state)
{
    static chain c;
    random_source random = random_from(33);
    const float scales[4] = {0.01f, 0.1f, 1.0f, 30.0f};
    (void)state;
    for (int i = 0; i < 20; i++) {
        const float s = scales[i % 4], tolerance = (i < 10 ? 1e-3f : 1e-4f) * (s > 1.0f ? s : 1.0f);
        const nkw_vec3 scale = {s, s, s};
        nkw_clip_reduced reduced;
        draw_chain(&random, LINKS, LINK_KEYS, scale, 0.0f, &c);
        double largest = reduced_chain(&c, tolerance, 0.3f, 0.3 / (double)s, &reduced);
        assert_true(largest <= (double)tolerance * (1.0 + 1e-3) && largest >= 0.99 * (double)reduced.distance);
    }
}

/* Points n[c] distance/s[c] of a joint of scale s: those of the unit sphere n in a joint whose scale is 1. */
static void each_axis_has_its_own_scale(void **state)
{
    static chain c;
    random_source random = random_from(34);
    (void)state;
    for (int i = 0; i < 10; i++) {
        const nkw_vec3 scale = {0.01f, 1.0f, i < 5 ? 5.0f : 0.0f};
        const nkw_mat4 unit = {{100.0f, 0, 0, 0, 0, 1.0f, 0, 0, 0, 0, i < 5 ? 0.2f : 1.0f, 0, 0, 0, 0, 1.0f}};
        nkw_clip_reduced reduced;
        draw_chain(&random, 1, LINK_KEYS, scale, 0.0f, &c);
        reduced_chain(&c, 1e-3f, 0.3f, 0.3, &reduced);
        double largest = 0.0;
        for (size_t k = 0; k < 2 * LINK_KEYS - 1; k++) {
            float time = k % 2 ? nkw_lerp(c.times[k / 2], c.times[k / 2 + 1], 0.5f) : c.times[k / 2];
            nkw_mat4 a, b;
            chain_models(&c, (const nkw_clip *)(const void *)block, time, &a);
            chain_models(&c, NULL, time, &b);
            a = nkw_mat4_mul(&a, &unit), b = nkw_mat4_mul(&b, &unit);
            largest = fmax(largest, farthest_distance(&a, &b, 0.3));
        }
        assert_true(largest <= 1e-3 + 1e-6 && largest >= 0.99 * (double)reduced.distance);
    }
}

static size_t bytes_of(const nkw_clip_source *source, nkw_clip_format format)
{
    nkw_clip_source s = *source;
    s.format = format;
    return clip_size_of(&s);
}

/* A clip of few keys is smaller as floats, or in 16 bits where their error is within the tolerance. */
static void a_reduced_clip_is_never_larger_than_one_of_floats_or_16_bits(void **state)
{
    static chain c;
    random_source random = random_from(35);
    const nkw_vec3 one = {1.0f, 1.0f, 1.0f};
    (void)state;
    for (size_t joints = 1; joints <= LINKS; joints++)
        for (size_t keys = 1; keys <= LINK_KEYS; keys += keys < 10 ? 1 : 10)
            for (int i = 0; i < 4; i++) {
                const float tolerances[4] = {1e-8f, 1e-4f, 1e-2f, 0.3f};
                nkw_clip_reduced reduced;
                draw_chain(&random, joints, keys, one, 0.0f, &c);
                double largest = reduced_chain(&c, tolerances[i], 0.1f, 0.1, &reduced);
                assert_true(reduced.share <= 1.0f && largest <= (double)tolerances[i] * (1.0 + 1e-4) + 3e-7);
                assert_true(reduced.bytes <= bytes_of(&c.source, NKW_CLIP_FLOAT32));
                assert_true(bytes_of(&c.source, NKW_CLIP_UNORM16) <= bytes_of(&c.source, NKW_CLIP_FLOAT32));
                if (i >= 2) /* 16 bits are within 1e-3 rad of each of three joints */
                    assert_true(reduced.bytes <= bytes_of(&c.source, NKW_CLIP_UNORM16));
            }
}

/* Steps below the rounding of the base: a knot may not be -1, which no unsigned number is. */
static void steps_below_the_rounding_of_floats_have_knots(void **state)
{
    static chain c;
    random_source random = random_from(36);
    const nkw_vec3 one = {1.0f, 1.0f, 1.0f};
    const float known[12] = {0.392556012f, 0.6094625f,   0.430625021f, 0.537603259f, 0.363504171f, 0.622943103f,
                             0.450217247f, 0.526413381f, 0.385836065f, 0.606550872f, 0.456118762f, 0.524578154f};
    nkw_clip_reduced reduced;
    (void)state;
    draw_chain(&random, 1, 3, one, 0.0f, &c);
    memcpy(c.values[0], known, sizeof known);
    assert_true(reduced_chain(&c, 5.81872825e-08f, 1.0f, 1.0, &reduced) < 3e-7);
    for (int i = 0; i < 50; i++) {
        draw_chain(&random, LINKS, LINK_KEYS, one, 0.0f, &c);
        assert_true(reduced_chain(&c, random_between(&random, 1e-8f, 1e-6f), 1.0f, 1.0, &reduced) < 4e-6);
        assert_true(reduced.share <= 1.0f);
    }
}

/* From -3e38 to 3e38: a range that no float is. */
static void ranges_that_overflow_are_stored_as_floats(void **state)
{
    static chain c;
    random_source random = random_from(37);
    const nkw_vec3 one = {1.0f, 1.0f, 1.0f};
    (void)state;
    for (int i = 0; i < 8; i++) {
        nkw_clip_reduced reduced;
        nkw_pose_span span = {pose, LINKS};
        draw_chain(&random, LINKS, LINK_KEYS, one, 0.0f, &c);
        for (size_t k = 0; k < LINK_KEYS; k++)
            c.values[1][3 * k] = 3e38f * ((float)k / 20.0f - 1.0f);
        for (size_t k = 0; k < LINK_KEYS && i % 2; k++)
            c.values[7][3 * k] = 1e38f * (float)(k % 2);
        const nkw_clip_reduction r = {c.parents, i < 4 ? 1e35f : 1e-3f, 0.1f, NULL, NULL, 0.0f};
        assert_int_equal(
            nkw_clip_reduce(&c.source, &r, bytes_span(block, sizeof block), &reduced, NULL, work_in(work, sizeof work)),
            NKW_OK);
        assert_true(reduced.share <= 1.0f);
        for (size_t k = 0; k < 2 * LINK_KEYS - 1; k++) {
            float time = 0.5f * (c.times[k / 2] + c.times[(k + 1) / 2]), want_value[3];
            nkw_clip_sample((const nkw_clip *)(const void *)block, time, NULL, span, NULL);
            nkw_track_sample(&c.tracks[1].track, time, NULL, want_value);
            assert_true(fabs((double)pose[0] - (double)want_value[0]) <= (double)r.tolerance);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lengths_of_rotations_count),
        cmocka_unit_test(a_constant_rotation_keeps_its_length),
        cmocka_unit_test(the_distance_is_in_model_space_whatever_the_scale),
        cmocka_unit_test(each_axis_has_its_own_scale),
        cmocka_unit_test(a_reduced_clip_is_never_larger_than_one_of_floats_or_16_bits),
        cmocka_unit_test(steps_below_the_rounding_of_floats_have_knots),
        cmocka_unit_test(ranges_that_overflow_are_stored_as_floats),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
