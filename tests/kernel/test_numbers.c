/* SPDX-License-Identifier: MIT */
/* Numbers that pages state, computed; those of clips and files are in the tests of these. */
#include <math.h>

#include "support/expect.h"
#include "support/page.h"

#define DEGREES 57.295779513082321

static nkw_quat about_z(double angle)
{
    nkw_quat q = {0, 0, (float)sin(angle / 2), (float)cos(angle / 2)};
    return q;
}

/* The largest angle between slerp and nlerp, in degrees. */
static double largest_lag(double degrees)
{
    nkw_quat a = about_z(0), b = about_z(degrees / DEGREES);
    double largest = 0;
    for (int i = 0; i <= 1000; i++) {
        float t = (float)i / 1000;
        float angle = nkw_quat_angle(nkw_quat_slerp(a, b, t), nkw_quat_nlerp(a, b, t));
        largest = fmax(largest, DEGREES * (double)angle);
    }
    return largest;
}

static void nlerp_lags_behind_slerp(void **state)
{
    (void)state;
    expect_page("subjects/curve/curve.md",
                "The largest difference is %.1f° for a rotation of 45° between the keys, %.1f° for 90°, "
                "%.0f° for 180°.",
                largest_lag(45), largest_lag(90), largest_lag(179.999));
    expect_page("subjects/pose/blend.md", "For a quarter turn nlerp differs from it by at most %.2f degrees.",
                largest_lag(90));
}

/* The largest angle between the mean of two rotations and the normalised sum, over all weights; in degrees. */
static double sum_from_mean(double degrees)
{
    nkw_quat q[2] = {about_z(0), about_z(degrees / DEGREES)};
    double largest = 0;
    for (int i = 1; i < 1000; i++) {
        float weights[2] = {1 - (float)i / 1000, (float)i / 1000};
        nkw_quat sum = nkw_quat_nlerp(q[0], q[1], weights[1]);
        float angle = nkw_quat_angle(nkw_quat_mean(q, 2, weights), sum);
        largest = fmax(largest, DEGREES * (double)angle);
    }
    return largest;
}

static void the_sum_of_two_rotations_leaves_their_mean(void **state)
{
    (void)state;
    expect_page("subjects/math/value.md",
                "| largest angle between sum and mean | %.3f° | %.2f° | %.2f° | %.2f° | %.1f° | %.1f° | %.1f° |",
                sum_from_mean(10), sum_from_mean(30), sum_from_mean(45), sum_from_mean(60), sum_from_mean(90),
                sum_from_mean(120), sum_from_mean(150));
}

/* The distance from the exact place in a loop of 102 frames after so many hours at 60 frames per second, in seconds. */
static double lost(double at, int frame)
{
    double off = fabs(at - frame % 102 / 60.0);
    return fmin(off, fabs(off - 1.7));
}

static void play_heads_lose_their_place(void **state)
{
    (void)state;
    static const int hours[] = {1, 10, 24, 100};
    static const char *const names[] = {"1 hour", "10 hours", "24 hours", "100 hours"};
    const nkw_playback_range range = {0, 1.7, 0, NKW_PLAYBACK_LOOP, NKW_PLAYBACK_LOOP, 0, 0};
    const float dt = 1.0f / 60;
    float head = 0;
    int frame = 0;
    for (int i = 0; i < 4; i++) {
        double worst[3] = {0, 0, 0};
        for (; frame < hours[i] * 216000;) {
            head += dt;
            head = head >= 1.7f ? head - 1.7f : head;
            frame++;
            if (frame > hours[i] * 216000 - 6000) { /* the last 100 s */
                double time = frame / 60.0;
                double narrow = (double)nkw_playback_head(NKW_PLAYBACK_LOOP, 0, 1.7f, (float)time).time;
                worst[0] = fmax(worst[0], lost((double)head, frame));
                worst[1] = fmax(worst[1], lost(narrow, frame));
                worst[2] = fmax(worst[2], lost(nkw_playback_head_f64(&range, time).time, frame));
            }
        }
        expect_page("subjects/track/track.md", "| %s | %.*f ms | %.*f ms | %.0e s |", names[i], i == 0, 1000 * worst[0],
                    i < 3, 1000 * worst[1], worst[2]);
    }
}

/* The frames of the first 1999 whose rounded seconds, times the rate, are below them. */
static int frames_before(nkw_rate rate)
{
    int count = 0;
    for (int64_t frame = 1; frame < 2000; frame++) {
        int64_t got;
        double seconds;
        assert_int_equal(nkw_ticks_to_seconds(frame, rate, &seconds), NKW_OK);
        assert_int_equal(nkw_ticks_from_seconds(seconds, rate, NKW_ROUND_DOWN, &got),
                         NKW_OK);
        count += got < frame;
    }
    return count;
}

static void rounded_seconds_are_the_frame_before(void **state)
{
    (void)state;
    const nkw_rate ntsc = {30000, 1001}, pal = {25, 1};
    expect_page("subjects/track/track.md", "is the frame before for %d of the first 1999 frames at 30000/1001, and for %d of "
                                     "those at 25.", frames_before(ntsc), frames_before(pal));
}

/* From rest at 0 to a goal at 1: the largest distance from the exact solution within 2 s. */
static double step_off(nkw_spring s, int per_second, int closed)
{
    const float h = 1.0f / (float)per_second;
    const nkw_state start = {0, 0}, goal = {1, 0};
    nkw_state m = start;
    double x = 0, v = 0, largest = 0;
    for (int i = 1; i <= 2 * per_second; i++) {
        v += (double)h * ((double)s.stiffness * (1 - x) - (double)s.damping * v);
        x += (double)h * v;
        m = nkw_spring_step(s, m, goal, h);
        double exact = (double)nkw_spring_step(s, start, goal, h * (float)i).value;
        largest = fmax(largest, fabs((closed ? (double)m.value : x) - exact));
    }
    return largest;
}

static void steps_of_springs_are_off(void **state)
{
    (void)state;
    nkw_spring s = nkw_spring_from_half_life(0.15f, 1.0f);
    expect_page("subjects/motion/spring.md", "is up to %.2f off at 60 frames per second, %.2f at 30, and it diverges at 10",
                step_off(s, 60, 0), step_off(s, 30, 0));
    assert_true(step_off(s, 10, 0) > 100);
    assert_true(step_off(s, 60, 1) < 3e-7);
    /* omega of a half-life of 1 s, critical damping; the deviation after 2 ln 2 / omega. */
    nkw_spring unit = nkw_spring_from_half_life(1, 1);
    double omega = sqrt((double)unit.stiffness), other = 2 * log(2.0);
    expect_page("subjects/motion/spring.md", "%.4f/omega. Other libraries call %.3f/omega (2 ln 2) a half-life; the deviation "
                                      "is then %.3f, not 0.5: multiply their number by %.4f.",
                omega, other, (1 + other) * exp(-other), omega / other);
    expect_page("subjects/motion/spring.md", "A wheel of 100 rad/s turns by %.0f° in a step of 1/30 s", 100.0 / 30 * DEGREES);
}

static void poses_have_as_many_arrays_as_the_page_states(void **state)
{
    (void)state;
    expect_page("subjects/pose/transition.md", "| `nkw_pose_velocity_span` | `NKW_POSE_VELOCITY_FLOATS`, %d arrays |",
                (int)NKW_POSE_VELOCITY_FLOATS(16) / 16);
    expect_page("subjects/pose/transition.md", "| `nkw_pose_inertia` | `NKW_POSE_INERTIA_FLOATS`, %d arrays |",
                (int)NKW_POSE_INERTIA_FLOATS(16) / 16);
    expect_page("subjects/pose/transition.md", "| `nkw_pose_dead_blend` | `NKW_POSE_DEAD_BLEND_FLOATS`, %d arrays |",
                (int)NKW_POSE_DEAD_BLEND_FLOATS(16) / 16);
    assert_int_equal(NKW_POSE_FLOATS(16), 10 * 16);
}

static void palettes_have_the_bytes_of_the_pages(void **state)
{
    (void)state;
    const int m44 = (int)sizeof(nkw_mat4), m34 = (int)sizeof(nkw_mat3x4), dual = (int)sizeof(nkw_dual_quat);
    const char *formats = "formats.md", *palette = "subjects/skin/palette.md";
    expect_page(formats, "| `nkw_mat4` | %d |", m44);
    expect_page(formats, "| `nkw_mat3x4` | %d |", m34);
    expect_page(formats, "| `nkw_dual_quat` | %d |", dual);
    expect_page(formats, "| `nkw_mat3`, `nkw_vec3` | %d, %d |", (int)sizeof(nkw_mat3), (int)sizeof(nkw_vec3));
    expect_page(formats, "| 16384 | %d | %d | %d |", 16384 / m44, 16384 / m34, 16384 / dual);
    expect_page(formats, "| 65536 | %d | %d | %d |", 65536 / m44, 65536 / m34, 65536 / dual);
    expect_page(formats, "%d `nkw_mat4`, %d `nkw_dual_quat`, %d `nkw_mat3x4`", 256 / m44, 256 / dual, 768 / m34);
    expect_page(palette, "| `nkw_mat4` | %d |", m44);
    expect_page(palette, "| `nkw_mat3x4`, three rows | %d |", m34);
    expect_page(palette, "| `nkw_dual_quat` | %d |", dual);
    expect_page("character.md", "[%d bytes per joint]", m34);
    expect_page("subjects/skin/crowd.md", "(10 j + c) %d + i", (int)NKW_CROWD);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nlerp_lags_behind_slerp),
        cmocka_unit_test(the_sum_of_two_rotations_leaves_their_mean),
        cmocka_unit_test(play_heads_lose_their_place),
        cmocka_unit_test(rounded_seconds_are_the_frame_before),
        cmocka_unit_test(steps_of_springs_are_off),
        cmocka_unit_test(poses_have_as_many_arrays_as_the_page_states),
        cmocka_unit_test(palettes_have_the_bytes_of_the_pages),
    };
    return cmocka_run_group_tests_name("numbers", tests, NULL, NULL);
}
