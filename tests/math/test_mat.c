/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "random.h"
#include "support/expect.h"

static nkw_vec3 vec(float x, float y, float z)
{
    nkw_vec3 r = {x, y, z};
    return r;
}

static nkw_mat4 random_affine(random_source *r, float scale)
{
    nkw_trs t = {random_vec3(r, -10, 10), random_rotation(r), random_vec3(r, 0.5f * scale, scale)};
    return nkw_mat4_from_trs(&t);
}

static void elements_stand_column_by_column(void **state)
{
    (void)state;
    nkw_mat3 m = nkw_mat3_from_columns(vec(1, 2, 3), vec(4, 5, 6), vec(7, 8, 9));
    const float want[9] = {1, 2, 3, 4, 5, 6, 7, 8, 9};
    expect_floats_bits(m.m, want, 9);
    expect_vec3_bits(nkw_mat3_column(&m, 1), vec(4, 5, 6));
    expect_vec3_bits(nkw_mat3_column(&m, 99), vec(1, 2, 3));
    expect_vec3_bits(nkw_mat3_transform(&m, vec(1, 0, 0)), vec(1, 2, 3));
    nkw_mat4 a = nkw_mat4_from_mat3(&m, vec(10, 11, 12));
    expect_bits(a.m[12], 10.0f);
    expect_bits(a.m[15], 1.0f);
    expect_bits(a.m[3], 0.0f);
    expect_vec3_bits(nkw_mat4_translation(&a), vec(10, 11, 12));
    nkw_mat3 back = nkw_mat3_from_mat4(&a);
    expect_floats_bits(back.m, want, 9);
}

static void product_applies_the_right_factor_first(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int i = 0; i < 5000; i++) {
        nkw_mat4 a = random_affine(&r, 2), b = random_affine(&r, 2), ab = nkw_mat4_mul(&a, &b);
        nkw_vec3 p = random_vec3(&r, -1, 1);
        expect_vec3_near(nkw_mat4_transform_point(&ab, p),
                         nkw_mat4_transform_point(&a, nkw_mat4_transform_point(&b, p)), 3e-5);
        nkw_mat3 c = nkw_mat3_from_mat4(&a), d = nkw_mat3_from_mat4(&b), cd = nkw_mat3_mul(&c, &d);
        expect_vec3_near(nkw_mat3_transform(&cd, p), nkw_mat3_transform(&c, nkw_mat3_transform(&d, p)), 1e-5);
    }
}

static void a_product_by_hand(void **state)
{
    (void)state;
    nkw_mat3 a = {{1, 4, 7, 2, 5, 8, 3, 6, 9}}, b = {{9, 6, 3, 8, 5, 2, 7, 4, 1}};
    const float want[9] = {30, 84, 138, 24, 69, 114, 18, 54, 90};
    nkw_mat3 ab = nkw_mat3_mul(&a, &b);
    expect_floats_bits(ab.m, want, 9);
}

static void affine_product_equals_the_general_one(void **state)
{
    (void)state;
    random_source r = random_from(2);
    for (int i = 0; i < 5000; i++) {
        nkw_mat4 a = random_affine(&r, 2), b = random_affine(&r, 2);
        nkw_mat4 general = nkw_mat4_mul(&a, &b), affine = nkw_mat4_mul_affine(&a, &b);
        expect_floats_near(affine.m, general.m, 16, 0.0);
    }
}

static void an_output_may_be_an_input(void **state)
{
    (void)state;
    random_source r = random_from(3);
    nkw_mat4 a = random_affine(&r, 2), b = random_affine(&r, 2), ab = nkw_mat4_mul(&a, &b);
    a = nkw_mat4_mul(&a, &b);
    expect_floats_bits(a.m, ab.m, 16);
    nkw_mat4 i = nkw_mat4_inverse(&a);
    a = nkw_mat4_inverse(&a);
    expect_floats_bits(a.m, i.m, 16);
}

static void transpose_turns_rows_into_columns(void **state)
{
    (void)state;
    nkw_mat4 m;
    for (int i = 0; i < 16; i++)
        m.m[i] = (float)i;
    nkw_mat4 t = nkw_mat4_transpose(&m);
    for (int c = 0; c < 4; c++)
        for (int k = 0; k < 4; k++)
            expect_bits(t.m[c * 4 + k], m.m[k * 4 + c]);
    nkw_mat3 s = {{1, 2, 3, 4, 5, 6, 7, 8, 9}}, u = nkw_mat3_transpose(&s);
    const float want[9] = {1, 4, 7, 2, 5, 8, 3, 6, 9};
    expect_floats_bits(u.m, want, 9);
}

static void directions_do_not_see_the_translation(void **state)
{
    (void)state;
    nkw_mat3 one = nkw_mat3_identity();
    nkw_mat4 m = nkw_mat4_from_mat3(&one, vec(5, 6, 7));
    expect_vec3_bits(nkw_mat4_transform_point(&m, vec(1, 2, 3)), vec(6, 8, 10));
    expect_vec3_bits(nkw_mat4_transform_direction(&m, vec(1, 2, 3)), vec(1, 2, 3));
}

static void projection_divides_by_w(void **state)
{
    (void)state;
    nkw_mat4 m = nkw_mat4_identity();
    m.m[11] = -1.0f;
    m.m[15] = 0.0f;
    expect_vec3_bits(nkw_mat4_project_point(&m, vec(4, 6, -2)), vec(2, 3, -1));
}

static void determinants_by_hand(void **state)
{
    (void)state;
    nkw_mat3 a = {{2, 0, 0, 0, 3, 0, 0, 0, -4}}, singular = {{1, 4, 7, 2, 5, 8, 3, 6, 9}};
    expect_bits(nkw_mat3_determinant(&a), -24.0f);
    expect_bits(nkw_mat3_determinant(&singular), 0.0f);
    nkw_mat4 b = {{1, 5, 2, 6, 0, 2, 7, 5, 2, 6, 3, 1, 9, 4, 3, 8}};
    expect_bits(nkw_mat4_determinant(&b), 1726.0f);
}

static void inverse_times_matrix_is_identity(void **state)
{
    (void)state;
    random_source r = random_from(4);
    nkw_mat4 one = nkw_mat4_identity();
    for (int i = 0; i < 5000; i++) {
        nkw_mat4 a = random_affine(&r, 2), general = nkw_mat4_inverse(&a), affine = nkw_mat4_inverse_affine(&a);
        nkw_mat4 p = nkw_mat4_mul(&a, &general);
        expect_floats_near(p.m, one.m, 16, 1e-5);
        expect_floats_near(affine.m, general.m, 16, 1e-5);
        nkw_mat3 b = nkw_mat3_from_mat4(&a), ib = nkw_mat3_inverse(&b), q = nkw_mat3_mul(&ib, &b);
        nkw_mat3 unit = nkw_mat3_identity();
        expect_floats_near(q.m, unit.m, 9, 2e-6);
    }
}

static void inverse_by_hand(void **state)
{
    (void)state;
    /* Rows 4 7 2 3 / 3 6 1 2 / 2 5 3 1 / 1 2 1 4 has determinant 33. */
    nkw_mat4 m = {{4, 3, 2, 1, 7, 6, 5, 2, 2, 1, 3, 1, 3, 2, 1, 4}};
    nkw_mat4 i = nkw_mat4_inverse(&m), p = nkw_mat4_mul(&m, &i), one = nkw_mat4_identity();
    expect_floats_near(p.m, one.m, 16, 1e-6);
}

static void inverse_survives_extreme_scales(void **state)
{
    (void)state;
    static const float scales[] = {1e-30f, 1e-18f, 1e-9f, 1e9f, 1e18f, 1e30f};
    for (size_t i = 0; i < sizeof scales / sizeof scales[0]; i++) {
        nkw_mat4 m = nkw_mat4_identity();
        m.m[0] = m.m[5] = m.m[10] = scales[i];
        nkw_mat4 a = nkw_mat4_inverse(&m), b = nkw_mat4_inverse_affine(&m);
        expect_ulps(a.m[0], 1.0f / scales[i], 1);
        expect_ulps(b.m[5], 1.0f / scales[i], 1);
        nkw_mat3 n = nkw_mat3_from_mat4(&m), c = nkw_mat3_inverse(&n);
        expect_ulps(c.m[8], 1.0f / scales[i], 1);
    }
}

static void singular_matrices_give_the_zero_matrix(void **state)
{
    (void)state;
    nkw_mat4 zero = {{0}}, flat = nkw_mat4_identity();
    nkw_mat3 zero3 = {{0}}, flat3 = {{1, 4, 7, 2, 5, 8, 3, 6, 9}}, got3 = nkw_mat3_inverse(&flat3);
    flat.m[5] = 0;
    nkw_mat4 a = nkw_mat4_inverse(&zero), b = nkw_mat4_inverse(&flat), c = nkw_mat4_inverse_affine(&flat);
    expect_floats_near(a.m, zero.m, 16, 0);
    expect_floats_near(b.m, zero.m, 16, 0);
    expect_floats_near(c.m, zero.m, 16, 0);
    expect_floats_near(got3.m, zero3.m, 9, 0);
}

/* The third column is the exact sum of the others, whatever the rounding of the determinant. */
static void exactly_dependent_columns_have_no_inverse(void **state)
{
    (void)state;
    random_source r = random_from(41);
    for (int i = 0; i < 20000; i++) {
        nkw_mat3 m;
        for (int k = 0; k < 3; k++) {
            do {
                m.m[k] = random_between(&r, -4, 4);
                m.m[3 + k] = random_between(&r, -4, 4);
                m.m[6 + k] = m.m[k] + m.m[3 + k];
            } while ((double)m.m[6 + k] != (double)m.m[k] + (double)m.m[3 + k]);
        }
        nkw_mat4 affine = nkw_mat4_from_mat3(&m, random_vec3(&r, -9, 9)), zero = {{0}};
        nkw_mat3 a = nkw_mat3_inverse(&m);
        nkw_mat4 b = nkw_mat4_inverse_affine(&affine), c = nkw_mat4_inverse(&affine);
        expect_floats_near(a.m, zero.m, 9, 0);
        expect_floats_near(b.m, zero.m, 16, 0);
        expect_floats_near(c.m, zero.m, 16, 0);
    }
}

/* A translation does not make a matrix singular, nor do small or uneven scales. */
static void a_far_translation_and_uneven_scales_have_an_inverse(void **state)
{
    (void)state;
    random_source r = random_from(42);
    for (int i = 0; i < 5000; i++) {
        float s[3], least = 1e30f;
        for (int k = 0; k < 3; k++) {
            s[k] = nkw_abs(random_scaled(&r, -20, 20));
            least = s[k] < least ? s[k] : least;
        }
        nkw_trs t = {{1e9f, -1e9f, 1e9f}, random_rotation(&r), {s[0], s[1], s[2]}};
        nkw_mat4 m = nkw_mat4_from_trs(&t), a = nkw_mat4_inverse_affine(&m);
        nkw_mat3 block = nkw_mat3_from_mat4(&m), inverse = nkw_mat3_inverse(&block);
        for (int k = 0; k < 9; k++)
            expect_near(inverse.m[k], a.m[k / 3 * 4 + k % 3], 1e-5 / (double)least);
        assert_true(a.m[15] == 1.0f);
    }
}

static void rigid_inverse_is_the_transpose(void **state)
{
    (void)state;
    random_source r = random_from(5);
    for (int i = 0; i < 5000; i++) {
        nkw_mat3 rotation = nkw_mat3_from_quat(random_rotation(&r));
        nkw_mat4 m = nkw_mat4_from_mat3(&rotation, random_vec3(&r, -10, 10));
        nkw_mat4 a = nkw_mat4_inverse_rigid(&m), b = nkw_mat4_inverse(&m);
        expect_floats_near(a.m, b.m, 16, 1e-5);
        expect_bits(a.m[1], m.m[4]);
    }
}

static void normal_matrix_is_the_inverse_transpose(void **state)
{
    (void)state;
    nkw_mat3 m = {{2, 0, 0, 0, 4, 0, 1, 0, 8}}, n = nkw_mat3_normal(&m);
    nkw_mat3 i = nkw_mat3_inverse(&m), t = nkw_mat3_transpose(&i);
    expect_floats_bits(n.m, t.m, 9);
}

static void normal_matrix_survives_a_zero_scale(void **state)
{
    (void)state;
    nkw_mat3 flat = {{3, 0, 0, 0, 0, 0, 0, 0, 5}}, n = nkw_mat3_normal(&flat), line = {{3, 0, 0, 0, 0, 0, 0, 0, 0}};
    expect_vec3_bits(nkw_mat3_transform(&n, vec(0.6f, 0.8f, 0)), vec(0, 0.8f, 0));
    nkw_mat3 none = nkw_mat3_normal(&line), zero = {{0}};
    expect_floats_near(none.m, zero.m, 9, 0);
    for (size_t k = 0; k < 18; k++) {
        nkw_mat3 m = {{1, 0, 0, 0, 1, 0, 0, 0, 1}};
        m.m[k / 2] = k % 2 ? INFINITY : NAN;
        none = nkw_mat3_normal(&m);
        expect_floats_near(none.m, zero.m, 9, 0);
    }
}

/* The normal of the plane that A diag(1, 0, 1) B flattens to is A y, on the side that the cofactors have. */
static void normals_of_a_flat_product_do_not_flip(void **state)
{
    (void)state;
    random_source r = random_from(43);
    for (int i = 0; i < 5000; i++) {
        nkw_quat q = random_rotation(&r), p = random_rotation(&r);
        nkw_mat3 a = nkw_mat3_from_quat(q), b = nkw_mat3_from_quat(p), flat = {{1, 0, 0, 0, 0, 0, 0, 0, 1}};
        nkw_mat3 m = nkw_mat3_mul(&a, &flat);
        m = nkw_mat3_mul(&m, &b);
        nkw_mat3 n = nkw_mat3_normal(&m);
        nkw_vec3 up = nkw_quat_rotate_inverse(p, (nkw_vec3){0, 1, 0});
        nkw_vec3 got = nkw_vec3_normalize(nkw_mat3_transform(&n, up));
        expect_vec3_near(got, nkw_quat_rotate(q, (nkw_vec3){0, 1, 0}), 2e-6);
    }
}

static void normal_matrix_turns_with_a_mirror(void **state)
{
    (void)state;
    nkw_mat3 mirror = {{-1, 0, 0, 0, 1, 0, 0, 0, 1}}, n = nkw_mat3_normal(&mirror);
    expect_vec3_near(nkw_mat3_transform(&n, vec(1, 0, 0)), vec(-1, 0, 0), 0);
    expect_vec3_near(nkw_mat3_transform(&n, vec(0, 1, 0)), vec(0, 1, 0), 0);
}

static void expect_orthonormal(const nkw_mat3 *m)
{
    nkw_mat3 t = nkw_mat3_transpose(m), p = nkw_mat3_mul(&t, m), one = nkw_mat3_identity();
    expect_floats_near(p.m, one.m, 9, 4e-7);
}

static void orthonormalize_keeps_x_and_the_side_of_z(void **state)
{
    (void)state;
    random_source r = random_from(6);
    for (int i = 0; i < 5000; i++) {
        nkw_mat3 m;
        for (int k = 0; k < 9; k++)
            m.m[k] = random_between(&r, -2, 2);
        nkw_mat3 o = nkw_mat3_orthonormalize(&m);
        expect_orthonormal(&o);
        expect_vec3_near(nkw_mat3_column(&o, 0), nkw_vec3_normalize(nkw_mat3_column(&m, 0)), 3e-7);
        assert_true(nkw_vec3_dot(nkw_mat3_column(&o, 1), nkw_mat3_column(&m, 1)) >= -1e-6f);
        assert_true(nkw_mat3_determinant(&o) * nkw_mat3_determinant(&m) >= 0.0f);
    }
}

static void orthonormalize_replaces_what_has_no_direction(void **state)
{
    (void)state;
    static const nkw_mat3 cases[] = {
        {{0, 0, 0, 0, 0, 0, 0, 0, 0}}, {{1, 2, 3, 0, 0, 0, 0, 0, 0}}, {{0, 0, 0, 1, 2, 3, 0, 0, 0}},
        {{0, 0, 0, 0, 0, 0, 1, 2, 3}}, {{1, 2, 3, 2, 4, 6, 3, 6, 9}}, {{1, 2, 3, 2, 4, 6, 0, 1, 0}},
        {{0, 0, 0, 1, 0, 0, 0, 1, 0}}, {{1e-40f, 0, 0, 0, 1e-40f, 0, 0, 0, 1e-40f}},
        {{1e38f, 0, 0, 1e38f, 1e38f, 0, 0, 0, 1e38f}},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        nkw_mat3 o = nkw_mat3_orthonormalize(&cases[i]);
        expect_orthonormal(&o);
    }
}

static void orthonormalize_of_nan_is_nan_from_its_column_on(void **state)
{
    (void)state;
    for (size_t k = 0; k < 9; k++) {
        nkw_mat3 m = {{1, 2, 0, 0, 3, 1, 2, 0, 1}};
        m.m[k] = NAN;
        nkw_mat3 o = nkw_mat3_orthonormalize(&m);
        for (size_t i = 0; i < 9; i++)
            assert_int_equal(o.m[i] != o.m[i], i / 3 >= k / 3);
    }
}

static void row_major_storage_is_transposed(void **state)
{
    (void)state;
    float rows[16];
    for (int i = 0; i < 16; i++)
        rows[i] = (float)(i + 1);
    nkw_mat4 m = nkw_mat4_from_row_major(rows);
    expect_bits(m.m[4], 2.0f);
    expect_bits(m.m[12], 4.0f);
    float back[16];
    nkw_mat4_to_row_major(&m, back);
    expect_floats_bits(back, rows, 16);
}

static void row_vectors_stored_by_rows_have_the_same_bytes(void **state)
{
    (void)state;
    /* A D3DX translation by (5, 6, 7): the last row. */
    const nkw_mat4 d3dx = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1}};
    expect_vec3_bits(nkw_mat4_transform_point(&d3dx, vec(1, 1, 1)), vec(6, 7, 8));
}

static void mat4_inverse_of_singular_integers_is_zero(void **state)
{
    (void)state;
    nkw_mat4 m;
    for (int i = 0; i < 16; i++)
        m.m[i] = (float)(i + 1);
    nkw_mat4 inverse = nkw_mat4_inverse(&m);
    for (int i = 0; i < 16; i++)
        assert_true(inverse.m[i] == 0.0f);
}

static void mat3_inverse_of_an_infinite_scale_is_zero(void **state)
{
    (void)state;
    nkw_mat3 m = {{INFINITY, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f}};
    nkw_mat3 inverse = nkw_mat3_inverse(&m);
    for (int i = 0; i < 9; i++)
        assert_true(inverse.m[i] == 0.0f);
}

static void inverses_of_what_is_not_finite_are_zero(void **state)
{
    (void)state;
    for (size_t k = 0; k < 32; k++) {
        nkw_mat4 m = nkw_mat4_identity();
        m.m[k / 2] = k % 2 ? INFINITY : NAN;
        nkw_mat4 general = nkw_mat4_inverse(&m), affine = nkw_mat4_inverse_affine(&m);
        for (size_t i = 0; i < 16; i++) {
            assert_true(general.m[i] == 0.0f);
            assert_true(affine.m[i] == 0.0f || k / 2 % 4 == 3 || k / 2 > 11);
        }
    }
}

static void projection_takes_w_from_all_four(void **state)
{
    (void)state;
    nkw_mat4 m = nkw_mat4_identity();
    m.m[3] = 2.0f, m.m[7] = 3.0f, m.m[11] = 5.0f, m.m[15] = 7.0f;
    /* w = 2 * 1 + 3 * 2 + 5 * 4 + 7 = 35 */
    expect_vec3_bits(nkw_mat4_project_point(&m, vec(1, 2, 4)), vec(1 / 35.0f, 2 / 35.0f, 4 / 35.0f));
}

/* Gauss-Jordan with full pivoting in long double. */
static void inverse_by_elimination(const nkw_mat4 *m, long double out[16])
{
    long double a[4][8] = {{0}};
    int column_of[4] = {0}, taken[4] = {0};
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++)
            a[i][j] = m->m[j * 4 + i];
        a[i][4 + i] = 1;
    }
    for (int k = 0; k < 4; k++) {
        int row = k, column = -1;
        for (int i = k; i < 4; i++)
            for (int j = 0; j < 4; j++)
                if (!taken[j] && (column < 0 || fabsl(a[i][j]) > fabsl(a[row][column])))
                    row = i, column = j;
        taken[column] = 1;
        column_of[k] = column;
        for (int j = 0; j < 8; j++) {
            long double t = a[k][j];
            a[k][j] = a[row][j], a[row][j] = t;
        }
        long double by = a[k][column];
        for (int j = 0; j < 8; j++)
            a[k][j] /= by;
        for (int i = 0; i < 4; i++) {
            long double f = i == k ? 0 : a[i][column];
            for (int j = 0; j < 8; j++)
                a[i][j] -= f * a[k][j];
        }
    }
    for (int k = 0; k < 4; k++)
        for (int j = 0; j < 4; j++)
            out[j * 4 + column_of[k]] = a[k][4 + j];
}

static void expect_inverse(const nkw_mat4 *m, const nkw_mat4 *got, double part)
{
    long double want[16], largest = 0;
    inverse_by_elimination(m, want);
    for (int i = 0; i < 16; i++)
        largest = fabsl(want[i]) > largest ? fabsl(want[i]) : largest;
    for (int i = 0; i < 16; i++)
        expect_near(got->m[i], (double)want[i], part * (double)largest);
}

/*
 * Rows or columns that nearly depend on each other, now and then in two pairs: from about 1 : 4000 on, cofactors cancel
 * too much. The first element is 0 half of the time.
 */
static void inverse_of_nearly_singular_matrices_is_exact(void **state)
{
    (void)state;
    random_source r = random_from(14);
    for (int i = 0; i < 4000; i++) {
        nkw_mat4 m;
        for (int k = 0; k < 16; k++)
            m.m[k] = random_between(&r, -1, 1);
        m.m[0] = i % 5 < 3 ? 0.0f : m.m[0];
        for (int pair = 0; pair < 1 + i / 8 % 2; pair++) {
            float part = nkw_abs(random_scaled(&r, -20, -8));
            int to = i % 4, from = (to + 1 + i / 4 % 3) % 4, other = (to + 1 + (i / 4 + 1) % 3) % 4;
            int t = pair ? other : to, f = pair ? 6 - to - from - other : from;
            for (int k = 0; k < 4; k++)
                if (i % 2)
                    m.m[t * 4 + k] = m.m[f * 4 + k] + part * m.m[t * 4 + k];
                else
                    m.m[k * 4 + t] = m.m[k * 4 + f] + part * m.m[k * 4 + t];
        }
        nkw_mat4 got = nkw_mat4_inverse(&m);
        expect_inverse(&m, &got, 1.2e-7);
    }
}

/* Every term of every cofactor is largest somewhere: all but a permutation's elements are small. */
static void inverse_of_any_permutation_is_exact(void **state)
{
    (void)state;
    random_source r = random_from(15);
    for (int i = 0; i < 2400; i++) {
        int place[4] = {0, 1, 2, 3}, code = i % 24;
        for (int k = 3; k > 0; code /= k + 1, k--) {
            int other = code % (k + 1), t = place[k];
            place[k] = place[other], place[other] = t;
        }
        nkw_mat4 m;
        for (int k = 0; k < 16; k++)
            m.m[k] = random_scaled(&r, -12, -6);
        for (int k = 0; k < 4; k++)
            m.m[k * 4 + place[k]] = random_scaled(&r, -2, 2);
        nkw_mat4 got = nkw_mat4_inverse(&m);
        expect_inverse(&m, &got, 1.2e-7);
    }
}

/* y 2^-14 rad from x still has a defined direction: it stays in the plane of both. */
static void orthonormalize_keeps_the_plane_of_close_columns(void **state)
{
    (void)state;
    nkw_mat3 m = {{1, 0, 0, 1, 0x1p-14f, 0x1p-14f, 0, 0, 1}}, got = nkw_mat3_orthonormalize(&m);
    expect_vec3_near(nkw_mat3_column(&got, 0), vec(1, 0, 0), 0);
    expect_vec3_near(nkw_mat3_column(&got, 1), vec(0, 0x1.6a09e6p-1f, 0x1.6a09e6p-1f), 1e-7);
    expect_vec3_near(nkw_mat3_column(&got, 2), vec(0, -0x1.6a09e6p-1f, 0x1.6a09e6p-1f), 1e-7);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(inverses_of_what_is_not_finite_are_zero),
        cmocka_unit_test(mat4_inverse_of_singular_integers_is_zero),
        cmocka_unit_test(mat3_inverse_of_an_infinite_scale_is_zero),
        cmocka_unit_test(elements_stand_column_by_column),
        cmocka_unit_test(product_applies_the_right_factor_first),
        cmocka_unit_test(a_product_by_hand),
        cmocka_unit_test(affine_product_equals_the_general_one),
        cmocka_unit_test(an_output_may_be_an_input),
        cmocka_unit_test(transpose_turns_rows_into_columns),
        cmocka_unit_test(directions_do_not_see_the_translation),
        cmocka_unit_test(projection_divides_by_w),
        cmocka_unit_test(determinants_by_hand),
        cmocka_unit_test(inverse_times_matrix_is_identity),
        cmocka_unit_test(inverse_by_hand),
        cmocka_unit_test(inverse_survives_extreme_scales),
        cmocka_unit_test(singular_matrices_give_the_zero_matrix),
        cmocka_unit_test(exactly_dependent_columns_have_no_inverse),
        cmocka_unit_test(a_far_translation_and_uneven_scales_have_an_inverse),
        cmocka_unit_test(rigid_inverse_is_the_transpose),
        cmocka_unit_test(normal_matrix_is_the_inverse_transpose),
        cmocka_unit_test(normal_matrix_survives_a_zero_scale),
        cmocka_unit_test(normals_of_a_flat_product_do_not_flip),
        cmocka_unit_test(normal_matrix_turns_with_a_mirror),
        cmocka_unit_test(orthonormalize_keeps_x_and_the_side_of_z),
        cmocka_unit_test(orthonormalize_replaces_what_has_no_direction),
        cmocka_unit_test(orthonormalize_of_nan_is_nan_from_its_column_on),
        cmocka_unit_test(row_major_storage_is_transposed),
        cmocka_unit_test(row_vectors_stored_by_rows_have_the_same_bytes),
        cmocka_unit_test(projection_takes_w_from_all_four),
        cmocka_unit_test(inverse_of_nearly_singular_matrices_is_exact),
        cmocka_unit_test(inverse_of_any_permutation_is_exact),
        cmocka_unit_test(orthonormalize_keeps_the_plane_of_close_columns),
    };
    return cmocka_run_group_tests_name("mat", tests, NULL, NULL);
}
