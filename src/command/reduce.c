/* SPDX-License-Identifier: MIT */
/* nakawari reduce: fewer keys, within a distance in model space. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model.h"
#include "progress.h"

static const options_text text = {
    "[OPTION...] FILE -o OUT",
    "Removes the keys of FILE that are not needed within a distance in model space, and writes the rest as glTF\n"
    "2.0. The keys that remain are unchanged. Turns, jumps and changes of the interpolation remain at every\n"
    "tolerance. Of a glTF file everything else is kept: meshes, materials, textures, cameras, extensions.\n"
    "Channels whose keys all equal the rest pose are left out, unless --keep-rest is used; a clip keeps one channel\n"
    "and its first and last time.\n\n"
    "Prints for each clip: keys and their bytes before and after, the largest distance that was measured between\n"
    "both, at the farthest vertex of each joint, and the largest difference of a morph weight. --lossless removes\n"
    "only keys between equal values. Tracks often share their key times: one whose fewer keys, with times of\n"
    "their own, would need more bytes remains as it is, unless --fewest is used.\n",
    "  nakawari reduce fox.glb -o small.glb\n"
    "  nakawari reduce fox.glb --tolerance 0.1 -o small.glb\n"
    "  nakawari reduce --lossless robot.gltf -o robot.glb\n"
    "  nakawari reduce - < fox.glb > small.glb\n",
    1, 0};

typedef struct request {
    char *clip, *output, *form;
    float tolerance;
    int lossless, fewest, keeps_rest;
} request;

/* ---- channels that equal the rest pose ---- */

/* The values of a target at rest, `width` of them; NULL without any, or if a matrix is in their place. */
static const float *rest_of(const nkw_document *d, const nkw_clip_track *t, size_t joint)
{
    const nkw_document_node *node = &d->nodes[joint];
    if (node->matrix)
        return NULL;
    switch (t->target) {
    case NKW_CLIP_TRANSLATION:
        return &node->rest.translation.x;
    case NKW_CLIP_ROTATION:
        return &node->rest.rotation.x;
    case NKW_CLIP_SCALE:
        return &node->rest.scale.x;
    default:
        return d->rest_floats ? d->rest_floats + t->index : NULL;
    }
}

/* Whether `width` numbers are `sign` times those of `rest`. */
static int equals(const float *values, const float *rest, float sign, size_t width)
{
    for (size_t i = 0; i < width; i++)
        if (values[i] != sign * rest[i])
            return 0;
    return 1;
}

/* Whether each value is that of the rest pose, of rotations the same quaternion or its negative, and tangents are 0. */
static int is_at_rest(const nkw_document *d, const nkw_clip_track *of, size_t joint)
{
    const nkw_track *t = &of->track;
    const float *rest = rest_of(d, of, joint), *key = t->values;
    const int is_cubic = t->interpolation == NKW_INTERPOLATION_CUBICSPLINE;
    const size_t width = t->width;
    if (!rest || t->count == 0 || t->key_interpolation)
        return 0;
    const int is_negative = of->target == NKW_CLIP_ROTATION && !equals(key + (is_cubic ? width : 0), rest, 1.0f, width);
    int same = 1;
    for (size_t k = 0; same && k < t->count; k++, key += is_cubic ? 3 * width : width) {
        same = equals(key + (is_cubic ? width : 0), rest, is_negative ? -1.0f : 1.0f, width);
        if (is_cubic)
            same = same && equals(key, rest, 0.0f, width) && equals(key + 2 * width, rest, 0.0f, width);
    }
    return same;
}

/* The first and the last time of tracks, and how many of them begin and end there. */
typedef struct span {
    float first, last;
    size_t firsts, lasts;
} span;

static void add_to_span(span *s, const nkw_track *t)
{
    if (t->count == 0)
        return;
    const float first = t->times[0], last = t->times[t->count - 1];
    s->firsts = first < s->first ? 1 : s->firsts + (first == s->first);
    s->first = first < s->first ? first : s->first;
    s->lasts = last > s->last ? 1 : s->lasts + (last == s->last);
    s->last = last > s->last ? last : s->last;
}

/* Takes a track away, if others begin at the first and end at the last time. */
static int take_from_span(span *s, const nkw_track *t)
{
    const size_t firsts = t->times[0] == s->first, lasts = t->times[t->count - 1] == s->last;
    if (firsts == s->firsts || lasts == s->lasts)
        return 0;
    s->firsts -= firsts;
    s->lasts -= lasts;
    return 1;
}

/* Leaves out the channels at rest; so many that the clip begins and ends as before. Returns 0 without memory. */
static int leave_out_rest(model *m, size_t animation, size_t *left_out)
{
    nkw_document_animation *a = &m->animations[animation];
    nkw_clip_track *tracks = model_take(m, a->track_count, sizeof *tracks);
    nkw_document_channel *channels = model_take(m, a->track_count, sizeof *channels);
    span s = {INFINITY, -INFINITY, 0, 0};
    size_t count = 0;
    if (!tracks || !channels)
        return 0;
    for (size_t i = 0; i < a->track_count; i++)
        add_to_span(&s, &a->tracks[i].track);
    for (size_t i = 0; i < a->track_count; i++) {
        if (is_at_rest(m->original, &a->tracks[i], (size_t)a->channels[i].joint) &&
            take_from_span(&s, &a->tracks[i].track))
            continue;
        tracks[count] = a->tracks[i];
        channels[count++] = a->channels[i];
    }
    *left_out += a->track_count - count;
    a->tracks = tracks;
    a->channels = channels;
    a->track_count = count;
    return 1;
}

/* ---- clips ---- */

static int reduce_clip(model *m, size_t i, const extent *e, float tolerance, const request *r, size_t *left_out)
{
    return model_reduce(m, i, e, tolerance, r->fewest) && (r->keeps_rest || leave_out_rest(m, i, left_out));
}

static int reduce_clips(model *m, const void *request_of, const extent *e, FILE *report)
{
    const request *r = request_of;
    const nkw_document *d = m->original;
    const float tolerance = r->lossless ? 0.0f : r->tolerance >= 0.0f ? r->tolerance : 1e-4f * e->size;
    input_clips clips = {0, d->animation_count};
    if (r->clip && !input_select(d, r->clip, &clips))
        return 0;
    size_t left_out = 0;
    int fine = 1;
    m->only_smaller = !r->fewest;
    model_report_head(report, d);
    progress p = progress_begin("reducing clip", clips.count, report);
    for (size_t i = clips.first; fine && clips.first != INPUT_REST && i < clips.first + clips.count; i++) {
        model_change change;
        progress_at(&p, i - clips.first);
        fine = reduce_clip(m, i, e, tolerance, r, &left_out) && model_measure(m, i, e, tolerance, &change);
        progress_end(&p);
        if (fine)
            model_report(report, d, i, &change);
    }
    progress_end(&p);
    if (left_out > 0)
        fprintf(report, "%zu channel%s left out: equal to the rest pose\n", left_out, left_out > 1 ? "s" : "");
    return fine;
}

static int run(const model_source *source, void *of)
{
    const request *r = of;
    const int is_gltf = strcmp(source->document->format, "glTF 2.0") == 0;
    return model_rewrite(source, is_gltf, r->form, r->output, reduce_clips, r);
}

static int check_request(const options *o, void *of)
{
    const request *r = of;
    if (!(r->tolerance == -1.0f || (r->tolerance >= 0.0f && r->tolerance < 1e30f)))
        return options_misuse(o, "--tolerance", "not a distance");
    if (r->lossless && r->tolerance != -1.0f)
        return options_misuse(o, "--lossless", "has no tolerance");
    if (!r->form && output_is_foreign(r->output))
        return options_misuse(o, r->output, "only glTF is written: .glb or .gltf");
    if (model_form(r->form, r->output) < 0)
        return options_misuse(o, r->form, "not glb, gltf or embedded");
    return COMMAND_FINE;
}

int command_reduce(int argc, const char **argv)
{
    request r = {NULL, NULL, NULL, -1.0f, 0, 0, 0};
    const struct poptOption known[] = {
        {"clip", 'c', POPT_ARG_STRING, &r.clip, 0, "number or name of the clip (default: all)", "N"},
        {"tolerance", 't', POPT_ARG_FLOAT, &r.tolerance, 0,
         "largest distance in model space (default: 1/10000 of the model's size)", "D"},
        {"lossless", 'l', POPT_ARG_NONE, &r.lossless, 0, "remove only keys between equal values", NULL},
        {"fewest", 0, POPT_ARG_NONE, &r.fewest, 0, "the fewest keys, also where they need more bytes", NULL},
        {"keep-rest", 0, POPT_ARG_NONE, &r.keeps_rest, 0, "keep channels that equal the rest pose", NULL},
        {"form", 'f', POPT_ARG_STRING, &r.form, 0,
         "glb, gltf (with FILE.bin) or embedded (default: by the name of the output)", "FORM"},
        {"output", 'o', POPT_ARG_STRING, &r.output, 0, "write to FILE, not to the standard output", "FILE"},
        INPUT_STRICT,
        OPTIONS_END};
    static const model_steps steps = {check_request, run};
    const int code = model_run(&text, known, argc, argv, &steps, &r);
    free(r.clip);
    free(r.output);
    free(r.form);
    return code;
}
