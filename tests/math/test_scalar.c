/* SPDX-License-Identifier: MIT */
#include "support/expect.h"
#include "support/random.h"

#include <float.h>
#include <math.h>

#define PI_FLOAT 0x1.921fb6p1f
#define HALF_PI  0x1.921fb6p0f
#define COUNT    100000

typedef float one_function(float x);

/* ---- identities ---- */

static void lerp_gives_its_ends_exactly(void **state)
{
    random_source r = random_from(1);
    (void)state;
    for (int i = 0; i < COUNT; i++) {
        float a = random_scaled(&r, -120, 120), b = random_scaled(&r, -120, 120);
        expect_bits(nkw_lerp(a, b, 0.0f), a);
        expect_bits(nkw_lerp(a, b, 1.0f), b);
    }
}

static void lerp_goes_on_beyond_its_ends(void **state)
{
    (void)state;
    expect_bits(nkw_lerp(2, 4, 0.5f), 3);
    expect_bits(nkw_lerp(2, 4, 2.0f), 6);
    expect_bits(nkw_lerp(2, 4, -1.0f), 0);
}

static void lerp_between_equal_numbers_gives_that_number(void **state)
{
    random_source r = random_from(2);
    (void)state;
    for (int i = 0; i < COUNT; i++) {
        float a = random_finite(&r);
        expect_bits(nkw_lerp(a, a, random_between(&r, -2.0f, 3.0f)), a + 0.0f);
    }
}

static void inverse_lerp_gives_0_and_1_at_its_ends(void **state)
{
    random_source r = random_from(3);
    (void)state;
    for (int i = 0; i < COUNT; i++) {
        float a = random_between(&r, -10.0f, 10.0f), b = random_between(&r, 11.0f, 20.0f);
        expect_bits(nkw_inverse_lerp(a, b, a), 0.0f);
        expect_bits(nkw_inverse_lerp(a, b, b), 1.0f);
        expect_bits(nkw_lerp(b, a, nkw_inverse_lerp(a, b, a)), b);
        expect_bits(nkw_lerp(b, a, nkw_inverse_lerp(a, b, b)), a);
    }
}

static void sincos_gives_the_bits_of_sin_and_cos(void **state)
{
    random_source r = random_from(4);
    (void)state;
    for (int i = 0; i < COUNT; i++) {
        float sine, cosine, x = random_finite(&r);
        nkw_sincos(x, &sine, &cosine);
        expect_bits(sine, nkw_sin(x));
        expect_bits(cosine, nkw_cos(x));
    }
}

static void sincos_may_write_both_to_one_float(void **state)
{
    float x = 0.0f;
    (void)state;
    nkw_sincos(x, &x, &x);
    expect_bits(x, 1.0f);
}

static void sines_and_cosines_lie_on_the_unit_circle(void **state)
{
    random_source r = random_from(5);
    (void)state;
    for (int i = 0; i < COUNT; i++) {
        float x = random_finite(&r);
        double s = (double)nkw_sin(x), c = (double)nkw_cos(x);
        expect_near(s * s + c * c, 1.0, 1.3e-7);
    }
}

static void an_arc_leads_back_to_its_sine(void **state)
{
    random_source r = random_from(6);
    (void)state;
    for (int i = 0; i < COUNT; i++) {
        float x = random_between(&r, -1.0f, 1.0f);
        expect_near((double)nkw_sin(nkw_asin(x)), (double)x, 1.2e-7);
        expect_near((double)nkw_cos(nkw_acos(x)), (double)x, 1.8e-7);
        expect_near((double)nkw_asin(x) + (double)nkw_acos(x), 1.57079632679489662, 1.9e-7);
    }
}

static void a_logarithm_leads_back_to_its_number(void **state)
{
    random_source r = random_from(7);
    (void)state;
    for (int i = 0; i < COUNT; i++) {
        float x = random_between(&r, -4.0f, 4.0f);
        expect_near((double)nkw_log(nkw_exp(x)), (double)x, 2.4e-7);
    }
}

static void wrapping_twice_is_wrapping_once(void **state)
{
    random_source r = random_from(8);
    (void)state;
    for (int i = 0; i < COUNT; i++) {
        float x = random_finite(&r), period = fabsf(random_scaled(&r, -149, 127));
        float once = nkw_wrap(x, period), angle = nkw_wrap_angle(x);
        expect_bits(nkw_wrap(once, period), once);
        expect_bits(nkw_wrap_angle(angle), angle);
    }
}

/* ---- degenerate cases ---- */

static void min_and_max_give_the_second_number_for_nan(void **state)
{
    (void)state;
    expect_bits(nkw_min(NAN, 2.0f), 2.0f);
    expect_nan(nkw_min(2.0f, NAN));
    expect_bits(nkw_max(NAN, 2.0f), 2.0f);
    expect_nan(nkw_max(2.0f, NAN));
    expect_bits(nkw_min(0.0f, -0.0f), -0.0f);
    expect_bits(nkw_max(-0.0f, 0.0f), 0.0f);
}

static void clamp_takes_nan_to_the_low_end(void **state)
{
    (void)state;
    expect_bits(nkw_clamp(NAN, 2.0f, 3.0f), 2.0f);
    expect_bits(nkw_clamp(5.0f, 3.0f, 2.0f), 2.0f);
    expect_bits(nkw_clamp(NAN, 0.0f, 1.0f), 0.0f);
    expect_bits(nkw_clamp(-INFINITY, 0.0f, 1.0f), 0.0f);
    expect_bits(nkw_clamp(INFINITY, 0.0f, 1.0f), 1.0f);
    expect_bits(nkw_smoothstep(NAN), 0.0f);
}

static void abs_drops_the_sign_of_zero(void **state)
{
    (void)state;
    expect_bits(nkw_abs(-0.0f), 0.0f);
    expect_bits(nkw_abs(0.0f), 0.0f);
    expect_bits(nkw_abs(-3.0f), 3.0f);
    expect_bits(nkw_abs(-INFINITY), INFINITY);
    expect_nan(nkw_abs(NAN));
}

static void inverse_lerp_of_an_empty_range_is_0(void **state)
{
    (void)state;
    expect_bits(nkw_inverse_lerp(2.0f, 2.0f, 7.0f), 0.0f);
    expect_bits(nkw_lerp(5.0f, 6.0f, nkw_inverse_lerp(2.0f, 2.0f, 7.0f)), 5.0f);
}

static void functions_of_nan_give_nan(void **state)
{
    one_function *functions[] = {nkw_sqrt, nkw_sin, nkw_cos, nkw_tan, nkw_asin,      nkw_acos,
                                 nkw_atan, nkw_exp, nkw_log, nkw_abs, nkw_wrap_angle};
    (void)state;
    for (size_t i = 0; i < sizeof functions / sizeof functions[0]; i++)
        expect_nan(functions[i](NAN));
    expect_nan(nkw_angle_difference(NAN, 0.0f));
    expect_nan(nkw_angle_difference(0.0f, NAN));
}

static void angles_of_no_end_give_nan(void **state)
{
    one_function *functions[] = {nkw_sin, nkw_cos, nkw_tan, nkw_wrap_angle};
    (void)state;
    for (size_t i = 0; i < sizeof functions / sizeof functions[0]; i++) {
        expect_nan(functions[i](INFINITY));
        expect_nan(functions[i](-INFINITY));
    }
    expect_nan(nkw_angle_difference(INFINITY, INFINITY));
}

static void arcs_beyond_1_count_as_1(void **state)
{
    (void)state;
    expect_bits(nkw_acos(0x1.000002p0f), 0.0f);
    expect_bits(nkw_acos(-0x1.000002p0f), PI_FLOAT);
    expect_bits(nkw_acos(INFINITY), 0.0f);
    expect_bits(nkw_asin(2.0f), HALF_PI);
    expect_bits(nkw_asin(-INFINITY), -HALF_PI);
}

static void exp_ends_in_0_and_infinity(void **state)
{
    (void)state;
    expect_bits(nkw_exp(-INFINITY), 0.0f);
    expect_bits(nkw_exp(INFINITY), INFINITY);
    expect_bits(nkw_exp(FLT_MAX), INFINITY);
    expect_bits(nkw_exp(-FLT_MAX), 0.0f);
    expect_bits(nkw_exp(0x1.62e42ep6f), 0x1.ffff08p127f);
    expect_bits(nkw_exp(0x1.62e43p6f), INFINITY);
    expect_bits(nkw_exp(-0x1.9fe368p6f), 0x1p-149f);
    expect_bits(nkw_exp(-0x1.9fe36ap6f), 0.0f);
}

static void log_of_zero_and_below_is_minus_infinity_and_nan(void **state)
{
    (void)state;
    expect_bits(nkw_log(0.0f), -INFINITY);
    expect_bits(nkw_log(-0.0f), -INFINITY);
    expect_bits(nkw_log(INFINITY), INFINITY);
    expect_bits(nkw_log(1.0f), 0.0f);
    expect_nan(nkw_log(-0x1p-149f));
    expect_nan(nkw_log(-INFINITY));
    expect_nan(nkw_sqrt(-1.0f));
    expect_bits(nkw_sqrt(-0.0f), -0.0f);
}

/* ISO C99 F.9.1.4. */
static void atan2_follows_annex_f(void **state)
{
    const float pi = PI_FLOAT, half = HALF_PI, quarter = 0x1.921fb6p-1f, three = 0x1.2d97c8p1f;
    const float cases[][3] = {
        {0.0f, 0.0f, 0.0f},           {0.0f, -0.0f, pi},
        {0.0f, 3.0f, 0.0f},           {0.0f, -3.0f, pi},
        {3.0f, 0.0f, half},           {3.0f, -0.0f, half},
        {3.0f, INFINITY, 0.0f},       {3.0f, -INFINITY, pi},
        {INFINITY, 3.0f, half},       {INFINITY, -3.0f, half},
        {INFINITY, 0.0f, half},       {0.0f, INFINITY, 0.0f},
        {0.0f, -INFINITY, pi},        {INFINITY, INFINITY, quarter},
        {INFINITY, -INFINITY, three}, {0x1p-149f, -FLT_MAX, pi},
        {FLT_MAX, 0x1p-149f, half},   {0x1p-149f, FLT_MAX, 0.0f},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        expect_bits(nkw_atan2(cases[i][0], cases[i][1]), cases[i][2]);
        expect_bits(nkw_atan2(-cases[i][0], cases[i][1]), -cases[i][2]);
    }
    expect_nan(nkw_atan2(NAN, INFINITY));
    expect_nan(nkw_atan2(0.0f, NAN));
}

/* ISO C99 F.9.4.4. */
static void pow_follows_annex_f(void **state)
{
    const float inf = INFINITY;
    const float cases[][3] = {
        {0.0f, -3.0f, inf},          {-0.0f, -3.0f, -inf},
        {0.0f, -2.0f, inf},          {-0.0f, -2.5f, inf},
        {0.0f, 3.0f, 0.0f},          {-0.0f, 3.0f, -0.0f},
        {0.0f, 2.0f, 0.0f},          {-0.0f, 2.5f, 0.0f},
        {-1.0f, inf, 1.0f},          {-1.0f, -inf, 1.0f},
        {1.0f, NAN, 1.0f},           {1.0f, inf, 1.0f},
        {NAN, 0.0f, 1.0f},           {inf, -0.0f, 1.0f},
        {0.0f, 0.0f, 1.0f},          {-2.0f, 0.0f, 1.0f},
        {-2.0f, 0.5f, NAN},          {0.5f, -inf, inf},
        {-0.5f, -inf, inf},          {2.0f, -inf, 0.0f},
        {0.5f, inf, 0.0f},           {-2.0f, inf, inf},
        {-inf, -3.0f, -0.0f},        {-inf, -2.5f, 0.0f},
        {-inf, 3.0f, -inf},          {-inf, 2.5f, inf},
        {inf, -1.0f, 0.0f},          {inf, 1.0f, inf},
        {0.0f, -inf, inf},           {-0.0f, inf, 0.0f},
        {-1.0f, NAN, NAN},           {NAN, 1.0f, NAN},
        {-2.0f, 3.0f, -8.0f},        {-2.0f, 2.0f, 4.0f},
        {-1.0f, 16777215.0f, -1.0f}, {-1.0f, 16777216.0f, 1.0f},
        {-1.0f, 8388607.5f, NAN},    {2.0f, 128.0f, inf},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
        expect_bits(nkw_pow(cases[i][0], cases[i][1]), cases[i][2]);
}

static void wrap_never_gives_the_period(void **state)
{
    (void)state;
    expect_bits(nkw_wrap(-1e-30f, 1.0f), 0x1.fffffep-1f);
    expect_bits(nkw_wrap(-0x1p-149f, 3.0f), 0x1.7ffffep1f);
    expect_bits(nkw_wrap(-0x1p-149f, 0x1p-149f), 0.0f);
    expect_bits(nkw_wrap(-0.0f, 3.0f), 0.0f);
    expect_bits(nkw_wrap(-3.0f, 3.0f), 0.0f);
    expect_bits(nkw_wrap(3.0f, 3.0f), 0.0f);
}

static void wrap_without_a_period_is_nan(void **state)
{
    (void)state;
    expect_nan(nkw_wrap(1.0f, 0.0f));
    expect_nan(nkw_wrap(1.0f, -0.0f));
    expect_nan(nkw_wrap(1.0f, -1.0f));
    expect_nan(nkw_wrap(1.0f, INFINITY));
    expect_nan(nkw_wrap(1.0f, NAN));
    expect_nan(nkw_wrap(INFINITY, 1.0f));
    expect_nan(nkw_wrap(-INFINITY, INFINITY));
    expect_nan(nkw_wrap(NAN, 1.0f));
}

static void wrap_angle_keeps_the_float_nearest_to_pi(void **state)
{
    (void)state;
    expect_bits(nkw_wrap_angle(PI_FLOAT), PI_FLOAT);
    expect_bits(nkw_wrap_angle(-PI_FLOAT), 0x1.921fb4p1f);
    expect_bits(nkw_wrap_angle(0x1.921fb8p1f), -0x1.921fb2p1f);
    expect_bits(nkw_wrap_angle(-0x1.921fb4p1f), -0x1.921fb4p1f);
    expect_bits(nkw_wrap_angle(-0.0f), -0.0f);
    expect_bits(nkw_angle_difference(0.0f, PI_FLOAT), PI_FLOAT);
}

/* ---- symmetry ---- */

static void odd_functions_are_odd_in_every_bit(void **state)
{
    one_function *functions[] = {nkw_sin, nkw_tan, nkw_asin, nkw_atan};
    random_source r = random_from(9);
    (void)state;
    for (size_t f = 0; f < sizeof functions / sizeof functions[0]; f++) {
        expect_bits(functions[f](-0.0f), -0.0f);
        expect_bits(functions[f](0.0f), 0.0f);
        for (int i = 0; i < COUNT; i++) {
            float x = random_finite(&r);
            expect_bits(functions[f](-x), -functions[f](x));
        }
    }
}

static void the_cosine_is_even_in_every_bit(void **state)
{
    random_source r = random_from(10);
    (void)state;
    expect_bits(nkw_cos(-0.0f), 1.0f);
    for (int i = 0; i < COUNT; i++) {
        float x = random_finite(&r);
        expect_bits(nkw_cos(-x), nkw_cos(x));
    }
}

static void atan2_is_odd_in_y_in_every_bit(void **state)
{
    random_source r = random_from(11);
    (void)state;
    for (int i = 0; i < COUNT; i++) {
        float y = random_finite(&r), x = random_finite(&r);
        expect_bits(nkw_atan2(-y, x), -nkw_atan2(y, x));
    }
}

static void turning_back_is_the_opposite_turn(void **state)
{
    random_source r = random_from(12);
    (void)state;
    for (int i = 0; i < COUNT; i++) {
        float from = random_finite(&r), to = random_between(&r, -10.0f, 10.0f);
        float there = nkw_angle_difference(from, to), back = nkw_angle_difference(to, from);
        if (fabsf(there) < 3.1415f)
            expect_bits(back, 0.0f - there);
    }
}

/* F is the float nearest to pi, a little more than pi: from F to 0 it is nearer to go on, by 2 pi - F. */
static void half_turns_are_rounded_for_each_direction(void **state)
{
    (void)state;
    const double pi = 3.14159265358979323846;
    random_source r = random_from(13);
    const float f = (float)pi;
    expect_bits(nkw_angle_difference(0.0f, f), f);
    expect_bits(nkw_angle_difference(f, 0.0f), (float)(2.0 * pi - (double)f));
    for (int i = 0; i < COUNT; i++) {
        float from = random_between(&r, -3.0f, 3.0f), to = from + f;
        for (int way = 0; way < 2; way++) {
            double exact = way ? (double)from - (double)to : (double)to - (double)from;
            exact += exact <= -pi ? 2.0 * pi : exact > pi + 2e-7 ? -2.0 * pi : 0.0;
            float got = way ? nkw_angle_difference(to, from) : nkw_angle_difference(from, to);
            double off = fabs((double)got - exact);
            assert_true(off <= 2e-7 || fabs(off - 2.0 * pi) <= 4e-7);
        }
    }
}

static void smoothstep_is_the_same_from_both_ends(void **state)
{
    (void)state;
    for (int i = 0; i <= 4096; i++) {
        float t = (float)i / 8192.0f;
        expect_bits(nkw_smoothstep(1.0f - t), 1.0f - nkw_smoothstep(t));
    }
}

/* ---- known values ---- */

/*
 * Arguments near multiples of pi/2, and the ends of the range: values from MPFR 4.2 at 400 bits, rounded to
 * nearest. 16367173 2^72 is the float nearest to a multiple of pi/2 (Muller, Elementary Functions, 2006).
 */
static void sin_and_cos_of_hard_arguments_are_known(void **state)
{
    (void)state;
    expect_bits(nkw_sin(PI_FLOAT), -0x1.777a5cp-24f);
    expect_bits(nkw_cos(HALF_PI), -0x1.777a5cp-25f);
    expect_bits(nkw_sin(0x1p20f), 0x1.526cccp-2f);
    expect_bits(nkw_sin(FLT_MAX), -0x1.0b3366p-1f);
    expect_bits(nkw_cos(FLT_MAX), 0x1.b4bf2cp-1f);
    expect_bits(nkw_cos(0x1.f37c8ap95f), -0x1.bbdd52p-30f);
    expect_bits(nkw_tan(0x1.f37c8ap95f), -0x1.274c1cp29f);
    expect_bits(nkw_sin(0x1p-149f), 0x1p-149f);
}

/* (float) of the exact value; 2^(1/2) etc. from the On-Line Encyclopedia of Integer Sequences A002193,
 * A001113, A002162, A000796. */
static void famous_numbers_are_rounded_correctly(void **state)
{
    (void)state;
    expect_bits(nkw_sqrt(2.0f), 1.41421356237309504880f);
    expect_bits(nkw_pow(2.0f, 0.5f), 1.41421356237309504880f);
    expect_bits(nkw_exp(1.0f), 2.71828182845904523536f);
    expect_bits(nkw_log(2.0f), 0.69314718055994530942f);
    expect_bits(nkw_acos(-1.0f), 3.14159265358979323846f);
    expect_bits(nkw_acos(0.5f), 1.04719755119659774615f);
    expect_bits(nkw_asin(0.5f), 0.52359877559829887308f);
    expect_bits(nkw_atan(1.0f), 0.78539816339744830962f);
    expect_bits(nkw_sin(1.0f), 0.84147098480789650665f);
    expect_bits(nkw_cos(1.0f), 0.54030230586813971740f);
    expect_bits(nkw_tan(1.0f), 1.55740772465490223051f);
    expect_bits(nkw_degrees_from_radians(1.0f), 57.2957795130823208768f);
    expect_bits(nkw_radians_from_degrees(180.0f), 3.14159265358979323846f);
}

static void small_examples_hold(void **state)
{
    (void)state;
    expect_bits(nkw_clamp(5.0f, 1.0f, 3.0f), 3.0f);
    expect_bits(nkw_lerp(2.0f, 6.0f, 0.25f), 3.0f);
    expect_bits(nkw_inverse_lerp(2.0f, 6.0f, 3.0f), 0.25f);
    expect_bits(nkw_lerp(10.0f, 30.0f, nkw_inverse_lerp(2.0f, 6.0f, 3.0f)), 15.0f);
    expect_bits(nkw_smoothstep(0.5f), 0.5f);
    expect_bits(nkw_smoothstep(0.25f), 0.15625f);
    expect_bits(nkw_wrap(7.0f, 3.0f), 1.0f);
    expect_bits(nkw_wrap(-1.0f, 3.0f), 2.0f);
    expect_bits(nkw_pow(3.0f, 4.0f), 81.0f);
}

/* FLT_MAX = 2^128 - 2^104; modulo 3 each even power of 2 is 1, so it is 0; modulo 7: 2^128 = 4, 2^104 = 4. */
static void wrap_of_huge_quotients_is_the_integer_remainder(void **state)
{
    (void)state;
    expect_bits(nkw_wrap(FLT_MAX, 3.0f), 0.0f);
    expect_bits(nkw_wrap(FLT_MAX, 7.0f), 0.0f);
    expect_bits(nkw_wrap(0x1p100f, 3.0f), 1.0f);
    expect_bits(nkw_wrap(-0x1p100f, 3.0f), 2.0f);
    expect_bits(nkw_wrap(0x1p127f, 3.0f * 0x1p-149f), 0x1p-149f);
}

/* ---- random properties ---- */

static void lerp_stays_between_its_ends_and_never_turns_back(void **state)
{
    random_source r = random_from(13);
    (void)state;
    for (int i = 0; i < COUNT; i++) {
        float a = random_between(&r, -1.0f, 1.0f), b = random_between(&r, -1.0f, 1.0f);
        float low = nkw_min(a, b), high = nkw_max(a, b), t = random_unit(&r);
        float before = nkw_lerp(low, high, t), after = nkw_lerp(low, high, t + 0x1p-24f);
        assert_true(before >= low && after <= high && before <= after);
        assert_true(nkw_lerp(low, high, 0.5f - 0x1p-25f) <= nkw_lerp(low, high, 0.5f));
    }
}

static void lerp_and_its_inverse_agree(void **state)
{
    random_source r = random_from(14);
    (void)state;
    for (int i = 0; i < COUNT; i++) {
        float a = random_between(&r, 0.0f, 1.0f), b = random_between(&r, 2.0f, 3.0f);
        float t = random_unit(&r);
        expect_near((double)nkw_inverse_lerp(a, b, nkw_lerp(a, b, t)), (double)t, 4e-7);
    }
}

static void smoothstep_ascends_within_0_and_1(void **state)
{
    float last = 0.0f;
    (void)state;
    for (int i = -1000; i <= COUNT + 1000; i++) {
        float y = nkw_smoothstep((float)i / (float)COUNT);
        assert_true(y >= last && y <= 1.0f);
        last = y;
    }
}

static void wrapped_numbers_lie_within_the_period(void **state)
{
    random_source r = random_from(15);
    (void)state;
    for (int i = 0; i < COUNT; i++) {
        float x = random_finite(&r), period = fabsf(random_scaled(&r, -149, 127));
        float wrapped = nkw_wrap(x, period);
        assert_true(wrapped >= 0.0f && wrapped < period);
        if (x >= 0.0f)
            expect_bits(wrapped, (float)fmod((double)x, (double)period));
    }
}

static void wrapped_angles_point_the_same_way(void **state)
{
    random_source r = random_from(16);
    (void)state;
    for (int i = 0; i < COUNT; i++) {
        float x = random_finite(&r), wrapped = nkw_wrap_angle(x);
        assert_true(wrapped > -PI_FLOAT && wrapped <= PI_FLOAT);
        expect_near((double)nkw_sin(wrapped), (double)nkw_sin(x), 2e-7);
        expect_near((double)nkw_cos(wrapped), (double)nkw_cos(x), 2e-7);
    }
}

static void an_angle_plus_the_difference_points_the_other_way(void **state)
{
    random_source r = random_from(17);
    (void)state;
    for (int i = 0; i < COUNT; i++) {
        float from = random_between(&r, -3.0f, 3.0f), to = random_between(&r, -1000.0f, 1000.0f);
        float turn = nkw_angle_difference(from, to);
        assert_true(turn > -PI_FLOAT && turn <= PI_FLOAT);
        expect_near((double)nkw_sin(from + turn), (double)nkw_sin(to), 1e-6);
        expect_near((double)nkw_cos(from + turn), (double)nkw_cos(to), 1e-6);
    }
}

static void moves_end_at_the_goal(void **state)
{
    (void)state;
    expect_bits(nkw_move_towards(1.0f, 4.0f, 2.0f), 3.0f);
    expect_bits(nkw_move_towards(1.0f, -4.0f, 2.0f), -1.0f);
    expect_bits(nkw_move_towards(1.0f, 4.0f, 3.0f), 4.0f);
    expect_bits(nkw_move_towards(1.0f, 0.1f, INFINITY), 0.1f);
    expect_bits(nkw_move_towards(1.0f, 4.0f, -2.0f), 1.0f);
    assert_true(isnan(nkw_move_towards(1.0f, NAN, 1.0f)));
    assert_true(isnan(nkw_move_towards(1.0f, 2.0f, NAN)));
}

static void equal_within_includes_the_tolerance(void **state)
{
    (void)state;
    assert_true(nkw_equal_within(1.0f, 1.5f, 0.5f));
    assert_false(nkw_equal_within(1.0f, 1.5f, 0.4f));
    assert_true(nkw_equal_within(INFINITY, INFINITY, 0.0f));
    assert_false(nkw_equal_within(INFINITY, -INFINITY, 1.0f));
    assert_false(nkw_equal_within(NAN, NAN, INFINITY));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lerp_gives_its_ends_exactly),
        cmocka_unit_test(lerp_goes_on_beyond_its_ends),
        cmocka_unit_test(lerp_between_equal_numbers_gives_that_number),
        cmocka_unit_test(inverse_lerp_gives_0_and_1_at_its_ends),
        cmocka_unit_test(sincos_gives_the_bits_of_sin_and_cos),
        cmocka_unit_test(sincos_may_write_both_to_one_float),
        cmocka_unit_test(sines_and_cosines_lie_on_the_unit_circle),
        cmocka_unit_test(an_arc_leads_back_to_its_sine),
        cmocka_unit_test(a_logarithm_leads_back_to_its_number),
        cmocka_unit_test(wrapping_twice_is_wrapping_once),
        cmocka_unit_test(min_and_max_give_the_second_number_for_nan),
        cmocka_unit_test(clamp_takes_nan_to_the_low_end),
        cmocka_unit_test(abs_drops_the_sign_of_zero),
        cmocka_unit_test(inverse_lerp_of_an_empty_range_is_0),
        cmocka_unit_test(functions_of_nan_give_nan),
        cmocka_unit_test(angles_of_no_end_give_nan),
        cmocka_unit_test(arcs_beyond_1_count_as_1),
        cmocka_unit_test(exp_ends_in_0_and_infinity),
        cmocka_unit_test(log_of_zero_and_below_is_minus_infinity_and_nan),
        cmocka_unit_test(atan2_follows_annex_f),
        cmocka_unit_test(pow_follows_annex_f),
        cmocka_unit_test(wrap_never_gives_the_period),
        cmocka_unit_test(wrap_without_a_period_is_nan),
        cmocka_unit_test(wrap_angle_keeps_the_float_nearest_to_pi),
        cmocka_unit_test(odd_functions_are_odd_in_every_bit),
        cmocka_unit_test(the_cosine_is_even_in_every_bit),
        cmocka_unit_test(atan2_is_odd_in_y_in_every_bit),
        cmocka_unit_test(turning_back_is_the_opposite_turn),
        cmocka_unit_test(half_turns_are_rounded_for_each_direction),
        cmocka_unit_test(smoothstep_is_the_same_from_both_ends),
        cmocka_unit_test(sin_and_cos_of_hard_arguments_are_known),
        cmocka_unit_test(famous_numbers_are_rounded_correctly),
        cmocka_unit_test(small_examples_hold),
        cmocka_unit_test(wrap_of_huge_quotients_is_the_integer_remainder),
        cmocka_unit_test(lerp_stays_between_its_ends_and_never_turns_back),
        cmocka_unit_test(lerp_and_its_inverse_agree),
        cmocka_unit_test(smoothstep_ascends_within_0_and_1),
        cmocka_unit_test(wrapped_numbers_lie_within_the_period),
        cmocka_unit_test(wrapped_angles_point_the_same_way),
        cmocka_unit_test(an_angle_plus_the_difference_points_the_other_way),
        cmocka_unit_test(moves_end_at_the_goal),
        cmocka_unit_test(equal_within_includes_the_tolerance),
    };
    return cmocka_run_group_tests_name("scalar", tests, NULL, NULL);
}
