/* SPDX-License-Identifier: MIT */
#include "write.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#include <nakawari/keyframe.h>

#include "picture.h"
#include "summary.h"

const report_method report_positions[] = {
    {"linear", NKW_POSITION_LINEAR},
    {"hermite", NKW_POSITION_HERMITE},
    {"bezier", NKW_POSITION_BEZIER},
    {"bspline", NKW_POSITION_BSPLINE},
    {"catmull-rom", NKW_POSITION_CATMULL_ROM},
    {"step", NKW_POSITION_STEP},
    {NULL, 0},
};
const report_method report_orientations[] = {
    {"none", NKW_ORIENTATION_STEP},   {"euler", NKW_ORIENTATION_EULER},
    {"quat", NKW_ORIENTATION_SLERP},  {"euler-unwrapped", NKW_ORIENTATION_EULER_UNWRAPPED},
    {"nlerp", NKW_ORIENTATION_NLERP}, {NULL, 0},
};
enum { NONE, EULER, QUAT }; /* the exercise's, in report_orientations */
enum { LINEAR, HERMITE, BEZIER, BSPLINE }; /* in report_positions */
enum { PATH_SIZE = 4096 };

const report_method *report_find(const char *name, const report_method *list)
{
    for (; list->name; list++)
        if (strcmp(list->name, name) == 0)
            return list;
    return NULL;
}

/* ---- files ---- */

static const char *path_in(const report_options *o, const char *name, const char *extension, char path[PATH_SIZE])
{
    sprintf(path, "%s/%s%s", o->folder, name, extension);
    return path;
}

/* Reports a file that could not be written. */
static int report(const report_options *o, int ok, const char *path)
{
    if (!ok)
        fprintf(stderr, "%s: cannot write %s: %s\n", o->program, path, strerror(errno));
    return ok;
}

/* ---- the table ---- */

/* Row k of the table: from half a second before the first key. Rounded once from the decimal step. */
static float row_time(const scene *s, const report_options *o, long k)
{
    return (float)((double)s->keys[0].time - 0.5 + (double)k * o->step);
}

long report_rows(const scene *s, const report_options *o)
{
    double span = (double)scene_end(s) - (double)s->keys[0].time + 1.0;
    return (long)(span / o->step + 1e-9) + 1;
}

/* Nine digits tell every float apart. Adding 0 turns -0 into 0. */
static void write_row(FILE *f, const scene *s, float time, const report_method *position,
                      const report_method *orientation)
{
    nkw_keyframe_trace trace;
    nkw_position_method p = (nkw_position_method)position->method;
    nkw_orientation_method o = (nkw_orientation_method)orientation->method;
    nkw_mat4 m = scene_sample(s, time, p, o);
    nkw_keyframe_options options = {p, o, NKW_KEYFRAME_RULE_LIBRARY};
    (void)nkw_keyframes_trace(s->keys, s->count, time, &options, &trace);
    fprintf(f, "%s,%u,%s,%s,%.9g,%u,%.9g", s->name, (unsigned)s->count, position->name, orientation->name, (double)time,
            (unsigned)trace.segment.index, (double)trace.segment.t);
    for (int i = 0; i < 16; i++)
        fprintf(f, ",%.9g", (double)(m.m[i] + 0.0f));
    fputc('\n', f);
}

static void write_rows(FILE *f, const scene *s, const report_options *o, int position, int orientation)
{
    long count = report_rows(s, o);
    for (long k = 0; k < count; k++)
        write_row(f, s, row_time(s, o, k), &report_positions[position], &report_orientations[orientation]);
}

static int write_table(const scene *s, const report_options *o, const char *path)
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

typedef struct picture {
    int (*write)(const scene *s, const char *path);
    const char *name, *caption, *alt; /* alt: what is seen, for those who do not */
    const char *exhibit; /* the address of the same on the page of exhibits */
} picture;

static const picture pictures[] = {
    {picture_trajectory_top, "trajectory-top",
     "The four position curves from above. Hermite passes through every key and leaves it along the object's nose; "
     "B&eacute;zier passes through every third key; B-spline passes near the keys.",
     "A map of seven keys and four curves: linear and Hermite pass through all keys, Bezier through keys 0, 3 and 6, "
     "the B-spline through none.",
     "exercise?position=hermite"},
    {picture_trajectory_perspective, "trajectory-perspective",
     "The same curves in space through the exercise's camera, each with the surface down to its shadow on the floor.",
     "Four panels, one for each curve, with a dart at each key.", "exercise?position=bspline"},
    {picture_frames, "frames", "All frames, every 0.2 s: position by Hermite, orientation by quaternions and slerp.",
     "Thirty-one darts along the Hermite curve.", "exercise?position=hermite&amp;orientation=quat&amp;view=frames"},
    {picture_frames_compare, "frames-compare",
     "Three keys enlarged, by Euler angles and by slerp, and the angle between the two over time.",
     "Two panels with eleven darts each at the same positions, with other orientations between the keys. Below, two "
     "arcs: 20.6 degrees at 0.5 s, 13.8 degrees at 1.5 s.",
     "exercise?position=hermite&amp;view=frames"},
    {picture_orientation_compare, "orientation-compare",
     "Where the two orientation methods differ most: the object side by side, the path of its nose, and how fast "
     "it turns.",
     "Two rows of darts; two paths on a sphere, that of slerp the shorter one; two curves of angular speed, that of "
     "slerp constant between keys.",
     "rotations"},
};
enum { PICTURE_COUNT = sizeof pictures / sizeof *pictures };

/* What nakawari-joints draws. */
static const picture joints_pictures[] = {
    {NULL, "joints-sheet", "From key frames to skinned vertices: every half second of the motion, by blended matrices.",
     "Eight capsules that bend and twist.", "joints"},
    {NULL, "joints-compare",
     "Where a joint is twisted most: blended matrices lose the volume, dual quaternions keep it.",
     "Two twisted capsules; that of blended matrices is thin as a thread in the middle.", "twist"},
};
enum { JOINTS_PICTURE_COUNT = sizeof joints_pictures / sizeof *joints_pictures };

/* A link to an exhibit, if there is a page of exhibits. */
static void write_try(FILE *f, const report_options *o, const char *exhibit)
{
    if (o->page)
        fprintf(f, " <a href=\"%s#%s\">Try it by hand.</a>", o->page, exhibit);
}

static void write_figure(FILE *f, const scene *s, const report_options *o, const picture *p)
{
    fprintf(f, "<figure><img src=\"%s.svg\" alt=\"%s\"><figcaption>%s", p->name, s->own ? p->caption : p->alt,
            p->caption);
    write_try(f, o, p->exhibit);
    fputs("</figcaption></figure>\n", f);
}

/* What nakawari render draws of the committed character. */
static void write_character(FILE *f, const report_options *o)
{
    static const char *const clips[] = {"walk", "wave", "hop"};
    fputs("<h1>A character from a file</h1>\n<figure class=\"row\">", f);
    for (int i = 0; i < 3; i++)
        fprintf(f, "<img src=\"%s.apng\" alt=\"A mannequin: %s\">", clips[i], clips[i]);
    fputs("<figcaption>The three clips of docs/examples/character.glb, by <code>nakawari render character.glb --clip "
          "walk "
          "--rate 25 -o walk.apng</code>.",
          f);
    write_try(f, o, "file");
    fputs("</figcaption></figure>\n"
          "<figure><img src=\"sheet.png\" alt=\"Eight frames of the walk with the skeleton\"><figcaption>The walk in "
          "eight frames with its skeleton: linear blend skinning of one mesh by 17 joints.</figcaption></figure>\n",
          f);
}

/* The link to the page of exhibits, before everything else. */
static void write_door(FILE *f, const report_options *o)
{
    if (o->page)
        fprintf(f,
                "<p class=\"door\"><a href=\"%s\">Open the page of exhibits</a> There the keys are moved and turned by "
                "hand, and every method follows at once. The captions below link to the exhibits. "
                "<code>cmake --workflow --preset page</code> builds the page first.</p>\n",
                o->page);
}

static int write_index(const scene *s, const report_options *o, const char *path)
{
    FILE *f = fopen(path, "wb");
    if (!f)
        return 0;
    fputs("<!doctype html>\n<html lang=\"en\"><meta charset=\"utf-8\"><title>nakawari: the exercise</title>\n"
          "<style>body{font:16px/1.5 sans-serif;max-width:1040px;margin:2em auto;padding:0 1em;color:#222}"
          "figure{margin:0 0 2.5em}img{width:100%;border:1px solid #ddd}.row img{width:32.6%}"
          "pre{font-size:12px;overflow:auto}.door a{display:inline-block;margin:0 .6em .4em 0;padding:.5em 1em;"
          "border-radius:6px;background:#1f5fd0;color:#fff}</style>\n"
          "<h1>Key-frame animation, drawn by nakawari</h1>\n",
          f);
    fprintf(f, "<p>%u keys%s. The numbers: <a href=\"%s.csv\">%s.csv</a>.</p>\n", (unsigned)s->count,
            s->own ? "" : ", one per second", s->name, s->name);
    write_door(f, o);
    fputs("<details><summary>A table to compare with</summary><pre>\n", f);
    summary_print(f, s);
    fputs("</pre></details>\n", f);
    for (int i = 0; i < PICTURE_COUNT; i++)
        write_figure(f, s, o, &pictures[i]);
    if (o->joints)
        fputs("<h1>A capsule on four joints</h1>\n", f);
    for (int i = 0; o->joints && i < JOINTS_PICTURE_COUNT; i++)
        write_figure(f, s, o, &joints_pictures[i]);
    if (o->character)
        write_character(f, o);
    fputs("</html>\n", f);
    int failed = ferror(f);
    return fclose(f) == 0 && !failed;
}

int report_write(const scene *s, const report_options *o)
{
    char path[PATH_SIZE];
    path_in(o, s->name, ".csv", path);
    if (!report(o, write_table(s, o, path), path))
        return 0;
    for (int i = 0; i < PICTURE_COUNT; i++) {
        path_in(o, pictures[i].name, ".svg", path);
        if (!report(o, pictures[i].write(s, path), path))
            return 0;
    }
    path_in(o, "index", ".html", path);
    if (!report(o, write_index(s, o, path), path))
        return 0;
    summary_print(stdout, s);
    printf("\nwrote the whole table %s/%s.csv\nand %d pictures, all on one page: %s\n", o->folder, s->name,
           (int)PICTURE_COUNT, path);
    return 1;
}
