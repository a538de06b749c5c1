/* SPDX-License-Identifier: MIT */
/**
 * @file
 * A character in one block: skeleton, rest pose, clips as a mixer plays them, skins and vertices, put together from
 * arrays by one call. nkw_document_character of nakawari::import makes it of a file.
 *
 * Nodes are numbered as in the source, in any order; joints as in the skeleton, parents first. All that a source says of
 * nodes becomes joints. The block has all but the vectors of vertices, their influences and the differences of morph
 * targets: these remain the caller's.
 *
 *     nkw_mixer_advance(&mixer, &character.set, seconds, &frame, work);       a frame: the pose
 *     nkw_character_palette(&character, pose, &place, models, palette);       all matrices of all parts
 *     nkw_character_vertices(&character, part, floats, palette, out);         the vertices of a part, or upload palette
 */
#ifndef NAKAWARI_CHARACTER_H
#define NAKAWARI_CHARACTER_H

#include <stdint.h>

#include "mixer.h"
#include "morph.h"
#include "palette.h"
#include "skeleton.h"
#include "skin.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Joints that move vertices, and where they were when the skin was bound. */
typedef struct nkw_character_skin {
    const int32_t *joints; /**< joint_count nodes */
    const nkw_mat4 *inverse_bind; /**< joint_count matrices, or NULL: see nkw_character_source.binds_at_rest */
    size_t joint_count;
} nkw_character_skin;
NKW_SIZE(nkw_character_skin, 24, 12);

/** An animation: the tracks of a clip. `index` of those of joints is a node. */
typedef struct nkw_character_animation {
    const char *name; /**< that nkw_clip_describe returns; NULL: "" */
    const nkw_clip_track *tracks;
    size_t track_count;
} nkw_character_animation;
NKW_SIZE(nkw_character_animation, 24, 12);

/** Vertices that are drawn together: a mesh, or a part of it with one material. */
typedef struct nkw_character_part {
    int32_t joint; /**< that carries it: in a source a node */
    int32_t skin_index; /**< of the skins of the source; NKW_NO_JOINT: rigid, moved by `joint` alone */
    nkw_vertices_view vertices; /**< in the rest position, without morph targets */
    /** Its joints are indices of the skin, and so of the part's matrices. Of a rigid part only vertex_count is read. */
    nkw_skin skin;
    nkw_morph morph; /**< zeros: none */
    size_t float_first; /**< the floats of the morph weights: morph.target_count from here on */
    size_t matrix_first, matrix_count; /**< in the palette of the character; written by the build */
} nkw_character_part;
NKW_SIZE(nkw_character_part, 184, 96);

/** What a character is put together from. Zeros: none of it. */
typedef struct nkw_character_source {
    const int32_t *node_parents; /**< node_count nodes or NKW_NO_JOINT, in any order */
    const nkw_trs *rest; /**< node_count local transforms; NULL: identities */
    const char *const *names; /**< node_count texts, or NULL */
    size_t node_count;
    const nkw_character_animation *animations;
    size_t animation_count;
    const float *rest_floats; /**< float_count morph weights and other floats of the clips; NULL: zeros */
    size_t float_count;
    const nkw_character_skin *skins;
    size_t skin_count;
    const nkw_character_part *parts;
    size_t part_count;
    nkw_clip_format format; /**< of the clips */
    int binds_at_rest; /**< skins without inverse bind matrices: 1: are bound in the rest pose; 0: have identities */
} nkw_character_source;
NKW_SIZE(nkw_character_source, 104, 56);

/** A character: views into its block. Any number of mixers may play it at the same time. */
typedef struct nkw_character {
    nkw_skeleton skeleton;
    nkw_mixer_set
        set; /**< the clips, in the order of the animations; rest pose and floats. No root motion: set it here */
    nkw_mixer_clip *clips; /**< those of the set, to add events and markers */
    const int32_t *joint_of_node, *node_of_joint; /**< skeleton.joint_count each */
    const char *const *names; /**< of the joints; "" without names */
    const nkw_character_part *parts; /**< in the order of the source */
    size_t part_count;
    size_t most_vertices; /**< the largest vertex count of a part */
    nkw_palette_source palette; /**< of nkw_palette_from_models, but its `models`: the matrices of all parts */
} nkw_character;
NKW_SIZE(nkw_character, 208, 112);

/** The bytes of working memory of nkw_character_build; track_count of the animation with most tracks. */
#define NKW_CHARACTER_WORK(node_count, track_count)                                                                    \
    (76 * (size_t)(node_count) + 4 * NKW_POSE_FLOATS((size_t)(node_count)) + 68 * (size_t)(track_count) + 16)

/**
 * Builds a character into a block.
 *
 * block      data NULL asks for the size. Aligned to 8 bytes, as malloc does; 64 is fastest. It has pointers into itself: it may not be
 *            moved or written to a file
 * bytes      receives the size; 0 after every error but a block that is too small
 * character  receives the views; unchanged after an error and without a block
 * bad        receives the first offending node, skin, part or animation, 0 if there is none; may be NULL
 * work       NKW_CHARACTER_WORK
 * Returns
 *
 *     NKW_OK            no error; also where only the size is asked for
 *     NKW_TOO_SMALL     too little working memory; a block that is too small or not aligned: *bytes is then its size
 *     of nodes          the results of nkw_skeleton_from_parents
 *     of skins          NKW_OUT_OF_RANGE for a joint that is no node
 *     of parts          NKW_OUT_OF_RANGE for a joint that is no node, a skin that does not exist, and morph weights after
 *                       the last float; NKW_MISMATCHED for a morph of another vertex_count
 *     of animations     the results of nkw_clip_build
 *
 * Influences and differences of vertices are not checked: nkw_skin_validate, nkw_morph_validate.
 *
 * Stack  at most 18 KiB.
 */
NKW_API nkw_result nkw_character_build(const nkw_character_source *source, nkw_bytes_span block, size_t *bytes,
                                       nkw_character *character, size_t *bad, nkw_work work);

/**
 * The model matrices of a pose, and the palette of all parts: nkw_skeleton_models_from_pose, then
 * nkw_palette_from_models. The matrix of a rigid part is the model matrix of its joint.
 *
 * root     places the character; NULL: none
 * models   receives skeleton.joint_count matrices
 * palette  receives palette.joint_count matrices: those of part p from parts[p].matrix_first on
 * Returns  NKW_MISMATCHED for a pose with another number of joints; nothing is then written
 *
 * Stack  at most 6 KiB.
 */
NKW_API nkw_result nkw_character_palette(const nkw_character *character, nkw_pose_view pose, const nkw_mat4 *root,
                                         nkw_mat4 *models, nkw_mat4 *palette);

/**
 * The vertices of a part: morphed (nkw_morph_apply), then skinned by linear blend (nkw_skin_linear), normals
 * with inverse_normals, because joints may scale.
 *
 * floats   set.float_count floats of a frame; NULL: those of the rest pose
 * palette  of nkw_character_palette
 * out      the vectors wanted; not the vertices of the part
 * Returns  NKW_OUT_OF_RANGE for a part that does not exist: nothing is then written; the results of nkw_skin_linear
 *
 * Stack  at most 17 KiB.
 */
NKW_API nkw_result nkw_character_vertices(const nkw_character *character, size_t part, const float *floats,
                                          const nkw_mat4 *palette, nkw_vertices_span out);

#ifdef __cplusplus
}
#endif

#endif
