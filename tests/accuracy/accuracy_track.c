/* SPDX-License-Identifier: MIT */
/* Errors of <nakawari/track.h> against binary128: one segment of a track, drawn from its seed. */
#include "../support/motion_span.h"
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <quadmath.h>

#define SAMPLES 15000u

/* Two keys, `width` floats each: in-tangent, value, out-tangent; or the value alone. */
typedef struct segment {
    float times[2], values[24], time;
    nkw_track track;
} segment;

static void begin(segment *s, random_source *r, size_t width, nkw_track_kind kind, nkw_interpolation interpolation)
{
    nkw_track track = {s->times, s->values, 2, width, kind, interpolation, NULL};
    s->track = track;
    s->times[0] = random_log(r, 1e-2f, 60.0f);
    s->times[1] = s->times[0] + random_log(r, 1e-2f, 10.0f);
    s->time = random_between(r, s->times[0], s->times[1]);
}

static wide duration_of(const segment *s)
{
    return (wide)s->times[1] - s->times[0];
}

static wide share_of(const segment *s)
{
    return ((wide)s->time - s->times[0]) / duration_of(s);
}

/* The curve of component i of a cubic track, and the largest of what it is made of. */
static wide hermite(const segment *s, size_t i, wide *largest)
{
    size_t w = s->track.width;
    wide d = duration_of(s), t = share_of(s), u = 1 - t;
    wide p = s->values[w + i], q = s->values[4 * w + i];
    wide v = d * s->values[2 * w + i], e = d * s->values[3 * w + i];
    wide all[4] = {p, q, v, e};
    for (int k = 0; k < 4; k++)
        *largest = all[k] > *largest ? all[k] : -all[k] > *largest ? -all[k] : *largest;
    return (1 + 2 * t) * u * u * p + t * u * u * v + t * t * (3 - 2 * t) * q - t * t * u * e;
}

/* Of the largest control value or tangent per segment, which are of one size. */
static double cubic_error(const float *x)
{
    random_source r = wide_source(x);
    segment s;
    float got;
    begin(&s, &r, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_CUBICSPLINE);
    float most = 1.0f / (s.times[1] - s.times[0]);
    for (int i = 0; i < 6; i++)
        s.values[i] = i % 3 == 1 ? random_between(&r, -1.0f, 1.0f) : random_between(&r, -most, most);
    nkw_track_sample(&s.track, s.time, NULL, &got);
    wide largest = 0, exact = hermite(&s, 0, &largest);
    return accuracy_units((double)got, (double)exact, (double)largest);
}

/* Velocity and acceleration at the rounded t, of the largest of the slope and the tangents. */
static double rates_error(const float *x)
{
    random_source r = wide_source(x);
    segment s;
    float value, got[2];
    const nkw_motion_span out = {&value, got, got + 1};
    begin(&s, &r, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_CUBICSPLINE);
    for (int i = 0; i < 6; i++)
        s.values[i] = random_between(&r, -1.0f, 1.0f);
    if (nkw_track_sample_motion(&s.track, s.time, out) != NKW_OK)
        return HUGE_VAL;
    wide h = (wide)s.times[1] - s.times[0], t = nkw_segment_find(s.times, 2, s.time).t, u = 1 - t;
    wide c[3] = {((wide)s.values[4] - s.values[1]) / h, s.values[2], s.values[3]}, size = 0;
    wide first[3] = {6 * t * u, u * (u - 2 * t), t * (t - 2 * u)}, second[3] = {6 - 12 * t, 6 * t - 4, 6 * t - 2};
    for (int i = 0; i < 3; i++)
        size = c[i] > size ? c[i] : -c[i] > size ? -c[i] : size;
    wide velocity = wide_dot(c, first, 3), acceleration = wide_dot(c, second, 3) / h;
    wide speed = velocity > size ? velocity : -velocity > size ? -velocity : size;
    wide bend = acceleration * h > size ? acceleration * h : -acceleration * h > size ? -acceleration * h : size;
    return fmax(wide_error_of(got, &velocity, 1, speed), wide_error_of(got + 1, &acceleration, 1, bend / h));
}

/* 2 Im(a b*). */
static void twice_over(const wide a[4], const wide b[4], wide out[4])
{
    wide conjugate[4] = {-b[0], -b[1], -b[2], b[3]};
    wide_quat_mul(a, conjugate, out);
    wide_scale(out, 2, 4);
}

/*
 * Angular velocity and acceleration at the rounded t, keys up to 1 rad apart: of S = 2|p'|/|p|, and of
 * 2|p''|/|p| + S^2.
 */
static double cubic_spin_error(const float *x)
{
    random_source r = wide_source(x);
    segment s;
    nkw_quat_motion got;
    begin(&s, &r, 4, NKW_TRACK_ROTATION, NKW_INTERPOLATION_CUBICSPLINE);
    float most = 0.5f / (s.times[1] - s.times[0]);
    for (int i = 0; i < 24; i++)
        s.values[i] = random_between(&r, -most, most);
    nkw_quat a = random_unit_quat(&r);
    put_quat(s.values + 4, a);
    put_quat(s.values + 16, random_unit_near(&r, a, 0.5f * random_unit(&r)));
    if (nkw_track_sample_motion(&s.track, s.time, quat_motion_span(&got)) != NKW_OK)
        return HUGE_VAL;
    wide h = duration_of(&s), t = nkw_segment_find(s.times, 2, s.time).t, u = 1 - t, p[3][4], w[4], e[4];
    for (int i = 0; i < 4; i++) {
        wide c[4] = {s.values[4 + i], h * s.values[8 + i], s.values[16 + i], h * s.values[12 + i]};
        wide k[3][4] = {
            {(1 + 2 * t) * u * u, t * u * u, t * t * (3 - 2 * t), -t * t * u},
            {-6 * t * u / h, u * (u - 2 * t) / h, 6 * t * u / h, t * (t - 2 * u) / h},
            {(12 * t - 6) / h / h, (6 * t - 4) / h / h, (6 - 12 * t) / h / h, (6 * t - 2) / h / h},
        };
        for (int d = 0; d < 3; d++)
            p[d][i] = wide_dot(c, k[d], 4);
    }
    wide n = wide_dot(p[0], p[0], 4), speed = 2 * sqrtq(wide_dot(p[1], p[1], 4) / n);
    twice_over(p[1], p[0], w);
    twice_over(p[2], p[0], e);
    for (int i = 0; i < 3; i++) {
        w[i] /= n;
        e[i] = e[i] / n - 2 * wide_dot(p[0], p[1], 4) / n * w[i];
    }
    wide bend = 2 * sqrtq(wide_dot(p[2], p[2], 4) / n) + speed * speed;
    return fmax(wide_error_of(&got.velocity.x, w, 3, speed), wide_error_of(&got.acceleration.x, e, 3, bend));
}

/* The velocity of a slerp, of its length. */
static double slerp_spin_error(const float *x)
{
    random_source r = wide_source(x);
    segment s;
    nkw_quat_motion got;
    wide a[4], b[4], exact[4];
    begin(&s, &r, 4, NKW_TRACK_ROTATION, NKW_INTERPOLATION_LINEAR);
    nkw_quat q = random_unit_quat(&r);
    put_quat(s.values, q);
    put_quat(s.values + 4, random_unit_near(&r, q, 1.5f * random_unit(&r)));
    if (nkw_track_sample_motion(&s.track, s.time, quat_motion_span(&got)) != NKW_OK)
        return HUGE_VAL;
    wide_from(s.values, a, 4);
    wide_from(s.values + 4, b, 4);
    wide_normalize(a, 4);
    wide_normalize(b, 4);
    twice_over(b, a, exact);
    wide_scale(exact, (wide)0.5, 4);
    wide v[3];
    wide_quat_log(exact, v);
    wide_scale(v, 2 / duration_of(&s), 3);
    return wide_error_of(&got.velocity.x, v, 3, sqrtq(wide_dot(v, v, 3)));
}

/* Keys of any sign up to `angle` apart, tangents of up to that length in a segment. */
static double cubic_turn_error(const float *x, float angle)
{
    random_source r = wide_source(x);
    segment s;
    float got[4];
    wide exact[4], largest = 0;
    begin(&s, &r, 4, NKW_TRACK_ROTATION, NKW_INTERPOLATION_CUBICSPLINE);
    nkw_quat a = random_unit_quat(&r), b = random_unit_near(&r, a, angle * random_unit(&r));
    float most = angle / 2.0f / (s.times[1] - s.times[0]);
    for (int i = 0; i < 24; i++)
        s.values[i] = random_between(&r, -most, most);
    put_quat(s.values + 4, a);
    put_quat(s.values + 16, b);
    nkw_track_sample(&s.track, s.time, NULL, got);
    for (size_t i = 0; i < 4; i++)
        exact[i] = hermite(&s, i, &largest);
    wide_normalize(exact, 4);
    return wide_error(got, exact, 4);
}

static double cubic_turn_small(const float *x)
{
    return cubic_turn_error(x, 0.25f);
}

static double cubic_turn_large(const float *x)
{
    return cubic_turn_error(x, 1.0f);
}

/* Values a and b = -a to `spread`, around the middle of the segment: where nkw_lerp is at its worst; 1 for any. */
static double linear_error(const float *x, float spread)
{
    random_source r = wide_source(x);
    segment s;
    float got;
    begin(&s, &r, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR);
    float middle = 0.5f * (s.times[0] + s.times[1]), half = spread * (s.times[1] - middle);
    s.time = random_between(&r, middle - half, middle + half);
    s.values[0] = random_between(&r, -1.0f, 1.0f);
    s.values[1] = random_between(&r, -1.0f, 1.0f);
    if (spread < 1.0f)
        s.values[1] = -s.values[0] * random_between(&r, 1.0f - spread, 1.0f + spread);
    nkw_track_sample(&s.track, s.time, NULL, &got);
    wide a = s.values[0], b = s.values[1], t = share_of(&s);
    return accuracy_units((double)got, (double)((1 - t) * a + t * b), fmax(fabs((double)a), fabs((double)b)));
}

static double linear_any(const float *x)
{
    return linear_error(x, 1.0f);
}

static double linear_opposite(const float *x)
{
    return linear_error(x, 0.05f);
}

static double slerp_error(const float *x)
{
    random_source r = wide_source(x);
    segment s;
    float got[4];
    wide a[4], b[4], exact[4];
    begin(&s, &r, 4, NKW_TRACK_ROTATION, NKW_INTERPOLATION_LINEAR);
    nkw_quat q = random_unit_quat(&r);
    put_quat(s.values, q);
    put_quat(s.values + 4, random_unit_near(&r, q, 1.5f * random_unit(&r)));
    nkw_track_sample(&s.track, s.time, NULL, got);
    wide_from(s.values, a, 4);
    wide_from(s.values + 4, b, 4);
    wide_slerp(a, b, share_of(&s), exact);
    return wide_error(got, exact, 4);
}

#define SAMPLE "nkw_track_sample"

static const wide_case cases[] = {
    {SAMPLE, "CUBICSPLINE, numbers", wide_seed, cubic_error, 2, WIDE_CHECKED},
    {SAMPLE, "CUBICSPLINE, rotations 0.25 apart", wide_seed, cubic_turn_small, 2, WIDE_CHECKED},
    {SAMPLE, "CUBICSPLINE, rotations 1 rad apart", wide_seed, cubic_turn_large, 2, WIDE_CHECKED},
    {"nkw_track_sample_motion", "numbers, CUBICSPLINE", wide_seed, rates_error, 2, WIDE_CHECKED},
    {"nkw_track_sample_motion", "CUBICSPLINE, 1 rad apart", wide_seed, cubic_spin_error, 2, WIDE_CHECKED},
    {"nkw_track_sample_motion", "LINEAR", wide_seed, slerp_spin_error, 2, WIDE_CHECKED},
    {SAMPLE, "LINEAR, numbers", wide_seed, linear_any, 2, WIDE_CHECKED},
    {SAMPLE, "LINEAR, nearly opposite keys, middle", wide_seed, linear_opposite, 2, WIDE_CHECKED},
    {SAMPLE, "LINEAR, rotations", wide_seed, slerp_error, 2, WIDE_CHECKED},
};

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("track.h", argc, argv);
    wide_search_seeds(&a, cases, sizeof cases / sizeof cases[0], SAMPLES);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
