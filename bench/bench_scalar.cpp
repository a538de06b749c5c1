/* SPDX-License-Identifier: MIT */
/* Elementary functions: the C library, SLEEF (1.0 ULP, vectors of the level of the build), a plain loop. */
#include <cmath>

#include "bench.h"
#include "peers.h"

using namespace bench;

#ifdef BENCH_SLEEF
static const peer_sleef &sleef()
{
    return BENCH_SLEEF_LEVEL;
}
#endif

using one = float (*)(float);
using one_n = void (*)(const float *, float *, size_t);
using two = float (*)(float, float);
using two_n = void (*)(const float *, const float *, float *, size_t);

/* The error is in ULP to within a factor of two: u of the result itself. */
static operation exact(const char *name, double bytes, double flops, reference truth)
{
    return {"scalar", name, 1, bytes, flops, truth, 1.1, 16, same::number, 0};
}

template <one F, one C>
static void of_one(const char *name, const array<float> &x, double flops, double (*truth)(double), one_n vectors)
{
    operation op = exact(name, 8, flops, [=, &x](size_t i, double *out) { *out = truth(static_cast<double>(x[i])); });
    single(op, "nkw", [&x](size_t i) { return F(x[i]); });
    single(op, "C library", [&x](size_t i) { return C(x[i]); });
    if (vectors)
        batch(op, "SLEEF", [=, &x](size_t from, size_t n) { vectors(x.at + from, answer.part[0] + from, n); });
}

template <two F, two C>
static void of_two(const char *name, const array<float> &x, const array<float> &y, double flops,
                   double (*truth)(double, double), two_n vectors)
{
    operation op = exact(name, 12, flops, [=, &x, &y](size_t i, double *out) {
        *out = truth(static_cast<double>(x[i]), static_cast<double>(y[i]));
    });
    single(op, "nkw", [&](size_t i) { return F(x[i], y[i]); });
    single(op, "C library", [&](size_t i) { return C(x[i], y[i]); });
    if (vectors)
        batch(op, "SLEEF",
              [=, &x, &y](size_t from, size_t n) { vectors(x.at + from, y.at + from, answer.part[0] + from, n); });
}

static void sine_and_cosine()
{
    struct pair {
        float s, c;
    };
    operation op = {"scalar", "sincos", 2, 12, 40, [](size_t i, double *out) {
                        out[0] = std::sin(static_cast<double>(turns[i]));
                        out[1] = std::cos(static_cast<double>(turns[i]));
                    }};
    single(op, "nkw", [](size_t i) {
        pair p;
        nkw_sincos(turns[i], &p.s, &p.c);
        return p;
    });
    single(op, "C library", [](size_t i) { return pair{sinf(turns[i]), cosf(turns[i])}; });
#ifdef BENCH_SLEEF
    batch(op, "SLEEF", [](size_t from, size_t n) {
        sleef().sincos(turns.at + from, answer.part[0] + from, answer.part[1] + from, n);
    });
#endif
}

static void lerp()
{
    operation op = {"scalar",
                    "lerp",
                    1,
                    16,
                    5,
                    [](size_t i, double *out) {
                        double a = static_cast<double>(signed_one[i]), b = static_cast<double>(turns[i]);
                        *out = a + static_cast<double>(t[i]) * (b - a);
                    },
                    20};
    single(op, "nkw", [](size_t i) { return nkw_lerp(signed_one[i], turns[i], t[i]); });
    single(op, "loop", [](size_t i) { return signed_one[i] + t[i] * (turns[i] - signed_one[i]); });
}

#ifdef BENCH_SLEEF
#define VECTORS(name) sleef().name
#else
#define VECTORS(name) nullptr
#endif

static const suite all([] {
    of_one<nkw_sqrt, sqrtf>("sqrt", positive, 1, std::sqrt, nullptr);
    of_one<nkw_sin, sinf>("sin", turns, 22, std::sin, VECTORS(sin));
    of_one<nkw_tan, tanf>("tan", turns, 40, std::tan, VECTORS(tan));
    of_one<nkw_asin, asinf>("asin", signed_one, 30, std::asin, VECTORS(asin));
    of_one<nkw_acos, acosf>("acos", signed_one, 30, std::acos, VECTORS(acos));
    of_one<nkw_atan, atanf>("atan", turns, 30, std::atan, VECTORS(atan));
    of_one<nkw_exp, expf>("exp", turns, 20, std::exp, VECTORS(exp));
    of_one<nkw_log, logf>("log", positive, 25, std::log, VECTORS(log));
    of_two<nkw_atan2, atan2f>("atan2", turns, signed_one, 35, std::atan2, VECTORS(atan2));
    of_two<nkw_pow, powf>("pow", positive, signed_one, 60, std::pow, VECTORS(pow));
    sine_and_cosine();
    lerp();
});
