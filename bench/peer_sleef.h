/* SPDX-License-Identifier: MIT */
/* SLEEF's vector functions of 1.0 ULP over arrays, for the vectors of each instruction set. */
#ifndef NAKAWARI_BENCH_PEER_SLEEF_H
#define NAKAWARI_BENCH_PEER_SLEEF_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef void peer_one(const float *x, float *out, size_t n);
typedef void peer_two(const float *x, const float *y, float *out, size_t n);

typedef struct peer_sleef {
    peer_one *sin, *tan, *asin, *acos, *atan, *exp, *log;
    peer_two *atan2, *pow;
    void (*sincos)(const float *x, float *sine, float *cosine, size_t n);
} peer_sleef;

extern const peer_sleef peer_sleef_sse2, peer_sleef_avx2, peer_sleef_avx512;

#ifdef __cplusplus
}
#endif

#endif
