/* SPDX-License-Identifier: MIT */
/** @file The output of `nakawari sample`: rows of numbers as CSV, JSON or raw bytes. */
#ifndef TABLE_H
#define TABLE_H

#include "command.h"

typedef enum table_format { TABLE_CSV, TABLE_JSON, TABLE_RAW } table_format;

typedef struct table {
    FILE *file;
    table_format format;
    const char *what; /**< "local" ... */
    const char *columns; /**< "tx,ty,tz" ... */
    int kind; /**< in the header of raw output */
    size_t width; /**< numbers in a row */
    size_t rows_per_time; /**< for the header of raw output */
    int has_targets; /**< a column of texts more */
    const char *target; /**< of the next row */
    long clip;
    float time;
    size_t row_count; /**< so far */
    int failed; /**< no memory */
} table;

/** Begins the output; `file` is the name of the document. */
void table_begin(table *t, const char *file);
void table_end(table *t);
/** Begins a clip with `time_count` times; then each time. */
void table_clip(table *t, long clip, size_t time_count);
void table_time(table *t, float time);
void table_row(table *t, size_t index, const char *name, const float *numbers);

#endif
