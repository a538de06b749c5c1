/* SPDX-License-Identifier: MIT */
/** @file All key times of clips. */
#ifndef TIMES_H
#define TIMES_H

#include "command.h"

typedef struct times {
    float *times; /**< ascending, without equal ones */
    size_t count;
} times;

/**
 * The key times of clip i of a and clip k of b, and the times half-way between two of them; 0 if there are no keys.
 * Returns 0 and reports without memory. times_free is due in either case.
 */
int times_of_clips(times *t, const nkw_document *a, size_t i, const nkw_document *b, size_t k);
void times_free(times *t);

#endif
