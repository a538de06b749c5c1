/* SPDX-License-Identifier: MIT */
/* XXH64 of 32-bit words that come in pieces. */
#ifndef NAKAWARI_FINGERPRINT_WORDS_H
#define NAKAWARI_FINGERPRINT_WORDS_H

#include "lane/strict.h"

#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "lane/scalar.h"

#define FINGERPRINT_STRIPE 8 /* words */
#define FINGERPRINT_CHUNK  64 /* words: whole stripes */

typedef struct fingerprint_sums {
    uint64_t sum[4];
    uint64_t from;
    uint64_t words; /* that are in the sums */
} fingerprint_sums;

fingerprint_sums nkwi_fingerprint_begin(uint64_t from);

/* count: whole stripes. */
void nkwi_fingerprint_add(fingerprint_sums *sums, const uint32_t *words, size_t count);

/* Adds the last words, of any count. */
uint64_t nkwi_fingerprint_end(fingerprint_sums *sums, const uint32_t *words, size_t count);

/* Of each of `arrays` component arrays of a pose or of offsets, one from the other. */
uint64_t nkwi_fingerprint_arrays(const float *data, size_t arrays, size_t joint_count, uint64_t from);

/* The bits of a float; every NaN is one. */
static inline uint32_t fingerprint_word(float x)
{
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return (bits & 0x7fffffffu) > 0x7f800000u ? 0x7fc00000u : bits;
}

#endif
