/* SPDX-License-Identifier: MIT */
/* Clips whose keys are reduced within a tolerance in model space. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "random.h"
#include "support/expect.h"
#include "support/farthest.h"
#include "support/tracks.h"
#include "support/views.h"

#define JOINTS 10
#define KEYS   121
#define TRACKS (2 * JOINTS + 1)
#define FLOATS 2
#define SKIN   0.25f

static struct {
    float times[KEYS], values[TRACKS][4 * KEYS];
    int32_t parents[JOINTS];
    nkw_clip_track tracks[TRACKS];
    nkw_clip_source source;
} drawn;
static double work[NKW_CLIP_REDUCE_WORK(TRACKS, JOINTS, FLOATS) / 8 + 2], block[1 << 15];

/* A chain of joints 1 apart. All rotate; the root also moves; the other translations are constant. */
static int draw(void **state)
{
    (void)state;
    const nkw_clip_source source = {drawn.tracks, TRACKS, JOINTS, FLOATS, {NULL, 0}, NULL, NKW_CLIP_FLOAT32, NULL};
    for (size_t k = 0; k < KEYS; k++)
        drawn.times[k] = nkw_timeline_time((nkw_timeline){0.0f, 30.0f, 0}, k);
    for (size_t i = 0; i < TRACKS; i++) {
        const nkw_clip_target target = i == TRACKS - 1 ? NKW_CLIP_FLOATS : (nkw_clip_target)(i % 2);
        const size_t width = target == NKW_CLIP_ROTATION ? 4 : target == NKW_CLIP_FLOATS ? FLOATS : 3;
        const nkw_clip_track whole = {target,
                                      i == TRACKS - 1 ? 0 : (uint32_t)(i / 2),
                                      {drawn.times, drawn.values[i], KEYS, width,
                                       target == NKW_CLIP_ROTATION ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS,
                                       NKW_INTERPOLATION_LINEAR, NULL}};
        drawn.tracks[i] = whole;
        for (size_t k = 0; k < KEYS; k++) {
            const float x = 0.05f * (float)k + (float)i, wave = nkw_sin(x);
            const nkw_vec3 axis = {i % 4 == 1 ? 1.0f : 0.0f, i % 4 == 1 ? 0.0f : 1.0f, 0.0f};
            const nkw_quat q = nkw_quat_from_axis_angle(axis, 0.4f * wave);
            float *v = drawn.values[i] + width * k;
            v[0] = i == 0 ? wave : i == TRACKS - 1 ? 0.5f * wave : 1.0f;
            v[1] = 0.0f;
            if (width == 3)
                v[2] = i == 0 ? 0.3f * wave * wave : 0.0f;
            if (target == NKW_CLIP_ROTATION)
                memcpy(v, &q, sizeof q);
        }
    }
    for (size_t j = 0; j < JOINTS; j++)
        drawn.parents[j] = (int32_t)j - 1;
    drawn.source = source;
    return 0;
}

static nkw_clip_reduction within(float tolerance)
{
    const nkw_clip_reduction r = {drawn.parents, tolerance, SKIN, NULL, NULL, 1e-3f};
    return r;
}

static nkw_clip_source reduce(const nkw_clip_reduction *r, nkw_reduced *reduced)
{
    const nkw_work room = work_in(work, sizeof work);
    nkw_clip_source_reduced out;
    size_t bad = 9;
    assert_int_equal(nkw_clip_source_reduce(&drawn.source, r, bytes_span(NULL, 0), &out, &bad, room), NKW_TOO_SMALL);
    assert_true(out.bytes > 0 && out.bytes <= sizeof block && out.source.track_count == 0);
    assert_int_equal(nkw_clip_source_reduce(&drawn.source, r, bytes_span(block, out.bytes), &out, &bad, room), NKW_OK);
    assert_int_equal(bad, 0);
    *reduced = out.reached;
    return out.source;
}

static void models_at(const nkw_clip_source *s, float time, nkw_mat4 *models, float *floats)
{
    static float pose[NKW_POSE_FLOATS(JOINTS)];
    const nkw_skeleton skeleton = {drawn.parents, JOINTS};
    nkw_pose_identity(pose_span(pose, JOINTS));
    for (size_t i = 0; i < s->track_count; i++)
        track_sample_to(&s->tracks[i], time, JOINTS, pose, floats);
    nkw_skeleton_models_from_pose(&skeleton, pose_view(pose, JOINTS), NULL, NULL, models);
}

/* The largest distance of each joint at 8 times of each segment. */
static void distances(const nkw_clip_source *out, float largest[JOINTS], float *of_floats)
{
    static nkw_mat4 a[JOINTS], b[JOINTS];
    float x[FLOATS], y[FLOATS];
    memset(largest, 0, JOINTS * sizeof *largest);
    *of_floats = 0.0f;
    for (int n = 0; n < 8 * (KEYS - 1); n++) {
        const float time = (float)n / 240.0f;
        models_at(&drawn.source, time, a, x);
        models_at(out, time, b, y);
        for (size_t j = 0; j < JOINTS; j++)
            largest[j] = fmaxf(largest[j], (float)farthest_distance(&a[j], &b[j], (double)SKIN));
        *of_floats = fmaxf(*of_floats, fmaxf(fabsf(x[0] - y[0]), fabsf(x[1] - y[1])));
    }
}

static float largest_of(const float *x, size_t n)
{
    float largest = 0.0f;
    for (size_t i = 0; i < n; i++)
        largest = fmaxf(largest, x[i]);
    return largest;
}

static size_t keys_of(const nkw_clip_source *s)
{
    size_t keys = 0;
    for (size_t i = 0; i < s->track_count; i++)
        keys += s->tracks[i].track.count;
    return keys;
}

static void the_error_reached_is_measured_in_model_space(void **state)
{
    (void)state;
    const float tolerances[4] = {1e-3f, 1e-2f, 0.1f, 1.0f};
    size_t before = TRACKS * KEYS;
    for (int i = 0; i < 4; i++) {
        const nkw_clip_reduction r = within(tolerances[i]);
        nkw_reduced reduced;
        const nkw_clip_source out = reduce(&r, &reduced);
        float largest[JOINTS], of_floats;
        distances(&out, largest, &of_floats);
        const float worst = largest_of(largest, JOINTS);
        assert_true(worst <= tolerances[i]);
        assert_true(reduced.distance <= tolerances[i]);
        expect_near(reduced.distance, worst, 0.03 * worst);
        assert_true(of_floats <= 1e-3f + 1e-6f);
        expect_near(reduced.floats, of_floats, 2e-5);
        expect_near(reduced.share, fmax(reduced.distance / tolerances[i], reduced.floats / 1e-3f), 1e-5);
        assert_int_equal(reduced.source_key_count, TRACKS * KEYS);
        assert_int_equal(reduced.key_count, keys_of(&out));
        assert_true(reduced.key_count < before);
        assert_true(reduced.distance > 0.3f * tolerances[i]); /* the tolerance is used */
        before = reduced.key_count;
    }
}

/* The same keys removed track by track, at the angle that moves the last joint by the tolerance, exceed it. */
static void errors_of_a_chain_add_up_without_the_hierarchy(void **state)
{
    (void)state;
    nkw_clip_reduction r = within(0.01f), alone = r;
    nkw_reduced chain, roots;
    float largest[JOINTS], of_floats;
    alone.parents = NULL;
    const nkw_clip_source out = reduce(&alone, &roots);
    distances(&out, largest, &of_floats);
    assert_true(largest[JOINTS - 1] > 0.03f);
    reduce(&r, &chain);
    assert_true(chain.key_count > roots.key_count);
}

static void each_joint_may_have_its_own_tolerance(void **state)
{
    (void)state;
    float tolerances[JOINTS], skin[JOINTS], largest[JOINTS], of_floats;
    for (size_t j = 0; j < JOINTS; j++) {
        tolerances[j] = j == JOINTS - 1 ? 1e-3f : 0.5f;
        skin[j] = SKIN;
    }
    nkw_clip_reduction r = within(0.0f);
    r.tolerances = tolerances;
    r.distances = skin;
    nkw_reduced reduced;
    const nkw_clip_source out = reduce(&r, &reduced);
    distances(&out, largest, &of_floats);
    for (size_t j = 0; j < JOINTS; j++)
        assert_true(largest[j] <= tolerances[j]);
    assert_true(reduced.share <= 1.0f);
}

static void a_tolerance_of_zero_is_lossless(void **state)
{
    (void)state;
    nkw_clip_reduction r = within(0.0f);
    r.float_tolerance = 0.0f;
    nkw_reduced reduced;
    const nkw_clip_source out = reduce(&r, &reduced);
    float largest[JOINTS], of_floats;
    distances(&out, largest, &of_floats);
    expect_bits(largest_of(largest, JOINTS), 0.0f);
    expect_bits(reduced.distance, 0.0f);
    expect_bits(reduced.share, 0.0f);
    for (size_t i = 0; i < TRACKS; i++) /* translations except the first are constant */
        assert_true(out.tracks[i].track.count == (i % 2 == 0 && i > 0 && i < TRACKS - 1 ? 2 : KEYS));
}

static void the_difference_of_reduced_tracks_is_the_error_that_was_reached(void **state)
{
    (void)state;
    const nkw_clip_reduction r = within(0.02f);
    nkw_reduced reduced, measured;
    const nkw_clip_source out = reduce(&r, &reduced);
    const nkw_work room = work_in(work, sizeof work);
    assert_int_equal(nkw_clip_source_difference(&drawn.source, &out, &r, &measured, room), NKW_OK);
    expect_bits(measured.distance, reduced.distance);
    expect_bits(measured.share, reduced.share);
    assert_int_equal(measured.key_count, reduced.key_count);
    assert_int_equal(nkw_clip_source_difference(&drawn.source, &drawn.source, &r, &measured, room), NKW_OK);
    expect_bits(measured.distance, 0.0f);
    nkw_clip_source other = out;
    other.joint_count++;
    assert_int_equal(nkw_clip_source_difference(&drawn.source, &other, &r, &measured, room), NKW_TOO_SMALL);
    other.joint_count = JOINTS;
    other.float_count = 0;
    other.track_count--;
    assert_int_equal(nkw_clip_source_difference(&drawn.source, &other, &r, &measured, room), NKW_MISMATCHED);
}

/* An equal change of all three scales moves all points around a joint equally far, in every direction. */
static void equal_scales_move_all_directions_equally(void **state)
{
    (void)state;
    random_source r = random_from(8);
    NKW_STACK_WORK(room, NKW_CLIP_REDUCE_WORK(2, 1, 0));
    const float zero = 0.0f;
    for (int i = 0; i < 5000; i++) {
        float scales[2], values[2][3], turn[4] = {0.0f, 0.0f, 0.0f, 1.0f};
        nkw_quat q = random_rotation(&r);
        if (i % 2)
            memcpy(turn, &q, sizeof turn);
        nkw_clip_track tracks[2][2];
        nkw_clip_source sources[2];
        for (int k = 0; k < 2; k++) {
            scales[k] = random_between(&r, 0.5f, 2.0f);
            values[k][0] = values[k][1] = values[k][2] = scales[k];
            const nkw_clip_track scale = {
                NKW_CLIP_SCALE, 0, {&zero, values[k], 1, 3, NKW_TRACK_FLOATS, NKW_INTERPOLATION_STEP, NULL}};
            const nkw_clip_track rotation = {
                NKW_CLIP_ROTATION, 0, {&zero, turn, 1, 4, NKW_TRACK_ROTATION, NKW_INTERPOLATION_STEP, NULL}};
            tracks[k][0] = scale, tracks[k][1] = rotation;
            const nkw_clip_source source = {tracks[k], 2, 1, 0, {NULL, 0}, NULL, NKW_CLIP_FLOAT32, NULL};
            sources[k] = source;
        }
        const nkw_clip_reduction reduction = {NULL, 1.0f, 3.0f, NULL, NULL, 0.0f};
        nkw_reduced d;
        assert_int_equal(nkw_clip_source_difference(&sources[0], &sources[1], &reduction, &d, room), NKW_OK);
        const double want = 3.0 * fabs((double)scales[1] - (double)scales[0]) / (double)scales[0];
        expect_near(d.distance, want, 2e-6 * want + 1e-6);
    }
}

static void wrong_sources_and_too_little_memory_are_refused(void **state)
{
    (void)state;
    nkw_clip_reduction r = within(0.01f);
    const size_t needed = NKW_CLIP_REDUCE_WORK(TRACKS, JOINTS, FLOATS);
    const nkw_work room = work_in(work, sizeof work), enough = {room.data, needed}, little = {room.data, needed - 1};
    nkw_clip_source_reduced out;
    const nkw_clip_source wrong = drawn.source, *s = &drawn.source;
    size_t bad = 0;
    assert_int_equal(nkw_clip_source_reduce(s, &r, bytes_span(NULL, 0), &out, NULL, little), NKW_TOO_SMALL);
    assert_int_equal(out.bytes, 0);
    assert_int_equal(nkw_clip_source_reduce(s, &r, bytes_span(NULL, 0), &out, NULL, enough), NKW_TOO_SMALL);
    const size_t bytes = out.bytes;
    const nkw_bytes_span whole = bytes_span(block, bytes);
    assert_int_equal(nkw_clip_source_reduce(s, &r, bytes_span(block, bytes - 1), &out, NULL, enough), NKW_TOO_SMALL);
    assert_true(out.source.track_count == 0 && out.bytes == bytes);
    assert_int_equal(nkw_clip_source_reduce(s, &r, whole, &out, NULL, enough), NKW_OK);
    r.tolerance = -1.0f;
    assert_int_equal(nkw_clip_source_reduce(s, &r, whole, &out, NULL, enough), NKW_OUT_OF_RANGE);
    r.tolerance = INFINITY;
    assert_int_equal(nkw_clip_source_reduce(s, &r, whole, &out, NULL, enough), NKW_NOT_FINITE);
    assert_int_equal(out.bytes, 0);
    r = within(0.01f);
    drawn.tracks[4].index = JOINTS;
    assert_int_equal(nkw_clip_source_reduce(&wrong, &r, whole, &out, &bad, enough), NKW_OUT_OF_RANGE);
    assert_int_equal(bad, 4);
    drawn.tracks[4].index = 2;
}

static void a_clip_without_tracks_has_none(void **state)
{
    (void)state;
    const nkw_clip_source nothing = {NULL, 0, 1, 0, {NULL, 0}, NULL, NKW_CLIP_FLOAT32, NULL};
    const nkw_clip_reduction r = {NULL, 1.0f, 1.0f, NULL, NULL, 1.0f};
    nkw_clip_source_reduced out;
    assert_int_equal(
        nkw_clip_source_reduce(&nothing, &r, bytes_span(block, sizeof block), &out, NULL, work_in(work, sizeof work)),
        NKW_OK);
    assert_int_equal(out.reached.key_count, 0);
    assert_int_equal(out.source.track_count, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_error_reached_is_measured_in_model_space),
        cmocka_unit_test(errors_of_a_chain_add_up_without_the_hierarchy),
        cmocka_unit_test(each_joint_may_have_its_own_tolerance),
        cmocka_unit_test(a_tolerance_of_zero_is_lossless),
        cmocka_unit_test(the_difference_of_reduced_tracks_is_the_error_that_was_reached),
        cmocka_unit_test(equal_scales_move_all_directions_equally),
        cmocka_unit_test(wrong_sources_and_too_little_memory_are_refused),
        cmocka_unit_test(a_clip_without_tracks_has_none),
    };
    return cmocka_run_group_tests(tests, draw, NULL);
}
