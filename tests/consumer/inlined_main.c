/* SPDX-License-Identifier: MIT */
/* Compares the bits of inlined.c's two compilations; exit status 1 if any differ. */
#include <stdio.h>
#include <string.h>

#include "random.h"

#define FLOATS 67

typedef void part(const float *in, float *out);
part inlined_vectors, inlined_quats, inlined_matrices, inlined_curves, inlined_scalars, inlined_rotations;
part called_vectors, called_quats, called_matrices, called_curves, called_scalars, called_rotations;
void inlined_many(const float *in, float *out, size_t n);
void called_many(const float *in, float *out, size_t n);

static void inlined_loop(const float *in, float *out)
{
    inlined_many(in, out, FLOATS);
}

static void called_loop(const float *in, float *out)
{
    called_many(in, out, FLOATS);
}

static const struct {
    const char *name;
    part *inlined, *called;
} parts[] = {
    {"vectors", inlined_vectors, called_vectors},    {"quats", inlined_quats, called_quats},
    {"matrices", inlined_matrices, called_matrices}, {"curves", inlined_curves, called_curves},
    {"scalars", inlined_scalars, called_scalars},    {"rotations", inlined_rotations, called_rotations},
    {"a loop", inlined_loop, called_loop},
};

/* Numbers of moderate size, one in eight a zero of either sign. */
static float some_number(random_source *r)
{
    unsigned kind = (unsigned)(random_bits(r) % 16);
    return kind == 0 ? 0.0f : kind == 1 ? -0.0f : random_scaled(r, -4, 3);
}

/* The same bits, or both NaN. */
static int same(float a, float b)
{
    return memcmp(&a, &b, sizeof a) == 0 || (a != a && b != b);
}

static unsigned differences(size_t part, const float *in)
{
    float a[3 * FLOATS] = {0}, b[3 * FLOATS] = {0};
    unsigned differ = 0;
    parts[part].inlined(in, a);
    parts[part].called(in, b);
    for (size_t i = 0; i < 3 * FLOATS; i++)
        differ += !same(a[i], b[i]);
    return differ;
}

int main(void)
{
    random_source r = random_from(5);
    unsigned failed = 0;
    for (size_t part = 0; part < sizeof parts / sizeof parts[0]; part++) {
        unsigned differ = 0;
        for (int round = 0; round < 5000; round++) {
            float in[FLOATS];
            for (size_t i = 0; i < FLOATS; i++)
                in[i] = some_number(&r);
            differ += differences(part, in);
        }
        printf("%s: %u floats differ\n", parts[part].name, differ);
        failed += differ != 0;
    }
    return failed != 0;
}
