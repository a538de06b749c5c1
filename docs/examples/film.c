/* SPDX-License-Identifier: MIT */
#include "film.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>

#include <nakawari/mat.h>
#include <nakawari/quat.h>
#include <nakawari/scalar.h>
#include <nakawari/vec.h>

#include "draw/space.h"

static const svg_colour joint_colours[RIG_JOINTS] = {0xd55e00, 0x2f7fd1, 0x2ca05a, 0x9a4fb0};

/* ---- the eye ---- */

/* From the front right, 15 degrees down. */
static nkw_mat4 view(void)
{
    nkw_vec3 x = {1.0f, 0.0f, 0.0f}, y = {0.0f, 1.0f, 0.0f};
    return nkw_mat4_from_quat(
        nkw_quat_mul(nkw_quat_from_axis_angle(x, 0.261799388f), nkw_quat_from_axis_angle(y, -0.872664626f)));
}

/* The camera that shows `extent` in the middle of the box. */
static svg_camera camera_for(svg_box extent, svg_box box)
{
    nkw_mat4 eye = view();
    float scale = nkw_min(box.width / extent.width, box.height / extent.height);
    svg_point centre = {box.x + 0.5f * box.width - scale * (extent.x + 0.5f * extent.width),
                        box.y + 0.5f * box.height - scale * (extent.y + 0.5f * extent.height)};
    return svg_orthographic(&eye, centre, scale);
}

/* ---- a moment ---- */

static rig_state move_to(film *f, float time, int dual)
{
    rig_state state = rig_at(f->rig, time);
    rig_skin(&state, f->mesh, dual, f->positions, f->normals);
    return state;
}

static svg_box around(const film *f)
{
    nkw_mat4 eye = view();
    svg_camera camera = svg_orthographic(&eye, svg_at(0.0f, 0.0f), 1.0f);
    svg_point low = svg_project(&camera, f->positions[0]), high = low;
    for (size_t i = 1; i < f->mesh->vertex_count; i++) {
        svg_point p = svg_project(&camera, f->positions[i]);
        low = svg_at(nkw_min(low.x, p.x), nkw_min(low.y, p.y));
        high = svg_at(nkw_max(high.x, p.x), nkw_max(high.y, p.y));
    }
    svg_box box = {low.x, low.y, high.x - low.x, high.y - low.y};
    return box;
}

static svg_box joined(svg_box a, svg_box b)
{
    float right = nkw_max(a.x + a.width, b.x + b.width), bottom = nkw_max(a.y + a.height, b.y + b.height);
    svg_box box = {nkw_min(a.x, b.x), nkw_min(a.y, b.y), 0.0f, 0.0f};
    box.width = right - box.x;
    box.height = bottom - box.y;
    return box;
}

/* ---- the mesh ---- */

/* The joints' colours, mixed by the weights of a face's corners. */
static svg_colour skin_colour(const mesh *m, const mesh_face *face)
{
    float share[RIG_JOINTS] = {0};
    for (int c = 0; c < face->corners; c++) {
        const mesh_vertex *v = &m->vertices[face->corner[c]];
        for (int i = 0; i < MESH_INFLUENCES; i++)
            share[v->joints[i]] += (float)v->weights[i] / (65535.0f * (float)face->corners);
    }
    svg_colour mixed = joint_colours[0];
    float sum = share[0];
    for (int j = 1; j < RIG_JOINTS; j++) {
        sum += share[j];
        mixed = svg_mix(mixed, joint_colours[j], sum > 0.0f ? share[j] / sum : 0.0f);
    }
    return mixed;
}

/* Stripes along y, an eighth of a turn wide, so that a twist is seen. */
static int striped(const mesh *m, const mesh_face *face)
{
    nkw_vec3 sum = NKW_VEC3_ZERO;
    for (int c = 0; c < face->corners; c++)
        sum = nkw_vec3_add(sum, m->vertices[face->corner[c]].position);
    return (sum.x > 0.0f) ^ (sum.z > 0.0f) ^ (nkw_abs(sum.x) > nkw_abs(sum.z));
}

/* The light comes over the eye's left shoulder. */
static svg_colour lit(const film *f, const mesh_face *face, svg_colour colour)
{
    const nkw_vec3 lamp = {0.35f, 0.65f, 0.67f};
    nkw_vec3 normal = NKW_VEC3_ZERO;
    for (int c = 0; c < face->corners; c++)
        normal = nkw_vec3_add(normal, f->normals[face->corner[c]]);
    float cosine = nkw_vec3_dot(nkw_vec3_normalize(normal), lamp);
    return svg_mix(0x1a1a22, colour, 0.62f + 0.38f * nkw_max(cosine, -0.6f));
}

static void add_face(space_list *list, const film *f, const svg_camera *camera, const mesh_face *face)
{
    nkw_vec3 corner[4];
    svg_point p[4];
    float distance = 0.0f;
    for (int c = 0; c < face->corners; c++) {
        corner[c] = f->positions[face->corner[c]];
        p[c] = svg_project(camera, corner[c]);
        distance += svg_depth(camera, corner[c]) / (float)face->corners;
    }
    if (!(svg_area(p, (size_t)face->corners) > 0.0f))
        return;
    svg_colour colour = skin_colour(f->mesh, face);
    colour = lit(f, face, striped(f->mesh, face) ? svg_mix(colour, 0xffffff, 0.45f) : colour);
    svg_paint paint = {colour, colour, 0.7f, 1.0f, NULL};
    space_add(list, camera, corner, face->corners, distance, &paint);
}

/* The joints and the bones between them, drawn over the mesh. */
static void draw_joints(svg *out, const svg_camera *camera, const rig_state *state)
{
    svg_paint bone = svg_stroke(0x1d1d22, 1.4f, 0.75f), ball = {0xffffff, 0x1d1d22, 1.4f, 0.9f, NULL};
    svg_point at[RIG_JOINTS];
    for (int j = 0; j < RIG_JOINTS; j++)
        at[j] = svg_project(camera, nkw_mat4_translation(&state->model[j]));
    svg_polyline(out, at, RIG_JOINTS, &bone);
    for (int j = 0; j < RIG_JOINTS; j++)
        svg_circle(out, at[j], 3.2f, &ball);
}

static int draw(svg *out, film *f, float time, int dual, const svg_camera *camera)
{
    space_list list = {NULL, 0, 0, 0};
    rig_state state = move_to(f, time, dual);
    for (size_t i = 0; i < f->mesh->face_count; i++)
        add_face(&list, f, camera, &f->mesh->faces[i]);
    int ok = space_paint(&list, out);
    draw_joints(out, camera, &state);
    return ok;
}

/* ---- the film ---- */

int film_open(film *f, const rig *r, const mesh *m, int dual, int frames)
{
    f->rig = r;
    f->mesh = m;
    f->dual = dual;
    f->frames = frames;
    f->positions = malloc(m->vertex_count * sizeof *f->positions);
    f->normals = malloc(m->vertex_count * sizeof *f->normals);
    if (!f->positions || !f->normals) {
        errno = ENOMEM;
        return 0;
    }
    for (int i = 0; i < frames; i++) {
        move_to(f, film_time(f, i), dual);
        f->extent = i ? joined(f->extent, around(f)) : around(f);
    }
    return 1;
}

void film_free(film *f)
{
    free(f->positions);
    free(f->normals);
}

float film_time(const film *f, int frame)
{
    return RIG_END * (float)frame / (float)f->frames;
}

static const char *seconds(float time, char text[SVG_DIGITS])
{
    char digits[SVG_DIGITS];
    sprintf(text, "%.16s s", svg_number(digits, time, 3));
    return text;
}

static const char *skinning(int dual)
{
    return dual ? "dual quaternions" : "blended matrices";
}

/* ---- one frame ---- */

int film_frame(film *f, int frame, const char *path)
{
    svg out;
    char text[SVG_DIGITS], title[128];
    const svg_box box = {24.0f, 24.0f, 352.0f, 400.0f};
    svg_camera camera = camera_for(f->extent, box);
    sprintf(title, "Frame %d of %d", frame + 1, f->frames);
    if (!svg_open(&out, path, 400.0f, 480.0f, title, skinning(f->dual)))
        return 0;
    int ok = draw(&out, f, film_time(f, frame), f->dual, &camera);
    svg_text(&out, svg_at(24.0f, 460.0f), &svg_sheet_strong, seconds(film_time(f, frame), text));
    svg_text(&out, svg_at(84.0f, 460.0f), &svg_sheet_small, skinning(f->dual));
    return svg_close(&out) && ok;
}

/* ---- all frames ---- */

enum { COLUMNS = 8 };

static void joint_legend(svg *s, svg_point at)
{
    static const char *const names[RIG_JOINTS] = {"joint 0", "joint 1", "joint 2", "joint 3"};
    for (int j = 0; j < RIG_JOINTS; j++) {
        svg_paint paint = svg_fill(joint_colours[j], 1.0f);
        svg_circle(s, at, 6.0f, &paint);
        svg_text(s, svg_at(at.x + 12.0f, at.y + 4.5f), &svg_sheet_text, names[j]);
        at.x += 86.0f;
    }
}

int film_sheet(film *f, const char *path)
{
    svg out;
    char text[SVG_DIGITS], title[96];
    const float width = 131.0f, height = 236.0f;
    int rows = (f->frames + COLUMNS - 1) / COLUMNS, ok = 1;
    float bottom = 84.0f + (float)rows * height;
    sprintf(title, "Four joints, %d frames, skinned by %s", f->frames, skinning(f->dual));
    if (!svg_sheet_open(
            &out, path, 1100.0f, bottom + 40.0f, title,
            "Key frames at 0, 1, 2, 3 and 4 s: the lesson's bend and back, a twist of 170 degrees, a hook. Colours are "
            "weights."))
        return 0;
    for (int i = 0; i < f->frames; i++) {
        svg_box box = {26.0f + width * (float)(i % COLUMNS), 88.0f + height * (float)(i / COLUMNS), width - 14.0f,
                       height - 40.0f};
        svg_camera camera = camera_for(f->extent, box);
        svg_font below = {13.0f, 0x2b2b30, 'm', 1, SVG_NONE};
        ok &= draw(&out, f, film_time(f, i), f->dual, &camera);
        svg_text(&out, svg_at(box.x + 0.5f * box.width, box.y + box.height + 24.0f), &below,
                 seconds(film_time(f, i), text));
    }
    joint_legend(&out, svg_at(36.0f, bottom + 16.0f));
    return svg_close(&out) && ok;
}

/* ---- the two ways of skinning ---- */

/*
 * How far the mesh keeps its thickness: the least share of its distance from the y axis that a vertex has kept. At
 * RIG_TWIST all joints stand on that axis and turn about it.
 */
static float least_thickness(const film *f)
{
    float least = 1.0f;
    for (size_t i = 0; i < f->mesh->vertex_count; i++) {
        nkw_vec3 a = f->mesh->vertices[i].position, b = f->positions[i];
        float before = nkw_sqrt(a.x * a.x + a.z * a.z), after = nkw_sqrt(b.x * b.x + b.z * b.z);
        if (before > 1e-3f * f->rig->spacing)
            least = nkw_min(least, after / before);
    }
    return least;
}

static int compare_panel(svg *out, film *f, int dual, svg_box extent, svg_box box)
{
    char text[128], digits[SVG_DIGITS];
    const svg_font name = {16.0f, 0x1d1d22, 'm', 1, SVG_NONE}, below = {13.0f, 0x2b2b30, 'm', 0, SVG_NONE};
    svg_camera camera = camera_for(extent, box);
    float x = box.x + 0.5f * box.width;
    int ok = draw(out, f, RIG_TWIST, dual, &camera);
    svg_text(out, svg_at(x, box.y + box.height + 34.0f), &name, dual ? "Dual quaternions" : "Blended matrices");
    sprintf(text, "keep %.16s %% of the thickness where it is least",
            svg_number(digits, 100.0f * least_thickness(f), 0));
    svg_text(out, svg_at(x, box.y + box.height + 56.0f), &below, text);
    return ok;
}

int film_compare(film *f, const char *path)
{
    svg out;
    const svg_box left = {60.0f, 92.0f, 300.0f, 330.0f}, right = {400.0f, 92.0f, 300.0f, 330.0f};
    if (!svg_sheet_open(&out, path, 760.0f, 540.0f, "A twist of 170 degrees at joint 2",
                      "Same keys and weights. The mean of two rotation matrices is not a rotation: it shrinks "
                      "the mesh."))
        return 0;
    move_to(f, RIG_TWIST, 0);
    svg_box extent = around(f);
    move_to(f, RIG_TWIST, 1);
    extent = joined(extent, around(f));
    int ok = compare_panel(&out, f, 0, extent, left) && compare_panel(&out, f, 1, extent, right);
    joint_legend(&out, svg_at(208.0f, 514.0f));
    return svg_close(&out) && ok;
}
