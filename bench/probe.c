/* SPDX-License-Identifier: MIT */
/* Compiled once for each instruction set, PROBE_ISA its name and PROBE_BYTES the bytes of its vectors. */
#include "probe.h"

#define JOIN(name, isa)     name##_##isa
#define JOIN_ISA(name, isa) JOIN(name, isa)

typedef float wide __attribute__((vector_size(PROBE_BYTES)));

enum { CHAINS = 12, LANES = PROBE_BYTES / sizeof(float) };

/*
 * Twelve chains hide the latency of both, and fit into sixteen registers. Ends at the fixed point 1, so nothing
 * overflows.
 */
static double work(float *x, size_t rounds)
{
    wide *v = (wide *)x;
    wide a = v[0], b = v[1], c = v[2], d = v[3], e = v[4], f = v[5];
    wide g = v[6], h = v[7], i = v[8], j = v[9], k = v[10], l = v[11];
    const wide p = v[0] * 0.0f + 0.5f;
    for (size_t n = 0; n < rounds; n++) {
        a = a * p + p, b = b * p + p, c = c * p + p, d = d * p + p, e = e * p + p, f = f * p + p;
        g = g * p + p, h = h * p + p, i = i * p + p, j = j * p + p, k = k * p + p, l = l * p + p;
    }
    v[0] = ((a + b) + (c + d)) + ((e + f) + (g + h)) + ((i + j) + (k + l));
    return (double)rounds * CHAINS * LANES * 2;
}

static void copy(const float *x, float *out, size_t n)
{
    const wide *from = (const wide *)x;
    wide *to = (wide *)out;
    for (size_t i = 0; i < n / LANES; i += 4) {
        to[i] = from[i] + from[i];
        to[i + 1] = from[i + 1] + from[i + 1];
        to[i + 2] = from[i + 2] + from[i + 2];
        to[i + 3] = from[i + 3] + from[i + 3];
    }
}

const probe JOIN_ISA(probe, PROBE_ISA) = {work, copy};
