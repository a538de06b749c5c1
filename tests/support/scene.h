/* SPDX-License-Identifier: MIT */
/*
 * Animated models as text, and tables of what they should come out as. The format stands beside the files, which are
 * not in the repository. A file that cannot be read fails the test.
 */
#ifndef NAKAWARI_TESTS_SCENE_H
#define NAKAWARI_TESTS_SCENE_H

#include <stdio.h>

#include <nakawari/nakawari.h>

#ifdef __cplusplus
extern "C" {
#endif

#define SCENE_NODES    64
#define SCENE_CHANNELS 80
#define SCENE_FLOATS   64

typedef struct scene_node {
    int parent, is_matrix;
    nkw_trs rest;
    nkw_mat4 matrix; /* in place of rest, where the file gives it */
    size_t weights; /* the first of its morph weights among the floats of the scene */
    size_t weight_count;
} scene_node;

typedef struct scene_channel {
    int anim;
    nkw_clip_track track; /* its index: the node, or the node's first weight */
    float *times, *values;
} scene_channel;

typedef struct scene {
    int nodes, channels, anims;
    size_t floats; /* morph weights of all nodes */
    scene_node node[SCENE_NODES];
    scene_channel channel[SCENE_CHANNELS];
} scene;

void scene_read(const char *path, scene *s);
void scene_free(scene *s);

void scene_read_floats(FILE *file, float *out, size_t n);

/* The local transforms of all nodes at the rest, as a pose. */
void scene_rest(const scene *s, float *pose);

/* The pose and the morph weights at a time of an animation, track by track over the rest; -1 is the rest. */
void scene_sample(const scene *s, int anim, float time, float *pose, float *floats);

/* A clip of an animation, to be freed. *source and tracks, SCENE_CHANNELS of them, are what it was built from. */
nkw_clip *scene_clip(const scene *s, int anim, nkw_clip_format format, const float *rest, nkw_clip_track *tracks,
                     nkw_clip_source *source);

/* The node's world matrix, from a pose. */
nkw_mat4 scene_world(const scene *s, const float *pose, int node);

/* A table of expected values, packed or not: `path` without the .gz. To be closed by table_close. */
FILE *table_open(const char *path);
void table_close(FILE *file);

/* tag, animation, time, a, b and as many values as the row has. A line of another form has the tag "#". */
typedef struct table_row {
    char tag[8];
    int anim, a, b, count;
    float time, values[16];
} table_row;

/* The next row; gives 0 at the end. */
int table_read(FILE *file, table_row *r);

#ifdef __cplusplus
}
#endif

#endif
