/* SPDX-License-Identifier: MIT */
/* The loops of crowd.c; batch/isa.h explains the list. */
#ifndef NAKAWARI_BATCH_CROWD_H
#define NAKAWARI_BATCH_CROWD_H

#include <stdint.h>

#include <nakawari/crowd.h>

#include "batch/isa.h"
#include "batch/skin.h"

/* One vector of the vertices of all characters; in is NULL where it is left out. Strides in bytes, not 0 for `in`. */
typedef struct crowd_stream {
    const unsigned char *in;
    size_t in_stride;
    unsigned char *out[NKW_CROWD];
    size_t out_stride[NKW_CROWD];
    int packed; /* the outputs of all characters */
} crowd_stream;

/* clang-format off */
#define NKW_LOOPS_CROWD(X) \
    X(nkwi_crowd_models, (const int32_t *parents, size_t joints, const float *crowd, const float *roots, float *models), (parents, joints, crowd, roots, models), NKW_WIDEST) \
    X(nkwi_crowd_bind, (const float *model, const nkw_mat4 *inverse_bind, float *out), (model, inverse_bind, out), NKW_WIDEST) \
    X(nkwi_crowd_from_poses, (const float *const *poses, size_t joints, size_t stride, float *crowd), (poses, joints, stride, crowd), NKW_WIDEST) \
    X(nkwi_crowd_to_matrices, (const float *crowd, size_t joints, nkw_mat4 *const *matrices), (crowd, joints, matrices), NKW_WIDEST) \
    X(nkwi_crowd_skin, (const skin_job *job, crowd_stream *streams), (job, streams), NKW_WIDEST)
/* clang-format on */

NKW_LOOPS_CROWD(NKW_DECLARE)

#endif
