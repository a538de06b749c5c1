/* SPDX-License-Identifier: MIT */
#include "data.h"
#include "hash.h"
#include "random.h"
#include "random_clip.h"
#include "views.h"

#define JOINTS 13

/* A clip baked into a chunk that is no multiple of a crowd. */
static uint64_t hash_baked(uint64_t hash, random_source *r, const nkw_skeleton *skeleton, const nkw_mat4 *bind)
{
    enum { FRAMES = 21 };
    static random_clip drawn;
    static float block[1 << 15];
    NKW_STACK_WORK(work, NKW_CROWD_BAKE_WORK(JOINTS, JOINTS));
    static nkw_mat4 buffer[FRAMES * JOINTS];
    NKW_STACK_WORK(tracks, NKW_CLIP_BUILD_WORK(RANDOM_CLIP_TRACKS));
    size_t bytes;
    const nkw_palette_chunk chunk = {FRAMES, JOINTS, 0};
    random_clip_draw(r, JOINTS, 0, &drawn);
    if (nkw_clip_build(&drawn.source, bytes_span(block, sizeof block), &bytes, NULL, tracks) != NKW_OK)
        return 0;
    const nkw_clip *clip = (const nkw_clip *)(const void *)block;
    const nkw_crowd_source source = {clip, skeleton, &bind[0], NULL, bind, JOINTS, 0.0f, 23.0f};
    crowd_bake(&source, &chunk, 0, FRAMES, work, buffer);
    return hash_floats(hash, buffer[0].m, 16 * FRAMES * JOINTS);
}

uint64_t data_crowd(void)
{
    static float poses[NKW_CROWD][NKW_POSE_FLOATS(JOINTS)], crowd[NKW_CROWD_POSE_FLOATS(JOINTS)];
    static float models[NKW_CROWD_MATRIX_FLOATS(JOINTS)], palette[NKW_CROWD_MATRIX_FLOATS(JOINTS)];
    static float roots[NKW_CROWD_MATRIX_FLOATS(1)];
    static nkw_mat4 bind[JOINTS], out[NKW_CROWD][JOINTS];
    int32_t parents[JOINTS];
    const float *in[NKW_CROWD];
    const nkw_mat4 *matrices[NKW_CROWD];
    nkw_mat4 *to[NKW_CROWD];
    random_source r = random_from(9);
    nkw_skeleton skeleton = {parents, JOINTS};
    for (size_t j = 0; j < JOINTS; j++)
        parents[j] = (int32_t)(random_bits(&r) % (j + 1)) - 1;
    for (size_t i = 0; i < NKW_CROWD; i++) {
        in[i] = i == 11 ? NULL : poses[i];
        to[i] = i == 5 ? NULL : out[i];
        matrices[i] = i == 3 ? NULL : &bind[i % JOINTS];
        for (size_t j = 0; j < JOINTS; j++) {
            nkw_trs trs = {random_vec3(&r, -3, 3), random_rotation(&r), random_vec3(&r, 0.5f, 2)};
            nkw_pose_set(pose_span(poses[i], JOINTS), j, &trs);
            bind[j] = nkw_mat4_from_trs(&trs);
        }
    }
    crowd_from_poses(in, JOINTS, crowd);
    crowd_from_matrices(matrices, 1, roots);
    crowd_models_from_pose(&skeleton, crowd, roots, models);
    crowd_palette_from_models(models, JOINTS, NULL, bind, JOINTS, palette);
    matrices_from_crowd(palette, JOINTS, to);
    return hash_baked(hash_floats(HASH_START, out[0][0].m, sizeof out / sizeof(float)), &r, &skeleton, bind);
}
