/* SPDX-License-Identifier: MIT */
/** @file What is changed so that the file that is written is valid glTF, and `convert --repair`. */
#ifndef MEND_H
#define MEND_H

#include "model.h"

/**
 * Clips of other formats than glTF that begin before 0 are moved to begin at 0, which is printed on stderr. Returns 0
 * without memory.
 */
int mend_starts(model *m);
/** Notes on stderr what the writer cannot make valid: shear; of a glTF file, its own faults. */
void mend_note(const model *m);
/**
 * Mends what `check` names, and prints each change on stderr:
 *
 *     tracks     numbers that are not finite, the order of keys, doubles, lengths of quaternions, times before 0
 *     vertices   joints that are not in the skin, weights, normals
 *     skins      inverse bind matrices that are missing, transposed, or not finite: those of the rest pose
 *
 * A track without a key that can be kept has one: the rest pose. Returns 0 without memory.
 */
int mend_all(model *m);

#endif
