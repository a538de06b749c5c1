/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/dual.h>
#include <nakawari/mat.h>
#include <nakawari/palette.h>
#include <nakawari/quat.h>

#include "batch/palette.h"
#include "lane/scalar.h"
#include "report.h"

void nkw_palette_from_models(const nkw_mat4 *models, size_t model_count, const int32_t *joints,
                             const nkw_mat4 *inverse_bind, const nkw_mat4 *global_inverse, size_t count, nkw_mat4 *out)
{
    nkwi_palette_4x4(models, model_count, joints, inverse_bind, global_inverse, out, count);
}

void nkw_palette_3x4_from_models(const nkw_mat4 *models, size_t model_count, const int32_t *joints,
                                 const nkw_mat4 *inverse_bind, const nkw_mat4 *global_inverse, size_t count,
                                 nkw_mat3x4 *out)
{
    nkwi_palette_3x4(models, model_count, joints, inverse_bind, global_inverse, out, count);
}

void nkw_palette_dual_from_models(const nkw_mat4 *models, size_t model_count, const int32_t *joints,
                                  const nkw_mat4 *inverse_bind, const nkw_mat4 *global_inverse, size_t count,
                                  nkw_dual_quat *out)
{
    nkwi_palette_dual(models, model_count, joints, inverse_bind, global_inverse, out, count);
}

void nkw_palette_from_3x4(const nkw_mat3x4 *palette, size_t count, nkw_mat4 *out)
{
    for (size_t i = 0; i < count; i++)
        out[i] = nkw_mat4_from_mat3x4(&palette[i]);
}

void nkw_palette_from_dual(const nkw_dual_quat *palette, size_t count, nkw_mat4 *out)
{
    for (size_t i = 0; i < count; i++)
        out[i] = nkw_mat4_from_dual_quat(&palette[i]);
}

void nkw_inverse_bind_from_models(const nkw_mat4 *models, size_t model_count, const int32_t *joints,
                                  const nkw_mat4 *global_inverse, size_t count, nkw_mat4 *out)
{
    nkwi_palette_inverse(models, model_count, joints, global_inverse, out, count);
}

void nkw_palette_normals(const nkw_mat4 *palette, size_t count, nkw_mat3 *out)
{
    nkwi_palette_normals(palette, 3, 0, (float *)out, count);
}

void nkw_palette_normals_rows(const nkw_mat4 *palette, size_t count, nkw_mat3x4 *out)
{
    nkwi_palette_normals(palette, 4, 1, (float *)out, count);
}

void nkw_palette_normals_columns(const nkw_mat4 *palette, size_t count, float *out)
{
    nkwi_palette_normals(palette, 4, 0, out, count);
}

static int is_finite(const nkw_mat4 *m)
{
    int finite = 1;
    for (size_t k = 0; k < 16; k++)
        finite = finite && (k % 4 == 3 || lane_is_finite(m->m[k]));
    return finite;
}

nkw_result nkw_palette_validate(size_t model_count, const int32_t *joints, const nkw_mat4 *inverse_bind, size_t count,
                                size_t *bad_joint)
{
    nkw_result result = count == 0 ? NKW_EMPTY : NKW_OK;
    size_t bad = 0;
    for (size_t i = 0; result == NKW_OK && i < count; i++) {
        size_t j = joints ? (size_t)joints[i] : i;
        if (j >= model_count)
            result = NKW_OUT_OF_RANGE;
        else if (inverse_bind && !is_finite(&inverse_bind[i]))
            result = NKW_NOT_FINITE;
        bad = i;
    }
    return report(result, bad, bad_joint);
}

static nkw_result check_dual(const nkw_dual_quat *d)
{
    if (!nkw_quat_is_finite(d->real) || !nkw_quat_is_finite(d->dual))
        return NKW_NOT_FINITE;
    return lane_is_unit_length(nkw_quat_length(d->real)) ? NKW_OK : NKW_NOT_UNIT;
}

nkw_result nkw_palette_dual_validate(const nkw_dual_quat *palette, size_t count, size_t *bad_joint)
{
    nkw_result result = count == 0 ? NKW_EMPTY : NKW_OK;
    size_t bad = 0;
    for (size_t i = 0; result == NKW_OK && i < count; i++) {
        result = check_dual(&palette[i]);
        bad = i;
    }
    return report(result, bad, bad_joint);
}

/* Matrices in the largest buffer. */
#define MOST (SIZE_MAX / sizeof(nkw_mat4))

/* The first multiple of the alignment from `place` on; MOST + 1 where there is none. */
static size_t aligned(size_t place, size_t alignment)
{
    size_t past = alignment > 1 ? place % alignment : 0;
    size_t gap = past ? alignment - past : 0;
    return gap <= MOST - place ? place + gap : MOST + 1;
}

nkw_result nkw_palette_chunks_place(nkw_palette_chunk *chunks, size_t count, size_t alignment, size_t *total,
                                    size_t *bad_chunk)
{
    nkw_result result = NKW_OK;
    size_t end = 0, bad = 0;
    for (size_t i = 0; result == NKW_OK && i < count; i++) {
        size_t frames = chunks[i].frames, joints = chunks[i].joints, first = aligned(end, alignment);
        if (frames == 0 || joints == 0)
            result = NKW_EMPTY;
        else if (first > MOST || frames > (MOST - first) / joints)
            result = NKW_TOO_SMALL;
        else
            chunks[i].first = first, end = first + frames * joints;
        bad = i;
    }
    *total = end;
    return report(result, bad, bad_chunk);
}

nkw_result nkw_palette_chunks_validate(const nkw_palette_chunk *chunks, size_t count, size_t total, size_t *bad_chunk)
{
    nkw_result result = NKW_OK;
    size_t end = 0, bad = 0;
    for (size_t i = 0; result == NKW_OK && i < count; i++) {
        size_t frames = chunks[i].frames, joints = chunks[i].joints, first = chunks[i].first;
        if (frames == 0 || joints == 0)
            result = NKW_EMPTY;
        else if (first > total || frames > (total - first) / joints)
            result = NKW_OUT_OF_RANGE;
        else if (first < end)
            result = NKW_REPEATED;
        else
            end = first + frames * joints;
        bad = i;
    }
    return report(result, bad, bad_chunk);
}

size_t nkw_palette_chunk_at(const nkw_palette_chunk *chunk, size_t frame, size_t joint)
{
    if (chunk->frames == 0 || chunk->joints == 0)
        return chunk->first;
    size_t f = frame < chunk->frames ? frame : chunk->frames - 1;
    size_t j = joint < chunk->joints ? joint : chunk->joints - 1;
    return chunk->first + f * chunk->joints + j;
}
