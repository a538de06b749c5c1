/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Many characters of one skeleton and one clip, each at its own time, and one buffer for the joint matrices of all.
 */
#ifndef TROUPE_H
#define TROUPE_H

#include <stdint.h>

#include <nakawari/clip.h>
#include <nakawari/crowd.h>
#include <nakawari/palette.h>
#include <nakawari/skeleton.h>

/** Baked frames per second. */
#define TROUPE_RATE 30

/** Everything is owned. While pieces are worked on, only `buffer` and `cursors` are written. */
typedef struct troupe {
    size_t joints, characters, frames; /* of the baked clip */
    int32_t *parents;
    nkw_skeleton skeleton;
    nkw_clip *clip;
    nkw_mat4 *inverse_bind;
    uint32_t *cursors; /* those of each character, one after the other */
    nkw_palette_chunk *chunks; /* 0: the baked clip; 1 + i: character i */
    nkw_mat4 *buffer; /* all chunks */
    size_t total; /* matrices in it */
} troupe;

/** What is worked out: the characters at a moment, or the frames of the baked clip. */
typedef enum troupe_task { TROUPE_CHARACTERS, TROUPE_FRAMES } troupe_task;

/** The steps on the way of a piece, NKW_CROWD characters or frames, one after the other or a lane for each. */
typedef enum troupe_step {
    TROUPE_SAMPLE, /**< the poses */
    TROUPE_MODELS, /**< local to model, one after the other */
    TROUPE_PALETTE, /**< joint matrices into the buffer, one after the other */
    TROUPE_ENTER, /**< the poses into the lanes */
    TROUPE_LANE_MODELS, /**< local to model, all lanes */
    TROUPE_LANE_PALETTE, /**< joint matrices, all lanes */
    TROUPE_LEAVE, /**< joint matrices out of the lanes into the buffer */
    TROUPE_STEPS
} troupe_step;

/** The working memory of one thread: what a piece is between two steps. Owned. */
typedef struct troupe_scratch {
    float *poses, *lane_poses, *lane_matrices;
    nkw_mat4 *models;
} troupe_scratch;

/** Gives NULL, or what is wrong. troupe_free is due in either case. */
const char *troupe_build(troupe *t, size_t characters, size_t joints);
void troupe_free(troupe *t);

/** Gives 0 if memory ran out. troupe_scratch_free is due in either case. */
int troupe_scratch_make(troupe_scratch *s, size_t joints);
void troupe_scratch_free(troupe_scratch *s);

size_t troupe_pieces(const troupe *t, troupe_task task);

/**
 * One step of one piece, for the moment `time`, seconds (of no matter to frames). Writes what belongs to the piece and
 * the scratch, and reads besides only what nobody writes: threads with scratches and pieces of their own need no lock.
 */
void troupe_do(const troupe *t, troupe_task task, troupe_step step, size_t piece, float time, troupe_scratch *s);

/** All steps of one piece: one after the other, or by lanes. The same bits. */
void troupe_piece(const troupe *t, troupe_task task, int lanes, size_t piece, float time, troupe_scratch *s);

/** A hash (FNV-1a over 32-bit words) of the whole buffer. */
uint64_t troupe_hash(const troupe *t);

/** Overwrites the whole buffer, so that a hash tells of what was written since. */
void troupe_clear(const troupe *t);

#endif
