/* SPDX-License-Identifier: MIT */
#include "data.h"
#include "hash.h"
#include "random.h"
#include "views.h"

#define JOINTS 37
#define FLOATS NKW_POSE_FLOATS(JOINTS)
#define POSES  4

typedef struct scene {
    float poses[POSES][FLOATS], velocities[2][NKW_POSE_VELOCITY_FLOATS(JOINTS)], out[FLOATS];
    float inertia[NKW_POSE_INERTIA_FLOATS(JOINTS)], dead[NKW_POSE_DEAD_BLEND_FLOATS(JOINTS)];
} scene;

static void draw(random_source *r, scene *s)
{
    for (size_t k = 0; k < POSES; k++)
        for (size_t j = 0; j < JOINTS; j++) {
            nkw_trs trs = {random_vec3(r, -5, 5), random_rotation(r), random_vec3(r, -2, 2)};
            if (k % 2)
                trs.rotation = random_near(r, nkw_pose_get(pose_view(s->poses[k - 1], JOINTS), j).rotation, 0.03f);
            nkw_pose_set(pose_span(s->poses[k], JOINTS), j, &trs);
        }
}

/* The joints alone: padding is not promised. */
static uint64_t hash_rows(uint64_t hash, const float *rows, size_t count)
{
    for (size_t c = 0; c < count; c++)
        hash = hash_floats(hash, rows + c * NKW_POSE_STRIDE(JOINTS), JOINTS);
    return hash;
}

static nkw_pose_state motion_of(scene *s, size_t k)
{
    nkw_pose_velocity_span v = {s->velocities[k], JOINTS};
    nkw_pose_velocity_from_poses(pose_view(s->poses[2 * k], JOINTS), pose_view(s->poses[2 * k + 1], JOINTS), 0.0625f,
                                 v);
    nkw_pose_state m = {pose_view(s->poses[2 * k + 1], JOINTS), NKW_VIEW(nkw_pose_velocity, v)};
    return m;
}

uint64_t data_transition(void)
{
    static scene s;
    random_source r = random_from(0x7261);
    draw(&r, &s);
    const nkw_pose_state from = motion_of(&s, 0), to = motion_of(&s, 1);
    const nkw_pose_inertia inertia = {s.inertia, JOINTS};
    const nkw_pose_dead_blend dead = {s.dead, JOINTS, 0.25f, 0.75f};
    uint64_t hash = hash_rows(hash_rows(HASH_START, s.velocities[0], 9), s.velocities[1], 9);
    nkw_pose_inertia_begin(inertia, &from, &to, 0.5f);
    nkw_pose_dead_blend_begin(&dead, &from);
    hash = hash_rows(hash, s.inertia, 30);
    for (int i = -1; i < 20; i++) {
        float t = 0.04f * (float)i;
        nkw_pose_inertia_evaluate(inertia, to.pose, t, pose_span(s.out, JOINTS));
        hash = hash_rows(hash, s.out, 10);
        nkw_pose_dead_blend_evaluate(&dead, to.pose, t, pose_span(s.out, JOINTS));
        hash = hash_rows(hash_rows(hash, s.out, 10), s.dead, 23);
    }
    return hash;
}
