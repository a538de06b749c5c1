/* SPDX-License-Identifier: MIT */
/* Compact clips of <nakawari/clip.h> beside their tracks: how much of the bounds of NKW_CLIP_UNORM16 is met. */
#include "wide.h"
#include "../support/views.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <string.h>

#define SAMPLES 10000u
#define KEYS    6
#define BYTES   4096

typedef struct drawn {
    float times[KEYS], values[4 * KEYS], time;
    nkw_clip_track track;
} drawn;

static drawn draw(const float *x, int is_rotation, float angle)
{
    random_source r = wide_source(x);
    drawn d;
    memset(&d, 0, sizeof d);
    nkw_quat q = random_unit_quat(&r);
    float offset = random_between(&r, -100.0f, 100.0f), range = random_log(&r, 1e-3f, 100.0f);
    for (int k = 0; k < KEYS; k++) {
        d.times[k] = (float)k / 8.0f;
        for (int c = 0; c < 3; c++)
            d.values[3 * k + c] = offset + random_between(&r, -range, range);
    }
    for (int k = 0; is_rotation && k < KEYS; k++) {
        put_quat(d.values + 4 * k, nkw_quat_scale(q, random_sign(&r)));
        q = random_unit_near(&r, q, angle * random_unit(&r));
    }
    d.time = random_between(&r, 0.0f, d.times[KEYS - 1]);
    return d;
}

/* The value of the compact clip of the one track. */
static int sample(drawn *d, int is_rotation, float time, float *pose)
{
    NKW_STACK_WORK(work, NKW_CLIP_BUILD_WORK(1));
    static float block[BYTES / sizeof(float)];
    nkw_track track = {d->times,
                       d->values,
                       KEYS,
                       is_rotation ? 4 : 3,
                       is_rotation ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS,
                       NKW_INTERPOLATION_LINEAR,
                       NULL};
    nkw_clip_track placed = {is_rotation ? NKW_CLIP_ROTATION : NKW_CLIP_TRANSLATION, 0, track};
    nkw_clip_source source = {&d->track, 1, 1, 0, {NULL, 0}, NULL, NKW_CLIP_UNORM16, NULL};
    size_t bytes;
    d->track = placed;
    d->track.track.times = d->times;
    if (nkw_clip_build(&source, bytes_span(block, sizeof block), &bytes, NULL, work) != NKW_OK)
        return 0;
    nkw_clip_sample((const nkw_clip *)(const void *)block, time, NULL, pose_span(pose, 1), NULL);
    return 1;
}

static int beyond;

/* A part of a stated bound, which fails where it is more than all. */
static double within(double part)
{
    beyond |= !(part <= 1.0);
    return part;
}

/* Of 0.51/65535 of the range and 3 u of the number: at most 1. */
static double number_error(const float *x)
{
    drawn d = draw(x, 0, 0.0f);
    float pose[NKW_POSE_FLOATS(1)], want[3];
    double worst = 0.0;
    if (!sample(&d, 0, d.time, pose))
        return HUGE_VAL;
    nkw_track_sample(&d.track.track, d.time, NULL, want);
    for (int c = 0; c < 3; c++) {
        double low = HUGE_VAL, high = -HUGE_VAL, size = 0.0;
        for (int k = 0; k < KEYS; k++) {
            low = fmin(low, (double)d.values[3 * k + c]);
            high = fmax(high, (double)d.values[3 * k + c]);
            size = fmax(size, fabs((double)d.values[3 * k + c]));
        }
        double bound = 0.51 / 65535.0 * (high - low) + 3.0 * 0x1p-24 * size;
        worst = fmax(worst, fabs((double)pose[c * 16] - (double)want[c]) / bound);
    }
    return within(worst);
}

/* Radians between the rotations, of `bound`. */
static double turn_error(const float *x, float angle, int at_key, double bound)
{
    drawn d = draw(x, 1, angle);
    float pose[NKW_POSE_FLOATS(1)], got[4], want[4];
    wide a[4], b[4];
    float time = at_key ? d.times[2] : d.time;
    if (!sample(&d, 1, time, pose))
        return HUGE_VAL;
    nkw_track_sample(&d.track.track, time, NULL, want);
    for (int c = 0; c < 4; c++)
        got[c] = pose[(3 + c) * 16];
    wide_from(got, a, 4);
    wide_from(want, b, 4);
    wide_normalize(a, 4);
    wide_normalize(b, 4);
    return within(2.0 * asin(0.5 * wide_turn(a, b) * 0x1p-24) / bound);
}

static double at_keys(const float *x)
{
    return turn_error(x, 1.5f, 1, 1.24e-4);
}

static double between_near(const float *x)
{
    return turn_error(x, 0.2f, 0, 1.24e-4);
}

static double between_far(const float *x)
{
    return turn_error(x, 1.5f, 0, 1.75e-4);
}

#define SAMPLE "nkw_clip_sample"

static const wide_case cases[] = {
    {SAMPLE, "UNORM16, numbers, fraction of the bound", wide_seed, number_error, 2, WIDE_NOTED},
    {SAMPLE, "UNORM16, rotations at keys, fraction of the bound", wide_seed, at_keys, 2, WIDE_NOTED},
    {SAMPLE, "UNORM16, keys 0.4 rad apart, fraction of 1.24e-4", wide_seed, between_near, 2, WIDE_NOTED},
    {SAMPLE, "UNORM16, keys to 3 rad apart, fraction of 1.75e-4", wide_seed, between_far, 2, WIDE_NOTED},
};

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("clip.h", argc, argv);
    wide_search_seeds(&a, cases, sizeof cases / sizeof cases[0], SAMPLES);
    a.failures += beyond;
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
