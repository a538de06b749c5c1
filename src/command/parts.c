/* SPDX-License-Identifier: MIT */
/* nakawari parts: skinned meshes cut into parts of few bones, as the JSON of the skin model converter. */
#include <errno.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "json.h"
#include "skinmodel.h"

static const options_text text = {
    "[OPTION...] FILE",
    "Cuts the triangles of each skinned mesh into parts of one material and at most N bones, and prints JSON:\n\n"
    "  skin_models.NAME.bones[]   name, parent (-1: none), matrix (bind pose, relative to the parent); parents\n"
    "                             first\n"
    "  skin_models.NAME.parts[]   bone (N bones), material (-1: none), vertexStride, vertex, index\n\n"
    "With --bones 2,4 a triangle is in a part of 2 bones if 2 suffice, otherwise in one of 4. A vertex is, for\n"
    "each bone of the part, its weight, and its position and normal in the space of the bone; then u and v of each\n"
    "set of texture coordinates of the mesh. With --space bind it is the N weights, then position and normal in\n"
    "the bind pose, then u and v. v is 0 at the upper edge of a picture, with --v up at the lower edge, as in a\n"
    "Collada file.\n\n"
    "The exit code is 1 if triangles need more bones: they are left out, and their number is reported.\n",
    "  nakawari parts fox.glb -o fox.json\n"
    "  nakawari parts --bones 16 --space bind fox.glb | jq '.skin_models[].parts | length'\n",
    1, 0};

enum { SIZES = 8, MOST_BONES = 1024 };

typedef struct request {
    char *bones, *space, *v, *output;
    size_t sizes[SIZES], size_count; /* ascending */
    int bind;
} request;

/* One partition: its mesh, which is what the one before rejected, and its result. */
typedef struct cut {
    nkw_partition_mesh mesh;
    nkw_partition parts;
    uint32_t *indices, *materials; /* owned, of the mesh; NULL for the first */
    size_t slots;
} cut;

/* A part of one of the cuts. */
typedef struct listed {
    const cut *from;
    size_t part;
} listed;

/* ---- cutting ---- */

static void free_cut(cut *c)
{
    free(c->parts.parts);
    free(c->parts.joints);
    free(c->parts.triangles);
    free(c->parts.indices);
    free(c->parts.vertices);
    free(c->parts.joint_slots);
    free(c->parts.weights);
    free(c->indices);
    free(c->materials);
}

/* The triangles that `before` rejected. */
static int take_rejected(cut *c, const cut *before)
{
    const size_t count = before->parts.rejected_count;
    c->mesh = before->mesh;
    c->indices = malloc((3 * count + 1) * sizeof *c->indices);
    c->materials = malloc((count + 1) * sizeof *c->materials);
    if (!c->indices || !c->materials)
        return 0;
    for (size_t i = 0; i < count; i++) {
        size_t t = before->parts.triangles[before->parts.triangle_count + i];
        memcpy(c->indices + 3 * i, before->mesh.indices + 3 * t, 3 * sizeof *c->indices);
        c->materials[i] = before->mesh.materials[t];
    }
    c->mesh.indices = c->indices;
    c->mesh.materials = c->materials;
    c->mesh.triangle_count = count;
    return 1;
}

/* NKW_TOO_SMALL also where the system has no memory. */
static nkw_result build(cut *c)
{
    const nkw_partition_sizes sizes = nkw_partition_bounds(&c->mesh, c->slots);
    const size_t limit = SIZE_MAX / 64, influences = c->mesh.influence_count;
    if (sizes.part_count > limit || sizes.joint_count > limit || sizes.vertex_count > limit || sizes.work_bytes > limit)
        return NKW_TOO_SMALL;
    const nkw_work work = {malloc(sizes.work_bytes + 1), sizes.work_bytes};
    nkw_partition *p = &c->parts;
    p->parts = malloc((sizes.part_count + 1) * sizeof *p->parts);
    p->joints = malloc((sizes.joint_count + 1) * sizeof *p->joints);
    p->triangles = malloc((c->mesh.triangle_count + 1) * sizeof *p->triangles);
    p->indices = malloc((3 * c->mesh.triangle_count + 1) * sizeof *p->indices);
    p->vertices = malloc((sizes.vertex_count + 1) * sizeof *p->vertices);
    p->joint_slots = malloc((sizes.vertex_count * influences + 1) * sizeof *p->joint_slots);
    p->weights = malloc((sizes.vertex_count * influences + 1) * sizeof *p->weights);
    nkw_result result = NKW_TOO_SMALL;
    if (work.data && p->parts && p->joints && p->triangles && p->indices && p->vertices && p->joint_slots && p->weights)
        result = nkw_partition_build(&c->mesh, c->slots, p, NULL, work);
    free(work.data);
    return result == NKW_TOO_MANY ? NKW_OK : result;
}

/* ---- output ---- */

static json_t *floats_to_json(const float *numbers, size_t count)
{
    json_t *list = json_array();
    for (size_t i = 0; i < count; i++)
        json_array_append_new(list, json_number((double)numbers[i]));
    return list;
}

static json_t *json_bones(const nkw_document *d, const skinmodel *s)
{
    json_t *list = json_array();
    for (size_t b = 0; b < s->bone_count; b++) {
        nkw_mat4 local = skinmodel_bind_local(s, b);
        json_array_append_new(list, json_pack("{s:o, s:i, s:o}", "name", json_text(d->nodes[s->joint_of_bone[b]].name),
                                              "parent", (int)s->parents[b], "matrix", floats_to_json(local.m, 16)));
    }
    return list;
}

static int contains(const uint16_t *joints, size_t count, size_t bone)
{
    size_t i = 0;
    while (i < count && joints[i] != bone)
        i++;
    return i < count;
}

/* The bones of a part; where there are fewer than slots, the first others, whose weights are 0. */
static json_t *part_bones(const listed *l, size_t bone_count)
{
    const nkw_part *part = &l->from->parts.parts[l->part];
    const uint16_t *joints = l->from->parts.joints + part->first_joint;
    json_t *list = json_array();
    for (size_t i = 0; i < part->joint_count; i++)
        json_array_append_new(list, json_integer(joints[i]));
    for (size_t b = 0; b < bone_count && json_array_size(list) < l->from->slots; b++)
        if (!contains(joints, part->joint_count, b))
            json_array_append_new(list, json_integer((json_int_t)b));
    while (json_array_size(list) < l->from->slots)
        json_array_append_new(list, json_integer(0));
    return list;
}

/* The vertices of a part with the weight of each slot, position and normal in the bind pose. */
static void bind_vertices(const skinmodel *s, const listed *l, float *out, size_t stride)
{
    const nkw_partition *p = &l->from->parts;
    const nkw_part *part = &p->parts[l->part];
    const size_t slots = l->from->slots, influences = l->from->mesh.influence_count;
    for (size_t i = 0; i < part->vertex_count; i++) {
        const size_t at = part->first_vertex + i, vertex = p->vertices[at];
        float *v = out + i * stride;
        for (size_t k = 0; k < influences; k++)
            if (p->weights[at * influences + k] != 0.0f)
                v[p->joint_slots[at * influences + k]] += p->weights[at * influences + k];
        memcpy(v + slots, &s->positions[vertex], sizeof s->positions[vertex]);
        memcpy(v + slots + 3, &s->normals[vertex], sizeof s->normals[vertex]);
    }
}

static json_t *part_vertices(const skinmodel *s, const listed *l, int bind, size_t stride)
{
    const nkw_partition *p = &l->from->parts;
    const nkw_part *part = &p->parts[l->part];
    const size_t slots = l->from->slots, before_uv = bind ? slots + 6 : 7 * slots;
    float *out = calloc(part->vertex_count * stride + 1, sizeof *out);
    if (!out)
        return NULL;
    if (bind) {
        bind_vertices(s, l, out, stride);
    } else {
        const nkw_partition_source source = {&l->from->mesh, s->inverse_bind, s->positions, s->normals};
        nkw_partition_vertices(p, l->part, &source, slots, out, stride);
    }
    const size_t uv = 2 * s->texcoord_count;
    for (size_t i = 0; i < part->vertex_count; i++)
        memcpy(out + i * stride + before_uv, s->texcoords + uv * (size_t)p->vertices[part->first_vertex + i],
               uv * sizeof *out);
    json_t *list = floats_to_json(out, part->vertex_count * stride);
    free(out);
    return list;
}

static json_t *json_part(const skinmodel *s, const listed *l, int bind)
{
    const nkw_part *part = &l->from->parts.parts[l->part];
    size_t stride = (bind ? l->from->slots + 6 : 7 * l->from->slots) + 2 * s->texcoord_count;
    json_t *index = json_array();
    for (size_t i = 0; i < 3 * (size_t)part->triangle_count; i++)
        json_array_append_new(index, json_integer(l->from->parts.indices[3 * (size_t)part->first_triangle + i]));
    return json_pack("{s:o, s:I, s:I, s:o, s:o}", "bone", part_bones(l, s->bone_count), "material",
                     (json_int_t)part->material - 1, "vertexStride", (json_int_t)stride, "vertex",
                     part_vertices(s, l, bind, stride), "index", index);
}

/* By material, then by bones. */
static int by_material(const void *a, const void *b)
{
    const listed *x = a, *y = b;
    const nkw_part *p = &x->from->parts.parts[x->part], *q = &y->from->parts.parts[y->part];
    if (p->material != q->material)
        return p->material < q->material ? -1 : 1;
    for (size_t i = 0; i < p->joint_count && i < q->joint_count; i++) {
        int bone = x->from->parts.joints[p->first_joint + i], other = y->from->parts.joints[q->first_joint + i];
        if (bone != other)
            return bone < other ? -1 : 1;
    }
    if (p->joint_count != q->joint_count)
        return p->joint_count < q->joint_count ? -1 : 1;
    return x->from->slots < y->from->slots ? -1 : x->from->slots > y->from->slots;
}

static json_t *json_parts(const skinmodel *s, const cut *cuts, size_t cut_count, int bind)
{
    size_t count = 0;
    for (size_t i = 0; i < cut_count; i++)
        count += cuts[i].parts.part_count;
    listed *all = malloc((count + 1) * sizeof *all);
    json_t *list = all ? json_array() : NULL;
    count = 0;
    for (size_t i = 0; all && i < cut_count; i++)
        for (size_t p = 0; p < cuts[i].parts.part_count; p++) {
            listed one = {&cuts[i], p};
            all[count++] = one;
        }
    if (all)
        qsort(all, count, sizeof *all, by_material);
    for (size_t i = 0; all && i < count; i++)
        json_array_append_new(list, json_part(s, &all[i], bind));
    free(all);
    return list;
}

/* ---- models ---- */

static int complain(const nkw_document *d, const char *name, const char *what)
{
    output_text(stderr, d->file);
    fputs(": ", stderr);
    output_text(stderr, name);
    fprintf(stderr, ": %s\n", what);
    return 0;
}

/* A name that the object does not have yet: that of the node, or with its number. */
static int add_model(json_t *models, const nkw_document_node *node, json_t *model)
{
    char name[512];
    snprintf(name, sizeof name, "%.400s", node->name);
    if (json_object_get(models, name))
        snprintf(name, sizeof name, "%.400s %zu", node->name, node->number);
    return json_object_set_new(models, name, model) == 0;
}

/* Counts the triangles that no part has. Returns 0 after an error. */
static int convert(const nkw_document *d, size_t joint, const request *r, json_t *models, size_t *rejected)
{
    skinmodel s;
    cut cuts[SIZES];
    nkw_result result = NKW_OK;
    size_t done = 0;
    memset(cuts, 0, sizeof cuts);
    int fine = skinmodel_open(&s, d, joint, r->sizes[r->size_count - 1]);
    cuts[0].mesh = s.mesh;
    for (; fine && result == NKW_OK && done < r->size_count; done++) {
        cuts[done].slots = r->sizes[done];
        result = !done || take_rejected(&cuts[done], &cuts[done - 1]) ? build(&cuts[done]) : NKW_TOO_SMALL;
    }
    if (fine && result != NKW_OK)
        fine = complain(d, d->nodes[joint].name, nkw_result_text(result));
    if (fine) {
        *rejected += cuts[done - 1].parts.rejected_count;
        fine = add_model(
            models, &d->nodes[joint],
            json_pack("{s:o, s:o}", "bones", json_bones(d, &s), "parts", json_parts(&s, cuts, done, r->bind)));
    }
    for (size_t i = 0; i < SIZES; i++)
        free_cut(&cuts[i]);
    skinmodel_free(&s);
    return fine;
}

static int run(const nkw_document *d, void *data)
{
    const request *r = data;
    json_t *models = json_object();
    size_t rejected = 0;
    int fine = 1, any = 0;
    for (size_t n = 0; fine && n < d->skeleton.joint_count; n++) {
        size_t joint = (size_t)d->joint_of_node[n];
        if (d->nodes[joint].mesh < 0 || d->nodes[joint].skin < 0)
            continue;
        any = 1;
        fine = convert(d, joint, r, models, &rejected);
    }
    if (fine && !any)
        fine = complain(d, "no node", "has a mesh and a skin");
    FILE *f = fine ? output_open(r->output) : NULL;
    if (!f) {
        json_decref(models);
        return 0;
    }
    fine = json_put_lines(f, json_pack("{s:o}", "skin_models", models));
    fine = output_close(f, r->output) && fine;
    if (rejected)
        fprintf(stderr, "%s: %zu %s of more than %zu %s: left out\n", d->file, COUNT(rejected, "triangle", "triangles"),
                COUNT(r->sizes[r->size_count - 1], "bone", "bones"));
    return fine && !rejected;
}

/* ---- the command ---- */

/* Numbers of bones, ascending, with commas. */
static int read_sizes(request *r)
{
    const char *at = r->bones ? r->bones : "2,4";
    for (r->size_count = 0; r->size_count < SIZES;) {
        char *end;
        errno = 0;
        unsigned long size = strtoul(at, &end, 10);
        if (end == at || errno || size < 1 || size > MOST_BONES || *at == '-' ||
            (r->size_count && size <= r->sizes[r->size_count - 1]))
            return 0;
        r->sizes[r->size_count++] = size;
        if (!*end)
            return 1;
        if (*end != ',')
            return 0;
        at = end + 1;
    }
    return 0;
}

static int check_request(const options *o, void *data)
{
    request *r = data;
    static const char *const spaces[] = {"bone", "bind"};
    int space = r->space ? words_find(r->space, spaces, 2) : 0;
    if (space < 0)
        return options_misuse(o, r->space, "not bone or bind");
    r->bind = space;
    if (!input_set_v(r->v))
        return options_misuse(o, r->v, "not down or up");
    return read_sizes(r) ? COMMAND_FINE : options_misuse(o, "--bones", "not ascending numbers in 1..1024: 2,4");
}

int command_parts(int argc, const char **argv)
{
    request r;
    memset(&r, 0, sizeof r);
    const struct poptOption known[] = {
        {"bones", 'b', POPT_ARG_STRING, &r.bones, 0, "the most bones of a part, or ascending numbers (default: 2,4)",
         "N,..."},
        {"space", 0, POPT_ARG_STRING, &r.space, 0, "space of the vertices: bone (default) or bind", "SPACE"},
        INPUT_V(&r.v),
        {"output", 'o', POPT_ARG_STRING, &r.output, 0, "write to FILE, not to the standard output", "FILE"},
        OPTIONS_END};
    static const command_steps steps = {check_request, run};
    const int code = command_run(&text, known, argc, argv, &steps, &r);
    free(r.bones);
    free(r.space);
    free(r.v);
    free(r.output);
    return code;
}
