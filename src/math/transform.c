/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/transform.h>

#include "lane/mat.h"
#include "pack/form.h"

/* Enough for the eigenvector of sheared blocks too; where there is no shear, two would do. */
#define TRS_ROTATION_STEPS 24

#if !NKW_F32X4
nkw_mat4 nkw_mat4_from_trs(const nkw_trs *trs)
{
    return lane_mat4_from_trs(trs);
}
#endif

/* The unit column, or a direction at right angles to the two others where it has no length. */
static lane_f64_vec3 unit_or_cross(lane_f64_vec3 column, double length, lane_f64_vec3 next, lane_f64_vec3 after)
{
    lane_f64_vec3 across = lane_f64_vec3_normalize(lane_f64_vec3_cross(next, after));
    return lane_f64_vec3_select(length == 0.0, across, lane_f64_vec3_normalize(column));
}

/* The unit directions of the columns x, y, z of lengths s, with those of length zero filled in. */
static lane_f64_mat3 directions(const lane_f64_mat3 *m, const double s[3])
{
    lane_f64_vec3 x = lane_f64_mat3_column(m, 0), y = lane_f64_mat3_column(m, 1), z = lane_f64_mat3_column(m, 2);
    lane_f64_vec3 axis_x = {1.0, 0.0, 0.0}, axis_y = {0.0, 1.0, 0.0}, axis_z = {0.0, 0.0, 1.0};
    if (s[0] == 0.0 && s[1] == 0.0 && s[2] == 0.0)
        return lane_f64_mat3_from_columns(axis_x, axis_y, axis_z);
    /* With one column left, the second is any at right angles to it; with two, the third is their product. */
    if (s[1] == 0.0 && s[2] == 0.0)
        y = lane_f64_vec3_perpendicular(x);
    else if (s[2] == 0.0 && s[0] == 0.0)
        z = lane_f64_vec3_perpendicular(y);
    else if (s[0] == 0.0 && s[1] == 0.0)
        x = lane_f64_vec3_perpendicular(z);
    double lx = lane_f64_vec3_length(x), ly = lane_f64_vec3_length(y), lz = lane_f64_vec3_length(z);
    return lane_f64_mat3_from_columns(unit_or_cross(x, lx, y, z), unit_or_cross(y, ly, z, x),
                                      unit_or_cross(z, lz, x, y));
}

LANE_SELDOM static nkw_trs from_any_affine(const nkw_mat4 *m)
{
    lane_f64_mat3 w = lane_f64_mat3_from_mat4(m);
    double s[3];
    for (size_t c = 0; c < 3; c++)
        s[c] = lane_f64_vec3_length(lane_f64_mat3_column(&w, c));
    lane_f64_mat3 unit = directions(&w, s);
    lane_f64_mat3 cofactors = lane_f64_mat3_cofactors(&unit);
    double side = lane_f64_mat3_determinant(&unit, &cofactors) < -LANE_LEAST_VOLUME ? -1.0 : 1.0;
    for (size_t i = 0; i < 3; i++)
        unit.m[i] *= side;
    nkw_trs r = {
        {m->m[12], m->m[13], m->m[14]},
        lane_quat_from_f64(lane_f64_quat_from_f64_mat3(&unit, TRS_ROTATION_STEPS)),
        {(float)(side * s[0]), (float)s[1], (float)s[2]},
    };
    return r;
}

LANE_FLAT nkw_trs nkw_trs_from_mat4(const nkw_mat4 *m)
{
    nkw_trs r;
#if NKW_F32X4
    int is_near = f32x4_trs_from_mat4(m->m, &r.translation.x);
#else
    nkw_mat3 block = nkw_mat3_from_mat4(m);
    lane_scaled_rotation turn =
        lane_scaled_rotation_of(nkw_mat3_column(&block, 0), nkw_mat3_column(&block, 1), nkw_mat3_column(&block, 2));
    int is_near = turn.is_near;
    r.translation = nkw_mat4_translation(m);
    r.rotation = turn.rotation;
    r.scale = turn.scale;
#endif
    return is_near ? r : from_any_affine(m);
}

float nkw_trs_residual(const nkw_trs *trs, const nkw_mat4 *m)
{
    lane_f64_mat3 w = lane_f64_mat3_from_mat4(m);
    lane_f64_mat3 r = lane_f64_mat3_from_f64_quat(lane_f64_quat_unit_from(trs->rotation));
    const double s[3] = {trs->scale.x, trs->scale.y, trs->scale.z};
    double longest = 0.0, nothing = 0.0; /* or NaN */
    lane_f64_mat3 difference;
    for (size_t c = 0; c < 3; c++) {
        double length = lane_f64_vec3_length(lane_f64_mat3_column(&w, c));
        longest = length > longest ? length : longest;
        for (size_t i = 0; i < 3; i++) {
            difference.m[c * 3 + i] = r.m[c * 3 + i] * s[c] - w.m[c * 3 + i];
            nothing += 0.0 * difference.m[c * 3 + i];
        }
    }
    return (float)((longest == 0.0 ? 0.0 : lane_f64_mat3_largest(&difference) / longest) + nothing);
}
