/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/dual.h>
#include <nakawari/mat.h>
#include <nakawari/palette.h>
#include <nakawari/quat.h>
#include <nakawari/vec.h>

#include "batch/palette.h"
#include "lane/scalar.h"
#include "report.h"

nkw_result nkw_palette_from_models(const nkw_palette_source *source, nkw_palette_span out)
{
    if (out.joint_count != source->joint_count)
        return NKW_MISMATCHED;
    switch (out.format) {
    case NKW_PALETTE_MAT4:
        nkwi_palette_4x4(source, (nkw_mat4 *)out.data);
        return NKW_OK;
    case NKW_PALETTE_MAT3X4:
        nkwi_palette_3x4(source, (nkw_mat3x4 *)out.data);
        return NKW_OK;
    case NKW_PALETTE_DUAL_QUAT:
        nkwi_palette_dual(source, (nkw_dual_quat *)out.data);
        return NKW_OK;
    case NKW_PALETTE_NORMAL_MAT3:
        nkwi_palette_normals(source, 3, 0, (float *)out.data);
        return NKW_OK;
    case NKW_PALETTE_NORMAL_ROWS:
        nkwi_palette_normals(source, 4, 1, (float *)out.data);
        return NKW_OK;
    case NKW_PALETTE_NORMAL_COLUMNS:
        nkwi_palette_normals(source, 4, 0, (float *)out.data);
        return NKW_OK;
    case NKW_PALETTE_FORMAT_COUNT:
    default:
        return NKW_BAD_FORMAT;
    }
}

/* The largest distance of a column of m from that of the rotation of its dual quaternion. */
static float dropped_of(const nkw_mat4 *m)
{
    const nkw_mat3 r = nkw_mat3_from_quat(nkw_dual_quat_from_mat4(m).real);
    float most = 0.0f;
    for (size_t c = 0; c < 3; c++) {
        const nkw_vec3 moved = {m->m[4 * c], m->m[4 * c + 1], m->m[4 * c + 2]},
                       turned = {r.m[3 * c], r.m[3 * c + 1], r.m[3 * c + 2]};
        const float distance = nkw_vec3_length(nkw_vec3_sub(moved, turned));
        most = distance <= most ? most : distance; /* or NaN */
        if (!(distance == distance))
            return distance;
    }
    return most;
}

float nkw_palette_residual(const nkw_palette_source *source, size_t *bad)
{
    float most = 0.0f;
    size_t at = 0;
    for (size_t i = 0; i < source->joint_count && most == most; i++) {
        nkw_palette_source one = *source;
        nkw_mat4 m = nkw_mat4_identity();
        const size_t j = source->joints ? (size_t)source->joints[i] : i;
        const int32_t joint = 0;
        one.models = j < source->model_count ? source->models + j : NULL;
        one.model_count = j < source->model_count;
        one.joints = &joint;
        one.inverse_bind = source->inverse_bind ? source->inverse_bind + i : NULL;
        one.joint_count = 1;
        nkwi_palette_4x4(&one, &m);
        const float dropped = dropped_of(&m);
        at = dropped <= most ? at : i;
        most = dropped <= most ? most : dropped;
    }
    if (bad)
        *bad = at;
    return most;
}

nkw_result nkw_palette_to_mat4(nkw_palette_view palette, nkw_mat4 *out)
{
    const nkw_mat4 *matrices = (const nkw_mat4 *)palette.data;
    const nkw_mat3x4 *rows = (const nkw_mat3x4 *)palette.data;
    const nkw_dual_quat *dual = (const nkw_dual_quat *)palette.data;
    if ((unsigned)palette.format > NKW_PALETTE_DUAL_QUAT)
        return NKW_BAD_FORMAT;
    for (size_t i = 0; i < palette.joint_count; i++)
        out[i] = palette.format == NKW_PALETTE_MAT4     ? matrices[i]
                 : palette.format == NKW_PALETTE_MAT3X4 ? nkw_mat4_from_mat3x4(&rows[i])
                                                        : nkw_mat4_from_dual_quat(&dual[i]);
    return NKW_OK;
}

void nkw_palette_inverse_bind(const nkw_palette_source *source, nkw_mat4 *out)
{
    nkwi_palette_inverse(source, out);
}

/* Whether `count` floats are finite; of a 4x4 matrix (16) the last row, every fourth float, is not tested. */
static int are_finite(const float *m, size_t count)
{
    int finite = 1;
    for (size_t k = 0; k < count; k++)
        finite = finite && ((count == 16 && k % 4 == 3) || lane_is_finite(m[k]));
    return finite;
}

nkw_result nkw_palette_source_validate(const nkw_palette_source *source, size_t *bad)
{
    nkw_result result = source->joint_count == 0 ? NKW_EMPTY : NKW_OK;
    size_t at = 0;
    for (size_t i = 0; result == NKW_OK && i < source->joint_count; i++) {
        size_t j = source->joints ? (size_t)source->joints[i] : i;
        if (j >= source->model_count)
            result = NKW_OUT_OF_RANGE;
        else if (source->inverse_bind && !are_finite(source->inverse_bind[i].m, 16))
            result = NKW_NOT_FINITE;
        at = i;
    }
    return report(result, at, bad);
}

static int is_unit(const nkw_dual_quat *d)
{
    return lane_is_unit_length(nkw_quat_length(d->real));
}

nkw_result nkw_palette_validate(nkw_palette_view palette, size_t *bad)
{
    static const unsigned char sizes[NKW_PALETTE_FORMAT_COUNT] = {16, 12, 8, 9, 12, 12};
    size_t at = 0;
    if ((unsigned)palette.format >= NKW_PALETTE_FORMAT_COUNT)
        return report(NKW_BAD_FORMAT, 0, bad);
    size_t size = sizes[palette.format];
    nkw_result result = palette.joint_count == 0 ? NKW_EMPTY : NKW_OK;
    for (size_t i = 0; result == NKW_OK && i < palette.joint_count; i++) {
        const float *element = (const float *)palette.data + i * size;
        if (!are_finite(element, size))
            result = NKW_NOT_FINITE;
        else if (palette.format == NKW_PALETTE_DUAL_QUAT && !is_unit((const nkw_dual_quat *)palette.data + i))
            result = NKW_NOT_UNIT;
        at = i;
    }
    return report(result, at, bad);
}

/* The number of nkw_mat4 whose size in bytes size_t can hold. */
#define PALETTE_MOST (SIZE_MAX / sizeof(nkw_mat4))

/* Returns the first multiple of the alignment at or after `place`; PALETTE_MOST + 1 if it exceeds PALETTE_MOST. */
static size_t aligned(size_t place, size_t alignment)
{
    size_t past = alignment > 1 ? place % alignment : 0;
    size_t gap = past ? alignment - past : 0;
    return gap <= PALETTE_MOST - place ? place + gap : PALETTE_MOST + 1;
}

nkw_result nkw_palette_chunks_place(nkw_palette_chunk *chunks, size_t count, size_t alignment, size_t *total,
                                    size_t *bad)
{
    nkw_result result = NKW_OK;
    size_t end = 0, at = 0;
    for (size_t i = 0; result == NKW_OK && i < count; i++) {
        size_t frames = chunks[i].frame_count, joints = chunks[i].joint_count, first = aligned(end, alignment);
        if (frames == 0 || joints == 0)
            result = NKW_EMPTY;
        else if (first > PALETTE_MOST || frames > (PALETTE_MOST - first) / joints)
            result = NKW_TOO_SMALL;
        else
            chunks[i].first = first, end = first + frames * joints;
        at = i;
    }
    *total = end;
    return report(result, at, bad);
}

nkw_result nkw_palette_chunks_validate(const nkw_palette_chunk *chunks, size_t count, size_t total, size_t *bad)
{
    nkw_result result = NKW_OK;
    size_t end = 0, at = 0;
    for (size_t i = 0; result == NKW_OK && i < count; i++) {
        size_t frames = chunks[i].frame_count, joints = chunks[i].joint_count, first = chunks[i].first;
        if (frames == 0 || joints == 0)
            result = NKW_EMPTY;
        else if (first > total || frames > (total - first) / joints)
            result = NKW_OUT_OF_RANGE;
        else if (first < end)
            result = NKW_REPEATED;
        else
            end = first + frames * joints;
        at = i;
    }
    return report(result, at, bad);
}
