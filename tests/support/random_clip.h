/* SPDX-License-Identifier: MIT */
/* Tracks of every sort for clips: shared and own key times, even and uneven, constant ones, all interpolations. */
#ifndef NAKAWARI_TESTS_RANDOM_CLIP_H
#define NAKAWARI_TESTS_RANDOM_CLIP_H

#include <math.h>

#include "random.h"

#ifdef __cplusplus
extern "C" {
#endif

#define RANDOM_CLIP_JOINTS 40
#define RANDOM_CLIP_FLOATS 12
#define RANDOM_CLIP_KEYS   24
#define RANDOM_CLIP_TRACKS (3 * RANDOM_CLIP_JOINTS + 4)
#define RANDOM_CLIP_LINES  5

typedef struct random_clip {
    nkw_clip_source source;
    nkw_clip_track tracks[RANDOM_CLIP_TRACKS];
    float times[RANDOM_CLIP_LINES][RANDOM_CLIP_KEYS];
    unsigned char modes[RANDOM_CLIP_KEYS], cubic_modes[RANDOM_CLIP_KEYS];
    float values[RANDOM_CLIP_TRACKS][3 * 4 * RANDOM_CLIP_KEYS];
    float rest[NKW_POSE_FLOATS(RANDOM_CLIP_JOINTS)], rest_floats[RANDOM_CLIP_FLOATS];
} random_clip;

/*
 * joints up to RANDOM_CLIP_JOINTS. variety 0: every property of every joint moves by LINEAR on one evenly spaced
 * timeline; 1: the same on an uneven one, some constant; 2: everything mixed; 3: every property of every joint by
 * CUBICSPLINE on one uneven timeline, rotations normalised where the number of joints is odd; 4: the same, segment by
 * segment CUBICSPLINE, LINEAR or STEP.
 */
void random_clip_draw(random_source *r, size_t joints, int variety, random_clip *clip);

/* What the tracks give one by one, over the rest. */
void random_clip_sample(const random_clip *clip, float time, float *pose, float *floats);

#ifdef __cplusplus
}
#endif

/* At key times, in the middle of two, elsewhere between them, outside, and a NaN. */
static inline float random_clip_time(random_source *r, const random_clip *c, int i)
{
    float keys[4] = {NAN, INFINITY, -1.0f, c->times[2][5]};
    const float *times = c->times[i % RANDOM_CLIP_LINES];
    int k = i % RANDOM_CLIP_KEYS;
    return i < 4                 ? keys[i]
           : i % 3 == 0          ? times[k]
           : i % 3 == 1 && k > 0 ? 0.5f * (times[k - 1] + times[k])
                                 : random_between(r, -0.2f, 1.4f);
}

#endif
