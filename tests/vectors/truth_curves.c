/* SPDX-License-Identifier: CC0-1.0 */
/* Cubic curves of numbers, glTF's CUBICSPLINE, Catmull-Rom over times, TCB tangents, cubic-bezier() of CSS. */
#include "truth.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <quadmath.h>

typedef void weights_of(wide t, wide w[4]);

static void hermite(wide t, wide w[4])
{
    wide s = 1 - t;
    w[0] = (1 + 2 * t) * s * s, w[1] = t * s * s, w[2] = t * t * (3 - 2 * t), w[3] = -t * t * s;
}

static void bezier(wide t, wide w[4])
{
    wide s = 1 - t;
    w[0] = s * s * s, w[1] = 3 * s * s * t, w[2] = 3 * s * t * t, w[3] = t * t * t;
}

static void bspline(wide t, wide w[4])
{
    wide s = 1 - t;
    w[0] = s * s * s / 6, w[1] = (4 - 6 * t * t + 3 * t * t * t) / 6;
    w[2] = (4 - 6 * s * s + 3 * s * s * s) / 6, w[3] = t * t * t / 6;
}

static void catmull_rom(wide t, wide w[4])
{
    wide h[4];
    hermite(t, h);
    w[0] = -h[1] / 2, w[1] = h[0] - h[3] / 2, w[2] = h[2] + h[1] / 2, w[3] = h[3] / 2;
}

static void cubic_case(const char *kind, const char *name, const char *check, weights_of *weights, const float *c,
                       float t)
{
    static const char *const names[4] = {"c0", "c1", "c2", "c3"};
    wide w[4], v[4], x;
    weights(t, w);
    wide_from(c, v, 4);
    x = wide_dot(w, v, 4);
    truth_case(kind, name, check);
    truth_scale(truth_size(c, 4) * (double)(fabsq(w[0]) + fabsq(w[1]) + fabsq(w[2]) + fabsq(w[3])));
    for (int i = 0; i < 4; i++)
        truth_in(names[i], c + i, 1);
    truth_in("t", &t, 1);
    truth_out("x", &x, 1);
}

static void cubic_group(const char *name, weights_of *weights, int has_ends)
{
    static const char *const lines[] = {"in c0 1", "in c1 1", "in c2 1", "in c3 1", "in t 1", "out x 1 near", NULL};
    static const float ends[7] = {0.0f, 1.0f, 0.5f, 0x1p-24f, 0x1.fffffep-1f, -0.5f, 1.5f};
    const float same[4] = {0.1f, weights == hermite ? 0.0f : 0.1f, 0.1f, weights == hermite ? 0.0f : 0.1f};
    const float far[4] = {1e7f, weights == hermite ? 1.0f : 1e7f, 10000001.0f, weights == hermite ? 1.0f : 10000001.0f};
    const float tiny[4] = {0x1p-140f, 0x1p-149f, -0x1p-141f, 0x1p-138f}, odd[4] = {1.0f, NAN, 2.0f, 3.0f};
    truth_group(name, lines, 8.0,
                "binary32 with a few roundings, times `size`: the control values times their weights");
    for (int i = 0; i < 8; i++) {
        float c[4];
        for (int k = 0; k < 4; k++)
            c[k] = random_between(truth_random(), -4.0f, 4.0f);
        cubic_case("ordinary", "random", NULL, weights, c, random_unit(truth_random()));
        if (i < 7)
            cubic_case("boundary", "t-at-and-near-the-ends",
                       has_ends && ends[i] == nearbyintf(ends[i]) ? "exact" : NULL, weights, c, ends[i]);
    }
    cubic_case("boundary", "constant", NULL, weights, same, 0.3f);
    cubic_case("hostile", "far-from-the-origin", NULL, weights, far, 0.3f);
    cubic_case("hostile", "subnormal", NULL, weights, tiny, 0.3f);
    cubic_case("hostile", "nan", NULL, weights, odd, 0.3f);
}

/* ---- glTF CUBICSPLINE ---- */

static void gltf_case(const char *kind, const char *name, const float times[2], const float k[4], float time)
{
    wide w[4], d = (wide)times[1] - times[0], t = d > 0 ? ((wide)time - times[0]) / d : 0, x;
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    hermite(t, w);
    x = w[0] * k[0] + w[1] * d * k[1] + w[2] * k[3] + w[3] * d * k[2];
    truth_case(kind, name, NULL);
    truth_scale(truth_size(k, 4) * fmax(1.0, (double)d));
    truth_in("times", times, 2);
    truth_in("value0", k, 1);
    truth_in("out0", k + 1, 1);
    truth_in("in1", k + 2, 1);
    truth_in("value1", k + 3, 1);
    truth_in("time", &time, 1);
    truth_out("x", &x, 1);
}

static void gltf_group(void)
{
    static const char *const lines[] = {"in times 2",  "in value0 1", "in out0 1",    "in in1 1",
                                        "in value1 1", "in time 1",   "out x 1 near", NULL};
    truth_group("gltf_cubicspline", lines, 16.0, "the rounding of t and of the duration too");
    for (int i = 0; i < 8; i++) {
        float times[2] = {random_between(truth_random(), 0.0f, 9.0f), 0.0f}, k[4];
        times[1] = times[0] + random_between(truth_random(), 0.01f, 3.0f);
        for (int j = 0; j < 4; j++)
            k[j] = random_between(truth_random(), -4.0f, 4.0f);
        gltf_case("ordinary", "random", times, k, nkw_lerp(times[0], times[1], random_unit(truth_random())));
        if (i < 2)
            gltf_case("boundary", "at-a-key", times, k, times[i]);
        if (i == 2) {
            gltf_case("boundary", "before-the-first-key", times, k, times[0] - 1.0f);
            gltf_case("boundary", "after-the-last-key", times, k, times[1] + 1.0f);
        }
    }
    const float two[2] = {0.0f, 2.0f}, unit[4] = {0.0f, 1.0f, 1.0f, 2.0f};
    gltf_case("hostile", "tangents-are-per-second", two, unit, 0.5f);
}

/* ---- Catmull-Rom over times, by Barry and Goldman's pyramid ---- */

static wide mixed(wide a, wide b, wide ta, wide tb, wide t)
{
    return ((tb - t) * a + (t - ta) * b) / (tb - ta);
}

static void pyramid_case(const char *kind, const char *name, const float times[4], const float p[4], float t)
{
    wide u = times[1] + (wide)t * ((wide)times[2] - times[1]);
    wide a = mixed(p[0], p[1], times[0], times[1], u), b = mixed(p[1], p[2], times[1], times[2], u);
    wide c = mixed(p[2], p[3], times[2], times[3], u);
    wide x = mixed(mixed(a, b, times[0], times[2], u), mixed(b, c, times[1], times[3], u), times[1], times[2], u);
    truth_case(kind, name, NULL);
    truth_scale(truth_size(p, 4) * 4.0);
    truth_in("times", times, 4);
    truth_in("values", p, 4);
    truth_in("t", &t, 1);
    truth_out("x", &x, 1);
}

static void pyramid_group(void)
{
    static const char *const lines[] = {"in times 4", "in values 4", "in t 1", "out x 1 near", NULL};
    const float even[4] = {0, 1, 2, 3}, uneven[4] = {0, 0.125f, 3.0f, 3.25f}, steps[4] = {0, 1, 1, 0};
    truth_group("catmull_rom_times", lines, 8.0, "t runs from 0 at times[1] to 1 at times[2]");
    for (int i = 0; i < 8; i++) {
        float times[4] = {0.0f}, p[4];
        for (int k = 0; k < 4; k++) {
            times[k] = k ? times[k - 1] + random_between(truth_random(), 0.2f, 2.0f) : 0.0f;
            p[k] = random_between(truth_random(), -4.0f, 4.0f);
        }
        pyramid_case("ordinary", "random", times, p, random_unit(truth_random()));
    }
    pyramid_case("boundary", "even-times", even, steps, 0.25f);
    pyramid_case("boundary", "t-is-0", uneven, steps, 0.0f);
    pyramid_case("hostile", "very-uneven-times", uneven, steps, 0.5f);
}

/* ---- Kochanek and Bartels ---- */

static void tcb_case(const char *kind, const char *name, const float times[3], const float p[3], const float tcb[3])
{
    wide h0 = (wide)times[1] - times[0], h1 = (wide)times[2] - times[1];
    wide d0 = ((wide)p[1] - p[0]) / h0, d1 = ((wide)p[2] - p[1]) / h1, t = 1 - (wide)tcb[0], c = tcb[1], b = tcb[2];
    wide before = t * ((1 - c) * (1 + b) * d0 * h0 + (1 + c) * (1 - b) * d1 * h1) / (h0 + h1);
    wide after = t * ((1 + c) * (1 + b) * d0 * h0 + (1 - c) * (1 - b) * d1 * h1) / (h0 + h1);
    truth_case(kind, name, NULL);
    truth_scale(4.0 * fmax(1.0, (double)fmaxq(fabsq(d0), fabsq(d1))));
    truth_in("times", times, 3);
    truth_in("values", p, 3);
    truth_in("tcb", tcb, 3);
    truth_out("before", &before, 1);
    truth_out("after", &after, 1);
}

static void tcb_group(void)
{
    static const char *const lines[] = {"in times 3",        "in values 3",      "in tcb 3",
                                        "out before 1 near", "out after 1 near", NULL};
    const float even[3] = {0, 1, 2}, uneven[3] = {0, 1, 4}, p[3] = {0, 1, 4};
    const float none[3] = {0, 0, 0}, tense[3] = {1, 0, 0}, corner[3] = {0, -1, 0}, biased[3] = {0, 0, 1};
    truth_group("tcb_tangents", lines, 4.0, "tangents per second before and after the middle key");
    for (int i = 0; i < 6; i++) {
        float times[3] = {0.0f}, values[3], tcb[3];
        for (int k = 0; k < 3; k++) {
            times[k] = k ? times[k - 1] + random_between(truth_random(), 0.2f, 2.0f) : 0.0f;
            values[k] = random_between(truth_random(), -4.0f, 4.0f);
            tcb[k] = random_between(truth_random(), -1.0f, 1.0f);
        }
        tcb_case("ordinary", "random", times, values, tcb);
    }
    tcb_case("boundary", "no-parameters-even-times", even, p, none);
    tcb_case("boundary", "no-parameters-uneven-times", uneven, p, none);
    tcb_case("boundary", "tension-1", uneven, p, tense);
    tcb_case("boundary", "continuity--1", uneven, p, corner);
    tcb_case("boundary", "bias-1", uneven, p, biased);
}

/* ---- cubic-bezier() of CSS: x(s) = t by bisection, then y(s) ---- */

static void css_case(const char *kind, const char *name, const float h[4], float t)
{
    wide low = 0, high = 1, w[4];
    for (int i = 0; i < 120; i++) {
        wide s = (low + high) / 2;
        bezier(s, w);
        if (w[1] * h[0] + w[2] * h[2] + w[3] < t)
            low = s;
        else
            high = s;
    }
    bezier(high, w);
    wide y = w[1] * h[1] + w[2] * h[3] + w[3];
    truth_case(kind, name, NULL);
    truth_scale(truth_size(h, 4));
    truth_in("x1", h, 1);
    truth_in("y1", h + 1, 1);
    truth_in("x2", h + 2, 1);
    truth_in("y2", h + 3, 1);
    truth_in("t", &t, 1);
    truth_out("y", &y, 1);
}

static void css_group(void)
{
    static const char *const lines[] = {"in x1 1", "in y1 1", "in x2 1", "in y2 1", "in t 1", "out y 1 near", NULL};
    static const float known[4][4] = {
        {0.25f, 0.1f, 0.25f, 1}, {0.42f, 0, 1, 1}, {0, 0, 0.58f, 1}, {0.42f, 0, 0.58f, 1}};
    static const char *const names[4] = {"ease", "ease-in", "ease-out", "ease-in-out"};
    const float steep[4] = {0, 1, 0, 1}, flat[4] = {1, 0, 1, 0}, wild[4] = {0.5f, -3.0f, 0.5f, 4.0f};
    truth_group("cubic_bezier", lines, 16.0, "where the curve is steep the rounding of the parameter counts");
    for (int i = 0; i < 4; i++)
        for (int k = 1; k < 8; k += 2)
            css_case("ordinary", names[i], known[i], (float)k / 8.0f);
    for (int i = 0; i < 6; i++) {
        float h[4];
        for (int k = 0; k < 4; k++)
            h[k] = k % 2 ? random_between(truth_random(), -0.5f, 1.5f) : random_between(truth_random(), 0.05f, 0.95f);
        css_case("ordinary", "random", h, random_unit(truth_random()));
    }
    css_case("boundary", "t-is-1", known[0], 1.0f);
    css_case("hostile", "vertical-at-the-start", steep, 0.001f);
    css_case("hostile", "vertical-at-the-end", flat, 0.75f);
    css_case("hostile", "far-handles", wild, 0.5f);
}

void truth_curves(const char *folder)
{
    static const char *const about[] = {
        "Cubic curves of numbers. t runs from 0 to 1 within the segment; outside, the cubic continues.",
        "hermite: value, tangent, value, tangent; tangents per segment, so dx/dt at t = 0 is c1.",
        "bezier, bspline, catmull_rom: four points; catmull_rom passes through c1 and c2.",
        "gltf_cubicspline: tangents per second, multiplied by the duration; clamped outside the keys (glTF 2.0, app. "
        "C).",
        "catmull_rom_times: key times, one curve between times[1] and times[2] (Barry, Goldman 1988).",
        "tcb_tangents: Kochanek, Bartels 1984, weighted for unequal durations; tcb is tension, continuity, bias.",
        "cubic_bezier: CSS Easing Functions, control points (x1, y1), (x2, y2).",
        NULL,
    };
    truth_open(folder, "curves", about);
    cubic_group("hermite", hermite, 1);
    cubic_group("bezier", bezier, 1);
    cubic_group("bspline", bspline, 0);
    cubic_group("catmull_rom", catmull_rom, 1);
    gltf_group();
    pyramid_group();
    tcb_group();
    css_group();
    truth_close();
}

#else
typedef int truth_curves_is_skipped;
#endif
