/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Threads and a clock, of POSIX or, where CROWD_C11_THREADS is 1, of C11. Both must be had before any other header is.
 */
#ifndef THREAD_H
#define THREAD_H

#if CROWD_C11_THREADS

#include <threads.h>
#include <time.h>

typedef thrd_t thread;
typedef int thread_result;

#else

#include <pthread.h>
#include <time.h>

typedef pthread_t thread;
typedef void *thread_result;

#endif

typedef thread_result thread_work(void *argument);

/** Gives 0 if no thread could be started. */
static inline int thread_start(thread *t, thread_work *work, void *argument)
{
#if CROWD_C11_THREADS
    return thrd_create(t, work, argument) == thrd_success;
#else
    return pthread_create(t, NULL, work, argument) == 0;
#endif
}

static inline void thread_join(thread t)
{
#if CROWD_C11_THREADS
    (void)thrd_join(t, NULL);
#else
    (void)pthread_join(t, NULL);
#endif
}

/** Seconds since some moment. */
static inline double thread_clock(void)
{
    struct timespec now;
#if CROWD_C11_THREADS
    (void)timespec_get(&now, TIME_UTC);
#else
    (void)clock_gettime(CLOCK_MONOTONIC, &now);
#endif
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

#endif
