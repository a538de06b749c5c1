/* SPDX-License-Identifier: MIT */
#include "mistake.h"

#include <nakawari/curve.h>
#include <nakawari/euler.h>
#include <nakawari/mat.h>
#include <nakawari/orient.h>
#include <nakawari/quat.h>
#include <nakawari/scalar.h>
#include <nakawari/vec.h>

#define DEGREES 57.2957795f

/* a p[0] + b p[1] + c p[2] + d p[3] */
static nkw_vec3 sum(const nkw_vec3 p[4], float a, float b, float c, float d)
{
    return nkw_vec3_add(nkw_vec3_add(nkw_vec3_scale(p[0], a), nkw_vec3_scale(p[1], b)),
                        nkw_vec3_add(nkw_vec3_scale(p[2], c), nkw_vec3_scale(p[3], d)));
}

/* ---- Hermite, (2) to (6): control has p0, v0, p1, v1 ---- */

/* t^3 + t^2 = h1 + 2 t^2 */
static nkw_vec3 plus_in_h1(const attempt *a)
{
    const float *w = a->right.weight, t = a->right.parameter;
    return sum(a->right.control, w[0], w[1], w[2], w[3] + 2 * t * t);
}

static nkw_vec3 tangents_as_they_are(const attempt *a)
{
    const float *w = a->right.weight;
    return sum(a->right.control, w[0], -w[1], w[2], -w[3]);
}

static nkw_vec3 blanks_exchanged(const attempt *a)
{
    const float *w = a->right.weight;
    return sum(a->right.control, w[0], w[2], w[1], w[3]);
}

/* ---- Bezier, (7) to (11) ---- */

/* The group of four keys that the exercise's program takes for a segment; 0 if there is none. */
static int group_of(const attempt *a, nkw_vec3 p[4])
{
    const size_t count = a->s->count;
    if (count < 4)
        return 0;
    size_t first = a->right.segment.index / 3 * 3;
    if (first + 4 > count)
        first -= 3;
    for (size_t i = 0; i < 4; i++)
        p[i] = a->s->keys[first + i].position;
    return 1;
}

/* s is 1 after the last complete group, where one control point is traced. */
static float group_parameter(const attempt *a)
{
    return a->right.control_count == 4 ? a->right.parameter : 1.0f;
}

/* (s - 1)^3 = -(1 - s)^3, and (s - 1)^2 = (1 - s)^2 */
static nkw_vec3 minus_one(const attempt *a)
{
    nkw_vec3 p[4];
    const nkw_weights k = nkw_cubic_weights(NKW_CUBIC_BEZIER, 0, group_parameter(a));
    return group_of(a, p) ? sum(p, -k.w[0], k.w[1], -k.w[2], k.w[3]) : a->right.position;
}

static nkw_vec3 t_for_s(const attempt *a)
{
    nkw_vec3 p[4];
    return group_of(a, p) ? nkw_vec3_bezier(p[0], p[1], p[2], p[3], a->right.segment.t) : a->right.position;
}

/* ---- B-spline, (12) to (16): in C, 1/6, 1/2 and 2/3 are 0 ---- */

static nkw_vec3 whole_fractions(const attempt *a)
{
    return nkw_vec3_scale(a->right.control[1], -a->right.parameter * a->right.parameter);
}

/* ---- Euler angles, 1.9 ---- */

static nkw_mat3 rotation_of_yxz(nkw_vec3 angles)
{
    return nkw_mat3_from_euler(angles, NKW_EULER_YXZ);
}

static nkw_vec3 angles_between(const attempt *a)
{
    return nkw_euler_lerp(a->right.angles[0], a->right.angles[1], a->right.segment.t, NKW_UNWRAP_NONE);
}

/* Yaw as ConvMatToEuler returns it: the trace has it unwrapped. */
static nkw_mat3 not_unwrapped(const attempt *a)
{
    nkw_vec3 from = a->right.angles[0];
    from.y = nkw_wrap_angle(from.y);
    return rotation_of_yxz(nkw_euler_lerp(from, a->right.angles[1], a->right.segment.t, NKW_UNWRAP_NONE));
}

static nkw_mat3 turned_by_degrees(const attempt *a)
{
    return rotation_of_yxz(nkw_vec3_scale(angles_between(a), DEGREES));
}

static nkw_mat3 reversed_product(const attempt *a)
{
    return nkw_mat3_from_euler(angles_between(a), NKW_EULER_ZXY);
}

/* ---- slerp, (17) and (18) ---- */

/* Of the sign that vecmath's set(Matrix3) chooses: w is positive from 1/2 on, otherwise the largest component is. */
static nkw_quat quaternion_of(const attempt *a, size_t key)
{
    nkw_mat3 m = nkw_mat3_from_quat(a->s->keys[key].orientation);
    nkw_quat q = nkw_quat_from_mat3(&m);
    return q.w <= -0.5f ? nkw_quat_negate(q) : q;
}

/* vecmath's interpolate: slerp with the signs as they are. */
static nkw_mat3 arc_as_it_is(nkw_quat q0, nkw_quat q1, float t)
{
    return nkw_mat3_from_quat(nkw_quat_slerp_path(q0, q1, t, NKW_PATH_AS_GIVEN, 0));
}

static nkw_mat3 blend(const attempt *a, float w0, float w1)
{
    const nkw_quat *q = a->right.orientation;
    return nkw_mat3_from_quat(nkw_quat_normalize(nkw_quat_add(nkw_quat_scale(q[0], w0), nkw_quat_scale(q[1], w1))));
}

static nkw_mat3 conjugated(const attempt *a)
{
    const size_t from = a->right.segment.index;
    nkw_quat q0 = quaternion_of(a, from), q1 = quaternion_of(a, from + 1);
    if (nkw_quat_dot(q0, q1) < 0.0f)
        q1 = nkw_quat_conjugate(q1);
    return arc_as_it_is(q0, q1, a->right.segment.t);
}

static nkw_mat3 never_negated(const attempt *a)
{
    const size_t from = a->right.segment.index;
    return arc_as_it_is(quaternion_of(a, from), quaternion_of(a, from + 1), a->right.segment.t);
}

static nkw_mat3 misplaced_bracket(const attempt *a)
{
    const float t = a->right.segment.t, theta = a->right.half_angle, sine = nkw_sin(theta);
    return sine > 0.0f ? blend(a, nkw_sin(1 - t) * theta / sine, a->right.orientation_weight[1]) : a->right.rotation;
}

static nkw_mat3 theta_in_degrees(const attempt *a)
{
    const float t = a->right.segment.t, theta = a->right.half_angle * DEGREES, sine = nkw_sin(theta);
    return sine != 0.0f ? blend(a, nkw_sin((1 - t) * theta) / sine, nkw_sin(t * theta) / sine) : a->right.rotation;
}

/* ---- all methods ---- */

static nkw_mat3 transposed(const attempt *a)
{
    return nkw_mat3_transpose(&a->right.rotation);
}

static scene by_the_other_rule(const attempt *a)
{
    scene other = *a->s;
    other.rule = a->s->rule == NKW_KEYFRAME_RULE_LIBRARY ? NKW_KEYFRAME_RULE_EXERCISE : NKW_KEYFRAME_RULE_LIBRARY;
    return other;
}

static nkw_vec3 other_rule_position(const attempt *a)
{
    const scene other = by_the_other_rule(a);
    nkw_mat4 m = scene_sample(&other, a->time, (nkw_position_method)a->method, NKW_ORIENTATION_STEP);
    return nkw_mat4_translation(&m);
}

static nkw_mat3 other_rule_orientation(const attempt *a)
{
    const scene other = by_the_other_rule(a);
    nkw_mat4 m = scene_sample(&other, a->time, NKW_POSITION_LINEAR, (nkw_orientation_method)a->method);
    return nkw_mat3_from_mat4(&m);
}

const mistake position_mistakes[] = {
    {"h1 has a plus, t^3 + t^2,", "(6)", NKW_POSITION_HERMITE, plus_in_h1, NULL},
    {"the tangents are not negated", "(2)", NKW_POSITION_HERMITE, tangents_as_they_are, NULL},
    {"blanks B and C are exchanged", "2.1", NKW_POSITION_HERMITE, blanks_exchanged, NULL},
    {"(t - 1) is used as printed", "(8) and (10)", NKW_POSITION_BEZIER, minus_one, NULL},
    {"t is used in place of s", "(7)", NKW_POSITION_BEZIER, t_for_s, NULL},
    {"1/6, 1/2 and 2/3 are divided as integers, and are 0,", "(13) to (16)", NKW_POSITION_BSPLINE, whole_fractions,
     NULL},
    {"the rule is the other one of --rule", "1.7", MISTAKE_ANY, other_rule_position, NULL},
    {NULL, NULL, 0, NULL, NULL},
};

const mistake orientation_mistakes[] = {
    {"yaw is not unwrapped", "1.9", NKW_ORIENTATION_EULER, NULL, not_unwrapped},
    {"sine and cosine take the angles in degrees", "1.9", NKW_ORIENTATION_EULER, NULL, turned_by_degrees},
    {"the rotations are multiplied as Rz Rx Ry", "1.9", NKW_ORIENTATION_EULER, NULL, reversed_product},
    {"q1 is conjugated, not negated,", "blank B of 2.4", NKW_ORIENTATION_SLERP, NULL, conjugated},
    {"q1 is never negated", "blank B of 2.4", NKW_ORIENTATION_SLERP, NULL, never_negated},
    {"sin(1 - t) theta is used as printed", "(17)", NKW_ORIENTATION_SLERP, NULL, misplaced_bracket},
    {"theta is in degrees", "(17)", NKW_ORIENTATION_SLERP, NULL, theta_in_degrees},
    {"the matrix is transposed", "1.7", MISTAKE_ANY, NULL, transposed},
    {"the rule is the other one of --rule, or the time is slightly after the key,", "1.7", MISTAKE_ANY, NULL,
     other_rule_orientation},
    {NULL, NULL, 0, NULL, NULL},
};
