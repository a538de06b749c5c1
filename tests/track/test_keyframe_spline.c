/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "random.h"
#include "support/expect.h"

#define KEYS 9

static nkw_result trace_of(const nkw_keyframe *keys, size_t count, float time, nkw_position_method position,
                           nkw_orientation_method orientation, nkw_keyframe_trace *trace)
{
    nkw_keyframe_options options = {position, orientation, NKW_KEYFRAME_RULE_LIBRARY};
    return nkw_keyframes_trace(keys, count, time, &options, trace);
}

static const struct {
    nkw_position_method position;
    nkw_spline_method spline;
} methods[] = {
    {NKW_POSITION_CENTRIPETAL, NKW_SPLINE_CENTRIPETAL},
    {NKW_POSITION_PCHIP, NKW_SPLINE_PCHIP},
    {NKW_POSITION_AKIMA, NKW_SPLINE_AKIMA},
    {NKW_POSITION_MAKIMA, NKW_SPLINE_MAKIMA},
};

#define METHODS (sizeof methods / sizeof methods[0])

/* Keys of uneven times, two of which are equal if there is a jump. */
static void draw(random_source *r, nkw_keyframe keys[KEYS], size_t jump)
{
    for (size_t k = 0; k < KEYS; k++) {
        keys[k].time = k ? keys[k - 1].time + (k == jump ? 0 : random_between(r, 0.125f, 2)) : random_between(r, -2, 2);
        keys[k].position = random_vec3(r, -4, 4);
        keys[k].orientation = random_rotation(r);
    }
}

static nkw_vec3 position(const nkw_keyframe *keys, size_t count, float time, nkw_position_method method)
{
    nkw_mat4 m = nkw_mat4_identity();
    assert_int_equal(nkw_keyframes_sample(keys, count, time, method, NKW_ORIENTATION_STEP, &m), NKW_OK);
    return nkw_mat4_translation(&m);
}

/* The CUBICSPLINE track of all keys. */
static nkw_vec3 by_track(const nkw_keyframe *keys, size_t count, float time, nkw_spline_method method)
{
    float times[KEYS], triples[9 * KEYS];
    nkw_vec3 at;
    nkw_track track = {times, triples, count, 3, NKW_TRACK_FLOATS, NKW_INTERPOLATION_CUBICSPLINE, NULL};
    nkw_spline spline = {times,  &keys[0].position.x,  count, 3,    sizeof(nkw_keyframe) / sizeof(float),
                         method, NKW_SPLINE_ENDS_FREE, 0,     NULL, NULL};
    nkw_tangent_span tangents = {triples, triples + 6, 9};
    for (size_t k = 0; k < count; k++) {
        times[k] = keys[k].time;
        memcpy(triples + 9 * k + 3, &keys[k].position, sizeof keys[k].position);
    }
    assert_int_equal(nkw_spline_tangents(&spline, tangents, NULL, (nkw_work){NULL, 0}), NKW_OK);
    nkw_track_sample(&track, time, NULL, &at.x);
    return at;
}

static void positions_have_the_bits_of_the_track_of_all_keys(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int i = 0; i < 300; i++) {
        nkw_keyframe keys[KEYS];
        size_t count = 1 + random_bits(&r) % KEYS;
        draw(&r, keys, i % 3 ? KEYS : 1 + random_bits(&r) % (KEYS - 1));
        for (size_t m = 0; m < METHODS; m++)
            for (int j = 0; j < 12; j++) {
                float time = nkw_lerp(keys[0].time - 1, keys[count - 1].time + 1, random_unit(&r));
                expect_vec3_bits(position(keys, count, time, methods[m].position),
                                 by_track(keys, count, time, methods[m].spline));
            }
    }
}

static void keys_come_back_bit_for_bit_at_their_own_time(void **state)
{
    (void)state;
    random_source r = random_from(2);
    nkw_keyframe keys[KEYS];
    draw(&r, keys, KEYS);
    for (int p = NKW_POSITION_STEP; p <= NKW_POSITION_MAKIMA; p++)
        for (size_t k = 0; k < KEYS; k++)
            expect_vec3_bits(position(keys, KEYS, keys[k].time, (nkw_position_method)p), keys[k].position);
}

static void step_next_holds_the_key_that_comes(void **state)
{
    (void)state;
    random_source r = random_from(3);
    nkw_keyframe keys[KEYS];
    nkw_keyframe_trace trace;
    draw(&r, keys, KEYS);
    for (size_t k = 0; k + 1 < KEYS; k++) {
        float within = 0.5f * (keys[k].time + keys[k + 1].time);
        expect_vec3_bits(position(keys, KEYS, within, NKW_POSITION_STEP_NEXT), keys[k + 1].position);
        trace_of(keys, KEYS, within, NKW_POSITION_STEP_NEXT, NKW_ORIENTATION_STEP, &trace);
        assert_int_equal(trace.control_count, 1);
        assert_int_equal(trace.key[0], k + 1);
    }
    expect_vec3_bits(position(keys, KEYS, keys[0].time - 1, NKW_POSITION_STEP_NEXT), keys[0].position);
    expect_vec3_bits(position(keys, KEYS, 1e9f, NKW_POSITION_STEP_NEXT), keys[KEYS - 1].position);
    expect_vec3_bits(position(keys, KEYS, NAN, NKW_POSITION_STEP_NEXT), keys[0].position);
    expect_vec3_bits(position(keys, 1, 0, NKW_POSITION_STEP_NEXT), keys[0].position);
}

/* Each coordinate stays between those of the two keys. */
static void pchip_stays_between_its_keys(void **state)
{
    (void)state;
    random_source r = random_from(4);
    for (int i = 0; i < 200; i++) {
        nkw_keyframe keys[KEYS];
        draw(&r, keys, KEYS);
        for (int j = 0; j < 40; j++) {
            size_t k = random_bits(&r) % (KEYS - 1);
            float time = nkw_lerp(keys[k].time, keys[k + 1].time, random_unit(&r));
            nkw_vec3 p = position(keys, KEYS, time, NKW_POSITION_PCHIP);
            nkw_vec3 low = nkw_vec3_min(keys[k].position, keys[k + 1].position),
                     high = nkw_vec3_max(keys[k].position, keys[k + 1].position);
            assert_true(p.x >= low.x - 2e-6f && p.y >= low.y - 2e-6f && p.z >= low.z - 2e-6f);
            assert_true(p.x <= high.x + 2e-6f && p.y <= high.y + 2e-6f && p.z <= high.z + 2e-6f);
        }
    }
}

static void keys_that_are_refused_have_no_tangents(void **state)
{
    (void)state;
    random_source r = random_from(5);
    nkw_keyframe keys[KEYS];
    draw(&r, keys, KEYS);
    keys[3].position.y = NAN;
    for (size_t m = 0; m < METHODS; m++) {
        float time = 0.5f * (keys[1].time + keys[2].time);
        float t = (time - keys[1].time) / (keys[2].time - keys[1].time);
        nkw_vec3 p = position(keys, KEYS, time, methods[m].position), zero = {0, 0, 0};
        expect_vec3_near(p, nkw_vec3_hermite(keys[1].position, zero, keys[2].position, zero, t), 1e-5);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(positions_have_the_bits_of_the_track_of_all_keys),
        cmocka_unit_test(keys_come_back_bit_for_bit_at_their_own_time),
        cmocka_unit_test(step_next_holds_the_key_that_comes),
        cmocka_unit_test(pchip_stays_between_its_keys),
        cmocka_unit_test(keys_that_are_refused_have_no_tangents),
    };
    return cmocka_run_group_tests_name("keyframe_spline", tests, NULL, NULL);
}
