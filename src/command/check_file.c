/* SPDX-License-Identifier: MIT */
/* What the document does not have of a glTF file: matrices of animated nodes, roots of skins, bounds, outer images. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "json.h"

/* The tree of a glTF file: the first chunk of a GLB, or the text. NULL if it is none. */
static json_t *read_tree(const void *data, size_t bytes)
{
    const unsigned char *at = data;
    json_error_t error;
    if (bytes >= 20 && memcmp(at, "glTF", 4) == 0) {
        const size_t length = (size_t)at[12] | (size_t)at[13] << 8 | (size_t)at[14] << 16 | (size_t)at[15] << 24;
        return length <= bytes - 20 ? json_loadb((const char *)at + 20, length, JSON_ALLOW_NUL, &error) : NULL;
    }
    const size_t mark = bytes >= 3 && memcmp(at, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
    return json_loadb((const char *)at + mark, bytes - mark, JSON_ALLOW_NUL, &error);
}

static const json_t *element(const json_t *root, const char *list, size_t index)
{
    return json_array_get(json_object_get(root, list), index);
}

static size_t index_of(const json_t *object, const char *key)
{
    const json_t *value = json_object_get(object, key);
    return json_is_integer(value) && json_integer_value(value) >= 0 ? (size_t)json_integer_value(value) : SIZE_MAX;
}

/* ---- nodes ---- */

/* glTF 2.0, 3.11: a node that is animated has no matrix. */
static void check_matrices(check *c, const json_t *root)
{
    const nkw_document *d = c->document;
    unsigned char *seen = calloc(d->skeleton.joint_count, 1);
    c->found.failed |= !seen;
    for (size_t a = 0; seen && a < d->animation_count; a++)
        for (size_t i = 0; i < d->animations[a].track_count; i++) {
            const int32_t joint = d->animations[a].channels[i].joint;
            const nkw_document_node *node = &d->nodes[joint];
            finding f = check_finding_at(SEVERITY_ERROR, "animated-matrix", "node", node->name, node->number);
            snprintf(f.detail, sizeof f.detail, "it has a matrix, and clip %zu animates it", a);
            if (d->animations[a].tracks[i].target == NKW_CLIP_FLOATS || seen[joint]++ ||
                !json_object_get(element(root, "nodes", node->number), "matrix"))
                continue;
            findings_add(&c->found, &f);
        }
    free(seen);
}

static int is_below(const nkw_document *d, int32_t joint, int32_t root)
{
    while (joint != NKW_NO_JOINT && joint != root)
        joint = d->skeleton.parents[joint];
    return joint == root;
}

static void check_skeletons(check *c, const json_t *root)
{
    const nkw_document *d = c->document;
    for (size_t s = 0; s < d->skin_count; s++) {
        const size_t number = index_of(element(root, "skins", s), "skeleton");
        if (number >= d->skeleton.joint_count)
            continue;
        const int32_t top = d->joint_of_node[number];
        for (size_t i = 0; i < d->skins[s].joint_count; i++) {
            finding f = check_finding_at(SEVERITY_WARNING, "wrong-skeleton", "skin", d->skins[s].name, s);
            snprintf(f.detail, sizeof f.detail, "joint %.60s is not below its skeleton, %.60s",
                     d->nodes[d->skins[s].joints[i]].name, d->nodes[top].name);
            if (is_below(d, d->skins[s].joints[i], top))
                continue;
            findings_add(&c->found, &f);
            break;
        }
    }
}

/* ---- bounds ---- */

/* How far min and max of an accessor of floats are from those of its numbers, beyond rounding; 0 without them. */
static double bounds_off(const json_t *accessor, const float *values, size_t width, size_t count)
{
    double off = 0.0;
    for (size_t i = 0; i < width; i++) {
        const json_t *low = json_array_get(json_object_get(accessor, "min"), i);
        const json_t *high = json_array_get(json_object_get(accessor, "max"), i);
        double least = (double)INFINITY, most = -(double)INFINITY;
        for (size_t k = 0; k < count; k++) {
            least = fmin(least, (double)values[k * width + i]);
            most = fmax(most, (double)values[k * width + i]);
        }
        const double slack = 1e-5 * fmax(fabs(least), fabs(most)) + 1e-6;
        if (json_is_number(low) && fabs(json_number_value(low) - least) > slack)
            off = fmax(off, fabs(json_number_value(low) - least));
        if (json_is_number(high) && fabs(json_number_value(high) - most) > slack)
            off = fmax(off, fabs(json_number_value(high) - most));
    }
    return off;
}

static void add_bounds(check *c, finding f, size_t accessor, double off)
{
    f.level = SEVERITY_WARNING;
    f.amount = off;
    snprintf(f.detail, sizeof f.detail, "min or max of accessor %zu is %.3g from its numbers", accessor, off);
    if (off > 0.0)
        findings_add(&c->found, &f);
}

/* The accessor, if its numbers are floats and as many as were read. */
static const json_t *floats_of(const json_t *root, size_t index, size_t count)
{
    const json_t *accessor = element(root, "accessors", index);
    return index_of(accessor, "componentType") == 5126 && index_of(accessor, "count") == count ? accessor : NULL;
}

static void check_times_bounds(check *c, const json_t *root, size_t animation)
{
    const nkw_document_animation *a = &c->document->animations[animation];
    for (size_t i = 0; i < a->track_count; i++) {
        const nkw_track *t = &a->tracks[i].track;
        const size_t input = a->channels[i].input;
        if (i > 0 && a->channels[i - 1].input == input)
            continue;
        add_bounds(c, check_finding(c, animation, i, -1, SEVERITY_WARNING, "wrong-bounds"), input,
                   bounds_off(floats_of(root, input, t->count), t->times, 1, t->count));
    }
}

static void check_mesh_bounds(check *c, const json_t *root, size_t mesh)
{
    const nkw_document_mesh *m = &c->document->meshes[mesh];
    const json_t *list = json_object_get(element(root, "meshes", mesh), "primitives");
    for (size_t k = 0; k < m->primitive_count && json_array_size(list) == m->primitive_count; k++) {
        const nkw_document_primitive *p = &m->primitives[k];
        const size_t index = index_of(json_object_get(json_array_get(list, k), "attributes"), "POSITION");
        const json_t *accessor = floats_of(root, index, p->vertex_count);
        if (p->positions)
            add_bounds(c, check_finding_at(SEVERITY_WARNING, "wrong-bounds", "mesh", m->name, mesh), index,
                       bounds_off(accessor, &p->positions[0].x, 3, p->vertex_count));
    }
}

/* ---- images ---- */

static int digit(char d)
{
    static const char digits[] = "0123456789abcdefABCDEF";
    const char *at = d ? strchr(digits, d) : NULL;
    const int place = at ? (int)(at - digits) : -1;
    return place < 16 ? place : place - 6;
}

/* A URI without its percent signs, to be freed. */
static char *path_of(const char *uri)
{
    char *path = malloc(strlen(uri) + 1), *to = path;
    for (; path && *uri; uri++) {
        const int high = *uri == '%' ? digit(uri[1]) : -1, low = high < 0 ? -1 : digit(uri[2]);
        *to++ = low < 0 ? *uri : (char)(16 * high + low);
        uri += low < 0 ? 0 : 2;
    }
    if (path)
        *to = 0;
    return path;
}

static void check_uris(check *c, const json_t *root)
{
    const json_t *images = json_object_get(root, "images");
    for (size_t i = 0; i < json_array_size(images); i++) {
        const char *uri = json_string_value(json_object_get(json_array_get(images, i), "uri"));
        size_t bytes = 0;
        if (!uri || strncmp(uri, "data:", 5) == 0 || strstr(uri, "://"))
            continue;
        char *path = path_of(uri);
        unsigned char *data = path ? input_read_beside(c->document, path, &bytes) : NULL;
        finding f = check_finding_at(SEVERITY_WARNING, "absent-image", "image", NULL, i);
        snprintf(f.detail, sizeof f.detail, "image %zu: %.100s cannot be read", i, path ? path : "");
        if (!data)
            findings_add(&c->found, &f);
        free(data);
        free(path);
    }
}

void check_file(check *c)
{
    if (strcmp(c->document->format, "glTF 2.0") != 0)
        return;
    json_t *root = read_tree(c->data, c->bytes);
    check_matrices(c, root);
    check_skeletons(c, root);
    for (size_t a = 0; a < c->document->animation_count; a++)
        check_times_bounds(c, root, a);
    for (size_t m = 0; m < c->document->mesh_count; m++)
        check_mesh_bounds(c, root, m);
    check_uris(c, root);
    json_decref(root);
}
