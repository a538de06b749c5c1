/* SPDX-License-Identifier: MIT */
#if !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200809L /* clock_gettime, fileno, isatty */
#endif
#include "progress.h"

#include <time.h>

#if defined(_WIN32)
#include <io.h>
#define isatty _isatty
#define fileno _fileno
#else
#include <unistd.h>
#endif

/* Seconds. */
#define PATIENCE 0.5
#define PERIOD   0.1

static int silent;

void progress_silence(void)
{
    silent = 1;
}

static double now(void)
{
#if defined(CLOCK_MONOTONIC)
    struct timespec t;
    if (clock_gettime(CLOCK_MONOTONIC, &t) == 0)
        return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
#endif
    return (double)clock() / (double)CLOCKS_PER_SEC;
}

progress progress_begin(const char *what, size_t total, FILE *lines)
{
    progress p = {what, total, now(), 0.0, 0};
    if (silent || !isatty(fileno(stderr)) || (lines && isatty(fileno(lines))))
        p.what = NULL;
    p.shown = p.began + PATIENCE - PERIOD;
    return p;
}

void progress_at(progress *p, size_t done)
{
    char left[64] = "";
    double time = p->what ? now() : 0.0, spent = time - p->began;
    if (!p->what || time < p->shown + PERIOD)
        return;
    p->shown = time;
    if (done > 0 && done <= p->total && spent > 4.0 * PATIENCE)
        snprintf(left, sizeof left, ", %.0f s left", spent * (double)(p->total - done) / (double)done);
    const int width = fprintf(stderr, "\r%s %zu of %zu%s", p->what, done + 1, p->total, left) - 1;
    for (int i = width; i < p->width; i++)
        fputc(' ', stderr);
    p->width = width > p->width ? width : p->width;
    fflush(stderr);
}

void progress_end(progress *p)
{
    if (p->width > 0)
        fprintf(stderr, "\r%*s\r", p->width, "");
    p->width = 0;
}
