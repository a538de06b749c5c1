/* SPDX-License-Identifier: MIT */
/* References in binary64, as the textbook has them. */
#ifndef NAKAWARI_BENCH_TRUTH_H
#define NAKAWARI_BENCH_TRUTH_H

#include <cmath>

#include <nakawari/types.h>

namespace truth
{

struct quat {
    double x, y, z, w;
    quat(double a, double b, double c, double d) : x(a), y(b), z(c), w(d)
    {
    }
    explicit quat(nkw_quat q)
        : quat(static_cast<double>(q.x), static_cast<double>(q.y), static_cast<double>(q.z), static_cast<double>(q.w))
    {
    }
    void put(double *out) const
    {
        out[0] = x, out[1] = y, out[2] = z, out[3] = w;
    }
};

inline double dot(quat a, quat b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
}

/* s a + u b */
inline quat sum(quat a, double s, quat b, double u)
{
    return {s * a.x + u * b.x, s * a.y + u * b.y, s * a.z + u * b.z, s * a.w + u * b.w};
}

inline quat unit(quat q)
{
    return sum(q, 1 / std::sqrt(dot(q, q)), q, 0);
}

inline quat mul(quat a, quat b)
{
    return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}

inline quat nlerp(quat a, quat b, double t)
{
    return unit(sum(a, 1 - t, b, dot(a, b) < 0 ? -t : t));
}

inline quat slerp(quat a, quat b, double t)
{
    double sign = dot(a, b) < 0 ? -1 : 1;
    quat d = sum(b, sign, a, -1), s = sum(b, sign, a, 1);
    double angle = 2 * std::atan2(std::sqrt(dot(d, d)), std::sqrt(dot(s, s)));
    if (angle < 1e-9)
        return sum(a, 1 - t, b, sign * t);
    return sum(a, std::sin((1 - t) * angle) / std::sin(angle), b, sign * std::sin(t * angle) / std::sin(angle));
}

/* Column by column, `rows` apart, times the lengths s of the columns. */
inline void rotation(quat q, const double s[3], double *m, int rows)
{
    const double r[9] = {
        1 - 2 * (q.y * q.y + q.z * q.z), 2 * (q.x * q.y + q.w * q.z),     2 * (q.x * q.z - q.w * q.y),
        2 * (q.x * q.y - q.w * q.z),     1 - 2 * (q.x * q.x + q.z * q.z), 2 * (q.y * q.z + q.w * q.x),
        2 * (q.x * q.z + q.w * q.y),     2 * (q.y * q.z - q.w * q.x),     1 - 2 * (q.x * q.x + q.y * q.y)};
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < 3; k++)
            m[c * rows + k] = s[c] * r[c * 3 + k];
}

/* a b of matrices with n rows and columns, column by column. */
template <class T> void product(const T *a, const T *b, int n, double *out)
{
    for (int c = 0; c < n; c++)
        for (int r = 0; r < n; r++) {
            out[c * n + r] = 0;
            for (int k = 0; k < n; k++)
                out[c * n + r] += static_cast<double>(a[k * n + r]) * static_cast<double>(b[c * n + k]);
        }
}

} // namespace truth

#endif
