/* SPDX-License-Identifier: MIT */
/*
 * What the machine can do at most, measured in the same run: additions and multiplications (no fused ones, which the
 * library does not use) and the copying of arrays, each for the vectors of an instruction set.
 */
#ifndef NAKAWARI_BENCH_PROBE_H
#define NAKAWARI_BENCH_PROBE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct probe {
    /*
     * `rounds` times a multiplication and an addition on each of 12 vectors; gives how many operations on floats that
     * were.
     */
    double (*work)(float *x, size_t rounds);
    /* out[i] = 2 x[i] */
    void (*copy)(const float *x, float *out, size_t n);
} probe;
extern const probe probe_sse2, probe_avx2, probe_avx512;

#ifdef __cplusplus
}

#include <string>
#include <vector>

#include "report.h"

namespace bench
{

/* Gflop/s; GB/s, bytes read plus bytes written, of arrays that lie in each level. */
struct limits {
    std::string isa;
    double flops, near_copy, second_copy, third_copy, far_copy;
};

/* Of the instruction sets that this processor has, the widest last. */
const std::vector<limits> &machine_limits();

/* The least time that one element of the row can take: its flops at the peak, or its bytes at the copying rate. */
double limit_ns(const row &r);

} // namespace bench
#endif

#endif
