/* SPDX-License-Identifier: CC0-1.0 */
/* What a library answers for run.c. */
#ifndef VECTORS_ADAPTER_H
#define VECTORS_ADAPTER_H

enum { VECTORS_NUMBERS = 64, VECTORS_VALUES = 12 };

typedef struct vectors_value {
    char name[32];
    int count;
    double x[VECTORS_NUMBERS];
} vectors_value;

/*
 * The function of a group: `in` are its arguments in the order of the file. Writes the results to `out` (each with its
 * count) and returns 1; returns 0 for a function that the library does not have.
 */
int vectors_answer(const char *group, const vectors_value *in, vectors_value *out);

#endif
