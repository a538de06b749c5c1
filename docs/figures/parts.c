/* SPDX-License-Identifier: MIT */
/* A rotation in two parts, and the mean of two rotations. */
#include "figure.h"
#include "draw/sphere.h"

#include <nakawari/orient.h>
#include <nakawari/quat.h>
#include <nakawari/scalar.h>
#include <nakawari/vec.h>

static const nkw_vec3 axis = {0.0f, 1.0f, 0.0f}, mark = {0.75f, 0.62f, 0.25f};

/* A twist of -75 degrees about y, then a swing of 55 degrees. */
static nkw_quat example(void)
{
    const nkw_vec3 across = {0.8f, 0.0f, 0.6f};
    nkw_quat twist = nkw_quat_from_axis_angle(axis, nkw_radians_from_degrees(-75.0f));
    return nkw_quat_mul(nkw_quat_from_axis_angle(across, nkw_radians_from_degrees(55.0f)), twist);
}

/* The way of v while the rotation grows from none to q after `first`. */
static void way(svg *s, const svg_camera *camera, nkw_quat first, nkw_quat q, nkw_vec3 v, svg_colour colour)
{
    nkw_vec3 points[FIGURE_STEPS + 1];
    for (int i = 0; i <= FIGURE_STEPS; i++) {
        nkw_quat part = nkw_quat_slerp(nkw_quat_identity(), q, (float)i / (float)FIGURE_STEPS);
        points[i] = nkw_vec3_normalize(nkw_quat_rotate(nkw_quat_mul(part, first), v));
    }
    sphere_line(s, camera, points, FIGURE_STEPS + 1, svg_stroke(colour, 3.2f, 1.0f));
}

static void place(svg *s, const svg_camera *camera, nkw_vec3 v, svg_colour colour, const char *name)
{
    svg_point at = svg_project(camera, nkw_vec3_normalize(v));
    figure_dot(s, at, colour);
    figure_name(s, at.x, at.y - 12.0f, colour, 'm', name);
}

static void parts_panel(svg *s, svg_point centre)
{
    nkw_mat4 view = figure_view(0.5f, 0.55f);
    svg_camera camera = svg_orthographic(&view, centre, 170.0f);
    nkw_quat q = example(), none = nkw_quat_identity();
    nkw_swing_twist p = nkw_quat_swing_twist(q, axis);
    sphere_ball(s, &camera);
    way(s, &camera, none, p.twist, mark, FIGURE_CATMULL_ROM);
    way(s, &camera, p.twist, p.swing, mark, FIGURE_HERMITE);
    way(s, &camera, p.twist, p.swing, axis, FIGURE_HERMITE);
    place(s, &camera, axis, FIGURE_INK, "axis");
    place(s, &camera, nkw_quat_rotate(q, axis), FIGURE_INK, "q axis");
    place(s, &camera, mark, FIGURE_GREY, "v");
    place(s, &camera, nkw_quat_rotate(p.twist, mark), FIGURE_GREY, "twist v");
    place(s, &camera, nkw_quat_rotate(q, mark), FIGURE_GREY, "q v");
}

/* The share of the angle at which the result lies, of two rotations with the weights 3/4 and 1/4. */
static float share(float degrees, int is_mean)
{
    const float weights[2] = {0.75f, 0.25f};
    nkw_quat q[2] = {nkw_quat_identity(), nkw_quat_from_axis_angle(axis, nkw_radians_from_degrees(degrees))};
    nkw_quat r = is_mean ? nkw_quat_mean(q, 2, weights) : nkw_quat_nlerp(q[0], q[1], 0.25f);
    return nkw_degrees_from_radians(nkw_quat_angle(q[0], r)) / degrees;
}

static void share_graph(svg *s, const svg_plot *plot, int is_mean, svg_colour colour)
{
    svg_point line[FIGURE_STEPS + 1];
    svg_paint paint = svg_stroke(colour, 3.0f, 1.0f);
    for (int i = 0; i <= FIGURE_STEPS; i++) {
        float degrees = nkw_lerp(1.0f, 179.0f, (float)i / (float)FIGURE_STEPS);
        line[i] = svg_plot_at(plot, degrees, share(degrees, is_mean));
    }
    svg_polyline(s, line, FIGURE_STEPS + 1, &paint);
}

int figure_quat_parts(const char *path)
{
    svg s;
    svg_paint twist = svg_stroke(FIGURE_CATMULL_ROM, 3.0f, 1.0f), swing = svg_stroke(FIGURE_HERMITE, 3.0f, 1.0f);
    svg_paint slerp = svg_stroke(FIGURE_PALE, 3.0f, 1.0f), sum = svg_stroke(FIGURE_NLERP, 3.0f, 1.0f);
    svg_paint mean = svg_stroke(FIGURE_BEZIER, 3.0f, 1.0f);
    svg_plot plot = {{560.0f, 120.0f, 380.0f, 280.0f},
                     {0.0f, 180.0f, 45.0f, "degrees between the two rotations"},
                     {0.0f, 0.3f, 0.05f, "share of the angle, weights 3/4 and 1/4"}};
    if (!figure_open(&s, path, 980.0f, 506.0f, "A rotation in two parts; the mean of two rotations",
                     "Left: first the twist about the axis, then the swing of the axis. Right: sum and mean leave a "
                     "quarter of the arc."))
        return 0;
    parts_panel(&s, svg_at(240.0f, 285.0f));
    svg_plot_frame(&s, &plot);
    svg_line(&s, svg_plot_at(&plot, 0.0f, 0.25f), svg_plot_at(&plot, 180.0f, 0.25f), &slerp);
    share_graph(&s, &plot, 0, FIGURE_NLERP);
    share_graph(&s, &plot, 1, FIGURE_BEZIER);
    figure_legend(&s, 120.0f, 482.0f, &twist, "twist");
    figure_legend(&s, 240.0f, 482.0f, &swing, "swing");
    figure_legend(&s, 520.0f, 482.0f, &slerp, "slerp");
    figure_legend(&s, 620.0f, 482.0f, &sum, "sum of the layers");
    figure_legend(&s, 790.0f, 482.0f, &mean, "nkw_quat_mean");
    return svg_close(&s);
}
