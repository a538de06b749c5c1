/* SPDX-License-Identifier: MIT */
/* BVH while it is read. */
#ifndef NAKAWARI_IMPORT_BVH_H
#define NAKAWARI_IMPORT_BVH_H

#include "document.h"

/* The number of a channel: a property times 3, plus an axis. */
enum { BVH_POSITION, BVH_ROTATION, BVH_SCALE, BVH_CHANNELS = 9 };

typedef struct nkwi_bvh_node {
    const char *name;
    int32_t parent;
    nkw_vec3 offset;
    unsigned char channels[BVH_CHANNELS]; /* in the order of the file */
    size_t channel_count, first; /* the first of them in a frame */
} nkwi_bvh_node;

typedef struct nkwi_bvh {
    nkwi_document *document;
    nkw_import_error *error;
    const char *at, *end; /* the text that is left */
    size_t line;
    nkwi_bvh_node *nodes;
    size_t node_count, node_room;
    float *values; /* of all frames */
    size_t value_count, value_room;
    size_t channel_count; /* of a frame */
    size_t stated; /* frames */
    double frame_time;
} nkwi_bvh;

/* The text: hierarchy and frames (bvh.c). */
int nkwi_bvh_parse(nkwi_bvh *b);
/* Nodes and tracks (bvh_document.c). */
int nkwi_bvh_document(nkwi_bvh *b, int adds_offset);

/* An error in the line that is read. */
int nkwi_bvh_fail(nkwi_bvh *b, const char *reason);

#endif
