/* SPDX-License-Identifier: MIT */
/* Errors of <nakawari/ease.h> against binary128. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <quadmath.h>

#define SAMPLES 40000u

/* ---- Penner's thirty: value and derivatives from the formulas ---- */

typedef struct exact {
    wide v, d, a;
} exact;

static nkw_motion cubic_bezier(float x1, float y1, float x2, float y2, float t)
{
    const nkw_easing e = {NKW_EASING_CUBIC_BEZIER, {x1, y1, x2, y2}, NKW_EASE_JUMP_END, 0, NULL, NULL};
    return nkw_easing_evaluate(&e, t);
}

static float steps(size_t count, nkw_ease_jump jump, float t)
{
    const nkw_easing e = {NKW_EASING_STEPS, {0, 0, 0, 0}, jump, count, NULL, NULL};
    const nkw_motion p = nkw_easing_evaluate(&e, t);
    return p.value;
}

static nkw_motion linear(const float *inputs, const float *outputs, size_t count, float t)
{
    const nkw_easing e = {NKW_EASING_LINEAR, {0, 0, 0, 0}, NKW_EASE_JUMP_END, count, inputs, outputs};
    return nkw_easing_evaluate(&e, t);
}

static exact bounce_out(wide x)
{
    const wide d = 2.75, m = x < 1 / d ? 0 : x < 2 / d ? 1.5 / d : x < 2.5 / d ? 2.25 / d : 2.625 / d;
    const wide k = x < 1 / d ? 0 : x < 2 / d ? 0.75 : x < 2.5 / d ? 0.9375 : 0.984375;
    exact e = {7.5625 * (x - m) * (x - m) + k, 15.125 * (x - m), 15.125};
    return e;
}

/* y = 1 - x, exact where x is nearly 1. */
static exact exact_in(int family, wide x, wide y, int both)
{
    const wide pi = wide_pi(), k = 10 * logq(2), c = both ? 1.70158 * 1.525 : 1.70158,
               w = 2 * pi / (both ? 0.45 : 0.3);
    wide power = exp2q(10 * x - 10), root = sqrtq(y * (1 + x)), angle = w * (x - 1), n = family + 1;
    exact sine = {1 - cosq(x * pi / 2), pi / 2 * sinq(x * pi / 2), pi * pi / 4 * cosq(x * pi / 2)};
    exact expo = {x == 0 ? 0 : power, k * power, k * k * power};
    exact circ = {1 - root, x / root, 1 / (root * root * root)};
    exact back = {x * x * ((c + 1) * x - c), 3 * (c + 1) * x * x - 2 * c * x, 6 * (c + 1) * x - 2 * c};
    exact elastic = {x == 0 ? 0 : power * cosq(angle), power * (k * cosq(angle) - w * sinq(angle)),
                     power * ((k * k - w * w) * cosq(angle) - 2 * k * w * sinq(angle))};
    exact out = bounce_out(1 - x), bounce = {1 - out.v, out.d, -out.a};
    exact power_of = {powq(x, n), n * powq(x, n - 1), n * (n - 1) * powq(x, n - 2)};
    return family == 0   ? sine
           : family == 5 ? expo
           : family == 6 ? circ
           : family == 7 ? back
           : family == 8 ? elastic
           : family == 9 ? bounce
                         : power_of;
}

static exact exact_ease(int index, wide t)
{
    int family = index / 3;
    if (index % 3 == 0)
        return exact_in(family, t, 1 - t, 0);
    wide x = t < 0.5 ? 2 * t : 2 - 2 * t;
    exact e = index % 3 == 1 ? exact_in(family, 1 - t, t, 0) : exact_in(family, x, t < 0.5 ? 1 - x : 2 * t - 1, 1);
    if (index % 3 == 2) {
        e.v /= 2;
        e.a *= 2;
    }
    if (index % 3 == 2 && t < 0.5)
        return e;
    e.v = 1 - e.v;
    e.a = -e.a;
    return e;
}

/* x = t, the number of the function */
static void progress(random_source *r, float *x)
{
    x[0] = random_unit(r);
    x[1] = (float)(random_bits(r) % 30);
}

static void near_the_ends(random_source *r, float *x)
{
    float off = random_log(r, random_bits(r) % 2 ? 1e-20f : 1e-9f, 0.25f);
    x[0] = random_sign(r) > 0.0f ? off : 1.0f - off;
    x[1] = (float)(random_bits(r) % 30);
}

/* Of the larger of 1 and the result. Derivatives of circ at its end are infinite. */
static double ease_error(const float *x)
{
    int index = (int)x[1];
    nkw_motion got = nkw_ease_evaluate((nkw_ease_kind)(NKW_EASE_SINE_IN + index), x[0]);
    exact e = exact_ease(index, x[0]);
    float of[3] = {got.value, got.velocity, got.acceleration};
    wide want[3] = {e.v, e.d, e.a};
    double worst = 0.0;
    for (int i = 0; i < 3; i++)
        if (finiteq(want[i]) && fabsq(want[i]) < 0x1p120)
            worst = fmax(worst, wide_error_of(of + i, want + i, 1, fmaxq(1, fabsq(want[i]))));
    return worst;
}

/* ---- CSS ---- */

static void controls(random_source *r, float *x)
{
    x[0] = random_unit(r);
    x[1] = random_between(r, -1.0f, 2.0f);
    x[2] = random_unit(r);
    x[3] = random_between(r, -1.0f, 2.0f);
    x[4] = random_unit(r);
}

static void steep(random_source *r, float *x)
{
    controls(r, x);
    x[0] = 1.0f - random_log(r, 1e-7f, 1e-2f);
    x[2] = random_log(r, 1e-7f, 1e-2f);
}

static wide bezier(wide a, wide b, wide s)
{
    wide r = 1 - s;
    return 3 * a * r * r * s + 3 * b * r * s * s + s * s * s;
}

static wide solved(const float *x, wide time)
{
    wide low = 0, high = 1;
    for (int i = 0; i < 110; i++) {
        wide s = (low + high) / 2;
        if (bezier(x[0], x[2], s) < time)
            low = s;
        else
            high = s;
    }
    return high;
}

static double bezier_error(const float *x)
{
    float got = cubic_bezier(x[0], x[1], x[2], x[3], x[4]).value;
    wide from = solved(x, (wide)x[4] - 0x1p-48), to = solved(x, (wide)x[4] + 0x1p-48);
    wide low = bezier(x[1], x[3], from), high = low;
    for (int i = 1; i <= 16; i++) {
        wide v = bezier(x[1], x[3], from + (to - from) * i / 16);
        low = fminq(low, v);
        high = fmaxq(high, v);
    }
    wide nearest = (wide)got < low ? low : (wide)got > high ? high : (wide)got;
    return wide_error_of(&got, &nearest, 1, fmaxq(1, fmaxq(fabsq(x[1]), fabsq(x[3]))));
}

static void stepped(random_source *r, float *x)
{
    x[0] = random_between(r, -1.0f, 2.0f);
    x[1] = (float)(1 + random_bits(r) % 100);
    x[2] = (float)(random_bits(r) % 4);
}

static double steps_error(const float *x)
{
    int jump = (int)x[2];
    wide n = jump == NKW_EASE_JUMP_NONE ? fmaxq(2, x[1]) : x[1];
    wide m = jump == NKW_EASE_JUMP_NONE ? n - 1 : jump == NKW_EASE_JUMP_BOTH ? n + 1 : n;
    wide k = floorq(x[0] * n) + (jump == NKW_EASE_JUMP_START || jump == NKW_EASE_JUMP_BOTH);
    k = x[0] <= 1 && k > m ? m : k;
    k = x[0] >= 0 && k < 0 ? 0 : k;
    wide want = k / m;
    float got = steps((size_t)x[1], (nkw_ease_jump)jump, x[0]);
    return wide_error_of(&got, &want, 1, want == 0 ? 1 : fabsq(want));
}

static void line(random_source *r, float *x)
{
    x[0] = random_unit(r);
    x[1] = x[0] + random_log(r, 1e-3f, 1.0f);
    x[2] = random_between(r, -2.0f, 2.0f);
    x[3] = random_between(r, -2.0f, 2.0f);
    x[4] = random_between(r, -1.0f, 2.0f);
}

static double line_error(const float *x)
{
    float got = linear(x, x + 2, 2, x[4]).value;
    wide want = x[2] + ((wide)x[3] - x[2]) * ((wide)x[4] - x[0]) / ((wide)x[1] - x[0]);
    return wide_error_of(&got, &want, 1, fmaxq(fabsq(want), fmaxq(fabsq(x[2]), fabsq(x[3]))));
}

static const wide_case cases[] = {
    {"nkw_ease_evaluate", "Penner's thirty, t in [0, 1)", progress, ease_error, 2, WIDE_CHECKED},
    {"nkw_ease_evaluate", "Penner's thirty, 1e-20 .. 1/4 from the ends", near_the_ends, ease_error, 2, WIDE_CHECKED},
    {"nkw_easing_evaluate", "cubic-bezier, x in 0 .. 1, y in -1 .. 2", controls, bezier_error, 5, WIDE_CHECKED},
    {"nkw_easing_evaluate", "cubic-bezier, nearly vertical", steep, bezier_error, 5, WIDE_CHECKED},
    {"nkw_easing_evaluate", "steps, 1 .. 100 steps, t in [-1, 2]", stepped, steps_error, 3, WIDE_CHECKED},
    {"nkw_easing_evaluate", "linear, one line, t in [-1, 2]", line, line_error, 5, WIDE_CHECKED},
};

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("ease.h", argc, argv);
    wide_search(&a, cases, sizeof cases / sizeof cases[0], SAMPLES);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
