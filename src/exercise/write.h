/* SPDX-License-Identifier: MIT */
/** @file A scene as files: the tables of its matrices by both rules, its pictures, and one page of all. */
#ifndef REPORT_H
#define REPORT_H

#include "scene.h"

/** A method of positions or orientations by its name; the last of a list has none. */
typedef struct report_method {
    const char *name;
    int method;
} report_method;

/** linear, hermite, bezier ...; none, euler, quat ...; exercise, library. */
extern const report_method report_positions[], report_orientations[], report_rules[];

/** NULL if the list has no such name. */
const report_method *report_find(const char *name, const report_method *list);

typedef struct report_options {
    const char *program; /**< for messages */
    const char *folder; /**< exists; at most 4000 characters */
    double step; /**< seconds between the rows of a table */
    const char *page; /**< a link to the page of exhibits, or NULL */
    const char *docs; /**< a link to the folder docs, or NULL */
    int joints, character; /**< whether the page shows the pictures of nakawari-joints, of nakawari render */
} report_options;

enum { REPORT_ROWS_MAX = 1000000 };

/** The number of rows of a table for one pair of methods. */
long report_rows(const scene *s, const report_options *o);

/** Writes all files and prints the summary. Returns 0 and reports on stderr if a file cannot be written. */
int report_write(const scene *s, const report_options *o);

#endif
