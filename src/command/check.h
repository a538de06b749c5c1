/* SPDX-License-Identifier: MIT */
/** @file The checks of `nakawari check`. docs/command.md derives each threshold. */
#ifndef CHECK_H
#define CHECK_H

#include "extent.h"
#include "finding.h"

/** What the checks share. */
typedef struct check {
    const nkw_document *document;
    findings found;
    extent extent;
    float tolerance; /**< a distance in model space that is not seen */
} check;

/** One track: key times, values, what a tolerance would drop. */
void check_track(check *c, size_t animation, size_t track);
/** Keys that a tolerance would drop, and constant tracks. Only for tracks without errors. */
void check_spare_keys(check *c, size_t animation, size_t track);
/** Whether the clip ends as it begins. The clip must have no errors. */
void check_loop(check *c, size_t animation);
/** Nodes, skins and vertices. */
void check_model(check *c);

/** A finding at a key of a track; key -1: the track. */
finding check_finding(const check *c, size_t animation, size_t track, long key, severity level, const char *what);
/** The value of a key, without its tangents. */
const float *check_value(const nkw_track *track, size_t key);

#endif
