/* SPDX-License-Identifier: MIT */
#ifndef NAKAWARI_BATCH_ROWS_H
#define NAKAWARI_BATCH_ROWS_H

#include <stddef.h>

/* The ten arrays of a pose, or of a part of one: array c begins at `at + c * stride`. */
typedef struct blend_rows {
    const float *at;
    size_t stride;
} blend_rows;
typedef struct blend_span {
    float *at;
    size_t stride;
} blend_span;

#endif
