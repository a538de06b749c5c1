/* SPDX-License-Identifier: MIT */
/* The parameter of a Bezier segment at a time: a user's Newton in float, and bisection as the reference. */
#ifndef NAKAWARI_BENCH_NEWTON_H
#define NAKAWARI_BENCH_NEWTON_H

#include <cmath>

namespace newton
{

/* Control numbers. */
struct cubic {
    float p[4];
};

template <class T> T at(const cubic &c, T s)
{
    T a = static_cast<T>(c.p[0]), b = static_cast<T>(c.p[1]), d = static_cast<T>(c.p[2]), e = static_cast<T>(c.p[3]);
    T r = 1 - s;
    return r * r * r * a + 3 * r * r * s * b + 3 * r * s * s * d + s * s * s * e;
}

inline float rate(const cubic &c, float s)
{
    float r = 1 - s;
    return 3 * (r * r * (c.p[1] - c.p[0]) + 2 * r * s * (c.p[2] - c.p[1]) + s * s * (c.p[3] - c.p[2]));
}

/* At most eight steps from s; no bracket. */
inline float solved(const cubic &c, float time, float s)
{
    for (int i = 0; i < 8; i++) {
        float off = at(c, s) - time;
        if (std::fabs(off) < 1e-7f)
            break;
        s -= off / rate(c, s);
    }
    return s;
}

/* Of a segment whose time does not run back. */
inline double bisected(const cubic &c, double time)
{
    double low = 0, high = 1;
    for (int i = 0; i < 60; i++) {
        double s = (low + high) / 2;
        (at(c, s) < time ? low : high) = s;
    }
    return (low + high) / 2;
}

} // namespace newton

#endif
