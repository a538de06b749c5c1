/* SPDX-License-Identifier: MIT */
/** @file A model of an OBJ file as the object of the exercise. */
#ifndef COMMAND_OBJECT_H
#define COMMAND_OBJECT_H

#include "draw/object.h"

/** The most triangles: a picture has up to 321 objects. */
enum { OBJECT_TRIANGLES_MAX = 10000 };

/**
 * The triangles of a file in the colours of its materials (Kd, as stored), fitted. Errors are reported on stderr;
 * returns 0. object_free is due in either case.
 */
int object_open(object_model *model, const char *path);

#endif
