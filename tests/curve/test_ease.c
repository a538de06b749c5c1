/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdint.h>

#include "random.h"
#include "support/expect.h"

static nkw_motion cubic_bezier(float x1, float y1, float x2, float y2, float t)
{
    const nkw_easing e = {NKW_EASING_CUBIC_BEZIER, {x1, y1, x2, y2}, NKW_EASE_JUMP_END, 0, NULL, NULL};
    return nkw_easing_evaluate(&e, t);
}

static float steps(size_t count, nkw_ease_jump jump, float t)
{
    const nkw_easing e = {NKW_EASING_STEPS, {0, 0, 0, 0}, jump, count, NULL, NULL};
    const nkw_motion p = nkw_easing_evaluate(&e, t);
    return p.velocity == 0.0f && p.acceleration == 0.0f ? p.value : INFINITY;
}

static nkw_motion linear(const float *inputs, const float *outputs, size_t count, float t)
{
    const nkw_easing e = {NKW_EASING_LINEAR, {0, 0, 0, 0}, NKW_EASE_JUMP_END, count, inputs, outputs};
    return nkw_easing_evaluate(&e, t);
}

static int is_penner(int kind)
{
    return kind >= NKW_EASE_SINE_IN && kind <= NKW_EASE_BOUNCE_IN_OUT;
}

/* ---- Penner's formulas as easings.net writes them, in binary64 by libm ---- */

static double bounce_out(double x)
{
    const double n = 7.5625, d = 2.75;
    if (x < 1 / d)
        return n * x * x;
    if (x < 2 / d)
        return n * (x - 1.5 / d) * (x - 1.5 / d) + 0.75;
    if (x < 2.5 / d)
        return n * (x - 2.25 / d) * (x - 2.25 / d) + 0.9375;
    return n * (x - 2.625 / d) * (x - 2.625 / d) + 0.984375;
}

static double penner_in(int family, double x)
{
    const double pi = 3.14159265358979323846;
    switch (family) {
    case 0:
        return 1 - cos(x * pi / 2);
    case 5:
        return x == 0 ? 0 : pow(2, 10 * x - 10);
    case 6:
        return 1 - sqrt(1 - x * x);
    case 7:
        return 2.70158 * x * x * x - 1.70158 * x * x;
    case 8:
        return x == 0 ? 0 : x == 1 ? 1 : -pow(2, 10 * x - 10) * sin((x * 10 - 10.75) * (2 * pi / 3));
    case 9:
        return 1 - bounce_out(1 - x);
    default:
        return pow(x, family + 1);
    }
}

static double penner_out(int family, double x)
{
    const double pi = 3.14159265358979323846;
    if (family == 8)
        return x == 0 ? 0 : x == 1 ? 1 : pow(2, -10 * x) * sin((x * 10 - 0.75) * (2 * pi / 3)) + 1;
    if (family == 9)
        return bounce_out(x);
    return 1 - penner_in(family, 1 - x);
}

static double penner_in_out(int family, double x)
{
    const double pi = 3.14159265358979323846, c2 = 1.70158 * 1.525, c5 = 2 * pi / 4.5;
    if (family == 7)
        return x < 0.5 ? (pow(2 * x, 2) * ((c2 + 1) * 2 * x - c2)) / 2
                       : (pow(2 * x - 2, 2) * ((c2 + 1) * (x * 2 - 2) + c2) + 2) / 2;
    if (family == 8)
        return x == 0    ? 0
               : x == 1  ? 1
               : x < 0.5 ? -(pow(2, 20 * x - 10) * sin((20 * x - 11.125) * c5)) / 2
                         : (pow(2, -20 * x + 10) * sin((20 * x - 11.125) * c5)) / 2 + 1;
    return x < 0.5 ? penner_in(family, 2 * x) / 2 : (1 + penner_out(family, 2 * x - 1)) / 2;
}

static double penner(int kind, double x)
{
    int family = (kind - NKW_EASE_SINE_IN) / 3, form = (kind - NKW_EASE_SINE_IN) % 3;
    return form == 0 ? penner_in(family, x) : form == 1 ? penner_out(family, x) : penner_in_out(family, x);
}

static void penners_functions_are_those_of_easings_net(void **state)
{
    (void)state;
    for (int kind = NKW_EASE_SINE_IN; kind <= NKW_EASE_BOUNCE_IN_OUT; kind++)
        for (int k = 0; k <= 1000; k++) {
            float t = (float)k / 1000.0f;
            expect_near(nkw_ease_evaluate((nkw_ease_kind)kind, t).value, penner(kind, t), 1.3e-7);
        }
}

static void ends_are_exact(void **state)
{
    (void)state;
    for (int kind = 0; kind < NKW_EASE_CSS_STEP_START; kind++) {
        expect_bits(nkw_ease_evaluate((nkw_ease_kind)kind, 0.0f).value, 0.0f);
        expect_bits(nkw_ease_evaluate((nkw_ease_kind)kind, 1.0f).value, 1.0f);
    }
}

static void out_is_in_from_the_other_end(void **state)
{
    (void)state;
    for (int in = NKW_EASE_SINE_IN; in <= NKW_EASE_BOUNCE_IN; in += 3)
        for (int k = 0; k <= 64; k++) {
            float t = (float)k / 64.0f;
            nkw_motion a = nkw_ease_evaluate((nkw_ease_kind)in, t),
                       b = nkw_ease_evaluate((nkw_ease_kind)(in + 1), 1.0f - t);
            expect_near(b.value, 1.0 - (double)a.value, 6e-8);
            expect_bits(b.velocity, a.velocity);
            expect_bits(b.acceleration, -a.acceleration);
            float middle = nkw_ease_evaluate((nkw_ease_kind)(in + 2), t).value,
                  other = nkw_ease_evaluate((nkw_ease_kind)(in + 2), 1.0f - t).value;
            if (k != 32)
                expect_near(middle + other, 1, 1.2e-7);
        }
}

/* Away from corners, jumps and vertical ends. */
static void derivatives_are_those_of_finite_differences(void **state)
{
    (void)state;
    const double e = 1e-5;
    for (int kind = NKW_EASE_SINE_IN; kind <= NKW_EASE_BOUNCE_IN_OUT; kind++)
        for (int k = 3; k < 98; k++) {
            double t = (double)(float)(k / 101.0);
            double a = penner(kind, t - e), b = penner(kind, t), c = penner(kind, t + e);
            nkw_motion p = nkw_ease_evaluate((nkw_ease_kind)kind, (float)t);
            expect_near(p.velocity, (c - a) / (2 * e), 3e-5);
            expect_near(p.acceleration, (c - 2 * b + a) / (e * e), 3e-3);
        }
}

static void outside_penner_holds_its_ends_and_css_continues(void **state)
{
    (void)state;
    for (int kind = NKW_EASE_SINE_IN; kind <= NKW_EASE_BOUNCE_IN_OUT; kind++) {
        expect_bits(nkw_ease_evaluate((nkw_ease_kind)kind, -0.25f).value, 0.0f);
        expect_bits(nkw_ease_evaluate((nkw_ease_kind)kind, -0.25f).velocity, 0.0f);
        expect_bits(nkw_ease_evaluate((nkw_ease_kind)kind, INFINITY).value, 1.0f);
    }
    expect_bits(nkw_ease_evaluate(NKW_EASE_LINEAR, 1.75f).value, 1.75f);
    expect_near(nkw_ease_evaluate(NKW_EASE_CSS, -0.5f).value, -0.5 * (0.1 / 0.25), 1e-7);
    expect_near(nkw_ease_evaluate(NKW_EASE_CSS, 1.5f).value, 1.0, 1e-7);
    expect_near(nkw_ease_evaluate(NKW_EASE_CSS_IN, 1.5f).value, 1.0 + 0.5 * (1.0 / 0.58), 2e-6);
    expect_bits(nkw_ease_evaluate(NKW_EASE_CSS_STEP_START, -0.5f).value, 0.0f);
    expect_bits(nkw_ease_evaluate(NKW_EASE_CSS_STEP_END, 2.5f).value, 2.0f);
}

static void nan_returns_nan_and_unknown_kinds_are_linear(void **state)
{
    (void)state;
    for (int kind = -1; kind <= NKW_EASE_COUNT; kind++)
        expect_nan(nkw_ease_evaluate((nkw_ease_kind)kind, NAN).value);
    expect_bits(nkw_ease_evaluate((nkw_ease_kind)99, 0.3f).value, 0.3f);
    expect_bits(nkw_ease_evaluate((nkw_ease_kind)-7, 0.3f).velocity, 1.0f);
    expect_nan(cubic_bezier(NAN, 0, 1, 1, 0.5f).value);
    expect_nan(cubic_bezier(0, 0, INFINITY, 1, 0.5f).value);
    expect_nan(cubic_bezier(0, 0, 1, 1, NAN).value);
    expect_nan(steps(3, NKW_EASE_JUMP_END, NAN));
}

static void only_circ_is_vertical(void **state)
{
    (void)state;
    expect_bits(nkw_ease_evaluate(NKW_EASE_CIRC_IN, 1.0f).velocity, INFINITY);
    expect_bits(nkw_ease_evaluate(NKW_EASE_CIRC_OUT, 0.0f).velocity, INFINITY);
    expect_bits(nkw_ease_evaluate(NKW_EASE_CIRC_OUT, 0.0f).acceleration, -INFINITY);
    /* Next to the vertical: 1/sqrt(2 t), of t as it is, not of 1 - (1 - t). */
    expect_near(nkw_ease_evaluate(NKW_EASE_CIRC_OUT, 0x1p-55f).velocity, 0x1p27, 16);
    expect_near(nkw_ease_evaluate(NKW_EASE_CIRC_OUT, 0x1p-81f).velocity, 0x1p40, 0x1p17);
    for (int kind = 0; kind < NKW_EASE_COUNT; kind++)
        for (int k = 0; k <= 32; k++) {
            nkw_motion p = nkw_ease_evaluate((nkw_ease_kind)kind, (float)k / 32.0f);
            int is_circ = is_penner(kind) && (kind - NKW_EASE_SINE_IN) / 3 == 6;
            assert_true(is_circ || (isfinite(p.value) && isfinite(p.velocity) && isfinite(p.acceleration)) || k % 32 == 0);
        }
}

/* ---- CSS ---- */

/* Bisection in long double. */
static double css(double x1, double y1, double x2, double y2, double t)
{
    long double low = 0, high = 1, s = 0;
    for (int i = 0; i < 80; i++) {
        s = (low + high) / 2;
        long double r = 1 - s, x = 3 * r * r * s * x1 + 3 * r * s * s * x2 + s * s * s;
        if (x < t)
            low = s;
        else
            high = s;
    }
    long double r = 1 - s;
    return (double)(3 * r * r * s * y1 + 3 * r * s * s * y2 + s * s * s);
}

static void cubic_bezier_agrees_with_bisection(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int i = 0; i < 20000; i++) {
        float x1 = random_unit(&r), x2 = random_unit(&r), y1 = random_between(&r, -1, 2),
              y2 = random_between(&r, -1, 2);
        float t = random_unit(&r);
        nkw_motion p = cubic_bezier(x1, y1, x2, y2, t);
        expect_near(p.value, css(x1, y1, x2, y2, t), 3e-7);
    }
    /* cubic-bezier(0.25, 0.1, 0.25, 1) at 1/4, 1/2, 3/4. */
    expect_near(nkw_ease_evaluate(NKW_EASE_CSS, 0.25f).value, 0.40851, 1e-5);
    expect_near(nkw_ease_evaluate(NKW_EASE_CSS, 0.5f).value, 0.80240, 1e-5);
    expect_near(nkw_ease_evaluate(NKW_EASE_CSS, 0.75f).value, 0.96046, 1e-5);
}

/* By the tangent; where its handle has no length by that of the next point; held where the tangent is vertical. */
static void cubic_bezier_continues_along_its_tangents(void **state)
{
    (void)state;
    expect_near(cubic_bezier(0.5f, 1, 0.5f, 0, -1).value, -2, 1e-6);
    expect_near(cubic_bezier(0.5f, 1, 0.5f, 0, 2).value, 3, 1e-6);
    expect_near(cubic_bezier(0, 0, 0.5f, 1, -1).value, -2, 1e-6);
    expect_near(cubic_bezier(0.5f, 0, 1, 1, 2).value, 3, 1e-6);
    expect_near(cubic_bezier(0, 0, 0, 0, -1).value, -1, 1e-6);
    expect_near(cubic_bezier(1, 1, 1, 1, 2).value, 2, 1e-6);
    expect_near(cubic_bezier(0, 1, 0.5f, 1, -1).value, 0, 0);
    expect_near(cubic_bezier(0.5f, 0, 1, 0.5f, 2).value, 1, 0);
    /* A line has no curvature, and the slope of the curve at its end: y'/x' = 2 at 0, 3 at 1. */
    for (float far = 0.5f; far < 9; far += 0.5f) {
        nkw_motion before = cubic_bezier(0.25f, 0.5f, 0.75f, 0.25f, -far);
        nkw_motion after = cubic_bezier(0.25f, 0.5f, 0.75f, 0.25f, 1 + far);
        expect_bits(before.value, -2 * far);
        expect_bits(before.velocity, 2);
        expect_bits(before.acceleration, 0);
        expect_bits(after.value, 1 + 3 * far);
        expect_bits(after.velocity, 3);
        expect_bits(after.acceleration, 0);
    }
}

static void steps_have_the_levels_of_css(void **state)
{
    (void)state;
    static const float want[4][4] = {
        {1 / 3.0f, 2 / 3.0f, 1, 1}, {0, 1 / 3.0f, 2 / 3.0f, 1}, {0, 0.5f, 1, 1}, {0.25f, 0.5f, 0.75f, 1}};
    const float times[4] = {0.1f, 0.4f, 0.9f, 1.0f};
    for (int jump = 0; jump < 4; jump++)
        for (int k = 0; k < 4; k++)
            expect_bits(steps(3, (nkw_ease_jump)jump, times[k]), want[jump][k]);
    expect_bits(steps(4, NKW_EASE_JUMP_END, 0.25f), 0.25f);
    expect_bits(steps(4, NKW_EASE_JUMP_START, 0.25f), 0.5f);
    expect_bits(steps(2, NKW_EASE_JUMP_END, -0.25f), -0.5f);
    expect_bits(steps(2, NKW_EASE_JUMP_END, 1.75f), 1.5f);
    expect_bits(steps(0, NKW_EASE_JUMP_END, 0.5f), 0.0f);
    expect_bits(steps(1, NKW_EASE_JUMP_NONE, 0.5f), 1.0f);
    expect_bits(steps(0, NKW_EASE_JUMP_BOTH, 0.5f), 0.5f);
    expect_bits(steps(3, (nkw_ease_jump)9, 0.4f), 1 / 3.0f);
}

static void linear_passes_through_its_points(void **state)
{
    (void)state;
    /* linear(0, 0.25 25% 75%, 1) */
    const float in[4] = {0, 0.25f, 0.75f, 1}, out[4] = {0, 0.25f, 0.25f, 1};
    for (int i = 0; i < 4; i++)
        expect_bits(linear(in, out, 4, in[i]).value, out[i]);
    expect_near(linear(in, out, 4, 0.5f).value, 0.25, 0);
    expect_near(linear(in, out, 4, 0.875f).value, 0.625, 1e-7);
    expect_near(linear(in, out, 4, 0.875f).velocity, 3, 1e-6);
    expect_near(linear(in, out, 4, -1.0f).value, -1, 1e-6);
    expect_near(linear(in, out, 4, 2.0f).value, 4, 1e-6);
    const float twice[4] = {0, 0.5f, 0.5f, 1}, jump[4] = {0, 0.25f, 0.75f, 1};
    expect_bits(linear(twice, jump, 4, 0.5f).value, 0.75f);
    expect_near(linear(twice, jump, 4, 0.49999f).value, 0.25, 1e-5);
    const float same[2] = {0.5f, 0.5f}, two[2] = {3, 4};
    expect_bits(linear(same, two, 2, 0.25f).value, 3);
    expect_bits(linear(same, two, 2, 0.5f).value, 4);
    expect_bits(linear(same, two, 1, 9.0f).value, 3);
    expect_bits(linear(NULL, NULL, 0, 0.5f).value, 0);
    expect_nan(linear(in, out, 4, NAN).value);
}

static void omitted_inputs_are_spaced_evenly(void **state)
{
    (void)state;
    float in[7] = {NAN, NAN, 0.5f, 0.25f, NAN, NAN, NAN}, one[1] = {NAN}, late[3] = {NAN, 1.5f, NAN};
    const float want[7] = {0, 0.25f, 0.5f, 0.5f, 2 / 3.0f, 5 / 6.0f, 1}, want_late[3] = {0, 1.5f, 1.5f};
    nkw_easing_complete(in, 7);
    expect_floats_near(in, want, 7, 1e-7);
    nkw_easing_complete(one, 1);
    expect_bits(one[0], 0.0f);
    nkw_easing_complete(late, 3);
    expect_floats_bits(late, want_late, 3);
    nkw_easing_complete(NULL, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(penners_functions_are_those_of_easings_net),
        cmocka_unit_test(ends_are_exact),
        cmocka_unit_test(out_is_in_from_the_other_end),
        cmocka_unit_test(derivatives_are_those_of_finite_differences),
        cmocka_unit_test(outside_penner_holds_its_ends_and_css_continues),
        cmocka_unit_test(nan_returns_nan_and_unknown_kinds_are_linear),
        cmocka_unit_test(only_circ_is_vertical),
        cmocka_unit_test(cubic_bezier_agrees_with_bisection),
        cmocka_unit_test(cubic_bezier_continues_along_its_tangents),
        cmocka_unit_test(steps_have_the_levels_of_css),
        cmocka_unit_test(linear_passes_through_its_points),
        cmocka_unit_test(omitted_inputs_are_spaced_evenly),
    };
    return cmocka_run_group_tests_name("ease", tests, NULL, NULL);
}
