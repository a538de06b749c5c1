/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Above the library: files. An animation file becomes a document: its nodes, skins, meshes and animations, in the types
 * and in the order of the library. Target nakawari::import; it allocates memory and uses a JSON library, and Assimp if it
 * was there when this was built.
 *
 *     nkw_document *document;
 *     nkw_import_error error;
 *     nkw_clip *clip;
 *     if (nkw_document_open("fox.glb", &document, &error) != NKW_IMPORT_OK ||
 *         nkw_document_clip(document, 0, NKW_CLIP_FLOAT32, &clip, &error) != NKW_IMPORT_OK)
 *         fprintf(stderr, "%s:%s: %s\n", error.file, error.place, error.reason);
 *
 * Then nkw_clip_sample, nkw_document_models and nkw_document_palette compute the pose, the model matrices and the
 * palette at a time, nkw_document_vertices the vertices.
 *
 * All nodes of a file are joints, sorted by nkw_skeleton_from_parents: parents before their children. Every index of a
 * node in a document is an index of a joint; `number` is the index in the file. Indices are valid: reading checks them.
 * Values are those of the file: reading does not check key times, keys, weights, or the joint indices of vertices. The
 * functions that build data from them do.
 *
 * docs/import.md states what is read from each format.
 */
#ifndef NAKAWARI_IMPORT_H
#define NAKAWARI_IMPORT_H

#include <nakawari/axes.h>
#include <nakawari/box.h>
#include <nakawari/character.h>
#include <nakawari/clip.h>
#include <nakawari/palette.h>
#include <nakawari/skeleton.h>
#include <nakawari/skin.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The kinds of errors. NKW_IMPORT_OK is 0. */
typedef enum nkw_import_result {
    NKW_IMPORT_OK,
    NKW_IMPORT_UNREADABLE, /**< a file does not exist, cannot be read, or is outside the folder of the first file */
    NKW_IMPORT_NO_MEMORY, /**< the system has no memory */
    NKW_IMPORT_TOO_LARGE, /**< a count or a size exceeds a limit of docs/import.md */
    NKW_IMPORT_UNKNOWN, /**< a file of no known format */
    NKW_IMPORT_INVALID, /**< a file that violates its format */
    NKW_IMPORT_UNSUPPORTED, /**< a valid file that needs a version or an extension that is not read */
    NKW_IMPORT_REFUSED, /**< values that a function of the library refuses, as nkw_import_error.result states */
    NKW_IMPORT_RESULT_MAX_ENUM = 0x7fffffff
} nkw_import_result;

/** What went wrong, and where. All texts end with 0; a text that is too long is cut. */
typedef struct nkw_import_error {
    nkw_import_result code;
    nkw_result result; /**< of the function of the library, for NKW_IMPORT_REFUSED; otherwise NKW_OK */
    char file[512]; /**< the file; of a longer path the end */
    char place[160]; /**< a JSON pointer: /animations/2/samplers/0/input; byte 12; line 3, column 14; or "" */
    char reason[256]; /**< in English, without a full stop */
} nkw_import_error;
NKW_SIZE(nkw_import_error, 936, 936);

/** A node of the file, and joint of the skeleton. */
typedef struct nkw_document_node {
    const char *name; /**< never NULL; "node_3" if node 3 of the file has no name */
    size_t number; /**< the index in the file */
    nkw_trs rest; /**< of a node with a matrix: nkw_trs_from_mat4 */
    const nkw_mat4 *matrix; /**< the matrix of a node that has one in the file and that no channel animates; or NULL */
    int32_t mesh; /**< an index of meshes, or NKW_NO_JOINT */
    int32_t skin; /**< an index of skins, or NKW_NO_JOINT */
    uint32_t float_first; /**< the first of its morph weights in the floats of clips */
    uint32_t float_count; /**< the number of its morph weights: the targets of its mesh */
    int is_view; /**< 1 if it has a camera or a light, in glTF */
} nkw_document_node;
NKW_SIZE(nkw_document_node, 88, 72);

/** Joints and their inverse bind matrices. The joints of vertices are indices of these arrays. */
typedef struct nkw_document_skin {
    const char *name;
    const int32_t *joints; /**< joint_count joints of the skeleton */
    const nkw_mat4 *inverse_bind; /**< joint_count matrices; NULL if the file has none: identities */
    size_t joint_count;
} nkw_document_skin;
NKW_SIZE(nkw_document_skin, 32, 16);

/** Differences of a morph target: vertex_count elements each; NULL: none. */
typedef struct nkw_document_target {
    const nkw_vec3 *positions, *normals, *tangents;
} nkw_document_target;
NKW_SIZE(nkw_document_target, 24, 12);

/** What three indices, two or one of a primitive form. Strips, fans and loops of the file become lists. */
typedef enum nkw_document_topology {
    NKW_DOCUMENT_POINTS,
    NKW_DOCUMENT_LINES,
    NKW_DOCUMENT_TRIANGLES,
    NKW_DOCUMENT_TOPOLOGY_MAX_ENUM = 0x7fffffff
} nkw_document_topology;

/** A part of a mesh with one material. Arrays that the file does not have are NULL. */
typedef struct nkw_document_primitive {
    nkw_document_topology topology;
    int32_t material; /**< an index of materials, or NKW_NO_JOINT */
    size_t vertex_count;
    const nkw_vec3 *positions;
    const nkw_vec3 *normals;
    const float *tangents; /**< 4 floats for each vertex: x y z, and the sign of the bitangent */
    const float *const
        *texcoords; /**< texcoord_count sets, each of 2 floats for each vertex: u to the right, v downwards
                                        from the upper edge of a picture (nkw_import_memory.v_is_up) */
    size_t texcoord_count; /**< 0: none, and texcoords is NULL */
    const float *colors; /**< 4 floats for each vertex: red, green, blue, alpha; linear: the first set */
    const uint32_t
        *indices; /**< index_count vertices, each less than vertex_count; never NULL: 0, 1, 2 ... if absent */
    size_t index_count;
    /** As in the file, all sets joined: influence_count numbers for each vertex; 0 and NULL for a rigid mesh. */
    const uint16_t *joints;
    const float *weights;
    size_t influence_count;
    /** The same for nkw_skin_linear: nkw_skin_prune to at most 8 influences. influence_count is 0 for a rigid mesh. */
    nkw_skin skin;
    const nkw_document_target *targets;
    size_t target_count;
    nkw_box box; /**< of the positions, without morph targets and skinning; empty without vertices */
} nkw_document_primitive;
NKW_SIZE(nkw_document_primitive, 208, 120);

typedef struct nkw_document_mesh {
    const char *name;
    const nkw_document_primitive *primitives;
    size_t primitive_count;
    const float *weights; /**< target_count morph weights; zeros if the file has none */
    const char *const *target_names; /**< target_count names */
    size_t target_count; /**< of every primitive of the mesh */
} nkw_document_mesh;
NKW_SIZE(nkw_document_mesh, 48, 24);

/** A picture in a file, or beside it. A picture that cannot be found has neither data nor path. */
typedef struct nkw_document_image {
    const char *name;
    const void *data; /**< as stored: a PNG or JPEG file; NULL if it is in no file that was read */
    size_t bytes;
    const char *path; /**< of an outer file, relative to the folder of the first file; otherwise NULL */
} nkw_document_image;
NKW_SIZE(nkw_document_image, 32, 16);

typedef struct nkw_document_material {
    const char *name;
    float color[4]; /**< base colour: red, green, blue, alpha; linear, 0..1 */
    const nkw_document_image *image; /**< NULL, or the base colour, to be multiplied; sRGB, repeated */
    size_t
        image_texcoords; /**< the index of the set of texcoords at which `image` is; primitives may have fewer sets */
} nkw_document_material;
NKW_SIZE(nkw_document_material, 40, 28);

/** Where a track of an animation is in the file. */
typedef struct nkw_document_channel {
    size_t number; /**< the index of the channel in its animation, in the file */
    int32_t joint; /**< the animated joint; of morph weights, the joint of the mesh */
    size_t input; /**< the accessor of the times, in the file; 0 in formats without */
    size_t output; /**< the accessor of the values, in the file; 0 in formats without */
    size_t bytes; /**< of times and values in the file; in text, as floats */
    size_t added; /**< keys that the file does not have: those between angles that turn by half a turn or more; of
                       curves that became CUBICSPLINE, those between the keys of the curves */
    float difference; /**< of curves of FBX and Collada that became CUBICSPLINE, the largest that was found at eighths
                           of segments: of rotations in radians; 0 of other tracks. The tolerance is 4e-6, of numbers times
                           the largest one; beyond it only where a segment was halved 14 times, or keys are too many */
} nkw_document_channel;
NKW_SIZE(nkw_document_channel, 56, 28);

/** A channel of the file that is no track. */
typedef struct nkw_document_unread {
    size_t number; /**< the index of the channel in its animation, in the file */
    const char *reason; /**< what it animates, and why it is not read */
} nkw_document_unread;
NKW_SIZE(nkw_document_unread, 16, 8);

/** An animation: tracks as in the file. Channels without a target are left out; others that are not read are listed. */
typedef struct nkw_document_animation {
    const char *name;
    const nkw_clip_track *tracks; /**< track_count */
    const nkw_document_channel *channels; /**< track_count */
    size_t track_count;
    const nkw_document_unread *unread; /**< unread_count; of glTF: KHR_animation_pointer, weights without targets */
    size_t unread_count;
} nkw_document_animation;
NKW_SIZE(nkw_document_animation, 48, 24);

typedef struct nkw_document_scene {
    const char *name;
    const int32_t *roots; /**< root_count joints */
    size_t root_count;
} nkw_document_scene;
NKW_SIZE(nkw_document_scene, 24, 12);

/** The axes and the unit of the numbers of a file. */
typedef struct nkw_document_space {
    nkw_axes axes; /**< zeros, which are no axes: the file states none */
    float metres; /**< of a unit; 0: the file states none */
} nkw_document_space;
NKW_SIZE(nkw_document_space, 16, 16);

/** A file that was read. All arrays belong to it and are read-only. */
typedef struct nkw_document {
    const char *file; /**< as passed to the function that opened it */
    const char *format; /**< "glTF 2.0", "BVH", "OBJ", "CSV keys", "JSON keys", or the name of an importer of Assimp */
    const char *generator; /**< the program that wrote the file; "" if unknown */
    size_t bytes; /**< of all files that were read */
    nkw_skeleton skeleton; /**< all nodes; at least one */
    const nkw_document_node *nodes; /**< skeleton.joint_count */
    const int32_t *joint_of_node; /**< skeleton.joint_count: from indices in the file to joints */
    nkw_pose_view rest; /**< the rest pose */
    const float *rest_floats; /**< float_count: the rest values of all morph weights */
    size_t float_count;
    const nkw_document_skin *skins;
    size_t skin_count;
    const nkw_document_mesh *meshes;
    size_t mesh_count;
    const nkw_document_material *materials;
    size_t material_count;
    const nkw_document_image *images; /**< only those of base colours have data or a path */
    size_t image_count;
    const nkw_document_animation *animations;
    const nkw_clip_names *clip_names; /**< animation_count: of each animation's clip, joints and morph targets */
    size_t animation_count;
    const nkw_document_scene *scenes;
    size_t scene_count;
    int32_t scene; /**< the scene to show, or NKW_NO_JOINT */
    const char *const *warnings; /**< warning_count: what is odd in the file, and how it was read */
    size_t warning_count;
    nkw_document_space space; /**< of glTF and FBX; of glTF NKW_AXES_GLTF and 1 */
} nkw_document;
NKW_SIZE(nkw_document, 240, 128);

/* ---- Reading ---- */

/**
 * Reads the outer files of a document.
 *
 * path     relative to the first file, with / between names, without a . or .. or an empty name
 * out      NULL: only the size is wanted. Otherwise receives `size` bytes from the start of the file
 * Returns  the size of the file in bytes; SIZE_MAX if it cannot be read, or if it has fewer than `size` bytes
 */
typedef size_t (*nkw_import_reader)(void *user, const char *path, void *out, size_t size);

/** A file in memory. */
typedef struct nkw_import_memory {
    const void *data;
    size_t bytes;
    const char *file; /**< its name, for messages */
    const char *folder; /**< the folder of outer files, which end in no other folder; NULL: outer files are errors */
    nkw_import_reader reader; /**< NULL; or reads outer files in place of the folder */
    void *user; /**< for the reader */
    int bvh_adds_offset; /**< of BVH: 1 if positions are added to the OFFSET of their joint; 0: they replace it */
    int v_is_up; /**< of texture coordinates: 1 if v is upwards from the lower edge of a picture, 0 if downwards */
} nkw_import_memory;
NKW_SIZE(nkw_import_memory, 56, 32);

/**
 * Reads a file: glTF 2.0 as .gltf, .glb or .vrm, BVH, OBJ, or keys in CSV or JSON, recognised by its content; with
 * Assimp FBX, Collada, X, MD5 and others, recognised by their content, otherwise by the extension of the file. Outer
 * files are read from its folder and the folders below.
 *
 * document  receives the document, to be closed; NULL after an error
 * error     receives what went wrong; code is NKW_IMPORT_OK without an error; may be NULL
 * Returns   error->code
 */
NKW_API nkw_import_result nkw_document_open(const char *path, nkw_document **document, nkw_import_error *error);

/** The same for a file in memory, which is not needed after the call. */
NKW_API nkw_import_result nkw_document_from_memory(const nkw_import_memory *memory, nkw_document **document,
                                                   nkw_import_error *error);

/** What nkw_document_prepare makes, in this order. Zero: nothing. */
typedef struct nkw_document_preparation {
    /**
     * Vertices are multiplied by the rest transforms of their nodes, which become identities. A node keeps its transform
     * if it is animated, a joint of a skin, a camera or light, or above such a node. Skinned vertices stay: their bind
     * pose does not depend on their node.
     */
    int apply_transforms;
    int fix_facing; /**< nkw_mesh_fix_facing; normals of turned triangles that point to the back are negated */
    int make_normals; /**< nkw_mesh_normals, where a primitive has none, or only zeros */
    int make_tangents; /**< nkw_mesh_tangents of the first texture coordinates, where a primitive has normals only */
    float crease; /**< of normals: radians, not negative */
} nkw_document_preparation;
NKW_SIZE(nkw_document_preparation, 20, 20);

/**
 * Prepares the triangles of a document that was opened, not of a copy. Vertices are split where the sides of an edge
 * differ. Each thing that is made is a warning of the document. Tangents have the sign of glTF: normal maps are baked
 * with v upwards.
 *
 * error    of NKW_IMPORT_REFUSED, the place is that of the primitive; may be NULL. The document remains valid
 * Returns  error->code
 */
NKW_API nkw_import_result nkw_document_prepare(nkw_document *document, const nkw_document_preparation *preparation,
                                               nkw_import_error *error);

/** Frees the document and all that it points to. NULL is allowed. */
NKW_API void nkw_document_close(nkw_document *document);

/* ---- OBJ as it is in the file ---- */

/** The number of a texture coordinate or a normal that a corner does not have. */
#define NKW_OBJ_NONE UINT32_MAX

/**
 * An OBJ file with its own arrays: each corner of a triangle has a number for its position, its texture coordinates and
 * its normal. `position_indices` are those of an nkw_mesh. Faces are triangles, in the order of the file.
 */
typedef struct nkw_obj {
    nkw_document *document; /**< the same file with joined vertices, materials, lines and points; closed with this */
    nkw_vec3 *positions; /**< position_count lines v */
    size_t position_count;
    float *texcoords; /**< 2 for each of texcoord_count lines vt; v as in the document */
    size_t texcoord_count;
    nkw_vec3 *normals; /**< normal_count lines vn */
    size_t normal_count;
    const uint32_t *position_indices; /**< 3 for each triangle, less than position_count */
    const uint32_t *texcoord_indices; /**< the same, or NKW_OBJ_NONE */
    const uint32_t *normal_indices; /**< the same, or NKW_OBJ_NONE */
    const int32_t *materials; /**< of each triangle: of the document's, or NKW_NO_JOINT */
    size_t triangle_count;
} nkw_obj;
NKW_SIZE(nkw_obj, 96, 48);

/**
 * Reads an OBJ file with its own arrays.
 *
 * obj      receives the arrays, to be closed by nkw_obj_close; NULL after an error
 * error    as of nkw_document_open; may be NULL
 * Returns  error->code; NKW_IMPORT_UNSUPPORTED for a file of another format
 */
NKW_API nkw_import_result nkw_obj_open(const char *path, nkw_obj **obj, nkw_import_error *error);

/** The same for a file in memory, which is not needed after the call. */
NKW_API nkw_import_result nkw_obj_from_memory(const nkw_import_memory *memory, nkw_obj **obj, nkw_import_error *error);

/** Frees the arrays and the document. NULL is allowed. */
NKW_API void nkw_obj_close(nkw_obj *obj);

/**
 * Scales the positions, those of the document too, about the origin, so that the largest side of their box is `largest`.
 * Each component is rounded once.
 *
 * Returns  the sides of the box after that; 0 0 0 without positions. If `largest` is not positive and finite, or the box
 *          has no size, nothing is scaled
 */
NKW_API nkw_vec3 nkw_obj_scale(nkw_obj *obj, float largest);

/* ---- From a document to the library ---- */

/**
 * The source of the clip of an animation: its tracks, its names, the rest pose and the rest morph weights. An animation that is
 * not less than animation_count has no tracks: its clip is the rest pose. The document must outlive the source.
 */
NKW_API nkw_clip_source nkw_document_clip_source(const nkw_document *document, size_t animation,
                                                 nkw_clip_format format);

/**
 * Builds the clip of an animation, which may outlive the document.
 *
 * clip     receives the clip, to be freed by nkw_import_free; NULL after an error
 * error    of NKW_IMPORT_REFUSED, the place is that of the first channel with an error; may be NULL
 * Returns  error->code
 */
NKW_API nkw_import_result nkw_document_clip(const nkw_document *document, size_t animation, nkw_clip_format format,
                                            nkw_clip **clip, nkw_import_error *error);

/** Frees a clip. NULL is allowed. */
NKW_API void nkw_import_free(void *block);

/**
 * Model matrices from a pose, as nkw_skeleton_models_from_pose. Joints with a `matrix` use it instead of the pose, so
 * shear is kept.
 *
 * pose     a pose of all joints
 * models   receives skeleton.joint_count matrices
 * Returns  NKW_MISMATCHED for a pose with another number of joints; nothing is then written
 */
NKW_API nkw_result nkw_document_models(const nkw_document *document, nkw_pose_view pose, const nkw_mat4 *root,
                                       nkw_mat4 *models);

/**
 * The joints that carry a mesh, of a joint and all below it: what is drawn of a tree of frames, in depth-first order. For
 * each, the model matrix of the joint is that of the primitives of its mesh; with a skin, the palette.
 *
 * root      a joint, or NKW_NO_JOINT: of the whole document
 * joints    receives up to `capacity` joints, ascending; NULL with capacity 0 asks for the count
 * count     receives their number, also if capacity is less; 0 after other errors
 * Returns   NKW_OK; NKW_TOO_SMALL for capacity; NKW_OUT_OF_RANGE if root is no joint
 *
 * Source    the draw list of the matrix stack over D3DXFRAME: frames whose pMeshContainer is not NULL
 */
NKW_API nkw_result nkw_document_mesh_joints(const nkw_document *document, int32_t root, int32_t *joints,
                                            size_t capacity, size_t *count);

/**
 * The character of a document, in one block: all nodes, animations, skins and meshes (nkw_character_build). Joints,
 * animations and morph weights have the numbers of the document; parts are the primitives of the joints that carry a
 * mesh, joint after joint. Part p is of the mesh document->nodes[parts[p].joint].mesh. The vectors of vertices are those
 * of the document, which must outlive the use of the parts; all else may outlive it.
 *
 * Joints with a `matrix` have its TRS: shear is lost. Where it is wanted, compute the models with nkw_document_models,
 * then nkw_palette_from_models of character->palette.
 *
 * block      as of nkw_character_build; data NULL asks for the size
 * bytes      receives the size; 0 after an error but a block that is too small
 * character  receives the views; unchanged after an error and without a block
 * error      of NKW_IMPORT_REFUSED, the place is that of the channel, the skin or the primitive; may be NULL
 * Returns    error->code
 */
NKW_API nkw_import_result nkw_document_character(const nkw_document *document, nkw_clip_format format,
                                                 nkw_bytes_span block, size_t *bytes, nkw_character *character,
                                                 nkw_import_error *error);

/** The source of the palette of a skin, which must be less than skin_count. */
NKW_API nkw_palette_source nkw_document_palette_source(const nkw_document *document, size_t skin,
                                                       const nkw_mat4 *models);

/**
 * The palette of a skin: joint_count matrices from the model matrices of all joints.
 *
 * Returns  NKW_OUT_OF_RANGE if skin is not less than skin_count; nothing is then written
 */
NKW_API nkw_result nkw_document_palette(const nkw_document *document, size_t skin, const nkw_mat4 *models,
                                        nkw_mat4 *palette);

/** Positions and normals of the vertices of a primitive. */
typedef struct nkw_document_vertices_span {
    nkw_vec3 *positions; /**< vertex_count */
    nkw_vec3 *normals; /**< vertex_count, or NULL; zeros if the file has none */
} nkw_document_vertices_span;
NKW_SIZE(nkw_document_vertices_span, 16, 8);

/**
 * Morph targets: the positions and normals of a primitive, to each the differences of each target times its weight
 * added. Targets of weight 0 are skipped.
 *
 * weights  target_count morph weights; NULL: zeros
 */
NKW_API void nkw_document_morph(const nkw_document_primitive *primitive, const float *weights,
                                nkw_document_vertices_span out);

/** What moves at one time. */
typedef struct nkw_document_moment {
    const nkw_mat4 *models; /**< the model matrices of all joints */
    const float
        *floats; /**< float_count morph weights of all joints, as nkw_clip_sample writes them; NULL: rest_floats */
    const nkw_mat4 *palette; /**< of the joint's skin (nkw_document_palette); not read if it has none */
} nkw_document_moment;
NKW_SIZE(nkw_document_moment, 24, 12);

/**
 * The vertices of a primitive of the mesh of a joint, in the space of the models: morphed, then skinned by
 * nkw_skin_linear, or moved by the joint's model matrix if the joint or the primitive has no skin.
 *
 * joint    less than skeleton.joint_count, with a mesh
 * moment   see above
 * Returns  NKW_OUT_OF_RANGE if there is no such joint or primitive; nothing is then written
 */
NKW_API nkw_result nkw_document_vertices(const nkw_document *document, size_t joint, size_t primitive,
                                         const nkw_document_moment *moment, nkw_document_vertices_span out);

/**
 * Checks all values that reading does not: every animation as nkw_clip_build does, every skin as
 * nkw_palette_source_validate, and every skinned primitive as nkw_skin_validate for the skin of each joint that has its
 * mesh.
 *
 * error    receives the first error; its place names the channel, the skin or the primitive; may be NULL
 * Returns  error->code
 */
NKW_API nkw_import_result nkw_document_validate(const nkw_document *document, nkw_import_error *error);

#ifdef __cplusplus
}
#endif

#endif
