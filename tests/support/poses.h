/* SPDX-License-Identifier: MIT */
/* Poses and masks of more than one block of the loops, for the tests of blending. */
#ifndef NAKAWARI_TESTS_POSES_H
#define NAKAWARI_TESTS_POSES_H

#include <math.h>

#include "expect.h"
#include "random.h"
#include "views.h"

#define JOINTS 149 /* two blocks of the loops, the second with padding */
#define STRIDE NKW_POSE_STRIDE(JOINTS)
#define FLOATS NKW_POSE_FLOATS(JOINTS)
#define U      5.9604645e-8 /* 2^-24 */

static inline void draw(random_source *r, float *pose)
{
    for (size_t i = 0; i < FLOATS; i++)
        pose[i] = NAN; /* the padding must have no effect */
    for (size_t j = 0; j < JOINTS; j++) {
        nkw_trs trs = {random_vec3(r, -5, 5), random_rotation(r), random_vec3(r, 0.5f, 2)};
        nkw_pose_set(pose_span(pose, JOINTS), j, &trs);
    }
}

static inline void draw_mask(random_source *r, float *mask)
{
    for (size_t j = 0; j < STRIDE; j++)
        mask[j] = j >= JOINTS ? NAN : random_bits(r) % 4 == 0 ? (float)(random_bits(r) % 2) : random_unit(r);
}

static inline void expect_poses_bits(const float *got, const float *want)
{
    for (size_t c = 0; c < 10; c++)
        expect_floats_bits(got + c * STRIDE, want + c * STRIDE, JOINTS);
}

#endif
