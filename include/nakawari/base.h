/* SPDX-License-Identifier: MIT */
/**
 * @file
 * The version, the linkage macros and the list of results.
 *
 * The library reads and writes only the memory that the caller passes. It allocates nothing, keeps no state, and uses
 * no errno, no locale and no file. Every function may be called from any thread.
 *
 * Example  nkw_result result; const char *text; unsigned number;
 *
 *     text = nkw_result_text(result);                 the text of an error
 *     number = nkw_version();                         of the linked library: 10203 is 1.2.3
 */
#ifndef NAKAWARI_BASE_H
#define NAKAWARI_BASE_H

#include <float.h>
#include <stddef.h>

/** The version of these headers, as three numbers. nkw_version() returns the version of the linked library. */
#define NKW_VERSION_MAJOR 0
#define NKW_VERSION_MINOR 1
#define NKW_VERSION_PATCH 0

/**
 * NKW_API precedes the prototype of each function of the library. `extern` also makes a symbol of each inline function
 * in Clang's MSVC mode, which otherwise drops those that their file does not call. The shared library is built with
 * NKW_BUILD and NKW_SHARED and exports these functions; a static library is built with NKW_BUILD alone, and what links
 * it exports none of them. Users define neither: on Windows, calls go through the import library.
 */
#if defined(NKW_BUILD) && defined(_WIN32) && defined(NKW_SHARED)
#define NKW_API extern __declspec(dllexport) NKW_REALIGN
#elif defined(__GNUC__) && !defined(_WIN32) && (defined(NKW_SHARED) || !defined(NKW_BUILD))
#define NKW_API extern __attribute__((visibility("default"))) NKW_REALIGN
#else
#define NKW_API extern NKW_REALIGN
#endif

/** 32-bit callers on x86 may align their stack to 4 bytes: a function of the library aligns it to 16 for its vectors. */
#if defined(NKW_BUILD) && defined(__GNUC__) && defined(__i386__)
#define NKW_REALIGN __attribute__((force_align_arg_pointer))
#else
#define NKW_REALIGN
#endif

/**
 * In GNU mode and C++, GCC fuses a * b + c into one rounding if the target has fast fma. NKW_FMA is 1 there on x86 and
 * AArch64, and the small algebra computes its products so that GCC cannot fuse them (inline/product.h); otherwise 0.
 * NKW_FUSES is 1 on other targets, and where another compiler that defines __GNUC__ may fuse.
 */
#if !defined(__GNUC__) || defined(__clang__) || !(defined(__FP_FAST_FMAF) || defined(__FP_FAST_FMA)) ||                \
    defined(NKW_CONTRACTION_OFF) || (defined(__STRICT_ANSI__) && !defined(__cplusplus))
#define NKW_FMA   0
#define NKW_FUSES 0
#elif defined(__CUDACC__) || defined(__EDG__) || defined(__INTEL_COMPILER) || defined(__NVCOMPILER) ||                 \
    !defined(__FP_FAST_FMAF) || !(defined(__SSE2__) || defined(__aarch64__))
#define NKW_FMA   0
#define NKW_FUSES 1
#else
#define NKW_FMA   1
#define NKW_FUSES 0
#endif

/**
 * The small algebra (sums, products, rotations, transforms) is inlined into the caller from the headers in `inline/`,
 * except where the caller's compiler could change its bits. There the headers declare prototypes only, and the caller
 * calls the same functions in the library: the bits are the same, at the cost of a call. A compiler could change bits
 *
 *   - under -ffast-math or one of its parts;
 *   - where it evaluates float in a wider format (x87, s390x in ISO mode);
 *   - where it may fuse a * b + c into one rounding (NKW_FUSES).
 *
 * No macro reports two of these cases. Define NKW_NO_INLINE there:
 *
 *   - with -ffp-contract=fast (GCC in ISO mode; Clang), and with Clang's other parts of -ffast-math except
 *     -ffinite-math-only;
 *   - for functions with GCC's attribute target("fma").
 *
 * A program defines
 *
 *     NKW_NO_INLINE         to disable inlining; it changes no result
 *     NKW_CONTRACTION_OFF   if GCC compiles it with -ffp-contract=off: products are then a * b
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
#elif NKW_FUSES
#define NKW_INLINE 0
#else
#define NKW_INLINE 1
#endif

/** NKW_LITERAL(type){...} is a value of a struct type, in C and in C++: NKW_LITERAL(nkw_vec3){1.0f, 2.0f, 3.0f}. */
#ifdef __cplusplus
#define NKW_LITERAL(type) type
#else
#define NKW_LITERAL(type) (type)
#endif

/**
 * NKW_F32X4 is 1 where the compiler has a vector type with operators and the target has instructions for it, otherwise
 * 0. If a program defines NKW_PLAIN, it is 0. It changes no result.
 */
#if defined(__GNUC__) && (defined(__SSE2__) || defined(__aarch64__) || defined(__wasm_simd128__)) && !defined(NKW_PLAIN)
#define NKW_F32X4 1
#else
#define NKW_F32X4 0
#endif

/**
 * NKW_ROOT is 1 where the compiler has a built-in for the square root instruction, otherwise 0. sqrtf may set errno and
 * would require the program to link libm. The files of the library define NKW_LIBRARY and call sqrtf.
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
 * NKW_BODY precedes each body of the small algebra. A call that the compiler does not inline calls the library's
 * symbol. In C this follows from the rules of C99 for inline functions. C++ would emit a weak copy, compiled with this
 * file's -march, and the linker could choose that copy for the whole program; gnu_inline prevents this. With it GCC also
 * inlines the larger bodies, which it would leave out as too large, in C too.
 *
 * NKW_PART precedes a step that several bodies share. It is always inlined and has no symbol.
 */
#if defined(__GNUC__) && !defined(NKW_DEFINE_ALGEBRA)
#define NKW_BODY extern inline __attribute__((__gnu_inline__))
#else
#define NKW_BODY inline
#endif
#if defined(__GNUC__) || defined(__clang__)
#define NKW_PART extern inline __attribute__((__gnu_inline__, __always_inline__))
#else
#define NKW_PART static inline
#endif

/**
 * NKW_ALGEBRA precedes each prototype of the small algebra. It is NKW_BODY in a user's file. It is NKW_API where
 * NKW_INLINE is 0, and in the file of the library that defines the symbols. NKW_ALGEBRA_F32X4 and NKW_ALGEBRA_ROOT
 * precede the functions that are inlined only where NKW_F32X4 or NKW_ROOT is 1.
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

/** First line of an inlined body. It prevents Clang and MSVC from fusing operations, in every mode of the file. */
#if defined(__clang__)
#define NKW_EXACT _Pragma("STDC FP_CONTRACT OFF")
#elif defined(_MSC_VER)
#define NKW_EXACT __pragma(fp_contract(off))
#else
#define NKW_EXACT
#endif

/**
 * The layout of structs and enumerations is the same for every caller. NKW_SIZE follows each struct, with its size in
 * bytes for pointers of 64 and of 32 bits: a struct that another header packs (`#pragma pack`) does not compile. Each
 * enumeration ends in a value of 31 bits, NKW_..._MAX_ENUM: it has 32 bits where a compiler makes enumerations short
 * (-fshort-enums), and in C++ it can hold every number that C code may pass. Functions treat it as any unknown number.
 */
#define NKW_SIZE(type, bytes64, bytes32)                                                                               \
    typedef char nkwi_size_of_##type                                                                                   \
        [sizeof(void *) == 8 ? (sizeof(type) == (bytes64) ? 1 : -1)                                                    \
                             : (sizeof(void *) != 4 || sizeof(type) == (bytes32) ? 1 : -1)]

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Every result that a function on sets of data can return, with its text.
 * Scalar functions are total and return no result code: each states its degenerate cases.
 */
#define NKW_RESULTS(X)                                                                                                 \
    X(NKW_OK, "no error")                                                                                              \
    X(NKW_EMPTY, "the input is empty: no keys, no joints or no influences")                                            \
    X(NKW_NOT_FINITE, "a number is infinite or not a number")                                                          \
    X(NKW_NOT_ASCENDING, "a key time is less than the one before it")                                                  \
    X(NKW_NOT_UNIT, "an orientation is not a unit quaternion")                                                         \
    X(NKW_BAD_METHOD, "unknown method, kind, interpolation or target")                                                 \
    X(NKW_TOO_SMALL, "a block or an array is too small, or its size exceeds size_t")                                   \
    X(NKW_OUT_OF_RANGE, "an index is out of range")                                                                    \
    X(NKW_NOT_ORDERED, "a joint precedes its parent")                                                                  \
    X(NKW_NOT_A_TREE, "a node is reached twice or not at all")                                                         \
    X(NKW_BAD_MIRROR, "a joint is not its partner's partner")                                                          \
    X(NKW_BAD_WEIGHTS, "weights are out of range or do not sum to 1")                                                  \
    X(NKW_TOO_MANY, "a number exceeds its limit")                                                                      \
    X(NKW_NOT_A_CLIP, "not a clip of this version and byte order, or not aligned")                                     \
    X(NKW_REPEATED, "two tracks animate the same value, or two chunks overlap")                                        \
    X(NKW_BAD_WIDTH, "the width of a value does not match its kind")                                                   \
    X(NKW_BAD_FORMAT, "unknown format, or a format for other data")                                                    \
    X(NKW_MISMATCHED, "two arguments differ in kind, in width or in a count")                                          \
    X(NKW_NO_RATE, "no rate has these key times, or none is within the tolerance")

/** The result of a function on sets of data. NKW_OK is 0; every other value names an error. */
typedef enum nkw_result {
#define NKW_RESULT_NAME(name, text) name,
    NKW_RESULTS(NKW_RESULT_NAME)
#undef NKW_RESULT_NAME
        NKW_RESULT_COUNT,
    NKW_RESULT_MAX_ENUM = 0x7fffffff
} nkw_result;

/** Returns the text of a result in English, without a full stop; "unknown result" for any other number. */
NKW_API const char *nkw_result_text(nkw_result result);

/** Returns the version of the linked library: major * 10000 + minor * 100 + patch. */
NKW_API unsigned nkw_version(void);

#ifdef __cplusplus
}
#endif

#endif
