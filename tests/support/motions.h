/* SPDX-License-Identifier: MIT */
/* Values with their velocities, for tests. */
#ifndef NAKAWARI_TESTS_MOTIONS_H
#define NAKAWARI_TESTS_MOTIONS_H

#include <nakawari/spring.h>

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

#endif
