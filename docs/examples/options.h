/* SPDX-License-Identifier: MIT */
/** @file The command line of the example programs: --name, --name VALUE, --help and -h. */
#ifndef EXAMPLES_OPTIONS_H
#define EXAMPLES_OPTIONS_H

#include <stddef.h>

typedef enum option_kind {
    OPTION_FLAG,  /* int: becomes 1 */
    OPTION_TEXT,  /* const char * */
    OPTION_WHOLE, /* long, low..high */
    OPTION_NUMBER /* double, low..high */
} option_kind;

typedef struct option {
    const char *name;
    option_kind kind;
    void *out;
    double low, high;
    int *given; /* becomes 1 where the option stands; may be NULL */
} option;

/** Reads all; the last of equal ones counts. *help becomes 1 for --help. What is wrong is said on stderr: gives 0. */
int options_read(const char *program, const option *known, size_t count, int argc, char **argv, int *help);

/** Says on stderr what is wrong and with which word; gives 0. */
int options_complain(const char *program, const char *what, const char *which);

#endif
