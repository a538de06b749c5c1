/* SPDX-License-Identifier: MIT */
/** @file Lines of a text and their fields, for tables that others have written. */
#ifndef FIELDS_H
#define FIELDS_H

#include <stddef.h>

enum { FIELDS_LINE = 4096, FIELDS_MOST = 128, FIELDS_NAME = 32 };

typedef struct fields {
    const char *at, *end; /**< what is not read yet */
    size_t line; /**< of the text, from 1 */
    char text[FIELDS_LINE];
    char *field[FIELDS_MOST];
    size_t count;
    const char *fault; /**< why a line cannot be read, or NULL */
} fields;

/** The next line without its end, LF, CR or CRLF. Returns 0 after the last, and with a fault if it is too long. */
int fields_next(fields *f);

/**
 * Cuts a text, a part of f->text, into fields: at semicolons, else at commas, else at blanks and tabs. Blanks and quotes
 * around a field are left out. Commas of a line with tabs are decimal ones. Returns 0 with a fault if there are too many.
 */
int fields_split(fields *f, char *text);

/** A number with a point or a comma, finite as a float. Returns 0 if it is none. */
int fields_number(const char *text, float *number);

/** The first letters and digits in lower case: "Pos_Method" and "p.x" as "posmethod" and "px". Returns `out`. */
const char *fields_name(const char *text, char out[FIELDS_NAME]);

/** Without the blanks before it. */
char *fields_start(char *text);

#endif
