/* SPDX-License-Identifier: MIT */
/* A stand-in for cgltf.h: the names that docs/examples/gltf_cgltf.h uses, and accessors that point to floats. */
#ifndef NAKAWARI_TESTS_CGLTF_H
#define NAKAWARI_TESTS_CGLTF_H

#include <stddef.h>

typedef enum cgltf_component_type {
    cgltf_component_type_invalid,
    cgltf_component_type_r_8,
    cgltf_component_type_r_8u,
    cgltf_component_type_r_16,
    cgltf_component_type_r_16u,
    cgltf_component_type_r_32u,
    cgltf_component_type_r_32f
} cgltf_component_type;

typedef struct cgltf_accessor {
    size_t count;
    const float *floats; /* not of cgltf */
    size_t float_count;
    cgltf_component_type component_type;
} cgltf_accessor;

typedef struct cgltf_primitive {
    size_t targets_count;
} cgltf_primitive;

typedef struct cgltf_mesh {
    cgltf_primitive *primitives;
    size_t primitives_count;
    float *weights;
    size_t weights_count;
} cgltf_mesh;

typedef struct cgltf_node {
    struct cgltf_node *parent;
    cgltf_mesh *mesh;
    float *weights;
    size_t weights_count;
    int has_matrix;
    float translation[3], rotation[4], scale[3], matrix[16];
} cgltf_node;

typedef struct cgltf_skin {
    cgltf_node **joints;
    size_t joints_count;
    cgltf_accessor *inverse_bind_matrices;
} cgltf_skin;

typedef enum cgltf_animation_path_type {
    cgltf_animation_path_type_invalid,
    cgltf_animation_path_type_translation,
    cgltf_animation_path_type_rotation,
    cgltf_animation_path_type_scale,
    cgltf_animation_path_type_weights
} cgltf_animation_path_type;

typedef enum cgltf_interpolation_type {
    cgltf_interpolation_type_linear,
    cgltf_interpolation_type_step,
    cgltf_interpolation_type_cubic_spline
} cgltf_interpolation_type;

typedef struct cgltf_animation_sampler {
    cgltf_accessor *input, *output;
    cgltf_interpolation_type interpolation;
} cgltf_animation_sampler;

typedef struct cgltf_animation_channel {
    cgltf_animation_sampler *sampler;
    cgltf_node *target_node;
    cgltf_animation_path_type target_path;
} cgltf_animation_channel;

typedef struct cgltf_animation {
    cgltf_animation_channel *channels;
    size_t channels_count;
} cgltf_animation;

typedef struct cgltf_data {
    cgltf_skin *skins;
    size_t skins_count;
    cgltf_node *nodes;
    size_t nodes_count;
    cgltf_animation *animations;
    size_t animations_count;
} cgltf_data;

static inline size_t cgltf_accessor_unpack_floats(const cgltf_accessor *accessor, float *out, size_t float_count)
{
    for (size_t i = 0; out && i < float_count; i++)
        out[i] = accessor->floats[i];
    return accessor->float_count;
}

#endif
