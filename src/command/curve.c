/* SPDX-License-Identifier: MIT */
#include "curve.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/orient.h>
#include <nakawari/quat.h>

/* Points of a curve, about one for two pixels; with more keys than RUNS, a key may be between two points. */
enum { POINTS = 240, RUNS = 960, LEAST = 2, WIDEST = 1024 };

/* The bounds of the runs: the start, the keys between, the end. */
static size_t find_bounds(const nkw_track *track, float start, float end, float *bounds)
{
    size_t count = 0;
    bounds[count++] = start;
    if (track->count <= RUNS)
        for (size_t k = 0; k < track->count; k++) {
            float time = track->times[k];
            if (time > bounds[count - 1] && time < end)
                bounds[count++] = time;
        }
    else
        for (size_t k = 1; k < RUNS; k++)
            bounds[count++] = start + (end - start) * ((float)k / (float)RUNS);
    if (end > bounds[count - 1])
        bounds[count++] = end;
    return count;
}

static void sample_point(curve *c, const nkw_clip_track *track, float time, float *value)
{
    float all[WIDEST]; /* curve_sample rejects wider values */
    nkw_track_sample(&track->track, time, NULL, all);
    memcpy(value, all, c->component_count * sizeof *value);
}

static void sample_velocity(curve *c, const nkw_clip_track *track, size_t at)
{
    const float *a = c->values[at], *b = c->values[at + 1];
    float step = c->times[at + 1] - c->times[at], *v = c->velocities[at];
    c->middles[at] = c->times[at] + 0.5f * step;
    if (track->target == NKW_CLIP_ROTATION) {
        nkw_quat p = {a[0], a[1], a[2], a[3]}, q = {b[0], b[1], b[2], b[3]};
        nkw_vec3 w = nkw_quat_angular_velocity(nkw_quat_normalize(p), nkw_quat_normalize(q), step);
        v[0] = w.x, v[1] = w.y, v[2] = w.z;
        return;
    }
    for (size_t i = 0; i < c->component_count; i++)
        v[i] = step > 0.0f ? (b[i] - a[i]) / step : 0.0f;
}

/* The end of a run is the last time before its bound: STEP keeps its value until then. */
static void sample_run(curve *c, const nkw_clip_track *track, float from, float to, size_t count)
{
    size_t first = c->point_count;
    for (size_t i = 0; i <= count; i++) {
        float time = from + (to - from) * ((float)i / (float)count);
        if (i == count)
            time = nextafterf(to, from);
        c->times[c->point_count] = time;
        sample_point(c, track, time, c->values[c->point_count++]);
    }
    for (size_t i = first; i + 1 < c->point_count; i++)
        sample_velocity(c, track, i);
    curve_run run = {first, c->point_count - first};
    c->runs[c->run_count++] = run;
}

int curve_sample(curve *c, const nkw_clip_track *track, float start, float end)
{
    float bounds[RUNS + 2];
    memset(c, 0, sizeof *c);
    if (track->track.width > WIDEST)
        return 1;
    size_t width = track->track.width, runs = find_bounds(&track->track, start, end, bounds) - 1;
    size_t room = 2 * POINTS + (LEAST + 1) * (runs + 1);
    c->component_count = width < CURVE_COMPONENTS ? width : CURVE_COMPONENTS;
    c->velocity_count = track->target == NKW_CLIP_ROTATION ? 3 : c->component_count;
    c->times = calloc(room, sizeof *c->times);
    c->middles = calloc(room, sizeof *c->middles);
    c->values = calloc(room, sizeof *c->values);
    c->velocities = calloc(room, sizeof *c->velocities);
    c->runs = calloc(runs + 1, sizeof *c->runs);
    if (!c->times || !c->middles || !c->values || !c->velocities || !c->runs)
        return 0;
    size_t count = runs && POINTS / runs > LEAST ? POINTS / runs : LEAST;
    for (size_t i = 0; i < runs; i++)
        sample_run(c, track, bounds[i], bounds[i + 1], count);
    return 1;
}

void curve_free(curve *c)
{
    free(c->times);
    free(c->middles);
    free(c->values);
    free(c->velocities);
    free(c->runs);
}
