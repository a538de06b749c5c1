/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/axes.h>
#include <nakawari/mat.h>
#include <nakawari/vec.h>

#include "lane/euler.h"

/* 0, 1, 2 for an axis X, Y, Z of either sign. */
static size_t place_of(nkw_axis axis)
{
    if (axis == NKW_AXIS_Y || axis == NKW_AXIS_NEGATIVE_Y)
        return 1;
    return axis == NKW_AXIS_Z || axis == NKW_AXIS_NEGATIVE_Z ? 2 : 0;
}

static int is_negative(nkw_axis axis)
{
    return axis == NKW_AXIS_NEGATIVE_X || axis == NKW_AXIS_NEGATIVE_Y || axis == NKW_AXIS_NEGATIVE_Z;
}

static nkw_axis axis_at(size_t place, int negative)
{
    int number = (int)place + 1;
    return (nkw_axis)(negative ? -number : number);
}

static int are_different(nkw_axis a, nkw_axis b, nkw_axis c)
{
    return (1u << place_of(a) | 1u << place_of(b) | 1u << place_of(c)) == 7u;
}

static float flip_if(int negative, float x)
{
    return negative ? -x : x;
}

static float pick(nkw_axis axis, nkw_vec3 v)
{
    const float c[3] = {v.x, v.y, v.z};
    return flip_if(is_negative(axis), c[place_of(axis)]);
}

/* The axis of the input that a map names for an axis of the result. */
static nkw_axis source_of(nkw_axes_map map, size_t place)
{
    const nkw_axis axes[3] = {map.x, map.y, map.z};
    return axes[place];
}

int nkw_axes_map_is_valid(nkw_axes_map map)
{
    return are_different(map.x, map.y, map.z);
}

nkw_axes_map nkw_axes_map_from_axes(nkw_axes from, nkw_axes to)
{
    const nkw_axis sources[3] = {from.right, from.up, from.forward}, targets[3] = {to.right, to.up, to.forward};
    nkw_axis named[3] = {(nkw_axis)0, (nkw_axis)0, (nkw_axis)0};
    if (are_different(from.right, from.up, from.forward) && are_different(to.right, to.up, to.forward))
        for (size_t k = 0; k < 3; k++)
            named[place_of(targets[k])] =
                axis_at(place_of(sources[k]), is_negative(sources[k]) != is_negative(targets[k]));
    nkw_axes_map map = {named[0], named[1], named[2]};
    return map;
}

nkw_axes_map nkw_axes_map_inverse(nkw_axes_map map)
{
    nkw_axis named[3] = {NKW_AXIS_X, NKW_AXIS_Y, NKW_AXIS_Z};
    if (nkw_axes_map_is_valid(map))
        for (size_t k = 0; k < 3; k++)
            named[place_of(source_of(map, k))] = axis_at(k, is_negative(source_of(map, k)));
    nkw_axes_map inverse = {named[0], named[1], named[2]};
    return inverse;
}

/* The sign of the permutation, by the difference of neighbouring places modulo 3, and those of the axes. */
int nkw_axes_map_is_mirror(nkw_axes_map map)
{
    int odd = (place_of(map.x) + 1) % 3 != place_of(map.y);
    int signs = is_negative(map.x) + is_negative(map.y) + is_negative(map.z);
    return nkw_axes_map_is_valid(map) && (odd + signs) % 2 == 1;
}

nkw_vec3 nkw_axes_convert_vec3(nkw_axes_map map, nkw_vec3 v)
{
    nkw_vec3 r = {pick(map.x, v), pick(map.y, v), pick(map.z, v)};
    return r;
}

static nkw_vec3 convert_angular(nkw_axes_map map, nkw_vec3 v)
{
    nkw_vec3 r = nkw_axes_convert_vec3(map, v);
    return nkw_axes_map_is_mirror(map) ? nkw_vec3_negate(r) : r;
}

static nkw_vec3 convert_scale(nkw_axes_map map, nkw_vec3 scale)
{
    const float c[3] = {scale.x, scale.y, scale.z};
    nkw_vec3 r = {c[place_of(map.x)], c[place_of(map.y)], c[place_of(map.z)]};
    return r;
}

nkw_quat nkw_axes_convert_quat(nkw_axes_map map, nkw_quat q)
{
    nkw_vec3 v = {q.x, q.y, q.z};
    v = convert_angular(map, v);
    nkw_quat r = {v.x, v.y, v.z, q.w};
    return r;
}

nkw_trs nkw_axes_convert_trs(nkw_axes_map map, const nkw_trs *trs)
{
    nkw_trs r = {
        nkw_axes_convert_vec3(map, trs->translation),
        nkw_axes_convert_quat(map, trs->rotation),
        convert_scale(map, trs->scale),
    };
    return r;
}

/* The element of P M P^T in a row and a column; row and column 3 stay in their places. */
static float element(nkw_axes_map map, const nkw_mat4 *m, size_t row, size_t column)
{
    size_t r = row < 3 ? place_of(source_of(map, row)) : row,
           c = column < 3 ? place_of(source_of(map, column)) : column;
    int negative_row = row < 3 && is_negative(source_of(map, row));
    int negative_column = column < 3 && is_negative(source_of(map, column));
    return flip_if(negative_row != negative_column, m->m[c * 4 + r]);
}

nkw_mat4 nkw_axes_convert_mat4(nkw_axes_map map, const nkw_mat4 *m)
{
    nkw_mat4 out;
    for (size_t i = 0; i < 16; i++)
        out.m[i] = element(map, m, i % 4, i / 4);
    return out;
}

/* The places of the axes of an order, from left to right; the third is the remaining one. */
static const unsigned char first_axis[6] = {0, 0, 1, 1, 2, 2}, second_axis[6] = {1, 2, 0, 2, 0, 1};

static nkw_euler_order convert_order(nkw_axes_map map, nkw_euler_order order)
{
    nkw_axes_map inverse = nkw_axes_map_inverse(map);
    size_t known = (int)order > 0 && (int)order < 12 ? (size_t)order % 6 : 0;
    size_t proper = lane_euler_is_proper(order) ? 6 : 0;
    size_t first = place_of(source_of(inverse, first_axis[known]));
    size_t second = place_of(source_of(inverse, second_axis[known]));
    for (size_t k = 0; k < 6; k++)
        if (first_axis[k] == first && second_axis[k] == second)
            return (nkw_euler_order)(k + proper);
    return NKW_EULER_XYZ;
}

/* 1, or -1 where the conversion changes the sign of rotations about an axis. */
static float sign_about(nkw_axes_map map, size_t axis)
{
    nkw_vec3 unit = {axis == 0 ? 1.0f : 0.0f, axis == 1 ? 1.0f : 0.0f, axis == 2 ? 1.0f : 0.0f};
    nkw_vec3 turned = convert_angular(map, unit);
    return turned.x + turned.y + turned.z < 0.0f ? -1.0f : 1.0f;
}

nkw_vec3 nkw_axes_convert_euler(nkw_axes_map map, nkw_vec3 angles, nkw_euler_order *order)
{
    nkw_euler_order from = *order;
    *order = convert_order(map, from);
    if (!lane_euler_is_proper(from))
        return convert_angular(map, angles);
    float outer = sign_about(map, first_axis[from - 6]), middle = sign_about(map, second_axis[from - 6]);
    nkw_vec3 r = {outer * angles.x, middle * angles.y, outer * angles.z};
    return r;
}

void nkw_axes_convert_values(nkw_axes_map map, const float *values, size_t count, nkw_axes_kind kind, float *out)
{
    const size_t width = NKW_AXES_WIDTH(kind);
    for (size_t i = 0; i < count; i++, values += width, out += width) {
        nkw_vec3 v = {values[0], values[1], values[2]};
        nkw_vec3 r = kind == NKW_AXES_SCALE                              ? convert_scale(map, v)
                     : kind == NKW_AXES_ANGULAR || kind == NKW_AXES_QUAT ? convert_angular(map, v)
                                                                         : nkw_axes_convert_vec3(map, v);
        if (width == 4)
            out[3] = values[3];
        out[0] = r.x;
        out[1] = r.y;
        out[2] = r.z;
    }
}
