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
    const void *data; /**< the file */
    size_t bytes;
} check;

/** One track: key times, values, what a tolerance would drop. */
void check_track(check *c, size_t animation, size_t track);
/** Keys that a tolerance would drop, and constant tracks. Only for tracks without errors. */
void check_spare_keys(check *c, size_t animation, size_t track);
/** Tangents, times and keys that lie far from those around them. Only for tracks without errors. */
void check_outliers(check *c, size_t animation, size_t track);
/** Whether the clip ends as it begins, in its place and its velocity, and feet that slide. The clip has no errors. */
void check_motion(check *c, size_t animation);
/** Scenes, names of joints, and how large skins are in the rest pose. */
void check_scene(check *c);
/** What the document does not have of a glTF file: matrices of animated nodes, bounds, images. */
void check_file(check *c);
/** Nodes, skins and vertices. */
void check_model(check *c);

/** Prints the errors and warnings of a file that was written. */
void check_written(const char *path);
/** How many findings of these kinds, separated by commas, check_file has. */
size_t check_count(const nkw_document *document, const void *data, size_t bytes, const char *kinds);

/** A finding at a key of a track; key -1: the track. */
finding check_finding(const check *c, size_t animation, size_t track, long key, severity level, const char *what);
/** A finding of a node, skin or mesh, whose number in the file is `number`. */
finding check_finding_at(severity level, const char *what, const char *object, const char *name, size_t number);
/** A difference of two values of a track as a distance in model space: the largest that it can cause. */
double check_distance(const check *c, const nkw_clip_track *track, size_t joint, const float *a, const float *b);
/** The value of a key, without its tangents. */
const float *check_value(const nkw_track *track, size_t key);

#endif
