/* SPDX-License-Identifier: MIT */
/*
 * Measured errors against the declared ones.
 *
 * An accuracy program measures every function of one header and reports each measurement as a row. The row
 * is compared with the number in the `Error` line of the comment before the function's prototype; the
 * program fails where the measurement is larger, and where a function with a number got no row.
 *
 *     int main(int argc, char **argv)
 *     {
 *         accuracy a = accuracy_begin("scalar.h", argc, argv);
 *         ...accuracy_row(&a, "nkw_sin", "all floats", worst, rms, count, witness);
 *         return accuracy_end(&a);
 *     }
 *
 * Arguments: --exhaustive    every float instead of a stride
 *            --effort=N      N times as many samples and changes in a search; N may be a fraction
 *            --only=NAME     one function
 *            --out=FILE      the rows as part of a Markdown table
 *
 * Units: ULP = unit in the last place of the exact result in binary32 (2^-149 at least); u = 2^-24 times the
 * magnitude that the Error line names. Headers are read from NKW_HEADER_DIR.
 */
#ifndef NAKAWARI_TESTS_ACCURACY_H
#define NAKAWARI_TESTS_ACCURACY_H

#include <stdint.h>
#include <stdio.h>

#define ACCURACY_NAMES 128

typedef struct accuracy {
    const char *header;
    char *text; /* the header, owned */
    const char *only;
    FILE *out;
    int exhaustive;
    double effort;
    int failures;
    int named;
    char names[ACCURACY_NAMES][48]; /* functions that got a row */
} accuracy;

typedef struct accuracy_error {
    double number; /* negative: no Error line, or one without a number */
    char unit[8]; /* "ULP", "u" or "" */
} accuracy_error;

/* The largest error so far, where, and the mean square. */
typedef struct accuracy_worst {
    double worst;
    double squares;
    uint64_t count;
    float witness[32];
    int arguments;
} accuracy_worst;

accuracy accuracy_begin(const char *header, int argc, char **argv);
/* Non-zero where the function is to be measured in this run. */
int accuracy_wants(const accuracy *a, const char *function);
/* 1 for an exhaustive run, else `otherwise`. */
uint32_t accuracy_stride(const accuracy *a, uint32_t otherwise);

/* The number and the unit in the Error line of the function's comment. */
accuracy_error declared_error(const accuracy *a, const char *function);

/* The distance of got from the exact result in ULPs of the latter; 0 where both are NaN, or the same
 * infinity; an exact value that rounds to an infinity counts as that. */
double accuracy_ulps(float got, double exact);
/* The same in u of `magnitude`. */
double accuracy_units(double got, double exact, double magnitude);

accuracy_worst accuracy_worst_begin(int arguments);
void accuracy_worst_add(accuracy_worst *w, double error, const float *arguments);

void accuracy_row(accuracy *a, const char *function, const char *region, const accuracy_worst *w);
/* Prints what is missing, frees, and gives the exit code. */
int accuracy_end(accuracy *a);

#endif
