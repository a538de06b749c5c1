/* SPDX-License-Identifier: MIT */
/* Errors of <nakawari/mat.h> against binary128: normal matrices, also of flat blocks; cameras. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>

#define SAMPLES 20000u
#define NORMAL  "nkw_mat3_normal"

/* U diag(1, a, b) V, rounded. */
static void stretched(random_source *r, float *x, double a, double b)
{
    const double s[3] = {1.0, a, b};
    double u[9], v[9];
    double_mat3_from_quat(random_unit_quat(r), u);
    double_mat3_from_quat(random_unit_quat(r), v);
    for (int i = 0; i < 9; i++) {
        double sum = 0.0;
        for (int k = 0; k < 3; k++)
            sum += u[k * 3 + i % 3] * s[k] * v[i / 3 * 3 + k];
        x[i] = (float)sum;
    }
}

static void even(random_source *r, float *x)
{
    double a = (double)random_log(r, 0.1f, 1.0f);
    stretched(r, x, a, (double)random_log(r, 0.1f, 1.0f));
}

static void uneven(random_source *r, float *x)
{
    double a = (double)random_log(r, 1e-5f, 1.0f);
    stretched(r, x, a, (double)random_log(r, 1e-5f, 1.0f));
}

static void flat(random_source *r, float *x)
{
    double a = (double)random_log(r, 0.1f, 1.0f);
    stretched(r, x, a, random_bits(r) % 4 ? (double)random_log(r, 1e-12f, 1e-6f) : 0.0);
}

/* Columns whose lengths differ by whole exponents. */
static void far_columns(random_source *r, float *x)
{
    uneven(r, x);
    for (int c = 0; c < 3; c++) {
        float scale = nkw_abs(random_scaled(r, -30, 30));
        for (int i = 0; i < 3; i++)
            x[3 * c + i] *= scale;
    }
}

/* The cofactors over the determinant; where that is at most 2^-20 of the columns' lengths, over the largest of them. */
static double normal_error(const float *x)
{
    wide m[9], c[9], det, lengths = 1, divisor = 0;
    nkw_mat3 f, got;
    for (int i = 0; i < 9; i++)
        f.m[i] = x[i];
    wide_from(x, m, 9);
    for (int i = 0; i < 3; i++) {
        wide_cross(m + (i + 1) % 3 * 3, m + (i + 2) % 3 * 3, c + 3 * i);
        lengths *= wide_length(m + 3 * i, 3);
    }
    det = wide_dot(m, c, 3);
    for (int i = 0; i < 9; i++)
        divisor = (c[i] < 0 ? -c[i] : c[i]) > divisor ? (c[i] < 0 ? -c[i] : c[i]) : divisor;
    if ((det < 0 ? -det : det) > lengths * 0x1p-20)
        divisor = det;
    wide_scale(c, 1 / divisor, 9);
    got = nkw_mat3_normal(&f);
    return wide_error(got.m, c, 9);
}

/* From, to and up of a camera whose direction is exact: small integers. */
static void camera_place(random_source *r, float *x)
{
    for (int i = 0; i < 9; i++)
        x[i] = (float)(int)(random_bits(r) % 201) - 100.0f;
}

/* The largest error of the block in u of 1, and of the translation in u of |eye|. */
static double look_at_error(const float *x)
{
    wide eye[3], z[3], up[3], row[9], exact[4];
    double worst = 0;
    wide_from(x, eye, 3);
    wide_from(x + 6, up, 3);
    for (int i = 0; i < 3; i++)
        z[i] = (wide)x[i] - (wide)x[3 + i];
    wide_cross(up, z, row);
    double across = (double)wide_length(row, 3);
    if (across < 0.1 * (double)(wide_length(z, 3) * wide_length(up, 3)) || across == 0.0)
        return 0.0;
    for (int i = 0; i < 3; i++)
        row[6 + i] = z[i] / wide_length(z, 3);
    wide_scale(row, 1 / wide_length(row, 3), 3);
    wide_cross(row + 6, row, row + 3);
    nkw_vec3 from = {x[0], x[1], x[2]}, to = {x[3], x[4], x[5]}, above = {x[6], x[7], x[8]};
    nkw_mat4 got = nkw_mat4_look_at(from, to, above);
    wide far_off = wide_length(eye, 3);
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++)
            worst = fmax(worst, accuracy_units((double)got.m[4 * k + i], (double)row[3 * i + k], 1.0));
        exact[i] = -wide_dot(row + 3 * i, eye, 3);
        if (far_off > 0)
            worst = fmax(worst, accuracy_units((double)got.m[12 + i], (double)exact[i], (double)far_off));
    }
    return worst;
}

static void perspective_camera(random_source *r, float *x)
{
    x[0] = random_between(r, 0.01f, 3.1f);
    x[1] = random_log(r, 0.1f, 10.0f);
    x[2] = random_log(r, 1e-4f, 1e3f);
    x[3] = x[2] * (1.0f + random_log(r, 1e-5f, 1e6f));
    x[4] = (float)(random_bits(r) % 3);
    x[5] = (float)(random_bits(r) % 2);
}

static double perspective_error(const float *x)
{
    nkw_perspective camera = {x[0], x[1], x[2], x[3], (nkw_graphics)x[4], x[5] != 0.0f};
    if (!(x[0] > 0.0f && x[0] < 3.1f && x[1] > 0.0f && x[2] > 0.0f && x[3] > x[2] && x[3] < INFINITY))
        return 0.0;
    nkw_mat4 got = nkw_mat4_from_perspective(&camera);
    double n = (double)x[2], f = (double)x[3], low = camera.graphics == NKW_GRAPHICS_GL ? -1.0 : 0.0;
    wide dn = camera.reversed_z ? 1 : low, df = camera.reversed_z ? low : 1, cot = 1 / tan((double)x[0] / 2);
    double worst = accuracy_ulps(got.m[0], (double)(cot / (wide)x[1]));
    worst = fmax(worst, accuracy_ulps(fabsf(got.m[5]), (double)cot));
    worst = fmax(worst, accuracy_ulps(got.m[10], (double)((dn * n - df * f) / ((wide)f - n))));
    return fmax(worst, accuracy_ulps(got.m[14], (double)((dn - df) * n * f / ((wide)f - n))));
}

static void orthographic_camera(random_source *r, float *x)
{
    for (int i = 0; i < 6; i++)
        x[i] = random_scaled(r, -10, 10);
    x[6] = (float)(random_bits(r) % 3);
    x[7] = (float)(random_bits(r) % 2);
}

static double row_error(const nkw_mat4 *m, int row, wide a, wide b, wide p, wide q)
{
    return fmax(accuracy_ulps(m->m[5 * row], (double)((q - p) / (b - a))),
                accuracy_ulps(m->m[12 + row], (double)((b * p - a * q) / (b - a))));
}

static double orthographic_error(const float *x)
{
    nkw_orthographic camera = {x[0], x[1], x[2], x[3], x[4], x[5], (nkw_graphics)x[6], x[7] != 0.0f};
    for (int i = 0; i < 6; i++)
        if (!(fabsf(x[i]) < 1e30f) || x[i] == x[i ^ 1])
            return 0.0;
    nkw_mat4 got = nkw_mat4_from_orthographic(&camera);
    wide low = camera.graphics == NKW_GRAPHICS_GL ? -1 : 0, y = camera.graphics == NKW_GRAPHICS_VULKAN ? -1 : 1;
    wide dn = camera.reversed_z ? 1 : low, df = camera.reversed_z ? low : 1;
    return fmax(fmax(row_error(&got, 0, x[0], x[1], -1, 1), row_error(&got, 1, x[2], x[3], -y, y)),
                row_error(&got, 2, -(wide)x[4], -(wide)x[5], dn, df));
}

static const wide_case cases[] = {
    {"nkw_mat4_look_at", "up at 6 degrees or more", camera_place, look_at_error, 9, WIDE_CHECKED},
    {"nkw_mat4_from_perspective", "all interfaces", perspective_camera, perspective_error, 6, WIDE_CHECKED},
    {"nkw_mat4_from_orthographic", "all interfaces", orthographic_camera, orthographic_error, 8, WIDE_CHECKED},
    {NORMAL, "scales to 10 : 1", even, normal_error, 9, WIDE_CHECKED},
    {NORMAL, "scales to 1e5 : 1", uneven, normal_error, 9, WIDE_CHECKED},
    {NORMAL, "flat", flat, normal_error, 9, WIDE_CHECKED},
    {NORMAL, "columns of any lengths", far_columns, normal_error, 9, WIDE_CHECKED},
};

void mat_more(accuracy *a)
{
    wide_search(a, cases, sizeof cases / sizeof cases[0], SAMPLES);
}

#else
/* ISO C forbids an empty file. */
typedef int mat_more_is_skipped;
#endif
