/* SPDX-License-Identifier: MIT */
/* Cubic keys fitted to samples. */
#include "figure.h"

#include <stdio.h>

#include <nakawari/fit.h>
#include <nakawari/scalar.h>

enum { SAMPLES = 181 };

static float motion(float time)
{
    return 0.6f * nkw_sin(2.0f * time) +
           0.25f * nkw_cos(5.3f * time) * nkw_smoothstep(nkw_clamp(time - 1.0f, 0.0f, 1.0f));
}

static void draw_tangents(svg *s, const svg_plot *plot, const nkw_track *t)
{
    svg_paint paint = svg_stroke(FIGURE_INK, 1.4f, 1.0f);
    for (size_t k = 0; k < t->count; k++)
        for (int side = 0; side < 2; side++) {
            const float *key = t->values + 3 * k;
            float by = side ? 0.12f : -0.12f;
            svg_line(s, svg_plot_at(plot, t->times[k], key[1]),
                     svg_plot_at(plot, t->times[k] + by, key[1] + by * key[side ? 2 : 0]), &paint);
        }
}

int figure_fit_samples(const char *path)
{
    svg s;
    static float times[SAMPLES], values[SAMPLES], made_times[SAMPLES], made[3 * SAMPLES];
    NKW_STACK_WORK(work, NKW_FIT_WORK(SAMPLES, 1));
    const float tolerance = 0.01f;
    nkw_track track = {times, values, SAMPLES, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR, NULL}, out;
    nkw_track_span span = {made_times, made, NULL, SAMPLES};
    svg_point line[SAMPLES];
    char reading[96];
    svg_paint curve = svg_stroke(FIGURE_HERMITE, 2.6f, 1.0f), bound = svg_stroke(FIGURE_PALE, 1.2f, 1.0f);
    svg_plot value = {{70.0f, 120.0f, 900.0f, 260.0f}, {-0.15f, 6.15f, 1.0f, ""}, {-1.1f, 1.1f, 0.5f, "value"}};
    svg_plot rest = {
        {70.0f, 430.0f, 900.0f, 120.0f}, {-0.15f, 6.15f, 1.0f, "time, s"}, {-0.0125f, 0.0125f, 0.01f, "difference"}};
    bound.dash = "5 4";
    for (size_t k = 0; k < SAMPLES; k++) {
        times[k] = nkw_timeline_time((nkw_timeline){0.0f, 30.0f, 0}, k);
        values[k] = motion(times[k]);
    }
    if (nkw_track_fit(&track, tolerance, span, &out, NULL, work) != NKW_OK)
        return 0;
    sprintf(reading, "%d samples; %u cubic keys within a tolerance of %.2f, tangents by least squares (black).",
            SAMPLES, (unsigned)out.count, (double)tolerance);
    if (!figure_open(&s, path, 1000.0f, 610.0f, "Few keys for many samples", reading))
        return 0;
    svg_paint samples = svg_stroke(0xb5b8c4, 6.0f, 1.0f);
    figure_legend(&s, 560.0f, 108.0f, &samples, "the samples");
    figure_legend(&s, 710.0f, 108.0f, &curve, "the cubics and their keys");
    svg_plot_frame(&s, &value);
    svg_plot_frame(&s, &rest);
    for (size_t k = 0; k < SAMPLES; k++)
        figure_dot(&s, svg_plot_at(&value, times[k], values[k]), 0xb5b8c4);
    for (size_t k = 0; k < SAMPLES; k++) {
        float fitted;
        nkw_track_sample(&out, times[k], NULL, &fitted);
        line[k] = svg_plot_at(&value, times[k], fitted);
    }
    svg_polyline(&s, line, SAMPLES, &curve);
    draw_tangents(&s, &value, &out);
    for (size_t k = 0; k < out.count; k++)
        figure_key(&s, svg_plot_at(&value, out.times[k], out.values[3 * k + 1]));
    for (size_t k = 0; k < SAMPLES; k++) {
        float fitted;
        nkw_track_sample(&out, times[k], NULL, &fitted);
        line[k] = svg_plot_at(&rest, times[k], fitted - values[k]);
    }
    svg_polyline(&s, line, SAMPLES, &curve);
    for (int side = -1; side <= 1; side += 2)
        svg_line(&s, svg_plot_at(&rest, rest.x.from, (float)side * tolerance),
                 svg_plot_at(&rest, rest.x.to, (float)side * tolerance), &bound);
    return svg_close(&s);
}
