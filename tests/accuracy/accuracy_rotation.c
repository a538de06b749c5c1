/* SPDX-License-Identifier: MIT */
/*
 * Errors of <nakawari/rotation.h> against binary128: the curves by their formulas, velocity and acceleration by
 * differences of the curve over 2^-30 and 2^-17 of the segment, which binary128 leaves more than 30 bits of.
 */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <quadmath.h>
#include <string.h>

#define SAMPLES 3000u
#define AT      "nkw_rotation_evaluate"
#define CONTROL "nkw_rotation_from_squad"

/* ---- Samples: four quaternions, two velocities, duration, t, kind ---- */

enum { VELOCITIES = 16, DURATION = 22, T = 23, KIND = 24, ARGUMENTS = 25 };

static void keys_apart(random_source *r, float *x, float low, float high)
{
    nkw_quat q = random_unit_quat(r);
    for (int i = 0; i < 4; i++) {
        put_quat(x + 4 * i, nkw_quat_scale(q, random_sign(r)));
        q = random_unit_near(r, q, random_log(r, low, high));
    }
    put_vec3(x + VELOCITIES, random_vec3(r, -1.0f, 1.0f));
    put_vec3(x + VELOCITIES + 3, random_vec3(r, -1.0f, 1.0f));
    x[DURATION] = random_log(r, 1e-3f, 10.0f);
    for (int i = 0; i < 6; i++)
        x[VELOCITIES + i] /= x[DURATION];
    x[T] = random_unit(r);
}

#define KEYS(name, kind, low, high)                                                                                    \
    static void name(random_source *r, float *x)                                                                       \
    {                                                                                                                  \
        keys_apart(r, x, low, high);                                                                                   \
        x[KIND] = (float)(kind);                                                                                       \
    }

KEYS(slerp_keys, NKW_ROTATION_SLERP, 1e-2f, 1.5f)
KEYS(near_slerp_keys, NKW_ROTATION_SLERP, 1e-6f, 1e-2f)
KEYS(hermite_keys, NKW_ROTATION_HERMITE, 1e-2f, 0.5f)
KEYS(squad_keys, NKW_ROTATION_SQUAD, 1e-2f, 0.33f)
KEYS(near_squad_keys, NKW_ROTATION_SQUAD, 1e-5f, 1e-2f)
KEYS(bspline_keys, NKW_ROTATION_BSPLINE, 1e-2f, 1.5f)
KEYS(near_bspline_keys, NKW_ROTATION_BSPLINE, 1e-5f, 1e-2f)

/* Up to 16 turns, the end within 1 rad of the prediction. */
static void wheel_keys(random_source *r, float *x)
{
    hermite_keys(r, x);
    for (int i = 0; i < 6; i++)
        x[VELOCITIES + i] *= 60.0f;
    nkw_vec3 mean = nkw_vec3_scale(nkw_vec3_add(vec3_at(x + VELOCITIES), vec3_at(x + VELOCITIES + 3)), 0.5f);
    nkw_quat end = nkw_quat_integrate(quat_at(x), mean, x[DURATION]);
    put_quat(x + 4, random_unit_near(r, nkw_quat_normalize(end), 0.5f * random_unit(r)));
}

static nkw_rotation_segment segment_of(const float *x)
{
    nkw_rotation_segment s = nkw_rotation_from_hermite(quat_at(x), vec3_at(x + VELOCITIES), quat_at(x + 4),
                                                       vec3_at(x + VELOCITIES + 3), x[DURATION]);
    s.kind = (nkw_rotation_kind)x[KIND];
    s.control[2] = quat_at(x + 8);
    s.control[3] = quat_at(x + 12);
    return s;
}

/* ---- The curves in binary128 ---- */

static void inverse_of(const wide q[4], wide out[4])
{
    memcpy(out, q, 4 * sizeof *q);
    wide_scale(out, -1, 3);
}

/* q exp(b v). Differences need all digits of binary128, more than wide_quat_exp has. */
static void append(wide q[4], const wide v[3], wide b)
{
    wide length = b * wide_length(v, 3), part = length != 0 ? b * sinq(length) / length : b;
    wide e[4] = {part * v[0], part * v[1], part * v[2], cosq(length)};
    wide_quat_mul(q, e, q);
}

/* log(a^-1 b), b with the nearer sign. */
static void chord(const wide a[4], const wide b[4], wide v[3])
{
    wide turn[4];
    inverse_of(a, turn);
    wide_quat_mul(turn, b, turn);
    wide_scale(turn, turn[3] < 0 ? -1 : 1, 4);
    wide_quat_log(turn, v);
}

static void controls_of(const float *x, wide c[4][4])
{
    for (int i = 0; i < 4; i++) {
        wide_from(x + 4 * i, c[i], 4);
        wide_normalize(c[i], 4);
    }
}

/* Half of duration/3 times the velocity, in the frame of q. */
static void half_third(const float *x, int i, const wide q[4], wide out[3])
{
    wide v[4], back[4];
    wide_from(x + VELOCITIES + 3 * i, v, 3);
    wide_scale(v, (wide)x[DURATION] / 6, 3);
    v[3] = 0;
    inverse_of(q, back);
    wide_quat_mul(back, v, v);
    wide_quat_mul(v, q, v);
    memcpy(out, v, 3 * sizeof *v);
}

/* The halves u, m, r, w of nkw_rotation_from_hermite. */
static void hermite_halves(const float *x, wide a[4], wide v[4][3])
{
    wide c[4][4], left[4], right[4] = {0, 0, 0, 1};
    controls_of(x, c);
    memcpy(a, c[0], sizeof c[0]);
    half_third(x, 0, c[0], v[0]);
    half_third(x, 1, c[1], v[3]);
    for (int i = 0; i < 3; i++)
        v[1][i] = (v[0][i] + v[3][i]) / 2;
    memcpy(left, a, 4 * sizeof *a);
    append(left, v[0], 1);
    append(left, v[1], 1);
    append(right, v[3], -1);
    wide_quat_mul(c[1], right, right);
    chord(left, right, v[2]);
}

/* Up to four halves of rotation vectors, their weights, the derivatives of these. Returns how many. */
typedef struct factors {
    int count;
    wide q0[4], v[4][3], b[4], b1[4], b2[4];
} factors;

static void weigh(factors *f, int i, wide b, wide b1, wide b2)
{
    f->b[i] = b;
    f->b1[i] = b1;
    f->b2[i] = b2;
}

static factors factors_at(const float *x, wide t)
{
    factors f;
    wide c[4][4], s = 1 - t;
    controls_of(x, c);
    memcpy(f.q0, c[0], sizeof c[0]);
    f.count = x[KIND] == (float)NKW_ROTATION_SLERP ? 1 : x[KIND] == (float)NKW_ROTATION_HERMITE ? 4 : 3;
    if (f.count == 4) {
        hermite_halves(x, f.q0, f.v);
        weigh(&f, 0, 1 - s * s * s, 3 * s * s, -6 * s);
        weigh(&f, 1, t * t * (3 - 2 * t), 6 * t * s, 6 - 12 * t);
        weigh(&f, 2, t * t * (3 - 2 * t), 6 * t * s, 6 - 12 * t);
        weigh(&f, 3, t * t * t, 3 * t * t, 6 * t);
        return f;
    }
    for (int i = 0; i < f.count; i++)
        chord(c[i], c[i + 1], f.v[i]);
    weigh(&f, 0, t, 1, 0);
    if (f.count == 3) {
        weigh(&f, 0, 1 - s * s * s / 6, s * s / 2, -s);
        weigh(&f, 1, (1 + 3 * t + 3 * t * t - 2 * t * t * t) / 6, (1 + 2 * t - 2 * t * t) / 2, 1 - 2 * t);
        weigh(&f, 2, t * t * t / 6, t * t / 2, t);
    }
    return f;
}

static void squad_at(const float *x, wide t, wide q[4])
{
    wide c[4][4], outer[4], inner[4];
    controls_of(x, c);
    wide_scale(c[3], wide_dot(c[0], c[3], 4) < 0 ? -1 : 1, 4);
    wide_scale(c[1], wide_dot(c[0], c[1], 4) < 0 ? -1 : 1, 4);
    wide_scale(c[2], wide_dot(c[3], c[2], 4) < 0 ? -1 : 1, 4);
    wide_slerp(c[0], c[3], t, outer);
    wide_slerp(c[1], c[2], t, inner);
    wide_slerp(outer, inner, 2 * t * (1 - t), q);
}

static void curve_at(const float *x, wide t, wide q[4])
{
    if (x[KIND] == (float)NKW_ROTATION_SQUAD) {
        squad_at(x, t, q);
        return;
    }
    factors f = factors_at(x, t);
    memcpy(q, f.q0, sizeof f.q0);
    for (int i = 0; i < f.count; i++)
        append(q, f.v[i], f.b[i]);
}

#define NEAR ((wide)0x1p-30)
#define FAR  ((wide)0x1p-17)

/* By t: 2 log(q(t + e) q(t - e)^-1) / 2 e. */
static void velocity_at(const float *x, wide t, wide v[3])
{
    wide low[4], high[4];
    curve_at(x, t - NEAR, low);
    curve_at(x, t + NEAR, high);
    inverse_of(low, low);
    wide_quat_mul(high, low, high);
    wide_scale(high, high[3] < 0 ? -1 : 1, 4);
    wide_quat_log(high, v);
    wide_scale(v, 1 / NEAR, 3);
}

static void acceleration_at(const float *x, wide t, wide a[3])
{
    wide low[3];
    velocity_at(x, t - FAR, low);
    velocity_at(x, t + FAR, a);
    for (int i = 0; i < 3; i++)
        a[i] = (a[i] - low[i]) / (2 * FAR);
}

/* The largest angle between two control values, at most 2 rad. */
static wide spread_of(const float *x)
{
    wide c[4][4], largest = 0, v[3];
    controls_of(x, c);
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < i; k++) {
            chord(c[i], c[k], v);
            largest = fmaxq(largest, 2 * wide_length(v, 3));
        }
    return largest;
}

/* What the errors of velocity and acceleration are relative to, by t. */
static void sizes_at(const float *x, wide t, wide *velocity, wide *acceleration)
{
    *velocity = 4 * spread_of(x);
    *acceleration = 16 * spread_of(x);
    if (x[KIND] == (float)NKW_ROTATION_SQUAD)
        return;
    factors f = factors_at(x, t);
    *velocity = *acceleration = 0;
    for (int i = 0; i < f.count; i++) {
        *velocity += 2 * fabsq(f.b1[i]) * wide_length(f.v[i], 3);
        *acceleration += 2 * fabsq(f.b2[i]) * wide_length(f.v[i], 3);
    }
    *acceleration += *velocity * *velocity;
}

static double evaluate_error(const float *x)
{
    wide q[4], v[3], a[3], t = x[T], h = x[DURATION], velocity, acceleration;
    float got[10];
    nkw_rotation_segment s = segment_of(x);
    nkw_quat_motion at = nkw_rotation_evaluate(&s, x[T]);
    put_quat(got, at.value);
    put_vec3(got + 4, at.velocity);
    put_vec3(got + 7, at.acceleration);
    curve_at(x, t, q);
    velocity_at(x, t, v);
    acceleration_at(x, t, a);
    sizes_at(x, t, &velocity, &acceleration);
    wide_scale(v, 1 / h, 3);
    wide_scale(a, 1 / (h * h), 3);
    double worst = fmax(wide_error_either(got, q, 4), wide_error_of(got + 4, v, 3, velocity / h));
    return fmax(worst, wide_error_of(got + 7, a, 3, acceleration / (h * h)));
}

/* ---- The inner control value of squad ---- */

static double control_error(const float *x)
{
    wide c[4][4], on[3], from[3];
    float got[4];
    controls_of(x, c);
    chord(c[1], c[2], on);
    chord(c[1], c[0], from);
    for (int i = 0; i < 3; i++)
        on[i] += from[i];
    append(c[1], on, (wide)-0.25);
    const nkw_quat keys[4] = {quat_at(x), quat_at(x + 4), quat_at(x + 8), quat_at(x + 8)};
    put_quat(got, nkw_rotation_from_squad(keys, 1.0f).control[1]);
    return wide_error(got, c[1], 4);
}

static const wide_case cases[] = {
    {AT, "SLERP", slerp_keys, evaluate_error, ARGUMENTS, WIDE_CHECKED},
    {AT, "SLERP, 1e-6 .. 1e-2", near_slerp_keys, evaluate_error, ARGUMENTS, WIDE_CHECKED},
    {AT, "HERMITE", hermite_keys, evaluate_error, ARGUMENTS, WIDE_CHECKED},
    {AT, "HERMITE, up to 16 turns", wheel_keys, evaluate_error, ARGUMENTS, WIDE_CHECKED},
    {AT, "SQUAD", squad_keys, evaluate_error, ARGUMENTS, WIDE_CHECKED},
    {AT, "SQUAD, 1e-5 .. 1e-2", near_squad_keys, evaluate_error, ARGUMENTS, WIDE_CHECKED},
    {AT, "BSPLINE", bspline_keys, evaluate_error, ARGUMENTS, WIDE_CHECKED},
    {AT, "BSPLINE, 1e-5 .. 1e-2", near_bspline_keys, evaluate_error, ARGUMENTS, WIDE_CHECKED},
    {CONTROL, "within 1.5", bspline_keys, control_error, 12, WIDE_CHECKED},
    {CONTROL, "1e-5 .. 1e-2", near_bspline_keys, control_error, 12, WIDE_CHECKED},
};

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("rotation.h", argc, argv);
    wide_search(&a, cases, sizeof cases / sizeof cases[0], SAMPLES);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
