/* SPDX-License-Identifier: MIT */
/* One property over time, with 2 to 100,000 keys: 65536 times at random, or 1024 as a player asks, on or back. */
#include <algorithm>
#include <cmath>
#include <memory>

#include "bench.h"
#include "peers.h"

using namespace bench;

struct data {
    std::vector<float> times, values, ask;
    nkw_track track;
};

static std::shared_ptr<data> draw(size_t keys, size_t width, nkw_track_kind kind, nkw_interpolation interpolation,
                                  asking how)
{
    auto d = std::make_shared<data>();
    size_t values = interpolation == NKW_INTERPOLATION_CUBICSPLINE ? 3 : 1;
    for (size_t k = 0; k < keys; k++) {
        d->times.push_back(static_cast<float>(k) / 30);
        for (size_t i = 0; i < values * width; i++)
            d->values.push_back(kind == NKW_TRACK_FLOATS ? point[i % 3][k % pool].x : (&unit_a[k % pool].x)[i % 4]);
    }
    for (size_t i = 0; i < (how == asking::random ? pool : near); i++)
        d->ask.push_back(time_at(how, i, d->times.back()));
    d->track = {d->times.data(), d->values.data(), keys, width, kind, interpolation, nullptr};
    return d;
}

static float *out(size_t i, size_t width)
{
    return &answer.at[0].m[0] + i * width;
}

/* What a user writes with std::upper_bound and glm, or by hand. */
static void by_hand(const data &d, float time, float *to)
{
    size_t after = static_cast<size_t>(std::upper_bound(d.times.begin(), d.times.end(), time) - d.times.begin());
    size_t k = std::min(std::max<size_t>(after, 1), d.times.size() - 1) - 1;
    float s = (time - d.times[k]) / (d.times[k + 1] - d.times[k]);
    s = s < 0 ? 0 : s > 1 ? 1 : s;
    const float *a = &d.values[k * d.track.width], *b = a + d.track.width;
    if (d.track.width == 3) {
        for (size_t i = 0; i < 3; i++)
            to[i] = a[i] + s * (b[i] - a[i]);
        return;
    }
#ifdef BENCH_GLM
    glm::quat q = glm::slerp(glm::quat(a[3], a[0], a[1], a[2]), glm::quat(b[3], b[0], b[1], b[2]), s);
    to[0] = q.x, to[1] = q.y, to[2] = q.z, to[3] = q.w;
#endif
}

static void rows(const char *name, size_t keys, size_t width, nkw_track_kind kind, nkw_interpolation interpolation,
                 asking how, double flops)
{
    auto d = draw(keys, width, kind, interpolation, how);
    operation op = {"track",
                    named(name, how),
                    width,
                    static_cast<double>(12 * width),
                    flops,
                    [=](size_t i, double *to) {
                        float value[4];
                        nkw_track_sample(&d->track, d->ask[i], NULL, value);
                        for (size_t k = 0; k < width; k++)
                            to[k] = static_cast<double>(value[k]);
                    },
                    0,
                    4096,
                    kind == NKW_TRACK_FLOATS ? same::number : same::rotation};
    op.sizes = {keys};
    op.elements = d->ask.size();
    into_structs(op, "nkw", [=](size_t, size_t n) {
        for (size_t i = 0; i < n; i++)
            nkw_track_sample(&d->track, d->ask[i], NULL, out(i, width));
    });
    into_structs(op, "nkw _from", [=](size_t, size_t n) {
        uint32_t cursor = 0;
        for (size_t i = 0; i < n; i++)
            nkw_track_sample(&d->track, d->ask[i], &cursor, out(i, width));
    });
    if (interpolation == NKW_INTERPOLATION_LINEAR)
        into_structs(op, width == 3 ? "loop" : "upper_bound, glm", [=](size_t, size_t n) {
            for (size_t i = 0; i < n; i++)
                by_hand(*d, d->ask[i], out(i, width));
        });
}

static const suite all([] {
    for (asking how : askings)
        for (size_t keys : {2u, 16u, 301u, 4096u, 100000u}) {
            rows("vec3 linear by keys", keys, 3, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR, how, 20);
            rows("vec3 cubicspline by keys", keys, 3, NKW_TRACK_FLOATS, NKW_INTERPOLATION_CUBICSPLINE, how, 55);
#ifdef BENCH_GLM
            rows("rotation linear by keys", keys, 4, NKW_TRACK_ROTATION, NKW_INTERPOLATION_LINEAR, how, 85);
#endif
        }
});
