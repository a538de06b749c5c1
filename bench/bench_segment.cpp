/* SPDX-License-Identifier: MIT */
/*
 * From a time to its segment, among 2 to 100,000 keys: 65536 times at random, which no predictor of branches learns,
 * or 1024 as a player asks, on or back.
 */
#include <algorithm>
#include <cmath>
#include <memory>

#include "bench.h"

using namespace bench;

struct timeline {
    std::vector<float> keys, ask;
    float rate;
};

/* Keys 1/32 s apart, so that what needs no search finds the same. */
static std::shared_ptr<timeline> line(size_t count, asking how)
{
    auto l = std::make_shared<timeline>();
    l->rate = 32;
    for (size_t k = 0; k < count; k++)
        l->keys.push_back(nkw_timeline_time(nkw_timeline{0, l->rate, 0}, k));
    for (size_t i = 0; i < (how == asking::random ? pool : near); i++)
        l->ask.push_back(time_at(how, i, l->keys.back()));
    return l;
}

static void put(size_t i, nkw_segment s)
{
    answer.part[0][i] = static_cast<float>(s.index);
    answer.part[1][i] = s.t;
}

static nkw_segment by_upper_bound(const std::vector<float> &keys, float time)
{
    size_t after = static_cast<size_t>(std::upper_bound(keys.begin(), keys.end(), time) - keys.begin());
    size_t k = std::min(std::max<size_t>(after, 1), keys.size() - 1) - 1;
    return {k, (time - keys[k]) / (keys[k + 1] - keys[k])};
}

/* A branchless search that is inlined, and a quotient of floats: wins at random times, loses where times follow. */
static nkw_segment by_halving(const std::vector<float> &keys, float time)
{
    const float *base = keys.data();
    for (size_t n = keys.size() - 1; n > 1; n -= n / 2)
        base += base[n / 2] <= time ? n / 2 : 0;
    return {static_cast<size_t>(base - keys.data()), (time - base[0]) / (base[1] - base[0])};
}

/*
 * The cursor that every player has: from where the last time was, key by key, inlined. Wins where times follow; a jump
 * walks all the way.
 */
static nkw_segment by_walking(const std::vector<float> &keys, float time, size_t k)
{
    while (k + 2 < keys.size() && keys[k + 1] <= time)
        k++;
    while (k > 0 && keys[k] > time)
        k--;
    return {k, (time - keys[k]) / (keys[k + 1] - keys[k])};
}

static void peers(const operation &op, std::shared_ptr<timeline> l, bool follow)
{
    batch(op, "std upper_bound", [=](size_t, size_t n) {
        for (size_t i = 0; i < n; i++)
            put(i, by_upper_bound(l->keys, l->ask[i]));
    });
    batch(op, "loop halving", [=](size_t, size_t n) {
        for (size_t i = 0; i < n; i++)
            put(i, by_halving(l->keys, l->ask[i]));
    });
    if (follow)
        batch(op, "loop walking", [=](size_t, size_t n) {
            nkw_segment s = by_upper_bound(l->keys, l->ask[0]);
            for (size_t i = 0; i < n; i++)
                put(i, s = by_walking(l->keys, l->ask[i], s.index));
        });
}

static operation finding(const std::string &name, std::shared_ptr<timeline> l, double flops)
{
    operation op = {"segment",
                    name,
                    2,
                    20,
                    flops,
                    [=](size_t i, double *out) {
                        nkw_segment s = nkw_segment_find(l->keys.data(), l->keys.size(), l->ask[i]);
                        out[0] = static_cast<double>(s.index), out[1] = static_cast<double>(s.t);
                    },
                    0,
                    4};
    op.sizes = {l->keys.size()};
    op.elements = l->ask.size();
    return op;
}

/* A float may be rounded up to the next key: right here, where all times are exact. */
static nkw_segment by_product(const timeline &l, float time)
{
    float x = time * l.rate;
    size_t k = std::min(static_cast<size_t>(x), l.keys.size() - 2);
    return {k, x - static_cast<float>(k)};
}

static void uniform_rows(std::shared_ptr<timeline> l, asking how)
{
    operation op = finding(named("find at a rate", how), l, 6);
    batch(op, "nkw", [=](size_t, size_t n) {
        for (size_t i = 0; i < n; i++)
            put(i, nkw_timeline_find(nkw_timeline{0, l->rate, l->keys.size()}, l->ask[i]));
    });
    batch(op, "loop", [=](size_t, size_t n) {
        for (size_t i = 0; i < n; i++)
            put(i, by_product(*l, l->ask[i]));
    });
}

static void rows(std::shared_ptr<timeline> l, asking how)
{
    operation op = finding(named("find by keys", how), l, 3 + std::log2(static_cast<double>(l->keys.size())));
    batch(op, "nkw", [=](size_t, size_t n) {
        for (size_t i = 0; i < n; i++)
            put(i, nkw_segment_find(l->keys.data(), l->keys.size(), l->ask[i]));
    });
    batch(op, "nkw _from", [=](size_t, size_t n) {
        nkw_segment s = {0, 0};
        for (size_t i = 0; i < n; i++)
            put(i, s = nkw_segment_find_hint(l->keys.data(), l->keys.size(), l->ask[i], s.index));
    });
    batch(op, "nkw _n", [=](size_t, size_t n) {
        static nkw_segment out[pool];
        nkw_segment_find_n(l->keys.data(), l->keys.size(), l->ask.data(), out, n);
        for (size_t i = 0; i < n; i++)
            put(i, out[i]);
    });
    peers(op, l, how != asking::random);
}

static const suite all([] {
    for (asking how : askings)
        for (size_t count : {2u, 16u, 301u, 4096u, 100000u})
            rows(line(count, how), how);
    for (asking how : askings)
        uniform_rows(line(301, how), how);
});
