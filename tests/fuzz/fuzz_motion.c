/* SPDX-License-Identifier: MIT */
/* The motion kit: springs, transitions. Total on any floats; unit rotations of finite ones. */
#include "fuzz.h"

static nkw_motion draw_motion(fuzz *f)
{
    nkw_motion m = {fuzz_float(f), fuzz_float(f)};
    return m;
}

static nkw_vec3 draw_vec3(fuzz *f)
{
    nkw_vec3 v = {fuzz_float(f), fuzz_float(f), fuzz_float(f)};
    return v;
}

static nkw_quat draw_quat(fuzz *f)
{
    nkw_quat q = {fuzz_float(f), fuzz_float(f), fuzz_float(f), fuzz_float(f)};
    return fuzz_byte(f) % 2 ? nkw_quat_normalize(q) : q;
}

static nkw_motion_quat draw_rotation(fuzz *f)
{
    nkw_motion_quat m = {draw_quat(f), draw_vec3(f)};
    return m;
}

static void check_unit(nkw_quat q, int is_finite)
{
    float length = nkw_quat_length(q);
    FUZZ_CHECK((length > 0.99f && length < 1.01f) || !is_finite);
}

static int finite_rotation(const nkw_motion_quat *m)
{
    float length = nkw_quat_length(m->value);
    return length > 1e-15f && length < 1e15f && fuzz_finite(&m->velocity.x, 3);
}

static int same_motion(nkw_motion a, nkw_motion b)
{
    return fuzz_same(&a.value, &b.value, 1) && fuzz_same(&a.velocity, &b.velocity, 1);
}

static void springs(fuzz *f)
{
    nkw_spring s = {fuzz_float(f), fuzz_float(f)};
    float a = fuzz_float(f), b = fuzz_float(f), h = fuzz_float(f);
    if (fuzz_byte(f) % 2)
        s = fuzz_byte(f) % 2 ? nkw_spring_from_half_life(a, b) : nkw_spring_from_frequency(a, b);
    FUZZ_CHECK(!(nkw_spring_frequency(s) < 0.0f) && !(nkw_spring_half_life(s) < 0.0f));
    FUZZ_CHECK(!(nkw_spring_damping_ratio(s) < 0.0f));
    nkw_motion from = draw_motion(f), goal = draw_motion(f), still = from;
    nkw_motion to = nkw_spring_step(s, from, goal, h);
    FUZZ_CHECK(h > 0.0f || h != h || same_motion(from, to));
    nkw_motion_quat q = draw_rotation(f), g = draw_rotation(f), r = nkw_quat_spring_step(s, &q, &g, h);
    int known = fuzz_finite(&s.stiffness, 1) && fuzz_finite(&s.damping, 1) && fuzz_finite(&h, 1);
    check_unit(r.value, known && h > 0.0f && finite_rotation(&q) && finite_rotation(&g));
    nkw_spring_timed timed = {s, b}, copy = timed;
    nkw_spring_timed_step(&timed, &from, &still, a, h);
    nkw_quat_spring_timed_step(&copy, &q, &g, draw_quat(f), h);
    FUZZ_CHECK(timed.time_left >= 0.0f || h <= 0.0f);
    FUZZ_CHECK(fuzz_same(&timed.time_left, &copy.time_left, 1));
    nkw_damper_step(a, b, from.value, h);
    nkw_quat_damper_step(q.value, g.value, a, h);
}

static void transitions(fuzz *f)
{
    float duration = fuzz_float(f), t = fuzz_float(f);
    nkw_motion from = draw_motion(f), to = draw_motion(f);
    nkw_inertia x = nkw_inertia_begin(from, to, duration);
    FUZZ_CHECK(x.duration >= 0.0f || x.duration != x.duration);
    FUZZ_CHECK(x.duration <= duration || x.duration == 0.0f || duration != duration);
    FUZZ_CHECK(t < x.duration || t != t || x.duration != x.duration ||
               same_motion(nkw_inertia_evaluate(x, to, t), to) || t <= 0.0f);
    nkw_motion_quat q = draw_rotation(f), g = draw_rotation(f);
    nkw_inertia_vec3 y = nkw_quat_inertia_begin(&q, &g, duration);
    nkw_motion_quat r = nkw_quat_inertia_evaluate(&y, &g, t);
    nkw_dead_blend_quat d = {q, fuzz_float(f), duration, draw_quat(f)};
    nkw_motion_quat blended = nkw_quat_dead_blend_evaluate(&d, &g, t);
    float length = nkw_quat_length(g.value);
    int known = finite_rotation(&q) && finite_rotation(&g) && length > 0.999f && length < 1.001f;
    check_unit(r.value, known);
    check_unit(blended.value,
               known && fuzz_finite(&d.half_life, 1) && fuzz_finite(&d.difference.x, 4) && fuzz_finite(&t, 1));
    nkw_motion_vec3 u = {draw_vec3(f), draw_vec3(f)}, v = {draw_vec3(f), draw_vec3(f)};
    nkw_inertia_vec3 z = nkw_vec3_inertia_begin(&u, &v, duration);
    nkw_vec3_inertia_evaluate(&z, &v, t);
    nkw_dead_blend_vec3 e = {u, fuzz_float(f), duration};
    nkw_vec3_dead_blend_evaluate(&e, &v, t);
    nkw_dead_blend_half_life(from, to.value, t, duration, x.c[0]);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz f = fuzz_begin(data, size);
    springs(&f);
    transitions(&f);
    return fuzz_end(&f);
}
