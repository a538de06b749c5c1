/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Smooth curves on rotations, with angular velocity and angular acceleration.
 *
 * Every kind of curve fills an nkw_rotation_segment; nkw_rotation_evaluate returns the orientation, the angular
 * velocity and the angular acceleration at a parameter t, 0 at the beginning of the segment and 1 at its end:
 *
 *     kind          passes through the keys   continuous at the keys
 *     SLERP         yes                       orientation
 *     HERMITE       yes                       angular velocity, if both segments of a key have the same one
 *     catmull_rom   yes                       angular velocity: a HERMITE segment with velocities from the keys
 *     tcb           yes                       angular velocity where continuity = 0: the same with three parameters
 *     SQUAD         yes                       angular velocity, for segments of equal duration
 *     BSPLINE       no, near them             angular velocity and acceleration, for segments of equal duration
 *
 * Angular velocities are in radians per second, accelerations in radians per second^2, in the *outer* frame of the
 * orientations, as nkw_quat_angular_velocity: d q/dt = (w/2) q. In the frame of the object they are
 * nkw_quat_rotate_inverse(orientation, w).
 *
 * SLERP, HERMITE and BSPLINE are products of rotations about fixed axes of the object,
 *
 *     q(t) = q0 exp(b1(t) v1/2) exp(b2(t) v2/2) ...
 *
 * whose velocities and accelerations follow factor by factor, in the frame of the object:
 *
 *     w = R(Ei)^-1 w + bi' vi,      a = R(Ei)^-1 a + bi'' vi + w x bi' vi,      Ei = exp(bi vi/2)
 *
 * A duration that is not positive has velocity and acceleration 0, and the velocities of its ends count as 0. All
 * quaternions are normalised before use; the zero quaternion counts as the identity. Everything is computed in binary64
 * and rounded once. t outside 0..1 continues the curve. NaN returns NaN.
 *
 * Source Kim, Kim, Shin, A General Construction Scheme for Unit Quaternion Curves with Simple High Order Derivatives,
 *        SIGGRAPH 1995: products of exponentials with cumulative weights.
 *        Sommer, Usenko, Schubert, Demmel, Cremers, Efficient Derivative Computation for Cumulative B-Splines on Lie
 *        Groups, CVPR 2020: velocity and acceleration factor by factor.
 */
#ifndef NAKAWARI_ROTATION_H
#define NAKAWARI_ROTATION_H

#include <stdint.h>

#include "curve.h"
#include "orient.h"
#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The curve of a segment. Any other number is read as SLERP. */
typedef enum nkw_rotation_kind {
    NKW_ROTATION_SLERP,
    NKW_ROTATION_HERMITE,
    NKW_ROTATION_SQUAD,
    NKW_ROTATION_BSPLINE,
    NKW_ROTATION_KIND_MAX_ENUM = 0x7fffffff
} nkw_rotation_kind;

/** A curve of rotations over t = 0..1. Filled by the functions below, or by the caller. */
typedef struct nkw_rotation_segment {
    nkw_rotation_kind kind;
    nkw_path path; /**< SLERP, HERMITE: the arc; see nkw_rotation_from_hermite */
    int32_t turns; /**< SLERP, HERMITE: whole turns more */
    float duration; /**< seconds */
    nkw_quat control[4]; /**< SLERP, HERMITE: two ends; SQUAD: end, inner, inner, end; BSPLINE: four controls */
    nkw_vec3 velocity[2]; /**< HERMITE: the angular velocities at the ends */
} nkw_rotation_segment;
NKW_SIZE(nkw_rotation_segment, 104, 104);

/** The constant rotation from a to b: nkw_quat_slerp_path as a segment. */
NKW_API nkw_rotation_segment nkw_rotation_from_slerp(nkw_quat a, nkw_quat b, float duration, nkw_path path,
                                                     int32_t turns);

/**
 * The cubic segment from a, with the angular velocity va, to b, with vb: Hermite interpolation of rotations.
 *
 *     q(t) = a exp(b1 u) exp(b2 m) exp(b2 r) exp(b3 w)
 *     b1 = 1 - (1-t)^3,   b2 = 3 t^2 - 2 t^3,   b3 = t^3
 *     u, w = duration/6 times va, vb in the frames of a, b,      m = (u + w)/2,      r closes the curve at b
 *
 * The velocities may turn the object several times within the segment: a wheel of 5.3 turns between two keys turns 5.3
 * times. The factors without r are the rotation that the velocities predict; 2 r is what is left to b, and path and
 * turns select its arc: short means that the end is at most half a turn from the prediction. This function stores
 * NKW_PATH_SHORT and 0; change the fields for others. Without velocities the curve is slerp with the parameter b2.
 * Rotations of more than 2^20 rad are rounded to a float. The segment from b to a with negated velocities is another
 * curve with the same ends: the product is not symmetric.
 */
NKW_API nkw_rotation_segment nkw_rotation_from_hermite(nkw_quat a, nkw_vec3 va, nkw_quat b, nkw_vec3 vb,
                                                       float duration);

/**
 * The segment from keys[1] to keys[2] with the velocities of Catmull-Rom at its ends. With the chords
 * wi = 2 log(keys[i+1] keys[i]^-1)/hi along the shorter arc and hi = times[i+1] - times[i], the velocity of key k is
 *
 *     v = (w0 h1 + w1 h0)/(h0 + h1)
 *
 * as nkw_vec3_cubic_from_catmull_rom. At the ends of a series repeat the end key with its time: where a duration is not
 * positive, the other chord is used.
 */
NKW_API nkw_rotation_segment nkw_rotation_from_catmull_rom(const nkw_quat keys[4], const float times[4]);

/**
 * The segment from keys[1] to keys[2] with the velocities of Kochanek and Bartels; tcb[0] belongs to keys[1], tcb[1] to
 * keys[2]. With the chords above, tension T, continuity C and bias B:
 *
 *     after keys[1]    v = (1 - T)((1 + C)(1 + B) w0 h0 + (1 - C)(1 - B) w1 h1)/(h0 + h1)
 *     before keys[2]   v = (1 - T)((1 - C)(1 + B) w1 h1 + (1 + C)(1 - B) w2 h2)/(h1 + h2)
 *
 * Source Kochanek, Bartels, Interpolating Splines with Local Tension, Continuity, and Bias Control, SIGGRAPH 1984.
 */
NKW_API nkw_rotation_segment nkw_rotation_from_tcb(const nkw_quat keys[4], const float times[4], const nkw_tcb tcb[2]);

/**
 * Squad from keys[1] to keys[2], with the inner control values s1, s2 of both:
 *
 *     q(t) = slerp(slerp(keys[1], keys[2], t), slerp(s1, s2, t), 2 t (1 - t))
 *     s    = key exp(-(log(key^-1 after) + log(key^-1 before))/4),      after and before nearest to key
 *
 * s1 and s2 are control[1] and control[2] of the segment. Inner control values have the sign nearer to that of their
 * end. At the ends of a series repeat the end key. The velocity at a key is the mean of both chords *per segment*: if
 * the durations of the segments differ, the velocity per second jumps; nkw_rotation_from_catmull_rom has no such jump.
 *
 * Error  0.91 u of the inner control values.
 * Source Shoemake, Quaternion Calculus and Fast Animation, SIGGRAPH course notes, 1987.
 */
NKW_API nkw_rotation_segment nkw_rotation_from_squad(const nkw_quat keys[4], float duration);

/**
 * The cumulative cubic B-spline: control values q0 .. q3, each next one taken with the nearer sign.
 *
 *     q(t) = q0 exp(b1 v1/2) exp(b2 v2/2) exp(b3 v3/2),      vi = 2 log(q(i-1)^-1 qi)
 *     b1 = 1 - (1-t)^3/6,   b2 = (1 + 3t + 3t^2 - 2t^3)/6,   b3 = t^3/6
 *
 * It passes near its control values, not through them, and velocity and acceleration are continuous.
 */
NKW_API nkw_rotation_segment nkw_rotation_from_bspline(const nkw_quat controls[4], float duration);

/**
 * Orientation, angular velocity and angular acceleration at t.
 *
 * Returns  at t = 0 and t = 1 of SLERP, HERMITE and SQUAD the orientation is the end's, bit for bit; the second end is
 *          negated if the arc ends at its negative
 *
 * Error  1.1 u of the orientation; 1.0 u of the velocity, of S = the sum of |bi' vi|; 1.0 u of the acceleration, of S^2
 *        + the sum of |bi'' vi|; for t in 0..1, against exact arithmetic on the fields of the segment. For SQUAD S and
 *        the sum are replaced by 4 and 16 times the largest angle between two of its control values, at most 2 rad.
 * Stack  at most 3 KiB.
 */
NKW_API nkw_quat_motion nkw_rotation_evaluate(const nkw_rotation_segment *segment, float t);

#ifdef __cplusplus
}
#endif

#endif
