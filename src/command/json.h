/* SPDX-License-Identifier: MIT */
/** @file JSON as the subcommands write it, by jansson. */
#ifndef COMMAND_JSON_H
#define COMMAND_JSON_H

#include <stdio.h>

#include <jansson.h>

/** The version of the members of the objects of `check` and `info`. */
#define JSON_SCHEMA 1

/** The object of the file of input_error: schema, file, error with place and reason. */
json_t *json_unreadable(void);
/** A new string; a text that is not UTF-8 becomes one with '?' in place of the bytes above 127. */
json_t *json_text(const char *text);
/** A new number; null if it is not finite. */
json_t *json_number(double number);
/** Writes a value in one line with nine significant digits, and releases it. Returns 0 if it is NULL: no memory. */
int json_put(FILE *f, json_t *value);
/** The same over many lines, indented, with a line end. */
int json_put_lines(FILE *f, json_t *value);

#endif
