/* SPDX-License-Identifier: MIT */
/*
 * The exceptions of IEEE 754, 7, by the processor's flags: a trap would stop the program where a flag is set. Systems
 * without flags have none: EXCEPTIONS is 0. docs/determinism.md states what is promised.
 */
#ifndef NAKAWARI_TESTS_EXCEPTIONS_H
#define NAKAWARI_TESTS_EXCEPTIONS_H

#include <fenv.h>
#include <stdio.h>
#include <string.h>

#if defined(FE_DIVBYZERO) && defined(FE_INVALID) && defined(FE_OVERFLOW)
#define EXCEPTION_DIVISION FE_DIVBYZERO
#if defined(__clang__) /* computes with unused parts of registers: the page has the reason */
#define EXCEPTION_OVERFLOW 0
#define EXCEPTION_INVALID  0
#else
#define EXCEPTION_OVERFLOW FE_OVERFLOW
#define EXCEPTION_INVALID  FE_INVALID
#endif
#define EXCEPTIONS (EXCEPTION_DIVISION | EXCEPTION_INVALID | EXCEPTION_OVERFLOW)
#else
#define EXCEPTION_DIVISION 0
#define EXCEPTION_INVALID  0
#define EXCEPTION_OVERFLOW 0
#define EXCEPTIONS         0
#endif

static inline void clear_exceptions(void)
{
#if EXCEPTIONS
    feclearexcept(FE_ALL_EXCEPT);
#endif
}

/* Those of `refused` since they were cleared. */
static inline int raised_exceptions(int refused)
{
#if EXCEPTIONS
    return fetestexcept(refused);
#else
    return refused & 0;
#endif
}

/* What a definition has: the root of negative numbers, points of a plane at infinity; and of inputs, times that are NaN. */
static inline int defined_exceptions(const char *name)
{
    return strcmp(name, "sqrt") == 0                 ? EXCEPTION_INVALID
           : strcmp(name, "mat4_project_point") == 0 ? EXCEPTION_DIVISION | EXCEPTION_INVALID
           : strcmp(name, "clip_reduce") == 0        ? EXCEPTION_INVALID
                                                     : 0;
}

/* Whether there are some, after a line about them. */
static inline int report_exceptions(const char *program, const char *name, const char *of, int raised)
{
    if (raised)
        fprintf(stderr, "%s: %s, %s: raises%s%s%s\n", program, name, of,
                raised & EXCEPTION_DIVISION ? " FE_DIVBYZERO" : "", raised & EXCEPTION_INVALID ? " FE_INVALID" : "",
                raised & EXCEPTION_OVERFLOW ? " FE_OVERFLOW" : "");
    return raised != 0;
}

#endif
