/* SPDX-License-Identifier: MIT */
#if !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200809L /* mkdir */
#endif
#include "command.h"

#include <ctype.h>
#include <errno.h>
#include <string.h>
#include <sys/stat.h>

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

int output_ending(const char *path, const char *const *words, int count)
{
    const char *end = path ? strrchr(path, '.') : NULL;
    char small[16];
    size_t n = 0;
    for (; end && end[n + 1] && n + 1 < sizeof small; n++)
        small[n] = (char)tolower((unsigned char)end[n + 1]);
    small[n] = 0;
    return n > 0 && !end[n + 1] ? words_find(small, words, count) : -1;
}

int output_is_foreign(const char *path)
{
    static const char *const ends[] = {"abc",  "avi", "blend",   "bmp",  "bvh",  "dae", "fbx", "gif",
                                       "jpeg", "jpg", "md5anim", "mov",  "mp4",  "obj", "pdf", "tif",
                                       "tiff", "usd", "usda",    "usdc", "usdz", "webp"};
    return output_ending(path, ends, sizeof ends / sizeof ends[0]) >= 0;
}

int output_folder(const char *path)
{
    if (mkdir(path, 0777) == 0 || errno == EEXIST)
        return 1;
    complain(path);
    return 0;
}

int output_close(FILE *f, const char *path)
{
    int failed = ferror(f);
    errno = 0;
    if (failed) /* the reason is not kept: another byte fails for the same */
        fputc('\n', f);
    failed |= fflush(f) != 0;
    errno = errno ? errno : EIO;
    if (failed)
        complain(path);
    if (!standard(path) && fclose(f) != 0 && !failed) {
        complain(path);
        failed = 1;
    }
    return !failed;
}

int output_complain(const nkw_document *d, const nkw_document_animation *animation, const char *what)
{
    output_text(stderr, d->file);
    if (animation) {
        fputs(": clip ", stderr);
        output_text(stderr, animation->name);
    }
    fprintf(stderr, ": %s\n", what);
    return 0;
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
