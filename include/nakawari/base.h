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
 * `inline/`, except where the caller's compiler could change its bits. There these headers declare prototypes only, and
 * the same functions are called in the library: same bits, one call slower. A compiler could change bits
 *
 *   - under -ffast-math or one of its parts;
 *   - where it evaluates float in a wider format (x87, s390x in ISO mode);
 *   - where it may fuse a * b + c into one rounding: GCC in GNU mode or C++ on a target with fast fma.
 *
 * No macro reports two cases; define NKW_NO_INLINE there: -ffp-contract=fast, for GCC in ISO mode and for Clang, with
 * Clang's other parts of -ffast-math except -ffinite-math-only; and a function with GCC's attribute target("fma").
 *
 * NKW_CONTRACTION_OFF, defined by a program that GCC compiles with -ffp-contract=off, allows inlining in GNU mode too.
 *
 * NKW_NO_INLINE disables inlining. It changes no result.
 *
 * NKW_INLINE is 1 where the definitions are inlined, otherwise 0.
 */
#if defined(NKW_NO_INLINE) || defined(__FAST_MATH__) || defined(_M_FP_FAST)
#define NKW_INLINE 0
#elif defined(__GNUC_GNU_INLINE__) && !defined(__cplusplus) /* Clang defines it in C++ too */
#define NKW_INLINE 0
#elif defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(__NO_SIGNED_ZEROS__) ||                 \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#define NKW_INLINE 0
#elif defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 16
#define NKW_INLINE 0
#elif (defined(__i386__) && !defined(__SSE2_MATH__)) || (defined(_M_IX86_FP) && _M_IX86_FP < 2)
#define NKW_INLINE 0 /* Clang reports 0 above where float is computed by SSE, but double by x87 */
#elif defined(__GNUC__) && !defined(__clang__) && (defined(__FP_FAST_FMAF) || defined(__FP_FAST_FMA)) &&               \
    !defined(NKW_CONTRACTION_OFF) && (!defined(__STRICT_ANSI__) || defined(__cplusplus))
#define NKW_INLINE 0
#else
#define NKW_INLINE 1
#endif

/**
 * NKW_F32X4 is 1 where the compiler has a vector type with operators and the target an instruction set for it, otherwise
 * 0. NKW_PLAIN, defined, makes it 0. It changes no result.
 */
#if defined(__GNUC__) && (defined(__SSE2__) || defined(__aarch64__) || defined(__wasm_simd128__)) && !defined(NKW_PLAIN)
#define NKW_F32X4 1
#else
#define NKW_F32X4 0
#endif

/**
 * NKW_ROOT is 1 where the compiler has a built-in square root instruction, otherwise 0: sqrtf, which may set errno,
 * would require a program to link libm. The library's own files, which define NKW_LIBRARY, call sqrtf.
 */
#if defined(NKW_LIBRARY)
#define NKW_ROOT 1
#elif defined(__has_builtin)
#if __has_builtin(__builtin_ia32_sqrtss)
#define NKW_ROOT 1
#endif
#endif
#if !defined(NKW_ROOT)
#define NKW_ROOT 0
#endif

/**
 * NKW_BODY precedes each body of the small algebra. A call that is not inlined is a call of the library's symbol: in C
 * by the rules of C99. C++ would emit a weak copy, compiled with this file's -march, which the linker could choose for
 * the whole program; gnu_inline prevents that.
 *
 * NKW_PART precedes a step that several bodies share. It is always inlined and has no symbol.
 */
#if defined(__cplusplus) && defined(__GNUC__)
#define NKW_BODY extern inline __attribute__((__gnu_inline__))
#else
#define NKW_BODY inline
#endif
#if defined(__GNUC__)
#define NKW_PART extern inline __attribute__((__gnu_inline__, __always_inline__))
#else
#define NKW_PART static inline
#endif

/**
 * NKW_ALGEBRA precedes each prototype of the small algebra: NKW_BODY in a user's file, a plain exported declaration in
 * the library file that defines the symbols and where NKW_INLINE is 0. NKW_ALGEBRA_F32X4 and NKW_ALGEBRA_ROOT precede
 * those that are inlined only where NKW_F32X4 or NKW_ROOT is 1.
 */
#if NKW_INLINE && !defined(NKW_DEFINE_ALGEBRA)
#define NKW_ALGEBRA NKW_BODY
#else
#define NKW_ALGEBRA NKW_API
#endif
#if NKW_F32X4
#define NKW_ALGEBRA_F32X4 NKW_ALGEBRA
#else
#define NKW_ALGEBRA_F32X4 NKW_API
#endif
#if NKW_ROOT
#define NKW_ALGEBRA_ROOT NKW_ALGEBRA
#else
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
#define NKW_RESULTS(X)                                                                                                 \
    X(NKW_OK, "no error")                                                                                              \
    X(NKW_EMPTY, "there is nothing: no keys, no joints, no influences")                                                \
    X(NKW_NOT_FINITE, "a number is infinite or not a number")                                                          \
    X(NKW_NOT_ASCENDING, "a key time is less than the one before it")                                                  \
    X(NKW_NOT_UNIT, "an orientation is not a unit quaternion")                                                         \
    X(NKW_BAD_METHOD, "no such method, kind, interpolation or target")                                                 \
    X(NKW_TOO_SMALL, "a block or an array is too small, or would be too large for size_t")                             \
    X(NKW_OUT_OF_RANGE, "an index is out of range")                                                                    \
    X(NKW_NOT_ORDERED, "a joint stands before its parent")                                                             \
    X(NKW_NOT_A_TREE, "a node is reached twice or not at all")                                                         \
    X(NKW_BAD_MIRROR, "a joint is not its partner's partner")                                                          \
    X(NKW_BAD_WEIGHTS, "weights are out of range or do not sum to 1")                                                  \
    X(NKW_TOO_MANY, "more bones or influences than there may be")                                                      \
    X(NKW_NOT_A_CLIP, "not a clip of this version and byte order, or not aligned")                                     \
    X(NKW_REPEATED, "two tracks move the same, or two chunks share a place")                                           \
    X(NKW_BAD_WIDTH, "the width of a value is not that of its kind")                                                   \
    X(NKW_BAD_FORMAT, "no such format, or one that is for something else")                                             \
    X(NKW_MISMATCHED, "two arguments are of different kinds or numbers of joints or floats")                           \
    X(NKW_NO_RATE, "no rate has these key times, or is within the tolerance")

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
