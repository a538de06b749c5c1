/* SPDX-License-Identifier: MIT */
/**
 * @file
 * The reader of a student's numbers: tables with or without names of columns, and what the exercise's program prints.
 *
 *     time,x,y,z,qx,qy,qz,qw      names in any order and case; fields between commas, semicolons, tabs or blanks
 *     0.1 -0.9 0.55 -1.35 ...     without names: 3, 4, 6, 7, 9, 12 or 16 numbers after the time
 *     Position: Hermit, Orientation: Quat
 *     Time: 0.10                  and below it, in any lines, as many numbers
 */
#ifndef ANSWERS_H
#define ANSWERS_H

#include "exercise/compare.h"

typedef enum answers_unit { ANSWERS_ANY_UNIT, ANSWERS_RADIANS, ANSWERS_DEGREES } answers_unit;

typedef struct answers_options {
    const char *scene; /**< rows with another name in a column "scene" are left out */
    answers_unit unit; /**< of angles whose column does not state it; ANY: degrees if one is above 10 */
    int by_rows; /**< matrices without names of elements are written row by row */
} answers_options;

typedef struct answers_fault {
    size_t line; /**< from 1; 0: of the whole text */
    const char *what;
} answers_fault;

/** At least as many rows as the text can have. */
size_t answers_most(const char *text, size_t bytes);

/** Reads all rows, at most `capacity`. Returns 0 with the fault if a line cannot be read or there is no row. */
int answers_read(const char *text, size_t bytes, const answers_options *o, compare_row *rows, size_t capacity,
                 size_t *count, answers_fault *fault);

#endif
