/* SPDX-License-Identifier: MIT */
/* From the harness to a file of results. */
#ifndef NAKAWARI_BENCH_REPORT_H
#define NAKAWARI_BENCH_REPORT_H

#include <cstddef>
#include <string>
#include <vector>

namespace bench
{

/* Which rows a program has: BENCH_ROWS. */
enum { rows_all, rows_own, rows_peers };

struct row {
    std::string stem, operation, who, layout;
    size_t n, elements; /* the size, and the elements of a call, which mostly is the same */
    size_t round; /* the elements of all calls together: what lies in a cache */
    bool told; /* timed by itself */
    double error; /* worst, u; -1 before the check */
    double bytes, flops;
    std::vector<double> ns; /* of one element, one for each repetition */

    std::string key() const
    {
        return stem + "/" + operation + "/" + who + "/" + layout + "/" + std::to_string(n);
    }
    bool own() const
    {
        return who.compare(0, 3, "nkw") == 0;
    }
};

/* A row that stays where it is. */
row &new_row();
void draw_inputs();
void list_all();

} // namespace bench

#endif
