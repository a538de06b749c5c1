/* SPDX-License-Identifier: MIT */
/*
 * How many instructions a fixed set of work takes: times are noisy, counts are not. Runs under callgrind, which
 * writes a file for each name; counts.cmake compares them with counts.txt. callgrind knows no AVX-512, so the loops
 * are those of the baseline and of AVX2.
 */
#include <stdlib.h>
#include <string.h>

#include <nakawari/nakawari.h>

#include "loops.h"
#include "views.h"
#include "counted.h"

enum { JOINTS = 67, KEYS = 301 };

/* What is written has external linkage, so that no compiler drops it. */
nkw_quat q_out[N];
nkw_vec3 v_out[N];
nkw_mat4 m_out[N];
nkw_trs trs_out[N];
nkw_segment segments[N];
float out[16][N];

static nkw_trs trs[N];
static float x[N], parts[24][N], ends[N], times[KEYS], values[JOINTS * KEYS * 10], pose[NKW_POSE_FLOATS(JOINTS)];
static nkw_clip_track tracks[3 * JOINTS];
static uint32_t cursors[8];
static float blocks[3][2 * JOINTS * KEYS * 16];
static const nkw_clip *clips[3];
static int32_t parents[JOINTS];
static float poses[2][NKW_POSE_FLOATS(JOINTS)], blended[NKW_POSE_FLOATS(JOINTS)];
static float crowd[NKW_CROWD_POSE_FLOATS(JOINTS)], crowd_models[NKW_CROWD_MATRIX_FLOATS(JOINTS)];
static uint16_t skin_joints[4 * N];
static float skin_weights[4 * N], skinned[6 * N], tangents[3 * N], vertices[6 * N];

static void draw_values(random_source *r)
{
    for (size_t i = 0; i < N; i++) {
        draw_element(r, i);
        nkw_trs place = {random_vec3(r, -1, 1), random_rotation(r), random_vec3(r, 0.5f, 2)};
        trs[i] = place;
        ma[i] = nkw_mat4_from_trs(&place);
        draw_matrices(r, i);
        x[i] = random_between(r, -1, 1);
        for (int k = 0; k < 24; k++)
            parts[k][i] = k < 4 ? (&qa[i].x)[k] : k < 8 ? (&qb[i].x)[k - 4] : random_between(r, -1, 1);
    }
    for (size_t k = 0; k < KEYS; k++)
        times[k] = nkw_timeline_time((nkw_timeline){0, 30, 0}, k);
}

static void build_clip(nkw_clip_format format, size_t i)
{
    nkw_clip_source source = {tracks, 3 * JOINTS, JOINTS, 0, {NULL, 0}, NULL, format, NULL};
    NKW_STACK_WORK(work, NKW_CLIP_BUILD_WORK(3 * JOINTS));
    const nkw_bytes_span block = {blocks[i], sizeof blocks[i]};
    size_t bytes = 0;
    if (nkw_clip_build(&source, block, &bytes, NULL, work) != NKW_OK ||
        nkw_clip_open(block.data, block.bytes, &clips[i]) != NKW_OK)
        exit(1);
}

static void draw_clips(random_source *r)
{
    static const size_t at[3] = {0, 3, 7}, width[3] = {3, 4, 3};
    for (size_t j = 0; j < JOINTS; j++)
        for (size_t k = 0; k < 3; k++) {
            float *v = values + (j * 10 + at[k]) * KEYS;
            for (size_t i = 0; i < KEYS; i++) {
                nkw_quat q = random_rotation(r);
                memcpy(v + i * width[k], &q, width[k] * sizeof *v);
            }
            nkw_clip_track track = {(nkw_clip_target)k,
                                    (uint32_t)j,
                                    {times, v, KEYS, width[k], k == 1 ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS,
                                     NKW_INTERPOLATION_LINEAR, NULL}};
            tracks[j * 3 + k] = track;
        }
    build_clip(NKW_CLIP_FLOAT32, 0);
    build_clip(NKW_CLIP_UNORM16, 1);
    /* The same numbers in turn as in-tangent, value and out-tangent. */
    for (size_t i = 0; i < 3 * JOINTS; i++)
        tracks[i].track.count = KEYS / 3, tracks[i].track.interpolation = NKW_INTERPOLATION_CUBICSPLINE;
    build_clip(NKW_CLIP_FLOAT32, 2);
    for (size_t i = 0; i < 3 * JOINTS; i++)
        tracks[i].track.count = KEYS, tracks[i].track.interpolation = NKW_INTERPOLATION_LINEAR;
}

static void draw_character(random_source *r)
{
    const float *lanes[NKW_CROWD];
    for (size_t j = 0; j < JOINTS; j++)
        parents[j] = j % 4 == 0 ? (int32_t)(j / 4) - 1 : (int32_t)j - 1;
    for (int k = 0; k < 2; k++)
        nkw_pose_from_trs(trs + k * JOINTS, (nkw_pose_span){poses[k], JOINTS});
    for (size_t i = 0; i < NKW_CROWD; i++)
        lanes[i] = poses[i % 2];
    crowd_from_poses(lanes, JOINTS, crowd);
    for (size_t i = 0; i < 4 * N; i++) {
        skin_joints[i] = (uint16_t)(random_bits(r) % JOINTS);
        skin_weights[i] = random_unit(r);
    }
    for (size_t i = 0; i < 6 * N; i++)
        vertices[i] = random_between(r, -1, 1);
    nkw_skin_view in = {skin_weights, 0, NKW_SKIN_F32};
    nkw_skin_span out_weights = {skin_weights, 0, NKW_SKIN_F32};
    nkw_skin_normalize_weights(in, 4, N, out_weights);
}

static void count_singles(void)
{
    EACH("single sin", out[0][i] = nkw_sin(x[i]));
    EACH("single acos", out[0][i] = nkw_acos(x[i]));
    EACH("single atan2", out[0][i] = nkw_atan2(x[i], t[i]));
    EACH("single pow", out[0][i] = nkw_pow(t[i], x[i]));
    EACH("single vec3_normalize", v_out[i] = nkw_vec3_normalize(p[0][i]));
    EACH("single quat_normalize", q_out[i] = nkw_quat_normalize(qa[i]));
    EACH("single quat_from_mat3", q_out[i] = nkw_quat_from_mat3(&turn[i]));
    EACH("single mat4_inverse", m_out[i] = nkw_mat4_inverse(&ma[i]));
    EACH("single mat4_inverse_affine", m_out[i] = nkw_mat4_inverse_affine(&ma[i]));
    EACH("single mat4_inverse_rigid", m_out[i] = nkw_mat4_inverse_rigid(&mb[i]));
    EACH("single trs_from_mat4", trs_out[i] = nkw_trs_from_mat4(&ma[i]));
    EACH("single quat_from_euler", q_out[i] = nkw_quat_from_euler(p[0][i], NKW_EULER_YXZ));
    EACH("single euler_from_quat", v_out[i] = nkw_euler_from_quat(qa[i], NKW_EULER_YXZ));
    EACH("single vec3_hermite", v_out[i] = nkw_vec3_hermite(p[0][i], p[1][i], p[2][i], p[3][i], t[i]));
    EACH("single vec3_bezier", v_out[i] = nkw_vec3_bezier(p[0][i], p[1][i], p[2][i], p[3][i], t[i]));
    EACH("single quat_nlerp", q_out[i] = nkw_quat_nlerp(qa[i], qb[i], t[i]));
    EACH("single quat_slerp", q_out[i] = nkw_quat_slerp(qa[i], qb[i], t[i]));
    EACH("single quat_log", v_out[i] = nkw_quat_log(qa[i]));
    EACH("single quat_exp", q_out[i] = nkw_quat_exp(p[0][i]));
}

static void count_inlined(void)
{
    EACH("inline quat_mul", q_out[i] = nkw_quat_mul(qa[i], qb[i]));
    EACH("inline quat_rotate", v_out[i] = nkw_quat_rotate(qa[i], p[0][i]));
    EACH("inline mat4_mul", m_out[i] = nkw_mat4_mul(&ma[i], &mb[i]));
    EACH("inline mat4_mul_affine", m_out[i] = nkw_mat4_mul_affine(&ma[i], &mb[i]));
    EACH("inline mat4_from_quat", m_out[i] = nkw_mat4_from_quat(qa[i]));
    EACH("inline mat4_from_trs", m_out[i] = nkw_mat4_from_trs(&trs[i]));
    EACH("inline vec3_lerp", v_out[i] = nkw_vec3_lerp(p[0][i], p[1][i], t[i]));
}

static void count_motion(void)
{
    static nkw_fcurve_key keys[33];
    const nkw_fcurve curve = {.keys = keys, .key_count = 33};
    const nkw_easing css = {NKW_EASING_CUBIC_BEZIER, {0.25f, 0.1f, 0.25f, 1.0f}, NKW_EASE_JUMP_END, 0, NULL, NULL};
    const nkw_spring spring = nkw_spring_from_half_life(0.1f, 0.5f);
    for (size_t k = 0; k < 33; k++) {
        nkw_fcurve_key key = {(float)k, x[k], {-0.2f, 0.1f}, {0.4f, 0.1f}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR};
        keys[k] = key;
    }
    EACH("single easing_evaluate, cubic-bezier", out[0][i] = nkw_easing_evaluate(&css, t[i]).value);
    EACH("single ease_evaluate, cubic in and out", out[0][i] = nkw_ease_evaluate(NKW_EASE_CUBIC_IN_OUT, t[i]).value);
    EACH("single fcurve_sample, 33 keys", out[0][i] = nkw_fcurve_sample(&curve, 32 * t[i], NULL).value);
    EACH("single spring_step",
         out[0][i] = nkw_spring_step(spring, (nkw_state){x[i], 1.0f}, (nkw_state){t[i], 0.0f}, 1.0f / 60).value);
}

/* Limbs of two bones, targets near their ends; no pole, no limits. */
static void count_limbs(void)
{
    static nkw_ik_two_bone limbs[N];
    static nkw_ik_aim aims[N];
    for (size_t i = 0; i < N; i++) {
        const nkw_vec3 end = nkw_vec3_add(p[1][i], nkw_vec3_scale(p[2][i], 0.1f));
        const nkw_ik_two_bone limb = {.mid = p[0][i], .end = p[1][i], .target = end, .weight = 1.0f};
        const nkw_ik_aim aim = {.forward = p[0][i], .target = p[1][i], .weight = 1.0f};
        limbs[i] = limb;
        aims[i] = aim;
    }
    EACH("single ik_two_bone_solve", v_out[i] = nkw_ik_two_bone_solve(&limbs[i]).end_position);
    EACH("single ik_aim_solve", q_out[i] = nkw_ik_aim_solve(&aims[i]).rotation);
}

static void count_data(void)
{
    EACH("segment_find", segments[i] = nkw_segment_find(times, KEYS, 10 * t[i]));
    EACH("segment_find_from",
         segments[i] = nkw_segment_find_hint(times, KEYS, 10.0f * (float)i / N, segments[i ? i - 1 : 0].index));
    EACH("timeline_find", segments[i] = nkw_timeline_find((nkw_timeline){0, 30, KEYS}, 10 * t[i]));
    EACH("track_sample vec3", nkw_track_sample(&tracks[0].track, 10 * t[i], NULL, &v_out[i].x));
    EACH("track_sample rotation", nkw_track_sample(&tracks[1].track, 10 * t[i], NULL, &q_out[i].x));
    COUNT("clip_sample 67 joints", for (size_t i = 0; i < 16; i++) nkw_clip_sample(
                                       clips[0], 10 * t[i], cursors, (nkw_pose_span){pose, JOINTS}, NULL));
    COUNT("clip_sample 67 joints, 16 bits", for (size_t i = 0; i < 16; i++) nkw_clip_sample(
                                                clips[1], 10 * t[i], cursors, (nkw_pose_span){pose, JOINTS}, NULL));
    COUNT("clip_sample 67 joints, CUBICSPLINE", for (size_t i = 0; i < 16; i++) nkw_clip_sample(
                                                    clips[2], 3 * t[i], cursors, (nkw_pose_span){pose, JOINTS}, NULL));
}

/*
 * Blends of poses as clips of one model have them: a third of the rotations equal, a fifth the identity; and masks of 0
 * and 1. One such joint must not take its register, or its block, away from the vectors.
 */
static void count_real_blends(void)
{
    static nkw_trs joints[2][JOINTS];
    static float pose_a[NKW_POSE_FLOATS(JOINTS)], pose_b[NKW_POSE_FLOATS(JOINTS)], mask[NKW_POSE_STRIDE(JOINTS)];
    const nkw_pose_view a = {pose_a, JOINTS}, b = {pose_b, JOINTS};
    const nkw_mask_view none = {NULL, JOINTS}, upper = {mask, JOINTS};
    const nkw_pose_span to = {blended, JOINTS};
    for (size_t j = 0; j < JOINTS; j++) {
        joints[0][j] = trs[j];
        joints[1][j] = trs[JOINTS + j];
        if (j % 5 == 1)
            joints[0][j].rotation = nkw_quat_identity();
        if (j % 3 == 0 || j % 5 == 1)
            joints[1][j].rotation = joints[0][j].rotation;
        mask[j] = j < 30 ? 0.0f : 1.0f;
    }
    nkw_pose_from_trs(joints[0], (nkw_pose_span){pose_a, JOINTS});
    nkw_pose_from_trs(joints[1], (nkw_pose_span){pose_b, JOINTS});
    nkw_pose_layer layers[2] = {{a, 0.5f, none}, {b, 0.5f, upper}};
    COUNT("pose_blend 67 joints, some equal", nkw_pose_blend(a, b, 0.3f, none, to));
    COUNT("pose_blend 67 joints, mask of 0 and 1", nkw_pose_blend(a, b, 1.0f, upper, to));
    COUNT("pose_layers_blend 67 joints, 2, mask of 0 and 1", nkw_pose_layers_blend(layers, 2, a, 0.1f, to));
    COUNT("pose_blend_slerp 67 joints, some equal", nkw_pose_blend_slerp(a, b, 0.3f, none, to));
    COUNT("pose_additive_apply 67 joints, some equal",
          nkw_pose_additive_apply(a, b, 0.5f, none, NKW_ADDITIVE_LOCAL, to));
}

/* Each joint at most 0.5 rad from that of poses[0]: signs always agree. */
static void count_near_layers(void)
{
    static float near[4][NKW_POSE_FLOATS(JOINTS)];
    random_source r = random_from(7);
    nkw_pose_layer layers[4];
    for (size_t i = 0; i < 4; i++) {
        const nkw_pose_layer layer = {{near[i], JOINTS}, 0.25f, {NULL, 0}};
        layers[i] = layer;
        for (size_t j = 0; j < JOINTS; j++) {
            nkw_trs near_trs = trs[j];
            near_trs.rotation = random_near(&r, trs[j].rotation, 0.25f * random_unit(&r));
            nkw_pose_set((nkw_pose_span){near[i], JOINTS}, j, &near_trs);
        }
    }
    COUNT("pose_layers_blend 67 joints, 4 near",
          nkw_pose_layers_blend(layers, 4, (nkw_pose_view){poses[0], JOINTS}, 0.1f, (nkw_pose_span){blended, JOINTS}));
}

static void count_transition(void)
{
    static float velocities[2][NKW_POSE_VELOCITY_FLOATS(JOINTS)], offsets[NKW_POSE_INERTIA_FLOATS(JOINTS)];
    const nkw_pose_view old = {poses[0], JOINTS}, now = {poses[1], JOINTS};
    const nkw_pose_state from = {old, {velocities[0], JOINTS}}, to = {now, {velocities[1], JOINTS}};
    COUNT("pose_velocity_from_poses 67 joints",
          nkw_pose_velocity_from_poses(old, now, 0.5f, (nkw_pose_velocity_span){velocities[0], JOINTS}));
    COUNT("pose_inertia_begin 67 joints",
          nkw_pose_inertia_begin((nkw_pose_inertia){offsets, JOINTS}, &from, &to, 0.5f));
}

/* These choose their loops by the processor, which under callgrind is one of AVX2 at the most. */
static void count_character(void)
{
    nkw_skeleton skeleton = {parents, JOINTS};
    nkw_skin skin = {N, 4, {skin_joints, 0, NKW_SKIN_U16}, {skin_weights, 0, NKW_SKIN_F32}};
    nkw_skin_palette palette = {{ma, JOINTS, NKW_PALETTE_MAT4}, {NULL, 0, NKW_PALETTE_NORMAL_MAT3}, {0, 0, 0}};
    nkw_vertices_view from = {{vertices, 24}, {vertices + 3, 24}, {NULL, 0}, {NULL, 0}};
    nkw_vertices_span to = {{skinned, 24}, {skinned + 3, 24}, {NULL, 0}, {NULL, 0}};
    nkw_pose_layer layers[4];
    for (size_t i = 0; i < 4; i++) {
        nkw_pose_layer layer = {{poses[i % 2], JOINTS}, 0.25f, {NULL, 0}};
        layers[i] = layer;
    }
    COUNT("pose_blend 67 joints",
          nkw_pose_blend((nkw_pose_view){poses[0], JOINTS}, (nkw_pose_view){poses[1], JOINTS}, 0.3f,
                         (nkw_mask_view){NULL, JOINTS}, (nkw_pose_span){blended, JOINTS}));
    COUNT("pose_layers_blend 67 joints, 4 of one weight",
          nkw_pose_layers_blend(layers, 4, (nkw_pose_view){poses[0], JOINTS}, 0.1f, (nkw_pose_span){blended, JOINTS}));
    count_real_blends();
    count_near_layers();
    COUNT("skeleton_pose_from_models 67 joints",
          nkw_skeleton_pose_from_models(&skeleton, mb, NULL, (nkw_pose_span){blended, JOINTS}, NULL));
    COUNT("skeleton_models_from_pose 67 joints",
          nkw_skeleton_models_from_pose(&skeleton, (nkw_pose_view){poses[0], skeleton.joint_count}, NULL, NULL, m_out));
    COUNT("palette_from_models 67 joints", palette_from_models(ma, JOINTS, NULL, mb, NULL, JOINTS, m_out));
    COUNT("skin_linear 1024 vertices, 4 influences", nkw_skin_linear(&skin, &palette, from, to));
    palette.options.inverse_normals = 1;
    COUNT("skin_linear 1024 vertices, 4 influences, inverse normals", nkw_skin_linear(&skin, &palette, from, to));
    palette.options = (nkw_skin_options){0, 0, 1};
    COUNT("skin_linear 1024 vertices, 4 influences, divided by weights", nkw_skin_linear(&skin, &palette, from, to));
    palette.options = (nkw_skin_options){0, 0, 0};
    from.tangents.data = vertices, to.tangents.data = tangents;
    COUNT("skin_linear 1024 vertices, 4 influences, tangents", nkw_skin_linear(&skin, &palette, from, to));
    count_transition();
    COUNT("crowd 16 of 67 joints to palettes", {
        crowd_models_from_pose(&skeleton, crowd, NULL, crowd_models);
        crowd_palette_from_models(crowd_models, JOINTS, NULL, mb, JOINTS, crowd_models);
    });
}

static void count_loops(void)
{
    const int avx2 = loop_isa == NKWI_ISA_AVX2;
    nkw_quat_view a = {parts[0], parts[1], parts[2], parts[3]}, c = {parts[4], parts[5], parts[6], parts[7]};
    nkw_quat_span q = {out[0], out[1], out[2], out[3]};
    nkw_vec3_view v[4];
    nkw_vec3_span s = {out[0], out[1], out[2]};
    nkw_mat4_span m;
    for (size_t k = 0; k < 4; k++) {
        nkw_vec3_view one = {parts[8 + 3 * k], parts[9 + 3 * k], parts[10 + 3 * k]};
        v[k] = one;
    }
    for (size_t k = 0; k < 16; k++)
        m.m[k] = out[k];
    nkw_trs_view place = {v[0], a, v[1]};
#define LOOP(name, arguments)                                                                                          \
    if (avx2)                                                                                                          \
        COUNT("avx2 " #name, nkw_##name##_n arguments);                                                                \
    else                                                                                                               \
        COUNT("generic " #name, nkw_##name##_n arguments)
    LOOP(vec3_normalize, (v[0], s, N));
    LOOP(vec3_lerp, (v[0], v[1], t, s, N));
    LOOP(vec3_hermite, (v[0], v[1], v[2], v[3], t, s, N));
    LOOP(quat_mul, (a, c, q, N));
    LOOP(quat_rotate, (a, v[0], s, N));
    LOOP(quat_normalize, (a, q, N));
    LOOP(quat_nlerp, (a, c, t, q, N));
    memcpy(ends, t, sizeof ends);
    ends[0] = 0.0f, ends[N / 2] = 1.0f;
    if (avx2)
        COUNT("avx2 quat_nlerp, two at an end", nkw_quat_nlerp_n(a, c, ends, q, N));
    else
        COUNT("generic quat_nlerp, two at an end", nkw_quat_nlerp_n(a, c, ends, q, N));
    LOOP(quat_slerp, (a, c, t, q, N));
    LOOP(mat4_from_trs, (place, m, N));
    LOOP(mat4_transform_point, (&ma[0], v[0], s, N));
    LOOP(quat_unpack, (qa, q, N));
    LOOP(quat_pack, (a, q_out, N));
}

int main(void)
{
    random_source r = random_from(5);
    draw_values(&r);
    draw_clips(&r);
    draw_character(&r);
    loop_by_length = 1;
    count_loops();
#if defined(NKW_HAVE_AVX2)
    if (__builtin_cpu_supports("avx2"))
        loop_isa = NKWI_ISA_AVX2;
#endif
    count_inlined();
    count_singles();
    count_motion();
    count_limbs();
    count_data();
    count_character();
    if (loop_isa == NKWI_ISA_AVX2)
        count_loops();
    return 0;
}
