/* SPDX-License-Identifier: MIT */
/*
 * Strict arithmetic: the first include of every source file.
 *
 * The same bits everywhere need each float and double operation to be rounded once, to its own type,
 * to nearest. The build says so with -std=c99 -ffp-contract=off; the lines below say it again for
 * whoever compiles the files by other means, and refuse what cannot be put right.
 */
#ifndef NAKAWARI_LANE_STRICT_H
#define NAKAWARI_LANE_STRICT_H

#include <float.h>

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__) ||                               \
    defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(__NO_SIGNED_ZEROS__) ||                   \
    defined(_M_FP_FAST)
#error "nakawari: build without -ffast-math and its parts, they change results"
#endif

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#elif defined(__GNUC__) && !defined(__STRICT_ANSI__) && !defined(NKW_ONE_FILE)
/* GNU mode contracts a * b + c by default and ignores the ISO pragma. */
#pragma GCC optimize("fp-contract=off")
#endif

/*
 * GCC 11 and 12 compile (double)(float)x of two doubles side by side to nothing, where the SLP vectoriser joins them.
 * With any pragma `optimize` and -flto, they take functions that read memory for such as do not (ipa-modref).
 * algebra.c has no double, and disables pairs by itself where they cost time.
 */
#if defined(NKW_ONE_FILE) /* its first lines have all pragmas of it */
#define LANE_NO_PAIRS
#elif defined(__GNUC__) && !defined(__clang__) && __GNUC__ >= 11 && (__GNUC__ <= 12 || !defined(__STRICT_ANSI__))
#pragma GCC optimize("no-ipa-modref")
#define LANE_NO_PAIRS _Pragma("GCC optimize(\"no-tree-slp-vectorize\")")
#else
#define LANE_NO_PAIRS
#endif
#ifndef NKW_DEFINE_ALGEBRA
LANE_NO_PAIRS
#endif

/* So the headers may inline their small algebra here. */
#ifndef NKW_CONTRACTION_OFF
#define NKW_CONTRACTION_OFF
#endif
#define NKW_LIBRARY

/*
 * Before a single function: all its calls are inlined, so that numbers stay in registers. And before what it seldom
 * calls, which keeps out of the way. A build that defines NKW_SMALL leaves to the compiler what is inlined.
 */
#if defined(__GNUC__) && !defined(NKW_SMALL)
#define LANE_FLAT __attribute__((flatten))
#else
#define LANE_FLAT
#endif
#if defined(__GNUC__)
#define LANE_SELDOM __attribute__((noinline, cold, unused))
#else
#define LANE_SELDOM
#endif

/* 16 means that only _Float16 is widened. */
#if (defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 16) ||                                     \
    (defined(__i386__) && !defined(__SSE2_MATH__)) || (defined(_M_IX86_FP) && _M_IX86_FP < 2)
#error "nakawari: float must be evaluated as float (i386: -msse2 -mfpmath=sse, s390x: -fexcess-precision=fast)"
#endif

/* The bits of the target's registers. One file that has loops for several targets sets them for each. */
#if defined(__AVX512F__)
#define NKW_REGISTER_BITS 512
#elif defined(__AVX__)
#define NKW_REGISTER_BITS 256
#else
#define NKW_REGISTER_BITS 128
#endif

#if FLT_RADIX != 2 || FLT_MANT_DIG != 24 || DBL_MANT_DIG != 53
#error "nakawari: float and double must be IEEE 754 binary32 and binary64"
#endif

#endif
