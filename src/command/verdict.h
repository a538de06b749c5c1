/* SPDX-License-Identifier: MIT */
/** @file nakawari exercise --check: reads a student's numbers and prints what compare.h finds. */
#ifndef VERDICT_H
#define VERDICT_H

#include "answers.h"

/**
 * Reads the file, or the standard input for "-", compares it with the scene and prints the result. Returns COMMAND_FINE
 * if all rows agree, COMMAND_FINDINGS if some differ, COMMAND_MISUSE if a line cannot be read, which is reported on
 * stderr with its number.
 */
int verdict_print(const scene *s, const char *path, const answers_options *read, const compare_options *compare);

#endif
