/* SPDX-License-Identifier: MIT */
/*
 * Poses and masks of 1 to 70 joints, and as many vertices, by the loops of each instruction set. What is behind the last
 * joint of an array, identities, signalling NaNs or memory that was never written, shows in no result, raises no
 * exception, and no memory checker (the presets msan and memcheck) sees a decision by it.
 *
 * A plain program, as parity.c is.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/nakawari.h>

#include "../support/exceptions.h"
#include "../support/hash.h"
#include "../support/isas.h"
#include "../support/random.h"
#include "../support/random_clip.h"
#if defined(STACK_PHASES)
static nkwi_isa loop_isa; /* the library's own choice */
#else
#include "../support/loops.h"
#endif
#include "../support/views.h"

enum { MOST = 70, POSES = 3, INFLUENCES = 4, WORDS = 1 << 15 };

typedef enum padding { IDENTITIES, SIGNALLING, UNWRITTEN } padding;

/* Arrays of the sizes that the joints ask for, each in memory of its own. */
typedef struct scene {
    size_t joints;
    float *poses[POSES], *masks[POSES], *out, *delta, *crowd, *lanes, *inertia, *dead;
    nkw_mat4 *models, *palette;
    nkw_mat3 *normals;
    nkw_dual_quat *duals;
    float *vectors[3], *skinned[3], *weights;
    uint16_t *indices;
    int32_t *parents;
} scene;

static void *memory(size_t bytes)
{
    void *m = malloc(bytes);
    if (!m)
        abort();
    return m;
}

static float *floats(size_t count)
{
    return (float *)memory(count * sizeof(float));
}

/* The padding of `rows` arrays; of identities, 1 from row `ones` on. */
static void pad(float *data, size_t rows, size_t ones, size_t joints, padding kind)
{
    const uint32_t signalling = 0x7fa00000u;
    const size_t stride = NKW_POSE_STRIDE(joints);
    for (size_t c = 0; c < rows && kind != UNWRITTEN; c++)
        for (size_t j = joints; j < stride; j++) {
            const float one = c >= ones ? 1.0f : 0.0f;
            memcpy(&data[c * stride + j], kind == IDENTITIES ? (const void *)&one : (const void *)&signalling,
                   sizeof one);
        }
}

/* Some scales are zero, some rotations equal. */
static void draw_pose(random_source *r, const scene *s, size_t k)
{
    for (size_t j = 0; j < s->joints; j++) {
        nkw_trs trs = {random_vec3(r, -5, 5), random_rotation(r), random_vec3(r, -2, 2)};
        if (j % 5 == 2)
            trs.scale.y = 0.0f;
        if (k > 0 && j % 3 == 1)
            trs.rotation = nkw_pose_get(pose_view(s->poses[0], s->joints), j).rotation;
        nkw_pose_set(pose_span(s->poses[k], s->joints), j, &trs);
        s->masks[k][j] = random_bits(r) % 4 == 0 ? (float)(random_bits(r) % 2) : random_unit(r);
    }
}

static void draw_vertices(random_source *r, scene *s)
{
    for (size_t i = 0; i < 3 * s->joints; i++)
        for (size_t k = 0; k < 3; k++)
            s->vectors[k][i] = k && i / 3 % 7 == 3 ? 0.0f : random_between(r, -1, 1);
    for (size_t i = 0; i < INFLUENCES * s->joints; i++) {
        s->weights[i] = i / INFLUENCES % 11 == 5 ? 0.0f : random_unit(r);
        s->indices[i] = (uint16_t)(random_bits(r) % (s->joints + 1));
    }
}

static scene scene_of(size_t joints, padding kind)
{
    const size_t stride = NKW_POSE_STRIDE(joints);
    random_source r = random_from(70 + joints);
    scene s;
    s.joints = joints;
    for (size_t k = 0; k < POSES; k++) {
        s.poses[k] = floats(10 * stride), s.masks[k] = floats(stride);
        pad(s.poses[k], 10, 6, joints, kind), pad(s.masks[k], 1, 0, joints, kind);
        s.vectors[k] = floats(3 * joints), s.skinned[k] = floats(3 * joints);
    }
    s.out = floats(10 * stride), s.delta = floats(10 * stride);
    pad(s.out, 10, 6, joints, kind), pad(s.delta, 10, 6, joints, kind);
    s.crowd = floats(NKW_CROWD_POSE_FLOATS(joints)), s.lanes = floats(NKW_CROWD_MATRIX_FLOATS(joints));
    s.inertia = floats(NKW_POSE_INERTIA_FLOATS(joints)), s.dead = floats(NKW_POSE_DEAD_BLEND_FLOATS(joints));
    s.models = (nkw_mat4 *)memory(joints * sizeof *s.models), s.palette = (nkw_mat4 *)memory(joints * sizeof *s.palette);
    s.normals = (nkw_mat3 *)memory(joints * sizeof *s.normals), s.duals = (nkw_dual_quat *)memory(joints * sizeof *s.duals);
    s.weights = floats(INFLUENCES * joints), s.indices = (uint16_t *)memory(INFLUENCES * joints * sizeof *s.indices);
    s.parents = (int32_t *)memory(joints * sizeof *s.parents);
    for (size_t j = 0; j < joints; j++)
        s.parents[j] = (int32_t)j - 1 - (int32_t)(random_bits(&r) % 4);
    for (size_t k = 0; k < POSES; k++)
        draw_pose(&r, &s, k);
    draw_vertices(&r, &s);
    return s;
}

static void free_scene(const scene *s)
{
    for (size_t k = 0; k < POSES; k++)
        free(s->poses[k]), free(s->masks[k]), free(s->vectors[k]), free(s->skinned[k]);
    free(s->out), free(s->delta), free(s->crowd), free(s->lanes), free(s->inertia), free(s->dead);
    free(s->models), free(s->palette), free(s->normals), free(s->duals);
    free(s->weights), free(s->indices), free(s->parents);
}

static nkw_pose_view pose_of(const scene *s, size_t k)
{
    return pose_view(s->poses[k], s->joints);
}

static uint64_t hash_blends(const scene *s)
{
    static const float ts[] = {0.0f, 0.25f, 0.75f, 1.0f, 1.5f};
    const nkw_pose_span out = pose_span(s->out, s->joints);
    uint64_t hash = HASH_START;
    for (size_t i = 0; i < 2 * sizeof ts / sizeof *ts; i++) {
        const nkw_mask_view mask = mask_view(i % 2 ? s->masks[0] : NULL, s->joints);
        nkw_pose_blend(pose_of(s, 0), pose_of(s, 1), ts[i / 2], mask, out);
        hash = nkw_pose_fingerprint(pose_view(s->out, s->joints), hash);
        nkw_pose_blend_slerp(pose_of(s, 0), pose_of(s, 1), ts[i / 2], mask, out);
        hash = nkw_pose_fingerprint(pose_view(s->out, s->joints), hash);
    }
    return hash;
}

static uint64_t hash_layers(const scene *s)
{
    uint64_t hash = HASH_START;
    for (unsigned i = 0; i < 16; i++) {
        nkw_pose_layer layers[POSES];
        for (unsigned k = 0; k < POSES; k++) {
            layers[k].pose = pose_of(s, k);
            layers[k].weight = i & 1 ? 0.25f : 0.5f - 0.125f * (float)k;
            layers[k].mask = mask_view(i & 2 ? s->masks[k] : NULL, s->joints);
        }
        nkw_pose_layers_blend(layers, i >> 2, pose_of(s, 2), 0.75f, pose_span(s->out, s->joints));
        hash = nkw_pose_fingerprint(pose_view(s->out, s->joints), hash);
    }
    return hash;
}

static uint64_t hash_differences(const scene *s)
{
    uint64_t hash = HASH_START;
    for (int i = 0; i < 4; i++) {
        const nkw_additive side = i & 1 ? NKW_ADDITIVE_PARENT : NKW_ADDITIVE_LOCAL;
        nkw_pose_additive_build(pose_of(s, 0), pose_of(s, 1), side, pose_span(s->delta, s->joints));
        nkw_pose_additive_apply(pose_of(s, 2), pose_view(s->delta, s->joints), i & 2 ? 1.0f : 0.75f,
                                mask_view(i & 2 ? s->masks[1] : NULL, s->joints), side, pose_span(s->out, s->joints));
        hash = nkw_pose_fingerprint(pose_view(s->delta, s->joints), hash);
        hash = nkw_pose_fingerprint(pose_view(s->out, s->joints), hash);
    }
    return hash;
}

static uint64_t hash_transitions(const scene *s)
{
    float *v = floats(NKW_POSE_VELOCITY_FLOATS(s->joints));
    const nkw_pose_velocity_span velocity = {v, s->joints};
    const nkw_pose_state from = {pose_of(s, 0), NKW_VIEW(nkw_pose_velocity, velocity)}, to = {pose_of(s, 1), {NULL, 0}};
    const nkw_pose_inertia inertia = {s->inertia, s->joints};
    const nkw_pose_dead_blend dead = {s->dead, s->joints, 0.25f, 0.75f};
    uint64_t hash = HASH_START;
    nkw_pose_velocity_from_poses(pose_of(s, 2), pose_of(s, 0), 0.5f, velocity);
    nkw_pose_inertia_begin(inertia, &from, &to, 0.5f);
    nkw_pose_dead_blend_begin(&dead, &from);
    for (int i = 0; i < 4; i++) {
        nkw_pose_inertia_evaluate(inertia, pose_of(s, 1), 0.25f * (float)i, pose_span(s->out, s->joints));
        hash = nkw_pose_fingerprint(pose_view(s->out, s->joints), hash);
        nkw_pose_dead_blend_evaluate(&dead, pose_of(s, 1), 0.25f * (float)i, pose_span(s->out, s->joints));
        hash = nkw_pose_fingerprint(pose_view(s->out, s->joints), hash);
    }
    free(v);
    return hash;
}

static uint64_t hash_models(const scene *s)
{
    const nkw_skeleton skeleton = {s->parents, s->joints};
    const nkw_palette_source source = {s->models, s->joints, NULL, s->models, NULL, s->joints};
    const nkw_range range = {s->joints / 3, s->joints};
    uint64_t hash = HASH_START;
    nkw_skeleton_models_from_pose(&skeleton, pose_of(s, 0), NULL, NULL, s->models);
    nkw_skeleton_models_from_pose(&skeleton, pose_of(s, 1), NULL, &range, s->models);
    hash = hash_floats(hash, s->models->m, 16 * s->joints);
    nkw_skeleton_pose_from_models(&skeleton, s->models, NULL, pose_span(s->out, s->joints), NULL);
    nkw_palette_from_models(&source, palette_span(NKW_PALETTE_MAT4, s->palette, s->joints));
    nkw_palette_from_models(&source, palette_span(NKW_PALETTE_NORMAL_MAT3, s->normals, s->joints));
    nkw_palette_from_models(&source, palette_span(NKW_PALETTE_DUAL_QUAT, s->duals, s->joints));
    hash = hash_floats(hash_floats(hash, s->palette->m, 16 * s->joints), s->normals->m, 9 * s->joints);
    return hash_floats(nkw_pose_fingerprint(pose_view(s->out, s->joints), hash), &s->duals->real.x, 8 * s->joints);
}

/* Streams in memory of their exact size; after hash_models. */
static uint64_t hash_skins(const scene *s)
{
    uint64_t hash = HASH_START;
    for (size_t i = 0; i < 12; i++) {
        const size_t influences = i % 4 + 1;
        const nkw_skin skin = {s->joints, influences, {s->indices, 0, NKW_SKIN_U16}, {s->weights, 0, NKW_SKIN_F32}};
        const nkw_vertices_view in = {{s->vectors[0], 0}, {s->vectors[1], 0}, {i / 4 ? s->vectors[2] : NULL, 0}, {NULL, 0}};
        const nkw_vertices_span out = {{s->skinned[0], 0}, {s->skinned[1], 0}, {s->skinned[2], 0}, {NULL, 0}};
        const nkw_skin_palette palette = {palette_view(NKW_PALETTE_MAT4, s->palette, s->joints),
                                          palette_view(NKW_PALETTE_NORMAL_MAT3, i / 4 == 2 ? s->normals : NULL, s->joints),
                                          {i % 5 == 4, i % 3 == 1, i % 2}};
        for (size_t k = 0; k < 3; k++)
            memcpy(s->skinned[k], s->vectors[k], 3 * s->joints * sizeof(float));
        nkw_skin_linear(&skin, &palette, in, out);
        for (size_t k = 0; k < 3; k++)
            hash = hash_floats(hash, s->skinned[k], 3 * s->joints);
        nkw_skin_dual_quat(&skin, palette_view(NKW_PALETTE_DUAL_QUAT, s->duals, s->joints), in, out);
        for (size_t k = 0; k < 3; k++)
            hash = hash_floats(hash, s->skinned[k], 3 * s->joints);
    }
    return hash;
}

static uint64_t hash_crowds(const scene *s)
{
    const nkw_skeleton skeleton = {s->parents, s->joints};
    nkw_pose_view poses[NKW_CROWD];
    for (size_t i = 0; i < NKW_CROWD; i++)
        poses[i] = pose_view(i == 5 ? NULL : s->poses[i % POSES], s->joints);
    const nkw_crowd_matrices_view roots = {NULL, 0};
    nkw_crowd_from_poses(poses, crowd_poses_span(s->crowd, s->joints));
    nkw_crowd_models_from_pose(&skeleton, crowd_poses_view(s->crowd, s->joints), roots,
                               crowd_matrices_span(s->lanes, s->joints));
    return hash_floats(HASH_START, s->lanes, NKW_CROWD_MATRIX_FLOATS(s->joints));
}

/* A clip of up to RANDOM_CLIP_JOINTS joints into a pose, and its blend with another one. */
static uint64_t hash_clips(const scene *s)
{
    static random_clip drawn;
    static float block[WORDS];
    random_source r = random_from(s->joints);
    NKW_STACK_WORK(work, NKW_CLIP_BUILD_WORK(RANDOM_CLIP_TRACKS));
    size_t bytes;
    uint64_t hash = HASH_START;
    if (s->joints > RANDOM_CLIP_JOINTS)
        return hash;
    random_clip_draw(&r, s->joints, (int)(s->joints % 3), &drawn);
    drawn.source.format = s->joints % 2 ? NKW_CLIP_UNORM16 : NKW_CLIP_FLOAT32;
    if (nkw_clip_build(&drawn.source, bytes_span(block, sizeof block), &bytes, NULL, work) != NKW_OK)
        abort();
    for (int i = 0; i < 4; i++) {
        float numbers[RANDOM_CLIP_FLOATS];
        const nkw_mask_view none = {NULL, 0};
        nkw_clip_sample((const nkw_clip *)(const void *)block, 0.25f * (float)i, NULL, pose_span(s->out, s->joints), numbers);
        nkw_pose_blend(pose_view(s->out, s->joints), pose_of(s, 1), 0.25f, none, pose_span(s->out, s->joints));
        hash = nkw_pose_fingerprint(pose_view(s->out, s->joints), hash);
    }
    return hash;
}

typedef struct part {
    const char *name;
    uint64_t (*hash)(const scene *);
} part;

static const part parts[] = {
    {"blends", hash_blends},           {"layers", hash_layers}, {"differences", hash_differences},
    {"transitions", hash_transitions}, {"models", hash_models}, {"skins", hash_skins},
    {"crowds", hash_crowds},           {"clips", hash_clips},
};

enum { PARTS = sizeof parts / sizeof *parts };

/* The hashes of all parts. Returns the number of those that raise an exception. */
static int run(size_t joints, padding kind, const char *isa, uint64_t hashes[PARTS])
{
    const scene s = scene_of(joints, kind);
    int failed = 0;
    for (size_t i = 0; i < PARTS; i++) {
        clear_exceptions();
        hashes[i] = parts[i].hash(&s);
        failed += kind != UNWRITTEN && report_exceptions("padding", parts[i].name, isa, raised_exceptions(EXCEPTIONS));
    }
    free_scene(&s);
    return failed;
}

static int run_isa(nkwi_isa tested, const char *isa)
{
    int failed = 0;
    loop_isa = tested;
    for (size_t joints = 1; joints <= MOST && failed == 0; joints++) {
        uint64_t want[PARTS], got[PARTS];
        failed += run(joints, IDENTITIES, isa, want);
        for (int kind = SIGNALLING; kind <= UNWRITTEN; kind++) {
            failed += run(joints, (padding)kind, isa, got);
            for (size_t i = 0; i < PARTS; i++)
                if (got[i] != want[i])
                    failed += fprintf(stderr, "padding: %s, %s, %zu joints: the padding shows\n", parts[i].name, isa,
                                      joints) > 0;
        }
        if (failed)
            fprintf(stderr, "padding: %s, %zu joints\n", isa, joints);
    }
    printf("padding: %s: %d failed\n", isa, failed);
    return failed;
}

int main(void)
{
    return run_isas("padding", run_isa) > 0;
}
