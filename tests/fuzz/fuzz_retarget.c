/* SPDX-License-Identifier: MIT */
/* Feet, retargeting, axes of poses, blend spaces: in bounds for any indices and counts, and weights that are weights. */
#include "fuzz.h"
#include "../support/views.h"

#include <string.h>

enum { JOINTS = 24 };

static void feet(fuzz *f)
{
    nkw_foot_rules rules = NKW_FOOT_RULES;
    nkw_foot foot;
    memset(&foot, 0, sizeof foot);
    if (fuzz_byte(f) % 2)
        memcpy(&rules, fuzz_floats(f, sizeof rules / sizeof(float), 1), sizeof rules);
    for (int i = 0; i < 12; i++) {
        nkw_vec3 p = {fuzz_float(f), 0.1f * (float)fuzz_upto(f, 3), fuzz_float(f)};
        p.x = fuzz_byte(f) % 2 ? 0.01f * (float)i : p.x;
        if (fuzz_byte(f) % 4)
            nkw_foot_update(&foot, &rules, p, fuzz_byte(f) % 4 ? 0.0f : fuzz_float(f), fuzz_float(f));
        else
            nkw_foot_update_given(&foot, &rules, p, fuzz_byte(f) % 3, fuzz_float(f));
        FUZZ_CHECK(foot.contact == 0 || foot.contact == 1);
        FUZZ_CHECK(foot.weight >= 0.0f && foot.weight <= 1.0f);
    }
}

static void retargets(fuzz *f, int wild)
{
    size_t m = fuzz_upto(f, JOINTS), n = fuzz_upto(f, JOINTS), bad = 0;
    size_t room = fuzz_byte(f) % 8 ? NKW_RETARGET_WORK(m, n) : fuzz_upto(f, 300);
    nkw_retarget_joint *joints = fuzz_block(f, n * sizeof *joints);
    const int32_t *from = fuzz_links(f, n, m, wild), *to = fuzz_links(f, n, m, wild);
    for (size_t j = 0; j < n; j++) {
        nkw_retarget_joint map = {from[j], to[j], fuzz_float(f), fuzz_byte(f) % 4 ? 0.0f : fuzz_float(f)};
        joints[j] = map;
    }
    nkw_retarget r = {{fuzz_parents(f, m, wild), m},
                      {fuzz_parents(f, n, wild), n},
                      {fuzz_pose(f, m, wild), m},
                      {fuzz_pose(f, n, wild), n},
                      joints,
                      {0, 0, 0, 1}};
    memcpy(&r.align, fuzz_floats(f, 4, wild), sizeof r.align);
    nkw_retarget_validate(&r, &bad);
    FUZZ_CHECK(bad == 0 || bad < m || bad < n);
    nkw_pose_span out = {fuzz_room(f, NKW_POSE_FLOATS(n)), n};
    const nkw_work work = {fuzz_block(f, room), room};
    nkw_result result = nkw_retarget_apply(&r, pose_view(fuzz_pose(f, m, wild), m), out, work);
    FUZZ_CHECK((result == NKW_OK) == (room >= NKW_RETARGET_WORK(m, n)));
    size_t a = fuzz_upto(f, 6), b = fuzz_upto(f, 6);
    const int32_t *source_chain = fuzz_links(f, a, m, wild), *target_chain = fuzz_links(f, b, n, wild);
    nkw_retarget_map_chain(&r, source_chain, a, target_chain, b, joints);
    float scale = 1.0f;
    nkw_retarget_chain_scale(&r, source_chain, a, target_chain, b, &scale);
    FUZZ_CHECK(scale > 0.0f);
}

static void axes(fuzz *f, int wild)
{
    size_t n = fuzz_upto(f, JOINTS);
    const nkw_axes from = NKW_AXES_BLENDER, to = NKW_AXES_UNREAL;
    nkw_axes_map map = nkw_axes_map_from_axes(from, to);
    const float *pose = fuzz_pose(f, n, wild);
    nkw_pose_span out = {fuzz_room(f, NKW_POSE_FLOATS(n)), n};
    FUZZ_CHECK(nkw_pose_convert_axes(pose_view(pose, n), map, out) == NKW_OK);
    nkw_pose_convert_axes(NKW_VIEW(nkw_pose, out), nkw_axes_map_inverse(map), out);
    for (size_t c = 0; n && c < 10; c++)
        FUZZ_CHECK(fuzz_same(out.data + c * NKW_POSE_STRIDE(n), pose + c * NKW_POSE_STRIDE(n), n));
}

static void spaces(fuzz *f, int wild)
{
    size_t count = fuzz_upto(f, 12), dimension = fuzz_upto(f, 4), bad;
    nkw_blendspace space = {fuzz_floats(f, count * dimension, wild), count, dimension, NKW_BLENDSPACE_CARTESIAN};
    space.kind = (nkw_blendspace_kind)fuzz_choice(f, 1);
    float *weights = fuzz_room(f, count), sum = 0.0f;
    nkw_result known = nkw_blendspace_weights(&space, fuzz_floats(f, dimension, wild), weights);
    nkw_result result = nkw_blendspace_validate(&space, &bad);
    FUZZ_CHECK(bad == 0 || bad < count);
    FUZZ_CHECK(known == NKW_OK || result != NKW_OK);
    if (known != NKW_OK)
        return;
    for (size_t i = 0; i < count; i++) {
        FUZZ_CHECK(weights[i] >= 0.0f && weights[i] <= 1.0f);
        sum += weights[i];
    }
    FUZZ_CHECK(result != NKW_OK || (sum > 0.999999f && sum < 1.000001f));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz f = fuzz_begin(data, size);
    int wild = fuzz_byte(&f) % 2;
    feet(&f);
    retargets(&f, wild);
    axes(&f, wild);
    spaces(&f, wild);
    return fuzz_end(&f);
}
