/* SPDX-License-Identifier: MIT */
/* Errors of <nakawari/mat.h> against binary128. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <string.h>

#define SAMPLES 40000u
/* For what needs a 4x4 elimination in binary128, and for what is mostly samples. */
#define FEWER 50000u

static nkw_mat3 mat3_at(const float *x)
{
    nkw_mat3 m;
    memcpy(m.m, x, sizeof m.m);
    return m;
}

static nkw_mat4 mat4_at(const float *x)
{
    nkw_mat4 m;
    memcpy(m.m, x, sizeof m.m);
    return m;
}

/* ---- Matrices U diag(s) V with singular values 1 .. 1/condition ---- */

/* x -> p x q turns the space of four dimensions: p times the basis from the left, q from the right. */
static void turn4(nkw_quat p, nkw_quat q, double m[16])
{
    const double a[16] = {p.w, p.z, -p.y, -p.x, -p.z, p.w, p.x, -p.y, p.y, -p.x, p.w, -p.z, p.x, p.y, p.z, p.w};
    const double b[16] = {q.w, -q.z, q.y, -q.x, q.z, q.w, -q.x, -q.y, -q.y, q.x, q.w, -q.z, q.x, q.y, q.z, q.w};
    for (int i = 0; i < 16; i++) {
        m[i] = 0.0;
        for (int k = 0; k < 4; k++)
            m[i] += a[k * 4 + i % 4] * b[i / 4 * 4 + k];
    }
}

static void assemble(const double *u, const double *s, const double *v, float *x, int n)
{
    for (int i = 0; i < n * n; i++) {
        double sum = 0.0;
        for (int k = 0; k < n; k++)
            sum += u[k * n + i % n] * s[k] * v[i / n * n + k];
        x[i] = (float)sum;
    }
}

static void conditioned(random_source *r, float *x, int n, float decade)
{
    double u[16], v[16], s[4];
    float condition = random_log(r, decade, 10.0f * decade);
    if (n == 3) {
        double_mat3_from_quat(random_unit_quat(r), u);
        double_mat3_from_quat(random_unit_quat(r), v);
    } else {
        nkw_quat p = random_unit_quat(r), q = random_unit_quat(r);
        turn4(p, q, u);
        p = random_unit_quat(r);
        turn4(p, random_unit_quat(r), v);
    }
    for (int i = 1; i < n; i++)
        s[i] = 1.0 / (double)random_log(r, 1.0f, condition);
    s[0] = 1.0;
    s[n - 1] = 1.0 / (double)condition;
    assemble(u, s, v, x, n);
}

#define DECADE(name, n, decade)                                                                                        \
    static void name(random_source *r, float *x)                                                                       \
    {                                                                                                                  \
        conditioned(r, x, n, decade);                                                                                  \
    }

DECADE(mat3_e0, 3, 1e0f)
DECADE(mat3_e1, 3, 1e1f)
DECADE(mat3_e2, 3, 1e2f)
DECADE(mat3_e3, 3, 1e3f)
DECADE(mat3_e4, 3, 1e4f)
DECADE(mat3_e5, 3, 1e5f)
DECADE(mat3_e6, 3, 1e6f)
DECADE(mat4_e0, 4, 1e0f)
DECADE(mat4_e1, 4, 1e1f)
DECADE(mat4_e2, 4, 1e2f)
DECADE(mat4_e3, 4, 1e3f)
DECADE(mat4_e4, 4, 1e4f)
DECADE(mat4_e5, 4, 1e5f)
DECADE(mat4_e6, 4, 1e6f)

/* ---- T R S with scales up to ratio : 1 ---- */

static void affine(random_source *r, float *x, float ratio)
{
    double m[9];
    float size = random_log(r, 1e-2f, 1e2f);
    double_mat3_from_quat(random_unit_quat(r), m);
    memset(x, 0, 16 * sizeof *x);
    for (int c = 0; c < 3; c++) {
        double s = (double)random_log(r, size, size * ratio);
        for (int i = 0; i < 3; i++)
            x[c * 4 + i] = (float)(s * m[c * 3 + i]);
    }
    put_vec3(x + 12, random_vec3(r, -10.0f, 10.0f));
    x[15] = 1.0f;
}

static void affine_1(random_source *r, float *x)
{
    affine(r, x, 10.0f);
}

static void affine_2(random_source *r, float *x)
{
    affine(r, x, 100.0f);
}

static void affine_3(random_source *r, float *x)
{
    affine(r, x, 1000.0f);
}

/* ---- Products ---- */

static void rotations(random_source *r, float *x)
{
    double m[9];
    for (int k = 0; k < 18; k += 9) {
        double_mat3_from_quat(random_unit_quat(r), m);
        for (int i = 0; i < 9; i++)
            x[k + i] = (float)m[i];
    }
}

static double mat3_mul_error(const float *x)
{
    wide a[9], b[9];
    nkw_mat3 m = mat3_at(x), n = mat3_at(x + 9), got = nkw_mat3_mul(&m, &n);
    wide_from(x, a, 9);
    wide_from(x + 9, b, 9);
    wide_mat_mul(a, b, a, 3);
    return wide_error(got.m, a, 9);
}

static void elements(random_source *r, float *x)
{
    for (int i = 0; i < 32; i++)
        x[i] = random_between(r, -1.0f, 1.0f);
}

static void affine_elements(random_source *r, float *x)
{
    elements(r, x);
    for (int i = 3; i < 32; i += 4)
        x[i] = i % 16 == 15 ? 1.0f : 0.0f;
}

static void affine_pair(random_source *r, float *x)
{
    affine(r, x, 10.0f);
    affine(r, x + 16, 10.0f);
}

/* Of the product of the factors' norms. */
static double of_factors(const float *got, const float *x)
{
    wide a[16], b[16], exact[16];
    wide_from(x, a, 16);
    wide_from(x + 16, b, 16);
    wide_mat_mul(a, b, exact, 4);
    return wide_error_of(got, exact, 16, wide_length(a, 16) * wide_length(b, 16));
}

static double mat4_mul_error(const float *x)
{
    nkw_mat4 m = mat4_at(x), n = mat4_at(x + 16), got = nkw_mat4_mul(&m, &n);
    return of_factors(got.m, x);
}

static double mul_affine_error(const float *x)
{
    nkw_mat4 m = mat4_at(x), n = mat4_at(x + 16), got = nkw_mat4_mul_affine(&m, &n);
    return of_factors(got.m, x);
}

/* ---- The matrix of a quaternion ---- */

static void rotation(random_source *r, float *x)
{
    put_quat(x, random_unit_quat(r));
}

static void small_rotation(random_source *r, float *x)
{
    float half = random_log(r, 1e-7f, 1e-2f);
    put_quat(x, random_unit_near(r, nkw_quat_identity(), half));
}

/* The norm of a rotation matrix is sqrt 3. */
static double from_quat_error(const float *x)
{
    wide q[4], m[9];
    nkw_mat3 got = nkw_mat3_from_quat(quat_at(x));
    wide_from(x, q, 4);
    wide_mat3_from_quat(q, m);
    return wide_error(got.m, m, 9);
}

static double from_quat_element_error(const float *x)
{
    wide q[4], m[9];
    double worst = 0.0;
    nkw_mat3 got = nkw_mat3_from_quat(quat_at(x));
    wide_from(x, q, 4);
    wide_mat3_from_quat(q, m);
    for (int i = 0; i < 9; i++)
        worst = fmax(worst, wide_error_of(got.m + i, m + i, 1, 1));
    return worst;
}

/* ---- Determinants and inverses ---- */

static double det3_error(const float *x)
{
    wide m[9];
    nkw_mat3 f = mat3_at(x);
    wide_from(x, m, 9);
    return accuracy_ulps(nkw_mat3_determinant(&f), (double)wide_determinant(m, 3));
}

static double det4_error(const float *x)
{
    wide m[16];
    nkw_mat4 f = mat4_at(x);
    wide_from(x, m, 16);
    return accuracy_ulps(nkw_mat4_determinant(&f), (double)wide_determinant(m, 4));
}

static double inverse3_error(const float *x)
{
    wide m[9];
    nkw_mat3 f = mat3_at(x), got = nkw_mat3_inverse(&f);
    wide_from(x, m, 9);
    return wide_inverse(m, m, 3) ? wide_error(got.m, m, 9) : HUGE_VAL;
}

/* Of the norm of the whole inverse. */
static double off_inverse(nkw_mat4 got, const float *x)
{
    wide m[16];
    wide_from(x, m, 16);
    return wide_inverse(m, m, 4) ? wide_error(got.m, m, 16) : HUGE_VAL;
}

static double inverse4_error(const float *x)
{
    nkw_mat4 f = mat4_at(x);
    return off_inverse(nkw_mat4_inverse(&f), x);
}

/* The block of |A^-1| and the translation of |A^-1| |t|, the larger of the two. */
static double inverse_affine_error(const float *x)
{
    wide m[16], block[9], t[3];
    nkw_mat4 f = mat4_at(x), got = nkw_mat4_inverse_affine(&f);
    nkw_mat3 linear = nkw_mat3_from_mat4(&got);
    wide_from(x, m, 16);
    wide_from(x + 12, t, 3);
    if (!wide_inverse(m, m, 4))
        return HUGE_VAL;
    wide_block(m, block);
    double place = wide_error_of(got.m + 12, m + 12, 3, wide_length(block, 9) * wide_length(t, 3));
    return fmax(wide_error(linear.m, block, 9), place);
}

/* Columns at random: from hardly to strongly sheared. */
static void sheared(random_source *r, float *x)
{
    affine(r, x, 10.0f);
    for (int i = 0; i < 12; i++)
        x[i] = i % 4 < 3 ? random_between(r, -1.0f, 1.0f) : 0.0f;
}

/* Rigid matrices are inverted as if they were exact. */
static void rigid(random_source *r, float *x)
{
    double m[9];
    double_mat3_from_quat(random_unit_quat(r), m);
    memset(x, 0, 16 * sizeof *x);
    for (int i = 0; i < 9; i++)
        x[i / 3 * 4 + i % 3] = (float)m[i];
    put_vec3(x + 12, random_vec3(r, -10.0f, 10.0f));
    x[15] = 1.0f;
}

static double inverse_rigid_error(const float *x)
{
    nkw_mat4 f = mat4_at(x);
    return off_inverse(nkw_mat4_inverse_rigid(&f), x);
}

/* ---- Gram and Schmidt ---- */

static void noisy_rotation(random_source *r, float *x)
{
    rotations(r, x);
    for (int i = 0; i < 9; i++)
        x[i] += random_between(r, -1e-3f, 1e-3f);
}

static void mirrored(random_source *r, float *x)
{
    mat3_e0(r, x);
    for (int i = 0; i < 9; i++)
        x[i] = -x[i];
}

static double orthonormalize_error(const float *x)
{
    wide m[9], z[3];
    double worst = 0.0;
    nkw_mat3 f = mat3_at(x), got = nkw_mat3_orthonormalize(&f);
    wide_from(x, m, 9);
    wide_normalize(m, 3);
    wide along = wide_dot(m, m + 3, 3);
    for (int i = 0; i < 3; i++)
        m[3 + i] -= along * m[i];
    wide_normalize(m + 3, 3);
    wide_cross(m, m + 3, z);
    wide side = wide_dot(z, m + 6, 3) < 0 ? -1 : 1;
    for (int i = 0; i < 3; i++)
        m[6 + i] = side * z[i];
    for (int c = 0; c < 9; c += 3)
        worst = fmax(worst, wide_error(got.m + c, m + c, 3));
    return worst;
}

/* ---- On vectors: the vector, then the matrix ---- */

static void turned_vector(random_source *r, float *x)
{
    rotations(r, x + 3);
    put_vec3(x, random_vec3(r, -10.0f, 10.0f));
}

static void vector_and_elements(random_source *r, float *x)
{
    elements(r, x + 3);
    put_vec3(x, random_vec3(r, -10.0f, 10.0f));
}

static void vector_and_affine(random_source *r, float *x)
{
    affine(r, x + 3, 10.0f);
    put_vec3(x, random_vec3(r, -10.0f, 10.0f));
}

static void scattered(random_source *r, float *x)
{
    for (int i = 0; i < 19; i++)
        x[i] = random_scaled(r, -20, 20);
}

/* A vector that is nearly lost: at right angles to two of the rows, to 2^-24 .. 2^-4. */
static void lost_vector(random_source *r, float *x, int stride)
{
    elements(r, x + 3);
    const float *m = x + 3;
    nkw_vec3 a = {m[0], m[stride], m[2 * stride]}, b = {m[1], m[stride + 1], m[2 * stride + 1]};
    nkw_vec3 v = nkw_vec3_normalize(nkw_vec3_cross(a, b)), off = random_vec3(r, -1.0f, 1.0f);
    put_vec3(x, nkw_vec3_add_scaled(v, off, random_scaled(r, -24, -4)));
}

static void lost_vector3(random_source *r, float *x)
{
    lost_vector(r, x, 3);
}

static void lost_vector4(random_source *r, float *x)
{
    lost_vector(r, x, 4);
}

/* A point that comes near the origin. */
static void lost_point(random_source *r, float *x)
{
    vector_and_affine(r, x);
    nkw_mat4 m = mat4_at(x + 3);
    nkw_vec3 t = nkw_mat4_transform_direction(&m, vec3_at(x)), off = random_vec3(r, -1.0f, 1.0f);
    put_vec3(x + 15, nkw_vec3_add_scaled(nkw_vec3_negate(t), off, random_scaled(r, -24, -4)));
}

/* The 3x3 block of m, columns `stride` apart, on v. Gives |m| |v|. */
static wide wide_on_vector(const float *m, int stride, const float *v, wide out[3])
{
    wide a[9], w[3];
    for (int i = 0; i < 9; i++)
        a[i] = m[i / 3 * stride + i % 3];
    wide_from(v, w, 3);
    for (int i = 0; i < 3; i++)
        out[i] = a[i] * w[0] + a[3 + i] * w[1] + a[6 + i] * w[2];
    return wide_length(a, 9) * wide_length(w, 3);
}

/* The matrix in x on the vector, exactly and by the library. Gives |m| |v|. */
static wide transform3(const float *x, wide exact[3], float got[3])
{
    nkw_mat3 m = mat3_at(x + 3);
    put_vec3(got, nkw_mat3_transform(&m, vec3_at(x)));
    return wide_on_vector(x + 3, 3, x, exact);
}

static double transform3_error(const float *x)
{
    float got[3];
    wide exact[3], size = transform3(x, exact, got);
    return wide_error_of(got, exact, 3, size);
}

/* For rotations. */
static double transform3_turn_error(const float *x)
{
    float got[3];
    wide exact[3];
    transform3(x, exact, got);
    return wide_error(got, exact, 3);
}

static double direction_error(const float *x)
{
    wide exact[3], size = wide_on_vector(x + 3, 4, x, exact);
    nkw_mat4 m = mat4_at(x + 3);
    float got[3];
    put_vec3(got, nkw_mat4_transform_direction(&m, vec3_at(x)));
    return wide_error_of(got, exact, 3, size);
}

static double point_error(const float *x)
{
    wide exact[3], t[3], size = wide_on_vector(x + 3, 4, x, exact);
    nkw_mat4 m = mat4_at(x + 3);
    float got[3];
    wide_from(x + 15, t, 3);
    for (int i = 0; i < 3; i++)
        exact[i] += t[i];
    put_vec3(got, nkw_mat4_transform_point(&m, vec3_at(x)));
    return wide_error_of(got, exact, 3, size + wide_length(t, 3));
}

/* w of 2^-12 .. 2^-2 of its terms. */
static void vanishing_w(random_source *r, float *x)
{
    vector_and_elements(r, x);
    const float *m = x + 3;
    x[18] = -((m[3] * x[0] + m[7] * x[1]) + m[11] * x[2]) + random_scaled(r, -12, -2);
}

/* A perspective of 30 to 120 degrees on a point in view. */
static void in_view(random_source *r, float *x)
{
    float f = random_between(r, 0.58f, 3.73f), near = random_log(r, 0.01f, 1.0f),
          far = near * random_log(r, 10.0f, 1e4f);
    float depth = random_log(r, near, far), aspect = random_between(r, 0.5f, 2.0f);
    nkw_mat4 m = {{f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (far + near) / (near - far), -1, 0, 0, 0, 0}};
    m.m[14] = 2.0f * far * near / (near - far);
    x[0] = random_between(r, -1.0f, 1.0f) * depth * aspect / f;
    x[1] = random_between(r, -1.0f, 1.0f) * depth / f;
    x[2] = -depth;
    memcpy(x + 3, m.m, sizeof m.m);
}

/* Of (1 + |q|) |m| |(p, 1)| / |w| or, in view, of 1. */
static double project_error(const float *x, int of_one)
{
    wide m[16], p[4] = {x[0], x[1], x[2], 1}, q[4];
    nkw_mat4 f = mat4_at(x + 3);
    float got[3];
    wide_from(x + 3, m, 16);
    for (int i = 0; i < 4; i++)
        q[i] = m[i] * p[0] + m[4 + i] * p[1] + m[8 + i] * p[2] + m[12 + i];
    wide_scale(q, 1 / q[3], 3);
    wide size = (1 + wide_length(q, 3)) * wide_length(m, 16) * wide_length(p, 4) / q[3];
    put_vec3(got, nkw_mat4_project_point(&f, vec3_at(x)));
    return wide_error_of(got, q, 3, of_one ? 1 : size < 0 ? -size : size);
}

static double project_any_error(const float *x)
{
    return project_error(x, 0);
}

static double project_view_error(const float *x)
{
    return project_error(x, 1);
}

/* -R^T t, of |t|; the rest bit by bit. */
static double rigid_place_error(const float *x)
{
    wide exact[3];
    nkw_mat4 f = mat4_at(x), got = nkw_mat4_inverse_rigid(&f);
    nkw_mat3 block = nkw_mat3_from_mat4(&f), back = nkw_mat3_transpose(&block), turned = nkw_mat3_from_mat4(&got);
    float t[3] = {-x[12], -x[13], -x[14]};
    wide size[3];
    wide_on_vector(back.m, 3, t, exact);
    wide_from(t, size, 3);
    return memcmp(&back, &turned, sizeof back) ? HUGE_VAL : wide_error_of(got.m + 12, exact, 3, wide_length(size, 3));
}

static const wide_case vectors[] = {
    {"nkw_mat3_transform", "rotations", turned_vector, transform3_error, 12, WIDE_CHECKED},
    {"nkw_mat3_transform", "elements in [-1, 1]", vector_and_elements, transform3_error, 12, WIDE_CHECKED},
    {"nkw_mat3_transform", "2^-20 .. 2^20 mixed", scattered, transform3_error, 12, WIDE_CHECKED},
    {"nkw_mat3_transform", "v nearly cancelled", lost_vector3, transform3_error, 12, WIDE_CHECKED},
    {"nkw_mat3_transform", "rotations, of abs(v)", turned_vector, transform3_turn_error, 12, WIDE_NOTED},
    {"nkw_mat4_transform_point", "T R S", vector_and_affine, point_error, 19, WIDE_CHECKED},
    {"nkw_mat4_transform_point", "elements in [-1, 1]", vector_and_elements, point_error, 19, WIDE_CHECKED},
    {"nkw_mat4_transform_point", "2^-20 .. 2^20 mixed", scattered, point_error, 19, WIDE_CHECKED},
    {"nkw_mat4_transform_point", "T R S, result near the origin", lost_point, point_error, 19, WIDE_CHECKED},
    {"nkw_mat4_transform_direction", "T R S", vector_and_affine, direction_error, 19, WIDE_CHECKED},
    {"nkw_mat4_transform_direction", "elements in [-1, 1]", vector_and_elements, direction_error, 19, WIDE_CHECKED},
    {"nkw_mat4_transform_direction", "2^-20 .. 2^20 mixed", scattered, direction_error, 19, WIDE_CHECKED},
    {"nkw_mat4_transform_direction", "d nearly cancelled", lost_vector4, direction_error, 19, WIDE_CHECKED},
    {"nkw_mat4_project_point", "elements in [-1, 1]", vector_and_elements, project_any_error, 19, WIDE_CHECKED},
    {"nkw_mat4_project_point", "2^-20 .. 2^20 mixed", scattered, project_any_error, 19, WIDE_CHECKED},
    {"nkw_mat4_project_point", "w 2^-12 .. 2^-2 of its terms", vanishing_w, project_any_error, 19, WIDE_CHECKED},
    {"nkw_mat4_project_point", "perspective, in view", in_view, project_any_error, 19, WIDE_CHECKED},
    {"nkw_mat4_project_point", "perspective, in view, of 1", in_view, project_view_error, 19, WIDE_NOTED},
    {"nkw_mat4_inverse_rigid", "translation", rigid, rigid_place_error, 16, WIDE_CHECKED},
};

static const wide_case cases[] = {
    {"nkw_mat3_mul", "rotations", rotations, mat3_mul_error, 18, WIDE_CHECKED},
    {"nkw_mat3_from_quat", "uniform", rotation, from_quat_error, 4, WIDE_UNITS},
    {"nkw_mat3_from_quat", "half angle 1e-7 .. 1e-2", small_rotation, from_quat_error, 4, WIDE_UNITS},
    {"nkw_mat3_from_quat", "uniform, worst element", rotation, from_quat_element_error, 4, WIDE_NOTED},
    {"nkw_mat3_determinant", "condition 1e0 .. 1e1", mat3_e0, det3_error, 9, WIDE_CHECKED},
    {"nkw_mat3_determinant", "condition 1e3 .. 1e4", mat3_e3, det3_error, 9, WIDE_CHECKED},
    {"nkw_mat3_determinant", "condition 1e6 .. 1e7", mat3_e6, det3_error, 9, WIDE_CHECKED},
    {"nkw_mat3_inverse", "condition 1e0 .. 1e1", mat3_e0, inverse3_error, 9, WIDE_CHECKED},
    {"nkw_mat3_inverse", "condition 1e1 .. 1e2", mat3_e1, inverse3_error, 9, WIDE_CHECKED},
    {"nkw_mat3_inverse", "condition 1e2 .. 1e3", mat3_e2, inverse3_error, 9, WIDE_CHECKED},
    {"nkw_mat3_inverse", "condition 1e3 .. 1e4", mat3_e3, inverse3_error, 9, WIDE_CHECKED},
    {"nkw_mat3_inverse", "condition 1e4 .. 1e5", mat3_e4, inverse3_error, 9, WIDE_CHECKED},
    {"nkw_mat3_inverse", "condition 1e5 .. 1e6", mat3_e5, inverse3_error, 9, WIDE_CHECKED},
    {"nkw_mat3_inverse", "condition 1e6 .. 1e7", mat3_e6, inverse3_error, 9, WIDE_CHECKED},
    {"nkw_mat3_orthonormalize", "rotations, noise 1e-3", noisy_rotation, orthonormalize_error, 9, WIDE_CHECKED},
    {"nkw_mat3_orthonormalize", "condition 1e0 .. 1e1", mat3_e0, orthonormalize_error, 9, WIDE_CHECKED},
    {"nkw_mat3_orthonormalize", "condition 1e3 .. 1e4", mat3_e3, orthonormalize_error, 9, WIDE_CHECKED},
    {"nkw_mat3_orthonormalize", "condition 1e6 .. 1e7", mat3_e6, orthonormalize_error, 9, WIDE_CHECKED},
    {"nkw_mat3_orthonormalize", "mirrors", mirrored, orthonormalize_error, 9, WIDE_CHECKED},
    {"nkw_mat4_mul", "elements in [-1, 1]", elements, mat4_mul_error, 32, WIDE_CHECKED},
    {"nkw_mat4_mul", "T R S", affine_pair, mat4_mul_error, 32, WIDE_CHECKED},
    {"nkw_mat4_mul_affine", "elements in [-1, 1]", affine_elements, mul_affine_error, 32, WIDE_CHECKED},
    {"nkw_mat4_mul_affine", "T R S", affine_pair, mul_affine_error, 32, WIDE_CHECKED},
};

static const wide_case costly[] = {
    {"nkw_mat4_determinant", "condition 1e0 .. 1e1", mat4_e0, det4_error, 16, WIDE_CHECKED},
    {"nkw_mat4_determinant", "condition 1e3 .. 1e4", mat4_e3, det4_error, 16, WIDE_CHECKED},
    {"nkw_mat4_inverse", "condition 1e0 .. 1e1", mat4_e0, inverse4_error, 16, WIDE_CHECKED},
    {"nkw_mat4_inverse", "condition 1e1 .. 1e2", mat4_e1, inverse4_error, 16, WIDE_CHECKED},
    {"nkw_mat4_inverse", "condition 1e2 .. 1e3", mat4_e2, inverse4_error, 16, WIDE_CHECKED},
    {"nkw_mat4_inverse", "condition 1e3 .. 1e4", mat4_e3, inverse4_error, 16, WIDE_CHECKED},
    {"nkw_mat4_inverse", "condition 1e4 .. 1e5", mat4_e4, inverse4_error, 16, WIDE_CHECKED},
    {"nkw_mat4_inverse", "condition 1e5 .. 1e6", mat4_e5, inverse4_error, 16, WIDE_CHECKED},
    {"nkw_mat4_inverse", "condition 1e6 .. 1e7", mat4_e6, inverse4_error, 16, WIDE_CHECKED},
    {"nkw_mat4_inverse", "T R S, scales to 10 : 1", affine_1, inverse4_error, 16, WIDE_CHECKED},
    {"nkw_mat4_inverse", "T R S, scales to 1000 : 1", affine_3, inverse4_error, 16, WIDE_CHECKED},
    {"nkw_mat4_inverse_affine", "scales to 10 : 1", affine_1, inverse_affine_error, 16, WIDE_CHECKED},
    {"nkw_mat4_inverse_affine", "scales to 100 : 1", affine_2, inverse_affine_error, 16, WIDE_CHECKED},
    {"nkw_mat4_inverse_affine", "scales to 1000 : 1", affine_3, inverse_affine_error, 16, WIDE_CHECKED},
    {"nkw_mat4_inverse_affine", "block in [-1, 1]", sheared, inverse_affine_error, 16, WIDE_CHECKED},
    {"nkw_mat4_inverse_rigid", "rounded rotations", rigid, inverse_rigid_error, 16, WIDE_NOTED},
};

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("mat.h", argc, argv);
    wide_search(&a, cases, sizeof cases / sizeof cases[0], SAMPLES);
    wide_search(&a, vectors, sizeof vectors / sizeof vectors[0], FEWER);
    wide_search(&a, costly, sizeof costly / sizeof costly[0], FEWER);
    mat_more(&a);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
