/* SPDX-License-Identifier: MIT */
#include "scene.h"

#include <algorithm>
#include <cmath>

#include "bench.h"
#include "peers.h"
#include "random.h"

namespace bench
{

static const size_t first[3] = {0, 3, 7}, width[3] = {3, 4, 3};

std::vector<int32_t> draw_parents(size_t joints)
{
    random_source source = random_from(67);
    std::vector<int32_t> parents(joints), level(joints);
    for (size_t j = 0; j < joints; j++) {
        int32_t up = static_cast<int32_t>(j) - 1;
        int climb = random_unit(&source) < 0.75f ? 0 : static_cast<int>(6 * random_unit(&source));
        while (up > 0 && (climb-- > 0 || level[static_cast<size_t>(up)] >= 11))
            up = parents[static_cast<size_t>(up)];
        parents[j] = up;
        level[j] = up < 0 ? 0 : level[static_cast<size_t>(up)] + 1;
    }
    return parents;
}

nkw_trs local_at(size_t i)
{
    nkw_vec3 p = point[0][i], q = point[1][i];
    return {{0.5f * p.x, 0.5f * p.y, 0.5f * p.z}, unit_a[i], {1 + 0.1f * q.x, 1 + 0.1f * q.y, 1 + 0.1f * q.z}};
}

/*
 * Neighbouring rotations are as near as in unit_near, for they go to and fro. Tangents of CUBICSPLINE keys are another
 * joint's numbers.
 */
static void draw_values(scene &s)
{
    size_t each = s.mode == NKW_INTERPOLATION_CUBICSPLINE ? 3 : 1;
    s.values.resize(s.joints * s.keys * each * 10);
    for (size_t j = 0; j < s.joints; j++)
        for (size_t k = 0; k < s.keys * each; k++) {
            nkw_trs trs = local_at((j * 7 + k) % pool);
            trs.rotation = k % 2 ? unit_near[j] : unit_a[j];
            for (size_t p = 0; p < 3; p++)
                std::copy_n(&trs.translation.x + first[p], width[p],
                            &s.values[(j * 10 + first[p]) * s.keys * each + k * width[p]]);
        }
    for (size_t j = 0; j < s.joints; j++)
        for (size_t p = 0; p < 3; p++) {
            const nkw_clip_target targets[3] = {NKW_CLIP_TRANSLATION, NKW_CLIP_ROTATION, NKW_CLIP_SCALE};
            const float *values = &s.values[(j * 10 + first[p]) * s.keys * each];
            s.tracks.push_back({targets[p],
                                static_cast<uint32_t>(j),
                                {s.times.data(), values, s.keys, width[p],
                                 p == 1 ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS, s.mode, nullptr}});
        }
}

static void keep_still(scene &s, size_t still)
{
    for (size_t i = 0; still && i < s.tracks.size(); i += still) {
        float *values = &s.values[(i / 3 * 10 + first[i % 3]) * s.keys];
        for (size_t k = 1; k < s.keys; k++)
            std::copy_n(values, width[i % 3], values + k * width[i % 3]);
    }
}

static void make_noisy(scene &s, size_t noisy)
{
    random_source source = random_from(29);
    for (size_t j = 0; noisy && j < s.joints; j += noisy)
        for (size_t k = 0; k < s.keys; k++) {
            float *q = &s.values[(j * 10 + first[1]) * s.keys + k * 4];
            for (int c = 0; c < 3; c++)
                q[c] = random_between(&source, -1, 1) * std::pow(10.0f, random_between(&source, -29, -23));
            q[3] = k % 2 ? 1 : 0x1.fffffep-1f;
        }
}

static void build(scene &s)
{
    std::vector<uint32_t> memory(NKW_CLIP_BUILD_WORK(s.tracks.size()) / sizeof(uint32_t));
    const nkw_work work = {memory.data(), NKW_CLIP_BUILD_WORK(s.tracks.size())};
    for (int format = 0; format < 2; format++) {
        nkw_clip_source source = {s.tracks.data(),
                                  s.tracks.size(),
                                  s.joints,
                                  0,
                                  {nullptr, 0},
                                  nullptr,
                                  format ? NKW_CLIP_UNORM16 : NKW_CLIP_FLOAT32,
                                  NULL};
        size_t bytes = 0;
        nkw_clip_build(&source, nkw_bytes_span{nullptr, 0}, &bytes, nullptr, work);
        s.blocks[format].resize(bytes / sizeof(float) + 1);
        nkw_clip_build(&source, nkw_bytes_span{s.blocks[format].data(), bytes}, &bytes, nullptr, work);
    }
    s.cursors.resize(nkw_clip_describe(s.clip(0)).cursor_count);
    s.pose.resize(NKW_POSE_FLOATS(s.joints));
}

std::shared_ptr<scene> draw_scene(size_t joints, size_t keys, nkw_interpolation mode, size_t still, size_t noisy)
{
    auto s = std::make_shared<scene>();
    s->joints = joints;
    s->keys = keys;
    s->mode = mode;
    for (size_t k = 0; k < keys; k++)
        s->times.push_back(static_cast<float>(k) / 30);
    draw_values(*s);
    keep_still(*s, still);
    make_noisy(*s, noisy);
    build(*s);
    return s;
}

nkw_trs scene::joint_at(size_t joint, float time) const
{
    nkw_trs trs;
    for (size_t p = 0; p < 3; p++)
        nkw_track_sample(&tracks[joint * 3 + p].track, time, NULL, &trs.translation.x + first[p]);
    return trs;
}

#ifdef BENCH_GLM
nkw_trs joint_by_hand(const scene &s, size_t joint, float time)
{
    nkw_trs trs;
    for (size_t p = 0; p < 3; p++) {
        const nkw_track &track = s.tracks[joint * 3 + p].track;
        const float *times = track.times;
        size_t after = static_cast<size_t>(std::upper_bound(times, times + s.keys, time) - times);
        size_t k = std::min(std::max<size_t>(after, 1), s.keys - 1) - 1;
        float u = (time - times[k]) / (times[k + 1] - times[k]);
        const float *a = track.values + k * track.width, *b = a + track.width;
        float *to = &trs.translation.x + first[p];
        if (p == 1) {
            glm::quat q = glm::slerp(glm::quat(a[3], a[0], a[1], a[2]), glm::quat(b[3], b[0], b[1], b[2]), u);
            trs.rotation = {q.x, q.y, q.z, q.w};
        } else {
            for (size_t i = 0; i < 3; i++)
                to[i] = a[i] + u * (b[i] - a[i]);
        }
    }
    return trs;
}
#endif

} // namespace bench
