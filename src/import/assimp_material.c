/* SPDX-License-Identifier: MIT */
/* Materials of a scene of Assimp: names, base colours and their pictures. */
#include <stdlib.h>
#include <string.h>

#include "assimp.h"
#include "file.h"

#include <assimp/material.h>

/* "*3" is the fourth texture of the scene; only compressed ones are files. */
static int copy_texture(nkwi_assimp *a, const char *number, nkw_document_image *image)
{
    unsigned long index = strtoul(number, NULL, 10);
    const struct aiTexture *t =
        index < a->scene->mNumTextures && a->scene->mTextures ? a->scene->mTextures[index] : NULL;
    if (!t || t->mHeight != 0 || !t->pcData)
        return 1;
    void *copy = nkwi_assimp_take(a, "images", t->mWidth, 1);
    if (!copy)
        return 0;
    memcpy(copy, t->pcData, t->mWidth);
    image->data = copy;
    image->bytes = t->mWidth;
    return 1;
}

/* The picture of a material, if it has one. What is wrong with its name is no error of the file. */
static int read_image(nkwi_assimp *a, const struct aiMaterial *m, nkw_document_image *images,
                      nkw_document_material *out)
{
    struct aiString name = {0, {0}};
    nkw_document *d = &a->document->all;
    enum aiTextureType type =
        aiGetMaterialTextureCount(m, aiTextureType_BASE_COLOR) ? aiTextureType_BASE_COLOR : aiTextureType_DIFFUSE;
    unsigned set = 0;
    if (aiGetMaterialTexture(m, type, 0, &name, NULL, &set, NULL, NULL, NULL, NULL) != aiReturn_SUCCESS || !name.length)
        return 1;
    nkw_document_image *image = &images[d->image_count];
    image->name = nkwi_assimp_name(a, &name, "image", d->image_count++);
    out->image = image;
    out->image_texcoords = set;
    if (!image->name)
        return 0;
    if (name.data[0] == '*')
        return copy_texture(a, name.data + 1, image);
    char *path = (char *)nkwi_assimp_take(a, "images", strlen(image->name) + 1, 1);
    image->path = path && !nkwi_path_from_name(image->name, path) ? path : NULL;
    return path != NULL;
}

static int read_material(nkwi_assimp *a, const struct aiMaterial *m, nkw_document_material *out)
{
    struct aiColor4D color = {1.0f, 1.0f, 1.0f, 1.0f};
    struct aiString name = {0, {0}};
    if (m && aiGetMaterialColor(m, AI_MATKEY_BASE_COLOR, &color) != aiReturn_SUCCESS)
        aiGetMaterialColor(m, AI_MATKEY_COLOR_DIFFUSE, &color);
    if (m)
        aiGetMaterialString(m, AI_MATKEY_NAME, &name);
    const float numbers[4] = {color.r, color.g, color.b, color.a};
    memcpy(out->color, numbers, sizeof numbers);
    out->name = nkwi_assimp_name(a, &name, "material", a->document->all.material_count);
    return out->name != NULL;
}

int nkwi_assimp_materials(nkwi_assimp *a)
{
    nkw_document *d = &a->document->all;
    size_t count = a->scene->mMaterials ? a->scene->mNumMaterials : 0;
    nkw_document_material *list = (nkw_document_material *)nkwi_assimp_take(a, "materials", count, sizeof *list);
    nkw_document_image *images = (nkw_document_image *)nkwi_assimp_take(a, "images", count, sizeof *images);
    if (!list || !images)
        return 0;
    d->materials = list;
    d->images = images;
    for (; d->material_count < count; d->material_count++) {
        const struct aiMaterial *m = a->scene->mMaterials[d->material_count];
        if (!read_material(a, m, &list[d->material_count]) ||
            (m && !read_image(a, m, images, &list[d->material_count])))
            return 0;
    }
    return 1;
}
