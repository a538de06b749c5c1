/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdint.h>

#include "random.h"
#include "support/expect.h"

static float weigh(nkw_weights w, float c0, float c1, float c2, float c3)
{
    const nkw_vec3_cubic c = {{{c0, 0.0f, 0.0f}, {c1, 0.0f, 0.0f}, {c2, 0.0f, 0.0f}, {c3, 0.0f, 0.0f}}};
    return nkw_vec3_cubic_sum(&c, w).x;
}

static nkw_handle_segment segment(float t0, float v0, nkw_handle out, nkw_handle in, float t1, float v1)
{
    nkw_handle_segment s = {t0, v0, out, in, t1, v1};
    return s;
}

/* From (0, 0) to (1, 1) with handles of lengths p, q in time and a, b in value. */
static nkw_handle_segment unit(float p, float a, float q, float b)
{
    nkw_handle out = {p, a}, in = {-q, -b};
    return segment(0.0f, 0.0f, out, in, 1.0f, 1.0f);
}

static nkw_handle_segment random_segment(random_source *r, float most)
{
    nkw_handle out = {random_between(r, 0.0f, most), random_between(r, -3, 3)};
    nkw_handle in = {-random_between(r, 0.0f, most), random_between(r, -3, 3)};
    float t0 = random_between(r, -20, 20), h = random_between(r, 0.01f, 4);
    out.time *= h;
    in.time *= h;
    return segment(t0, random_between(r, -9, 9), out, in, t0 + h, random_between(r, -9, 9));
}

/* ---- By other means: in long double, from the control points ---- */

static long double bezier(long double a, long double b, long double c, long double d, long double s)
{
    long double r = 1 - s;
    return r * r * r * a + 3 * r * r * s * b + 3 * r * s * s * c + s * s * s * d;
}

static long double time_of(const nkw_handle_segment *c, long double s)
{
    return bezier(c->time0, (long double)c->time0 + c->out.time, (long double)c->time1 + c->in.time, c->time1, s);
}

static long double value_of(const nkw_handle_segment *c, long double s)
{
    return bezier(c->value0, (long double)c->value0 + c->out.value, (long double)c->value1 + c->in.value, c->value1, s);
}

/* Bisection; for segments that do not run back. */
static long double solved(const nkw_handle_segment *c, long double time)
{
    long double low = 0, high = 1;
    for (int i = 0; i < 80; i++) {
        long double s = (low + high) / 2;
        if (time_of(c, s) < time)
            low = s;
        else
            high = s;
    }
    return high;
}

/* ---- Identities ---- */

static void handles_of_a_third_are_the_hermite_curve(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int i = 0; i < 20000; i++) {
        float t0 = (float)(i % 5), h = (i % 3) ? 3.0f : 0.75f, v0 = random_between(&r, -4, 4),
              v1 = random_between(&r, -4, 4);
        float m0 = random_between(&r, -4, 4), m1 = random_between(&r, -4, 4), t = random_unit(&r);
        nkw_handle out = {h / 3.0f, m0 / 3.0f}, in = {-h / 3.0f, -m1 / 3.0f};
        nkw_handle_segment s = segment(t0, v0, out, in, t0 + h, v1);
        nkw_motion p = nkw_handle_sample(&s, t0 + h * t);
        t = ((t0 + h * t) - t0) / h;
        nkw_weights first = nkw_cubic_weights(NKW_CUBIC_HERMITE, 1, t),
                    second = nkw_cubic_weights(NKW_CUBIC_HERMITE, 2, t);
        expect_near(p.value, nkw_hermite(v0, m0, v1, m1, t), 4e-6);
        expect_near(p.velocity * h, weigh(first, v0, m0, v1, m1), 2e-5);
        expect_near(p.acceleration * h * h, weigh(second, v0, m0, v1, m1), 2e-4);
    }
}

static void keys_come_back_bit_for_bit_at_their_own_time(void **state)
{
    (void)state;
    random_source r = random_from(2);
    for (int i = 0; i < 5000; i++) {
        nkw_handle_segment s = random_segment(&r, 2.0f);
        expect_bits(nkw_handle_sample(&s, s.time0).value, s.value0);
        expect_bits(nkw_handle_sample(&s, s.time1).value, s.value1);
        expect_bits(nkw_handle_parameter(&s, s.time0), 0.0f);
        expect_bits(nkw_handle_parameter(&s, s.time1), 1.0f);
        expect_near(nkw_handle_sample(&s, s.time0).velocity, s.out.value / s.out.time,
                    1e-6 * fabsf(s.out.value / s.out.time));
        expect_near(nkw_handle_sample(&s, s.time1).velocity, s.in.value / s.in.time,
                    1e-6 * fabsf(s.in.value / s.in.time));
    }
}

static void a_constant_curve_is_constant(void **state)
{
    (void)state;
    random_source r = random_from(3);
    for (int i = 0; i < 5000; i++) {
        nkw_handle_segment s = random_segment(&r, 2.0f);
        s.value1 = s.value0;
        s.out.value = s.in.value = 0.0f;
        nkw_motion p = nkw_handle_sample(&s, random_between(&r, s.time0, s.time1));
        expect_bits(p.value, s.value0);
        expect_near(p.velocity, 0.0f, 0.0f);
    }
}

/* Where the curve does not run back, bisection finds the same parameter. */
static void the_solver_agrees_with_bisection(void **state)
{
    (void)state;
    random_source r = random_from(4);
    for (int i = 0; i < 20000; i++) {
        nkw_handle_segment s = random_segment(&r, i % 2 ? 1.0f : 0.6f);
        float time = random_between(&r, s.time0, s.time1);
        long double at = solved(&s, time);
        nkw_motion p = nkw_handle_sample(&s, time);
        expect_near(nkw_handle_parameter(&s, time), (double)at, 1e-6);
        expect_near(p.value, (double)value_of(&s, at), 1e-5);
    }
}

static void derivatives_are_those_of_finite_differences(void **state)
{
    (void)state;
    random_source r = random_from(5);
    const long double e = 1e-5L;
    for (int i = 0; i < 4000; i++) {
        nkw_handle_segment s = random_segment(&r, 0.7f);
        float h = s.time1 - s.time0, time = s.time0 + h * random_between(&r, 0.1f, 0.9f);
        long double at[3], d = e * h;
        for (int k = 0; k < 3; k++)
            at[k] = value_of(&s, solved(&s, time + (k - 1) * d));
        nkw_motion p = nkw_handle_sample(&s, time);
        double first = (double)((at[2] - at[0]) / (2 * d)), second = (double)((at[2] - 2 * at[1] + at[0]) / (d * d));
        double size = 9.0 / h;
        expect_near(p.velocity, first, 1e-5 * (size + fabs(first)));
        expect_near(p.acceleration, second, 1e-3 * (size / h + fabs(second)));
    }
}

/* ---- Every pair of handles ---- */

static const float lengths[] = {-1e30f,  -2.0f,       -1.0f, -0.5f,      -1e-3f, -1e-20f, 0.0f,       1e-30f,
                                1e-6f,   0.1f,        0.25f, 0.3333333f, 0.42f,  0.5f,    0.58f,      0.75f,
                                0.9999f, 0.99999994f, 1.0f,  1.0001f,    1.1f,   1.25f,   1.3333333f, 1.3333334f,
                                1.5f,    2.0f,        3.0f,  10.0f,      1e6f,   1e20f,   1e30f};
enum { LENGTHS = sizeof lengths / sizeof lengths[0] };

/* The curve has the time at a parameter within the step of a float, and not at one before. */
static void expect_first_at(const nkw_handle_segment *c, float time, long double size)
{
    const long double e = 1e-6L * size;
    long double s = nkw_handle_parameter(c, time), low = INFINITY, high = -INFINITY;
    for (int i = -4; i <= 4; i++) {
        long double x = time_of(c, s + 1.5e-8L * i);
        low = fminl(low, x);
        high = fmaxl(high, x);
    }
    int is_first = 1;
    for (int i = 1; i < 100; i++)
        is_first &= s < 1e-3L || time_of(c, (s - 1e-3L) * i / 100) <= time + e;
    if (low > time + e || high < time - e || !is_first) {
        print_error("p %a q %a time %a s %La\n", (double)c->out.time, -(double)c->in.time, (double)time, s);
        fail();
    }
}

static void it_converges_for_every_pair_of_handles(void **state)
{
    (void)state;
    for (int a = 0; a < LENGTHS; a++)
        for (int b = 0; b < LENGTHS; b++)
            for (int k = 1; k < 97; k++) {
                nkw_handle_segment s = unit(lengths[a], 0.0f, lengths[b], 0.0f);
                float time = k < 48 ? (float)k / 48.0f : k < 74 ? ldexpf(1.0f, 47 - k) : 1.0f - ldexpf(1.0f, 73 - k);
                expect_first_at(&s, time, fmaxf(1.0f, fmaxf(fabsf(lengths[a]), fabsf(lengths[b]))));
            }
}

static void zero_length_handles_have_the_slope_of_the_next_point(void **state)
{
    (void)state;
    nkw_handle_segment both = unit(0, 0, 0, 0), first = unit(0, 0, 0.25f, 0.5f);
    for (int k = 0; k <= 8; k++) {
        nkw_motion p = nkw_handle_sample(&both, (float)k / 8.0f);
        expect_near(p.value, (double)k / 8, 1e-7);
        expect_near(p.velocity, 1, 1e-6);
        expect_near(p.acceleration, 0, 1e-5);
    }
    /* The next control point is (0.75, 0.5). */
    expect_near(nkw_handle_sample(&first, 0.0f).velocity, 0.5f / 0.75f, 1e-6);
    expect_bits(nkw_handle_sample(&first, 0.0f).acceleration, INFINITY);
    nkw_handle_segment last = unit(0.25f, 0.5f, 0, 0), meet = unit(1, 1, 0, 0);
    expect_near(nkw_handle_sample(&last, 1.0f).velocity, 0.5f / 0.75f, 1e-6);
    expect_bits(nkw_handle_sample(&last, 1.0f).acceleration, -INFINITY);
    expect_near(nkw_handle_sample(&meet, 1.0f).velocity, 1, 1e-6);
}

static void vertical_tangents_have_an_infinite_slope(void **state)
{
    (void)state;
    nkw_handle_segment up = unit(0, 0.5f, 0, 0.5f), down = unit(0, -0.5f, 0, -0.5f), inside = unit(1, 0, 1, 0);
    expect_bits(nkw_handle_sample(&up, 0.0f).velocity, INFINITY);
    expect_bits(nkw_handle_sample(&up, 1.0f).velocity, INFINITY);
    expect_bits(nkw_handle_sample(&down, 0.0f).velocity, -INFINITY);
    expect_bits(nkw_handle_sample(&down, 1.0f).velocity, -INFINITY);
    nkw_motion middle = nkw_handle_sample(&inside, 0.5f);
    expect_bits(middle.value, 0.5f);
    expect_bits(middle.velocity, INFINITY);
    assert_true(nkw_handle_sample(&inside, 0.50001f).velocity > 100.0f);
}

static void outside_the_segment_it_holds_the_ends(void **state)
{
    (void)state;
    nkw_handle_segment s = unit(0.5f, 2, 0.5f, 3);
    const float before[3] = {0, 0, 0}, after[3] = {1, 0, 0};
    nkw_motion a = nkw_handle_sample(&s, -0.1f), b = nkw_handle_sample(&s, 1.1f), c = nkw_handle_sample(&s, INFINITY);
    expect_floats_bits(&a.value, before, 3);
    expect_floats_bits(&b.value, after, 3);
    expect_floats_bits(&c.value, after, 3);
}

static void a_segment_without_a_duration_is_a_jump(void **state)
{
    (void)state;
    nkw_handle out = {1, 1}, in = {-1, 1};
    nkw_handle_segment empty = segment(2, 5, out, in, 2, 7), back = segment(3, 5, out, in, 2, 7), halves[2];
    expect_bits(nkw_handle_sample(&empty, 1.9f).value, 5);
    expect_bits(nkw_handle_sample(&empty, 2.0f).value, 7);
    expect_bits(nkw_handle_sample(&empty, 2.0f).velocity, 0);
    expect_bits(nkw_handle_sample(&back, 2.5f).value, 7);
    expect_bits(nkw_handle_parameter(&back, 1.0f), 0);
    assert_int_equal(nkw_handle_runs_back(&back), 0);
    nkw_handle_split(&empty, 2.0f, &halves[0], &halves[1]);
    expect_bits(halves[0].value1, 7);
}

static void nan_and_infinite_times_return_nan(void **state)
{
    (void)state;
    nkw_handle_segment s = unit(0.5f, 0, 0.5f, 0), nan_handle = unit(NAN, 0, 0.5f, 0), far = unit(0.5f, 0, INFINITY, 0);
    expect_nan(nkw_handle_sample(&s, NAN).value);
    expect_nan(nkw_handle_parameter(&s, NAN));
    expect_nan(nkw_handle_sample(&nan_handle, 0.5f).value);
    expect_nan(nkw_handle_sample(&far, 0.5f).velocity);
    s.time1 = INFINITY;
    expect_nan(nkw_handle_sample(&s, 0.5f).value);
    s = unit(0.5f, NAN, 0.5f, 0);
    expect_nan(nkw_handle_sample(&s, 0.5f).value);
    expect_bits(nkw_handle_sample(&s, 0.0f).value, 0);
}

/* Each time of a segment by itself: there is no point, no parameter, no limit, and a split leaves the whole before. */
static void each_time_of_a_segment_must_be_finite(void **state)
{
    (void)state;
    const float wrong[3] = {NAN, INFINITY, -INFINITY};
    for (int i = 0; i < 12; i++) {
        nkw_handle_segment s = unit(2, 0.25f, 2, 0.25f), left, right;
        assert_int_equal(nkw_handle_runs_back(&s), 1);
        *(i % 4 == 0 ? &s.time0 : i % 4 == 1 ? &s.time1 : i % 4 == 2 ? &s.out.time : &s.in.time) = wrong[i / 4];
        expect_nan(nkw_handle_sample(&s, 0.5f).value);
        expect_nan(nkw_handle_parameter(&s, 0.5f));
        for (int policy = 0; policy < 5; policy++) {
            nkw_handle_segment same = nkw_handle_limit(&s, (nkw_handle_policy)policy);
            assert_memory_equal(&same, &s, sizeof s);
        }
        nkw_handle_split(&s, 0.5f, &left, &right);
        expect_bits(left.value0, s.value0);
        expect_bits(right.value1, s.value1);
    }
    nkw_handle_segment s = unit(2, 0.25f, 2, 0.25f), left, right;
    nkw_handle_split(&s, NAN, &left, &right);
    expect_bits(left.out.value, s.out.value);
    expect_bits(left.in.value, s.in.value);
    s.time1 = s.time0;
    for (int policy = 0; policy < 5; policy++) {
        nkw_handle_segment same = nkw_handle_limit(&s, (nkw_handle_policy)policy);
        assert_memory_equal(&same, &s, sizeof s);
    }
}

/* ---- Running back ---- */

/* Where time falls, the first value counts: at the local maximum of time the curve jumps, and never before. */
static void a_curve_that_runs_back_jumps_where_it_turns(void **state)
{
    (void)state;
    nkw_handle_segment s = unit(2, 0, 2, 0);
    assert_int_equal(nkw_handle_runs_back(&s), 1);
    float before = 0.0f;
    int jumps = 0;
    for (int k = 1; k <= 1000; k++) {
        float value = nkw_handle_sample(&s, (float)k / 1000.0f).value;
        assert_true(value > before);
        jumps += value - before > 0.1f;
        before = value;
    }
    assert_int_equal(jumps, 1);
}

/* The limits of the ellipse, each a step inside and a step outside; see OpenUSD's page on regression. */
static void the_limits_are_those_of_the_ellipse(void **state)
{
    (void)state;
    static const float edge[][2] = {{1, 0}, {1.3333333f, 0.3333333f}, {1, 1}, {0.3333333f, 1.3333333f}, {0, 1}};
    for (int i = 0; i < 5; i++) {
        nkw_handle_segment at = unit(edge[i][0], 0, edge[i][1], 0), over = at;
        assert_int_equal(nkw_handle_runs_back(&at), 0);
        over.out.time *= 1.001f;
        over.in.time *= 1.001f;
        assert_int_equal(nkw_handle_runs_back(&over), 1);
    }
    nkw_handle_segment long_only = unit(1.2f, 0, 0.0f, 0), bold = unit(1.2f, 0, 0.3f, 0),
                       away = unit(-1e-9f, 0, 0.3f, 0);
    assert_int_equal(nkw_handle_runs_back(&long_only), 1);
    assert_int_equal(nkw_handle_runs_back(&bold), 0);
    assert_int_equal(nkw_handle_runs_back(&away), 1);
}

static const nkw_handle_policy policies[3] = {NKW_HANDLE_CONTAIN, NKW_HANDLE_KEEP_RATIO, NKW_HANDLE_KEEP_START};

static void limited_handles_do_not_run_back_and_are_limited_once(void **state)
{
    (void)state;
    random_source r = random_from(6);
    for (int i = 0; i < 60000; i++) {
        nkw_handle_segment s = random_segment(&r, i % 3 ? 1.5f : 4.0f);
        s.out.time = i % 11 == 0 ? -s.out.time : i % 13 == 0 ? 0.0f : s.out.time;
        s.in.time = i % 7 == 0 ? -s.in.time : i % 17 == 0 ? -1e-30f : s.in.time;
        for (int k = 0; k < 3; k++) {
            nkw_handle_segment limited = nkw_handle_limit(&s, policies[k]),
                               again = nkw_handle_limit(&limited, policies[k]);
            assert_int_equal(nkw_handle_runs_back(&limited), 0);
            assert_memory_equal(&limited, &again, sizeof again);
            if (!nkw_handle_runs_back(&s) && policies[k] != NKW_HANDLE_CONTAIN)
                assert_memory_equal(&limited, &s, sizeof s);
        }
    }
}

static void limited_handles_keep_their_slopes(void **state)
{
    (void)state;
    random_source r = random_from(7);
    for (int i = 0; i < 20000; i++) {
        nkw_handle_segment s = random_segment(&r, 4.0f);
        for (int k = 0; k < 3; k++) {
            nkw_handle_segment limited = nkw_handle_limit(&s, policies[k]);
            double slope = (double)s.out.value / s.out.time, other = (double)s.in.value / s.in.time;
            expect_near((double)limited.out.value, slope * limited.out.time, 1e-6 * fabs(limited.out.value));
            expect_near((double)limited.in.value, other * limited.in.time, 1e-6 * fabs(limited.in.value));
        }
    }
}

static void expect_lengths(nkw_handle_segment s, nkw_handle_policy policy, double p, double q)
{
    nkw_handle_segment limited = nkw_handle_limit(&s, policy);
    expect_near(limited.out.time, p, 2e-6);
    expect_near(-limited.in.time, q, 2e-6);
}

static void each_policy_shortens_in_its_way(void **state)
{
    (void)state;
    nkw_handle_segment far = unit(2, 1, 4, 1), one = unit(3, 1, 0, 0), bold = unit(1.2f, 1, 2, 1);
    expect_lengths(far, NKW_HANDLE_NONE, 2, 4);
    expect_lengths(far, NKW_HANDLE_CONTAIN, 1, 1);
    double factor = (6 + sqrt(8.0)) / 28;
    expect_lengths(far, NKW_HANDLE_KEEP_RATIO, 2 * factor, 4 * factor);
    expect_lengths(far, NKW_HANDLE_KEEP_START, 4.0 / 3, 1.0 / 3);
    expect_lengths(one, NKW_HANDLE_KEEP_RATIO, 1, 0);
    expect_lengths(bold, NKW_HANDLE_KEEP_START, 1.2f, (0.8 + sqrt(1.2 * 0.4)) / 2);
    /* From below, the branch nearer to q: the handle becomes longer. */
    expect_lengths(unit(1.2f, 1, 0.001f, 1), NKW_HANDLE_KEEP_START, 1.2f, (0.8 - sqrt(1.2 * 0.4)) / 2);
    expect_lengths(unit(0, 0, 2, 1), NKW_HANDLE_KEEP_START, 0, 1);
    expect_lengths(unit(-1, 1, 0.5f, 1), NKW_HANDLE_KEEP_RATIO, 0, 0.5);
    expect_lengths(far, (nkw_handle_policy)77, 2, 4);
}

/* OpenUSD's baselines InitiallyRegressiveContain and KeepStart: widths and values to 6 digits. Widths of the latter are
 * shorter than the limit by 1e-5 of the duration, 11. Times of the former are met to 1e-5. */
static void openusd_shortens_the_same(void **state)
{
    (void)state;
    nkw_handle out = {15.8f, -1.3f * 15.8f}, in = {-16.8f, -0.4f * 16.8f};
    nkw_handle_segment s = segment(156, 0, out, in, 167, 28.8f), limited = nkw_handle_limit(&s, NKW_HANDLE_KEEP_START);
    expect_near(limited.out.time, 14.666557, 2e-4);
    expect_near(-limited.in.time, 3.666557, 2e-4);
    expect_near(nkw_handle_sample(&limited, 160.049751f).value, -4.041445, 2e-4);
    expect_near(nkw_handle_sample(&limited, 163.004975f).value, -4.130118, 2e-3);
    expect_near(nkw_handle_sample(&limited, 166.507463f).value, 28.210649, 2e-4);
    static const double contained[][2] = {{157.039801, -1.269597},
                                          {159.995025, -3.104126},
                                          {161.417910, 1.743242},
                                          {161.582090, 13.881955},
                                          {163.004975, 23.790394}};
    limited = nkw_handle_limit(&s, NKW_HANDLE_CONTAIN);
    expect_bits(limited.out.time, 11);
    expect_bits(limited.in.time, -11);
    for (int i = 0; i < 5; i++) {
        nkw_motion p = nkw_handle_sample(&limited, (float)contained[i][0]);
        expect_near(p.value, contained[i][1], 2e-6 + 2e-5 * fabs(p.velocity));
    }
}

/* ---- Splitting ---- */

static void both_parts_of_a_split_are_the_curve(void **state)
{
    (void)state;
    random_source r = random_from(8);
    for (int i = 0; i < 4000; i++) {
        nkw_handle_segment s = random_segment(&r, 1.0f), left, right;
        float at = random_between(&r, s.time0, s.time1);
        nkw_handle_split(&s, at, &left, &right);
        expect_bits(left.value1, nkw_handle_sample(&s, at).value);
        expect_bits(right.value0, left.value1);
        expect_bits(left.time1, at);
        for (int k = 1; k < 8; k++) {
            float time = s.time0 + (s.time1 - s.time0) * (float)k / 8.0f;
            long double whole = value_of(&s, solved(&s, time));
            long double part =
                time < at ? value_of(&left, solved(&left, time)) : value_of(&right, solved(&right, time));
            nkw_motion p = nkw_handle_sample(&s, time);
            /* Handles rounded to float: a time of 2^-24 of a second moves the value by its slope. */
            expect_near((double)part, (double)whole, 1e-5 + 1e-6 * fabs(p.velocity));
        }
    }
}

static void a_split_outside_leaves_the_whole(void **state)
{
    (void)state;
    nkw_handle_segment s = unit(0.25f, 0.5f, 0.5f, 0.125f), left, right = s;
    nkw_handle_split(&right, -3.0f, &left, &right);
    assert_memory_equal(&right, &s, sizeof s);
    expect_bits(left.time1, 0.0f);
    expect_bits(left.value1, 0.0f);
    nkw_handle_split(&s, 3.0f, &left, &right);
    assert_memory_equal(&left, &s, sizeof s);
    expect_bits(right.time0, 1.0f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(handles_of_a_third_are_the_hermite_curve),
        cmocka_unit_test(keys_come_back_bit_for_bit_at_their_own_time),
        cmocka_unit_test(a_constant_curve_is_constant),
        cmocka_unit_test(the_solver_agrees_with_bisection),
        cmocka_unit_test(derivatives_are_those_of_finite_differences),
        cmocka_unit_test(it_converges_for_every_pair_of_handles),
        cmocka_unit_test(zero_length_handles_have_the_slope_of_the_next_point),
        cmocka_unit_test(vertical_tangents_have_an_infinite_slope),
        cmocka_unit_test(outside_the_segment_it_holds_the_ends),
        cmocka_unit_test(a_segment_without_a_duration_is_a_jump),
        cmocka_unit_test(nan_and_infinite_times_return_nan),
        cmocka_unit_test(a_curve_that_runs_back_jumps_where_it_turns),
        cmocka_unit_test(the_limits_are_those_of_the_ellipse),
        cmocka_unit_test(limited_handles_do_not_run_back_and_are_limited_once),
        cmocka_unit_test(limited_handles_keep_their_slopes),
        cmocka_unit_test(each_policy_shortens_in_its_way),
        cmocka_unit_test(openusd_shortens_the_same),
        cmocka_unit_test(both_parts_of_a_split_are_the_curve),
        cmocka_unit_test(a_split_outside_leaves_the_whole),
        cmocka_unit_test(each_time_of_a_segment_must_be_finite),
    };
    return cmocka_run_group_tests_name("handle", tests, NULL, NULL);
}
