/* SPDX-License-Identifier: MIT */
/**
 * @file
 * nakawari-coursework: the university exercise on key-frame animation, finished: tables of the object's matrix
 * by every method, pictures of its way, and the whole calculation of any one time. See docs/coursework.md.
 */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/keyframe.h>

#include "options.h"
#include "picture.h"
#include "scene.h"
#include "summary.h"
#include "trace.h"

/* Exit codes. */
enum { DONE, NOT_WRITTEN, MISUSED };
enum { PATH_SIZE = 4096, ROWS_MAX = 1000000 };

typedef struct named {
    const char *name;
    int method;
} named;

static const named positions[] = {
    {"linear", NKW_POSITION_LINEAR},
    {"hermite", NKW_POSITION_HERMITE},
    {"bezier", NKW_POSITION_BEZIER},
    {"bspline", NKW_POSITION_BSPLINE},
    {"catmull-rom", NKW_POSITION_CATMULL_ROM},
    {"step", NKW_POSITION_STEP},
    {NULL, 0},
};
static const named orientations[] = {
    {"none", NKW_ORIENTATION_STEP},   {"euler", NKW_ORIENTATION_EULER},
    {"quat", NKW_ORIENTATION_SLERP},  {"euler-unwrapped", NKW_ORIENTATION_EULER_UNWRAPPED},
    {"nlerp", NKW_ORIENTATION_NLERP}, {NULL, 0},
};
enum { NONE, EULER, QUAT }; /* the exercise's, in `orientations` */
enum { LINEAR, HERMITE, BEZIER, BSPLINE }; /* in `positions` */

static const char usage[] =
    "usage: nakawari-coursework [options]\n"
    "Prints the numbers of the exercise's key-frame animation; writes a table and pictures of it.\n"
    "\n"
    "  --scene 1|2        which of the exercise's scenes (default 1)\n"
    "  --keys N           only its first N keys, 2 or more (default all)\n"
    "  --step SECONDS     distance of the table's rows (default 0.1)\n"
    "  --out DIR          an existing folder for the files (default .)\n"
    "  --joints           index.html shows the pictures of nakawari-joints too, from the same folder\n"
    "  --character        and those of a character, by nakawari render: walk.apng, wave.apng, hop.apng, sheet.png\n"
    "  --trace TIME       write no file; print the calculation at TIME step by step, with\n"
    "  --position P       linear, hermite (default), bezier, bspline, catmull-rom or step, and\n"
    "  --orientation O    none, euler, quat (default), euler-unwrapped or nlerp\n"
    "  -h, --help         print this\n";

typedef struct options {
    long scene, keys;
    double step, time;
    const char *out;
    int joints, character, trace, help;
    const named *position, *orientation;
} options;

/* ---- the command line ---- */

static const char program[] = "nakawari-coursework";

static int find_method(const char *text, const named *list, const named **out)
{
    for (; text && list->name; list++)
        if (strcmp(list->name, text) == 0) {
            *out = list;
            return 1;
        }
    return !text || options_complain(program, "no such method", text);
}

static int read_options(int argc, char **argv, options *o)
{
    const char *position = NULL, *orientation = NULL;
    const option known[] = {{"--scene", OPTION_WHOLE, &o->scene, 1, 2, NULL},
                            {"--keys", OPTION_WHOLE, &o->keys, 2, SCENE_KEYS_MAX, NULL},
                            {"--step", OPTION_NUMBER, &o->step, 1e-4, 1e3, NULL},
                            {"--out", OPTION_TEXT, &o->out, 0, 0, NULL},
                            {"--joints", OPTION_FLAG, &o->joints, 0, 0, NULL},
                            {"--character", OPTION_FLAG, &o->character, 0, 0, NULL},
                            {"--trace", OPTION_NUMBER, &o->time, -1e6, 1e6, &o->trace},
                            {"--position", OPTION_TEXT, &position, 0, 0, NULL},
                            {"--orientation", OPTION_TEXT, &orientation, 0, 0, NULL}};
    if (!options_read(program, known, sizeof known / sizeof *known, argc, argv, &o->help) ||
        !find_method(position, positions, &o->position) || !find_method(orientation, orientations, &o->orientation))
        return 0;
    return strlen(o->out) + 64 < PATH_SIZE || options_complain(program, "path too long", o->out);
}

/* ---- files ---- */

static const char *path_in(const options *o, const char *name, const char *extension, char path[PATH_SIZE])
{
    sprintf(path, "%s/%s%s", o->out, name, extension);
    return path;
}

/* Reports a file that could not be written. */
static int report(int ok, const char *path)
{
    if (!ok)
        fprintf(stderr, "nakawari-coursework: cannot write %s: %s\n", path, strerror(errno));
    return ok;
}

/* ---- the table ---- */

/* Row k of the table: from half a second before the first key. Rounded once from the decimal step. */
static float row_time(const scene *s, const options *o, long k)
{
    return (float)((double)s->keys[0].time - 0.5 + (double)k * o->step);
}

static long row_count(const scene *s, const options *o)
{
    double span = (double)scene_end(s) - (double)s->keys[0].time + 1.0;
    return (long)(span / o->step + 1e-9) + 1;
}

/* Nine digits tell every float apart. Adding 0 turns -0 into 0. */
static void write_row(FILE *f, const scene *s, float time, const named *position, const named *orientation)
{
    nkw_keyframe_trace trace;
    nkw_position_method p = (nkw_position_method)position->method;
    nkw_orientation_method o = (nkw_orientation_method)orientation->method;
    nkw_mat4 m = scene_sample(s, time, p, o);
    (void)nkw_keyframes_trace(s->keys, s->count, time, p, o, &trace);
    fprintf(f, "%s,%u,%s,%s,%.9g,%u,%.9g", s->name, (unsigned)s->count, position->name, orientation->name, (double)time,
            (unsigned)trace.segment.index, (double)trace.segment.t);
    for (int i = 0; i < 16; i++)
        fprintf(f, ",%.9g", (double)(m.m[i] + 0.0f));
    fputc('\n', f);
}

static void write_rows(FILE *f, const scene *s, const options *o, int position, int orientation)
{
    long count = row_count(s, o);
    for (long k = 0; k < count; k++)
        write_row(f, s, row_time(s, o, k), &positions[position], &orientations[orientation]);
}

static int write_table(const scene *s, const options *o, const char *path)
{
    FILE *f = fopen(path, "wb");
    if (!f)
        return 0;
    fputs("scene,n_keys,pos_method,ori_method,time,seg,t", f);
    for (int i = 0; i < 16; i++)
        fprintf(f, ",m%d", i);
    fputc('\n', f);
    for (int position = LINEAR; position <= BSPLINE; position++) {
        write_rows(f, s, o, position, EULER);
        write_rows(f, s, o, position, QUAT);
    }
    write_rows(f, s, o, LINEAR, NONE);
    int failed = ferror(f);
    return fclose(f) == 0 && !failed;
}

/* ---- the pictures ---- */

static int write_frames_euler(const scene *s, const char *path)
{
    return picture_frames(s, NKW_ORIENTATION_EULER, path);
}

static int write_frames_slerp(const scene *s, const char *path)
{
    return picture_frames(s, NKW_ORIENTATION_SLERP, path);
}

typedef struct picture {
    int (*write)(const scene *s, const char *path);
    const char *name, *caption, *alt; /* alt: what is seen, for those who do not */
} picture;

static const picture pictures[] = {
    {picture_trajectory_top, "trajectory-top",
     "The four position curves from above. Hermite passes through every key and leaves it along the object's nose; "
     "B&eacute;zier passes through every third key; B-spline passes near the keys.",
     "A map of seven keys and four curves. Only the B-spline does not reach them; the Bezier curve is far from key 2."},
    {picture_trajectory_perspective, "trajectory-perspective",
     "The same curves in space through the exercise's camera, each with the curtain down to its shadow on the floor.",
     "Four panels, one for each curve, with a dart at each key."},
    {write_frames_euler, "frames-euler", "All frames, every 0.2 s, orientation by Euler angles.",
     "Thirty-one darts along the Hermite curve."},
    {write_frames_slerp, "frames-slerp", "The same frames, orientation by quaternions and slerp.",
     "The same darts at the same places; they differ between keys 0 and 2."},
    {picture_orientation_compare, "orientation-compare",
     "Where the two orientation methods differ most: the object side by side, the path of its nose, and how fast "
     "it turns.",
     "Two rows of darts; two paths on a sphere, that of slerp the shorter one; two curves of angular speed, that of "
     "slerp constant between keys."},
};
enum { PICTURE_COUNT = sizeof pictures / sizeof *pictures };

/* What nakawari-joints draws. */
static const picture joints_pictures[] = {
    {NULL, "joints-sheet", "From key frames to skinned vertices: every half second of the motion, by blended matrices.",
     "Eight capsules that bend and twist."},
    {NULL, "joints-compare",
     "Where a joint is twisted most: blended matrices lose the volume, dual quaternions keep it.",
     "Two twisted capsules; that of blended matrices is thin as a thread in the middle."},
};
enum { JOINTS_PICTURE_COUNT = sizeof joints_pictures / sizeof *joints_pictures };

static void write_figure(FILE *f, const picture *p)
{
    fprintf(f, "<figure><img src=\"%s.svg\" alt=\"%s\"><figcaption>%s</figcaption></figure>\n", p->name, p->alt,
            p->caption);
}

/* What nakawari render draws of the committed character. */
static void write_character(FILE *f)
{
    static const char *const clips[] = {"walk", "wave", "hop"};
    fputs("<h1>A character from a file</h1>\n<figure class=\"row\">", f);
    for (int i = 0; i < 3; i++)
        fprintf(f, "<img src=\"%s.apng\" alt=\"A mannequin: %s\">", clips[i], clips[i]);
    fputs("<figcaption>The three clips of docs/examples/character.glb, by <code>nakawari render character.glb --clip "
          "walk "
          "--rate 25 -o walk.apng</code>.</figcaption></figure>\n"
          "<figure><img src=\"sheet.png\" alt=\"Eight frames of the walk with the skeleton\"><figcaption>The walk in "
          "eight frames with its skeleton: linear blend skinning of one mesh by 17 joints.</figcaption></figure>\n",
          f);
}

static int write_index(const scene *s, const options *o, const char *path)
{
    FILE *f = fopen(path, "wb");
    if (!f)
        return 0;
    fputs("<!doctype html>\n<html lang=\"en\"><meta charset=\"utf-8\"><title>nakawari: the exercise</title>\n"
          "<style>body{font:16px/1.5 sans-serif;max-width:1040px;margin:2em auto;padding:0 1em;color:#222}"
          "figure{margin:0 0 2.5em}img{width:100%;border:1px solid #ddd}.row img{width:32.6%}"
          "pre{font-size:12px;overflow:auto}</style>\n"
          "<h1>Key-frame animation, drawn by nakawari</h1>\n",
          f);
    fprintf(f, "<p>%u keys, one per second. The numbers: <a href=\"%s.csv\">%s.csv</a>.</p>\n", (unsigned)s->count,
            s->name, s->name);
    fputs("<details><summary>A table to compare with</summary><pre>\n", f);
    summary_print(f, s);
    fputs("</pre></details>\n", f);
    for (int i = 0; i < PICTURE_COUNT; i++)
        write_figure(f, &pictures[i]);
    if (o->joints)
        fputs("<h1>A capsule on four joints</h1>\n", f);
    for (int i = 0; o->joints && i < JOINTS_PICTURE_COUNT; i++)
        write_figure(f, &joints_pictures[i]);
    if (o->character)
        write_character(f);
    fputs("</html>\n", f);
    int failed = ferror(f);
    return fclose(f) == 0 && !failed;
}

static int write_files(const scene *s, const options *o)
{
    char path[PATH_SIZE];
    path_in(o, s->name, ".csv", path);
    if (!report(write_table(s, o, path), path))
        return 0;
    for (int i = 0; i < PICTURE_COUNT; i++) {
        path_in(o, pictures[i].name, ".svg", path);
        if (!report(pictures[i].write(s, path), path))
            return 0;
    }
    path_in(o, "index", ".html", path);
    if (!report(write_index(s, o, path), path))
        return 0;
    summary_print(stdout, s);
    printf("\nwrote the whole table %s/%s.csv\nand %d pictures, all on one page: %s\n", o->out, s->name,
           (int)PICTURE_COUNT, path);
    return 1;
}

static int run(const options *o)
{
    scene s;
    if (!scene_build((int)o->scene, (size_t)o->keys, &s)) {
        options_complain(program, "the scene has fewer keys", "--keys");
        return MISUSED;
    }
    if (row_count(&s, o) > ROWS_MAX) {
        options_complain(program, "too many rows", "--step");
        return MISUSED;
    }
    if (!o->trace)
        return write_files(&s, o) ? DONE : NOT_WRITTEN;
    trace_print(stdout, &s, (float)o->time, (nkw_position_method)o->position->method,
                (nkw_orientation_method)o->orientation->method);
    return DONE;
}

int main(int argc, char **argv)
{
    options o = {1, 0, 0.1, 0.0, ".", 0, 0, 0, 0, &positions[HERMITE], &orientations[QUAT]};
    int code = DONE;
    if (!read_options(argc, argv, &o))
        return MISUSED;
    if (o.help)
        fputs(usage, stdout);
    else
        code = run(&o);
    if (code == DONE && fflush(stdout) != 0)
        code = NOT_WRITTEN;
    return code;
}
