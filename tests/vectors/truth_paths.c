/* SPDX-License-Identifier: CC0-1.0 */
/* Between two rotations: slerp, nlerp, paths with whole turns, angular velocity. */
#include "truth.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <quadmath.h>
#include <string.h>

/* q(t) along the path and k turns more; straight: by the angle of the straight line. */
static void arc_at(const float a[4], const float b[4], float t, int path, int turns, int straight, wide out[4])
{
    wide u[4], v[4], e[4];
    wide_from(a, u, 4);
    wide_from(b, v, 4);
    truth_align(u, v, path);
    wide_normalize(u, 4);
    wide_normalize(v, 4);
    wide cosine = wide_dot(u, v, 4);
    for (int i = 0; i < 4; i++)
        e[i] = v[i] - cosine * u[i];
    wide sine = wide_length(e, 4), h = atan2q(sine, cosine);
    if (sine > 0)
        wide_normalize(e, 4);
    wide angle = straight ? atan2q(t * sine, (1 - (wide)t) + t * cosine) : t * h;
    angle += wide_pi() * ((wide)t * turns);
    for (int i = 0; i < 4; i++)
        out[i] = cosq(angle) * u[i] + sinq(angle) * e[i];
}

static void between(const char *kind, const char *name, const char *check, const float a[4], const float b[4], float t,
                    int straight)
{
    wide q[4];
    arc_at(a, b, t, 0, 0, straight, q);
    truth_case(kind, name, check);
    truth_in("a", a, 4);
    truth_in("b", b, 4);
    truth_in("t", &t, 1);
    truth_out("q", q, 4);
}

static void with_path(const char *kind, const char *name, const float a[4], const float b[4], float t, int path,
                      int turns, int straight)
{
    wide q[4];
    float p = (float)path, k = (float)turns;
    arc_at(a, b, t, path, turns, straight, q);
    truth_case(kind, name, NULL);
    truth_in("a", a, 4);
    truth_in("b", b, 4);
    truth_in("t", &t, 1);
    truth_in("path", &p, 1);
    truth_in("turns", &k, 1);
    truth_out("q", q, 4);
}

static void negated(const float q[4], float out[4])
{
    for (int i = 0; i < 4; i++)
        out[i] = -q[i];
}

static void short_group(const char *name, int straight, double units)
{
    static const char *const lines[] = {"in a 4", "in b 4", "in t 1", "out q 4 sign", NULL};
    float a[4], b[4], n[4], c[4];
    truth_group(name, lines, units, "binary32 with the angle from the chord; the shorter arc, whatever the signs");
    for (int k = 0; k < 10; k++) {
        truth_some_turn(a);
        truth_some_turn(b);
        between("ordinary", "random", NULL, a, b, random_unit(truth_random()), straight);
    }
    static const float degrees[5] = {0.01f, 1.0f, 45.0f, 90.0f, 170.0f};
    truth_turn(1, 2, 3, 40, a);
    for (int k = 0; k < 5; k++) {
        truth_turn(0, 0, 1, degrees[k], b);
        truth_turn(0, 0, 1, 0, c);
        between("ordinary", "about-z", NULL, c, b, 0.3f, straight);
    }
    truth_some_turn(b);
    negated(b, n);
    between("boundary", "t-is-0", NULL, a, b, 0.0f, straight);
    between("boundary", "t-is-1", NULL, a, b, 1.0f, straight);
    between("boundary", "one-key-negated-is-the-same", NULL, a, n, 0.3f, straight);
    between("boundary", "equal", NULL, a, a, 0.3f, straight);
    negated(a, n);
    between("hostile", "opposite-signs-of-one-rotation", NULL, a, n, 0.3f, straight);
    truth_turn(0, 0, 1, 0.0001f, b);
    between("hostile", "nearly-equal", NULL, c, b, 0.5f, straight);
    truth_turn(0, 0, 1, 180, b);
    between("hostile", "half-a-turn-either-arc", "unit", c, b, 0.5f, straight);
    n[0] = NAN;
    between("hostile", "nan", "nan", a, n, 0.5f, straight);
}

static void path_group(const char *name, int straight, double units)
{
    static const char *const lines[] = {"in a 4", "in b 4", "in t 1", "in path 1", "in turns 1", "out q 4 sign", NULL};
    float a[4], b[4];
    truth_group(name, lines, units,
                "path 0 short, 1 long, 2 as the signs are; turns: whole turns more, about the same axis");
    for (int k = 0; k < 9; k++) {
        truth_some_turn(a);
        truth_some_turn(b);
        with_path("ordinary", "random", a, b, random_unit(truth_random()), k % 3, 0, straight);
        with_path("ordinary", "random-with-turns", a, b, random_unit(truth_random()), k % 3, k - 4, straight);
    }
    truth_turn(0, 0, 1, 0, a);
    truth_turn(0, 0, 1, 60, b);
    with_path("boundary", "short-60-degrees-half-way-30", a, b, 0.5f, 0, 0, straight);
    with_path("boundary", "long-300-degrees-half-way--150", a, b, 0.5f, 1, 0, straight);
    with_path("boundary", "one-turn-more-half-way-210", a, b, 0.5f, 0, 1, straight);
    with_path("boundary", "t-is-1", a, b, 1.0f, 0, 3, straight);
    with_path("hostile", "a-million-turns-at-a-quarter", a, b, 0.25f, 0, 1000000, straight);
    with_path("hostile", "a-million-turns-back", a, b, 0.3f, 1, -1000000, straight);
    negated(b, b);
    with_path("hostile", "as-given-with-a-negated-key-is-long", a, b, 0.5f, 2, 0, straight);
}

static void velocity(const char *kind, const char *name, const float a[4], const float b[4], float duration)
{
    wide p[4], q[4], v[3];
    wide_from(a, p, 4);
    wide_from(b, q, 4);
    wide_normalize(p, 4);
    wide_normalize(q, 4);
    truth_align(p, q, 0);
    truth_inverse(p, p);
    wide_quat_mul(q, p, q);
    wide_quat_log(q, v);
    wide_scale(v, duration == 0 ? 0 : 2 / (wide)duration, 3);
    truth_case(kind, name, NULL);
    truth_scale((double)wide_length(v, 3));
    truth_in("a", a, 4);
    truth_in("b", b, 4);
    truth_in("duration", &duration, 1);
    truth_out("velocity", v, 3);
}

static void velocities(void)
{
    static const char *const lines[] = {"in a 4", "in b 4", "in duration 1", "out velocity 3 near", NULL};
    float a[4], b[4];
    truth_group("angular_velocity", lines, 8.0, "radians per second in the frame of a and b, along the shorter arc");
    for (int k = 0; k < 8; k++) {
        truth_some_turn(a);
        truth_some_turn(b);
        velocity("ordinary", "random", a, b, random_between(truth_random(), 0.01f, 3.0f));
    }
    truth_turn(0, 0, 1, 0, a);
    truth_turn(0, 0, 1, 90, b);
    velocity("boundary", "a-quarter-turn-about-z-in-two-seconds", a, b, 2.0f);
    velocity("boundary", "no-motion", a, a, 1.0f);
    velocity("hostile", "no-duration-no-velocity", a, b, 0.0f);
}

void truth_paths(const char *folder)
{
    static const char *const about[] = {
        "From one rotation to another. Quaternions x y z w, unit to rounding. t from 0 to 1.",
        "slerp and nlerp take the shorter arc: b is negated (all four components) if a.b < 0.",
        "slerp_path and nlerp_path: with g the angle of the rotation along the path, the whole angle is g + 2 pi "
        "turns.",
        "nlerp: normalize((1 - t) a + t b); with turns, these advance linearly.",
        "Results marked `sign` are compared up to the sign of the whole quaternion.",
        NULL,
    };
    truth_open(folder, "paths", about);
    short_group("slerp", 0, 8.0);
    short_group("nlerp", 1, 8.0);
    path_group("slerp_path", 0, 8.0);
    path_group("nlerp_path", 1, 8.0);
    velocities();
    truth_close();
}

#else
typedef int truth_paths_is_skipped;
#endif
