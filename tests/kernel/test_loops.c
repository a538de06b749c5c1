/* SPDX-License-Identifier: MIT */
/* Each loop over arrays against its scalar function, line by line of parity/rows.h, bit for bit. */
#include "parity/access.h"
#include "support/expect.h"
#include "support/random.h"

#define GUARD 16
#define WORD  -0x1.5a5a5ap119f /* a number that no function returns */

static float inputs[ARRAYS][LONGEST], outputs[ARRAYS][LONGEST + GUARD];

/* `plain`: t inside 0..1, no ends, and nothing so large that a loop leaves its usual path; else a few of each. */
static size_t draw_letter(random_source *r, char letter, int plain, float values[16])
{
    static const float odd[8] = {0, 1, 0.5f, -0.0f, 1.5f, -2, 1e7f, -3e30f};
    uint64_t kind = random_bits(r) % 64;
    size_t count = letter == 'q' ? 4 : letter == 'v' ? 3 : letter == 'm' ? 9 : letter == 'M' ? 16 : 1;
    for (size_t j = 0; j < count; j++)
        values[j] = letter == 't' ? random_between(r, 0.01f, 0.49f) : random_scaled(r, -4, 2);
    if (letter == 't' && !plain)
        values[0] = kind < 8 ? odd[kind] : random_unit(r);
    else if (kind < 8 && !plain)
        values[kind % count] = odd[kind];
    else if (letter == 'q')
        put_quat(values, random_rotation(r));
    else if (letter == 'm')
        put_mat3(values, nkw_mat3_from_quat(random_rotation(r)));
    return count;
}

static void draw(random_source *r, const row *w, int plain, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        size_t k = 0;
        for (const char *l = w->inputs; *l; l++) {
            float values[16];
            size_t count = draw_letter(r, *l, plain, values);
            for (size_t j = 0; j < count; j++)
                inputs[k + j][i] = values[j];
            k += count;
        }
    }
}

static void expect_singles(const row *w, size_t n)
{
    for (size_t i = 0; i < n + GUARD; i++) {
        float x[ARRAYS], want[16];
        for (size_t k = 0; k < ARRAYS; k++)
            x[k] = inputs[k][i < n ? i : 0];
        for (size_t k = 0; k < 16; k++)
            want[k] = WORD;
        if (i < n)
            w->single(x, want);
        for (size_t k = 0; k < w->outputs; k++) {
            int same =
                bits_of(outputs[k][i]) == bits_of(want[k]) || (outputs[k][i] != outputs[k][i] && want[k] != want[k]);
            if (!same)
                print_error("nkw_%s_n, length %zu, output %zu, element %zu\n", w->name, n, k, i);
            expect_bits(outputs[k][i], want[k]);
        }
    }
}

static void loops_have_the_bits_of_single_calls_at_every_length(void **state)
{
    (void)state;
    static const size_t longer[] = {48, 63, 64, 65, 79, 127, 128, 129, 143, 255, 256, 257, 271, 527};
    const float *in[ARRAYS];
    float *out[ARRAYS];
    for (size_t k = 0; k < ARRAYS; k++)
        in[k] = inputs[k], out[k] = outputs[k];
    for (size_t w = 0; w < ROWS; w++) {
        random_source r = random_from(w);
        for (size_t i = 0; i < 36 + sizeof longer / sizeof longer[0]; i++) {
            size_t n = i < 36 ? i : longer[i - 36];
            draw(&r, &rows[w], i % 2 == 0, n);
            for (size_t k = 0; k < rows[w].outputs; k++)
                for (size_t e = 0; e < n + GUARD; e++)
                    outputs[k][e] = WORD;
            rows[w].loop(in, out, n);
            expect_singles(&rows[w], n);
        }
    }
}

/* Back to structs what was taken from them. */
static void packing_undoes_unpacking(void **state)
{
    (void)state;
    enum { N = 37 };
    nkw_vec3 v[N], v_back[N + 1];
    nkw_quat q[N], q_back[N + 1];
    nkw_mat4 m[N], m_back[N + 1];
    random_source r = random_from(1);
    float *out[16];
    const float *in[16];
    for (size_t k = 0; k < 16; k++)
        in[k] = out[k] = outputs[k];
    for (size_t i = 0; i < N; i++) {
        v[i] = random_vec3(&r, -1, 1);
        q[i] = random_rotation(&r);
        for (size_t k = 0; k < 16; k++)
            m[i].m[k] = random_unit(&r);
    }
    for (size_t n = 0; n <= N; n++) {
        memset(v_back, 0x5a, sizeof v_back);
        memset(q_back, 0x5a, sizeof q_back);
        memset(m_back, 0x5a, sizeof m_back);
        nkw_vec3_unpack_n(v, VS(0), n);
        nkw_vec3_pack_n(V(0), v_back, n);
        nkw_quat_unpack_n(q, QS(0), n);
        nkw_quat_pack_n(Q(0), q_back, n);
        nkw_mat4_unpack_n(m, MS4(0), n);
        nkw_mat4_pack_n(M4(0), m_back, n);
        expect_floats_bits(&v_back[0].x, &v[0].x, 3 * n);
        expect_floats_bits(&q_back[0].x, &q[0].x, 4 * n);
        expect_floats_bits(m_back[0].m, m[0].m, 16 * n);
        assert_int_equal(bits_of(v_back[n].x), 0x5a5a5a5a);
        assert_int_equal(bits_of(q_back[n].x), 0x5a5a5a5a);
        assert_int_equal(bits_of(m_back[n].m[0]), 0x5a5a5a5a);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(loops_have_the_bits_of_single_calls_at_every_length),
        cmocka_unit_test(packing_undoes_unpacking),
    };
    return cmocka_run_group_tests_name("loops", tests, NULL, NULL);
}
