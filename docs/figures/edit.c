/* SPDX-License-Identifier: MIT */
/* Edits of a track. */
#include "figure.h"

#include <nakawari/edit.h>

enum { KEYS = 5, ROOM = 2 * KEYS };

/* In-tangent, value, out-tangent. */
static const float key_times[KEYS] = {0.0f, 0.5f, 1.2f, 2.0f, 3.0f};
static const float key_values[3 * KEYS] = {0.0f, 0.2f, 1.5f, 0.5f, 0.9f, 0.5f,  -1.2f, 0.4f,
                                           0.0f, 0.6f, 0.7f, 0.6f, 0.0f, 0.55f, 0.0f};

typedef struct made {
    float times[ROOM], values[3 * ROOM];
    nkw_track track;
} made;

/* One plot: the source in grey, the edited track in colour. */
static void panel(svg *s, int index, const char *name, const nkw_track *source, const nkw_track *track)
{
    svg_plot plot = {{60.0f + 320.0f * (float)(index % 3), 140.0f + 240.0f * (float)(index / 3), 270.0f, 150.0f},
                     {-0.2f, 6.2f, 1.0f, "time, s"},
                     {-0.2f, 1.3f, 0.5f, ""}};
    const nkw_track *lines[2] = {source, track};
    svg_plot_frame(s, &plot);
    figure_bold(s, plot.box.x, plot.box.y - 8.0f, 13.0f, FIGURE_INK, 's', name);
    for (int i = 0; i < 2; i++) {
        const nkw_track *t = lines[i];
        svg_point line[FIGURE_STEPS + 1];
        svg_paint paint = i ? svg_stroke(FIGURE_HERMITE, 2.8f, 1.0f) : svg_stroke(0xc4c6d0, 2.0f, 1.0f);
        float first = t->times[0], last = t->times[t->count - 1];
        for (int k = 0; k <= FIGURE_STEPS; k++) {
            float time = first + (last - first) * (float)k / (float)FIGURE_STEPS, value;
            nkw_track_sample(t, time, NULL, &value);
            line[k] = svg_plot_at(&plot, time, value);
        }
        svg_polyline(s, line, FIGURE_STEPS + 1, &paint);
    }
    for (size_t k = 0; k < track->count; k++)
        figure_key(s, svg_plot_at(&plot, track->times[k], track->values[3 * k + 1]));
}

int figure_edit_track(const char *path)
{
    svg s;
    const nkw_track source = {key_times, key_values, KEYS, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_CUBICSPLINE, NULL};
    made edited[6];
    if (!figure_open(&s, path, 1000.0f, 600.0f, "Edits of a track",
                     "Each edit writes new keys. Their tangents change with them, so the curve keeps its shape."))
        return 0;
    svg_paint grey = svg_stroke(0xc4c6d0, 2.0f, 1.0f), colour = svg_stroke(FIGURE_HERMITE, 2.8f, 1.0f);
    figure_legend(&s, 60.0f, 94.0f, &grey, "the source");
    figure_legend(&s, 200.0f, 94.0f, &colour, "the result, with its keys");
    for (int i = 0; i < 6; i++) {
        nkw_track_span span = {edited[i].times, edited[i].values, NULL, ROOM};
        nkw_track *out = &edited[i].track;
        static const char *const names[6] = {"the track",       "trim: from 0.8 to 2.4 s",
                                             "retime: scale 2", "retime: scale -1, offset 3",
                                             "join: to itself", "close: share 1/2"};
        *out = source;
        if (i == 1)
            nkw_track_trim(&source, 0.8f, 2.4f, span, out);
        else if (i == 2 || i == 3)
            nkw_track_retime(&source, i == 2 ? 2.0f : -1.0f, i == 2 ? 0.0f : 3.0f, span, out);
        else if (i == 4)
            nkw_track_join(&source, &source, span, out);
        else if (i == 5)
            nkw_track_close(&source, 0.5f, span, out);
        panel(&s, i, names[i], &source, out);
    }
    return svg_close(&s);
}
