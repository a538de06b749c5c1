/* SPDX-License-Identifier: MIT */
/*
 * Poses out of clips. An element is a joint, so the time of a pose is the number of joints times that in the table. By
 * joints: 301 keys in ten seconds. By keys: 16 joints.
 */
#include <algorithm>
#include <cmath>
#include <memory>

#include "bench.h"
#include "peers.h"
#include "scene.h"

using namespace bench;

/* The times of the calls, in this order. The first one is that of the check. slow: in steps of 1/6000 s instead. */
struct playing {
    asking how;
    float end;
    size_t call;
    bool slow;
    float next()
    {
        size_t i = call++;
        return i == 0 ? checked() : slow ? std::fmod(static_cast<float>(i % 60000) / 6000, end) : time_at(how, i, end);
    }
    float checked() const
    {
        return 0.321f * end;
    }
};

static void spread(const scene &s)
{
    for (size_t j = 0; j < s.joints; j++)
        for (size_t c = 0; c < 10; c++)
            answer.part[c][j] = s.pose[c * NKW_POSE_STRIDE(s.joints) + j];
}

static void row(const operation &op, const char *who, std::shared_ptr<scene> s, asking how,
                std::function<void(scene &, float)> sample, bool slow = false)
{
    auto time = std::make_shared<playing>(playing{how, s->times.back(), 0, slow});
    auto check = [=](size_t) {
        time->call = 0;
        sample(*s, time->next());
        spread(*s);
    };
    add(op, who, layout::components, op.sizes[0], check, [=](benchmark::State &state) {
        for (auto _ : state) {
            sample(*s, time->next());
            benchmark::ClobberMemory();
        }
    });
}

static void put(scene &s, size_t joint, const nkw_trs &trs)
{
    for (size_t c = 0; c < 10; c++)
        s.pose[c * NKW_POSE_STRIDE(s.joints) + joint] = (&trs.translation.x)[c];
}

static operation posing(const std::string &name, std::shared_ptr<scene> s, size_t size, float checked)
{
    operation op = {"clip",
                    name,
                    10,
                    120,
                    125,
                    [=](size_t j, double *out) {
                        nkw_trs trs = s->joint_at(j, checked);
                        std::copy_n(&trs.translation.x, 10, out);
                    },
                    1024,
                    4096,
                    same::transform};
    op.sizes = {size};
    op.elements = s->joints;
    if (s->mode == NKW_INTERPOLATION_CUBICSPLINE)
        op.bytes = 200, op.flops = 147; /* keys, the tangents between, and the result */
    if (s->mode == NKW_INTERPOLATION_STEP)
        op.bytes = 80, op.flops = 0;
    return op;
}

static void rows(const char *name, std::shared_ptr<scene> s, size_t size, asking how)
{
    operation op = posing(named(name, how), s, size, playing{how, s->times.back(), 0, false}.checked());
    row(op, "nkw", s, how, [](scene &x, float time) {
        nkw_clip_sample(x.clip(0), time, x.cursors.data(), nkw_pose_span{x.pose.data(), x.joints}, nullptr);
    });
    if (s->mode == NKW_INTERPOLATION_LINEAR)
        row(op, "nkw 16 bits", s, how, [](scene &x, float time) {
            nkw_clip_sample(x.clip(1), time, x.cursors.data(), nkw_pose_span{x.pose.data(), x.joints}, nullptr);
        });
    /* Track by track, each with its own search: the reference, not a rival. */
    row(op, "nkw tracks", s, how, [](scene &x, float time) {
        for (size_t j = 0; j < x.joints; j++)
            put(x, j, x.joint_at(j, time));
    });
#ifdef BENCH_GLM
    if (s->mode == NKW_INTERPOLATION_LINEAR)
        row(op, "upper_bound, glm", s, how, [](scene &x, float time) {
            for (size_t j = 0; j < x.joints; j++)
                put(x, j, joint_by_hand(x, j, time));
        });
#endif
}

/* Steps of 1/6000 s: slow motion. */
static void slow_rows(std::shared_ptr<scene> s)
{
    operation op =
        posing("pose in slow motion", s, s->joints, playing{asking::onward, s->times.back(), 0, true}.checked());
    for (int format = 0; format < 2; format++) {
        const size_t bytes = nkw_clip_describe(s->clip(format)).cache_bytes;
        auto cache = std::make_shared<std::vector<float>>(bytes / sizeof(float));
        row(
            op, format ? "nkw 16 bits" : "nkw", s, asking::onward,
            [=](scene &x, float time) {
                nkw_clip_sample(x.clip(format), time, x.cursors.data(), nkw_pose_span{x.pose.data(), x.joints},
                                nullptr);
            },
            true);
        row(
            op, format ? "nkw 16 bits _cached" : "nkw _cached", s, asking::onward,
            [=](scene &x, float time) {
                nkw_clip_sample_cached(x.clip(format), time, nkw_bytes_span{cache->data(), bytes},
                                       nkw_pose_span{x.pose.data(), x.joints}, nullptr);
            },
            true);
    }
}

static const suite all([] {
    slow_rows(draw_scene(67, 301));
    for (size_t joints : {10u, 67u, 256u, 1000u}) {
        auto s = draw_scene(joints, 301);
        for (asking how : askings)
            rows("pose by joints", s, joints, how);
    }
    rows("a fifth still pose by joints", draw_scene(67, 301, NKW_INTERPOLATION_LINEAR, 5), 67, asking::onward);
    rows("half noisy pose by joints", draw_scene(67, 301, NKW_INTERPOLATION_LINEAR, 0, 2), 67, asking::onward);
    rows("CUBICSPLINE pose by joints", draw_scene(67, 301, NKW_INTERPOLATION_CUBICSPLINE), 67, asking::onward);
    rows("STEP pose by joints", draw_scene(67, 301, NKW_INTERPOLATION_STEP), 67, asking::onward);
    for (size_t keys : {2u, 16u, 301u, 4096u, 100000u}) {
        auto s = draw_scene(16, keys);
        for (asking how : askings)
            rows("pose by keys", s, keys, how);
    }
});
