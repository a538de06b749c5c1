/* SPDX-License-Identifier: MIT */
#include "expect.h"

#include <math.h>

uint32_t bits_of(float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

float float_of(uint32_t bits)
{
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

/* The place of a float in the ascending row of all floats; both zeros have place 0. */
static int64_t place_of(float value)
{
    uint32_t bits = bits_of(value);
    int64_t magnitude = (int64_t)(bits & 0x7FFFFFFFu);
    return bits >> 31 ? -magnitude : magnitude;
}

double ulp_distance(float a, float b)
{
    int64_t distance = place_of(a) - place_of(b);
    return (double)(distance < 0 ? -distance : distance);
}

/* index: the element of an array, or -1. */
static void fail_floats(const char *what, float got, float want, long index, const char *file,
                        int line)
{
    if (index >= 0)
        print_error("element %ld: ", index);
    print_error("%s\n  got  %a (%.9g, bits %08x)\n  want %a (%.9g, bits %08x)\n  %.0f ULPs apart\n",
                what, (double)got, (double)got, (unsigned)bits_of(got), (double)want, (double)want,
                (unsigned)bits_of(want), ulp_distance(got, want));
    _fail(file, line);
}

static int same_bits(float got, float want)
{
    return bits_of(got) == bits_of(want) || (got != got && want != want);
}

/* Equal numbers, infinite ones too, are near whatever the bound. */
static int is_near(double got, double want, double bound)
{
    return got == want || fabs(got - want) <= bound;
}

void expect_bits_at(float got, float want, const char *file, int line)
{
    if (!same_bits(got, want))
        fail_floats("different bits", got, want, -1, file, line);
}

void expect_near_at(double got, double want, double bound, const char *file, int line)
{
    if (is_near(got, want, bound))
        return;
    print_error("not near\n  got  %a (%.17g)\n  want %a (%.17g)\n  off by %.3g, allowed %.3g\n",
                got, got, want, want, fabs(got - want), bound);
    _fail(file, line);
}

void expect_ulps_at(float got, float want, double ulps, const char *file, int line)
{
    int number = got == got && want == want;
    if (!number || ulp_distance(got, want) > ulps)
        fail_floats("too many ULPs", got, want, -1, file, line);
}

void expect_nan_at(float got, const char *file, int line)
{
    if (got == got)
        fail_floats("not a NaN", got, NAN, -1, file, line);
}

void expect_floats_bits_at(const float *got, const float *want, size_t count, const char *file,
                           int line)
{
    for (size_t i = 0; i < count; i++)
        if (!same_bits(got[i], want[i]))
            fail_floats("different bits", got[i], want[i], (long)i, file, line);
}

void expect_floats_near_at(const float *got, const float *want, size_t count, double bound,
                           const char *file, int line)
{
    for (size_t i = 0; i < count; i++)
        if (!is_near((double)got[i], (double)want[i], bound))
            fail_floats("not near", got[i], want[i], (long)i, file, line);
}

static void list_vec3(nkw_vec3 v, float *list)
{
    list[0] = v.x;
    list[1] = v.y;
    list[2] = v.z;
}

static void list_quat(nkw_quat q, float sign, float *list)
{
    list[0] = sign * q.x;
    list[1] = sign * q.y;
    list[2] = sign * q.z;
    list[3] = sign * q.w;
}

void expect_vec3_bits_at(nkw_vec3 got, nkw_vec3 want, const char *file, int line)
{
    float g[3], w[3];
    list_vec3(got, g);
    list_vec3(want, w);
    expect_floats_bits_at(g, w, 3, file, line);
}

void expect_vec3_near_at(nkw_vec3 got, nkw_vec3 want, double bound, const char *file, int line)
{
    float g[3], w[3];
    list_vec3(got, g);
    list_vec3(want, w);
    expect_floats_near_at(g, w, 3, bound, file, line);
}

void expect_quat_bits_at(nkw_quat got, nkw_quat want, const char *file, int line)
{
    float g[4], w[4];
    list_quat(got, 1.0f, g);
    list_quat(want, 1.0f, w);
    expect_floats_bits_at(g, w, 4, file, line);
}

void expect_quat_near_at(nkw_quat got, nkw_quat want, double bound, const char *file, int line)
{
    float g[4], w[4];
    list_quat(got, 1.0f, g);
    list_quat(want, 1.0f, w);
    expect_floats_near_at(g, w, 4, bound, file, line);
}

void expect_rotation_near_at(nkw_quat got, nkw_quat want, double bound, const char *file, int line)
{
    float g[4], w[4];
    float dot = (got.x * want.x + got.y * want.y) + (got.z * want.z + got.w * want.w);
    list_quat(got, 1.0f, g);
    list_quat(want, dot < 0.0f ? -1.0f : 1.0f, w);
    expect_floats_near_at(g, w, 4, bound, file, line);
}
