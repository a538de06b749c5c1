/* SPDX-License-Identifier: CC0-1.0 */
/* Smooth curves of rotations with angular velocity and acceleration, by differences in binary128. */
#include "truth.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <quadmath.h>
#include <string.h>

/* A curve of rotations over t, from four quaternions and two velocities. */
typedef struct spline {
    wide q[4][4], v[2][3], duration;
} spline;

typedef void curve(const spline *s, wide t, wide q[4]);

static void slerp_wide(const wide a[4], const wide b[4], wide t, wide out[4])
{
    wide v[3], turn[4];
    truth_inverse(a, turn);
    wide_quat_mul(turn, b, turn);
    wide_quat_log(turn, v);
    memcpy(turn, a, sizeof turn);
    truth_append(turn, v, t);
    memcpy(out, turn, sizeof turn);
}

/* k exp(-(log(k^-1 next) + log(k^-1 previous))/4). */
static void inner(const wide before[4], const wide key[4], const wide after[4], wide out[4])
{
    wide on[3], from[3];
    truth_chord(key, after, on);
    truth_chord(key, before, from);
    for (int i = 0; i < 3; i++)
        on[i] += from[i];
    memcpy(out, key, 4 * sizeof *key);
    truth_append(out, on, (wide)-0.25);
}

static void squad(const spline *s, wide t, wide q[4])
{
    wide a[4], b[4], s1[4], s2[4], outside[4], inside[4];
    memcpy(a, s->q[1], sizeof a);
    memcpy(b, s->q[2], sizeof b);
    truth_align(a, b, 0);
    inner(s->q[0], a, b, s1);
    inner(a, b, s->q[3], s2);
    slerp_wide(a, b, t, outside);
    slerp_wide(s1, s2, t, inside);
    slerp_wide(outside, inside, 2 * t * (1 - t), q);
}

static void bspline(const spline *s, wide t, wide q[4])
{
    wide r = 1 - t, b[3] = {1 - r * r * r / 6, (1 + 3 * t + 3 * t * t - 2 * t * t * t) / 6, t * t * t / 6};
    memcpy(q, s->q[0], 4 * sizeof *q);
    for (int i = 0; i < 3; i++) {
        wide v[3];
        truth_chord(s->q[i], s->q[i + 1], v);
        truth_append(q, v, b[i]);
    }
}

/* Half of duration/3 times the velocity, in the frame of q. */
static void half_third(const spline *s, int i, const wide q[4], wide out[3])
{
    wide v[4] = {s->v[i][0], s->v[i][1], s->v[i][2], 0}, back[4];
    wide_scale(v, s->duration / 6, 3);
    truth_inverse(q, back);
    wide_quat_mul(back, v, v);
    wide_quat_mul(v, q, v);
    memcpy(out, v, 3 * sizeof *v);
}

static void hermite(const spline *s, wide t, wide q[4])
{
    wide u[3], w[3], m[3], rest[3], left[4], right[4] = {0, 0, 0, 1}, r = 1 - t;
    half_third(s, 0, s->q[0], u);
    half_third(s, 1, s->q[1], w);
    for (int i = 0; i < 3; i++)
        m[i] = (u[i] + w[i]) / 2;
    memcpy(left, s->q[0], sizeof left);
    truth_append(left, u, 1);
    truth_append(left, m, 1);
    truth_append(right, w, -1);
    wide_quat_mul(s->q[1], right, right);
    truth_chord(left, right, rest);
    memcpy(q, s->q[0], 4 * sizeof *q);
    truth_append(q, u, 1 - r * r * r);
    truth_append(q, m, t * t * (3 - 2 * t));
    truth_append(q, rest, t * t * (3 - 2 * t));
    truth_append(q, w, t * t * t);
}

#define NEAR ((wide)0x1p-30)
#define FAR  ((wide)0x1p-17)

static void velocity_at(curve *c, const spline *s, wide t, wide v[3])
{
    wide low[4], high[4];
    c(s, t - NEAR, low);
    c(s, t + NEAR, high);
    truth_inverse(low, low);
    wide_quat_mul(high, low, high);
    wide_scale(high, high[3] < 0 ? -1 : 1, 4);
    wide_quat_log(high, v);
    wide_scale(v, 1 / (NEAR * s->duration), 3);
}

static void outputs(curve *c, const spline *s, wide t)
{
    wide q[4], v[3], low[3], a[3];
    c(s, t, q);
    velocity_at(c, s, t, v);
    velocity_at(c, s, t - FAR, low);
    velocity_at(c, s, t + FAR, a);
    for (int i = 0; i < 3; i++)
        a[i] = (a[i] - low[i]) / (2 * FAR * s->duration);
    truth_out("q", q, 4);
    truth_out("velocity", v, 3);
    truth_out("acceleration", a, 3);
}

static void normalized(const float *x, wide q[4])
{
    wide_from(x, q, 4);
    wide_normalize(q, 4);
}

/* The largest angle between neighbouring control values, radians. */
static double spread_of(const spline *s)
{
    wide largest = 0, v[3];
    for (int i = 0; i < 3; i++) {
        truth_chord(s->q[i], s->q[i + 1], v);
        largest = fmaxq(largest, 2 * wide_length(v, 3));
    }
    return (double)largest;
}

/* Of a curve that turns at most `angle` radians per segment, and of the rounding of its keys. */
static void put_sizes(double angle, double duration)
{
    const double rate = (1.0 + angle) / duration;
    const double sizes[3] = {1.0 + angle, rate, rate * rate + 4.0 * rate / duration};
    truth_sizes(sizes, 3);
}

static void four_case(const char *kind, const char *name, curve *c, const float k[16], float duration, float t)
{
    spline s = {.duration = duration};
    for (int i = 0; i < 4; i++)
        normalized(k + 4 * i, s.q[i]);
    truth_case(kind, name, NULL);
    put_sizes(4.0 * spread_of(&s), (double)duration);
    truth_in("q0", k, 4);
    truth_in("q1", k + 4, 4);
    truth_in("q2", k + 8, 4);
    truth_in("q3", k + 12, 4);
    truth_in("duration", &duration, 1);
    truth_in("t", &t, 1);
    outputs(c, &s, t);
}

static void draw_keys(float k[16], float angle)
{
    truth_some_turn(k);
    for (int i = 1; i < 4; i++) {
        wide q[4];
        put_quat(k + 4 * i, random_near(truth_random(), quat_at(k + 4 * i - 4), angle * random_unit(truth_random())));
        normalized(k + 4 * i, q);
        wide_round(q, k + 4 * i, 4);
    }
}

static void four_group(const char *name, curve *c)
{
    static const char *const lines[] = {"in q0 4",
                                        "in q1 4",
                                        "in q2 4",
                                        "in q3 4",
                                        "in duration 1",
                                        "in t 1",
                                        "out q 4 sign",
                                        "out velocity 3 near",
                                        "out acceleration 3 near",
                                        NULL};
    float k[16];
    truth_group(name, lines, 8.0,
                "binary64 inside and one rounding; more for binary32; `size` is of each result: the angle, its rate, "
                "the change of that");
    for (int i = 0; i < 8; i++) {
        draw_keys(k, 0.6f);
        four_case("ordinary", "random", c, k, random_between(truth_random(), 0.5f, 2.0f), random_unit(truth_random()));
    }
    four_case("boundary", "t-is-0", c, k, 1.0f, 0.0f);
    four_case("boundary", "t-is-1", c, k, 1.0f, 1.0f);
    for (int i = 0; i < 4; i++)
        truth_turn(0, 1, 0, 30.0f * (float)i, k + 4 * i);
    four_case("boundary", "steady-turn-about-y", c, k, 1.0f, 0.4f);
    for (int i = 0; i < 4; i++)
        k[4 + i] = -k[4 + i];
    four_case("hostile", "one-key-negated-is-the-same", c, k, 1.0f, 0.4f);
    draw_keys(k, 0.001f);
    four_case("hostile", "nearly-equal-keys", c, k, 1.0f, 0.4f);
}

static void hermite_case(const char *kind, const char *name, const float k[8], const float v[6], float duration,
                         float t)
{
    spline s = {.duration = duration};
    normalized(k, s.q[0]);
    normalized(k + 4, s.q[1]);
    wide_from(v, s.v[0], 3);
    wide_from(v + 3, s.v[1], 3);
    truth_case(kind, name, NULL);
    put_sizes(truth_size(v, 6) * (double)duration + 4.0, (double)duration);
    truth_in("a", k, 4);
    truth_in("velocity_a", v, 3);
    truth_in("b", k + 4, 4);
    truth_in("velocity_b", v + 3, 3);
    truth_in("duration", &duration, 1);
    truth_in("t", &t, 1);
    outputs(hermite, &s, t);
}

static void hermite_group(void)
{
    static const char *const lines[] = {"in a 4",
                                        "in velocity_a 3",
                                        "in b 4",
                                        "in velocity_b 3",
                                        "in duration 1",
                                        "in t 1",
                                        "out q 4 sign",
                                        "out velocity 3 near",
                                        "out acceleration 3 near",
                                        NULL};
    float k[16], v[6];
    truth_group("rotation_hermite", lines, 8.0, "as squad; the velocities state the number of turns");
    for (int i = 0; i < 8; i++) {
        draw_keys(k, 0.5f);
        put_vec3(v, random_vec3(truth_random(), -1.0f, 1.0f));
        put_vec3(v + 3, random_vec3(truth_random(), -1.0f, 1.0f));
        hermite_case("ordinary", "random", k, v, random_between(truth_random(), 0.5f, 1.5f),
                     random_unit(truth_random()));
    }
    hermite_case("boundary", "t-is-0", k, v, 1.0f, 0.0f);
    hermite_case("boundary", "t-is-1", k, v, 1.0f, 1.0f);
    const float wheel[6] = {0, 33.25f, 0, 0, 33.25f, 0}, whole[6] = {0, 0, 0x1.921fb6p3f, 0, 0, 0x1.921fb6p3f};
    truth_turn(0, 1, 0, 0, k);
    truth_turn(0, 1, 0, 105.0859f, k + 4);
    hermite_case("hostile", "a-wheel-of-five-turns", k, wheel, 1.0f, 0.3f);
    hermite_case("hostile", "two-whole-turns-between-equal-keys", k, whole, 1.0f, 0.25f);
}

/* ---- Velocities from the chords of four keys ---- */

/* 2 log(b a^-1)/h in the outer frame. */
static void chord_velocity(const wide a[4], const wide b[4], wide h, wide v[3])
{
    wide back[4], turn[4];
    truth_inverse(a, back);
    wide_quat_mul(b, back, turn);
    wide_scale(turn, turn[3] < 0 ? -1 : 1, 4);
    wide_quat_log(turn, v);
    wide_scale(v, 2 / h, 3);
}

/* The velocities at keys 1 and 2: tcb NULL is Catmull-Rom. */
static void velocities_of(spline *s, const wide h[3], const float *tcb)
{
    wide w[3][3];
    for (int i = 0; i < 3; i++)
        chord_velocity(s->q[i], s->q[i + 1], h[i], w[i]);
    for (int end = 0; end < 2; end++) {
        wide h0 = h[end], h1 = h[end + 1], k0 = h1, k1 = h0;
        if (tcb) {
            wide t = 1 - (wide)tcb[3 * end], c = tcb[3 * end + 1] * (end ? -1 : 1), b = tcb[3 * end + 2];
            k0 = t * (1 + c) * (1 + b) * h0;
            k1 = t * (1 - c) * (1 - b) * h1;
        }
        for (int i = 0; i < 3; i++)
            s->v[end][i] = (k0 * w[end][i] + k1 * w[end + 1][i]) / (h0 + h1);
    }
}

static void keyed_case(const char *kind, const char *name, const float k[16], const float times[4], const float *tcb,
                       float t)
{
    spline s = {.duration = (wide)times[2] - times[1]};
    wide h[3];
    for (int i = 0; i < 4; i++)
        normalized(k + 4 * i, s.q[i]);
    for (int i = 0; i < 3; i++)
        h[i] = (wide)times[i + 1] - times[i];
    velocities_of(&s, h, tcb);
    double angle = (double)(s.duration * fmaxq(wide_length(s.v[0], 3), wide_length(s.v[1], 3)));
    memcpy(s.q[0], s.q[1], sizeof s.q[0]);
    memcpy(s.q[1], s.q[2], sizeof s.q[1]);
    truth_case(kind, name, NULL);
    put_sizes(4.0 + angle, (double)s.duration);
    truth_in("q0", k, 4);
    truth_in("q1", k + 4, 4);
    truth_in("q2", k + 8, 4);
    truth_in("q3", k + 12, 4);
    truth_in("times", times, 4);
    if (tcb)
        truth_in("tcb", tcb, 6);
    truth_in("t", &t, 1);
    outputs(hermite, &s, t);
}

static void keyed_group(int has_tcb)
{
    static const char *const plain[] = {"in q0 4",
                                        "in q1 4",
                                        "in q2 4",
                                        "in q3 4",
                                        "in times 4",
                                        "in t 1",
                                        "out q 4 sign",
                                        "out velocity 3 near",
                                        "out acceleration 3 near",
                                        NULL};
    static const char *const with[] = {"in q0 4",
                                       "in q1 4",
                                       "in q2 4",
                                       "in q3 4",
                                       "in times 4",
                                       "in tcb 6",
                                       "in t 1",
                                       "out q 4 sign",
                                       "out velocity 3 near",
                                       "out acceleration 3 near",
                                       NULL};
    const float even[4] = {0, 1, 2, 3}, uneven[4] = {0, 0.25f, 1.25f, 4.25f}, tense[6] = {1, 0, 0, 1, 0, 0};
    float k[16], tcb[6] = {0};
    truth_group(has_tcb ? "rotation_tcb" : "rotation_catmull_rom", has_tcb ? with : plain, 8.0,
                "as rotation_hermite, with the velocities rounded");
    for (int i = 0; i < 8; i++) {
        float times[4] = {0};
        draw_keys(k, 0.4f);
        for (int j = 1; j < 4; j++)
            times[j] = times[j - 1] + random_between(truth_random(), 0.5f, 1.5f);
        for (int j = 0; j < 6; j++)
            tcb[j] = random_between(truth_random(), -1.0f, 1.0f);
        keyed_case("ordinary", "random", k, times, has_tcb ? tcb : NULL, random_unit(truth_random()));
    }
    keyed_case("boundary", "even-times", k, even, has_tcb ? tcb : NULL, 0.5f);
    keyed_case("boundary", "t-is-0", k, even, has_tcb ? tcb : NULL, 0.0f);
    if (has_tcb)
        keyed_case("boundary", "tension-1-rests-at-the-keys", k, even, tense, 0.25f);
    keyed_case("hostile", "uneven-times", k, uneven, has_tcb ? tcb : NULL, 0.75f);
    for (int i = 4; i < 8; i++)
        k[i] = -k[i];
    keyed_case("hostile", "one-key-negated-is-the-same", k, uneven, has_tcb ? tcb : NULL, 0.75f);
}

void truth_splines(const char *folder)
{
    static const char *const about[] = {
        "Smooth curves of rotations over t in 0..1, `duration` seconds long, with angular velocity (radians per "
        "second)",
        "and angular acceleration (per second^2) in the outer frame: dq/dt = (w/2) q. Quaternions x y z w.",
        "squad: from q1 to q2, slerp(slerp(q1, q2, t), slerp(s1, s2, t), 2t(1-t)), s = q exp(-(log(q^-1 next) +",
        "log(q^-1 previous))/4) (Shoemake 1987). rotation_bspline: cumulative, q0 exp(b1 v1/2) exp(b2 v2/2) exp(b3 "
        "v3/2)",
        "(Kim, Kim, Shin 1995). rotation_hermite: a exp(b1 u) exp(b2 m) exp(b2 r) exp(b3 w), b1 = 1-(1-t)^3,",
        "b2 = 3t^2-2t^3, b3 = t^3; u, w = duration/6 velocity in the frame of the end, m = (u+w)/2, r closes the "
        "curve.",
        "rotation_catmull_rom, rotation_tcb: rotation_hermite from q1 to q2 with velocities from the chords w = 2 "
        "log(b a^-1)/h",
        "of the segments: (w0 h1 + w1 h0)/(h0 + h1); Kochanek, Bartels 1984 with tension, continuity, bias of q1, then "
        "of q2:",
        "after q1 (1-T)((1+C)(1+B) w0 h0 + (1-C)(1-B) w1 h1)/(h0 + h1), before q2 the same with -C.",
        "Neighbouring control values are taken with the nearer sign.",
        NULL,
    };
    truth_open(folder, "splines", about);
    four_group("squad", squad);
    four_group("rotation_bspline", bspline);
    hermite_group();
    keyed_group(0);
    keyed_group(1);
    truth_close();
}

#else
typedef int truth_splines_is_skipped;
#endif
