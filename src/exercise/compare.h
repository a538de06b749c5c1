/* SPDX-License-Identifier: MIT */
/**
 * @file
 * A student's own numbers against those of the exercise: which rows differ, and which classic mistake reproduces them.
 */
#ifndef COMPARE_H
#define COMPARE_H

#include "mistake.h"
#include "write.h"

typedef enum compare_part { COMPARE_POSITION, COMPARE_ORIENTATION, COMPARE_PARTS } compare_part;

/** What a row has of the orientation. */
typedef enum compare_form { COMPARE_NONE, COMPARE_MATRIX, COMPARE_QUATERNION, COMPARE_ANGLES } compare_form;

enum { COMPARE_UNSTATED = -1 };

/** The numbers of one time. */
typedef struct compare_row {
    size_t line; /**< in the file, from 1 */
    float time;
    int method[COMPARE_PARTS]; /**< indices in report_positions, report_orientations; COMPARE_UNSTATED */
    int has_position;
    compare_form form;
    int whole; /**< whether all 16 elements of m are the row's */
    float angles[3]; /**< yaw, pitch, roll in radians, if that is the form */
    int degrees; /**< whether they were degrees */
    nkw_mat4 m;
} compare_row;

/** The rotation Ry(yaw) Rx(pitch) Rz(roll) of the angles, radians. */
nkw_mat3 compare_rotation(const float angles[3]);

typedef struct compare_options {
    int method[COMPARE_PARTS]; /**< of rows that state none; COMPARE_UNSTATED: the one that explains most rows */
    float tolerance; /**< of an element of the matrix */
} compare_options;

/** A mistake that reproduces differing rows. */
typedef struct compare_cause {
    const mistake *mistake; /**< NULL: another method, or degrees */
    int method; /**< the other method; COMPARE_UNSTATED: degrees that were taken for radians */
    size_t reproduced; /**< of the differing rows */
    size_t agreeing; /**< of all rows */
    float worst; /**< the largest difference from a reproduced row */
} compare_cause;

enum { COMPARE_CAUSES = 3, COMPARE_FINDINGS = 16 };

/** One part of the rows of one method. */
typedef struct compare_finding {
    compare_part part;
    int method, is_guess; /**< index in its list; whether the rows do not state it */
    size_t rows, differing;
    float first, last; /**< times of differing rows */
    size_t line; /**< of the first of them */
    float worst, worst_time;
    size_t cause_count; /**< of mistakes that reproduce all differing rows and agree with most others */
    compare_cause causes[COMPARE_CAUSES]; /**< the closest first */
    compare_cause nearest; /**< without causes: the mistake that reproduces most of them, perhaps none */
} compare_finding;

typedef struct compare_result {
    int is_transposed; /**< every 4x4 matrix has its position in the last row: they were compared transposed */
    size_t count; /**< of findings */
    compare_finding findings[COMPARE_FINDINGS];
} compare_result;

/** Compares by the scene's rule. Transposes the rows that were written so. The result says whether all agree. */
int compare_rows(const scene *s, const compare_options *o, compare_row *rows, size_t count, compare_result *result);

#endif
