/* SPDX-License-Identifier: MIT */
#include "options.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int options_complain(const char *program, const char *what, const char *which)
{
    fprintf(stderr, "%s: %s: %s\nTry %s --help.\n", program, what, which, program);
    return 0;
}

static int read_value(const char *program, const option *o, const char *text)
{
    char *end;
    if (o->kind == OPTION_TEXT) {
        *(const char **)o->out = text;
        return 1;
    }
    double x = strtod(text, &end);
    if (end == text || *end || !(x >= o->low && x <= o->high))
        return options_complain(program, "not a number in range", text);
    if (o->kind == OPTION_NUMBER) {
        *(double *)o->out = x;
        return 1;
    }
    *(long *)o->out = (long)x;
    return (double)(long)x == x || options_complain(program, "not a whole number", text);
}

static const option *find(const option *known, size_t count, const char *name)
{
    for (size_t k = 0; k < count; k++)
        if (strcmp(known[k].name, name) == 0)
            return &known[k];
    return NULL;
}

int options_read(const char *program, const option *known, size_t count, int argc, char **argv, int *help)
{
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0) {
            *help = 1;
            continue;
        }
        const option *o = find(known, count, argv[i]);
        if (!o)
            return options_complain(program, "unknown option", argv[i]);
        if (o->given)
            *o->given = 1;
        if (o->kind == OPTION_FLAG)
            *(int *)o->out = 1;
        else if (++i == argc)
            return options_complain(program, "value missing after", argv[i - 1]);
        else if (!read_value(program, o, argv[i]))
            return 0;
    }
    return 1;
}
