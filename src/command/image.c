/* SPDX-License-Identifier: MIT */
#include "image.h"

#include <stdlib.h>
#include <string.h>

#include <png.h>
#include <zlib.h>

/* ---- PNG ---- */

static unsigned char *finish_read(png_image *image, size_t most, size_t *width, size_t *height)
{
    const png_color black = {0, 0, 0};
    unsigned char *pixels = NULL;
    image->format = PNG_FORMAT_RGB;
    if (image->width <= most && image->height <= most)
        pixels = (unsigned char *)malloc(PNG_IMAGE_SIZE(*image));
    if (pixels && !png_image_finish_read(image, &black, pixels, 0, NULL)) {
        free(pixels);
        pixels = NULL;
    }
    *width = image->width;
    *height = image->height;
    png_image_free(image);
    return pixels;
}

static void start(png_image *image)
{
    memset(image, 0, sizeof *image);
    image->version = PNG_IMAGE_VERSION;
}

unsigned char *image_read_png(const void *data, size_t bytes, size_t most, size_t *width, size_t *height)
{
    png_image image;
    start(&image);
    return png_image_begin_read_from_memory(&image, data, bytes) ? finish_read(&image, most, width, height) : NULL;
}

unsigned char *image_read_png_file(const char *path, size_t most, size_t *width, size_t *height)
{
    png_image image;
    start(&image);
    return png_image_begin_read_from_file(&image, path) ? finish_read(&image, most, width, height) : NULL;
}

static void describe(png_image *image, size_t width, size_t height)
{
    start(image);
    image->format = PNG_FORMAT_RGB;
    image->width = (png_uint_32)width;
    image->height = (png_uint_32)height;
}

int image_write_png(FILE *f, const unsigned char *pixels, size_t width, size_t height)
{
    png_image image;
    describe(&image, width, height);
    int fine = png_image_write_to_stdio(&image, f, 0, pixels, 0, NULL) != 0;
    png_image_free(&image);
    return fine;
}

/* ---- animated PNG ---- */

static void put_u32(unsigned char *out, unsigned long value)
{
    for (int i = 0; i < 4; i++)
        out[i] = (unsigned char)(value >> (24 - 8 * i) & 0xff);
}

static unsigned long u32_at(const unsigned char *p)
{
    return (unsigned long)p[0] << 24 | (unsigned long)p[1] << 16 | (unsigned long)p[2] << 8 | p[3];
}

/* Bytes of a chunk, and their checksum. */
static unsigned long put_part(FILE *f, unsigned long crc, const unsigned char *data, size_t bytes)
{
    if (!bytes)
        return crc;
    fwrite(data, 1, bytes, f);
    return crc32(crc, data, (uInt)bytes);
}

/* A chunk of two parts: its length, its name, the parts, the checksum of name and parts. */
static void put_chunk(FILE *f, const char *name, const unsigned char *head, size_t head_bytes,
                      const unsigned char *data, size_t bytes)
{
    unsigned char number[4], letters[4];
    put_u32(number, (unsigned long)(head_bytes + bytes));
    memcpy(letters, name, 4);
    fwrite(number, 1, 4, f);
    unsigned long crc = put_part(f, 0, letters, 4);
    crc = put_part(f, crc, head, head_bytes);
    crc = put_part(f, crc, data, bytes);
    put_u32(number, crc);
    fwrite(number, 1, 4, f);
}

int image_film_open(image_film *film, FILE *f, size_t width, size_t height, size_t frame_count)
{
    static const unsigned char signature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    unsigned char header[13] = {0}, control[8] = {0};
    memset(film, 0, sizeof *film);
    film->file = f;
    film->width = width;
    film->height = height;
    film->frame_count = frame_count;
    film->before = (unsigned char *)malloc(3 * width * height);
    put_u32(header, (unsigned long)width);
    put_u32(header + 4, (unsigned long)height);
    header[8] = 8; /* bits */
    header[9] = 2; /* red, green, blue */
    put_u32(control, (unsigned long)frame_count);
    fwrite(signature, 1, sizeof signature, f);
    put_chunk(f, "IHDR", header, sizeof header, NULL, 0);
    put_chunk(f, "acTL", control, sizeof control, NULL, 0);
    return film->before != NULL;
}

/* A rectangle: x, y, width, height. */
typedef struct region {
    size_t x, y, width, height;
} region;

static int pixels_equal(const image_film *film, const unsigned char *pixels, size_t x, size_t y)
{
    size_t at = 3 * (y * film->width + x);
    return memcmp(film->before + at, pixels + at, 3) == 0;
}

/* Where a frame differs from the one before; one pixel at least. */
static region difference(const image_film *film, const unsigned char *pixels)
{
    size_t x0 = film->width, x1 = 0, y0 = film->height, y1 = 0;
    for (size_t y = 0; y < film->height; y++)
        for (size_t x = 0; x < film->width; x++)
            if (!pixels_equal(film, pixels, x, y)) {
                x0 = x < x0 ? x : x0;
                x1 = x > x1 ? x : x1;
                y0 = y < y0 ? y : y0;
                y1 = y;
            }
    region all = {0, 0, film->width, film->height}, none = {0, 0, 1, 1}, some = {x0, y0, x1 - x0 + 1, y1 - y0 + 1};
    return film->frame == 0 ? all : x0 > x1 ? none : some;
}

/* fcTL: the rectangle, the time, and that it replaces what was there. */
static void put_control(image_film *film, region r, double seconds)
{
    unsigned char control[26] = {0};
    double ms = seconds > 0.0 ? seconds * 1000.0 + 0.5 : 1.0;
    unsigned delay = ms < 65535.0 ? (unsigned)ms : 65535u;
    put_u32(control, film->sequence++);
    put_u32(control + 4, (unsigned long)r.width);
    put_u32(control + 8, (unsigned long)r.height);
    put_u32(control + 12, (unsigned long)r.x);
    put_u32(control + 16, (unsigned long)r.y);
    control[20] = (unsigned char)(delay >> 8);
    control[21] = (unsigned char)(delay & 255);
    control[22] = 1000 >> 8;
    control[23] = 1000 & 255;
    put_chunk(film->file, "fcTL", control, sizeof control, NULL, 0);
}

/* The IDAT chunks of a whole PNG file: as they are for the first frame, as fdAT with a number for the others. */
static void put_data(image_film *film, const unsigned char *png, size_t bytes)
{
    for (size_t at = 8; at + 12 <= bytes;) {
        size_t length = u32_at(png + at);
        if (memcmp(png + at + 4, "IDAT", 4) == 0) {
            unsigned char number[4] = {0};
            if (film->frame > 0)
                put_u32(number, film->sequence++);
            put_chunk(film->file, film->frame > 0 ? "fdAT" : "IDAT", number, film->frame > 0 ? 4 : 0, png + at + 8,
                      length);
        }
        at += length + 12;
    }
}

int image_film_add(image_film *film, const unsigned char *pixels, double seconds)
{
    png_image image;
    region r = difference(film, pixels);
    const unsigned char *first = pixels + 3 * (r.y * film->width + r.x);
    describe(&image, r.width, r.height);
    png_alloc_size_t bytes = PNG_IMAGE_PNG_SIZE_MAX(image);
    unsigned char *png = (unsigned char *)malloc(bytes);
    int fine = png && png_image_write_to_memory(&image, png, &bytes, 0, first, (png_int_32)(3 * film->width), NULL);
    if (fine) {
        put_control(film, r, seconds);
        put_data(film, png, bytes);
        memcpy(film->before, pixels, 3 * film->width * film->height);
        film->frame++;
    }
    png_image_free(&image);
    free(png);
    return fine && !ferror(film->file);
}

void image_film_close(image_film *film)
{
    if (film->file && film->frame == film->frame_count)
        put_chunk(film->file, "IEND", NULL, 0, NULL, 0);
    free(film->before);
}
