/* SPDX-License-Identifier: MIT */
#include "fuzz.h"
#include "../support/views.h"

#include <string.h>

enum { JOINTS = 150, LAYERS = 9 };

static int same_pose(const float *a, const float *b, size_t n)
{
    size_t stride = NKW_POSE_STRIDE(n);
    for (size_t c = 0; c < 10; c++)
        if (!fuzz_same(a + c * stride, b + c * stride, n))
            return 0;
    return 1;
}

static int finite_pose(const float *a, size_t n)
{
    for (size_t c = 0; c < 10; c++)
        if (!fuzz_finite(a + c * NKW_POSE_STRIDE(n), n))
            return 0;
    return 1;
}

static float *draw_mask(fuzz *f, size_t n, int wild)
{
    return fuzz_byte(f) % 2 ? NULL : fuzz_floats(f, NKW_POSE_STRIDE(n), wild);
}

static void two(fuzz *f, size_t n, int wild)
{
    const float *a = fuzz_pose(f, n, wild), *b = fuzz_pose(f, n, wild), *mask = draw_mask(f, n, wild);
    float *out = fuzz_room(f, NKW_POSE_FLOATS(n)), t = wild ? fuzz_float(f) : (float)fuzz_byte(f) / 255.0f;
    nkw_pose_blend_slerp(pose_view(a, n), pose_view(b, n), t, mask_view(mask, n), pose_span(out, n));
    FUZZ_CHECK(wild || finite_pose(out, n));
    nkw_pose_blend(pose_view(a, n), pose_view(b, n), t, mask_view(mask, n), pose_span(out, n));
    FUZZ_CHECK(wild || finite_pose(out, n));
}

/* In place over either input: the same bits. */
static void two_in_place(fuzz *f, size_t n)
{
    float *a = fuzz_pose(f, n, 1), *b = fuzz_pose(f, n, 1), t = fuzz_float(f);
    float *out = fuzz_room(f, NKW_POSE_FLOATS(n));
    nkw_pose_blend(pose_view(a, n), pose_view(b, n), t, mask_view(NULL, n), pose_span(out, n));
    int over_b = fuzz_byte(f) % 2;
    nkw_pose_blend(pose_view(a, n), pose_view(b, n), t, mask_view(NULL, n), pose_span(over_b ? b : a, n));
    FUZZ_CHECK(same_pose(out, over_b ? b : a, n));
}

static void many(fuzz *f, size_t n, int wild)
{
    nkw_pose_layer layer[LAYERS], turned[LAYERS];
    size_t count = fuzz_upto(f, LAYERS), by = fuzz_upto(f, LAYERS);
    for (size_t i = 0; i < count; i++) {
        const float *pose = i && fuzz_byte(f) % 4 == 0 ? layer[i - 1].pose.data : fuzz_pose(f, n, wild);
        float weight = fuzz_byte(f) % 4 ? fuzz_float(f) : 1.0f;
        nkw_pose_layer l = {pose_view(pose, n), weight, mask_view(draw_mask(f, n, wild), n)};
        layer[i] = l;
    }
    for (size_t i = 0; i < count; i++)
        turned[(i + by) % count] = layer[i];
    const float *rest = fuzz_pose(f, n, wild);
    float *out = fuzz_room(f, NKW_POSE_FLOATS(n)), *again = fuzz_room(f, NKW_POSE_FLOATS(n));
    float threshold = fuzz_float(f);
    size_t bad;
    nkw_pose_layers_validate(layer, count, n, &bad);
    FUZZ_CHECK(bad < count || bad == 0);
    for (size_t i = 0; i < count; i++)
        FUZZ_CHECK(!layer[i].mask.data || nkw_mask_validate(layer[i].mask, &bad) != NKW_OK || bad == 0);
    nkw_pose_layers_blend(layer, count, pose_view(rest, n), threshold, pose_span(out, n));
    nkw_pose_layers_blend(turned, count, pose_view(rest, n), threshold, pose_span(again, n));
    FUZZ_CHECK(same_pose(out, again, n));
    FUZZ_CHECK(wild || finite_pose(out, n));
}

static void additive(fuzz *f, size_t n, int wild)
{
    const float *a = fuzz_pose(f, n, wild), *ref = fuzz_pose(f, n, wild), *mask = draw_mask(f, n, wild);
    float *delta = fuzz_room(f, NKW_POSE_FLOATS(n)), *out = fuzz_room(f, NKW_POSE_FLOATS(n));
    nkw_additive side = (nkw_additive)fuzz_choice(f, 1);
    nkw_result result = nkw_pose_additive_build(pose_view(a, n), pose_view(ref, n), side, pose_span(delta, n));
    FUZZ_CHECK(result == ((unsigned)side > 1 ? NKW_BAD_METHOD : NKW_OK));
    if (result != NKW_OK)
        return;
    FUZZ_CHECK(wild || finite_pose(delta, n));
    nkw_pose_additive_apply(pose_view(ref, n), pose_view(delta, n), wild ? fuzz_float(f) : 1.0f, mask_view(mask, n),
                            side, pose_span(out, n));
    FUZZ_CHECK(wild || finite_pose(out, n));
    nkw_pose_additive_apply(pose_view(a, n), pose_view(delta, n), 0.0f, mask_view(mask, n), side, pose_span(out, n));
    FUZZ_CHECK(same_pose(out, a, n));
}

/* Any map of partners: the mirror twice is the pose. */
static void mirror(fuzz *f, size_t n)
{
    const float *pose = fuzz_pose(f, n, 1);
    const int32_t *pair = fuzz_links(f, n, n, 1);
    float *out = fuzz_room(f, NKW_POSE_FLOATS(n));
    nkw_mirror plane = (nkw_mirror)fuzz_choice(f, 2);
    size_t bad;
    nkw_result result = nkw_pose_mirror(pose_view(pose, n), pair, plane, pose_span(out, n), &bad);
    FUZZ_CHECK(bad < n || bad == 0);
    if (result != NKW_OK)
        return;
    FUZZ_CHECK(nkw_pose_mirror(pose_view(out, n), pair, plane, pose_span(out, n), NULL) == NKW_OK);
    FUZZ_CHECK(same_pose(out, pose, n));
}

/* A track of any kind for the partner of any joint. */
static void mirror_track(fuzz *f, const nkw_mirror_rig *rig, nkw_work work)
{
    const nkw_axes_kind kind = (nkw_axes_kind)(fuzz_byte(f) % 5);
    const size_t width = 3 + fuzz_byte(f) % 2, count = fuzz_upto(f, 5);
    const int is_cubic = fuzz_byte(f) % 2;
    float *times = fuzz_floats(f, count, 1), *values = fuzz_floats(f, 3 * count * width, 1);
    float *out = fuzz_room(f, 3 * count * width);
    const nkw_track track = {times, values, count, width, width == 4 ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS,
                             is_cubic ? NKW_INTERPOLATION_CUBICSPLINE : NKW_INTERPOLATION_LINEAR, NULL};
    const size_t joint = fuzz_byte(f) % 2 ? fuzz_huge(f) : fuzz_upto(f, JOINTS);
    nkw_track_mirror_rest(&track, rig, joint, kind, fuzz_byte(f) % 2 ? out : values, work);
}

/* Partners of partners, of the partner of the parent unless there is none. */
static void mirror_places(fuzz *f, const nkw_mirror_rig *rig, size_t n)
{
    const nkw_skeleton skeleton = {rig->parents, n};
    nkw_mat4 models[JOINTS];
    int32_t pair[JOINTS];
    for (size_t i = 0; i < n; i++) {
        models[i] = nkw_mat4_identity();
        for (size_t k = 12; k < 15; k++)
            models[i].m[k] = fuzz_byte(f) % 4 ? (float)(fuzz_byte(f) % 5) - 2.0f : fuzz_float(f);
    }
    const size_t pairs = nkw_mirror_pairs_from_models(&skeleton, models, rig->plane, fuzz_float(f), pair);
    FUZZ_CHECK(2 * pairs <= n);
    for (size_t i = 0; i < n; i++)
        FUZZ_CHECK(pair[i] >= 0 && (size_t)pair[i] < n && pair[pair[i]] == (int32_t)i);
}

/* Through any rest pose, and names of any bytes. */
static void mirror_rest(fuzz *f, size_t n)
{
    const float *pose = fuzz_pose(f, n, 1), *rest = fuzz_pose(f, n, 0);
    const nkw_mirror_rig rig = {fuzz_parents(f, n, 1), fuzz_links(f, n, n, 1), pose_view(rest, n),
                                (nkw_mirror)fuzz_choice(f, 2)};
    float *out = fuzz_room(f, NKW_POSE_FLOATS(n)), difference = 0.0f;
    NKW_STACK_WORK(work, NKW_MIRROR_WORK(JOINTS));
    size_t bad;
    nkw_pose_mirror_rest(pose_view(pose, n), &rig, pose_span(out, n), &difference, &bad, work);
    FUZZ_CHECK(bad < n || bad == 0);
    FUZZ_CHECK(difference >= 0.0f && difference < 3.15f);
    mirror_track(f, &rig, work);
    mirror_places(f, &rig, n);
    char text[4][5] = {{0}};
    const char *names[4];
    int32_t pair[4];
    for (size_t i = 0; i < 4; i++) {
        for (size_t k = 0; k < 4; k++)
            text[i][k] = "LRlr_.A"[fuzz_byte(f) % 7];
        names[i] = text[i];
    }
    nkw_mirror_pairs_from_names(names, 4, pair);
    for (size_t i = 0; i < 4; i++)
        FUZZ_CHECK(pair[i] >= 0 && pair[i] < 4 && pair[pair[i]] == (int32_t)i);
}

static void mask_and_pose(fuzz *f, size_t n)
{
    float *mask = fuzz_room(f, NKW_POSE_STRIDE(n)), *pose = fuzz_pose(f, n, 1);
    size_t bad, root = fuzz_byte(f) % 4 ? fuzz_upto(f, JOINTS) : fuzz_huge(f);
    mask_from_subtree(fuzz_parents(f, n, 1), n, root, mask);
    for (size_t j = 0; j < NKW_POSE_STRIDE(n); j++)
        FUZZ_CHECK(mask[j] == 1.0f || mask[j] == 0.0f);
    nkw_result result = nkw_pose_validate(pose_view(pose, n), &bad);
    FUZZ_CHECK(bad < n || bad == 0);
    FUZZ_CHECK(result != NKW_OK || finite_pose(pose, n));
    nkw_trs trs = nkw_pose_get(pose_view(pose, n), root);
    nkw_pose_set(pose_span(pose, n), root, &trs);
    nkw_trs *all = fuzz_block(f, n * sizeof *all);
    float *back = fuzz_room(f, NKW_POSE_FLOATS(n));
    nkw_trs_from_pose(pose_view(pose, n), all);
    nkw_pose_from_trs(all, pose_span(back, n));
    FUZZ_CHECK(same_pose(pose, back, n));
}

static void layers_of_branches(fuzz *f, size_t n, int wild)
{
    const nkw_skeleton skeleton = {fuzz_parents(f, n, 1), n};
    float *pose = fuzz_pose(f, n, wild), *mask = fuzz_room(f, NKW_POSE_STRIDE(n)), *times = fuzz_floats(f, n, wild);
    const size_t root = fuzz_upto(f, JOINTS);
    FUZZ_CHECK(nkw_mask_from_branch(&skeleton, root, fuzz_float(f), mask_span(mask, n)) == NKW_OK);
    FUZZ_CHECK(n == 0 || nkw_mask_validate(mask_view(mask, n), NULL) == NKW_OK);
    FUZZ_CHECK(nkw_mask_from_times(times, fuzz_float(f), (nkw_ease_kind)fuzz_choice(f, 40), mask_span(mask, n)) ==
               NKW_OK);
    FUZZ_CHECK(n == 0 || nkw_mask_validate(mask_view(mask, n), NULL) == NKW_OK);
    FUZZ_CHECK(nkw_skeleton_compose_rotations(&skeleton, pose_view(pose, n), pose_span(pose, n)) == NKW_OK);
    FUZZ_CHECK(nkw_skeleton_separate_rotations(&skeleton, pose_view(pose, n), pose_span(pose, n)) == NKW_OK);
    FUZZ_CHECK(wild || finite_pose(pose, n));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz f = fuzz_begin(data, size);
    size_t n = fuzz_upto(&f, JOINTS);
    int wild = fuzz_byte(&f) % 2;
    two(&f, n, wild);
    two_in_place(&f, n);
    many(&f, n, wild);
    additive(&f, n, wild);
    mirror(&f, n);
    mirror_rest(&f, n);
    mask_and_pose(&f, n);
    layers_of_branches(&f, n, wild);
    return fuzz_end(&f);
}
