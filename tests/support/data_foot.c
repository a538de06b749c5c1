/* SPDX-License-Identifier: MIT */
#include "data.h"
#include "hash.h"
#include "random.h"
#include "views.h"

/* A foot that slides, rises and falls in steps of time of many lengths. */
uint64_t data_foot(void)
{
    random_source r = random_from(11);
    uint64_t hash = HASH_START;
    const nkw_foot_rules rules = NKW_FOOT_RULES;
    nkw_foot foot = {0}, given = {0};
    nkw_vec3 at = {0, 0, 0};
    for (int i = 0; i < 4000; i++) {
        float dt = i % 50 ? random_between(&r, 0.004f, 0.02f) : 0.0f, speed = i % 90 < 45 ? 0.2f : 2.0f;
        nkw_vec3 step = random_vec3(&r, -speed, speed);
        at = nkw_vec3_add_scaled(at, step, dt);
        at.y = i % 90 < 45 ? 0.01f : 0.01f + 0.004f * (float)(i % 45);
        nkw_vec3 p = nkw_foot_update(&foot, &rules, at, 0.0f, dt);
        hash = hash_floats(hash, &p.x, 3);
        hash = hash_floats(hash, &foot.weight, 1);
        p = nkw_foot_update_given(&given, &rules, at, i % 70 < 30, dt);
        hash = hash_floats(hash, &p.x, 3);
        hash = hash_floats(hash, &given.weight, 1);
    }
    return hash;
}
