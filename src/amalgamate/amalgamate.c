/* SPDX-License-Identifier: MIT */
/*
 * Writes the library as two files, nakawari.h and nakawari.c:
 *
 *     amalgamate ROOT OUT.h OUT.c BEGIN.h BEGIN.c headers --sources files --loops files --wide ISA BITS ISA BITS ...
 *
 * Headers are public ones, in the order of the list of subjects; #include "..." is replaced by the file, once. A file
 * scope name that two files declare gets the stem of its file behind it, and the macros of a source end with it. The
 * loops come once for the baseline and once for each ISA, with the names of their files and headers followed by ISA,
 * between NKW_TARGET_ISA and NKW_TARGET_END where NKW_WIDE_LOOPS is 1. OUT.h begins with BEGIN.h, OUT.c with BEGIN.c.
 * The same input has the same output.
 */
#include <stdio.h>
#include <string.h>

#include "file.h"

enum { MOST = 512 };

typedef struct job {
    const char *root, *isa; /* "" is the baseline */
    files all;
    names repeated, header_macros; /* names of two files; macros of private headers */
    names wide_names, wide_macros; /* of the files that are repeated for each instruction set */
    int inside; /* of an #if of an including file */
    text out;
} job;

static void expand(job *j, file *f);

static int is_header(const file *f)
{
    return strcmp(f->path + strlen(f->path) - 2, ".h") == 0;
}

static int is_public(const job *j, const file *f)
{
    const size_t n = strlen(j->root);
    return strncmp(f->path, j->root, n) == 0 && strncmp(f->path + n, "/include/", 9) == 0;
}

/* A word of the file f, after the token `before`. */
static void put_word(job *j, const file *f, token t, token before)
{
    const int own = names_have(&f->own, t.at, t.length);
    const int member = token_is(before, ".") || token_is(before, "->");
    text_add(&j->out, t.at, t.length);
    if (member)
        return;
    if (!is_header(f) && own &&
        (names_have(&j->repeated, t.at, t.length) || names_have(&j->header_macros, t.at, t.length))) {
        text_put(&j->out, "_");
        text_put(&j->out, f->stem);
    }
    if (*j->isa && f->wide && ((own && !is_header(f)) || names_have(&j->wide_names, t.at, t.length))) {
        text_put(&j->out, "_");
        text_put(&j->out, j->isa);
    }
}

/* The tokens from..end, which has no directive at its begin. */
static void put_tokens(job *j, const file *f, const char *from, const char *end)
{
    int line = 0;
    token before = {END, from, 0};
    for (token t = token_next(from, &line); t.at < end && t.kind != END;
         line = 0, t = token_next(t.at + t.length, &line)) {
        if (t.kind == WORD)
            put_word(j, f, t, before);
        else
            text_add(&j->out, t.at, t.length);
        if (t.kind != SPACE && t.kind != COMMENT)
            before = t;
    }
}

/* Stores the depth of #if after the directive t. */
static void put_directive(job *j, file *f, token t, int *depth)
{
    token argument;
    const token word = directive_word(t, &argument);
    const char *name = include_name(t);
    if (name && argument.at[0] == '<' && !is_public(j, f))
        return; /* nakawari.h has all of them */
    if (name) {
        file *g = files_find(&j->all, j->root, f->path, name);
        if (is_public(j, g) && !is_public(j, f))
            return;
        const int outside = j->inside;
        if (g->guarded && (g->done || g->open))
            return;
        j->inside |= *depth != f->guarded;
        g->open = 1;
        expand(j, g);
        g->open = 0, g->done = !j->inside;
        j->inside = outside;
        return;
    }
    if (token_is(word, "pragma") && token_is(argument, "omp")) {
        text_put(&j->out, "NKW_VECTORS");
        return;
    }
    *depth += token_is(word, "if") || token_is(word, "ifdef") || token_is(word, "ifndef");
    *depth -= token_is(word, "endif");
    put_tokens(j, f, t.at, t.at + t.length);
}

/* Functions of the list f that only the library calls: before the declarations from the list. */
static void put_list(job *j, const file *f)
{
    for (size_t i = 0; i < f->list.count; i++) {
        text_put(&j->out, "NKW_LOCAL void ");
        text_put(&j->out, f->list.name[i]);
        text_put(&j->out, ";\n");
    }
}

static int is_local(const file *f, token t)
{
    for (size_t i = 0; i < f->local_count; i++)
        if (f->content.data + f->local[i] == t.at)
            return 1;
    return 0;
}

static void expand(job *j, file *f)
{
    int line = 1, depth = 0;
    token before = {END, "", 0};
    for (token t = token_next(f->content.data, &line); t.kind != END; t = token_next(t.at + t.length, &line)) {
        if (t.kind == DIRECTIVE) {
            put_directive(j, f, t, &depth);
        } else if (t.kind == COMMENT && strncmp(t.at, "/* SPDX", 7) == 0) {
            continue;
        } else if (t.kind == WORD) {
            if (f->is_list && strncmp(t.at, "NKW_LOOPS_", 10) == 0)
                put_list(j, f);
            if (is_local(f, t))
                text_put(&j->out, "NKW_LOCAL ");
            put_word(j, f, t, before);
        } else {
            text_add(&j->out, t.at, t.length);
        }
        if (t.kind == WORD || t.kind == OTHER)
            before = t;
    }
}

static void undefine(job *j, const names *macros)
{
    for (size_t i = 0; i < macros->count; i++) {
        text_put(&j->out, "#undef ");
        text_put(&j->out, macros->name[i]);
        text_put(&j->out, "\n");
    }
}

static void put_source(job *j, file *f)
{
    expand(j, f);
    undefine(j, &f->macros);
}

/* Reads what f includes, and what that includes. */
static void reach(job *j, file *f)
{
    int line = 1;
    if (f->done)
        return;
    f->done = 1;
    for (token t = token_next(f->content.data, &line); t.kind != END; t = token_next(t.at + t.length, &line)) {
        const char *name = t.kind == DIRECTIVE ? include_name(t) : NULL;
        if (name)
            reach(j, files_find(&j->all, j->root, f->path, name));
    }
}

/* The file is part of what lists of loops include: the same for each instruction set. */
static void keep(job *j, file *f)
{
    f->wide = 0;
    int line = 1;
    for (token t = token_next(f->content.data, &line); t.kind != END; t = token_next(t.at + t.length, &line)) {
        const char *name = t.kind == DIRECTIVE ? include_name(t) : NULL;
        if (name && strncmp(name, "nakawari/", 9) != 0)
            keep(j, files_find(&j->all, j->root, f->path, name));
    }
}

static void find_wide(job *j, file *const *loops, size_t count)
{
    for (size_t i = 0; i < j->all.count; i++) {
        file *f = j->all.file[i];
        const char *kernel = strstr(f->path, "/src/kernel/");
        f->wide = kernel && is_header(f) && !f->is_list &&
                  (!strncmp(kernel + 12, "pack/", 5) || !strncmp(kernel + 12, "batch/", 6) ||
                   !strcmp(kernel + 12, "sizes.h"));
    }
    for (size_t i = 0; i < j->all.count; i++)
        if (j->all.file[i]->is_list)
            keep(j, j->all.file[i]);
    for (size_t i = 0; i < count; i++)
        loops[i]->wide = 1;
    for (size_t i = 0; i < j->all.count; i++) {
        const file *f = j->all.file[i];
        for (size_t k = 0; f->wide && is_header(f) && k < f->own.count; k++)
            names_add(&j->wide_names, f->own.name[k], strlen(f->own.name[k]));
        for (size_t k = 0; f->wide && is_header(f) && k < f->macros.count; k++)
            names_add(&j->wide_macros, f->macros.name[k], strlen(f->macros.name[k]));
    }
}

static void find_repeated(job *j)
{
    names seen = {NULL, 0, 0};
    for (size_t i = 0; i < j->all.count; i++) {
        const file *f = j->all.file[i];
        if (is_public(j, f))
            continue;
        for (size_t k = 0; k < f->own.count; k++) {
            const char *name = f->own.name[k];
            if (names_have(&seen, name, strlen(name)))
                names_add(&j->repeated, name, strlen(name));
            names_add(&seen, name, strlen(name));
        }
        for (size_t k = 0; is_header(f) && k < f->macros.count; k++)
            names_add(&j->header_macros, f->macros.name[k], strlen(f->macros.name[k]));
    }
}

static void forget(job *j, int only_wide)
{
    for (size_t i = 0; i < j->all.count; i++)
        if (!only_wide || j->all.file[i]->wide)
            j->all.file[i]->done = 0;
}

static void put_wide(job *j, file *const *loops, size_t count, const char *isa, const char *bits)
{
    text *out = &j->out;
    text_put(out, "\n#if NKW_WIDE_LOOPS\n");
    undefine(j, &j->wide_macros);
    text_put(out, "#undef NKW_ISA\n#undef NKW_REGISTER_BITS\n#define NKW_ISA ");
    text_put(out, isa), text_put(out, "\n#define NKW_REGISTER_BITS "), text_put(out, bits);
    text_put(out, "\nNKW_TARGET_"), text_put(out, isa), text_put(out, "\n");
    forget(j, 1);
    j->isa = isa;
    for (size_t i = 0; i < count; i++)
        put_source(j, loops[i]);
    j->isa = "";
    text_put(out, "\nNKW_TARGET_END\n#endif\n");
}

static size_t read_list(job *j, char **argument, file **out)
{
    size_t n = 0;
    for (; argument[n] && strncmp(argument[n], "--", 2) != 0; n++) {
        if (n == MOST)
            fail("too many files", argument[n]);
        out[n] = files_get(&j->all, argument[n]);
    }
    return n;
}

int main(int count, char **argument)
{
    static job j;
    static file *headers[MOST], *sources[MOST], *loops[MOST];
    if (count < 7)
        fail("too few arguments", argument[0]);
    j.root = argument[1], j.isa = "";
    char **next = argument + 6;
    const size_t header_count = read_list(&j, next, headers);
    next += header_count + 1;
    const size_t source_count = read_list(&j, next, sources);
    next += source_count + 1;
    const size_t loop_count = read_list(&j, next, loops);
    next += loop_count + 1;

    const size_t given = j.all.count;
    for (size_t i = 0; i < given; i++)
        reach(&j, j.all.file[i]);
    find_repeated(&j);
    find_wide(&j, loops, loop_count);
    forget(&j, 0);

    text begin = text_read(argument[4]);
    j.out = begin;
    for (size_t i = 0; i < header_count; i++)
        if (!headers[i]->done)
            headers[i]->open = 1, expand(&j, headers[i]), headers[i]->open = 0, headers[i]->done = 1;
    text_put(&j.out, "\n#endif\n");
    text_write(argument[2], &j.out);

    j.out = text_read(argument[5]);
    for (size_t i = 0; i < source_count; i++)
        put_source(&j, sources[i]);
    for (size_t i = 0; i < loop_count; i++)
        put_source(&j, loops[i]);
    for (; next[0] && next[1]; next += 2)
        put_wide(&j, loops, loop_count, next[0], next[1]);
    text_write(argument[3], &j.out);
    return 0;
}
