/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/foot.h>
#include <nakawari/vec.h>

#include "lane/scalar.h"

static int is_contact(const nkw_foot_rules *rules, int contact, float height, float speed)
{
    float highest = contact ? rules->leave_height : rules->enter_height;
    float fastest = contact ? rules->leave_speed : rules->enter_speed;
    return height <= highest && speed <= fastest;
}

static float height_of(const nkw_foot_rules *rules, nkw_vec3 position, float ground)
{
    nkw_vec3 up = nkw_vec3_normalize(rules->up);
    int is_zero = up.x == 0.0f && up.y == 0.0f && up.z == 0.0f;
    return (is_zero ? position.y : nkw_vec3_dot(up, position)) - ground;
}

static int next_contact(const nkw_foot *foot, const nkw_foot_rules *rules, const nkw_vec3_state *animated,
                        float ground)
{
    float height = height_of(rules, animated->value, ground), speed = nkw_vec3_length(animated->velocity);
    float away = nkw_vec3_distance(animated->value, foot->locked);
    if (foot->contact && rules->release_distance > 0.0f && away > rules->release_distance)
        return 0;
    return is_contact(rules, foot->contact, height, speed);
}

/* What the foot follows: the lock, or the animation. */
static nkw_vec3_state followed(const nkw_foot *foot, const nkw_vec3_state *animated)
{
    nkw_vec3_state locked = {foot->locked, {0.0f, 0.0f, 0.0f}};
    return foot->contact ? locked : *animated;
}

static void change_contact(nkw_foot *foot, const nkw_foot_rules *rules, const nkw_vec3_state *animated,
                           const nkw_vec3_state *now)
{
    foot->contact = !foot->contact;
    foot->locked = animated->value;
    foot->time = 0.0f;
    nkw_vec3_state to = followed(foot, animated);
    foot->offset.kind = NKW_OFFSET_INERTIA;
    foot->offset.duration = rules->duration;
    nkw_vec3_offset_begin(&foot->offset, now, &to);
}

nkw_vec3 nkw_foot_update(nkw_foot *foot, const nkw_foot_rules *rules, nkw_vec3 animated, float ground, float h)
{
    if (!nkw_vec3_is_finite(animated) || !lane_is_finite(ground) || !lane_is_finite(h))
        return foot->position;
    int passes = foot->started && h > 0.0f;
    nkw_vec3_state motion = {animated, {0.0f, 0.0f, 0.0f}};
    if (passes)
        motion.velocity = nkw_vec3_scale(nkw_vec3_sub(animated, foot->animated), 1.0f / h);
    foot->time = passes ? foot->time + h : foot->time;
    nkw_vec3_state to = followed(foot, &motion);
    nkw_vec3_state now = nkw_vec3_offset_evaluate(&foot->offset, &to, foot->time);
    if (passes && next_contact(foot, rules, &motion, ground) != (foot->contact != 0))
        change_contact(foot, rules, &motion, &now);
    foot->started = 1;
    foot->animated = animated;
    foot->position = now.value;
    return foot->position;
}
