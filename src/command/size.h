/* SPDX-License-Identifier: MIT */
/** @file The bytes of clips. */
#ifndef SIZE_H
#define SIZE_H

#include "extent.h"

/** Bytes as NKW_CLIP_FLOAT32 and as NKW_CLIP_UNORM16; SIZE_MAX where the library refuses the keys. */
typedef struct clip_size {
    size_t clip, compact;
} clip_size;

clip_size size_of_clip(const nkw_document *d, size_t animation);
/** One sixteenth of what 16 such channels add to a clip without tracks: its keys, and its share of the key times. */
clip_size size_of_channel(const nkw_document *d, size_t animation, size_t track);

/**
 * The clip that nkw_clip_reduce builds within a distance in model space, at the reach of each joint; of morph weights
 * within the same share of 1 as the distance is of the model's size. NULL, and SIZE_MAX bytes, if the library refuses
 * the keys or there is no memory.
 */
void *reduced_clip(const nkw_document *d, size_t animation, const extent *e, float tolerance, size_t *bytes);
/** Its bytes. */
size_t size_of_reduced(const nkw_document *d, size_t animation, const extent *e, float tolerance);

#endif
