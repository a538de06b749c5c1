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
 * Dead blending continues the old motion with a velocity that decays, and blends from it to the new one.
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

/**
 * The offset of a number during a transition: (1 - u)^3 (c[0] + c[1] u + c[2] u^2), u = t/duration, and 0 from
 * t = duration on.
 */
typedef struct nkw_inertia {
    float c[3];
    float duration;
} nkw_inertia;
NKW_SIZE(nkw_inertia, 16, 16);

/** The same of a vector; of a rotation, half the rotation vector of the offset, in the outer frame. */
typedef struct nkw_vec3_inertia {
    nkw_vec3 c[3];
    float duration;
} nkw_vec3_inertia;
NKW_SIZE(nkw_vec3_inertia, 40, 40);

/**
 * Begins the transition from one motion to another.
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
 * duration  seconds. A duration that is not positive and finite ends the transition at once
 *
 * Error  1.01 u of the norm of the coefficients.
 * Source Bollo, Inertialization: High-Performance Animation Transitions in Gears of War, GDC 2018.
 */
NKW_API nkw_inertia nkw_inertia_begin(nkw_state from, nkw_state to, float duration);

/**
 * The same of a vector. T and A follow from the part of v along x, with V x / |x|^2 for V/x; the part of v at right
 * angles to x has no offset to reduce and is kept. So the velocity is continuous in all directions, and the transition
 * does not depend on the axes.
 */
NKW_API nkw_vec3_inertia nkw_vec3_inertia_begin(const nkw_vec3_state *from, const nkw_vec3_state *to, float duration);

/**
 * The same of a rotation: x = log(from to^-1) along the shorter arc, and v is its rate, which follows from both angular
 * velocities. The arc is chosen here, once: whatever the new motion does later, the result does not snap from one arc
 * to the other. For opposite rotations either arc begins at `from`.
 *
 * from, to  any lengths but 0; a zero quaternion counts as the identity. A v that passes more than 2^16 rad in T is
 *           reduced to that
 *
 * Error  1.01 u of the norm of the nine coefficients, and of the duration, for rotations of 2^-9 to 3 rad and
 *        velocities of at most 5 rad/s. Where T is reduced to -5 x/v it has the condition of that quotient: the
 *        error holds for v within 89.9 degrees of -x.
 */
NKW_API nkw_vec3_inertia nkw_quat_inertia_begin(const nkw_quat_state *from, const nkw_quat_state *to, float duration);

/**
 * The motion t seconds after the transition began, from the new motion at that time.
 *
 * to       value and velocity of the new motion; without interest in the velocity of the result, any
 * t        seconds; negative numbers and NaN count as 0
 * Returns  `from` at the start, t = 0, to rounding; exactly `to` from t = duration on
 *
 * Computed in binary64, rounded once.
 *
 * Error  1.01 u of the value, relative to |to| + |c[0]| + |c[1]| + |c[2]|.
 */
NKW_API nkw_state nkw_inertia_evaluate(nkw_inertia inertia, nkw_state to, float t);
/** The same of a vector: each component with the bits of nkw_inertia_evaluate. */
NKW_API nkw_vec3_state nkw_vec3_inertia_evaluate(const nkw_vec3_inertia *inertia, const nkw_vec3_state *to, float t);
/**
 * The same of a rotation: exp(offset) to. The velocity is exact: the derivative of the exponential and of `to`.
 *
 * Error  1.01 u of the quaternion, for coefficients to 2^9 rad. With those of nkw_quat_inertia_begin, which are rounded
 *        to floats, the result from rest to rest is within 2.5 u.
 */
NKW_API nkw_quat_state nkw_quat_inertia_evaluate(const nkw_vec3_inertia *inertia, const nkw_quat_state *to, float t);

/**
 * A transition by dead blending: the last state of the old motion, the time in seconds in which its velocity is halved,
 * and the duration of the blend. It needs no begin: fill in the four numbers.
 */
typedef struct nkw_dead_blend {
    nkw_state from;
    float half_life, duration;
} nkw_dead_blend;
NKW_SIZE(nkw_dead_blend, 16, 16);

/** The same of a vector. */
typedef struct nkw_vec3_dead_blend {
    nkw_vec3_state from;
    float half_life, duration;
} nkw_vec3_dead_blend;
NKW_SIZE(nkw_vec3_dead_blend, 32, 32);

/**
 * The same of a rotation. `difference` is the difference of both motions at the last evaluation; {0, 0, 0, 0} at
 * first, which takes the shorter arc.
 */
typedef struct nkw_quat_dead_blend {
    nkw_quat_state from;
    float half_life, duration;
    nkw_quat difference;
} nkw_quat_dead_blend;
NKW_SIZE(nkw_quat_dead_blend, 52, 52);

/**
 * The motion t seconds after the transition began, from the new motion at that time.
 *
 *     old(t) = x + v h (1 - 2^(-t/half_life)),    h = half_life/ln 2,    s = 3 u^2 - 2 u^3,    u = t/duration
 *
 *     result = old + s (to - old)
 *
 * half_life  0 and negative numbers stop the old motion at once, infinity lets it continue with its velocity
 * duration   seconds. Not positive, or NaN: the result is `to`
 * to         value and velocity of the new motion
 * t          seconds; negative numbers and NaN count as 0
 * Returns    exactly `from` at t = 0, exactly `to` from t = duration on
 *
 * Error  1.01 u of the value, relative to |x| + |v h (1 - 2^(-t/half_life))| + |to|.
 * Source Holden, Dead Blending, 2023.
 */
NKW_API nkw_state nkw_dead_blend_evaluate(const nkw_dead_blend *blend, nkw_state to, float t);
/** The same of a vector: each component with the bits of nkw_dead_blend_evaluate. */
NKW_API nkw_vec3_state nkw_vec3_dead_blend_evaluate(const nkw_vec3_dead_blend *blend, const nkw_vec3_state *to,
                                                     float t);
/**
 * The same of a rotation: the old one rotates on with the angular velocity of `from`, decaying, and
 *
 *     result = exp((1 - s) log(difference)) to,      difference = +-old to^-1
 *
 * The sign of the difference is that for which it continues the one of the last evaluation. So the arc does not change
 * where the motions pass half a turn from each other, as the shorter arc would; it changes where they pass a whole
 * turn.
 * Evaluate in the order of time, in steps in which the difference turns by less than a turn.
 *
 * blend  difference receives the difference
 *
 * Error  1.01 u of the quaternion, for v h below 10 rad.
 */
NKW_API nkw_quat_state nkw_quat_dead_blend_evaluate(nkw_quat_dead_blend *blend, const nkw_quat_state *to, float t);

/**
 * A half-life for dead blending: long where the old motion moves towards the new value, short where it moves away.
 *
 *     half_life (to - from.value) / from.velocity,      limited to least .. most
 *
 * For a vector, pass its component in the direction of the new value. A velocity of 0 and NaN return `most`.
 *
 * Source Holden, Dead Blending Node in Unreal Engine, 2023.
 */
NKW_API float nkw_dead_blend_half_life(nkw_state from, float to, float half_life, float least, float most);

/** A body between two steps of physics: its position and its rotation, with their velocities. */
typedef struct nkw_body_motion {
    nkw_vec3_state position;
    nkw_quat_state rotation;
} nkw_body_motion;
NKW_SIZE(nkw_body_motion, 52, 52);

/**
 * The motion between two steps of physics, for frames that are drawn between them: the position by the Hermite curve
 * with the velocities of both steps (nkw_vec3_cubic_evaluate), the rotation by that with the angular velocities
 * (nkw_rotation_from_hermite), so that a wheel of several turns in a step turns as often. Value and velocity are continuous
 * from step to step; a lerp has a corner in each.
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
