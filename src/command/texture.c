/* SPDX-License-Identifier: MIT */
#include "texture.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/scalar.h>
#include <nakawari/vec.h>

#include "command.h"
#include "image.h"

/* The largest width and height. */
enum { SIDE_MOST = 1 << (TEXTURE_LEVELS - 1) };

/* An outer file beside the document. */
static unsigned char *read_outer(const nkw_document *d, const char *path, size_t *width, size_t *height)
{
    char *name = input_beside(d, path);
    unsigned char *pixels = name ? image_read_png_file(name, SIDE_MOST, width, height) : NULL;
    free(name);
    return pixels;
}

float texture_share(unsigned char byte)
{
    const float root = (float)byte / 255.0f;
    return root * root;
}

static int to_linear(texture *t, const unsigned char *pixels)
{
    const size_t count = t->widths[0] * t->heights[0];
    t->levels[0] = (nkw_vec3 *)malloc(count * sizeof *t->levels[0]);
    for (size_t i = 0; t->levels[0] && i < count; i++) {
        const unsigned char *p = pixels + 3 * i;
        nkw_vec3 c = {texture_share(p[0]), texture_share(p[1]), texture_share(p[2])};
        t->levels[0][i] = c;
    }
    return t->levels[0] != NULL;
}

/* Each texel is the mean of four of the level before; of an odd number the last is left out. */
static int halve(texture *t, int level)
{
    const nkw_vec3 *from = t->levels[level - 1];
    size_t row = t->widths[level - 1], width = row / 2, height = t->heights[level - 1] / 2;
    if (!width || !height)
        return 0;
    t->widths[level] = width;
    t->heights[level] = height;
    t->levels[level] = (nkw_vec3 *)malloc(width * height * sizeof **t->levels);
    for (size_t i = 0; t->levels[level] && i < width * height; i++) {
        const nkw_vec3 *p = from + i / width * 2 * row + i % width * 2;
        nkw_vec3 sum = nkw_vec3_add(nkw_vec3_add(p[0], p[1]), nkw_vec3_add(p[row], p[row + 1]));
        t->levels[level][i] = nkw_vec3_scale(sum, 0.25f);
    }
    return t->levels[level] != NULL;
}

void texture_open(texture *t, const nkw_document *d, const nkw_document_image *image)
{
    memset(t, 0, sizeof *t);
    unsigned char *pixels = image->data
                                ? image_read_png(image->data, image->bytes, SIDE_MOST, &t->widths[0], &t->heights[0])
                            : image->path ? read_outer(d, image->path, &t->widths[0], &t->heights[0])
                                          : NULL;
    if (pixels && to_linear(t, pixels))
        for (t->level_count = 1; t->level_count < TEXTURE_LEVELS && halve(t, t->level_count);)
            t->level_count++;
    free(pixels);
}

void texture_free(texture *t)
{
    for (int i = 0; i < t->level_count; i++)
        free(t->levels[i]);
    t->level_count = 0;
}

int texture_level(const texture *t, float texels, float points)
{
    int level = 0;
    for (float ratio = texels; level + 1 < t->level_count && ratio > 2.0f * points; ratio *= 0.25f)
        level++;
    return level;
}

/* The texel before a place, the share of the next, both within `count` texels. */
static size_t split(float place, size_t count, size_t *next, float *share)
{
    float whole = floorf(place), at = (place - whole) * (float)count - 0.5f, low = floorf(at);
    if (!isfinite(at))
        at = low = 0.0f;
    size_t first = low < 0.0f ? count - 1 : (size_t)low;
    first = first < count ? first : count - 1;
    *next = first + 1 < count ? first + 1 : 0;
    *share = at - low;
    return first;
}

nkw_vec3 texture_at(const texture *t, int level, float u, float v)
{
    size_t x1, y1, width = t->widths[level];
    float dx, dy;
    size_t x0 = split(u, width, &x1, &dx), y0 = split(v, t->heights[level], &y1, &dy);
    const nkw_vec3 *upper = t->levels[level] + y0 * width, *lower = t->levels[level] + y1 * width;
    return nkw_vec3_lerp(nkw_vec3_lerp(upper[x0], upper[x1], dx), nkw_vec3_lerp(lower[x0], lower[x1], dx), dy);
}
