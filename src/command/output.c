/* SPDX-License-Identifier: MIT */
#include "command.h"

#include <errno.h>
#include <string.h>

static int standard(const char *path)
{
    return !path || strcmp(path, "-") == 0;
}

static void complain(const char *path)
{
    int reason = errno;
    output_text(stderr, standard(path) ? "standard output" : path);
    fprintf(stderr, ": cannot be written: %s\n", strerror(reason));
}

FILE *output_open(const char *path)
{
    FILE *f = standard(path) ? stdout : fopen(path, "wb");
    if (!f)
        complain(path);
    return f;
}

int output_close(FILE *f, const char *path)
{
    errno = EIO;
    int failed = ferror(f) || fflush(f) != 0;
    if (failed)
        complain(path);
    if (!standard(path) && fclose(f) != 0 && !failed) {
        complain(path);
        failed = 1;
    }
    return !failed;
}

void output_number(FILE *f, float number)
{
    if (number != number)
        fputs("nan", f);
    else
        fprintf(f, "%.9g", (double)number);
}

void output_field(FILE *f, const char *text)
{
    if (!strpbrk(text, ",\"\r\n")) {
        fputs(text, f);
        return;
    }
    fputc('"', f);
    for (; *text; text++) {
        if (*text == '"')
            fputc('"', f);
        fputc(*text, f);
    }
    fputc('"', f);
}

void output_text(FILE *f, const char *text)
{
    for (; *text; text++) {
        unsigned char c = (unsigned char)*text;
        if (c < 32 || c == 127)
            fprintf(f, "\\x%02x", c);
        else
            fputc(c, f);
    }
}
