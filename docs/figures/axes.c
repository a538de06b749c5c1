/* SPDX-License-Identifier: MIT */
/* One character in the axes of four tools. */
#include "figure.h"

#include <nakawari/axes.h>
#include <nakawari/mat.h>
#include <nakawari/vec.h>

enum { PARTS = 6 };

static nkw_vec3 at(float x, float y, float z)
{
    nkw_vec3 r = {x, y, z};
    return r;
}

/* Ends of the limbs and the nose, in glTF's axes: the character faces +z, its right hand is at -x. */
static void character(svg *s, const svg_camera *camera)
{
    const nkw_vec3 from[PARTS] = {at(0, 0.7f, 0), at(0, 1.15f, 0), at(0, 1.15f, 0),
                                  at(0, 0.7f, 0), at(0, 0.7f, 0),  at(0, 1.5f, 0.1f)};
    const nkw_vec3 to[PARTS] = {at(0, 1.25f, 0), at(-0.45f, 0.8f, 0.1f), at(0.45f, 0.8f, 0.1f),
                                at(-0.2f, 0, 0), at(0.2f, 0, 0),         at(0, 1.48f, 0.34f)};
    svg_paint limb = svg_stroke(FIGURE_PALE, 8.0f, 1.0f), head = svg_fill(FIGURE_PALE, 1.0f);
    for (int i = 0; i < PARTS; i++)
        svg_line(s, svg_project(camera, from[i]), svg_project(camera, to[i]), &limb);
    svg_circle(s, svg_project(camera, at(0, 1.5f, 0)), 15.0f, &head);
}

static void tripod(svg *s, const svg_camera *camera, nkw_axes tool)
{
    static const char *const names[3] = {"x", "y", "z"};
    static const svg_colour colours[3] = {0xc62828, 0x2e7d32, 0x1f5fd0};
    const nkw_axes gltf = NKW_AXES_GLTF;
    nkw_axes_map map = nkw_axes_map_from_axes(tool, gltf);
    svg_point origin = svg_project(camera, NKW_VEC3_ZERO);
    for (int i = 0; i < 3; i++) {
        nkw_vec3 unit = at(i == 0, i == 1, i == 2);
        svg_paint line = svg_stroke(colours[i], 3.0f, 1.0f);
        svg_point tip = svg_project(camera, nkw_axes_convert_vec3(map, unit));
        svg_arrow(s, origin, tip, &line);
        figure_name(s, tip.x + 0.14f * (tip.x - origin.x), tip.y + 0.14f * (tip.y - origin.y) + 5.0f, colours[i], 'm',
                    names[i]);
    }
}

static void tool(svg *s, float x, const char *name, const char *hand, nkw_axes axes)
{
    nkw_mat4 view = figure_view(0.55f, 0.35f);
    svg_camera camera = svg_orthographic(&view, svg_at(x, 250.0f), 92.0f);
    character(s, &camera);
    tripod(s, &camera, axes);
    figure_bold(s, x, 350.0f, 15.0f, FIGURE_INK, 'm', name);
    figure_text(s, x, 370.0f, 13.0f, FIGURE_GREY, 'm', hand);
}

int figure_axes_tools(const char *path)
{
    const nkw_axes gltf = NKW_AXES_GLTF, blender = NKW_AXES_BLENDER, unity = NKW_AXES_UNITY, unreal = NKW_AXES_UNREAL;
    svg s;
    if (!figure_open(&s, path, 960.0f, 390.0f, "One character, the axes of four tools",
                     "Each tool names the same three directions differently: right, up and forward of the character."))
        return 0;
    tool(&s, 130.0f, "glTF, Maya", "right-handed, y up", gltf);
    tool(&s, 365.0f, "Blender, 3ds Max", "right-handed, z up", blender);
    tool(&s, 600.0f, "Unity, Direct3D", "left-handed, y up", unity);
    tool(&s, 835.0f, "Unreal", "left-handed, z up", unreal);
    return svg_close(&s);
}
