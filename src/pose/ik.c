/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/ik.h>
#include <nakawari/orient.h>
#include <nakawari/quat.h>
#include <nakawari/vec.h>

#include "ik_turn.h"
#include "lane/quat.h"
#include "lane/scalar.h"

/* Squared sine below which directions count as parallel: the rounding of model matrices. */
#define IK_PARALLEL 0x1p-36

/* sin(1/4): a limb that is bent by less than 1/4 rad, to either side, is heard to be straight. */
#define STRAIGHT_SINE 0x1.faaeed4f31577p-3

static int limb_is_finite(const nkw_ik_two_bone *limb)
{
    return nkw_vec3_is_finite(limb->root) && nkw_vec3_is_finite(limb->mid) && nkw_vec3_is_finite(limb->end) &&
           nkw_vec3_is_finite(limb->target) && nkw_vec3_is_finite(limb->pole) && nkw_vec3_is_finite(limb->hinge);
}

/* A direction that is not given: what it would decide is not computed. */
static int is_zero(nkw_vec3 v)
{
    return v.x == 0.0f && v.y == 0.0f && v.z == 0.0f;
}

/* ---- Two bones ---- */

/* A limb in binary64: the bones u, v and their lengths a, b; the target seen from the root, at the distance d. */
typedef struct two_bone {
    lane_f64_vec3 u, v, target, pole;
    double a, b, d;
} two_bone;

static two_bone two_bone_of(const nkw_ik_two_bone *limb)
{
    lane_f64_vec3 root = lane_f64_vec3_from(limb->root), mid = lane_f64_vec3_from(limb->mid);
    two_bone t;
    t.u = lane_f64_vec3_sub(mid, root);
    t.v = lane_f64_vec3_sub(lane_f64_vec3_from(limb->end), mid);
    t.target = lane_f64_vec3_sub(lane_f64_vec3_from(limb->target), root);
    t.pole = lane_f64_vec3_from(limb->pole);
    if (!is_zero(limb->pole))
        t.pole = lane_f64_vec3_normalize(t.pole);
    t.a = lane_f64_vec3_length(t.u);
    t.b = lane_f64_vec3_length(t.v);
    t.d = lane_f64_vec3_length(t.target);
    return t;
}

/* The distance of the end from the root: that of the target, softened, and clamped to what the bones allow. */
static double reach_of(const two_bone *t, float softness)
{
    double length = t->a + t->b, least = lane_abs64(t->a - t->b), r = t->d;
    double share = softness > 0.0f ? softness < 1.0f ? (double)softness : 1.0 : 0.0, start = length - share * length;
    if (share > 0.0) {
        double is = lane_f64_vec3_length(lane_f64_vec3_add(t->u, t->v));
        start = is > start ? is : start;
    }
    double soft = length - start;
    if (soft > 0.0 && r > start)
        r = length - soft * lane_exp2_64(lane_limit64((start - r) / soft * LANE_LOG2_E, -1000.0, 0.0));
    r = r < length ? r : length;
    return r > least ? r : least;
}

/* An axis of the middle joint: a positive rotation about it extends the limb. */
typedef struct hinge {
    lane_f64_vec3 axis; /* unit, across the first bone, and across the second after `turn` */
    lane_f64_quat turn; /* the second bone to the plane across the axis */
    int is_turned; /* turn is not the identity */
    double side; /* 1; -1 if the second bone is past straight */
} hinge;

/*
 * The given hinge h, a unit vector across the first bone, of a limb that is bent by less than STRAIGHT. With the normal n
 * of its plane, on the side of h, and the share k = sin(bend) / sin(STRAIGHT), the axis is that of k n + (1 - k) h.
 * `turn` is the shortest rotation of the second bone that keeps its bend b, to (cos b, +-sin b) along the first bone and
 * bone x axis.
 */
static hinge heard(const two_bone *t, lane_f64_vec3 bone, lane_f64_vec3 n, double sine, lane_f64_vec3 h)
{
    double k = sine / (t->a * t->b * STRAIGHT_SINE), side = lane_f64_vec3_dot(n, h) < 0.0 ? -1.0 : 1.0;
    lane_f64_vec3 normal = lane_f64_vec3_scale(n, side / sine);
    lane_f64_vec3 axis = lane_f64_vec3_add_scaled(lane_f64_vec3_scale(normal, k), h, 1.0 - k);
    axis = lane_f64_vec3_add_scaled(axis, bone, -lane_f64_vec3_dot(axis, bone));
    hinge r = {lane_f64_vec3_normalize(axis), {0.0, 0.0, 0.0, 1.0}, 1, side};
    lane_f64_vec3 across = lane_f64_vec3_scale(lane_f64_vec3_cross(bone, r.axis), side * sine / t->a);
    lane_f64_vec3 to = lane_f64_vec3_add_scaled(across, bone, lane_f64_vec3_dot(t->v, bone));
    r.turn = ik_turn_between(t->v, to);
    return r;
}

/* The axis of the limb's plane; of a limb that is nearly straight, the given one, or that to the pole, or any. */
static hinge hinge_of(const two_bone *t, nkw_vec3 given)
{
    lane_f64_vec3 n = lane_f64_vec3_cross(t->v, t->u);
    lane_f64_vec3 bone = lane_f64_vec3_scale(t->u, 1.0 / t->a);
    double sine2 = lane_f64_vec3_dot(n, n), scale2 = (t->a * t->a) * (t->b * t->b);
    int is_bent = sine2 >= IK_PARALLEL * scale2;
    int is_straight = sine2 < STRAIGHT_SINE * STRAIGHT_SINE * scale2 && lane_f64_vec3_dot(t->u, t->v) > 0.0;
    hinge r = {lane_f64_vec3_normalize(n), {0.0, 0.0, 0.0, 1.0}, 0, 1.0};
    if (is_bent && (!is_straight || is_zero(given)))
        return r;
    lane_f64_vec3 h = lane_f64_vec3_normalize(lane_f64_vec3_from(given));
    h = lane_f64_vec3_add_scaled(h, bone, -lane_f64_vec3_dot(h, bone));
    int is_given = lane_f64_vec3_dot(h, h) >= IK_PARALLEL;
    h = lane_f64_vec3_normalize(h);
    if (is_bent)
        return is_given ? heard(t, bone, n, lane_sqrt64(sine2), h) : r;
    n = lane_f64_vec3_cross(bone, t->pole);
    r.axis = lane_f64_vec3_dot(n, n) >= IK_PARALLEL ? lane_f64_vec3_normalize(n) : lane_f64_vec3_perpendicular(bone);
    r.axis = is_given ? h : r.axis;
    return r;
}

/*
 * Cosine and sine of half the angle between the bones at the distance r: their squares times 4 a b. The divisor is the
 * sum of both, which is 4 a b unless the shorter bone is lost in the roundings of the longer one. If both are 0, the
 * limb is straight: 2^-600 is nothing beside any other number.
 */
static lane_sincos half_angle_at(const two_bone *t, double r)
{
    double least = t->a - t->b, most = t->a + t->b;
    double c2 = (most - r) * (most + r), s2 = (r - least) * (r + least);
    c2 = c2 > 0.0 ? c2 : 0.0;
    s2 = (s2 > 0.0 ? s2 : 0.0) + 0x1p-600;
    double scale = 1.0 / (c2 + s2);
    lane_sincos half = {lane_sqrt64(s2 * scale), lane_sqrt64(c2 * scale)};
    return half;
}

/* The same of the bones as they are: half the sum and half the difference of their directions from the middle joint. */
static lane_sincos half_angle_of(const two_bone *t)
{
    lane_f64_vec3 back = lane_f64_vec3_scale(t->u, -1.0 / t->a), on = lane_f64_vec3_scale(t->v, 1.0 / t->b);
    lane_sincos half = {0.5 * lane_f64_vec3_length(lane_f64_vec3_sub(on, back)),
                        0.5 * lane_f64_vec3_length(lane_f64_vec3_add(on, back))};
    return half;
}

/* The rotation of the middle joint. */
static lane_f64_quat bend_of(const two_bone *t, double r, nkw_vec3 given)
{
    const lane_f64_quat identity = {0.0, 0.0, 0.0, 1.0};
    if (t->a == 0.0 || t->b == 0.0)
        return identity;
    lane_sincos want = half_angle_at(t, r), is = half_angle_of(t);
    hinge h = hinge_of(t, given);
    is.c *= h.side;
    lane_sincos half = {want.s * is.c - want.c * is.s, want.c * is.c + want.s * is.s};
    lane_f64_quat bend = lane_f64_quat_from_axis_half(h.axis, half);
    return h.is_turned ? lane_f64_quat_normalize(lane_f64_quat_mul(bend, h.turn)) : bend;
}

/* The rotation of the root: the end to the direction of the target, the middle joint to the side of the pole. */
static lane_f64_quat swing_of(const two_bone *t, lane_f64_vec3 end, nkw_vec3 pole)
{
    lane_f64_vec3 to = t->d > 0.0 ? t->target : end;
    lane_f64_quat swing = ik_turn_between(end, to);
    if (is_zero(pole))
        return swing;
    lane_f64_vec3 line = lane_f64_vec3_normalize(to);
    return lane_f64_quat_mul(ik_turn_about(line, lane_f64_quat_rotate(swing, t->u), t->pole, IK_PARALLEL), swing);
}

nkw_ik_two_bone_solution nkw_ik_two_bone_solve(const nkw_ik_two_bone *limb)
{
    nkw_ik_two_bone_solution r = {nkw_quat_identity(), nkw_quat_identity(), limb->mid, limb->end, INFINITY};
    if (!limb_is_finite(limb))
        return r;
    two_bone t = two_bone_of(limb);
    lane_f64_quat mid = bend_of(&t, reach_of(&t, limb->softness), limb->hinge);
    lane_f64_vec3 end = lane_f64_vec3_add(t.u, lane_f64_quat_rotate(mid, t.v));
    r.mid = ik_weighted(mid, limb->weight);
    r.root = ik_weighted(swing_of(&t, end, limb->pole), limb->weight);
    /* The positions and the error are those of the rotations as they are rounded. */
    lane_f64_quat turn = lane_f64_quat_unit_from(r.root);
    mid = lane_f64_quat_unit_from(r.mid);
    end = lane_f64_quat_rotate(turn, lane_f64_vec3_add(t.u, lane_f64_quat_rotate(mid, t.v)));
    lane_f64_vec3 root = lane_f64_vec3_from(limb->root);
    r.mid_position = lane_vec3_from_f64(lane_f64_vec3_add(root, lane_f64_quat_rotate(turn, t.u)));
    r.end_position = lane_vec3_from_f64(lane_f64_vec3_add(root, end));
    r.error = (float)lane_f64_vec3_length(lane_f64_vec3_sub(end, t.target));
    return r;
}

/* ---- Aim ---- */

static int aim_is_finite(const nkw_ik_aim *aim)
{
    return nkw_vec3_is_finite(aim->position) && nkw_vec3_is_finite(aim->offset) && nkw_vec3_is_finite(aim->forward) &&
           nkw_vec3_is_finite(aim->target) && nkw_vec3_is_finite(aim->up) && nkw_vec3_is_finite(aim->pole) &&
           nkw_vec3_is_finite(aim->limit_axis);
}

/* Where the ray meets the sphere of radius d about the joint, or its nearest point to the joint. */
static lane_f64_vec3 meeting_point(lane_f64_vec3 offset, lane_f64_vec3 forward, double d)
{
    double along = lane_f64_vec3_dot(offset, forward);
    lane_f64_vec3 nearest = lane_f64_vec3_add_scaled(offset, forward, -along);
    double rest = d * d - lane_f64_vec3_dot(nearest, nearest);
    return lane_f64_vec3_add_scaled(nearest, forward, lane_sqrt64(rest > 0.0 ? rest : 0.0));
}

/* The rotation that brings a direction into a cone. */
static lane_f64_quat into_cone(lane_f64_vec3 direction, nkw_vec3 given, float angle)
{
    const lane_f64_quat identity = {0.0, 0.0, 0.0, 1.0};
    lane_f64_vec3 axis = lane_f64_vec3_normalize(lane_f64_vec3_from(given));
    double most = angle > 0.0f ? (double)angle : 0.0;
    lane_f64_vec3 across = lane_f64_vec3_cross(axis, direction);
    double is = lane_atan2_64(lane_f64_vec3_length(across), lane_f64_vec3_dot(axis, direction));
    if (angle != angle || !(is > most))
        return identity;
    lane_f64_vec3 unit = lane_f64_vec3_normalize(direction);
    return lane_f64_quat_from_axis_half(ik_axis_between(axis, unit), lane_sincos64(0.5 * (most - is)));
}

static lane_f64_quat aim_of(const nkw_ik_aim *aim, lane_f64_vec3 forward, lane_f64_vec3 target)
{
    lane_f64_vec3 meets = forward;
    if (!is_zero(aim->offset))
        meets = meeting_point(lane_f64_vec3_from(aim->offset), forward, lane_f64_vec3_length(target));
    lane_f64_quat turn = ik_turn_between(meets, target);
    double d = is_zero(aim->up) || is_zero(aim->pole) ? 0.0 : lane_f64_vec3_length(target);
    if (d > 0.0) {
        lane_f64_vec3 up = lane_f64_quat_rotate(turn, lane_f64_vec3_normalize(lane_f64_vec3_from(aim->up)));
        lane_f64_vec3 pole = lane_f64_vec3_normalize(lane_f64_vec3_from(aim->pole));
        turn = lane_f64_quat_mul(ik_turn_about(lane_f64_vec3_scale(target, 1.0 / d), up, pole, IK_PARALLEL), turn);
    }
    if (is_zero(aim->limit_axis))
        return turn;
    return lane_f64_quat_mul(into_cone(lane_f64_quat_rotate(turn, forward), aim->limit_axis, aim->limit_angle), turn);
}

nkw_ik_aim_solution nkw_ik_aim_solve(const nkw_ik_aim *aim)
{
    nkw_ik_aim_solution r = {nkw_quat_identity(), INFINITY};
    if (!aim_is_finite(aim))
        return r;
    lane_f64_vec3 forward = lane_f64_vec3_normalize(lane_f64_vec3_from(aim->forward));
    lane_f64_vec3 offset = lane_f64_vec3_from(aim->offset);
    lane_f64_vec3 target = lane_f64_vec3_sub(lane_f64_vec3_from(aim->target), lane_f64_vec3_from(aim->position));
    r.error = 0.0f;
    if (lane_f64_vec3_dot(forward, forward) == 0.0)
        return r;
    r.rotation = ik_weighted(aim_of(aim, forward, target), aim->weight);
    lane_f64_quat turn = lane_f64_quat_unit_from(r.rotation);
    lane_f64_vec3 rest = lane_f64_vec3_sub(target, lane_f64_quat_rotate(turn, offset));
    lane_f64_vec3 ray = lane_f64_quat_rotate(turn, forward);
    double sine = lane_f64_vec3_length(lane_f64_vec3_cross(ray, rest)), cosine = lane_f64_vec3_dot(ray, rest);
    r.error = sine == 0.0 && cosine == 0.0 ? 0.0f : (float)lane_atan2_64(sine, cosine);
    return r;
}
