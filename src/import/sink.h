/* SPDX-License-Identifier: MIT */
/* A glTF file while it is written: a buffer that grows, its views and accessors, and the keys of tracks. */
#ifndef NAKAWARI_IMPORT_SINK_H
#define NAKAWARI_IMPORT_SINK_H

#include <jansson.h>

#include <nakawari/export.h>

#include "gltf.h"

typedef struct nkwi_sink {
    nkw_import_error *error;
    unsigned char *data; /* of the buffer */
    size_t bytes, room;
    json_t *views, *accessors; /* arrays; of the tree that is written */
    json_t *view; /* the view of keys; its bytes end where the buffer ends */
    size_t view_index, view_start;
    nkwi_memory scratch;
    struct nkwi_known *known; /* accessors of keys that exist already */
    size_t known_count, known_room;
    int failed; /* no memory */
} nkwi_sink;

/* Where the numbers of an accessor are, and what they are. */
typedef struct nkwi_numbers {
    nkwi_component component;
    int normalized;
    size_t width; /* components of an element: 1, 2, 3, 4 or 16 */
    size_t count; /* of elements */
    const void *data; /* in the byte order of this machine */
    int bounds; /* whether the least and the greatest of each component are stated */
    int target; /* of the view: 34962 of vertices, 34963 of indices, or 0 */
} nkwi_numbers;

void nkwi_sink_open(nkwi_sink *s, nkw_import_error *error, json_t *views, json_t *accessors);
void nkwi_sink_close(nkwi_sink *s);

/* Appends bytes, at a multiple of four. Returns where they are. */
size_t nkwi_sink_append(nkwi_sink *s, const void *data, size_t bytes);

/* An accessor in a view of its own. Returns its index. */
size_t nkwi_sink_numbers(nkwi_sink *s, const nkwi_numbers *numbers);

/* Begins and ends the view that the keys of all tracks share. */
void nkwi_sink_begin_keys(nkwi_sink *s);
void nkwi_sink_end_keys(nkwi_sink *s);

/*
 * The sampler of a track, as JSON. `component` is the type of its values, if they have it exactly; NULL, and the error,
 * if glTF has no such track.
 */
json_t *nkwi_sink_sampler(nkwi_sink *s, const nkw_clip_track *track, const nkwi_place *place, nkwi_component component);

/* A view of bytes, appended. Returns its index. */
size_t nkwi_sink_bytes(nkwi_sink *s, const void *data, size_t bytes);

/* The media type of a picture that glTF allows: PNG or JPEG; NULL for any other. */
const char *nkwi_image_type(const void *data, size_t bytes);

/* The file of the tree, whose buffer is that of the sink. `precision`: significant digits of numbers. */
int nkwi_sink_write(nkwi_sink *s, json_t *root, nkw_gltf_form form, const char *uri, size_t precision,
                    nkw_gltf_file *file);

/* json_object_set_new and json_array_append_new; without memory the sink has failed. */
void nkwi_set(nkwi_sink *s, json_t *object, const char *key, json_t *value);
void nkwi_put(nkwi_sink *s, json_t *array, json_t *value);
/* A number, 0 in place of one that is not finite; a text, ? in place of bytes that are not UTF-8. */
json_t *nkwi_real(double number);
json_t *nkwi_string(nkwi_sink *s, const char *text);
/* A path as a URI: bytes that a URI has not, in hexadecimal digits after %. */
json_t *nkwi_uri(nkwi_sink *s, const char *path);
json_t *nkwi_floats_of(nkwi_sink *s, const float *values, size_t count);

#endif
