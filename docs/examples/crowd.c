/* SPDX-License-Identifier: MIT */
/**
 * @file
 * nakawari-crowd: many characters on many threads, without a lock: every thread works on characters of its own and
 * writes their joint matrices to their own part of one buffer. Measures how that scales, and checks that the bits do
 * not know of threads or lanes. See docs/subjects/skin/crowd.md.
 */
#define _POSIX_C_SOURCE 200809L
#include "thread.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "options.h"
#include "troupe.h"

/* Exit codes. */
enum { DONE, FAILED, MISUSED };
enum { THREADS_MAX = 256 };

static const char usage[] =
    "usage: nakawari-crowd [options]\n"
    "Poses many characters on many threads, measures it, and checks that the bits are always the same.\n"
    "\n"
    "  --characters N     1 to 100000 (default 256)\n"
    "  --joints N         of each, 1 to 1000 (default 67)\n"
    "  --threads N        measure 1, 2, ... N threads, 1 to 256 (default 4)\n"
    "  --seconds S        length of each measurement, 0.001 to 60 (default 0.2)\n"
    "  -h, --help         print this\n";

typedef struct options {
    long characters, joints, threads;
    double seconds;
    int help;
} options;

static int read_options(int argc, char **argv, options *o)
{
    const option known[] = {{"--characters", OPTION_WHOLE, &o->characters, 1, 100000, NULL},
                            {"--joints", OPTION_WHOLE, &o->joints, 1, 1000, NULL},
                            {"--threads", OPTION_WHOLE, &o->threads, 1, THREADS_MAX, NULL},
                            {"--seconds", OPTION_NUMBER, &o->seconds, 0.001, 60, NULL}};
    return options_read("nakawari-crowd", known, sizeof known / sizeof *known, argc, argv, &o->help);
}

/* ---- threads ---- */

/* A share of the work: pieces from .. to - 1, for `moments` moments, a sixtieth of a second apart. */
typedef struct share {
    const troupe *troupe;
    troupe_task task;
    int lanes;
    size_t from, to;
    long moments;
    troupe_scratch scratch;
    thread handle;
    int started;
} share;

static thread_result work(void *argument)
{
    share *s = argument;
    for (long m = 0; m < s->moments; m++) {
        for (size_t piece = s->from; piece < s->to; piece++)
            troupe_piece(s->troupe, s->task, s->lanes, piece, (float)m / 60.0f, &s->scratch);
    }
    return (thread_result)0;
}

/*
 * The whole work on so many threads, this one the first of them; what a thread could not be started for is done here.
 * Nothing is shared that is written, so there is nothing to lock. Gives the seconds.
 */
static double run(share *shares, int threads, const troupe *t, troupe_task task, int lanes, long moments)
{
    size_t pieces = troupe_pieces(t, task);
    double start = thread_clock();
    for (int i = threads - 1; i >= 0; i--) {
        share *s = &shares[i];
        s->troupe = t;
        s->task = task;
        s->lanes = lanes;
        s->from = pieces * (size_t)i / (size_t)threads;
        s->to = pieces * ((size_t)i + 1) / (size_t)threads;
        s->moments = moments;
        s->started = i > 0 && thread_start(&s->handle, work, s);
        if (!s->started)
            work(s);
    }
    for (int i = 1; i < threads; i++) {
        if (shares[i].started)
            thread_join(shares[i].handle);
    }
    return thread_clock() - start;
}

/* ---- measuring ---- */

/*
 * Nanoseconds per character, the least of five runs, for other programs only ever add to it. The number of moments is
 * doubled until a run is long enough.
 */
static double cost(share *shares, int threads, const troupe *t, int lanes, double seconds)
{
    enum { RUNS = 5 };
    long moments = 1;
    double least = run(shares, threads, t, TROUPE_CHARACTERS, lanes, moments);
    while (least < seconds / RUNS && moments < 1000000000L)
        least = run(shares, threads, t, TROUPE_CHARACTERS, lanes, moments *= 2);
    for (int i = 1; i < RUNS; i++) {
        double taken = run(shares, threads, t, TROUPE_CHARACTERS, lanes, moments);
        least = taken < least ? taken : least;
    }
    return 1e9 * least / ((double)moments * (double)t->characters);
}

/* The bits of everything: all characters after ten moments, and the baked clip. */
static uint64_t bits(share *shares, int threads, const troupe *t, int lanes)
{
    troupe_clear(t);
    (void)run(shares, threads, t, TROUPE_CHARACTERS, lanes, 10);
    (void)run(shares, threads, t, TROUPE_FRAMES, lanes, 1);
    return troupe_hash(t);
}

static void print_hash(uint64_t hash)
{
    printf("%08lx%08lx", (unsigned long)(hash >> 32), (unsigned long)(hash & 0xffffffffu));
}

static double repeat(share *s, const troupe *t, troupe_step step, long times)
{
    double start = thread_clock();
    for (long i = 0; i < times; i++)
        troupe_do(t, TROUPE_CHARACTERS, step, 0, (float)i / 60.0f, &s->scratch);
    return thread_clock() - start;
}

/* The same for one step of the first piece, which has been through all steps. */
static double step_cost(share *s, const troupe *t, troupe_step step, double seconds)
{
    enum { RUNS = 20 };
    long times = 1;
    double least = repeat(s, t, step, times);
    size_t characters = t->characters < NKW_CROWD ? t->characters : NKW_CROWD;
    while (least < seconds / RUNS && times < 1000000000L)
        least = repeat(s, t, step, times *= 2);
    for (int i = 1; i < RUNS; i++) {
        double taken = repeat(s, t, step, times);
        least = taken < least ? taken : least;
    }
    return 1e9 * least / ((double)times * (double)characters);
}

static void print_buffer(const troupe *t)
{
    const nkw_palette_chunk *baked = &t->chunks[0], *last = &t->chunks[t->characters];
    printf("%lu characters of %lu joints, a clip of %lu baked frames, one buffer of %lu matrices\n",
           (unsigned long)t->characters, (unsigned long)t->joints, (unsigned long)t->frames, (unsigned long)t->total);
    printf("  baked frame f begins at matrix %lu + %lu f, the last at %lu\n", (unsigned long)baked->first,
           (unsigned long)baked->joint_count, (unsigned long)(baked->first + (t->frames - 1) * baked->joint_count));
    printf("  character 0 begins at matrix %lu, the last at %lu\n\n", (unsigned long)t->chunks[1].first,
           (unsigned long)last->first);
}

static void print_steps(share *s, const troupe *t, double seconds)
{
    static const char *const names[TROUPE_STEPS] = {
        "sample the clip",          "local to model, one by one", "palette, one by one", "into the lanes",
        "local to model, by lanes", "palette, by lanes",          "out of the lanes"};
    printf("\none thread, one piece in the cache, ns per character\n");
    for (int step = 0; step < TROUPE_STEPS; step++)
        printf("  %-26s %8.1f\n", names[step], step_cost(s, t, (troupe_step)step, seconds / TROUPE_STEPS));
}

/* One row: the cost of both ways, and the hash. Gives 0 if a hash is not the first one. */
static int print_row(share *shares, int threads, const troupe *t, double seconds, double first[2], uint64_t *hash)
{
    int same = 1;
    printf("%7d", threads);
    for (int lanes = 0; lanes < 2; lanes++) {
        double ns = cost(shares, threads, t, lanes, seconds);
        uint64_t now = bits(shares, threads, t, lanes);
        if (threads == 1)
            first[lanes] = ns;
        if (threads == 1 && !lanes)
            *hash = now;
        printf("  %9.1f  %7.2f", ns, first[lanes] / ns);
        same &= now == *hash;
    }
    printf("  ");
    print_hash(*hash);
    printf(same ? "\n" : " is NOT what came now\n");
    fflush(stdout);
    return same;
}

static int measure(share *shares, int threads, const troupe *t, double seconds)
{
    double first[2] = {0, 0};
    uint64_t hash = 0;
    int same = 1;
    print_buffer(t);
    printf("                one by one      sixteen at once\n");
    printf("threads   ns each  speedup    ns each  speedup  bits of the buffer, both ways\n");
    for (int i = 1; i <= threads; i++)
        same &= print_row(shares, i, t, seconds, first, &hash);
    print_steps(&shares[0], t, seconds);
    if (!same)
        fprintf(stderr, "nakawari-crowd: the bits depend on threads or lanes\n");
    return same;
}

/* ---- */

static int play(const troupe *t, const options *o)
{
    int threads = (int)o->threads, ok = 1;
    share *shares = calloc((size_t)threads, sizeof *shares);
    for (int i = 0; shares && i < threads; i++)
        ok &= troupe_scratch_make(&shares[i].scratch, t->joints);
    ok = shares && ok;
    if (ok)
        ok = measure(shares, threads, t, o->seconds);
    else
        fprintf(stderr, "nakawari-crowd: not enough memory\n");
    for (int i = 0; shares && i < threads; i++)
        troupe_scratch_free(&shares[i].scratch);
    free(shares);
    return ok;
}

static int build_and_play(const options *o)
{
    troupe t;
    const char *wrong = troupe_build(&t, (size_t)o->characters, (size_t)o->joints);
    int ok = !wrong && play(&t, o);
    if (wrong)
        fprintf(stderr, "nakawari-crowd: %s\n", wrong);
    troupe_free(&t);
    return ok ? DONE : FAILED;
}

int main(int argc, char **argv)
{
    options o = {256, 67, 4, 0.2, 0};
    int code = DONE;
    if (!read_options(argc, argv, &o))
        return MISUSED;
    if (o.help)
        fputs(usage, stdout);
    else
        code = build_and_play(&o);
    if (code == DONE && fflush(stdout) != 0)
        code = FAILED;
    return code;
}
