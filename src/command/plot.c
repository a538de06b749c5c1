/* SPDX-License-Identifier: MIT */
/* nakawari plot: the curves of joints over time, as SVG or PNG. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "curve.h"
#include "plot.h"
#include "watch.h"

static const options_text text = {
    "[OPTION...] FILE",
    "Draws the channels of a clip: on the left the values over time with their keys, on the right the velocity,\n"
    "of rotations the angular velocity in radians per second, in the frame of the parent. x is red, y green, z\n"
    "blue, w grey; of morph weights the first four are drawn.\n\n"
    "  --what path    the paths of joints in the space of the model, from four sides; without --joint the five\n"
    "         longest\n"
    "  --what euler   the angles of rotations about x, y and z, and those that interpolating the angles of the\n"
    "         keys results\n"
    "                 in (dashed); and the angle between the two\n",
    "  nakawari plot fox.glb --clip Walk --joint b_Head_05 -o head.svg\n"
    "  nakawari plot fox.glb -c 1 -j b_Head_05,b_Neck_04 --what rotation > neck.svg\n"
    "  nakawari plot fox.glb -c Run --what path -o paths.png\n"
    "  nakawari plot keys.csv --watch -o keys.svg\n",
    1, 0};

static const char *const targets[] = {"translation", "rotation", "scale", "weights", "path", "euler"};
static const char *const orders[] = {"xyz", "xzy", "yxz", "yzx", "zxy", "zyx"};
static const char *const modes[] = {"LINEAR", "STEP", "CUBICSPLINE"};

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

static void put_curve(page *p, const svg_plot *plot, const curve *c, int velocity, size_t component)
{
    svg_paint paint = svg_stroke(chart_colours[component], 1.6f, 1.0f);
    svg_point *points = calloc(c->point_count + 1, sizeof *points);
    page_path_begin(p);
    for (size_t r = 0; points && r < c->run_count; r++) {
        size_t count = c->runs[r].count - (size_t)velocity, first = c->runs[r].first;
        for (size_t i = 0; i < count; i++)
            points[i] = svg_plot_at(plot, (velocity ? c->middles : c->times)[first + i],
                                    (velocity ? c->velocities : c->values)[first + i][component]);
        page_path_lines(p, points, count);
    }
    page_path_end(p, &paint);
    free(points);
}

static void put_keys(page *p, const svg_plot *plot, const nkw_track *track, size_t components)
{
    size_t width = track->width, cubic = track->interpolation == NKW_INTERPOLATION_CUBICSPLINE;
    for (size_t k = 0; k < track->count && track->count <= 512; k++)
        for (size_t i = 0; i < components; i++) {
            svg_paint dot = {0xffffff, chart_colours[i], 1.3f, 1.0f, NULL};
            page_circle(p, svg_plot_at(plot, track->times[k], track->values[(cubic ? 3 * k + 1 : k) * width + i]),
                        track->count > 40 ? 1.8f : 3.0f, &dot);
        }
}

static void put_panel(page *p, svg_box box, const nkw_clip_track *track, const curve *c, svg_axis time, int velocity)
{
    float low, high;
    const char *name = !velocity                            ? "value"
                       : track->target == NKW_CLIP_ROTATION ? "angular velocity, rad/s"
                                                            : "velocity, 1/s";
    bounds_of(c, velocity, &low, &high);
    svg_plot plot = {box, time, chart_axis(low, high, name)};
    chart_frame(p, &plot);
    for (size_t i = velocity ? c->velocity_count : c->component_count; i-- > 0;)
        put_curve(p, &plot, c, velocity, i);
    if (!velocity)
        put_keys(p, &plot, &track->track, c->component_count);
}

/* The rows of channels, and of their Euler angles. */
static int put_row(page *p, const nkw_document *d, const plot_request *r, size_t animation, size_t index, svg_axis time,
                   float y)
{
    const nkw_document_animation *a = &d->animations[animation];
    const nkw_clip_track *track = &a->tracks[index];
    char title[256];
    curve c;
    snprintf(title, sizeof title, "%.160s %s: %s, %zu %s", d->nodes[a->channels[index].joint].name,
             targets[track->target], modes[track->track.interpolation], COUNT(track->track.count, "key", "keys"));
    chart_label(p, svg_at(24.0f, y + 16.0f), 's', title, 14.0f, 0x1d1d22);
    if (r->target == PLOT_EULER)
        return plot_euler(p, r, track, time, y);
    int fine = curve_sample(&c, track, time.from, time.to);
    if (fine) {
        put_panel(p, plot_panel(y, 0), track, &c, time, 0);
        put_panel(p, plot_panel(y, 1), track, &c, time, 1);
    }
    curve_free(&c);
    return fine;
}

/* ---- the page ---- */

/* The first joint of the list that no joint is; NULL if there is none. Names may contain commas: then none is sought. */
static const char *find_stranger(const plot_request *r, const nkw_document *d, size_t *length)
{
    for (size_t j = 0; j < d->skeleton.joint_count; j++)
        if (strchr(d->nodes[j].name, ',') && plot_lists(r, d->nodes[j].name))
            return NULL;
    for (const char *at = r->joints; at && *at; at += *length + (at[*length] == ',')) {
        size_t j = 0;
        *length = strcspn(at, ",");
        while (j < d->skeleton.joint_count && !input_is_joint(d, j, at, *length))
            j++;
        if (j == d->skeleton.joint_count)
            return at;
    }
    return NULL;
}

static int selected(const nkw_document *d, size_t animation, size_t index, const plot_request *r)
{
    const nkw_document_animation *a = &d->animations[animation];
    const int target = (int)a->tracks[index].target;
    return (r->target == PLOT_ALL || target == (r->target == PLOT_EULER ? (int)NKW_CLIP_ROTATION : r->target)) &&
           plot_names(r, d, (size_t)a->channels[index].joint);
}

static size_t count_rows(const nkw_document *d, size_t animation, const plot_request *r)
{
    size_t rows = 0;
    if (r->target != PLOT_PATH)
        for (size_t i = 0; i < d->animations[animation].track_count; i++)
            rows += (size_t)selected(d, animation, i, r);
    else
        for (size_t j = 0; j < d->skeleton.joint_count; j++)
            rows += (size_t)plot_names(r, d, j);
    return rows;
}

static void put_legend(page *p, const plot_request *r)
{
    static const char *const names[4] = {"x", "y", "z", "w"};
    const int euler = r->target == PLOT_EULER;
    svg_paint solid = svg_stroke(0x55555c, 1.7f, 1.0f), dashed = solid;
    for (int i = 0; i < (euler ? 3 : 4); i++) {
        svg_paint paint = svg_stroke(chart_colours[i], 2.4f, 1.0f);
        chart_key(p, svg_at((euler ? 560.0f : 910.0f) + 44.0f * (float)i, 30.0f), &paint, names[i]);
    }
    if (!euler)
        return;
    dashed.dash = "4 4";
    chart_key(p, svg_at(720.0f, 30.0f), &solid, "the channel (LINEAR: slerp)");
    chart_key(p, svg_at(930.0f, 30.0f), &dashed, "its angles, linear");
}

static int put_rows(page *p, const plot_request *r, moment *m, size_t animation, size_t most)
{
    const float start = nkw_clip_describe(m->clip).start, end = nkw_clip_describe(m->clip).end;
    const float span = end > start ? end - start : 1.0f;
    const svg_axis time = {start, start + span, chart_tick(span), "s"};
    int fine = 1;
    size_t shown = 0;
    put_legend(p, r);
    for (size_t i = 0; fine && i < m->document->animations[animation].track_count && shown < most; i++)
        if (selected(m->document, animation, i, r))
            fine = put_row(p, m->document, r, animation, i, time, (float)PLOT_TOP + (float)PLOT_ROW * (float)shown++);
    return fine;
}

static void put_heading(page *p, const plot_request *r, const char *title, size_t rows, size_t most)
{
    char more[96];
    chart_label(p, svg_at(24.0f, 34.0f), 's', title, 20.0f, 0x1d1d22);
    if (rows <= most || r->target == PLOT_PATH)
        return;
    snprintf(more, sizeof more, "%zu of %zu channels; --joint and --most choose others", most, rows);
    chart_label(p, svg_at(24.0f, 54.0f), 's', more, 12.0f, 0x55555c);
}

static int put_page(FILE *f, const plot_request *r, moment *m, size_t animation, size_t rows)
{
    page p;
    char title[300];
    const nkw_document *d = m->document;
    size_t most = rows < (size_t)r->most ? rows : (size_t)r->most;
    svg_point size = {1090.0f, (float)PLOT_TOP + (float)PLOT_ROW * (float)most};
    snprintf(title, sizeof title, "%.200s, clip %zu", d->animations[animation].name, animation);
    if (!page_start(&p, f, page_is_png(r->output), r->target == PLOT_PATH ? plot_path_size() : size, title,
                    r->target == PLOT_PATH    ? "Paths of joints in space"
                    : r->target == PLOT_EULER ? "Angles of rotations over time, and of interpolated angles"
                                              : "Values and velocities of channels over time")) {
        fprintf(stderr, "%s: too many rows for a PNG\n", r->output);
        return 0;
    }
    put_heading(&p, r, title, rows, most);
    int fine = r->target == PLOT_PATH ? plot_path(&p, r, m) : put_rows(&p, r, m, animation, most);
    if (!fine)
        fprintf(stderr, "%s: no memory\n", d->file);
    return page_finish(&p) && fine;
}

static int complain(const nkw_document *d, const char *what)
{
    output_text(stderr, d->file);
    fputs(": ", stderr);
    output_text(stderr, what);
    fputc('\n', stderr);
    return 0;
}

static int complain_of(const nkw_document *d, const char *joint, size_t length)
{
    char what[256];
    snprintf(what, sizeof what, "no joint %.*s", length < 200 ? (int)length : 200, joint);
    return complain(d, what);
}

static int plot_document(const nkw_document *d, void *data)
{
    const plot_request *r = data;
    input_clips clips;
    moment m;
    if (!input_select(d, r->clip, &clips))
        return 0;
    if (clips.first == INPUT_REST || clips.count != 1)
        return complain(d, "the rest pose and all clips have no plot: choose a clip");
    size_t length;
    const char *stranger = find_stranger(r, d, &length);
    if (stranger)
        return complain_of(d, stranger, length);
    const size_t rows = count_rows(d, clips.first, r);
    if (!rows)
        return complain(d, r->target == PLOT_PATH ? "there is no joint"
                                                  : "no channel of the clip is of these joints and this kind");
    FILE *f = NULL;
    int fine = moment_open(&m, d, clips.first) && (f = output_open(r->output)) != NULL &&
               put_page(f, r, &m, clips.first, rows);
    moment_close(&m);
    return f && output_close(f, r->output) && fine;
}

static int check_watch(const options *o, const plot_request *r)
{
    if (strcmp(o->files[0], "-") == 0)
        return options_misuse(o, "--watch", "not with the standard input");
    return r->output && strcmp(r->output, "-") != 0 ? COMMAND_FINE : options_misuse(o, "--watch", "only with --output");
}

static int check_request(const options *o, void *data)
{
    plot_request *r = data;
    int order = r->order ? words_find(r->order, orders, 6) : NKW_EULER_XYZ;
    r->target = r->what ? words_find(r->what, targets, 6) : PLOT_ALL;
    r->euler = (nkw_euler_order)order;
    if (r->what && r->target < 0)
        return options_misuse(o, r->what, "not translation, rotation, scale, weights, path or euler");
    if (order < 0)
        return options_misuse(o, r->order, "not an order: xyz, xzy, yxz, yzx, zxy or zyx");
    if (r->order && r->target != PLOT_EULER)
        return options_misuse(o, "--order", "only with --what euler");
    if (output_is_foreign(r->output))
        return options_misuse(o, r->output, "only .svg and .png are written");
#if !defined(NKW_CAIRO)
    if (page_is_png(r->output))
        return options_misuse(o, r->output, "PNG is not built: it needs cairo");
#endif
    if (r->most < 1 || r->most > 1000)
        return options_misuse(o, "--most", "not in 1..1000");
    return r->watch ? check_watch(o, r) : COMMAND_FINE;
}

static const command_steps steps = {check_request, plot_document};

/* ---- the command ---- */

typedef struct watched {
    const char *path;
    plot_request *request;
} watched;

static void plot_again(void *user)
{
    const watched *w = user;
    (void)command_work(w->path, &steps, w->request);
}

static int run(int argc, const char **argv, const struct poptOption *known, plot_request *r)
{
    options o;
    int code;
    if (!options_read(&o, &text, known, argc, argv))
        code = o.code;
    else if ((code = check_request(&o, r)) == COMMAND_FINE) {
        watched w = {o.files[0], r};
        if (r->watch)
            watch_file(w.path, plot_again, &w);
        else
            code = command_work(w.path, &steps, r);
    }
    options_close(&o);
    return code;
}

int command_plot(int argc, const char **argv)
{
    plot_request r = {NULL, NULL, NULL, NULL, NULL, PLOT_ALL, NKW_EULER_XYZ, 16, 0};
    const struct poptOption known[] = {
        {"clip", 'c', POPT_ARG_STRING, &r.clip, 0, "number or name of the clip (default: 0)", "N"},
        {"joint", 'j', POPT_ARG_STRING, &r.joints, 0, "names or numbers of joints (default: all)", "NAME,..."},
        {"what", 'w', POPT_ARG_STRING, &r.what, 0,
         "translation, rotation, scale, weights (default: all four), path or euler", "WHAT"},
        {"order", 0, POPT_ARG_STRING, &r.order, 0, "of the angles of --what euler: xyz (default, Rx Ry Rz), yxz ...",
         "ORDER"},
        {"most", 'm', POPT_ARG_LONG, &r.most, 0, "number of channels on the page (default: 16)", "N"},
        {"watch", 0, POPT_ARG_NONE, &r.watch, 0, "draw again when FILE changes, until interrupted", NULL},
        {"output", 'o', POPT_ARG_STRING, &r.output, 0, "write to FILE, .svg or .png; not to the standard output",
         "FILE"},
        INPUT_STRICT,
        OPTIONS_END};
    const int code = run(argc, argv, known, &r);
    free(r.clip);
    free(r.joints);
    free(r.what);
    free(r.order);
    free(r.output);
    return code;
}
