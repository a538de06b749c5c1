/* SPDX-License-Identifier: MIT */
/* nakawari render: pictures of the model at times, as PNG, animated PNG or SVG. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/vec.h>

#include "image.h"
#include "progress.h"
#include "raster.h"
#include "sketch.h"
#include "timelist.h"
#include "view.h"

static const options_text text = {
    "[OPTION...] FILE",
    "Draws the morphed and skinned meshes of FILE at times of a clip, shaded, with base colour textures in PNG,\n"
    "as a contact sheet, row by row; with --sequence as numbered files of one frame each; or as an animated PNG.\n"
    "The camera is orthographic and frames the model over all times. With --turntable it turns once around the\n"
    "model, with --follow it moves with it.\n",
    "  nakawari render fox.glb --clip Walk -o walk.png\n"
    "  nakawari render fox.glb -c Run -o run.apng\n"
    "  nakawari render fox.glb -c rest --turntable --format apng > fox.png\n"
    "  nakawari render fox.glb -c Run --at 0,0.25 --skeleton --size 480 -o run.svg\n"
    "  nakawari render fox.glb -c Run --rate 25 --sequence run- && ffmpeg -framerate 25 -i run-%04d.png run.mp4\n",
    1, 0};

enum { SIZE_MOST = 4096, SHEET_MOST = 16384, FRAMES_MOST = 10000 };

typedef enum form { FORM_PNG, FORM_APNG, FORM_SVG, FORMS } form;
static const char *const forms[FORMS] = {"png", "apng", "svg"};

typedef struct request {
    char *clip, *at, *output, *sequence, *format;
    float rate, yaw, pitch;
    long frames, size, columns;
    int skeleton, turntable, follow, plain;
    form form;
} request;

/* One clip while it is drawn: the cell of a frame, and the sheet or one frame in bytes. */
typedef struct picture {
    const request *request;
    moment *moment;
    view view;
    view_box box; /* of all frames */
    raster cell;
    size_t frame_count, columns, rows;
    unsigned char *pixels;
    progress line;
} picture;

/* ---- times ---- */

/* An animation is a loop: the end of the clip is its start. */
static size_t count_frames(const moment *m, const request *r)
{
    if (r->at)
        return timelist_count(r->at);
    if (!(r->rate > 0.0f))
        return (size_t)r->frames;
    size_t count = moment_rate_count(m, r->rate);
    return r->form == FORM_APNG && count > 1 ? count - 1 : count;
}

/* Without a list or a rate: frames evenly from the start of the clip, without its end, which is the start of a loop. */
static float frame_time(const moment *m, const request *r, size_t count, size_t k)
{
    float time = 0.0f, start = nkw_clip_describe(m->clip).start, end = nkw_clip_describe(m->clip).end;
    const char *list = r->at;
    if (!r->at)
        return r->rate > 0.0f ? moment_rate_time(m, r->rate, k) : start + (end - start) * ((float)k / (float)count);
    for (size_t i = 0; i <= k; i++)
        timelist_next(&list, &time);
    return time;
}

/* The seconds that a frame of an animation is shown: until the next one; all of a clip without a length take 4 s. */
static double frame_seconds(const picture *p, size_t k)
{
    const moment *m = p->moment;
    const float start = nkw_clip_describe(m->clip).start, end = nkw_clip_describe(m->clip).end;
    const size_t count = p->frame_count;
    if (!(end > start))
        return 4.0 / (double)count;
    if (p->request->at && k + 1 == count)
        return (double)(end - start) / (double)count;
    float next = k + 1 < count ? frame_time(m, p->request, count, k + 1) : end;
    return (double)next - (double)frame_time(m, p->request, count, k);
}

static void go_to(picture *p, size_t k)
{
    const float degree = 0.0174532925f;
    float turn = p->request->turntable ? 360.0f * ((float)k / (float)p->frame_count) : 0.0f;
    moment_at(p->moment, frame_time(p->moment, p->request, p->frame_count, k));
    nkw_vec3 origin = p->request->follow ? view_middle(&p->view, p->moment) : NKW_VEC3_ZERO;
    view_turn(&p->view, origin, (p->request->yaw + turn) * degree, p->request->pitch * degree);
}

/* ---- drawing ---- */

/* The box of all frames. */
static void frame_all(picture *p)
{
    go_to(p, 0);
    p->box = p->view.box;
    for (size_t k = 0; k < p->frame_count; k++) {
        go_to(p, k);
        view_include(&p->view, p->moment);
        view_join(&p->box, &p->view.box);
    }
    if (!p->request->plain)
        view_include_shadow(&p->view, &p->box);
    if (p->box.low.x <= p->box.high.x)
        return;
    p->box.low = p->box.high = p->box.least = p->box.most = NKW_VEC3_ZERO;
}

static void draw_on(picture *p, size_t k, canvas *c)
{
    progress_at(&p->line, k);
    go_to(p, k);
    p->view.box = p->box;
    if (!p->request->plain)
        view_draw_floor(&p->view, p->moment, c);
    view_draw(&p->view, p->moment, c, p->request->skeleton);
}

static void draw_frame(picture *p, size_t k, unsigned char *out, size_t stride)
{
    raster_clear(&p->cell, view_paper());
    draw_on(p, k, &p->cell.canvas);
    raster_resolve(&p->cell, out, stride);
}

/* ---- the files ---- */

static int write_png(picture *p, FILE *f, size_t first, size_t count)
{
    size_t size = (size_t)p->request->size, columns = count < p->columns ? count : p->columns;
    size_t rows = (count + columns - 1) / columns, stride = 3 * size * columns;
    memset(p->pixels, 255, stride * size * rows);
    for (size_t k = 0; k < count; k++)
        draw_frame(p, first + k, p->pixels + k / columns * size * stride + k % columns * 3 * size, stride);
    return image_write_png(f, p->pixels, size * columns, size * rows);
}

static int write_svg(picture *p, FILE *f, size_t first, size_t count)
{
    svg page;
    size_t columns = count < p->columns ? count : p->columns, rows = (count + columns - 1) / columns;
    float size = (float)p->request->size;
    int fine = 1;
    svg_start(&page, f, size * (float)columns, size * (float)rows, input_name(p->moment->document->file),
              "The model at times of a clip");
    for (size_t k = 0; k < count && fine; k++) {
        sketch s;
        svg_box box = {size * (float)(k % columns), size * (float)(k / columns), size, size};
        sketch_begin(&s, &page, box, view_paper());
        draw_on(p, first + k, &s.canvas);
        fine = sketch_end(&s) || output_complain(p->moment->document, NULL, "no memory");
    }
    svg_finish(&page);
    return fine;
}

static int write_apng(picture *p, FILE *f, size_t first, size_t count)
{
    image_film film;
    size_t size = (size_t)p->request->size;
    int fine = image_film_open(&film, f, size, size, count) || output_complain(p->moment->document, NULL, "no memory");
    for (size_t k = 0; k < count && fine; k++) {
        draw_frame(p, first + k, p->pixels, 3 * size);
        fine = image_film_add(&film, p->pixels, frame_seconds(p, first + k));
    }
    image_film_close(&film);
    return fine;
}

static int write_file(picture *p, const char *path, size_t first, size_t count)
{
    static int (*const writers[FORMS])(picture *, FILE *, size_t, size_t) = {write_png, write_apng, write_svg};
    FILE *f = output_open(path);
    if (!f)
        return 0;
    int fine = writers[p->request->form](p, f, first, count);
    return output_close(f, path) && fine;
}

static int write_sequence(picture *p)
{
    size_t room = strlen(p->request->sequence) + 32;
    char *path = malloc(room);
    int fine = path != NULL;
    for (size_t k = 0; fine && k < p->frame_count; k++) {
        snprintf(path, room, "%s%04zu.%s", p->request->sequence, k, forms[p->request->form]);
        fine = write_file(p, path, k, 1);
    }
    free(path);
    return fine;
}

/* ---- the command ---- */

/* The rows and columns of the picture, within the limits. */
static int plan(picture *p, const request *r)
{
    const int single = r->sequence || r->form == FORM_APNG;
    p->frame_count = count_frames(p->moment, r);
    if (p->frame_count > FRAMES_MOST)
        return output_complain(p->moment->document, NULL, "more than 10000 frames: use a lower rate");
    size_t columns = single ? 1 : (size_t)r->columns;
    p->columns = p->frame_count < columns ? p->frame_count : columns;
    p->rows = single ? 1 : (p->frame_count + p->columns - 1) / p->columns;
    if (p->columns * (size_t)r->size > SHEET_MOST || p->rows * (size_t)r->size > SHEET_MOST)
        return output_complain(p->moment->document, NULL,
                        "the sheet exceeds 16384 pixels: use fewer frames, a --size or --sequence");
    if (r->form == FORM_SVG)
        return 1;
    p->pixels = malloc(3 * p->columns * p->rows * (size_t)r->size * (size_t)r->size);
    return (p->pixels && raster_open(&p->cell, (size_t)r->size, (size_t)r->size)) ||
           output_complain(p->moment->document, NULL, "no memory");
}

/* 8 frames of a sheet; of an animation 25 a second, 48 if the clip has no length. */
static void set_frames(request *r, const moment *m)
{
    const int film = r->form == FORM_APNG && !r->at && r->rate == 0.0f && !r->frames;
    if (film && nkw_clip_describe(m->clip).end > nkw_clip_describe(m->clip).start)
        r->rate = 25.0f;
    else if (!r->frames)
        r->frames = film ? 48 : 8;
}

static int render_document(const nkw_document *d, void *data)
{
    request *r = data;
    input_clips clips;
    moment m;
    picture p;
    memset(&p, 0, sizeof p);
    if (!input_select(d, r->clip, &clips))
        return 0;
    if (clips.count != 1)
        return output_complain(d, NULL, "choose one clip");
    p.request = r;
    p.moment = &m;
    int fine = moment_open(&m, d, clips.first) && view_open(&p.view, d);
    if (fine)
        set_frames(r, &m);
    fine = fine && plan(&p, r);
    if (fine) {
        frame_all(&p);
        p.line = progress_begin("drawing frame", p.frame_count, NULL);
        fine = r->sequence ? write_sequence(&p) : write_file(&p, r->output, 0, p.frame_count);
        progress_end(&p.line);
    }
    raster_free(&p.cell);
    free(p.pixels);
    view_free(&p.view);
    moment_close(&m);
    return fine;
}

/* The format by its name, or by the end of the output's name. */
static int find_form(request *r)
{
    int found = r->format ? words_find(r->format, forms, FORMS) : output_ending(r->output, forms, FORMS);
    r->form = found < 0 ? FORM_PNG : (form)found;
    return found >= 0 || !r->format;
}

static int check_request(const options *o, void *data)
{
    request *r = data;
    if (!find_form(r))
        return options_misuse(o, r->format, "not png, apng or svg");
    if (!r->format && output_is_foreign(r->output))
        return options_misuse(o, r->output, "only .png, .apng and .svg are written");
    if (r->at && !timelist_count(r->at))
        return options_misuse(o, r->at, "not a list of times: 0,0.5,1");
    if (r->rate != 0.0f && !(r->rate > 0.0f && r->rate <= 1e6f))
        return options_misuse(o, "--rate", "not in 0..1000000");
    if (r->at && r->rate != 0.0f)
        return options_misuse(o, "--at, --rate", "only one of them");
    if (r->frames < 0 || r->frames > FRAMES_MOST)
        return options_misuse(o, "--frames", "not in 0..10000");
    if (r->size < 16 || r->size > SIZE_MOST)
        return options_misuse(o, "--size", "not in 16..4096");
    if (r->columns < 1 || r->columns > 1024)
        return options_misuse(o, "--columns", "not in 1..1024");
    if (!isfinite(r->yaw) || !isfinite(r->pitch))
        return options_misuse(o, "--yaw, --pitch", "not a number");
    if (r->sequence && (r->output || r->form == FORM_APNG))
        return options_misuse(o, "--sequence", r->output ? "not with --output" : "not as apng");
    return COMMAND_FINE;
}

int command_render(int argc, const char **argv)
{
    request r = {NULL, NULL, NULL, NULL, NULL, 0.0f, 35.0f, 12.0f, 0, 240, 4, 0, 0, 0, 0, FORM_PNG};
    const struct poptOption known[] = {
        {"clip", 'c', POPT_ARG_STRING, &r.clip, 0, "number or name of the clip, or rest (default: 0)", "N"},
        {"at", 't', POPT_ARG_STRING, &r.at, 0, "times in seconds", "T,T,..."},
        {"rate", 'r', POPT_ARG_FLOAT, &r.rate, 0, "frames per second from the start of the clip to its end", "R"},
        {"frames", 'n', POPT_ARG_LONG, &r.frames, 0,
         "frames evenly from the start of the clip (default: 8; apng: a rate of 25)", "N"},
        {"size", 's', POPT_ARG_LONG, &r.size, 0, "width and height of a frame in pixels (default: 240)", "S"},
        {"columns", 0, POPT_ARG_LONG, &r.columns, 0, "frames in a row of the sheet (default: 4)", "N"},
        {"skeleton", 'k', POPT_ARG_NONE, &r.skeleton, 0, "draw the joints of the skins over the model", NULL},
        {"yaw", 0, POPT_ARG_FLOAT, &r.yaw, 0, "degrees that the camera is to the model's left (default: 35)", "D"},
        {"pitch", 0, POPT_ARG_FLOAT, &r.pitch, 0, "degrees that it looks down (default: 12)", "D"},
        {"follow", 0, POPT_ARG_NONE, &r.follow, 0, "move the camera with the model over the floor", NULL},
        {"plain", 0, POPT_ARG_NONE, &r.plain, 0, "draw no floor and no shadow", NULL},
        {"turntable", 0, POPT_ARG_NONE, &r.turntable, 0, "turn once around the model", NULL},
        {"output", 'o', POPT_ARG_STRING, &r.output, 0, "write to FILE, not to the standard output", "FILE"},
        {"format", 'f', POPT_ARG_STRING, &r.format, 0,
         "png, apng (animated) or svg (default: by the end of --output, or png)", "FORMAT"},
        {"sequence", 0, POPT_ARG_STRING, &r.sequence, 0, "write each frame to PREFIX0000.png, PREFIX0001.png ...",
         "PREFIX"},
        INPUT_STRICT,
        OPTIONS_END};
    static const command_steps steps = {check_request, render_document};
    const int code = command_run(&text, known, argc, argv, &steps, &r);
    free(r.clip);
    free(r.at);
    free(r.output);
    free(r.sequence);
    free(r.format);
    return code;
}
