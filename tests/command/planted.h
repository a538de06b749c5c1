/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Writes a small glTF file with values that a test changes: two joints, a skin, a triangle and one animated rotation,
 * translation and scale of the second joint.
 */
#ifndef TESTS_PLANTED_H
#define TESTS_PLANTED_H

enum { PLANTED_KEYS = 5, PLANTED_VERTICES = 3 };

typedef struct planted {
    float times[PLANTED_KEYS];
    float rotations[3 * PLANTED_KEYS][4]; /**< CUBICSPLINE: in-tangent, value, out-tangent for each key */
    float translations[PLANTED_KEYS][3], scales[PLANTED_KEYS][3];
    int cubic; /**< of the rotations */
    float rest_scale[3];
    float inverse_bind[2][16];
    unsigned short joints[PLANTED_VERTICES][4];
    float weights[PLANTED_VERTICES][4];
    int texcoord_count; /**< sets of texture coordinates, planted_texcoord */
} planted;

/** u (component 0) or v (1) of a vertex in a set, exact in binary, in 0..1, and different for each vertex and set. */
float planted_texcoord(int set, int vertex, int component);

/** A file without a fault: the joint turns by 0, 40, 10, 60 and 0 degrees, moves and grows, and returns. */
planted planted_clean(void);
/** The same with CUBICSPLINE rotations that turn by 10 degrees from key to key, with zero tangents. */
planted planted_cubic(void);
/** The rotation of a key by degrees about z. */
void planted_turn(planted *p, int key, double degrees);
/** Writes the file and its buffer, NAME.gltf and NAME.bin, into the current folder. */
void planted_write(const planted *p, const char *name);

#endif
