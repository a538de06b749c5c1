/* SPDX-License-Identifier: MIT */
/*
 * Curves of rotations. The loops are the formulas with the C library, and have the orientation alone: no angular
 * velocity and no acceleration, which the library returns with it.
 */
#include <cmath>

#include "bench.h"
#include "random.h"
#include "textbook.h"
#include "truth.h"

using namespace bench;
using textbook::quat;
using textbook::vec;

static std::vector<nkw_rotation_segment> hermite, squad, bspline;

template <class T> static quat<T> control(const nkw_rotation_segment &s, size_t k)
{
    return quat<T>(s.control[k]);
}

template <class T> static quat<T> hermite_at(const nkw_rotation_segment &s, T x)
{
    T sixth = static_cast<T>(s.duration) / 6, r = 1 - x, half = static_cast<T>(0.5);
    quat<T> a = control<T>(s, 0), b = control<T>(s, 1);
    vec<T> u = sixth * rotate(conjugate(a), vec<T>(s.velocity[0])),
           w = sixth * rotate(conjugate(b), vec<T>(s.velocity[1]));
    vec<T> m = half * (u + w);
    quat<T> first = textbook::exp(u) * textbook::exp(m);
    vec<T> rest = textbook::log(conjugate(first) * conjugate(a) * b * conjugate(textbook::exp(w)));
    T b1 = 1 - r * r * r, b2 = x * x * (3 - 2 * x), b3 = x * x * x;
    return a * textbook::exp(b1 * u) * textbook::exp(b2 * m) * textbook::exp(b2 * rest) * textbook::exp(b3 * w);
}

static quat<float> squad_at(const nkw_rotation_segment &s, float x)
{
    quat<float> ends = textbook::slerp(control<float>(s, 0), control<float>(s, 3), x);
    quat<float> inner = textbook::slerp(control<float>(s, 1), control<float>(s, 2), x);
    return textbook::slerp(ends, inner, 2 * x * (1 - x));
}

/* By truth::slerp: that of the textbook is a lerp for near quaternions. */
static quat<double> exact_squad(const nkw_rotation_segment &s, double x)
{
    truth::quat c[4] = {truth::quat(s.control[0]), truth::quat(s.control[1]), truth::quat(s.control[2]),
                        truth::quat(s.control[3])};
    for (truth::quat &q : c)
        q = truth::unit(q);
    truth::quat q = truth::slerp(truth::slerp(c[0], c[3], x), truth::slerp(c[1], c[2], x), 2 * x * (1 - x));
    return {q.x, q.y, q.z, q.w};
}

template <class T> static quat<T> bspline_at(const nkw_rotation_segment &s, T x)
{
    T r = 1 - x, b[3] = {1 - r * r * r / 6, (1 + x * (3 + x * (3 - 2 * x))) / 6, x * x * x / 6};
    quat<T> q = control<T>(s, 0);
    for (size_t k = 0; k < 3; k++)
        q = q * textbook::exp(b[k] * textbook::log(conjugate(control<T>(s, k)) * control<T>(s, k + 1)));
    return q;
}

template <class F, class G>
static void rows(const char *name, const std::vector<nkw_rotation_segment> &s, double flops, F loop, G exact)
{
    reference truth = [&s, exact](size_t i, double *out) { put(unit(exact(s[i], static_cast<double>(t[i]))), out); };
    operation op = {"rotation", name, 4, 120, flops, truth, 4, 4096, same::rotation};
    single(op, "nkw", [&s](size_t i) { return nkw_rotation_evaluate(&s[i], t[i]).value; });
    single(op, "loop", [&s, loop](size_t i) { return to(loop(s[i], t[i])); });
}

/* Keys some 10 to 60 degrees of rotation apart, 0.1 s. */
static void draw()
{
    random_source r = random_from(21);
    for (size_t i = 0; i < pool; i++) {
        nkw_quat keys[4] = {unit_a[i], unit_a[i], unit_a[i], unit_a[i]};
        for (size_t k = 1; k < 4; k++)
            keys[k] = random_near(&r, keys[k - 1], random_between(&r, 0.09f, 0.5f));
        const float times[4] = {0, 0.1f, 0.2f, 0.3f};
        hermite.push_back(nkw_rotation_from_catmull_rom(keys, times));
        squad.push_back(nkw_rotation_from_squad(keys, 0.1f));
        bspline.push_back(nkw_rotation_from_bspline(keys, 0.1f));
    }
}

static const suite all([] {
    draw();
    rows("hermite", hermite, 420, hermite_at<float>, hermite_at<double>);
    rows("squad", squad, 160, squad_at, exact_squad);
    rows("bspline", bspline, 260, bspline_at<float>, bspline_at<double>);
});
