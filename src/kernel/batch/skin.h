/* SPDX-License-Identifier: MIT */
/* The loops of skin.c; batch/isa.h explains the list. */
#ifndef NAKAWARI_BATCH_SKIN_H
#define NAKAWARI_BATCH_SKIN_H

#include <nakawari/skin.h>

#include "batch/isa.h"

/* One vector of the vertices; in is NULL where it is left out. Strides in bytes, not 0. */
typedef struct skin_stream {
    const unsigned char *in;
    unsigned char *out;
    size_t in_stride, out_stride;
} skin_stream;

enum { SKIN_POSITIONS, SKIN_NORMALS, SKIN_TANGENTS, SKIN_BITANGENTS, SKIN_STREAMS };

/* The most joints of a palette: offsets of nkw_mat4 in bytes are below 2^32. */
#define SKIN_JOINTS (1u << 26)

/* One call of skinning. Formats fit, strides are not 0, influence_count is 0..8, joint_count at most SKIN_JOINTS. */
typedef struct skin_job {
    nkw_skin_view joints, weights;
    size_t vertex_count, influence_count;
    uint32_t joint_count;
    nkw_skin_options options;
    const unsigned char *palette; /* nkw_mat4 or nkw_dual_quat */
    const unsigned char *normals; /* nkw_mat3, or NULL, also with inverse_normals */
    skin_stream streams[SKIN_STREAMS];
} skin_job;

#define NKW_LOOPS_SKIN(X)                                                                                              \
    X(nkwi_skin_linear, (const skin_job *job), (job), job->vertex_count)                                               \
    X(nkwi_skin_dual_quat, (const skin_job *job), (job), job->vertex_count)

NKW_LOOPS_SKIN(NKW_DECLARE)

#endif
