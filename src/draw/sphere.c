/* SPDX-License-Identifier: MIT */
#include "sphere.h"

#include <nakawari/scalar.h>
#include <nakawari/vec.h>

void sphere_line(svg *s, const svg_camera *camera, const nkw_vec3 *points, size_t count, svg_paint paint)
{
    svg_point run[4 * SPHERE_STEPS + 1];
    float whole = paint.opacity;
    for (size_t i = 0; i + 1 < count;) {
        int back = svg_depth(camera, points[i]) > 0.0f;
        size_t n = 0;
        run[n++] = svg_project(camera, points[i]);
        while (i + 1 < count && (svg_depth(camera, points[i]) > 0.0f) == back)
            run[n++] = svg_project(camera, points[++i]);
        paint.opacity = back ? 0.3f * whole : whole;
        svg_polyline(s, run, n, &paint);
    }
}

/* The circle a cos + b sin + c. */
static void circle(svg *s, const svg_camera *camera, nkw_vec3 a, nkw_vec3 b, nkw_vec3 c)
{
    nkw_vec3 points[SPHERE_STEPS + 1];
    for (int i = 0; i <= SPHERE_STEPS; i++) {
        float angle = 6.28318531f * (float)i / (float)SPHERE_STEPS;
        nkw_vec3 p = nkw_vec3_add_scaled(nkw_vec3_scale(a, nkw_cos(angle)), b, nkw_sin(angle));
        points[i] = nkw_vec3_add(p, c);
    }
    sphere_line(s, camera, points, SPHERE_STEPS + 1, svg_stroke(0xa9adba, 1.0f, 0.8f));
}

void sphere_ball(svg *s, const svg_camera *camera)
{
    const nkw_vec3 up = {0.0f, 1.0f, 0.0f};
    svg_paint ball = {0xf4f5f9, 0x9a9aa2, 1.2f, 1.0f, NULL};
    svg_circle(s, camera->centre, camera->scale, &ball);
    for (int i = 0; i < 6; i++) {
        float angle = 0.523598776f * (float)i;
        nkw_vec3 side = {nkw_sin(angle), 0.0f, nkw_cos(angle)};
        circle(s, camera, side, up, NKW_VEC3_ZERO);
    }
    for (int i = -2; i <= 2; i++) {
        float angle = 0.523598776f * (float)i, r = nkw_cos(angle);
        nkw_vec3 x = {r, 0.0f, 0.0f}, z = {0.0f, 0.0f, r}, c = {0.0f, nkw_sin(angle), 0.0f};
        circle(s, camera, x, z, c);
    }
}
