/* SPDX-License-Identifier: MIT */
#include "support/poses.h"
#include "support/views.h"

#define LAYERS 5

typedef struct bed {
    float poses[LAYERS][FLOATS], masks[LAYERS][STRIDE], rest[FLOATS], out[FLOATS], want[FLOATS];
    nkw_pose_layer layers[LAYERS];
} bed;

static bed *make_bed(uint64_t seed)
{
    static bed b;
    random_source r = random_from(seed);
    draw(&r, b.rest);
    for (size_t i = 0; i < LAYERS; i++) {
        draw(&r, b.poses[i]);
        draw_mask(&r, b.masks[i]);
        nkw_pose_layer layer = {pose_view(b.poses[i], JOINTS), random_between(&r, 0.1f, 1), mask_view(NULL, 0)};
        b.layers[i] = layer;
    }
    return &b;
}

static void permute_and_compare(bed *b, nkw_pose_layer *layers, size_t fixed)
{
    if (fixed == LAYERS) {
        nkw_pose_layers_blend(layers, LAYERS, pose_view(b->rest, JOINTS), 3.5f, pose_span(b->out, JOINTS));
        expect_poses_bits(b->out, b->want);
    }
    for (size_t i = fixed; i < LAYERS; i++) {
        nkw_pose_layer other[LAYERS];
        memcpy(other, layers, sizeof other);
        other[fixed] = layers[i];
        other[i] = layers[fixed];
        permute_and_compare(b, other, fixed + 1);
    }
}

static void expect_any_order(bed *b)
{
    nkw_pose_layers_blend(b->layers, LAYERS, pose_view(b->rest, JOINTS), 3.5f, pose_span(b->want, JOINTS));
    permute_and_compare(b, b->layers, 0);
}

static void the_order_of_layers_changes_no_bit(void **state)
{
    (void)state;
    bed *b = make_bed(5);
    expect_any_order(b);
    for (size_t i = 0; i < LAYERS; i++)
        b->layers[i].mask = mask_view(b->masks[i], JOINTS);
    expect_any_order(b);
    for (size_t i = 0; i < LAYERS; i++)
        b->layers[i].weight = 0.25f;
    expect_any_order(b);
    for (size_t i = 0; i < LAYERS; i++)
        b->layers[i].mask = mask_view(i % 2 ? b->masks[1] : NULL, JOINTS);
    expect_any_order(b);
    for (size_t i = 0; i < 4 * STRIDE; i++)
        b->poses[1][3 * STRIDE + i] = b->poses[2][3 * STRIDE + i] = b->poses[3][3 * STRIDE + i];
    b->layers[4] = b->layers[2];
    expect_any_order(b);
}

static void layers_that_differ_in_one_row_may_come_in_any_order(void **state)
{
    (void)state;
    for (size_t row = 0; row < 10; row++) {
        bed *b = make_bed(19 + row);
        for (size_t i = 0; i < LAYERS; i++) {
            b->layers[i].weight = 0.25f;
            for (size_t c = 0; c < 10 && i > 0; c++)
                if (c != row)
                    memcpy(b->poses[i] + c * STRIDE, b->poses[0] + c * STRIDE, STRIDE * sizeof(float));
        }
        expect_any_order(b);
    }
}

/* More layers than the library sorts together, some of them equal; in all cyclic orders, and reversed. */
static void many_layers_of_one_weight_may_come_in_any_order(void **state)
{
    (void)state;
    enum { MANY = 75 };
    bed *b = make_bed(15), *more;
    static bed other;
    nkw_pose_layer layers[MANY];
    other = *b;
    more = make_bed(16);
    for (int masked = 0; masked < 2; masked++) {
        for (size_t i = 0; i < MANY; i++) {
            const float *pose = i % 7 < 5 ? more->poses[i % 7] : other.poses[i % 5];
            nkw_pose_layer layer = {pose_view(pose, JOINTS), 0.25f, mask_view(NULL, 0)};
            layer.mask = mask_view(masked && i % 3 ? more->masks[i % 5] : NULL, JOINTS);
            layers[i] = layer;
        }
        nkw_pose_layers_blend(layers, MANY, pose_view(more->rest, JOINTS), 0.1f, pose_span(more->want, JOINTS));
        for (size_t step = 0; step < 2 * MANY; step++) {
            nkw_pose_layer rotated[MANY];
            for (size_t i = 0; i < MANY; i++)
                rotated[i] = layers[(step < MANY ? i + step : 3 * MANY - i - step) % MANY];
            nkw_pose_layers_blend(rotated, MANY, pose_view(more->rest, JOINTS), 0.1f, pose_span(more->out, JOINTS));
            expect_poses_bits(more->out, more->want);
        }
        for (size_t j = 0; j < JOINTS && !masked; j++) {
            double mean = 0;
            for (size_t i = 0; i < MANY; i++)
                mean += (double)layers[i].pose.data[j] / MANY;
            expect_near(more->out[j], mean, 1e-5);
        }
    }
}

/* Several groups of one weight, some of them without a share; translations and scales. */
static void groups_of_one_weight_give_the_mean(void **state)
{
    (void)state;
    static const float weights[5][LAYERS] = {
        {0.4f, 0.4f, 0.1f, 0.1f, 0.1f},           {0.5f, 0.2f, 0.2f, 0.1f, 0.1f}, {0.3f, 0.3f, 0.3f, 0.2f, 0.2f},
        {0x1p60f, 0x1p60f, 1e-45f, 1e-45f, 0.0f}, {0.2f, 0.2f, 0.2f, 0.2f, 0.2f},
    };
    for (size_t set = 0; set < 5; set++) {
        bed *b = make_bed(20 + set);
        double total = 0;
        for (size_t i = 0; i < LAYERS; i++)
            total += (double)(b->layers[(3 * i) % LAYERS].weight = weights[set][i]);
        nkw_pose_layers_blend(b->layers, LAYERS, pose_view(b->rest, JOINTS), 0.0f, pose_span(b->out, JOINTS));
        for (size_t c = 0; c < 10; c += c == 2 ? 5 : 1)
            for (size_t j = 0; j < JOINTS; j++) {
                double mean = 0;
                for (size_t i = 0; i < LAYERS; i++)
                    mean += (double)b->layers[i].weight / total * (double)b->poses[i][c * STRIDE + j];
                expect_near(b->out[c * STRIDE + j], mean, 20 * U);
            }
    }
}

/* With masks and without: all other joints of all layers change, and joint 7 keeps its bits. */
static void a_joints_result_depends_on_that_joint_alone(void **state)
{
    (void)state;
    random_source r = random_from(12);
    bed *b = make_bed(11);
    for (int masked = 0; masked < 2; masked++) {
        for (size_t i = 0; i < LAYERS; i++)
            b->layers[i].mask = mask_view(masked ? b->masks[i] : NULL, JOINTS);
        nkw_pose_layers_blend(b->layers, LAYERS, pose_view(b->rest, JOINTS), 0.1f, pose_span(b->want, JOINTS));
        for (int round = 0; round < 20; round++) {
            for (size_t i = 0; i < LAYERS * 10 * STRIDE; i++)
                if (i % STRIDE != 7)
                    b->poses[i / (10 * STRIDE)][i % (10 * STRIDE)] = random_unit(&r);
            nkw_pose_layers_blend(b->layers, LAYERS, pose_view(b->rest, JOINTS), 0.1f, pose_span(b->out, JOINTS));
            for (size_t c = 0; c < 10; c++)
                expect_bits(b->out[c * STRIDE + 7], b->want[c * STRIDE + 7]);
        }
    }
}

typedef struct weighted {
    double q[4], w;
} weighted;

static double dot4(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

/* A = sum w_i w_k s_ik q_i q_k^T, s_ik the sign of q_i . q_k. */
static void signed_matrix(const weighted *all, size_t count, double a[4][4])
{
    memset(a, 0, 16 * sizeof a[0][0]);
    for (size_t i = 0; i < count; i++)
        for (size_t k = 0; k < count; k++) {
            const double w = all[i].w * all[k].w * (dot4(all[i].q, all[k].q) < 0 ? -1 : 1);
            for (size_t r = 0; r < 16; r++)
                a[r / 4][r % 4] += w * all[i].q[r / 4] * all[k].q[r % 4];
        }
}

/* r is the eigenvector of the largest eigenvalue l of A: A r = l r, and no pivot of l - A is negative. */
static void expect_top(double a[4][4], nkw_quat r, double tolerance)
{
    const double x[4] = {r.x, r.y, r.z, r.w};
    double norm = 0, top = 0, m[4][4];
    for (size_t i = 0; i < 4; i++) {
        norm = fmax(norm, sqrt(dot4(a[i], a[i])));
        top += x[i] * dot4(a[i], x);
    }
    for (size_t i = 0; i < 4; i++)
        expect_near((float)(dot4(a[i], x) / norm), top * x[i] / norm, tolerance);
    for (size_t i = 0; i < 16; i++)
        m[i / 4][i % 4] = (i % 5 == 0 ? top / norm + 1e-5 : 0) - a[i / 4][i % 4] / norm;
    for (size_t k = 0; k < 4; k++) {
        assert_true(m[k][k] > 0);
        for (size_t i = k + 1; i < 4; i++)
            for (size_t j = 3; j > k; j--)
                m[i][j] -= m[i][k] / m[k][k] * m[k][j];
    }
    expect_near(nkw_quat_length(r), 1, 4 * U);
}

/* Rotations by the definition in blend.h; translations and scales are weighted means. */
static void expect_joint(const bed *b, const float *w, size_t j)
{
    weighted all[LAYERS + 1];
    size_t count = 0;
    double total = 0, mean[10] = {0}, a[4][4];
    for (size_t i = 0; i <= LAYERS; i++) {
        const float *pose = i < LAYERS ? b->poses[i] : b->rest;
        for (size_t c = 0; c < 10; c++)
            mean[c] += (double)w[i] * (double)pose[c * STRIDE + j];
        for (size_t c = 0; c < 4; c++)
            all[count].q[c] = (double)pose[(3 + c) * STRIDE + j];
        all[count].w = (double)w[i];
        count += w[i] > 0;
        total += (double)w[i];
    }
    signed_matrix(all, count, a);
    expect_top(a, nkw_pose_get(pose_view(b->out, JOINTS), j).rotation, 8 * U);
    for (size_t c = 0; c < 10; c += c == 2 ? 5 : 1)
        expect_near(b->out[c * STRIDE + j], mean[c] / total, 20 * U);
}

static void expect_mean(bed *b, float threshold)
{
    nkw_pose_layers_blend(b->layers, LAYERS, pose_view(b->rest, JOINTS), threshold, pose_span(b->out, JOINTS));
    for (size_t j = 0; j < JOINTS; j++) {
        float w[LAYERS + 1], sum = 0;
        for (size_t i = 0; i < LAYERS; i++)
            sum += w[i] = b->layers[i].weight * (b->layers[i].mask.data ? b->layers[i].mask.data[j] : 1.0f);
        w[LAYERS] = sum < threshold ? threshold - sum : 0.0f;
        expect_joint(b, w, j);
    }
}

static nkw_quat yaw_mean(const float *angles, const float *weights, int masked)
{
    float poses[3][NKW_POSE_FLOATS(1)], rest[NKW_POSE_FLOATS(1)], one[NKW_POSE_STRIDE(1)] = {1};
    nkw_pose_layer layers[3];
    nkw_pose_identity(pose_span(rest, 1));
    for (size_t i = 0; i < 3; i++) {
        nkw_trs trs = nkw_trs_identity();
        trs.rotation = nkw_quat_from_axis_angle((nkw_vec3){0, 1, 0}, angles[i]);
        nkw_pose_identity(pose_span(poses[i], 1));
        nkw_pose_set(pose_span(poses[i], 1), 0, &trs);
        nkw_pose_layer layer = {pose_view(poses[i], 1), weights[i], mask_view(masked ? one : NULL, 1)};
        layers[i] = layer;
    }
    nkw_pose_layers_blend(layers, 3, pose_view(rest, 1), 0.1f, pose_span(rest, 1));
    return nkw_pose_get(pose_view(rest, 1), 0).rotation;
}

/*
 * Yaws of 0, 2.2 and -2.2 rad, of which no two shorter arcs agree. Where two weights exchange their order the mean
 * moves by about as much as they do: it jumped by 1.09 rad. Along the path around the simplex of weights it turns once.
 */
static void three_layers_do_not_jump_where_weights_exchange_their_order(void **state)
{
    (void)state;
    const float angles[3] = {0.0f, 2.2f, -2.2f};
    for (int masked = 0; masked < 2; masked++) {
        const float one[3] = {0.2f, 0.4f + 1e-6f, 0.4f - 1e-6f}, other[3] = {0.2f, 0.4f - 1e-6f, 0.4f + 1e-6f};
        const nkw_quat at = yaw_mean(angles, one, masked);
        assert_true(nkw_quat_angle(at, yaw_mean(angles, other, masked)) < 2e-5f);
        expect_near(nkw_abs(at.y), 1, 1e-5);
        nkw_quat last = yaw_mean(angles, (const float[3]){1, 0, 0}, masked);
        float turned = 0;
        for (int i = 1; i <= 3000; i++) {
            const float t = (float)(i % 1000) / 1000.0f;
            float weights[3] = {0, 0, 0};
            weights[i / 1000 % 3] = 1 - t;
            weights[(i / 1000 + 1) % 3] = t;
            weights[(i / 1000 + 2) % 3] = 1e-3f;
            const nkw_quat now = yaw_mean(angles, weights, masked);
            assert_true(nkw_quat_angle(last, now) < 0.02f);
            turned +=
                2 *
                nkw_asin(
                    nkw_quat_mul(nkw_quat_conjugate(last), nkw_quat_dot(last, now) < 0 ? nkw_quat_negate(now) : now).y);
            last = now;
        }
        expect_near(turned, 6.2831853, 1e-2);
    }
}

/* As the weight of the third fades, the mean becomes the blend of the other two. */
static void a_third_layer_fades_to_the_blend_of_two(void **state)
{
    (void)state;
    const float angles[3] = {0.0f, 2.2f, -2.2f};
    for (int k = 0; k < 3; k++) {
        float two[3] = {0.5f, 0.3f, 0.4f}, nearly[3];
        two[k] = 0.0f;
        memcpy(nearly, two, sizeof two);
        nearly[k] = 1e-6f;
        assert_true(nkw_quat_angle(yaw_mean(angles, two, 0), yaw_mean(angles, nearly, 0)) < 2e-5f);
    }
}

static void layers_give_the_weighted_mean_and_the_rest_pose_what_is_missing(void **state)
{
    (void)state;
    bed *b = make_bed(6);
    static const float weights[LAYERS] = {0.9f, 0.5f, 0.4f, 0.3f, 0.2f};
    for (size_t i = 0; i < LAYERS; i++)
        b->layers[i].weight = weights[i];
    expect_mean(b, 0.1f);
    expect_mean(b, 4.0f);
    for (size_t i = 0; i < LAYERS; i++)
        b->layers[i].mask = mask_view(b->masks[i], JOINTS);
    expect_mean(b, 0.1f);
    expect_mean(b, 2.0f);
    /* A little is missing, on every joint alike. */
    for (size_t i = 0; i < LAYERS; i++)
        for (size_t j = 0; j < JOINTS; j++)
            b->masks[i][j] = 0.75f;
    expect_mean(b, 1.75f);
}

static void two_layers_are_the_blend_of_two_from_the_heavier(void **state)
{
    (void)state;
    bed *b = make_bed(7);
    b->layers[0].weight = 0.3f;
    b->layers[1].weight = 0.6f;
    nkw_pose_layers_blend(b->layers, 2, pose_view(b->rest, JOINTS), 0.5f, pose_span(b->out, JOINTS));
    nkw_pose_blend(pose_view(b->poses[1], JOINTS), pose_view(b->poses[0], JOINTS), 0.3f / (0.3f + 0.6f),
                   mask_view(NULL, JOINTS), pose_span(b->want, JOINTS));
    expect_poses_bits(b->out, b->want);
}

static void one_layer_alone_is_its_pose_bit_for_bit(void **state)
{
    (void)state;
    bed *b = make_bed(8);
    b->poses[0][3] = -0.0f;
    b->poses[0][3 * STRIDE + 3] = -0.0f;
    b->layers[0].weight = 0.37f;
    nkw_pose_layers_blend(b->layers, 1, pose_view(b->rest, JOINTS), 0.1f, pose_span(b->out, JOINTS));
    expect_poses_bits(b->out, b->poses[0]);
    for (size_t j = 0; j < STRIDE; j++) {
        b->masks[0][j] = j % 2 ? 0.25f : 0.0f;
        b->masks[1][j] = j % 2 ? -1.0f : 0.5f;
    }
    b->layers[0].mask = mask_view(b->masks[0], JOINTS);
    b->layers[1].mask = mask_view(b->masks[1], JOINTS);
    b->poses[1][1] = NAN;
    nkw_pose_layers_blend(b->layers, 2, pose_view(b->rest, JOINTS), 0.0f, pose_span(b->out, JOINTS));
    for (size_t i = 0; i < FLOATS; i++)
        if (i % STRIDE < JOINTS)
            expect_bits(b->out[i], b->poses[i % 2 ? 0 : 1][i]);
}

static void what_all_layers_share_comes_out_bit_for_bit(void **state)
{
    (void)state;
    bed *b = make_bed(9);
    for (size_t i = 0; i < LAYERS; i++) {
        memcpy(b->poses[i], b->poses[0], 3 * STRIDE * sizeof(float));
        memcpy(b->poses[i] + 7 * STRIDE, b->poses[0] + 7 * STRIDE, 3 * STRIDE * sizeof(float));
        b->layers[i].mask = mask_view(i % 2 ? b->masks[i] : NULL, JOINTS);
    }
    nkw_pose_layers_blend(b->layers, LAYERS, pose_view(b->rest, JOINTS), 0.1f, pose_span(b->out, JOINTS));
    for (size_t c = 0; c < 10; c = c == 2 ? 7 : c + 1)
        expect_floats_bits(b->out + c * STRIDE, b->poses[0] + c * STRIDE, JOINTS);
}

static void the_rest_pose_stands_where_nothing_has_a_weight(void **state)
{
    (void)state;
    bed *b = make_bed(10);
    static const float none[LAYERS] = {0.0f, -0.0f, -1.0f, NAN, -INFINITY};
    static const float thresholds[] = {0.1f, 0.0f, -1.0f, NAN, INFINITY};
    for (size_t i = 0; i < LAYERS; i++)
        b->layers[i].weight = none[i];
    for (size_t i = 0; i < 5; i++) {
        nkw_pose_layers_blend(b->layers, LAYERS, pose_view(b->rest, JOINTS), thresholds[i], pose_span(b->out, JOINTS));
        expect_poses_bits(b->out, b->rest);
        nkw_pose_layers_blend(NULL, 0, pose_view(b->rest, JOINTS), thresholds[i], pose_span(b->out, JOINTS));
        expect_poses_bits(b->out, b->rest);
    }
    b->layers[0].weight = 1.0f;
    b->layers[0].mask = mask_view(b->masks[0], JOINTS);
    memset(b->masks[0], 0, sizeof b->masks[0]);
    nkw_pose_layers_blend(b->layers, LAYERS, pose_view(b->rest, JOINTS), 0.0f, pose_span(b->out, JOINTS));
    expect_poses_bits(b->out, b->rest);
}

static void negative_and_nan_weights_are_no_layers(void **state)
{
    (void)state;
    bed *b = make_bed(11);
    nkw_pose_layers_blend(b->layers + 2, 3, pose_view(b->rest, JOINTS), 0.1f, pose_span(b->want, JOINTS));
    b->layers[0].weight = -3.0f;
    b->layers[1].weight = NAN;
    nkw_pose_layers_blend(b->layers, LAYERS, pose_view(b->rest, JOINTS), 0.1f, pose_span(b->out, JOINTS));
    expect_poses_bits(b->out, b->want);
}

static void enormous_weights_count_as_two_to_the_sixty(void **state)
{
    (void)state;
    bed *b = make_bed(12);
    b->layers[0].weight = 0x1p60f;
    b->layers[1].weight = 0x1p60f;
    nkw_pose_layers_blend(b->layers, 2, pose_view(b->rest, JOINTS), 0.1f, pose_span(b->want, JOINTS));
    b->layers[0].weight = INFINITY;
    b->layers[1].weight = 3e38f;
    nkw_pose_layers_blend(b->layers, 2, pose_view(b->rest, JOINTS), 0.1f, pose_span(b->out, JOINTS));
    expect_poses_bits(b->out, b->want);
    for (size_t j = 0; j < JOINTS; j++)
        expect_near(nkw_quat_length(nkw_pose_get(pose_view(b->out, JOINTS), j).rotation), 1, 4 * U);
}

/* Rotations that agree, given with both signs and far from the rest pose, stay what they are. */
static void signs_of_layers_do_not_matter(void **state)
{
    (void)state;
    bed *b = make_bed(13);
    nkw_pose_identity(pose_span(b->rest, JOINTS));
    for (size_t j = 0; j < JOINTS; j++)
        for (size_t i = 0; i < LAYERS; i++) {
            nkw_trs trs = nkw_trs_identity();
            trs.rotation = nkw_quat_from_axis_angle((nkw_vec3){0, 1, 0}, 3.1f + 0.02f * (float)i);
            trs.rotation = (i + j) % 2 ? nkw_quat_negate(trs.rotation) : trs.rotation;
            nkw_pose_set(pose_span(b->poses[i], JOINTS), j, &trs);
        }
    for (size_t i = 0; i < LAYERS; i++)
        b->layers[i].weight = 0.2f;
    nkw_pose_layers_blend(b->layers, LAYERS, pose_view(b->rest, JOINTS), 0.1f, pose_span(b->out, JOINTS));
    nkw_quat want = nkw_quat_from_axis_angle((nkw_vec3){0, 1, 0}, 3.14f);
    for (size_t j = 0; j < JOINTS; j++)
        expect_rotation_near(nkw_pose_get(pose_view(b->out, JOINTS), j).rotation, want, 1e-6);
}

static void the_result_may_replace_a_layers_pose(void **state)
{
    (void)state;
    for (int even = 0; even < 2; even++)
        for (size_t k = 0; k < LAYERS; k++) {
            bed *b = make_bed(14);
            for (size_t i = 0; i < LAYERS && even; i++)
                b->layers[i].weight = 0.25f;
            nkw_pose_layers_blend(b->layers, LAYERS, pose_view(b->rest, JOINTS), 0.1f, pose_span(b->want, JOINTS));
            nkw_pose_layers_blend(b->layers, LAYERS, pose_view(b->rest, JOINTS), 0.1f, pose_span(b->poses[k], JOINTS));
            expect_poses_bits(b->poses[k], b->want);
        }
}

/* Layers of one weight that have one row in common, behind which other things stand in each of them. */
static void the_padding_puts_no_layer_before_another(void **state)
{
    (void)state;
    random_source r = random_from(17);
    bed *b = make_bed(18);
    for (size_t i = 0; i < LAYERS; i++) {
        b->layers[i].weight = 0.25f;
        memcpy(b->poses[i] + 3 * STRIDE, b->poses[0] + 3 * STRIDE, JOINTS * sizeof(float));
    }
    nkw_pose_layers_blend(b->layers, LAYERS, pose_view(b->rest, JOINTS), 0.1f, pose_span(b->want, JOINTS));
    for (int round = 0; round < 10; round++) {
        for (size_t i = 0; i < LAYERS * 10 * STRIDE; i++)
            if (i % STRIDE >= JOINTS)
                b->poses[i / (10 * STRIDE)][i % (10 * STRIDE)] = random_unit(&r);
        nkw_pose_layers_blend(b->layers, LAYERS, pose_view(b->rest, JOINTS), 0.1f, pose_span(b->out, JOINTS));
        expect_poses_bits(b->out, b->want);
    }
}

static void expect_mask(const float *mask, size_t joints, nkw_result result, size_t joint)
{
    size_t bad = 99;
    assert_int_equal(nkw_mask_validate(mask_view(mask, joints), &bad), result);
    assert_int_equal(bad, joint);
    assert_int_equal(nkw_mask_validate(mask_view(mask, joints), NULL), result);
}

static void validate_names_the_first_joint_of_a_bad_mask(void **state)
{
    (void)state;
    float mask[5] = {0, 1, 0.5f, -0.0f, 1};
    expect_mask(mask, 5, NKW_OK, 0);
    expect_mask(mask, 0, NKW_EMPTY, 0);
    mask[4] = 1.0000001f;
    expect_mask(mask, 5, NKW_BAD_WEIGHTS, 4);
    expect_mask(mask, 4, NKW_OK, 0);
    mask[3] = -1e-30f;
    expect_mask(mask, 5, NKW_BAD_WEIGHTS, 3);
    mask[2] = INFINITY;
    expect_mask(mask, 5, NKW_NOT_FINITE, 2);
    mask[1] = NAN;
    expect_mask(mask, 5, NKW_NOT_FINITE, 1);
}

static void expect_layers(const bed *b, size_t count, size_t joints, nkw_result result, size_t layer)
{
    size_t bad = 99;
    assert_int_equal(nkw_pose_layers_validate(b->layers, count, joints, &bad), result);
    assert_int_equal(bad, layer);
    assert_int_equal(nkw_pose_layers_validate(b->layers, count, joints, NULL), result);
}

static void validate_names_the_first_bad_layer(void **state)
{
    (void)state;
    bed *b = make_bed(21);
    for (size_t i = 0; i < LAYERS; i++)
        b->layers[i].mask = mask_view(b->masks[i], JOINTS);
    b->layers[1].weight = 0x1p60f;
    b->layers[0].weight = 0.0f;
    expect_layers(b, LAYERS, JOINTS, NKW_OK, 0);
    expect_layers(b, 0, JOINTS, NKW_OK, 0);
    expect_layers(b, LAYERS, 0, NKW_EMPTY, 0);
    b->masks[4][JOINTS - 1] = 2.0f;
    expect_layers(b, LAYERS, JOINTS, NKW_BAD_WEIGHTS, 4);
    b->layers[3].weight = -1.0f;
    expect_layers(b, LAYERS, JOINTS, NKW_BAD_WEIGHTS, 3);
    b->layers[2].weight = NAN;
    expect_layers(b, LAYERS, JOINTS, NKW_NOT_FINITE, 2);
    b->layers[1].weight = 0x1.000002p60f;
    expect_layers(b, LAYERS, JOINTS, NKW_BAD_WEIGHTS, 1);
    b->layers[2].mask.joint_count = 3;
    b->layers[0].pose.joint_count++;
    expect_layers(b, LAYERS, JOINTS, NKW_MISMATCHED, 0);
    assert_int_equal(
        nkw_pose_layers_blend(b->layers, LAYERS, pose_view(b->rest, JOINTS), 0.1f, pose_span(b->out, JOINTS)),
        NKW_MISMATCHED);
    b->layers[0].pose.data = NULL;
    expect_layers(b, LAYERS, JOINTS, NKW_EMPTY, 0);
}

/* Two rotations 90 degrees apart are farthest, 3.2 degrees (docs/subjects/math/value.md); four random ones are nearer. */
static void layers_are_near_the_mean_of_their_rotations(void **state)
{
    (void)state;
    static float poses[4][FLOATS], rest[FLOATS], out[FLOATS];
    nkw_pose_layer layers[4];
    random_source r = random_from(90);
    draw(&r, rest);
    for (int round = 0; round < 100; round++) {
        nkw_quat q[4][JOINTS];
        float weights[4];
        for (int i = 0; i < 4; i++) {
            weights[i] = random_between(&r, 0.05f, 1.0f);
            draw(&r, poses[i]);
            for (size_t j = 0; j < JOINTS; j++) {
                nkw_trs trs = nkw_trs_identity();
                /* Each within 45 degrees of the first, 0.39 between the quaternions: all within 90 of one another. */
                q[i][j] = i ? random_near(&r, q[0][j], 0.39f * random_unit(&r)) : random_rotation(&r);
                trs.rotation = random_bits(&r) & 1 ? nkw_quat_negate(q[i][j]) : q[i][j];
                nkw_pose_set(pose_span(poses[i], JOINTS), j, &trs);
            }
            nkw_pose_layer layer = {pose_view(poses[i], JOINTS), weights[i], mask_view(NULL, 0)};
            layers[i] = layer;
        }
        nkw_pose_layers_blend(layers, 4, pose_view(rest, JOINTS), 0.0f, pose_span(out, JOINTS));
        for (size_t j = 0; j < JOINTS; j++) {
            nkw_quat keys[4] = {q[0][j], q[1][j], q[2][j], q[3][j]};
            nkw_quat got = nkw_pose_get(pose_view(out, JOINTS), j).rotation;
            assert_true(nkw_quat_angle(got, nkw_quat_mean(keys, 4, weights)) < nkw_radians_from_degrees(2.9f));
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_order_of_layers_changes_no_bit),
        cmocka_unit_test(layers_that_differ_in_one_row_may_come_in_any_order),
        cmocka_unit_test(many_layers_of_one_weight_may_come_in_any_order),
        cmocka_unit_test(groups_of_one_weight_give_the_mean),
        cmocka_unit_test(a_joints_result_depends_on_that_joint_alone),
        cmocka_unit_test(three_layers_do_not_jump_where_weights_exchange_their_order),
        cmocka_unit_test(a_third_layer_fades_to_the_blend_of_two),
        cmocka_unit_test(layers_give_the_weighted_mean_and_the_rest_pose_what_is_missing),
        cmocka_unit_test(two_layers_are_the_blend_of_two_from_the_heavier),
        cmocka_unit_test(one_layer_alone_is_its_pose_bit_for_bit),
        cmocka_unit_test(what_all_layers_share_comes_out_bit_for_bit),
        cmocka_unit_test(the_rest_pose_stands_where_nothing_has_a_weight),
        cmocka_unit_test(negative_and_nan_weights_are_no_layers),
        cmocka_unit_test(enormous_weights_count_as_two_to_the_sixty),
        cmocka_unit_test(signs_of_layers_do_not_matter),
        cmocka_unit_test(the_result_may_replace_a_layers_pose),
        cmocka_unit_test(the_padding_puts_no_layer_before_another),
        cmocka_unit_test(validate_names_the_first_joint_of_a_bad_mask),
        cmocka_unit_test(validate_names_the_first_bad_layer),
        cmocka_unit_test(layers_are_near_the_mean_of_their_rotations),
    };
    return cmocka_run_group_tests_name("blend_layers", tests, NULL, NULL);
}
