/* SPDX-License-Identifier: MIT */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <quadmath.h>
#include <string.h>

/* ---- Between the types ---- */

nkw_vec3 vec3_at(const float *x)
{
    nkw_vec3 v = {x[0], x[1], x[2]};
    return v;
}

nkw_quat quat_at(const float *x)
{
    nkw_quat q = {x[0], x[1], x[2], x[3]};
    return q;
}

void put_vec3(float *x, nkw_vec3 v)
{
    memcpy(x, &v, sizeof v);
}

void put_quat(float *x, nkw_quat q)
{
    memcpy(x, &q, sizeof q);
}

void wide_from(const float *x, wide *out, int n)
{
    for (int i = 0; i < n; i++)
        out[i] = x[i];
}

void wide_round(const wide *x, float *out, int n)
{
    for (int i = 0; i < n; i++)
        out[i] = (float)x[i];
}

/* ---- Samples: by the library's own exp and log, which are the same everywhere ---- */

float random_log(random_source *r, float low, float high)
{
    float x = nkw_exp(random_between(r, nkw_log(low), nkw_log(high)));
    /* Logarithms are too coarse for every float to come. */
    return r->fine ? nkw_clamp(x * (1.0f + (float)(random_bits(r) >> 60) * 0x1p-23f), low, high) : x;
}

float random_sign(random_source *r)
{
    return random_bits(r) >> 63 ? -1.0f : 1.0f;
}

static nkw_quat rounded_unit(const double q[4])
{
    double s = 1.0 / sqrt((q[0] * q[0] + q[1] * q[1]) + (q[2] * q[2] + q[3] * q[3]));
    nkw_quat r = {(float)(s * q[0]), (float)(s * q[1]), (float)(s * q[2]), (float)(s * q[3])};
    return r;
}

static void double_quat_mul(const double a[4], const double b[4], double out[4])
{
    out[0] = (a[3] * b[0] + a[0] * b[3]) + (a[1] * b[2] - a[2] * b[1]);
    out[1] = (a[3] * b[1] + a[1] * b[3]) + (a[2] * b[0] - a[0] * b[2]);
    out[2] = (a[3] * b[2] + a[2] * b[3]) + (a[0] * b[1] - a[1] * b[0]);
    out[3] = (a[3] * b[3] - a[0] * b[0]) - (a[1] * b[1] + a[2] * b[2]);
}

nkw_quat random_unit_quat(random_source *r)
{
    nkw_quat q = random_rotation(r);
    double d[4] = {q.x, q.y, q.z, q.w};
    return rounded_unit(d);
}

nkw_quat random_unit_near(random_source *r, nkw_quat q, float angle)
{
    nkw_vec3 axis = random_direction(r);
    double s = (double)nkw_sin(angle), c = (double)nkw_cos(angle);
    double a[4] = {q.x, q.y, q.z, q.w}, b[4];
    double turn[4] = {s * (double)axis.x, s * (double)axis.y, s * (double)axis.z, c};
    double_quat_mul(a, turn, b);
    return rounded_unit(b);
}

void double_mat3_from_quat(nkw_quat q, double m[9])
{
    double x = q.x, y = q.y, z = q.z, w = q.w, s = 2.0 / ((x * x + y * y) + (z * z + w * w));
    double r[9] = {
        1.0 - s * (y * y + z * z), s * (x * y + w * z),       s * (x * z - w * y),
        s * (x * y - w * z),       1.0 - s * (x * x + z * z), s * (y * z + w * x),
        s * (x * z + w * y),       s * (y * z - w * x),       1.0 - s * (x * x + y * y),
    };
    memcpy(m, r, sizeof r);
}

/* ---- Norms and errors ---- */

wide wide_dot(const wide *a, const wide *b, int n)
{
    wide sum = 0;
    for (int i = 0; i < n; i++)
        sum += a[i] * b[i];
    return sum;
}

wide wide_length(const wide *a, int n)
{
    return sqrtq(wide_dot(a, a, n));
}

void wide_scale(wide *a, wide s, int n)
{
    for (int i = 0; i < n; i++)
        a[i] *= s;
}

void wide_normalize(wide *a, int n)
{
    wide length = wide_length(a, n);
    if (length > 0)
        wide_scale(a, 1 / length, n);
}

/* |got - sign exact|^2 / magnitude^2, in u. The difference is exact enough in binary128, its norm in binary64. */
static double error_between(const float *got, const wide *exact, int n, int sign, double magnitude)
{
    double sum = 0.0;
    for (int i = 0; i < n; i++) {
        double d = (double)(got[i] - sign * exact[i]);
        double part = d == 0.0 ? 0.0 : d / magnitude;
        sum += part * part;
    }
    return sum == 0.0 ? 0.0 : sum - sum == 0.0 ? sqrt(sum) * 0x1p24 : HUGE_VAL;
}

static double size_of(const wide *exact, int n)
{
    double sum = 0.0;
    for (int i = 0; i < n; i++)
        sum += (double)exact[i] * (double)exact[i];
    return sqrt(sum);
}

double wide_error(const float *got, const wide *exact, int n)
{
    return error_between(got, exact, n, 1, size_of(exact, n));
}

double wide_error_either(const float *got, const wide *exact, int n)
{
    double size = size_of(exact, n);
    return fmin(error_between(got, exact, n, 1, size), error_between(got, exact, n, -1, size));
}

double wide_error_of(const float *got, const wide *exact, int n, wide magnitude)
{
    return error_between(got, exact, n, 1, (double)magnitude);
}

double wide_unit_error(const float *q, int n)
{
    wide x[4];
    wide_from(q, x, n);
    return fabs((double)(wide_length(x, n) - 1)) * 0x1p24;
}

/* |vector part of conjugate(a) b| = sin(angle / 2). */
double wide_turn(const wide a[4], const wide b[4])
{
    wide c[4] = {-a[0], -a[1], -a[2], a[3]}, d[4];
    wide_quat_mul(c, b, d);
    double sine = sqrt((double)wide_dot(d, d, 3)) / (size_of(a, 4) * size_of(b, 4));
    return sine == sine ? 2.0 * sine * 0x1p24 : HUGE_VAL;
}

/* ---- Algebra ---- */

wide wide_pi(void)
{
    return acosq(-1);
}

void wide_cross(const wide a[3], const wide b[3], wide out[3])
{
    wide r[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    memcpy(out, r, sizeof r);
}

void wide_quat_mul(const wide a[4], const wide b[4], wide out[4])
{
    wide r[4] = {
        a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1],
        a[3] * b[1] + a[1] * b[3] + a[2] * b[0] - a[0] * b[2],
        a[3] * b[2] + a[2] * b[3] + a[0] * b[1] - a[1] * b[0],
        a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2],
    };
    memcpy(out, r, sizeof r);
}

void wide_mat3_from_quat(const wide q[4], wide m[9])
{
    wide s = 2 / wide_dot(q, q, 4);
    wide x = s * q[0], y = s * q[1], z = s * q[2];
    wide xx = x * q[0], yy = y * q[1], zz = z * q[2], xy = x * q[1], xz = x * q[2], yz = y * q[2];
    wide wx = x * q[3], wy = y * q[3], wz = z * q[3];
    wide r[9] = {1 - yy - zz, xy + wz, xz - wy, xy - wz, 1 - xx - zz, yz + wx, xz + wy, yz - wx, 1 - xx - yy};
    memcpy(m, r, sizeof r);
}

/* q^T K q = 1 + trace(R(q)^T M). */
static void form_of(const wide m[9], wide k[16])
{
    wide xy = m[1] + m[3], xz = m[2] + m[6], yz = m[5] + m[7];
    wide xw = m[5] - m[7], yw = m[6] - m[2], zw = m[1] - m[3];
    wide r[16] = {
        1 + m[0] - m[4] - m[8], xy, xz, xw, xy, 1 - m[0] + m[4] - m[8], yz, yw, xz, yz,
        1 - m[0] - m[4] + m[8], zw, xw, yw, zw, 1 + m[0] + m[4] + m[8],
    };
    memcpy(k, r, sizeof r);
}

/* k times itself twelve times over, in binary64: what is left is the dominant eigenvector, to binary64. */
static void square_often(double k[16])
{
    for (int step = 0; step < 12; step++) {
        double s[16], trace = k[0] + k[5] + k[10] + k[15];
        for (int i = 0; i < 16; i++)
            k[i] /= trace;
        for (int i = 0; i < 16; i++) {
            const double *a = k + i / 4 * 4, *b = k + i % 4 * 4;
            s[i] = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
        }
        memcpy(k, s, sizeof s);
    }
}

/* The eigenvector in binary64, then multiplications by K in binary128, each good for some digits. */
void wide_quat_from_mat3(const wide m[9], wide q[4])
{
    wide k[16], next[4];
    double square[16];
    int best = 0;
    form_of(m, k);
    for (int i = 0; i < 16; i++)
        square[i] = (double)k[i];
    square_often(square);
    for (int i = 1; i < 4; i++)
        best = square[i * 5] > square[best * 5] ? i : best;
    for (int i = 0; i < 4; i++)
        q[i] = square[best * 4 + i];
    for (int step = 0; step < 3; step++) {
        for (int i = 0; i < 4; i++)
            next[i] = wide_dot(k + i * 4, q, 4);
        memcpy(q, next, sizeof next);
    }
    wide_normalize(q, 4);
}

/* Sine and cosine to 2^-64, which is 2^-40 u, in a tenth of the time of sincosq. */
void wide_quat_from_axis(const wide axis[3], wide angle, wide q[4])
{
    long double half = (long double)(angle / 2), s = sinl(half);
    for (int i = 0; i < 3; i++)
        q[i] = axis[i] * s;
    q[3] = cosl(half);
}

void wide_quat_log(const wide q[4], wide v[3])
{
    wide n = wide_length(q, 3);
    memcpy(v, q, 3 * sizeof *v);
    wide_scale(v, n > 0 ? atan2q(n, q[3]) / n : 0, 3);
}

void wide_rotation_rate(const wide v[3], const wide w[3], wide out[3])
{
    wide h = wide_length(v, 3), c = h == 0 ? 1 / (wide)12 : (1 - h / tanq(h)) / (4 * h * h), a[3], b[3], r[3];
    for (int i = 0; i < 3; i++)
        r[i] = 2 * v[i];
    wide_cross(r, w, a);
    wide_cross(r, a, b);
    for (int i = 0; i < 3; i++)
        out[i] = w[i] - a[i] / 2 + c * b[i];
}

void wide_quat_exp(const wide v[3], wide q[4])
{
    wide axis[3] = {v[0], v[1], v[2]};
    wide_normalize(axis, 3);
    wide_quat_from_axis(axis, 2 * wide_length(v, 3), q);
}

void wide_quat_from_euler(const wide angles[3], nkw_euler_order order, wide q[4])
{
    static const int axes[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    wide identity[4] = {0, 0, 0, 1};
    memcpy(q, identity, sizeof identity);
    for (int i = 0; i < 3; i++) {
        int axis = axes[order][i];
        wide unit[3] = {axis == 0, axis == 1, axis == 2}, turn[4];
        wide_quat_from_axis(unit, angles[axis], turn);
        wide_quat_mul(q, turn, q);
    }
}

/* sin((1-t)h)/sin h = cos(t h) - cos h sin(t h)/sin h. */
void wide_slerp(const wide a[4], const wide b[4], wide t, wide out[4])
{
    wide ab = wide_dot(a, b, 4), aabb = wide_dot(a, a, 4) * wide_dot(b, b, 4);
    wide cosine = ab / sqrtq(aabb), rest = 1 - cosine * cosine;
    wide sine = rest > 0 ? sqrtq(rest) : 0, s, c;
    sincosq(t * atan2q(sine, cosine), &s, &c);
    wide to = sine > 0 ? s / sine : t;
    wide from = sine > 0 ? c - cosine * to : 1 - t;
    for (int i = 0; i < 4; i++)
        out[i] = from * a[i] + to * b[i];
}

void wide_mat_mul(const wide *a, const wide *b, wide *out, int n)
{
    wide r[16];
    for (int i = 0; i < n * n; i++) {
        r[i] = 0;
        for (int j = 0; j < n; j++)
            r[i] += a[j * n + i % n] * b[i / n * n + j];
    }
    memcpy(out, r, (size_t)(n * n) * sizeof *r);
}

void wide_mat4_from_trs(const nkw_trs *trs, wide out[16])
{
    float q[4], v[3], s[3];
    wide w[4], block[9];
    put_quat(q, trs->rotation);
    put_vec3(v, trs->translation);
    put_vec3(s, trs->scale);
    wide_from(q, w, 4);
    wide_mat3_from_quat(w, block);
    for (int i = 0; i < 16; i++) {
        int c = i / 4, r = i % 4;
        out[i] = r == 3 ? (wide)(c == 3) : c == 3 ? (wide)v[r] : s[c] * block[3 * c + r];
    }
}

void wide_block(const wide m[16], wide out[9])
{
    for (int i = 0; i < 9; i++)
        out[i] = m[i / 3 * 4 + i % 3];
}

/* Lines of m beside those of the identity become the identity beside the inverse. Gives the determinant. */
static wide eliminate(wide a[4][8], int n, int width)
{
    wide determinant = 1;
    for (int k = 0; k < n; k++) {
        int best = k;
        for (int i = k + 1; i < n; i++)
            best = fabsq(a[i][k]) > fabsq(a[best][k]) ? i : best;
        for (int j = 0; j < width && best != k; j++) {
            wide t = a[k][j];
            a[k][j] = a[best][j];
            a[best][j] = t;
        }
        determinant *= best == k ? a[k][k] : -a[k][k];
        if (a[k][k] == 0)
            return 0;
        wide r = 1 / a[k][k];
        for (int j = k; j < width; j++)
            a[k][j] *= r;
        for (int i = 0; i < n; i++) {
            wide f = a[i][k];
            for (int j = k; j < width && i != k && f != 0; j++)
                a[i][j] -= a[k][j] != 0 ? f * a[k][j] : 0;
        }
    }
    return determinant;
}

wide wide_determinant(const wide *m, int n)
{
    wide a[4][8];
    for (int i = 0; i < n * n; i++)
        a[i / n][i % n] = m[i];
    return eliminate(a, n, n);
}

int wide_inverse(const wide *m, wide *out, int n)
{
    wide a[4][8];
    for (int i = 0; i < n * n; i++) {
        a[i / n][i % n] = m[i];
        a[i / n][n + i % n] = i / n == i % n;
    }
    if (eliminate(a, n, 2 * n) == 0)
        return 0;
    for (int i = 0; i < n * n; i++)
        out[i] = a[i / n][n + i % n];
    return 1;
}

#else

/* Not an empty file. */
extern const int wide_unavailable;
const int wide_unavailable = 1;

#endif
