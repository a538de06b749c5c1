/* SPDX-License-Identifier: MIT */
/*
 * Loops are compiled once for each instruction set: the build defines NKW_ISA, its name, for the files of this folder.
 * Without NKW_ISA it is `generic`, the baseline of the target.
 *
 * A file stem.h of this folder lists its loops: NKW_LOOPS_STEM(X) calls
 *
 *     X(name, parameters, arguments, n)
 *
 * for each, where `name` is a function nkw_..._n of the public headers or nkwi_..., which only the library calls, and n
 * the elements that the choice of the instruction set goes by. From one line come the declarations below, and the
 * function `name`, which chooses (simd/dispatch.h). stem.c defines name_ISA as NKW_LOOP(name). To add one, see
 * docs/simd.md.
 */
#ifndef NAKAWARI_BATCH_ISA_H
#define NAKAWARI_BATCH_ISA_H

#include <stddef.h>

#include "lane/strict.h"

#ifndef NKW_ISA
#define NKW_ISA generic
#endif

#define NKW_JOIN(name, isa)     name##_##isa
#define NKW_JOIN_ISA(name, isa) NKW_JOIN(name, isa)

/* Of a build as one file (src/amalgamate): before what only the library calls, and what is not to be inlined. */
#ifndef NKW_LOCAL
#define NKW_LOCAL
#endif
#ifndef NKW_APART
#define NKW_APART
#endif

/* Before and in the definition of a loop. All its calls are inlined: one that is left keeps it from vectorising. */
#define NKW_LOOP(name) NKW_LOCAL NKW_APART LANE_FLAT void NKW_JOIN_ISA(name, NKW_ISA)

/* For n in a list: arrays that are long, or whole blocks. */
#define NKW_WIDEST ((size_t)-1)

#define NKW_DECLARE(name, parameters, arguments, n)      void name parameters;
#define NKW_DECLARE_LOOP(name, parameters, arguments, n) NKW_LOCAL void NKW_JOIN_ISA(name, NKW_ISA) parameters;

/* A part of a kernel to which counts and formats are constants: compilers do not see by themselves that it pays. */
#if defined(__GNUC__) && !defined(NKW_SMALL)
#define NKW_ALWAYS_INLINE static inline __attribute__((always_inline))
#else
#define NKW_ALWAYS_INLINE static inline
#endif

/* Before a loop over a constant few: Clang would take it apart before it looks for vectors, and then find none. */
#if defined(__clang__)
#define NKW_KEEP_LOOP _Pragma("clang loop unroll(disable)")
#else
#define NKW_KEEP_LOOP
#endif

/* A condition that mostly holds: what it guards comes first. */
#if defined(__GNUC__)
#define NKW_LIKELY(condition) __builtin_expect(!!(condition), 1)
#else
#define NKW_LIKELY(condition) (condition)
#endif

/* A part of a kernel that stays a function of its own, lest a large one be compiled in one piece. */
#if defined(__GNUC__)
#define NKW_NOINLINE __attribute__((noinline))
#else
#define NKW_NOINLINE
#endif

#endif
