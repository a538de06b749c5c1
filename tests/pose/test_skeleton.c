/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "random.h"
#include "support/expect.h"
#include "support/views.h"

#define MOST 150

/* root 0; 1 and 4 below it, 2 and 3 below 1; root 5 with 6 */
static const int32_t small[7] = {NKW_NO_JOINT, 0, 1, 1, 0, NKW_NO_JOINT, 5};

static const nkw_mat4 some_root = {{0.5f, 1, -2, 7, 3, 0.25f, 1, 7, -1, 1, 4, 7, 10, -20, 30, 7}};

typedef struct character {
    int32_t parents[MOST];
    nkw_skeleton skeleton;
    nkw_trs trs[MOST];
    nkw_mat4 locals[MOST], models[MOST];
    float pose[NKW_POSE_FLOATS(MOST)];
} character;

/* Parents before children, in no order otherwise; one joint in nine is a root. Padding holds NaN. */
static void draw(random_source *r, size_t joints, character *c)
{
    for (size_t j = 0; j < joints; j++) {
        uint64_t bits = random_bits(r);
        size_t chosen = bits % 3 ? j - 1 : (size_t)(bits >> 8) % (j ? j : 1);
        c->parents[j] = j == 0 || bits % 9 == 0 ? NKW_NO_JOINT : (int32_t)chosen;
        c->trs[j].translation = random_vec3(r, -5, 5);
        c->trs[j].rotation = random_rotation(r);
        c->trs[j].scale = random_vec3(r, 0.5f, 2);
        c->locals[j] = nkw_mat4_from_trs(&c->trs[j]);
    }
    nkw_pose_from_trs(c->trs, pose_span(c->pose, joints));
    for (size_t k = 0; k < 10; k++)
        for (size_t j = joints; j < NKW_POSE_STRIDE(joints); j++)
            c->pose[k * NKW_POSE_STRIDE(joints) + j] = NAN;
    c->skeleton.parents = c->parents;
    c->skeleton.joint_count = joints;
}

/* The definition, joint by joint. */
static void compose(const character *c, const nkw_mat4 *root, nkw_mat4 *models)
{
    for (size_t j = 0; j < c->skeleton.joint_count; j++) {
        const nkw_mat4 *parent = c->parents[j] < 0 ? root : &models[c->parents[j]];
        models[j] = parent ? nkw_mat4_mul_affine(parent, &c->locals[j]) : c->locals[j];
    }
}

static void expect_matrices(const nkw_mat4 *got, const nkw_mat4 *want, size_t count)
{
    for (size_t j = 0; j < count; j++)
        expect_floats_bits(got[j].m, want[j].m, 16);
}

static nkw_mat4 moved(float x, float y, float z)
{
    nkw_mat4 m = nkw_mat4_identity();
    m.m[12] = x;
    m.m[13] = y;
    m.m[14] = z;
    return m;
}

static void fill(nkw_mat4 *m, size_t count, float value)
{
    for (size_t j = 0; j < count; j++)
        for (size_t i = 0; i < 16; i++)
            m[j].m[i] = value;
}

static void models_are_the_products_along_the_chain_bit_for_bit(void **state)
{
    (void)state;
    random_source r = random_from(1);
    static character c;
    static nkw_mat4 want[MOST];
    for (size_t joints = 1; joints <= MOST; joints++) {
        draw(&r, joints, &c);
        const nkw_mat4 *root = joints % 2 ? &some_root : NULL;
        compose(&c, root, want);
        nkw_skeleton_models_from_pose(&c.skeleton, pose_view(c.pose, c.skeleton.joint_count), root, NULL, c.models);
        expect_matrices(c.models, want, joints);
        fill(c.models, joints, 9);
        nkw_skeleton_models_from_locals(&c.skeleton, c.locals, root, NULL, c.models);
        expect_matrices(c.models, want, joints);
        nkw_skeleton_models_from_locals(&c.skeleton, c.locals, root, NULL, c.locals);
        expect_matrices(c.locals, want, joints);
    }
}

static void nothing_is_written_behind_the_last_joint(void **state)
{
    (void)state;
    random_source r = random_from(2);
    static character c;
    nkw_mat4 guard;
    fill(&guard, 1, 9);
    for (size_t joints = 1; joints < 70; joints++) {
        draw(&r, joints, &c);
        fill(c.models, MOST, 9);
        nkw_skeleton_models_from_pose(&c.skeleton, pose_view(c.pose, c.skeleton.joint_count), NULL, NULL, c.models);
        update_models_from_pose(&c.skeleton, c.pose, NULL, 0, MOST, c.models);
        update_models_from_locals(&c.skeleton, c.locals, NULL, 0, MOST, c.models);
        expect_floats_bits(c.models[joints].m, guard.m, 16);
    }
}

static void root_joints_without_a_root_matrix_are_their_local_matrices(void **state)
{
    (void)state;
    const int32_t parents[1] = {NKW_NO_JOINT};
    const nkw_skeleton skeleton = {parents, 1};
    nkw_trs trs = {{-0.0f, 1, -0.0f}, {0, 0, 0, 1}, {-1, 0, 1}};
    nkw_mat4 want = nkw_mat4_from_trs(&trs), got, open = want;
    float pose[NKW_POSE_FLOATS(1)];
    nkw_pose_from_trs(&trs, pose_span(pose, 1));
    nkw_skeleton_models_from_pose(&skeleton, pose_view(pose, skeleton.joint_count), NULL, NULL, &got);
    expect_floats_bits(got.m, want.m, 16);
    for (size_t i = 3; i < 16; i += 4)
        open.m[i] = NAN;
    nkw_skeleton_models_from_locals(&skeleton, &open, NULL, NULL, &got);
    expect_floats_bits(got.m, want.m, 16);
}

static void last_rows_are_not_read_and_come_out_exact(void **state)
{
    (void)state;
    random_source r = random_from(3);
    static character c;
    static nkw_mat4 want[MOST];
    draw(&r, 40, &c);
    compose(&c, &some_root, want);
    for (size_t j = 0; j < 40; j++)
        c.locals[j].m[3] = c.locals[j].m[7] = c.locals[j].m[11] = c.locals[j].m[15] = INFINITY;
    nkw_skeleton_models_from_locals(&c.skeleton, c.locals, &some_root, NULL, c.models);
    expect_matrices(c.models, want, 40);
    c.pose[0] = INFINITY;
    nkw_skeleton_models_from_pose(&c.skeleton, pose_view(c.pose, c.skeleton.joint_count), &some_root, NULL, c.models);
    for (size_t j = 0; j < 40; j++)
        for (size_t i = 3; i < 16; i += 4)
            expect_bits(c.models[j].m[i], i == 15 ? 1.0f : 0.0f);
}

static void the_root_matrix_is_applied_once(void **state)
{
    (void)state;
    const nkw_skeleton skeleton = {small, 7};
    nkw_mat4 locals[7], models[7], root = moved(100, 0, 0);
    for (int j = 0; j < 7; j++)
        locals[j] = moved(0, 1, 0);
    nkw_skeleton_models_from_locals(&skeleton, locals, &root, NULL, models);
    const float heights[7] = {1, 2, 3, 3, 2, 1, 2};
    for (int j = 0; j < 7; j++) {
        expect_bits(models[j].m[12], 100);
        expect_bits(models[j].m[13], heights[j]);
    }
}

/* The frames of the article: 10 along x, and 7 more. */
static void child_frames_add_to_those_of_their_parents(void **state)
{
    (void)state;
    const int32_t parents[2] = {NKW_NO_JOINT, 0};
    const nkw_skeleton skeleton = {parents, 2};
    nkw_mat4 locals[2] = {moved(10, 0, 0), moved(7, 0, 0)}, models[2], world = moved(-10, 0, 0);
    nkw_skeleton_models_from_locals(&skeleton, locals, NULL, NULL, models);
    expect_bits(models[1].m[12], 17);
    nkw_skeleton_models_from_locals(&skeleton, locals, &world, NULL, models);
    expect_bits(models[0].m[12], 0);
    expect_bits(models[1].m[12], 7);
}

/* docs/subjects/pose/skeleton.md */
static void the_four_joints_of_the_page_have_its_numbers(void **state)
{
    (void)state;
    const int32_t parents[4] = {NKW_NO_JOINT, 0, 1, 0};
    const nkw_skeleton skeleton = {parents, 4};
    const nkw_trs trs[4] = {
        {{0, 1, 0}, {0, 0, 0, 1}, {1, 1, 1}},
        {{2, 0, 0}, {0, 0, 0.70710678f, 0.70710678f}, {1, 1, 1}},
        {{3, 0, 0}, {0, 0, 0, 1}, {1, 1, 1}},
        {{0, 2, 0}, {0, 0, 0, 1}, {1, 1, 1}},
    };
    nkw_mat4 want[4] = {
        {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 1, 0, 1}},
        {{0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 2, 1, 0, 1}},
        {{0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 2, 4, 0, 1}},
        {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 3, 0, 1}},
    };
    float pose[NKW_POSE_FLOATS(4)];
    nkw_mat4 models[4], root = moved(100, 0, 0);
    nkw_pose_from_trs(trs, pose_span(pose, 4));
    nkw_skeleton_models_from_pose(&skeleton, pose_view(pose, skeleton.joint_count), NULL, NULL, models);
    for (int j = 0; j < 4; j++)
        expect_floats_near(models[j].m, want[j].m, 16, 4e-7);
    nkw_skeleton_models_from_pose(&skeleton, pose_view(pose, skeleton.joint_count), &root, NULL, models);
    for (int j = 0; j < 4; j++) {
        want[j].m[12] += 100;
        expect_floats_near(models[j].m, want[j].m, 16, 4e-7);
    }
}

static void shear_survives(void **state)
{
    (void)state;
    const int32_t parents[2] = {NKW_NO_JOINT, 0};
    const nkw_skeleton skeleton = {parents, 2};
    nkw_trs trs[2] = {nkw_trs_identity(), nkw_trs_identity()};
    trs[0].scale.x = 2;
    trs[1].rotation = nkw_quat_from_axis_angle((nkw_vec3){0, 0, 1}, 0.7853982f);
    float pose[NKW_POSE_FLOATS(2)];
    nkw_mat4 models[2];
    nkw_pose_from_trs(trs, pose_span(pose, 2));
    nkw_skeleton_models_from_pose(&skeleton, pose_view(pose, skeleton.joint_count), NULL, NULL, models);
    const float half = 0.70710678f;
    const float want[8] = {2 * half, half, 0, 0, -2 * half, half, 0, 0};
    expect_floats_near(models[1].m, want, 8, 3e-7);
    assert_true(pose_from_models(&skeleton, models, NULL, pose) < 1e-6f);
    const int32_t roots[2] = {NKW_NO_JOINT, NKW_NO_JOINT};
    const nkw_skeleton flat = {roots, 2};
    assert_true(pose_from_models(&flat, models, NULL, pose) > 0.1f);
}

static void an_update_of_a_subtree_gives_the_whole_again(void **state)
{
    (void)state;
    random_source r = random_from(4);
    static character c;
    static nkw_mat4 want[MOST];
    for (size_t from = 0; from < 90; from++) {
        int32_t to[90], back[90], parents[90];
        draw(&r, 90, &c);
        assert_int_equal(nkw_skeleton_from_parents(c.parents, 90, to, back, parents, NULL), NKW_OK);
        memcpy(c.parents, parents, sizeof parents);
        size_t end = nkw_skeleton_subtree_end(&c.skeleton, from);
        nkw_skeleton_models_from_pose(&c.skeleton, pose_view(c.pose, c.skeleton.joint_count), &some_root, NULL,
                                      c.models);
        c.trs[from].translation.x += 1;
        c.locals[from] = nkw_mat4_from_trs(&c.trs[from]);
        nkw_pose_set(pose_span(c.pose, 90), from, &c.trs[from]);
        compose(&c, &some_root, want);
        nkw_mat4 before[MOST];
        memcpy(before, c.models, sizeof before);
        update_models_from_pose(&c.skeleton, c.pose, &some_root, from, end, c.models);
        expect_matrices(c.models, want, 90);
        update_models_from_locals(&c.skeleton, c.locals, &some_root, from, end, before);
        expect_matrices(before, want, 90);
    }
}

static void an_update_touches_its_range_alone(void **state)
{
    (void)state;
    random_source r = random_from(5);
    static character c;
    static nkw_mat4 want[MOST];
    draw(&r, MOST, &c);
    compose(&c, NULL, want);
    for (int k = 0; k < 200; k++) {
        size_t from = (size_t)(random_bits(&r) % MOST), to = (size_t)(random_bits(&r) % MOST);
        nkw_mat4 guard;
        fill(&guard, 1, 9);
        fill(c.models, MOST, 9);
        memcpy(c.models, want, from * sizeof want[0]);
        update_models_from_pose(&c.skeleton, c.pose, NULL, from, to, c.models);
        expect_matrices(c.models, want, from > to ? from : to);
        for (size_t j = from > to ? from : to; j < MOST; j++)
            expect_floats_bits(c.models[j].m, guard.m, 16);
    }
}

static void subtree_ends_are_those_of_depth_first_order(void **state)
{
    (void)state;
    const nkw_skeleton skeleton = {small, 7};
    const size_t want[8] = {5, 4, 3, 4, 5, 7, 7, 7};
    for (size_t j = 0; j < 8; j++)
        assert_int_equal(nkw_skeleton_subtree_end(&skeleton, j), want[j]);
    const int32_t broad[5] = {NKW_NO_JOINT, 0, 0, 1, 2};
    const nkw_skeleton other = {broad, 5};
    assert_int_equal(nkw_skeleton_subtree_end(&other, 1), 2);
    assert_int_equal(nkw_skeleton_subtree_end(&other, 2), 3);
    assert_int_equal(nkw_skeleton_subtree_end(&other, 0), 5);
}

static void parents_that_are_not_before_their_joint_make_roots(void **state)
{
    (void)state;
    const int32_t wild[6] = {0, 2, INT32_MIN, INT32_MAX, 6, 3}, tame[6] = {-1, -1, -1, -1, -1, 3};
    const nkw_skeleton skeleton = {wild, 6}, same = {tame, 6};
    random_source r = random_from(6);
    static character c;
    draw(&r, 6, &c);
    nkw_mat4 got[6], want[6];
    float a[NKW_POSE_FLOATS(6)], b[NKW_POSE_FLOATS(6)];
    nkw_skeleton_models_from_pose(&skeleton, pose_view(c.pose, skeleton.joint_count), &some_root, NULL, got);
    nkw_skeleton_models_from_pose(&same, pose_view(c.pose, same.joint_count), &some_root, NULL, want);
    expect_matrices(got, want, 6);
    nkw_skeleton_models_from_locals(&skeleton, c.locals, NULL, NULL, got);
    expect_matrices(got, c.locals, 5);
    nkw_skeleton_locals_from_models(&skeleton, c.locals, &some_root, got);
    nkw_skeleton_locals_from_models(&same, c.locals, &some_root, want);
    expect_matrices(got, want, 6);
    pose_from_models(&skeleton, c.locals, NULL, a);
    pose_from_models(&same, c.locals, NULL, b);
    expect_floats_bits(a, b, NKW_POSE_FLOATS(6));
    for (size_t j = 0; j < 6; j++)
        assert_int_equal(nkw_skeleton_subtree_end(&skeleton, j), nkw_skeleton_subtree_end(&same, j));
}

static void locals_come_back_from_models(void **state)
{
    (void)state;
    random_source r = random_from(7);
    static character c;
    static nkw_mat4 got[MOST];
    for (int k = 0; k < 40; k++) {
        draw(&r, 8, &c);
        const nkw_mat4 *root = k % 2 ? &some_root : NULL;
        nkw_skeleton_models_from_pose(&c.skeleton, pose_view(c.pose, c.skeleton.joint_count), root, NULL, c.models);
        nkw_skeleton_locals_from_models(&c.skeleton, c.models, root, got);
        for (size_t j = 0; j < 8; j++)
            expect_floats_near(got[j].m, c.locals[j].m, 16, 2e-3);
        nkw_skeleton_locals_from_models(&c.skeleton, c.models, root, c.models);
        expect_matrices(c.models, got, 8);
    }
}

static void locals_are_those_of_the_single_functions_at_every_count(void **state)
{
    (void)state;
    random_source r = random_from(17);
    static character c;
    static nkw_mat4 got[41], in_place[40];
    for (size_t n = 1; n <= 40; n++) {
        draw(&r, n, &c);
        const nkw_mat4 *root = n % 2 ? &some_root : NULL, guard = moved(7, 7, 7);
        nkw_skeleton_models_from_pose(&c.skeleton, pose_view(c.pose, c.skeleton.joint_count), root, NULL, c.models);
        for (size_t k = 4; k < 8; k++)
            c.models[n / 3].m[k] *= n % 5 ? 1.0f : 0.0f;
        memcpy(in_place, c.models, n * sizeof *in_place);
        got[n] = guard;
        nkw_skeleton_locals_from_models(&c.skeleton, c.models, root, got);
        nkw_skeleton_locals_from_models(&c.skeleton, in_place, root, in_place);
        expect_matrices(in_place, got, n);
        expect_matrices(&got[n], &guard, 1);
        for (size_t j = 0; j < n; j++) {
            const nkw_mat4 *parent = c.skeleton.parents[j] < 0 ? root : &c.models[c.skeleton.parents[j]];
            nkw_mat4 want = c.models[j];
            if (parent) {
                nkw_mat4 inverse = nkw_mat4_inverse_affine(parent);
                want = nkw_mat4_mul_affine(&inverse, &c.models[j]);
            }
            expect_matrices(&got[j], &want, 1);
        }
    }
}

static void models_come_back_from_the_pose_of_models(void **state)
{
    (void)state;
    random_source r = random_from(8);
    static character c;
    static nkw_mat4 got[MOST];
    for (int k = 0; k < 40; k++) {
        draw(&r, 20, &c);
        for (size_t j = 0; j < 20; j++)
            c.trs[j].scale = (nkw_vec3){1, 1, 1};
        nkw_pose_from_trs(c.trs, pose_span(c.pose, 20));
        nkw_skeleton_models_from_pose(&c.skeleton, pose_view(c.pose, c.skeleton.joint_count), NULL, NULL, c.models);
        assert_true(pose_from_models(&c.skeleton, c.models, NULL, c.pose) < 1e-5f);
        nkw_skeleton_models_from_pose(&c.skeleton, pose_view(c.pose, c.skeleton.joint_count), NULL, NULL, got);
        for (size_t j = 0; j < 20; j++)
            expect_floats_near(got[j].m, c.models[j].m, 16, 1e-4);
    }
}

static void below_a_singular_parent_locals_are_zero(void **state)
{
    (void)state;
    const int32_t parents[2] = {NKW_NO_JOINT, 0};
    const nkw_skeleton skeleton = {parents, 2};
    nkw_mat4 models[2] = {moved(1, 2, 3), moved(4, 5, 6)}, locals[2];
    models[0].m[5] = 0;
    nkw_skeleton_locals_from_models(&skeleton, models, NULL, locals);
    expect_floats_bits(locals[0].m, models[0].m, 16);
    for (size_t i = 0; i < 16; i++)
        expect_bits(locals[1].m[i], i == 15 ? 1.0f : 0.0f);
    float pose[NKW_POSE_FLOATS(2)];
    pose_from_models(&skeleton, models, NULL, pose);
    nkw_trs trs = nkw_pose_get(pose_view(pose, 2), 1);
    expect_quat_bits(trs.rotation, ((nkw_quat){0, 0, 0, 1}));
    expect_vec3_bits(trs.scale, ((nkw_vec3){0, 0, 0}));
}

/* Under a rotated parent the block of the flat joint is singular to rounding only. */
static void below_a_flat_joint_of_a_rotated_parent_locals_are_zero(void **state)
{
    (void)state;
    const int32_t parents[3] = {NKW_NO_JOINT, 0, 1};
    const nkw_skeleton skeleton = {parents, 3};
    random_source r = random_from(31);
    for (int i = 0; i < 1000; i++) {
        nkw_trs t[3] = {{{1, 2, 3}, random_rotation(&r), {1, 1, 1}},
                        {{0, 1, 0}, random_rotation(&r), {1, 0, 1}},
                        {{0, 1, 0}, random_rotation(&r), {1, 1, 1}}};
        nkw_mat4 models[3];
        for (int j = 0; j < 3; j++) {
            nkw_mat4 local = nkw_mat4_from_trs(&t[j]);
            models[j] = j ? nkw_mat4_mul_affine(&models[j - 1], &local) : local;
        }
        nkw_mat4 below[2] = {models[2], nkw_mat4_mul_affine(&models[2], &models[0])};
        float pose[NKW_POSE_FLOATS(2)];
        const int32_t chain[2] = {NKW_NO_JOINT, 0};
        const nkw_skeleton pair = {chain, 2};
        pose_from_models(&pair, below, NULL, pose);
        nkw_trs got = nkw_pose_get(pose_view(pose, 2), 1);
        expect_vec3_bits(got.scale, ((nkw_vec3){0, 0, 0}));
        expect_vec3_bits(got.translation, ((nkw_vec3){0, 0, 0}));
        nkw_mat4 locals[3];
        nkw_skeleton_locals_from_models(&skeleton, models, NULL, locals);
        expect_floats_near(locals[2].m, (float[12]){0}, 12, 0);
    }
}

static void a_model_of_nan_shows_in_what_the_pose_could_not_hold(void **state)
{
    (void)state;
    const int32_t parents[3] = {NKW_NO_JOINT, NKW_NO_JOINT, NKW_NO_JOINT};
    const nkw_skeleton skeleton = {parents, 3};
    nkw_mat4 models[3] = {moved(1, 2, 3), moved(4, 5, 6), moved(7, 8, 9)};
    float pose[NKW_POSE_FLOATS(3)];
    models[1].m[4] = NAN;
    assert_true(isnan(pose_from_models(&skeleton, models, NULL, pose)));
}

static void expect_skeleton(const int32_t *parents, size_t count, nkw_result result, size_t joint)
{
    const nkw_skeleton skeleton = {parents, count};
    size_t bad = 99;
    assert_int_equal(nkw_skeleton_validate(&skeleton, &bad), result);
    assert_int_equal(bad, joint);
    assert_int_equal(nkw_skeleton_validate(&skeleton, NULL), result);
}

static void validate_names_the_first_offender(void **state)
{
    (void)state;
    const int32_t self[3] = {NKW_NO_JOINT, 1, 0}, later[4] = {NKW_NO_JOINT, 0, 3, 7}, far[4] = {NKW_NO_JOINT, 0, 4, 3};
    const int32_t negative[2] = {-2, 0}, first[1] = {0};
    expect_skeleton(small, 7, NKW_OK, 0);
    expect_skeleton(small, 0, NKW_EMPTY, 0);
    expect_skeleton(self, 3, NKW_NOT_ORDERED, 1);
    expect_skeleton(later, 4, NKW_NOT_ORDERED, 2);
    expect_skeleton(far, 4, NKW_OUT_OF_RANGE, 2);
    expect_skeleton(negative, 2, NKW_OUT_OF_RANGE, 0);
    expect_skeleton(first, 1, NKW_NOT_ORDERED, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(models_are_the_products_along_the_chain_bit_for_bit),
        cmocka_unit_test(nothing_is_written_behind_the_last_joint),
        cmocka_unit_test(root_joints_without_a_root_matrix_are_their_local_matrices),
        cmocka_unit_test(last_rows_are_not_read_and_come_out_exact),
        cmocka_unit_test(the_root_matrix_is_applied_once),
        cmocka_unit_test(child_frames_add_to_those_of_their_parents),
        cmocka_unit_test(the_four_joints_of_the_page_have_its_numbers),
        cmocka_unit_test(shear_survives),
        cmocka_unit_test(an_update_of_a_subtree_gives_the_whole_again),
        cmocka_unit_test(an_update_touches_its_range_alone),
        cmocka_unit_test(subtree_ends_are_those_of_depth_first_order),
        cmocka_unit_test(parents_that_are_not_before_their_joint_make_roots),
        cmocka_unit_test(locals_come_back_from_models),
        cmocka_unit_test(locals_are_those_of_the_single_functions_at_every_count),
        cmocka_unit_test(models_come_back_from_the_pose_of_models),
        cmocka_unit_test(below_a_singular_parent_locals_are_zero),
        cmocka_unit_test(below_a_flat_joint_of_a_rotated_parent_locals_are_zero),
        cmocka_unit_test(a_model_of_nan_shows_in_what_the_pose_could_not_hold),
        cmocka_unit_test(validate_names_the_first_offender),
    };
    return cmocka_run_group_tests_name("skeleton", tests, NULL, NULL);
}
