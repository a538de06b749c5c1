/* SPDX-License-Identifier: MIT */
/* Errors of <nakawari/dialect.h> against binary128. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <quadmath.h>

#define SAMPLES 40000u

/* x = two times, the slope and the weight of the out-handle */
static void slope(random_source *r, float *x)
{
    x[0] = random_between(r, -10.0f, 10.0f);
    x[1] = x[0] + random_log(r, 1e-3f, 10.0f);
    x[2] = random_sign(r) * random_log(r, 1e-3f, 1e3f);
    x[3] = random_log(r, 1e-3f, 10.0f);
}

static double handle_error(const float *x, nkw_weighted weighted, nkw_weight_unit unit)
{
    const nkw_slope_key slopes[2] = {{x[0], 0, 0, x[2], 0, x[3], weighted, NKW_FCURVE_BEZIER},
                                     {x[1], 0, 0, 0, 0, 0, NKW_WEIGHTED_NONE, NKW_FCURVE_BEZIER}};
    nkw_fcurve_key keys[2];
    wide h = (wide)x[1] - x[0], m = x[2], w = x[3];
    wide time = unit == NKW_WEIGHT_FRACTION ? w * h : unit == NKW_WEIGHT_SECONDS ? w : w / sqrtq(1 + m * m);
    time = weighted == NKW_WEIGHTED_NONE ? h / 3 : time;
    wide value = m * time;
    nkw_fcurve_from_slope_keys(slopes, 2, unit, keys, NULL);
    return fmax(wide_error_of(&keys[0].out.time, &time, 1, fabsq(time)),
                wide_error_of(&keys[0].out.value, &value, 1, fabsq(value)));
}

static double third_error(const float *x)
{
    return handle_error(x, NKW_WEIGHTED_NONE, NKW_WEIGHT_FRACTION);
}

static double fraction_error(const float *x)
{
    return handle_error(x, NKW_WEIGHTED_OUT, NKW_WEIGHT_FRACTION);
}

static double length_error(const float *x)
{
    return handle_error(x, NKW_WEIGHTED_OUT, NKW_WEIGHT_LENGTH);
}

/* x = the key, the tip of a handle as a point */
static void points(random_source *r, float *x)
{
    for (int i = 0; i < 4; i++)
        x[i] = random_between(r, -10.0f, 10.0f);
}

static double blender_error(const float *x)
{
    nkw_blender_key b = {{x[0], x[1]}, {x[0], x[1]}, {x[2], x[3]}, 2, 0};
    nkw_fcurve_key key;
    nkw_fcurve_from_blender_keys(&b, 1, &key, NULL);
    wide time = (wide)x[2] - x[0], value = (wide)x[3] - x[1];
    return fmax(wide_error_of(&key.out.time, &time, 1, fmaxq(fabsq(x[0]), fabsq(x[2]))),
                wide_error_of(&key.out.value, &value, 1, fmaxq(fabsq(x[1]), fabsq(x[3]))));
}

/* x = three times, three values */
static void three(random_source *r, float *x)
{
    x[0] = random_between(r, -10.0f, 10.0f);
    x[1] = x[0] + random_between(r, 0.5f, 2.0f);
    x[2] = x[1] + random_between(r, 0.5f, 2.0f);
    for (int i = 3; i < 6; i++)
        x[i] = random_between(r, -1.0f, 1.0f);
}

/* Values of the handles, of the larger of the two slopes. */
static double auto_error(const float *x)
{
    const nkw_handle_types types[3] = {
        {NKW_HANDLE_AUTO, NKW_HANDLE_AUTO}, {NKW_HANDLE_AUTO, NKW_HANDLE_AUTO}, {NKW_HANDLE_VECTOR, NKW_HANDLE_VECTOR}};
    nkw_fcurve_key keys[3];
    for (int k = 0; k < 3; k++) {
        nkw_fcurve_key key = {x[k], x[3 + k], {0, 0}, {0, 0}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR};
        keys[k] = key;
    }
    nkw_fcurve_auto_handles(keys, 3, types);
    wide h0 = (wide)x[1] - x[0], h1 = (wide)x[2] - x[1], d0 = ((wide)x[4] - x[3]) / h0, d1 = ((wide)x[5] - x[4]) / h1;
    wide out = (d0 + d1) / 2 * h1 / (wide)2.5614, third = -d1 * h1 / 3, steep = fmaxq(fabsq(d0), fabsq(d1));
    return fmax(wide_error_of(&keys[1].out.value, &out, 1, steep * h1),
                wide_error_of(&keys[2].in.value, &third, 1, steep * h1));
}

static const wide_case cases[] = {
    {"nkw_fcurve_from_slope_keys", "without a weight", slope, third_error, 4, WIDE_CHECKED},
    {"nkw_fcurve_from_slope_keys", "FRACTION", slope, fraction_error, 4, WIDE_CHECKED},
    {"nkw_fcurve_from_slope_keys", "LENGTH", slope, length_error, 4, WIDE_CHECKED},
    {"nkw_fcurve_from_blender_keys", "[-10, 10]", points, blender_error, 4, WIDE_CHECKED},
    {"nkw_fcurve_auto_handles", "AUTO, VECTOR", three, auto_error, 6, WIDE_CHECKED},
};

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("dialect.h", argc, argv);
    wide_search(&a, cases, sizeof cases / sizeof cases[0], SAMPLES);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
