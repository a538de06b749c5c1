/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Programs of the exercise as students write them, right and wrong: scene 1 in binary64 by the listings of the exercise's
 * text. They share no code with the library.
 */
#ifndef TESTS_STUDENT_H
#define TESTS_STUDENT_H

typedef enum student_slip {
    SLIP_NONE,
    SLIP_MINUS_ONE, /* (8), (10): (s - 1) as printed */
    SLIP_T_FOR_S, /* (7) */
    SLIP_T_LATER, /* the same, but only from the second group on */
    SLIP_PLUS, /* (6): t^3 + t^2 */
    SLIP_TANGENT, /* the third column, not negated */
    SLIP_EXCHANGED, /* blank B with C's weight and C with B's */
    SLIP_INTEGER, /* (13) to (16): 1/6 is 0 */
    SLIP_CONJUGATE, /* 2.4, blank B as its text says */
    SLIP_NO_BLANK_B,
    SLIP_BRACKET, /* (17): sin(1 - t) theta */
    SLIP_THETA, /* theta in degrees */
    SLIP_UNWRAP, /* 1.9 without the two ifs */
    SLIP_DEGREES, /* rotY, rotX, rotZ of degrees */
    SLIP_ORDER, /* rot.mul(rot, o) */
    SLIP_HALF_OPEN, /* time < keyframes[i + 1].time */
    SLIP_NOISE /* 0.05 is added to one number of every third row */
} student_slip;

typedef enum student_position { STUDENT_LINEAR, STUDENT_HERMITE, STUDENT_BEZIER, STUDENT_BSPLINE } student_position;
typedef enum student_orientation { STUDENT_NONE, STUDENT_EULER, STUDENT_QUAT } student_orientation;

typedef struct student {
    student_position position;
    student_orientation orientation;
    student_slip slip;
} student;

typedef struct student_pose {
    double p[3], o[3][3]; /* o[row][column] */
} student_pose;

/* The object at a time, by the exercise's UpdateModelMat. */
student_pose student_sample(const student *s, double time);

/* x, y, z, w and yaw, pitch, roll of a rotation. */
void student_quaternion(double o[3][3], double q[4]);
void student_angles(double o[3][3], double angles[3]);

#endif
