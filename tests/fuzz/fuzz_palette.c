/* SPDX-License-Identifier: MIT */
#include "fuzz.h"
#include "../support/views.h"

#include <string.h>

enum { MODELS = 60, JOINTS = 40, CHUNKS = 12 };

typedef struct inputs {
    const nkw_mat4 *models, *inverse_bind, *global_inverse;
    const int32_t *joints;
    size_t model_count, count;
} inputs;

static inputs draw(fuzz *f, int wild)
{
    inputs i = {NULL, NULL, NULL, NULL, fuzz_upto(f, MODELS), fuzz_upto(f, JOINTS)};
    i.models = fuzz_matrices(f, i.model_count, wild);
    i.joints = fuzz_byte(f) % 4 ? fuzz_links(f, i.count, i.model_count, 1) : NULL;
    i.inverse_bind = fuzz_byte(f) % 2 ? fuzz_matrices(f, i.count, wild) : NULL;
    i.global_inverse = fuzz_byte(f) % 2 ? fuzz_matrices(f, 1, wild) : NULL;
    return i;
}

static void forms(fuzz *f, const inputs *i, int wild)
{
    nkw_mat4 *four = fuzz_block(f, i->count * sizeof *four), *back = fuzz_block(f, i->count * sizeof *back);
    nkw_mat3x4 *rows = fuzz_block(f, i->count * sizeof *rows);
    nkw_dual_quat *dual = fuzz_block(f, i->count * sizeof *dual);
    palette_from_models(i->models, i->model_count, i->joints, i->inverse_bind, i->global_inverse, i->count, four);
    palette_3x4_from_models(i->models, i->model_count, i->joints, i->inverse_bind, i->global_inverse, i->count, rows);
    palette_dual_from_models(i->models, i->model_count, i->joints, i->inverse_bind, i->global_inverse, i->count, dual);
    nkw_palette_to_mat4(palette_view(NKW_PALETTE_MAT3X4, rows, i->count), back);
    FUZZ_CHECK(fuzz_same((float *)four, (float *)back, 16 * i->count) && fuzz_affine(four, i->count));
    FUZZ_CHECK(wild || (fuzz_finite((float *)four, 16 * i->count) && fuzz_finite((float *)dual, 8 * i->count)));
    size_t bad;
    nkw_result sound = nkw_palette_validate(palette_view(NKW_PALETTE_DUAL_QUAT, dual, i->count), &bad);
    FUZZ_CHECK(bad < i->count || bad == 0);
    FUZZ_CHECK(sound != NKW_OK || fuzz_finite((float *)dual, 8 * i->count));
    nkw_palette_to_mat4(palette_view(NKW_PALETTE_DUAL_QUAT, dual, i->count), back);
    FUZZ_CHECK(fuzz_affine(back, i->count));
    nkw_mat3 *normals = fuzz_block(f, i->count * sizeof *normals);
    palette_normals(four, i->count, normals);
    palette_normals_rows(four, i->count, rows);
    float *columns = fuzz_room(f, 12 * i->count);
    palette_normals_columns(four, i->count, columns);
    for (size_t k = 0; k < 9 * i->count; k++) {
        size_t m = k / 9, c = k % 9 / 3, r = k % 3;
        FUZZ_CHECK(fuzz_same(&normals[m].m[k % 9], &rows[m].m[4 * r + c], 1));
        FUZZ_CHECK(fuzz_same(&normals[m].m[k % 9], columns + 12 * m + 4 * c + r, 1));
    }
}

static int is_zero(const nkw_mat4 *m)
{
    int zero = 1;
    for (size_t k = 0; k < 16; k++)
        zero &= m->m[k] == 0.0f;
    return zero;
}

static void in_place(fuzz *f, const inputs *i)
{
    size_t n = i->count < i->model_count ? i->count : i->model_count, bad;
    nkw_mat4 *out = fuzz_block(f, i->count * sizeof *out), *over = fuzz_block(f, i->model_count * sizeof *over);
    nkw_result result = palette_source_validate(i->model_count, i->joints, i->inverse_bind, i->count, &bad);
    FUZZ_CHECK(bad < i->count || bad == 0);
    FUZZ_CHECK((result == NKW_EMPTY) == (i->count == 0));
    const nkw_palette_source source = {i->models, i->model_count, i->joints, i->inverse_bind, i->global_inverse, i->count};
    FUZZ_CHECK(!(nkw_palette_residual(&source, &bad) < 0.0f) && (bad < i->count || bad == 0));
    memcpy(over, i->models, i->model_count * sizeof *over);
    palette_from_models(i->models, i->model_count, NULL, i->inverse_bind, i->global_inverse, n, out);
    palette_from_models(over, i->model_count, NULL, i->inverse_bind, i->global_inverse, n, over);
    FUZZ_CHECK(fuzz_same((float *)out, (float *)over, 16 * n));
    inverse_bind_from_models(i->models, i->model_count, i->joints, i->global_inverse, i->count, out);
    for (size_t k = 0; k < i->count; k++)
        FUZZ_CHECK(fuzz_affine(&out[k], 1) || is_zero(&out[k]));
}

/* Chunks do not overlap, in the order given, and the buffer's bytes are a size_t. */
static void chunks(fuzz *f)
{
    size_t count = fuzz_upto(f, CHUNKS), total, bad, end = 0, alignment = fuzz_huge(f);
    nkw_palette_chunk *c = fuzz_block(f, count * sizeof *c);
    for (size_t i = 0; i < count; i++) {
        nkw_palette_chunk drawn = {fuzz_huge(f), fuzz_byte(f) % 2 ? fuzz_byte(f) : fuzz_huge(f), 0};
        c[i] = drawn;
    }
    nkw_result result = nkw_palette_chunks_place(c, count, alignment, &total, &bad);
    FUZZ_CHECK(bad < count || bad == 0);
    for (size_t i = 0; i < (result == NKW_OK ? count : bad); i++) {
        FUZZ_CHECK(c[i].first >= end && c[i].first % (alignment ? alignment : 1) == 0);
        end = c[i].first + c[i].frame_count * c[i].joint_count;
        FUZZ_CHECK(end > c[i].first && end <= SIZE_MAX / sizeof(nkw_mat4));
    }
    FUZZ_CHECK(total == end);
    FUZZ_CHECK(result != NKW_OK || nkw_palette_chunks_validate(c, count, total, NULL) == NKW_OK);
    for (size_t i = 0; i < count; i++)
        c[i].first = fuzz_huge(f);
    result = nkw_palette_chunks_validate(c, count, total, &bad);
    FUZZ_CHECK(bad < count || bad == 0);
    for (size_t i = 0; i < count && result == NKW_OK; i++)
        FUZZ_CHECK(c[i].first + (c[i].frame_count - 1) * c[i].joint_count + c[i].joint_count - 1 < total);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz f = fuzz_begin(data, size);
    int wild = fuzz_byte(&f) % 2;
    inputs i = draw(&f, wild);
    forms(&f, &i, wild);
    in_place(&f, &i);
    chunks(&f);
    return fuzz_end(&f);
}
