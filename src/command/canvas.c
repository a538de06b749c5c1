/* SPDX-License-Identifier: MIT */
#include "canvas.h"

#include <math.h>

#include <nakawari/scalar.h>
#include <nakawari/vec.h>

nkw_vec3 canvas_lit(nkw_vec3 colour, nkw_vec3 normal)
{
    const nkw_vec3 lamp = {-0.36f, 0.55f, 0.753f}, fill = {0.8f, 0.1f, 0.592f}, half = {-0.192f, 0.294f, 0.936f};
    nkw_vec3 n = nkw_vec3_normalize(normal);
    if (n.z < 0.0f)
        n = nkw_vec3_scale(n, -1.0f);
    float key = nkw_max(nkw_vec3_dot(n, lamp), 0.0f), side = nkw_max(nkw_vec3_dot(n, fill), 0.0f);
    float gloss = nkw_max(nkw_vec3_dot(n, half), 0.0f);
    for (int i = 0; i < 5; i++)
        gloss *= gloss;
    float light = 0.13f + 0.1f * (0.5f + 0.5f * n.y) + 0.66f * key + 0.1f * side;
    nkw_vec3 white = {0.05f * gloss, 0.05f * gloss, 0.05f * gloss};
    return nkw_vec3_add_scaled(white, colour, light);
}

static int finite(nkw_vec3 v)
{
    return isfinite(v.x) && isfinite(v.y) && isfinite(v.z);
}

int canvas_finite(const canvas_corner corner[3])
{
    int all = 1;
    for (int i = 0; i < 3; i++)
        all = all && finite(corner[i].place) && finite(corner[i].normal);
    return all;
}

float canvas_area(nkw_vec3 a, nkw_vec3 b, float x, float y)
{
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

int canvas_texture_level(const canvas_corner corner[3], const texture *image)
{
    const canvas_corner *a = &corner[0], *b = &corner[1], *c = &corner[2];
    float across = (b->u - a->u) * (c->v - a->v) - (b->v - a->v) * (c->u - a->u);
    float texels = fabsf(across) * (float)image->widths[0] * (float)image->heights[0];
    return texture_level(image, texels, fabsf(canvas_area(a->place, b->place, c->place.x, c->place.y)));
}

unsigned char canvas_byte(float share)
{
    return (unsigned char)(255.0f * nkw_sqrt(nkw_clamp(share, 0.0f, 1.0f)) + 0.5f);
}
