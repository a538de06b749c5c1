/* SPDX-License-Identifier: MIT */
/*
 * glTF 2.0, 3.8: textures and images. What is wrong with one is no error of the file: nothing but its own picture needs
 * it. Outer files are not read.
 */
#include <string.h>

#include "file.h"
#include "gltf.h"

int nkwi_gltf_images(nkwi_gltf *g)
{
    nkwi_value list;
    size_t count;
    if (!nkwi_gltf_list(g, "images", &list, &count))
        return 0;
    g->images = (nkw_document_image *)nkwi_gltf_take(g, &list, count, sizeof *g->images);
    g->image_is_read = (unsigned char *)nkwi_gltf_scratch(g, &list, count, 1);
    if (!g->images || !g->image_is_read)
        return 0;
    g->document->all.images = g->images;
    g->document->all.image_count = count;
    for (size_t i = 0; i < count; i++) {
        nkwi_value object = nkwi_element(&list, i);
        g->images[i].name = nkwi_gltf_name(g, &object, "image");
        if (!g->images[i].name)
            return 0;
    }
    return 1;
}

static int copy_view(nkwi_gltf *g, const nkwi_value *object, nkw_document_image *image)
{
    const unsigned char *data;
    size_t bytes;
    if (!nkwi_gltf_view(g, object, &data, &bytes))
        return 0;
    void *copy = nkwi_gltf_take(g, object, bytes, 1);
    if (!copy)
        return 0;
    memcpy(copy, data, bytes);
    image->data = copy;
    image->bytes = bytes;
    return 1;
}

static int decode_data(nkwi_gltf *g, const nkwi_value *object, const char *uri, nkw_document_image *image)
{
    size_t room = strlen(uri), bytes;
    unsigned char *data = (unsigned char *)nkwi_gltf_take(g, object, room, 1);
    if (!data || nkwi_bytes_from_uri(uri, data, room, &bytes) || bytes > room)
        return 0;
    image->data = data;
    image->bytes = bytes;
    return 1;
}

static int name_file(nkwi_gltf *g, const nkwi_value *object, const char *uri, nkw_document_image *image)
{
    char *path = (char *)nkwi_gltf_take(g, object, strlen(uri) + 1, 1);
    if (!path || nkwi_path_from_uri(uri, path))
        return 0;
    image->path = path;
    return 1;
}

static int read_image(nkwi_gltf *g, const nkwi_value *object, nkw_document_image *image)
{
    const char *uri = nkwi_text(object, "uri", NULL);
    if (!uri)
        return copy_view(g, object, image);
    return strncmp(uri, "data:", 5) == 0 ? decode_data(g, object, uri, image) : name_file(g, object, uri, image);
}

static int find_image(nkwi_gltf *g, const nkwi_value *object, const char *key, int32_t *image, size_t *set)
{
    nkwi_value info = nkwi_member(object, key), textures = nkwi_member(&g->root, "textures");
    int32_t texture = NKW_NO_JOINT;
    *image = NKW_NO_JOINT;
    if (!nkwi_index(g->error, &info, "index", "texture", nkwi_length(&textures), &texture) ||
        !nkwi_count(g->error, &info, "texCoord", 0, set) || texture == NKW_NO_JOINT)
        return 0;
    nkwi_value element = nkwi_element(&textures, (size_t)texture);
    return nkwi_index(g->error, &element, "source", "image", g->document->all.image_count, image) &&
           *image != NKW_NO_JOINT;
}

const nkw_document_image *nkwi_gltf_texture(nkwi_gltf *g, const nkwi_value *object, const char *key, size_t *set)
{
    const nkw_import_error before = *g->error;
    int32_t index;
    nkw_document_image *image = NULL;
    *set = 0;
    if (find_image(g, object, key, &index, set)) {
        nkwi_value list = nkwi_member(&g->root, "images"), at = nkwi_element(&list, (size_t)index);
        image = &g->images[index];
        if (!g->image_is_read[index])
            read_image(g, &at, image);
        g->image_is_read[index] = 1;
    }
    *g->error = before;
    *set = image ? *set : 0;
    return image;
}
