/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Root motion: the part of an animation that moves the character, taken from its root joint, and its
 * difference over a step of time, without drift over a million loops.
 *
 * The root transform of a clip is divided into the motion, by which the game moves the character, and the rest, which
 * remains in the pose:
 *
 *     root(t) = motion(t) rest(t)
 *
 * Over a step the character moves by motion(from)^-1 motion(to). Where the clip repeated k times in the step, each loop
 * adds C = motion(last) motion(first)^-1:
 *
 *     delta = motion(from)^-1 C^k motion(to),      k = cycle(to) - cycle(from), negative backwards
 *
 * C^k is a screw motion in closed form, for any k: one step over 1000 loops costs as much as one over none, and nothing
 * is accumulated. Motions are nkw_trs of scale 1. The times and cycles are those of nkw_playback_head and
 * nkw_playback_head_f64. Computed in binary64, rounded once.
 */
#ifndef NAKAWARI_ROOT_H
#define NAKAWARI_ROOT_H

#include "pose.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The parts of a root transform that become motion; combine them by |. */
typedef enum nkw_root_part {
    NKW_ROOT_PLANE = 1, /**< the translation at right angles to up */
    NKW_ROOT_HEIGHT = 2, /**< the translation along up */
    NKW_ROOT_YAW = 4, /**< the rotation about up: the twist of nkw_quat_swing_twist */
    NKW_ROOT_ROTATION = 8, /**< the whole rotation; YAW has no effect then */
    NKW_ROOT_PART_MAX_ENUM = 0x7fffffff
} nkw_root_part;

/** What becomes motion. */
typedef struct nkw_root_rule {
    nkw_vec3 up; /**< any length but 0: (0, 1, 0), (0, 0, 1). Zero or not finite: y */
    unsigned parts; /**< of nkw_root_part; 0 is no motion. Other bits have no effect */
} nkw_root_rule;
NKW_SIZE(nkw_root_rule, 16, 16);

/** A root transform in two parts: root = motion rest. */
typedef struct nkw_root_motion {
    nkw_trs motion; /**< of scale 1 */
    nkw_trs rest; /**< with the scale of the root transform */
} nkw_root_motion;
NKW_SIZE(nkw_root_motion, 80, 80);

/**
 * Splits a root transform: the motion has the parts that the rule names, the others are the identity; the rest is
 * motion^-1 root. To place the character where it is at the beginning of the clip, multiply by the inverse of the
 * motion there; nkw_root_delta and nkw_root_place do. To split a joint of a pose, store the rest in it by nkw_pose_set:
 * a joint without a parent, or with parents that do not move.
 *
 * Returns  the motion, whose rotation is unit, and the rest. A rotation by half a turn about a horizontal axis has no
 *          yaw: the identity
 *
 * Error  1.7 u of the rotation of the rest; 1.0 u of its translation, relative to |root| + |motion|; 1.0 u of the
 *        translation of the motion plus 2^-26 of that of the root, which the parts may cancel.
 */
NKW_API nkw_root_motion nkw_root_split(const nkw_root_rule *rule, const nkw_trs *root);

/**
 * Splits the keys of a root joint, in place: translations and rotations at the same times, as of two tracks with one
 * timeline. At the keys the product of motion and rest is the root. Between keys it differs where the yaw turns,
 * because a straight line about a turning frame is a curve: keep the keys dense there, as resampled tracks are. Keys of
 * CUBICSPLINE tracks are to be resampled first.
 *
 * translations, rotations  count keys; receive the rest. NULL: the identity
 * motions                  receives count motions; may be NULL
 */
NKW_API void nkw_root_split_keys(const nkw_root_rule *rule, nkw_vec3 *translations, nkw_quat *rotations,
                                 nkw_trs *motions, size_t count);

/** The motions at the first and the last key of a clip, as nkw_root_split returns them. */
typedef struct nkw_root_cycle {
    nkw_trs first, last;
} nkw_root_cycle;
NKW_SIZE(nkw_root_cycle, 80, 80);

/**
 * The motion of a step of time, in the frame of the character before the step: place(after) = place(before) delta.
 *
 *     delta = from^-1 C^cycles to,      C = last first^-1
 *
 * cycle     of the clip
 * from, to  the motions at the play heads before and after the step
 * cycles    the cycle after the step minus the cycle before it; negative for play backwards; 0 for ping-pong, which
 *           goes back to its beginning. Any number: C^cycles of a broken number is the part of the screw motion
 * Returns   a transform of scale 1. Not finite if an input is not
 *
 * A broken number of cycles takes the rotation of C along the shorter arc: divide a clip that turns by more than half a
 * turn. Whole numbers of cycles are the same along both arcs.
 *
 * Error  1.2 u of the rotation; 1.0 u of the translation, relative to itself plus 2^-10 of the ways of all cycles,
 *        |cycles| + 1 times the sum of the lengths of the translations of first and last. For |cycles| up to 2^20, 12
 *        days of cycles of one second; more cycles multiply the angle of C, of 44 bits, by more: 1.6 u at 2^22, 112 u
 *        at 2^28.
 */
NKW_API nkw_trs nkw_root_delta(const nkw_root_cycle *cycle, const nkw_trs *from, const nkw_trs *to, double cycles);

/**
 * The place of a character from the place where its clip began: without accumulation, so that it does not drift.
 *
 *     place = origin first^-1 C^number now
 *
 * Ping-pong goes back to its beginning: its cycles add no motion, so pass 0 for `number`, whatever the head's cycle is.
 *
 * cycle   of the clip
 * origin  the transform of the character at the first key of cycle 0
 * now     the motion at the play head
 * number  the cycle of the play head
 *
 * After n loops the character is at the same place, to the rounding of this result, as after n times one loop.
 *
 * Error  1.2 u, relative as nkw_root_delta.
 * Stack  at most 2 KiB.
 */
NKW_API nkw_trs nkw_root_place(const nkw_root_cycle *cycle, const nkw_trs *origin, const nkw_trs *now, double number);

/**
 * The weighted mean of motions, for clips that are blended: translations by their weighted mean, rotations by that of
 * their logarithms, which is exact about one axis.
 *
 *     translation = sum w p / W,      rotation = exp(sum w log q / W),      W = sum w,  each q with w >= 0
 *
 * motions, weights  count of each; negative weights and NaN count as 0. Weights need not sum to 1
 * Returns           the identity if no weight is positive
 *
 * Error  1.0 u of the rotation; 1.0 u of the largest translation.
 */
NKW_API nkw_trs nkw_root_blend(const nkw_trs *motions, const float *weights, size_t count);

#ifdef __cplusplus
}
#endif

#endif
