/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Curves on rotations.
 *
 * q and -q are the same rotation, so two arcs join two rotations. The shorter arc rotates by at most pi. If a.b is
 * negative, the shorter arc ends at -b: b is *negated*, not conjugated, because the conjugate is another rotation.
 * Interpolations of quaternions take the shorter arc, except the functions in _path, where nkw_path selects the arc.
 *
 * Example  nkw_quat a, b, q; nkw_vec3 v; float t; int32_t turns;
 *
 *     q = nkw_quat_nlerp(a, b, t);                           shorter arc, cheap, speed varies
 *     q = nkw_quat_slerp(a, b, t);                           shorter arc, constant speed
 *     q = nkw_quat_rotate_towards(a, b, 0.1f);               by an angle, never beyond
 *     q = nkw_quat_slerp_path(a, b, t, NKW_PATH_LONG, 0);    longer arc, whole turns
 *     q = nkw_quat_nlerp_path(a, b, t, NKW_PATH_LONG, 0);
 *     turns = nkw_quat_turns(a, b, v, NKW_PATH_SHORT);       which arc an angular velocity took
 *     v = nkw_quat_log(q);                                   half the rotation vector
 *     q = nkw_quat_exp(v);
 *     q = nkw_quat_pow(q, t);                                a part of a rotation
 *     v = nkw_quat_angular_velocity(a, b, 0.1f);             radians per second
 *     q = nkw_quat_integrate(q, v, 0.1f);                    turns for a time
 */
#ifndef NAKAWARI_ORIENT_H
#define NAKAWARI_ORIENT_H

#include <stdint.h>

#include "euler.h"
#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * The arc between a and b. Any other number is read as NKW_PATH_SHORT.
 *
 * Functions with a path also take a number of whole turns k: the rotation by the angle g of the arc continues by k
 * whole turns about the same axis, to g + 2 pi k. A negative k turns the other way: the short arc with k = -1 is the
 * long arc.
 */
typedef enum nkw_path {
    NKW_PATH_SHORT,   /**< the arc of at most half a turn: from a to the nearer of b and -b */
    NKW_PATH_LONG,    /**< the other arc, of at least half a turn */
    NKW_PATH_AS_GIVEN, /**< from a to b, with their signs as given */
    NKW_PATH_MAX_ENUM = 0x7fffffff
} nkw_path;

/**
 * Normalised linear interpolation along the shorter arc.
 *
 *     q(t) = normalize((1-t) a +- t b)
 *
 * The same path as slerp, but not at constant angular velocity: it deviates by up to 0.9 degrees from slerp for a
 * quarter turn, by up to 0.3 for a sixth of a turn. It takes about a third of the time of slerp.
 *
 * a, b     unit to within 1e-5
 * t        any up to |t| = 2^60; outside 0..1 the straight line from a to +-b continues; far beyond 2^60 the result is
 *          zero or NaN
 * Returns  a unit quaternion; exactly a at t = 0, exactly b or -b at t = 1, exactly q between q and +-q. Two zero
 *          quaternions return the identity for t between 0 and 1.
 *
 * The weighted sum is divided by its length; where |a.b| is below 5 u, rounding decides the sign.
 *
 * Error  3.3 u for t in 0..1 (2.96 for keys unit to rounding or to 1e-5; 2.2 of 65,536 random ones).
 * Source Blow, Understanding Slerp, Then Not Using It, 2004.
 */
NKW_ALGEBRA_ROOT nkw_quat nkw_quat_nlerp(nkw_quat a, nkw_quat b, float t);

/**
 * Spherical interpolation of two unit quaternions along the shorter arc, at constant angular velocity.
 *
 *     q(t) = a sin((1-t)h)/sin h +- b sin(t h)/sin h,      cos h = |a.b|
 *
 * Within 0..1 one expression is valid for all angles, without a branch on the angle and without acos or sine. Less
 * exact forms of peers take longer, so this form stays.
 *
 * a, b     unit to rounding; for other lengths, 2^-60 to 2^60, the length of the result deviates from 1 as theirs do
 * t        any; outside 0..1 the arc continues by nkw_quat_slerp_path, which takes about ten times as long
 * Returns  a quaternion that is unit as a and b are: exactly a at t = 0, exactly b or -b at t = 1, exactly q between q
 *          and +-q. If 1 - t is exact, slerp(a, b, t) and slerp(b, a, 1 - t) have the same bits, except the sign. If
 *          a.b = 0, a rotation by half a turn, both arcs have equal length, and b is not negated. Two zero quaternions
 *          return zero.
 *
 * Error  3.7 u (for arcs up to 0.5 rad between the quaternions 1.3, and 1.9 at t = 1/2; root mean square 0.61); 1.0 for
 *        t outside 0..1 with |t| below 6e5. From |t h| = 2^20 rad on, t h is first rounded to a float, and the result
 *        is only a quaternion on the circle of the arc.
 * Source Shoemake, Animating Rotation with Quaternion Curves, SIGGRAPH 1985.
 */
NKW_API nkw_quat nkw_quat_slerp(nkw_quat a, nkw_quat b, float t);

/**
 * `from`, rotated towards `to` along the shorter arc by at most `angle` radians: `to` itself within that angle,
 * otherwise nkw_quat_slerp(from, to, angle / nkw_quat_angle(from, to)). A negative angle counts as 0. NaN returns NaN.
 */
NKW_API nkw_quat nkw_quat_rotate_towards(nkw_quat from, nkw_quat to, float angle);

/**
 * Spherical interpolation along the arc that `path` selects, and `turns` whole turns more. Computed in binary64.
 *
 *     q(t) = a turned by t (g + 2 pi turns) about the axis of the arc,      g the angle of the arc, 0..2 pi
 *
 * a, b     any lengths; the directions are interpolated along the arc, the lengths linearly from |a| to |b|
 * t        any; outside 0..1 the arc continues with the length of the nearer end. From |t g| = 2^21 rad on, t g is
 *          first rounded to a float.
 * turns    any; up to 2^29 the product with t is exact
 * Returns  as nkw_quat_slerp; at t = 1, b with the sign of the arc, negated if turns is odd. If a and b are equal or
 *          opposite to within 2^-48 rad, the arc has no axis: the local z axis is used, through a * (0, 0, 1, 0), for
 *          the arc from a to -a and for whole turns. From 2^-48 to 2^-28 rad, rounding of the inputs decides the axis.
 *
 * Error  1.2 u for t in -2..2 and turns of -1000..1000, if the axis does not depend on rounding: without turns the
 *        ends of the arc are at least 2^-26 rad from opposite, with turns also 2^-26 rad from equal (1.6 u at 2^-28
 *        rad).
 */
NKW_API nkw_quat nkw_quat_slerp_path(nkw_quat a, nkw_quat b, float t, nkw_path path, int32_t turns);

/**
 * nkw_quat_nlerp along the arc that `path` selects, and `turns` whole turns more, which advance linearly. Computed in
 * binary64 as the angle of the straight line from a to b, along the arc of nkw_quat_slerp_path:
 *
 *     tan(p/2) = t |b| sin h / ((1-t) |a| + t |b| cos h),      q(t) = a turned by p + 2 pi turns t,      h = g/2
 *
 * Without turns it is normalize((1-t) a + t b), b with the sign of the path. The long arc is nearly all in the middle
 * of 0..1, the more so the longer it is: for arcs above half a turn nkw_quat_slerp_path is the better choice.
 *
 * a, b, t, turns, Returns  as nkw_quat_slerp_path
 *
 * Error  1.2 u for t in 0..1, under the condition of nkw_quat_slerp_path, and for arcs of at most 3.1 rad between the
 *        quaternions.
 */
NKW_API nkw_quat nkw_quat_nlerp_path(nkw_quat a, nkw_quat b, float t, nkw_path path, int32_t turns);

/**
 * The number of whole turns with which the arc from a to b is nearest to the rotation vector `expected` (radians, in
 * the frame of a and b): the k that minimises |(g + 2 pi k) n - expected|, n the axis of the arc. For a wheel whose
 * angular velocity w is known, expected = w * duration. The smaller |k| of two that are equally near; 0 if a and b are
 * equal, so that the arc has no axis, or if `expected` is not finite. Clamped to -2^29..2^29.
 */
NKW_API int32_t nkw_quat_turns(nkw_quat a, nkw_quat b, nkw_vec3 expected, nkw_path path);

/**
 * The logarithm of a unit quaternion: half the rotation vector.
 *
 *     log q = axis * angle/2,      angle/2 = atan2(|q.xyz|, q.w) in 0..pi
 *
 * q need not be unit: its length has no effect. log(q) and log(-q) differ: they are the two arcs of the same rotation.
 * The identity returns zero; a negative w with x = y = z = 0 returns (pi, 0, 0).
 *
 * From others: the rotation vector of SciPy (as_rotvec), Sophus and Eigen is twice this.
 *
 * Error  1.0 u.
 */
NKW_API nkw_vec3 nkw_quat_log(nkw_quat q);

/**
 * The exponential of half a rotation vector: (v sin|v| / |v|, cos|v|), a unit quaternion for every finite v.
 * exp(log(q)) = q.
 *
 * Error  0.91 u, for |v| below 1e5.
 */
NKW_API nkw_quat nkw_quat_exp(nkw_vec3 v);

/**
 * q^t = exp(t log q): the rotation q applied t times. t = 0.5 rotates by half the angle, -1 is the inverse, 3 rotates
 * by three times the angle. q is not negated: for t that is not an integer, the results of q and -q are different
 * rotations. At t = 1 the result is q/|q| to the error below, not the bits of nkw_quat_normalize.
 *
 * Error  0.91 u, for |t| below 1e4.
 */
NKW_API nkw_quat nkw_quat_pow(nkw_quat q, float t);

/**
 * The constant angular velocity that rotates a to b along the shorter arc in `duration` seconds, in radians per second
 * and in the frame of a and b.
 *
 *     w = 2 log(b a^-1) / duration
 *
 * duration = 0 returns the zero vector.
 *
 * Error  1.0 u, relative to the exact value for unit inputs without rounding.
 */
NKW_API nkw_vec3 nkw_quat_angular_velocity(nkw_quat a, nkw_quat b, float duration);

/**
 * q rotated with the constant angular velocity w (radians per second, in the frame of q) for `duration` seconds:
 * exp(w duration / 2) q. The inverse of nkw_quat_angular_velocity.
 *
 * Error  0.91 u, for rotations below 1e5 rad.
 */
NKW_API nkw_quat nkw_quat_integrate(nkw_quat q, nkw_vec3 angular_velocity, float duration);

#ifdef __cplusplus
}
#endif

#if NKW_INLINE || defined(NKW_DEFINE_ALGEBRA)
#include "inline/orient.h"
#endif

#endif
