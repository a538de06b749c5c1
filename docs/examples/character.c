/* SPDX-License-Identifier: MIT */
/**
 * @file
 * nakawari-character: writes the mannequin, its skins and its clips as a binary glTF file. It has two meshes on two
 * skins, a morph target in a sparse accessor, normalised integers, and channels of every mode and path.
 */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/mat.h>
#include <nakawari/vec.h>

#include "glb.h"
#include "mannequin.h"
#include "options.h"

/* Exit codes. */
enum { DONE, NOT_WRITTEN, MISUSED };
/* Nodes: the root, two meshes, then the joints. */
enum { NODE_ROOT, NODE_BODY, NODE_FACE, NODE_JOINTS };
enum { SKIN_BODY, SKIN_FACE };

static const char usage[] = "usage: nakawari-character [--out FILE]\n"
                            "Writes a small animated character as a binary glTF file.\n"
                            "\n"
                            "  --out FILE    the file (default character.glb)\n"
                            "  -h, --help    print this\n";

static const char *const materials[MANNEQUIN_PARTS] = {
    "{\"name\":\"body\",\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.25,0.45,0.7,1],\"metallicFactor\":0}}",
    "{\"name\":\"shoes\",\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.75,0.3,0.2,1],\"metallicFactor\":0}}",
    "{\"name\":\"face\",\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.9,0.75,0.6,1],\"metallicFactor\":0}}",
    "{\"name\":\"eyes\",\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.1,0.1,0.12,1],\"metallicFactor\":0}}",
};

static int is_face(enum mannequin_part part)
{
    return part == PART_FACE || part == PART_EYES;
}

/* ---- Meshes ---- */

/* The smallest and the largest components, which glTF asks for. */
static void print_bounds(char *to, size_t room, const nkw_vec3 *v, size_t count)
{
    nkw_vec3 low = v[0], high = v[0];
    for (size_t i = 1; i < count; i++) {
        low = nkw_vec3_min(low, v[i]);
        high = nkw_vec3_max(high, v[i]);
    }
    snprintf(to, room, ",\"min\":[%.9g,%.9g,%.9g],\"max\":[%.9g,%.9g,%.9g]", (double)low.x, (double)low.y,
             (double)low.z, (double)high.x, (double)high.y, (double)high.z);
}

/* The vertices of a mesh as separate arrays. */
typedef struct arrays {
    nkw_vec3 *positions, *normals, *moves, *moved;
    uint16_t *weights, *indices, *changed;
    uint8_t *joints;
    size_t changed_count;
} arrays;

static void free_arrays(arrays *a)
{
    free(a->positions);
    free(a->normals);
    free(a->moves);
    free(a->moved);
    free(a->weights);
    free(a->indices);
    free(a->changed);
    free(a->joints);
}

static int fill_arrays(arrays *a, const mesh *m, enum mannequin_part part)
{
    const size_t n = m->vertex_count;
    a->positions = malloc(n * sizeof *a->positions);
    a->normals = malloc(n * sizeof *a->normals);
    a->moves = calloc(n, sizeof *a->moves);
    a->moved = malloc(n * sizeof *a->moved);
    a->weights = malloc(n * 4 * sizeof *a->weights);
    a->indices = malloc(m->face_count * 3 * sizeof *a->indices);
    a->changed = malloc(n * sizeof *a->changed);
    a->joints = malloc(n * 4);
    a->changed_count = 0;
    if (!a->positions || !a->normals || !a->moves || !a->moved || !a->weights || !a->indices || !a->changed ||
        !a->joints)
        return 0;
    for (size_t i = 0; i < n; i++) {
        a->positions[i] = m->vertices[i].position;
        a->normals[i] = m->vertices[i].normal;
        for (size_t e = 0; e < 4; e++) {
            a->weights[4 * i + e] = m->vertices[i].weights[e];
            a->joints[4 * i + e] = (uint8_t)(is_face(part) || !a->weights[4 * i + e] ? 0 : m->vertices[i].joints[e]);
        }
    }
    for (size_t f = 0; f < m->face_count * 3; f++)
        a->indices[f] = (uint16_t)m->faces[f / 3].corner[f % 3];
    if (part == PART_FACE)
        mannequin_puff(m, a->moves);
    for (size_t i = 0; i < n; i++)
        if (nkw_vec3_length(a->moves[i]) > 0.0f) {
            a->moved[a->changed_count] = a->moves[i];
            a->changed[a->changed_count++] = (uint16_t)i;
        }
    return 1;
}

static void print_primitive(glb *g, glb_bytes *out, const arrays *a, const mesh *m, enum mannequin_part part)
{
    static const glb_layout vec3 = {GLB_F32, "VEC3", 0}, bytes = {GLB_U8, "VEC4", 0}, shares = {GLB_U16, "VEC4", 1},
                            index = {GLB_U16, "SCALAR", 0};
    const size_t n = m->vertex_count;
    char bounds[256];
    print_bounds(bounds, sizeof bounds, a->positions, n);
    size_t position = glb_accessor(g, vec3, n, a->positions, n * sizeof *a->positions, bounds);
    size_t normal = glb_accessor(g, vec3, n, a->normals, n * sizeof *a->normals, "");
    size_t joints = glb_accessor(g, bytes, n, a->joints, n * 4, "");
    size_t weights = glb_accessor(g, shares, n, a->weights, n * 8, "");
    size_t indices = glb_accessor(g, index, 3 * m->face_count, a->indices, 3 * m->face_count * sizeof *a->indices, "");
    glb_print(out,
              "{\"attributes\":{\"POSITION\":%zu,\"NORMAL\":%zu,\"JOINTS_0\":%zu,\"WEIGHTS_0\":%zu},"
              "\"indices\":%zu,\"material\":%d",
              position, normal, joints, weights, indices, (int)part);
    if (is_face(part)) {
        print_bounds(bounds, sizeof bounds, a->moves, n);
        size_t target = glb_sparse_vec3(g, n, a->changed_count, a->changed, &a->moved[0].x, bounds);
        glb_print(out, ",\"targets\":[{\"POSITION\":%zu}]", target);
    }
    glb_print(out, "}");
}

static void add_primitive(glb *g, glb_bytes *out, enum mannequin_part part)
{
    mesh m;
    arrays a = {0};
    if (mannequin_mesh(&m, part) && fill_arrays(&a, &m, part))
        print_primitive(g, out, &a, &m, part);
    else
        out->failed = 1;
    free_arrays(&a);
    mesh_free(&m);
}

static void print_meshes(glb *g, glb_bytes *out)
{
    glb_print(out, "\"meshes\":[{\"name\":\"body\",\"primitives\":[");
    add_primitive(g, out, PART_BODY);
    glb_print(out, ",");
    add_primitive(g, out, PART_SHOES);
    glb_print(out, "]},{\"name\":\"face\",\"primitives\":[");
    add_primitive(g, out, PART_FACE);
    glb_print(out, ",");
    add_primitive(g, out, PART_EYES);
    glb_print(out, "],\"weights\":[0],\"extras\":{\"targetNames\":[\"puff\"]}}]");
}

/* ---- Nodes and skins ---- */

static void print_joint(glb_bytes *out, int joint)
{
    const mannequin_bone *b = &mannequin_bones[joint];
    const char *before = ",\"children\":[";
    glb_print(out, ",{\"name\":\"%s\",\"translation\":[%.9g,%.9g,%.9g]", b->name, (double)b->translation.x,
              (double)b->translation.y, (double)b->translation.z);
    for (int child = 0; child < MANNEQUIN_JOINTS; child++)
        if (mannequin_bones[child].parent == joint) {
            glb_print(out, "%s%d", before, NODE_JOINTS + child);
            before = ",";
        }
    glb_print(out, *before == ',' && before[1] == '\0' ? "]}" : "}");
}

static void print_nodes(glb_bytes *out)
{
    glb_print(out, "\"scene\":0,\"scenes\":[{\"nodes\":[%d]}],", NODE_ROOT);
    glb_print(out, "\"nodes\":[{\"name\":\"mannequin\",\"children\":[%d,%d,%d]}", NODE_BODY, NODE_FACE, NODE_JOINTS);
    glb_print(out, ",{\"name\":\"body\",\"mesh\":0,\"skin\":%d}", SKIN_BODY);
    glb_print(out, ",{\"name\":\"face\",\"mesh\":1,\"skin\":%d}", SKIN_FACE);
    for (int joint = 0; joint < MANNEQUIN_JOINTS; joint++)
        print_joint(out, joint);
    glb_print(out, "]");
}

/* Inverse bind matrices of the joints from..to - 1: no joint is rotated in the bind pose. */
static void print_skin(glb *g, glb_bytes *out, const char *name, int from, int to)
{
    static const glb_layout mat4 = {GLB_F32, "MAT4", 0};
    nkw_mat4 inverse[MANNEQUIN_JOINTS];
    const size_t count = (size_t)(to - from);
    for (int j = from; j < to; j++) {
        const nkw_mat3 one = nkw_mat3_identity();
        inverse[j - from] = nkw_mat4_from_mat3(&one, nkw_vec3_scale(mannequin_place(j), -1.0f));
    }
    size_t binds = glb_accessor(g, mat4, count, inverse, count * sizeof *inverse, "");
    glb_print(out, "{\"name\":\"%s\",\"skeleton\":%d,\"inverseBindMatrices\":%zu,\"joints\":[", name, NODE_JOINTS,
              binds);
    for (int j = from; j < to; j++)
        glb_print(out, "%s%d", j > from ? "," : "", NODE_JOINTS + j);
    glb_print(out, "]}");
}

/* ---- Animations ---- */

/* A channel's times: those of an earlier channel of the clip, if they are the same. */
static size_t times_accessor(glb *g, const mannequin_clip *c, size_t channel, const size_t *earlier)
{
    static const glb_layout scalar = {GLB_F32, "SCALAR", 0};
    const mannequin_channel *ch = &c->channels[channel];
    for (size_t i = 0; i < channel; i++)
        if (c->channels[i].key_count == ch->key_count &&
            memcmp(c->channels[i].times, ch->times, ch->key_count * sizeof *ch->times) == 0)
            return earlier[i];
    char bounds[128];
    snprintf(bounds, sizeof bounds, ",\"min\":[%.9g],\"max\":[%.9g]", (double)ch->times[0],
             (double)ch->times[ch->key_count - 1]);
    return glb_accessor(g, scalar, ch->key_count, ch->times, ch->key_count * sizeof *ch->times, bounds);
}

static void print_sampler(glb *g, glb_bytes *out, const mannequin_channel *ch, size_t input)
{
    static const char *const modes[] = {
        [NKW_INTERPOLATION_STEP] = "STEP",
        [NKW_INTERPOLATION_LINEAR] = "LINEAR",
        [NKW_INTERPOLATION_CUBICSPLINE] = "CUBICSPLINE",
    };
    const size_t count = ch->key_count * (ch->mode == NKW_INTERPOLATION_CUBICSPLINE ? 3 : 1);
    const glb_layout layout = {GLB_F32, ch->width == 4 ? "VEC4" : ch->width == 3 ? "VEC3" : "SCALAR", 0};
    size_t output = glb_accessor(g, layout, count, ch->values, count * ch->width * sizeof *ch->values, "");
    glb_print(out, "{\"input\":%zu,\"output\":%zu,\"interpolation\":\"%s\"}", input, output, modes[ch->mode]);
}

static void print_animation(glb *g, glb_bytes *out, const mannequin_clip *c)
{
    static const char *const paths[] = {"translation", "rotation", "scale", "weights"};
    size_t inputs[CLIP_CHANNELS];
    glb_print(out, "{\"name\":\"%s\",\"samplers\":[", c->name);
    for (size_t i = 0; i < c->channel_count; i++) {
        inputs[i] = times_accessor(g, c, i, inputs);
        glb_print(out, i ? "," : "");
        print_sampler(g, out, &c->channels[i], inputs[i]);
    }
    glb_print(out, "],\"channels\":[");
    for (size_t i = 0; i < c->channel_count; i++) {
        const mannequin_channel *ch = &c->channels[i];
        const int node = ch->path == PATH_PUFF ? NODE_FACE : NODE_JOINTS + ch->joint;
        glb_print(out, "%s{\"sampler\":%zu,\"target\":{\"node\":%d,\"path\":\"%s\"}}", i ? "," : "", i, node,
                  paths[ch->path]);
    }
    glb_print(out, "]}");
}

/* ---- The file ---- */

static void print_all(glb *g, glb_bytes *json)
{
    static mannequin_clip clips[MANNEQUIN_CLIPS];
    mannequin_clips(clips);
    glb_print(json, "{\"asset\":{\"version\":\"2.0\",\"generator\":\"nakawari-character\"},");
    print_nodes(json);
    glb_print(json, ",");
    print_meshes(g, json);
    glb_print(json, ",\"materials\":[");
    for (int i = 0; i < MANNEQUIN_PARTS; i++)
        glb_print(json, "%s%s", i ? "," : "", materials[i]);
    glb_print(json, "],\"skins\":[");
    print_skin(g, json, "body", 0, MANNEQUIN_JOINTS);
    glb_print(json, ",");
    print_skin(g, json, "face", HEAD, HEAD + 1);
    glb_print(json, "],\"animations\":[");
    for (size_t i = 0; i < MANNEQUIN_CLIPS; i++) {
        glb_print(json, i ? "," : "");
        print_animation(g, json, &clips[i]);
    }
    glb_print(json, "],\"accessors\":[");
    glb_append(json, g->accessors.data, g->accessors.size);
    glb_print(json, "],\"bufferViews\":[");
    glb_append(json, g->views.data, g->views.size);
    glb_print(json, "],\"buffers\":[{\"byteLength\":%zu}]}", g->buffer.size);
    json->failed = json->failed || g->accessors.failed || g->views.failed;
}

int main(int argc, char **argv)
{
    const char *path = "character.glb";
    int help = 0;
    const option known[] = {{"--out", OPTION_TEXT, &path, 0, 0, NULL}};
    if (!options_read("nakawari-character", known, sizeof known / sizeof *known, argc, argv, &help))
        return MISUSED;
    if (help) {
        fputs(usage, stdout);
        return DONE;
    }
    glb g = {0};
    glb_bytes json = {NULL, 0, 0, 0};
    print_all(&g, &json);
    int written = glb_write(path, &json, &g.buffer);
    if (!written)
        fprintf(stderr, "nakawari-character: cannot write %s: %s\n", path, strerror(errno));
    glb_free(&json);
    glb_free(&g.buffer);
    glb_free(&g.views);
    glb_free(&g.accessors);
    if (written)
        printf("wrote %s\n", path);
    return written ? DONE : NOT_WRITTEN;
}
