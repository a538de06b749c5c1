/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <math.h>

#include <nakawari/ease.h>

#include "ease_point.h"
#include "handle_solve.h"
#include "lane/scalar.h"

/* sin(pi u) for |u| <= 1/2. */
static double sine(double u)
{
    lane_turns turns = {u, 0};
    return lane_sine64(turns);
}

static handle_point sine_in(double x)
{
    double half = sine(0.25 * x), w = LANE_HALF_PI;
    handle_point r = {2.0 * (half * half), w * sine(0.5 * x), (w * w) * sine(0.5 * (1.0 - x))};
    return r;
}

/* x^n */
static handle_point power_in(double x, int n)
{
    double p = 1.0;
    for (int i = 2; i < n; i++)
        p *= x;
    handle_point r = {p * (x * x), (double)n * (p * x), (double)(n * (n - 1)) * p};
    return r;
}

static handle_point expo_in(double x)
{
    const double k = 10.0 * LANE_LN_2;
    double power = lane_exp2_64(10.0 * x - 10.0);
    handle_point r = {x > 0.0 ? power : 0.0, k * power, (k * k) * power};
    return r;
}

/* 1 - sqrt(1 - x^2) without a difference, y = 1 - x. */
static handle_point circ_in(double x, double y)
{
    double root = lane_sqrt64(y * (1.0 + x));
    handle_point r = {(x * x) / (1.0 + root), INFINITY, INFINITY}; /* vertical at x = 1 */
    if (root != 0.0) {
        r.first = x / root;
        r.second = 1.0 / ((root * root) * root);
    }
    return r;
}

static handle_point back_in(double x, double c)
{
    handle_point r = {(x * x) * ((c + 1.0) * x - c), x * ((3.0 * (c + 1.0)) * x - 2.0 * c),
                      (6.0 * (c + 1.0)) * x - 2.0 * c};
    return r;
}

/* -E sin(w (x - 1) - pi/2),  E = 2^(10 (x - 1)) = e^(k (x - 1)),  w = 2 pi/period; that is E cos(w (x - 1)). */
static handle_point elastic_in(double x, double period)
{
    const double k = 10.0 * LANE_LN_2, w = LANE_TWO_PI / period;
    double u = (x - 1.0) * (2.0 / period), rounded_u = u + LANE_ROUND, power = lane_exp2_64(10.0 * x - 10.0);
    double remainder = u - (rounded_u - LANE_ROUND), sign = (lane_bits64(rounded_u) & 1u) ? -power : power;
    double c = sign * sine(0.5 - lane_abs64(remainder)), s = sign * sine(remainder);
    handle_point r = {x > 0.0 ? c : 0.0, k * c - w * s, (k * k - w * w) * c - (2.0 * k * w) * s};
    return r;
}

static handle_point bounce_in(double x)
{
    static const double middle[4] = {0.0, 1.5 / 2.75, 2.25 / 2.75, 2.625 / 2.75},
                        top[4] = {0.0, 0.75, 0.9375, 0.984375};
    double y = 1.0 - x;
    int i = (y >= 1.0 / 2.75) + (y >= 2.0 / 2.75) + (y >= 2.5 / 2.75);
    double from = y - middle[i];
    handle_point r = {(1.0 - top[i]) - 7.5625 * (from * from), 15.125 * from, -15.125};
    return r;
}

typedef enum family { SINE, QUAD, CUBIC, QUART, QUINT, EXPO, CIRC, BACK, ELASTIC, BOUNCE } family;

/* The `in` function of a family at x, y = 1 - x; `both` selects the constants of in-out. */
static handle_point ease_in(family f, double x, double y, int both)
{
    switch (f) {
    case SINE:
        return sine_in(x);
    case EXPO:
        return expo_in(x);
    case CIRC:
        return circ_in(x, y);
    case BACK:
        return back_in(x, both ? 1.70158 * 1.525 : 1.70158);
    case ELASTIC:
        return elastic_in(x, both ? 0.45 : 0.3);
    case BOUNCE:
        return bounce_in(x);
    default:
        return power_in(x, (int)f + 1);
    }
}

/* 1 - f(1 - t) */
static handle_point mirrored(handle_point in)
{
    handle_point r = {1.0 - in.value, in.first, -in.second};
    return r;
}

/* f(2t)/2 */
static handle_point halved(handle_point in)
{
    handle_point r = {0.5 * in.value, in.first, 2.0 * in.second};
    return r;
}

/* Penner's function `index` of the thirty, for t in 0..1. */
static handle_point penner(int index, double t)
{
    family f = (family)(index / 3);
    if (index % 3 == 0)
        return ease_in(f, t, 1.0 - t, 0);
    if (index % 3 == 1)
        return mirrored(ease_in(f, 1.0 - t, t, 0));
    return t < 0.5 ? halved(ease_in(f, 2.0 * t, 1.0 - 2.0 * t, 1))
                   : mirrored(halved(ease_in(f, 2.0 - 2.0 * t, 2.0 * t - 1.0, 1)));
}

static handle_point penner_point(int index, double t)
{
    handle_point before = {0.0, 0.0, 0.0}, after = {1.0, 0.0, 0.0};
    if (t < 0.0 || t > 1.0)
        return t > 1.0 ? after : before;
    handle_point r = penner(index, t);
    r.value = t == 0.0 ? 0.0 : t == 1.0 ? 1.0 : r.value;
    return r;
}

/* Finite control points (x1, y1) and (x2, y2), at t. Outside 0..1 along the tangent of the end, if not vertical. */
static handle_point css_point(const float c[4], double t)
{
    handle_cubic curve = {1.0, (double)c[0], 1.0 - (double)c[2], 0.0, 1.0, (double)c[1], 1.0 - (double)c[3]};
    double end = t > 0.0 ? 1.0 : 0.0;
    if (t > 0.0 && t < 1.0)
        return handle_point_at(&curve, handle_parameter(&curve, t));
    handle_point r = handle_point_at(&curve, end);
    if (t == end)
        return r;
    r.first = r.first - r.first == 0.0 ? r.first : 0.0;
    r.second = 0.0;
    r.value = r.first != 0.0 ? end + r.first * (t - end) : end;
    return r;
}

static nkw_motion cubic_bezier(const float c[4], float t)
{
    nkw_motion none = {NAN, NAN, NAN};
    return t == t && lane_is_finite(c[0]) && lane_is_finite(c[2]) ? handle_rounded(css_point(c, (double)t)) : none;
}

static double steps(size_t count, nkw_ease_jump jump, double t)
{
    size_t least = jump == NKW_EASE_JUMP_NONE ? 2 : 1;
    int starts = jump == NKW_EASE_JUMP_START || jump == NKW_EASE_JUMP_BOTH;
    double n = (double)(count > least ? count : least);
    double m = jump == NKW_EASE_JUMP_BOTH ? n + 1.0 : jump == NKW_EASE_JUMP_NONE ? n - 1.0 : n;
    double step = lane_floor64(t * n) + (double)starts;
    step = t <= 1.0 && step > m ? m : step;
    step = t >= 0.0 && step < 0.0 ? 0.0 : step;
    return step / m;
}

const float *nkwi_ease_css(nkw_ease_kind kind)
{
    static const float css[4][4] = {
        {0.25f, 0.1f, 0.25f, 1.0f},
        {0.42f, 0.0f, 1.0f, 1.0f},
        {0.0f, 0.0f, 0.58f, 1.0f},
        {0.42f, 0.0f, 0.58f, 1.0f},
    };
    int index = (int)kind - (int)NKW_EASE_CSS;
    return index >= 0 && index < 4 ? css[index] : NULL;
}

handle_point nkwi_ease_point(nkw_ease_kind kind, double t)
{
    handle_point none = {(double)NAN, (double)NAN, (double)NAN}, line = {t, 1.0, 0.0}, step = {0.0, 0.0, 0.0};
    int index = (int)kind;
    if (t != t)
        return none;
    if (index >= NKW_EASE_SINE_IN && index <= NKW_EASE_BOUNCE_IN_OUT)
        return penner_point(index - NKW_EASE_SINE_IN, t);
    const float *css = nkwi_ease_css(kind);
    if (css)
        return css_point(css, t);
    if (index != NKW_EASE_CSS_STEP_START && index != NKW_EASE_CSS_STEP_END)
        return line;
    step.value = steps(1, index == NKW_EASE_CSS_STEP_START ? NKW_EASE_JUMP_START : NKW_EASE_JUMP_END, t);
    return step;
}

nkw_motion nkw_ease_evaluate(nkw_ease_kind kind, float t)
{
    return handle_rounded(nkwi_ease_point(kind, (double)t));
}

/* The last point, of all but the last, whose input is <= t; 0 if there is none. */
static size_t line_of(const float *inputs, size_t count, float t)
{
    size_t k = count - 2;
    while (k > 0 && !(inputs[k] <= t))
        k--;
    return k;
}

static nkw_motion linear(const float *inputs, const float *outputs, size_t count, float t)
{
    nkw_motion r = {t != t ? NAN : count > 0 ? outputs[0] : 0.0f, 0.0f, 0.0f};
    if (count < 2 || t != t)
        return r;
    size_t k = line_of(inputs, count, t);
    double width = (double)inputs[k + 1] - (double)inputs[k], rise = (double)outputs[k + 1] - (double)outputs[k];
    r.value = t < inputs[k] ? outputs[k] : outputs[k + 1];
    if (width == 0.0)
        return r;
    r.value = (float)((double)outputs[k] + rise * (((double)t - (double)inputs[k]) / width));
    r.value = t == inputs[k + 1] ? outputs[k + 1] : r.value;
    r.velocity = (float)(rise / width);
    return r;
}

nkw_motion nkw_easing_evaluate(const nkw_easing *easing, float t)
{
    if (easing->kind == NKW_EASING_LINEAR)
        return linear(easing->inputs, easing->outputs, easing->count, t);
    if (easing->kind != NKW_EASING_STEPS)
        return cubic_bezier(easing->curve, t);
    nkw_motion r = {(float)steps(easing->count, easing->jump, (double)t), 0.0f, 0.0f};
    return r;
}

/* Inputs k + 1 .. end - 1, spaced evenly between the inputs k and end. */
static void space(float *inputs, size_t k, size_t end)
{
    double from = inputs[k], step = ((double)inputs[end] - from) / (double)(int64_t)(end - k);
    for (size_t i = k + 1; i < end; i++)
        inputs[i] = (float)(from + step * (double)(int64_t)(i - k));
}

void nkw_easing_complete(float *inputs, size_t count)
{
    if (count == 0)
        return;
    if (inputs[0] != inputs[0])
        inputs[0] = 0.0f;
    if (inputs[count - 1] != inputs[count - 1])
        inputs[count - 1] = 1.0f;
    size_t last = 0; /* the last input that is not omitted */
    for (size_t i = 1; i < count; i++) {
        if (inputs[i] != inputs[i])
            continue;
        inputs[i] = inputs[i] < inputs[last] ? inputs[last] : inputs[i];
        space(inputs, last, i);
        last = i;
    }
}
