/* SPDX-License-Identifier: MIT */
/* Segments with handles in time, each handle within its segment. The loop has up to eight Newton steps in float. */
#include "bench.h"
#include "newton.h"

using namespace bench;

static array<nkw_handle_segment> segment;

static newton::cubic times(size_t i)
{
    const nkw_handle_segment &s = segment[i];
    return {{s.time0, s.time0 + s.out.time, s.time1 + s.in.time, s.time1}};
}

static newton::cubic values(size_t i)
{
    const nkw_handle_segment &s = segment[i];
    return {{s.value0, s.value0 + s.out.value, s.value1 + s.in.value, s.value1}};
}

/* All segments last 1 s. */
static void draw()
{
    for (size_t i = 0; i < pool; i++) {
        nkw_vec3 a = point[0][i], b = point[1][i];
        segment.set(i, {0, a.x, {0.33f + 0.3f * a.y, 0.5f * a.z}, {-0.33f + 0.3f * b.y, 0.5f * b.z}, 1, b.x});
    }
}

static const suite all([] {
    draw();
    reference truth = [](size_t i, double *out) {
        *out = newton::at(values(i), newton::bisected(times(i), static_cast<double>(t[i])));
    };
    operation op = {"handle", "value at a time", 1, 40, 90, truth};
    single(op, "nkw", [](size_t i) { return nkw_handle_sample(&segment[i], t[i]).value; });
    single(op, "loop", [](size_t i) { return newton::at(values(i), newton::solved(times(i), t[i], t[i])); });
});
