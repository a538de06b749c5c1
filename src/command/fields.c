/* SPDX-License-Identifier: MIT */
#include "fields.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

static int fail(fields *f, const char *what)
{
    f->fault = what;
    return 0;
}

int fields_next(fields *f)
{
    size_t n = 0;
    if (f->at == f->end)
        return 0;
    f->line++;
    for (; f->at < f->end && *f->at != '\n' && *f->at != '\r'; f->at++) {
        if (n + 1 == FIELDS_LINE)
            return fail(f, "the line is longer than 4000 characters");
        if (*f->at == '\0')
            return fail(f, "this is not text");
        f->text[n++] = *f->at;
    }
    f->text[n] = '\0';
    if (f->at < f->end && *f->at++ == '\r' && f->at < f->end && *f->at == '\n')
        f->at++;
    return 1;
}

static int is_blank(char c)
{
    return c == ' ' || c == '\t';
}

char *fields_start(char *text)
{
    while (is_blank(*text))
        text++;
    return text;
}

static char *trimmed(char *text)
{
    while (is_blank(*text) || *text == '"')
        text++;
    size_t n = strlen(text);
    while (n > 0 && (is_blank(text[n - 1]) || text[n - 1] == '"'))
        text[--n] = '\0';
    return text;
}

/* A comma between digits and tabs is a decimal one: 0,5<tab>1,25. */
static const char *separators_of(const char *text)
{
    if (strchr(text, ';'))
        return ";";
    return strchr(text, ',') && (!strchr(text, '\t') || strstr(text, ",\t")) ? "," : " \t";
}

/* Fields between blanks: any number of them. Otherwise an empty field counts, but not one at the end of the line. */
int fields_split(fields *f, char *text)
{
    const char *separators = separators_of(text);
    f->count = 0;
    text = trimmed(text);
    while (*text) {
        const size_t n = strcspn(text, separators);
        char *next = text + n + (text[n] != '\0');
        if (f->count == FIELDS_MOST)
            return fail(f, "the line has more than 128 fields");
        text[n] = '\0';
        text = trimmed(text);
        if (*text || *separators != ' ')
            f->field[f->count++] = text;
        text = next;
    }
    return 1;
}

int fields_number(const char *text, float *number)
{
    char copy[64], *end;
    size_t n = 0;
    for (; text[n]; n++) {
        if (n + 1 == sizeof copy || !strchr("0123456789+-.,eE", text[n]))
            return 0;
        copy[n] = text[n];
        if (text[n] == ',')
            copy[n] = '.';
    }
    copy[n] = '\0';
    const double value = strtod(copy, &end);
    *number = (float)value;
    return end != copy && *end == '\0' && value >= -(double)FLT_MAX && value <= (double)FLT_MAX;
}

const char *fields_name(const char *text, char out[FIELDS_NAME])
{
    size_t n = 0;
    for (; *text && n + 1 < FIELDS_NAME; text++) {
        const char c = *text >= 'A' && *text <= 'Z' ? (char)(*text - 'A' + 'a') : *text;
        if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'))
            out[n++] = c;
    }
    out[n] = '\0';
    return out;
}
