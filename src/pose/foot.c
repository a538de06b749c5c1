/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/curve.h>
#include <nakawari/foot.h>
#include <nakawari/scalar.h>
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
    return is_contact(rules, foot->contact && !foot->is_assumed, height, speed);
}

/* The share of a transition that has passed after `time` seconds. */
static float share_of(const nkw_foot_rules *rules, float time)
{
    float duration = rules->duration;
    return duration > 0.0f && time < duration ? time / duration : 1.0f;
}

/* The motion of the foot: of the lock, from the lock to the animation, of the animation. */
static nkw_vec3_state motion_of(const nkw_foot *foot, const nkw_foot_rules *rules, const nkw_vec3_state *animated)
{
    const nkw_vec3_state still = {foot->locked, {0.0f, 0.0f, 0.0f}};
    static const float fade[4] = {1.0f, 0.0f, 0.0f, 0.0f};
    float u = share_of(rules, foot->released);
    if (!foot->contact && !(u < 1.0f && foot->weight_before > 0.0f))
        return *animated;
    nkw_vec3_state held = nkw_vec3_offset_evaluate(&foot->offset, &still, foot->time);
    if (foot->contact)
        return held;
    nkw_motion kept = nkw_cubic_evaluate(fade, u, NKW_CUBIC_HERMITE);
    float rate = kept.velocity / rules->duration;
    nkw_vec3 away = nkw_vec3_sub(held.value, animated->value), drift = nkw_vec3_sub(held.velocity, animated->velocity);
    nkw_vec3_state between = {
        nkw_vec3_add_scaled(animated->value, away, kept.value),
        nkw_vec3_add_scaled(nkw_vec3_add_scaled(animated->velocity, drift, kept.value), away, rate),
    };
    return between;
}

static float weight_of(const nkw_foot *foot, const nkw_foot_rules *rules)
{
    float w = foot->weight_before, s = nkw_smoothstep(share_of(rules, foot->contact ? foot->time : foot->released));
    return foot->contact ? w + (1.0f - w) * s : w * (1.0f - s);
}

/* Locks the foot at the animation; `now` is its motion. */
static void lock(nkw_foot *foot, const nkw_foot_rules *rules, nkw_vec3 at, const nkw_vec3_state *now)
{
    const nkw_vec3_state to = {at, {0.0f, 0.0f, 0.0f}};
    foot->contact = 1;
    foot->locked = at;
    foot->time = 0.0f;
    foot->offset.kind = NKW_OFFSET_INERTIA;
    foot->offset.duration = rules->duration;
    nkw_vec3_offset_begin(&foot->offset, now, &to);
}

/* The first position: in contact it is the lock, with the whole weight. */
static void start(nkw_foot *foot, const nkw_foot_rules *rules, nkw_vec3 animated, int contact)
{
    const nkw_vec3_state still = {animated, {0.0f, 0.0f, 0.0f}};
    lock(foot, rules, animated, &still);
    foot->contact = contact;
    foot->weight = foot->weight_before = contact ? 1.0f : 0.0f;
    foot->released = 0.0f;
    foot->started = 1;
}

/* Changes the contact. A first contact that is not confirmed leaves nothing behind. */
static void change(nkw_foot *foot, const nkw_foot_rules *rules, const nkw_vec3_state *animated,
                   const nkw_vec3_state *now)
{
    foot->weight_before = foot->is_assumed ? 0.0f : weight_of(foot, rules);
    foot->released = 0.0f;
    if (foot->contact)
        foot->contact = 0;
    else
        lock(foot, rules, animated->value, now);
}

static nkw_vec3_state passed(nkw_foot *foot, nkw_vec3 animated, float h)
{
    int passes = h > 0.0f;
    nkw_vec3_state motion = {animated, {0.0f, 0.0f, 0.0f}};
    if (passes)
        motion.velocity = nkw_vec3_scale(nkw_vec3_sub(animated, foot->animated), 1.0f / h);
    foot->time = passes ? foot->time + h : foot->time;
    foot->released = passes ? foot->released + h : foot->released;
    return motion;
}

/* The end of an update, in which the contact becomes `contact`. */
static nkw_vec3 updated(nkw_foot *foot, const nkw_foot_rules *rules, const nkw_vec3_state *animated, int contact)
{
    nkw_vec3_state now = motion_of(foot, rules, animated);
    if (contact != (foot->contact != 0)) {
        change(foot, rules, animated, &now);
        now = foot->is_assumed ? *animated : now;
    }
    foot->weight = weight_of(foot, rules);
    foot->animated = animated->value;
    foot->position = now.value;
    return foot->position;
}

nkw_vec3 nkw_foot_update(nkw_foot *foot, const nkw_foot_rules *rules, nkw_vec3 animated, float ground, float h)
{
    if (!nkw_vec3_is_finite(animated) || !lane_is_finite(ground) || !lane_is_finite(h))
        return foot->position;
    int begins = !foot->started, passes = !begins && h > 0.0f;
    if (begins)
        start(foot, rules, animated, is_contact(rules, 0, height_of(rules, animated, ground), 0.0f));
    nkw_vec3_state motion = passed(foot, animated, begins ? 0.0f : h);
    int contact = passes ? next_contact(foot, rules, &motion, ground) : foot->contact != 0;
    nkw_vec3 position = updated(foot, rules, &motion, contact);
    foot->is_assumed = begins ? foot->contact : foot->is_assumed && !passes;
    return position;
}

nkw_vec3 nkw_foot_update_given(nkw_foot *foot, const nkw_foot_rules *rules, nkw_vec3 animated, int contact, float h)
{
    if (!nkw_vec3_is_finite(animated) || !lane_is_finite(h))
        return foot->position;
    int begins = !foot->started;
    if (begins)
        start(foot, rules, animated, contact != 0);
    nkw_vec3_state motion = passed(foot, animated, begins ? 0.0f : h);
    foot->is_assumed = 0;
    return updated(foot, rules, &motion, contact != 0);
}
