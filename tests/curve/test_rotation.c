/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "random.h"
#include "support/expect.h"

#define PI 3.14159274f

enum { KINDS = 4 };

/* The curve of four keys at any times. */
static nkw_quat inner_control(nkw_quat before, nkw_quat key, nkw_quat after)
{
    const nkw_quat keys[4] = {before, key, after, after};
    return nkw_rotation_from_squad(keys, 1.0f).control[1];
}

static float uneven(const float times[4], float p0, float p1, float p2, float p3, float t)
{
    const float keys[4] = {p0, p1, p2, p3};
    float c[4];
    nkw_cubic_from_catmull_rom(keys, times, c);
    return nkw_hermite(c[0], c[1], c[2], c[3], t);
}

static nkw_vec3 vec(float x, float y, float z)
{
    nkw_vec3 r = {x, y, z};
    return r;
}

static nkw_quat about(nkw_vec3 axis, float angle)
{
    return nkw_quat_from_axis_angle(axis, angle);
}

static nkw_quat some_key(random_source *r)
{
    return nkw_quat_normalize(random_rotation(r));
}

/* Keys of which each is within `angle` (between the quaternions) of the one before, of either sign. */
static void draw_keys(random_source *r, nkw_quat *keys, int count, float angle)
{
    for (int i = 0; i < count; i++) {
        nkw_quat q = i ? random_near(r, keys[i - 1], random_between(r, 0.0f, angle)) : random_rotation(r);
        keys[i] = nkw_quat_normalize(random_bits(r) & 1 ? nkw_quat_negate(q) : q);
    }
}

/* From a, with velocities whose prediction of the end is wrong by up to 1.4 rad. */
static nkw_rotation_segment draw_hermite(random_source *r, nkw_quat a, float duration)
{
    nkw_vec3 va = random_vec3(r, -6, 6), vb = random_vec3(r, -6, 6);
    nkw_quat predicted = nkw_quat_integrate(a, nkw_vec3_scale(nkw_vec3_add(va, vb), 0.5f), duration);
    nkw_quat b = nkw_quat_normalize(random_near(r, predicted, random_between(r, 0.0f, 0.7f)));
    return nkw_rotation_from_hermite(a, va, random_bits(r) & 1 ? b : nkw_quat_negate(b), vb, duration);
}

/* A segment of any kind. */
static nkw_rotation_segment draw_segment(random_source *r, int kind)
{
    nkw_quat k[4];
    draw_keys(r, k, 4, 0.7f);
    float duration = random_between(r, 0.2f, 3.0f);
    if (kind == 0)
        return nkw_rotation_from_slerp(k[0], random_near(r, k[0], random_between(r, 0.2f, 0.7f)), duration,
                                       NKW_PATH_SHORT, 1);
    if (kind == 1)
        return draw_hermite(r, k[0], 0.3f * duration);
    return kind == 2 ? nkw_rotation_from_squad(k, duration) : nkw_rotation_from_bspline(k, duration);
}

static void ends_are_the_keys_bit_for_bit(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int i = 0; i < 6000; i++) {
        nkw_rotation_segment s = draw_segment(&r, i % 3);
        nkw_quat end = s.control[i % 3 == 2 ? 3 : 1], got = nkw_rotation_evaluate(&s, 1.0f).value;
        expect_quat_bits(nkw_rotation_evaluate(&s, 0.0f).value, s.control[0]);
        expect_quat_bits(got, nkw_quat_dot(got, end) < 0 ? nkw_quat_negate(end) : end);
        /* No jump before the end: the sign is that of the curve. */
        expect_quat_near(nkw_rotation_evaluate(&s, 0x1.fffffep-1f).value, got, 1e-5);
        expect_quat_near(nkw_rotation_evaluate(&s, 0x1p-24f).value, s.control[0], 1e-5);
    }
}

/* By central differences of the results; the distances leave about 1e-4. */
static void velocity_and_acceleration_are_the_derivatives(void **state)
{
    (void)state;
    random_source r = random_from(2);
    const float e = 0x1p-7f;
    for (int i = 0; i < 8000; i++) {
        nkw_rotation_segment s = draw_segment(&r, i % KINDS);
        float t = random_between(&r, 0.1f, 0.9f), h = s.duration;
        nkw_quat_motion at = nkw_rotation_evaluate(&s, t), low = nkw_rotation_evaluate(&s, t - e),
                           high = nkw_rotation_evaluate(&s, t + e);
        nkw_vec3 mean = nkw_quat_angular_velocity(low.value, high.value, 2.0f * e * h);
        nkw_vec3 change = nkw_vec3_scale(nkw_vec3_sub(high.velocity, low.velocity), 0.5f / (e * h));
        float speed = nkw_vec3_length(at.velocity) + 1.0f / h, size = speed * speed + nkw_vec3_length(at.acceleration);
        expect_vec3_near(at.velocity, mean, 0.01 * (double)(speed + 30.0f / h));
        expect_vec3_near(at.acceleration, change, 0.01 * (double)(size + 60.0f / (h * h)));
    }
}

static void slerp_segment_is_slerp_at_constant_velocity(void **state)
{
    (void)state;
    random_source r = random_from(3);
    for (int i = 0; i < 5000; i++) {
        nkw_quat a = some_key(&r), b = some_key(&r);
        nkw_path path = (nkw_path)(i % 3);
        int32_t turns = (int32_t)(random_bits(&r) % 5) - 2;
        nkw_rotation_segment s = nkw_rotation_from_slerp(a, b, 2.0f, path, turns);
        float t = random_unit(&r);
        nkw_quat_motion at = nkw_rotation_evaluate(&s, t), start = nkw_rotation_evaluate(&s, 0.0f);
        expect_quat_near(at.value, nkw_quat_slerp_path(a, b, t, path, turns), 3e-7);
        expect_vec3_near(at.velocity, start.velocity, 4e-6);
        expect_vec3_near(at.acceleration, vec(0, 0, 0), 1e-12);
        if (path == NKW_PATH_SHORT && turns == 0)
            expect_vec3_near(at.velocity, nkw_quat_angular_velocity(a, b, 2.0f), 1e-6);
    }
}

static void hermite_has_the_velocities_of_its_ends(void **state)
{
    (void)state;
    random_source r = random_from(4);
    for (int i = 0; i < 5000; i++) {
        nkw_rotation_segment s = draw_segment(&r, 1);
        expect_vec3_near(nkw_rotation_evaluate(&s, 0.0f).velocity, s.velocity[0], 3e-6);
        expect_vec3_near(nkw_rotation_evaluate(&s, 1.0f).velocity, s.velocity[1], 3e-6);
    }
}

static void hermite_at_rest_is_slerp_that_eases(void **state)
{
    (void)state;
    random_source r = random_from(5);
    for (int i = 0; i < 5000; i++) {
        nkw_quat a = some_key(&r), b = some_key(&r);
        nkw_rotation_segment s = nkw_rotation_from_hermite(a, vec(0, 0, 0), b, vec(0, 0, 0), 1.0f);
        float t = random_unit(&r), eased = t * t * (3.0f - 2.0f * t);
        expect_quat_near(nkw_rotation_evaluate(&s, t).value, nkw_quat_slerp(a, b, eased), 5e-7);
        s.path = NKW_PATH_LONG;
        s.turns = 2;
        expect_quat_near(nkw_rotation_evaluate(&s, t).value, nkw_quat_slerp_path(a, b, eased, NKW_PATH_LONG, 2),
                         4e-6);
    }
}

/* A wheel at a constant rate, whole turns between its keys among them, where the arc has no axis. */
static void wheels_turn_as_often_as_their_velocity_says(void **state)
{
    (void)state;
    random_source r = random_from(6);
    for (int i = 0; i < 5000; i++) {
        nkw_vec3 axis = nkw_vec3_normalize(random_direction(&r));
        float angle = i % 3 ? random_between(&r, -100.0f, 100.0f) : 2.0f * PI * (float)(i % 17 - 8);
        float duration = random_between(&r, 0.01f, 2.0f), t = random_unit(&r);
        nkw_vec3 rate = nkw_vec3_scale(axis, angle / duration);
        nkw_quat a = some_key(&r), b = nkw_quat_integrate(a, rate, duration);
        b = random_bits(&r) & 1 ? nkw_quat_negate(b) : b;
        nkw_rotation_segment s = nkw_rotation_from_hermite(a, rate, b, rate, duration);
        nkw_quat_motion at = nkw_rotation_evaluate(&s, t);
        expect_rotation_near(at.value, nkw_quat_integrate(a, rate, t * duration), 2e-5);
        expect_near(nkw_vec3_distance(at.velocity, rate), 0, 2e-5 * (1.0 + fabs((double)angle)) / (double)duration);
    }
}

/* Noise of the keys does not change the turns, and deviates the curve as little. */
static void noise_on_a_wheel_stays_noise(void **state)
{
    (void)state;
    random_source r = random_from(7);
    for (int i = 0; i < 3000; i++) {
        nkw_vec3 rate = vec(0, 2.0f * PI * (float)(i % 9 - 4), 0);
        nkw_quat a = some_key(&r), b = nkw_quat_normalize(random_near(&r, a, 1e-3f));
        nkw_vec3 wobble = random_vec3(&r, -0.01f, 0.01f);
        nkw_rotation_segment s = nkw_rotation_from_hermite(a, nkw_vec3_add(rate, wobble), b, rate, 1.0f);
        float t = random_unit(&r);
        expect_rotation_near(nkw_rotation_evaluate(&s, t).value, nkw_quat_integrate(a, rate, t), 6e-3);
    }
}

static void signs_of_the_keys_do_not_matter(void **state)
{
    (void)state;
    random_source r = random_from(9);
    for (int i = 0; i < 6000; i++) {
        nkw_quat k[4], n[4];
        const float times[4] = {0.0f, 0.7f, 1.0f, 2.5f};
        draw_keys(&r, k, 4, 0.7f);
        for (int j = 0; j < 4; j++)
            n[j] = random_bits(&r) & 1 ? nkw_quat_negate(k[j]) : k[j];
        float t = random_unit(&r);
        nkw_rotation_segment a[3] = {nkw_rotation_from_squad(k, 1), nkw_rotation_from_bspline(k, 1),
                                     nkw_rotation_from_catmull_rom(k, times)};
        nkw_rotation_segment b[3] = {nkw_rotation_from_squad(n, 1), nkw_rotation_from_bspline(n, 1),
                                     nkw_rotation_from_catmull_rom(n, times)};
        nkw_quat_motion p = nkw_rotation_evaluate(&a[i % 3], t), q = nkw_rotation_evaluate(&b[i % 3], t);
        expect_rotation_near(p.value, q.value, 2e-7);
        expect_vec3_near(p.velocity, q.velocity, 1e-5);
    }
}

/* q to g q, for every key: the curve turns with them, and so do velocity and acceleration. */
static void turned_keys_turn_the_curve(void **state)
{
    (void)state;
    random_source r = random_from(10);
    for (int i = 0; i < 6000; i++) {
        nkw_rotation_segment s = draw_segment(&r, i % KINDS), turned = s;
        nkw_quat g = some_key(&r);
        for (int j = 0; j < 4; j++)
            turned.control[j] = nkw_quat_mul(g, s.control[j]);
        for (int j = 0; j < 2; j++)
            turned.velocity[j] = nkw_quat_rotate(g, s.velocity[j]);
        float t = random_unit(&r);
        nkw_quat_motion a = nkw_rotation_evaluate(&s, t), b = nkw_rotation_evaluate(&turned, t);
        double rate = 1.0 / (double)(s.duration * s.duration);
        expect_rotation_near(nkw_quat_mul(g, a.value), b.value, 6e-6);
        expect_vec3_near(nkw_quat_rotate(g, a.velocity), b.velocity, 3e-4 * (1.0 + rate));
        expect_vec3_near(nkw_quat_rotate(g, a.acceleration), b.acceleration, 3e-3 * (1.0 + rate));
    }
}

/* About one axis all kinds are curves of the angle. */
static void about_one_axis_they_are_the_curves_of_numbers(void **state)
{
    (void)state;
    random_source r = random_from(11);
    for (int i = 0; i < 6000; i++) {
        nkw_vec3 axis = nkw_vec3_normalize(random_direction(&r));
        float a[4], t = random_unit(&r);
        nkw_quat k[4];
        for (int j = 0; j < 4; j++) {
            a[j] = (j ? a[j - 1] : 0.0f) + random_between(&r, -1.0f, 1.0f);
            k[j] = about(axis, a[j]);
        }
        float v0 = random_between(&r, -1.5f, 1.5f), v1 = random_between(&r, -1.5f, 1.5f);
        nkw_rotation_segment hermite =
            nkw_rotation_from_hermite(k[0], nkw_vec3_scale(axis, v0), k[1], nkw_vec3_scale(axis, v1), 1.0f);
        expect_rotation_near(nkw_rotation_evaluate(&hermite, t).value,
                             about(axis, nkw_hermite(a[0], v0, a[1], v1, t)), 2e-6);
        nkw_rotation_segment bspline = nkw_rotation_from_bspline(k, 1.0f);
        expect_rotation_near(nkw_rotation_evaluate(&bspline, t).value,
                             about(axis, nkw_bspline(a[0], a[1], a[2], a[3], t)), 2e-6);
        nkw_rotation_segment squad = nkw_rotation_from_squad(k, 1.0f);
        float s1 = a[1] - 0.25f * (a[2] + a[0] - 2.0f * a[1]), s2 = a[2] - 0.25f * (a[3] + a[1] - 2.0f * a[2]);
        float angle = nkw_lerp(nkw_lerp(a[1], a[2], t), nkw_lerp(s1, s2, t), 2.0f * t * (1.0f - t));
        expect_rotation_near(nkw_rotation_evaluate(&squad, t).value, about(axis, angle), 2e-6);
        const float times[4] = {0.0f, 1.0f, 2.5f, 3.5f};
        nkw_rotation_segment through = nkw_rotation_from_catmull_rom(k, times);
        expect_rotation_near(nkw_rotation_evaluate(&through, t).value,
                             about(axis, uneven(times, a[0], a[1], a[2], a[3], t)), 3e-6);
    }
}

static void join(nkw_rotation_segment *a, nkw_rotation_segment *b, int has_acceleration)
{
    nkw_quat_motion p = nkw_rotation_evaluate(a, 1.0f), q = nkw_rotation_evaluate(b, 0.0f);
    expect_rotation_near(p.value, q.value, 3e-7);
    expect_vec3_near(p.velocity, q.velocity, 3e-5);
    if (has_acceleration)
        expect_vec3_near(p.acceleration, q.acceleration, 1e-4);
}

static void segments_join_with_their_velocity(void **state)
{
    (void)state;
    random_source r = random_from(12);
    const float times[5] = {0.0f, 0.4f, 1.0f, 1.9f, 2.0f};
    for (int i = 0; i < 4000; i++) {
        nkw_quat k[5];
        draw_keys(&r, k, 5, 0.7f);
        nkw_rotation_segment squads[2] = {nkw_rotation_from_squad(k, 0.5f), nkw_rotation_from_squad(k + 1, 0.5f)};
        nkw_rotation_segment splines[2] = {nkw_rotation_from_bspline(k, 0.5f), nkw_rotation_from_bspline(k + 1, 0.5f)};
        nkw_rotation_segment cubics[2] = {nkw_rotation_from_catmull_rom(k, times),
                                          nkw_rotation_from_catmull_rom(k + 1, times + 1)};
        join(&squads[0], &squads[1], 0);
        join(&splines[0], &splines[1], 1);
        join(&cubics[0], &cubics[1], 0);
        /* Continuity 0 of the shared key joins; another does not. */
        nkw_tcb key[3] = {{0.3f, 0.2f, -0.4f}, {-0.5f, 0.0f, 0.6f}, {0.1f, 0.9f, 0.0f}};
        nkw_rotation_segment tcb[2] = {nkw_rotation_from_tcb(k, times, key),
                                       nkw_rotation_from_tcb(k + 1, times + 1, key + 1)};
        join(&tcb[0], &tcb[1], 0);
    }
}

static void tcb_without_parameters_is_catmull_rom_at_even_times(void **state)
{
    (void)state;
    random_source r = random_from(13);
    const float times[4] = {1.0f, 1.5f, 2.0f, 2.5f};
    const nkw_tcb none[2] = {{0, 0, 0}, {0, 0, 0}}, tense[2] = {{1, 0.5f, 0}, {1, 0, 0.5f}};
    for (int i = 0; i < 2000; i++) {
        nkw_quat k[4];
        draw_keys(&r, k, 4, 0.7f);
        nkw_rotation_segment a = nkw_rotation_from_tcb(k, times, none), b = nkw_rotation_from_catmull_rom(k, times);
        expect_vec3_near(a.velocity[0], b.velocity[0], 1e-6);
        expect_vec3_near(a.velocity[1], b.velocity[1], 1e-6);
        a = nkw_rotation_from_tcb(k, times, tense);
        expect_vec3_bits(nkw_vec3_add(a.velocity[0], vec(0, 0, 0)), vec(0, 0, 0));
        expect_vec3_bits(nkw_vec3_add(a.velocity[1], vec(0, 0, 0)), vec(0, 0, 0));
    }
}

/* Bias 1 takes the chord before the key alone, continuity -1 the chord of each side: a corner. */
static void bias_and_continuity_choose_the_chord(void **state)
{
    (void)state;
    const nkw_vec3 z = {0, 0, 1};
    const nkw_quat k[4] = {about(z, 0.0f), about(z, 1.0f), about(z, 1.5f), about(z, 1.25f)};
    const float times[4] = {0, 1, 2, 3};
    const nkw_tcb bias[2] = {{0, 0, 1}, {0, 0, -1}}, corner[2] = {{0, -1, 0}, {0, -1, 0}};
    nkw_rotation_segment s = nkw_rotation_from_tcb(k, times, bias);
    expect_vec3_near(s.velocity[0], vec(0, 0, 1.0f), 1e-6);
    expect_vec3_near(s.velocity[1], vec(0, 0, -0.25f), 1e-6);
    s = nkw_rotation_from_tcb(k, times, corner);
    expect_vec3_near(s.velocity[0], vec(0, 0, 0.5f), 1e-6);
    expect_vec3_near(s.velocity[1], vec(0, 0, 0.5f), 1e-6);
}

static void repeated_end_keys_take_the_other_chord(void **state)
{
    (void)state;
    const nkw_vec3 x = {1, 0, 0};
    const nkw_quat k[4] = {about(x, 0.2f), about(x, 0.2f), about(x, 0.8f), about(x, 0.8f)};
    const float times[4] = {1, 1, 3, 3}, still[4] = {2, 2, 2, 2};
    nkw_rotation_segment s = nkw_rotation_from_catmull_rom(k, times);
    expect_vec3_near(s.velocity[0], vec(0.3f, 0, 0), 1e-6);
    expect_vec3_near(s.velocity[1], vec(0.3f, 0, 0), 1e-6);
    s = nkw_rotation_from_catmull_rom(k, still);
    expect_vec3_bits(s.velocity[0], vec(0, 0, 0));
}

static void squad_control_of_even_keys_is_the_key(void **state)
{
    (void)state;
    random_source r = random_from(14);
    for (int i = 0; i < 2000; i++) {
        nkw_vec3 axis = nkw_vec3_normalize(random_direction(&r));
        float step = random_between(&r, -2.9f, 2.9f);
        nkw_quat key = some_key(&r), before = nkw_quat_mul(key, about(axis, -step)),
                 after = nkw_quat_negate(nkw_quat_mul(key, about(axis, step)));
        expect_quat_near(inner_control(before, key, after), key, 3e-7);
    }
}

/* By hand: log(after) is a quarter of pi about z, log(before) 0; the control turns back by an eighth of a half turn. */
static void squad_control_has_its_known_value(void **state)
{
    (void)state;
    const nkw_vec3 z = {0, 0, 1};
    const nkw_quat one = {0, 0, 0, 1};
    expect_quat_near(inner_control(one, one, about(z, PI / 2)), about(z, -PI / 8), 1e-7);
}

static void without_a_duration_there_is_no_velocity(void **state)
{
    (void)state;
    random_source r = random_from(15);
    const float durations[3] = {0.0f, -1.0f, NAN};
    for (int i = 0; i < 300; i++) {
        nkw_rotation_segment s = draw_segment(&r, i % KINDS);
        s.duration = durations[i % 3];
        nkw_quat_motion at = nkw_rotation_evaluate(&s, 0.3f);
        assert_true(nkw_quat_is_finite(at.value));
        expect_vec3_near(at.velocity, vec(0, 0, 0), 0);
        expect_vec3_near(at.acceleration, vec(0, 0, 0), 0);
    }
}

static void equal_keys_do_not_move(void **state)
{
    (void)state;
    random_source r = random_from(16);
    for (int i = 0; i < 500; i++) {
        nkw_quat q = some_key(&r), k[4] = {q, nkw_quat_negate(q), q, q};
        nkw_rotation_segment s[3] = {nkw_rotation_from_slerp(q, k[1], 1, NKW_PATH_SHORT, 0),
                                     nkw_rotation_from_squad(k, 1), nkw_rotation_from_bspline(k, 1)};
        nkw_quat_motion at = nkw_rotation_evaluate(&s[i % 3], random_unit(&r));
        expect_rotation_near(at.value, q, 2e-7);
        expect_vec3_near(at.velocity, vec(0, 0, 0), 1e-6);
        expect_vec3_near(at.acceleration, vec(0, 0, 0), 2e-6);
    }
}

static void zeros_are_identities_and_unknown_kinds_slerp(void **state)
{
    (void)state;
    const nkw_quat zero = {0, 0, 0, 0}, one = {0, 0, 0, 1}, half_turn = {1, 0, 0, 0};
    const nkw_quat zeros[4] = {zero, zero, zero, zero}, far[4] = {one, half_turn, one, half_turn};
    for (int kind = 0; kind < KINDS; kind++) {
        nkw_rotation_segment s = nkw_rotation_from_bspline(zeros, 1.0f);
        s.kind = (nkw_rotation_kind)kind;
        expect_quat_near(nkw_rotation_evaluate(&s, 0.5f).value, one, 1e-7);
        for (int i = 0; i < 4; i++)
            s.control[i] = far[i];
        for (int t = -8; t <= 8; t++) {
            nkw_quat_motion at = nkw_rotation_evaluate(&s, (float)t / 4.0f);
            expect_near(nkw_quat_length(at.value), 1.0, 1e-6);
            assert_true(nkw_vec3_is_finite(at.velocity) && nkw_vec3_is_finite(at.acceleration));
        }
        expect_nan(nkw_rotation_evaluate(&s, NAN).value.w);
    }
    nkw_rotation_segment s = nkw_rotation_from_slerp(one, half_turn, 1.0f, NKW_PATH_SHORT, 0), odd = s;
    odd.kind = (nkw_rotation_kind)77;
    expect_quat_bits(nkw_rotation_evaluate(&odd, 0.3f).value, nkw_rotation_evaluate(&s, 0.3f).value);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ends_are_the_keys_bit_for_bit),
        cmocka_unit_test(velocity_and_acceleration_are_the_derivatives),
        cmocka_unit_test(slerp_segment_is_slerp_at_constant_velocity),
        cmocka_unit_test(hermite_has_the_velocities_of_its_ends),
        cmocka_unit_test(hermite_at_rest_is_slerp_that_eases),
        cmocka_unit_test(wheels_turn_as_often_as_their_velocity_says),
        cmocka_unit_test(noise_on_a_wheel_stays_noise),
        cmocka_unit_test(signs_of_the_keys_do_not_matter),
        cmocka_unit_test(turned_keys_turn_the_curve),
        cmocka_unit_test(about_one_axis_they_are_the_curves_of_numbers),
        cmocka_unit_test(segments_join_with_their_velocity),
        cmocka_unit_test(tcb_without_parameters_is_catmull_rom_at_even_times),
        cmocka_unit_test(bias_and_continuity_choose_the_chord),
        cmocka_unit_test(repeated_end_keys_take_the_other_chord),
        cmocka_unit_test(squad_control_of_even_keys_is_the_key),
        cmocka_unit_test(squad_control_has_its_known_value),
        cmocka_unit_test(without_a_duration_there_is_no_velocity),
        cmocka_unit_test(equal_keys_do_not_move),
        cmocka_unit_test(zeros_are_identities_and_unknown_kinds_slerp),
    };
    return cmocka_run_group_tests_name("rotation", tests, NULL, NULL);
}
