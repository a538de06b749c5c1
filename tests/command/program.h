/* SPDX-License-Identifier: MIT */
/** @file Runs the program nakawari. NKW_PROGRAM is its path, NKW_CHARACTER that of the committed model. */
#ifndef TESTS_PROGRAM_H
#define TESTS_PROGRAM_H

#include "expect.h"

/**
 * Runs `nakawari ARGUMENTS`, formatted as by printf, in the shell. Returns what it prints on its standard output, to be
 * freed; `2>&1` in the arguments adds the standard error. *code receives its exit code; NULL: it must be 0.
 */
char *program_run(int *code, const char *arguments, ...);

/** Fails unless the program ends with `code` and prints `text` somewhere on either output. */
void program_says(int code, const char *text, const char *arguments);

/** The number of lines of a text that contain `part`. */
size_t lines_with(const char *text, const char *part);

#endif
