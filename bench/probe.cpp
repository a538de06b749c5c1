/* SPDX-License-Identifier: MIT */
#include "probe.h"

#include <algorithm>
#include <chrono>
#include <memory>

#include <unistd.h>

namespace bench
{

/* The best of several: a limit is what is reached when nothing disturbs. */
template <class F> static double best_rate(F work)
{
    double best = 0;
    for (int repeat = 0; repeat < 15; repeat++) {
        auto begin = std::chrono::steady_clock::now();
        double amount = work();
        std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - begin;
        best = std::max(best, amount / took.count());
    }
    return best;
}

static constexpr size_t kib = 1024 / sizeof(float), far_floats = 64 * 1024 * kib;

/* GB/s of copying n floats again and again, at least 8 MiB at a time. */
static double copy_rate(const probe &p, float *x, size_t n)
{
    size_t times = std::max<size_t>(1, 2048 * kib / n);
    p.copy(x, x + n, n);
    return best_rate([=] {
        for (size_t k = 0; k < times; k++)
            p.copy(x, x + n, n);
        return static_cast<double>(2 * n * sizeof(float) * times);
    });
}

static limits measure(const char *isa, const probe &p, float *x)
{
    std::fill(x, x + 2 * far_floats, 1.0f);
    limits l = {isa, best_rate([=] { return p.work(x, 200000); }), 0, 0, 0, 0};
    l.near_copy = copy_rate(p, x, 8 * kib);
    l.second_copy = copy_rate(p, x, 128 * kib);
    l.third_copy = copy_rate(p, x, 2048 * kib);
    l.far_copy = copy_rate(p, x, far_floats);
    return l;
}

const std::vector<limits> &machine_limits()
{
    static const std::vector<limits> all = [] {
        std::vector<limits> found;
        std::unique_ptr<float[]> block(new float[2 * far_floats + 16]);
        size_t off = reinterpret_cast<size_t>(block.get()) / sizeof(float) % 16;
        float *x = block.get() + (16 - off);
        found.push_back(measure("sse2", probe_sse2, x));
        if (__builtin_cpu_supports("avx2"))
            found.push_back(measure("avx2", probe_avx2, x));
        if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
            __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw"))
            found.push_back(measure("avx512", probe_avx512, x));
        return found;
    }();
    return all;
}

/* Those of the instruction set of this build. */
static const limits &limits_of_build()
{
    const std::vector<limits> &all = machine_limits();
    return *std::find_if(all.begin(), all.end(), [](const limits &l) { return l.isa == BENCH_ISA; });
}

/* Bytes of a level of the caches, or what is usual where the system does not tell. */
static double level(int name, double usual)
{
    long bytes = sysconf(name);
    return bytes > 0 ? static_cast<double>(bytes) : usual;
}

double limit_ns(const row &r)
{
    const limits &l = limits_of_build();
    double set = r.bytes * static_cast<double>(r.round);
    double rate = set <= level(_SC_LEVEL1_DCACHE_SIZE, 32768)     ? l.near_copy
                  : set <= level(_SC_LEVEL2_CACHE_SIZE, 1048576)  ? l.second_copy
                  : set <= level(_SC_LEVEL3_CACHE_SIZE, 16777216) ? l.third_copy
                                                                  : l.far_copy;
    return std::max(r.bytes / rate, r.flops / l.flops);
}

} // namespace bench
