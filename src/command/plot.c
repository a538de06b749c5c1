/* SPDX-License-Identifier: MIT */
/* nakawari plot: the curves of joints over time, as SVG. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "curve.h"
#include "moment.h"
#include "svg.h"

static const options_text text = {"[OPTION...] FILE",
                                  "Draws the channels of a clip as SVG: on the left the values over time with their "
                                  "keys, on the right the velocity,\n"
                                  "of rotations the angular velocity in radians per second, in the frame of the "
                                  "parent. x is red, y green, z blue, w\n"
                                  "grey; of morph weights the first four are drawn.\n",
                                  "  nakawari plot fox.glb --clip Walk --joint b_Head_05 -o head.svg\n"
                                  "  nakawari plot fox.glb -c 1 -j b_Head_05,b_Neck_04 --what rotation > neck.svg\n",
                                  1, 0};

typedef struct request {
    char *clip, *joints, *what, *output;
    int target; /* -1: all */
    long most;
} request;

static const char *const targets[] = {"translation", "rotation", "scale", "weights"};
static const char *const modes[] = {"LINEAR", "STEP", "CUBICSPLINE"};
static const svg_colour colours[CURVE_COMPONENTS] = {0xd62728, 0x2ca02c, 0x1f5fd0, 0x77777f};

enum { ROW = 210, TOP = 70, PANEL_WIDTH = 470, PANEL_HEIGHT = 130 };

/* ---- axes ---- */

/* A step of 1, 2 or 5 times a power of ten, four to ten of them in a range. */
static float tick_of(float range)
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

static svg_axis axis_of(float low, float high, const char *name)
{
    if (!(high > low)) {
        float around = fabsf(low) > 0.0f ? 0.5f * fabsf(low) : 1.0f;
        high = low + around;
        low -= around;
    }
    float margin = 0.06f * (high - low);
    svg_axis axis = {low - margin, high + margin, tick_of(high - low), name};
    return axis;
}

static void put_label(svg *s, svg_point at, char anchor, const char *words, float size, svg_colour colour)
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
    svg_text(s, at, &font, plain);
}

/* The lines of an axis: at the multiples of its tick. */
static void put_ticks(svg *s, const svg_plot *plot, const svg_axis *axis, int vertical)
{
    svg_paint grid = svg_stroke(0xe6e6ea, 1.0f, 1.0f);
    double first = ceil((double)axis->from / (double)axis->tick), last = floor((double)axis->to / (double)axis->tick);
    for (double k = first; k <= last && k < first + 40.0; k += 1.0) {
        char number[32];
        float value = (float)(k * (double)axis->tick);
        snprintf(number, sizeof number, "%.6g", k == 0.0 ? 0.0 : (double)value);
        svg_point p = vertical ? svg_plot_at(plot, plot->x.from, value) : svg_plot_at(plot, value, plot->y.from);
        svg_point q = vertical ? svg_plot_at(plot, plot->x.to, value) : svg_plot_at(plot, value, plot->y.to);
        svg_line(s, p, q, &grid);
        put_label(s, vertical ? svg_at(p.x - 6.0f, p.y + 4.0f) : svg_at(p.x, p.y + 15.0f), vertical ? 'e' : 'm', number,
                  11.0f, 0x55555c);
    }
}

static void put_frame(svg *s, const svg_plot *plot)
{
    svg_paint border = svg_stroke(0x9a9aa2, 1.0f, 1.0f);
    put_ticks(s, plot, &plot->x, 0);
    put_ticks(s, plot, &plot->y, 1);
    svg_rect(s, plot->box, 0.0f, &border);
    put_label(s, svg_at(plot->box.x, plot->box.y - 7.0f), 's', plot->y.name, 12.0f, 0x2b2b30);
}

/* ---- curves ---- */

static void bounds_of(const curve *c, int velocity, float *low, float *high)
{
    size_t components = velocity ? c->velocity_count : c->component_count;
    *low = INFINITY, *high = -INFINITY;
    for (size_t r = 0; r < c->run_count; r++)
        for (size_t i = 0; i + (size_t)velocity < c->runs[r].count; i++)
            for (size_t k = 0; k < components; k++) {
                float v = (velocity ? c->velocities : c->values)[c->runs[r].first + i][k];
                *low = v < *low ? v : *low;
                *high = v > *high ? v : *high;
            }
    if (!(*low <= *high))
        *low = *high = 0.0f;
}

static void put_curve(svg *s, const svg_plot *plot, const curve *c, int velocity, size_t component)
{
    svg_paint paint = svg_stroke(colours[component], 1.6f, 1.0f);
    svg_point *points = calloc(c->point_count + 1, sizeof *points);
    for (size_t r = 0; points && r < c->run_count; r++) {
        size_t count = c->runs[r].count - (size_t)velocity, first = c->runs[r].first;
        for (size_t i = 0; i < count; i++)
            points[i] = svg_plot_at(plot, (velocity ? c->middles : c->times)[first + i],
                                    (velocity ? c->velocities : c->values)[first + i][component]);
        svg_polyline(s, points, count, &paint);
    }
    free(points);
}

static void put_keys(svg *s, const svg_plot *plot, const nkw_track *track, size_t components)
{
    size_t width = track->width, cubic = track->interpolation == NKW_INTERPOLATION_CUBICSPLINE;
    for (size_t k = 0; k < track->count && track->count <= 512; k++)
        for (size_t i = 0; i < components; i++) {
            svg_paint dot = {0xffffff, colours[i], 1.3f, 1.0f, NULL};
            svg_circle(s, svg_plot_at(plot, track->times[k], track->values[(cubic ? 3 * k + 1 : k) * width + i]), 3.0f,
                       &dot);
        }
}

static void put_panel(svg *s, svg_box box, const nkw_clip_track *track, const curve *c, svg_axis time, int velocity)
{
    float low, high;
    const char *name = !velocity                            ? "value"
                       : track->target == NKW_CLIP_ROTATION ? "angular velocity, rad/s"
                                                            : "velocity, 1/s";
    bounds_of(c, velocity, &low, &high);
    svg_plot plot = {box, time, axis_of(low, high, name)};
    put_frame(s, &plot);
    for (size_t i = velocity ? c->velocity_count : c->component_count; i-- > 0;)
        put_curve(s, &plot, c, velocity, i);
    if (!velocity)
        put_keys(s, &plot, &track->track, c->component_count);
}

static int put_row(svg *s, const nkw_document *d, size_t animation, size_t index, svg_axis time, float y)
{
    const nkw_document_animation *a = &d->animations[animation];
    const nkw_clip_track *track = &a->tracks[index];
    svg_box left = {60.0f, y + 44.0f, PANEL_WIDTH, PANEL_HEIGHT}, right = left;
    char title[256];
    curve c;
    right.x += PANEL_WIDTH + 70.0f;
    snprintf(title, sizeof title, "%.160s %s: %s, %zu keys", d->nodes[a->channels[index].joint].name,
             targets[track->target], modes[track->track.interpolation], track->track.count);
    int fine = curve_sample(&c, track, time.from, time.to);
    put_label(s, svg_at(24.0f, y + 16.0f), 's', title, 14.0f, 0x1d1d22);
    if (fine) {
        put_panel(s, left, track, &c, time, 0);
        put_panel(s, right, track, &c, time, 1);
    }
    curve_free(&c);
    return fine;
}

/* ---- the page ---- */

/* Whether a list of names, with commas, contains a name. */
static int listed(const char *list, const char *name)
{
    size_t length = strlen(name);
    for (const char *at = strstr(list, name); at; at = strstr(at + 1, name))
        if ((at == list || at[-1] == ',') && (at[length] == ',' || at[length] == 0))
            return 1;
    return 0;
}

static int selected(const nkw_document *d, size_t animation, size_t index, const request *r)
{
    const nkw_document_animation *a = &d->animations[animation];
    const char *name = d->nodes[a->channels[index].joint].name;
    return (r->target < 0 || (int)a->tracks[index].target == r->target) &&
           (!r->joints || (name[0] && listed(r->joints, name)));
}

static void put_legend(svg *s)
{
    static const char *const names[CURVE_COMPONENTS] = {"x", "y", "z", "w"};
    for (int i = 0; i < CURVE_COMPONENTS; i++) {
        svg_point at = {930.0f + 36.0f * (float)i, 30.0f};
        svg_paint paint = svg_stroke(colours[i], 2.4f, 1.0f);
        svg_line(s, at, svg_at(at.x + 14.0f, at.y), &paint);
        put_label(s, svg_at(at.x + 18.0f, at.y + 4.0f), 's', names[i], 12.0f, 0x2b2b30);
    }
}

static int put_page(FILE *f, const nkw_document *d, size_t animation, const request *r, float start, float end)
{
    svg s;
    char title[300];
    const nkw_document_animation *a = &d->animations[animation];
    size_t rows = 0, shown = 0;
    for (size_t i = 0; i < a->track_count; i++)
        rows += (size_t)selected(d, animation, i, r);
    size_t most = rows < (size_t)r->most ? rows : (size_t)r->most;
    svg_axis time = {start, end > start ? end : start + 1.0f, tick_of(end > start ? end - start : 1.0f), "s"};
    snprintf(title, sizeof title, "%.200s, clip %zu", a->name, animation);
    svg_start(&s, f, 1090.0f, (float)TOP + (float)ROW * (float)most, title,
              "Values and velocities of channels over time");
    put_label(&s, svg_at(24.0f, 34.0f), 's', title, 20.0f, 0x1d1d22);
    put_legend(&s);
    if (rows > most) {
        snprintf(title, sizeof title, "%zu of %zu channels; --joint and --most choose others", most, rows);
        put_label(&s, svg_at(24.0f, 54.0f), 's', title, 12.0f, 0x55555c);
    }
    int fine = 1;
    for (size_t i = 0; fine && i < a->track_count && shown < most; i++)
        if (selected(d, animation, i, r))
            fine = put_row(&s, d, animation, i, time, (float)TOP + (float)ROW * (float)shown++);
    svg_finish(&s);
    if (!fine)
        fprintf(stderr, "%s: no memory\n", d->file);
    return fine;
}

static int complain(const nkw_document *d, const char *what)
{
    output_text(stderr, d->file);
    fprintf(stderr, ": %s\n", what);
    return 0;
}

static int plot_document(const nkw_document *d, void *data)
{
    const request *r = data;
    input_clips clips;
    moment m;
    if (!input_select(d, r->clip, &clips))
        return 0;
    if (clips.first == INPUT_REST || clips.count != 1)
        return complain(d, "the rest pose and all clips have no plot: choose a clip");
    size_t any = 0;
    for (size_t i = 0; i < d->animations[clips.first].track_count; i++)
        any += (size_t)selected(d, clips.first, i, r);
    if (!any)
        return complain(d, "no channel of the clip is of these joints and this kind");
    FILE *f = NULL;
    int fine = moment_open(&m, d, clips.first) && (f = output_open(r->output)) != NULL &&
               put_page(f, d, clips.first, r, nkw_clip_start(m.clip), nkw_clip_end(m.clip));
    moment_close(&m);
    return f && output_close(f, r->output) && fine;
}

static int check_request(const options *o, void *data)
{
    request *r = data;
    r->target = r->what ? options_word(r->what, targets, 4) : -1;
    if (r->what && r->target < 0)
        return options_misuse(o, r->what, "not translation, rotation, scale or weights");
    return r->most < 1 || r->most > 1000 ? options_misuse(o, "--most", "not in 1..1000") : COMMAND_FINE;
}

int command_plot(int argc, const char **argv)
{
    request r = {NULL, NULL, NULL, NULL, -1, 16};
    const struct poptOption known[] = {
        {"clip", 'c', POPT_ARG_STRING, &r.clip, 0, "number or name of the clip (default: 0)", "N"},
        {"joint", 'j', POPT_ARG_STRING, &r.joints, 0, "names of joints (default: all)", "NAME,..."},
        {"what", 'w', POPT_ARG_STRING, &r.what, 0, "translation, rotation, scale or weights (default: all)", "WHAT"},
        {"most", 'm', POPT_ARG_LONG, &r.most, 0, "number of channels on the page (default: 16)", "N"},
        {"output", 'o', POPT_ARG_STRING, &r.output, 0, "write to FILE, not to the standard output", "FILE"},
        OPTIONS_END};
    static const command_steps steps = {check_request, plot_document};
    const int code = command_run(&text, known, argc, argv, &steps, &r);
    free(r.clip);
    free(r.joints);
    free(r.what);
    free(r.output);
    return code;
}
