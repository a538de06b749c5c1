/* SPDX-License-Identifier: MIT */
/* nakawari reduce: fewer keys, within a distance in model space. */
#include <stdlib.h>
#include <string.h>

#include "model.h"
#include "progress.h"

static const options_text text = {
    "[OPTION...] FILE -o OUT",
    "Removes the keys of FILE that are not needed within a distance in model space, and writes the rest as glTF\n"
    "2.0. The keys that remain are unchanged. Turns, jumps and changes of the interpolation remain at every\n"
    "tolerance. Of a glTF file everything else is kept: meshes, materials, textures, cameras, extensions.\n\n"
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
    int lossless, fewest;
} request;

static int reduce_clips(model *m, const void *request_of, const extent *e, FILE *report)
{
    const request *r = request_of;
    const nkw_document *d = m->original;
    const float tolerance = r->lossless ? 0.0f : r->tolerance >= 0.0f ? r->tolerance : 1e-4f * e->size;
    input_clips clips = {0, d->animation_count};
    if (r->clip && !input_select(d, r->clip, &clips))
        return 0;
    int fine = 1;
    m->only_smaller = !r->fewest;
    model_report_head(report, d);
    progress p = progress_begin("reducing clip", clips.count, report);
    for (size_t i = clips.first; fine && clips.first != INPUT_REST && i < clips.first + clips.count; i++) {
        model_change change;
        progress_at(&p, i - clips.first);
        fine = model_reduce(m, i, e, tolerance, r->fewest) && model_measure(m, i, e, tolerance, &change);
        progress_end(&p);
        if (fine)
            model_report(report, d, i, &change);
    }
    progress_end(&p);
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
    request r = {NULL, NULL, NULL, -1.0f, 0, 0};
    const struct poptOption known[] = {
        {"clip", 'c', POPT_ARG_STRING, &r.clip, 0, "number or name of the clip (default: all)", "N"},
        {"tolerance", 't', POPT_ARG_FLOAT, &r.tolerance, 0,
         "largest distance in model space (default: 1/10000 of the model's size)", "D"},
        {"lossless", 'l', POPT_ARG_NONE, &r.lossless, 0, "remove only keys between equal values", NULL},
        {"fewest", 0, POPT_ARG_NONE, &r.fewest, 0, "the fewest keys, also where they need more bytes", NULL},
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
