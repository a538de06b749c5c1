/* SPDX-License-Identifier: MIT */
#include "object.h"

#include <stdlib.h>

#include <nakawari/mat.h>
#include <nakawari/scalar.h>
#include <nakawari/vec.h>

/* Of a model whose longest side is 1: what is nearer to a plane is in it. */
#define THICKNESS 1e-5f
/* The most triangles that cuts add. After them a triangle is where its middle is: large models have small triangles. */
enum { CUTS_MAX = 1000 };

/* ---- the size ---- */

static int is_finite(nkw_vec3 p)
{
    return p.x - p.x == 0.0f && p.y - p.y == 0.0f && p.z - p.z == 0.0f;
}

static int fit(object_triangle *triangles, size_t count)
{
    nkw_vec3 low = triangles[0].corner[0], high = low;
    for (size_t i = 0; i < 3 * count; i++) {
        const nkw_vec3 p = triangles[i / 3].corner[i % 3];
        if (!is_finite(p))
            return 0;
        low = nkw_vec3_min(low, p);
        high = nkw_vec3_max(high, p);
    }
    const nkw_vec3 size = nkw_vec3_sub(high, low), middle = nkw_vec3_lerp(low, high, 0.5f);
    const float side = nkw_max(size.x, nkw_max(size.y, size.z));
    if (!(side > 1e-30f && side < 1e30f))
        return 0;
    for (size_t i = 0; i < 3 * count; i++) {
        nkw_vec3 *p = &triangles[i / 3].corner[i % 3];
        *p = nkw_vec3_scale(nkw_vec3_sub(*p, middle), 1.0f / side);
    }
    return 1;
}

/* ---- the tree ---- */

/* The node's number + 1; 0 without memory. */
static size_t add_node(object_model *model, const object_node *node)
{
    if (model->count == model->room) {
        const size_t room = model->room ? 2 * model->room : 64;
        object_node *nodes = realloc(model->nodes, room * sizeof *nodes);
        if (!nodes)
            return 0;
        model->nodes = nodes;
        model->room = room;
    }
    model->nodes[model->count] = *node;
    return ++model->count;
}

static int insert(object_model *model, size_t at, const object_node *node, size_t most);

/* Below a child of `at`, or as that child. */
static int insert_below(object_model *model, size_t at, int in_front, const object_node *node, size_t most)
{
    const size_t child = in_front ? model->nodes[at].front : model->nodes[at].back;
    if (child)
        return insert(model, child - 1, node, most);
    const size_t added = add_node(model, node);
    if (added && in_front)
        model->nodes[at].front = added;
    else if (added)
        model->nodes[at].back = added;
    return added != 0;
}

/* The part of a triangle on one side (sign 1 or -1) of a plane, d from its corners: a fan of up to two triangles. */
static int insert_part(object_model *model, size_t at, const object_node *node, const float d[3], float sign,
                       size_t most)
{
    const nkw_vec3 *c = node->triangle.corner;
    nkw_vec3 corner[4];
    int count = 0;
    for (int i = 0; i < 3; i++) {
        const int k = (i + 1) % 3;
        if (sign * d[i] >= -THICKNESS)
            corner[count++] = c[i];
        if ((d[i] > THICKNESS && d[k] < -THICKNESS) || (d[i] < -THICKNESS && d[k] > THICKNESS))
            corner[count++] = nkw_vec3_lerp(c[i], c[k], d[i] / (d[i] - d[k]));
    }
    for (int i = 2; i < count; i++) {
        object_node part = *node;
        part.triangle.corner[0] = corner[0];
        part.triangle.corner[1] = corner[i - 1];
        part.triangle.corner[2] = corner[i];
        if (!insert_below(model, at, sign > 0.0f, &part, most))
            return 0;
    }
    return 1;
}

static int insert(object_model *model, size_t at, const object_node *node, size_t most)
{
    for (;;) {
        const object_node *plane = &model->nodes[at];
        float d[3], low = 0.0f, high = 0.0f;
        for (int i = 0; i < 3; i++) {
            d[i] = nkw_vec3_dot(plane->normal, node->triangle.corner[i]) - plane->offset;
            low = nkw_min(low, d[i]);
            high = nkw_max(high, d[i]);
        }
        if (low < -THICKNESS && high > THICKNESS && model->count < most)
            return insert_part(model, at, node, d, 1.0f, most) && insert_part(model, at, node, d, -1.0f, most);
        const int in_front = high + low >= 0.0f;
        const size_t child = in_front ? plane->front : plane->back;
        if (!child)
            return insert_below(model, at, in_front, node, most);
        at = child - 1;
    }
}

object_result object_build(object_model *model, object_triangle *triangles, size_t count)
{
    if (count == 0 || !fit(triangles, count))
        return OBJECT_NO_SIZE;
    for (size_t i = 0; i < count; i++) {
        const nkw_vec3 *c = triangles[i].corner;
        const nkw_vec3 n = nkw_vec3_cross(nkw_vec3_sub(c[1], c[0]), nkw_vec3_sub(c[2], c[0]));
        const float length = nkw_vec3_length(n);
        if (!(length > 1e-12f))
            continue;
        object_node node = {triangles[i], nkw_vec3_scale(n, 1.0f / length), 0.0f, 0, 0};
        node.offset = nkw_vec3_dot(node.normal, c[0]);
        if (!(model->count ? insert(model, 0, &node, count + CUTS_MAX) : add_node(model, &node) != 0))
            return OBJECT_NO_MEMORY;
    }
    return model->count ? OBJECT_OK : OBJECT_NO_SIZE;
}

void object_free(object_model *model)
{
    free(model->nodes);
}

/* ---- painting ---- */

static void place(const object_triangle *t, const nkw_mat4 *m, float length, nkw_vec3 out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = nkw_mat4_transform_point(m, nkw_vec3_scale(t->corner[i], length));
}

/* Whether the eye is on the front side of a node's plane: the eye is a point, or of parallel lines a direction. */
static int faces_eye(const svg_camera *camera, const nkw_mat4 *m, float length, const object_node *node)
{
    const nkw_vec3 corner = nkw_mat4_transform_point(m, nkw_vec3_scale(node->triangle.corner[0], length));
    const nkw_vec3 n = nkw_mat4_transform_direction(&camera->view, nkw_mat4_transform_direction(m, node->normal));
    if (camera->projection.m[11] == 0.0f)
        return n.z > 0.0f;
    return nkw_vec3_dot(n, nkw_mat4_transform_point(&camera->view, corner)) < 0.0f;
}

/* One distance for the whole model, as for the dart, so that two of them do not mix. */
static void add_triangle(space_list *list, const svg_camera *camera, const nkw_vec3 corner[3], float distance,
                         svg_colour colour)
{
    const svg_paint paint = {colour, colour, 0.5f, 1.0f, NULL}; /* the line closes the gap to the next triangle */
    space_add(list, camera, corner, 3, distance, &paint);
}

/* What is on the far side of each plane, the plane's triangle if its front is seen, what is on the near side. */
static void paint_model(space_list *list, const svg_camera *camera, const nkw_mat4 *m, float length, int pale,
                        const object_model *model)
{
    const float distance = space_distance(camera, nkw_mat4_translation(m));
    size_t *waiting = malloc(model->count * sizeof *waiting), count = 0, at = 1;
    if (!waiting) {
        list->failed = 1;
        return;
    }
    while (at || count) {
        const object_node *node = &model->nodes[at ? at - 1 : waiting[--count]];
        const int faces = faces_eye(camera, m, length, node);
        if (at) {
            waiting[count++] = at - 1;
            at = faces ? node->back : node->front;
            continue;
        }
        if (faces) {
            nkw_vec3 corner[3];
            place(&node->triangle, m, length, corner);
            const svg_colour colour = space_lit(node->triangle.colour, corner);
            add_triangle(list, camera, corner, distance, pale ? svg_mix(colour, 0xffffff, 0.62f) : colour);
        }
        at = faces ? node->front : node->back;
    }
    free(waiting);
}

void object_paint(space_list *list, const svg_camera *camera, const nkw_mat4 *m, float length, int pale,
                  const object_model *model)
{
    if (model)
        paint_model(list, camera, m, length, pale, model);
    else
        space_dart(list, camera, m, length, pale ? &space_pale : &space_vivid);
}

void object_shadow(svg *s, const svg_camera *camera, const nkw_mat4 *m, float length, const object_model *model)
{
    if (!model) {
        space_dart_shadow(s, camera, m, length);
        return;
    }
    for (size_t i = 0; i < model->count; i++) {
        nkw_vec3 corner[3];
        svg_point p[3];
        place(&model->nodes[i].triangle, m, length, corner);
        for (int k = 0; k < 3; k++)
            p[k] = svg_project(camera, space_shadow_of(corner[k]));
        svg_polygon(s, p, 3, &space_shade);
    }
}
