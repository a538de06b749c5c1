/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/quat.h>
#include <nakawari/root.h>
#include <nakawari/transform.h>

#include "lane/arc.h"

/* A rotation, then a translation. */
typedef struct rigid {
    lane_f64_quat r;
    lane_f64_vec3 t;
} rigid;

static rigid rigid_from(const nkw_trs *trs)
{
    rigid a = {lane_f64_quat_unit_from(trs->rotation), lane_f64_vec3_from(trs->translation)};
    return a;
}

static nkw_trs trs_from(rigid a)
{
    nkw_trs trs = {lane_vec3_from_f64(a.t), lane_quat_from_f64(a.r), {1.0f, 1.0f, 1.0f}};
    return trs;
}

static rigid rigid_mul(rigid a, rigid b)
{
    rigid c = {lane_f64_quat_mul(a.r, b.r), lane_f64_vec3_add(a.t, lane_f64_quat_rotate(a.r, b.t))};
    return c;
}

static rigid rigid_inverse(rigid a)
{
    lane_f64_quat r = lane_f64_quat_conjugate(a.r);
    rigid c = {r, lane_f64_quat_rotate(r, lane_f64_vec3_scale(a.t, -1.0))};
    return c;
}

/*
 * a^k: with the angle 2 h about the axis u, the shorter arc, and the parts of t along the axis and across it,
 *
 *     rotation by 2 k h,      translation = k along + (sin kh / sin h) R((k - 1) h) across
 */
static rigid rigid_pow(rigid a, double k)
{
    lane_f64_quat identity = {0.0, 0.0, 0.0, 1.0};
    lane_f64_vec3 half = lane_f64_quat_log(lane_f64_quat_aligned(identity, a.r, NKW_PATH_SHORT));
    lane_f64_vec3 u = lane_f64_vec3_normalize(half);
    double h = lane_f64_vec3_length(half), part = 0.5 * (k - 1.0);
    lane_sincos one = lane_turn64_long(h), all = lane_turn64_long(k * h);
    lane_f64_quat middle = lane_f64_quat_from_axis_half(u, lane_turn64_long(part * h));
    lane_f64_vec3 along = lane_f64_vec3_scale(u, lane_f64_vec3_dot(u, a.t));
    lane_f64_vec3 across = lane_f64_quat_rotate(middle, lane_f64_vec3_sub(a.t, along));
    rigid c = {
        lane_f64_quat_from_axis_half(u, all),
        lane_f64_vec3_add_scaled(lane_f64_vec3_scale(along, k), across, one.s == 0.0 ? k : all.s / one.s),
    };
    return c;
}

/* ---- Motion and rest ---- */

static lane_f64_vec3 up_of(nkw_vec3 up)
{
    lane_f64_vec3 y = {0.0, 1.0, 0.0}, v = lane_f64_vec3_from(up);
    double n2 = lane_f64_vec3_dot(v, v);
    return n2 > 0.0 && n2 - n2 == 0.0 ? lane_f64_vec3_normalize(v) : y;
}

static nkw_trs motion_of(const nkw_root_rule *rule, const nkw_trs *root)
{
    lane_f64_vec3 up = up_of(rule->up), p = lane_f64_vec3_from(root->translation);
    lane_f64_vec3 along = lane_f64_vec3_scale(up, lane_f64_vec3_dot(up, p)), none = {0.0, 0.0, 0.0};
    lane_f64_vec3 plane = rule->parts & NKW_ROOT_PLANE ? lane_f64_vec3_sub(p, along) : none;
    lane_f64_vec3 height = rule->parts & NKW_ROOT_HEIGHT ? along : none;
    rigid m = {{0.0, 0.0, 0.0, 1.0}, lane_f64_vec3_add(plane, height)};
    if ((rule->parts & NKW_ROOT_PLANE) && (rule->parts & NKW_ROOT_HEIGHT))
        m.t = p;
    if (rule->parts & NKW_ROOT_ROTATION)
        m.r = lane_f64_quat_unit_from(root->rotation);
    else if (rule->parts & NKW_ROOT_YAW)
        m.r = lane_f64_quat_from(nkw_quat_swing_twist(root->rotation, lane_vec3_from_f64(up)).twist);
    return trs_from(m);
}

static nkw_trs rest_of(const nkw_trs *root, const nkw_trs *motion)
{
    rigid m = rigid_from(motion), r = {lane_f64_quat_from(root->rotation), lane_f64_vec3_from(root->translation)};
    lane_f64_quat back = lane_f64_quat_conjugate(m.r);
    rigid rest = {lane_f64_quat_mul(back, r.r), lane_f64_quat_rotate(back, lane_f64_vec3_sub(r.t, m.t))};
    nkw_trs trs = trs_from(rest);
    trs.scale = root->scale;
    return trs;
}

nkw_root_motion nkw_root_split(const nkw_root_rule *rule, const nkw_trs *root)
{
    nkw_root_motion parts;
    parts.motion = motion_of(rule, root);
    parts.rest = rest_of(root, &parts.motion);
    return parts;
}

void nkw_root_split_keys(const nkw_root_rule *rule, nkw_vec3 *translations, nkw_quat *rotations, nkw_trs *motions,
                         size_t count)
{
    for (size_t k = 0; k < count; k++) {
        nkw_trs root = nkw_trs_identity();
        if (translations)
            root.translation = translations[k];
        if (rotations)
            root.rotation = rotations[k];
        nkw_root_motion parts = nkw_root_split(rule, &root);
        if (translations)
            translations[k] = parts.rest.translation;
        if (rotations)
            rotations[k] = parts.rest.rotation;
        if (motions)
            motions[k] = parts.motion;
    }
}

/* ---- Steps and places ---- */

/* C^k = (last first^-1)^k. */
static rigid cycles_of(const nkw_root_cycle *cycle, double k)
{
    return rigid_pow(rigid_mul(rigid_from(&cycle->last), rigid_inverse(rigid_from(&cycle->first))), k);
}

nkw_trs nkw_root_delta(const nkw_root_cycle *cycle, const nkw_trs *from, const nkw_trs *to, double cycles)
{
    rigid end = rigid_from(to), back = rigid_inverse(rigid_from(from));
    return trs_from(rigid_mul(back, cycles == 0.0 ? end : rigid_mul(cycles_of(cycle, cycles), end)));
}

nkw_trs nkw_root_place(const nkw_root_cycle *cycle, const nkw_trs *origin, const nkw_trs *now, double number)
{
    rigid end = rigid_from(now), moved = number == 0.0 ? end : rigid_mul(cycles_of(cycle, number), end);
    rigid begin = rigid_mul(rigid_from(origin), rigid_inverse(rigid_from(&cycle->first)));
    nkw_trs place = trs_from(rigid_mul(begin, moved));
    place.scale = origin->scale;
    return place;
}

static size_t positive_count(const float *weights, size_t count)
{
    size_t n = 0;
    for (size_t i = 0; i < count; i++)
        n += weights[i] > 0.0f;
    return n;
}

/* The mean of one rotation is itself, without logarithm and exponential: in binary64 both are exact to 2^-50. */
nkw_trs nkw_root_blend(const nkw_trs *motions, const float *weights, size_t count)
{
    lane_f64_quat identity = {0.0, 0.0, 0.0, 1.0}, sum = {0.0, 0.0, 0.0, 0.0};
    lane_f64_vec3 t = {0.0, 0.0, 0.0}, half = {0.0, 0.0, 0.0};
    const size_t positive = positive_count(weights, count);
    double total = 0.0;
    for (size_t i = 0; i < count; i++) {
        double w = (double)weights[i];
        if (!(w > 0.0))
            continue;
        rigid m = rigid_from(&motions[i]);
        t = lane_f64_vec3_add_scaled(t, m.t, w);
        m.r = lane_f64_quat_aligned(identity, m.r, NKW_PATH_SHORT);
        sum = lane_f64_quat_add(sum, m.r);
        if (positive > 1)
            half = lane_f64_vec3_add_scaled(half, lane_f64_quat_log(m.r), w);
        total += w;
    }
    if (!(total > 0.0))
        return nkw_trs_identity();
    lane_f64_quat r = positive > 1 ? lane_f64_quat_exp(lane_f64_vec3_scale(half, 1.0 / total)) : sum;
    rigid mean = {r, lane_f64_vec3_scale(t, 1.0 / total)};
    return trs_from(mean);
}
