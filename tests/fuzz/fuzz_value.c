/* SPDX-License-Identifier: MIT */
/* Single values: total on any floats and enumerators, and what is promised of the results. */
#include "fuzz.h"
#include "../support/joint_limits.h"

#include <string.h>

/* Any numbers, as all that functions take. */
typedef struct any {
    float f[6];
    nkw_vec3 v[4];
    nkw_quat q[2];
    nkw_mat3 m3, n3;
    nkw_mat4 m4, n4;
    nkw_trs trs;
    nkw_dual_quat d, e;
    nkw_vec3_cubic cubics;
    float rows[16], times[4];
} any;

/* Neither NaN nor infinite. */
static int finite(float x)
{
    return fuzz_finite(&x, 1);
}

/* In the range, or NaN where the input is not finite. */
static void within(float x, float low, float high, int is_finite)
{
    FUZZ_CHECK((x >= low && x <= high) || (x != x && !is_finite));
}

static void scalar(const any *a)
{
    const float pi = 3.1415927f, x = a->f[0], y = a->f[1];
    float s, c;
    within(nkw_clamp(x, 0.0f, 1.0f), 0.0f, 1.0f, finite(x));
    within(nkw_sin(x), -1.0f, 1.0f, finite(x));
    within(nkw_cos(x), -1.0f, 1.0f, finite(x));
    nkw_sincos(x, &s, &c);
    float sine = nkw_sin(x), cosine = nkw_cos(x);
    FUZZ_CHECK(fuzz_same(&s, &sine, 1) && fuzz_same(&c, &cosine, 1));
    within(nkw_atan2(y, x), -pi, pi, finite(x) && finite(y));
    within(nkw_atan(x), -0.5f * pi, 0.5f * pi, finite(x));
    within(nkw_wrap_angle(x), -pi, pi, finite(x));
    within(nkw_angle_difference(x, y), -pi, pi, finite(x) && finite(y));
    FUZZ_CHECK(!(nkw_abs(x) < 0.0f) && !(nkw_exp(x) < 0.0f));
    FUZZ_CHECK(x < 0.0f || x != x || nkw_sqrt(x) >= 0.0f);
    FUZZ_CHECK(!(nkw_asin(x) > pi) && !(nkw_acos(x) > pi));
    FUZZ_CHECK(!finite(x) || !finite(y) || nkw_min(x, y) <= nkw_max(x, y));
    nkw_tan(x), nkw_log(x), nkw_pow(x, y), nkw_wrap(x, y), nkw_smoothstep(x), nkw_clamp(x, y, a->f[2]);
    nkw_lerp(x, y, a->f[2]), nkw_inverse_lerp(x, y, a->f[2]),
        nkw_lerp(a->f[3], a->f[4], nkw_inverse_lerp(y, a->f[2], x));
    nkw_degrees_from_radians(x), nkw_radians_from_degrees(x);
}

static void vec(const any *a)
{
    nkw_vec3 u = a->v[0], v = a->v[1];
    nkw_vec3 n = nkw_vec3_normalize(u);
    FUZZ_CHECK(!nkw_vec3_is_finite(u) || (nkw_vec3_is_finite(n) && nkw_vec3_length(n) < 1.000001f));
    FUZZ_CHECK(nkw_vec3_is_finite(u) == (finite(u.x) && finite(u.y) && finite(u.z)));
    within(nkw_vec3_angle(u, v), 0.0f, 3.1415930f, nkw_vec3_is_finite(u) && nkw_vec3_is_finite(v));
    nkw_vec3_add(u, v), nkw_vec3_sub(u, v), nkw_vec3_mul(u, v), nkw_vec3_negate(u), nkw_vec3_scale(u, a->f[0]);
    nkw_vec3_min(u, v), nkw_vec3_max(u, v), nkw_vec3_dot(u, v), nkw_vec3_cross(u, v), nkw_vec3_dot(u, u);
    nkw_vec3_add_scaled(u, v, a->f[0]), nkw_vec3_lerp(u, v, a->f[0]), nkw_vec3_distance(u, v);
    nkw_vec3_project(u, v), nkw_vec3_reject(u, v), nkw_vec3_reflect(u, v), nkw_vec3_perpendicular(u);
}

/* Unit, or what the page says of zero: no longer than unit in any case. */
static void at_most_unit(nkw_quat q, int is_finite)
{
    FUZZ_CHECK(!is_finite || (nkw_quat_is_finite(q) && nkw_quat_length(q) < 1.000001f));
}

static void quat(const any *a, nkw_euler_order order)
{
    nkw_quat p = a->q[0], q = a->q[1];
    float wxyz[4];
    int is_finite = nkw_quat_is_finite(p);
    at_most_unit(nkw_quat_normalize(p), is_finite);
    at_most_unit(nkw_quat_from_axis_angle(a->v[0], a->f[0]), nkw_vec3_is_finite(a->v[0]) && finite(a->f[0]));
    at_most_unit(nkw_quat_from_vectors(a->v[0], a->v[1]), nkw_vec3_is_finite(a->v[0]) && nkw_vec3_is_finite(a->v[1]));
    at_most_unit(nkw_quat_look_rotation(a->v[0], a->v[1]), nkw_vec3_is_finite(a->v[0]) && nkw_vec3_is_finite(a->v[1]));
    at_most_unit(nkw_quat_from_mat3(&a->m3), fuzz_finite(a->m3.m, 9));
    at_most_unit(nkw_quat_from_euler(a->v[0], order), nkw_vec3_is_finite(a->v[0]));
    nkw_quat_to_wxyz(p, wxyz);
    nkw_quat back = nkw_quat_from_wxyz(wxyz);
    FUZZ_CHECK(fuzz_same(&back.x, &p.x, 4));
    nkw_axis_angle_from_quat(p), nkw_quat_add(p, q), nkw_quat_sub(p, q), nkw_quat_scale(p, a->f[0]);
    nkw_quat_negate(p), nkw_quat_conjugate(p), nkw_quat_dot(p, q), nkw_quat_mul(p, q), nkw_quat_inverse(p);
    nkw_quat_rotate(p, a->v[0]), nkw_quat_rotate_inverse(p, a->v[0]), nkw_quat_angle(p, q);
    nkw_mat3_from_euler(a->v[0], order), nkw_euler_from_quat(p, order), nkw_euler_from_mat3(&a->m3, order);
    nkw_euler_unwrap(a->v[0], a->v[1]), nkw_euler_alternate(a->v[0], order);
    nkw_euler_nearest(a->v[0], a->v[1], order);
    nkw_swing_twist parts = nkw_quat_swing_twist(p, a->v[0]);
    at_most_unit(parts.swing, is_finite && nkw_vec3_is_finite(a->v[0]));
    at_most_unit(parts.twist, is_finite && nkw_vec3_is_finite(a->v[0]));
    within(nkw_quat_twist_angle(p, a->v[0]), -3.1415930f, 3.1415930f, is_finite && nkw_vec3_is_finite(a->v[0]));
    at_most_unit(nkw_quat_mean(a->q, 2, a->f),
                 is_finite && nkw_quat_is_finite(q) && finite(a->f[0]) && finite(a->f[1]));
}

static void orient(const any *a, nkw_path path, nkw_unwrap unwrap)
{
    nkw_quat p = a->q[0], q = a->q[1];
    float t = a->f[0], d = a->f[1];
    nkw_quat_nlerp(p, q, t), nkw_quat_slerp(p, q, t), nkw_quat_slerp_path(p, q, t, path, 0), nkw_quat_log(p);
    nkw_quat_exp(a->v[0]), nkw_quat_pow(p, t), nkw_quat_angular_velocity(p, q, d), nkw_quat_integrate(p, a->v[0], d);
    nkw_euler_lerp(a->v[0], a->v[1], t, unwrap);
    int32_t turns = nkw_quat_turns(p, q, a->v[0], path);
    FUZZ_CHECK(turns <= 1 << 29 && turns >= -(1 << 29));
    nkw_quat_slerp_path(p, q, t, path, turns), nkw_quat_nlerp_path(p, q, t, path, turns);
    nkw_quat_slerp_path(p, q, t, path, INT32_MIN), nkw_quat_nlerp_path(p, q, t, path, INT32_MAX);
}

static void limit(const any *a)
{
    nkw_limit limit = {a->q[1], a->v[0], a->v[1], a->f[0], a->f[1], a->f[2], a->f[3]};
    nkw_quat q = a->q[0], all = nkw_limit_apply(&limit, q), cone = limit_cone(q, a->v[0], a->f[0]);
    nkw_quat ellipse = limit_ellipse(q, a->v[0], a->v[1], a->f[0], a->f[1]);
    nkw_quat twist = limit_twist(q, a->v[0], a->f[0], a->f[1]);
    int is_finite = nkw_quat_is_finite(q);
    FUZZ_CHECK(!is_finite || (nkw_quat_is_finite(all) && nkw_quat_is_finite(cone)));
    FUZZ_CHECK(!is_finite || (nkw_quat_is_finite(ellipse) && nkw_quat_is_finite(twist)));
}

static void axes(const any *a, fuzz *f)
{
    nkw_axes_map map = {(nkw_axis)(fuzz_choice(f, 6) - 3), (nkw_axis)(fuzz_choice(f, 6) - 3),
                        (nkw_axis)(fuzz_choice(f, 6) - 3)};
    nkw_axes from = {map.x, map.y, map.z}, to = {map.z, map.x, map.y};
    nkw_axes_map back = nkw_axes_map_inverse(map);
    nkw_trs there = nkw_axes_convert_trs(map, &a->trs), again = nkw_axes_convert_trs(back, &there);
    nkw_mat4 m = nkw_axes_convert_mat4(map, &a->m4), n = nkw_axes_convert_mat4(back, &m);
    int is_valid = nkw_axes_map_is_valid(map);
    FUZZ_CHECK(is_valid == nkw_axes_map_is_valid(nkw_axes_map_from_axes(from, to)));
    FUZZ_CHECK(!is_valid ||
               (fuzz_same(&again.translation.x, &a->trs.translation.x, 10) && fuzz_same(n.m, a->m4.m, 16)));
    nkw_euler_order order = (nkw_euler_order)fuzz_choice(f, 11);
    nkw_axes_convert_euler(map, a->v[0], &order);
    float values[4] = {a->f[0], a->f[1], a->f[2], a->f[3]};
    nkw_axes_convert_values(map, values, 1, (nkw_axes_kind)fuzz_choice(f, 5), values);
}

/* A segment of any numbers, and those that are made of any keys. */
static void rotation(const any *a, nkw_path path, int32_t turns)
{
    const nkw_quat keys[4] = {a->q[0], a->q[1], a->trs.rotation, a->d.real};
    const nkw_tcb tcb[2] = {{a->f[0], a->f[1], a->f[2]}, {a->f[3], a->f[4], a->f[5]}};
    nkw_rotation_segment s[6] = {
        nkw_rotation_from_slerp(keys[0], keys[1], a->f[1], path, turns),
        nkw_rotation_from_hermite(keys[0], a->v[0], keys[1], a->v[1], a->f[1]),
        nkw_rotation_from_catmull_rom(keys, a->times),
        nkw_rotation_from_tcb(keys, a->times, tcb),
        nkw_rotation_from_squad(keys, a->f[1]),
        nkw_rotation_from_bspline(keys, a->f[1]),
    };
    for (int i = 0; i < 6; i++) {
        nkw_quat_motion at = nkw_rotation_evaluate(&s[i], a->f[0]);
        int is_finite = nkw_quat_is_finite(at.value);
        FUZZ_CHECK(!is_finite || a->f[0] == 0.0f || a->f[0] == 1.0f || nkw_quat_length(at.value) < 1.0001f);
    }
}

static void mat(const any *a, size_t column)
{
    float rows[16];
    nkw_mat4_to_row_major(&a->m4, rows);
    nkw_mat4 back = nkw_mat4_from_row_major(rows);
    FUZZ_CHECK(fuzz_same(back.m, a->m4.m, 16));
    nkw_mat4 product = nkw_mat4_mul_affine(&a->m4, &a->n4);
    nkw_mat3x4 three = nkw_mat3x4_from_mat4(&product);
    back = nkw_mat4_from_mat3x4(&three);
    FUZZ_CHECK(fuzz_affine(&product, 1) && fuzz_same(back.m, product.m, 16));
    nkw_mat3_column(&a->m3, column), nkw_mat3_from_columns(a->v[0], a->v[1], a->v[2]), nkw_mat3_transpose(&a->m3);
    nkw_mat3_mul(&a->m3, &a->n3), nkw_mat3_transform(&a->m3, a->v[0]), nkw_mat3_from_quat(a->q[0]);
    nkw_mat3_determinant(&a->m3), nkw_mat3_inverse(&a->m3), nkw_mat3_normal(&a->m3), nkw_mat3_orthonormalize(&a->m3);
    nkw_mat4_from_mat3(&a->m3, a->v[0]), nkw_mat4_from_quat(a->q[0]), nkw_mat4_transpose(&a->m4);
    nkw_mat4_mul(&a->m4, &a->n4), nkw_mat4_project_point(&a->m4, a->v[0]), nkw_mat4_determinant(&a->m4);
    nkw_mat4_inverse(&a->m4), nkw_mat4_inverse_affine(&a->m4), nkw_mat4_inverse_rigid(&a->m4);
    nkw_mat4_transform_point(&a->m4, a->v[0]), nkw_mat4_transform_direction(&a->m4, a->v[0]);
}

static void transform(const any *a)
{
    nkw_trs t = nkw_trs_from_mat4(&a->m4);
    at_most_unit(t.rotation, fuzz_finite(a->m4.m, 16));
    FUZZ_CHECK(!(nkw_trs_residual(&t, &a->m4) < 0.0f));
    nkw_mat4 m = nkw_mat4_from_trs(&a->trs), d = nkw_mat4_from_dual_quat(&a->d);
    FUZZ_CHECK(fuzz_affine(&m, 1) && fuzz_affine(&d, 1));
    nkw_mat3_from_quat_scale(a->q[0], a->v[0]), nkw_trs_transform_point(&a->trs, a->v[0]), nkw_trs_mul(&t, &a->trs);
    nkw_dual_quat unit = nkw_dual_quat_normalize(&a->d), of = nkw_dual_quat_from_mat4(&a->m4);
    at_most_unit(unit.real, nkw_quat_is_finite(a->d.real) && nkw_quat_is_finite(a->d.dual));
    at_most_unit(of.real, fuzz_finite(a->m4.m, 16));
    nkw_dual_quat_from_rigid(a->q[0], a->v[0]), nkw_dual_quat_transform_point(&a->d, NKW_VEC3_ZERO),
        nkw_dual_quat_mul(&a->d, &a->e);
    nkw_dual_quat_transform_point(&a->d, a->v[0]), nkw_quat_rotate(a->d.real, a->v[0]);
}

static void weights(float t)
{
    for (int kind = -1; kind <= 4; kind++)
        for (int derivative = -1; derivative <= 3; derivative++)
            nkw_cubic_weights((nkw_cubic_kind)kind, derivative, t);
}

static void curve(const any *a)
{
    const float *f = a->f, *w = a->times, t = a->f[5];
    const nkw_vec3 *v = a->v;
    nkw_vec3_cubic lefts, rights;
    weights(t);
    nkw_vec3_cubic_sum(&a->cubics, nkw_cubic_weights(NKW_CUBIC_BEZIER, 0, t));
    nkw_hermite(f[0], f[1], f[2], f[3], t), nkw_vec3_hermite(v[0], v[1], v[2], v[3], t);
    nkw_bezier(f[0], f[1], f[2], f[3], t), nkw_vec3_bezier(v[0], v[1], v[2], v[3], t);
    nkw_bspline(f[0], f[1], f[2], f[3], t), nkw_vec3_bspline(v[0], v[1], v[2], v[3], t);
    nkw_catmull_rom(f[0], f[1], f[2], f[3], t), nkw_vec3_catmull_rom(v[0], v[1], v[2], v[3], t);
    float through[4];
    nkw_cubic_from_catmull_rom(f, w, through);
    nkw_vec3_cubic_from_catmull_rom(v, w);
    nkw_vec3_motion from = {v[0], v[1], v[2]}, to = {v[3], v[0], v[1]};
    nkw_vec3_quintic_evaluate(&from, &to, t);
    for (int kind = -1; kind <= 4; kind++)
        nkw_vec3_cubic_evaluate(&a->cubics, t, (nkw_cubic_kind)kind);
    for (int of = -1; of <= 4; of++)
        for (int to_kind = -1; to_kind <= 4; to_kind++)
            nkw_vec3_cubic_convert(&a->cubics, (nkw_cubic_kind)of, (nkw_cubic_kind)to_kind);
    nkw_vec3_bezier_split(&a->cubics, t, &lefts, &rights);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz f = fuzz_begin(data, size);
    any *a = (any *)(void *)fuzz_floats(&f, sizeof(any) / sizeof(float), fuzz_byte(&f) % 4 != 0);
    float *numbers = (float *)a;
    for (size_t i = fuzz_byte(&f) % 64; i > 0; i--)
        numbers[fuzz_upto(&f, sizeof(any) / sizeof(float) - 1)] = fuzz_float(&f);
    scalar(a);
    vec(a);
    quat(a, (nkw_euler_order)fuzz_choice(&f, 11));
    orient(a, (nkw_path)fuzz_choice(&f, 2), (nkw_unwrap)fuzz_choice(&f, 2));
    rotation(a, (nkw_path)fuzz_choice(&f, 2), (int32_t)(fuzz_bits(&f) >> 1));
    axes(a, &f);
    limit(a);
    mat(a, fuzz_byte(&f));
    transform(a);
    curve(a);
    FUZZ_CHECK(nkw_result_text((nkw_result)fuzz_choice(&f, NKW_RESULT_COUNT)) != NULL);
    return fuzz_end(&f);
}
