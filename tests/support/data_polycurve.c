/* SPDX-License-Identifier: MIT */
#include "data.h"
#include "hash.h"
#include "put.h"
#include "random.h"

#define SEGMENTS 4
#define STEPS    3
#define ENTRIES  NKW_POLYCURVE_LENGTHS(SEGMENTS, STEPS)
#define POINTS   400

static nkw_vec3_cubic cubics[SEGMENTS];
static nkw_vec3 points[POINTS];

static uint64_t hash_vec3(uint64_t hash, nkw_vec3 v)
{
    float x[3];
    put_vec3(x, v);
    return hash_floats(hash, x, 3);
}

static uint64_t hash_frame(uint64_t hash, nkw_curve_frame f)
{
    return hash_vec3(hash_vec3(hash_vec3(hash, f.tangent), f.normal), f.binormal);
}

static uint64_t hash_places(uint64_t hash, const nkw_polycurve *curve, random_source *r)
{
    float lengths[ENTRIES];
    nkw_polycurve_measure(curve, STEPS, lengths, ENTRIES);
    hash = hash_floats(hash, lengths, ENTRIES);
    for (int i = 0; i < 8; i++) {
        float length = lengths[ENTRIES - 1] * random_unit(r);
        nkw_segment at = nkw_polycurve_at_length(curve, lengths, NKW_POLYCURVE_LENGTHS(curve->count, STEPS), length);
        float place[2] = {(float)at.index, at.t};
        nkw_vec3_motion p = nkw_polycurve_evaluate(curve, at);
        hash = hash_floats(hash, place, 2);
        hash = hash_frame(hash, nkw_curve_frame_frenet(&p, random_vec3(r, -1.0f, 1.0f)));
        hash = hash_frame(hash, nkw_polycurve_frenet(curve, at, p.acceleration));
    }
    return hash;
}

uint64_t data_polycurve(void)
{
    random_source r = random_from(0x706f6c79);
    uint64_t hash = HASH_START;
    const nkw_vec3 zero = {0.0f, 0.0f, 0.0f};
    for (int round = 0; round < 80; round++) {
        nkw_curve_frame frames[ENTRIES];
        nkw_polycurve curve = {cubics, SEGMENTS, (nkw_cubic_kind)(round % 4)};
        float from = random_between(&r, -0.5f, 1.0f), to = random_between(&r, 0.0f, 1.5f);
        size_t count;
        nkw_vec3 direction = random_direction(&r);
        for (size_t i = 0; i < 4 * SEGMENTS; i++)
            cubics[i / 4].c[i % 4] = random_vec3(&r, -2.0f, 2.0f);
        /* On a line: segments that turn back. */
        for (size_t i = 0; i < 4 * SEGMENTS && round % 5 == 4; i++)
            cubics[i / 4].c[i % 4] = nkw_vec3_scale(direction, 0.25f * (float)(random_bits(&r) % 16));
        /* At rest at an end. */
        if (round % 5 == 3)
            cubics[round % 4].c[round % 2 ? 1 : 3] =
                curve.kind == NKW_CUBIC_BEZIER ? cubics[round % 4].c[round % 2 ? 0 : 2] : zero;
        float length = nkw_vec3_cubic_length(cubics, from, to, curve.kind);
        hash = hash_floats(hash, &length, 1);
        hash = hash_places(hash, &curve, &r);
        nkw_polycurve_frames(&curve, STEPS, random_vec3(&r, -1.0f, 1.0f), (nkw_polycurve_ends)(round / 4 % 2), frames,
                             ENTRIES);
        for (size_t i = 0; i < ENTRIES; i++)
            hash = hash_frame(hash, frames[i]);
        nkw_polycurve_flatten(&curve, 0.01f, points, POINTS, &count);
        for (size_t i = 0; i < count && i < POINTS; i++)
            hash = hash_vec3(hash, points[i]);
    }
    return hash;
}
