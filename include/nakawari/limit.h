/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Limits of joints: the nearest rotation within a cone, an ellipse, a range of twist.
 *
 * A rotation is split into a twist about an axis of the joint and a swing of this axis (nkw_quat_swing_twist):
 *
 *     q = swing twist,      swing = exp(s/2),  s perpendicular to the axis,  |s| the angle of the swing
 *
 * Swings are points s of a plane, and limits are figures of this plane about the origin. A point outside moves to the
 * nearest point of the boundary; the twist does not change. A twist outside its range moves to the nearer end, around
 * the circle; the swing does not change.
 *
 * Within the limits, or outside by at most 2^-20 rad, q is returned unchanged, bit for bit; so limits applied twice
 * return the same bits as once: a cone always, the others where the swing of the result is at most 2.9 rad. Nearer to
 * half a turn, the rounding of q moves its twist and the direction of its swing by more than 2^-20 rad.
 *
 * Angles are clamped to 0..pi, NaN to pi (no limit). A zero axis is no limit: q is returned. If q has NaN or infinity,
 * it is returned too. q need not be unit; what is clamped is unit.
 *
 * Source Dobrowolski, Swing-twist decomposition in Clifford algebra, arXiv:1506.05481, 2015;
 *        Eberly, Distance from a Point to an Ellipse, an Ellipsoid, or a Hyperellipsoid, 2013.
 */
#ifndef NAKAWARI_LIMIT_H
#define NAKAWARI_LIMIT_H

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The limits of one joint, measured from a rest rotation. */
typedef struct nkw_limit {
    nkw_quat rest; /**< the rotation of no swing and no twist; zero counts as the identity */
    nkw_vec3 axis; /**< the direction of the bone in the joint's space, any length; zero: no limit */
    nkw_vec3 side; /**< the first axis of the ellipse, in the joint's space */
    float swing_side, swing_across; /**< half axes a, b of the ellipse, radians; equal for a cone */
    float twist_low, twist_high; /**< radians */
} nkw_limit;
NKW_SIZE(nkw_limit, 56, 56);

/**
 * No limit. Set the axis and the angles that are limited; a cone of 0.5 rad about z:
 *
 *     nkw_limit limit = NKW_LIMIT_NONE;
 *     limit.axis.z = 1;
 *     limit.swing_side = limit.swing_across = 0.5f;
 */
#define NKW_LIMIT_NONE                                                                                                 \
    {                                                                                                                  \
        {0, 0, 0, 1}, {0, 0, 0}, {0, 0, 0}, 3.14159274f, 3.14159274f, -3.14159274f, 3.14159274f                        \
    }

/**
 * The rotation nearest to q within all limits of the joint: the twist and the swing of rest^-1 q are limited.
 *
 * The swing is limited to an ellipse with half axes a, b, angles of the swings about `side` and about axis x side:
 *
 *     (s.side / a)^2 + (s.(axis x side) / b)^2 <= 1
 *
 * side is made perpendicular to the axis; zero or along the axis it is replaced by nkw_vec3_perpendicular(axis). With
 * b = 0 the joint swings like a hinge. The nearest point of the boundary is the root of a convex function, by Newton's
 * method from the side on which it converges for every point.
 *
 * The twist is limited to the angles low .. high, of at most 2^20 rad; a range of 2 pi or more, or NaN, is no limit. If
 * low > high, both are replaced by their mean.
 *
 * Returns q, bit for bit, if both are within their limits.
 *
 * Error  0.91 u, if the swing is at least 1e-3 rad from half a turn.
 */
NKW_API nkw_quat nkw_limit_apply(const nkw_limit *limit, nkw_quat q);

#ifdef __cplusplus
}
#endif

#endif
