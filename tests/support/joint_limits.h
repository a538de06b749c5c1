/* SPDX-License-Identifier: MIT */
/* A rotation within a cone, an ellipse or a range of twist alone. */
#ifndef NAKAWARI_TESTS_JOINT_LIMITS_H
#define NAKAWARI_TESTS_JOINT_LIMITS_H

#include <nakawari/limit.h>

static inline nkw_quat limit_ellipse(nkw_quat q, nkw_vec3 axis, nkw_vec3 side, float a, float b)
{
    nkw_limit limit = NKW_LIMIT_NONE;
    limit.axis = axis;
    limit.side = side;
    limit.swing_side = a;
    limit.swing_across = b;
    return nkw_limit_apply(&limit, q);
}

static inline nkw_quat limit_cone(nkw_quat q, nkw_vec3 axis, float angle)
{
    nkw_vec3 none = {0, 0, 0};
    return limit_ellipse(q, axis, none, angle, angle);
}

static inline nkw_quat limit_twist(nkw_quat q, nkw_vec3 axis, float low, float high)
{
    nkw_limit limit = NKW_LIMIT_NONE;
    limit.axis = axis;
    limit.twist_low = low;
    limit.twist_high = high;
    return nkw_limit_apply(&limit, q);
}

#endif
