/* SPDX-License-Identifier: MIT */
/* Errors of <nakawari/morph.h> against binary128. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <quadmath.h>
#include <string.h>

#define TARGETS 4

/* v, then d and w of each target, of one size or of many. */
static void one_size(random_source *r, float *x)
{
    for (int i = 0; i < 1 + 2 * TARGETS; i++)
        x[i] = random_between(r, -1.0f, 1.0f);
}

static void many_sizes(random_source *r, float *x)
{
    for (int i = 0; i < 1 + 2 * TARGETS; i++)
        x[i] = random_scaled(r, -8, 8);
}

/* Of one component and `count` targets, divided by count + 1. */
static double morph_error(const float *x, size_t count)
{
    nkw_morph_target targets[TARGETS];
    nkw_vec3 deltas[TARGETS], v = {x[0], 0, 0}, got;
    float weights[TARGETS];
    wide want = x[0], size = fabsq((wide)x[0]);
    memset(targets, 0, sizeof targets);
    for (size_t k = 0; k < count; k++) {
        nkw_vec3 delta = {x[1 + 2 * k], 0, 0};
        deltas[k] = delta;
        weights[k] = x[2 + 2 * k];
        targets[k].deltas.positions.data = &deltas[k].x;
        want += (wide)x[1 + 2 * k] * x[2 + 2 * k];
        size += fabsq((wide)x[1 + 2 * k] * x[2 + 2 * k]);
    }
    nkw_morph morph = {targets, count, 1};
    nkw_vertices_view in;
    nkw_vertices_span out;
    memset(&in, 0, sizeof in);
    memset(&out, 0, sizeof out);
    in.positions.data = &v.x;
    out.positions.data = &got.x;
    nkw_morph_apply(&morph, weights, in, out);
    return wide_error_of(&got.x, &want, 1, size) / (double)(count + 1);
}

static double of_one(const float *x)
{
    return morph_error(x, 1);
}

static double of_four(const float *x)
{
    return morph_error(x, TARGETS);
}

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("morph.h", argc, argv);
    static const wide_case cases[] = {
        {"nkw_morph_apply", "one target, / 2", one_size, of_one, 3, WIDE_CHECKED},
        {"nkw_morph_apply", "one target of any size, / 2", many_sizes, of_one, 3, WIDE_CHECKED},
        {"nkw_morph_apply", "four targets, / 5", one_size, of_four, 9, WIDE_CHECKED},
    };
    wide_search(&a, cases, sizeof cases / sizeof *cases, 20000);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
