/* SPDX-License-Identifier: MIT */
/*
 * Poses out of clips: every joint has keys for its translation, rotation and scale, 301 of them in ten seconds. An
 * element is a joint, so the time of a pose is n times the number in the table.
 */
#include <algorithm>
#include <memory>

#include "bench.h"
#include "peers.h"

using namespace bench;

static const size_t keys = 301;

struct scene {
    size_t joints;
    std::vector<float> times, values, pose;
    std::vector<nkw_clip_track> tracks;
    std::vector<float> blocks[2]; /* of each format */
    std::vector<uint32_t> cursors;

    const nkw_clip *clip(int format) const
    {
        return reinterpret_cast<const nkw_clip *>(blocks[format].data());
    }
};

/* Ten arrays of keys a joint: neighbouring rotations are as near as in unit_near, for they go to and fro. */
static void draw_values(scene &s)
{
    static const size_t at[3] = {0, 3, 7}, width[3] = {3, 4, 3};
    s.values.resize(s.joints * keys * 10);
    for (size_t j = 0; j < s.joints; j++)
        for (size_t k = 0; k < keys; k++) {
            size_t i = (j * 7 + k) % pool;
            const nkw_trs trs = {point[0][i], k % 2 ? unit_near[j] : unit_a[j], place[i].scale};
            for (size_t p = 0; p < 3; p++)
                std::copy_n(&trs.translation.x + at[p], width[p], &s.values[(j * 10 + at[p]) * keys + k * width[p]]);
        }
    for (size_t j = 0; j < s.joints; j++)
        for (size_t p = 0; p < 3; p++) {
            const nkw_clip_target targets[3] = {NKW_CLIP_TRANSLATION, NKW_CLIP_ROTATION, NKW_CLIP_SCALE};
            const float *values = &s.values[(j * 10 + at[p]) * keys];
            s.tracks.push_back({targets[p],
                                static_cast<uint32_t>(j),
                                {s.times.data(), values, keys, width[p], p == 1 ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS,
                                 NKW_INTERPOLATION_LINEAR, nullptr}});
        }
}

static void build(scene &s)
{
    std::vector<uint32_t> work(NKW_CLIP_WORK(s.tracks.size()));
    for (int format = 0; format < 2; format++) {
        nkw_clip_source source = {s.tracks.data(),
                                  s.tracks.size(),
                                  s.joints,
                                  0,
                                  nullptr,
                                  nullptr,
                                  format ? NKW_CLIP_UNORM16 : NKW_CLIP_FLOAT32};
        size_t bytes = 0;
        nkw_clip_measure(&source, work.data(), &bytes, nullptr);
        s.blocks[format].resize(bytes / sizeof(float) + 1);
        nkw_clip_build(&source, work.data(), s.blocks[format].data(), bytes, nullptr);
    }
    s.cursors.resize(nkw_clip_cursors(s.clip(0)));
    s.pose.resize(NKW_POSE_FLOATS(s.joints));
}

static std::shared_ptr<scene> draw(size_t joints)
{
    auto s = std::make_shared<scene>();
    s->joints = joints;
    for (size_t k = 0; k < keys; k++)
        s->times.push_back(static_cast<float>(k) / 30);
    draw_values(*s);
    build(*s);
    return s;
}

/* Where the time stands at each call: anywhere, or 1/60 s on. The first one is that of the check. */
struct playing {
    bool random;
    size_t call = 0;
    float next()
    {
        size_t i = call++;
        return i == 0 ? 3.21f : random ? 10 * t[i % pool] : static_cast<float>(i % 600) / 60;
    }
};

static void spread(const scene &s)
{
    for (size_t j = 0; j < s.joints; j++)
        for (size_t c = 0; c < 10; c++)
            answer.part[c][j] = s.pose[c * NKW_POSE_STRIDE(s.joints) + j];
}

#ifdef BENCH_GLM
/* What stands in many programs: track by track, each with its own search and the C library's slerp. */
static void by_hand(scene &s, float time)
{
    for (const nkw_clip_track &c : s.tracks) {
        const float *times = c.track.times;
        size_t after = static_cast<size_t>(std::upper_bound(times, times + keys, time) - times);
        size_t k = std::min(std::max<size_t>(after, 1), keys - 1) - 1;
        float u = (time - times[k]) / (times[k + 1] - times[k]), *to = s.pose.data() + c.index;
        const float *a = c.track.values + k * c.track.width, *b = a + c.track.width;
        size_t step = NKW_POSE_STRIDE(s.joints);
        if (c.target != NKW_CLIP_ROTATION) {
            for (size_t i = 0; i < 3; i++)
                to[(i + (c.target == NKW_CLIP_SCALE ? 7 : 0)) * step] = a[i] + u * (b[i] - a[i]);
            continue;
        }
        glm::quat q = glm::slerp(glm::quat(a[3], a[0], a[1], a[2]), glm::quat(b[3], b[0], b[1], b[2]), u);
        to[3 * step] = q.x, to[4 * step] = q.y, to[5 * step] = q.z, to[6 * step] = q.w;
    }
}
#endif

static void row(const operation &op, const char *who, std::shared_ptr<scene> s, bool random,
                std::function<void(scene &, float)> sample)
{
    auto time = std::make_shared<playing>();
    time->random = random;
    auto fill = [=](size_t) {
        time->call = 0;
        sample(*s, time->next());
        spread(*s);
    };
    add(op, who, layout::components, s->joints, fill, [=](benchmark::State &state) {
        for (auto _ : state) {
            sample(*s, time->next());
            benchmark::ClobberMemory();
        }
    });
}

static void rows(size_t joints, bool random)
{
    auto s = draw(joints);
    operation op = {"clip",
                    std::to_string(joints) + (random ? " joints, random" : " joints, in order"),
                    10,
                    120,
                    125,
                    [=](size_t j, double *out) {
                        for (size_t p = 0; p < 3; p++) {
                            float value[4];
                            static const size_t at[3] = {0, 3, 7}, width[3] = {3, 4, 3};
                            nkw_track_sample(&s->tracks[j * 3 + p].track, 3.21f, value);
                            std::copy_n(value, width[p], out + at[p]);
                        }
                    },
                    1024,
                    4096,
                    same::transform};
    row(op, "nkw", s, random,
        [](scene &x, float time) { nkw_clip_sample(x.clip(0), time, x.cursors.data(), x.pose.data(), nullptr); });
    row(op, "nkw 16 bits", s, random,
        [](scene &x, float time) { nkw_clip_sample(x.clip(1), time, x.cursors.data(), x.pose.data(), nullptr); });
    row(op, "nkw tracks", s, random, [](scene &x, float time) {
        static const size_t at[3] = {0, 3, 7};
        for (const nkw_clip_track &c : x.tracks) {
            float value[4];
            nkw_track_sample(&c.track, time, value);
            for (size_t i = 0; i < c.track.width; i++)
                x.pose[(at[c.target] + i) * NKW_POSE_STRIDE(x.joints) + c.index] = value[i];
        }
    });
#ifdef BENCH_GLM
    row(op, "upper_bound, glm", s, random, by_hand);
#endif
}

static const suite all([] {
    for (size_t joints : {16u, 67u, 1024u}) {
        rows(joints, true);
        rows(joints, false);
    }
});
