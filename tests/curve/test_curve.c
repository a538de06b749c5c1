/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "random.h"
#include "support/expect.h"

typedef float curve(float, float, float, float, float);

/* A kind of curve. Interpolating kinds pass through control values first and last. */
static const struct kind {
    nkw_cubic_kind kind;
    curve *at;
    int first, last; /* -1: passes through none */
    int affine; /* all four weights sum to 1; Hermite: those of the points */
} kinds[] = {
    {NKW_CUBIC_HERMITE, nkw_hermite, 0, 2, 0},
    {NKW_CUBIC_BEZIER, nkw_bezier, 0, 3, 1},
    {NKW_CUBIC_BSPLINE, nkw_bspline, -1, -1, 1},
    {NKW_CUBIC_CATMULL_ROM, nkw_catmull_rom, 1, 2, 1},
};

#define KINDS (sizeof kinds / sizeof kinds[0])

static void draw(random_source *r, float c[4])
{
    for (int i = 0; i < 4; i++)
        c[i] = random_between(r, -1, 1);
}

static void end_points_come_back_bit_for_bit(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (size_t k = 0; k < KINDS; k++) {
        for (int i = 0; i < 5000 && kinds[k].first >= 0; i++) {
            float c[4];
            for (int j = 0; j < 4; j++)
                c[j] = i == 0 ? -0.0f : random_scaled(&r, -60, 60);
            expect_bits(kinds[k].at(c[0], c[1], c[2], c[3], 0.0f), c[kinds[k].first]);
            expect_bits(kinds[k].at(c[0], c[1], c[2], c[3], 1.0f), c[kinds[k].last]);
        }
    }
}

static void constant_curves_are_constant(void **state)
{
    (void)state;
    random_source r = random_from(2);
    for (int i = 0; i < 20000; i++) {
        float p = random_scaled(&r, -60, 60), t = random_unit(&r);
        expect_bits(nkw_hermite(p, 0, p, 0, t), p);
        expect_near(nkw_bezier(p, p, p, p, t), p, 6.0 * 0x1p-24 * fabs((double)p));
        expect_bits(nkw_bspline(p, p, p, p, t), p);
        expect_bits(nkw_catmull_rom(p, p, p, p, t), p);
    }
}

static float weigh(nkw_weights w, float c0, float c1, float c2, float c3)
{
    const nkw_vec3_cubic c = {{{c0, 0.0f, 0.0f}, {c1, 0.0f, 0.0f}, {c2, 0.0f, 0.0f}, {c3, 0.0f, 0.0f}}};
    return nkw_vec3_cubic_sum(&c, w).x;
}

static void curve_is_the_weighted_sum(void **state)
{
    (void)state;
    random_source r = random_from(3);
    for (size_t k = 0; k < KINDS; k++) {
        for (int i = 0; i < 5000; i++) {
            float c[4], t = random_unit(&r);
            draw(&r, c);
            expect_near(kinds[k].at(c[0], c[1], c[2], c[3], t),
                        weigh(nkw_cubic_weights(kinds[k].kind, 0, t), c[0], c[1], c[2], c[3]), 1e-6);
        }
    }
}

static void weights_of_points_sum_to_one(void **state)
{
    (void)state;
    for (size_t k = 0; k < KINDS; k++) {
        for (int i = 0; i <= 1000; i++) {
            float t = (float)i / 1000;
            nkw_weights w = nkw_cubic_weights(kinds[k].kind, 0, t), v = nkw_cubic_weights(kinds[k].kind, 1, t),
                        a = nkw_cubic_weights(kinds[k].kind, 2, t);
            double other = kinds[k].affine;
            expect_near(w.w[0] + other * w.w[1] + w.w[2] + other * w.w[3], 1.0, 2e-7);
            expect_near(v.w[0] + other * v.w[1] + v.w[2] + other * v.w[3], 0.0, 1e-6);
            expect_near(a.w[0] + other * a.w[1] + a.w[2] + other * a.w[3], 0.0, 2e-6);
        }
    }
}

static void derivatives_are_the_slopes_of_the_weights(void **state)
{
    (void)state;
    const float h = 0x1p-8f;
    for (size_t k = 0; k < KINDS; k++) {
        for (int i = 1; i < 100; i++) {
            float t = (float)i / 100;
            nkw_weights before = nkw_cubic_weights(kinds[k].kind, 0, t - h),
                        at = nkw_cubic_weights(kinds[k].kind, 0, t), after = nkw_cubic_weights(kinds[k].kind, 0, t + h);
            nkw_weights v = nkw_cubic_weights(kinds[k].kind, 1, t), a = nkw_cubic_weights(kinds[k].kind, 2, t);
            for (int j = 0; j < 4; j++) {
                /* Central differences: off by h^2/6 times the third derivative, at most 18; and by rounding. */
                expect_near(v.w[j], ((double)after.w[j] - (double)before.w[j]) / (2 * (double)h), 2e-4);
                expect_near(a.w[j],
                            ((double)after.w[j] - 2 * (double)at.w[j] + (double)before.w[j]) / ((double)h * (double)h),
                            3e-2);
            }
        }
    }
}

static void weights_at_one_half_are_those_of_the_textbook(void **state)
{
    (void)state;
    const float hermite[4] = {0.5f, 0.125f, 0.5f, -0.125f}, bezier[4] = {0.125f, 0.375f, 0.375f, 0.125f};
    const float bspline[4] = {1 / 48.0f, 23 / 48.0f, 23 / 48.0f, 1 / 48.0f};
    const float catmull_rom[4] = {-0.0625f, 0.5625f, 0.5625f, -0.0625f};
    nkw_weights h = nkw_cubic_weights(NKW_CUBIC_HERMITE, 0, 0.5f), b = nkw_cubic_weights(NKW_CUBIC_BEZIER, 0, 0.5f);
    nkw_weights s = nkw_cubic_weights(NKW_CUBIC_BSPLINE, 0, 0.5f),
                c = nkw_cubic_weights(NKW_CUBIC_CATMULL_ROM, 0, 0.5f);
    expect_floats_bits(h.w, hermite, 4);
    expect_floats_bits(b.w, bezier, 4);
    expect_floats_near(s.w, bspline, 4, 3e-8);
    expect_floats_bits(c.w, catmull_rom, 4);
}

static void unknown_kinds_are_hermite_and_unknown_derivatives_none(void **state)
{
    (void)state;
    nkw_weights expected = nkw_cubic_weights(NKW_CUBIC_HERMITE, 0, 0.25f);
    nkw_weights kind = nkw_cubic_weights((nkw_cubic_kind)9, 0, 0.25f);
    nkw_weights third = nkw_cubic_weights(NKW_CUBIC_HERMITE, 3, 0.25f);
    nkw_weights negative = nkw_cubic_weights(NKW_CUBIC_HERMITE, -1, 0.25f);
    expect_floats_bits(kind.w, expected.w, 4);
    expect_floats_bits(third.w, expected.w, 4);
    expect_floats_bits(negative.w, expected.w, 4);
}

static void ends_leave_along_the_tangents(void **state)
{
    (void)state;
    nkw_weights v0 = nkw_cubic_weights(NKW_CUBIC_HERMITE, 1, 0), v1 = nkw_cubic_weights(NKW_CUBIC_HERMITE, 1, 1);
    const float first[4] = {0, 1, 0, 0}, last[4] = {0, 0, 0, 1};
    expect_floats_near(v0.w, first, 4, 0);
    expect_floats_near(v1.w, last, 4, 0);
    nkw_weights c0 = nkw_cubic_weights(NKW_CUBIC_CATMULL_ROM, 1, 0),
                c1 = nkw_cubic_weights(NKW_CUBIC_CATMULL_ROM, 1, 1);
    const float from[4] = {-0.5f, 0, 0.5f, 0}, to[4] = {0, -0.5f, 0, 0.5f};
    expect_floats_near(c0.w, from, 4, 0);
    expect_floats_near(c1.w, to, 4, 0);
}

static void bspline_segments_join_bit_for_bit(void **state)
{
    (void)state;
    random_source r = random_from(4);
    for (int i = 0; i < 20000; i++) {
        float p[5];
        for (int j = 0; j < 5; j++)
            p[j] = random_between(&r, -1, 1);
        expect_bits(nkw_bspline(p[0], p[1], p[2], p[3], 1.0f), nkw_bspline(p[1], p[2], p[3], p[4], 0.0f));
        expect_near(nkw_bspline(p[0], p[1], p[2], p[3], 0.0f), ((double)p[0] + 4 * (double)p[1] + (double)p[2]) / 6,
                    1e-7);
    }
}

static void curves_mirror(void **state)
{
    (void)state;
    random_source r = random_from(5);
    for (int i = 0; i < 20000; i++) {
        float c[4], t = random_unit(&r);
        draw(&r, c);
        expect_bits(nkw_bezier(c[0], c[1], c[2], c[3], t), nkw_bezier(c[3], c[2], c[1], c[0], 1.0f - t));
        expect_bits(nkw_bspline(c[0], c[1], c[2], c[3], t), nkw_bspline(c[3], c[2], c[1], c[0], 1.0f - t));
        expect_bits(nkw_catmull_rom(c[0], c[1], c[2], c[3], t), nkw_catmull_rom(c[3], c[2], c[1], c[0], 1.0f - t));
        expect_bits(nkw_hermite(c[0], c[1], c[2], c[3], t), nkw_hermite(c[2], -c[3], c[0], -c[1], 1.0f - t));
    }
}

static void vectors_go_by_component(void **state)
{
    (void)state;
    random_source r = random_from(6);
    for (int i = 0; i < 2000; i++) {
        nkw_vec3 a = random_vec3(&r, -1, 1), b = random_vec3(&r, -1, 1), c = random_vec3(&r, -1, 1),
                 d = random_vec3(&r, -1, 1);
        float t = random_unit(&r);
        expect_bits(nkw_vec3_hermite(a, b, c, d, t).x, nkw_hermite(a.x, b.x, c.x, d.x, t));
        expect_bits(nkw_vec3_bezier(a, b, c, d, t).y, nkw_bezier(a.y, b.y, c.y, d.y, t));
        expect_bits(nkw_vec3_bspline(a, b, c, d, t).z, nkw_bspline(a.z, b.z, c.z, d.z, t));
        expect_bits(nkw_vec3_catmull_rom(a, b, c, d, t).x, nkw_catmull_rom(a.x, b.x, c.x, d.x, t));
        nkw_weights w = nkw_cubic_weights(NKW_CUBIC_BEZIER, 0, t);
        const nkw_vec3_cubic all = {{a, b, c, d}};
        expect_bits(nkw_vec3_cubic_sum(&all, w).z, weigh(w, a.z, b.z, c.z, d.z));
    }
}

/* The curve of four keys at any times. */
static float uneven(const float times[4], float p0, float p1, float p2, float p3, float t)
{
    const float keys[4] = {p0, p1, p2, p3};
    float c[4];
    nkw_cubic_from_catmull_rom(keys, times, c);
    return nkw_hermite(c[0], c[1], c[2], c[3], t);
}

static void nonuniform_catmull_rom_over_even_times_is_the_uniform_one(void **state)
{
    (void)state;
    random_source r = random_from(7);
    const float times[4] = {2, 2.5f, 3, 3.5f};
    for (int i = 0; i < 5000; i++) {
        float c[4], t = random_unit(&r);
        draw(&r, c);
        expect_near(uneven(times, c[0], c[1], c[2], c[3], t), nkw_catmull_rom(c[0], c[1], c[2], c[3], t), 1e-6);
    }
}

/* Barry and Goldman's pyramid of linear interpolations, in double. */
static double pyramid(const float times[4], const float p[4], double time)
{
    double q[4] = {p[0], p[1], p[2], p[3]};
    for (int i = 0; i < 3; i++)
        q[i] += (q[i + 1] - q[i]) * (time - (double)times[i]) / ((double)times[i + 1] - (double)times[i]);
    for (int i = 0; i < 2; i++)
        q[i] += (q[i + 1] - q[i]) * (time - (double)times[i]) / ((double)times[i + 2] - (double)times[i]);
    return q[0] + (q[1] - q[0]) * (time - (double)times[1]) / ((double)times[2] - (double)times[1]);
}

static void nonuniform_catmull_rom_is_the_pyramid_of_barry_and_goldman(void **state)
{
    (void)state;
    random_source r = random_from(8);
    for (int i = 0; i < 5000; i++) {
        float c[4], t = random_unit(&r), times[4] = {0};
        draw(&r, c);
        for (int k = 1; k < 4; k++)
            times[k] = times[k - 1] + random_between(&r, 0.25f, 1.0f);
        double time = (double)times[1] + (double)t * ((double)times[2] - (double)times[1]);
        expect_near(uneven(times, c[0], c[1], c[2], c[3], t), pyramid(times, c, time), 4e-6);
    }
}

static void tangent_without_a_duration_takes_the_other_side(void **state)
{
    (void)state;
    const float keys[4] = {1, 2, 4, 8};
    const float even[4] = {0, 0.5f, 1, 1.5f}, first[4] = {1, 1, 1.5f, 2}, last[4] = {0, 0.5f, 1, 1},
                odd[4] = {2, 1, 2, NAN};
    const float none[4] = {3, 3, 3, 3};
    const struct {
        const float *times;
        float leaving, arriving;
    } want[5] = {{even, 1.5f, 3}, {first, 2, 3}, {last, 1.5f, 2}, {odd, 2, 2}, {none, 0, 0}};
    for (int i = 0; i < 5; i++) {
        float c[4];
        nkw_cubic_from_catmull_rom(keys, want[i].times, c);
        expect_bits(c[0], 2);
        expect_bits(c[1], want[i].leaving);
        expect_bits(c[2], 4);
        expect_bits(c[3], want[i].arriving);
    }
}

static void draw_cubic(random_source *r, nkw_vec3_cubic *c)
{
    for (int i = 0; i < 4; i++)
        c->c[i] = random_vec3(r, -1, 1);
}

static nkw_vec3 bezier_at(const nkw_vec3_cubic *b, float t)
{
    return nkw_vec3_bezier(b->c[0], b->c[1], b->c[2], b->c[3], t);
}

static void expect_cubics_near(const nkw_vec3_cubic *a, const nkw_vec3_cubic *b, double bound)
{
    for (int i = 0; i < 4; i++)
        expect_vec3_near(a->c[i], b->c[i], bound);
}

static void conversions_keep_the_curve(void **state)
{
    (void)state;
    random_source r = random_from(9);
    for (int i = 0; i < 5000; i++) {
        nkw_vec3_cubic h, s;
        float t = random_unit(&r);
        draw_cubic(&r, &h);
        draw_cubic(&r, &s);
        nkw_vec3_cubic b = nkw_vec3_cubic_convert(&h, NKW_CUBIC_HERMITE, NKW_CUBIC_BEZIER),
                       back = nkw_vec3_cubic_convert(&b, NKW_CUBIC_BEZIER, NKW_CUBIC_HERMITE);
        expect_vec3_near(bezier_at(&b, t), nkw_vec3_hermite(h.c[0], h.c[1], h.c[2], h.c[3], t), 1e-6);
        expect_cubics_near(&back, &h, 1e-6);
        b = nkw_vec3_cubic_convert(&s, NKW_CUBIC_BSPLINE, NKW_CUBIC_BEZIER);
        expect_vec3_near(bezier_at(&b, t), nkw_vec3_bspline(s.c[0], s.c[1], s.c[2], s.c[3], t), 1e-6);
    }
}

static nkw_vec3 turned_round(nkw_vec3 v)
{
    nkw_vec3 r = {v.y, v.z, v.x};
    return r;
}

static void every_kind_becomes_every_other_and_comes_back(void **state)
{
    (void)state;
    random_source r = random_from(10);
    for (int i = 0; i < 2000; i++)
        for (int from = 0; from < (int)KINDS; from++)
            for (int to = 0; to < (int)KINDS; to++) {
                nkw_cubic_kind a = (nkw_cubic_kind)from, b = (nkw_cubic_kind)to;
                nkw_vec3_cubic c, permuted;
                float t = random_unit(&r);
                draw_cubic(&r, &c);
                nkw_vec3_cubic other = nkw_vec3_cubic_convert(&c, a, b), back = nkw_vec3_cubic_convert(&other, b, a);
                expect_vec3_near(nkw_vec3_cubic_evaluate(&other, t, b).value, nkw_vec3_cubic_evaluate(&c, t, a).value,
                                 6e-6);
                expect_cubics_near(&back, &c, a == b ? 0 : 2e-5);
                for (int k = 0; k < 4; k++)
                    permuted.c[k] = turned_round(c.c[k]);
                permuted = nkw_vec3_cubic_convert(&permuted, a, b);
                for (int k = 0; k < 4; k++)
                    expect_vec3_bits(permuted.c[k], turned_round(other.c[k]));
            }
    nkw_vec3_cubic c, same;
    draw_cubic(&r, &c);
    same = nkw_vec3_cubic_convert(&c, (nkw_cubic_kind)9, NKW_CUBIC_HERMITE);
    expect_cubics_near(&same, &c, 0);
}

static void split_halves_meet_and_follow_the_whole(void **state)
{
    (void)state;
    random_source r = random_from(11);
    for (int i = 0; i < 5000; i++) {
        nkw_vec3_cubic whole, left, right;
        float cut = random_unit(&r), t = random_unit(&r);
        draw_cubic(&r, &whole);
        nkw_vec3_bezier_split(&whole, cut, &left, &right);
        expect_vec3_bits(left.c[0], whole.c[0]);
        expect_vec3_bits(left.c[3], right.c[0]);
        expect_vec3_bits(right.c[3], whole.c[3]);
        expect_vec3_near(bezier_at(&left, t), bezier_at(&whole, cut * t), 1e-6);
        expect_vec3_near(bezier_at(&right, t), bezier_at(&whole, cut + (1 - cut) * t), 1e-6);
        nkw_vec3_cubic in_place = whole, other;
        nkw_vec3_bezier_split(&in_place, cut, &in_place, &other);
        expect_cubics_near(&in_place, &left, 0);
        expect_cubics_near(&other, &right, 0);
    }
}

/* c0 + c1 s + c2 s^2. */
static nkw_vec3 parabola(const nkw_vec3 c[3], double s)
{
    const double x[3] = {c[0].x, c[1].x, c[2].x}, y[3] = {c[0].y, c[1].y, c[2].y}, z[3] = {c[0].z, c[1].z, c[2].z};
    nkw_vec3 r = {(float)(x[0] + s * (x[1] + s * x[2])), (float)(y[0] + s * (y[1] + s * y[2])),
                  (float)(z[0] + s * (z[1] + s * z[2]))};
    return r;
}

static void tangents_of_a_parabola_are_its_slope(void **state)
{
    (void)state;
    random_source r = random_from(12);
    for (int i = 0; i < 2000; i++) {
        nkw_vec3 c[3] = {random_vec3(&r, -1, 1), random_vec3(&r, -1, 1), random_vec3(&r, -1, 1)};
        float h0 = random_between(&r, 0.25f, 2), h1 = random_between(&r, 0.25f, 2);
        nkw_vec3 before = parabola(c, -(double)h0), after = parabola(c, h1);
        const nkw_vec3 keys[4] = {before, c[0], after, after};
        const float at[4] = {-h0, 0, h1, h1};
        expect_vec3_near(nkw_vec3_scale(nkw_vec3_cubic_from_catmull_rom(keys, at).c[1], 1 / h1), c[1], 4e-6);
    }
}

static void curves_go_on_beyond_their_ends(void **state)
{
    (void)state;
    static const float far[] = {-10, -1, -0x1p-24f, 1.0000001f, 2, 7.5f};
    random_source r = random_from(21);
    for (int i = 0; i < 6000; i++) {
        double t = (double)far[i % 6], s = 1 - t, size = 6 * (1 + fabs(t * t * t));
        float c[4];
        draw(&r, c);
        double a = (double)c[0], b = (double)c[1], d = (double)c[2], e = (double)c[3];
        expect_near(nkw_hermite(c[0], c[1], c[2], c[3], far[i % 6]),
                    (1 + 2 * t) * s * s * a + t * s * s * b + t * t * (3 - 2 * t) * d - t * t * s * e, 4e-7 * size);
        expect_near(nkw_bezier(c[0], c[1], c[2], c[3], far[i % 6]),
                    s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * d + t * t * t * e, 4e-7 * size);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(end_points_come_back_bit_for_bit),
        cmocka_unit_test(constant_curves_are_constant),
        cmocka_unit_test(curve_is_the_weighted_sum),
        cmocka_unit_test(weights_of_points_sum_to_one),
        cmocka_unit_test(derivatives_are_the_slopes_of_the_weights),
        cmocka_unit_test(weights_at_one_half_are_those_of_the_textbook),
        cmocka_unit_test(unknown_kinds_are_hermite_and_unknown_derivatives_none),
        cmocka_unit_test(ends_leave_along_the_tangents),
        cmocka_unit_test(bspline_segments_join_bit_for_bit),
        cmocka_unit_test(curves_mirror),
        cmocka_unit_test(vectors_go_by_component),
        cmocka_unit_test(nonuniform_catmull_rom_over_even_times_is_the_uniform_one),
        cmocka_unit_test(nonuniform_catmull_rom_is_the_pyramid_of_barry_and_goldman),
        cmocka_unit_test(tangent_without_a_duration_takes_the_other_side),
        cmocka_unit_test(conversions_keep_the_curve),
        cmocka_unit_test(every_kind_becomes_every_other_and_comes_back),
        cmocka_unit_test(split_halves_meet_and_follow_the_whole),
        cmocka_unit_test(tangents_of_a_parabola_are_its_slope),
        cmocka_unit_test(curves_go_on_beyond_their_ends),
    };
    return cmocka_run_group_tests_name("curve", tests, NULL, NULL);
}
