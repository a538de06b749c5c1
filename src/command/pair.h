/* SPDX-License-Identifier: MIT */
/** @file Which joints and clips of two documents are the same: those of equal name, in their order. */
#ifndef PAIR_H
#define PAIR_H

#include "command.h"

/**
 * The partner of each joint of a in b and back, or NKW_NO_JOINT: the first joint of b with the same name that has no
 * partner yet, in the order of nodes. Returns 0 and reports without memory.
 */
int pair_joints(const nkw_document *a, const nkw_document *b, int32_t *partner, int32_t *back);

/** The clip of b for clip i of a: of the same name, as many before it having that name; SIZE_MAX if there is none. */
size_t pair_clip(const nkw_document *a, size_t i, const nkw_document *b);

#endif
