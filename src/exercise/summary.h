/* SPDX-License-Identifier: MIT */
/** @file The numbers of the exercise as two small tables, to compare a program of one's own with. */
#ifndef SUMMARY_H
#define SUMMARY_H

#include <stdio.h>

#include "scene.h"

/** Every half second: the position by the four methods; the orientation by two, in degrees, and the angle between. */
void summary_print(FILE *f, const scene *s);

#endif
