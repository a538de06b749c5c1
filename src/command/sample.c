/* SPDX-License-Identifier: MIT */
/* nakawari sample: poses, matrices and vertices at times. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "moment.h"
#include "progress.h"
#include "table.h"
#include "timelist.h"

typedef enum sample_what { WHAT_LOCAL, WHAT_MODEL, WHAT_PALETTE, WHAT_VERTICES, WHAT_WEIGHTS, WHATS } sample_what;

static const char *const what_words[WHATS] = {"local", "model", "palette", "vertices", "weights"};
#define MATRIX_COLUMNS "m0,m1,m2,m3,m4,m5,m6,m7,m8,m9,m10,m11,m12,m13,m14,m15"
static const char *const what_columns[WHATS] = {"tx,ty,tz,qx,qy,qz,qw,sx,sy,sz", MATRIX_COLUMNS, MATRIX_COLUMNS,
                                                "x,y,z,nx,ny,nz", "weight"};
static const size_t what_widths[WHATS] = {10, 16, 16, 6, 1};

/* The command line. */
typedef struct request {
    char *clip, *at, *what, *output;
    float rate;
    int json, raw;
    sample_what kind;
} request;

#define NO_RATE (-1e30f) /* without --rate */

static const options_text text = {
    "[OPTION...] FILE",
    "Samples a clip of FILE (- reads the standard input) and prints a line for each node, joint or vertex:\n"
    "clip, time, index, name, and the numbers.\n\n"
    "  local     translation, rotation x y z w, scale of each node; index: the node in the file\n"
    "  model     the matrix from the node's space to the model's, column by column\n"
    "  palette   the joint matrix (model * inverse bind) of each joint of the skins; index: the joint in the skin,\n"
    "            continued over all skins; name: that of the joint\n"
    "  vertices  position and normal of each morphed and skinned vertex, in model space, mesh by mesh in the order of\n"
    "            the nodes; index: counted over all of them; name: that of the mesh's node\n"
    "  weights   the morph weights of each node\n",
    "  nakawari sample fox.glb --clip 1 --at 0,0.5 --what model\n"
    "  nakawari sample fox.glb --clip Walk --rate 30 --json > walk.json\n"
    "  nakawari sample - --clip all --rate 60 --what palette --raw -o palettes.bin < fox.glb\n",
    1, 0};

/* ---- rows ---- */

static void local_rows(const moment *m, table *t)
{
    for (size_t n = 0; n < m->document->skeleton.joint_count; n++) {
        int32_t joint = m->document->joint_of_node[n];
        nkw_trs trs = nkw_pose_get(moment_pose(m), (size_t)joint);
        float numbers[10] = {trs.translation.x, trs.translation.y, trs.translation.z, trs.rotation.x, trs.rotation.y,
                             trs.rotation.z,    trs.rotation.w,    trs.scale.x,       trs.scale.y,    trs.scale.z};
        table_row(t, n, m->document->nodes[joint].name, numbers);
    }
}

static void model_rows(const moment *m, table *t)
{
    for (size_t n = 0; n < m->document->skeleton.joint_count; n++) {
        int32_t joint = m->document->joint_of_node[n];
        table_row(t, n, m->document->nodes[joint].name, m->models[joint].m);
    }
}

static void palette_rows(moment *m, table *t)
{
    size_t index = 0;
    for (size_t s = 0; s < m->document->skin_count; s++) {
        const nkw_document_skin *skin = &m->document->skins[s];
        moment_palette(m, s);
        for (size_t i = 0; i < skin->joint_count; i++)
            table_row(t, index++, m->document->nodes[skin->joints[i]].name, m->palette[i].m);
    }
}

static const nkw_document_mesh *mesh_of_node(const nkw_document *d, size_t node)
{
    int32_t mesh = d->nodes[d->joint_of_node[node]].mesh;
    return mesh < 0 ? NULL : &d->meshes[mesh];
}

static void vertex_rows(moment *m, table *t)
{
    size_t index = 0;
    for (size_t n = 0; n < m->document->skeleton.joint_count; n++) {
        const nkw_document_mesh *mesh = mesh_of_node(m->document, n);
        size_t joint = (size_t)m->document->joint_of_node[n];
        for (size_t p = 0; mesh && p < mesh->primitive_count; p++) {
            moment_vertices(m, joint, p);
            for (size_t v = 0; v < mesh->primitives[p].vertex_count; v++) {
                nkw_vec3 at = m->positions[v], up = m->normals[v];
                float numbers[6] = {at.x, at.y, at.z, up.x, up.y, up.z};
                table_row(t, index++, m->document->nodes[joint].name, numbers);
            }
        }
    }
}

static void weight_rows(const moment *m, table *t)
{
    size_t index = 0;
    for (size_t n = 0; n < m->document->skeleton.joint_count; n++) {
        const nkw_document_node *node = &m->document->nodes[m->document->joint_of_node[n]];
        const nkw_document_mesh *mesh = mesh_of_node(m->document, n);
        for (size_t k = 0; k < node->float_count; k++) {
            t->target = mesh && k < mesh->target_count ? mesh->target_names[k] : "";
            table_row(t, index++, node->name, &m->floats[node->float_first + k]);
        }
    }
}

static size_t count_rows(const nkw_document *d, sample_what what)
{
    size_t count = 0;
    if (what == WHAT_LOCAL || what == WHAT_MODEL)
        return d->skeleton.joint_count;
    if (what == WHAT_WEIGHTS)
        return d->float_count;
    if (what == WHAT_PALETTE)
        for (size_t s = 0; s < d->skin_count; s++)
            count += d->skins[s].joint_count;
    for (size_t n = 0; what == WHAT_VERTICES && n < d->skeleton.joint_count; n++) {
        const nkw_document_mesh *mesh = mesh_of_node(d, n);
        for (size_t p = 0; mesh && p < mesh->primitive_count; p++)
            count += mesh->primitives[p].vertex_count;
    }
    return count;
}

static void sample_at(moment *m, sample_what what, float time, table *t)
{
    moment_at(m, time);
    table_time(t, time);
    switch (what) {
    case WHAT_LOCAL:
        local_rows(m, t);
        break;
    case WHAT_MODEL:
        model_rows(m, t);
        break;
    case WHAT_PALETTE:
        palette_rows(m, t);
        break;
    case WHAT_VERTICES:
        vertex_rows(m, t);
        break;
    default:
        weight_rows(m, t);
    }
}

/* ---- times ---- */

static int sample_clip(moment *m, size_t animation, const request *r, table *t)
{
    size_t count = r->at ? timelist_count(r->at) : moment_rate_count(m, r->rate);
    if (count > INT32_MAX || t->rows_per_time > INT32_MAX) {
        fprintf(stderr, "%s: clip %ld: too many times at this rate\n", m->document->file, input_clip_number(animation));
        return 0;
    }
    const char *list = r->at;
    table_clip(t, input_clip_number(animation), count);
    progress p = progress_begin("sampling time", count, t->file);
    for (size_t k = 0; k < count && !ferror(t->file) && !t->failed; k++) {
        float time = 0.0f;
        progress_at(&p, k);
        if (r->at)
            timelist_next(&list, &time);
        else
            time = moment_rate_time(m, r->rate, k);
        sample_at(m, r->kind, time, t);
    }
    progress_end(&p);
    return !t->failed;
}

/* ---- the command ---- */

static int sample_document(const nkw_document *d, const request *r, FILE *f)
{
    input_clips clips;
    table_format format = r->json ? TABLE_JSON : r->raw ? TABLE_RAW : TABLE_CSV;
    table t = {f, format, what_words[r->kind], what_columns[r->kind], (int)r->kind, what_widths[r->kind], 0,
               r->kind == WHAT_WEIGHTS, "", 0, 0.0f, 0, 0};
    if (!input_select(d, r->clip, &clips))
        return 0;
    t.rows_per_time = count_rows(d, r->kind);
    int fine = 1;
    for (size_t i = 0; fine && i < clips.count; i++) {
        moment m;
        size_t animation = clips.first == INPUT_REST ? INPUT_REST : clips.first + i;
        fine = moment_open(&m, d, animation);
        if (fine && i == 0)
            table_begin(&t, d->file);
        fine = fine && sample_clip(&m, animation, r, &t);
        moment_close(&m);
    }
    if (fine)
        table_end(&t);
    return fine;
}

static int check_request(const options *o, void *data)
{
    request *r = data;
    int kind = r->what ? words_find(r->what, what_words, WHATS) : WHAT_LOCAL;
    if (kind < 0)
        return options_misuse(o, r->what, "not local, model, palette, vertices or weights");
    r->kind = (sample_what)kind;
    static const char *const end[] = {"json"};
    r->json |= !r->raw && output_ending(r->output, end, 1) == 0;
    if (r->json && r->raw)
        return options_misuse(o, "--raw", "not with --json");
    if (!r->at && r->rate == NO_RATE)
        return options_misuse(o, "--at, --rate", "one of them is needed");
    if (r->at && r->rate != NO_RATE)
        return options_misuse(o, "--at, --rate", "only one of them");
    if (r->at && !timelist_count(r->at))
        return options_misuse(o, r->at, "not a list of times: 0,0.5,1");
    if (!r->at && !(r->rate > 0.0f && r->rate <= 1e6f))
        return options_misuse(o, "--rate", "not above 0 and up to 1000000");
    return COMMAND_FINE;
}

static int run(const nkw_document *d, void *data)
{
    const request *r = data;
    FILE *f = output_open(r->output);
    int fine = f && sample_document(d, r, f);
    if (f)
        fine &= output_close(f, r->output);
    return fine;
}

int command_sample(int argc, const char **argv)
{
    request r = {NULL, NULL, NULL, NULL, NO_RATE, 0, 0, WHAT_LOCAL};
    const struct poptOption known[] = {
        {"clip", 'c', POPT_ARG_STRING, &r.clip, 0, "number or name of the clip, all, or rest (default: 0)", "N"},
        {"at", 't', POPT_ARG_STRING, &r.at, 0, "times in seconds", "T,T,..."},
        {"rate", 'r', POPT_ARG_FLOAT, &r.rate, 0, "samples per second from the start of the clip to its end", "R"},
        {"what", 'w', POPT_ARG_STRING, &r.what, 0, "local (default), model, palette, vertices or weights", "WHAT"},
        {"json", 0, POPT_ARG_NONE, &r.json, 0, "print JSON in place of CSV; also if --output ends with .json", NULL},
        {"raw", 0, POPT_ARG_NONE, &r.raw, 0, "write bytes: the header of docs/command.md, then floats", NULL},
        {"output", 'o', POPT_ARG_STRING, &r.output, 0, "write to FILE, not to the standard output", "FILE"},
        INPUT_STRICT,
        OPTIONS_END};
    static const command_steps steps = {check_request, run};
    const int code = command_run(&text, known, argc, argv, &steps, &r);
    free(r.clip);
    free(r.at);
    free(r.what);
    free(r.output);
    return code;
}
