/* SPDX-License-Identifier: MIT */
#include "polycurve_slopes.h"

#include <nakawari/vec.h>

/* Intervals of less than 2^-FLATTEN_LEVELS are refused. */
#define FLATTEN_LEVELS 20

/* The points written so far, and the last one. */
typedef struct polyline {
    nkw_vec3 *points;
    size_t count, capacity;
    nkw_vec3 last;
} polyline;

static void add(polyline *line, nkw_vec3 p)
{
    if (line->count < line->capacity)
        line->points[line->count] = p;
    line->count++;
    line->last = p;
}

/* (a + 4 b + c)/6. */
static lane_f64_vec3 knot(nkw_vec3 a, nkw_vec3 b, nkw_vec3 c)
{
    lane_f64_vec3 outer = lane_f64_vec3_add(lane_f64_vec3_from(a), lane_f64_vec3_from(c));
    lane_f64_vec3 sum = lane_f64_vec3_add_scaled(outer, lane_f64_vec3_from(b), 4.0);
    lane_f64_vec3 r = {sum.x / 6.0, sum.y / 6.0, sum.z / 6.0};
    return r;
}

/* The start (end 0) or the end (end 1) of a segment. Neighbours in a B-spline compute theirs by the same sum. */
static lane_f64_vec3 end_of(nkw_cubic_kind kind, const nkw_vec3 *c, size_t end)
{
    static const unsigned char ends[][2] = {
#define ENDS(KIND, name, first, last) [NKW_CUBIC_##KIND] = {first, last},
        LANE_CUBICS(ENDS)
#undef ENDS
    };
    const unsigned known = (unsigned)kind < sizeof ends / sizeof ends[0] ? (unsigned)kind : NKW_CUBIC_HERMITE;
    const nkw_vec3 *at = &c[ends[known][end]];
    return kind == NKW_CUBIC_BSPLINE ? knot(at[0], at[1], at[2]) : lane_f64_vec3_from(*at);
}

/* Adds the ends of the intervals of a segment. Returns 0 if they become too small. */
static int add_segment(polyline *line, nkw_cubic_kind kind, const nkw_vec3_cubic *cubic, double tolerance)
{
    polycurve_slopes c = polycurve_slopes_of(kind, cubic);
    lane_f64_vec3 start = end_of(kind, cubic->c, 0), end = end_of(kind, cubic->c, 1);
    nkw_vec3 first = lane_vec3_from_f64(start);
    unsigned level = 0, i = 0;
    double width = 1.0;
    if (line->count == 0 || !(first.x == line->last.x && first.y == line->last.y && first.z == line->last.z))
        add(line, first);
    do {
        double low = width * (double)i, high = width * ((double)i + 1.0);
        double before = lane_f64_vec3_length(polycurve_second(&c, low)),
               after = lane_f64_vec3_length(polycurve_second(&c, high));
        if ((before > after ? before : after) * (width * width) > 8.0 * tolerance) {
            if (level++ == FLATTEN_LEVELS)
                return 0;
            i *= 2;
            width *= 0.5;
            continue;
        }
        lane_f64_vec3 p = {lane_f64_value_between(start.x, end.x, c.x, high),
                           lane_f64_value_between(start.y, end.y, c.y, high),
                           lane_f64_value_between(start.z, end.z, c.z, high)};
        add(line, lane_vec3_from_f64(p));
        for (i++; level > 0 && i % 2 == 0; i /= 2) {
            level--;
            width *= 2.0;
        }
    } while (level > 0);
    return 1;
}

static int is_finite(const nkw_vec3_cubic *cubic)
{
    return nkw_vec3_is_finite(cubic->c[0]) && nkw_vec3_is_finite(cubic->c[1]) && nkw_vec3_is_finite(cubic->c[2]) &&
           nkw_vec3_is_finite(cubic->c[3]);
}

nkw_result nkw_polycurve_flatten(const nkw_polycurve *curve, float tolerance, nkw_vec3 *points, size_t capacity,
                                 size_t *count)
{
    polyline line = {points, 0, capacity, {0.0f, 0.0f, 0.0f}};
    *count = 0;
    if (curve->count == 0)
        return NKW_EMPTY;
    if (!(tolerance > 0.0f))
        return NKW_OUT_OF_RANGE;
    for (size_t k = 0; k < curve->count; k++) {
        if (!is_finite(&curve->cubics[k]))
            return NKW_NOT_FINITE;
        if (!add_segment(&line, curve->kind, &curve->cubics[k], tolerance))
            return NKW_TOO_MANY;
    }
    *count = line.count;
    return line.count <= capacity ? NKW_OK : NKW_TOO_SMALL;
}
