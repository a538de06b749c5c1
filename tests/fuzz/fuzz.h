/* SPDX-License-Identifier: MIT */
/*
 * Harnesses that feed the library with whatever bytes come: hostile counts, indices, links, formats, NaN.
 *
 *     int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
 *     {
 *         fuzz f = fuzz_begin(data, size);
 *         ...
 *         return fuzz_end(&f);
 *     }
 *
 * Memory comes in blocks of the very size that is asked for. Under AddressSanitizer nothing stands around them;
 * elsewhere guard bytes do, and fuzz_end looks at them. A broken promise aborts.
 */
#ifndef NAKAWARI_TESTS_FUZZ_H
#define NAKAWARI_TESTS_FUZZ_H

#include <stddef.h>
#include <stdint.h>

#include "../support/random.h"

#define FUZZ_BLOCKS 320

typedef struct fuzz {
    const uint8_t *data;
    size_t size;
    struct {
        unsigned char *memory;
        size_t bytes;
    } block[FUZZ_BLOCKS];
    size_t blocks;
} fuzz;

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

fuzz fuzz_begin(const uint8_t *data, size_t size);
/* Looks at the guards and frees all blocks. Gives 0. */
int fuzz_end(fuzz *f);

/* ---- From the input; zeros when it is used up ---- */

uint32_t fuzz_bits(fuzz *f);
unsigned char fuzz_byte(fuzz *f);
/* 0 .. n, n at most 2^16 - 1. */
size_t fuzz_upto(fuzz *f, size_t n);
/* Now and then none of the values 0 .. n. */
int fuzz_choice(fuzz *f, int n);
/* As wide as size_t, small or at a power of two. */
size_t fuzz_huge(fuzz *f);
/* A float of any bits, or a round one, or a special one. */
float fuzz_float(fuzz *f);
/* A source of its own, for arrays. */
random_source fuzz_source(fuzz *f);

/* ---- Memory until fuzz_end ---- */

/* Holds 0xa5. */
void *fuzz_block(fuzz *f, size_t bytes);
float *fuzz_room(fuzz *f, size_t floats);

static inline nkw_work fuzz_work(fuzz *f, size_t bytes)
{
    const nkw_work work = {fuzz_block(f, bytes), bytes};
    return work;
}

/* Between -4 and 4; wild: now and then anything at all. */
float *fuzz_floats(fuzz *f, size_t count, int wild);
void *fuzz_bytes(fuzz *f, size_t bytes);
/* Indices 0 .. count - 1 and -1; wild: now and then anything. */
int32_t *fuzz_links(fuzz *f, size_t n, size_t count, int wild);
/* Parents before children; wild: now and then anything. */
int32_t *fuzz_parents(fuzz *f, size_t n, int wild);
/* A pose of unit rotations; wild: now and then anything. Its padding is anything. */
float *fuzz_pose(fuzz *f, size_t joints, int wild);
/* Affine matrices of poses; wild: now and then anything. */
nkw_mat4 *fuzz_matrices(fuzz *f, size_t n, int wild);

/* ---- Promises ---- */

#define FUZZ_CHECK(holds) fuzz_check((holds), #holds, __FILE__, __LINE__)
void fuzz_check(int holds, const char *what, const char *file, int line);

int fuzz_finite(const float *v, size_t n);
/* The same bits, but any NaN is as good as another. */
int fuzz_same(const float *a, const float *b, size_t n);
/* Of the matrices, each last row being exactly 0 0 0 1. */
int fuzz_affine(const nkw_mat4 *m, size_t n);

#endif
