/* SPDX-License-Identifier: MIT */
/* What counts.c and counts_algebra.c have in common: the size of the work, one count, and random inputs. */
#ifndef NAKAWARI_BENCH_COUNTED_H
#define NAKAWARI_BENCH_COUNTED_H

#include <nakawari/nakawari.h>
#include <valgrind/callgrind.h>

#include "random.h"

enum { N = 1024 };

static nkw_quat qa[N], qb[N];
static nkw_vec3 p[4][N];
static nkw_mat3 turn[N];
static nkw_mat4 ma[N], mb[N];
static float t[N];

/* What is before each name. */
#if defined(COUNTS_AS)
#define COUNT_NAME(name) COUNTS_AS " " name
#else
#define COUNT_NAME(name) name
#endif

/* One count: a name, and the code between. */
#define COUNT(name, code)                                                                                              \
    do {                                                                                                               \
        CALLGRIND_ZERO_STATS;                                                                                          \
        code;                                                                                                          \
        CALLGRIND_DUMP_STATS_AT(COUNT_NAME(name));                                                                     \
    } while (0)
#define EACH(name, code) COUNT(name, for (size_t i = 0; i < N; i++) code)

static void draw_element(random_source *r, size_t i)
{
    qa[i] = random_rotation(r);
    qb[i] = random_rotation(r);
    for (int k = 0; k < 4; k++)
        p[k][i] = random_vec3(r, -1, 1);
}

/* ma[i] is of the caller. */
static void draw_matrices(random_source *r, size_t i)
{
    turn[i] = nkw_mat3_from_quat(qb[i]);
    mb[i] = nkw_mat4_from_mat3(&turn[i], p[0][i]);
    t[i] = random_unit(r);
}

#endif
