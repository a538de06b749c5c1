/* SPDX-License-Identifier: MIT */
/* Errors of <nakawari/track.h> against binary128: one segment of a track, drawn from its seed. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>

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
    nkw_track_sample(&s.track, s.time, &got);
    wide largest = 0, exact = hermite(&s, 0, &largest);
    return accuracy_units((double)got, (double)exact, (double)largest);
}

/* Velocity and acceleration at the rounded t, of the largest of the slope and the tangents. */
static double rates_error(const float *x)
{
    random_source r = wide_source(x);
    segment s;
    float value, got[2];
    begin(&s, &r, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_CUBICSPLINE);
    for (int i = 0; i < 6; i++)
        s.values[i] = random_between(&r, -1.0f, 1.0f);
    if (nkw_track_sample_derivatives(&s.track, s.time, &value, got, got + 1) != NKW_OK)
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
    nkw_track_sample(&s.track, s.time, got);
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
    nkw_track_sample(&s.track, s.time, &got);
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
    nkw_track_sample(&s.track, s.time, got);
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
    {"nkw_track_sample_derivatives", "CUBICSPLINE", wide_seed, rates_error, 2, WIDE_CHECKED},
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
