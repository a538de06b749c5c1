/* SPDX-License-Identifier: MIT */
/*
 * Clips that are so long that the first trials of a reduction are of parts of them only: what happens between these
 * parts is within the tolerance too.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/clip_reduce.h>
#include <nakawari/skeleton.h>

#include "random.h"
#include "support/clips.h"
#include "support/farthest.h"
#include "support/tracks.h"
#include "support/views.h"

#define JOINTS 3
#define KEYS   3000
#define TRACKS (2 * JOINTS + 1)
#define TENTHS (KEYS / 10)
#define REACH  0.1f

static struct {
    float times[KEYS], tenths[TENTHS], values[TRACKS][4 * KEYS];
    int32_t parents[JOINTS];
    nkw_clip_track tracks[TRACKS];
    nkw_clip_source source;
} drawn;
static double work[NKW_CLIP_REDUCE_WORK(TRACKS, JOINTS, 1) / 8 + 2], block[1 << 18];

/* Little motion, but of the keys 200 to 260; these differ from their neighbours at random. */
static float motion(random_source *r, size_t k)
{
    const float slow = 0.02f * nkw_sin(0.05f * (float)k);
    return k < 200 || k > 260 ? slow : slow + random_between(r, -0.5f, 0.5f);
}

/*
 * A chain of joints 1 apart: all rotate; the root is translated, with a tenth of the keys; the translations of the
 * others are constant; and a float.
 */
static int draw(void **state)
{
    (void)state;
    random_source r = random_from(71);
    const nkw_clip_source source = {drawn.tracks, TRACKS, JOINTS, 1, {NULL, 0}, NULL, NKW_CLIP_FLOAT32, NULL};
    for (size_t k = 0; k < KEYS; k++)
        drawn.times[k] = (float)k / 60.0f;
    for (size_t k = 0; k < TENTHS; k++)
        drawn.tenths[k] = drawn.times[10 * k] + 0.003f;
    for (size_t i = 0; i < TRACKS; i++) {
        const int is_float = i == TRACKS - 1, is_rotation = !is_float && i % 2, is_root = i == 0;
        const size_t width = is_float ? 1 : is_rotation ? 4 : 3, count = is_root ? TENTHS : KEYS;
        const nkw_track t = {is_root ? drawn.tenths : drawn.times,
                             drawn.values[i],
                             count,
                             width,
                             is_rotation ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS,
                             NKW_INTERPOLATION_LINEAR,
                             NULL};
        const nkw_clip_track c = {is_float      ? NKW_CLIP_FLOATS
                                  : is_rotation ? NKW_CLIP_ROTATION
                                                : NKW_CLIP_TRANSLATION,
                                  is_float ? 0 : (uint32_t)(i / 2), t};
        drawn.tracks[i] = c;
        for (size_t k = 0; k < count; k++) {
            const float x = motion(&r, k), y = motion(&r, k);
            const nkw_quat q = nkw_quat_exp((nkw_vec3){0.5f * x, 0.5f * y, 0.2f * x});
            float *v = drawn.values[i] + width * k;
            if (is_rotation)
                memcpy(v, &q, sizeof q);
            else if (is_float)
                v[0] = x;
            else
                v[0] = is_root ? x : 1.0f, v[1] = is_root ? y : 0.0f, v[2] = 0.0f;
        }
    }
    for (size_t j = 0; j < JOINTS; j++)
        drawn.parents[j] = (int32_t)j - 1;
    drawn.source = source;
    return 0;
}

/* The models of tracks, or of a clip; and the float. */
static float models_at(const nkw_clip_source *s, const nkw_clip *clip, float time, nkw_mat4 *models)
{
    const nkw_skeleton skeleton = {drawn.parents, JOINTS};
    float pose[NKW_POSE_FLOATS(JOINTS)], number = 0.0f;
    nkw_pose_identity(pose_span(pose, JOINTS));
    for (size_t i = 0; !clip && i < s->track_count; i++)
        track_sample_to(&s->tracks[i], time, JOINTS, pose, &number);
    if (clip)
        assert_int_equal(nkw_clip_sample(clip, time, NULL, pose_span(pose, JOINTS), &number), NKW_OK);
    nkw_skeleton_models_from_pose(&skeleton, pose_view(pose, JOINTS), NULL, NULL, models);
    return number;
}

/* |p| + the root of the sum of the squares of 0.1 (a - b): no point of the sphere moves by more. */
static double most(const nkw_mat4 *a, const nkw_mat4 *b)
{
    double moved = 0.0, turned = 0.0;
    for (int i = 0; i < 12; i++) {
        const double d = (double)a->m[i] - (double)b->m[i], p = i < 3 ? (double)a->m[12 + i] - (double)b->m[12 + i] : 0;
        turned += (double)REACH * (double)REACH * d * d;
        moved += p * p;
    }
    return sqrt(moved) + sqrt(turned);
}

/* The largest distance of the reduced tracks, or of the clip, at all keys and between them; the float within 1e-3. */
static double largest_distance(const nkw_clip_source *reduced, const nkw_clip *clip)
{
    double largest = 0.0;
    for (size_t k = 0; k + 1 < KEYS; k++)
        for (int part = 0; part < 2; part++) {
            const float time = nkw_lerp(drawn.times[k], drawn.times[k + 1], 0.5f * (float)part);
            nkw_mat4 want[JOINTS], got[JOINTS];
            const float a = models_at(&drawn.source, NULL, time, want), b = models_at(reduced, clip, time, got);
            assert_true(nkw_abs(a - b) <= 1e-3f * 1.0001f);
            for (size_t j = 0; j < JOINTS; j++)
                if (most(&want[j], &got[j]) > largest)
                    largest = fmax(largest, farthest_distance(&want[j], &got[j], (double)REACH));
        }
    return largest;
}

static void a_long_clip_is_within_the_tolerance_everywhere(void **state)
{
    (void)state;
    const float tolerances[3] = {1e-2f, 1e-3f, 1e-4f};
    const size_t floats = clip_size_of(&drawn.source);
    for (int i = 0; i < 3; i++) {
        const nkw_clip_reduction r = {drawn.parents, tolerances[i], REACH, NULL, NULL, 1e-3f};
        nkw_clip_reduced reduced;
        const nkw_clip *clip;
        assert_int_equal(nkw_clip_reduce(&drawn.source, &r, bytes_span(block, sizeof block), &reduced, NULL,
                                         work_in(work, sizeof work)),
                         NKW_OK);
        assert_int_equal(nkw_clip_open(block, reduced.bytes, &clip), NKW_OK);
        const double largest = largest_distance(NULL, clip);
        assert_true(reduced.share <= 1.0f && largest <= (double)tolerances[i] + 2e-6);
        assert_true(largest >= 0.5 * (double)tolerances[i]); /* it is used */
        assert_true(reduced.bytes * 4 < floats);
    }
}

static void long_tracks_are_within_the_tolerance_everywhere(void **state)
{
    (void)state;
    const float tolerances[2] = {1e-2f, 1e-3f};
    for (int i = 0; i < 2; i++) {
        const nkw_clip_reduction r = {drawn.parents, tolerances[i], REACH, NULL, NULL, 1e-3f};
        nkw_clip_source_reduced reduced;
        assert_int_equal(nkw_clip_source_reduce(&drawn.source, &r, bytes_span(block, sizeof block), &reduced, NULL,
                                                work_in(work, sizeof work)),
                         NKW_OK);
        const double largest = largest_distance(&reduced.source, NULL);
        assert_true(reduced.reached.share <= 1.0f && largest <= (double)tolerances[i] + 2e-6);
        assert_true(largest >= 0.5 * (double)tolerances[i]);
        assert_true(reduced.reached.key_count * 2 < reduced.reached.source_key_count);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_long_clip_is_within_the_tolerance_everywhere),
        cmocka_unit_test(long_tracks_are_within_the_tolerance_everywhere),
    };
    return cmocka_run_group_tests_name("clip_reduce_long", tests, draw, NULL);
}
