/* SPDX-License-Identifier: MIT */
/* Strings that grow, sets of names, and the tokens of C. */
#ifndef NAKAWARI_AMALGAMATE_TEXT_H
#define NAKAWARI_AMALGAMATE_TEXT_H

#include <stddef.h>

/* A string of `length` bytes with a 0 behind them. */
typedef struct text {
    char *data;
    size_t length, capacity;
} text;

void text_add(text *t, const char *data, size_t length);
void text_put(text *t, const char *string);
/* The whole file; ends the program with a message if it cannot be read or written. */
text text_read(const char *path);
void text_write(const char *path, const text *t);
char *text_copy(const char *data, size_t length);
void fail(const char *what, const char *which);

/* Names in the order in which they were added, each once. */
typedef struct names {
    char **name;
    size_t count, capacity;
} names;

int names_have(const names *set, const char *name, size_t length);
void names_add(names *set, const char *name, size_t length);

typedef enum kind { END, SPACE, COMMENT, DIRECTIVE, WORD, OTHER } kind;

/* OTHER is a string, a character, a number or one sign of punctuation. A directive ends before its line's end. */
typedef struct token {
    kind kind;
    const char *at;
    size_t length;
} token;

/* The token at `at`; `line` is 1 if only space precedes it in its line, and is updated. */
token token_next(const char *at, int *line);
int token_is(token t, const char *string);

#endif
