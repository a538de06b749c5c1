/* SPDX-License-Identifier: MIT */
/**
 * @file
 * The two scenes of the exercise as key frames: one key per second, from second 0.
 */
#ifndef SCENE_H
#define SCENE_H

#include <nakawari/keyframe.h>

enum { SCENE_KEYS_MAX = 7 };

typedef struct scene {
    char name[24];                     /**< "scene1", or "scene1_first3" where keys were left out */
    nkw_keyframe keys[SCENE_KEYS_MAX]; /**< of which count are used */
    size_t count;
    nkw_mat4 view;                     /**< from the world to the eye of the exercise's camera */
} scene;

/** Scene 1 or 2, cut to its first `keys` keys; 0 keys means all. Gives 0 for a scene or a number it has not. */
int scene_build(int number, size_t keys, scene *out);

/** The time of the last key, seconds. */
float scene_end(const scene *s);

/** The matrix of the object at a time; the scene's keys are valid, so sampling them cannot fail. */
nkw_mat4 scene_sample(const scene *s, float time, nkw_position_method position, nkw_orientation_method orientation);

#endif
