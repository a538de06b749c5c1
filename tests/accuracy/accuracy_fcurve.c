/* SPDX-License-Identifier: MIT */
/* Errors of <nakawari/fcurve.h> against binary128. Those of BEZIER are in accuracy_handle. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <quadmath.h>

#define SAMPLES 40000u

/* x = the times and values of two keys, a time, the exponent of an ease of Penner */
static void two_keys(random_source *r, float *x)
{
    x[0] = random_between(r, -10.0f, 10.0f);
    x[1] = x[0] + random_log(r, 1e-3f, 10.0f);
    x[2] = random_between(r, -1.0f, 1.0f);
    x[3] = random_between(r, -1.0f, 1.0f);
    x[4] = nkw_clamp(nkw_lerp(x[0], x[1], random_unit(r)), x[0], x[1]);
    x[5] = (float)(2 + random_bits(r) % 4);
}

static void far_away(random_source *r, float *x)
{
    two_keys(r, x);
    x[4] = x[0] + random_between(r, -1e4f, 1e4f) * (x[1] - x[0]);
}

static float sampled(const float *x, nkw_fcurve_kind kind, nkw_fcurve_outside outside)
{
    nkw_ease_kind ease = (nkw_ease_kind)(NKW_EASE_QUAD_IN + 3 * ((int)x[5] - 2));
    nkw_fcurve_key keys[2] = {{x[0], x[2], {0, 0}, {0, 0}, kind, ease}, {x[1], x[3], {0, 0}, {0, 0}, kind, ease}};
    nkw_fcurve curve = {keys, 2, outside, outside, 0, 0, NKW_HANDLE_NONE};
    return nkw_fcurve_sample(&curve, x[4], NULL).value;
}

static wide progress(const float *x)
{
    return ((wide)x[4] - x[0]) / ((wide)x[1] - x[0]);
}

static double error_of(float got, wide want, const float *x)
{
    return wide_error_of(&got, &want, 1, fmaxq(fabsq(want), fmaxq(fabsq(x[2]), fabsq(x[3]))));
}

static double line_error(const float *x)
{
    return error_of(sampled(x, NKW_FCURVE_LINEAR, NKW_FCURVE_OUTSIDE_LINEAR), x[2] + ((wide)x[3] - x[2]) * progress(x),
                    x);
}

static double ease_error(const float *x)
{
    return error_of(sampled(x, NKW_FCURVE_EASE, NKW_FCURVE_OUTSIDE_HOLD),
                    x[2] + ((wide)x[3] - x[2]) * powq(progress(x), x[5]), x);
}

/* Cycles of a line with offset are one line. */
static double offset_error(const float *x)
{
    return error_of(sampled(x, NKW_FCURVE_LINEAR, NKW_FCURVE_OUTSIDE_CYCLE_OFFSET),
                    x[2] + ((wide)x[3] - x[2]) * progress(x), x);
}

static const wide_case cases[] = {
    {"nkw_fcurve_sample", "LINEAR", two_keys, line_error, 6, WIDE_CHECKED},
    {"nkw_fcurve_sample", "EASE by Penner's powers", two_keys, ease_error, 6, WIDE_CHECKED},
    {"nkw_fcurve_sample", "LINEAR outside, 1e4 durations", far_away, line_error, 6, WIDE_CHECKED},
    {"nkw_fcurve_sample", "CYCLE_OFFSET, 1e4 cycles", far_away, offset_error, 6, WIDE_CHECKED},
};

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("fcurve.h", argc, argv);
    wide_search(&a, cases, sizeof cases / sizeof cases[0], SAMPLES);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
