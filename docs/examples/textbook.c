/* SPDX-License-Identifier: MIT */
#include "textbook.h"

#include <math.h>

#define PI 3.14159265358979323846

/* ---- positions ---- */

void tb_hermite_weights(double t, double weight[4])
{
    weight[0] = 2 * t * t * t - 3 * t * t + 1; /* (3) H0, of p0 */
    weight[1] = -2 * t * t * t + 3 * t * t; /* (4) H1, of p1 */
    weight[2] = t * t * t - 2 * t * t + t; /* (5) h0, of v0 */
    weight[3] = t * t * t - t * t; /* (6) h1, of v1 */
}

void tb_bezier_weights(double s, double weight[4])
{
    weight[0] = (1 - s) * (1 - s) * (1 - s); /* (8); the text has (t - 1) */
    weight[1] = 3 * (1 - s) * (1 - s) * s; /* (9) */
    weight[2] = 3 * (1 - s) * s * s; /* (10) */
    weight[3] = s * s * s; /* (11) */
}

void tb_bspline_weights(double t, double weight[4])
{
    weight[0] = -1.0 / 6 * t * t * t + 1.0 / 2 * t * t - 1.0 / 2 * t + 1.0 / 6; /* (13) */
    weight[1] = 1.0 / 2 * t * t * t - t * t + 2.0 / 3; /* (14) */
    weight[2] = -1.0 / 2 * t * t * t + 1.0 / 2 * t * t + 1.0 / 2 * t + 1.0 / 6; /* (15) */
    weight[3] = 1.0 / 6 * t * t * t; /* (16) */
}

tb_vec3 tb_linear(tb_vec3 p0, tb_vec3 p1, double t)
{
    tb_vec3 p = {(1 - t) * p0.x + t * p1.x, (1 - t) * p0.y + t * p1.y, (1 - t) * p0.z + t * p1.z};
    return p;
}

tb_vec3 tb_sum(const double weight[4], tb_vec3 p0, tb_vec3 p1, tb_vec3 p2, tb_vec3 p3)
{
    tb_vec3 p = {
        weight[0] * p0.x + weight[1] * p1.x + weight[2] * p2.x + weight[3] * p3.x,
        weight[0] * p0.y + weight[1] * p1.y + weight[2] * p2.y + weight[3] * p3.y,
        weight[0] * p0.z + weight[1] * p1.z + weight[2] * p2.z + weight[3] * p3.z,
    };
    return p;
}

/* ---- quaternions ---- */

tb_quat tb_slerp(tb_quat q0, tb_quat q1, double t)
{
    double cosine = q0.x * q1.x + q0.y * q1.y + q0.z * q1.z + q0.w * q1.w;
    double sign = cosine < 0 ? -1 : 1; /* blank B: -q1 is the same rotation, on the shorter arc */
    double theta = acos(fmin(sign * cosine, 1)); /* (18) */
    double k0 = 1 - t, k1 = t; /* the limit of (17) for theta -> 0, where it is 0 / 0 */
    if (theta > 1e-9) {
        k0 = sin((1 - t) * theta) / sin(theta); /* (17) */
        k1 = sin(t * theta) / sin(theta);
    }
    k1 *= sign;
    tb_quat q = {k0 * q0.x + k1 * q1.x, k0 * q0.y + k1 * q1.y, k0 * q0.z + k1 * q1.z, k0 * q0.w + k1 * q1.w};
    return q;
}

/*
 * With R of tb_mat3_from_quat: the trace is 4 w^2 - 1, R[i][i] - R[j][j] - R[k][k] = 4 q_i^2 - 1, and the sums and
 * differences of opposite elements are 4 times a product of two components. The largest component is divided by.
 */
tb_quat tb_quat_from_mat3(const tb_mat3 *r)
{
    const double(*m)[3] = (const double(*)[3])r->m;
    tb_quat q;
    if (m[0][0] + m[1][1] + m[2][2] > 0) {
        q.w = sqrt(1 + m[0][0] + m[1][1] + m[2][2]) / 2;
        q.x = (m[2][1] - m[1][2]) / (4 * q.w);
        q.y = (m[0][2] - m[2][0]) / (4 * q.w);
        q.z = (m[1][0] - m[0][1]) / (4 * q.w);
    } else if (m[0][0] > m[1][1] && m[0][0] > m[2][2]) {
        q.x = sqrt(1 + m[0][0] - m[1][1] - m[2][2]) / 2;
        q.y = (m[1][0] + m[0][1]) / (4 * q.x);
        q.z = (m[0][2] + m[2][0]) / (4 * q.x);
        q.w = (m[2][1] - m[1][2]) / (4 * q.x);
    } else if (m[1][1] > m[2][2]) {
        q.y = sqrt(1 - m[0][0] + m[1][1] - m[2][2]) / 2;
        q.x = (m[1][0] + m[0][1]) / (4 * q.y);
        q.z = (m[2][1] + m[1][2]) / (4 * q.y);
        q.w = (m[0][2] - m[2][0]) / (4 * q.y);
    } else {
        q.z = sqrt(1 - m[0][0] - m[1][1] + m[2][2]) / 2;
        q.x = (m[0][2] + m[2][0]) / (4 * q.z);
        q.y = (m[2][1] + m[1][2]) / (4 * q.z);
        q.w = (m[1][0] - m[0][1]) / (4 * q.z);
    }
    return q;
}

tb_mat3 tb_mat3_from_quat(tb_quat q)
{
    tb_mat3 r = {{
        {1 - 2 * (q.y * q.y + q.z * q.z), 2 * (q.x * q.y - q.w * q.z), 2 * (q.x * q.z + q.w * q.y)},
        {2 * (q.x * q.y + q.w * q.z), 1 - 2 * (q.x * q.x + q.z * q.z), 2 * (q.y * q.z - q.w * q.x)},
        {2 * (q.x * q.z - q.w * q.y), 2 * (q.y * q.z + q.w * q.x), 1 - 2 * (q.x * q.x + q.y * q.y)},
    }};
    return r;
}

/* ---- Euler angles ---- */

tb_angles tb_angles_from_mat3(const tb_mat3 *r)
{
    tb_vec3 y = {r->m[0][1], r->m[1][1], r->m[2][1]}, z = {r->m[0][2], r->m[1][2], r->m[2][2]};
    tb_angles a;
    a.yaw = atan2(z.x, z.z);
    a.pitch = atan2(-z.y, sqrt(z.x * z.x + z.z * z.z));
    a.roll = atan2(cos(a.pitch) * (sin(a.yaw) * y.z - cos(a.yaw) * y.x), y.y);
    return a;
}

tb_mat3 tb_mat3_from_angles(tb_angles a)
{
    tb_mat3 yaw = {{{cos(a.yaw), 0, sin(a.yaw)}, {0, 1, 0}, {-sin(a.yaw), 0, cos(a.yaw)}}};
    tb_mat3 pitch = {{{1, 0, 0}, {0, cos(a.pitch), -sin(a.pitch)}, {0, sin(a.pitch), cos(a.pitch)}}};
    tb_mat3 roll = {{{cos(a.roll), -sin(a.roll), 0}, {sin(a.roll), cos(a.roll), 0}, {0, 0, 1}}};
    tb_mat3 yaw_pitch = tb_mat3_mul(&yaw, &pitch);
    return tb_mat3_mul(&yaw_pitch, &roll);
}

tb_angles tb_angles_lerp(tb_angles a0, tb_angles a1, double t)
{
    if (a0.yaw < a1.yaw - PI)
        a0.yaw += 2 * PI;
    else if (a0.yaw > a1.yaw + PI)
        a0.yaw -= 2 * PI;
    tb_angles a = {(a1.yaw - a0.yaw) * t + a0.yaw, (a1.pitch - a0.pitch) * t + a0.pitch,
                   (a1.roll - a0.roll) * t + a0.roll};
    return a;
}

/* ---- matrices and joints ---- */

tb_mat3 tb_mat3_mul(const tb_mat3 *a, const tb_mat3 *b)
{
    tb_mat3 c;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            c.m[i][j] = a->m[i][0] * b->m[0][j] + a->m[i][1] * b->m[1][j] + a->m[i][2] * b->m[2][j];
    return c;
}

tb_mat4 tb_mat4_mul(const tb_mat4 *a, const tb_mat4 *b)
{
    tb_mat4 c;
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            c.m[i][j] =
                a->m[i][0] * b->m[0][j] + a->m[i][1] * b->m[1][j] + a->m[i][2] * b->m[2][j] + a->m[i][3] * b->m[3][j];
    return c;
}

tb_mat3 tb_normal_matrix(const tb_mat3 *r)
{
    tb_mat3 cofactor;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            cofactor.m[i][j] = r->m[i1][j1] * r->m[i2][j2] - r->m[i1][j2] * r->m[i2][j1];
        }
    double determinant = r->m[0][0] * cofactor.m[0][0] + r->m[0][1] * cofactor.m[0][1] + r->m[0][2] * cofactor.m[0][2];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            cofactor.m[i][j] /= determinant;
    return cofactor;
}

static tb_mat4 translation(double x, double y, double z)
{
    tb_mat4 m = {{{1, 0, 0, x}, {0, 1, 0, y}, {0, 0, 1, z}, {0, 0, 0, 1}}};
    return m;
}

void tb_joint_chain(const tb_vec3 *bind, const tb_mat4 *j, size_t count, tb_mat4 *m)
{
    for (size_t i = 0; i < count; i++) {
        tb_mat4 t = translation(bind[i].x, bind[i].y, bind[i].z);
        tb_mat4 t_inverse = translation(-bind[i].x, -bind[i].y, -bind[i].z);
        tb_mat4 tj = tb_mat4_mul(&t, &j[i]);
        m[i] = tb_mat4_mul(&tj, &t_inverse);
        if (i > 0)
            m[i] = tb_mat4_mul(&m[i - 1], &m[i]);
    }
}
