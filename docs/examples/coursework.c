/* SPDX-License-Identifier: MIT */
/**
 * @file
 * nakawari-coursework: the university exercise on key-frame animation, finished: tables of the object's matrix
 * by every method, pictures of its way, and the whole calculation of any one time. See docs/coursework.md.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/keyframe.h>

#include "options.h"
#include "exercise/write.h"
#include "exercise/trace.h"

/* Exit codes. */
enum { DONE, NOT_WRITTEN, MISUSED };

static const char usage[] =
    "usage: nakawari-coursework [options]\n"
    "Prints the numbers of the exercise's key-frame animation; writes tables and pictures of it.\n"
    "\n"
    "  --scene 1|2        which of the exercise's scenes (default 1)\n"
    "  --keys N           only its first N keys, 2 or more (default all)\n"
    "  --step SECONDS     distance of the tables' rows (default 0.1)\n"
    "  --rule R           exercise (default) or library: of what is printed and drawn; there is a table of each\n"
    "  --out DIR          an existing folder for the files (default .)\n"
    "  --joints           index.html shows the pictures of nakawari-joints too, from the same folder\n"
    "  --character        and those of a character, by nakawari render: walk.apng, wave.apng, hop.apng, sheet.png\n"
    "  --page LINK        and a link to the page of exhibits\n"
    "  --docs LINK        and one to the folder docs, for the reasons\n"
    "  --trace TIME       write no file; print the calculation at TIME step by step, with\n"
    "  --position P       linear, hermite (default), bezier, bspline, catmull-rom or step, and\n"
    "  --orientation O    none, euler, quat (default), euler-unwrapped or nlerp\n"
    "  -h, --help         print this\n";

typedef struct options {
    long scene, keys;
    double time;
    report_options report;
    int trace, help;
    const report_method *position, *orientation, *rule;
} options;

/* ---- the command line ---- */

static const char program[] = "nakawari-coursework";

static int find_method(const char *text, const report_method *list, const report_method **out)
{
    if (text)
        *out = report_find(text, list);
    return *out || options_complain(program, "no such method", text);
}

static int read_options(int argc, char **argv, options *o)
{
    const char *position = NULL, *orientation = NULL, *rule = NULL;
    const option known[] = {{"--scene", OPTION_WHOLE, &o->scene, 1, 2, NULL},
                            {"--keys", OPTION_WHOLE, &o->keys, 2, SCENE_KEYS_MAX, NULL},
                            {"--step", OPTION_NUMBER, &o->report.step, 1e-4, 1e3, NULL},
                            {"--out", OPTION_TEXT, &o->report.folder, 0, 0, NULL},
                            {"--joints", OPTION_FLAG, &o->report.joints, 0, 0, NULL},
                            {"--character", OPTION_FLAG, &o->report.character, 0, 0, NULL},
                            {"--page", OPTION_TEXT, &o->report.page, 0, 0, NULL},
                            {"--docs", OPTION_TEXT, &o->report.docs, 0, 0, NULL},
                            {"--trace", OPTION_NUMBER, &o->time, -1e6, 1e6, &o->trace},
                            {"--position", OPTION_TEXT, &position, 0, 0, NULL},
                            {"--orientation", OPTION_TEXT, &orientation, 0, 0, NULL},
                            {"--rule", OPTION_TEXT, &rule, 0, 0, NULL}};
    if (!options_read(program, known, sizeof known / sizeof *known, argc, argv, &o->help) ||
        !find_method(position, report_positions, &o->position) ||
        !find_method(orientation, report_orientations, &o->orientation) || !find_method(rule, report_rules, &o->rule))
        return 0;
    return strlen(o->report.folder) <= 4000 || options_complain(program, "path too long", o->report.folder);
}

static int run(const options *o)
{
    scene s;
    if (!scene_build((int)o->scene, (size_t)o->keys, &s)) {
        options_complain(program, "the scene has fewer keys", "--keys");
        return MISUSED;
    }
    s.rule = (nkw_keyframe_rule)o->rule->method;
    if (report_rows(&s, &o->report) > REPORT_ROWS_MAX) {
        options_complain(program, "too many rows", "--step");
        return MISUSED;
    }
    if (!o->trace)
        return report_write(&s, &o->report) ? DONE : NOT_WRITTEN;
    trace_print(stdout, &s, (float)o->time, (nkw_position_method)o->position->method,
                (nkw_orientation_method)o->orientation->method);
    return DONE;
}

int main(int argc, char **argv)
{
    options o = {1, 0, 0.0, {program, ".", 0.1, NULL, NULL, 0, 0}, 0, 0, report_find("hermite", report_positions),
                 report_find("quat", report_orientations), report_rules};
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
