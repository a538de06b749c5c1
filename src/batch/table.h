/* SPDX-License-Identifier: MIT */
/*
 * The loops of one instruction set. The build compiles src/batch once for each, with NKW_ISA its name; without
 * NKW_ISA it is `generic`, for the flags as they are.
 */
#ifndef NAKAWARI_BATCH_TABLE_H
#define NAKAWARI_BATCH_TABLE_H

#include "batch/kernels.h"

#ifndef NKW_ISA
#define NKW_ISA generic
#endif

#define NKW_JOIN(name, isa)     name##_##isa
#define NKW_JOIN_ISA(name, isa) NKW_JOIN(name, isa)
/* name_avx2 and its like. */
#define NKW_PER_ISA(name) NKW_JOIN_ISA(name, NKW_ISA)

/*
 * Opens the definition of a loop: KERNEL(quat_slerp)(nkw_quat_view a, ...). All its calls are inlined, whatever the
 * optimiser thinks of it: one that is left keeps it from vectorising.
 */
#define KERNEL(name) LANE_FLAT void NKW_PER_ISA(nkw_batch_##name)

/* A part of a kernel to which counts and formats are constants: compilers do not see by themselves that it pays. */
#if defined(__GNUC__)
#define INLINE static inline __attribute__((always_inline))
#else
#define INLINE static inline
#endif

/* Before a loop over a constant few: Clang would take it apart before it looks for vectors, and then find none. */
#if defined(__clang__)
#define KEEP_LOOP _Pragma("clang loop unroll(disable)")
#else
#define KEEP_LOOP
#endif

/* A condition that mostly holds: what it guards comes first. */
#if defined(__GNUC__)
#define USUALLY(condition) __builtin_expect(!!(condition), 1)
#else
#define USUALLY(condition) (condition)
#endif

/* A part of a kernel that stays a function of its own, lest a large one be compiled in one piece. */
#if defined(__GNUC__)
#define APART __attribute__((noinline))
#else
#define APART
#endif

/* One function pointer for each loop. */
typedef struct nkw_batch {
#define KERNEL_MEMBER(name, parameters, arguments) void(*name) parameters;
    KERNEL_LIST(KERNEL_MEMBER)
    KERNEL_INNER_LIST(KERNEL_MEMBER)
#undef KERNEL_MEMBER
} nkw_batch;

#define KERNEL_DECLARE(name, parameters, arguments) void NKW_PER_ISA(nkw_batch_##name) parameters;
KERNEL_LIST(KERNEL_DECLARE)
KERNEL_INNER_LIST(KERNEL_DECLARE)
#undef KERNEL_DECLARE

#endif
