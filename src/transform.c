/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/transform.h>

#include "lane/mat.h"

/* Enough for the eigenvector of sheared blocks too; where there is no shear, two would do. */
#define NEAREST_ROTATION_STEPS 24

/* The unit column, or a direction at right angles to the two others where it has no length. */
static lane_wvec3 unit_or_cross(lane_wvec3 column, double length, lane_wvec3 next, lane_wvec3 after)
{
    lane_wvec3 across = lane_wvec3_normalize(lane_wvec3_cross(next, after));
    return lane_wvec3_select(length == 0.0, across, lane_wvec3_normalize(column));
}

/* The unit directions of the columns x, y, z of lengths s, with those of length zero filled in. */
static lane_wmat3 directions(const lane_wmat3 *m, const double s[3])
{
    lane_wvec3 x = lane_wmat3_column(m, 0), y = lane_wmat3_column(m, 1), z = lane_wmat3_column(m, 2);
    lane_wvec3 axis_x = {1.0, 0.0, 0.0}, axis_y = {0.0, 1.0, 0.0}, axis_z = {0.0, 0.0, 1.0};
    if (s[0] == 0.0 && s[1] == 0.0 && s[2] == 0.0)
        return lane_wmat3_from_columns(axis_x, axis_y, axis_z);
    /* With one column left, the second is any at right angles to it; with two, the third is their product. */
    if (s[1] == 0.0 && s[2] == 0.0)
        y = lane_wvec3_perpendicular(x);
    else if (s[2] == 0.0 && s[0] == 0.0)
        z = lane_wvec3_perpendicular(y);
    else if (s[0] == 0.0 && s[1] == 0.0)
        x = lane_wvec3_perpendicular(z);
    double lx = lane_wvec3_length(x), ly = lane_wvec3_length(y), lz = lane_wvec3_length(z);
    return lane_wmat3_from_columns(unit_or_cross(x, lx, y, z), unit_or_cross(y, ly, z, x),
                                   unit_or_cross(z, lz, x, y));
}

nkw_trs nkw_trs_from_mat4(const nkw_mat4 *m)
{
    lane_wmat3 w = lane_wmat3_from_mat4(m);
    double s[3];
    for (size_t c = 0; c < 3; c++)
        s[c] = lane_wvec3_length(lane_wmat3_column(&w, c));
    lane_wmat3 unit = directions(&w, s);
    lane_wmat3 cofactors = lane_wmat3_cofactors(&unit);
    double side = lane_wmat3_determinant(&unit, &cofactors) < 0.0 ? -1.0 : 1.0;
    for (size_t i = 0; i < 3; i++)
        unit.m[i] *= side;
    nkw_trs r = {
        {m->m[12], m->m[13], m->m[14]},
        lane_quat_from_wide(lane_wquat_from_wmat3(&unit, NEAREST_ROTATION_STEPS)),
        {(float)(side * s[0]), (float)s[1], (float)s[2]},
    };
    return r;
}

float nkw_trs_residual(const nkw_trs *trs, const nkw_mat4 *m)
{
    lane_wmat3 w = lane_wmat3_from_mat4(m);
    lane_wmat3 r = lane_wmat3_from_wquat(lane_wquat_normalize(lane_wquat_from(trs->rotation)));
    const double s[3] = {trs->scale.x, trs->scale.y, trs->scale.z};
    double longest = 0.0, nothing = 0.0; /* or NaN */
    lane_wmat3 difference;
    for (size_t c = 0; c < 3; c++) {
        double length = lane_wvec3_length(lane_wmat3_column(&w, c));
        longest = length > longest ? length : longest;
        for (size_t i = 0; i < 3; i++) {
            difference.m[c * 3 + i] = r.m[c * 3 + i] * s[c] - w.m[c * 3 + i];
            nothing += 0.0 * difference.m[c * 3 + i];
        }
    }
    return (float)((longest == 0.0 ? 0.0 : lane_wmat3_largest(&difference) / longest) + nothing);
}
