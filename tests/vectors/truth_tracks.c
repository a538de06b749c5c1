/* SPDX-License-Identifier: CC0-1.0 */
/* Samplers of files: rotations of glTF, keys with handles in time, tangents from keys. */
#include "truth.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <quadmath.h>
#include <string.h>

/* ---- glTF rotations between two keys ---- */

static wide parameter(const float times[2], float time)
{
    wide t = ((wide)time - times[0]) / ((wide)times[1] - times[0]);
    return t < 0 ? 0 : t > 1 ? 1 : t;
}

/* Keys: value, out-tangent, in-tangent, value. */
static void cubic_case(const char *kind, const char *name, const float times[2], const float k[16], float time)
{
    wide t = parameter(times, time), s = 1 - t, d = (wide)times[1] - times[0], q[4];
    for (int i = 0; i < 4; i++)
        q[i] = (1 + 2 * t) * s * s * k[i] + t * s * s * d * k[4 + i] + t * t * (3 - 2 * t) * k[12 + i] -
               t * t * s * d * k[8 + i];
    wide length = wide_length(q, 4);
    wide_normalize(q, 4);
    truth_case(kind, name, NULL);
    truth_scale((1.0 + truth_size(k, 16) * (double)d) / (double)length);
    truth_in("times", times, 2);
    truth_in("value0", k, 4);
    truth_in("out0", k + 4, 4);
    truth_in("in1", k + 8, 4);
    truth_in("value1", k + 12, 4);
    truth_in("time", &time, 1);
    truth_out("q", q, 4);
}

static void cubic_group(void)
{
    static const char *const lines[] = {"in times 2",  "in value0 4", "in out0 4",    "in in1 4",
                                        "in value1 4", "in time 1",   "out q 4 sign", NULL};
    const float times[2] = {1.0f, 3.0f};
    float k[16] = {0};
    truth_group("gltf_rotation_cubicspline", lines, 8.0, "four Hermite curves, then normalised; signs are not changed");
    for (int i = 0; i < 8; i++) {
        wide q[4];
        truth_some_turn(k);
        put_quat(k + 12, random_near(truth_random(), quat_at(k), 0.8f));
        wide_from(k + 12, q, 4);
        wide_normalize(q, 4);
        wide_round(q, k + 12, 4);
        for (int j = 4; j < 12; j++)
            k[j] = random_between(truth_random(), -0.3f, 0.3f);
        cubic_case("ordinary", "random", times, k, random_between(truth_random(), 1.0f, 3.0f));
    }
    cubic_case("boundary", "at-the-first-key", times, k, 1.0f);
    cubic_case("boundary", "after-the-last-key", times, k, 4.0f);
    memset(k, 0, sizeof k);
    truth_turn(0, 0, 1, 0, k);
    truth_turn(0, 0, 1, 90, k + 12);
    cubic_case("boundary", "90-degrees-at-rest-half-way-45", times, k, 2.0f);
    for (int i = 12; i < 16; i++)
        k[i] = -k[i];
    cubic_case("hostile", "the-same-with-a-negated-key-half-way--135", times, k, 2.0f);
}

static void linear_case(const char *kind, const char *name, const float times[2], const float k[8], float time)
{
    wide a[4], b[4], q[4];
    wide_from(k, a, 4);
    wide_from(k + 4, b, 4);
    truth_align(a, b, 0);
    wide_slerp(a, b, parameter(times, time), q);
    truth_case(kind, name, NULL);
    truth_in("times", times, 2);
    truth_in("value0", k, 4);
    truth_in("value1", k + 4, 4);
    truth_in("time", &time, 1);
    truth_out("q", q, 4);
}

static void linear_group(void)
{
    static const char *const lines[] = {"in times 2", "in value0 4", "in value1 4", "in time 1", "out q 4 sign", NULL};
    const float times[2] = {1.0f, 3.0f};
    float k[8];
    truth_group("gltf_rotation_linear", lines, 8.0, "slerp along the shorter arc, with the rounding of t");
    for (int i = 0; i < 8; i++) {
        truth_some_turn(k);
        truth_some_turn(k + 4);
        linear_case("ordinary", "random", times, k, random_between(truth_random(), 1.0f, 3.0f));
    }
    linear_case("boundary", "before-the-first-key", times, k, 0.0f);
    truth_turn(0, 0, 1, 0, k);
    truth_turn(0, 0, 1, 90, k + 4);
    for (int i = 4; i < 8; i++)
        k[i] = -k[i];
    linear_case("hostile", "a-negated-key-takes-the-shorter-arc-half-way-45", times, k, 2.0f);
}

/* ---- A segment with handles in time: four points (time, value) of a Bezier curve ---- */

static wide bezier(const float p[4], wide s)
{
    wide r = 1 - s;
    return r * r * r * p[0] + 3 * r * r * s * p[1] + 3 * r * s * s * p[2] + s * s * s * p[3];
}

static void handle_case(const char *kind, const char *name, const float times[4], const float values[4], float time)
{
    wide low = 0, high = 1;
    for (int i = 0; i < 120; i++) {
        wide s = (low + high) / 2;
        if (bezier(times, s) < time)
            low = s;
        else
            high = s;
    }
    wide x = bezier(values, high);
    truth_case(kind, name, NULL);
    truth_scale(truth_size(values, 4));
    truth_in("times", times, 4);
    truth_in("values", values, 4);
    truth_in("time", &time, 1);
    truth_out("x", &x, 1);
}

static void handle_group(void)
{
    static const char *const lines[] = {"in times 4", "in values 4", "in time 1", "out x 1 near", NULL};
    const float even[4] = {0, 1, 2, 3}, thin[4] = {0, 0.0625f, 2.9375f, 3}, crossed[4] = {0, 3, 0, 3};
    const float values[4] = {0, 2, -1, 1};
    truth_group("handles", lines, 32.0, "the parameter is found to a few ULPs of the time; the curve is steep there");
    for (int i = 0; i < 8; i++) {
        float t[4] = {0, 0, 0, 4}, v[4];
        t[1] = random_between(truth_random(), 0.1f, 2.5f);
        t[2] = 4.0f - random_between(truth_random(), 0.1f, 2.5f);
        for (int k = 0; k < 4; k++)
            v[k] = random_between(truth_random(), -4.0f, 4.0f);
        handle_case("ordinary", "random", t, v, random_between(truth_random(), 0.1f, 3.9f));
    }
    handle_case("boundary", "handles-at-a-third-are-hermite", even, values, 0.75f);
    handle_case("boundary", "at-the-first-key", thin, values, 0.0f);
    handle_case("hostile", "short-handles", thin, values, 0.01f);
    handle_case("hostile", "handles-that-reach-the-other-key", crossed, values, 1.4f);
}

/* ---- Tangents of five keys ---- */

enum { KEYS = 5 };

static void slopes_of(const float t[KEYS], const float p[KEYS], wide h[KEYS - 1], wide d[KEYS - 1])
{
    for (int i = 0; i + 1 < KEYS; i++) {
        h[i] = (wide)t[i + 1] - t[i];
        d[i] = ((wide)p[i + 1] - p[i]) / h[i];
    }
}

static wide pchip_end(wide h0, wide h1, wide d0, wide d1)
{
    wide v = ((2 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
    if (v * d0 <= 0)
        return 0;
    return d0 * d1 <= 0 && fabsq(v) > 3 * fabsq(d0) ? 3 * d0 : v;
}

static void pchip(const wide *h, const wide *d, wide m[KEYS])
{
    m[0] = pchip_end(h[0], h[1], d[0], d[1]);
    m[KEYS - 1] = pchip_end(h[KEYS - 2], h[KEYS - 3], d[KEYS - 2], d[KEYS - 3]);
    for (int i = 1; i + 1 < KEYS; i++) {
        wide w0 = 2 * h[i] + h[i - 1], w1 = h[i] + 2 * h[i - 1];
        m[i] = d[i - 1] * d[i] <= 0 ? 0 : (w0 + w1) / (w0 / d[i - 1] + w1 / d[i]);
    }
}

static void akima(const wide *h, const wide *d, wide m[KEYS])
{
    wide e[KEYS + 3];
    (void)h;
    memcpy(e + 2, d, (KEYS - 1) * sizeof *d);
    e[1] = 2 * e[2] - e[3];
    e[0] = 2 * e[1] - e[2];
    e[KEYS + 1] = 2 * e[KEYS] - e[KEYS - 1];
    e[KEYS + 2] = 2 * e[KEYS + 1] - e[KEYS];
    for (int i = 0; i < KEYS; i++) {
        wide w0 = fabsq(e[i + 3] - e[i + 2]), w1 = fabsq(e[i + 1] - e[i]);
        m[i] = w0 + w1 > 0 ? (w0 * e[i + 1] + w1 * e[i + 2]) / (w0 + w1) : (e[i + 1] + e[i + 2]) / 2;
    }
}

/* Continuous acceleration, 0 at both ends, by Thomas' elimination. */
static void natural(const wide *h, const wide *d, wide m[KEYS])
{
    wide diagonal[KEYS], right[KEYS], upper[KEYS];
    diagonal[0] = 2, upper[0] = 1, right[0] = 3 * d[0];
    for (int i = 1; i < KEYS; i++) {
        int last = i + 1 == KEYS;
        wide lower = last ? 1 : h[i];
        wide middle = last ? 2 : 2 * (h[i - 1] + h[i]);
        upper[i] = last ? 0 : h[i - 1];
        right[i] = last ? 3 * d[i - 1] : 3 * (h[i] * d[i - 1] + h[i - 1] * d[i]);
        wide factor = lower / diagonal[i - 1];
        diagonal[i] = middle - factor * upper[i - 1];
        right[i] -= factor * right[i - 1];
    }
    for (int i = KEYS - 1; i >= 0; i--)
        m[i] = (right[i] - (i + 1 < KEYS ? upper[i] * m[i + 1] : 0)) / diagonal[i];
}

typedef void tangents_of(const wide *h, const wide *d, wide m[KEYS]);

static void tangents_case(const char *kind, const char *name, tangents_of *f, const float *t, const float *p)
{
    wide h[KEYS - 1], d[KEYS - 1], m[KEYS];
    double largest = 1.0;
    slopes_of(t, p, h, d);
    f(h, d, m);
    for (int i = 0; i + 1 < KEYS; i++)
        largest = fmax(largest, (double)fabsq(d[i]));
    truth_case(kind, name, NULL);
    truth_scale(2.0 * largest);
    truth_in("times", t, KEYS);
    truth_in("values", p, KEYS);
    truth_out("tangents", m, KEYS);
}

static void tangents_group(const char *name, tangents_of *f, const char *reason)
{
    static const char *const lines[] = {"in times 5", "in values 5", "out tangents 5 near", NULL};
    const float even[KEYS] = {0, 1, 2, 3, 4}, line[KEYS] = {1, 3, 5, 7, 9}, step[KEYS] = {0, 0, 0, 1, 1};
    const float uneven[KEYS] = {0, 0.0625f, 1, 8, 8.5f}, bumps[KEYS] = {0, 1, -1, 2, 2};
    truth_group(name, lines, 8.0, reason);
    for (int i = 0; i < 6; i++) {
        float t[KEYS] = {0}, p[KEYS];
        for (int k = 0; k < KEYS; k++) {
            t[k] = k ? t[k - 1] + random_between(truth_random(), 0.2f, 2.0f) : 0.0f;
            p[k] = random_between(truth_random(), -4.0f, 4.0f);
        }
        tangents_case("ordinary", "random", f, t, p);
    }
    tangents_case("boundary", "a-line", f, even, line);
    tangents_case("boundary", "a-step", f, even, step);
    tangents_case("hostile", "very-uneven-times", f, uneven, bumps);
}

void truth_tracks(const char *folder)
{
    static const char *const about[] = {
        "Samplers of files. Quaternions x y z w. Times in seconds; outside the keys the end keys hold.",
        "gltf_rotation_linear: slerp along the shorter arc. gltf_rotation_cubicspline: Hermite curves of the "
        "components,",
        "tangents per second, normalised; no key is negated, so keys of opposite signs take the longer way (glTF 2.0, "
        "app. C).",
        "handles: the Bezier segment of four points (time, value); the value where its time is `time` (Blender, Maya, "
        "USD).",
        "pchip, akima, natural: tangents per second at five keys. pchip as SciPy's PchipInterpolator; akima as in "
        "1970, with",
        "extrapolated slopes; natural: the C2 cubic spline without acceleration at its ends.",
        NULL,
    };
    truth_open(folder, "tracks", about);
    linear_group();
    cubic_group();
    handle_group();
    tangents_group("pchip", pchip, "a few roundings of slopes");
    tangents_group("akima", akima, "differences of slopes, which cancel");
    tangents_group("natural", natural, "a tridiagonal system");
    truth_close();
}

#else
typedef int truth_tracks_is_skipped;
#endif
