/* SPDX-License-Identifier: MIT */
/* nakawari plot --what euler: the angles of a rotation, and what interpolating the angles of its keys would change. */
#include "plot.h"

#include <math.h>
#include <stdlib.h>

#include <nakawari/orient.h>
#include <nakawari/quat.h>
#include <nakawari/scalar.h>
#include <nakawari/segment.h>

enum { POINTS = 481 };

#define DEGREES 57.2957795f

/* Angles in degrees at each time: of the channel, of interpolated angles, and between the two. */
typedef struct angles {
    float times[POINTS], own[POINTS][3], euler[POINTS][3], between[POINTS];
    nkw_vec3 *keys; /* unwrapped, radians */
} angles;

static const float *key_of(const nkw_track *track, size_t k)
{
    return track->values + (track->interpolation == NKW_INTERPOLATION_CUBICSPLINE ? 3 * k + 1 : k) * track->width;
}

/* The angles of the keys, each nearest to those before. */
static int find_keys(angles *a, const nkw_track *track, nkw_euler_order order)
{
    a->keys = (nkw_vec3 *)calloc(track->count + 1, sizeof *a->keys);
    for (size_t k = 0; a->keys && k < track->count; k++) {
        const float *v = key_of(track, k);
        nkw_quat q = {v[0], v[1], v[2], v[3]};
        a->keys[k] = nkw_euler_from_quat(nkw_quat_normalize(q), order);
    }
    if (a->keys)
        nkw_euler_filter(a->keys, track->count, order, a->keys);
    return a->keys != NULL;
}

static void to_degrees(float out[3], nkw_vec3 v)
{
    out[0] = v.x * DEGREES, out[1] = v.y * DEGREES, out[2] = v.z * DEGREES;
}

static void sample(angles *a, const nkw_track *track, nkw_euler_order order, size_t i, float time)
{
    float value[4];
    nkw_segment s = nkw_segment_find(track->times, track->count, time);
    size_t next = s.index + 1 < track->count ? s.index + 1 : s.index;
    nkw_vec3 linear = nkw_euler_lerp(a->keys[s.index], a->keys[next], s.t, NKW_UNWRAP_NONE);
    nkw_track_sample(track, time, NULL, value);
    nkw_quat q = {value[0], value[1], value[2], value[3]};
    q = nkw_quat_normalize(q);
    a->times[i] = time;
    to_degrees(a->euler[i], linear);
    to_degrees(a->own[i], nkw_euler_nearest(nkw_euler_from_quat(q, order), linear, order));
    a->between[i] = nkw_quat_angle(q, nkw_quat_from_euler(linear, order)) * DEGREES;
}

static void include(float *low, float *high, float value)
{
    *low = value < *low ? value : *low;
    *high = value > *high ? value : *high;
}

/* A curve, interrupted where an angle jumps by half a turn. */
static void put_curve(page *p, const svg_plot *plot, const angles *a, const float *values, size_t stride,
                      const svg_paint *paint)
{
    svg_point points[POINTS];
    size_t count = 0;
    page_path_begin(p);
    for (size_t i = 0; i < POINTS; i++) {
        if (i && fabsf(values[i * stride] - values[(i - 1) * stride]) > 170.0f) {
            page_path_lines(p, points, count);
            count = 0;
        }
        points[count++] = svg_plot_at(plot, a->times[i], values[i * stride]);
    }
    page_path_lines(p, points, count);
    page_path_end(p, paint);
}

static void put_angles(page *p, const angles *a, const nkw_track *track, svg_axis time, float y)
{
    float low = INFINITY, high = -INFINITY;
    for (size_t i = 0; i < POINTS; i++)
        for (int k = 0; k < 3; k++) {
            include(&low, &high, a->own[i][k]);
            include(&low, &high, a->euler[i][k]);
        }
    svg_plot plot = {plot_panel(y, 0), time, chart_axis(low, high, "angles, degrees")};
    chart_frame(p, &plot);
    for (size_t k = 0; k < 3; k++) {
        svg_paint own = svg_stroke(chart_colours[k], 1.7f, 1.0f), euler = own;
        euler.dash = "4 4";
        euler.width = 1.3f;
        put_curve(p, &plot, a, &a->euler[0][k], 3, &euler);
        put_curve(p, &plot, a, &a->own[0][k], 3, &own);
    }
    for (size_t k = 0; k < track->count && track->count <= 512; k++) {
        float degrees[3];
        to_degrees(degrees, a->keys[k]);
        for (size_t i = 0; i < 3; i++) {
            svg_paint dot = {0xffffff, chart_colours[i], 1.3f, 1.0f, NULL};
            page_circle(p, svg_plot_at(&plot, track->times[k], degrees[i]), track->count > 40 ? 1.8f : 3.0f, &dot);
        }
    }
}

static void put_between(page *p, const angles *a, svg_axis time, float y)
{
    float low = 0.0f, high = 0.1f, most = 0.0f, when = a->times[0];
    char name[96];
    svg_paint paint = svg_stroke(0x7b3fa0, 1.8f, 1.0f);
    for (size_t i = 0; i < POINTS; i++) {
        include(&low, &high, a->between[i]);
        when = a->between[i] > most ? a->times[i] : when;
        most = nkw_max(most, a->between[i]);
    }
    snprintf(name, sizeof name, "angle between the two, degrees: at most %.3g at %.3g s", (double)most, (double)when);
    svg_plot plot = {plot_panel(y, 1), time, chart_axis(low, high, name)};
    chart_frame(p, &plot);
    put_curve(p, &plot, a, a->between, 1, &paint);
}

int plot_euler(page *p, const plot_request *r, const nkw_clip_track *track, svg_axis time, float y)
{
    static angles a;
    if (!track->track.count)
        return 1;
    if (!find_keys(&a, &track->track, r->euler))
        return 0;
    for (size_t i = 0; i < POINTS; i++)
        sample(&a, &track->track, r->euler, i, time.from + (time.to - time.from) * ((float)i / (float)(POINTS - 1)));
    put_angles(p, &a, &track->track, time, y);
    put_between(p, &a, time, y);
    free(a.keys);
    return 1;
}
