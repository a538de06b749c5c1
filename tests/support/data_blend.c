/* SPDX-License-Identifier: MIT */
#include "data.h"
#include "random.h"
#include "views.h"

#define JOINTS 151 /* more than one block, and not a multiple of anything */
#define FLOATS NKW_POSE_FLOATS(JOINTS)
#define POSES  4

typedef struct scene {
    float poses[POSES][FLOATS], masks[POSES][NKW_POSE_STRIDE(JOINTS)], out[FLOATS];
    int32_t pair[JOINTS], parents[JOINTS];
} scene;

static void draw(random_source *r, scene *s)
{
    for (size_t k = 0; k < POSES; k++)
        for (size_t j = 0; j < JOINTS; j++) {
            nkw_trs trs = {random_vec3(r, -5, 5), random_rotation(r), random_vec3(r, -2, 2)};
            if (j % 5 == 0)
                trs.scale.y = 0.0f;
            if (k > 0 && j % 3 == 0)
                trs.rotation = random_near(r, nkw_pose_get(pose_view(s->poses[0], JOINTS), j).rotation, 0.125f);
            nkw_pose_set(pose_span(s->poses[k], JOINTS), j, &trs);
            s->masks[k][j] = random_bits(r) % 4 == 0 ? 0.0f : random_between(r, -0.25f, 1.25f);
        }
    for (size_t j = 0; j < JOINTS; j++) {
        s->pair[j] = (int32_t)(j + 1 == JOINTS ? j : j ^ 1);
        s->parents[j] = (int32_t)j - 1 - (int32_t)(random_bits(r) % 4);
    }
}

static uint64_t two_poses(uint64_t hash, scene *s)
{
    static const float ts[] = {0.0f, 0.25f, 0.5f, 0.875f, 1.0f, 1.5f, -2.0f};
    for (size_t i = 0; i < sizeof ts / sizeof ts[0]; i++)
        for (int k = 0; k < 4; k++) {
            const float *mask = k & 1 ? s->masks[0] : NULL;
            if (k & 2)
                nkw_pose_blend_slerp(pose_view(s->poses[0], JOINTS), pose_view(s->poses[1], JOINTS), ts[i],
                                     mask_view(mask, JOINTS), pose_span(s->out, JOINTS));
            else
                nkw_pose_blend(pose_view(s->poses[0], JOINTS), pose_view(s->poses[1], JOINTS), ts[i],
                               mask_view(mask, JOINTS), pose_span(s->out, JOINTS));
            hash = nkw_pose_fingerprint(pose_view(s->out, JOINTS), hash);
        }
    return hash;
}

static uint64_t many_poses(uint64_t hash, scene *s)
{
    for (unsigned k = 0; k < 16; k++) {
        nkw_pose_layer layers[POSES];
        for (unsigned i = 0; i < POSES; i++) {
            layers[i].pose = pose_view(s->poses[i], JOINTS);
            layers[i].weight = k & 1 ? 0.25f : 0.5f - 0.125f * (float)i;
            layers[i].mask = mask_view(k >> 1 & 1 ? s->masks[i] : NULL, JOINTS);
        }
        nkw_pose_layers_blend(layers, (k >> 2) + 1, pose_view(s->poses[3], JOINTS), 0.75f, pose_span(s->out, JOINTS));
        hash = nkw_pose_fingerprint(pose_view(s->out, JOINTS), hash);
    }
    return hash;
}

static uint64_t differences(uint64_t hash, scene *s)
{
    static float delta[FLOATS];
    for (int k = 0; k < 4; k++) {
        nkw_additive side = k & 1 ? NKW_ADDITIVE_PARENT : NKW_ADDITIVE_LOCAL;
        nkw_pose_additive_build(pose_view(s->poses[0], JOINTS), pose_view(s->poses[1], JOINTS), side,
                                pose_span(delta, JOINTS));
        hash = nkw_pose_fingerprint(pose_view(delta, JOINTS), hash);
        nkw_pose_additive_apply(pose_view(s->poses[2], JOINTS), pose_view(delta, JOINTS), k & 2 ? 1.0f : 0.75f,
                                mask_view(k & 2 ? s->masks[1] : NULL, JOINTS), side, pose_span(s->out, JOINTS));
        hash = nkw_pose_fingerprint(pose_view(s->out, JOINTS), hash);
    }
    return hash;
}

/* Chains of three joints each, of one figure: their partners are joints of the same depth. */
static uint64_t mirrored_through_rest(scene *s, uint64_t hash)
{
    int32_t parents[JOINTS], pair[JOINTS];
    NKW_STACK_WORK(work, NKW_MIRROR_WORK(JOINTS));
    for (int32_t j = 0; j < JOINTS; j++) {
        const int32_t partner = j / 3 % 2 ? j - 3 : j + 3, last = JOINTS / 6 * 6;
        parents[j] = j % 3 ? j - 1 : -1;
        pair[j] = j < last ? partner : j;
    }
    const nkw_mirror_rig rig = {parents, pair, pose_view(s->poses[1], JOINTS), NKW_MIRROR_Y};
    const float times[2] = {0, 1}, *keys = s->poses[0];
    float values[24];
    const nkw_track turns = {times, keys, 2, 4, NKW_TRACK_ROTATION, NKW_INTERPOLATION_CUBICSPLINE, NULL},
                    places = {times, keys, 2, 3, NKW_TRACK_FLOATS, NKW_INTERPOLATION_CUBICSPLINE, NULL};
    for (size_t j = 0; j < JOINTS; j++) {
        nkw_track_mirror_rest(&turns, &rig, j, NKW_AXES_QUAT, values, work);
        hash = nkw_fingerprint_floats(values, 24, hash);
        nkw_track_mirror_rest(&places, &rig, j, j % 2 ? NKW_AXES_VEC3 : NKW_AXES_SCALE, values, work);
        hash = nkw_fingerprint_floats(values, 18, hash);
    }
    nkw_pose_mirror_rest(pose_view(s->poses[0], JOINTS), &rig, pose_span(s->out, JOINTS), NULL, NULL, work);
    return nkw_pose_fingerprint(pose_view(s->out, JOINTS), hash);
}

uint64_t data_blend(void)
{
    static scene s;
    random_source r = random_from(5);
    draw(&r, &s);
    uint64_t hash = differences(many_poses(two_poses(0, &s), &s), &s);
    nkw_pose_mirror(pose_view(s.poses[0], JOINTS), s.pair, NKW_MIRROR_Z, pose_span(s.out, JOINTS), NULL);
    hash = nkw_pose_fingerprint(pose_view(s.out, JOINTS), hash);
    hash = mirrored_through_rest(&s, hash);
    mask_from_subtree(s.parents, JOINTS, 2, s.masks[0]);
    return nkw_fingerprint_floats(s.masks[0], NKW_POSE_STRIDE(JOINTS), hash);
}
