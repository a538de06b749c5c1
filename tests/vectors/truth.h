/* SPDX-License-Identifier: CC0-1.0 */
/*
 * What writes the vectors: numbers in binary128 from exact binary32 inputs, by formulas that share no code with the
 * library. Needs GCC's libquadmath (tests/accuracy/wide.h).
 */
#ifndef NAKAWARI_VECTORS_TRUTH_H
#define NAKAWARI_VECTORS_TRUTH_H

#include "../accuracy/wide.h"

#if WIDE_AVAILABLE

#define ULP1 0x1p-24 /* half of the distance of floats from 1/2 on: the unit of the tolerances */

/* Begins the file NAME.txt in the folder; `about` has lines, each becomes a comment. */
void truth_open(const char *folder, const char *name, const char *const *about);
void truth_close(void);
/* A function. `arguments` and `results` are lines as in the file, ended by NULL; the tolerance is in units of 2^-24. */
void truth_group(const char *name, const char *const *lines, double units, const char *reason);
/* A case: its class, its name, and the check that replaces the comparison, or NULL. */
void truth_case(const char *kind, const char *name, const char *check);
/* The magnitude by which the tolerance is multiplied: of all results, or of each. */
void truth_scale(double scale);
void truth_sizes(const double *sizes, int n);
void truth_in(const char *name, const float *x, int n);
void truth_out(const char *name, const wide *x, int n);

/* Some floats, and some of each kind. */
random_source *truth_random(void);
/* The largest magnitude of n floats, at least 1. */
double truth_size(const float *x, int n);
/* A unit quaternion with each component rounded once, by words: x, y, z and the angle in degrees. */
void truth_turn(float x, float y, float z, float degrees, float out[4]);
void truth_some_turn(float out[4]);
/* exp(b v) from the right, and the inverse. */
void truth_append(wide q[4], const wide v[3], wide b);
void truth_inverse(const wide q[4], wide out[4]);
/* log(a^-1 b), b with the nearer sign. */
void truth_chord(const wide a[4], const wide b[4], wide v[3]);
/* b with the sign of path 0 short, 1 long, 2 as given. */
void truth_align(const wide a[4], wide b[4], int path);

void truth_curves(const char *folder);
void truth_rotations(const char *folder);
void truth_paths(const char *folder);
void truth_splines(const char *folder);
void truth_euler(const char *folder);
void truth_time(const char *folder);
void truth_poses(const char *folder);
void truth_skinning(const char *folder);
void truth_motion(const char *folder);
void truth_tracks(const char *folder);
void truth_ease(const char *folder);

#endif
#endif
