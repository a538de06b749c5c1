/* SPDX-License-Identifier: MIT */
/*
 * A loop over arrays of any values, at any offset, in place or not: the bits of its scalar function, nothing outside
 * the output.
 */
#include "fuzz.h"

#include "../parity/access.h"

static size_t arrays_of(const char *letters)
{
    size_t count = 0;
    for (; *letters; letters++)
        count += *letters == 'q' ? 4 : *letters == 'v' ? 3 : *letters == 'm' ? 9 : *letters == 'M' ? 16 : 1;
    return count;
}

/* An array of n floats that begins `shift` floats into a block of exactly that length. */
static float *array_at(fuzz *f, size_t n, size_t shift, int wild)
{
    return fuzz_floats(f, shift + n, wild) + shift;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz f = fuzz_begin(data, size);
    const row *w = &rows[fuzz_byte(&f) % ROWS];
    size_t n = fuzz_upto(&f, fuzz_byte(&f) % 8 ? 40 : 600), shift = fuzz_byte(&f) % 16, arrays = arrays_of(w->inputs);
    int wild = fuzz_byte(&f) % 4 != 0, in_place = w->in_place && fuzz_byte(&f) % 2;
    float *to[ARRAYS] = {NULL};
    const float *in[ARRAYS] = {NULL};
    for (size_t k = 0; k < arrays; k++)
        in[k] = to[k] = array_at(&f, n, shift, wild);
    float *want = fuzz_room(&f, 16 * n);
    for (size_t i = 0; i < n; i++) {
        float x[ARRAYS] = {0};
        for (size_t k = 0; k < arrays; k++)
            x[k] = in[k][i];
        w->single(x, want + 16 * i);
    }
    for (size_t k = 0; k < w->outputs; k++)
        if (!in_place || k >= arrays)
            to[k] = array_at(&f, n, fuzz_byte(&f) % 16, 0);
    w->loop(in, to, n);
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < w->outputs; k++)
            FUZZ_CHECK(fuzz_same(&to[k][i], want + 16 * i + k, 1));
    return fuzz_end(&f);
}
