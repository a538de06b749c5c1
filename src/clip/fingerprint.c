/* SPDX-License-Identifier: MIT */
/* XXH64 of words: of floats and poses here, of clips and mixers in their files. */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/fingerprint.h>

#include "fingerprint_words.h"

#define PRIME_1 UINT64_C(0x9e3779b185ebca87)
#define PRIME_2 UINT64_C(0xc2b2ae3d27d4eb4f)
#define PRIME_3 UINT64_C(0x165667b19e3779f9)
#define PRIME_4 UINT64_C(0x85ebca77c2b2ae63)
#define PRIME_5 UINT64_C(0x27d4eb2f165667c5)

static uint64_t rotate(uint64_t x, unsigned bits)
{
    return x << bits | x >> (64 - bits);
}

static uint64_t two_words(const uint32_t *w)
{
    return (uint64_t)w[1] << 32 | w[0];
}

static uint64_t mix(uint64_t sum, uint64_t input)
{
    return rotate(sum + input * PRIME_2, 31) * PRIME_1;
}

fingerprint_sums nkwi_fingerprint_begin(uint64_t from)
{
    const fingerprint_sums sums = {{from + PRIME_1 + PRIME_2, from + PRIME_2, from, from - PRIME_1}, from, 0};
    return sums;
}

void nkwi_fingerprint_add(fingerprint_sums *sums, const uint32_t *words, size_t count)
{
    sums->words += count;
    for (size_t i = 0; i < count; i += FINGERPRINT_STRIPE)
        for (size_t k = 0; k < 4; k++)
            sums->sum[k] = mix(sums->sum[k], two_words(words + i + 2 * k));
}

static uint64_t joined(const fingerprint_sums *sums)
{
    const uint64_t *s = sums->sum;
    uint64_t hash = rotate(s[0], 1) + rotate(s[1], 7) + rotate(s[2], 12) + rotate(s[3], 18);
    for (size_t k = 0; k < 4; k++)
        hash = (hash ^ mix(0, s[k])) * PRIME_1 + PRIME_4;
    return hash;
}

uint64_t nkwi_fingerprint_end(fingerprint_sums *sums, const uint32_t *words, size_t count)
{
    const size_t whole = count - count % FINGERPRINT_STRIPE;
    nkwi_fingerprint_add(sums, words, whole);
    uint64_t hash = sums->words ? joined(sums) : sums->from + PRIME_5;
    hash += 4 * (sums->words + (count - whole));
    size_t i = whole;
    for (; i + 2 <= count; i += 2)
        hash = rotate(hash ^ mix(0, two_words(words + i)), 27) * PRIME_1 + PRIME_4;
    if (i < count)
        hash = rotate(hash ^ words[i] * PRIME_1, 23) * PRIME_2 + PRIME_3;
    hash = (hash ^ hash >> 33) * PRIME_2;
    hash = (hash ^ hash >> 29) * PRIME_3;
    return hash ^ hash >> 32;
}

uint64_t nkw_fingerprint_floats(const float *values, size_t count, uint64_t from)
{
    uint32_t words[FINGERPRINT_CHUNK];
    fingerprint_sums sums = nkwi_fingerprint_begin(from);
    for (;; values += FINGERPRINT_CHUNK, count -= FINGERPRINT_CHUNK) {
        const size_t n = count < FINGERPRINT_CHUNK ? count : FINGERPRINT_CHUNK;
        for (size_t i = 0; i < n; i++)
            words[i] = fingerprint_word(values[i]);
        if (n < FINGERPRINT_CHUNK)
            return nkwi_fingerprint_end(&sums, words, n);
        nkwi_fingerprint_add(&sums, words, n);
    }
}

uint64_t nkwi_fingerprint_arrays(const float *data, size_t arrays, size_t joint_count, uint64_t from)
{
    for (size_t c = 0; c < arrays; c++)
        from = nkw_fingerprint_floats(data + c * NKW_POSE_STRIDE(joint_count), joint_count, from);
    return from;
}

uint64_t nkw_pose_fingerprint(nkw_pose_view pose, uint64_t from)
{
    return nkwi_fingerprint_arrays(pose.data, 10, pose.joint_count, from);
}
