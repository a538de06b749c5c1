/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "random.h"
#include "support/expect.h"

#define METHODS (NKW_SPLINE_C2 + 1)
#define MOST    16

/* Eight keys of one number; the expected tangents are those of SciPy 1.10 except MAKIMA (of the formula). */
static const float times8[8] = {0, 0.5f, 1.25f, 2, 2.5f, 4, 4.75f, 6}, values8[8] = {0, 1, 0.5f, 0.5f, 3, 2.75f, -1, 0};

static nkw_spline numbers(const float *times, const float *values, size_t count, nkw_spline_method method)
{
    nkw_spline s = {times, values, count, 1, 1, method, NKW_SPLINE_ENDS_FREE, 0, NULL, NULL};
    return s;
}

/* The tangents before and after the keys of a spline that has no error. */
static void tangents_of(const nkw_spline *s, float *in, float *out)
{
    NKW_STACK_WORK(work, NKW_SPLINE_WORK(3 * MOST));
    nkw_tangent_span to = {in, out, s->width};
    size_t bad = 7;
    assert_int_equal(nkw_spline_tangents(s, to, &bad, work), NKW_OK);
    assert_int_equal(bad, 0);
}

static void draw_keys(random_source *r, float *times, float *values, size_t count)
{
    for (size_t k = 0; k < count; k++) {
        times[k] = k ? times[k - 1] + random_between(r, 0.125f, 2) : random_between(r, -2, 2);
        values[k] = random_between(r, -4, 4);
    }
}

static void expect_tangents(const nkw_spline *s, const double *want)
{
    float in[MOST], out[MOST];
    tangents_of(s, in, out);
    for (size_t k = 0; k < s->count; k++) {
        expect_near(in[k], want[k], 3e-7);
        expect_bits(out[k], in[k]);
    }
}

static void tangents_are_those_of_scipy(void **state)
{
    (void)state;
    static const struct {
        nkw_spline_method method;
        nkw_spline_ends ends;
        double want[8];
    } rows[] = {
        {NKW_SPLINE_PCHIP, NKW_SPLINE_ENDS_FREE, {3.0666666666666669, 0, 0, 0, 0, -0.36, 0, 2.4}},
        {NKW_SPLINE_AKIMA,
         NKW_SPLINE_ENDS_FREE,
         {3.3333333333333330, -0.13333333333333339, -0.43478260869565216, 0.57142857142857129, 2.3728813559322037,
          -2.4437689969604866, -2.3636363636363638, 3.7}},
        {NKW_SPLINE_MAKIMA,
         NKW_SPLINE_ENDS_FREE,
         {2.7407407407407409, -0.2857142857142857, -0.46153846153846156, 0.58252427184466016, 2.402234636871508,
          -2.5339074273412274, -2.4571428571428573, 2.775}},
        {NKW_SPLINE_C2,
         NKW_SPLINE_ENDS_FREE,
         {2.5205717819694713, 0.95885643606105764, -1.5751398532594947, 3.3417029769769209, 4.9110833122499278,
          -4.8137754289301817, -3.2642153693344209, 2.8321076846672097}},
        {NKW_SPLINE_C2,
         NKW_SPLINE_ENDS_CLAMPED,
         {2, 1.1230334857981816, -1.6151674289909086, 3.3376362301654532, 4.9513241854424299, -5.1235021740358011,
          -2.3551555706138134, -1.5}},
        {NKW_SPLINE_C2,
         NKW_SPLINE_ENDS_PERIODIC,
         {2.6135566098121163, 0.92936292782107766, -1.5671495538235627, 3.3392352874731732, 4.9139820776384653,
          -4.8295624835272406, -3.2183035882375095, 2.6135566098121163}},
    };
    static const float ends[2] = {2, -1.5f};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        nkw_spline s = numbers(times8, values8, 8, rows[i].method);
        s.ends = rows[i].ends;
        s.end_tangents = ends;
        expect_tangents(&s, rows[i].want);
    }
}

static void two_and_three_keys_have_the_tangents_of_scipy(void **state)
{
    (void)state;
    static const double akima[3] = {3.3333333333333333, 0.66666666666666652, -2},
                        pchip[3] = {3.0666666666666667, 0, -2};
    static const double two[2] = {2, 2}, periodic[3] = {0.66666666666666674, 0.66666666666666674, 0.66666666666666674};
    static const float round[3] = {0, 1, 0};
    nkw_spline s = numbers(times8, values8, 3, NKW_SPLINE_AKIMA);
    expect_tangents(&s, akima);
    s.method = NKW_SPLINE_PCHIP;
    expect_tangents(&s, pchip);
    nkw_spline closed = numbers(times8, round, 3, NKW_SPLINE_C2);
    closed.ends = NKW_SPLINE_ENDS_PERIODIC;
    expect_tangents(&closed, periodic);
    for (int method = 0; method < METHODS; method++) {
        nkw_spline line = numbers(times8, values8, 2, (nkw_spline_method)method);
        expect_tangents(&line, two);
    }
}

static void a_separate_key_has_no_tangent(void **state)
{
    (void)state;
    static const double none[1] = {0};
    for (int method = 0; method < METHODS; method++)
        for (int ends = 0; ends <= NKW_SPLINE_ENDS_PERIODIC; ends++) {
            nkw_spline s = numbers(times8, values8 + 4, 1, (nkw_spline_method)method);
            s.ends = (nkw_spline_ends)ends;
            expect_tangents(&s, none);
        }
}

/* The tangent per segment at the middle of three keys. */
static float through(const float *v, const float *t)
{
    const float keys[4] = {v[0], v[1], v[2], v[2]}, times[4] = {t[0], t[1], t[2], t[2]};
    float c[4];
    nkw_cubic_from_catmull_rom(keys, times, c);
    return c[1];
}

static void catmull_rom_has_the_tangents_of_the_curve(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int i = 0; i < 500; i++) {
        float t[MOST], v[MOST], in[MOST], out[MOST];
        draw_keys(&r, t, v, 8);
        nkw_spline s = numbers(t, v, 8, NKW_SPLINE_CATMULL_ROM);
        tangents_of(&s, in, out);
        for (size_t k = 1; k < 7; k++)
            expect_near(in[k], through(v + k - 1, t + k - 1) / (t[k + 1] - t[k]), 4e-5);
        expect_near(in[0], ((double)v[1] - (double)v[0]) / ((double)t[1] - (double)t[0]), 4e-6);
    }
}

static void tcb_of_zeros_is_cardinal_and_their_tension_is_the_same(void **state)
{
    (void)state;
    random_source r = random_from(2);
    for (int i = 0; i < 500; i++) {
        float t[MOST], v[MOST], in[MOST], out[MOST], cardinal[MOST];
        nkw_tcb tcb[8];
        draw_keys(&r, t, v, 8);
        nkw_spline s = numbers(t, v, 8, NKW_SPLINE_CARDINAL);
        s.tension = i % 2 ? random_between(&r, -1, 1) : 0;
        for (size_t k = 0; k < 8; k++) {
            const nkw_tcb same = {s.tension, 0, 0};
            tcb[k] = same;
        }
        tangents_of(&s, cardinal, cardinal);
        s.method = NKW_SPLINE_TCB;
        s.tcb = i % 2 ? tcb : NULL;
        tangents_of(&s, in, out);
        expect_floats_near(in, cardinal, 8, 4e-6);
        expect_floats_bits(in, out, 8);
    }
}

/* Kochanek and Bartels, equations 8 and 9, of differences in place of slopes: even times of 1 s. */
static void tcb_over_even_times_is_that_of_the_paper(void **state)
{
    (void)state;
    random_source r = random_from(3);
    static const float even[3] = {0, 1, 2};
    for (int i = 0; i < 2000; i++) {
        float v[3], in[3], out[3];
        nkw_tcb keys[3];
        for (size_t k = 0; k < 3; k++) {
            const nkw_tcb key = {random_between(&r, -1, 1), random_between(&r, -1, 1), random_between(&r, -1, 1)};
            keys[k] = key;
            v[k] = random_between(&r, -1, 1);
        }
        nkw_spline s = numbers(even, v, 3, NKW_SPLINE_TCB);
        s.tcb = keys;
        tangents_of(&s, in, out);
        double t = keys[1].tension, c = keys[1].continuity, b = keys[1].bias, d0 = (double)v[1] - (double)v[0],
               d1 = (double)v[2] - (double)v[1];
        expect_near(in[1], (1 - t) * (1 - c) * (1 + b) / 2 * d0 + (1 - t) * (1 + c) * (1 - b) / 2 * d1, 1e-6);
        expect_near(out[1], (1 - t) * (1 + c) * (1 + b) / 2 * d0 + (1 - t) * (1 - c) * (1 - b) / 2 * d1, 1e-6);
    }
}

static void tcb_of_continuity_minus_one_is_a_polygon(void **state)
{
    (void)state;
    static const nkw_tcb corner[3] = {{0, -1, 0}, {0, -1, 0}, {0, -1, 0}};
    static const float even[3] = {0, 0.5f, 1}, v[3] = {1, 2, -1};
    float in[3], out[3];
    nkw_spline s = numbers(even, v, 3, NKW_SPLINE_TCB);
    s.tcb = corner;
    tangents_of(&s, in, out);
    expect_bits(in[1], 2);
    expect_bits(out[1], -6);
}

static void evenly_spaced_keys_on_a_line_have_its_slope(void **state)
{
    (void)state;
    float t[MOST], v[MOST], in[MOST], out[MOST];
    for (size_t k = 0; k < MOST; k++) {
        t[k] = 0.25f * (float)k - 1;
        v[k] = 3 - 0.75f * (float)k;
    }
    for (int method = 0; method < METHODS; method++) {
        nkw_spline s = numbers(t, v, MOST, (nkw_spline_method)method);
        tangents_of(&s, in, out);
        for (size_t k = 0; k < MOST; k++) {
            expect_near(in[k], -3, 1e-6);
            expect_near(out[k], -3, 1e-6);
        }
    }
}

static void reversed_keys_have_the_opposite_tangents(void **state)
{
    (void)state;
    random_source r = random_from(4);
    for (int i = 0; i < 60 * METHODS; i++) {
        float t[8], v[8], back_t[8], back_v[8], in[8], out[8], back_in[8], back_out[8];
        draw_keys(&r, t, v, 8);
        for (size_t k = 0; k < 8; k++) {
            back_t[7 - k] = -t[k];
            back_v[7 - k] = v[k];
        }
        nkw_spline s = numbers(t, v, 8, (nkw_spline_method)(i % METHODS)),
                   back = numbers(back_t, back_v, 8, (nkw_spline_method)(i % METHODS));
        s.ends = back.ends = i % 2 ? NKW_SPLINE_ENDS_FREE : NKW_SPLINE_ENDS_PERIODIC;
        tangents_of(&s, in, out);
        tangents_of(&back, back_in, back_out);
        for (size_t k = 0; k < 8; k++) {
            expect_near(in[k], -(double)back_out[7 - k], 1e-5);
            expect_near(out[k], -(double)back_in[7 - k], 1e-5);
        }
    }
}

/* Ten periods, a middle one of which must be the one. */
static void periodic_keys_are_those_of_many_periods(void **state)
{
    (void)state;
    random_source r = random_from(5);
    for (int i = 0; i < 40 * METHODS; i++) {
        nkw_spline_method method = (nkw_spline_method)(i % METHODS);
        float t[5], v[5], in[5], out[5], all_t[41], all_v[41], all_in[41], all_out[41];
        size_t periods = 10, n = 4;
        for (size_t k = 0; k <= n; k++) {
            t[k] = k ? t[k - 1] + (float)(1 + random_bits(&r) % 8) / 8 : 0;
            v[k] = k < n ? random_between(&r, -4, 4) : v[0];
        }
        for (size_t k = 0; k <= periods * n; k++) {
            all_t[k] = t[n] * (float)(k / n) + t[k % n];
            all_v[k] = v[k % n];
        }
        nkw_spline s = numbers(t, v, n + 1, method), all = numbers(all_t, all_v, periods * n + 1, method);
        s.ends = NKW_SPLINE_ENDS_PERIODIC;
        tangents_of(&s, in, out);
        tangents_of(&all, all_in, all_out);
        /* C2: the effect of the ends vanishes within five periods. */
        for (size_t k = 0; k <= n; k++) {
            expect_near(in[k], all_in[5 * n + k], 1e-5);
            expect_near(out[k], all_out[5 * n + k], 1e-5);
        }
    }
}

static void equal_times_divide_the_keys(void **state)
{
    (void)state;
    random_source r = random_from(6);
    for (int i = 0; i < 40 * METHODS; i++) {
        float t[9], v[9], in[9], out[9], part_in[9], part_out[9];
        draw_keys(&r, t, v, 9);
        size_t jump = 1 + random_bits(&r) % 8;
        t[jump] = t[jump - 1]; /* 0 .. jump - 1, and from jump on */
        nkw_spline s = numbers(t, v, 9, (nkw_spline_method)(i % METHODS)), part = s;
        tangents_of(&s, in, out);
        part.count = jump;
        tangents_of(&part, part_in, part_out);
        expect_floats_bits(in, part_in, jump);
        expect_floats_bits(out, part_out, jump);
        nkw_spline rest = numbers(t + jump, v + jump, 9 - jump, s.method);
        tangents_of(&rest, part_in, part_out);
        expect_floats_bits(in + jump, part_in, 9 - jump);
        expect_floats_bits(out + jump, part_out, 9 - jump);
    }
}

/* A CUBICSPLINE track of a spline of numbers. */
static nkw_track track_of(const nkw_spline *s, float *triples)
{
    nkw_track track = {s->times, triples, s->count, s->width, NKW_TRACK_FLOATS, NKW_INTERPOLATION_CUBICSPLINE, NULL};
    nkw_tangent_span to = {triples, triples + 2 * s->width, 3 * s->width};
    NKW_STACK_WORK(work, NKW_SPLINE_WORK(MOST));
    for (size_t k = 0; k < s->count; k++)
        for (size_t c = 0; c < s->width; c++)
            triples[k * 3 * s->width + s->width + c] = s->values[k * s->stride + c];
    assert_int_equal(nkw_spline_tangents(s, to, NULL, work), NKW_OK);
    assert_int_equal(nkw_track_validate(&track, NULL), NKW_OK);
    return track;
}

static void pchip_does_not_leave_the_values_of_its_keys(void **state)
{
    (void)state;
    random_source r = random_from(7);
    for (int i = 0; i < 200; i++) {
        float t[8], v[8], triples[24];
        draw_keys(&r, t, v, 8);
        nkw_spline s = numbers(t, v, 8, NKW_SPLINE_PCHIP);
        nkw_track track = track_of(&s, triples);
        for (size_t k = 0; k < 7; k++) {
            float before = v[k], low = fminf(v[k], v[k + 1]), high = fmaxf(v[k], v[k + 1]);
            for (int j = 1; j <= 32; j++) {
                float at;
                nkw_track_sample(&track, t[k] + (t[k + 1] - t[k]) * (float)j / 32, NULL, &at);
                assert_true(at >= low - 2e-6f && at <= high + 2e-6f);
                assert_true(v[k] < v[k + 1] ? at >= before - 2e-6f : at <= before + 2e-6f);
                before = at;
            }
        }
    }
}

/* Just before and just after each key. */
static void c2_has_a_continuous_acceleration(void **state)
{
    (void)state;
    random_source r = random_from(8);
    for (int i = 0; i < 300; i++) {
        float t[8], v[8], triples[24], velocity, before, after;
        const nkw_motion_span from = {NULL, &velocity, &before}, to = {NULL, &velocity, &after};
        draw_keys(&r, t, v, 8);
        v[7] = v[0];
        nkw_spline s = numbers(t, v, 8, NKW_SPLINE_C2);
        s.ends = (nkw_spline_ends)(i % 3);
        nkw_track track = track_of(&s, triples), first = track, last = track;
        for (size_t k = 1; k < 7; k++) {
            first.count = k + 1; /* ends at key k: the derivative of the segment before */
            assert_int_equal(nkw_track_sample_motion(&first, t[k], from), NKW_OK);
            assert_int_equal(nkw_track_sample_motion(&track, t[k], to), NKW_OK);
            expect_bits(velocity, triples[3 * k + 2]);
            expect_near(before, after, 2e-3);
        }
        nkw_track_sample_motion(&track, t[0], to);
        nkw_track_sample_motion(&last, t[7], from);
        if (s.ends == NKW_SPLINE_ENDS_PERIODIC)
            expect_near(before, after, 2e-3);
        if (s.ends == NKW_SPLINE_ENDS_FREE) {
            expect_near(before, 0, 2e-3);
            expect_near(after, 0, 2e-3);
        }
    }
}

static void centripetal_over_its_knots_is_catmull_rom(void **state)
{
    (void)state;
    random_source r = random_from(9);
    for (int i = 0; i < 400; i++) {
        float points[24], knots[8], in[24], out[24], want[24];
        for (size_t j = 0; j < 24; j++)
            points[j] = random_between(&r, -4, 4);
        nkw_spline s = {knots, points, 8, 3, 3, NKW_SPLINE_CATMULL_ROM, NKW_SPLINE_ENDS_FREE, 0, NULL, NULL};
        nkw_spline_knots(&s, i % 2 ? 0.5f : 1.0f, knots);
        tangents_of(&s, want, want);
        s.method = i % 2 ? NKW_SPLINE_CENTRIPETAL : NKW_SPLINE_CHORDAL;
        tangents_of(&s, in, out);
        expect_floats_near(in, want, 24, 4e-5);
        expect_floats_near(out, want, 24, 4e-5);
    }
}

/* The direction is the same on both sides, in any times. */
static void centripetal_keys_have_one_direction(void **state)
{
    (void)state;
    random_source r = random_from(10);
    for (int i = 0; i < 400; i++) {
        float points[24], t[8], v[8], in[24], out[24];
        draw_keys(&r, t, v, 8);
        for (size_t j = 0; j < 24; j++)
            points[j] = random_between(&r, -4, 4);
        nkw_spline s = {t, points, 8, 3, 3, NKW_SPLINE_CENTRIPETAL, NKW_SPLINE_ENDS_FREE, 0, NULL, NULL};
        tangents_of(&s, in, out);
        for (size_t k = 0; k < 8; k++) {
            nkw_vec3 a = {in[3 * k], in[3 * k + 1], in[3 * k + 2]}, b = {out[3 * k], out[3 * k + 1], out[3 * k + 2]};
            expect_vec3_near(nkw_vec3_normalize(a), nkw_vec3_normalize(b), 1e-6);
        }
    }
}

static void coincident_points_have_finite_tangents(void **state)
{
    (void)state;
    static const float same[5] = {1, 1, 1, 4, 4};
    float in[5], out[5];
    for (int method = 0; method < METHODS; method++) {
        nkw_spline s = numbers(times8, same, 5, (nkw_spline_method)method);
        tangents_of(&s, in, out);
        for (size_t k = 0; k < 5; k++)
            assert_true(in[k] - in[k] == 0 && out[k] - out[k] == 0);
        if (method != NKW_SPLINE_C2)
            expect_near(out[0], 0, 0);
    }
}

static void vectors_go_by_component_and_stride(void **state)
{
    (void)state;
    random_source r = random_from(11);
    for (int i = 0; i < 40 * METHODS; i++) {
        nkw_spline_method method = (nkw_spline_method)(i % METHODS);
        nkw_keyframe keys[6];
        float t[6], y[6], in[18], out[18], y_in[6], y_out[6];
        draw_keys(&r, t, y, 6);
        for (size_t k = 0; k < 6; k++) {
            const nkw_vec3 p = {2 * y[k], y[k], -y[k]}; /* in line, so that knots differ by a factor only */
            keys[k].position = p;
        }
        nkw_spline s = {t,      &keys[0].position.x,  6, 3,    sizeof keys[0] / sizeof(float),
                        method, NKW_SPLINE_ENDS_FREE, 0, NULL, NULL};
        tangents_of(&s, in, out);
        nkw_spline one = numbers(t, y, 6, method);
        tangents_of(&one, y_in, y_out);
        for (size_t k = 0; k < 6; k++) {
            expect_near(in[3 * k + 1], y_in[k], 1e-5);
            expect_near(out[3 * k + 1], y_out[k], 1e-5);
            expect_near(in[3 * k], 2 * (double)y_in[k], 2e-5);
        }
    }
}

static void tangents_beyond_floats_are_the_largest(void **state)
{
    (void)state;
    static const float t[3] = {0, 0x1p-140f, 1}, v[3] = {-3e38f, 3e38f, 0};
    for (int method = 0; method < METHODS; method++) {
        float in[3], out[3];
        nkw_spline s = numbers(t, v, 3, (nkw_spline_method)method);
        tangents_of(&s, in, out);
        for (size_t k = 0; k < 3; k++)
            assert_true(in[k] - in[k] == 0 && out[k] - out[k] == 0);
    }
}

static void times_one_ulp_apart_have_the_slope_between_them(void **state)
{
    (void)state;
    const float t[3] = {1, nextafterf(1, 2), nextafterf(nextafterf(1, 2), 2)}, v[3] = {0, 0.5f, 1};
    for (int method = 0; method < METHODS; method++) {
        nkw_spline s = numbers(t, v, 3, (nkw_spline_method)method);
        static const double slope[3] = {0x1p22, 0x1p22, 0x1p22};
        expect_tangents(&s, slope);
    }
}

/* Of a parabola, which each tangent of a clamped C2 spline has exactly. */
static void ten_thousand_keys_are_solved(void **state)
{
    (void)state;
    enum { MANY = 10000 };
    static float t[MANY], v[MANY], in[MANY];
    NKW_STACK_WORK(work, NKW_SPLINE_WORK(MANY));
    const float ends[2] = {0, 2};
    for (size_t k = 0; k < MANY; k++) {
        t[k] = (float)k / (MANY - 1);
        v[k] = (float)((double)t[k] * (double)t[k]);
    }
    nkw_spline s = {t, v, MANY, 1, 1, NKW_SPLINE_C2, NKW_SPLINE_ENDS_CLAMPED, 0, NULL, ends};
    nkw_tangent_span to = {in, in, 1};
    assert_int_equal(nkw_spline_tangents(&s, to, NULL, work), NKW_OK);
    for (size_t k = 0; k < MANY; k++)
        expect_near(in[k], 2 * (double)t[k], 2e-3); /* values are rounded, durations are 1e-4 */
}

/* What a spline of two keys of two numbers answers; the tangents must stay as they were. */
static void expect_refused(const nkw_spline *s, size_t stride, size_t bytes, nkw_result result, size_t bad)
{
    float in[8] = {9, 9, 9, 9, 9, 9, 9, 9}, out[8] = {9, 9, 9, 9, 9, 9, 9, 9};
    NKW_STACK_WORK(all, NKW_SPLINE_WORK(8));
    const nkw_work work = {all.data, bytes};
    nkw_tangent_span to = {in, out, stride};
    size_t at = 99;
    assert_int_equal(nkw_spline_tangents(s, to, &at, work), result);
    assert_int_equal(at, bad);
    assert_int_equal(nkw_spline_tangents(s, to, NULL, work), result);
    for (size_t i = 0; i < 8; i++)
        assert_true(in[i] == 9 && out[i] == 9);
}

static void shapes_are_checked(void **state)
{
    (void)state;
    const nkw_spline sound = numbers(times8, values8, 4, NKW_SPLINE_C2);
    nkw_spline s = sound;
    s.count = 0;
    expect_refused(&s, 1, NKW_SPLINE_WORK(8), NKW_EMPTY, 0);
    s = sound;
    s.width = 0;
    expect_refused(&s, 1, NKW_SPLINE_WORK(8), NKW_EMPTY, 0);
    s = sound;
    s.method = (nkw_spline_method)METHODS;
    expect_refused(&s, 1, NKW_SPLINE_WORK(8), NKW_BAD_METHOD, 0);
    s = sound;
    s.ends = (nkw_spline_ends)3;
    expect_refused(&s, 1, NKW_SPLINE_WORK(8), NKW_BAD_METHOD, 0);
    s = sound;
    s.stride = 0;
    expect_refused(&s, 1, NKW_SPLINE_WORK(8), NKW_BAD_WIDTH, 0);
    expect_refused(&sound, 0, NKW_SPLINE_WORK(8), NKW_BAD_WIDTH, 0);
    expect_refused(&sound, 1, NKW_SPLINE_WORK(4) - 1, NKW_TOO_SMALL, 0);
    float in[4] = {9, 9, 9, 9};
    NKW_STACK_WORK(work, NKW_SPLINE_WORK(5));
    const nkw_work odd = {(unsigned char *)work.data + 8, NKW_SPLINE_WORK(4)}, none = {NULL, NKW_SPLINE_WORK(4)};
    const nkw_tangent_span to = {in, in, 1};
    assert_int_equal(nkw_spline_tangents(&sound, to, NULL, odd), NKW_TOO_SMALL);
    assert_int_equal(nkw_spline_tangents(&sound, to, NULL, none), NKW_TOO_SMALL);
    assert_true(in[0] == 9 && in[3] == 9);
    nkw_spline huge = sound;
    huge.count = SIZE_MAX / 8;
    assert_int_equal(nkw_spline_tangents(&huge, to, NULL, work), NKW_TOO_SMALL);
}

static void keys_are_checked(void **state)
{
    (void)state;
    static const float infinite[4] = {0, 1, 2, INFINITY}, descending[4] = {0, 1, 0.5f, 2}, ends[2] = {0, NAN};
    static const nkw_tcb keys[4] = {{0, 0, 0}, {0, NAN, 0}, {0, 0, 0}, {0, 0, 0}};
    nkw_spline s = numbers(times8, infinite, 4, NKW_SPLINE_AKIMA);
    expect_refused(&s, 1, 0, NKW_NOT_FINITE, 3);
    s = numbers(infinite, values8, 4, NKW_SPLINE_AKIMA);
    expect_refused(&s, 1, 0, NKW_NOT_FINITE, 3);
    s = numbers(descending, values8, 4, NKW_SPLINE_AKIMA);
    expect_refused(&s, 1, 0, NKW_NOT_ASCENDING, 2);
    s = numbers(times8, values8, 4, NKW_SPLINE_TCB);
    s.tcb = keys;
    expect_refused(&s, 1, 0, NKW_NOT_FINITE, 1);
    s = numbers(times8, values8, 4, NKW_SPLINE_CARDINAL);
    s.tension = NAN;
    expect_refused(&s, 1, 0, NKW_NOT_FINITE, 0);
    s.tension = 0;
    s.ends = NKW_SPLINE_ENDS_CLAMPED;
    s.end_tangents = ends;
    expect_refused(&s, 1, 0, NKW_NOT_FINITE, 3);
    static const float first[2] = {INFINITY, 0};
    s.end_tangents = first;
    expect_refused(&s, 1, 0, NKW_NOT_FINITE, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tangents_are_those_of_scipy),
        cmocka_unit_test(two_and_three_keys_have_the_tangents_of_scipy),
        cmocka_unit_test(a_separate_key_has_no_tangent),
        cmocka_unit_test(catmull_rom_has_the_tangents_of_the_curve),
        cmocka_unit_test(tcb_of_zeros_is_cardinal_and_their_tension_is_the_same),
        cmocka_unit_test(tcb_over_even_times_is_that_of_the_paper),
        cmocka_unit_test(tcb_of_continuity_minus_one_is_a_polygon),
        cmocka_unit_test(evenly_spaced_keys_on_a_line_have_its_slope),
        cmocka_unit_test(reversed_keys_have_the_opposite_tangents),
        cmocka_unit_test(periodic_keys_are_those_of_many_periods),
        cmocka_unit_test(equal_times_divide_the_keys),
        cmocka_unit_test(pchip_does_not_leave_the_values_of_its_keys),
        cmocka_unit_test(c2_has_a_continuous_acceleration),
        cmocka_unit_test(centripetal_over_its_knots_is_catmull_rom),
        cmocka_unit_test(centripetal_keys_have_one_direction),
        cmocka_unit_test(coincident_points_have_finite_tangents),
        cmocka_unit_test(vectors_go_by_component_and_stride),
        cmocka_unit_test(tangents_beyond_floats_are_the_largest),
        cmocka_unit_test(times_one_ulp_apart_have_the_slope_between_them),
        cmocka_unit_test(ten_thousand_keys_are_solved),
        cmocka_unit_test(shapes_are_checked),
        cmocka_unit_test(keys_are_checked),
    };
    return cmocka_run_group_tests_name("spline", tests, NULL, NULL);
}
