/* SPDX-License-Identifier: MIT */
/**
 * @file
 * The classic mistakes of the exercise: each evaluates one wrong formula at one time. The formulas are numbered as in
 * the exercise's text (docs/coursework.md).
 */
#ifndef MISTAKE_H
#define MISTAKE_H

#include "scene.h"

/** What the right program computes at a time, by the scene's rule: the numbers that the wrong formulas start from. */
typedef struct attempt {
    const scene *s;
    float time;
    int method; /**< an nkw_position_method or nkw_orientation_method */
    nkw_keyframe_trace right;
} attempt;

typedef struct mistake {
    const char *name, *where; /**< "if NAME in WHERE" */
    int method; /**< of which it is a mistake; MISTAKE_ANY: of all */
    nkw_vec3 (*position)(const attempt *a); /**< NULL for a mistake of orientations */
    nkw_mat3 (*orientation)(const attempt *a); /**< NULL for a mistake of positions */
} mistake;

enum { MISTAKE_ANY = -1 };

/** Mistakes of positions and of orientations, the more specific ones first. The last has no name. */
extern const mistake position_mistakes[], orientation_mistakes[];

#endif
