/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Contacts of feet with the ground, and feet that are locked while they are in contact.
 *
 * A foot of an animation slides a little while it stands, because the character moves at another speed than the clip.
 * While a foot is in contact its position is locked. When it leaves the ground the position returns to that of the
 * animation. No transition jumps in position or velocity. Solve the leg for the position by ik.h, with the weight of the
 * foot: a foot that follows the animation has the weight 0, and its leg stays that of the animation.
 *
 * All functions work on a state of the caller; a state of zeros begins. Positions are in world space, with the motion
 * of the root. Units: metres and seconds; any others, if the rules have the same.
 */
#ifndef NAKAWARI_FOOT_H
#define NAKAWARI_FOOT_H

#include "inertia.h"

#ifdef __cplusplus
extern "C" {
#endif

/** When a foot is in contact, and how long transitions take. */
typedef struct nkw_foot_rules {
    nkw_vec3 up; /**< the direction of heights, any length; zero: +y */
    float enter_height, leave_height; /**< above the ground */
    float enter_speed, leave_speed; /**< units per second, in all directions */
    float release_distance; /**< from the locked position to that of the animation; the lock ends beyond. 0: never */
    float duration; /**< of the transitions to and from the lock, seconds */
} nkw_foot_rules;
NKW_SIZE(nkw_foot_rules, 36, 36);

/**
 * Usual rules in metres and seconds, for the toe or the ball of a foot: contact begins below 5 cm and 0.3 m/s, and ends
 * above 10 cm or 1 m/s or 20 cm away; transitions take 0.2 s. nkw_foot_rules rules = NKW_FOOT_RULES;
 */
#define NKW_FOOT_RULES                                                                                                 \
    {                                                                                                                  \
        {0, 1, 0}, 0.05f, 0.1f, 0.3f, 1.0f, 0.2f, 0.2f                                                                 \
    }

/** The state of a foot. Zeros: nothing is known yet; set zeros again after a jump of the character. */
typedef struct nkw_foot {
    nkw_vec3 animated; /**< the position of the animation at the last update */
    nkw_vec3 locked; /**< where the foot is locked, while in contact */
    nkw_vec3 position; /**< the result of the last update */
    nkw_vec3_offset offset; /**< of the transition to the lock, an inertialisation */
    float time; /**< since it began */
    int started, contact;
    int is_assumed; /**< 1: the contact is that of the first update, and not confirmed yet */
    float released; /**< seconds since the contact ended */
    float weight; /**< 0..1, of the lock: a result of the last update, for the limb of ik.h */
    float weight_before; /**< what it was when the contact began or ended */
} nkw_foot;
NKW_SIZE(nkw_foot, 140, 140);

/**
 * Updates a foot, and returns the position at which it should be.
 *
 * The velocity of the animation is the difference from the last position, divided by h. The height is the part of the
 * position along `up`, less `ground`. Contact has hysteresis:
 *
 *     was in contact    unless height > leave_height or speed > leave_speed
 *     was not           if height <= enter_height and speed <= enter_speed
 *
 * When contact begins, the foot is locked at the position of the animation, and the result blends from the present
 * motion to the lock by nkw_vec3_offset_begin with rules->duration. When it ends, the result is between the lock and
 * the animation, and lower than neither; u is the share of the duration that has passed:
 *
 *     contact     position = lock + offset                   weight = w + (1 - w) s(u),     s(u) = u^2 (3 - 2 u)
 *     after it    position = animated + (1 - s(u)) (lock + offset - animated),       weight = w (1 - s(u))
 *
 * with w the weight at the change. After `duration` the weight is exactly 1 in contact, and else exactly 0.
 *
 * animated  the position of the foot in the animation
 * ground    the height of the ground below the foot
 * h         seconds since the last update
 * Returns   the position, and in foot->contact whether it is in contact: exactly `animated` if no contact was found
 *           yet, and `duration` after a contact; exactly the locked position in contact, after `duration`
 *
 * At the first update no velocity is known. A foot at or below enter_height is then taken to be in contact, with weight
 * 1, and is locked at `animated`. The next update in which time passes confirms this by enter_height and enter_speed;
 * else the foot is released at once, without a transition, as it has not moved. If h is not positive, no time passes and
 * the contact stays. If animated, ground or h is not finite, the state stays and the last position is returned.
 *
 * Source Holden, Inverse Kinematics and Foot Locking, 2025 (the lock).
 */
NKW_API nkw_vec3 nkw_foot_update(nkw_foot *foot, const nkw_foot_rules *rules, nkw_vec3 animated, float ground, float h);

/**
 * nkw_foot_update with contacts that are known: from a file, from the source of a retargeted motion, from a search over
 * the whole clip. Of the rules only the duration is read.
 *
 * contact  1 in contact, 0 not; at the first update too, with weight 1, and whether time passes or not
 */
NKW_API nkw_vec3 nkw_foot_update_given(nkw_foot *foot, const nkw_foot_rules *rules, nkw_vec3 animated, int contact,
                                       float h);

#ifdef __cplusplus
}
#endif

#endif
