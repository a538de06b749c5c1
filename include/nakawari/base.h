/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Floor 0: what everything else stands on: the version, the linkage words, the list of results.
 *
 * The library reads and writes only what it is given. It allocates nothing, keeps no state, touches
 * no errno, no locale and no file, so every function may be called from any thread.
 */
#ifndef NAKAWARI_BASE_H
#define NAKAWARI_BASE_H

#include <float.h>
#include <stddef.h>

/** The version of these headers, as three numbers. nkw_version() gives that of the linked library. */
#define NKW_VERSION_MAJOR 0
#define NKW_VERSION_MINOR 1
#define NKW_VERSION_PATCH 0

/**
 * NKW_API marks what the library exports. Windows users of the shared library need nothing: an import
 * without the attribute goes through the import library.
 */
#if defined(NKW_BUILD) && defined(_WIN32) && defined(NKW_SHARED)
#define NKW_API __declspec(dllexport)
#elif defined(__GNUC__) && !defined(_WIN32)
#define NKW_API __attribute__((visibility("default")))
#else
#define NKW_API
#endif

/**
 * Small algebra (sums, products, rotations, transforms) is inlined into the caller from the headers in
 * `inline/`, but only where the caller's compiler cannot change its bits. It could where it evaluates float
 * wider than float (x87, s390x in ISO mode), or under -ffast-math. There the same functions are called in the
 * library instead: same bits, one call slower.
 *
 * Two things no macro tells: Clang's -ffp-contract=fast and its parts of -ffast-math other than
 * -ffinite-math-only, and a function with GCC's attribute target("fma"). Define NKW_NO_INLINE there.
 *
 * NKW_NO_INLINE turns inlining off altogether. It changes no result.
 *
 * NKW_INLINE is 1 where the definitions are inlined, else 0.
 */
#if defined(NKW_NO_INLINE) || defined(__FAST_MATH__) || defined(_M_FP_FAST)
#define NKW_INLINE 0
#elif defined(__GNUC_GNU_INLINE__) && !defined(__cplusplus) /* Clang defines it in C++ too */
#define NKW_INLINE 0
#elif defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(__NO_SIGNED_ZEROS__) ||            \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#define NKW_INLINE 0
#elif defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 16
#define NKW_INLINE 0
#elif (defined(__i386__) && !defined(__SSE2_MATH__)) || (defined(_M_IX86_FP) && _M_IX86_FP < 2)
#define NKW_INLINE 0 /* Clang says 0 above where float is taken by SSE, but double by x87 */
#else
#define NKW_INLINE 1
#endif

/**
 * The product of two floats in an inlined body, rounded before anything is done with it. GCC on a target with fast
 * fma fuses a * b + c into one rounding, in one function or across several, and no macro tells whether
 * -ffp-contract=off is on; it has no product left to fuse where
 *
 *     a b = fma(a, b, -0)        for all a and b, with the sign of a zero
 *
 * which takes one instruction as well and goes into vectors as a product does. GCC negates it by another, -a b - (-0),
 * which is 0 where -0 is due, so inlined bodies negate by NKW_MUL(-1, x).
 *
 * NKW_MUL64 is the same of two doubles.
 *
 * A program that is compiled with -ffp-contract=off may define NKW_CONTRACTION_OFF to say so, and has plain products.
 */
#if defined(__GNUC__) && !defined(__clang__) && defined(__FP_FAST_FMAF) && !defined(NKW_CONTRACTION_OFF)
#define NKW_FUSES
#define NKW_MUL(a, b) __builtin_fmaf(a, b, -0.0f)
#else
#define NKW_MUL(a, b) ((a) * (b))
#endif
#if defined(NKW_FUSES) && defined(__FP_FAST_FMA)
#define NKW_MUL64(a, b) __builtin_fma(a, b, -0.0)
#else
#define NKW_MUL64(a, b) ((a) * (b))
#endif

/**
 * NKW_BODY stands before each body of the small algebra. What is not inlined after all is a call of the library's
 * symbol, as C99 has it. So it is in the C++ of GCC and Clang: a copy of the file's own, made for the file's processor,
 * could take the place of the library's for the whole program.
 */
#if defined(__cplusplus) && defined(__GNUC__)
#define NKW_BODY extern inline __attribute__((__gnu_inline__))
#else
#define NKW_BODY inline
#endif

/**
 * NKW_ALGEBRA stands before each prototype of the small algebra: as before its body in a user's file, a plain
 * exported declaration in the one library file that holds the symbols and where NKW_INLINE is 0.
 */
#if NKW_INLINE && !defined(NKW_DEFINE_ALGEBRA) && defined(NKW_FUSES)
/* GCC weighs a body as if each fma in it were a call. */
#define NKW_ALGEBRA __attribute__((always_inline)) NKW_BODY
#elif NKW_INLINE && !defined(NKW_DEFINE_ALGEBRA)
#define NKW_ALGEBRA NKW_BODY
#else
#define NKW_ALGEBRA NKW_API
#endif

/**
 * NKW_ALGEBRA_ROOT stands before those that take a square root. They are inlined only where a word of the compiler is
 * the instruction: for sqrtf, which may set errno, a program would have to be linked with libm.
 */
#if NKW_INLINE && defined(__has_builtin)
#if __has_builtin(__builtin_ia32_sqrtss)
#define NKW_ROOT_INLINE 1
#endif
#endif
#if defined(NKW_ROOT_INLINE)
#define NKW_ALGEBRA_ROOT NKW_ALGEBRA
#else
#define NKW_ROOT_INLINE  0
#define NKW_ALGEBRA_ROOT NKW_API
#endif

/** First line of an inlined body: Clang and MSVC then fuse nothing in it, whatever the file's mode. */
#if defined(__clang__)
#define NKW_EXACT _Pragma("STDC FP_CONTRACT OFF")
#elif defined(_MSC_VER)
#define NKW_EXACT __pragma(fp_contract(off))
#else
#define NKW_EXACT
#endif

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Every code that a function of the data floors can give, with its text.
 * Functions on single values are total and give no code: each states its degenerate cases instead.
 */
#define NKW_RESULTS(X)                                                                             \
    X(NKW_OK, "no error")                                                                          \
    X(NKW_EMPTY, "there is nothing: no keys, no joints, no influences")                            \
    X(NKW_NOT_FINITE, "a number is infinite or not a number")                                      \
    X(NKW_NOT_ASCENDING, "a key time is less than the one before it")                              \
    X(NKW_NOT_UNIT, "an orientation is not a unit quaternion")                                     \
    X(NKW_BAD_METHOD, "no such method, kind, interpolation or target")                             \
    X(NKW_TOO_SMALL, "a block or an array is too small, or would be too large for size_t")         \
    X(NKW_OUT_OF_RANGE, "an index is out of range")                                                \
    X(NKW_NOT_ORDERED, "a joint stands before its parent")                                         \
    X(NKW_NOT_A_TREE, "a node is reached twice or not at all")                                     \
    X(NKW_BAD_MIRROR, "a joint is not its partner's partner")                                      \
    X(NKW_BAD_WEIGHTS, "weights are out of range or do not sum to 1")                              \
    X(NKW_TOO_MANY, "more bones or influences than there may be")                                  \
    X(NKW_NOT_A_CLIP, "not a clip of this version and byte order, or not aligned")                 \
    X(NKW_REPEATED, "two tracks move the same, or two chunks share a place")                       \
    X(NKW_BAD_WIDTH, "the width of a value is not that of its kind")                               \
    X(NKW_BAD_FORMAT, "no such format, or one that is for something else")                         \
    X(NKW_MISMATCHED, "two arguments are of different numbers of joints or floats")

/** What a function of the data floors gives: NKW_OK is 0, all else names what is wrong. */
typedef enum nkw_result {
#define NKW_RESULT_NAME(name, text) name,
    NKW_RESULTS(NKW_RESULT_NAME)
#undef NKW_RESULT_NAME
        NKW_RESULT_COUNT
} nkw_result;

/** The text of a result in English, without a full stop; "unknown result" for any other number. */
NKW_API const char *nkw_result_text(nkw_result result);

/** The version of the linked library: major * 10000 + minor * 100 + patch. */
NKW_API unsigned nkw_version(void);

#ifdef __cplusplus
}
#endif

#endif
