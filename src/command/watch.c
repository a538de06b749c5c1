/* SPDX-License-Identifier: MIT */
#if !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200809L /* nanosleep, st_mtim */
#endif
#include "watch.h"

#include <signal.h>
#include <sys/stat.h>
#include <time.h>

#if defined(_WIN32)
#include <windows.h>
#endif

static volatile sig_atomic_t interrupted;

static void interrupt(int number)
{
    (void)number;
    interrupted = 1;
}

/* A file as last seen. */
typedef struct state {
    long long seconds, nanoseconds, bytes;
} state;

static int look(const char *path, state *out)
{
    struct stat s;
    if (stat(path, &s) != 0)
        return 0;
    out->seconds = (long long)s.st_mtime;
    out->nanoseconds = 0;
#if !defined(_WIN32) && !defined(__APPLE__)
    out->nanoseconds = (long long)s.st_mtim.tv_nsec;
#endif
    out->bytes = (long long)s.st_size;
    return 1;
}

static int same(const state *a, const state *b)
{
    return a->seconds == b->seconds && a->nanoseconds == b->nanoseconds && a->bytes == b->bytes;
}

static void wait_a_while(void)
{
#if defined(_WIN32)
    Sleep(200);
#else
    struct timespec time = {0, 200000000};
    nanosleep(&time, NULL);
#endif
}

/* Until the file has changed, and then has been the same for one period: its writer may not be ready. */
static void wait_for_change(const char *path, const state *before)
{
    state seen = *before, now;
    while (!interrupted) {
        wait_a_while();
        if (!look(path, &now))
            continue;
        if (same(&now, &seen) && !same(&now, before))
            return;
        seen = now;
    }
}

void watch_file(const char *path, void (*work)(void *user), void *user)
{
    interrupted = 0;
    signal(SIGINT, interrupt);
    signal(SIGTERM, interrupt);
    while (!interrupted) {
        state before = {0, 0, -1};
        look(path, &before);
        work(user);
        wait_for_change(path, &before);
    }
}
