/* SPDX-License-Identifier: MIT */
/**
 * @file
 * A mixer plays several clips at once: it advances their times, fades them, keeps them in step, blends their poses
 * in layers, and returns the pose, the floats, the motion of the root and the events of each frame.
 *
 * The set has what does not change, and belongs to the caller: clips, their events and markers, masks, the rest pose.
 * One set serves any number of mixers. A mixer is the state of one character: plain data without pointers, so that an
 * assignment saves it and another one restores it. A mixer of zeros plays nothing. It has NKW_MIXER_SLOTS slots, each
 * of which plays one clip. The caller may change `weight` and `speed` of a slot at any time: a blend tree is a program
 * that writes these weights.
 *
 * The state is advanced in closed form, from one end of a fade to the next: times, fades and the phases of groups are
 * the same after one step and after many, to the rounding of their sums in binary64.
 *
 * Example  nkw_mixer mixer; nkw_mixer_set set; nkw_mixer_options options; nkw_mixer_frame frame; nkw_work work;
 *          size_t slot, bad;
 *
 *     nkw_mixer_set_validate(&set, &bad);                          which clip is wrong
 *     nkw_mixer_play(&mixer, &set, &options, &slot);               cross-fade to a clip
 *     nkw_mixer_stop(&mixer, slot, 0.2f);                          fades it out
 *     nkw_mixer_advance(&mixer, &set, 1.0 / 60.0, &frame, work);   the next frame: pose, motion, events
 *     nkw_mixer_validate(&mixer, &set, &bad);                      of a state that was received
 */
#ifndef NAKAWARI_MIXER_H
#define NAKAWARI_MIXER_H

#include <stdint.h>

#include "blend.h"
#include "clip.h"
#include "playback.h"
#include "pose.h"
#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- What does not change ---- */

/** A mark in a clip: an instant, or an interval if the duration is positive. */
typedef struct nkw_mixer_mark {
    float time; /**< seconds, as the key times of the clip are */
    float duration; /**< seconds; 0 for an instant */
} nkw_mixer_mark;
NKW_SIZE(nkw_mixer_mark, 8, 8);

/** A clip of a set. Zeros are the usual choice for all members but the clip. */
typedef struct nkw_mixer_clip {
    const nkw_clip *clip;
    /** What an additive slot is relative to; data NULL: the clip at `start`. */
    nkw_pose_view reference;
    const nkw_mixer_mark *events; /**< in any order */
    size_t event_count;
    const float *markers; /**< for NKW_MIXER_SYNC_MARKERS: ascending times in [start, end) */
    size_t marker_count;
    float start, end; /**< the part that is played, in seconds; both 0: the whole clip */
} nkw_mixer_clip;
NKW_SIZE(nkw_mixer_clip, 64, 36);

/** What mixers play. */
typedef struct nkw_mixer_set {
    const nkw_mixer_clip *clips;
    size_t clip_count;
    const nkw_mask_view *masks; /**< an entry without data is the whole body */
    size_t mask_count; /**< 0: mask 0 is the whole body */
    nkw_pose_view rest; /**< of the joints of all clips; what has no weight is at rest */
    const float *rest_floats; /**< float_count floats; NULL: zeros */
    size_t float_count; /**< the separate floats of all clips */
    size_t root; /**< the joint whose motion moves the character, without moving parents */
    nkw_vec3 up; /**< for its motion: of nkw_root_rule in root.h */
    uint32_t root_parts; /**< of nkw_root_part in root.h; 0: the root stays in the pose */
} nkw_mixer_set;
NKW_SIZE(nkw_mixer_set, 88, 52);

/* ---- The state ---- */

/** The slots of a mixer: the clips that play at the same time, those that fade out included. */
#define NKW_MIXER_SLOTS 16

/** The cursors of a slot. A clip of more timelines than these is searched in each frame. */
#define NKW_MIXER_CURSORS 8

/** How a slot is mixed. Any other number is read as NKW_MIXER_BLEND. */
typedef enum nkw_mixer_blend {
    NKW_MIXER_BLEND, /**< weighted mean with the slots of its layer, over the layers below */
    NKW_MIXER_ADD, /**< added to its layer, as nkw_pose_additive_apply does, relative to the reference of its clip */
    NKW_MIXER_BLEND_MAX_ENUM = 0x7fffffff
} nkw_mixer_blend;

/** How the slots of a group keep in step. Any other number is read as NKW_MIXER_SYNC_LENGTH. */
typedef enum nkw_mixer_sync {
    NKW_MIXER_SYNC_LENGTH, /**< all cycles take the same time; each slot keeps its phase */
    NKW_MIXER_SYNC_PHASE, /**< the phase is that of the leader */
    NKW_MIXER_SYNC_MARKERS, /**< between the same markers as the leader; PHASE if their numbers differ or are 0 */
    NKW_MIXER_SYNC_MAX_ENUM = 0x7fffffff
} nkw_mixer_sync;

/** How the clip begins. Unknown numbers are refused. */
typedef enum nkw_mixer_transition {
    NKW_MIXER_CROSS_FADE, /**< it fades in, and the other blended slots of its layer fade out */
    NKW_MIXER_FADE_IN, /**< it fades in; no other slot is changed */
    NKW_MIXER_INERTIA, /**< at once, with the whole pose inertialised from the one that was last shown */
    NKW_MIXER_DEAD_BLEND, /**< at once, with a dead blend of the whole pose */
    NKW_MIXER_TRANSITION_MAX_ENUM = 0x7fffffff
} nkw_mixer_transition;

/** A weight that changes at a constant rate: from + (to - from) min(elapsed / duration, 1). */
typedef struct nkw_mixer_fade {
    double elapsed, duration; /**< seconds; a duration of 0 is `to` */
    float from, to; /**< a slot with to = 0 is freed at the end of its fade */
} nkw_mixer_fade;
NKW_SIZE(nkw_mixer_fade, 24, 24);

/** A slot: a clip that plays. All but weight and speed is written by the functions. */
typedef struct nkw_mixer_slot {
    double time; /**< running seconds since `start` of the clip; not wrapped */
    nkw_mixer_fade fade;
    double cycle; /**< of `motion` */
    nkw_trs motion, first, last; /**< of the root: where the slot is, at the start and the end of its clip */
    float weight; /**< multiplied by the fade; negative and NaN count as 0, above 2^60 as 2^60 */
    float speed; /**< seconds of the clip per second; negative plays backwards, what is not finite counts as 0 */
    uint32_t playing; /**< 0: the slot is free; 1 before its first frame, 2 from then on */
    uint32_t clip, mask; /**< of the set */
    uint32_t layer; /**< slots of higher layers cover those of lower ones */
    uint32_t group; /**< 0: not in step with other slots */
    nkw_mixer_sync sync;
    nkw_playback mode;
    nkw_mixer_blend blend;
    uint32_t cursors[NKW_MIXER_CURSORS]; /**< of nkw_clip_sample; any numbers */
} nkw_mixer_slot;
NKW_SIZE(nkw_mixer_slot, 232, 232);

/** A mixer. */
typedef struct nkw_mixer {
    nkw_mixer_slot slot[NKW_MIXER_SLOTS];
    double elapsed, duration; /**< of the transition of the pose, in seconds */
    float step; /**< seconds between the last two poses that were shown */
    uint32_t slot_count; /**< the slots from this one on are free */
    nkw_mixer_transition transition; /**< NKW_MIXER_CROSS_FADE: none */
    uint32_t pending; /**< 1: it begins with the next frame */
    uint32_t shown; /**< poses that were shown, 2 for more: the place of the last is shown_at */
    uint32_t shown_at;
} nkw_mixer;
NKW_SIZE(nkw_mixer, 3752, 3752);

/**
 * Floats in the poses of a mixer that uses NKW_MIXER_INERTIA or NKW_MIXER_DEAD_BLEND: the last two poses and the
 * offsets of the joints. They are a part of the state: saved and restored with it.
 */
#define NKW_MIXER_POSES_FLOATS(joint_count) (50 * NKW_POSE_STRIDE(joint_count))

/* ---- A frame ---- */

typedef enum nkw_mixer_event_kind {
    NKW_MIXER_PASSED, /**< an instant */
    NKW_MIXER_ENTERED, /**< an interval begins; backwards, at its end */
    NKW_MIXER_LEFT, /**< an interval ends; backwards, at its time; or its slot is freed within it */
    NKW_MIXER_EVENT_KIND_MAX_ENUM = 0x7fffffff
} nkw_mixer_event_kind;

/** An event. */
typedef struct nkw_mixer_event {
    uint32_t slot, clip, event;
    nkw_mixer_event_kind kind;
    float weight; /**< of the slot, at the end of the step */
    float moment; /**< seconds since the beginning of the step, as if the slot had moved at a constant rate */
} nkw_mixer_event;
NKW_SIZE(nkw_mixer_event, 24, 24);

/** The arrays that receive a frame, and what it has. */
typedef struct nkw_mixer_frame {
    nkw_pose_span pose;
    float *floats; /**< float_count floats of the set; may be NULL */
    float *poses; /**< NKW_MIXER_POSES_FLOATS of the state; NULL: no transition but by fades */
    nkw_mixer_event *events; /**< event_capacity events; may be NULL if that is 0 */
    size_t event_capacity;
    size_t event_count; /**< receives the number of events, which may be greater than the capacity */
    nkw_trs motion; /**< receives the motion of the step, in the frame of the character before it; of scale 1 */
} nkw_mixer_frame;
NKW_SIZE(nkw_mixer_frame, 96, 68);

/** How a clip is played. Zeros are the usual choice. Weight and speed of the slot are 1: change them in the slot. */
typedef struct nkw_mixer_options {
    uint32_t clip, mask; /**< of the set */
    uint32_t layer, group; /**< of nkw_mixer_slot */
    nkw_playback mode;
    nkw_mixer_blend blend;
    nkw_mixer_sync sync; /**< with the slots of the group */
    nkw_mixer_transition transition;
    float fade; /**< seconds of the transition; 0 is a cut */
    float time; /**< seconds after `start` of the clip */
} nkw_mixer_options;
NKW_SIZE(nkw_mixer_options, 40, 40);

/**
 * Checks a set: each clip, then the masks, then the root.
 *
 * Returns  NKW_EMPTY for a rest pose without data or joints and for a clip that is NULL; NKW_MISMATCHED for another
 *          number of joints or floats; NKW_NOT_FINITE for times that are not finite; NKW_OUT_OF_RANGE for an end before
 *          the start, for events of negative duration, for markers outside [start, end), and for a root that is not a
 *          joint; NKW_NOT_ASCENDING for markers that do not ascend; the results of nkw_mask_validate. *bad becomes the
 *          index of the first offending clip or mask, 0 if there is none; it may be NULL
 */
NKW_API nkw_result nkw_mixer_set_validate(const nkw_mixer_set *set, size_t *bad);

/**
 * Begins to play a clip in a free slot. It is seen in the next frame.
 *
 *     transition    the new slot          other slots of its layer (NKW_MIXER_BLEND)   the pose
 *     CROSS_FADE    fades from 0 to 1     fade to 0                                    is blended
 *     FADE_IN       fades from 0 to 1     unchanged                                    is blended
 *     INERTIA       1                     freed in the next frame                      nkw_pose_inertia_begin
 *     DEAD_BLEND    1                     freed in the next frame                      nkw_pose_dead_blend_begin
 *
 * All fades of a cross-fade are linear and end together: weights that sum to 1 continue to do so. A slot that joins a
 * group takes its phase from the first slot of the group, for PHASE and MARKERS. A dead blend halves the velocity of
 * the old motion in a quarter of its duration.
 *
 * slot     receives the slot; may be NULL
 * Returns  NKW_OUT_OF_RANGE for an unknown clip or mask and for a negative fade; NKW_BAD_METHOD for an unknown mode,
 *          blend, sync or transition; NKW_NOT_FINITE for a fade or a time that is not finite; NKW_EMPTY and
 *          NKW_MISMATCHED for the clip, as nkw_mixer_set_validate; NKW_TOO_MANY if no slot is free; nothing is then
 *          changed
 */
NKW_API nkw_result nkw_mixer_play(nkw_mixer *mixer, const nkw_mixer_set *set, const nkw_mixer_options *options,
                                  size_t *slot);

/**
 * Fades a slot out. It is freed at the end of the fade; a fade of 0 s ends with the next frame.
 *
 * Returns  NKW_OUT_OF_RANGE for an unknown or free slot and for a negative fade, NKW_NOT_FINITE for a fade that is not
 *          finite; nothing is then changed
 */
NKW_API nkw_result nkw_mixer_stop(nkw_mixer *mixer, size_t slot, float fade);

/**
 * The bytes of working memory of nkw_mixer_advance, for at most `slot_count` slots that play in one layer at a time;
 * at least 1, at most NKW_MIXER_SLOTS.
 */
#define NKW_MIXER_WORK(slot_count, joint_count, float_count)                                                           \
    (4 * (((slot_count) + 4) * NKW_POSE_FLOATS(joint_count) + 3 * (float_count)))

/**
 * Advances all slots by `seconds` and mixes the frame at their new times.
 *
 * Time. A slot advances by speed times seconds; its time in the clip is nkw_playback_head_f64 of that, with its mode
 * before and after. The slots of a group (of positive length) advance by the same number of cycles,
 *
 *     integral of  sum w speed / sum w length  over the step,     w the weights with their fades
 *
 * The first slot of the group is its leader. Fades that end within the step end at their own time, and then free their
 * slots.
 *
 * Pose. From the lowest layer to the highest, from the rest pose on:
 *
 *     pose = nkw_pose_layers_blend(blended slots, rest = pose, threshold = 1 - 2^-20)
 *     pose = nkw_pose_additive_apply(pose, delta, NKW_ADDITIVE_LOCAL) of each added slot
 *
 * So weights below 1 let the layers below through, and of a sum above 1 each slot has its share. One slot of weight 1
 * is nkw_clip_sample, two of weights that sum to 1 are nkw_pose_blend, bit for bit. Floats are mixed in the same way,
 * without masks. Then a transition of the pose (INERTIA, DEAD_BLEND) is applied.
 *
 * Motion. If the set has root parts, the root joint of each sample has the rest of nkw_root_split, and `motion` is
 * nkw_root_blend of the nkw_root_delta of the blended slots of layer 0, by their weights at the end of the step times
 * their masks at the root. What they lack to 1 does not move. Cycles of a loop continue; ping-pong goes and returns.
 *
 * Events. Each event of a slot is reported exactly once each time its clip passes it, however the steps divide the
 * time: forward in (before, after], backwards in [after, before); in the first frame also at the time where the slot
 * begins, and the intervals in which it begins. Freed slots leave their intervals. In a loop, an interval of whole
 * cycles, to 2^-23 of its duration, is left when it is entered again. The order is by moments, then by slots, then by
 * events; of too many the first ones are stored.
 *
 * frame    pose: of set->rest.joint_count joints
 * seconds  at least 0 and at most 2^30. 0 mixes the frame again
 * Returns  NKW_OUT_OF_RANGE for other seconds and for a root that is not a joint; NKW_NOT_FINITE for NaN; NKW_EMPTY
 *          without a rest pose; NKW_MISMATCHED for a pose with another number of joints; NKW_TOO_SMALL for too little
 *          working memory, and for frame->poses NULL while a transition of the pose is running; the results of
 *          nkw_mixer_validate; nothing is then changed
 *
 * Error  of times, for each step and each fade that ends in it: 2^-53 of the time; in groups also 2^-44 of the way at
 *        the fastest rate within the step.
 * Stack  at most 19 KiB.
 */
NKW_API nkw_result nkw_mixer_advance(nkw_mixer *mixer, const nkw_mixer_set *set, double seconds, nkw_mixer_frame *frame,
                                     nkw_work work);

/**
 * Checks a state that was received or read, against its set.
 *
 * Returns  NKW_OUT_OF_RANGE for a clip, a mask or a place that does not exist; NKW_NOT_FINITE for a time or a fade that
 *          is not finite; NKW_BAD_METHOD for an unknown transition; NKW_EMPTY and NKW_MISMATCHED for clips and masks of
 *          other joints or floats. *bad becomes the first offending slot, 0 if there is none; it may be NULL
 */
NKW_API nkw_result nkw_mixer_validate(const nkw_mixer *mixer, const nkw_mixer_set *set, size_t *bad);

#ifdef __cplusplus
}
#endif

#endif
