/* SPDX-License-Identifier: MIT */
/* Values with their velocities, and transitions that have begun, for tests. */
#ifndef NAKAWARI_TESTS_MOTIONS_H
#define NAKAWARI_TESTS_MOTIONS_H

#include <nakawari/inertia.h>

static inline nkw_state motion(float value, float velocity)
{
    nkw_state m = {value, velocity};
    return m;
}

static inline nkw_vec3 vec(float x, float y, float z)
{
    nkw_vec3 v = {x, y, z};
    return v;
}

static inline nkw_vec3_state moving(nkw_vec3 value, nkw_vec3 velocity)
{
    nkw_vec3_state m = {value, velocity};
    return m;
}

static inline nkw_quat_state rotating(nkw_quat value, nkw_vec3 velocity)
{
    nkw_quat_state m = {value, velocity};
    return m;
}

static inline nkw_offset inertia_of(nkw_state from, nkw_state to, float duration)
{
    nkw_offset o = {.duration = duration};
    nkw_offset_begin(&o, from, to);
    return o;
}

static inline nkw_vec3_offset inertia_of_vec3(const nkw_vec3_state *from, const nkw_vec3_state *to, float duration)
{
    nkw_vec3_offset o = {.duration = duration};
    nkw_vec3_offset_begin(&o, from, to);
    return o;
}

static inline nkw_quat_offset inertia_of_quat(const nkw_quat_state *from, const nkw_quat_state *to, float duration)
{
    nkw_quat_offset o = {.duration = duration};
    nkw_quat_offset_begin(&o, from, to);
    return o;
}

static inline nkw_offset dead_of(nkw_state from, float half_life, float duration)
{
    nkw_offset o = {.kind = NKW_OFFSET_DEAD_BLEND, .duration = duration, .half_life = half_life};
    nkw_offset_begin(&o, from, from);
    return o;
}

static inline nkw_vec3_offset dead_of_vec3(nkw_vec3_state from, float half_life, float duration)
{
    nkw_vec3_offset o = {.kind = NKW_OFFSET_DEAD_BLEND, .duration = duration, .half_life = half_life};
    nkw_vec3_offset_begin(&o, &from, &from);
    return o;
}

static inline nkw_quat_offset dead_of_quat(nkw_quat_state from, float half_life, float duration)
{
    nkw_quat_offset o = {.kind = NKW_OFFSET_DEAD_BLEND, .duration = duration, .half_life = half_life};
    nkw_quat_offset_begin(&o, &from, &from);
    return o;
}

#endif
