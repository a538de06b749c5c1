/* SPDX-License-Identifier: MIT */
/* Formulas as a textbook has them: of float what a user writes with the C library, of double the reference. */
#ifndef NAKAWARI_BENCH_TEXTBOOK_H
#define NAKAWARI_BENCH_TEXTBOOK_H

#include <cmath>

#include <nakawari/types.h>

namespace textbook
{

template <class T> struct vec {
    T x, y, z;
    vec(T a, T b, T c) : x(a), y(b), z(c)
    {
    }
    explicit vec(nkw_vec3 v) : vec(static_cast<T>(v.x), static_cast<T>(v.y), static_cast<T>(v.z))
    {
    }
};

template <class T> vec<T> operator+(vec<T> a, vec<T> b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <class T> vec<T> operator-(vec<T> a, vec<T> b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <class T> vec<T> operator*(T s, vec<T> v)
{
    return {s * v.x, s * v.y, s * v.z};
}

template <class T> T dot(vec<T> a, vec<T> b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class T> vec<T> cross(vec<T> a, vec<T> b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class T> T length(vec<T> v)
{
    return std::sqrt(dot(v, v));
}

template <class T> struct quat {
    T x, y, z, w;
    quat(T a, T b, T c, T d) : x(a), y(b), z(c), w(d)
    {
    }
    explicit quat(nkw_quat q) : quat(static_cast<T>(q.x), static_cast<T>(q.y), static_cast<T>(q.z), static_cast<T>(q.w))
    {
    }
};

template <class T> quat<T> operator*(quat<T> a, quat<T> b)
{
    return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}

template <class T> quat<T> operator*(T s, quat<T> q)
{
    return {s * q.x, s * q.y, s * q.z, s * q.w};
}

template <class T> quat<T> conjugate(quat<T> q)
{
    return {-q.x, -q.y, -q.z, q.w};
}

template <class T> quat<T> unit(quat<T> q)
{
    return (1 / std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w)) * q;
}

/* q v q^-1 */
template <class T> vec<T> rotate(quat<T> q, vec<T> v)
{
    vec<T> axis = {q.x, q.y, q.z}, twice = static_cast<T>(2) * cross(axis, v);
    return v + q.w * twice + cross(axis, twice);
}

/* Of half a rotation vector. */
template <class T> quat<T> exp(vec<T> v)
{
    T angle = length(v), k = angle > 0 ? std::sin(angle) / angle : 1;
    return {k * v.x, k * v.y, k * v.z, std::cos(angle)};
}

/* Half the rotation vector along the shorter arc. */
template <class T> vec<T> log(quat<T> q)
{
    vec<T> v = {q.x, q.y, q.z};
    T s = length(v), sign = q.w < 0 ? -1 : 1;
    return (s > 0 ? sign * std::atan2(s, sign * q.w) / s : sign) * v;
}

/* In float closed forms cancel for small angles: a series is taken. */
template <class T> bool is_small(T a)
{
    return sizeof(T) == sizeof(float) && a < static_cast<T>(0.5);
}

/* r' of the rotation vector r from the angular velocity w in the outer frame, and back. */
template <class T> vec<T> rate_of(vec<T> r, vec<T> w)
{
    T a = length(r), a2 = a * a, k = (1 + a2 / 60 * (1 + a2 / 42)) / 12;
    if (!is_small(a))
        k = (1 - a / 2 / std::tan(a / 2)) / a2;
    return w - static_cast<T>(0.5) * cross(r, w) + k * cross(r, cross(r, w));
}

template <class T> vec<T> velocity_of(vec<T> r, vec<T> w)
{
    T a = length(r), a2 = a * a, s = std::sin(a / 2), k = (1 - a2 / 20 * (1 - a2 / 42)) / 6;
    if (!is_small(a))
        k = (a - std::sin(a)) / (a * a2);
    return w + 2 * s * s / a2 * cross(r, w) + k * cross(r, cross(r, w));
}

/* A lerp for near quaternions: no reference. */
inline quat<float> slerp(quat<float> a, quat<float> b, float s)
{
    float c = a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w, sign = c < 0 ? -1.0f : 1.0f, u = 1 - s, v = s;
    c *= sign;
    if (c < 0.9995f) {
        float angle = std::acos(c), inverse = 1 / std::sin(angle);
        u = std::sin(u * angle) * inverse;
        v = std::sin(v * angle) * inverse;
    }
    v *= sign;
    return {u * a.x + v * b.x, u * a.y + v * b.y, u * a.z + v * b.z, u * a.w + v * b.w};
}

/* A float's struct as the library's, or numbers to a reference. */
inline nkw_vec3 to(vec<float> v)
{
    return {v.x, v.y, v.z};
}

inline nkw_quat to(quat<float> q)
{
    return {q.x, q.y, q.z, q.w};
}

inline void put(vec<double> v, double *out)
{
    out[0] = v.x, out[1] = v.y, out[2] = v.z;
}

inline void put(quat<double> q, double *out)
{
    out[0] = q.x, out[1] = q.y, out[2] = q.z, out[3] = q.w;
}

} // namespace textbook

#endif
