/* SPDX-License-Identifier: MIT */
/* Steps of springs in closed form, 1/60 s. The loop is Holden's exact spring, with the C library. */
#include <cmath>

#include "bench.h"
#include "textbook.h"

using namespace bench;
using textbook::quat;
using textbook::vec;

static const float step = 1.0f / 60;
static array<nkw_state> moving, goal;
static array<nkw_vec3_state> moving3, goal3;
static array<nkw_quat_state> turning, turning_to;

/* The deviation y and its rate v after h: m = {m11, m12, m21, m22}. */
template <class T> static void matrix_of(nkw_spring s, T h, T *m)
{
    T k = static_cast<T>(s.stiffness), y = static_cast<T>(s.damping) / 2, w2 = k - y * y, e = std::exp(-y * h);
    T w = std::sqrt(std::fabs(w2)), c = 1, d = h;
    if (w2 > static_cast<T>(1e-5) * k)
        c = std::cos(w * h), d = std::sin(w * h) / w;
    else if (w2 < static_cast<T>(-1e-5) * k)
        c = std::cosh(w * h), d = std::sinh(w * h) / w;
    m[0] = e * (c + y * d), m[1] = e * d, m[2] = -e * k * d, m[3] = e * (c - y * d);
}

template <class T> static void textbook_step(nkw_spring s, const float *from, const float *to, size_t n, T *out)
{
    T h = static_cast<T>(step), m[4];
    matrix_of(s, h, m);
    for (size_t k = 0; k < n; k++) {
        T g = static_cast<T>(to[k]), rate = static_cast<T>(to[n + k]);
        T y = static_cast<T>(from[k]) - g, v = static_cast<T>(from[n + k]) - rate;
        out[k] = g + rate * h + (m[0] * y + m[1] * v);
        out[n + k] = rate + (m[2] * y + m[3] * v);
    }
}

template <class T>
static quat<T> textbook_turn(nkw_spring s, const nkw_quat_state &from, const nkw_quat_state &to, vec<T> *velocity)
{
    T h = static_cast<T>(step), m[4];
    matrix_of(s, h, m);
    quat<T> g(to.value), e = unit(quat<T>(from.value) * conjugate(g));
    vec<T> r = static_cast<T>(2) * textbook::log(e), rate(to.velocity);
    vec<T> v = textbook::rate_of(r, vec<T>(from.velocity) - rotate(e, rate));
    vec<T> at = m[0] * r + m[1] * v, then = m[2] * r + m[3] * v;
    e = textbook::exp(static_cast<T>(0.5) * at);
    *velocity = textbook::velocity_of(at, then) + rotate(e, rate);
    return unit(e * textbook::exp(h / 2 * rate) * g);
}

/* M: value and velocity of n floats each. */
template <class M, class F>
static void rows(const char *name, nkw_spring s, const array<M> &from, const array<M> &to, F own)
{
    constexpr size_t n = array<M>::parts / 2;
    auto floats = [](const M &m) { return reinterpret_cast<const float *>(&m); };
    reference truth = [=, &from, &to](size_t i, double *out) {
        textbook_step(s, floats(from[i]), floats(to[i]), n, out);
    };
    operation op = {"spring", name, 2 * n, 24.0 * n, 20 + 10.0 * n, truth, 16};
    chained<M>(op, "nkw", from, [=, &to](const M &x, size_t i) { return own(s, x, to[i]); });
    chained<M>(op, "loop", from, [=, &to](const M &x, size_t i) {
        M r;
        textbook_step(s, floats(x), floats(to[i]), n, reinterpret_cast<float *>(&r));
        return r;
    });
}

static nkw_state number_step(nkw_spring s, const nkw_state &x, const nkw_state &to)
{
    return nkw_spring_step(s, x, to, step);
}

static nkw_vec3_state vector_step(nkw_spring s, const nkw_vec3_state &x, const nkw_vec3_state &to)
{
    return nkw_vec3_spring_step(s, &x, &to, step);
}

static void rotations(nkw_spring s)
{
    reference truth = [=](size_t i, double *out) {
        vec<double> v(0, 0, 0);
        put(textbook_turn(s, turning[i], turning_to[i], &v), out);
        put(v, out + 4);
    };
    operation op = {"spring", "quat, underdamped", 7, 84, 220, truth, 16, 4096, same::rotation};
    single(op, "nkw", [=](size_t i) { return nkw_quat_spring_step(s, &turning[i], &turning_to[i], step); });
    single(op, "loop", [=](size_t i) {
        vec<float> v(0, 0, 0);
        quat<float> q = textbook_turn(s, turning[i], turning_to[i], &v);
        return nkw_quat_state{to(q), to(v)};
    });
}

static const suite all([] {
    for (size_t i = 0; i < pool; i++) {
        moving.set(i, {signed_one[i], point[0][i].x});
        goal.set(i, {point[1][i].x, point[1][i].y});
        moving3.set(i, {point[0][i], point[1][i]});
        goal3.set(i, {point[2][i], point[3][i]});
        turning.set(i, {unit_near[i], point[0][i]});
        turning_to.set(i, {unit_a[i], point[1][i]});
    }
    nkw_spring critical = nkw_spring_from_half_life(0.1f, 1), under = nkw_spring_from_half_life(0.1f, 0.5f);
    rows("float, critically damped", critical, moving, goal, number_step);
    rows("float, underdamped", under, moving, goal, number_step);
    rows("vec3, underdamped", under, moving3, goal3, vector_step);
    rotations(under);
});
