/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Transitions from one motion to another without a jump of the value or of its velocity, and the motion
 * between two steps of physics.
 *
 * Inertialisation stores the offset between the old and the new motion when the new one begins, and reduces it to 0 by
 * a quintic. Only the new motion is evaluated from then on:
 *
 *     result(t) = to(t) + offset(t),     t seconds after the transition began
 *
 * Dead blending continues the old motion with a velocity that decays, and blends from it to the new one. One state,
 * nkw_offset, is begun and evaluated in the same way for both.
 *
 * The states of both motions are needed once, when the transition begins; then only that of the new one. `evaluate`
 * returns a motion, so that a transition can begin while another is running: its result is the `from` of the next.
 */
#ifndef NAKAWARI_INERTIA_H
#define NAKAWARI_INERTIA_H

#include "spring.h"
#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** How a transition passes from the old motion to the new one. Any other number is read as NKW_OFFSET_INERTIA. */
typedef enum nkw_offset_kind {
    NKW_OFFSET_INERTIA, /**< inertialisation: the new motion, and an offset from it that shrinks to 0 */
    NKW_OFFSET_DEAD_BLEND, /**< dead blending: from the old motion, slowing down, to the new one */
    NKW_OFFSET_KIND_MAX_ENUM = 0x7fffffff
} nkw_offset_kind;

/**
 * A transition of a number. Set kind, duration and half_life; nkw_offset_begin sets the rest. Zeros are a transition
 * that has ended.
 */
typedef struct nkw_offset {
    nkw_offset_kind kind;
    float duration; /**< seconds */
    float half_life; /**< dead blending: seconds in which the velocity of the old motion is halved */
    float end; /**< seconds after which only the new motion remains: at most the duration */
    nkw_state from; /**< the old motion where the transition began */
    float c[3]; /**< inertialisation: (1 - u)^3 (c[0] + c[1] u + c[2] u^2), u = t/end, is the offset */
} nkw_offset;
NKW_SIZE(nkw_offset, 36, 36);

/** The same of a vector. */
typedef struct nkw_vec3_offset {
    nkw_offset_kind kind;
    float duration, half_life, end;
    nkw_vec3_state from;
    nkw_vec3 c[3];
} nkw_vec3_offset;
NKW_SIZE(nkw_vec3_offset, 76, 76);

/** The same of a rotation. */
typedef struct nkw_quat_offset {
    nkw_offset_kind kind;
    float duration, half_life, end;
    nkw_quat_state from;
    nkw_vec3 c[3]; /**< of half the rotation vector of the offset, in the outer frame */
    nkw_quat difference; /**< dead blending: of both motions at the last evaluation; zeros before the first one */
} nkw_quat_offset;
NKW_SIZE(nkw_quat_offset, 96, 96);

/**
 * Begins the transition from one motion to another.
 *
 * Inertialisation:
 *
 *     x = from - to,   v = from' - to',   T = duration,   V = v T
 *
 *     offset(u) = (1 - u)^3 (x + (V + 3 x) u + (A/2 + 3 V + 6 x) u^2),      A = max(-8 V/x - 20, 0) x
 *
 * the quintic that ends with value, velocity and acceleration 0. If the offset already shrinks, T is reduced to
 * -5 x/v where that is shorter, and the acceleration A at the start is raised, so that the offset does not change its
 * sign. If the offset grows, its velocity is kept: it grows to at most |x| + 0.22 |V| before it shrinks. (Bollo sets
 * such velocities to 0; the velocity then jumps.)
 *
 * Dead blending stores `from`; `to` is not read.
 *
 * offset  kind, duration and half_life are read, the rest is set. A duration that is not positive ends the transition
 *         at once, that of inertialisation also if it is infinite
 *
 * Error  1.01 u of the norm of the coefficients.
 * Source Bollo, Inertialization: High-Performance Animation Transitions in Gears of War, GDC 2018.
 */
NKW_API void nkw_offset_begin(nkw_offset *offset, nkw_state from, nkw_state to);

/**
 * The same of a vector. T and A follow from the part of v along x, with V x / |x|^2 for V/x; the part of v at right
 * angles to x has no offset to reduce and is kept. So the velocity is continuous in all directions, and the transition
 * does not depend on the axes.
 */
NKW_API void nkw_vec3_offset_begin(nkw_vec3_offset *offset, const nkw_vec3_state *from, const nkw_vec3_state *to);

/**
 * The same of a rotation: x = log(from to^-1) along the shorter arc, and v is its rate, which follows from both angular
 * velocities. The arc is chosen here, once: whatever the new motion does later, the result of inertialisation does not
 * snap from one arc to the other. For opposite rotations either arc begins at `from`.
 *
 * from, to  any lengths but 0; a zero quaternion counts as the identity. A v that passes more than 2^16 rad in T is
 *           reduced to that
 *
 * Error  1.01 u of the norm of the nine coefficients, and of `end`, for rotations of 2^-9 to 3 rad and velocities of at
 *        most 5 rad/s. Where T is reduced to -5 x/v it has the condition of that quotient: the error holds for v within
 *        89.9 degrees of -x.
 */
NKW_API void nkw_quat_offset_begin(nkw_quat_offset *offset, const nkw_quat_state *from, const nkw_quat_state *to);

/**
 * The motion t seconds after the transition began, from the new motion at that time.
 *
 *     inertialisation    to + offset(u),      u = t/end
 *     dead blending      old + s (to - old),  s = 3 u^2 - 2 u^3
 *
 *     old(t) = x + v h (1 - 2^(-t/half_life)),  h = half_life/ln 2,  x and v of `from`
 *
 * offset   a half_life of 0 or less stops the old motion at once, infinity lets it continue with its velocity
 * to       value and velocity of the new motion; without interest in the velocity of the result, any
 * t        seconds; negative numbers and NaN count as 0
 * Returns  `from` at t = 0: of inertialisation to rounding, of dead blending exactly. From t = end on exactly `to`
 *
 * Computed in binary64, rounded once.
 *
 * Error  1.01 u of the value, relative to |to| + |c[0]| + |c[1]| + |c[2]|; of dead blending, relative to
 *        |x| + |v h (1 - 2^(-t/half_life))| + |to|.
 * Source Holden, Dead Blending, 2023.
 */
NKW_API nkw_state nkw_offset_evaluate(const nkw_offset *offset, nkw_state to, float t);
/** The same of a vector: each component with the bits of nkw_offset_evaluate, of the coefficients of that component. */
NKW_API nkw_vec3_state nkw_vec3_offset_evaluate(const nkw_vec3_offset *offset, const nkw_vec3_state *to, float t);
/**
 * The same of a rotation.
 *
 *     inertialisation    exp(offset) to
 *     dead blending      exp((1 - s) log(difference)) to,   difference = +-old to^-1
 *
 * The old rotation of dead blending rotates on with the angular velocity of `from`, decaying. The sign of the
 * difference is that for which it continues the one of the last evaluation, and at first that of the shorter arc. So
 * the arc does not change where the motions pass half a turn from each other, as the shorter arc would; it changes
 * where they pass a whole turn. Evaluate in the order of time, in steps in which the difference turns by less than a
 * turn.
 *
 * offset   of dead blending, receives the difference
 * Returns  also the exact velocity: the derivative of the exponential and of `to`
 *
 * Error  1.01 u of the quaternion, for coefficients to 2^9 rad, and for v h below 10 rad. With the coefficients of
 *        nkw_quat_offset_begin, which are rounded to floats, the result from rest to rest is within 2.5 u.
 */
NKW_API nkw_quat_state nkw_quat_offset_evaluate(nkw_quat_offset *offset, const nkw_quat_state *to, float t);

/** A body between two steps of physics: its position and its rotation, with their velocities. */
typedef struct nkw_body_motion {
    nkw_vec3_state position;
    nkw_quat_state rotation;
} nkw_body_motion;
NKW_SIZE(nkw_body_motion, 52, 52);

/**
 * The motion between two steps of physics, for frames that are drawn between them: the position by the Hermite curve
 * with the velocities of both steps (nkw_vec3_cubic_evaluate), the rotation by that with the angular velocities
 * (nkw_rotation_from_hermite), so that a wheel of several turns in a step turns as often. Value and velocity are
 * continuous from step to step; a lerp has a corner in each.
 *
 * a, b      two consecutive steps
 * duration  seconds between them. If it is not positive and finite, the velocities of the ends count as 0, and those of
 *           the result are 0
 * t         0 at a, 1 at b; outside, the curve continues
 * Returns   exactly the position and the rotation of a at t = 0; those of b at t = 1, where the rotation may be
 *           negated
 *
 * Error  as nkw_vec3_cubic_evaluate and nkw_rotation_evaluate.
 * Stack  at most 3 KiB.
 */
NKW_API nkw_body_motion nkw_body_motion_between(const nkw_body_motion *a, const nkw_body_motion *b, float duration,
                                                float t);

#ifdef __cplusplus
}
#endif

#endif
