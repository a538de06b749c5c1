/* SPDX-License-Identifier: MIT */
#include "space.h"

#include <errno.h>
#include <stdlib.h>

#include <nakawari/mat.h>
#include <nakawari/scalar.h>
#include <nakawari/vec.h>

const space_livery space_vivid = {0xf08a24, 0x2f7fd1, 0x6a6a78, 0xf4d35e};
const space_livery space_pale = {0xfbd9b4, 0xbcd8f2, 0xb9b9c0, 0xfaf0c8};
const svg_paint space_shade = {0x3c4250, SVG_NONE, 0.0f, 1.0f, NULL};

/* ---- the painter ---- */

static int grow(space_list *list)
{
    if (list->count < list->room)
        return 1;
    size_t room = list->room ? 2 * list->room : 256;
    space_shape *shapes = realloc(list->shapes, room * sizeof *shapes);
    if (!shapes) {
        list->failed = 1;
        return 0;
    }
    list->shapes = shapes;
    list->room = room;
    return 1;
}

void space_add(space_list *list, const svg_camera *camera, const nkw_vec3 *corners, int count, float distance,
               const svg_paint *paint)
{
    if (!grow(list))
        return;
    space_shape *shape = &list->shapes[list->count];
    shape->corners = count;
    shape->paint = *paint;
    shape->distance = distance;
    shape->order = list->count++;
    for (int i = 0; i < count; i++)
        shape->point[i] = svg_project(camera, corners[i]);
}

static int far_first(const void *a, const void *b)
{
    const space_shape *x = a, *y = b;
    if (x->distance != y->distance)
        return x->distance > y->distance ? -1 : 1;
    return x->order < y->order ? -1 : 1;
}

int space_paint(space_list *list, svg *s)
{
    const space_list empty = {NULL, 0, 0, 0};
    int ok = !list->failed;
    if (list->count)
        qsort(list->shapes, list->count, sizeof *list->shapes, far_first);
    for (size_t i = 0; i < list->count; i++) {
        const space_shape *shape = &list->shapes[i];
        if (shape->corners == 2)
            svg_line(s, shape->point[0], shape->point[1], &shape->paint);
        else
            svg_polygon(s, shape->point, (size_t)shape->corners, &shape->paint);
    }
    free(list->shapes);
    *list = empty;
    if (!ok)
        errno = ENOMEM;
    return ok;
}

float space_distance(const svg_camera *camera, nkw_vec3 p)
{
    return nkw_vec3_length(nkw_mat4_transform_point(&camera->view, p));
}

nkw_vec3 space_below(nkw_vec3 p)
{
    nkw_vec3 q = {p.x, 0.0f, p.z};
    return q;
}

/* ---- the floor ---- */

static int overlaps(const svg_point *points, int count, svg_box box)
{
    int left = 0, right = 0, above = 0, under = 0;
    for (int i = 0; i < count; i++) {
        left += points[i].x < box.x;
        right += points[i].x > box.x + box.width;
        above += points[i].y < box.y;
        under += points[i].y > box.y + box.height;
    }
    return left < count && right < count && above < count && under < count;
}

/* The tile from (x, z) to (x + 1, z + 1); pale from 4 units before the eye to nothing at 14. */
static void tile(svg *s, const svg_camera *camera, svg_box box, float x, float z)
{
    nkw_vec3 corner[4] = {{x, 0.0f, z}, {x, 0.0f, z + 1.0f}, {x + 1.0f, 0.0f, z + 1.0f}, {x + 1.0f, 0.0f, z}};
    svg_point p[4];
    for (int i = 0; i < 4; i++) {
        if (svg_depth(camera, corner[i]) < 0.3f)
            return;
        p[i] = svg_project(camera, corner[i]);
    }
    float fade = nkw_lerp(0.0f, 1.0f, nkw_inverse_lerp(4.0f, 14.0f, svg_depth(camera, corner[0])));
    svg_paint paint = svg_fill(svg_mix(0xe9ecf2, 0xffffff, fade), 1.0f);
    if (fade < 1.0f && overlaps(p, 4, box))
        svg_polygon(s, p, 4, &paint);
}

void space_floor(svg *s, const svg_camera *camera, svg_box box)
{
    for (int x = -16; x < 16; x++) {
        for (int z = -16; z < 16; z++) {
            if ((x + z) % 2 == 0)
                tile(s, camera, box, (float)x, (float)z);
        }
    }
}

/* ---- the dart ---- */

/* Corners for a length of 1. The body is convex; the fin stands on the ridge from NOSE to TOP. */
enum { NOSE, LEFT, RIGHT, TOP, KEEL, FIN_FRONT, FIN_TIP, FIN_BACK, CORNERS };
static const nkw_vec3 corners[CORNERS] = {
    {0.0f, 0.0f, -0.55f},   {-0.38f, 0.0f, 0.42f}, {0.38f, 0.0f, 0.42f},  {0.0f, 0.14f, 0.42f},
    {0.0f, -0.09f, 0.42f},  {0.0f, 0.08f, 0.0f},   {0.0f, 0.40f, 0.34f}, {0.0f, 0.40f, 0.45f},
};

typedef struct face {
    int corner[4], corners;
    int part; /* index into the four colours of a livery */
} face;

enum { LEFT_PART, RIGHT_PART, UNDER_PART, FIN_PART };
/* Counter-clockwise seen from outside. */
static const face body[] = {
    {{NOSE, LEFT, TOP, 0}, 3, LEFT_PART},       {{NOSE, TOP, RIGHT, 0}, 3, RIGHT_PART},
    {{NOSE, KEEL, LEFT, 0}, 3, UNDER_PART},     {{NOSE, RIGHT, KEEL, 0}, 3, UNDER_PART},
    {{LEFT, KEEL, RIGHT, TOP}, 4, UNDER_PART},
};
enum { BODY_FACES = sizeof body / sizeof *body };
static const face fin = {{FIN_FRONT, TOP, FIN_BACK, FIN_TIP}, 4, FIN_PART};

static void place(const nkw_mat4 *m, float length, nkw_vec3 out[CORNERS])
{
    for (int i = 0; i < CORNERS; i++)
        out[i] = nkw_mat4_transform_point(m, nkw_vec3_scale(corners[i], length));
}

static void pick(const face *f, const nkw_vec3 at[CORNERS], nkw_vec3 out[4])
{
    for (int i = 0; i < f->corners; i++)
        out[i] = at[f->corner[i]];
}

static int faces_eye(const svg_camera *camera, const nkw_vec3 *corner, int count)
{
    svg_point p[4];
    for (int i = 0; i < count; i++)
        p[i] = svg_project(camera, corner[i]);
    return svg_area(p, (size_t)count) > 0.0f;
}

/* Light falls from above and a little from the front right, on a good part of grey everywhere. */
svg_colour space_lit(svg_colour colour, const nkw_vec3 *c)
{
    const nkw_vec3 lamp = {0.25f, 0.9f, 0.35f};
    nkw_vec3 n = nkw_vec3_cross(nkw_vec3_sub(c[1], c[0]), nkw_vec3_sub(c[2], c[0]));
    float cosine = nkw_vec3_dot(nkw_vec3_normalize(n), lamp);
    return svg_mix(0x15151c, colour, 0.84f + 0.16f * nkw_max(cosine, -0.8f));
}

static svg_colour part_colour(const space_livery *l, int part)
{
    const svg_colour colours[] = {l->left, l->right, l->under, l->fin};
    return colours[part];
}

/* The foremost quarter of a side is red, so that the nose is seen. */
static void nose_cap(space_list *list, const svg_camera *camera, const nkw_vec3 side[3], float distance)
{
    nkw_vec3 cap[3] = {side[0], nkw_vec3_lerp(side[0], side[1], 0.24f), nkw_vec3_lerp(side[0], side[2], 0.24f)};
    svg_paint paint = svg_fill(space_lit(0xe8304f, side), 1.0f);
    space_add(list, camera, cap, 3, distance, &paint);
}

static void add_face(space_list *list, const svg_camera *camera, const face *f, const nkw_vec3 at[CORNERS],
                     float distance, const space_livery *livery)
{
    nkw_vec3 corner[4];
    pick(f, at, corner);
    svg_paint paint = {space_lit(part_colour(livery, f->part), corner), 0x33333a, 0.6f, 1.0f, NULL};
    space_add(list, camera, corner, f->corners, distance, &paint);
    if (f->corners == 3)
        nose_cap(list, camera, corner, distance);
}

/*
 * One distance for the whole dart, so that two darts do not mix. Within it: the body is convex, its faces that
 * look at the eye never cover each other. The fin lies outside the planes of both top faces: if the eye is
 * outside one of them nothing of the body can cover the fin, and if it is inside both the fin can cover nothing.
 */
void space_dart(space_list *list, const svg_camera *camera, const nkw_mat4 *m, float length,
                const space_livery *livery)
{
    nkw_vec3 at[CORNERS], corner[4];
    int seen[BODY_FACES];
    place(m, length, at);
    float distance = space_distance(camera, nkw_mat4_translation(m));
    for (int i = 0; i < BODY_FACES; i++) {
        pick(&body[i], at, corner);
        seen[i] = faces_eye(camera, corner, body[i].corners);
    }
    int above = seen[LEFT_PART] || seen[RIGHT_PART];
    if (!above)
        add_face(list, camera, &fin, at, distance, livery);
    for (int i = 0; i < BODY_FACES; i++) {
        if (seen[i])
            add_face(list, camera, &body[i], at, distance, livery);
    }
    if (above)
        add_face(list, camera, &fin, at, distance, livery);
}

/* From the lamp (0, 10, 0) through p to the floor: p + (p - lamp) p.y / (10 - p.y). */
nkw_vec3 space_shadow_of(nkw_vec3 p)
{
    float k = 10.0f / (10.0f - p.y);
    nkw_vec3 q = {p.x * k, 0.0f, p.z * k};
    return q;
}

void space_dart_shadow(svg *s, const svg_camera *camera, const nkw_mat4 *m, float length)
{
    nkw_vec3 at[CORNERS], corner[4];
    svg_point p[4];
    place(m, length, at);
    for (int i = 0; i <= BODY_FACES; i++) {
        const face *f = i < BODY_FACES ? &body[i] : &fin;
        pick(f, at, corner);
        for (int k = 0; k < f->corners; k++)
            p[k] = svg_project(camera, space_shadow_of(corner[k]));
        /* Of a closed body the faces that look one way cover all of the shadow. */
        if (f == &fin || svg_area(p, (size_t)f->corners) > 0.0f)
            svg_polygon(s, p, (size_t)f->corners, &space_shade);
    }
}
