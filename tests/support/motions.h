/* SPDX-License-Identifier: MIT */
/* Values with their velocities, for tests. */
#ifndef NAKAWARI_TESTS_MOTIONS_H
#define NAKAWARI_TESTS_MOTIONS_H

#include <nakawari/spring.h>

static inline nkw_motion motion(float value, float velocity)
{
    nkw_motion m = {value, velocity};
    return m;
}

static inline nkw_vec3 vec(float x, float y, float z)
{
    nkw_vec3 v = {x, y, z};
    return v;
}

static inline nkw_vec3_motion moving(nkw_vec3 value, nkw_vec3 velocity)
{
    nkw_vec3_motion m = {value, velocity};
    return m;
}

static inline nkw_quat_motion rotating(nkw_quat value, nkw_vec3 velocity)
{
    nkw_quat_motion m = {value, velocity};
    return m;
}

#endif
