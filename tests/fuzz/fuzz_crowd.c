/* SPDX-License-Identifier: MIT */
/* Every lane has the bits of its character alone, on whatever skeleton; and of its clip alone, sampled and baked. */
#include "fuzz.h"

#include <string.h>

#include "../support/random_clip.h"
#include "../support/views.h"

enum { JOINTS = 24 };

static void check_lanes(fuzz *f, const float *crowd, size_t n, const nkw_mat4 *const *want)
{
    nkw_mat4 *out[NKW_CROWD];
    for (size_t i = 0; i < NKW_CROWD; i++)
        out[i] = want[i] ? fuzz_block(f, n * sizeof **out) : NULL;
    matrices_from_crowd(crowd, n, out);
    for (size_t i = 0; i < NKW_CROWD; i++)
        FUZZ_CHECK(!out[i] || fuzz_same((const float *)out[i], (const float *)want[i], 16 * n));
}

static const nkw_clip *some_clip(fuzz *f, size_t joints)
{
    random_clip *drawn = fuzz_block(f, sizeof *drawn);
    random_source r = fuzz_source(f);
    size_t bytes;
    random_clip_draw(&r, joints, 2, drawn);
    const nkw_work work = fuzz_work(f, NKW_CLIP_BUILD_WORK(drawn->source.track_count));
    nkw_clip_build(&drawn->source, bytes_span(NULL, 0), &bytes, NULL, work);
    if (bytes == 0)
        return NULL;
    void *block = fuzz_block(f, bytes);
    FUZZ_CHECK(nkw_clip_build(&drawn->source, bytes_span(block, bytes), &bytes, NULL, work) == NKW_OK);
    return (const nkw_clip *)block;
}

static void sample(fuzz *f, const nkw_clip *clip, size_t n, size_t characters)
{
    float *times = fuzz_floats(f, characters, 1), *lanes = fuzz_room(f, NKW_CROWD_POSE_FLOATS(n));
    float *want = fuzz_room(f, NKW_CROWD_POSE_FLOATS(n));
    const float *poses[NKW_CROWD] = {NULL};
    for (size_t i = 0; i < characters; i++) {
        float *pose = fuzz_room(f, NKW_POSE_FLOATS(n));
        nkw_clip_sample(clip, times[i], NULL, pose_span(pose, n), NULL);
        poses[i] = pose;
    }
    crowd_from_poses(poses, n, want);
    crowd_sample(clip, times, NULL, characters, fuzz_work(f, NKW_CROWD_SAMPLE_WORK(n)), lanes);
    FUZZ_CHECK(fuzz_same(lanes, want, NKW_CROWD_POSE_FLOATS(n)));
}

/* Any rate and any frames: the chunk is written, nothing else. */
static void bake(fuzz *f, const nkw_crowd_source *source)
{
    size_t frames = fuzz_upto(f, 40), count = source->joint_count, bad, n = source->skeleton->joint_count;
    const nkw_palette_chunk chunk = {frames, count, 0};
    nkw_mat4 *buffer = fuzz_block(f, frames * count * sizeof *buffer);
    const size_t from = fuzz_upto(f, 50);
    const nkw_range range = {from, fuzz_upto(f, 50)};
    nkw_crowd_bake(source, &chunk, &range, buffer, &bad, fuzz_work(f, NKW_CROWD_BAKE_WORK(n, count)));
    FUZZ_CHECK(bad < count || bad < n || bad == 0);
}

/* Any influences: each lane has the bits of its palette alone. */
static void skin(fuzz *f, const float *lanes, size_t n, const nkw_mat4 *const *palettes)
{
    const size_t count = fuzz_upto(f, 20), k = fuzz_upto(f, 10);
    const uint8_t bits = fuzz_byte(f);
    const nkw_skin_options options = {bits & 1, bits >> 1 & 1, bits >> 2 & 1};
    nkw_skin s = {count, k, {NULL, 0, NKW_SKIN_U8}, {NULL, 0, NKW_SKIN_F32}};
    s.joints.data = fuzz_bytes(f, count * k);
    s.weights.data = fuzz_floats(f, count * k, fuzz_byte(f) % 2);
    const nkw_vertices_view vertices = {
        {fuzz_floats(f, 3 * count, 1), 0}, {fuzz_floats(f, 3 * count, 0), 0}, {NULL, 0}, {NULL, 0}};
    nkw_vertices_span outs[NKW_CROWD], alone[NKW_CROWD];
    for (size_t i = 0; i < NKW_CROWD; i++) {
        const nkw_vertices_span none = {{NULL, 0}, {NULL, 0}, {NULL, 0}, {NULL, 0}};
        outs[i] = alone[i] = none;
        if (!palettes[i])
            continue;
        outs[i].positions.data = fuzz_room(f, 3 * count), outs[i].normals.data = fuzz_room(f, 3 * count);
        alone[i].positions.data = fuzz_room(f, 3 * count), alone[i].normals.data = fuzz_room(f, 3 * count);
        const nkw_skin_palette p = {{palettes[i], n, NKW_PALETTE_MAT4}, {NULL, 0, NKW_PALETTE_MAT4}, options};
        nkw_skin_linear(&s, &p, vertices, alone[i]);
    }
    nkw_crowd_skin(crowd_matrices_view(lanes, n), &s, vertices, options, outs);
    for (size_t i = 0; i < NKW_CROWD; i++)
        FUZZ_CHECK(!palettes[i] || (fuzz_same(outs[i].positions.data, alone[i].positions.data, 3 * count) &&
                                    fuzz_same(outs[i].normals.data, alone[i].normals.data, 3 * count)));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz f = fuzz_begin(data, size);
    size_t n = fuzz_upto(&f, JOINTS), count = fuzz_upto(&f, JOINTS), characters = fuzz_upto(&f, NKW_CROWD);
    int wild = fuzz_byte(&f) % 2;
    nkw_skeleton s = {fuzz_parents(&f, n, wild), n};
    const int32_t *joints = fuzz_byte(&f) % 2 ? fuzz_links(&f, count, n, 1) : NULL;
    const nkw_mat4 *inverse_bind = fuzz_byte(&f) % 2 ? fuzz_matrices(&f, count, wild) : NULL;
    const nkw_mat4 *root = fuzz_matrices(&f, 1, wild), *roots[NKW_CROWD];
    const float *poses[NKW_CROWD] = {NULL};
    const nkw_mat4 *models[NKW_CROWD] = {NULL}, *palettes[NKW_CROWD] = {NULL};
    for (size_t i = 0; i < NKW_CROWD; i++)
        roots[i] = root;
    for (size_t i = 0; i < characters; i++) {
        nkw_mat4 *m = fuzz_block(&f, n * sizeof *m), *p = fuzz_block(&f, count * sizeof *p);
        poses[i] = fuzz_pose(&f, n, wild);
        nkw_skeleton_models_from_pose(&s, pose_view(poses[i], s.joint_count), root, NULL, m);
        palette_from_models(m, n, joints, inverse_bind, NULL, count, p);
        models[i] = m;
        palettes[i] = p;
    }
    float *lanes = fuzz_room(&f, NKW_CROWD_POSE_FLOATS(n)), *placed = fuzz_room(&f, NKW_CROWD_MATRIX_FLOATS(1));
    float *all = fuzz_room(&f, NKW_CROWD_MATRIX_FLOATS(n)), *palette = fuzz_room(&f, NKW_CROWD_MATRIX_FLOATS(count));
    crowd_from_poses(poses, n, lanes);
    crowd_from_matrices(roots, 1, placed);
    crowd_models_from_pose(&s, lanes, placed, all);
    check_lanes(&f, all, n, models);
    crowd_palette_from_models(all, n, joints, inverse_bind, count, palette);
    check_lanes(&f, palette, count, palettes);
    skin(&f, palette, count, palettes);
    crowd_models_from_pose(&s, lanes, NULL, all);
    const nkw_clip *clip = n ? some_clip(&f, n) : NULL;
    if (clip) {
        const nkw_crowd_source source = {clip, &s, root, joints, inverse_bind, count, fuzz_float(&f), fuzz_float(&f)};
        sample(&f, clip, n, characters);
        bake(&f, &source);
    }
    return fuzz_end(&f);
}
