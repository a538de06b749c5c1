/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include <nakawari/clip_reduce.h>

#include "random.h"
#include "support/expect.h"
#include "views.h"

enum { JOINTS = 67, FLOATS = 3, KEYS = 9, TRACKS = 3 * JOINTS + 1 };

typedef struct scene {
    nkw_clip_track tracks[TRACKS];
    float times[3][KEYS], values[TRACKS][KEYS * 12];
    unsigned char modes[KEYS];
    uint32_t block[64 * 1024];
    nkw_clip_source source;
    const nkw_clip *clip;
} scene;

static unsigned char memory[1024 * 1024];
static float pose[NKW_POSE_FLOATS(JOINTS)], part[NKW_POSE_FLOATS(JOINTS)];
static float velocity[NKW_POSE_VELOCITY_FLOATS(JOINTS)];

static nkw_work work(void)
{
    return work_in(memory, sizeof memory);
}

static nkw_pose_velocity_span velocity_span(float *data)
{
    nkw_pose_velocity_span r = {data, JOINTS};
    return r;
}

static void draw_track(random_source *r, scene *s, size_t i, nkw_interpolation interpolation)
{
    nkw_clip_track *c = &s->tracks[i];
    const int is_rotation = i < JOINTS, is_cubic = interpolation == NKW_INTERPOLATION_CUBICSPLINE;
    c->target = is_rotation      ? NKW_CLIP_ROTATION
                : i < 2 * JOINTS ? NKW_CLIP_TRANSLATION
                : i < 3 * JOINTS ? NKW_CLIP_SCALE
                                 : NKW_CLIP_FLOATS;
    c->index = (uint32_t)(i % JOINTS) * (i < 3 * JOINTS);
    c->track.width = is_rotation ? 4 : i < 3 * JOINTS ? 3 : FLOATS;
    c->track.kind = is_rotation ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS;
    c->track.interpolation = interpolation;
    c->track.times = s->times[i % 7 == 0 ? 1 : 0];
    c->track.count = i % 11 == 5 ? 1 : KEYS;
    c->track.values = s->values[i];
    c->track.key_interpolation = is_cubic && i % 5 == 0 ? s->modes : NULL;
    nkw_quat q = random_rotation(r);
    for (size_t k = 0; k < KEYS * (is_cubic ? 3u : 1u); k++) {
        const int is_tangent = is_cubic && k % 3 != 1;
        q = random_near(r, q, 0.75f);
        for (size_t j = 0; j < c->track.width; j++)
            s->values[i][k * c->track.width + j] = random_between(r, -1, 1);
        if (is_rotation && !is_tangent)
            memcpy(&s->values[i][k * 4], &q, sizeof q);
    }
}

static void draw(random_source *r, scene *s, nkw_clip_format format, int which)
{
    memset(s, 0, sizeof *s);
    for (size_t k = 0; k < KEYS; k++) {
        s->times[0][k] = 0.25f * (float)k;
        s->times[1][k] = 0.5f + 0.3f * (float)k + random_between(r, 0, 0.1f);
        s->modes[k] = (unsigned char)(k % 3);
    }
    for (size_t i = 0; i < TRACKS; i++)
        draw_track(r, s, i, (nkw_interpolation)(which < 3 ? which : (int)(random_bits(r) % 3)));
    s->source.tracks = s->tracks;
    s->source.track_count = TRACKS;
    s->source.joint_count = JOINTS;
    s->source.float_count = FLOATS;
    s->source.format = format;
    size_t bytes, bad;
    assert_int_equal(nkw_clip_build(&s->source, bytes_span(s->block, sizeof s->block), &bytes, &bad, work()), NKW_OK);
    s->clip = (const nkw_clip *)(const void *)s->block;
}

static void expect_joint(size_t joint)
{
    const nkw_trs a = nkw_pose_get(pose_view(pose, JOINTS), joint), b = nkw_pose_get(pose_view(part, JOINTS), joint);
    assert_memory_equal(&a, &b, sizeof a);
}

static void some_joints_are_sampled_as_all(void **state)
{
    static const uint32_t lists[][4] = {{0, 66, 31, 15}, {64, 64, 1000, 16}, {5, 6, 7, 8}};
    static scene s;
    (void)state;
    random_source r = random_from(1);
    for (int i = 0; i < 16; i++) {
        draw(&r, &s, i % 2 ? NKW_CLIP_UNORM16 : NKW_CLIP_FLOAT32, i / 2 % 4);
        uint32_t cursors[64] = {0};
        for (float time = -0.5f; time < 4.0f; time += 0.125f) {
            nkw_clip_sample(s.clip, time, NULL, pose_span(pose, JOINTS), NULL);
            for (size_t l = 0; l < 3; l++) {
                memset(part, 0xff, sizeof part);
                assert_int_equal(nkw_clip_sample_joints(s.clip, time, lists[l], 4, cursors, pose_span(part, JOINTS)),
                                 NKW_OK);
                for (size_t k = 0; k < 4; k++)
                    if (lists[l][k] < JOINTS)
                        expect_joint(lists[l][k]);
            }
            for (size_t n = 0; n <= JOINTS; n += n < 4 ? 1 : 9) {
                memset(part, 0xff, sizeof part);
                nkw_clip_sample_joints(s.clip, time, NULL, n, NULL, pose_span(part, JOINTS));
                for (size_t k = 0; k < n; k++)
                    expect_joint(k);
            }
        }
    }
    assert_int_equal(nkw_clip_sample_joints(s.clip, 0, NULL, 1, NULL, pose_span(part, JOINTS - 1)), NKW_MISMATCHED);
}

static void expect_channel(const scene *s, float time, nkw_clip_target target, uint32_t index, uint32_t *cursors,
                           const float *floats)
{
    const nkw_trs all = index < JOINTS ? nkw_pose_get(pose_view(pose, JOINTS), index) : nkw_trs_identity();
    const float *expected = target == NKW_CLIP_TRANSLATION ? &all.translation.x
                            : target == NKW_CLIP_ROTATION  ? &all.rotation.x
                            : target == NKW_CLIP_SCALE     ? &all.scale.x
                                                           : floats + index;
    float values[5] = {-7, -7, -7, -7, -7};
    const size_t width = target == NKW_CLIP_ROTATION ? 4 : target == NKW_CLIP_FLOATS ? 1 : 3;
    assert_int_equal(nkw_clip_sample_channel(s->clip, time, target, index, cursors, values), NKW_OK);
    for (size_t i = 0; i < 5; i++)
        expect_bits(values[i], i < width ? expected[i] : -7.0f);
}

/* The clip with packed keys, in the memory of the other. */
static void reduce(scene *s)
{
    s->source.format = NKW_CLIP_FLOAT32;
    const nkw_clip_reduction reduction = {NULL, 0.1f, 0.1f, NULL, NULL, 0.1f};
    nkw_clip_reduced reduced;
    size_t bad;
    const nkw_bytes_span block = bytes_span(s->block, sizeof s->block);
    assert_int_equal(nkw_clip_reduce(&s->source, &reduction, block, &reduced, &bad, work()), NKW_OK);
    assert_true(reduced.packed_count > 0);
}

/* Of the clip, and of its reduced form with packed keys. */
static void channels_are_sampled_as_all(void **state)
{
    static scene s;
    (void)state;
    random_source r = random_from(5);
    for (int i = 0; i < 12; i++) {
        draw(&r, &s, i % 2 ? NKW_CLIP_UNORM16 : NKW_CLIP_FLOAT32, i < 8 ? i / 2 : NKW_INTERPOLATION_LINEAR);
        if (i >= 8)
            reduce(&s);
        uint32_t cursors[64] = {0};
        for (float time = -0.5f; time < 4.0f; time += 0.125f) {
            float floats[FLOATS];
            nkw_clip_sample(s.clip, time, NULL, pose_span(pose, JOINTS), floats);
            for (uint32_t k = 0; k < 4 * JOINTS; k++)
                if (k % 4 != NKW_CLIP_FLOATS || k / 4 < FLOATS)
                    expect_channel(&s, time, (nkw_clip_target)(k % 4), k / 4, k % 8 < 4 ? cursors : NULL, floats);
        }
    }
    float untouched = -7;
    assert_int_equal(nkw_clip_sample_channel(s.clip, 0, NKW_CLIP_SCALE, JOINTS, NULL, &untouched), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_clip_sample_channel(s.clip, 0, NKW_CLIP_FLOATS, FLOATS, NULL, &untouched), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_clip_sample_channel(s.clip, 0, (nkw_clip_target)4, 0, NULL, &untouched), NKW_BAD_METHOD);
    expect_bits(untouched, -7.0f);
}

/* The velocity of the track itself; 0 of one key. */
static void expect_velocities(const scene *s, float time, const float *floats)
{
    const size_t stride = NKW_POSE_STRIDE(JOINTS);
    for (size_t i = 0; i < TRACKS; i++) {
        const nkw_clip_track *c = &s->tracks[i];
        float v[4] = {0, 0, 0, 0};
        const nkw_motion_span motion = {NULL, v, NULL};
        const size_t row = c->target == NKW_CLIP_TRANSLATION ? 0 : c->target == NKW_CLIP_ROTATION ? 3 : 6;
        nkw_track_sample_motion(&c->track, time, motion);
        for (size_t k = 0; k < 3; k++)
            expect_bits(c->target == NKW_CLIP_FLOATS ? floats[k] : velocity[(row + k) * stride + c->index], v[k]);
    }
}

static void velocities_are_those_of_the_tracks(void **state)
{
    static scene s;
    (void)state;
    random_source r = random_from(2);
    for (int i = 0; i < 4; i++) {
        draw(&r, &s, NKW_CLIP_FLOAT32, i);
        for (float time = -0.5f; time < 4.0f; time += 0.125f) {
            float floats[FLOATS];
            assert_int_equal(nkw_clip_sample_velocity(s.clip, time, velocity_span(velocity), floats, work()), NKW_OK);
            expect_velocities(&s, time, floats);
        }
        nkw_clip_sample_velocity(s.clip, NAN, velocity_span(velocity), NULL, work());
        for (size_t k = 0; k < NKW_POSE_VELOCITY_FLOATS(JOINTS); k++)
            expect_bits(velocity[k], 0.0f);
    }
    const nkw_work little = {memory, NKW_CLIP_VELOCITY_WORK(JOINTS, FLOATS) - 1};
    nkw_pose_velocity_span other = {velocity, JOINTS - 1};
    assert_int_equal(nkw_clip_sample_velocity(s.clip, 0, velocity_span(velocity), NULL, little), NKW_TOO_SMALL);
    assert_int_equal(nkw_clip_sample_velocity(s.clip, 0, other, NULL, work()), NKW_MISMATCHED);
}

/* Compact clips: the difference of two samples within a segment. */
static void velocities_of_compact_clips_are_their_slopes(void **state)
{
    static scene s;
    static float later[NKW_POSE_FLOATS(JOINTS)], slope[NKW_POSE_VELOCITY_FLOATS(JOINTS)];
    (void)state;
    random_source r = random_from(3);
    draw(&r, &s, NKW_CLIP_UNORM16, NKW_INTERPOLATION_LINEAR);
    for (size_t i = 0; i < TRACKS; i++)
        s.tracks[i].track.times = s.times[0];
    for (float time = 0.0625f; time < 2.0f; time += 0.25f) {
        nkw_clip_sample(s.clip, time, NULL, pose_span(pose, JOINTS), NULL);
        nkw_clip_sample(s.clip, time + 0.0625f, NULL, pose_span(later, JOINTS), NULL);
        nkw_pose_velocity_from_poses(pose_view(pose, JOINTS), pose_view(later, JOINTS), 0.0625f, velocity_span(slope));
        nkw_clip_sample_velocity(s.clip, time, velocity_span(velocity), NULL, work());
        for (size_t c = 0; c < 9; c++)
            for (size_t j = 0; j < JOINTS; j++)
                if (j % 7 != 0 && c >= 3 && c < 6)
                    expect_near((double)velocity[c * NKW_POSE_STRIDE(JOINTS) + j],
                                (double)slope[c * NKW_POSE_STRIDE(JOINTS) + j], 2e-3);
    }
}

/* The derivative of nlerp by differences in binary64. */
static void nlerp64(const double a[4], const double b[4], double t, double out[4])
{
    double dot = 0, n = 0;
    for (int i = 0; i < 4; i++)
        dot += a[i] * b[i];
    for (int i = 0; i < 4; i++) {
        out[i] = (1 - t) * a[i] + t * (dot < 0 ? -b[i] : b[i]);
        n += out[i] * out[i];
    }
    for (int i = 0; i < 4; i++)
        out[i] /= sqrt(n);
}

/* q turned by omega for h seconds, to the first order, made unit. */
static void turned(nkw_quat q, nkw_vec3 omega, double h, double out[4])
{
    const double x = 0.5 * h * (double)omega.x, y = 0.5 * h * (double)omega.y, z = 0.5 * h * (double)omega.z;
    const double a = (double)q.x, b = (double)q.y, c = (double)q.z, d = (double)q.w;
    const double r[4] = {a + x * d + y * c - z * b, b + y * d + z * a - x * c, c + z * d + x * b - y * a,
                         d - x * a - y * b - z * c};
    double n = 0;
    for (int i = 0; i < 4; i++)
        n += r[i] * r[i];
    for (int i = 0; i < 4; i++)
        out[i] = r[i] / sqrt(n);
}

static void a_blend_turns_as_its_derivative(void **state)
{
    static float a[NKW_POSE_FLOATS(1)], b[NKW_POSE_FLOATS(1)], va[NKW_POSE_VELOCITY_FLOATS(1)],
        vb[NKW_POSE_VELOCITY_FLOATS(1)], out[NKW_POSE_VELOCITY_FLOATS(1)];
    const double h = 1e-5;
    (void)state;
    random_source r = random_from(4);
    for (int i = 0; i < 2000; i++) {
        nkw_trs p = {random_vec3(&r, -1, 1), random_rotation(&r), random_vec3(&r, -1, 1)};
        nkw_trs q = {random_vec3(&r, -1, 1), random_near(&r, p.rotation, 1.0f), random_vec3(&r, -1, 1)};
        const float mask[16] = {i % 4 ? 0.5f : 1.0f}, t = random_unit(&r), rate = random_between(&r, -2, 2);
        const double w = (double)(t * mask[0]), change = (double)rate * (double)mask[0];
        if (i % 2)
            q.rotation = nkw_quat_negate(q.rotation);
        nkw_pose_set(pose_span(a, 1), 0, &p);
        nkw_pose_set(pose_span(b, 1), 0, &q);
        for (size_t c = 0; c < 9; c++) {
            va[16 * c] = random_between(&r, -1, 1);
            vb[16 * c] = random_between(&r, -1, 1);
        }
        const nkw_pose_state from = {pose_view(a, 1), {va, 1}}, to = {pose_view(b, 1), {vb, 1}};
        nkw_pose_velocity_span span = {out, 1};
        assert_int_equal(nkw_pose_velocity_blend(&from, &to, t, rate, mask_view(mask, 1), span), NKW_OK);
        const nkw_vec3 wa = {va[48], va[64], va[80]}, wb = {vb[48], vb[64], vb[80]};
        double qa[2][4], qb[2][4], n[2][4];
        for (int k = 0; k < 2; k++) {
            turned(p.rotation, wa, k ? h : -h, qa[k]);
            turned(q.rotation, wb, k ? h : -h, qb[k]);
            nlerp64(qa[k], qb[k], w + change * (k ? h : -h), n[k]);
        }
        const double *x = n[0], *y = n[1]; /* 2 Im(y x*) / (2 h) */
        const double turn[3] = {y[0] * x[3] - y[3] * x[0] - (y[1] * x[2] - y[2] * x[1]),
                                y[1] * x[3] - y[3] * x[1] - (y[2] * x[0] - y[0] * x[2]),
                                y[2] * x[3] - y[3] * x[2] - (y[0] * x[1] - y[1] * x[0])};
        for (size_t c = 0; c < 3; c++)
            expect_near((double)out[16 * (3 + c)], turn[c] / h, 2e-6);
        expect_near((double)out[0],
                    (1 - w) * (double)va[0] + w * (double)vb[0] +
                        change * ((double)q.translation.x - (double)p.translation.x),
                    1e-6);
        expect_near((double)out[16 * 8],
                    (1 - w) * (double)va[16 * 8] + w * (double)vb[16 * 8] +
                        change * ((double)q.scale.z - (double)p.scale.z),
                    1e-6);
        expect_bits(out[1], 0.0f);
    }
    const nkw_pose_state one = {pose_view(a, 1), {NULL, 0}}, two = {pose_view(a, 2), {NULL, 0}};
    nkw_pose_velocity_span span = {out, 1};
    const nkw_mask_view whole = {NULL, 0};
    assert_int_equal(nkw_pose_velocity_blend(&one, &two, 0, 0, whole, span), NKW_MISMATCHED);
    assert_int_equal(nkw_pose_velocity_blend(&one, &one, 0.5f, 1, whole, span), NKW_OK);
    for (size_t c = 0; c < 9; c++)
        assert_true(out[16 * c] == 0.0f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(some_joints_are_sampled_as_all),
        cmocka_unit_test(channels_are_sampled_as_all),
        cmocka_unit_test(velocities_are_those_of_the_tracks),
        cmocka_unit_test(velocities_of_compact_clips_are_their_slopes),
        cmocka_unit_test(a_blend_turns_as_its_derivative),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
