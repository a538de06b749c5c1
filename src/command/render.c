/* SPDX-License-Identifier: MIT */
/* nakawari render: pictures of the model at times, as PNG. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/vec.h>

#include "progress.h"
#include "timelist.h"
#include "view.h"

static const options_text text = {
    "[OPTION...] FILE",
    "Draws the morphed and skinned meshes of FILE at times of a clip, shaded, as one PNG file: a contact sheet, row "
    "by\n"
    "row; or with --sequence as numbered files of one frame each. The camera is orthographic and frames the model "
    "over\n"
    "all times. With --turntable it turns once around the model.\n",
    "  nakawari render fox.glb --clip Walk -o walk.png\n"
    "  nakawari render fox.glb -c Run --at 0,0.25 --skeleton --size 480 -o run.png\n"
    "  nakawari render fox.glb -c Run --rate 25 --sequence run- && ffmpeg -framerate 25 -i run-%04d.png run.mp4\n",
    1, 0};

enum { SIZE_MOST = 4096, SHEET_MOST = 16384, FRAMES_MOST = 10000 };

typedef struct request {
    char *clip, *at, *output, *sequence;
    float rate, yaw, pitch;
    long frames, size, columns;
    int skeleton, turntable;
} request;

/* One clip while it is drawn: the cell of a frame, and the sheet or one frame in bytes. */
typedef struct picture {
    const request *request;
    moment *moment;
    view view;
    nkw_vec3 low, high; /* of all frames */
    raster cell;
    size_t frame_count, columns, rows;
    unsigned char *pixels;
} picture;

/* ---- times ---- */

static size_t count_frames(const moment *m, const request *r)
{
    if (r->at)
        return timelist_count(r->at);
    return r->rate > 0.0f ? moment_rate_count(m, r->rate) : (size_t)r->frames;
}

/* Without a list or a rate: frames evenly from the start of the clip, without its end, which is the start of a loop. */
static float frame_time(const moment *m, const request *r, size_t count, size_t k)
{
    float time = 0.0f, start = nkw_clip_start(m->clip), end = nkw_clip_end(m->clip);
    const char *list = r->at;
    if (!r->at)
        return r->rate > 0.0f ? moment_rate_time(m, r->rate, k) : start + (end - start) * ((float)k / (float)count);
    for (size_t i = 0; i <= k; i++)
        timelist_next(&list, &time);
    return time;
}

static void go_to(picture *p, size_t k)
{
    const float degree = 0.0174532925f;
    float turn = p->request->turntable ? 360.0f * ((float)k / (float)p->frame_count) : 0.0f;
    moment_at(p->moment, frame_time(p->moment, p->request, p->frame_count, k));
    view_turn(&p->view, (p->request->yaw + turn) * degree, p->request->pitch * degree);
}

/* ---- drawing ---- */

/* The box of all frames. */
static void frame_all(picture *p)
{
    view all;
    go_to(p, 0);
    all = p->view;
    for (size_t k = 0; k < p->frame_count; k++) {
        go_to(p, k);
        view_include(&p->view, p->moment);
        view_join(&all, &p->view);
    }
    p->low = all.low;
    p->high = all.high;
    if (p->low.x <= p->high.x)
        return;
    p->low = nkw_vec3_zero();
    p->high = p->low;
}

static void draw_frame(picture *p, size_t k, unsigned char *out, size_t stride)
{
    const nkw_vec3 paper = {0.86f, 0.88f, 0.91f};
    go_to(p, k);
    p->view.low = p->low;
    p->view.high = p->high;
    raster_clear(&p->cell, paper);
    view_draw(&p->view, p->moment, &p->cell, p->request->skeleton);
    raster_resolve(&p->cell, out, stride);
}

static int write_file(const picture *p, const char *path, size_t width, size_t height)
{
    FILE *f = output_open(path);
    if (!f)
        return 0;
    int fine = raster_write_png(f, p->pixels, width, height);
    return output_close(f, path) && fine;
}

static int draw_sequence(picture *p)
{
    size_t size = (size_t)p->request->size, room = strlen(p->request->sequence) + 32;
    char *path = malloc(room);
    int fine = path != NULL;
    progress line = progress_begin("drawing frame", p->frame_count, NULL);
    for (size_t k = 0; fine && k < p->frame_count; k++) {
        progress_at(&line, k);
        draw_frame(p, k, p->pixels, 3 * size);
        snprintf(path, room, "%s%04zu.png", p->request->sequence, k);
        fine = write_file(p, path, size, size);
    }
    progress_end(&line);
    free(path);
    return fine;
}

static int draw_sheet(picture *p)
{
    size_t size = (size_t)p->request->size, stride = 3 * size * p->columns;
    memset(p->pixels, 255, stride * size * p->rows);
    progress line = progress_begin("drawing frame", p->frame_count, NULL);
    for (size_t k = 0; k < p->frame_count; k++) {
        progress_at(&line, k);
        draw_frame(p, k, p->pixels + k / p->columns * size * stride + k % p->columns * 3 * size, stride);
    }
    progress_end(&line);
    return write_file(p, p->request->output, size * p->columns, size * p->rows);
}

/* ---- the command ---- */

static int complain(const nkw_document *d, const char *what)
{
    output_text(stderr, d->file);
    fprintf(stderr, ": %s\n", what);
    return 0;
}

/* The rows and columns of the picture, within the limits. */
static int plan(picture *p, const request *r)
{
    p->frame_count = count_frames(p->moment, r);
    if (p->frame_count > FRAMES_MOST)
        return complain(p->moment->document, "more than 10000 frames: use a lower rate");
    size_t columns = r->sequence ? 1 : (size_t)r->columns;
    p->columns = p->frame_count < columns ? p->frame_count : columns;
    p->rows = r->sequence ? 1 : (p->frame_count + p->columns - 1) / p->columns;
    if (p->columns * (size_t)r->size > SHEET_MOST || p->rows * (size_t)r->size > SHEET_MOST)
        return complain(p->moment->document,
                        "the sheet exceeds 16384 pixels: use fewer frames, a --size or --sequence");
    p->pixels = malloc(3 * p->columns * p->rows * (size_t)r->size * (size_t)r->size);
    return (p->pixels && raster_open(&p->cell, (size_t)r->size, (size_t)r->size)) ||
           complain(p->moment->document, "no memory");
}

static int render_document(const nkw_document *d, void *data)
{
    const request *r = data;
    input_clips clips;
    moment m;
    picture p;
    memset(&p, 0, sizeof p);
    if (!input_select(d, r->clip, &clips))
        return 0;
    if (clips.count != 1)
        return complain(d, "choose one clip");
    p.request = r;
    p.moment = &m;
    int fine = moment_open(&m, d, clips.first) && view_open(&p.view, d) && plan(&p, r);
    if (fine) {
        frame_all(&p);
        fine = r->sequence ? draw_sequence(&p) : draw_sheet(&p);
    }
    raster_free(&p.cell);
    free(p.pixels);
    view_free(&p.view);
    moment_close(&m);
    return fine;
}

static int check_request(const options *o, void *data)
{
    const request *r = data;
    if (r->at && !timelist_count(r->at))
        return options_misuse(o, r->at, "not a list of times: 0,0.5,1");
    if (r->rate != 0.0f && !(r->rate > 0.0f && r->rate <= 1e6f))
        return options_misuse(o, "--rate", "not in 0..1000000");
    if (r->at && r->rate != 0.0f)
        return options_misuse(o, "--at, --rate", "only one of them");
    if (r->frames < 1 || r->frames > FRAMES_MOST)
        return options_misuse(o, "--frames", "not in 1..10000");
    if (r->size < 16 || r->size > SIZE_MOST)
        return options_misuse(o, "--size", "not in 16..4096");
    if (r->columns < 1 || r->columns > 1024)
        return options_misuse(o, "--columns", "not in 1..1024");
    if (!isfinite(r->yaw) || !isfinite(r->pitch))
        return options_misuse(o, "--yaw, --pitch", "not a number");
    if (r->sequence && r->output)
        return options_misuse(o, "--sequence", "not with --output");
    return COMMAND_FINE;
}

int command_render(int argc, const char **argv)
{
    request r = {NULL, NULL, NULL, NULL, 0.0f, 35.0f, 12.0f, 8, 240, 4, 0, 0};
    const struct poptOption known[] = {
        {"clip", 'c', POPT_ARG_STRING, &r.clip, 0, "number or name of the clip, or rest (default: 0)", "N"},
        {"at", 't', POPT_ARG_STRING, &r.at, 0, "times in seconds", "T,T,..."},
        {"rate", 'r', POPT_ARG_FLOAT, &r.rate, 0, "frames per second from the start of the clip to its end", "R"},
        {"frames", 'n', POPT_ARG_LONG, &r.frames, 0, "frames evenly from the start of the clip (default: 8)", "N"},
        {"size", 's', POPT_ARG_LONG, &r.size, 0, "width and height of a frame in pixels (default: 240)", "S"},
        {"columns", 0, POPT_ARG_LONG, &r.columns, 0, "frames in a row of the sheet (default: 4)", "N"},
        {"skeleton", 'k', POPT_ARG_NONE, &r.skeleton, 0, "draw the joints of the skins over the model", NULL},
        {"yaw", 0, POPT_ARG_FLOAT, &r.yaw, 0, "degrees that the camera is to the model's left (default: 35)", "D"},
        {"pitch", 0, POPT_ARG_FLOAT, &r.pitch, 0, "degrees that it looks down (default: 12)", "D"},
        {"turntable", 0, POPT_ARG_NONE, &r.turntable, 0, "turn once around the model", NULL},
        {"output", 'o', POPT_ARG_STRING, &r.output, 0, "write to FILE, not to the standard output", "FILE"},
        {"sequence", 0, POPT_ARG_STRING, &r.sequence, 0, "write each frame to PREFIX0000.png, PREFIX0001.png ...",
         "PREFIX"},
        OPTIONS_END};
    static const command_steps steps = {check_request, render_document};
    const int code = command_run(&text, known, argc, argv, &steps, &r);
    free(r.clip);
    free(r.at);
    free(r.output);
    free(r.sequence);
    return code;
}
