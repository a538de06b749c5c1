/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/mat.h>
#include <nakawari/quat.h>
#include <nakawari/scalar.h>
#include <nakawari/vec.h>

#include "lane/scalar.h"

nkw_mat4 nkw_mat4_from_translation(nkw_vec3 t)
{
    nkw_mat4 m = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, t.x, t.y, t.z, 1}};
    return m;
}

nkw_mat4 nkw_mat4_from_scale(nkw_vec3 s)
{
    nkw_mat4 m = {{s.x, 0, 0, 0, 0, s.y, 0, 0, 0, 0, s.z, 0, 0, 0, 0, 1}};
    return m;
}

nkw_mat4 nkw_mat4_from_axis_angle(nkw_vec3 axis, float angle)
{
    return nkw_mat4_from_quat(nkw_quat_from_axis_angle(axis, angle));
}

nkw_mat4 nkw_mat4_look_at(nkw_vec3 eye, nkw_vec3 target, nkw_vec3 up)
{
    nkw_mat3 r = nkw_mat3_from_quat(nkw_quat_look_rotation(nkw_vec3_sub(target, eye), up));
    nkw_mat4 camera = nkw_mat4_from_mat3(&r, eye);
    return nkw_mat4_inverse_rigid(&camera);
}

/* The depths of the nearest and of the farthest plane. */
typedef struct depths {
    double near_z, far_z;
} depths;

static depths depths_of(nkw_graphics graphics, int reversed_z)
{
    double least = graphics == NKW_GRAPHICS_GL ? -1.0 : 0.0;
    depths d = {reversed_z ? 1.0 : least, reversed_z ? least : 1.0};
    return d;
}

static int is_known(nkw_graphics graphics)
{
    return (unsigned)graphics <= NKW_GRAPHICS_VULKAN;
}

static double y_sign(nkw_graphics graphics)
{
    return graphics == NKW_GRAPHICS_VULKAN ? -1.0 : 1.0;
}

static const nkw_mat4 nothing = {{0}};

nkw_mat4 nkw_mat4_from_perspective(const nkw_perspective *camera)
{
    if (!(camera->angle > 0.0f && camera->angle < (float)LANE_PI && camera->aspect > 0.0f && camera->near_z > 0.0f &&
          camera->far_z > camera->near_z && lane_is_finite(camera->aspect) && is_known(camera->graphics)))
        return nothing;
    depths d = depths_of(camera->graphics, camera->reversed_z);
    lane_sincos half = lane_sincos64(0.5 * (double)camera->angle);
    double cotangent = half.c / half.s, n = (double)camera->near_z, r = n / (double)camera->far_z;
    nkw_mat4 m = nothing;
    m.m[0] = (float)(cotangent / (double)camera->aspect);
    m.m[5] = (float)(y_sign(camera->graphics) * cotangent);
    m.m[10] = (float)((d.near_z * r - d.far_z) / (1.0 - r));
    m.m[11] = -1.0f;
    m.m[14] = (float)(n * (d.near_z - d.far_z) / (1.0 - r));
    return m;
}

/* Row `row` of the map of a to p and b to q: x' = scale x + offset. */
static void map_row(nkw_mat4 *m, size_t row, double a, double b, double p, double q)
{
    m->m[5 * row] = (float)((q - p) / (b - a));
    m->m[12 + row] = (float)((b * p - a * q) / (b - a));
}

nkw_mat4 nkw_mat4_from_orthographic(const nkw_orthographic *camera)
{
    const float side[6] = {camera->left, camera->right, camera->bottom, camera->top, camera->near_z, camera->far_z};
    for (size_t i = 0; i < 6; i++)
        if (!lane_is_finite(side[i]) || side[i] == side[i ^ 1])
            return nothing;
    if (!is_known(camera->graphics))
        return nothing;
    depths d = depths_of(camera->graphics, camera->reversed_z);
    double y = y_sign(camera->graphics);
    nkw_mat4 m = nothing;
    map_row(&m, 0, (double)side[0], (double)side[1], -1.0, 1.0);
    map_row(&m, 1, (double)side[2], (double)side[3], -y, y);
    map_row(&m, 2, -(double)side[4], -(double)side[5], d.near_z, d.far_z);
    m.m[15] = 1.0f;
    return m;
}

int nkw_mat4_equal_within(const nkw_mat4 *a, const nkw_mat4 *b, float tolerance)
{
    int equal = 1;
    for (size_t i = 0; i < 16; i++)
        equal &= nkw_equal_within(a->m[i], b->m[i], tolerance);
    return equal;
}
