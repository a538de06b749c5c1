/* SPDX-License-Identifier: MIT */
/*
 * Block sizes and thresholds, each with its reason. None shows in a result: a loop over blocks returns the bits of the
 * scalar function. Sizes were measured on x86-64; they are multiples of 16, the floats of the widest register.
 */
#ifndef NAKAWARI_SIZES_H
#define NAKAWARI_SIZES_H

#include <stddef.h>

/* ---- Loops over elements ---- */

/* Normalisation: lengths of a block in the first-level cache. */
#define NORMALIZE_BLOCK 256
/* Rotations (slerp, nlerp): lengths and roots of a block in the first-level cache, 5 arrays of 1 KiB. */
#define ORIENT_BLOCK 256
/*
 * Slerp, nlerp: so many elements after the last whole register are computed as a register; one takes less time alone.
 */
#define TAIL_LEAST 2
/* Matrices that are transposed to component arrays: the floats of the widest register. */
#define MATRIX_BLOCK 16

/* ---- Poses ---- */

/* Blends: the most joints that a loop processes at once; its sums are 2.5 KiB of stack. */
#define BLEND_BLOCK 128
/* Additive poses of records: joints converted together, 2.5 KiB of stack for each pose; a multiple of 16. */
#define RECORDS_BLOCK 64
/* Blends: so many layers are sorted by weight together, with their indices on the stack. */
#define BLEND_SORTED 32
/* Blends: the most layers whose rotations, if their signs do not agree, have a mean that is continuous. */
#define BLEND_SIGNED 32
/* Models from a pose: joints whose R S are computed together; a multiple of 16, as the padding of a pose is. */
#define MODELS_BLOCK 64
/* A pose from models: local matrices that are on the stack together. */
#define LOCALS_BLOCK 16

/* ---- Clips and segments ---- */

/* Lanes in a block of keys: the widest register, so that loops over a block have no remainder. Part of the format. */
#define CLIP_BLOCK 16
/* Scattered blocks of numbers computed together: stores of one block overlap the computation of the next. */
#define CLIP_SCATTER_BLOCKS 8
/* Blocks of compact rotations that take each step together: the divisions of one overlap those of the others. */
#define CLIP_SLERP16_BLOCKS 8
/* Levels of residuals of packed keys, and the intervals of a segment: part of the format. */
#define PACKED_LEVELS 4
#define PACKED_KEYS   (1 << PACKED_LEVELS)
/* Numbers of packed keys that share their widths: fewer waste fewer bits, more take less time. Format. */
#define PACKED_COLUMNS 8
/* Numbers of a packed key, at most: a byte has the index of one, and the codes of a segment are on the stack. */
#define PACKED_SLOTS 240
/* Constant joints between animated ones, at most, that get lanes of their own: output is then contiguous. */
#define CLIP_GAP 4
/* Floats between two constants of one run, at most: they are copied with it, and animated values overwrite them. */
#define CLIP_RUN_GAP 32
/*
 * Equal constants, at least, that are stored as one value of each CLIP_FILL. Format: a pose has at most CLIP_FILL times
 * the memory of its clip.
 */
#define CLIP_FILL 32u
/* Searches: so many neighbouring keys are compared at once. */
#define SEGMENT_WINDOW ((size_t)16)
/* Searches of many times: the keys that a time is compared with first, around the last segment found. */
#define SEGMENT_NEAR_KEYS ((size_t)5)
/* So many times are found in one way; the segments of the last SEGMENT_FIRST_RUN decide on the way of the next. */
#define SEGMENT_RUN       ((size_t)128)
#define SEGMENT_FIRST_RUN ((size_t)16)
/* Times compared in each segment of a track with its clip. */
#define DIFFERENCE_QUARTERS 4

/* ---- Skinning ---- */

/* Vertices in a block: its arrays stay in the first-level cache. */
#define SKIN_BLOCK 64
/* The same where matrices are not stored and vertices have up to four influences: a block costs about 40 ns. */
#define SKIN_LONG_BLOCK (2 * SKIN_BLOCK)
/* Morph targets: vertices that all dense targets are added to together, 6 KiB. */
#define MORPH_BLOCK 512

#endif
