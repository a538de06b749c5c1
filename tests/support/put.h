/* SPDX-License-Identifier: MIT */
/* Values as plain floats, for programs that compare them one by one. */
#ifndef NAKAWARI_TESTS_PUT_H
#define NAKAWARI_TESTS_PUT_H

#include <string.h>

#include <nakawari/nakawari.h>

static inline void put_vec3(float *o, nkw_vec3 v)
{
    memcpy(o, &v, sizeof v);
}

static inline void put_quat(float *o, nkw_quat q)
{
    memcpy(o, &q, sizeof q);
}

static inline void put_mat3(float *o, nkw_mat3 m)
{
    memcpy(o, &m, sizeof m);
}

static inline void put_mat4(float *o, nkw_mat4 m)
{
    memcpy(o, &m, sizeof m);
}

#endif
