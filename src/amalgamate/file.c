/* SPDX-License-Identifier: MIT */
#include "file.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PATH = 1024 };

token directive_word(token directive, token *argument)
{
    int line = 0;
    const char *end = directive.at + directive.length;
    token t = token_next(directive.at + 1, &line);
    while (t.kind == SPACE && t.at < end)
        t = token_next(t.at + t.length, &line);
    *argument = token_next(t.at + t.length, &line);
    while (argument->kind == SPACE && argument->at < end)
        *argument = token_next(argument->at + argument->length, &line);
    if (argument->at >= end)
        argument->length = 0;
    return t;
}

const char *include_name(token directive)
{
    static char name[PATH];
    token argument;
    if (!token_is(directive_word(directive, &argument), "include"))
        return NULL;
    const char *begin = argument.at + 1;
    const char close = argument.at[0] == '<' ? '>' : '"';
    const char *end = strchr(begin, close);
    if (!end || end - begin >= PATH || (close == '>' && strncmp(begin, "nakawari/", 9) != 0))
        return NULL;
    memcpy(name, begin, (size_t)(end - begin));
    name[end - begin] = 0;
    return name;
}

/* The declaration at the depth 0 that is read. */
typedef struct statement {
    const char *begin;
    int is_static, is_typedef, is_enum, has_body, parens;
    token function, last, before; /* the first name before "(", the two tokens before */
} statement;

static int is_attribute(token t)
{
    int upper = 0, lower = 0;
    for (size_t i = 0; i < t.length; i++) {
        upper |= isupper((unsigned char)t.at[i]) != 0;
        lower |= islower((unsigned char)t.at[i]) != 0;
    }
    return (upper && !lower) || token_is(t, "__attribute__") || token_is(t, "_Pragma");
}

static int begins(token t, const char *with)
{
    return t.length >= strlen(with) && memcmp(t.at, with, strlen(with)) == 0;
}

static void own(file *f, token t)
{
    if (t.kind == WORD && !begins(t, "nkw_") && !begins(t, "nkwi_") && !begins(t, "NKW") && !token_is(t, "const"))
        names_add(&f->own, t.at, t.length);
}

static void add_local(file *f, const statement *s)
{
    if (!begins(s->function, "nkwi_") || s->is_static || s->is_typedef)
        return;
    f->local = (size_t *)realloc(f->local, (f->local_count + 1) * sizeof *f->local);
    if (!f->local)
        fail("out of memory", f->path);
    f->local[f->local_count++] = (size_t)(s->begin - f->content.data);
}

/* A token outside of braces and parentheses. */
static void read_outside(file *f, statement *s, token t)
{
    if (!s->begin && t.kind == WORD)
        s->begin = t.at;
    s->is_static |= token_is(t, "static") || token_is(t, "NKW_ALWAYS_INLINE");
    s->is_typedef |= token_is(t, "typedef");
    s->is_enum |= token_is(t, "enum");
    if (token_is(t, "(") && s->last.kind == WORD && !is_attribute(s->last) && !s->function.length && !s->is_typedef)
        s->function = s->last, own(f, s->last);
    if (s->last.kind == WORD && !s->function.length && strchr("[=;,", t.at[0]) && t.kind == OTHER &&
        (s->is_static || s->is_typedef))
        own(f, s->last);
    if (token_is(t, "{") && s->last.kind == WORD &&
        (token_is(s->before, "struct") || token_is(s->before, "enum") || token_is(s->before, "union")))
        own(f, s->last);
}

static void add_macro(file *f, token directive)
{
    token argument;
    const token word = directive_word(directive, &argument);
    if (token_is(word, "define"))
        names_add(&f->macros, argument.at, argument.length);
}

/* X(nkwi_name, (parameters), of a list of loops. */
static void read_list(file *f, token directive)
{
    const char *end = directive.at + directive.length;
    f->is_list = 1;
    for (const char *at = directive.at; (at = strstr(at, "X(nkw")) != NULL && at < end; at++) {
        const char *comma = strchr(at, ','), *close = strchr(at, ')');
        if (strncmp(at, "X(nkwi_", 7) != 0 || !comma || !close)
            continue;
        text line = {NULL, 0, 0};
        text_add(&line, at + 2, (size_t)(comma - at) - 2);
        text_add(&line, comma + 2, (size_t)(close - comma) - 1);
        names_add(&f->list, line.data, line.length);
        free(line.data);
    }
}

static void read_directive(file *f, token t, int *first)
{
    token argument;
    const token word = directive_word(t, &argument);
    if (*first)
        f->guarded = token_is(word, "ifndef") && begins(argument, "NAKAWARI_");
    *first = 0;
    add_macro(f, t);
    if (token_is(word, "define") && begins(argument, "NKW_LOOPS_"))
        read_list(f, t);
}

static void scan(file *f)
{
    static const statement none;
    statement s = none;
    int line = 1, braces = 0, first = 1, ended;
    for (token t = token_next(f->content.data, &line); t.kind != END; t = token_next(t.at + t.length, &line)) {
        if (t.kind == DIRECTIVE)
            read_directive(f, t, &first);
        if (t.kind == SPACE || t.kind == COMMENT || t.kind == DIRECTIVE)
            continue;
        if (braces == 0 && s.parens == 0)
            read_outside(f, &s, t);
        if (s.is_enum && braces == 1 && s.parens == 0 && (token_is(s.last, "{") || token_is(s.last, ",")))
            own(f, t);
        s.parens += token_is(t, "(") - token_is(t, ")") + token_is(t, "[") - token_is(t, "]");
        s.has_body |= braces == 0 && token_is(t, "{") && s.function.length && s.parens == 0;
        braces += token_is(t, "{") - token_is(t, "}");
        s.before = s.last, s.last = t;
        ended = braces == 0 && s.parens == 0 && (token_is(t, ";") || (token_is(t, "}") && s.has_body));
        if (ended)
            add_local(f, &s), s = none;
    }
}

static char *stem_of(const char *path)
{
    const char *name = strrchr(path, '/') ? strrchr(path, '/') + 1 : path;
    return text_copy(name, strcspn(name, "."));
}

/* a/b/../c is a/c. */
static void shorten(char *path)
{
    for (char *up; (up = strstr(path, "/../")) != NULL;) {
        char *begin = up;
        while (begin > path && begin[-1] != '/')
            begin--;
        memmove(begin, up + 4, strlen(up + 4) + 1);
    }
}

file *files_get(files *all, const char *path)
{
    for (size_t i = 0; i < all->count; i++)
        if (strcmp(all->file[i]->path, path) == 0)
            return all->file[i];
    file *f = (file *)calloc(1, sizeof *f);
    if (!f || all->count == sizeof all->file / sizeof *all->file)
        fail("too many files", path);
    f->path = text_copy(path, strlen(path));
    f->stem = stem_of(path);
    f->content = text_read(path);
    scan(f);
    return all->file[all->count++] = f;
}

static int exists(const char *path)
{
    FILE *f = fopen(path, "rb");
    return f ? !fclose(f) : 0;
}

file *files_find(files *all, const char *root, const char *from, const char *name)
{
    static const char *const folders[] = {"/src/kernel/", "/src/", "/include/"};
    char path[2 * PATH];
    const char *slash = strrchr(from, '/');
    snprintf(path, sizeof path, "%.*s/%s", slash ? (int)(slash - from) : 0, from, name);
    for (size_t i = 0; i < 3 && !exists(path); i++)
        snprintf(path, sizeof path, "%s%s%s", root, folders[i], name);
    if (!exists(path))
        fail("is not found", name);
    shorten(path);
    return files_get(all, path);
}
