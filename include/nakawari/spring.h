/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Springs and dampers in closed form: a value follows a goal.
 *
 * A spring accelerates a value x towards its goal g, which moves with constant velocity during a step:
 *
 *     x'' = stiffness (g - x) + damping (g' - x'),      g(t) = g(0) + g' t
 *
 * A step is the exact solution of this equation, not an integration: a step of 2h equals two steps of h, for any h,
 * except for rounding, and no step is unstable. With omega^2 = stiffness and zeta = damping / (2 omega), the spring is
 *
 *     underdamped         zeta < 1    passes the goal and oscillates
 *     critically damped   zeta = 1    the fastest spring that does not oscillate (SmoothDamp)
 *     overdamped          zeta > 1    slower, does not oscillate
 *
 * The state of a value is the value and its rate of change. The goal has both too. To follow a goal
 * whose velocity is not known, pass 0 for it. If the goal itself moves with its velocity, the spring follows it without
 * a lag, and the goal of the next step is at goal.value + h goal.velocity.
 *
 * Computed in binary64, rounded once.
 *
 * Frame rates. The state is a float, so what the frame rate changes are the roundings: of each step half an ULP (unit
 * in the last place) of the value. A step towards the goal that would round to nothing moves the value by one ULP, so
 * that it arrives. It then moves linearly, and faster than the exact solution. From that solution the value deviates,
 * in many steps, by less than
 *
 *     ULP / (1 - 2^(-h / half_life))   (damper),     ULP (1 + max(2 zeta, 1/zeta) / (omega h))   (spring)
 *
 * with the ULP of the largest value on the way, and of the largest velocity / omega. At 10,000 (ULP 2^-10) and 1000
 * steps a second with a half-life of 1 s, that is 1.4 and 1.2. Not moved are springs without damping, drag alone, and
 * with zeta < 1/2 a spring that is still accelerated towards its goal; such a spring may go on around its goal by some
 * ULPs. A rotation has the same rule with a least step of 1.25 * 2^-22 rad: a shorter step of which rounding takes more
 * than half is made that long. Values near 0 have finer floats: store large coordinates relative to a near one.
 *
 * Source Holden, Spring-It-On: The Game Developer's Spring-Roll-Call, 2021.
 */
#ifndef NAKAWARI_SPRING_H
#define NAKAWARI_SPRING_H

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * The constants of a spring: stiffness in 1/s^2, damping in 1/s. Without stiffness it is drag alone, without damping it
 * oscillates for ever; with both 0 the value keeps its velocity. A negative constant counts as 0, an infinite one as
 * the largest float.
 */
typedef struct nkw_spring {
    float stiffness, damping;
} nkw_spring;
NKW_SIZE(nkw_spring, 8, 8);

/**
 * The spring whose deviation from the goal, from rest, is halved for the first time after `half_life` seconds. The half
 * of the deviation is exact for every damping ratio; for the critically damped spring, omega = 1.6783 / half_life.
 *
 * From others: a half-life of Holden's functions is 2 ln 2 / omega, after which 0.597 of the deviation is left.
 * Multiply it by 1.2107.
 *
 * half_life      seconds; 0 and negative numbers are a jump to the goal: omega is at most 2^62 per second. Infinity is
 *                no spring, as is every omega below 2^-62 per second
 * damping_ratio  zeta, 1 for critical damping; negative numbers count as 0, numbers above 2^20 as 2^20
 * Returns        NaN constants if an argument is NaN
 *
 * Error  1.01 u of each constant.
 */
NKW_API nkw_spring nkw_spring_from_half_life(float half_life, float damping_ratio);

/**
 * The spring of `frequency` oscillations per second, if it had no damping: stiffness = (2 pi frequency)^2, damping =
 * 4 pi frequency damping_ratio.
 *
 * frequency      Hz; negative numbers count as 0, numbers above 2^60 as 2^60
 * damping_ratio  as above
 *
 * Error  1.01 u of each constant.
 */
NKW_API nkw_spring nkw_spring_from_frequency(float frequency, float damping_ratio);

/** What a spring does, in the numbers that it can be made from. */
typedef struct nkw_spring_description {
    float frequency; /**< sqrt(stiffness) / (2 pi), Hz, as nkw_spring_from_frequency takes it */
    float damping_ratio; /**< damping / (2 sqrt(stiffness)); 0 for no damping, infinity for drag alone */
    /**
     * Seconds in which the deviation from the goal, from rest, is halved for the first time, as
     * nkw_spring_from_half_life takes it. Infinity without stiffness: the deviation stays.
     */
    float half_life;
} nkw_spring_description;
NKW_SIZE(nkw_spring_description, 12, 12);

/**
 * The inverse of nkw_spring_from_frequency and of nkw_spring_from_half_life.
 *
 * Error  1.01 u of each number.
 */
NKW_API nkw_spring_description nkw_spring_describe(nkw_spring spring);

/**
 * One step of a spring: the motion after h seconds.
 *
 * from     the motion at the beginning of the step
 * goal     the goal at the beginning of the step, and its velocity
 * h        seconds; 0 and negative numbers return `from` bit for bit, infinity counts as the largest float
 * Returns  the motion after h seconds; NaN if an argument is NaN. A value at its goal, with the goal's velocity, stays
 *          there.
 *
 * Error  1.01 u of the value, relative to the sum of the magnitudes |g(h)| + |m11 (x - g)| + |m12 (x' - g')| that it
 *        consists of, and the same of the velocity, for phases w h = sqrt(stiffness - damping^2/4) h below 2^28 rad (a
 *        week at 70 oscillations a second; beyond, the phase is rounded to 2^-53 of itself); of the value one ULP
 *        where the step is less than half an ULP. Two steps of h differ from the exact step of 2h by at most 2.0 u of
 *        the magnitudes of both steps, where these are not less than half an ULP.
 */
NKW_API nkw_state nkw_spring_step(nkw_spring spring, nkw_state from, nkw_state goal, float h);

/** The same of a vector: each component with the bits of nkw_spring_step. */
NKW_API nkw_vec3_state nkw_vec3_spring_step(nkw_spring spring, const nkw_vec3_state *from,
                                             const nkw_vec3_state *goal, float h);

/**
 * The same of a rotation: the rotation vector of the error, r = 2 log(from goal^-1) along the shorter arc, is the
 * deviation that the spring reduces.
 *
 *     x(h) = exp(r(h) / 2) g(h),      g(h) = exp(goal.velocity h / 2) g(0)
 *
 * The rate of r is computed from the angular velocities, and back, by the derivative of the exponential, so that the
 * axis may turn: a step of 2h equals two of h as long as |r| stays below pi. Where the goal moves past half a turn from
 * the value, the spring changes its direction, but the rotation and its angular velocity are continuous.
 *
 * from, goal  any lengths but 0; a zero quaternion counts as the identity
 * h           as above
 * Returns     a unit quaternion; `from` bit for bit for h <= 0
 *
 * Error  1.01 u of the quaternion, for |r| and the angle that it passes below 10 rad; 3.5 u where the step turns it by
 *        less than 1.25 * 2^-22 rad.
 */
NKW_API nkw_quat_state nkw_quat_spring_step(nkw_spring spring, const nkw_quat_state *from,
                                             const nkw_quat_state *goal, float h);

/**
 * One step of exponential decay towards a goal at rest: the deviation is halved every half_life seconds.
 *
 *     x(h) = g + (x - g) 2^(-h / half_life)
 *
 * Without a state but the value, and without a continuous velocity where the goal jumps.
 *
 * half_life  seconds; 0 and negative numbers return the goal. From 2^54 h on, infinity included, nothing decays: the
 *            result is `from`, bit for bit
 * h          seconds; 0 and negative numbers return `from` bit for bit, whatever the half-life
 *
 * Error  1.01 u of |g| + |x - g|, and one ULP of the value where the step is less than half of that; two steps of h
 *        differ from the exact step of 2h by at most 2.0 u of it, where both are not less.
 */
NKW_API float nkw_damper_step(float from, float goal, float half_life, float h);
/** The same of a vector: each component with the bits of nkw_damper_step. */
NKW_API nkw_vec3 nkw_vec3_damper_step(nkw_vec3 from, nkw_vec3 goal, float half_life, float h);
/**
 * The same of a rotation: the angle of the shorter arc to the goal is halved every half_life seconds. The result has
 * the sign of `from` and is a unit quaternion; where the decay rounds to 0 it is the goal, or its negative.
 *
 * from, goal  any lengths but 0; a zero quaternion counts as the identity
 *
 * Error  1.01 u; 3.5 u where the step turns it by less than 1.25 * 2^-22 rad.
 */
NKW_API nkw_quat nkw_quat_damper_step(nkw_quat from, nkw_quat goal, float half_life, float h);

/**
 * A spring that arrives at a time: it follows a point that moves to the goal at constant velocity. The point jumps to
 * the goal damping / stiffness seconds before the time: from there on the spring slows down as it would with the goal
 * at rest.
 *
 * By itself the spring would be at b(T) at the time T, near the goal. An acceleration u is added, of all with which it
 * arrives at the goal at rest the one with the least integral of u^2. With E(t) the motion of a deviation of the spring
 * in t seconds, a matrix of 2 rows and columns (value and velocity), and e(t) its second column,
 *
 *     u(t) = e(T - t)^T l,     W(T) l = (goal, 0) - b(T),     W(t) = integral from 0 to t of e(s) e(s)^T ds
 *     state(t) = b(t) + W(t) E(T - t)^T l
 *
 * Springs that are fast beside the time are helped near the end only; without a spring the motion is the cubic of
 * Hermite from the state to the goal at rest.
 */
typedef struct nkw_spring_timed {
    nkw_spring spring;
    float time_left; /**< seconds until the arrival */
    nkw_state state; /**< what follows */
    nkw_state point; /**< what it follows: {state.value, 0} at first. Of it only the value is read */
} nkw_spring_timed;
NKW_SIZE(nkw_spring_timed, 28, 28);

/** The same of a vector. */
typedef struct nkw_vec3_spring_timed {
    nkw_spring spring;
    float time_left;
    nkw_vec3_state state, point;
} nkw_vec3_spring_timed;
NKW_SIZE(nkw_vec3_spring_timed, 60, 60);

/** The same of a rotation. */
typedef struct nkw_quat_spring_timed {
    nkw_spring spring;
    float time_left;
    nkw_quat_state state, point;
} nkw_quat_spring_timed;
NKW_SIZE(nkw_quat_spring_timed, 68, 68);

/**
 * One step of a spring that arrives at a time. The step is divided where the point jumps to the goal, so a step of 2h
 * equals two of h, except for rounding.
 *
 * timed  receives state and point at the end of the step, and time_left - h, rounded, at least one ULP less, and at
 *        least 0. Where it becomes 0, state and point are exactly {goal, 0}. Without time left, the spring follows the
 *        goal as nkw_spring_step
 * goal   where to arrive; it may change between steps
 * h      as above; 0 and negative numbers change nothing
 *
 * Error  1.01 u of s = |goal| + |state.value| + |point.value| + |state.velocity| time_left, for the value after a step;
 *        for the velocity, of s (sqrt(stiffness) + damping + 6 / time_left).
 * Source Bryson, Ho, Applied Optimal Control, 1975 (the least integral of u^2 between two states).
 */
NKW_API void nkw_spring_timed_step(nkw_spring_timed *timed, float goal, float h);
/** The same of a vector: each component with the bits of nkw_spring_timed_step. */
NKW_API void nkw_vec3_spring_timed_step(nkw_vec3_spring_timed *timed, nkw_vec3 goal, float h);
/**
 * The same of a rotation, of each component of the rotation vector 2 log(value goal^-1) and its rate; the point rotates
 * along the shorter arc to the goal. At the time the state is exactly {goal, 0}, the goal normalised.
 *
 * Stack  at most 2 KiB.
 */
NKW_API void nkw_quat_spring_timed_step(nkw_quat_spring_timed *timed, nkw_quat goal, float h);

#ifdef __cplusplus
}
#endif

#endif
