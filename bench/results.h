/* SPDX-License-Identifier: MIT */
/* A file of results, read back: a line for each way to do an operation. */
#ifndef NAKAWARI_BENCH_RESULTS_H
#define NAKAWARI_BENCH_RESULTS_H

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace bench
{

/* A way to do an operation; times are 0 where there is none. */
struct line {
    std::string build, stem, operation, who, layout;
    std::map<size_t, double> ns; /* of one element, by size */
    double chain = 0, error = 0, bytes = 0, flops = 0, limit = 0;

    bool own() const
    {
        return who.compare(0, 3, "nkw") == 0;
    }
    /* A peer beyond this error, u, is shown, but nothing is compared with it. */
    static constexpr double loose = 64;
    bool compared() const
    {
        return !own() && error <= loose;
    }
    bool does(const line &other) const
    {
        return build == other.build && stem == other.stem && operation == other.operation;
    }
    /* At the size that stands for all: 1024 elements, 67 joints, 301 keys, 1000 characters, or the largest. */
    double time() const;
};

struct results {
    std::vector<line> lines; /* those of an operation stand together */
    std::vector<line> machine;

    /* Of all builds, or of one. Gives false for a file that cannot be read. */
    bool read(const char *path, const char *build);
    /* In the order of the file. */
    std::vector<std::string> builds() const;
    /* The best peer's time over that of l; 0 without a peer. Structs are held against structs, the rest against all. */
    double versus(const line &l, bool chain) const;
    /* The sizes that some line of the operation has. */
    std::vector<size_t> sizes(const line &of) const;

    /* The fastest of the lines of an operation that `wanted` picks, or NULL. */
    template <class F> const line *fastest(const line &of, bool chain, F wanted) const
    {
        const line *best = nullptr;
        for (const line &l : lines) {
            double time = chain ? l.chain : l.time();
            if (l.does(of) && time > 0 && wanted(l) && (!best || time < (chain ? best->chain : best->time())))
                best = &l;
        }
        return best;
    }
};

/* Three digits; nothing for 0. */
std::string three(double value);

/* An operation in whose sizes the growth of its cost is seen: the page has a table of each. */
struct growth {
    const char *stem, *operation, *element, *size;
};
extern const std::vector<growth> growths;

} // namespace bench

#endif
