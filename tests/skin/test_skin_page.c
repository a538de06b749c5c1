/* SPDX-License-Identifier: MIT */
/* The program of docs/subjects/skin/skin.md, "With scale". */
#include <math.h>

#include "subjects_skin_skin_3.c" /* the block of the page */
#include "support/poses.h"
#include "support/views.h"

#define BONES 3
#define SOME  40

static const int32_t bone_parents[BONES] = {-1, 0, 1};

/* Hip, thigh, shank; every vertex has an influence of each. */
typedef struct limb {
    float bind[NKW_POSE_FLOATS(BONES)], pose[NKW_POSE_FLOATS(BONES)], scaled[NKW_POSE_FLOATS(BONES)];
    nkw_mat4 inverse_bind[BONES], models[BONES], stretch[BONES], inverse[BONES], matrices[BONES];
    nkw_dual_quat rigid[BONES];
    nkw_vec3 positions[SOME], normals[SOME], out[SOME], out_normals[SOME], want[SOME], want_normals[SOME];
    uint8_t joints[BONES * SOME];
    float weights[BONES * SOME];
} limb;

static limb l;

static const nkw_skeleton skeleton = {bone_parents, BONES};

static nkw_palette_source source(void)
{
    const nkw_palette_source s = {l.models, BONES, NULL, l.inverse_bind, NULL, BONES};
    return s;
}

static void draw_limb(random_source *r)
{
    nkw_pose_identity(pose_span(l.bind, BONES));
    for (size_t j = 0; j < BONES; j++) {
        const nkw_trs trs = {random_vec3(r, -1, 1), random_rotation(r), {1, 1, 1}};
        nkw_pose_set(pose_span(l.bind, BONES), j, &trs);
    }
    memcpy(l.pose, l.bind, sizeof l.pose);
    nkw_skeleton_models_from_pose(&skeleton, pose_view(l.bind, BONES), NULL, NULL, l.models);
    const nkw_palette_source s = source();
    nkw_palette_inverse_bind(&s, l.inverse_bind);
    for (size_t i = 0; i < SOME; i++) {
        l.positions[i] = random_vec3(r, -2, 2);
        l.normals[i] = random_direction(r);
        const float a = random_between(r, 0, 1), b = random_between(r, 0, 1 - a), w[BONES] = {a, b, 1 - a - b};
        for (size_t j = 0; j < BONES; j++) {
            l.joints[BONES * i + j] = (uint8_t)j;
            l.weights[BONES * i + j] = w[j];
        }
    }
}

/* Turns joint j by a rotation, after that of the bind pose, and scales it. */
static void set_joint(size_t j, nkw_quat turn, float scale)
{
    nkw_trs trs = nkw_pose_get(pose_view(l.bind, BONES), j);
    trs.rotation = nkw_quat_mul(trs.rotation, turn);
    trs.scale = (nkw_vec3){scale, scale, scale};
    nkw_pose_set(pose_span(l.pose, BONES), j, &trs);
}

static float run(const nkw_skin *skin)
{
    const scaled_character c = {skeleton, l.inverse_bind, pose_view(l.bind, BONES), pose_span(l.scaled, BONES),
                                l.models, l.stretch, l.inverse, l.rigid};
    const nkw_vertices_view in = {{l.positions, 0}, {l.normals, 0}, {NULL, 0}, {NULL, 0}};
    const nkw_vertices_span out = {{l.out, 0}, {l.out_normals, 0}, {NULL, 0}, {NULL, 0}};
    return scaled_skin(&c, pose_view(l.pose, BONES), skin, in, out);
}

/* By nkw_skin_linear of the joint matrices, or by nkw_skin_dual_quat of them. Returns what dual quaternions drop. */
static float run_plain(const nkw_skin *skin, int is_dual)
{
    const nkw_vertices_view in = {{l.positions, 0}, {l.normals, 0}, {NULL, 0}, {NULL, 0}};
    const nkw_vertices_span out = {{l.want, 0}, {l.want_normals, 0}, {NULL, 0}, {NULL, 0}};
    const nkw_skin_palette palette = {
        {l.matrices, BONES, NKW_PALETTE_MAT4}, {NULL, 0, NKW_PALETTE_NORMAL_MAT3}, {0, 1, 0}};
    const nkw_palette_span matrices = {l.matrices, BONES, NKW_PALETTE_MAT4},
                           rigid = {l.rigid, BONES, NKW_PALETTE_DUAL_QUAT};
    const nkw_palette_view dual = {l.rigid, BONES, NKW_PALETTE_DUAL_QUAT};
    const nkw_palette_source s = source();
    nkw_skeleton_models_from_pose(&skeleton, pose_view(l.pose, BONES), NULL, NULL, l.models);
    nkw_palette_from_models(&s, matrices);
    nkw_palette_from_models(&s, rigid);
    assert_int_equal(is_dual ? nkw_skin_dual_quat(skin, dual, in, out) : nkw_skin_linear(skin, &palette, in, out),
                     NKW_OK);
    return nkw_palette_residual(&s, NULL);
}

static nkw_skin skin_of(size_t vertices, size_t influences)
{
    const nkw_skin skin = {vertices, influences, {l.joints, BONES, NKW_SKIN_U8},
                           {l.weights, BONES * sizeof(float), NKW_SKIN_F32}};
    return skin;
}

static void expect_same(double tolerance)
{
    for (size_t i = 0; i < SOME; i++) {
        expect_vec3_near(l.out[i], l.want[i], tolerance);
        expect_vec3_near(l.out_normals[i], l.want_normals[i], tolerance);
    }
}

static void one_influence_and_no_rotation_are_linear_blend(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int n = 0; n < 50; n++) {
        const nkw_skin one = skin_of(SOME, 1), all = skin_of(SOME, BONES);
        draw_limb(&r);
        for (size_t j = 0; j < BONES; j++)
            set_joint(j, nkw_quat_identity(), random_between(&r, 0.5f, 2));
        assert_true(run(&all) < 2e-6f);
        assert_true(run_plain(&all, 0) > 1e-3f);
        expect_same(4e-5);
        for (size_t i = 0; i < SOME; i++) {
            l.joints[BONES * i] = (uint8_t)(i % BONES);
            l.weights[BONES * i] = 1;
        }
        for (size_t j = 0; j < BONES; j++)
            set_joint(j, random_rotation(&r), random_between(&r, 0.5f, 2));
        run(&one);
        run_plain(&one, 0);
        expect_same(4e-5);
    }
}

/* Scaled as a whole, it is the dual quaternion skin of the unscaled pose, times the scale. */
static void without_scale_and_scaled_as_a_whole_it_is_dual_quaternion_skinning(void **state)
{
    (void)state;
    random_source r = random_from(2);
    for (int n = 0; n < 50; n++) {
        const nkw_skin all = skin_of(SOME, BONES);
        nkw_quat turns[BONES];
        draw_limb(&r);
        for (size_t j = 0; j < BONES; j++)
            set_joint(j, turns[j] = random_near(&r, nkw_quat_identity(), 0.5f), 1);
        run(&all);
        assert_true(run_plain(&all, 1) < 2e-6f);
        expect_same(4e-5);
        set_joint(0, turns[0], 1.5f);
        const nkw_vec3 root = nkw_pose_get(pose_view(l.pose, BONES), 0).translation;
        for (size_t i = 0; i < SOME; i++)
            l.want[i] = nkw_vec3_add(root, nkw_vec3_scale(nkw_vec3_sub(l.want[i], root), 1.5f));
        run(&all);
        expect_same(6e-5);
        expect_near(run_plain(&all, 1), 0.5, 2e-6);
    }
}

/* The knee, with weights of both bones, is where the model of the shank is; its palette alone tears it away. */
static void an_elbow_stays_at_its_joint_when_its_bones_are_scaled(void **state)
{
    (void)state;
    random_source r = random_from(3);
    float most = 0;
    for (int n = 0; n < 50; n++) {
        const nkw_skin one = skin_of(1, BONES);
        const float share = random_between(&r, 0, 1);
        draw_limb(&r);
        l.positions[0] = nkw_mat4_translation(&l.models[2]);
        l.weights[0] = 0;
        l.weights[1] = share;
        l.weights[2] = 1 - share;
        set_joint(1, random_near(&r, nkw_quat_identity(), 0.5f), random_between(&r, 0.5f, 2));
        set_joint(2, random_near(&r, nkw_quat_identity(), 1), random_between(&r, 0.5f, 2));
        run(&one);
        expect_vec3_near(l.out[0], nkw_mat4_translation(&l.models[2]), 2e-5);
        run_plain(&one, 1);
        most = nkw_max(most, nkw_vec3_length(nkw_vec3_sub(l.out[0], l.want[0])));
    }
    assert_true(most > 0.1f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_influence_and_no_rotation_are_linear_blend),
        cmocka_unit_test(without_scale_and_scaled_as_a_whole_it_is_dual_quaternion_skinning),
        cmocka_unit_test(an_elbow_stays_at_its_joint_when_its_bones_are_scaled),
    };
    return cmocka_run_group_tests_name("skin_page", tests, NULL, NULL);
}
