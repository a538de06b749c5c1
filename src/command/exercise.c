/* SPDX-License-Identifier: MIT */
/* nakawari exercise: the university exercise on key-frame animation, for keys of one's own. */
#include <stdlib.h>
#include <string.h>

#include <nakawari/pose.h>

#include "command.h"
#include "exercise/write.h"
#include "exercise/trace.h"
#include "object.h"
#include "verdict.h"

static const options_text text = {
    "[OPTION...] SCENE",
    "Draws the exercise of docs/coursework.md with the keys of SCENE: tables of the object's matrix by every\n"
    "method and by both rules, the curves from above and in space, all frames, Euler angles against slerp, and one page of all.\n"
    "SCENE is a scene of keys in JSON, a table of keys in CSV or JSON, or any other file that is read: the keys\n"
    "of one joint of a clip, at most 64 of them in 64 seconds. With --trace it prints the calculation at one\n"
    "time, step by step; with --check it\n"
    "compares the numbers of FILE, and names the mistake that they show. FILE has a line for each time: the time, then\n"
    "a position (x y z), an orientation (matrix, quaternion x y z w, or yaw pitch roll), or both, under names of\n"
    "columns or in this order; or it has what the exercise's program prints. The exit code is 0 if all agree, 1 if\n"
    "rows differ, 2 for a line that cannot be read.\n",
    "  nakawari exercise docs/examples/scenes.json --clip scene1 -o out\n"
    "  nakawari exercise docs/examples/flight.csv -o out && open out/index.html\n"
    "  nakawari exercise docs/examples/scenes.json --object docs/examples/car.obj -o out\n"
    "  nakawari exercise docs/examples/flight.csv --trace 1.25 --position bezier --orientation euler\n"
    "  nakawari exercise docs/examples/scenes.json --check mine.csv --position bezier --orientation quat\n",
    1, 0};

#define TOLERANCE 0.001

typedef struct request {
    char *clip, *joint, *output, *object, *position, *orientation, *rule, *checked, *angles, *matrix;
    long keys;
    double step, time, tolerance;
    int traces, verdict; /* verdict: the exit code of --check */
    answers_unit unit;
    const report_method *position_method, *orientation_method, *sampling_rule;
} request;

/* ---- the keys ---- */

/* The joint of that name or number; without one the first that the clip moves or turns. -1 if there is none. */
static int32_t find_joint(const nkw_document *d, const nkw_document_animation *a, const char *name)
{
    for (size_t i = 0; i < a->track_count; i++) {
        const int32_t joint = a->channels[i].joint;
        const int moves = a->tracks[i].target == NKW_CLIP_TRANSLATION || a->tracks[i].target == NKW_CLIP_ROTATION;
        if (moves && (!name || input_is_joint(d, (size_t)joint, name, strlen(name))))
            return joint;
    }
    return NKW_NO_JOINT;
}

static const nkw_track *find_track(const nkw_document_animation *a, int32_t joint, nkw_clip_target target)
{
    for (size_t i = 0; i < a->track_count; i++)
        if (a->channels[i].joint == joint && a->tracks[i].target == target &&
            nkw_track_validate(&a->tracks[i].track, NULL) == NKW_OK)
            return &a->tracks[i].track;
    return NULL;
}

static int has_added(const nkw_document_animation *a, int32_t joint)
{
    size_t added = 0;
    for (size_t i = 0; i < a->track_count; i++)
        added += a->channels[i].joint == joint ? a->channels[i].added : 0;
    return added > 0;
}

/* The earliest key time of both tracks after key k of each; moves on beyond it. Returns 0 after the last. */
static int next_time(const nkw_track *const tracks[2], size_t k[2], float *time)
{
    int found = 0;
    for (int i = 0; i < 2; i++)
        if (tracks[i] && k[i] < tracks[i]->count && (!found || tracks[i]->times[k[i]] < *time)) {
            *time = tracks[i]->times[k[i]];
            found = 1;
        }
    for (int i = 0; found && i < 2; i++)
        while (tracks[i] && k[i] < tracks[i]->count && tracks[i]->times[k[i]] <= *time)
            k[i]++;
    return found;
}

/* Key frames at the key times of the translation and of the rotation. Returns how many; one more than fit for more. */
static size_t read_keys(const nkw_document *d, const nkw_document_animation *a, int32_t joint,
                        nkw_keyframe keys[SCENE_KEYS_MAX])
{
    const nkw_track *tracks[2] = {find_track(a, joint, NKW_CLIP_TRANSLATION), find_track(a, joint, NKW_CLIP_ROTATION)};
    const nkw_trs rest = nkw_pose_get(d->rest, (size_t)joint);
    size_t k[2] = {0, 0}, count = 0;
    float time = 0.0f;
    while (next_time(tracks, k, &time)) {
        nkw_keyframe key = {time, rest.translation, rest.rotation};
        if (tracks[0])
            nkw_track_sample(tracks[0], time, NULL, &key.position.x);
        if (tracks[1])
            nkw_track_sample(tracks[1], time, NULL, &key.orientation.x);
        if (count == SCENE_KEYS_MAX)
            return count + 1;
        keys[count++] = key;
    }
    return count;
}

static int read_scene(const nkw_document *d, const request *r, scene *s)
{
    nkw_keyframe keys[SCENE_KEYS_MAX];
    input_clips clips;
    if (!input_select(d, r->clip, &clips))
        return 0;
    if (clips.first == INPUT_REST || clips.count != 1)
        return output_complain(d, NULL, clips.count > 1 ? "choose one clip" : "has no clip");
    const nkw_document_animation *a = &d->animations[clips.first];
    const int32_t joint = find_joint(d, a, r->joint);
    if (joint == NKW_NO_JOINT)
        return output_complain(d, NULL, r->joint ? "the clip does not move that joint" : "the clip moves no joint");
    size_t count = read_keys(d, a, joint, keys);
    if (count > SCENE_KEYS_MAX)
        return output_complain(d, NULL, "the joint has more than 64 keys: see nakawari reduce");
    if (has_added(a, joint))
        fputs("note: keys were added where angles turn by half a turn or more: they shape the curve too\n", stderr);
    if (r->keys > 0 && (size_t)r->keys < count)
        count = (size_t)r->keys;
    return scene_from_keys(a->name, keys, count, s) ||
           output_complain(d, NULL, "the keys are not valid, fewer than 2, or longer than 64 seconds: see nakawari check");
}

/* ---- the command ---- */

static int method_of(const report_method *list, const char *name)
{
    return name ? (int)(report_find(name, list) - list) : COMPARE_UNSTATED;
}

/* Whether the numbers have been read and agree. */
static int check_numbers(const scene *s, request *r)
{
    const answers_options read = {s->name, r->unit, r->matrix && strcmp(r->matrix, "rows") == 0};
    const compare_options compare = {
        {method_of(report_positions, r->position), method_of(report_orientations, r->orientation)},
        (float)r->tolerance};
    r->verdict = verdict_print(s, r->checked, &read, &compare);
    return r->verdict == COMMAND_FINE;
}

/* Writes the tables and pictures, with the object of the request. */
static int write_files(scene *s, const report_options *o, const request *r)
{
    object_model model = {NULL, NULL, 0, 0};
    int done = !r->object || object_open(&model, r->object);
    if (done) {
        s->object = r->object ? &model : NULL;
        done = output_folder(o->folder) && report_write(s, o);
    }
    object_free(&model);
    return done;
}

static int run(const nkw_document *d, void *data)
{
    request *r = data;
    const report_options o = {"nakawari exercise", r->output ? r->output : ".", r->step, NULL, NULL, 0, 0};
    scene s;
    if (!read_scene(d, r, &s))
        return 0;
    s.rule = (nkw_keyframe_rule)r->sampling_rule->method;
    if (r->checked) {
        if (!check_numbers(&s, r))
            return 0;
    } else if (r->traces)
        trace_print(stdout, &s, (float)r->time, (nkw_position_method)r->position_method->method,
                    (nkw_orientation_method)r->orientation_method->method);
    else if (report_rows(&s, &o) > REPORT_ROWS_MAX)
        return output_complain(d, NULL, "more than 1000000 rows: choose a longer --step");
    else if (!write_files(&s, &o, r))
        return 0;
    return output_close(stdout, NULL);
}

static int check_comparison(const options *o, request *r)
{
    static const char *const units[] = {"radians", "degrees"}, *const orders[] = {"columns", "rows"};
    const int unit = r->angles ? words_find(r->angles, units, 2) : 0;
    if (!r->checked && (r->angles || r->matrix || r->tolerance != TOLERANCE))
        return options_misuse(o, r->angles ? "--angles" : r->matrix ? "--matrix" : "--tolerance", "only with --check");
    if (unit < 0)
        return options_misuse(o, r->angles, "not radians or degrees");
    if (r->matrix && words_find(r->matrix, orders, 2) < 0)
        return options_misuse(o, r->matrix, "not columns or rows");
    if (!(r->tolerance >= 0.0 && r->tolerance <= 1e6))
        return options_misuse(o, "--tolerance", "not in 0..1000000");
    if (r->checked && r->traces)
        return options_misuse(o, "--trace", "not with --check");
    if (r->object && (r->checked || r->traces))
        return options_misuse(o, "--object", "not with --check or --trace");
    r->unit = !r->angles ? ANSWERS_ANY_UNIT : unit == 0 ? ANSWERS_RADIANS : ANSWERS_DEGREES;
    return COMMAND_FINE;
}

static int check_request(const options *o, void *data)
{
    request *r = data;
    r->position_method = report_find(r->position ? r->position : "hermite", report_positions);
    r->orientation_method = report_find(r->orientation ? r->orientation : "quat", report_orientations);
    r->sampling_rule = report_find(r->rule ? r->rule : "exercise", report_rules);
    if (!r->sampling_rule)
        return options_misuse(o, r->rule, "not exercise or library");
    if (!r->position_method)
        return options_misuse(o, r->position, "not linear, hermite, bezier, bspline, catmull-rom or step");
    if (!r->orientation_method)
        return options_misuse(o, r->orientation, "not none, euler, quat, euler-unwrapped or nlerp");
    if (!(r->step >= 1e-4 && r->step <= 1e3))
        return options_misuse(o, "--step", "not in 0.0001..1000");
    if (!(r->time == 1e30 || (r->time >= -1e6 && r->time <= 1e6)))
        return options_misuse(o, "--trace", "not a time");
    if (r->output && strlen(r->output) > 4000)
        return options_misuse(o, "--output", "too long");
    r->traces = r->time != 1e30;
    return r->keys == 1 || r->keys < 0 ? options_misuse(o, "--keys", "not 2 or more") : check_comparison(o, r);
}

int command_exercise(int argc, const char **argv)
{
    request r = {0};
    r.step = 0.1;
    r.time = 1e30;
    r.tolerance = TOLERANCE;
    const struct poptOption known[] = {
        {"clip", 'c', POPT_ARG_STRING, &r.clip, 0, "number or name of the clip (default: 0)", "N"},
        {"joint", 'j', POPT_ARG_STRING, &r.joint, 0, "name or number of the joint (default: the first that moves)",
         "N"},
        {"keys", 'k', POPT_ARG_LONG, &r.keys, 0, "only the first N keys", "N"},
        {"step", 's', POPT_ARG_DOUBLE, &r.step, 0, "seconds between the rows of the tables (default: 0.1)", "S"},
        {"rule", 'r', POPT_ARG_STRING, &r.rule, 0,
         "exercise (default) or library: of what is printed and drawn", "RULE"},
        {"trace", 't', POPT_ARG_DOUBLE, &r.time, 0, "write no file; print the calculation at time T", "T"},
        {"position", 'p', POPT_ARG_STRING, &r.position, 0,
         "of --trace (default: hermite) and --check: linear, hermite, bezier, bspline, catmull-rom, step", "METHOD"},
        {"orientation", 'q', POPT_ARG_STRING, &r.orientation, 0,
         "of --trace (default: quat) and --check: none, euler, quat, euler-unwrapped, nlerp", "METHOD"},
        {"check", 'x', POPT_ARG_STRING, &r.checked, 0, "write no file; compare the numbers of FILE", "FILE"},
        {"tolerance", 0, POPT_ARG_DOUBLE, &r.tolerance, 0, "of --check: of an element of the matrix (default: 0.001)",
         "D"},
        {"angles", 0, POPT_ARG_STRING, &r.angles, 0,
         "of --check: radians, degrees (default: degrees if one is above 10)", "UNIT"},
        {"matrix", 0, POPT_ARG_STRING, &r.matrix, 0, "of --check: written by columns (default) or rows", "ORDER"},
        {"object", 0, POPT_ARG_STRING, &r.object, 0,
         "draw the model FILE.obj in place of the dart: its nose at -z, scaled to the dart's length", "FILE"},
        {"output", 'o', POPT_ARG_STRING, &r.output, 0,
         "write the files to the folder DIR, made if it does not exist (default: .)", "DIR"},
        OPTIONS_END};
    static const command_steps steps = {check_request, run};
    input_set_holding(0);
    int code = command_run(&text, known, argc, argv, &steps, &r);
    code = r.verdict != COMMAND_FINE ? r.verdict : code;
    free(r.clip);
    free(r.joint);
    free(r.output);
    free(r.object);
    free(r.position);
    free(r.orientation);
    free(r.rule);
    free(r.checked);
    free(r.angles);
    free(r.matrix);
    return code;
}
