/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "random.h"
#include "support/expect.h"

#define MOST 513

static nkw_curve_frame frame_from_up(nkw_vec3 tangent, nkw_vec3 up)
{
    const nkw_vec3_motion point = {{0, 0, 0}, tangent, {0, 0, 0}};
    return nkw_curve_frame_frenet(&point, up);
}

static nkw_vec3 vec3(float x, float y, float z)
{
    nkw_vec3 r = {x, y, z};
    return r;
}

static void expect_frame(const nkw_curve_frame *f)
{
    expect_near(nkw_vec3_length(f->tangent), 1, 2e-7);
    expect_near(nkw_vec3_length(f->normal), 1, 2e-7);
    expect_vec3_near(nkw_vec3_cross(f->tangent, f->normal), f->binormal, 3e-7);
    expect_near(nkw_vec3_dot(f->tangent, f->normal), 0, 2e-7);
}

/* (cos a, sin a, a/2) for a = 0 .. turns 2 pi, in Hermite segments. */
static void helix(nkw_vec3_cubic *cubics, size_t count, double turns)
{
    const double step = turns * 6.283185307179586 / (double)count;
    for (size_t k = 0; k < count; k++)
        for (size_t end = 0; end < 2; end++) {
            double a = step * (double)(k + end);
            cubics[k].c[2 * end] = vec3((float)cos(a), (float)sin(a), (float)(a / 2));
            cubics[k].c[2 * end + 1] = vec3((float)(-step * sin(a)), (float)(step * cos(a)), (float)(step / 2));
        }
}

/* A circle about `axis` z in `count` segments. */
static void circle(nkw_vec3_cubic *cubics, size_t count)
{
    helix(cubics, count, 1);
    for (size_t k = 0; k < count; k++)
        for (size_t i = 0; i < 4; i++)
            cubics[k].c[i].z = 0;
    cubics[count - 1].c[2] = cubics[0].c[0];
    cubics[count - 1].c[3] = cubics[0].c[1];
}

static void frenet_of_a_helix_points_to_its_axis(void **state)
{
    (void)state;
    for (int i = 0; i < 100; i++) {
        double a = 0.1 * i;
        nkw_vec3_motion p = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
        p.velocity = vec3((float)-sin(a), (float)cos(a), 0.5f);
        p.acceleration = vec3((float)-cos(a), (float)-sin(a), 0);
        nkw_curve_frame f = nkw_curve_frame_frenet(&p, vec3(0, 0, 0));
        expect_frame(&f);
        expect_vec3_near(f.normal, p.acceleration, 3e-7);
    }
}

static void frenet_at_an_inflection_keeps_the_normal(void **state)
{
    (void)state;
    nkw_vec3_motion p = {{0, 0, 0}, {2, 0, 0}, {-3, 0, 0}};
    nkw_curve_frame f = nkw_curve_frame_frenet(&p, vec3(5, 0, 2));
    expect_frame(&f);
    expect_vec3_bits(f.normal, vec3(0, 0, 1));
    f = nkw_curve_frame_frenet(&p, vec3(7, 0, 0)); /* nothing perpendicular */
    expect_frame(&f);
    p.acceleration = vec3(0, 0, 0);
    f = nkw_curve_frame_frenet(&p, vec3(0, -1, 0));
    expect_vec3_bits(f.normal, vec3(0, -1, 0));
    p.velocity = vec3(0, 0, 0);
    f = nkw_curve_frame_frenet(&p, vec3(0, 0, 0));
    expect_vec3_bits(f.tangent, vec3(1, 0, 0));
    expect_frame(&f);
    p.acceleration = vec3(0, 3, 0);
    f = nkw_curve_frame_frenet(&p, vec3(1, 1, 0));
    expect_vec3_bits(f.tangent, vec3(0, 1, 0));
    expect_vec3_bits(f.normal, vec3(1, 0, 0));
}

static nkw_vec3 tangent_at(nkw_cubic_kind kind, const nkw_vec3_cubic *c, float t)
{
    nkw_polycurve curve = {c, 1, kind};
    nkw_segment at = {0, t};
    nkw_curve_frame f = nkw_polycurve_frenet(&curve, at, vec3(0, 1, 0));
    expect_frame(&f);
    return f.tangent;
}

static void a_curve_at_rest_has_its_direction(void **state)
{
    (void)state;
    const nkw_vec3 z = {0, 0, 1}, o = {0, 0, 0}, a = {0, 0, 5}, b = {0, 0, 10};
    nkw_vec3_cubic end = {{o, a, b, b}}, start = {{o, o, a, b}}, both = {{o, o, b, b}}, half = {{o, b, o, b}};
    nkw_vec3_cubic cube = {{o, o, o, b}}, slowing = {{b, o, o, o}}, hermite = {{o, a, b, o}}, point = {{a, a, a, a}};
    expect_vec3_near(tangent_at(NKW_CUBIC_BEZIER, &end, 1), z, 0);
    expect_vec3_near(tangent_at(NKW_CUBIC_BEZIER, &start, 0), z, 0);
    expect_vec3_near(tangent_at(NKW_CUBIC_BEZIER, &both, 0), z, 0);
    expect_vec3_near(tangent_at(NKW_CUBIC_BEZIER, &both, 1), z, 0);
    expect_vec3_near(tangent_at(NKW_CUBIC_BEZIER, &half, 0.5f), z, 0);
    expect_vec3_near(tangent_at(NKW_CUBIC_BEZIER, &cube, 0), z, 0);
    expect_vec3_near(tangent_at(NKW_CUBIC_BEZIER, &slowing, 1), vec3(0, 0, -1), 0);
    expect_vec3_near(tangent_at(NKW_CUBIC_HERMITE, &hermite, 1), z, 0);
    expect_vec3_near(tangent_at(NKW_CUBIC_BEZIER, &point, 1), vec3(1, 0, 0), 0);
    nkw_polycurve none = {&point, 0, NKW_CUBIC_BEZIER}, one = {&end, 1, NKW_CUBIC_BEZIER};
    nkw_segment at = {7, 1};
    expect_vec3_near(nkw_polycurve_frenet(&none, at, z).tangent, vec3(1, 0, 0), 0);
    expect_vec3_near(nkw_polycurve_frenet(&one, at, o).tangent, z, 0);
}

/* The frame at rest is the limit of those beside it; elsewhere it is that of the derivatives. */
static void frames_at_rest_are_limits(void **state)
{
    (void)state;
    random_source r = random_from(9);
    for (int i = 0; i < 2000; i++) {
        float side = i % 2 ? 1.0f : 0.0f;
        nkw_vec3 p = random_vec3(&r, -1, 1), q = random_vec3(&r, -1, 1), v = random_vec3(&r, -2, 2), o = {0, 0, 0};
        nkw_vec3_cubic c = {{p, i % 2 ? v : o, q, i % 2 ? o : v}};
        nkw_polycurve curve = {&c, 1, NKW_CUBIC_HERMITE};
        nkw_segment at = {0, side}, beside = {0, i % 2 ? 1 - 0x1p-10f : 0x1p-10f}, inside = {0, random_unit(&r)};
        nkw_curve_frame f = nkw_polycurve_frenet(&curve, at, o), g = nkw_polycurve_frenet(&curve, beside, o);
        nkw_vec3_motion middle = nkw_polycurve_evaluate(&curve, inside), rest = nkw_polycurve_evaluate(&curve, at);
        expect_frame(&f);
        if (nkw_vec3_length(nkw_vec3_cross(rest.acceleration, nkw_vec3_sub(middle.acceleration, rest.acceleration))) < 0.5f)
            continue;
        expect_vec3_near(f.tangent, g.tangent, 0.05);
        expect_vec3_near(f.normal, g.normal, 0.2);
        f = nkw_polycurve_frenet(&curve, inside, v);
        g = nkw_curve_frame_frenet(&middle, v);
        expect_vec3_near(f.tangent, g.tangent, 1e-6);
    }
}

/* Not along the chord of the last step. */
static void frames_follow_a_curve_that_comes_to_rest(void **state)
{
    (void)state;
    nkw_vec3_cubic c = {{{0, 0, 0}, {0, 0, 0}, {1, 1, 0}, {1, 1, 0}}};
    c.c[1] = vec3(2, -1, 0);
    nkw_polycurve curve = {&c, 1, NKW_CUBIC_BEZIER};
    nkw_curve_frame frames[2];
    nkw_vec3 t = nkw_vec3_normalize(nkw_vec3_sub(c.c[3], c.c[1]));
    assert_int_equal(nkw_polycurve_frames(&curve, 1, vec3(0, 0, 1), NKW_POLYCURVE_OPEN, frames, 2), NKW_OK);
    expect_vec3_near(frames[1].tangent, t, 2e-7);
    expect_vec3_near(frames[1].normal, vec3(0, 0, 1), 2e-7);
}

static void a_frame_from_up_is_near_up(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int i = 0; i < 1000; i++) {
        nkw_vec3 t = random_vec3(&r, -3, 3), up = random_vec3(&r, -3, 3);
        nkw_curve_frame f = frame_from_up(t, up);
        expect_frame(&f);
        assert_true(nkw_vec3_dot(f.normal, up) >= 0);
        expect_near(nkw_vec3_dot(f.binormal, up), 0, 2e-6);
    }
    nkw_curve_frame same = frame_from_up(vec3(0, 0, 2), vec3(0, 0, 1)),
                    none = frame_from_up(vec3(0, 0, 0), vec3(0, 0, 0));
    expect_frame(&same);
    expect_frame(&none);
}

static void transport_without_a_turn_keeps_the_frame(void **state)
{
    (void)state;
    random_source r = random_from(2);
    for (int i = 0; i < 500; i++) {
        nkw_vec3 t = random_direction(&r), a = random_vec3(&r, -3, 3), zero = {0, 0, 0};
        nkw_curve_frame f = frame_from_up(t, random_direction(&r));
        nkw_curve_frame g = nkw_curve_frame_transport(&f, a, nkw_vec3_add(a, random_vec3(&r, -1, 1)), f.tangent);
        expect_frame(&g);
        g = nkw_curve_frame_transport(&f, a, nkw_vec3_add_scaled(a, t, 0.5f), t);
        expect_vec3_near(g.normal, f.normal, 2e-6);
        g = nkw_curve_frame_transport(&f, a, a, zero);
        expect_vec3_bits(g.normal, f.normal);
        g = nkw_curve_frame_transport(&f, a, a, t);
        expect_vec3_near(g.normal, f.normal, 3e-7);
        g = nkw_curve_frame_transport(&f, a, nkw_vec3_add(a, t), zero); /* the tangent is the step */
        expect_vec3_near(g.tangent, t, 1e-6);
    }
}

/* Without a step: the least rotation from one tangent to the other, which is that of nkw_quat_from_vectors. */
static void transport_in_place_is_the_least_rotation(void **state)
{
    (void)state;
    random_source r = random_from(3);
    for (int i = 0; i < 500; i++) {
        nkw_vec3 a = random_direction(&r), b = random_direction(&r), zero = {0, 0, 0};
        nkw_curve_frame f = frame_from_up(a, random_direction(&r));
        nkw_curve_frame g = nkw_curve_frame_transport(&f, zero, zero, b);
        if (nkw_vec3_dot(a, b) > -0.99f)
            expect_vec3_near(g.normal, nkw_quat_rotate(nkw_quat_from_vectors(a, b), f.normal), 1e-5);
    }
}

static void transported_back_it_is_the_frame_again(void **state)
{
    (void)state;
    random_source r = random_from(4);
    for (int i = 0; i < 500; i++) {
        nkw_vec3 a = random_vec3(&r, -2, 2), b = random_vec3(&r, -2, 2), t = random_direction(&r);
        nkw_curve_frame f = frame_from_up(t, random_direction(&r));
        nkw_curve_frame there = nkw_curve_frame_transport(&f, a, b, random_direction(&r));
        nkw_curve_frame back = nkw_curve_frame_transport(&there, b, a, f.tangent);
        expect_vec3_near(back.normal, f.normal, 2e-5);
    }
}

/* The angle of the Frenet normal about the tangent, from the normal of f. On a helix it grows evenly. */
static double angle_to_axis(const nkw_curve_frame *f, double a)
{
    nkw_vec3 inward = vec3((float)-cos(a), (float)-sin(a), 0);
    return atan2((double)nkw_vec3_dot(f->binormal, inward), (double)nkw_vec3_dot(f->normal, inward));
}

/* Torsion 1/2 / (1 + 1/4) over arc length sqrt(5)/2 a: tau s = a/sqrt(5). */
static double helix_error(size_t steps)
{
    static nkw_vec3_cubic cubics[64];
    static nkw_curve_frame frames[MOST];
    nkw_polycurve curve = {cubics, 64, NKW_CUBIC_HERMITE};
    helix(cubics, 64, 2);
    assert_int_equal(nkw_polycurve_frames(&curve, steps, vec3(-1, 0, 0), NKW_POLYCURVE_OPEN, frames, MOST), NKW_OK);
    size_t last = 64 * steps;
    for (size_t i = 0; i <= last; i++)
        expect_frame(&frames[i]);
    double end = 2 * 6.283185307179586, turned = angle_to_axis(&frames[last], end) - end / sqrt(5);
    return fabs(remainder(turned - angle_to_axis(&frames[0], 0), 6.283185307179586));
}

static void frames_of_a_helix_turn_back_by_its_torsion(void **state)
{
    (void)state;
    /* The cubics are a helix to within 1e-5 of its torsion; the frames are those of the cubics, of order 4. */
    double limit = helix_error(8), one = fabs(helix_error(1) - limit), two = fabs(helix_error(2) - limit);
    assert_true(limit < 1e-5);
    assert_true(one < 1e-5 && two < one / 10);
}

static void frames_of_a_plane_curve_keep_the_binormal(void **state)
{
    (void)state;
    random_source r = random_from(5);
    for (int i = 0; i < 50; i++) {
        nkw_vec3_cubic c[3];
        nkw_curve_frame frames[25];
        for (int k = 0; k < 12; k++) {
            c[k / 4].c[k % 4] = random_vec3(&r, -2, 2);
            c[k / 4].c[k % 4].z = 0;
        }
        nkw_polycurve curve = {c, 3, NKW_CUBIC_BEZIER};
        assert_int_equal(nkw_polycurve_frames(&curve, 8, vec3(0, 0, 1), NKW_POLYCURVE_OPEN, frames, 25), NKW_OK);
        for (int k = 0; k < 25; k++)
            expect_vec3_near(frames[k].normal, vec3(0, 0, 1), 1e-6);
    }
}

static void frames_of_a_closed_curve_close(void **state)
{
    (void)state;
    random_source r = random_from(6);
    for (int i = 0; i < 50; i++) {
        nkw_vec3_cubic c[8];
        nkw_curve_frame open[65], closed[65];
        circle(c, 8);
        for (int k = 0; k < 8; k++) {
            float z = random_between(&r, -1, 1);
            c[k].c[2].z = z;
            c[(k + 1) % 8].c[0].z = z;
        }
        nkw_polycurve curve = {c, 8, NKW_CUBIC_HERMITE};
        nkw_segment before_end = {7, 0.875f};
        assert_int_equal(nkw_polycurve_frames(&curve, 8, vec3(0, 0, 1), NKW_POLYCURVE_OPEN, open, 65), NKW_OK);
        assert_int_equal(nkw_polycurve_frames(&curve, 8, vec3(0, 0, 1), NKW_POLYCURVE_CLOSED, closed, 65), NKW_OK);
        expect_vec3_bits(closed[64].normal, closed[0].normal);
        expect_vec3_bits(closed[64].binormal, closed[0].binormal);
        double gap = nkw_vec3_angle(open[64].normal, open[0].normal);
        for (int k = 0; k < 65; k++) {
            expect_frame(&closed[k]);
            assert_true((double)nkw_vec3_angle(open[k].normal, closed[k].normal) <= gap + 1e-5);
        }
        /* The last step is as small as the others: the frame before the end is turned by nearly all of the gap. */
        nkw_curve_frame last = nkw_curve_frame_transport(&closed[63], nkw_polycurve_evaluate(&curve, before_end).value,
                                                         c[0].c[0], closed[64].tangent);
        assert_true((double)nkw_vec3_angle(last.normal, closed[64].normal) <= gap / 16 + 1e-5);
    }
}

static void a_point_has_frames(void **state)
{
    (void)state;
    nkw_vec3 p = {1, 2, 3};
    nkw_vec3_cubic still = {{p, p, p, p}};
    nkw_curve_frame frames[5];
    nkw_polycurve curve = {&still, 1, NKW_CUBIC_BEZIER};
    for (int ends = 0; ends < 3; ends++) {
        assert_int_equal(nkw_polycurve_frames(&curve, 4, vec3(0, 1, 0), (nkw_polycurve_ends)ends, frames, 5), NKW_OK);
        for (int i = 0; i < 5; i++) {
            expect_vec3_bits(frames[i].tangent, vec3(1, 0, 0));
            expect_vec3_bits(frames[i].normal, vec3(0, 1, 0));
        }
    }
}

static void frames_check_their_arguments(void **state)
{
    (void)state;
    nkw_vec3_cubic c[2];
    nkw_curve_frame frames[5];
    helix(c, 2, 1);
    nkw_polycurve curve = {c, 2, NKW_CUBIC_HERMITE}, none = {c, 0, NKW_CUBIC_HERMITE};
    frames[0].tangent = vec3(9, 9, 9);
    assert_int_equal(nkw_polycurve_frames(&none, 2, vec3(0, 0, 1), NKW_POLYCURVE_OPEN, frames, 5), NKW_EMPTY);
    assert_int_equal(nkw_polycurve_frames(&curve, 0, vec3(0, 0, 1), NKW_POLYCURVE_OPEN, frames, 5), NKW_EMPTY);
    assert_int_equal(nkw_polycurve_frames(&curve, 2, vec3(0, 0, 1), NKW_POLYCURVE_OPEN, frames, 4), NKW_TOO_SMALL);
    assert_int_equal(nkw_polycurve_frames(&curve, 2, vec3(0, 0, 1), NKW_POLYCURVE_OPEN, frames, 0), NKW_TOO_SMALL);
    expect_vec3_bits(frames[0].tangent, vec3(9, 9, 9));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(frenet_of_a_helix_points_to_its_axis),
        cmocka_unit_test(frenet_at_an_inflection_keeps_the_normal),
        cmocka_unit_test(a_curve_at_rest_has_its_direction),
        cmocka_unit_test(frames_at_rest_are_limits),
        cmocka_unit_test(frames_follow_a_curve_that_comes_to_rest),
        cmocka_unit_test(a_frame_from_up_is_near_up),
        cmocka_unit_test(transport_without_a_turn_keeps_the_frame),
        cmocka_unit_test(transport_in_place_is_the_least_rotation),
        cmocka_unit_test(transported_back_it_is_the_frame_again),
        cmocka_unit_test(frames_of_a_helix_turn_back_by_its_torsion),
        cmocka_unit_test(frames_of_a_plane_curve_keep_the_binormal),
        cmocka_unit_test(frames_of_a_closed_curve_close),
        cmocka_unit_test(a_point_has_frames),
        cmocka_unit_test(frames_check_their_arguments),
    };
    return cmocka_run_group_tests_name("polycurve_frames", tests, NULL, NULL);
}
