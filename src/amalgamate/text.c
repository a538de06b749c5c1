/* SPDX-License-Identifier: MIT */
#include "text.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void fail(const char *what, const char *which)
{
    fprintf(stderr, "amalgamate: %s: %s\n", which, what);
    exit(1);
}

static void *grown(void *data, size_t bytes)
{
    void *r = realloc(data, bytes);
    if (!r)
        fail("out of memory", "realloc");
    return r;
}

void text_add(text *t, const char *data, size_t length)
{
    if (t->length + length + 1 > t->capacity) {
        t->capacity = 2 * (t->length + length + 1);
        t->data = (char *)grown(t->data, t->capacity);
    }
    memcpy(t->data + t->length, data, length);
    t->length += length;
    t->data[t->length] = 0;
}

void text_put(text *t, const char *string)
{
    text_add(t, string, strlen(string));
}

text text_read(const char *path)
{
    text t = {NULL, 0, 0};
    char part[4096];
    size_t n;
    FILE *file = fopen(path, "rb");
    if (!file)
        fail("cannot be read", path);
    text_put(&t, "");
    while ((n = fread(part, 1, sizeof part, file)) > 0)
        text_add(&t, part, n);
    if (ferror(file))
        fail("cannot be read", path);
    fclose(file);
    return t;
}

void text_write(const char *path, const text *t)
{
    FILE *file = fopen(path, "wb");
    if (!file || fwrite(t->data, 1, t->length, file) != t->length || fclose(file))
        fail("cannot be written", path);
}

char *text_copy(const char *data, size_t length)
{
    char *r = (char *)grown(NULL, length + 1);
    memcpy(r, data, length);
    r[length] = 0;
    return r;
}

int names_have(const names *set, const char *name, size_t length)
{
    for (size_t i = 0; i < set->count; i++)
        if (strncmp(set->name[i], name, length) == 0 && set->name[i][length] == 0)
            return 1;
    return 0;
}

void names_add(names *set, const char *name, size_t length)
{
    if (names_have(set, name, length))
        return;
    if (set->count == set->capacity) {
        set->capacity = 2 * set->capacity + 16;
        set->name = (char **)grown(set->name, set->capacity * sizeof *set->name);
    }
    set->name[set->count++] = text_copy(name, length);
}

static size_t directive_length(const char *at)
{
    size_t n = 0;
    while (at[n] && at[n] != '\n') {
        if (at[n] == '\\' && at[n + 1] == '\n')
            n++;
        else if (at[n] == '/' && at[n + 1] == '*') {
            const char *end = strstr(at + n + 2, "*/");
            if (!end)
                fail("a comment does not end", "directive");
            n = (size_t)(end - at) + 1;
        }
        n++;
    }
    return n;
}

static size_t quoted_length(const char *at)
{
    size_t n = 1;
    while (at[n] && at[n] != at[0])
        n += at[n] == '\\' ? 2 : 1;
    return n + 1;
}

static int is_word(char c)
{
    return isalnum((unsigned char)c) || c == '_';
}

static size_t number_length(const char *at)
{
    size_t n = 1;
    while (is_word(at[n]) || at[n] == '.' || ((at[n] == '+' || at[n] == '-') && strchr("eEpP", at[n - 1])))
        n++;
    return n;
}

token token_next(const char *at, int *line)
{
    token t = {OTHER, at, 1};
    const char c = at[0];
    if (!c) {
        t.kind = END, t.length = 0;
        return t;
    }
    if (isspace((unsigned char)c)) {
        t.kind = SPACE;
        *line = *line || c == '\n';
        return t;
    }
    if (c == '/' && at[1] == '*') {
        const char *end = strstr(at + 2, "*/");
        if (!end)
            fail("a comment does not end", "text");
        t.kind = COMMENT, t.length = (size_t)(end - at) + 2;
        return t;
    }
    if (c == '#' && *line) {
        t.kind = DIRECTIVE, t.length = directive_length(at);
        return t;
    }
    *line = 0;
    if (isalpha((unsigned char)c) || c == '_') {
        t.kind = WORD;
        while (is_word(at[t.length]))
            t.length++;
    } else if (c == '"' || c == '\'') {
        t.length = quoted_length(at);
    } else if (isdigit((unsigned char)c) || (c == '.' && isdigit((unsigned char)at[1]))) {
        t.length = number_length(at);
    } else if (c == '-' && at[1] == '>') {
        t.length = 2;
    }
    return t;
}

int token_is(token t, const char *string)
{
    return t.length == strlen(string) && memcmp(t.at, string, t.length) == 0;
}
