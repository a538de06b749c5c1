/* SPDX-License-Identifier: MIT */
#include "chart.h"

#include <math.h>
#include <stdio.h>

const svg_colour chart_colours[CHART_COLOURS] = {0xd62728, 0x2ca02c, 0x1f5fd0, 0x77777f,
                                                 0xd55e00, 0x7b3fa0, 0x00897b, 0x8c564b};

float chart_tick(float range)
{
    double step = 1.0, quarter = 0.25 * (double)range;
    if (!isfinite(range))
        return range;
    while (step > quarter && step > 1e-60)
        step /= 10.0;
    while (10.0 * step <= quarter)
        step *= 10.0;
    double ratio = (double)range / step;
    return (float)(step * (ratio >= 20.0 ? 5.0 : ratio >= 8.0 ? 2.0 : 1.0));
}

svg_axis chart_axis(float low, float high, const char *name)
{
    if (!(high > low)) {
        float around = fabsf(low) > 0.0f ? 0.5f * fabsf(low) : 1.0f;
        high = low + around;
        low -= around;
    }
    float margin = 0.06f * (high - low);
    svg_axis axis = {low - margin, high + margin, chart_tick(high - low), name};
    return axis;
}

void chart_label(page *p, svg_point at, char anchor, const char *words, float size, svg_colour colour)
{
    char plain[256];
    svg_font font = {size, colour, anchor, size > 12.0f, SVG_NONE};
    size_t n = 0;
    for (; words[n] && n + 1 < sizeof plain; n++)
        plain[n] = words[n];
    while (n && words[n] && ((unsigned char)words[n] & 0xc0) == 0x80)
        n--; /* not within a character of UTF-8 */
    plain[n] = 0;
    for (size_t i = 0; i < n; i++)
        if ((unsigned char)plain[i] < 32)
            plain[i] = '?';
    page_text(p, at, &font, plain);
}

/* The lines of an axis: at the multiples of its tick. */
static void put_ticks(page *p, const svg_plot *plot, const svg_axis *axis, int vertical)
{
    svg_paint grid = svg_stroke(0xe6e6ea, 1.0f, 1.0f);
    double tick = (double)axis->tick, from_to[2] = {(double)axis->from / tick, (double)axis->to / tick};
    double first = ceil(fmin(from_to[0], from_to[1])), last = floor(fmax(from_to[0], from_to[1]));
    for (double k = first; k <= last && k < first + 40.0; k += 1.0) {
        char number[32];
        float value = (float)(k * (double)axis->tick);
        snprintf(number, sizeof number, "%.6g", k == 0.0 ? 0.0 : (double)value);
        svg_point from = vertical ? svg_plot_at(plot, plot->x.from, value) : svg_plot_at(plot, value, plot->y.from);
        svg_point to = vertical ? svg_plot_at(plot, plot->x.to, value) : svg_plot_at(plot, value, plot->y.to);
        page_line(p, from, to, &grid);
        chart_label(p, vertical ? svg_at(from.x - 6.0f, from.y + 4.0f) : svg_at(from.x, from.y + 15.0f),
                    vertical ? 'e' : 'm', number, 11.0f, 0x55555c);
    }
}

void chart_frame(page *p, const svg_plot *plot)
{
    svg_paint border = svg_stroke(0x9a9aa2, 1.0f, 1.0f);
    put_ticks(p, plot, &plot->x, 0);
    put_ticks(p, plot, &plot->y, 1);
    page_rect(p, plot->box, &border);
    chart_label(p, svg_at(plot->box.x, plot->box.y - 7.0f), 's', plot->y.name, 12.0f, 0x2b2b30);
}

void chart_key(page *p, svg_point at, const svg_paint *paint, const char *words)
{
    page_line(p, at, svg_at(at.x + 18.0f, at.y), paint);
    chart_label(p, svg_at(at.x + 24.0f, at.y + 4.0f), 's', words, 12.0f, 0x2b2b30);
}
