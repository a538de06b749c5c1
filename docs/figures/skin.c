/* SPDX-License-Identifier: MIT */
/* Skinned meshes: a twisted tube by matrices and by dual quaternions; a hand cut into parts. */
#include "figure.h"

#include <stdio.h>
#include <stdlib.h>

#include <nakawari/dual.h>
#include <nakawari/mat.h>
#include <nakawari/partition.h>
#include <nakawari/quat.h>
#include <nakawari/scalar.h>
#include <nakawari/skin.h>
#include <nakawari/vec.h>

/* ---- the twisted tube ---- */

enum { RINGS = 29, AROUND = 20, POINTS = RINGS * AROUND };

static const float half_length = 1.5f, twist = 2.9670597f; /* 170 degrees */

typedef struct tube {
    nkw_vec3 bind[POINTS], linear[POINTS], dual[POINTS];
    float weights[2 * POINTS];
    unsigned char joints[2 * POINTS];
} tube;

/* A cylinder of radius 0.5 about y; the upper joint's weight grows from 0 to 1 over the middle. */
static void make_tube(tube *t)
{
    for (int ring = 0; ring < RINGS; ring++)
        for (int i = 0; i < AROUND; i++) {
            int v = ring * AROUND + i;
            float angle = 2.0f * 3.14159265f * (float)i / (float)AROUND;
            float y = half_length * (2.0f * (float)ring / (float)(RINGS - 1) - 1.0f);
            nkw_vec3 p = {0.5f * nkw_cos(angle), y, 0.5f * nkw_sin(angle)};
            t->bind[v] = p;
            t->weights[2 * v + 1] = nkw_clamp(0.5f + 0.5f * y, 0.0f, 1.0f);
            t->weights[2 * v] = 1.0f - t->weights[2 * v + 1];
            t->joints[2 * v] = 0;
            t->joints[2 * v + 1] = 1;
        }
}

static void twist_tube(tube *t)
{
    const nkw_vec3 y = {0.0f, 1.0f, 0.0f}, none = {0.0f, 0.0f, 0.0f};
    nkw_quat turn = nkw_quat_from_axis_angle(y, twist);
    nkw_mat4 matrices[2] = {nkw_mat4_identity(), nkw_mat4_from_quat(turn)};
    nkw_dual_quat duals[2] = {nkw_dual_quat_from_rigid(nkw_quat_identity(), NKW_VEC3_ZERO),
                              nkw_dual_quat_from_rigid(turn, none)};
    nkw_skin skin = {POINTS, 2, {t->joints, 0, NKW_SKIN_U8}, {t->weights, 0, NKW_SKIN_F32}};
    nkw_skin_palette palette = {{matrices, 2, NKW_PALETTE_MAT4}, {NULL, 0, NKW_PALETTE_NORMAL_MAT3}, {0, 0, 0}};
    nkw_palette_view dual_palette = {duals, 2, NKW_PALETTE_DUAL_QUAT};
    nkw_vertices_view in = {{t->bind, 0}, {NULL, 0}, {NULL, 0}, {NULL, 0}};
    nkw_vertices_span linear = {{t->linear, 0}, {NULL, 0}, {NULL, 0}, {NULL, 0}};
    nkw_vertices_span dual = {{t->dual, 0}, {NULL, 0}, {NULL, 0}, {NULL, 0}};
    nkw_skin_linear(&skin, &palette, in, linear);
    nkw_skin_dual_quat(&skin, dual_palette, in, dual);
}

/* Two of every five stripes along the tube are dark: they show how it turns. light: 1 towards the eye, -1 away. */
static svg_colour stripe(int i, float light)
{
    svg_colour colour = i % 5 < 2 ? 0x1f5fd0 : 0xe9eef8;
    return svg_mix(0x1d1d22, colour, 0.72f + 0.28f * light);
}

/* A quad of the tube, unless its back is turned to the eye; of the uppermost rings the inside shows. */
static void add_quad(space_list *list, const svg_camera *camera, const nkw_vec3 quad[4], int ring, int i)
{
    svg_point page[4];
    nkw_vec3 middle = nkw_vec3_scale(nkw_vec3_add(quad[0], quad[2]), 0.5f), out = {middle.x, 0.0f, middle.z};
    float light = nkw_mat4_transform_direction(&camera->view, nkw_vec3_normalize(out)).z;
    for (int k = 0; k < 4; k++)
        page[k] = svg_project(camera, quad[k]);
    int is_front = svg_area(page, 4) < 0.0f;
    svg_colour fill = stripe(i, is_front ? light : -0.8f);
    svg_paint paint = {fill, fill, 0.5f, 1.0f, NULL};
    if (is_front || ring + 6 > RINGS)
        space_add(list, camera, quad, 4, -nkw_mat4_transform_point(&camera->view, middle).z, &paint);
}

static int draw_tube(svg *s, svg_point centre, const nkw_vec3 *p)
{
    nkw_mat4 view = figure_view(0.35f, 0.3f);
    svg_camera camera = svg_orthographic(&view, centre, 82.0f);
    space_list list = {NULL, 0, 0, 0};
    for (int ring = 0; ring + 1 < RINGS; ring++)
        for (int i = 0; i < AROUND; i++) {
            int a = ring * AROUND + i, b = ring * AROUND + (i + 1) % AROUND;
            nkw_vec3 quad[4] = {p[a], p[b], p[b + AROUND], p[a + AROUND]};
            add_quad(&list, &camera, quad, ring, i);
        }
    return space_paint(&list, s);
}

/* The radius of each ring, the mean of its points. */
static void radius_graph(svg *s, const svg_plot *plot, const nkw_vec3 *p, svg_colour colour, const char *dash)
{
    svg_point line[RINGS];
    svg_paint paint = svg_stroke(colour, 2.6f, 1.0f);
    paint.dash = dash;
    for (int ring = 0; ring < RINGS; ring++) {
        float sum = 0.0f, y = half_length * (2.0f * (float)ring / (float)(RINGS - 1) - 1.0f);
        for (int i = 0; i < AROUND; i++) {
            nkw_vec3 v = p[ring * AROUND + i];
            sum += nkw_sqrt(v.x * v.x + v.z * v.z);
        }
        line[ring] = svg_plot_at(plot, y, sum / (float)AROUND);
    }
    svg_polyline(s, line, RINGS, &paint);
}

int figure_skin_twist(const char *path)
{
    static tube t;
    svg_plot plot = {
        {680.0f, 120.0f, 276.0f, 236.0f}, {-1.5f, 1.5f, 0.5f, "along the tube"}, {0.0f, 0.6f, 0.1f, "radius"}};
    svg_paint blue = svg_stroke(0xd55e00, 2.6f, 1.0f), green = svg_stroke(0x2c8c4a, 2.6f, 1.0f);
    svg s;
    make_tube(&t);
    twist_tube(&t);
    if (!figure_open(
            &s, path, 984.0f, 440.0f, "A twist by 170 degrees between two joints",
            "The weight of the upper joint grows from 0 to 1 over the middle. Blended matrices lose volume there, "
            "dual quaternions keep it."))
        return 0;
    if (!draw_tube(&s, svg_at(110.0f, 250.0f), t.bind) || !draw_tube(&s, svg_at(312.0f, 250.0f), t.linear) ||
        !draw_tube(&s, svg_at(514.0f, 250.0f), t.dual))
        return 0;
    figure_text(&s, 110.0f, 420.0f, 14.0f, FIGURE_INK, 'm', "as bound");
    figure_bold(&s, 312.0f, 420.0f, 14.0f, 0xd55e00, 'm', "matrices: nkw_skin_linear");
    figure_bold(&s, 514.0f, 420.0f, 14.0f, 0x2c8c4a, 'm', "nkw_skin_dual_quat");
    svg_plot_frame(&s, &plot);
    radius_graph(&s, &plot, t.dual, 0x2c8c4a, NULL);
    radius_graph(&s, &plot, t.linear, 0xd55e00, NULL);
    figure_legend(&s, 690.0f, 420.0f, &blue, "matrices");
    figure_legend(&s, 802.0f, 420.0f, &green, "dual quaternions");
    return svg_close(&s);
}

/* ---- a hand in parts ---- */

enum { FINGERS = 4, BONES = 1 + 3 * FINGERS, PALM = 12, DOWN = 6, ALONG = 12, WIDE = 2, MOST = 4 };
enum { PALM_POINTS = (PALM + 1) * (DOWN + 1), FINGER_POINTS = (WIDE + 1) * (ALONG + 1) };
enum { HAND_POINTS = PALM_POINTS + FINGERS * FINGER_POINTS };
enum { HAND_TRIANGLES = 2 * (PALM * DOWN + FINGERS * WIDE * ALONG) };

typedef struct hand {
    svg_point point[HAND_POINTS];
    uint16_t joints[2 * HAND_POINTS];
    float weights[2 * HAND_POINTS];
    uint32_t indices[3 * HAND_TRIANGLES];
    size_t points, triangles;
} hand;

/* A grid of columns by rows, whose vertices have been added from `first` on, row by row. */
static void add_grid(hand *h, size_t first, int columns, int rows)
{
    for (int r = 0; r < rows; r++)
        for (int c = 0; c < columns; c++) {
            uint32_t a = (uint32_t)(first + (size_t)(r * (columns + 1) + c)), b = a + (uint32_t)columns + 1;
            uint32_t *at = h->indices + 3 * h->triangles;
            at[0] = a, at[1] = a + 1, at[2] = b;
            at[3] = a + 1, at[4] = b + 1, at[5] = b;
            h->triangles += 2;
        }
}

/* A vertex between two bones: `upper` has its weight. */
static void add_point(hand *h, float x, float y, int lower, int upper, float weight)
{
    size_t v = h->points++;
    h->point[v] = svg_at(x, y);
    h->joints[2 * v] = (uint16_t)lower;
    h->joints[2 * v + 1] = (uint16_t)upper;
    h->weights[2 * v] = 1.0f - weight;
    h->weights[2 * v + 1] = weight;
}

/* Fingers are three bones long; near the joints a vertex hangs on two. The palm is one bone. */
static void make_hand(hand *h)
{
    h->points = h->triangles = 0;
    for (int r = 0; r <= DOWN; r++)
        for (int c = 0; c <= PALM; c++)
            add_point(h, 40.0f + 26.0f * (float)c, 300.0f + 20.0f * (float)r, 0,
                      1 + 3 * (c < PALM ? c / 3 : FINGERS - 1), r < 2 ? 0.25f * (float)(2 - r) : 0.0f);
    add_grid(h, 0, PALM, DOWN);
    for (int f = 0; f < FINGERS; f++) {
        size_t first = h->points;
        for (int r = 0; r <= ALONG; r++)
            for (int c = 0; c <= WIDE; c++) {
                float along = 3.0f * (float)(ALONG - r) / (float)ALONG;
                int bone = along >= 2.5f ? 2 : along >= 0.5f ? (int)(along - 0.5f) : -1;
                float share = nkw_clamp(2.0f * (along - (float)bone - 0.75f), 0.0f, 1.0f);
                int lower = bone < 0 ? 0 : 1 + 3 * f + bone, upper = bone == 2 ? lower : 1 + 3 * f + bone + 1;
                add_point(h, 53.0f + 78.0f * (float)f + 26.0f * (float)c, 112.0f + 15.0f * (float)r, lower, upper,
                          bone == 2  ? 0.0f
                          : bone < 0 ? 0.5f + 0.5f * nkw_clamp(2.0f * along, 0.0f, 1.0f)
                                     : share);
            }
        add_grid(h, first, WIDE, ALONG);
    }
}

static const svg_colour part_colours[8] = {0x1f5fd0, 0xd55e00, 0x2c8c4a, 0x7b3fa0,
                                           0xc2185b, 0xe0a800, 0x00897b, 0x6a6a72};

static void draw_parts(svg *s, const hand *h, const nkw_partition *p)
{
    for (size_t k = 0; k < p->part_count; k++)
        for (size_t t = 0; t < p->parts[k].triangle_count; t++) {
            const uint32_t *corner = h->indices + 3 * p->triangles[p->parts[k].first_triangle + t];
            svg_point shape[3] = {h->point[corner[0]], h->point[corner[1]], h->point[corner[2]]};
            svg_paint paint = {svg_mix(0xffffff, part_colours[k % 8], 0.55f), 0xffffff, 0.8f, 1.0f, NULL};
            svg_polygon(s, shape, 3, &paint);
        }
}

static void draw_joints(svg *s)
{
    svg_paint line = svg_stroke(FIGURE_INK, 1.6f, 0.8f);
    char text[16];
    for (int f = 0; f < FINGERS; f++)
        for (int b = 0; b < 3; b++) {
            svg_point at = {79.0f + 78.0f * (float)f, 292.0f - 60.0f * (float)b};
            svg_point to = {at.x, at.y - 60.0f};
            svg_line(s, at, to, &line);
            figure_dot(s, at, FIGURE_INK);
            sprintf(text, "%d", (1 + 3 * f + b) % 100);
            figure_name(s, at.x + 7.0f, at.y - 8.0f, FIGURE_INK, 's', text);
        }
    figure_dot(s, svg_at(196.0f, 372.0f), FIGURE_INK);
    figure_name(s, 204.0f, 368.0f, FIGURE_INK, 's', "0");
}

static void part_list(svg *s, float x, float y, const nkw_partition *p)
{
    for (size_t k = 0; k < p->part_count && k < 16; k++) {
        const nkw_part *part = &p->parts[k];
        char text[96];
        int used = sprintf(text, "part %u: joints", (unsigned)k);
        svg_box box = {x, y + 28.0f * (float)k - 13.0f, 16.0f, 16.0f};
        svg_paint paint = svg_fill(svg_mix(0xffffff, part_colours[k % 8], 0.55f), 1.0f);
        svg_rect(s, box, 3.0f, &paint);
        for (size_t b = 0; b < part->joint_count && b < MOST; b++)
            used += sprintf(text + used, " %u", (unsigned)p->joints[part->first_joint + b]);
        figure_bold(s, x + 26.0f, y + 28.0f * (float)k, 14.0f, FIGURE_INK, 's', text);
        sprintf(text, "%u triangles, %u vertices", (unsigned)part->triangle_count, (unsigned)part->vertex_count);
        figure_text(s, x + 220.0f, y + 28.0f * (float)k, 13.0f, FIGURE_GREY, 's', text);
    }
}

/* The arrays for a cut, in one static block each: lengths are those of nkw_partition_bounds, checked. */
static nkw_result cut(const nkw_partition_mesh *mesh, nkw_partition *p)
{
    static nkw_part parts[HAND_TRIANGLES];
    static uint16_t bones[MOST * HAND_TRIANGLES], slots[6 * HAND_TRIANGLES];
    static uint32_t triangles[HAND_TRIANGLES], indices[3 * HAND_TRIANGLES], vertices[3 * HAND_TRIANGLES];
    static float weights[6 * HAND_TRIANGLES];
    NKW_STACK_WORK(work, 1 << 18);
    nkw_partition arrays = {parts, bones, triangles, indices, vertices, slots, weights, 0, 0, 0, 0, 0};
    nkw_partition_sizes sizes = nkw_partition_bounds(mesh, MOST);
    *p = arrays;
    if (sizes.joint_count > MOST * HAND_TRIANGLES || sizes.vertex_count > 3 * HAND_TRIANGLES)
        return NKW_TOO_SMALL;
    return nkw_partition_build(mesh, MOST, p, NULL, work);
}

int figure_partition_parts(const char *path)
{
    static hand h;
    nkw_partition p;
    char text[96];
    svg s;
    make_hand(&h);
    nkw_partition_mesh mesh = {h.indices, NULL, h.triangles, h.joints, h.weights, h.points, 2, BONES, NULL};
    if (cut(&mesh, &p) != NKW_OK ||
        !figure_open(
            &s, path, 860.0f, 450.0f, "A hand of 13 joints in parts of at most four",
            "Each part is drawn with its own palette; every triangle is in one part, vertices on the seam in "
            "both."))
        return 0;
    draw_parts(&s, &h, &p);
    draw_joints(&s);
    part_list(&s, 424.0f, 140.0f, &p);
    sprintf(text, "the mesh has %u triangles, %u vertices", (unsigned)mesh.triangle_count, (unsigned)mesh.vertex_count);
    figure_text(&s, 424.0f, 140.0f + 28.0f * (float)p.part_count + 14.0f, 13.0f, FIGURE_GREY, 's', text);
    return svg_close(&s);
}
