/* SPDX-License-Identifier: MIT */
/* Errors of <nakawari/edit.h> against binary128: tracks of two or three keys, drawn from their seed. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>

#define SAMPLES 15000u

/* A track of three keys, and the edited one. */
typedef struct drawn {
    float times[3], values[36], made_times[8], made[96];
    nkw_track track, out;
    nkw_track_span memory;
} drawn;

static void begin(drawn *d, random_source *r, size_t width, nkw_interpolation interpolation)
{
    nkw_track track = {d->times,      d->values, 3, width, width == 4 ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS,
                       interpolation, NULL};
    nkw_track_span memory = {d->made_times, d->made, NULL, 8};
    d->track = track;
    d->memory = memory;
    d->times[0] = random_log(r, 1e-2f, 60.0f);
    d->times[1] = d->times[0] + random_log(r, 1e-2f, 10.0f);
    d->times[2] = d->times[1] + random_log(r, 1e-2f, 10.0f);
}

/* The Hermite curve of one segment at a time, and the largest of its values and tangents per segment. */
static wide hermite(const drawn *d, float time, wide *largest)
{
    wide h = (wide)d->times[1] - d->times[0], t = ((wide)time - d->times[0]) / h, u = 1 - t;
    wide all[4] = {d->values[1], h * d->values[2], d->values[4], h * d->values[3]};
    for (int k = 0; k < 4; k++)
        *largest = all[k] > *largest ? all[k] : -all[k] > *largest ? -all[k] : *largest;
    return (1 + 2 * t) * u * u * all[0] + t * u * u * all[1] + t * t * (3 - 2 * t) * all[2] - t * t * u * all[3];
}

/* Of the largest value or tangent per segment. */
static double trim_error(const float *x)
{
    random_source r = wide_source(x);
    drawn d;
    float got;
    begin(&d, &r, 1, NKW_INTERPOLATION_CUBICSPLINE);
    float most = 1.0f / (d.times[1] - d.times[0]);
    for (int i = 0; i < 9; i++)
        d.values[i] = i % 3 == 1 ? random_between(&r, -1.0f, 1.0f) : random_between(&r, -most, most);
    float at = random_between(&r, d.times[0], d.times[1]), time = random_between(&r, at, d.times[1]);
    if (nkw_track_trim(&d.track, at, d.times[2], d.memory, &d.out) != NKW_OK)
        return INFINITY;
    nkw_track_sample(&d.out, time, NULL, &got);
    wide largest = 0, exact = hermite(&d, time, &largest);
    return accuracy_units((double)got, (double)exact, (double)largest);
}

static double retime_error(const float *x)
{
    random_source r = wide_source(x);
    drawn d;
    begin(&d, &r, 1, NKW_INTERPOLATION_LINEAR);
    for (int i = 0; i < 3; i++)
        d.values[i] = 0.0f;
    float scale = random_log(&r, 1e-3f, 1e3f), offset = random_sign(&r) * random_log(&r, 1e-3f, 1e3f);
    if (nkw_track_retime(&d.track, scale, offset, d.memory, &d.out) != NKW_OK)
        return INFINITY;
    wide exact = (wide)scale * d.times[1] + offset;
    return accuracy_units((double)d.out.times[1], (double)exact, fabs((double)exact));
}

static wide share_of(const drawn *d)
{
    return ((wide)d->times[1] - d->times[0]) / ((wide)d->times[2] - d->times[0]);
}

static double close_error(const float *x)
{
    random_source r = wide_source(x);
    drawn d;
    begin(&d, &r, 1, NKW_INTERPOLATION_LINEAR);
    for (int i = 0; i < 3; i++)
        d.values[i] = random_between(&r, -1.0f, 1.0f);
    float share = random_unit(&r);
    if (nkw_track_close(&d.track, share, d.memory, &d.out) != NKW_OK)
        return INFINITY;
    wide exact = d.values[1] + ((wide)share - share_of(&d)) * ((wide)d.values[2] - d.values[0]);
    double largest = fmax(fabs((double)d.values[0]), fmax(fabs((double)d.values[1]), fabs((double)d.values[2])));
    return accuracy_units((double)d.out.values[1], (double)exact, largest);
}

static double close_turn_error(const float *x)
{
    random_source r = wide_source(x);
    drawn d;
    wide a[4], b[4], c[4], turn[4], v[3], exact[4];
    begin(&d, &r, 4, NKW_INTERPOLATION_LINEAR);
    nkw_quat q = random_unit_quat(&r);
    put_quat(d.values, q);
    put_quat(d.values + 4, random_unit_quat(&r));
    put_quat(d.values + 8, random_unit_near(&r, q, 1.5f * random_unit(&r)));
    float share = random_unit(&r);
    if (nkw_track_close(&d.track, share, d.memory, &d.out) != NKW_OK)
        return INFINITY;
    wide_from(d.values, a, 4);
    wide_from(d.values + 4, b, 4);
    wide_from(d.values + 8, c, 4);
    for (int i = 0; i < 3; i++)
        a[i] = -a[i];
    wide_quat_mul(c, a, turn);
    wide_quat_log(turn, v);
    wide_scale(v, (wide)share - share_of(&d), 3);
    wide_quat_exp(v, turn);
    wide_quat_mul(turn, b, exact);
    return wide_error(d.out.values + 4, exact, 4);
}

static const wide_case cases[] = {
    {"nkw_track_trim", "CUBICSPLINE, one number", wide_seed, trim_error, 2, WIDE_CHECKED},
    {"nkw_track_retime", "times", wide_seed, retime_error, 2, WIDE_CHECKED},
    {"nkw_track_close", "numbers", wide_seed, close_error, 2, WIDE_CHECKED},
    {"nkw_track_close", "rotations", wide_seed, close_turn_error, 2, WIDE_CHECKED},
};

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("edit.h", argc, argv);
    wide_search_seeds(&a, cases, sizeof cases / sizeof cases[0], SAMPLES);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
