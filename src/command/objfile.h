/* SPDX-License-Identifier: MIT */
/** @file The files of a model as OBJ: .obj, .mtl, and the pictures that are in no file of their own. */
#ifndef OBJFILE_H
#define OBJFILE_H

#include "model.h"

/** Whether a name ends with .obj. */
int objfile_is(const char *path);

/**
 * Writes OUT.obj, the model at its time, and with materials OUT.mtl and the pictures as OUT_0.png. Prints on stderr what
 * OBJ does not have. bytes: receives the bytes of all files. Returns 0 and reports if a step fails.
 */
int objfile_write(model *m, const char *path, size_t *bytes);

#endif
