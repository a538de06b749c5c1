/* SPDX-License-Identifier: MIT */
#include "json.h"

#include "command.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

json_t *json_text(const char *text)
{
    json_t *string = json_string(text);
    char *copy = string ? NULL : malloc(strlen(text) + 1);
    if (!copy)
        return string;
    strcpy(copy, text);
    for (char *c = copy; *c; c++)
        if ((unsigned char)*c > 127)
            *c = '?';
    string = json_string(copy);
    free(copy);
    return string;
}

json_t *json_number(double number)
{
    return isfinite(number) ? json_real(number) : json_null();
}

static int put(FILE *f, json_t *value, size_t flags)
{
    if (!value)
        return 0;
    int failed = json_dumpf(value, f, flags | JSON_ENCODE_ANY | JSON_REAL_PRECISION(9)) != 0;
    json_decref(value);
    return !failed;
}

int json_put(FILE *f, json_t *value)
{
    return put(f, value, 0);
}

int json_put_lines(FILE *f, json_t *value)
{
    int fine = put(f, value, JSON_INDENT(1));
    fputc('\n', f);
    return fine;
}

json_t *json_unreadable(void)
{
    const nkw_import_error *e = input_error();
    return json_pack("{s:i, s:o, s:{s:o, s:o}}", "schema", JSON_SCHEMA, "file", json_text(e->file), "error", "place",
                     json_text(e->place), "reason", json_text(e->reason));
}
