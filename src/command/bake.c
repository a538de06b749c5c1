/* SPDX-License-Identifier: MIT */
/* nakawari bake: clips as files that map back, and palettes as textures. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "bytes.h"
#include "moment.h"
#include "progress.h"
#include "size.h"

static const options_text text = {
    "[OPTION...] FILE",
    "Writes a clip of FILE in a form that needs no reader of models:\n\n"
    "  clip      the block of nkw_clip_build: map the file, call nkw_clip_open, sample. In the byte order of this\n"
    "            machine\n"
    "  compact   the same with 16-bit keys\n"
    "  reduced   the same as small as a tolerance permits, by nkw_clip_reduce\n"
    "  palette   the palette of a skin at a rate, for textures of GPU crowds: a header of 32 bytes, then for each\n"
    "            frame\n"
    "            and joint the first three rows of the joint matrix: 3 texels of 4 floats, little-endian\n",
    "  nakawari bake fox.glb --clip Run -o run.nkw\n"
    "  nakawari bake fox.glb -c Run --as reduced --tolerance 0.1 -o run.nkw\n"
    "  nakawari bake fox.glb -c Run --as palette --rate 30 -o run.palette\n",
    1, 0};

typedef enum bake_form { FORM_CLIP, FORM_COMPACT, FORM_REDUCED, FORM_PALETTE, FORMS } bake_form;
static const char *const forms[FORMS] = {"clip", "compact", "reduced", "palette"};

typedef struct request {
    char *clip, *as, *output;
    float rate, tolerance;
    long skin;
    bake_form form;
} request;

/* ---- clips ---- */

static int write_block(const char *path, const void *block, size_t bytes)
{
    FILE *f = output_open(path);
    if (!f)
        return 0;
    int fine = fwrite(block, 1, bytes, f) == bytes;
    return output_close(f, path) && fine;
}

static int bake_clip(const nkw_document *d, size_t animation, const request *r)
{
    nkw_clip *clip = NULL;
    nkw_import_error error;
    nkw_clip_format format = r->form == FORM_COMPACT ? NKW_CLIP_UNORM16 : NKW_CLIP_FLOAT32;
    if (nkw_document_clip(d, animation, format, &clip, &error) != NKW_IMPORT_OK) {
        input_report(&error);
        return 0;
    }
    int fine = write_block(r->output, clip, nkw_clip_describe(clip).bytes);
    nkw_import_free(clip);
    return fine;
}

static int bake_reduced(const nkw_document *d, size_t animation, const request *r)
{
    extent e;
    size_t bytes = 0;
    int fine = extent_open(&e, d);
    void *block = NULL;
    if (fine)
        block = reduced_clip(d, animation, &e, r->tolerance >= 0.0f ? r->tolerance : 1e-4f * e.size, &bytes);
    fine = block ? write_block(r->output, block, bytes)
                 : output_complain(d, NULL, "the clip cannot be reduced: see nakawari check; or there is no memory");
    free(block);
    extent_free(&e);
    return fine;
}

/* ---- palettes ---- */

static void put_header(FILE *f, const moment *m, const request *r, size_t joints, size_t frames)
{
    fputs("nkwpalet", f);
    bytes_put_u32(f, 1);
    bytes_put_u32(f, (uint32_t)joints);
    bytes_put_u32(f, (uint32_t)frames);
    bytes_put_f32(f, r->rate);
    bytes_put_f32(f, nkw_clip_describe(m->clip).start);
    bytes_put_f32(f, nkw_clip_describe(m->clip).end);
}

static void put_rows(FILE *f, const nkw_mat4 *m)
{
    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 4; column++)
            bytes_put_f32(f, m->m[4 * column + row]);
}

static int bake_palette(const nkw_document *d, size_t animation, const request *r)
{
    moment m;
    FILE *f = NULL;
    if ((size_t)r->skin >= d->skin_count)
        return output_complain(d, NULL, "no such skin");
    const size_t skin = (size_t)r->skin, joints = d->skins[skin].joint_count;
    int fine = moment_open(&m, d, animation);
    size_t frames = fine ? moment_rate_count(&m, r->rate) : 0;
    if (fine && frames > INT32_MAX)
        fine = output_complain(d, NULL, "too many frames at this rate");
    fine = fine && (f = output_open(r->output)) != NULL;
    if (fine)
        put_header(f, &m, r, joints, frames);
    progress p = progress_begin("baking frame", frames, NULL);
    for (size_t k = 0; fine && k < frames && !ferror(f); k++) {
        progress_at(&p, k);
        moment_at(&m, moment_rate_time(&m, r->rate, k));
        moment_palette(&m, skin);
        for (size_t j = 0; j < joints; j++)
            put_rows(f, &m.palette[j]);
    }
    progress_end(&p);
    moment_close(&m);
    return f && output_close(f, r->output) && fine;
}

/* ---- the command ---- */

static int bake(const nkw_document *d, void *data)
{
    const request *r = data;
    input_clips clips;
    if (!input_select(d, r->clip, &clips))
        return 0;
    if (clips.count != 1)
        return output_complain(d, NULL, "choose one clip");
    if (r->form == FORM_PALETTE)
        return bake_palette(d, clips.first, r);
    return r->form == FORM_REDUCED ? bake_reduced(d, clips.first, r) : bake_clip(d, clips.first, r);
}

static int check_request(const options *o, void *data)
{
    request *r = data;
    int form = r->as ? words_find(r->as, forms, FORMS) : FORM_CLIP;
    if (form < 0)
        return options_misuse(o, r->as, "not clip, compact, reduced or palette");
    r->form = (bake_form)form;
    if (r->form == FORM_PALETTE && !(r->rate > 0.0f && r->rate <= 1e6f))
        return options_misuse(o, "--rate", "needed for palettes, in 0..1000000");
    if (r->form != FORM_PALETTE && r->rate != 0.0f)
        return options_misuse(o, "--rate", "only with --as palette");
    if (!(r->tolerance == -1.0f || (r->tolerance >= 0.0f && r->tolerance < 1e30f)))
        return options_misuse(o, "--tolerance", "not a distance");
    return r->skin < 0 ? options_misuse(o, "--skin", "not a number of a skin") : COMMAND_FINE;
}

int command_bake(int argc, const char **argv)
{
    request r = {NULL, NULL, NULL, 0.0f, -1.0f, 0, FORM_CLIP};
    const struct poptOption known[] = {
        {"clip", 'c', POPT_ARG_STRING, &r.clip, 0, "number or name of the clip (default: 0)", "N"},
        {"as", 'a', POPT_ARG_STRING, &r.as, 0, "clip (default), compact, reduced or palette", "FORM"},
        {"tolerance", 't', POPT_ARG_FLOAT, &r.tolerance, 0,
         "distance in model space for reduced (default: 1/10000 of the model's size)", "D"},
        {"rate", 'r', POPT_ARG_FLOAT, &r.rate, 0, "frames per second of palettes, to the end of the clip", "R"},
        {"skin", 's', POPT_ARG_LONG, &r.skin, 0, "number of the skin of palettes (default: 0)", "N"},
        {"output", 'o', POPT_ARG_STRING, &r.output, 0, "write to FILE, not to the standard output", "FILE"},
        INPUT_STRICT,
        OPTIONS_END};
    static const command_steps steps = {check_request, bake};
    const int code = command_run(&text, known, argc, argv, &steps, &r);
    free(r.clip);
    free(r.as);
    free(r.output);
    return code;
}
