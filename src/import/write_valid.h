/* SPDX-License-Identifier: MIT */
/*
 * What glTF requires of numbers and other formats do not: weights of sum 1, unit normals, matrices whose last row is
 * 0 0 0 1. Values of glTF files are written as they are: their faults are theirs, and `check` of the command names them.
 */
#ifndef NAKAWARI_IMPORT_WRITE_VALID_H
#define NAKAWARI_IMPORT_WRITE_VALID_H

#include <nakawari/export.h>

/* Whether a document is not of a glTF file. */
int nkwi_valid_applies(const nkw_document *document);

/*
 * The influences of a primitive: weights of one joint are added, negative ones and those that are not finite are 0, and
 * the sum is 1 to half a step of the largest weight. A vertex without weights keeps them. `joints` and `weights` have
 * room for vertex_count * influence_count.
 */
void nkwi_valid_influences(const nkw_document_primitive *p, uint16_t *joints, float *weights);

/*
 * Unit vectors, of `width` floats each, of which the first three are a vector: 3 of normals, 4 of tangents, whose last
 * is 1 or -1. Those that are zero or not finite become `other`, vertex_count vectors of length 1.
 */
void nkwi_valid_units(const float *from, size_t width, const nkw_vec3 *other, size_t vertex_count, float *out);

/* Of each vertex the direction of the sum of its triangles' areas; 0 0 1 where that is zero. */
void nkwi_valid_faces(const nkw_document_primitive *p, nkw_vec3 *out);

/* Numbers in 0..1, of NaN 1. Returns whether any differs. */
int nkwi_valid_colors(const float *from, size_t count, float *out);

/* The same matrix of points: its last row is 0 0 0 1 if it is near a multiple of that. */
nkw_mat4 nkwi_valid_matrix(const nkw_mat4 *m);

#endif
