/* SPDX-License-Identifier: MIT */
#include "write.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#include <nakawari/keyframe.h>
#include <nakawari/mat.h>

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
const report_method report_rules[] = {
    {"exercise", NKW_KEYFRAME_RULE_EXERCISE}, {"library", NKW_KEYFRAME_RULE_LIBRARY}, {NULL, 0}};
enum { POSITIONS = 4, ORIENTATIONS = 3, RULES = 2 }; /* the exercise's methods are the first of their lists */
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

/* ---- the tables ---- */

/* Row k of a table: from half a second before the first key. Rounded once from the decimal step. */
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
    nkw_keyframe_options options = {p, o, s->rule};
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

static scene ruled(const scene *s, int rule)
{
    scene copy = *s;
    copy.rule = (nkw_keyframe_rule)report_rules[rule].method;
    return copy;
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
    for (int position = 0; position < POSITIONS; position++)
        for (int orientation = 0; orientation < ORIENTATIONS; orientation++)
            write_rows(f, s, o, position, orientation);
    int failed = ferror(f);
    return fclose(f) == 0 && !failed;
}

/* NAME_exercise.csv and NAME_library.csv. */
static int write_tables(const scene *s, const report_options *o)
{
    char path[PATH_SIZE], extension[32];
    for (int rule = 0; rule < RULES; rule++) {
        const scene by = ruled(s, rule);
        sprintf(extension, "_%s.csv", report_rules[rule].name);
        path_in(o, s->name, extension, path);
        if (!report(o, write_table(&by, o, path), path))
            return 0;
    }
    return 1;
}

/* The rows of one pair of methods in which the tables differ by more than rounding. */
static long differing(const scene *s, const report_options *o, int position, int orientation)
{
    const scene a = ruled(s, 0), b = ruled(s, 1);
    long count = 0;
    for (long k = 0; k < report_rows(s, o); k++) {
        const nkw_position_method p = (nkw_position_method)report_positions[position].method;
        const nkw_orientation_method q = (nkw_orientation_method)report_orientations[orientation].method;
        nkw_mat4 m = scene_sample(&a, row_time(s, o, k), p, q), n = scene_sample(&b, row_time(s, o, k), p, q);
        count += !nkw_mat4_equal_within(&m, &n, 1e-5f * s->unit);
    }
    return count;
}

static void print_difference(FILE *f, const scene *s, const report_options *o, const char *reason)
{
    long rows = 0, count = 0;
    for (int position = 0; position < POSITIONS; position++)
        for (int orientation = 0; orientation < ORIENTATIONS; orientation++) {
            rows += report_rows(s, o);
            count += differing(s, o, position, orientation);
        }
    fprintf(f,
            "%ld of their %ld rows differ: by the exercise's rule a segment contains both its ends and Bezier curves "
            "go on\noutside the keys; the library's segments are half open, and it clamps. Why: %s\n",
            count, rows, reason);
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

static void write_links(FILE *f, const scene *s, const report_options *o)
{
    fprintf(
        f,
        " The numbers by the rule of the exercise's program: <a href=\"%s_exercise.csv\">%s_exercise.csv</a>; by the "
        "library's: <a href=\"%s_library.csv\">%s_library.csv</a>. ",
        s->name, s->name, s->name, s->name);
    print_difference(f, s, o, "");
    if (o->docs)
        fprintf(f, "<a href=\"%s/coursework.md#where-this-library-differs\">", o->docs);
    fprintf(f, "docs/coursework.md, <i>Where this library differs</i>%s.</p>\n", o->docs ? "</a>" : "");
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
    fprintf(f, "<p>%u keys%s.", (unsigned)s->count, s->own ? "" : ", one per second");
    write_links(f, s, o);
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
    if (!write_tables(s, o))
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
    printf("\nwrote the whole tables %s/%s_exercise.csv and %s_library.csv\n", o->folder, s->name, s->name);
    print_difference(stdout, s, o, "docs/coursework.md#where-this-library-differs");
    printf("and %d pictures, all on one page: %s\n", (int)PICTURE_COUNT, path);
    return 1;
}
