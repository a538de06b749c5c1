/* SPDX-License-Identifier: MIT */
/** @file Base colour textures: PNG files of a document. */
#ifndef TEXTURE_H
#define TEXTURE_H

#include <stddef.h>

#include <nakawari/import.h>

enum { TEXTURE_LEVELS = 15 };

/** Levels of half the width and height each; red, green, blue, linear. */
typedef struct texture {
    nkw_vec3 *levels[TEXTURE_LEVELS];
    size_t widths[TEXTURE_LEVELS], heights[TEXTURE_LEVELS];
    int level_count; /**< 0: no picture */
} texture;

/** Reads an image of a document. What is no PNG, too large or missing has no levels. */
void texture_open(texture *t, const nkw_document *d, const nkw_document_image *image);
void texture_free(texture *t);

/** The linear share of a byte of sRGB, by a square. */
float texture_share(unsigned char byte);

/** The level of which a texel covers about a point, if `texels` texels of level 0 are drawn on `points` points. */
int texture_level(const texture *t, float texels, float points);
/** The colour at a place, between four texels; the picture repeats. */
nkw_vec3 texture_at(const texture *t, int level, float u, float v);

#endif
