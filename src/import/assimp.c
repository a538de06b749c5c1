/* SPDX-License-Identifier: MIT */
#include "assimp.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <assimp/config.h>
#include <assimp/postprocess.h>

#include "file.h"
#include "utf8.h"

void *nkwi_assimp_take(nkwi_assimp *a, const char *place, size_t count, size_t size)
{
    const nkwi_place root = {NULL, NULL, 0}, at = {&root, place, 0};
    return nkwi_document_take(a->document, a->error, &at, count, size);
}

void *nkwi_assimp_scratch(nkwi_assimp *a, const char *place, size_t count, size_t size)
{
    void *block = nkwi_take(&a->scratch, count, size);
    if (!block) {
        const nkwi_place root = {NULL, NULL, 0}, at = {&root, place, 0};
        nkwi_fail(a->error, &at, a->scratch.exceeded ? NKW_IMPORT_TOO_LARGE : NKW_IMPORT_NO_MEMORY,
                  "no memory for %zu elements of %zu bytes", count, size);
    }
    return block;
}

const char *nkwi_assimp_name(nkwi_assimp *a, const struct aiString *name, const char *kind, size_t number)
{
    char text[sizeof name->data + 1];
    const size_t length = name->length < sizeof name->data ? name->length : sizeof name->data - 1;
    memcpy(text, name->data, length);
    text[length] = 0;
    nkwi_utf8(text, length);
    return nkwi_document_name(a->document, a->error, text, kind, number);
}

nkw_mat4 nkwi_assimp_matrix(const struct aiMatrix4x4 *m)
{
    const nkw_mat4 columns = {{m->a1, m->b1, m->c1, m->d1, m->a2, m->b2, m->c2, m->d2, m->a3, m->b3, m->c3, m->d3,
                               m->a4, m->b4, m->c4, m->d4}};
    return columns;
}

/* A text of the scene's metadata, or NULL. */
static const struct aiString *metadata(const struct aiScene *scene, const char *key)
{
    const struct aiMetadata *m = scene->mMetaData;
    for (unsigned i = 0; m && i < m->mNumProperties; i++)
        if (strcmp(m->mKeys[i].data, key) == 0 && m->mValues[i].mType == AI_AISTRING)
            return (const struct aiString *)m->mValues[i].mData;
    return NULL;
}

static int read_origin(nkwi_assimp *a)
{
    const struct aiString *format = metadata(a->scene, "SourceAsset_Format");
    const struct aiString *generator = metadata(a->scene, "SourceAsset_Generator");
    nkw_document *d = &a->document->all;
    d->format = format ? nkwi_assimp_name(a, format, "Assimp", 0) : "Assimp";
    d->generator = generator && generator->length ? nkwi_assimp_name(a, generator, "", 0) : "";
    return d->format && d->generator;
}

/* The importers' settings: no meshes made of skeletons, no materials' files; of FBX no animations and no pivots. */
static struct aiPropertyStore *settings(void)
{
    struct aiPropertyStore *store = aiCreatePropertyStore();
    if (store) {
        aiSetImportPropertyInteger(store, AI_CONFIG_IMPORT_NO_SKELETON_MESHES, 1);
        aiSetImportPropertyInteger(store, AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, 0);
        aiSetImportPropertyInteger(store, AI_CONFIG_IMPORT_FBX_READ_ANIMATIONS, 0);
        aiSetImportPropertyInteger(store, AI_CONFIG_IMPORT_FBX_READ_TEXTURES, 0);
    }
    return store;
}

/* Whether a mesh has polygons, or faces of several shapes. */
static int is_mixed(const struct aiMesh *m)
{
    for (size_t f = 0; f < m->mNumFaces; f++)
        if (m->mFaces[f].mNumIndices > 3 || m->mFaces[f].mNumIndices != m->mFaces[0].mNumIndices)
            return 1;
    return 0;
}

/*
 * Polygons become triangles, and meshes of several shapes several meshes. Both read indices that were checked. Only
 * where it is needed: a scene without faces is an error in Assimp 5.2, after which it frees the scene twice.
 */
static int process(nkwi_assimp *a)
{
    const unsigned steps = aiProcess_Triangulate | aiProcess_SortByPType;
    size_t i = 0;
    while (i < a->scene->mNumMeshes && !is_mixed(a->scene->mMeshes[i]))
        i++;
    if (i == a->scene->mNumMeshes)
        return 1;
    if (!aiApplyPostProcessing(a->scene, steps)) {
        a->scene = NULL;
        return nkwi_fail(a->error, NULL, NKW_IMPORT_INVALID, "Assimp: %s", aiGetErrorString());
    }
    return nkwi_assimp_check(a);
}

static int read_parts(nkwi_assimp *a, const nkw_import_memory *memory)
{
    return nkwi_assimp_check(a) && read_origin(a) && nkwi_assimp_tree(a) &&
           nkwi_assimp_fbx_open(a, memory) && nkwi_assimp_collada_open(a, memory) && process(a) &&
           nkwi_assimp_materials(a) && nkwi_assimp_meshes(a) && nkwi_assimp_nodes(a) && nkwi_assimp_animations(a) &&
           nkwi_assimp_x_mirrors(a, memory) && nkwi_assimp_units(a);
}

/* The name of the first file for the importer: its own, with the extension of its format. To be freed. */
static char *importer_name(const nkw_import_memory *memory)
{
    const char *file = memory->file ? memory->file : "", *extension = nkwi_assimp_extension(memory);
    const char *slash = strrchr(file, '/'), *name = slash ? slash + 1 : file, *dot = strrchr(name, '.');
    size_t stem = dot ? (size_t)(dot - name) : strlen(name), tail = strlen(extension);
    char *whole = (char *)malloc(stem + tail + 2);
    if (!whole)
        return NULL;
    memcpy(whole, name, stem);
    if (stem == 0)
        whole[stem++] = '_';
    memcpy(whole + stem, extension, tail + 1);
    return whole;
}

const struct aiScene *nkwi_assimp_import(const nkw_import_memory *memory, const char *name, nkwi_assimp_files *files)
{
    struct aiPropertyStore *store = settings();
    nkwi_assimp_files_begin(files, memory, name);
    const struct aiScene *scene = store ? aiImportFileExWithProperties(name, 0, &files->io, store) : NULL;
    if (store)
        aiReleasePropertyStore(store);
    return scene;
}

static int import(nkwi_assimp *a, const nkw_import_memory *memory, const char *name)
{
    nkwi_assimp_files files;
    nkw_import_memory trimmed = *memory;
    void *copy = NULL;
    if (strcmp(nkwi_assimp_extension(memory), ".dae") == 0 && !nkwi_assimp_collada_trim(&trimmed, &copy))
        return nkwi_fail(a->error, NULL, NKW_IMPORT_NO_MEMORY, "no memory for the text of the file");
    a->scene = nkwi_assimp_import(&trimmed, name, &files);
    free(copy);
    a->document->memory.most = a->scratch.most = NKWI_MEMORY_MOST(files.bytes);
    a->document->all.bytes = files.bytes;
    a->frame_rate = files.frame_rate;
    a->has_meshes = strcmp(nkwi_assimp_extension(memory), ".md5anim") != 0;
    if (files.fault) {
        char place[32];
        snprintf(place, sizeof place, "line %zu", files.fault);
        return nkwi_fail_at(a->error, place, NKW_IMPORT_INVALID, "the MD5 file is cut, or names what is not there");
    }
    if (a->scene)
        return 1;
    const char *reason = aiGetErrorString();
    return nkwi_fail(a->error, NULL, NKW_IMPORT_INVALID, "Assimp: %s", reason && *reason ? reason : "cannot be read");
}

/* Equal in any case; `small` is in small letters. */
static int is_same(const char *text, const char *small)
{
    for (; *small; text++, small++)
        if ((*text >= 'A' && *text <= 'Z' ? *text - 'A' + 'a' : *text) != *small)
            return 0;
    return !*text;
}

/* Not glTF and OBJ, which have readers of their own, also where their content is of none. */
int nkwi_assimp_is(const nkw_import_memory *memory)
{
    const char *extension = nkwi_assimp_extension(memory);
    static const char *const own[] = {".gltf", ".glb", ".vrm", ".obj"};
    for (size_t i = 0; i < sizeof own / sizeof *own; i++)
        if (is_same(extension, own[i]))
            return 0;
    return memory->bytes > 0 && extension[0] && aiIsExtensionSupported(extension);
}

int nkwi_assimp_read(nkwi_document *document, const nkw_import_memory *memory, nkw_import_error *error)
{
    nkwi_assimp a;
    memset(&a, 0, sizeof a);
    a.document = document;
    a.error = error;
    char *name = importer_name(memory);
    int done = name ? import(&a, memory, name) && read_parts(&a, memory)
                    : nkwi_fail(error, NULL, NKW_IMPORT_NO_MEMORY, "no memory for the name of the file");
    aiReleaseImport(a.scene);
    nkwi_assimp_fbx_close(&a);
    nkwi_assimp_collada_close(&a);
    nkwi_give(&a.scratch);
    free(name);
    return done;
}
