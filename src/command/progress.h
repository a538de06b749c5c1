/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Progress of long work: one line on the standard error, if that is a terminal and the work has taken half a second.
 *
 *     progress p = progress_begin("drawing frame", count, NULL);
 *     for (size_t k = 0; k < count; k++) {
 *         progress_at(&p, k);
 *         ...
 *     }
 *     progress_end(&p);
 */
#ifndef PROGRESS_H
#define PROGRESS_H

#include <stdio.h>

typedef struct progress {
    const char *what; /**< NULL: nothing is shown */
    size_t total;
    double began, shown; /**< seconds of a clock */
    int width; /**< characters of the line on the terminal */
} progress;

/**
 * Begins work of `total` steps. `lines` is a file that the work itself writes line by line, or NULL: on a terminal
 * these lines are progress enough, and nothing is shown.
 */
progress progress_begin(const char *what, size_t total, FILE *lines);
/** The work is at step `done`: redraws the line ten times a second at most. */
void progress_at(progress *p, size_t done);
/** Removes the line, until progress_at draws it again. Due before anything else is printed on the terminal. */
void progress_end(progress *p);

/** Shows nothing from now on: --quiet. */
void progress_silence(void);

#endif
