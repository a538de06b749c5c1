/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Floor 3: curves on rotations.
 *
 * q and -q are the same rotation, so between two rotations run two arcs. The shorter one turns by at most pi;
 * it is found by the sign of a.b, and where that is negative b is *negated* (not conjugated: the conjugate is
 * another rotation). nkw_path says which arc is meant where it is not the shorter one.
 */
#ifndef NAKAWARI_ORIENT_H
#define NAKAWARI_ORIENT_H

#include "euler.h"
#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Which of the two arcs between a and b. Any other number is read as NKW_PATH_SHORT. */
typedef enum nkw_path {
    NKW_PATH_SHORT,   /**< the arc of at most half a turn: b or -b, whichever is nearer */
    NKW_PATH_LONG,    /**< the other one, of at least half a turn */
    NKW_PATH_AS_GIVEN /**< from the quaternion a to the quaternion b as their signs stand */
} nkw_path;

/**
 * Normalised linear interpolation along the shorter arc.
 *
 *     q(t) = normalize((1-t) a +- t b)
 *
 * The same path as slerp, but not at constant speed: for a quarter turn it is up to 0.9 degrees ahead or behind, for a
 * sixth of a turn 0.3. It takes little more than half of slerp's time.
 *
 * a, b   unit to within 1e-5
 * Gives  a unit quaternion; exactly a at t = 0, exactly b or -b at t = 1. t outside 0..1 continues the chord,
 *        up to |t| = 2^60; far beyond that it gives zeros or NaN.
 *        Two zero quaternions give the identity inside.
 *
 * Error  3.3 u for t in 0..1 (3.00 for keys unit to 1e-5, 2.77 for keys unit to rounding).
 * Source Blow, Understanding Slerp, Then Not Using It, 2004.
 */
NKW_API nkw_quat nkw_quat_nlerp(nkw_quat a, nkw_quat b, float t);

/**
 * Spherical interpolation of two unit quaternions along the shorter arc, at constant speed.
 *
 *     q(t) = a sin((1-t)h)/sin h +- b sin(t h)/sin h,      cos h = |a.b|
 *
 * One expression without a branch on the angle, smooth through h = 0: no acos, no sine, no threshold. For t outside
 * 0..1 the arc continues, by nkw_quat_slerp_path, which takes some ten times as long.
 *
 * a, b   unit to rounding; otherwise the result's length is off by as much as theirs, for lengths of 2^-60 to 2^60
 * t      any
 * Gives  a unit quaternion, as long as the inputs are: exactly a at t = 0, exactly b or -b at t = 1, exactly q
 *        between q and +-q. slerp(a, b, t) and slerp(b, a, 1 - t) have the same bits, up to the sign, where
 *        1 - t is exact. At a.b = 0, half a turn apart, both arcs are equally long, and b is taken as it stands.
 *        Two zero quaternions give zero.
 *
 * Error  3.7 u (for arcs up to 0.5 rad between the quaternions 1.3, and 1.9 at t = 1/2; root mean square 0.61); 1.0 for
 *        t outside 0..1 while |t| is below 6e5: beyond, t h is first rounded to a float from 2^20 rad on, which leaves
 *        some quaternion of the arc's circle.
 * Source Shoemake, Animating Rotation with Quaternion Curves, SIGGRAPH 1985.
 */
NKW_API nkw_quat nkw_quat_slerp(nkw_quat a, nkw_quat b, float t);

/**
 * Spherical interpolation along the arc that `path` names, in binary64 inside.
 *
 * a, b   any lengths; the directions are blended, and the length goes from |a| to |b|
 * t      any; outside 0..1 the arc continues with the length of the nearer end. From |t h| = 2^20 rad on, where h is
 *        the angle between them, t h is first rounded to a float.
 * Gives  as nkw_quat_slerp. Between opposite quaternions (a = -b as given, a = b the long way), exactly or to within
 *        2^-48 rad, every arc through a is as long: the one taken turns about the local z axis, by way of
 *        a * (0, 0, 1, 0). Between 2^-48 and 2^-28 rad from opposite the rounding of the inputs decides the arc.
 *
 * Error  1.0 u for t in -2..2, while the quaternions are 2^-28 rad or more from opposite.
 */
NKW_API nkw_quat nkw_quat_slerp_path(nkw_quat a, nkw_quat b, float t, nkw_path path);

/**
 * The logarithm of a unit quaternion: the rotation vector, halved.
 *
 *     log q = axis * angle/2,      angle/2 = atan2(|q.xyz|, q.w) in 0..pi
 *
 * q need not be unit (its length is left out). q and -q differ: -q goes the long way round. No turn gives zero;
 * q.w < 0 with no axis (-1) gives (pi, 0, 0).
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
 * q^t = exp(t log q): the rotation q, t times. t = 0.5 is the half-way turn, -1 the inverse, 3 three turns.
 * As given: q and -q differ for t that is not whole. At t = 1 it is q/|q| to the error below, not the bits of
 * nkw_quat_normalize.
 *
 * Error  0.91 u, for |t| below 1e4.
 */
NKW_API nkw_quat nkw_quat_pow(nkw_quat q, float t);

/**
 * The constant angular velocity, in radians per second and in the frame that a and b are given in, that turns a
 * into b by the shorter arc in `duration` seconds.
 *
 *     w = 2 log(b a^-1) / duration
 *
 * duration 0 gives the zero vector.
 *
 * Error  1.0 u, against unit inputs without rounding.
 */
NKW_API nkw_vec3 nkw_quat_angular_velocity(nkw_quat a, nkw_quat b, float duration);

/**
 * q turned with the constant angular velocity w (radians per second, in the frame that q is given in) for
 * `duration` seconds: exp(w duration / 2) q. The inverse of nkw_quat_angular_velocity.
 *
 * Error  0.91 u, while the turn is below 1e5 rad.
 */
NKW_API nkw_quat nkw_quat_integrate(nkw_quat q, nkw_vec3 angular_velocity, float duration);

/** Which of three interpolated angles take the shorter way round. Any other number is read as NONE. */
typedef enum nkw_unwrap {
    NKW_UNWRAP_NONE, /**< as given: angles of several turns are kept */
    NKW_UNWRAP_YAW,  /**< only the angle about Y: the exercise's rule */
    NKW_UNWRAP_ALL   /**< each of the three */
} nkw_unwrap;

/**
 * Linear interpolation of Euler angles.
 *
 * Where unwrap says so, an angle of `a` that lies more than pi from that of `b` is moved by one turn towards it
 * first. That keeps each *angle* on its shorter way, which is not the shorter arc of the rotation. Exactly a (or
 * a moved by its turn) at t = 0, exactly b at t = 1.
 *
 * Error  1.0 u of the larger of |a|, |b|, each angle for itself, a as moved, for t in 0..1.
 */
NKW_API nkw_vec3 nkw_euler_lerp(nkw_vec3 a, nkw_vec3 b, float t, nkw_unwrap unwrap);

/**
 * The same functions over component arrays: element i of the result is f of the elements i, with the very bits of
 * the single call; with _at_n all at one t. See types.h for what holds of all batch functions.
 */
NKW_API void nkw_quat_nlerp_n(nkw_quat_view a, nkw_quat_view b, const float *t, nkw_quat_span out, size_t n);
NKW_API void nkw_quat_nlerp_at_n(nkw_quat_view a, nkw_quat_view b, float t, nkw_quat_span out, size_t n);
NKW_API void nkw_quat_slerp_n(nkw_quat_view a, nkw_quat_view b, const float *t, nkw_quat_span out, size_t n);
NKW_API void nkw_quat_slerp_at_n(nkw_quat_view a, nkw_quat_view b, float t, nkw_quat_span out, size_t n);
NKW_API void nkw_quat_log_n(nkw_quat_view q, nkw_vec3_span out, size_t n);
NKW_API void nkw_quat_exp_n(nkw_vec3_view v, nkw_quat_span out, size_t n);

#ifdef __cplusplus
}
#endif

#endif
