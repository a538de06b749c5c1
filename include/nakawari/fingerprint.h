/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Fingerprints: 64 bits of floats, poses, clips and mixers, to find the first frame in which two machines differ.
 *
 * A fingerprint is XXH64 of 32-bit words, the lowest byte first on every machine. Equal data have equal fingerprints on
 * every port; data that differ have different ones, but for one chance in 2^64. It detects errors, not forgery.
 *
 *     from     the seed: 0, or the fingerprint of what precedes. So one number is that of a whole frame:
 *              nkw_mixer_fingerprint(&mixer, poses, joints, nkw_pose_fingerprint(pose, 0))
 *
 *     0 and -0              differ: later results can differ
 *     NaN                   every NaN is 0x7fc00000: their bits differ between compilers. Keys of clips: as they are
 *     padding of poses      is not read
 *     an array of no floats has a fingerprint too
 *
 * `nakawari diff` compares two logs of fingerprints and names the first frame that differs.
 *
 * Source Collet, xxHash fast digest algorithm, version 0.1.1, 2018, section "XXH64 algorithm description".
 */
#ifndef NAKAWARI_FINGERPRINT_H
#define NAKAWARI_FINGERPRINT_H

#include <stdint.h>

#include "clip.h"
#include "mixer.h"
#include "pose.h"
#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Of `count` floats. */
NKW_API uint64_t nkw_fingerprint_floats(const float *values, size_t count, uint64_t from);

/** Of the transforms of all joints: nkw_fingerprint_floats of each of the ten component arrays, one from the other. */
NKW_API uint64_t nkw_pose_fingerprint(nkw_pose_view pose, uint64_t from);

/**
 * Of a clip: XXH64 of its whole block, names included, as a machine of ascending byte order writes it. So it is
 * `xxhsum -H1` of a file with such a block, if `from` is 0; and two clips of the same fingerprint are the same bytes.
 *
 * Stack  at most 2 KiB.
 */
NKW_API uint64_t nkw_clip_fingerprint(const nkw_clip *clip, uint64_t from);

/**
 * Of the state of a mixer: of all that later frames depend on, but the clips. Left out are
 *
 *     free slots                                   but which of them are free
 *     cursors                                      on which no bit of a frame depends
 *     elapsed, duration                            without a transition of the pose
 *     step                                         before two poses were shown
 *     shown_at                                     the last pose that was shown comes first, wherever it is
 *     poses that were not shown, and offsets       without a transition of the pose, and before its first frame
 *     padding of all arrays
 *
 * poses    NKW_MIXER_POSES_FLOATS(joint_count) floats of the state, or NULL: they are left out
 */
NKW_API uint64_t nkw_mixer_fingerprint(const nkw_mixer *mixer, const float *poses, size_t joint_count, uint64_t from);

#ifdef __cplusplus
}
#endif

#endif
