/* SPDX-License-Identifier: MIT */
#include "scene.h"

#include <stdio.h>

#include <nakawari/euler.h>
#include <nakawari/mat.h>
#include <nakawari/quat.h>
#include <nakawari/scalar.h>

/* Position, and the turns of Ry(yaw) Rx(pitch) Rz(roll) in degrees: whole numbers, so exact until they are used. */
typedef struct placement {
    nkw_vec3 position;
    float yaw, pitch, roll;
} placement;

/* What the exercise sets up; the camera turns by yaw and pitch, degrees, at a distance from (-0.5, 0, 0). */
typedef struct setup {
    placement keys[SCENE_KEYS_MAX];
    size_t count;
    float yaw, pitch, distance;
} setup;

static const setup setups[] = {
    {{
         {{-1.0f, 0.5f, -1.5f}, 108.0f, 0.0f, 0.0f},
         {{0.0f, 1.0f, 0.0f}, 216.0f, 60.0f, 45.0f},
         {{-2.0f, 0.5f, 1.0f}, 180.0f, -30.0f, 0.0f},
         {{0.0f, 0.4f, 1.5f}, 216.0f, 0.0f, 0.0f},
         {{1.0f, 0.35f, 1.75f}, -72.0f, 15.0f, 0.0f},
         {{1.5f, 0.6f, 0.0f}, 0.0f, 0.0f, 0.0f},
         {{1.0f, 1.0f, -1.0f}, 60.0f, 0.0f, 0.0f},
     },
     7, 15.0f, -20.0f, 6.0f},
    {{
         {{-1.0f, 0.5f, 0.0f}, 108.0f, 0.0f, 0.0f},
         {{1.0f, 0.5f, 0.0f}, 216.0f, 60.0f, 45.0f},
     },
     2, 0.0f, -20.0f, 5.0f},
};

static nkw_keyframe keyframe(size_t second, const placement *p)
{
    nkw_vec3 angles = {nkw_radians_from_degrees(p->pitch), nkw_radians_from_degrees(p->yaw),
                       nkw_radians_from_degrees(p->roll)};
    nkw_keyframe key = {(float)second, p->position, nkw_quat_from_euler(angles, NKW_EULER_YXZ)};
    return key;
}

/* T(0, 0, -distance) Rx(-pitch) Ry(-yaw) T(0.5, 0, 0) */
static nkw_mat4 view(const setup *s)
{
    nkw_vec3 x = {1.0f, 0.0f, 0.0f}, y = {0.0f, 1.0f, 0.0f};
    nkw_vec3 back = {0.0f, 0.0f, -s->distance}, aim = {0.5f, 0.0f, 0.0f};
    nkw_quat turn = nkw_quat_mul(nkw_quat_from_axis_angle(x, nkw_radians_from_degrees(-s->pitch)),
                                 nkw_quat_from_axis_angle(y, nkw_radians_from_degrees(-s->yaw)));
    nkw_mat3 rotation = nkw_mat3_from_quat(turn), upright = nkw_mat3_identity();
    nkw_mat4 eye = nkw_mat4_from_mat3(&rotation, back), shift = nkw_mat4_from_mat3(&upright, aim);
    return nkw_mat4_mul_affine(&eye, &shift);
}

int scene_build(int number, size_t keys, scene *out)
{
    if (number < 1 || number > 2)
        return 0;
    const setup *s = &setups[number - 1];
    if (keys == 1 || keys > s->count)
        return 0;
    out->count = keys ? keys : s->count;
    for (size_t k = 0; k < out->count; k++)
        out->keys[k] = keyframe(k, &s->keys[k]);
    out->view = view(s);
    if (out->count == s->count)
        sprintf(out->name, "scene%d", number);
    else
        sprintf(out->name, "scene%d_first%u", number, (unsigned)out->count);
    return 1;
}

float scene_end(const scene *s)
{
    return s->keys[s->count - 1].time;
}

nkw_mat4 scene_sample(const scene *s, float time, nkw_position_method position, nkw_orientation_method orientation)
{
    nkw_mat4 m = nkw_mat4_identity();
    (void)nkw_keyframes_sample(s->keys, s->count, time, position, orientation, &m);
    return m;
}
