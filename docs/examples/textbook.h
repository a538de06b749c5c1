/* SPDX-License-Identifier: MIT */
/**
 * @file
 * The formulas of the exercise and of the lesson as their texts print them, with the slips of docs/coursework.md
 * corrected: plain C in binary64, one function a formula, nothing rearranged. To read beside the library, which
 * computes the same values with fewer roundings; test_textbook states how far the two are apart.
 */
#ifndef TEXTBOOK_H
#define TEXTBOOK_H

#include <stddef.h>

typedef struct tb_vec3 {
    double x, y, z;
} tb_vec3;

typedef struct tb_quat {
    double x, y, z, w;
} tb_quat;

/** m[row][column]: rotates the column vector v to m v. */
typedef struct tb_mat3 {
    double m[3][3];
} tb_mat3;

typedef struct tb_mat4 {
    double m[4][4];
} tb_mat4;

/** Radians: R = Ry(yaw) Rx(pitch) Rz(roll). */
typedef struct tb_angles {
    double yaw, pitch, roll;
} tb_angles;

/** Formulas (3) to (6), in the order of formula (2): of p0, p1, v0, v1. The library's order is p0, v0, p1, v1. */
void tb_hermite_weights(double t, double weight[4]);
/** Formulas (8) to (11). */
void tb_bezier_weights(double s, double weight[4]);
/** Formulas (13) to (16). */
void tb_bspline_weights(double t, double weight[4]);

/** Formula (1). */
tb_vec3 tb_linear(tb_vec3 p0, tb_vec3 p1, double t);
/** Formulas (2), (7) and (12). */
tb_vec3 tb_sum(const double weight[4], tb_vec3 p0, tb_vec3 p1, tb_vec3 p2, tb_vec3 p3);

/** Formulas (17) and (18), for the shorter arc. */
tb_quat tb_slerp(tb_quat q0, tb_quat q1, double t);
/** Of a rotation matrix: blank A of 2.4. */
tb_quat tb_quat_from_mat3(const tb_mat3 *r);
/** Of a unit quaternion: blank D of 2.4. */
tb_mat3 tb_mat3_from_quat(tb_quat q);

/** ConvMatToEuler. At a pitch of 90 degrees roll is lost. */
tb_angles tb_angles_from_mat3(const tb_mat3 *r);
/** Ry Rx Rz. */
tb_mat3 tb_mat3_from_angles(tb_angles a);
/** The program's linear interpolation: the first yaw is moved by one turn towards the second if they differ by more than pi. */
tb_angles tb_angles_lerp(tb_angles a0, tb_angles a1, double t);

tb_mat3 tb_mat3_mul(const tb_mat3 *a, const tb_mat3 *b);
tb_mat4 tb_mat4_mul(const tb_mat4 *a, const tb_mat4 *b);
/** Transposed inverse, for normals: cofactors divided by the determinant. `r` has an inverse. */
tb_mat3 tb_normal_matrix(const tb_mat3 *r);

/**
 * The lesson's chain: M[0] = T J T^-1 and M[i] = M[i-1] T J T^-1. T[i] translates by bind[i], the joint's position in the
 * model at rest; J[i] is the motion of joint i about its own origin.
 */
void tb_joint_chain(const tb_vec3 *bind, const tb_mat4 *j, size_t count, tb_mat4 *m);

#endif
