/* SPDX-License-Identifier: MIT */
/*
 * A property of a node as a track: STEP where it only jumps, LINEAR where lines follow it, otherwise CUBICSPLINE. A
 * cubic segment has the curve at its ends and at 3/8 and 5/8, so cubic curves are exact; segments are halved until the
 * curve is within the tolerance at each eighth.
 */
#ifndef NAKAWARI_IMPORT_FBX_BAKE_H
#define NAKAWARI_IMPORT_FBX_BAKE_H

#include <nakawari/track.h>

#include "fbx.h"

/* The times at which a property may have a kink or a jump, ascending. */
/*
 * What a property may do at a time. JUMP: its value is that after a jump. AFTER: it jumps behind the time, at the next
 * float. SEAM: a jump where a cycle begins, whose time is rounded.
 */
enum { NKWI_FBX_JUMP = 1, NKWI_FBX_SEAM = 2, NKWI_FBX_AFTER = 4 };

typedef struct nkwi_fbx_time {
    float time;
    unsigned char may_jump;
    uint32_t curve; /* whose key it is */
} nkwi_fbx_time;

typedef struct nkwi_fbx_times {
    nkwi_fbx_time *list;
    size_t count, room;
    uint32_t curves;
    size_t channels; /* of curves, or of values without */
    float start, stop;
    size_t outside; /* keys before the start or after the stop */
    int failed; /* no memory */
} nkwi_fbx_times;

/* Adds a time of the curve `curves`, if it is between the start and the stop. */
void nkwi_fbx_add_time(nkwi_fbx_times *times, float time, int may_jump);
/* Adds the keys of a property and of the weights of its layers, repeated where curves repeat. */
void nkwi_fbx_add_times(nkwi_fbx_times *times, const nkwi_fbx_animated *a);
/* Sorts them; those within a microsecond become one; adds the start and the stop. */
void nkwi_fbx_sort_times(nkwi_fbx_times *times);

typedef struct nkwi_fbx_source {
    void (*sample)(void *user, float time, float *out); /* `width` numbers */
    void *user;
    size_t width; /* at most NKWI_FBX_WIDTH */
    int is_rotation;
    nkwi_fbx_times *times; /* at which it may not jump after all: they are changed */
} nkwi_fbx_source;

enum { NKWI_FBX_WIDTH = 512 };

/* The largest difference to the curves: radians for rotations, otherwise times the largest number of the track. */
#define NKWI_FBX_TOLERANCE 4e-6f

typedef struct nkwi_fbx_baked {
    float *times, *values; /* to be freed */
    size_t count, room, added; /* added: keys at times of no key of the file */
    size_t width; /* floats of a key */
    nkw_interpolation interpolation;
    float difference; /* the largest that was found, except of spins */
    size_t spins; /* turns by about 360 degrees from one frame to the next, which are left out */
} nkwi_fbx_baked;

/* Returns 0 without memory. nkwi_fbx_baked_free also then. */
int nkwi_fbx_bake(const nkwi_fbx_source *source, nkwi_fbx_baked *out);
void nkwi_fbx_baked_free(nkwi_fbx_baked *baked);

#endif
