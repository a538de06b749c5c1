/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Logs of fingerprints: where two runs part. A log is text:
 *
 *     frame NUMBER HASH                     a frame: any text without blanks, and 16 hexadecimal digits
 *     joint INDEX NUMBERS [NAME]            of this frame: translation x y z, rotation x y z w, scale x y z
 *     floats NUMBERS                        of this frame; further such lines continue
 */
#ifndef DIFFLOG_H
#define DIFFLOG_H

/** Whether a file begins as a log does. The standard input does not. */
int difflog_is(const char *path);

typedef struct difflog_request {
    const char *a, *b;
    int json;
    float tolerance; /**< of numbers that are logged */
} difflog_request;

/** Compares two logs frame by frame up to the first that differs. Returns the exit code. */
int difflog_run(const difflog_request *request);

#endif
