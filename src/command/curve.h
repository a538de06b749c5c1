/* SPDX-License-Identifier: MIT */
/** @file The curve of a track over time, as points for a plot. */
#ifndef CURVE_H
#define CURVE_H

#include "command.h"

enum { CURVE_COMPONENTS = 4 };

/** A run of points without a jump: between two keys, or between two equidistant times if there are many keys. */
typedef struct curve_run {
    size_t first, count; /**< of the points */
} curve_run;

/**
 * Values at `times`, and velocities at `middles`, between two points of a run; a run of n points has n - 1 velocities,
 * from the same index on. Velocities are per second, of rotations the angular velocity in radians per second.
 */
typedef struct curve {
    size_t component_count, velocity_count; /**< 3 or 4, and 3; of morph weights at most 4 */
    size_t point_count, run_count;
    float *times, *middles;
    float (*values)[CURVE_COMPONENTS], (*velocities)[CURVE_COMPONENTS];
    curve_run *runs;
} curve;

/** Samples a track from `start` to `end`. Returns 0 without memory. curve_free is due in either case. */
int curve_sample(curve *c, const nkw_clip_track *track, float start, float end);
void curve_free(curve *c);

#endif
