/* SPDX-License-Identifier: MIT */
/* Errors of the weights of <nakawari/blendspace.h> against binary128. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <quadmath.h>

#define SAMPLES 20000u

/* Seven samples of two parameters on a jittered grid, and a point. */
enum { COUNT = 7, NUMBERS = 2 * COUNT + 2 };

static void any(random_source *r, float *x)
{
    for (int i = 0; i < COUNT; i++) {
        x[2 * i] = (float)(i % 3) - 1.0f + random_between(r, -0.4f, 0.4f);
        x[2 * i + 1] = (float)(i / 3) - 1.0f + random_between(r, -0.4f, 0.4f);
    }
    x[2 * COUNT] = random_between(r, -2, 2);
    x[2 * COUNT + 1] = random_between(r, -2, 2);
}

static wide angle(const float *a, const float *b)
{
    return 2 * atan2q((wide)a[0] * b[1] - (wide)a[1] * b[0], (wide)a[0] * b[0] + (wide)a[1] * b[1]);
}

static wide length(const float *v)
{
    return sqrtq((wide)v[0] * v[0] + (wide)v[1] * v[1]);
}

static wide band(wide px, wide py, wide bx, wide by)
{
    return 1 - (px * bx + py * by) / (bx * bx + by * by);
}

static wide polar(const float *p, const float *a, const float *b)
{
    wide la = length(a), mean = (la + length(b)) / 2, to = angle(a, b), at = angle(a, p);
    wide dl = (length(b) - la) / mean, pl = (length(p) - la) / mean, turn = 4 * wide_pi();
    wide h = band(pl, at, dl, to), other = band(pl, at, dl, to > 0 ? to - turn : to + turn);
    return fabsq(to) >= wide_pi() && other < h ? other : h;
}

static double weight_error(const float *x, nkw_blendspace_kind kind)
{
    const nkw_blendspace space = {x, COUNT, 2, kind};
    const float *p = x + 2 * COUNT;
    float got[COUNT];
    wide h[COUNT], sum = 0;
    double worst = 0.0;
    nkw_blendspace_weights(&space, p, got);
    for (int i = 0; i < COUNT; i++) {
        const float *a = x + 2 * i;
        h[i] = 1;
        for (int j = 0; j < COUNT; j++) {
            const float *b = x + 2 * j;
            wide w = kind == NKW_BLENDSPACE_POLAR
                         ? polar(p, a, b)
                         : band((wide)p[0] - a[0], (wide)p[1] - a[1], (wide)b[0] - a[0], (wide)b[1] - a[1]);
            h[i] = j != i && w < h[i] ? w : h[i];
        }
        h[i] = h[i] > 0 ? h[i] : 0;
        sum += h[i];
    }
    for (int i = 0; i < COUNT; i++)
        worst = fmax(worst, (double)fabsq(got[i] - h[i] / sum) * 0x1p24);
    return worst;
}

static double cartesian_error(const float *x)
{
    return weight_error(x, NKW_BLENDSPACE_CARTESIAN);
}

static double polar_error(const float *x)
{
    return weight_error(x, NKW_BLENDSPACE_POLAR);
}

static const wide_case cases[] = {
    {"nkw_blendspace_weights", "7 samples, Cartesian", any, cartesian_error, NUMBERS, WIDE_CHECKED},
    {"nkw_blendspace_weights", "7 samples, polar", any, polar_error, NUMBERS, WIDE_CHECKED},
};

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("blendspace.h", argc, argv);
    wide_search(&a, cases, sizeof cases / sizeof cases[0], SAMPLES);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
