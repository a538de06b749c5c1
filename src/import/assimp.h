/* SPDX-License-Identifier: MIT */
/*
 * The bridge to Assimp: all formats except glTF, BVH, OBJ and keys. Everything of a scene is checked before it is used:
 * counts, indices, names. docs/importers.md states what each importer loses.
 */
#ifndef NAKAWARI_IMPORT_ASSIMP_H
#define NAKAWARI_IMPORT_ASSIMP_H

#include <assimp/cfileio.h>
#include <assimp/cimport.h>
#include <assimp/scene.h>

#include "document.h"

/* A name of a node, and its index. */
typedef struct nkwi_assimp_name_index {
    const char *name;
    int32_t node;
} nkwi_assimp_name_index;

/* A node of the document that is none of the scene (assimp_fbx.h): the scale of a node, or what FBX applies to its mesh
 * alone. */
typedef enum nkwi_assimp_extra_kind { NKWI_ASSIMP_SCALE, NKWI_ASSIMP_GEOMETRY } nkwi_assimp_extra_kind;

typedef struct nkwi_assimp_extra {
    size_t node; /* of the tree, whose part it is */
    nkwi_assimp_extra_kind kind;
    size_t parent; /* a number of the document's list */
    nkw_trs rest;
} nkwi_assimp_extra;

/* A joint of a skin: a node, and its inverse bind matrix. next: another entry of the same node. */
typedef struct nkwi_assimp_bone {
    int32_t node, next;
    nkw_mat4 inverse_bind;
} nkwi_assimp_bone;

typedef struct nkwi_assimp_skin {
    const nkwi_assimp_bone *bones;
    size_t count;
} nkwi_assimp_skin;

typedef struct nkwi_assimp {
    nkwi_document *document;
    nkw_import_error *error;
    const struct aiScene *scene;
    nkwi_memory scratch; /* until the file is read */
    /* Nodes in the order of the tree: a node, then its first child with all below, and so on. */
    const struct aiNode **nodes;
    int32_t *parents;
    nkw_mat4 *locals;
    size_t node_count;
    nkwi_assimp_name_index *by_name; /* sorted */
    /* Numbers of the document's list of nodes, where a node has its own index; the extras follow. */
    size_t *carrier; /* what has the scale of a node: the joint of bones, and the parent of nodes below */
    size_t *mesh_carrier; /* what has the mesh of a node */
    unsigned char *is_split; /* its scale is an extra */
    nkw_trs *rests; /* of FBX and Collada */
    nkwi_assimp_extra *extras;
    size_t extra_count;
    struct nkwi_assimp_fbx *fbx; /* or NULL */
    struct nkwi_assimp_collada *collada; /* or NULL */
    nkw_document_primitive *primitives; /* of each aiMesh; joints are bones of the mesh */
    double frame_rate; /* as in nkwi_assimp_files */
    int has_meshes; /* not where Assimp adds a picture of the skeleton */
    nkwi_assimp_skin *skins; /* of each skin, as nodes of the tree */
    uint32_t *uses; /* node_count, for nkwi_assimp_find_nth */
} nkwi_assimp;

/* The files that an importer asks for (assimp_file.c). */
typedef struct nkwi_assimp_files {
    struct aiFileIO io;
    const nkw_import_memory *memory;
    const char *name; /* of the first file, as the importer gets it */
    size_t bytes; /* of all files that were read */
    size_t fault; /* of MD5: the line of nkwi_assimp_md5_fault of a file that was not opened for it; otherwise 0 */
    double frame_rate; /* of MD5: frameRate of the .md5anim that was opened; otherwise 0 */
} nkwi_assimp_files;

/* The scene of the first file, whose name for the importer is `name`; NULL, and the reason of Assimp, without one. */
const struct aiScene *nkwi_assimp_import(const nkw_import_memory *memory, const char *name, nkwi_assimp_files *files);

void nkwi_assimp_files_begin(nkwi_assimp_files *files, const nkw_import_memory *memory, const char *name);

/* The first line of an .md5mesh or .md5anim that would harm Assimp (assimp_md5.c), counted from 1; 0 for none. */
size_t nkwi_assimp_md5_fault(const void *data, size_t bytes);

/* The extension of a file with a dot, by its content, then by its name; "" for neither. */
const char *nkwi_assimp_extension(const nkw_import_memory *memory);

/* Memory until the file is read, and of the document. */
void *nkwi_assimp_scratch(nkwi_assimp *a, const char *place, size_t count, size_t size);
void *nkwi_assimp_take(nkwi_assimp *a, const char *place, size_t count, size_t size);

/* A name as UTF-8; "KIND_NUMBER" where it is empty. */
const char *nkwi_assimp_name(nkwi_assimp *a, const struct aiString *name, const char *kind, size_t number);

/* The first node of this name, or NKW_NO_JOINT. */
int32_t nkwi_assimp_find(const nkwi_assimp *a, const char *name);

/*
 * Of several nodes with this name the first, in the next call the second, and so on, in the order of the tree; after
 * the last the first. uses: node_count numbers, zeros before the first call.
 */
int32_t nkwi_assimp_find_nth(const nkwi_assimp *a, const char *name, uint32_t *uses);

/* The joint of a node of the tree, and that which has its scale. */
int32_t nkwi_assimp_joint(const nkwi_assimp *a, int32_t node);
int32_t nkwi_assimp_bone_joint(const nkwi_assimp *a, int32_t node);

nkw_mat4 nkwi_assimp_matrix(const struct aiMatrix4x4 *m);

/* The parts of a scene, in this order. */
int nkwi_assimp_check(nkwi_assimp *a); /* counts and indices of meshes */
int nkwi_assimp_check_node(nkwi_assimp *a, size_t node); /* its meshes exist */
int nkwi_assimp_tree(nkwi_assimp *a);
int nkwi_assimp_materials(nkwi_assimp *a);
int nkwi_assimp_meshes(nkwi_assimp *a);
int nkwi_assimp_join(nkwi_assimp *a, nkw_document_primitive *p, uint32_t *indices); /* equal vertices */
int nkwi_assimp_nodes(nkwi_assimp *a);
int nkwi_assimp_instances(nkwi_assimp *a, nkw_document_node *list); /* meshes and skins of nodes */
int nkwi_assimp_skins(nkwi_assimp *a); /* joints of skins, after the nodes are sorted */
int nkwi_assimp_animations(nkwi_assimp *a);
int nkwi_assimp_x_mirrors(nkwi_assimp *a, const nkw_import_memory *memory); /* matrix keys of X that mirror */
int nkwi_assimp_units(nkwi_assimp *a); /* rotation keys that are none */
/* Keys as the next track of an animation, whose lists have room. */
struct nkwi_fbx_baked;
int nkwi_assimp_store(nkwi_assimp *a, nkw_document_animation *out, nkw_clip_target target, int32_t joint, size_t width,
                      const struct nkwi_fbx_baked *baked);

/*
 * Collada, beside Assimp (assimp_collada.c): nodes, after the tree is read; animations; the name of a node, or NULL.
 * Other formats have none.
 */
int nkwi_assimp_collada_open(nkwi_assimp *a, const nkw_import_memory *memory);
int nkwi_assimp_collada_animations(nkwi_assimp *a);
const char *nkwi_assimp_collada_name(const nkwi_assimp *a, size_t node);
void nkwi_assimp_collada_close(nkwi_assimp *a);
/*
 * The file for Assimp, to be freed: without animations, which it loses, and on some targets of which it fails; with
 * blanks at the end of a text that were at its beginning, where it takes them for a number.
 */
int nkwi_assimp_collada_trim(nkw_import_memory *memory, void **copy);

/* FBX, beside Assimp (assimp_fbx.c): nodes, after the tree is read; animations. Other formats have neither. */
int nkwi_assimp_fbx_open(nkwi_assimp *a, const nkw_import_memory *memory);
int nkwi_assimp_fbx_animations(nkwi_assimp *a);
void nkwi_assimp_fbx_close(nkwi_assimp *a);
/* The inverse bind matrix of a bone for the mesh of a node, if a cluster of the file states it. */
int nkwi_assimp_fbx_bind(nkwi_assimp *a, size_t node, size_t bone, nkw_mat4 *matrix);
/* What FBX applies to the mesh of a node alone. */
void nkwi_assimp_fbx_geometry(const nkwi_assimp *a, size_t node, nkw_mat4 *matrix);
/* The weights of the morph targets of a node at rest. */
int nkwi_assimp_fbx_weights(nkwi_assimp *a, size_t node, size_t count, float *weights);
/* Whether a node is below the node without the scale of its parent. */
int nkwi_assimp_fbx_is_apart(const nkwi_assimp *a, size_t node);

#endif
