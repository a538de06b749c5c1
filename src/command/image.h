/* SPDX-License-Identifier: MIT */
/** @file PNG files by libpng, and animated ones. */
#ifndef IMAGE_H
#define IMAGE_H

#include <stddef.h>
#include <stdio.h>

/** Red, green, blue of each pixel, row by row, to be freed; NULL if it is no PNG of at most `most` pixels a side. */
unsigned char *image_read_png(const void *data, size_t bytes, size_t most, size_t *width, size_t *height);
unsigned char *image_read_png_file(const char *path, size_t most, size_t *width, size_t *height);

/** Writes a PNG file of width x height pixels. Returns 0 if it cannot. */
int image_write_png(FILE *f, const unsigned char *pixels, size_t width, size_t height);

/**
 * An animated PNG while it is written: an ordinary PNG of the first frame with the others in further chunks, each only
 * the rectangle in which it differs from the frame before it. Source: World Wide Web Consortium, Portable Network
 * Graphics (PNG) Specification, third edition, 2025, 4.9 and 11.3.6.
 */
typedef struct image_film {
    FILE *file;
    size_t width, height, frame_count, frame; /**< frame: how many are written */
    unsigned long sequence; /**< the number of the next chunk */
    unsigned char *before; /**< the pixels of the frame before */
} image_film;

/** Begins the file. Returns 0 without memory. image_film_close is due in either case. */
int image_film_open(image_film *film, FILE *f, size_t width, size_t height, size_t frame_count);
/** Adds a frame that is shown for some seconds, at most 65. Returns 0 if it cannot. */
int image_film_add(image_film *film, const unsigned char *pixels, double seconds);
/** Ends the file, which remains open. */
void image_film_close(image_film *film);

#endif
