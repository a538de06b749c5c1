/* SPDX-License-Identifier: MIT */
/* nakawari check: what is wrong with a file. */
#include "check.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "json.h"
#include "model.h"

static const options_text text = {
    "[OPTION...] FILE...",
    "Checks each FILE (- reads the standard input) and prints one line for each kind of finding, errors first: the\n"
    "worst of its kind, with file, clip, joint, key, time, severity, what, how much, and how many there are.\n\n"
    "  error     unsorted-time, not-finite, not-unit, joint-out-of-range, bad-weight, not-affine,\n"
    "            transposed-matrix, animated-matrix, refused\n"
    "  warning   duplicate-time, short-segment, negative-time, outlier-time, not-unit, over-half-turn, long-way,\n"
    "            spike, overshoot, non-positive-scale (negative), weights-sum, unused-joint-out-of-range,\n"
    "            singular-matrix, scaled-matrix, joint-outside-scene, empty-scene, wrong-skeleton, wrong-bounds,\n"
    "            absent-image, unread-channel, as-read\n"
    "  note      rounded-unit, sign-flip, half-turn, non-positive-scale (zero), constant, spare-keys, open-loop,\n"
    "            root-drift, velocity-seam, sliding-foot, equal-names, added-keys\n\n"
    "Errors and warnings make the exit code 1, with --strict notes too.\n",
    "  nakawari check fox.glb\n"
    "  nakawari check --all fox.glb\n"
    "  nakawari check --only open-loop,velocity-seam walk.glb\n"
    "  nakawari check --no-notes models/*.glb\n"
    "  nakawari check --json fox.glb | jq '.findings[] | select(.severity == \"error\")'\n",
    1, 1};

/* An error of the library that no check has found: two tracks of one property, for example. */
static int check_clip_builds(check *c, size_t animation)
{
    nkw_clip *clip = NULL;
    nkw_import_error error;
    finding f = finding_of(SEVERITY_ERROR, "refused");
    int fine = nkw_document_clip(c->document, animation, NKW_CLIP_FLOAT32, &clip, &error) == NKW_IMPORT_OK;
    nkw_import_free(clip);
    if (fine)
        return 1;
    f.clip = (long)animation;
    snprintf(f.detail, sizeof f.detail, "%.60s: %.90s", error.place, error.reason);
    findings_add(&c->found, &f);
    return 0;
}

static void check_unread(check *c, size_t animation)
{
    const nkw_document_animation *a = &c->document->animations[animation];
    for (size_t i = 0; i < a->unread_count; i++) {
        finding f = finding_of(SEVERITY_WARNING, "unread-channel");
        f.clip = (long)animation;
        f.number = (long)a->unread[i].number;
        f.object = "channel";
        snprintf(f.detail, sizeof f.detail, "%.150s", a->unread[i].reason);
        findings_add(&c->found, &f);
    }
}

static void check_clip(check *c, size_t animation, int notes)
{
    const nkw_document_animation *a = &c->document->animations[animation];
    size_t errors = c->found.counts[SEVERITY_ERROR];
    check_unread(c, animation);
    c->found.line = progress_begin("checking channel", a->track_count, NULL);
    for (size_t i = 0; i < a->track_count; i++) {
        progress_at(&c->found.line, i);
        const size_t before = c->found.counts[SEVERITY_ERROR];
        check_track(c, animation, i);
        if (c->found.counts[SEVERITY_ERROR] == before)
            check_outliers(c, animation, i);
    }
    progress_end(&c->found.line);
    if (c->found.counts[SEVERITY_ERROR] != errors || !check_clip_builds(c, animation) || !notes)
        return;
    c->found.line = progress_begin("looking for spare keys of channel", a->track_count, NULL);
    for (size_t i = 0; i < a->track_count; i++) {
        progress_at(&c->found.line, i);
        check_spare_keys(c, animation, i);
    }
    progress_end(&c->found.line);
    check_motion(c, animation);
}

static void check_warnings(check *c)
{
    for (size_t i = 0; i < c->document->warning_count; i++) {
        finding f = finding_of(SEVERITY_WARNING, "as-read");
        snprintf(f.detail, sizeof f.detail, "%.150s", c->document->warnings[i]);
        findings_add(&c->found, &f);
    }
}

static void check_document(check *c, int notes)
{
    check_warnings(c);
    check_model(c);
    check_scene(c);
    check_file(c);
    for (size_t i = 0; i < c->document->animation_count; i++)
        check_clip(c, i, notes);
}

/* docs/command.md states the members. */
static int put_json(check *c)
{
    json_t *all = json_pack(
        "{s:i, s:o, s:I, s:I, s:I, s:o, s:o}", "schema", JSON_SCHEMA, "file", json_text(c->document->file), "errors",
        (json_int_t)c->found.counts[SEVERITY_ERROR], "warnings", (json_int_t)c->found.counts[SEVERITY_WARNING], "notes",
        (json_int_t)c->found.counts[SEVERITY_NOTE], "kinds", findings_kinds(&c->found), "findings", c->found.list);
    return json_put_lines(stdout, all);
}

typedef struct request {
    int json, strict, no_notes, all;
    float tolerance;
    long most;
    char *only;
} request;

static int run(check *c, const request *r)
{
    c->found.document = c->document;
    c->found.most = (size_t)r->most;
    c->found.hide_notes = r->no_notes;
    c->found.only = r->only;
    c->found.sums_up = !r->all && !r->json;
    c->found.list = r->json ? json_array() : NULL;
    int fine = extent_open(&c->extent, c->document);
    if (fine) {
        c->tolerance = r->tolerance >= 0.0f ? r->tolerance : 1e-4f * c->extent.size;
        check_document(c, !r->no_notes);
    }
    extent_free(&c->extent);
    fine = fine && !c->found.failed;
    findings_end(&c->found);
    if (r->json && fine)
        fine = put_json(c);
    fine = output_close(stdout, NULL) && fine;
    if (!fine || c->found.counts[SEVERITY_ERROR] || c->found.counts[SEVERITY_WARNING])
        return COMMAND_FINDINGS;
    return r->strict && c->found.counts[SEVERITY_NOTE] ? COMMAND_FINDINGS : COMMAND_FINE;
}

/* The bytes are kept for what the document does not have. */
static int check_path(const char *path, const request *r)
{
    model_source source;
    check c;
    int code = COMMAND_FINDINGS;
    memset(&c, 0, sizeof c);
    if (model_source_open(&source, path)) {
        c.document = source.document;
        c.data = source.data;
        c.bytes = source.memory.bytes;
        code = run(&c, r);
    } else if (r->json) {
        json_put_lines(stdout, json_unreadable());
        output_close(stdout, NULL);
    }
    model_source_close(&source);
    return code;
}

void check_written(const char *path)
{
    const request errors = {0, 0, 1, 0, -1.0f, 100, NULL};
    input_set_holding(0);
    check_path(path, &errors);
}

size_t check_count(const nkw_document *document, const void *data, size_t bytes, const char *kinds)
{
    check c;
    memset(&c, 0, sizeof c);
    c.document = c.found.document = document;
    c.data = data;
    c.bytes = bytes;
    c.found.only = kinds;
    c.found.sums_up = 1;
    check_file(&c);
    return c.found.counts[SEVERITY_ERROR] + c.found.counts[SEVERITY_WARNING];
}

/* --only: kinds, separated by commas. */
static int are_kinds(const char *only)
{
    size_t length = strcspn(only, ",");
    while (finding_is_kind(only, length) && only[length] == ',') {
        only += length + 1;
        length = strcspn(only, ",");
    }
    return finding_is_kind(only, length);
}

static int check_request(const options *o, const request *r)
{
    if (!(r->tolerance == -1.0f || (r->tolerance >= 0.0f && r->tolerance < 1e30f)))
        return options_misuse(o, "--tolerance", "not a distance");
    if (r->only && !are_kinds(r->only))
        return options_misuse(o, r->only, "no kind of finding: --help lists them");
    for (int i = 0, inputs = 0; o->files[i]; i++)
        if (strcmp(o->files[i], "-") == 0 && inputs++)
            return options_misuse(o, "-", "only one file can be the standard input");
    return r->most < 1 ? options_misuse(o, "--most", "not a positive number") : COMMAND_FINE;
}

int command_check(int argc, const char **argv)
{
    request r = {0, 0, 0, 0, -1.0f, 100, NULL};
    const struct poptOption known[] = {
        {"all", 'a', POPT_ARG_NONE, &r.all, 0, "print every finding, in the order of the file", NULL},
        {"only", 0, POPT_ARG_STRING, &r.only, 0, "only these kinds, separated by commas", "KINDS"},
        {"json", 0, POPT_ARG_NONE, &r.json, 0, "print a JSON object for each file in place of lines", NULL},
        {"strict", 's', POPT_ARG_NONE, &r.strict, 0, "exit with 1 for notes too", NULL},
        {"no-notes", 'n', POPT_ARG_NONE, &r.no_notes, 0, "do not look for what only wastes memory, and for open loops",
         NULL},
        {"tolerance", 't', POPT_ARG_FLOAT, &r.tolerance, 0,
         "distance that is not seen, for notes (default: 1/10000 of the model's size)", "D"},
        {"most", 'm', POPT_ARG_LONG, &r.most, 0, "lines of one kind for one track (default: 100)", "N"},
        OPTIONS_END};
    options o;
    int code;
    input_set_holding(0);
    if (!options_read(&o, &text, known, argc, argv))
        code = o.code;
    else if ((code = check_request(&o, &r)) == COMMAND_FINE) {
        for (int i = 0; o.files[i]; i++)
            if (check_path(o.files[i], &r) != COMMAND_FINE)
                code = COMMAND_FINDINGS;
    }
    free(r.only);
    options_close(&o);
    return code;
}
