/* SPDX-License-Identifier: MIT */
/* The motion kit on a character: the mannequin of docs/examples and its clips. */
#include <math.h>
#include <stdlib.h>

#include "expect.h"
#include "mannequin.h"
#include "views.h"

enum { JOINTS = MANNEQUIN_JOINTS, FRAMES = 60 };

typedef struct body {
    int32_t parents[JOINTS];
    nkw_skeleton skeleton;
    float rest[NKW_POSE_FLOATS(JOINTS)], pose[NKW_POSE_FLOATS(JOINTS)];
    nkw_mat4 models[JOINTS];
} body;

static nkw_box with_point(const nkw_box *box, nkw_vec3 p)
{
    const nkw_box point = {p, p};
    return nkw_box_union(box, &point);
}

static mannequin_clip clips[MANNEQUIN_CLIPS];

static void make_body(body *b)
{
    nkw_pose_identity(pose_span(b->rest, JOINTS));
    for (size_t j = 0; j < JOINTS; j++) {
        nkw_trs trs = {mannequin_bones[j].translation, {0, 0, 0, 1}, {1, 1, 1}};
        b->parents[j] = mannequin_bones[j].parent;
        nkw_pose_set(pose_span(b->rest, JOINTS), j, &trs);
    }
    b->skeleton.parents = b->parents;
    b->skeleton.joint_count = JOINTS;
}

static void update(body *b)
{
    nkw_skeleton_models_from_pose(&b->skeleton, pose_view(b->pose, JOINTS), NULL, NULL, b->models);
}

static nkw_track track_of(const mannequin_channel *c, const float *values)
{
    nkw_track_kind kind = c->path == PATH_ROTATION ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS;
    nkw_track track = {c->times, values, c->key_count, c->width, kind, c->mode, NULL};
    return track;
}

static void set_channel(float *pose, const mannequin_channel *c, const float v[4])
{
    nkw_trs trs = nkw_pose_get(pose_view(pose, JOINTS), (size_t)c->joint);
    if (c->path == PATH_ROTATION)
        trs.rotation = (nkw_quat){v[0], v[1], v[2], v[3]};
    else if (c->path == PATH_TRANSLATION)
        trs.translation = (nkw_vec3){v[0], v[1], v[2]};
    else if (c->path == PATH_SCALE)
        trs.scale = (nkw_vec3){v[0], v[1], v[2]};
    nkw_pose_set(pose_span(pose, JOINTS), (size_t)c->joint, &trs);
}

static float end_of(const mannequin_clip *clip)
{
    float end = 0;
    for (size_t i = 0; i < clip->channel_count; i++)
        end = nkw_max(end, clip->channels[i].times[clip->channels[i].key_count - 1]);
    return end;
}

static void play(body *b, const mannequin_clip *clip, float time)
{
    memcpy(b->pose, b->rest, sizeof b->pose);
    for (size_t i = 0; i < clip->channel_count; i++) {
        float v[4];
        nkw_track track = track_of(&clip->channels[i], clip->channels[i].values);
        if (clip->channels[i].path == PATH_PUFF)
            continue;
        nkw_track_sample(&track, time, NULL, v);
        set_channel(b->pose, &clip->channels[i], v);
    }
    update(b);
}

static nkw_vec3 place(const body *b, size_t joint)
{
    return nkw_mat4_translation(&b->models[joint]);
}

/* Each foot is put 5 cm higher, as on a step: the knees stay in front, the feet arrive. */
static void feet_reach_a_step(void **state)
{
    (void)state;
    body b;
    make_body(&b);
    for (int i = 0; i <= FRAMES; i++)
        for (size_t thigh = THIGH_L; thigh <= THIGH_R; thigh += 3) {
            play(&b, &clips[0], end_of(&clips[0]) * (float)i / FRAMES);
            nkw_ik_pose ik = {b.skeleton, b.models, NULL, pose_span(b.pose, JOINTS)};
            nkw_ik_limb limb = {thigh, thigh + 1, thigh + 2, place(&b, thigh + 2), {0, 0, 1}, {-1, 0, 0}, 0, 1};
            limb.target.y += 0.05f;
            float error;
            assert_int_equal(nkw_ik_pose_two_bone(&ik, &limb, &error), NKW_OK);
            update(&b);
            assert_true(error < 1e-6f);
            expect_vec3_near(place(&b, thigh + 2), limb.target, 2e-6);
            nkw_vec3 line = nkw_vec3_normalize(nkw_vec3_sub(limb.target, place(&b, thigh)));
            nkw_vec3 knee = nkw_vec3_reject(nkw_vec3_sub(place(&b, thigh + 1), place(&b, thigh)), line);
            assert_true(knee.z > 0.05f);
        }
}

static void the_head_looks_where_the_neck_permits(void **state)
{
    (void)state;
    body b;
    make_body(&b);
    for (int i = 0; i < 24; i++) {
        float angle = 6.2831853f * (float)i / 24, off = nkw_abs(nkw_wrap_angle(angle));
        play(&b, &clips[0], 0.3f);
        nkw_ik_pose ik = {b.skeleton, b.models, NULL, pose_span(b.pose, JOINTS)};
        nkw_ik_look look = {HEAD, place(&b, HEAD), {0, 0, 1}, {0, 0, 0}, {0, 1, 0}, {0, 1, 0}, {0, 0, 1}, 1.2f, 1};
        look.target = nkw_vec3_add(look.target, (nkw_vec3){nkw_sin(angle), 0, nkw_cos(angle)});
        float error;
        assert_int_equal(nkw_ik_pose_aim(&ik, &look, &error), NKW_OK);
        /* The neck itself sways by a few degrees. */
        expect_near(error, off > 1.2f ? off - 1.2f : 0, off > 1.0f ? 0.25 : 1e-6);
    }
}

/* The clip and the rest pose in Blender's axes: the models are the converted models, in every frame of every clip. */
static void clips_convert_to_other_axes(void **state)
{
    (void)state;
    const nkw_axes gltf = NKW_AXES_GLTF, others[3] = {NKW_AXES_BLENDER, NKW_AXES_UNITY, NKW_AXES_UNREAL};
    body b, c;
    make_body(&b);
    make_body(&c);
    for (int k = 0; k < 3 * MANNEQUIN_CLIPS; k++) {
        nkw_axes_map map = nkw_axes_map_from_axes(gltf, others[k % 3]);
        mannequin_clip converted = clips[k / 3];
        nkw_pose_convert_axes(pose_view(b.rest, JOINTS), map, pose_span(c.rest, JOINTS));
        for (size_t i = 0; i < converted.channel_count; i++) {
            static const nkw_clip_target targets[] = {NKW_CLIP_TRANSLATION, NKW_CLIP_ROTATION, NKW_CLIP_SCALE,
                                                      NKW_CLIP_FLOATS};
            mannequin_channel *ch = &converted.channels[i];
            nkw_clip_track track = {targets[ch->path], 0, track_of(ch, ch->values)};
            if (track.target == NKW_CLIP_FLOATS)
                continue;
            const nkw_axes_kind kind = NKW_CLIP_AXES(track.target);
            assert_int_equal(nkw_track_convert_axes(&track.track, map, kind, ch->values), NKW_OK);
        }
        for (int i = 0; i <= FRAMES; i++) {
            float time = end_of(&converted) * (float)i / FRAMES;
            play(&b, &clips[k / 3], time);
            play(&c, &converted, time);
            for (size_t j = 0; j < JOINTS; j++) {
                nkw_mat4 want = nkw_axes_convert_mat4(map, &b.models[j]);
                expect_floats_near(c.models[j].m, want.m, 16, 3e-6);
            }
        }
    }
}

/* The same body, each joint with other axes: all joints move alike. */
static void the_walk_moves_a_body_with_other_axes(void **state)
{
    (void)state;
    body b, c;
    nkw_quat axes[JOINTS];
    nkw_retarget_joint map[JOINTS];
    NKW_STACK_WORK(work, NKW_RETARGET_WORK(JOINTS, JOINTS));
    make_body(&b);
    make_body(&c);
    for (size_t j = 0; j < JOINTS; j++) {
        int parent = mannequin_bones[j].parent;
        nkw_quat up = parent < 0 ? nkw_quat_identity() : axes[parent];
        axes[j] = nkw_quat_from_axis_angle((nkw_vec3){1, 2, (float)j}, (float)j);
        nkw_trs trs = {nkw_quat_rotate_inverse(up, mannequin_bones[j].translation),
                       nkw_quat_mul(nkw_quat_conjugate(up), axes[j]),
                       {1, 1, 1}};
        nkw_pose_set(pose_span(c.rest, JOINTS), j, &trs);
        map[j] = (nkw_retarget_joint){(int32_t)j, NKW_NO_JOINT, 0, j == HIPS ? 1.0f : 0.0f};
    }
    nkw_retarget r = {b.skeleton, c.skeleton, pose_view(b.rest, JOINTS), pose_view(c.rest, JOINTS), map, {0, 0, 0, 1}};
    assert_int_equal(nkw_retarget_validate(&r, NULL), NKW_OK);
    for (int i = 0; i <= FRAMES; i++) {
        play(&b, &clips[0], end_of(&clips[0]) * (float)i / FRAMES);
        nkw_retarget_apply(&r, pose_view(b.pose, JOINTS), pose_span(c.pose, JOINTS), work);
        update(&c);
        for (size_t j = 0; j < JOINTS; j++)
            expect_vec3_near(place(&c, j), place(&b, j), 3e-6);
    }
}

static void the_skin_is_inside_its_bounds_in_every_frame(void **state)
{
    (void)state;
    body b;
    mesh m;
    nkw_mat4 bind[JOINTS], palette[JOINTS];
    nkw_box boxes[JOINTS + 1], box;
    make_body(&b);
    assert_true(mannequin_mesh(&m, PART_BODY));
    nkw_vec3 *skinned = calloc(m.vertex_count, sizeof *skinned);
    assert_non_null(skinned);
    memcpy(b.pose, b.rest, sizeof b.pose);
    update(&b);
    nkw_palette_source source = {b.models, JOINTS, NULL, NULL, NULL, JOINTS};
    nkw_palette_inverse_bind(&source, bind);
    source.inverse_bind = bind;
    const size_t s = sizeof(mesh_vertex);
    nkw_skin skin = {m.vertex_count,
                     MESH_INFLUENCES,
                     {m.vertices[0].joints, s, NKW_SKIN_U16},
                     {m.vertices[0].weights, s, NKW_SKIN_U16}};
    nkw_vertices_view in = {{&m.vertices[0].position, s}, {NULL, 0}, {NULL, 0}, {NULL, 0}};
    nkw_vertices_span out = {{skinned, 0}, {NULL, 0}, {NULL, 0}, {NULL, 0}};
    assert_int_equal(nkw_box_from_skin(&skin, in.positions, boxes, JOINTS), NKW_OK);
    for (int i = 0; i <= FRAMES * MANNEQUIN_CLIPS; i++) {
        const mannequin_clip *clip = &clips[i % MANNEQUIN_CLIPS];
        play(&b, clip, end_of(clip) * (float)i / (FRAMES * MANNEQUIN_CLIPS));
        nkw_palette_span to = {palette, JOINTS, NKW_PALETTE_MAT4};
        nkw_palette_from_models(&source, to);
        nkw_skin_palette matrices = {NKW_VIEW(nkw_palette, to), {NULL, 0, NKW_PALETTE_NORMAL_MAT3}, {0, 0, 0}};
        nkw_skin_linear(&skin, &matrices, in, out);
        nkw_box_from_palette(NKW_VIEW(nkw_palette, to), boxes, &box);
        nkw_box tight = NKW_BOX_EMPTY;
        for (size_t v = 0; v < m.vertex_count; v++)
            tight = with_point(&tight, skinned[v]);
        nkw_box both = nkw_box_union(&box, &tight);
        expect_floats_bits(&both.low.x, &box.low.x, 6);
        /* At most 15 cm larger than the tightest box, on each side. */
        assert_true(box.high.y - tight.high.y < 0.15f && tight.low.y - box.low.y < 0.15f);
        assert_true(box.high.x - tight.high.x < 0.15f && tight.low.z - box.low.z < 0.15f);
    }
    free(skinned);
    mesh_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(feet_reach_a_step),
        cmocka_unit_test(the_head_looks_where_the_neck_permits),
        cmocka_unit_test(clips_convert_to_other_axes),
        cmocka_unit_test(the_walk_moves_a_body_with_other_axes),
        cmocka_unit_test(the_skin_is_inside_its_bounds_in_every_frame),
    };
    mannequin_clips(clips);
    return cmocka_run_group_tests_name("body", tests, NULL, NULL);
}
