/* SPDX-License-Identifier: MIT */
/* Errors of <nakawari/mat.h> against binary128. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <string.h>

#define SAMPLES 160000u
/* For what needs a 4x4 elimination in binary128. */
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

static void wide_mat4_mul(const float *x, wide out[16])
{
    wide b[16];
    wide_from(x, out, 16);
    wide_from(x + 16, b, 16);
    wide_mat_mul(out, b, out, 4);
}

static double mat4_mul_error(const float *x)
{
    wide exact[16];
    nkw_mat4 m = mat4_at(x), n = mat4_at(x + 16), got = nkw_mat4_mul(&m, &n);
    wide_mat4_mul(x, exact);
    return wide_error(got.m, exact, 16);
}

static double mul_affine_error(const float *x)
{
    wide exact[16];
    nkw_mat4 m = mat4_at(x), n = mat4_at(x + 16), got = nkw_mat4_mul_affine(&m, &n);
    wide_mat4_mul(x, exact);
    return wide_error(got.m, exact, 16);
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

static double normal_error(const float *x)
{
    wide m[9];
    nkw_mat3 f = mat3_at(x), got = nkw_mat3_normal(&f), transposed = nkw_mat3_transpose(&got);
    wide_from(x, m, 9);
    return wide_inverse(m, m, 3) ? wide_error(transposed.m, m, 9) : HUGE_VAL;
}

static double inverse4_error(const float *x)
{
    wide m[16];
    nkw_mat4 f = mat4_at(x), got = nkw_mat4_inverse(&f);
    wide_from(x, m, 16);
    return wide_inverse(m, m, 4) ? wide_error(got.m, m, 16) : HUGE_VAL;
}

static double inverse_affine_error(const float *x)
{
    wide m[16];
    nkw_mat4 f = mat4_at(x), got = nkw_mat4_inverse_affine(&f);
    wide_from(x, m, 16);
    return wide_inverse(m, m, 4) ? wide_error(got.m, m, 16) : HUGE_VAL;
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
    wide m[16];
    nkw_mat4 f = mat4_at(x), got = nkw_mat4_inverse_rigid(&f);
    wide_from(x, m, 16);
    return wide_inverse(m, m, 4) ? wide_error(got.m, m, 16) : HUGE_VAL;
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

static const wide_case cases[] = {
    {"nkw_mat3_mul", "rotations", rotations, mat3_mul_error, 18, WIDE_CHECKED},
    {"nkw_mat3_from_quat", "uniform", rotation, from_quat_error, 4, WIDE_CHECKED},
    {"nkw_mat3_from_quat", "half angle 1e-7 .. 1e-2", small_rotation, from_quat_error, 4, WIDE_CHECKED},
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
    {"nkw_mat3_normal", "condition 1e0 .. 1e1", mat3_e0, normal_error, 9, WIDE_CHECKED},
    {"nkw_mat3_normal", "condition 1e6 .. 1e7", mat3_e6, normal_error, 9, WIDE_CHECKED},
    {"nkw_mat3_orthonormalize", "rotations, noise 1e-3", noisy_rotation, orthonormalize_error, 9, WIDE_CHECKED},
    {"nkw_mat3_orthonormalize", "condition 1e0 .. 1e1", mat3_e0, orthonormalize_error, 9, WIDE_CHECKED},
    {"nkw_mat3_orthonormalize", "condition 1e3 .. 1e4", mat3_e3, orthonormalize_error, 9, WIDE_CHECKED},
    {"nkw_mat3_orthonormalize", "condition 1e6 .. 1e7", mat3_e6, orthonormalize_error, 9, WIDE_CHECKED},
    {"nkw_mat3_orthonormalize", "mirrors", mirrored, orthonormalize_error, 9, WIDE_CHECKED},
    {"nkw_mat4_mul", "elements in [-1, 1]", elements, mat4_mul_error, 32, WIDE_CHECKED},
    {"nkw_mat4_mul", "T R S", affine_pair, mat4_mul_error, 32, WIDE_NOTED},
    {"nkw_mat4_mul_affine", "elements in [-1, 1]", affine_elements, mul_affine_error, 32, WIDE_CHECKED},
    {"nkw_mat4_mul_affine", "T R S", affine_pair, mul_affine_error, 32, WIDE_NOTED},
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
    {"nkw_mat4_inverse_rigid", "rounded rotations", rigid, inverse_rigid_error, 16, WIDE_NOTED},
};

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("mat.h", argc, argv);
    wide_run(&a, cases, sizeof cases / sizeof cases[0], SAMPLES);
    wide_run(&a, costly, sizeof costly / sizeof costly[0], FEWER);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
