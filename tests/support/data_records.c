/* SPDX-License-Identifier: MIT */
#include <string.h>

#include "data.h"
#include "hash.h"
#include "random.h"
#include "views.h"

#define JOINTS 151 /* more than one block, and not a multiple of anything */
#define POSES  3

typedef struct scene {
    nkw_trs poses[POSES][JOINTS], out[JOINTS];
    float mask[NKW_POSE_STRIDE(JOINTS)];
    int32_t parents[JOINTS];
    nkw_mat4 models[JOINTS];
    unsigned char work[NKW_RECORDS_LAYERS_WORK(POSES) + 16];
} scene;

static nkw_records_view view_of(const nkw_trs *trs)
{
    nkw_records_view r = {trs, JOINTS};
    return r;
}

static void draw(random_source *r, scene *s)
{
    for (size_t k = 0; k < POSES; k++)
        for (size_t j = 0; j < JOINTS; j++) {
            nkw_trs trs = {random_vec3(r, -5, 5), random_rotation(r), random_vec3(r, -2, 2)};
            if (k > 0 && j % 3 == 0)
                trs.rotation = random_near(r, s->poses[0][j].rotation, 0.125f);
            s->poses[k][j] = trs;
            s->mask[j] = random_bits(r) % 4 == 0 ? 0.0f : random_between(r, -0.25f, 1.25f);
        }
    for (size_t j = 0; j < JOINTS; j++)
        s->parents[j] = (int32_t)j - 1 - (int32_t)(random_bits(r) % 4);
}

static uint64_t hash_out(uint64_t hash, const scene *s)
{
    float numbers[10 * JOINTS];
    memcpy(numbers, s->out, sizeof numbers);
    return hash_floats(hash, numbers, 10 * JOINTS);
}

static uint64_t blends(uint64_t hash, scene *s)
{
    static const float ts[] = {0.0f, 0.25f, 0.5f, 0.875f, 1.0f, 1.5f, -2.0f};
    nkw_records_span out = {s->out, JOINTS};
    for (size_t i = 0; i < 2 * sizeof ts / sizeof ts[0]; i++) {
        nkw_mask_view mask = mask_view(i % 2 ? s->mask : NULL, JOINTS);
        nkw_records_layer layers[2];
        nkw_records_blend(view_of(s->poses[0]), view_of(s->poses[1]), ts[i / 2], mask, out);
        hash = hash_out(hash, s);
        for (unsigned k = 0; k < 2; k++) {
            layers[k].pose = view_of(s->poses[k]);
            layers[k].weight = ts[i / 2] * (float)(k + 1);
            layers[k].mask = mask;
        }
        nkw_records_layers_blend(layers, 2, view_of(s->poses[2]), 0.75f, out, work_in(s->work, sizeof s->work));
        hash = hash_out(hash, s);
    }
    return hash;
}

uint64_t data_records(void)
{
    static scene s;
    random_source r = random_from(36);
    nkw_records_span out = {s.out, JOINTS};
    nkw_skeleton skeleton = {s.parents, JOINTS};
    draw(&r, &s);
    uint64_t hash = blends(HASH_START, &s);
    nkw_records_additive_build(view_of(s.poses[0]), view_of(s.poses[1]), NKW_ADDITIVE_LOCAL, out);
    hash = hash_out(hash, &s);
    nkw_records_additive_apply(view_of(s.poses[2]), view_of(s.out), 0.75f, mask_view(s.mask, JOINTS),
                               NKW_ADDITIVE_LOCAL, out);
    hash = hash_out(hash, &s);
    nkw_skeleton_models_from_records(&skeleton, view_of(s.poses[0]), NULL, NULL, s.models);
    return hash_floats(hash, s.models[0].m, 16 * JOINTS);
}
