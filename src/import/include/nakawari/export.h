/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Above the library: documents as glTF 2.0 files, and as OBJ at one time. Part of nakawari::import.
 *
 *     nkw_gltf_file file;
 *     if (nkw_document_write(document, NKW_GLTF_BINARY, NULL, &file, &error) == NKW_IMPORT_OK)
 *         fwrite(file.data, 1, file.bytes, out);
 *     nkw_gltf_file_free(&file);
 *
 * To change a document, copy the structure nkw_document, not what it points to, and replace its arrays: a writer reads
 * the fields only. The same document is written with the same bytes everywhere.
 *
 * glTF has no two keys at one time and no interpolation per key. A jump becomes two keys whose times differ by one ULP.
 * STEP segments between LINEAR or CUBICSPLINE ones become a key more, one ULP before the next. LINEAR segments of
 * numbers between CUBICSPLINE ones become cubics of the same values; such a rotation is an error: resample it first.
 *
 * docs/import.md states what is written.
 */
#ifndef NAKAWARI_EXPORT_H
#define NAKAWARI_EXPORT_H

#include "import.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The form of a file. */
typedef enum nkw_gltf_form {
    NKW_GLTF_BINARY, /**< .glb */
    NKW_GLTF_TEXT, /**< .gltf, its buffer as a data URI */
    NKW_GLTF_OUTER, /**< .gltf, its buffer in a file of its own */
    NKW_GLTF_FORM_MAX_ENUM = 0x7fffffff
} nkw_gltf_form;

/** Bytes to be written, freed by nkw_gltf_file_free. */
typedef struct nkw_gltf_file {
    unsigned char *data;
    size_t bytes;
    unsigned char *outer; /**< of NKW_GLTF_OUTER: the buffer; NULL without one */
    size_t outer_bytes;
    size_t outer_images; /**< how many images are files of their own, which this one names */
    size_t outer_image; /**< the number of the first of these in the document */
} nkw_gltf_file;
NKW_SIZE(nkw_gltf_file, 48, 24);

/**
 * Writes a document: nodes, skins, meshes with all that is read of them, morph targets, the names, base colours and
 * pictures of materials, scenes, animations. Nodes have the numbers of the file. Nothing else of the file is written:
 * no other textures, cameras, lights, extensions, extras. Pictures are PNG or JPEG; an outer one remains a name.
 *
 * Of a document whose format is not "glTF 2.0" the numbers are made valid: weights of sum 1, one for each joint; unit
 * normals and tangents, of a vertex without one that of its triangles; colours in 0..1; the last row of inverse bind
 * matrices 0 0 0 1. Times before 0 and matrices with shear remain.
 *
 * uri      of NKW_GLTF_OUTER: the path of the outer file, relative to the first; otherwise not read
 * file     receives the bytes; zeros after an error
 * error    receives what went wrong; its place is that of the part; may be NULL
 * Returns  error->code: NKW_IMPORT_UNSUPPORTED for tracks that glTF does not have, NKW_IMPORT_TOO_LARGE for 4 GiB
 */
NKW_API nkw_import_result nkw_document_write(const nkw_document *document, nkw_gltf_form form, const char *uri,
                                             nkw_gltf_file *file, nkw_import_error *error);

/** A glTF file whose animations are replaced. */
typedef struct nkw_gltf_rewriting {
    const nkw_import_memory
        *source; /**< the bytes of the file; outer files are read as nkw_document_from_memory does */
    const nkw_document *from; /**< the document of these bytes */
    const nkw_document *to; /**< the same with other tracks: as many animations; channels may be left out */
    int embeds_images; /**< whether outer images become part of the file, as of a GLB, or in another folder: those that
                            can be read and are PNG, JPEG, WebP or KTX2 */
} nkw_gltf_rewriting;
NKW_SIZE(nkw_gltf_rewriting, 32, 16);

/**
 * Writes a glTF file with other animations and everything else as it is: materials, textures, cameras, extensions,
 * extras. If any track has other arrays than in `from`, or is left out, all keys are written anew and the old bytes are
 * dropped; values keep the integer type of their accessor if that is exact. All buffers become one.
 *
 * A channel of `from` whose number no channel of `to` has is left out of the file. At least one of an animation remains.
 *
 * Returns  as nkw_document_write; NKW_IMPORT_REFUSED for a `to` with channels that `from` does not have, in another
 *          order, with other targets, or without any; the errors of reading; NKW_IMPORT_UNSUPPORTED for
 *          files with EXT_meshopt_compression
 */
NKW_API nkw_import_result nkw_gltf_rewrite(const nkw_gltf_rewriting *rewriting, nkw_gltf_form form, const char *uri,
                                           nkw_gltf_file *file, nkw_import_error *error);

/** Frees the bytes and sets zeros. */
NKW_API void nkw_gltf_file_free(nkw_gltf_file *file);

/* ---- OBJ ---- */

/** What an OBJ file shows of a document. All zero: the rest pose, without materials. */
typedef struct nkw_obj_writing {
    const nkw_mat4 *models; /**< the model matrices of all joints; NULL: of the rest pose */
    const float *floats; /**< float_count morph weights; NULL: rest_floats */
    const char *materials; /**< the name of the MTL file, as mtllib has it; NULL: no materials */
    const char *const *images; /**< image_count names of pictures, NULL for none; or NULL: the path of each */
    int v_is_up; /**< as the document was read: nkw_import_memory.v_is_up. v is always upwards in OBJ */
} nkw_obj_writing;
NKW_SIZE(nkw_obj_writing, 40, 20);

/** Texts to be written, freed by nkw_obj_file_free. A 0 follows each. */
typedef struct nkw_obj_file {
    char *data;
    size_t bytes;
    char *materials; /**< the MTL file; NULL without materials */
    size_t material_bytes;
} nkw_obj_file;
NKW_SIZE(nkw_obj_file, 32, 16);

/**
 * Writes a document at one time as OBJ: for each node with a mesh an object with its vertices (nkw_document_vertices),
 * in the space of the models. Triangles keep their order; under a mirror their corners are exchanged, so that fronts
 * stay fronts. Numbers are the shortest that are read as the same floats. Equal positions, texture coordinates and
 * normals are one line. Of the materials the colour, the opacity and the picture are written; what has no material,
 * where others have one, gets a white one.
 *
 * OBJ has neither animations nor skins nor nodes below nodes. It has one set of texture coordinates: the first.
 * Tangents, and the opacity of vertex colours, are not written.
 *
 * file     receives the bytes; zeros after an error
 * error    receives what went wrong; may be NULL
 * Returns  error->code: NKW_IMPORT_UNSUPPORTED for a document without vertices, NKW_IMPORT_REFUSED for a skin that
 *          nkw_skin_linear refuses
 */
NKW_API nkw_import_result nkw_document_write_obj(const nkw_document *document, const nkw_obj_writing *writing,
                                                 nkw_obj_file *file, nkw_import_error *error);

/** Frees the bytes and sets zeros. */
NKW_API void nkw_obj_file_free(nkw_obj_file *file);

#ifdef __cplusplus
}
#endif

#endif
