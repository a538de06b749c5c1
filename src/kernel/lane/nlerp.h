/* SPDX-License-Identifier: MIT */
/* nlerp: a sum, divided by its length. */
#ifndef NAKAWARI_LANE_NLERP_H
#define NAKAWARI_LANE_NLERP_H

#include "strict.h"

#include <nakawari/orient.h>

#include "quat.h"
#include "scalar.h"

/* v is divided by sqrt(n2) later. It is the sum of nlerp times 2^60; or the result itself, and n2 is 1. */
typedef struct lane_nlerp {
    nkw_quat v;
    float n2;
} lane_nlerp;

/*
 * v = (1 - t) a + t c, c = +-b, exactly a at t = 0, exactly c at t = 1, exactly a where a = c is not zero. `generic`, a
 * constant, states that none of these holds.
 */
static inline lane_nlerp lane_quat_nlerp(nkw_quat a, nkw_quat b, float t, int generic)
{
    uint32_t last = generic ? 0u : 0u - (uint32_t)(t == 1.0f);
    float s = lane_select(last, NKW_NLERP_SCALE, NKW_NLERP_SCALE - NKW_NLERP_SCALE * t);
    nkw_quat part = nkw_quat_scale(a, s);
    float dot = nkw_quat_dot(part, b);
    nkw_quat c = lane_quat_flip(b, (dot < 0.0f) != (s < 0.0f) ? 0x80000000u : 0u);
    nkw_quat v = nkw_quat_add(part, nkw_quat_scale(c, NKW_NLERP_SCALE * t));
    int is_equal = (a.x == c.x) & (a.y == c.y) & (a.z == c.z) & (a.w == c.w);
    uint32_t kept = generic ? 0u : 0u - (uint32_t)nkw_nlerp_is_kept(is_equal, t, dot);
    lane_nlerp r = {
        {
            lane_select(kept, lane_select(last, c.x, a.x), v.x),
            lane_select(kept, lane_select(last, c.y, a.y), v.y),
            lane_select(kept, lane_select(last, c.z, a.z), v.z),
            lane_select(kept, lane_select(last, c.w, a.w), v.w),
        },
        lane_select(kept, 1.0f, nkw_quat_dot(v, v)),
    };
    return r;
}

/* Returns v / |v| for a sum of any length n; v itself for n = 1. */
static inline nkw_quat lane_nlerp_any(nkw_quat v, float n)
{
    return lane_quat_select(n == 1.0f, v, nkw_quat_normalize_any(v, nkw_quat_dot(v, v), 1.0f));
}

#endif
