/* SPDX-License-Identifier: MIT */
/*
 * The fingerprint of a clip: the words of its block as a little-endian machine has them. Words are numbers, the same on
 * every machine; the parts that are not (clip_parts.h) have another order in the words of a big-endian one:
 *
 *     bytes in memory     two 16-bit numbers 1 2      four bytes 1 2 3 4
 *     little-endian       0x00020001                  0x04030201
 *     big-endian          0x00010002: halves          0x01020304: bytes
 */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/fingerprint.h>

#include "clip_layout.h"
#include "clip_parts.h"
#include "fingerprint_words.h"

#define CHUNK 256 /* words: whole stripes */

static int is_little(void)
{
    const uint32_t one = 1;
    unsigned char first;
    memcpy(&first, &one, 1);
    return first == 1;
}

/* Words from `at` on. */
typedef struct clip_chunk {
    uint32_t words[CHUNK];
    uint64_t at, count;
} clip_chunk;

/* Exchanges the words of a part that are in the chunk. */
static void exchange(void *user, clip_part part, uint64_t at, uint64_t count)
{
    clip_chunk *c = (clip_chunk *)user;
    const uint64_t end = at + count < c->at + c->count ? at + count : c->at + c->count;
    for (uint64_t i = at > c->at ? at : c->at; i < end; i++) {
        uint32_t *w = &c->words[i - c->at];
        *w = part == PART_HALVES ? clip_swapped_halves(*w) : clip_swapped_bytes(*w);
    }
}

uint64_t nkw_clip_fingerprint(const nkw_clip *clip, uint64_t from)
{
    const uint32_t *words = clip_words(clip);
    fingerprint_sums sums = nkwi_fingerprint_begin(from);
    clip_chunk c;
    if (is_little())
        return nkwi_fingerprint_end(&sums, words, clip->words);
    for (c.at = 0;; c.at += CHUNK) {
        c.count = clip->words - c.at < CHUNK ? clip->words - c.at : CHUNK;
        memcpy(c.words, words + c.at, (size_t)c.count * sizeof *words);
        nkwi_clip_parts(words, clip->words, exchange, &c);
        if (c.count < CHUNK)
            return nkwi_fingerprint_end(&sums, c.words, (size_t)c.count);
        nkwi_fingerprint_add(&sums, c.words, CHUNK);
    }
}
