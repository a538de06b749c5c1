/* SPDX-License-Identifier: MIT */
/* nakawari diff: the largest difference of each joint between two files; logs are in difflog.c. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "difflog.h"
#include "distance.h"
#include "extent.h"
#include "json.h"
#include "pair.h"
#include "progress.h"
#include "times.h"

static const options_text text = {
    "[OPTION...] A B",
    "Compares the clips of two files: prints for each joint the largest distance between A and B in model space,\n"
    "and the time of it. The distance is the largest of four points: the joint's origin, and the points on its\n"
    "three axes at the distance of its farthest vertex. It is measured at the times of all keys of both clips and\n"
    "half-way between two of them. Joints and clips are matched by name, those of equal name in their order.\n\n"
    "The exit code is 1 if a distance exceeds --tolerance, or if a joint or a clip is in one file only.\n\n"
    "Two logs of fingerprints, which begin with the word frame: prints the first frame, joint and number that\n"
    "differ. The exit code is 1 if any does. --tolerance is then the largest difference of a number.\n",
    "  nakawari diff fox.glb fox-optimised.glb\n"
    "  nakawari diff --tolerance 0.01 --clip Walk fox.glb fox-optimised.glb\n"
    "  nakawari diff server.log client.log\n"
    "  nakawari diff --json a.glb b.glb | jq '.clips[].joints[] | select(.distance > 0.1)'\n",
    2, 0};

typedef struct request {
    char *clip;
    int json, all;
    float tolerance, distance;
} request;

/* The largest difference of one joint, or of the morph weights. */
typedef struct worst {
    double distance;
    float time;
} worst;

/* What is compared: joints of a with their partners in b. */
typedef struct comparison {
    const nkw_document *a, *b;
    const request *request;
    const extent *extent; /* of a */
    int32_t *partner; /* of each joint of a, or NKW_NO_JOINT */
    worst *joints; /* of each joint of a, in one clip */
    worst floats;
    double most; /* of all clips */
    size_t unmatched;
    json_t *list; /* of clips; NULL: print lines */
    json_t *only; /* what is in one file only */
} comparison;

static double float_difference(const nkw_document *a, const nkw_document *b, const int32_t *partner, const float *x,
                               const float *y)
{
    double most = 0.0;
    for (size_t j = 0; j < a->skeleton.joint_count; j++) {
        const nkw_document_node *from = &a->nodes[j], *to = partner[j] < 0 ? NULL : &b->nodes[partner[j]];
        for (size_t k = 0; to && k < from->float_count && k < to->float_count; k++) {
            double d = fabs((double)x[from->float_first + k] - (double)y[to->float_first + k]);
            most = d > most ? d : most;
        }
    }
    return most;
}

static void compare_at(comparison *c, moment *x, moment *y, float time)
{
    moment_at(x, time);
    moment_at(y, time);
    for (size_t j = 0; j < c->a->skeleton.joint_count; j++) {
        if (c->partner[j] < 0)
            continue;
        float reach = c->request->distance >= 0.0f ? c->request->distance : c->extent->reach[j];
        double distance = matrix_distance(&x->models[j], &y->models[c->partner[j]], reach);
        if (distance > c->joints[j].distance) {
            c->joints[j].distance = distance;
            c->joints[j].time = time;
        }
    }
    double floats = float_difference(c->a, c->b, c->partner, x->floats, y->floats);
    if (floats > c->floats.distance) {
        c->floats.distance = floats;
        c->floats.time = time;
    }
}

/* ---- output ---- */

static void put_lines(const comparison *c, size_t clip_a, size_t clip_b, size_t time_count)
{
    printf("clip %ld ", input_clip_number(clip_a));
    output_text(stdout, input_clip_name(c->a, clip_a));
    printf(" and clip %ld ", input_clip_number(clip_b));
    output_text(stdout, input_clip_name(c->b, clip_b));
    printf(": %zu %s\n        distance          time  joint\n", COUNT(time_count, "time", "times"));
    size_t equal = 0;
    for (size_t n = 0; n < c->a->skeleton.joint_count; n++) {
        size_t j = (size_t)c->a->joint_of_node[n];
        if (c->partner[j] < 0)
            continue;
        if (!c->request->all && c->joints[j].distance == 0.0) {
            equal++;
            continue;
        }
        printf("%16.9g  %12.9g  ", c->joints[j].distance, (double)c->joints[j].time);
        output_text(stdout, c->a->nodes[j].name);
        putchar('\n');
    }
    if (equal)
        printf("%16d                %zu %s\n", 0, COUNT(equal, "joint", "joints"));
    if (c->a->float_count)
        printf("%16.9g  %12.9g  morph weights\n", c->floats.distance, (double)c->floats.time);
}

static json_t *json_joints(const comparison *c)
{
    json_t *list = json_array();
    for (size_t n = 0; n < c->a->skeleton.joint_count; n++) {
        size_t j = (size_t)c->a->joint_of_node[n];
        if (c->partner[j] >= 0)
            json_array_append_new(list, json_pack("{s:I, s:o, s:o, s:o}", "node", (json_int_t)n, "joint",
                                                  json_text(c->a->nodes[j].name), "distance",
                                                  json_number(c->joints[j].distance), "time",
                                                  json_number((double)c->joints[j].time)));
    }
    return list;
}

static void add_json(comparison *c, size_t clip_a, size_t clip_b, size_t time_count)
{
    json_array_append_new(c->list,
                          json_pack("{s:I, s:o, s:I, s:I, s:o, s:o}", "clip_a", (json_int_t)input_clip_number(clip_a),
                                    "name", json_text(input_clip_name(c->a, clip_a)), "clip_b",
                                    (json_int_t)input_clip_number(clip_b), "times", (json_int_t)time_count, "joints",
                                    json_joints(c), "morph_weights", json_number(c->floats.distance)));
}

/* ---- clips ---- */

static int compare_clips(comparison *c, size_t clip_a, size_t clip_b)
{
    const worst none = {0.0, 0.0f};
    moment x, y;
    times t;
    memset(&y, 0, sizeof y);
    memset(&t, 0, sizeof t);
    int fine = moment_open(&x, c->a, clip_a) && moment_open(&y, c->b, clip_b) &&
               times_of_clips(&t, c->a, clip_a, c->b, clip_b);
    c->floats = none;
    for (size_t j = 0; j < c->a->skeleton.joint_count; j++)
        c->joints[j] = none;
    progress p = progress_begin("comparing time", t.count, NULL);
    for (size_t k = 0; fine && k < t.count; k++) {
        progress_at(&p, k);
        compare_at(c, &x, &y, t.times[k]);
    }
    progress_end(&p);
    for (size_t j = 0; fine && j < c->a->skeleton.joint_count; j++)
        c->most = fmax(c->most, c->joints[j].distance);
    c->most = fmax(c->most, c->floats.distance);
    if (fine && c->list)
        add_json(c, clip_a, clip_b, t.count);
    else if (fine)
        put_lines(c, clip_a, clip_b, t.count);
    times_free(&t);
    moment_close(&x);
    moment_close(&y);
    return fine;
}

static void report_unmatched(comparison *c, const char *file, const char *what, const char *name)
{
    c->unmatched++;
    if (c->only) {
        json_array_append_new(
            c->only, json_pack("{s:o, s:s, s:o}", "file", json_text(file), "what", what, "name", json_text(name)));
        return;
    }
    fputs("only in ", stdout);
    output_text(stdout, file);
    printf(": %s ", what);
    output_text(stdout, name);
    putchar('\n');
}

static int compare_all_clips(comparison *c)
{
    size_t matched = 0;
    int fine = 1;
    for (size_t i = 0; fine && i < c->a->animation_count; i++) {
        size_t other = pair_clip(c->a, i, c->b);
        if (other == SIZE_MAX)
            report_unmatched(c, c->a->file, "clip", c->a->animations[i].name);
        else
            fine = compare_clips(c, i, other);
        matched += other != SIZE_MAX;
    }
    for (size_t i = 0; matched < c->b->animation_count && i < c->b->animation_count; i++)
        if (pair_clip(c->b, i, c->a) == SIZE_MAX)
            report_unmatched(c, c->b->file, "clip", c->b->animations[i].name);
    if (!c->a->animation_count)
        fine = compare_clips(c, INPUT_REST, INPUT_REST);
    return fine;
}

static int compare_selected(comparison *c)
{
    input_clips x, y;
    if (!c->request->clip)
        return compare_all_clips(c);
    if (strcmp(c->request->clip, "all") == 0)
        return compare_all_clips(c);
    return input_select(c->a, c->request->clip, &x) && input_select(c->b, c->request->clip, &y) &&
           compare_clips(c, x.first, y.first);
}

static void report_joints(comparison *c, const int32_t *back)
{
    for (size_t j = 0; j < c->a->skeleton.joint_count; j++)
        if (c->partner[j] < 0)
            report_unmatched(c, c->a->file, "joint", c->a->nodes[j].name);
    for (size_t j = 0; j < c->b->skeleton.joint_count; j++)
        if (back[j] < 0)
            report_unmatched(c, c->b->file, "joint", c->b->nodes[j].name);
}

static int put_json(const comparison *c)
{
    return json_put_lines(stdout,
                          json_pack("{s:o, s:o, s:o, s:o, s:o}", "a", json_text(c->a->file), "b", json_text(c->b->file),
                                    "largest", json_number(c->most), "only", c->only, "clips", c->list));
}

/* ---- the command ---- */

static int run(const nkw_document *a, const nkw_document *b, const request *r)
{
    extent e;
    comparison c;
    memset(&c, 0, sizeof c);
    c.a = a, c.b = b, c.request = r, c.extent = &e;
    int32_t *back = calloc(b->skeleton.joint_count, sizeof *back);
    c.partner = calloc(a->skeleton.joint_count, sizeof *c.partner);
    c.joints = calloc(a->skeleton.joint_count, sizeof *c.joints);
    c.list = r->json ? json_array() : NULL;
    c.only = r->json ? json_array() : NULL;
    int fine = extent_open(&e, a) && back && c.partner && c.joints && pair_joints(a, b, c.partner, back);
    if (fine) {
        report_joints(&c, back);
        fine = compare_selected(&c);
    }
    if (fine && r->json)
        fine = put_json(&c);
    extent_free(&e);
    free(back);
    free(c.partner);
    free(c.joints);
    fine = output_close(stdout, NULL) && fine;
    return fine && !c.unmatched && c.most <= (double)r->tolerance ? COMMAND_FINE : COMMAND_FINDINGS;
}

static int check_request(const options *o, const request *r)
{
    if (!(r->tolerance >= 0.0f))
        return options_misuse(o, "--tolerance", "not a distance");
    if (!(r->distance == -1.0f || r->distance >= 0.0f))
        return options_misuse(o, "--distance", "not a distance");
    if (strcmp(o->files[0], "-") == 0 && strcmp(o->files[1], "-") == 0)
        return options_misuse(o, "-", "only one file can be the standard input");
    return COMMAND_FINE;
}

static int run_logs(const options *o, const request *r)
{
    const difflog_request logs = {o->files[0], o->files[1], r->json, r->tolerance};
    if (r->clip || r->all || r->distance >= 0.0f)
        return options_misuse(o, o->files[0], "a log has no clips, no distances and no other joints");
    return difflog_run(&logs);
}

static int run_files(const options *o, const request *r)
{
    if (difflog_is(o->files[0]) && difflog_is(o->files[1]))
        return run_logs(o, r);
    nkw_document *a = input_open(o->files[0]), *b = a ? input_open(o->files[1]) : NULL;
    int code = b ? run(a, b, r) : COMMAND_FINDINGS;
    input_close(a);
    input_close(b);
    return code;
}

int command_diff(int argc, const char **argv)
{
    request r = {NULL, 0, 0, 0.0f, -1.0f};
    const struct poptOption known[] = {
        {"clip", 'c', POPT_ARG_STRING, &r.clip, 0, "number or name of one clip of both (default: all)", "N"},
        {"tolerance", 't', POPT_ARG_FLOAT, &r.tolerance, 0, "largest distance that is fine (default: 0)", "D"},
        {"distance", 'd', POPT_ARG_FLOAT, &r.distance, 0,
         "distance of the points from the joints (default: of each joint's farthest vertex)", "D"},
        {"all", 'a', POPT_ARG_NONE, &r.all, 0, "print joints without a difference too", NULL},
        {"json", 0, POPT_ARG_NONE, &r.json, 0, "print JSON", NULL},
        INPUT_STRICT,
        OPTIONS_END};
    options o;
    int code;
    if (!options_read(&o, &text, known, argc, argv))
        code = o.code;
    else if ((code = check_request(&o, &r)) == COMMAND_FINE)
        code = run_files(&o, &r);
    options_close(&o);
    free(r.clip);
    return code;
}
