/* SPDX-License-Identifier: MIT */
#include "data.h"
#include "hash.h"
#include "random.h"

#define KEYS  11
#define WIDTH 3

static float times[KEYS], values[KEYS * WIDTH], triples[3 * KEYS * WIDTH];

static void draw(random_source *r, unsigned round)
{
    for (size_t k = 0; k < KEYS; k++) {
        times[k] = k ? times[k - 1] + random_between(r, 0.125f, 2.0f) : random_between(r, -2.0f, 2.0f);
        for (size_t c = 0; c < WIDTH; c++)
            values[k * WIDTH + c] = random_between(r, -4.0f, 4.0f);
    }
    if (round % 4 == 1)
        times[5] = times[4];
}

/* The tangents, and the track that they make at some times. */
static uint64_t hash_spline(uint64_t hash, const nkw_spline *s, random_source *r)
{
    NKW_STACK_WORK(work, NKW_SPLINE_WORK(KEYS));
    float at[3 * WIDTH];
    nkw_tangent_span to = {triples, triples + 2 * WIDTH, 3 * WIDTH};
    nkw_track track = {times, triples, KEYS, WIDTH, NKW_TRACK_FLOATS, NKW_INTERPOLATION_CUBICSPLINE, NULL};
    if (nkw_spline_tangents(s, to, NULL, work) != NKW_OK)
        return 0;
    for (size_t k = 0; k < KEYS; k++)
        for (size_t c = 0; c < WIDTH; c++)
            triples[(3 * k + 1) * WIDTH + c] = values[k * WIDTH + c];
    hash = hash_floats(hash, triples, 3 * KEYS * WIDTH);
    for (size_t i = 0; i < 8; i++) {
        float time = nkw_lerp(times[0], times[KEYS - 1], random_unit(r));
        const nkw_motion_span out = {at, at + WIDTH, at + 2 * WIDTH};
        nkw_track_sample_motion(&track, time, out);
        hash = hash_floats(hash, at, 3 * WIDTH);
    }
    return hash;
}

/* A curve of three components of each degree. */
uint64_t data_nurbs(void)
{
    random_source r = random_from(0x6e7572);
    uint64_t hash = HASH_START;
    for (unsigned round = 0; round < 160; round++) {
        float knots[NKW_NURBS_KNOTS(20, NKW_NURBS_DEGREE)], points[60], weights[20], at[9];
        size_t degree = round % (NKW_NURBS_DEGREE + 1), count = degree + 1 + round % 5;
        nkw_nurbs c = {points, round % 3 ? weights : NULL, knots, count, degree, 3, 3};
        nkw_nurbs_make_knots(count, degree, -1.0f, 2.5f, (nkw_nurbs_knots_kind)(round % 2), knots);
        for (size_t k = degree + 1; round % 4 > 1 && k < count; k++)
            knots[k] = nkw_lerp(knots[k], knots[k - 1], random_unit(&r));
        for (size_t i = 0; i < 3 * count; i++)
            points[i] = random_between(&r, -4.0f, 4.0f);
        for (size_t i = 0; i < count; i++)
            weights[i] = random_between(&r, 0.25f, 4.0f);
        for (size_t i = 0; i < 8; i++) {
            nkw_nurbs_evaluate(&c, random_between(&r, -1.25f, 2.75f), (nkw_motion_span){at, at + 3, at + 6});
            hash = hash_floats(hash, at, 9);
        }
        hash = hash_floats(hash, knots, NKW_NURBS_KNOTS(count, degree));
    }
    return hash;
}

uint64_t data_spline(void)
{
    random_source r = random_from(0x73706c);
    uint64_t hash = HASH_START;
    for (unsigned round = 0; round < 20 * (NKW_SPLINE_C2 + 1); round++) {
        nkw_tcb tcb[KEYS];
        float ends[2 * WIDTH], knots[KEYS];
        draw(&r, round);
        for (size_t k = 0; k < KEYS; k++) {
            tcb[k].tension = random_between(&r, -1.0f, 1.0f);
            tcb[k].continuity = random_between(&r, -1.0f, 1.0f);
            tcb[k].bias = random_between(&r, -1.0f, 1.0f);
        }
        for (size_t c = 0; c < 2 * WIDTH; c++)
            ends[c] = random_between(&r, -4.0f, 4.0f);
        nkw_spline s = {times,
                        values,
                        KEYS,
                        WIDTH,
                        WIDTH,
                        (nkw_spline_method)(round % (NKW_SPLINE_C2 + 1)),
                        (nkw_spline_ends)(round % 5 % 3),
                        tcb[0].tension,
                        tcb,
                        ends};
        hash = hash_spline(hash, &s, &r);
        nkw_spline_knots(&s, 0.25f * (float)(round % 8), knots);
        hash = hash_floats(hash, knots, KEYS);
    }
    return hash;
}
