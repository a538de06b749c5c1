/* SPDX-License-Identifier: MIT */
/* The images of a file that is rewritten (rewrite.h): outer files become views of the buffer, if asked. */
#include <string.h>

#include "file.h"
#include "rewrite.h"

/* The types of core glTF, EXT_texture_webp and KHR_texture_basisu; NULL for another. */
static const char *type_of(const unsigned char *data, size_t bytes)
{
    if (bytes > 12 && memcmp(data, "RIFF", 4) == 0 && memcmp(data + 8, "WEBP", 4) == 0)
        return "image/webp";
    if (bytes > 12 && memcmp(data, "\xabKTX 20\xbb\r\n\x1a\n", 12) == 0)
        return "image/ktx2";
    return nkwi_image_type(data, bytes);
}

/* The path of an outer image; NULL of others. */
static const char *outer_of(const json_t *image)
{
    const char *uri = json_string_value(json_object_get(image, "uri"));
    return uri && strncmp(uri, "data:", 5) != 0 ? uri : NULL;
}

/* An outer image becomes a view. One that cannot be read, or is of another type, remains a name. */
static void embed_image(nkwi_rewriter *r, json_t *image)
{
    const char *uri = outer_of(image);
    if (!uri || !r->g.memory->reader)
        return;
    char *path = (char *)nkwi_take(&r->sink.scratch, strlen(uri) + 1, 1);
    if (!path || nkwi_path_from_uri(uri, path))
        return;
    size_t bytes = r->g.memory->reader(r->g.memory->user, path, NULL, 0);
    unsigned char *data = bytes < NKWI_BYTES_MOST ? (unsigned char *)nkwi_take(&r->sink.scratch, bytes + 1, 1) : NULL;
    if (!data || r->g.memory->reader(r->g.memory->user, path, data, bytes) == SIZE_MAX || !type_of(data, bytes))
        return;
    json_t *view = json_object();
    nkwi_set(&r->sink, view, "buffer", json_integer(0));
    nkwi_set(&r->sink, view, "byteOffset", json_integer((json_int_t)nkwi_sink_append(&r->sink, data, bytes)));
    nkwi_set(&r->sink, view, "byteLength", json_integer((json_int_t)bytes));
    nkwi_set(&r->sink, view, "new", json_true());
    nkwi_set(&r->sink, image, "bufferView", json_integer((json_int_t)json_array_size(r->sink.views)));
    nkwi_set(&r->sink, image, "mimeType", json_string(type_of(data, bytes)));
    nkwi_put(&r->sink, r->sink.views, view);
    json_object_del(image, "uri");
}

void nkwi_rewriter_images(nkwi_rewriter *r, nkw_gltf_file *file)
{
    json_t *images = json_object_get(r->root, "images");
    for (size_t i = 0; i < json_array_size(images); i++) {
        json_t *image = json_array_get(images, i);
        if (r->rewriting->embeds_images)
            embed_image(r, image);
        if (outer_of(image))
            file->outer_image = file->outer_images++ ? file->outer_image : i;
    }
}
