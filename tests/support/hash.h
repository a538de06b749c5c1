/* SPDX-License-Identifier: MIT */
#ifndef NAKAWARI_TESTS_HASH_H
#define NAKAWARI_TESTS_HASH_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

#define HASH_START UINT64_C(0xcbf29ce484222325)

/* FNV-1a over the bits, lowest byte first; every NaN counts as one. */
static inline uint64_t hash_floats(uint64_t hash, const float *o, size_t count)
{
    for (size_t k = 0; k < count; k++) {
        uint32_t bits = 0x7fc00000u;
        if (o[k] == o[k])
            memcpy(&bits, &o[k], sizeof bits);
        for (unsigned b = 0; b < 32; b += 8) {
            hash ^= (bits >> b) & 0xff;
            hash *= UINT64_C(0x100000001b3);
        }
    }
    return hash;
}

#endif
