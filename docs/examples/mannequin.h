/* SPDX-License-Identifier: MIT */
/**
 * @file
 * A mannequin: 17 joints, four meshes on them, and three clips. nakawari-character writes it as a glTF file.
 *
 * Metres and seconds; y is up, the mannequin faces +z and its left is +x. In the bind pose its arms point sideways.
 */
#ifndef MANNEQUIN_H
#define MANNEQUIN_H

#include <nakawari/segment.h>
#include <nakawari/track.h>
#include <nakawari/types.h>

#include "mesh.h"

enum mannequin_joint {
    HIPS,
    SPINE,
    CHEST,
    NECK,
    HEAD,
    ARM_L,
    FOREARM_L,
    HAND_L,
    ARM_R,
    FOREARM_R,
    HAND_R,
    THIGH_L,
    SHIN_L,
    FOOT_L,
    THIGH_R,
    SHIN_R,
    FOOT_R,
    MANNEQUIN_JOINTS
};

/** A joint in the bind pose: its parent comes before it; no joint is rotated. */
typedef struct mannequin_bone {
    const char *name;
    int32_t parent;
    nkw_vec3 translation;
} mannequin_bone;

extern const mannequin_bone mannequin_bones[MANNEQUIN_JOINTS];

/** The model space position of a joint in the bind pose. */
nkw_vec3 mannequin_place(int joint);

enum mannequin_part { PART_BODY, PART_SHOES, PART_FACE, PART_EYES, MANNEQUIN_PARTS };

/** Builds a part in the bind pose, weights in 1/65535. Returns 0 if memory ran out. mesh_free is due in either case. */
int mannequin_mesh(mesh *m, enum mannequin_part part);

/** Stores how far each vertex of the face moves when it puffs its cheeks: the morph target. */
void mannequin_puff(const mesh *face, nkw_vec3 *moves);

/* ---- clips ---- */

typedef enum mannequin_path { PATH_TRANSLATION, PATH_ROTATION, PATH_SCALE, PATH_PUFF } mannequin_path;

enum { CHANNEL_KEYS = 16, CHANNEL_FLOATS = CHANNEL_KEYS * 12 };

/** A channel of a clip: `width` floats a key, three times as many with CUBICSPLINE (in-tangent, value, out-tangent). */
typedef struct mannequin_channel {
    mannequin_path path;
    int joint; /* of PATH_PUFF: HEAD */
    nkw_interpolation mode;
    size_t key_count, width;
    float times[CHANNEL_KEYS], values[CHANNEL_FLOATS];
} mannequin_channel;

enum { CLIP_CHANNELS = 16 };

typedef struct mannequin_clip {
    const char *name;
    size_t channel_count;
    mannequin_channel channels[CLIP_CHANNELS];
} mannequin_clip;

enum { MANNEQUIN_CLIPS = 3 };

/** walk (LINEAR, loops), wave (CUBICSPLINE rotations), hop (all modes and paths). */
void mannequin_clips(mannequin_clip clips[MANNEQUIN_CLIPS]);

#endif
