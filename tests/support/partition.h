/* SPDX-License-Identifier: MIT */
/* Random skinned meshes, their partitions, and what holds for every partition, looked at by plain means. */
#ifndef NAKAWARI_TESTS_PARTITION_H
#define NAKAWARI_TESTS_PARTITION_H

#include "random.h"

#define MOST_TRIANGLES  600
#define MOST_VERTICES   400
#define MOST_INFLUENCES 8

/* A mesh with separate arrays. */
typedef struct mesh_data {
    nkw_partition_mesh mesh;
    uint32_t indices[3 * MOST_TRIANGLES], materials[MOST_TRIANGLES];
    uint16_t joints[MOST_VERTICES * MOST_INFLUENCES];
    float weights[MOST_VERTICES * MOST_INFLUENCES];
} mesh_data;

/* A mesh of these counts, all numbers 0. */
void mesh_shape(mesh_data *d, size_t triangles, size_t vertices, size_t influences, size_t joints);
/*
 * Vertices near joint v * joints / vertices, triangles of vertices near each other: like a body. Where the weight is 0
 * the joint does not exist. Three materials.
 */
void mesh_draw(mesh_data *d, random_source *r);
/*
 * A strip of six triangles along a chain of joints 0 1 2 3 4, the last of another material. Each vertex has one joint,
 * but for one that has two; the joint of weight 0 does not exist.
 */
void mesh_strip(mesh_data *d);
/* How many triangles need more joints. */
size_t mesh_needing_more(const nkw_partition_mesh *m, size_t max_joint_count);
/* Builds in memory of exactly the lengths of nkw_partition_bounds; fails unless the result is the one wanted. */
nkw_partition partition_build(const nkw_partition_mesh *mesh, size_t max_joint_count, nkw_result want);
void partition_free(nkw_partition *p);
/* Fails unless the partition keeps all its promises: cover, runs, order, materials, joints, vertices. */
void expect_partition(const nkw_partition_mesh *m, size_t max_joint_count, const nkw_partition *p);
/* Fails unless all counts are 0. */
void expect_nothing(const nkw_partition *p);

#endif
