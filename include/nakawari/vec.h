/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Vectors of three floats.
 *
 * A vector is a column. Positions, directions, scales and Euler angles share the type; the name of the argument states
 * the meaning. Sums of three products are evaluated as (x + y) + z.
 *
 * Every function is total: infinities and NaN propagate by the rules of IEEE 754. Statements about zero and subnormal
 * vectors hold for every one of them.
 *
 * Example  nkw_vec3 a, b, v, n; float t, x;
 *
 *     v = nkw_vec3_add(a, b);
 *     v = nkw_vec3_sub(a, b);
 *     v = nkw_vec3_negate(a);
 *     v = nkw_vec3_scale(a, t);
 *     v = nkw_vec3_mul(a, b);                   component by component
 *     v = nkw_vec3_add_scaled(a, b, t);         a + t b
 *     v = nkw_vec3_min(a, b);                   component by component
 *     v = nkw_vec3_max(a, b);
 *     x = nkw_vec3_dot(a, b);                   dot(a, a) is the squared length
 *     v = nkw_vec3_cross(a, b);
 *     v = nkw_vec3_lerp(a, b, t);               a straight line
 *     x = nkw_vec3_length(a);
 *     x = nkw_vec3_distance(a, b);
 *     v = nkw_vec3_normalize(a);                zero stays zero
 *     x = nkw_vec3_angle(a, b);                 0 to pi
 *     v = nkw_vec3_project(a, b);               the part along b
 *     v = nkw_vec3_reject(a, b);                the part across b
 *     v = nkw_vec3_reflect(a, n);               at a plane with the unit normal n
 *     v = nkw_vec3_perpendicular(a);            any unit vector across a
 *     nkw_vec3_is_finite(a);
 *     nkw_vec3_equal_within(a, b, 1e-5f);       component by component
 *     v = nkw_vec3_move_towards(v, b, 0.1f);    by a step, never beyond
 */
#ifndef NAKAWARI_VEC_H
#define NAKAWARI_VEC_H

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** (0, 0, 0), as an initialiser and as an argument. */
#define NKW_VEC3_ZERO (NKW_LITERAL(nkw_vec3){0.0f, 0.0f, 0.0f})

/** a + b. */
NKW_ALGEBRA nkw_vec3 nkw_vec3_add(nkw_vec3 a, nkw_vec3 b);
/** a - b. */
NKW_ALGEBRA nkw_vec3 nkw_vec3_sub(nkw_vec3 a, nkw_vec3 b);
/** -a. Negates zeros too. */
NKW_ALGEBRA nkw_vec3 nkw_vec3_negate(nkw_vec3 a);
/** s a. */
NKW_ALGEBRA nkw_vec3 nkw_vec3_scale(nkw_vec3 a, float s);
/** The component-wise product (a.x b.x, a.y b.y, a.z b.z): a scaled along the axes by b. */
NKW_ALGEBRA nkw_vec3 nkw_vec3_mul(nkw_vec3 a, nkw_vec3 b);
/**
 * a + s b: one product and one sum, each rounded.
 *
 * Error  2.0 u of |a| + |s b|, for each component separately.
 */
NKW_ALGEBRA nkw_vec3 nkw_vec3_add_scaled(nkw_vec3 a, nkw_vec3 b, float s);
/** The smaller of each pair of components, by nkw_min. */
NKW_ALGEBRA nkw_vec3 nkw_vec3_min(nkw_vec3 a, nkw_vec3 b);
/** The larger of each pair of components, by nkw_max. */
NKW_ALGEBRA nkw_vec3 nkw_vec3_max(nkw_vec3 a, nkw_vec3 b);

/**
 * The scalar product a.b = (a.x b.x + a.y b.y) + a.z b.z.
 *
 * Error  3.0 u of |a| |b|.
 */
NKW_ALGEBRA float nkw_vec3_dot(nkw_vec3 a, nkw_vec3 b);

/**
 * The vector product a x b, right-handed: x cross y is z.
 *
 * Error  2.0 u of |a| |b|.
 */
NKW_ALGEBRA nkw_vec3 nkw_vec3_cross(nkw_vec3 a, nkw_vec3 b);

/**
 * Linear interpolation of each component by nkw_lerp: exactly a at t = 0, exactly b at t = 1, and exactly a if a = b.
 * For t outside 0..1 the line continues.
 *
 * Error  2.0 u of the larger of |a|, |b|, for each component separately, for t in 0..1.
 */
NKW_ALGEBRA nkw_vec3 nkw_vec3_lerp(nkw_vec3 a, nkw_vec3 b, float t);

/**
 * The length |a|. Finite if the exact length is: no intermediate overflow or underflow.
 *
 * Error  0.501 ULP.
 */
NKW_API float nkw_vec3_length(nkw_vec3 a);

/**
 * The distance |a - b| of two points. The difference is computed exactly.
 *
 * Error  0.501 ULP.
 */
NKW_API float nkw_vec3_distance(nkw_vec3 a, nkw_vec3 b);

/**
 * a / |a|: the unit vector in the direction of a, for every finite a, including subnormal and huge vectors.
 * The zero vector returns the zero vector.
 *
 * The squares are summed in binary32. Lengths outside 2^-79 .. 2^32 take about twice as long: they are multiplied by
 * another power of two.
 *
 * Error  3.1 u (2.97 at -0x1.0063f4p-122, -0x1.988c8p-131, 0x1.5905ap-130; 2.5 of 65,536 random vectors).
 */
NKW_ALGEBRA_ROOT nkw_vec3 nkw_vec3_normalize(nkw_vec3 a);

/**
 * The angle between two directions, 0..pi radians; 0 if one of them is zero.
 *
 *     angle = atan2(|a x b|, a.b)
 *
 * This keeps all digits near 0 and near pi, where acos(a.b) loses half of them.
 *
 * Error  0.501 ULP.
 */
NKW_API float nkw_vec3_angle(nkw_vec3 a, nkw_vec3 b);

/**
 * The component of a along b: b (a.b) / (b.b). b need not be unit; b = 0 returns zero.
 *
 * Error  1.0 u of |a|.
 */
NKW_API nkw_vec3 nkw_vec3_project(nkw_vec3 a, nkw_vec3 b);

/**
 * The component of a perpendicular to b: a - project(a, b). b = 0 returns a.
 *
 * Error  1.0 u of |a|.
 */
NKW_API nkw_vec3 nkw_vec3_reject(nkw_vec3 a, nkw_vec3 b);

/**
 * a reflected in the plane through the origin with the unit normal n: a - 2 (a.n) n.
 *
 * Error  19.0 u of |a| for n from nkw_vec3_normalize, 11.0 for a unit n with each component rounded once.
 */
NKW_ALGEBRA nkw_vec3 nkw_vec3_reflect(nkw_vec3 a, nkw_vec3 n);

/**
 * A unit vector perpendicular to a: the normalised cross product of a and the axis of its smallest component. The zero
 * vector returns the x axis.
 *
 * The result is discontinuous where the two smallest components are equal in magnitude. No continuous choice exists on
 * the sphere.
 *
 * Error  0.71 u.
 */
NKW_API nkw_vec3 nkw_vec3_perpendicular(nkw_vec3 a);

/** 1 if all three components are finite, otherwise 0. */
NKW_ALGEBRA int nkw_vec3_is_finite(nkw_vec3 a);

/** 1 if no component of a and b differs by more than `tolerance`, otherwise 0, also for NaN. */
NKW_API int nkw_vec3_equal_within(nkw_vec3 a, nkw_vec3 b, float tolerance);

/**
 * `from`, moved on the straight line towards `to` by at most `step`: `to` itself within that distance. A negative step
 * counts as 0. NaN returns NaN.
 *
 *     from + (to - from) step / |to - from|
 */
NKW_API nkw_vec3 nkw_vec3_move_towards(nkw_vec3 from, nkw_vec3 to, float step);

#ifdef __cplusplus
}
#endif

#if NKW_INLINE || defined(NKW_DEFINE_ALGEBRA)
#include "inline/vec.h"
#endif

#endif
