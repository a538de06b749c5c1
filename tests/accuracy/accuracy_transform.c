/* SPDX-License-Identifier: MIT */
/* Errors of <nakawari/transform.h> against binary128. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <string.h>

#define SAMPLES 40000u
#define FEWER   100000u

/* ---- Samples: translation, rotation, scale, as ten floats ---- */

static void with_scale(random_source *r, float *x, nkw_quat q, float low, float high)
{
    put_vec3(x, random_vec3(r, -100.0f, 100.0f));
    put_quat(x + 3, q);
    for (int i = 7; i < 10; i++)
        x[i] = random_log(r, low, high);
}

static void non_uniform(random_source *r, float *x)
{
    with_scale(r, x, random_unit_quat(r), 1e-2f, 1e2f);
}

static void uniform(random_source *r, float *x)
{
    non_uniform(r, x);
    x[8] = x[9] = x[7];
}

static void pure_rotation(random_source *r, float *x)
{
    non_uniform(r, x);
    x[7] = x[8] = x[9] = 1.0f;
}

static void one_negative(random_source *r, float *x)
{
    non_uniform(r, x);
    x[7 + random_bits(r) % 3] *= -1.0f;
}

static void two_negative(random_source *r, float *x)
{
    non_uniform(r, x);
    unsigned kept = (unsigned)(random_bits(r) % 3);
    for (unsigned i = 0; i < 3; i++)
        x[7 + i] = i == kept ? x[7 + i] : -x[7 + i];
}

static void three_negative(random_source *r, float *x)
{
    non_uniform(r, x);
    for (int i = 7; i < 10; i++)
        x[i] = -x[i];
}

static void tiny(random_source *r, float *x)
{
    with_scale(r, x, random_unit_quat(r), 1e-6f, 1e-3f);
}

/* Elements down to 1e-33: still normal numbers, their squares not. */
static void vanishing(random_source *r, float *x)
{
    with_scale(r, x, random_unit_quat(r), 1e-30f, 1e-20f);
}

static void huge(random_source *r, float *x)
{
    with_scale(r, x, random_unit_quat(r), 1e20f, 1e38f);
}

static void near_half_turn(random_source *r, float *x)
{
    nkw_vec3 axis = random_direction(r);
    nkw_quat half = {axis.x, axis.y, axis.z, 0.0f};
    float off = random_log(r, 1e-7f, 1e-2f);
    with_scale(r, x, random_unit_near(r, half, off), 1e-2f, 1e2f);
}

/* Rotations as the library normalises them. */
static void normalised(random_source *r, float *x)
{
    non_uniform(r, x);
    put_quat(x + 3, nkw_quat_normalize(nkw_quat_scale(quat_at(x + 3), random_between(r, 0.5f, 2.0f))));
}

static void not_unit(random_source *r, float *x)
{
    non_uniform(r, x);
    put_quat(x + 3, nkw_quat_scale(quat_at(x + 3), random_log(r, 1e-3f, 1e3f)));
}

static nkw_trs trs_at(const float *x)
{
    nkw_trs t = {vec3_at(x), quat_at(x + 3), vec3_at(x + 7)};
    return t;
}

/* The columns of R S in binary128. */
static void columns(const nkw_trs *t, wide m[9])
{
    float q[4], s[3];
    wide w[4];
    put_quat(q, t->rotation);
    put_vec3(s, t->scale);
    wide_from(q, w, 4);
    wide_mat3_from_quat(w, m);
    for (int c = 0; c < 3; c++)
        wide_scale(m + c * 3, s[c], 3);
}

static double worst_column(const float *m, int stride, const wide *exact)
{
    double worst = 0.0;
    for (int c = 0; c < 3; c++)
        worst = fmax(worst, wide_error(m + c * stride, exact + c * 3, 3));
    return worst;
}

static double compose_error(const float *x)
{
    wide exact[9];
    nkw_trs t = trs_at(x);
    nkw_mat4 m = nkw_mat4_from_trs(&t);
    columns(&t, exact);
    int rest = m.m[12] == x[0] && m.m[13] == x[1] && m.m[14] == x[2] && m.m[15] == 1.0f;
    return rest ? worst_column(m.m, 4, exact) : HUGE_VAL;
}

/* The columns of |q|^2 R S, q as given. */
static double stored_error(const float *x)
{
    wide exact[9], q[4];
    nkw_trs t = trs_at(x);
    nkw_mat4 got = nkw_mat4_from_trs(&t);
    columns(&t, exact);
    wide_from(x + 3, q, 4);
    wide_scale(exact, wide_dot(q, q, 4), 9);
    return worst_column(got.m, 4, exact);
}

static double from_quat_scale_error(const float *x)
{
    wide exact[9];
    nkw_trs t = trs_at(x);
    nkw_mat3 m = nkw_mat3_from_quat_scale(t.rotation, t.scale);
    columns(&t, exact);
    return worst_column(m.m, 3, exact);
}

/* The matrix of a sample, each element rounded once. */
static nkw_mat4 rounded(const float *x)
{
    wide exact[9];
    nkw_trs t = trs_at(x);
    nkw_mat4 m = nkw_mat4_identity();
    columns(&t, exact);
    for (int c = 0; c < 3; c++)
        wide_round(exact + c * 3, m.m + c * 4, 3);
    put_vec3(m.m + 12, t.translation);
    return m;
}

/* |rebuilt column - column| / |column|, the rotation taken as unit. */
static double rebuilt_error(const float *x)
{
    wide exact[9], column[3];
    double worst = 0.0;
    nkw_mat4 m = rounded(x);
    nkw_trs t = nkw_trs_from_mat4(&m);
    columns(&t, exact);
    for (int c = 0; c < 3; c++) {
        wide_from(m.m + c * 4, column, 3);
        worst = fmax(worst, wide_error_of(m.m + c * 4, exact + c * 3, 3, wide_length(column, 3)));
    }
    int translation = t.translation.x == x[0] && t.translation.y == x[1] && t.translation.z == x[2];
    return translation ? worst : HUGE_VAL;
}

/* Against the scale that made the matrix: its rounding counts. */
static double scale_error(const float *x)
{
    nkw_mat4 m = rounded(x);
    nkw_trs t = nkw_trs_from_mat4(&m);
    double worst = 0.0;
    float got[3];
    put_vec3(got, t.scale);
    for (int i = 0; i < 3; i++)
        worst = fmax(worst, fabs(fabs((double)got[i]) / fabs((double)x[7 + i]) - 1.0) * 0x1p24);
    return worst;
}

static double rotation_error(const float *x)
{
    wide q[4];
    float got[4];
    nkw_mat4 m = rounded(x);
    put_quat(got, nkw_trs_from_mat4(&m).rotation);
    wide_from(x + 3, q, 4);
    wide_normalize(q, 4);
    return wide_error_either(got, q, 4);
}

#define COMPOSE   "nkw_mat4_from_trs"
#define DECOMPOSE "nkw_trs_from_mat4"

static const wide_case cases[] = {
    {COMPOSE, "scales 1e-2 .. 1e2", non_uniform, compose_error, 10, WIDE_UNITS},
    {COMPOSE, "scale 1", pure_rotation, compose_error, 10, WIDE_CHECKED},
    {COMPOSE, "rotation near half turns", near_half_turn, compose_error, 10, WIDE_UNITS},
    {COMPOSE, "rotation not unit, of |q|^2 R S", not_unit, stored_error, 10, WIDE_CHECKED},
    {COMPOSE, "rotation from nkw_quat_normalize", normalised, compose_error, 10, WIDE_NOTED},
    {"nkw_mat3_from_quat_scale", "scales 1e-2 .. 1e2", non_uniform, from_quat_scale_error, 10, WIDE_UNITS},
    {COMPOSE, "scales 1e-6 .. 1e-3", tiny, compose_error, 10, WIDE_CHECKED},
    {DECOMPOSE, "uniform scale 1e-2 .. 1e2", uniform, rebuilt_error, 10, WIDE_CHECKED},
    {DECOMPOSE, "scales 1e-2 .. 1e2", non_uniform, rebuilt_error, 10, WIDE_CHECKED},
    {DECOMPOSE, "one negative scale", one_negative, rebuilt_error, 10, WIDE_CHECKED},
    {DECOMPOSE, "two negative scales", two_negative, rebuilt_error, 10, WIDE_CHECKED},
    {DECOMPOSE, "three negative scales", three_negative, rebuilt_error, 10, WIDE_CHECKED},
    {DECOMPOSE, "scale 1", pure_rotation, rebuilt_error, 10, WIDE_CHECKED},
    {DECOMPOSE, "scales 1e-6 .. 1e-3", tiny, rebuilt_error, 10, WIDE_CHECKED},
    {DECOMPOSE, "scales 1e-30 .. 1e-20", vanishing, rebuilt_error, 10, WIDE_CHECKED},
    {DECOMPOSE, "scales 1e20 .. 1e38", huge, rebuilt_error, 10, WIDE_CHECKED},
    {DECOMPOSE, "rotation near half turns", near_half_turn, rebuilt_error, 10, WIDE_CHECKED},
    {DECOMPOSE, "scale, uniform 1e-2 .. 1e2", uniform, scale_error, 10, WIDE_NOTED},
    {DECOMPOSE, "scale, 1e-2 .. 1e2", non_uniform, scale_error, 10, WIDE_NOTED},
    {DECOMPOSE, "scale, 1", pure_rotation, scale_error, 10, WIDE_NOTED},
    {DECOMPOSE, "scale, 1e-6 .. 1e-3", tiny, scale_error, 10, WIDE_NOTED},
    {DECOMPOSE, "rotation, uniform 1e-2 .. 1e2", uniform, rotation_error, 10, WIDE_NOTED},
    {DECOMPOSE, "rotation, 1e-2 .. 1e2", non_uniform, rotation_error, 10, WIDE_NOTED},
    {DECOMPOSE, "rotation, 1", pure_rotation, rotation_error, 10, WIDE_NOTED},
    {DECOMPOSE, "rotation, 1e-6 .. 1e-3", tiny, rotation_error, 10, WIDE_NOTED},
    {DECOMPOSE, "rotation, near half turns", near_half_turn, rotation_error, 10, WIDE_NOTED},
};

/* ---- On points: translation, rotation, scale, point; two transforms; a transform and a matrix ---- */

static void with_point(random_source *r, float *x)
{
    put_vec3(x + 10, random_vec3(r, -10.0f, 10.0f));
}

static void moved_point(random_source *r, float *x)
{
    with_scale(r, x, random_unit_quat(r), 0.1f, 10.0f);
    with_point(r, x);
}

static void half_turned_point(random_source *r, float *x)
{
    near_half_turn(r, x);
    with_point(r, x);
    put_vec3(x, random_vec3(r, -1.0f, 1.0f));
}

/* Unit as the library makes it. */
static void half_turned_by_normalised(random_source *r, float *x)
{
    half_turned_point(r, x);
    nkw_vec3 axis = random_direction(r);
    nkw_quat q = {axis.x, axis.y, axis.z, random_scaled(r, -24, -6)};
    put_quat(x + 3, nkw_quat_normalize(q));
}

/* To near the origin. */
static void lost_point(random_source *r, float *x)
{
    moved_point(r, x);
    nkw_vec3 v = nkw_quat_rotate(quat_at(x + 3), nkw_vec3_mul(vec3_at(x + 7), vec3_at(x + 10)));
    nkw_vec3 off = random_vec3(r, -1.0f, 1.0f);
    put_vec3(x, nkw_vec3_add_scaled(nkw_vec3_negate(v), off, random_scaled(r, -24, -4)));
}

/* Of |scale * p| + |translation|. */
static double off_point(nkw_vec3 v, const nkw_trs *t, nkw_vec3 p)
{
    float f[3], got[3];
    wide m[9], w[3], to[3], scaled[3], scale[3];
    nkw_trs turn = *t;
    turn.scale.x = turn.scale.y = turn.scale.z = 1.0f;
    columns(&turn, m);
    put_vec3(f, p);
    wide_from(f, w, 3);
    put_vec3(f, t->scale);
    wide_from(f, scale, 3);
    put_vec3(f, t->translation);
    wide_from(f, to, 3);
    for (int i = 0; i < 3; i++)
        scaled[i] = scale[i] * w[i];
    for (int i = 0; i < 3; i++)
        w[i] = m[i] * scaled[0] + m[3 + i] * scaled[1] + m[6 + i] * scaled[2] + to[i];
    put_vec3(got, v);
    return wide_error_of(got, w, 3, wide_length(scaled, 3) + wide_length(to, 3));
}

static double point_error(const float *x)
{
    nkw_trs t = trs_at(x);
    return off_point(nkw_trs_transform_point(&t, vec3_at(x + 10)), &t, vec3_at(x + 10));
}

static void two_transforms(random_source *r, float *x)
{
    with_scale(r, x, random_unit_quat(r), 0.1f, 10.0f);
    with_scale(r, x + 10, random_unit_quat(r), 0.1f, 10.0f);
}

static void near_half_turns(random_source *r, float *x)
{
    near_half_turn(r, x);
    near_half_turn(r, x + 10);
    put_vec3(x, random_vec3(r, -1.0f, 1.0f));
}

static void two_normalised(random_source *r, float *x)
{
    near_half_turns(r, x);
    half_turned_by_normalised(r, x);
    put_vec3(x + 10, random_vec3(r, -100.0f, 100.0f));
}

static double product_place_error(const float *x)
{
    nkw_trs a = trs_at(x), b = trs_at(x + 10), got = nkw_trs_mul(&a, &b);
    return off_point(got.translation, &a, b.translation);
}

/* And the scale, which is rounded once. */
static double product_turn_error(const float *x)
{
    wide a[4], b[4];
    float q[4];
    nkw_trs s = trs_at(x), t = trs_at(x + 10), got = nkw_trs_mul(&s, &t);
    wide_from(x + 3, a, 4);
    wide_from(x + 13, b, 4);
    wide_quat_mul(a, b, a);
    put_quat(q, got.rotation);
    int scale = got.scale.x == x[7] * x[17] && got.scale.y == x[8] * x[18] && got.scale.z == x[9] * x[19];
    return scale ? wide_error(q, a, 4) : HUGE_VAL;
}

/* A matrix that is T R S but for its rounding. */
static void with_own_matrix(random_source *r, float *x)
{
    non_uniform(r, x);
    nkw_mat4 m = rounded(x);
    memcpy(x + 10, m.m, 12 * sizeof *x);
}

static void with_sheared_matrix(random_source *r, float *x)
{
    with_scale(r, x, random_unit_quat(r), 1.0f, 2.0f);
    nkw_mat4 m = rounded(x);
    memcpy(x + 10, m.m, 12 * sizeof *x);
    float shear = random_log(r, 1e-4f, 1.0f);
    for (int i = 0; i < 3; i++)
        x[14 + i] += shear * x[10 + i];
}

static double residual_error(const float *x)
{
    wide m[9], exact[9], longest = 0, largest = 0;
    nkw_trs t = trs_at(x);
    nkw_mat4 f = nkw_mat4_identity();
    columns(&t, exact);
    for (int i = 0; i < 9; i++) {
        f.m[i / 3 * 4 + i % 3] = x[10 + i / 3 * 4 + i % 3];
        m[i] = f.m[i / 3 * 4 + i % 3];
        wide off = m[i] > exact[i] ? m[i] - exact[i] : exact[i] - m[i];
        largest = off > largest ? off : largest;
    }
    for (int c = 0; c < 9; c += 3) {
        wide length = wide_length(m + c, 3);
        longest = length > longest ? length : longest;
    }
    return accuracy_ulps(nkw_trs_residual(&t, &f), (double)(largest / longest));
}

#define POINT    "nkw_trs_transform_point"
#define PRODUCT  "nkw_trs_mul"
#define RESIDUAL "nkw_trs_residual"

static const wide_case points[] = {
    {POINT, "scales 0.1 .. 10", moved_point, point_error, 13, WIDE_CHECKED},
    {POINT, "rotation near half turns", half_turned_point, point_error, 13, WIDE_CHECKED},
    {POINT, "near half turns, normalised", half_turned_by_normalised, point_error, 13, WIDE_CHECKED},
    {POINT, "result near the origin", lost_point, point_error, 13, WIDE_CHECKED},
    {PRODUCT, "translation, scales 0.1 .. 10", two_transforms, product_place_error, 20, WIDE_CHECKED},
    {PRODUCT, "translation, near half turns", near_half_turns, product_place_error, 20, WIDE_CHECKED},
    {PRODUCT, "translation, near half turns, normalised", two_normalised, product_place_error, 20, WIDE_CHECKED},
    {PRODUCT, "rotation", two_transforms, product_turn_error, 20, WIDE_CHECKED},
    {RESIDUAL, "T R S, rounded", with_own_matrix, residual_error, 22, WIDE_NOTED},
    {RESIDUAL, "shear 1e-4 .. 1", with_sheared_matrix, residual_error, 22, WIDE_CHECKED},
};

/* ---- A chain of joints: rotation and reach of the product of many T R ---- */

#define DEEPEST 64

static double chain_error(const float *x, int depth, int position)
{
    random_source r = wide_source(x);
    nkw_mat4 world = nkw_mat4_identity();
    wide exact[16], local[16];
    wide_from(world.m, exact, 16);
    for (int i = 0; i < depth; i++) {
        nkw_trs t = {random_vec3(&r, -1.0f, 1.0f), random_unit_quat(&r), {1.0f, 1.0f, 1.0f}};
        nkw_mat4 m = nkw_mat4_from_trs(&t);
        wide columns3[9];
        world = nkw_mat4_mul_affine(&world, &m);
        columns(&t, columns3);
        wide_from(m.m, local, 16);
        for (int k = 0; k < 9; k++)
            local[k / 3 * 4 + k % 3] = columns3[k];
        wide_mat_mul(exact, local, exact, 4);
    }
    if (position)
        return wide_error_of(world.m + 12, exact + 12, 3, depth);
    return wide_error(world.m, exact, 12);
}

static double chain_1(const float *x)
{
    return chain_error(x, 1, 0);
}

static double chain_4(const float *x)
{
    return chain_error(x, 4, 0);
}

static double chain_16(const float *x)
{
    return chain_error(x, 16, 0);
}

static double chain_64(const float *x)
{
    return chain_error(x, DEEPEST, 0);
}

static double reach_64(const float *x)
{
    return chain_error(x, DEEPEST, 1);
}

static const wide_case chains[] = {
    {COMPOSE, "chain of 1 joint, rotation", wide_seed, chain_1, 2, WIDE_NOTED},
    {COMPOSE, "chain of 4 joints, rotation", wide_seed, chain_4, 2, WIDE_NOTED},
    {COMPOSE, "chain of 16 joints, rotation", wide_seed, chain_16, 2, WIDE_NOTED},
    {COMPOSE, "chain of 64 joints, rotation", wide_seed, chain_64, 2, WIDE_NOTED},
    {COMPOSE, "chain of 64 joints, position / depth", wide_seed, reach_64, 2, WIDE_NOTED},
};

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("transform.h", argc, argv);
    wide_search(&a, cases, sizeof cases / sizeof cases[0], SAMPLES);
    wide_search(&a, points, sizeof points / sizeof points[0], FEWER);
    wide_search(&a, chains, sizeof chains / sizeof chains[0], SAMPLES / 100);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
