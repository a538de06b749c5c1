/* SPDX-License-Identifier: MIT */
#include "support/poses.h"
#include "support/views.h"

static nkw_trs expected_blend(const float *a, const float *b, size_t j, float t, int slerp)
{
    nkw_trs p = nkw_pose_get(pose_view(a, JOINTS), j), q = nkw_pose_get(pose_view(b, JOINTS), j), r;
    r.translation = nkw_vec3_lerp(p.translation, q.translation, t);
    r.scale = nkw_vec3_lerp(p.scale, q.scale, t);
    r.rotation = slerp ? nkw_quat_slerp(p.rotation, q.rotation, t) : nkw_quat_nlerp(p.rotation, q.rotation, t);
    return r;
}

static void expect_blend(const float *a, const float *b, float t, const float *mask)
{
    static float got[2][FLOATS];
    nkw_pose_blend(pose_view(a, JOINTS), pose_view(b, JOINTS), t, mask_view(mask, JOINTS), pose_span(got[0], JOINTS));
    nkw_pose_blend_slerp(pose_view(a, JOINTS), pose_view(b, JOINTS), t, mask_view(mask, JOINTS),
                         pose_span(got[1], JOINTS));
    for (int slerp = 0; slerp < 2; slerp++)
        for (size_t j = 0; j < JOINTS; j++) {
            float m = mask ? nkw_clamp(mask[j] == mask[j] ? mask[j] : 0.0f, 0.0f, 1.0f) : 1.0f;
            nkw_trs want = expected_blend(a, b, j, t == t ? t * m : 0.0f, slerp),
                    is = nkw_pose_get(pose_view(got[slerp], JOINTS), j);
            expect_floats_bits(&is.translation.x, &want.translation.x, 10);
        }
}

static void two_poses_blend_as_lerp_nlerp_and_slerp_bit_for_bit(void **state)
{
    (void)state;
    random_source r = random_from(1);
    static float a[FLOATS], b[FLOATS], mask[STRIDE];
    draw(&r, a);
    draw(&r, b);
    draw_mask(&r, mask);
    static const float ts[] = {0.0f, 1.0f, 0.5f, 0.3f, 0.8f, -1.0f, 2.5f, 1e-30f, NAN};
    for (size_t i = 0; i < sizeof ts / sizeof ts[0]; i++) {
        expect_blend(a, b, ts[i], NULL);
        expect_blend(a, b, ts[i], mask);
    }
}

static void expect_nlerp(const float *a, const float *b)
{
    for (float t = 0.0f; t <= 1.0f; t += 0.25f) {
        static float got[FLOATS];
        nkw_pose_blend(pose_view(a, JOINTS), pose_view(b, JOINTS), t, mask_view(NULL, JOINTS), pose_span(got, JOINTS));
        for (size_t j = 0; j < JOINTS; j++)
            expect_quat_bits(nkw_pose_get(pose_view(got, JOINTS), j).rotation, expected_blend(a, b, j, t, 0).rotation);
    }
}

/* Each among unit rotations: one such joint is enough for the general path. */
static void rotations_of_any_length_blend_as_nlerp_too(void **state)
{
    (void)state;
    static const float lengths[] = {0.0f, 1e-30f, 0.5f, 3.0f, 1e30f};
    static const size_t joints[] = {0, 7, 90, JOINTS - 1};
    random_source r = random_from(2);
    static float a[FLOATS], b[FLOATS];
    for (size_t i = 0; i < sizeof lengths / sizeof lengths[0]; i++)
        for (size_t k = 0; k < sizeof joints / sizeof joints[0]; k++) {
            draw(&r, a);
            draw(&r, b);
            for (size_t c = 3; c < 7; c++) {
                a[c * STRIDE + joints[k]] *= lengths[i];
                b[c * STRIDE + joints[k]] *= lengths[i];
                b[c * STRIDE + 7] = a[c * STRIDE + 7];
                b[c * STRIDE + 8] = -a[c * STRIDE + 8];
            }
            expect_nlerp(a, b);
        }
    b[3 * STRIDE + 60] = INFINITY;
    expect_nlerp(a, b);
}

static void masks_weigh_joint_by_joint(void **state)
{
    (void)state;
    random_source r = random_from(3);
    static float a[FLOATS], b[FLOATS], mask[STRIDE];
    draw(&r, a);
    draw(&r, b);
    draw_mask(&r, mask);
    mask[5] = -2.0f;
    mask[6] = 3.0f;
    mask[7] = NAN;
    mask[8] = INFINITY;
    expect_blend(a, b, 0.75f, mask);
    expect_blend(a, b, 1.0f, mask);
    expect_blend(a, b, NAN, mask);
}

/* As two clips of one model have them: a third of the rotations equal, some of them negated, a fifth the identity. */
static void draw_real(random_source *r, float *a, float *b, float *mask)
{
    static const float parts[4] = {0.0f, 1.0f, 0.5f, 0.8f}, zeros[2] = {0.0f, -0.0f};
    draw(r, a);
    draw(r, b);
    for (size_t j = 0; j < JOINTS; j++) {
        nkw_trs p = nkw_pose_get(pose_view(a, JOINTS), j), q = nkw_pose_get(pose_view(b, JOINTS), j);
        nkw_quat still = {zeros[random_bits(r) % 2], 0.0f, zeros[random_bits(r) % 2], 1.0f};
        if (random_bits(r) % 5 == 0)
            p.rotation = still;
        if (random_bits(r) % 3 == 0)
            q.rotation = random_bits(r) % 2 ? p.rotation : nkw_quat_negate(p.rotation);
        if (random_bits(r) % 2)
            q.translation = p.translation;
        nkw_pose_set(pose_span(a, JOINTS), j, &p);
        nkw_pose_set(pose_span(b, JOINTS), j, &q);
        mask[j] = parts[random_bits(r) % 4];
    }
}

static void poses_of_one_model_blend_bit_for_bit_as_each_joint_alone(void **state)
{
    (void)state;
    random_source r = random_from(5);
    static float a[FLOATS], b[FLOATS], mask[STRIDE];
    for (int i = 0; i < 500; i++) {
        draw_real(&r, a, b, mask);
        expect_blend(a, b, random_unit(&r), NULL);
        expect_blend(a, b, 1.0f, mask);
        expect_blend(a, b, random_between(&r, -2.0f, 2.0f), mask);
    }
}

static void the_ends_are_the_poses_bit_for_bit(void **state)
{
    (void)state;
    random_source r = random_from(4);
    static float a[FLOATS], b[FLOATS], out[FLOATS];
    draw(&r, a);
    draw(&r, b);
    a[2] = -0.0f;
    nkw_pose_view from = pose_view(a, JOINTS), to = pose_view(b, JOINTS);
    nkw_mask_view none = mask_view(NULL, 0);
    for (int slerp = 0; slerp < 2; slerp++) {
        (slerp ? nkw_pose_blend_slerp : nkw_pose_blend)(from, to, 0.0f, none, pose_span(out, JOINTS));
        expect_poses_bits(out, a);
        (slerp ? nkw_pose_blend_slerp : nkw_pose_blend)(from, to, 1.0f, none, pose_span(out, JOINTS));
        for (size_t j = 0; j < JOINTS; j++) {
            nkw_trs got = nkw_pose_get(pose_view(out, JOINTS), j), want = nkw_pose_get(pose_view(b, JOINTS), j);
            float side = nkw_quat_dot(nkw_pose_get(pose_view(a, JOINTS), j).rotation, want.rotation);
            want.rotation = side < 0.0f ? nkw_quat_negate(want.rotation) : want.rotation;
            expect_floats_bits(&got.translation.x, &want.translation.x, 10);
        }
    }
}

static void nothing_is_touched_without_joints(void **state)
{
    (void)state;
    float pose[1] = {7}, out[1] = {9};
    nkw_pose_layer layer = {pose_view(pose, 0), 1.0f, mask_view(NULL, 0)};
    const int32_t pair[1] = {0};
    nkw_pose_blend(pose_view(pose, 0), pose_view(pose, 0), 0.5f, mask_view(NULL, 0), pose_span(out, 0));
    nkw_pose_blend_slerp(pose_view(pose, 0), pose_view(pose, 0), 0.5f, mask_view(pose, 0), pose_span(out, 0));
    nkw_pose_layers_blend(&layer, 1, pose_view(pose, 0), 0.1f, pose_span(out, 0));
    nkw_pose_layers_blend(NULL, 3, pose_view(NULL, 0), 0.1f, pose_span(out, 0));
    nkw_pose_additive_build(pose_view(pose, 0), pose_view(pose, 0), NKW_ADDITIVE_LOCAL, pose_span(out, 0));
    nkw_pose_additive_apply(pose_view(pose, 0), pose_view(pose, 0), 1.0f, mask_view(NULL, 0), NKW_ADDITIVE_LOCAL,
                            pose_span(out, 0));
    nkw_pose_mirror(pose_view(pose, 0), pair, NKW_MIRROR_X, pose_span(out, 0), NULL);
    mask_from_subtree(pair, 0, 0, out);
    expect_bits(out[0], 9.0f);
}

static void poses_of_different_joints_are_not_blended(void **state)
{
    (void)state;
    static float a[FLOATS], out[FLOATS], mask[NKW_POSE_STRIDE(JOINTS)];
    nkw_pose_view whole = pose_view(a, JOINTS), less = pose_view(a, JOINTS - 1);
    nkw_mask_view none = mask_view(NULL, 0), thin = mask_view(mask, JOINTS - 1);
    nkw_pose_span to = pose_span(out, JOINTS);
    int32_t pair[JOINTS] = {0};
    nkw_pose_identity(pose_span(a, JOINTS));
    out[0] = 9.0f;
    assert_int_equal(nkw_pose_blend(less, whole, 0.5f, none, to), NKW_MISMATCHED);
    assert_int_equal(nkw_pose_blend(whole, less, 0.5f, none, to), NKW_MISMATCHED);
    assert_int_equal(nkw_pose_blend(whole, whole, 0.5f, thin, to), NKW_MISMATCHED);
    assert_int_equal(nkw_pose_blend_slerp(whole, less, 0.5f, none, to), NKW_MISMATCHED);
    assert_int_equal(nkw_pose_blend_slerp(whole, whole, 0.5f, thin, to), NKW_MISMATCHED);
    assert_int_equal(nkw_pose_layers_blend(NULL, 0, less, 0.5f, to), NKW_MISMATCHED);
    assert_int_equal(nkw_pose_additive_build(whole, less, NKW_ADDITIVE_LOCAL, to), NKW_MISMATCHED);
    assert_int_equal(nkw_pose_additive_apply(whole, less, 1.0f, none, NKW_ADDITIVE_LOCAL, to), NKW_MISMATCHED);
    assert_int_equal(nkw_pose_additive_apply(whole, whole, 1.0f, thin, NKW_ADDITIVE_LOCAL, to), NKW_MISMATCHED);
    assert_int_equal(nkw_pose_mirror(less, pair, NKW_MIRROR_X, to, NULL), NKW_MISMATCHED);
    expect_bits(out[0], 9.0f);
    assert_int_equal(nkw_pose_blend(whole, whole, 0.5f, none, to), NKW_OK);
    expect_bits(out[0], 0.0f);
}

static void writing_stays_within_the_block(void **state)
{
    (void)state;
    for (size_t joints = 1; joints < 40; joints++) {
        float a[NKW_POSE_FLOATS(39)], out[NKW_POSE_FLOATS(39) + 1], mask[NKW_POSE_STRIDE(39)];
        int32_t pair[39];
        nkw_pose_identity(pose_span(a, joints));
        for (size_t j = 0; j < NKW_POSE_STRIDE(39); j++)
            mask[j] = 0.5f;
        for (size_t j = 0; j < joints; j++)
            pair[j] = (int32_t)(joints - 1 - j);
        size_t end = NKW_POSE_FLOATS(joints);
        out[end] = 9.0f;
        nkw_pose_layer layers[2] = {{pose_view(a, joints), 1.0f, mask_view(NULL, 0)},
                                    {pose_view(a, joints), 1.0f, mask_view(mask, joints)}};
        nkw_pose_blend(pose_view(a, joints), pose_view(a, joints), 0.5f, mask_view(NULL, joints),
                       pose_span(out, joints));
        nkw_pose_blend_slerp(pose_view(a, joints), pose_view(a, joints), 0.5f, mask_view(mask, joints),
                             pose_span(out, joints));
        nkw_pose_layers_blend(layers, 2, pose_view(a, joints), 0.5f, pose_span(out, joints));
        nkw_pose_additive_build(pose_view(a, joints), pose_view(a, joints), NKW_ADDITIVE_PARENT,
                                pose_span(out, joints));
        nkw_pose_additive_apply(pose_view(a, joints), pose_view(a, joints), 0.5f, mask_view(mask, joints),
                                NKW_ADDITIVE_PARENT, pose_span(out, joints));
        nkw_pose_mirror(pose_view(a, joints), pair, NKW_MIRROR_Y, pose_span(out, joints), NULL);
        expect_bits(out[end], 9.0f);
    }
}

static void every_function_works_in_place(void **state)
{
    (void)state;
    random_source r = random_from(14);
    static float first[FLOATS], second[FLOATS], want[FLOATS], mask[STRIDE];
    draw(&r, first);
    draw(&r, second);
    draw_mask(&r, mask);
    nkw_pose_blend(pose_view(first, JOINTS), pose_view(second, JOINTS), 0.3f, mask_view(NULL, JOINTS),
                   pose_span(want, JOINTS));
    nkw_pose_blend(pose_view(first, JOINTS), pose_view(second, JOINTS), 0.3f, mask_view(NULL, JOINTS),
                   pose_span(second, JOINTS));
    expect_poses_bits(second, want);
    nkw_pose_blend_slerp(pose_view(second, JOINTS), pose_view(first, JOINTS), 0.3f, mask_view(mask, JOINTS),
                         pose_span(want, JOINTS));
    nkw_pose_blend_slerp(pose_view(second, JOINTS), pose_view(first, JOINTS), 0.3f, mask_view(mask, JOINTS),
                         pose_span(second, JOINTS));
    expect_poses_bits(second, want);
    nkw_pose_additive_build(pose_view(second, JOINTS), pose_view(first, JOINTS), NKW_ADDITIVE_PARENT,
                            pose_span(want, JOINTS));
    nkw_pose_additive_build(pose_view(second, JOINTS), pose_view(first, JOINTS), NKW_ADDITIVE_PARENT,
                            pose_span(second, JOINTS));
    expect_poses_bits(second, want);
    nkw_pose_additive_apply(pose_view(first, JOINTS), pose_view(second, JOINTS), 0.7f, mask_view(mask, JOINTS),
                            NKW_ADDITIVE_PARENT, pose_span(want, JOINTS));
    nkw_pose_additive_apply(pose_view(first, JOINTS), pose_view(second, JOINTS), 0.7f, mask_view(mask, JOINTS),
                            NKW_ADDITIVE_PARENT, pose_span(second, JOINTS));
    expect_poses_bits(second, want);
}

/* differences */

static void expect_round_trip(const float *a, const float *ref, nkw_additive side)
{
    static float delta[FLOATS], back[FLOATS];
    nkw_pose_additive_build(pose_view(a, JOINTS), pose_view(ref, JOINTS), side, pose_span(delta, JOINTS));
    nkw_pose_additive_apply(pose_view(ref, JOINTS), pose_view(delta, JOINTS), 1.0f, mask_view(NULL, JOINTS), side,
                            pose_span(back, JOINTS));
    for (size_t j = 0; j < JOINTS; j++)
        for (size_t c = 0; c < 10; c++) {
            double want = (double)a[c * STRIDE + j], from = (double)ref[c * STRIDE + j];
            double bound = c < 3 ? fabs(want - from) + fabs(want) : c < 7 ? 2.6 : 2 * fabs(want);
            expect_near(back[c * STRIDE + j], want, bound * U);
        }
}

static void applying_a_difference_to_its_reference_gives_the_pose(void **state)
{
    (void)state;
    random_source r = random_from(15);
    static float a[FLOATS], ref[FLOATS];
    for (int round = 0; round < 200; round++) {
        draw(&r, a);
        draw(&r, ref);
        expect_round_trip(a, ref, NKW_ADDITIVE_LOCAL);
        expect_round_trip(a, ref, NKW_ADDITIVE_PARENT);
    }
}

static void near_poses_with_unit_scale_come_back_exactly_but_for_rotations(void **state)
{
    (void)state;
    random_source r = random_from(16);
    static float a[FLOATS], ref[FLOATS], delta[FLOATS];
    draw(&r, a);
    draw(&r, ref);
    for (size_t i = 0; i < 3 * STRIDE; i++) {
        a[i] = ref[i] * random_between(&r, 0.5f, 2.0f);
        ref[7 * STRIDE + i] = i % 2 ? 1.0f : 0.25f;
    }
    nkw_pose_additive_build(pose_view(a, JOINTS), pose_view(ref, JOINTS), NKW_ADDITIVE_LOCAL, pose_span(delta, JOINTS));
    nkw_pose_additive_apply(pose_view(ref, JOINTS), pose_view(delta, JOINTS), 1.0f, mask_view(NULL, JOINTS),
                            NKW_ADDITIVE_LOCAL, pose_span(delta, JOINTS));
    for (size_t c = 0; c < 10; c = c == 2 ? 7 : c + 1)
        expect_floats_bits(delta + c * STRIDE, a + c * STRIDE, JOINTS);
}

static void a_difference_of_weight_zero_leaves_the_base_bit_for_bit(void **state)
{
    (void)state;
    random_source r = random_from(17);
    static float base[FLOATS], delta[FLOATS], out[FLOATS], mask[STRIDE];
    draw(&r, base);
    draw(&r, delta);
    base[4] = -0.0f;
    static const float none[] = {0.0f, -1.0f, NAN};
    for (size_t i = 0; i < 3; i++) {
        nkw_pose_additive_apply(pose_view(base, JOINTS), pose_view(delta, JOINTS), none[i], mask_view(NULL, JOINTS),
                                NKW_ADDITIVE_LOCAL, pose_span(out, JOINTS));
        expect_poses_bits(out, base);
    }
    delta[6] = INFINITY;
    nkw_pose_additive_apply(pose_view(base, JOINTS), pose_view(delta, JOINTS), 1.0f, mask_view(mask, JOINTS),
                            NKW_ADDITIVE_PARENT, pose_span(out, JOINTS));
    expect_poses_bits(out, base);
}

static void sides_are_the_joints_own_axes_and_its_parents(void **state)
{
    (void)state;
    random_source r = random_from(18);
    static float a[FLOATS], ref[FLOATS], base[FLOATS], delta[FLOATS], out[FLOATS];
    draw(&r, a);
    draw(&r, ref);
    draw(&r, base);
    for (int parent = 0; parent < 2; parent++) {
        nkw_additive side = parent ? NKW_ADDITIVE_PARENT : NKW_ADDITIVE_LOCAL;
        nkw_pose_additive_build(pose_view(a, JOINTS), pose_view(ref, JOINTS), side, pose_span(delta, JOINTS));
        nkw_pose_additive_apply(pose_view(base, JOINTS), pose_view(delta, JOINTS), 1.0f, mask_view(NULL, JOINTS), side,
                                pose_span(out, JOINTS));
        for (size_t j = 0; j < JOINTS; j++) {
            nkw_trs p = nkw_pose_get(pose_view(a, JOINTS), j), q = nkw_pose_get(pose_view(ref, JOINTS), j),
                    b = nkw_pose_get(pose_view(base, JOINTS), j);
            nkw_quat back = nkw_quat_conjugate(q.rotation);
            nkw_quat want = parent ? nkw_quat_mul(nkw_quat_mul(p.rotation, back), b.rotation)
                                   : nkw_quat_mul(b.rotation, nkw_quat_mul(back, p.rotation));
            nkw_trs got = nkw_pose_get(pose_view(out, JOINTS), j);
            expect_quat_near(got.rotation, want, 8 * U);
            expect_near(got.translation.x, b.translation.x + (p.translation.x - q.translation.x), 20 * U);
            expect_near(got.scale.z, b.scale.z * (p.scale.z / q.scale.z), 20 * U);
        }
    }
}

static void a_part_of_a_difference_is_a_part_of_each(void **state)
{
    (void)state;
    float base[NKW_POSE_FLOATS(1)], delta[NKW_POSE_FLOATS(1)];
    nkw_quat half = {0.6f, 0.0f, 0.0f, 0.8f}, none = {0.0f, 0.0f, 0.0f, 1.0f};
    nkw_trs b = {{1, 2, 3}, {0, 0, 0, 1}, {1, 2, 4}}, d = {{4, 8, -4}, half, {3, 1, 0.5f}};
    for (int negated = 0; negated < 2; negated++) {
        d.rotation = negated ? nkw_quat_negate(half) : half;
        nkw_pose_from_trs(&b, pose_span(base, 1));
        nkw_pose_from_trs(&d, pose_span(delta, 1));
        nkw_pose_additive_apply(pose_view(base, 1), pose_view(delta, 1), 0.25f, mask_view(NULL, 1), NKW_ADDITIVE_LOCAL,
                                pose_span(base, 1));
        nkw_trs got = nkw_pose_get(pose_view(base, 1), 0);
        expect_vec3_bits(got.translation, ((nkw_vec3){2, 4, 2}));
        expect_vec3_bits(got.scale, ((nkw_vec3){1.5f, 2, 3.5f}));
        nkw_quat want = nkw_quat_nlerp(none, half, 0.25f);
        expect_quat_bits(got.rotation, nkw_quat_mul(b.rotation, negated ? nkw_quat_negate(want) : want));
    }
}

static void zeros_in_the_reference_are_defined(void **state)
{
    (void)state;
    float a[NKW_POSE_FLOATS(1)], ref[NKW_POSE_FLOATS(1)];
    nkw_trs p = {{1, 2, 3}, {0.6f, 0, 0, 0.8f}, {0, 2, 3}}, q = {{0, 0, 0}, {0, 0, 0, 0}, {0, 0, -0.0f}};
    for (int parent = 0; parent < 2; parent++) {
        nkw_pose_from_trs(&p, pose_span(a, 1));
        nkw_pose_from_trs(&q, pose_span(ref, 1));
        nkw_pose_additive_build(pose_view(a, 1), pose_view(ref, 1), parent ? NKW_ADDITIVE_PARENT : NKW_ADDITIVE_LOCAL,
                                pose_span(a, 1));
        nkw_trs got = nkw_pose_get(pose_view(a, 1), 0);
        expect_vec3_bits(got.scale, ((nkw_vec3){1, 1, 1}));
        expect_quat_bits(got.rotation, p.rotation);
    }
}

/* mirror */

static void a_mirror_reflects_points_through_its_plane(void **state)
{
    (void)state;
    random_source r = random_from(19);
    static const nkw_mirror planes[] = {NKW_MIRROR_X, NKW_MIRROR_Y, NKW_MIRROR_Z};
    for (int k = 0; k < 3; k++)
        for (int round = 0; round < 100; round++) {
            float pose[NKW_POSE_FLOATS(1)];
            const int32_t self = 0;
            nkw_trs trs = {random_vec3(&r, -2, 2), random_rotation(&r), random_vec3(&r, 0.5f, 2)};
            nkw_vec3 point = random_vec3(&r, -1, 1),
                     sign = {k == 0 ? -1.0f : 1, k == 1 ? -1.0f : 1, k == 2 ? -1.0f : 1};
            nkw_pose_from_trs(&trs, pose_span(pose, 1));
            nkw_pose_mirror(pose_view(pose, 1), &self, planes[k], pose_span(pose, 1), NULL);
            nkw_trs seen = nkw_pose_get(pose_view(pose, 1), 0);
            nkw_vec3 got = nkw_trs_transform_point(&seen, nkw_vec3_mul(sign, point));
            expect_vec3_near(got, nkw_vec3_mul(sign, nkw_trs_transform_point(&trs, point)), 30 * U);
        }
}

/* Of each five joints two pairs, and one on its own. */
static void make_pairs(int32_t pair[JOINTS])
{
    for (size_t j = 0; j < JOINTS; j++)
        pair[j] = (int32_t)(j % 5 == 4 ? j : j - j % 5 + (j % 5 ^ 1));
}

static void a_mirror_twice_gives_the_original_bits(void **state)
{
    (void)state;
    random_source r = random_from(20);
    static float pose[FLOATS], once[FLOATS], twice[FLOATS];
    int32_t pair[JOINTS];
    draw(&r, pose);
    pose[0] = -0.0f;
    make_pairs(pair);
    nkw_pose_mirror(pose_view(pose, JOINTS), pair, NKW_MIRROR_X, pose_span(once, JOINTS), NULL);
    expect_bits(once[2 * STRIDE], pose[2 * STRIDE + 1]);
    expect_bits(once[1], -pose[0]);
    nkw_pose_mirror(pose_view(once, JOINTS), pair, NKW_MIRROR_X, pose_span(twice, JOINTS), NULL);
    expect_poses_bits(twice, pose);
    nkw_pose_mirror(pose_view(pose, JOINTS), pair, NKW_MIRROR_X, pose_span(pose, JOINTS), NULL);
    expect_poses_bits(pose, once);
}

/* A mirror of so many joints, which writes nothing if a partner is none. */
static void expect_invalid(const int32_t *pair, size_t joints, nkw_result result, size_t joint)
{
    static float pose[FLOATS], out[FLOATS];
    size_t bad = 99;
    nkw_pose_identity(pose_span(pose, joints));
    out[0] = 9.0f;
    assert_int_equal(nkw_pose_mirror(pose_view(pose, joints), pair, NKW_MIRROR_Z, pose_span(out, joints), &bad),
                     result);
    assert_int_equal(bad, joint);
    expect_bits(out[0], result == NKW_OK && joints > 0 ? 0.0f : 9.0f);
    assert_int_equal(nkw_pose_mirror(pose_view(pose, joints), pair, NKW_MIRROR_Z, pose_span(out, joints), NULL),
                     result);
}

static void a_mirror_names_the_first_joint_without_a_partner(void **state)
{
    (void)state;
    int32_t pair[4] = {0, 2, 1, 3};
    expect_invalid(pair, 4, NKW_OK, 0);
    expect_invalid(pair, 0, NKW_OK, 0);
    pair[3] = 4;
    expect_invalid(pair, 4, NKW_OUT_OF_RANGE, 3);
    pair[3] = -1;
    expect_invalid(pair, 4, NKW_OUT_OF_RANGE, 3);
    pair[3] = 0;
    expect_invalid(pair, 4, NKW_BAD_MIRROR, 3);
    pair[1] = 3;
    expect_invalid(pair, 4, NKW_BAD_MIRROR, 1);
}

static void a_subtree_masks_a_joint_and_all_below_it(void **state)
{
    (void)state;
    static const int32_t parents[8] = {-1, 0, 1, 1, 0, 4, 7, INT32_MAX};
    static const float arm[8] = {0, 1, 1, 1, 0, 0, 0, 0}, all[8] = {1, 1, 1, 1, 1, 1, 0, 0}, none[8] = {0};
    float mask[NKW_POSE_STRIDE(8)];
    mask_from_subtree(parents, 8, 1, mask);
    expect_floats_bits(mask, arm, 8);
    expect_floats_bits(mask + 8, none, 8);
    mask_from_subtree(parents, 8, 0, mask);
    expect_floats_bits(mask, all, 8);
    mask_from_subtree(parents, 8, 8, mask);
    expect_floats_bits(mask, none, 8);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_poses_blend_as_lerp_nlerp_and_slerp_bit_for_bit),
        cmocka_unit_test(rotations_of_any_length_blend_as_nlerp_too),
        cmocka_unit_test(masks_weigh_joint_by_joint),
        cmocka_unit_test(poses_of_one_model_blend_bit_for_bit_as_each_joint_alone),
        cmocka_unit_test(the_ends_are_the_poses_bit_for_bit),
        cmocka_unit_test(nothing_is_touched_without_joints),
        cmocka_unit_test(poses_of_different_joints_are_not_blended),
        cmocka_unit_test(writing_stays_within_the_block),
        cmocka_unit_test(every_function_works_in_place),
        cmocka_unit_test(applying_a_difference_to_its_reference_gives_the_pose),
        cmocka_unit_test(near_poses_with_unit_scale_come_back_exactly_but_for_rotations),
        cmocka_unit_test(a_difference_of_weight_zero_leaves_the_base_bit_for_bit),
        cmocka_unit_test(sides_are_the_joints_own_axes_and_its_parents),
        cmocka_unit_test(a_part_of_a_difference_is_a_part_of_each),
        cmocka_unit_test(zeros_in_the_reference_are_defined),
        cmocka_unit_test(a_mirror_reflects_points_through_its_plane),
        cmocka_unit_test(a_mirror_twice_gives_the_original_bits),
        cmocka_unit_test(a_mirror_names_the_first_joint_without_a_partner),
        cmocka_unit_test(a_subtree_masks_a_joint_and_all_below_it),
    };
    return cmocka_run_group_tests_name("blend", tests, NULL, NULL);
}
