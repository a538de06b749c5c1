/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Scenes of key frames: the two of the exercise, one key per second from second 0, and those of own keys.
 */
#ifndef SCENE_H
#define SCENE_H

#include <nakawari/keyframe.h>

#include "draw/object.h"

enum { SCENE_KEYS_MAX = 64, SCENE_SECONDS_MAX = 64 };

typedef struct scene {
    char name[64];                     /**< "scene1", or "scene1_first3" where keys were left out */
    nkw_keyframe keys[SCENE_KEYS_MAX]; /**< of which count are used */
    size_t count;
    nkw_mat4 view;                     /**< from the pictures' world to the eye of the exercise's camera */
    float unit;                        /**< the length that pictures show as 1: 1 in the exercise */
    int own;                           /**< whether the keys are not those of the exercise */
    nkw_keyframe_rule rule;            /**< by which it is sampled; that of the exercise until it is set */
    const object_model *object;        /**< drawn in place of the dart; NULL, the dart, until it is set */
} scene;

/** Scene 1 or 2, cut to its first `keys` keys; 0 keys means all. Gives 0 for a scene or a number it has not. */
int scene_build(int number, size_t keys, scene *out);

/**
 * A scene of own keys, at most SCENE_KEYS_MAX, at most SCENE_SECONDS_MAX seconds; `name` is cut to letters, digits, - and _.
 * The camera is that of scene 1, aimed at the middle of the keys; the unit is a power of ten. 0 for fewer than two
 * keys, more or longer ones, and for keys that nkw_keyframes_validate refuses.
 */
int scene_from_keys(const char *name, const nkw_keyframe *keys, size_t count, scene *out);

/** The time of the first and of the last key, seconds. */
float scene_start(const scene *s);
float scene_end(const scene *s);

/** The number of times at a rate from the first key to the last one, both included; the times. */
size_t scene_times(const scene *s, int per_second);
float scene_time(const scene *s, int per_second, size_t i);
/** The time at t of a segment between two keys. */
float scene_segment_time(const scene *s, size_t segment, float t);

/** The matrix of the object at a time by the scene's rule; its keys are valid, so sampling them cannot fail. */
nkw_mat4 scene_sample(const scene *s, float time, nkw_position_method position, nkw_orientation_method orientation);

/** The same for pictures: the position in units. The position of a key in units. */
nkw_mat4 scene_place(const scene *s, float time, nkw_position_method position, nkw_orientation_method orientation);
nkw_vec3 scene_position(const scene *s, size_t key);

#endif
