/* SPDX-License-Identifier: MIT */
/*
 * Each batch function, by the loops of each instruction set that this processor has, against the single function: bit
 * for bit, for the lengths 0..67 and some longer, at every alignment, in place and not, with guard words around the
 * outputs. None divides by zero.
 *
 * A plain program, so that it also runs where there is no test library: on emulators, under Wine, in WebAssembly.
 */
#include <stdio.h>
#include <string.h>

#include <nakawari/nakawari.h>

#include "../support/data.h"
#include "../support/exceptions.h"
#include "../support/isas.h"
#include "../support/put.h"
#include "../support/random.h"
#include "../support/loops.h"
#include "access.h"

#define GUARD   16
#define STRIDE  (LONGEST + 2 * GUARD)
#define WORD    0xfb5a5a5au /* a number that no function returns, about -1.1e36 */

/* Inputs and outputs of one run: element i of array k is at [k][GUARD + shift + i]. */
static float inputs[ARRAYS][STRIDE], outputs[ARRAYS][STRIDE], pristine[ARRAYS][STRIDE];

/* Mostly of moderate size, now and then anything finite. */
static float number(random_source *r)
{
    return random_bits(r) % 16 == 0 ? random_finite(r) : random_scaled(r, -8, 3);
}

/* Few are outside 0..1, or no loop of many elements would do without the way that is for those. */
static float parameter(random_source *r)
{
    const float ends[4] = {0.0f, 0.5f, 1.0f, -0.0f};
    uint64_t kind = random_bits(r) % 64;
    return kind < 12 ? ends[kind % 4] : kind == 12 ? random_scaled(r, -3, 1) : random_unit(r);
}

/* Writes the arrays of one letter for element i. Returns their number. */
static size_t draw_letter(random_source *r, char letter, size_t k, size_t i)
{
    size_t count = letter == 'q' ? 4 : letter == 'v' ? 3 : letter == 'm' ? 9 : letter == 'M' ? 16 : 1;
    float values[16];
    for (size_t j = 0; j < count; j++)
        values[j] = letter == 't' ? parameter(r) : number(r);
    if (letter == 'q' && random_bits(r) % 16)
        put_quat(values, random_rotation(r));
    if (letter == 'm' && random_bits(r) % 16)
        put_mat3(values, nkw_mat3_from_quat(random_rotation(r)));
    for (size_t j = 0; j < count; j++)
        inputs[k + j][i] = values[j];
    return count;
}

/*
 * Fills the inputs up to `end`. Returns the number of arrays of the row. Every other pair of quaternions is close or
 * opposite; of eight one has -0 in the first, one in both.
 */
static size_t draw(random_source *r, const row *w, size_t end)
{
    size_t count = 0;
    for (size_t i = 0; i < end; i++) {
        count = 0;
        for (const char *l = w->inputs; *l; l++)
            count += draw_letter(r, *l, count, i);
        if (strncmp(w->inputs, "qq", 2) == 0 && i % 2)
            for (size_t j = 0; j < 4; j++)
                inputs[4 + j][i] = (i % 4 == 1 ? -1.0f : 1.0f) * inputs[j][i] * (i % 8 < 4 ? 1.0f : 1.00001f);
        if (strncmp(w->inputs, "qq", 2) == 0 && i % 8 == 2)
            inputs[0][i] = -0.0f;
        if (strncmp(w->inputs, "qq", 2) == 0 && i % 8 == 4)
            inputs[0][i] = inputs[4][i] = -0.0f;
    }
    return count;
}

static uint32_t bits(float f)
{
    uint32_t b;
    memcpy(&b, &f, sizeof b);
    return f != f ? 0x7fc00000u : b;
}

static void fill_guards(size_t arrays)
{
    const uint32_t word = WORD;
    for (size_t k = 0; k < arrays; k++)
        for (size_t i = 0; i < STRIDE; i++)
            memcpy(&outputs[k][i], &word, sizeof word);
}

static int complain(const row *w, const char *isa, size_t n, size_t k, size_t i, float got, float want)
{
    fprintf(stderr, "parity: %s, %s, length %zu, output %zu, element %zu: %08lx (%a), not %08lx (%a)\n", w->name, isa,
            n, k, i, (unsigned long)bits(got), (double)got, (unsigned long)bits(want), (double)want);
    return 1;
}

/* Compares the outputs from `start` on, and the words before and after them with what they held. */
static int compare(const row *w, const char *isa, size_t n, size_t start, size_t arrays, int in_place)
{
    for (size_t i = 0; i < STRIDE; i++) {
        float x[ARRAYS], o[16] = {0};
        int inside = i >= start && i < start + n;
        for (size_t k = 0; inside && k < arrays; k++)
            x[k] = pristine[k][i];
        if (inside)
            w->single(x, o);
        for (size_t k = 0; k < w->outputs; k++) {
            int reused = in_place && k < arrays;
            float got = reused ? inputs[k][i] : outputs[k][i];
            float guard;
            const uint32_t word = WORD;
            memcpy(&guard, &word, sizeof guard);
            float want = inside ? o[k] : reused ? pristine[k][i] : guard;
            if (bits(got) != bits(want))
                return complain(w, isa, n, k, i - start, got, want);
        }
    }
    return 0;
}

static int run(const row *w, const char *isa, size_t n, size_t shift, int in_place,
               random_source *r)
{
    const float *in[ARRAYS];
    float *out[ARRAYS];
    size_t start = GUARD + shift, arrays = draw(r, w, start + n);
    fill_guards(w->outputs);
    memcpy(pristine, inputs, arrays * sizeof *inputs);
    for (size_t k = 0; k < ARRAYS; k++) {
        in[k] = inputs[k] + start;
        out[k] = (in_place && k < arrays ? inputs[k] : outputs[k]) + start;
    }
    clear_exceptions();
    w->loop(in, out, n);
    if (report_exceptions("parity", w->name, isa, raised_exceptions(EXCEPTION_DIVISION)))
        return 1;
    return compare(w, isa, n, start, arrays, in_place);
}

static int run_row(const row *w, const char *isa)
{
    random_source r = random_from(7);
    int failed = 0;
    for (size_t n = 0; n <= 67 && !failed; n++)
        failed = run(w, isa, n, n % 16, 0, &r) || (w->in_place && run(w, isa, n, (n + 5) % 16, 1, &r));
    static const size_t lengths[] = {255, 256, 257, 583};
    for (size_t i = 0; i < 4 && !failed; i++)
        failed = run(w, isa, lengths[i], 3, 0, &r) || (w->in_place && run(w, isa, lengths[i], 1, 1, &r));
    return failed;
}

/* Back to structs what was unpacked from them. */
static int run_packs(const char *isa)
{
    random_source r = random_from(8);
    static float back[16 * LONGEST];
    for (size_t n = 0; n <= 67; n++) {
        static const row any = {"pack", "M", 16, 0, NULL, NULL};
        const float *in[16];
        draw(&r, &any, n + 1);
        for (size_t k = 0; k < 16; k++)
            in[k] = inputs[k] + 1;
        nkw_vec3_pack_n(V(0), (nkw_vec3 *)(void *)back, n);
        if (n && memcmp(back, aos(in, 3, n), n * sizeof(nkw_vec3)) != 0)
            return fprintf(stderr, "parity: vec3_pack, %s, length %zu\n", isa, n) > 0;
        nkw_quat_pack_n(Q(0), (nkw_quat *)(void *)back, n);
        if (n && memcmp(back, aos(in, 4, n), n * sizeof(nkw_quat)) != 0)
            return fprintf(stderr, "parity: quat_pack, %s, length %zu\n", isa, n) > 0;
        nkw_mat4_pack_n(M4(0), (nkw_mat4 *)(void *)back, n);
        if (n && memcmp(back, aos(in, 16, n), n * sizeof(nkw_mat4)) != 0)
            return fprintf(stderr, "parity: mat4_pack, %s, length %zu\n", isa, n) > 0;
    }
    return 0;
}

/* The functions on sets of data by the loops of an instruction set, against the same by the baseline's; every loop is run. */
static int run_data(nkwi_isa tested, const char *isa)
{
    int failed = 0;
    memset(&loop_runs, 0, sizeof loop_runs);
#define DATA_COMPARE(stem)                                                                                             \
    {                                                                                                                  \
        loop_isa = NKWI_ISA_GENERIC;                                                                                   \
        uint64_t want = data_##stem();                                                                                 \
        loop_isa = tested;                                                                                             \
        clear_exceptions();                                                                                            \
        if (data_##stem() != want)                                                                                     \
            failed += fprintf(stderr, "parity: data_" #stem ", %s: differs from generic\n", isa) > 0;                  \
        failed += report_exceptions("parity", "data_" #stem, isa,                                                      \
                                    raised_exceptions(EXCEPTIONS & ~defined_exceptions(#stem)));                       \
    }
    DATA_LIST(DATA_COMPARE)
#undef DATA_COMPARE
#define LOOP_RUNS(name, parameters, arguments, n)                                                                      \
    if (loop_runs.name == 0 && strncmp(#name, "nkwi_", 5) == 0)                                                        \
        failed += fprintf(stderr, "parity: " #name ": no data function runs it\n") > 0;
    LOOPS(LOOP_RUNS)
#undef LOOP_RUNS
    return failed;
}

static int run_isa(nkwi_isa tested, const char *isa)
{
    loop_isa = tested;
    int failed = run_packs(isa);
    for (size_t i = 0; i < ROWS; i++)
        failed += run_row(&rows[i], isa);
    printf("parity: %s: %zu functions, %d differ\n", isa, ROWS + 3, failed);
    return failed + run_data(tested, isa);
}

int main(void)
{
    return run_isas("parity", run_isa) > 0;
}
