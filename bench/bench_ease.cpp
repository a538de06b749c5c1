/* SPDX-License-Identifier: MIT */
/* Easing. The loops are the formulas with the C library, and for cubic-bezier() up to eight Newton steps in float. */
#include <cmath>

#include "bench.h"
#include "newton.h"

using namespace bench;

static const float pi = 3.14159265f;

static void kind(const char *name, nkw_ease_kind k, double flops, float (*loop)(float), double (*truth)(double))
{
    operation op = {"ease", name, 1, 8, flops, [=](size_t i, double *out) { *out = truth(static_cast<double>(t[i])); }};
    single(op, "nkw", [=](size_t i) { return nkw_ease_evaluate(k, t[i]).value; });
    single(op, "loop", [=](size_t i) { return loop(t[i]); });
}

static float sine(float x)
{
    return 0.5f - 0.5f * cosf(pi * x);
}

static float elastic(float x)
{
    return 1 + exp2f(-10 * x) * sinf((10 * x - 0.75f) * (2 * pi / 3));
}

static float back(float x)
{
    float y = x - 1;
    return 1 + y * y * (2.70158f * y + 1.70158f);
}

static void bezier()
{
    static const nkw_easing css = {
        NKW_EASING_CUBIC_BEZIER, {0.25f, 0.1f, 0.25f, 1}, NKW_EASE_JUMP_END, 0, nullptr, nullptr};
    static const newton::cubic x = {0, 0.25f, 0.25f, 1}, y = {0, 0.1f, 1, 1};
    reference truth = [](size_t i, double *out) {
        *out = newton::at(y, newton::bisected(x, static_cast<double>(t[i])));
    };
    operation op = {"ease", "cubic-bezier", 1, 8, 80, truth};
    single(op, "nkw", [](size_t i) { return nkw_easing_evaluate(&css, t[i]).value; });
    single(op, "loop", [](size_t i) { return newton::at(y, newton::solved(x, t[i], t[i])); });
}

static const suite all([] {
    static constexpr double wide_pi = 3.14159265358979323846;
    kind("sine, in and out", NKW_EASE_SINE_IN_OUT, 15, sine,
         [](double x) { return 0.5 - 0.5 * std::cos(wide_pi * x); });
    kind("elastic, out", NKW_EASE_ELASTIC_OUT, 35, elastic,
         [](double x) { return 1 + std::exp2(-10 * x) * std::sin((10 * x - 0.75) * (2 * wide_pi / 3)); });
    kind("back, out", NKW_EASE_BACK_OUT, 6, back,
         [](double x) { return 1 + (x - 1) * (x - 1) * (2.70158 * (x - 1) + 1.70158); });
    bezier();
});
