/* SPDX-License-Identifier: MIT */
#include "scene.h"

#include <stdio.h>
#include <string.h>

#include <nakawari/euler.h>
#include <nakawari/mat.h>
#include <nakawari/quat.h>
#include <nakawari/scalar.h>
#include <nakawari/vec.h>

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
     7,
     15.0f,
     -20.0f,
     6.0f},
    {{
         {{-1.0f, 0.5f, 0.0f}, 108.0f, 0.0f, 0.0f},
         {{1.0f, 0.5f, 0.0f}, 216.0f, 60.0f, 45.0f},
     },
     2,
     0.0f,
     -20.0f,
     5.0f},
};

static nkw_keyframe keyframe(size_t second, const placement *p)
{
    nkw_vec3 angles = {nkw_radians_from_degrees(p->pitch), nkw_radians_from_degrees(p->yaw),
                       nkw_radians_from_degrees(p->roll)};
    nkw_keyframe key = {(float)second, p->position, nkw_quat_from_euler(angles, NKW_EULER_YXZ)};
    return key;
}

/* T(0, 0, -distance) Rx(-pitch) Ry(-yaw) T(aim) */
static nkw_mat4 view(const setup *s, nkw_vec3 aim)
{
    nkw_vec3 x = {1.0f, 0.0f, 0.0f}, y = {0.0f, 1.0f, 0.0f};
    nkw_vec3 back = {0.0f, 0.0f, -s->distance};
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
    const nkw_vec3 aim = {0.5f, 0.0f, 0.0f};
    out->view = view(s, aim);
    out->unit = 1.0f;
    out->own = 0;
    out->rule = NKW_KEYFRAME_RULE_EXERCISE;
    out->object = NULL;
    if (out->count == s->count)
        sprintf(out->name, "scene%d", number);
    else
        sprintf(out->name, "scene%d_first%u", number, (unsigned)out->count);
    return 1;
}

static void set_name(scene *s, const char *name)
{
    size_t n = 0;
    for (; *name && n + 1 < sizeof s->name; name++) {
        const int plain = (*name >= 'a' && *name <= 'z') || (*name >= 'A' && *name <= 'Z') ||
                          (*name >= '0' && *name <= '9') || *name == '-' || *name == '_';
        s->name[n++] = plain ? *name : '_';
    }
    s->name[n] = 0;
    if (n == 0)
        strcpy(s->name, "scene");
}

/* The middle of the keys, and the farthest of them from it. */
static nkw_vec3 middle_of(const scene *s, float *radius)
{
    nkw_vec3 low = s->keys[0].position, high = low;
    for (size_t k = 1; k < s->count; k++) {
        low = nkw_vec3_min(low, s->keys[k].position);
        high = nkw_vec3_max(high, s->keys[k].position);
    }
    nkw_vec3 middle = nkw_vec3_scale(nkw_vec3_add(low, high), 0.5f);
    *radius = 0.5f * nkw_vec3_distance(low, high);
    return middle;
}

/* The power of ten that makes the radius 0.5 ... 5. */
static float unit_of(float radius)
{
    float unit = 1.0f;
    while (radius > 5.0f * unit && unit < 1e30f)
        unit *= 10.0f;
    while (radius < 0.5f * unit && unit > 1e-6f)
        unit /= 10.0f;
    return unit;
}

int scene_from_keys(const char *name, const nkw_keyframe *keys, size_t count, scene *out)
{
    setup eye = setups[0];
    float radius;
    size_t bad;
    if (count < 2 || count > SCENE_KEYS_MAX || nkw_keyframes_validate(keys, count, &bad) != NKW_OK ||
        !(keys[count - 1].time - keys[0].time <= (float)SCENE_SECONDS_MAX))
        return 0;
    memcpy(out->keys, keys, count * sizeof *keys);
    out->count = count;
    out->own = 1;
    out->rule = NKW_KEYFRAME_RULE_EXERCISE;
    out->object = NULL;
    set_name(out, name);
    nkw_vec3 middle = middle_of(out, &radius);
    out->unit = unit_of(radius);
    eye.distance = 2.0f + 2.0f * radius / out->unit;
    out->view = view(&eye, nkw_vec3_scale(middle, -1.0f / out->unit));
    return 1;
}

float scene_start(const scene *s)
{
    return s->keys[0].time;
}

float scene_end(const scene *s)
{
    return s->keys[s->count - 1].time;
}

nkw_mat4 scene_sample(const scene *s, float time, nkw_position_method position, nkw_orientation_method orientation)
{
    nkw_mat4 m = nkw_mat4_identity();
    nkw_keyframe_options options = {position, orientation, s->rule};
    (void)nkw_keyframes_sample_as(s->keys, s->count, time, &options, &m);
    return m;
}

nkw_mat4 scene_place(const scene *s, float time, nkw_position_method position, nkw_orientation_method orientation)
{
    nkw_mat4 m = scene_sample(s, time, position, orientation);
    for (int i = 12; i < 15; i++)
        m.m[i] /= s->unit;
    return m;
}

nkw_vec3 scene_position(const scene *s, size_t key)
{
    nkw_vec3 p = s->keys[key].position;
    p.x /= s->unit, p.y /= s->unit, p.z /= s->unit;
    return p;
}

size_t scene_times(const scene *s, int per_second)
{
    return (size_t)((scene_end(s) - scene_start(s)) * (float)per_second + 0.999f) + 1;
}

float scene_time(const scene *s, int per_second, size_t i)
{
    return nkw_min(scene_start(s) + (float)i / (float)per_second, scene_end(s));
}

float scene_segment_time(const scene *s, size_t segment, float t)
{
    return nkw_lerp(s->keys[segment].time, s->keys[segment + 1].time, t);
}
