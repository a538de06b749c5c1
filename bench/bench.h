/* SPDX-License-Identifier: MIT */
/*
 * What every bench file stands on: the same inputs for all, a reference for each operation, and three ways to add a
 * row.
 *
 *     operation slerp = {"orient", "slerp rand", 4, 52, 61, reference};     what is computed, and what is right
 *     single(slerp, "glm", f)        f(i) gives the value of element i          array of structs, one by one, and as a
 *                                    dependent chain
 *     chained(slerp, "glm", x, f)    f(x[i], i) likewise                        the same, the chain by x = f(x, i)
 *     batch(slerp, "loop SoA", f)    f(from, n) fills `answer`                  component arrays, or anything else
 *
 * Each row is checked before it is timed: elements 0 .. n-1 against the reference, the worst error is its counter,
 * and a row that is off by more than the operation allows fails the whole run. Names that begin with "nkw" are the
 * library's own.
 */
#ifndef NAKAWARI_BENCH_H
#define NAKAWARI_BENCH_H

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <new>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>
#include <nakawari/nakawari.h>

namespace bench
{

/*
 * Elements of every input array. Calls of fewer elements than `near` go round the first `near`, which stay in a near
 * cache, but whose branches a predictor may learn; those of `pool` elements it cannot.
 */
constexpr size_t pool = 65536, near = 1024;
/* Floats from one component array to the next: arrays a power of two apart would fall on the same lines of a cache. */
constexpr size_t stride = pool + 80;

/* The same values as an array of structs and as component arrays. */
template <class T> struct array {
    static constexpr size_t parts = sizeof(T) / sizeof(float);
    alignas(64) T at[pool];
    alignas(64) float part[parts][stride];

    const T &operator[](size_t i) const
    {
        return at[i];
    }
    void set(size_t i, const T &value)
    {
        at[i] = value;
        for (size_t k = 0; k < parts; k++)
            part[k][i] = reinterpret_cast<const float *>(&at[i])[k];
    }
};

/*
 * unit_a, unit_b     unrelated unit quaternions: half the pairs need a change of sign
 * unit_near          0.5 to 15 degrees of rotation from unit_a, as neighbouring keys are
 * point[0..3]        coordinates in -1..1
 * angles             three angles: the second within +-1.5, away from the pole, the others within +-3
 * place              translation in -1..1, any rotation, scale in 0.5..2
 * rigid, affine      rotation and translation; the matrix of `place`
 * general            elements in -1..1 and 2 more on the diagonal
 * turn               rotation matrices
 * t 0..1, signed_one -1..1, turns -10..10, positive 0.01..100
 */
extern array<nkw_quat> unit_a, unit_b, unit_near;
extern array<nkw_vec3> point[4], angles;
extern array<nkw_trs> place, place_b;
extern array<nkw_mat4> rigid, affine, general;
extern array<nkw_mat3> turn;
extern array<float> t, signed_one, turns, positive;

/* What rows write: element i at `element(answer)[i]`, or component k in answer.part[k][i]. */
extern array<nkw_mat4> answer;

/* The bytes of an input as another library's type. */
template <class T, class U> const T *as(const array<U> &a)
{
    static_assert(sizeof(T) == sizeof(U), "the same bytes");
    return reinterpret_cast<const T *>(a.at);
}

nkw_vec3_view view(const array<nkw_vec3> &a, size_t from);
nkw_quat_view view(const array<nkw_quat> &a, size_t from);
nkw_trs_view view(const array<nkw_trs> &a, size_t from);
nkw_mat4_view view(const array<nkw_mat4> &a, size_t from);
nkw_vec3_span vec3_out(size_t from);
nkw_quat_span quat_out(size_t from);
nkw_mat4_span mat4_out(size_t from);

/* Which differences count: q and -q are the same as a rotation, and as components 3..6 of a transform. */
enum class same { number, rotation, transform };

using reference = std::function<void(size_t i, double *out)>;

/*
 * width    floats of a result
 * bytes    read and written for one element
 * flops    additions, multiplications, divisions and roots of one element, as the formula has them
 * truth    the result of element i in binary64
 * own      the library's error may be this many u of the result's largest component, u = 2^-24
 * others   and a peer's
 */
struct operation {
    std::string stem, name;
    size_t width;
    double bytes, flops;
    reference truth;
    double own = 4, others = 4096;
    same sort = same::number;
    double least = 1; /* the error is in u of this at the least; 0: of the result alone */
    std::vector<size_t> sizes = {1, 16, 67, 1024, 65536};
    size_t elements = 0; /* of a call, where the size is of something else: of the keys, say. 0: the size */
    size_t round = 0; /* of all calls together, where each goes on from the one before. 0: as of a call */
};

enum class layout { structs, components, chain };

/* What is measured: the time of this thread on its processor, or what the row itself says, by SetIterationTime. */
enum class passing { processor, told };

/* A row of one size: `check` computes the first elements into `answer`, `time` does all for the benchmark. */
void add(const operation &op, const std::string &who, layout where, size_t n, std::function<void(size_t)> check,
         std::function<void(benchmark::State &)> time, passing clock = passing::processor);

/*
 * A row of a data floor at its one size, op.sizes[0]: `run` does the work where its data lie, `show` takes the result
 * to `answer` for the check.
 */
template <class Run, class Show>
void whole(const operation &op, const std::string &who, layout where, Run run, Show show)
{
    auto check = [=](size_t) {
        run();
        show();
    };
    auto time = [=](benchmark::State &state) {
        for (auto _ : state) {
            run();
            benchmark::ClobberMemory();
        }
    };
    add(op, who, where, op.sizes[0], check, time);
}

template <class Run> void whole(const operation &op, const std::string &who, layout where, Run run)
{
    whole(op, who, where, run, [] {});
}

/* Where the next call begins. */
inline size_t next(size_t from, size_t n)
{
    from += n == 1 ? 1 : (n + 15) / 16 * 16;
    return from + n > near ? 0 : from;
}

template <class F> void over(const operation &op, const char *who, layout where, F fill)
{
    for (size_t size : op.sizes) {
        size_t n = op.elements ? op.elements : size;
        operation gone = op;
        gone.round = n < near ? near : n;
        add(
            gone, who, where, size, [=](size_t count) { fill(size_t{0}, count); },
            [=](benchmark::State &state) {
                size_t from = 0;
                for (auto _ : state) {
                    fill(from, n);
                    benchmark::ClobberMemory();
                    from = next(from, n);
                }
            });
    }
}

template <class F> void batch(const operation &op, const char *who, F fill)
{
    over(op, who, layout::components, fill);
}

/* Like batch, but into an array of structs. */
template <class F> void into_structs(const operation &op, const char *who, F fill)
{
    over(op, who, layout::structs, fill);
}

/*
 * Results are constructed where they go: assigned, GCC keeps what a call gives in memory, in parts, and reads it from
 * there as a whole, which waits for the parts to be written.
 */
template <class F> void one_by_one(const operation &op, const char *who, F f)
{
    using T = decltype(f(size_t{0}));
    over(op, who, layout::structs, [=](size_t from, size_t n) {
        T *out = reinterpret_cast<T *>(answer.at);
        for (size_t i = from; i < from + n; i++)
            ::new (out + i) T(f(i));
    });
}

/*
 * A dependent chain over `near` elements: step(result, i) gives the result of element i once it has the one before it.
 * f(i) gives what is checked.
 */
template <class T, class F, class Step> void chain(const operation &op, const char *who, T first, F f, Step step)
{
    auto check = [=](size_t count) {
        T *out = reinterpret_cast<T *>(answer.at);
        for (size_t i = 0; i < count; i++)
            out[i] = f(i);
    };
    add(op, who, layout::chain, near, check, [=](benchmark::State &state) {
        for (auto _ : state) {
            T value = first, other = first;
            for (size_t i = 0; i < near; i += 2) {
                ::new (&other) T(step(value, i));
                ::new (&value) T(step(other, i + 1));
            }
            benchmark::DoNotOptimize(value);
        }
    });
}

/* 0, which no compiler can know. */
inline volatile uint32_t nothing = 0;

/*
 * In the chain each call reads the element whose number is i plus a part of the result before it that is always 0,
 * made of `nothing`: to take the result to an address and to read there is part of each step.
 */
template <class F> void single(const operation &op, const char *who, F f)
{
    using T = decltype(f(size_t{0}));
    one_by_one(op, who, f);
    uint32_t none = nothing;
    chain(op, who, f(0), f, [=](const T &before, size_t i) {
        uint32_t bits;
        std::memcpy(&bits, &before, sizeof bits);
        return f(i + (bits & none));
    });
}

/* x[i] is the first argument of element i: in the chain it is the result of the element before. */
template <class T, class U, class F> void chained(const operation &op, const char *who, const array<U> &first, F f)
{
    const T *x = as<T>(first);
    auto at = [=](size_t i) { return f(x[i], i); };
    one_by_one(op, who, at);
    chain(op, who, x[0], at, f);
}

/* How times follow one another: anywhere, or 1/60 s on or back, as a player asks. */
enum class asking { random, onward, backward };
constexpr asking askings[] = {asking::random, asking::onward, asking::backward};
std::string named(const char *what, asking o); /* "what, random" */
/* The i-th time in 0 .. end. */
float time_at(asking o, size_t i, float end);

/* A file's list: static const bench::suite orient([] { ... }); */
struct suite {
    explicit suite(void (*list)());
};

/* Gives doubles of a struct of floats. */
template <class T> std::vector<double> wide(const T &value)
{
    const float *f = reinterpret_cast<const float *>(&value);
    return std::vector<double>(f, f + sizeof(T) / sizeof(float));
}

/*
 * The library's function of the same element as the reference: for rows whose single function the accuracy tests
 * measure.
 */
template <class F> reference by(F f)
{
    return [=](size_t i, double *out) {
        auto value = f(i);
        const float *from = reinterpret_cast<const float *>(&value);
        for (size_t k = 0; k < sizeof value / sizeof(float); k++)
            out[k] = static_cast<double>(from[k]);
    };
}

} // namespace bench

#endif
