/* SPDX-License-Identifier: MIT */
/* The keys that are kept within a tolerance. */
#include "figure.h"

#include <stdio.h>

#include <nakawari/reduce.h>
#include <nakawari/scalar.h>

enum { KEYS = 61 };

/* Still, then a fast movement, then a slow one. */
static float motion(size_t k)
{
    const float time = (float)k / 15.0f;
    if (time < 0.8f)
        return 0.0f;
    if (time < 2.4f)
        return 0.5f - 0.5f * nkw_cos(3.9269908f * (time - 0.8f)) * (2.4f - time) / 1.6f;
    return 0.5f + 0.2f * (time - 2.4f) + 0.25f * nkw_sin(1.9f * (time - 2.4f));
}

static void corridor(svg *s, const svg_plot *plot, const nkw_track *track, float tolerance)
{
    svg_paint paint = svg_stroke(FIGURE_PALE, 1.0f, 0.9f);
    svg_point line[KEYS];
    for (int side = -1; side <= 1; side += 2) {
        for (size_t k = 0; k < KEYS; k++)
            line[k] = svg_plot_at(plot, track->times[k], track->values[k] + (float)side * tolerance);
        svg_polyline(s, line, KEYS, &paint);
    }
}

static void panel(svg *s, float y, const nkw_track *track, float tolerance, svg_colour colour)
{
    float times[KEYS], values[KEYS], difference;
    char text[96];
    const nkw_track_span span = {times, values, NULL, KEYS};
    svg_plot plot = {{70.0f, y, 900.0f, 200.0f}, {-0.1f, 4.1f, 0.5f, "time, s"}, {-0.2f, 1.2f, 0.5f, "value"}};
    svg_paint paint = svg_stroke(colour, 2.4f, 1.0f);
    svg_point line[KEYS];
    nkw_track out;
    nkw_track_reduce(track, tolerance, span, &out, &difference);
    svg_plot_frame(s, &plot);
    corridor(s, &plot, track, tolerance);
    for (size_t k = 0; k < KEYS; k++)
        figure_dot(s, svg_plot_at(&plot, track->times[k], track->values[k]), FIGURE_PALE);
    for (size_t k = 0; k < out.count; k++)
        line[k] = svg_plot_at(&plot, out.times[k], out.values[k]);
    svg_polyline(s, line, out.count, &paint);
    for (size_t k = 0; k < out.count; k++)
        figure_key(s, line[k]);
    sprintf(text, "tolerance %.2f: %d of %d keys, error %.4f", (double)tolerance, (int)out.count, KEYS,
            (double)difference);
    figure_bold(s, 84.0f, y + 22.0f, 14.0f, colour, 's', text);
}

int figure_reduce_keys(const char *path)
{
    svg s;
    float times[KEYS], values[KEYS];
    if (!figure_open(&s, path, 1000.0f, 620.0f, "Key reduction keeps the keys that a tolerance needs",
                     "Grey: the keys of the source, and the tolerance around them. White: the keys that are kept, "
                     "unchanged."))
        return 0;
    for (size_t k = 0; k < KEYS; k++) {
        times[k] = (float)k / 15.0f;
        values[k] = motion(k);
    }
    const nkw_track track = {times, values, KEYS, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR, NULL};
    panel(&s, 110.0f, &track, 0.01f, FIGURE_CATMULL_ROM);
    panel(&s, 370.0f, &track, 0.05f, FIGURE_HERMITE);
    return svg_close(&s);
}
