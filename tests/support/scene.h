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

#define SCENE_NODES    1024
#define SCENE_CHANNELS 16384
#define SCENE_TRACKS   2048 /* channels of one animation */
#define SCENE_FLOATS   512
#define SCENE_SKINS    96
#define SCENE_VERTICES 256

typedef struct scene_node {
    int parent, is_matrix;
    nkw_trs rest;
    nkw_mat4 matrix; /* in place of rest, if the file has it */
    size_t weights; /* the first of its morph weights among the floats of the scene */
    size_t weight_count;
} scene_node;

typedef struct scene_channel {
    int anim;
    nkw_clip_track track; /* its index: the node, or the node's first weight */
    float *times, *values;
} scene_channel;

typedef struct scene_skin {
    size_t count;
    int32_t joints[SCENE_NODES]; /* numbers in the skeleton */
    nkw_mat4 inverse_bind[SCENE_NODES];
} scene_skin;

/* Some vertices of a mesh that is skinned. */
typedef struct scene_mesh {
    int node, skin;
    size_t count;
    int index[SCENE_VERTICES];
    nkw_vec3 positions[SCENE_VERTICES];
    uint16_t joints[SCENE_VERTICES][8];
    float weights[SCENE_VERTICES][8];
} scene_mesh;

typedef struct scene {
    int nodes, channels, anims, skins, meshes;
    int32_t joint_of_node[SCENE_NODES], node_of_joint[SCENE_NODES], parents[SCENE_NODES];
    scene_skin skin[SCENE_SKINS];
    scene_mesh mesh[SCENE_SKINS];
    size_t floats; /* morph weights of all nodes */
    scene_node node[SCENE_NODES];
    scene_channel channel[SCENE_CHANNELS];
} scene;

/* Whether the folder NKW_DATA_DIR exists; otherwise prints that tests are skipped. */
int scene_folder_is_there(void);

void scene_read(const char *path, scene *s);
void scene_free(scene *s);

/* Rotation keys are normalised as they are read from now on. */
void scene_normalize_keys(scene *s);

void scene_read_floats(FILE *file, float *out, size_t n);

/* The local transforms of all nodes at the rest, as a pose. */
void scene_rest(const scene *s, float *pose);

/* The pose and the morph weights at a time of an animation, track by track over the rest; -1 is the rest. */
void scene_sample(const scene *s, int anim, float time, float *pose, float *floats);

/* A clip of an animation, to be freed. *source and tracks, SCENE_TRACKS of them, are what it was built from. */
nkw_clip *scene_clip(const scene *s, int anim, nkw_clip_format format, const float *rest, nkw_clip_track *tracks,
                     nkw_clip_source *source);

/* The world matrices of all nodes, in the order of the skeleton that the scene's nodes make. */
void scene_models(const scene *s, const float *pose, nkw_mat4 *models);

/* A file, packed or not: `path` with or without the .gz. To be closed by table_close. */
FILE *table_open(const char *path);
void table_close(FILE *file);

/* tag, animation, time, a, b and as many values as the row has. A line of another form has the tag "#". */
typedef struct table_row {
    char tag[8];
    int anim, a, b, count;
    float time, values[SCENE_FLOATS];
} table_row;

/* Reads the next row; returns 0 at the end. */
int table_read(FILE *file, table_row *r);

/* 5e-6 of the largest value in the file is adequate for binary32, as the format states; 5e-4 if keys are not unit. */
double table_bound(const char *path, int off_unit);

#ifdef __cplusplus
}
#endif

#endif
