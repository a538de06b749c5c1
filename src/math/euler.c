/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/euler.h>

#include "lane/euler.h"
#include "lane/mat.h"
#include "pack/angles.h"
#include "pack/arcs.h"
#include "pack/quat.h"

/* In binary64, for angles of any size. */
static lane_f64_quat far_rotation(nkw_vec3 angles, const lane_euler_axes *o)
{
    const float a[3] = {angles.x, angles.y, angles.z};
    lane_f64_quat p = lane_f64_quat_from_half_angles(0.5 * (double)a[o->i], 0.5 * (double)a[o->j],
                                                     0.5 * (double)a[o->k], (double)o->e);
    lane_f64_vec3 v = lane_euler_in_place(p.x, p.y, p.z, o);
    lane_f64_quat q = {v.x, v.y, v.z, p.w};
    return q;
}

/* Of a proper order i j i. */
static lane_f64_quat proper_rotation(nkw_vec3 angles, const lane_euler_axes *o)
{
    lane_f64_quat p = lane_f64_quat_from_proper(0.5 * (double)angles.x, 0.5 * (double)angles.y, 0.5 * (double)angles.z,
                                                (double)o->e);
    lane_f64_vec3 v = lane_euler_in_place(p.x, p.y, p.z, o);
    lane_f64_quat q = {v.x, v.y, v.z, p.w};
    return q;
}

LANE_SELDOM static nkw_quat proper_quat(nkw_vec3 angles, const lane_euler_axes *o)
{
    return lane_quat_from_f64(proper_rotation(angles, o));
}

LANE_SELDOM static nkw_mat3 proper_mat3(nkw_vec3 angles, const lane_euler_axes *o)
{
    lane_f64_mat3 m = lane_f64_mat3_from_f64_quat(proper_rotation(angles, o));
    return lane_mat3_from_f64(&m, 1.0);
}

LANE_SELDOM static nkw_quat far_quat(nkw_vec3 angles, const lane_euler_axes *o)
{
    return lane_quat_from_f64(far_rotation(angles, o));
}

LANE_SELDOM static nkw_mat3 far_mat3(nkw_vec3 angles, const lane_euler_axes *o)
{
    lane_f64_mat3 m = lane_f64_mat3_from_f64_quat(far_rotation(angles, o));
    return lane_mat3_from_f64(&m, 1.0);
}

LANE_FLAT nkw_quat nkw_quat_from_euler(nkw_vec3 angles, nkw_euler_order order)
{
    const lane_euler_axes *o = lane_euler_axes_of(order);
    const float a[3] = {angles.x, angles.y, angles.z};
    if (lane_euler_is_proper(order))
        return proper_quat(angles, o);
    if (lane_angles_are_far(angles.x, angles.y, angles.z))
        return far_quat(angles, o);
    nkw_quat p = lane_quat_from_halves(f32x4_turns(0.5f * a[o->i], 0.5f * a[o->j], 0.5f * a[o->k]), o->e);
    const float v[3] = {p.x, p.y, p.z};
    nkw_quat q = {v[o->of[0]], v[o->of[1]], v[o->of[2]], p.w};
    return q;
}

LANE_FLAT nkw_mat3 nkw_mat3_from_euler(nkw_vec3 angles, nkw_euler_order order)
{
    const lane_euler_axes *o = lane_euler_axes_of(order);
    const float a[3] = {angles.x, angles.y, angles.z};
    if (lane_euler_is_proper(order))
        return proper_mat3(angles, o);
    if (lane_angles_are_far(angles.x, angles.y, angles.z))
        return far_mat3(angles, o);
    nkw_mat3 m = lane_mat3_from_turns(f32x4_turns(a[o->i], a[o->j], a[o->k]), o->e);
    return lane_euler_mat3_in_place(&m, o);
}

/* Normalises a quaternion whose length is outside the range of the fast formula. Zero returns the identity. */
LANE_SELDOM static lane_f64_quat rescued(lane_f64_quat q)
{
    return lane_f64_quat_normalize(q);
}

/*
 * Sum and difference of the outer angles from the two halves of the quaternion; see nkw_euler_from_quat. With
 * P = |(w + qj, qi + e qk)|^2 and M = |(w - qj, qi - e qk)|^2
 *
 *     sin j : cos j = (P - M)/2 : sqrt(P M),     (P - M)/2 = 2 (w qj + e qi qk),     (P + M)/2 = |q|^2
 *
 * so q need not be unit: |q|^2 in 2^-20 .. 2^20. A half that is shorter than the rounding of a unit quaternion of
 * floats, 2^-24, is the pole.
 */
static nkw_vec3 angles_of(lane_f64_quat q, const lane_euler_axes *o)
{
    const double v[3] = {q.x, q.y, q.z};
    double e = (double)o->e, vi = v[o->i], vj = v[o->j], vk = e * v[o->k];
    double pc = q.w + vj, ps = vi + vk, mc = q.w - vj, ms = vi - vk;
    double plus = pc * pc + ps * ps, minus = mc * mc + ms * ms;
    double pole = 0x1p-49 * (plus + minus);
    const double y[3] = {ps, ms, 2.0 * (q.w * vj + vi * vk)}, x[3] = {pc, mc, lane_sqrt64_near(plus * minus)};
    double a[3];
    f64x2_three_arcs(y, x, a);
    /* At a pole the missing half is taken so that k is 0. */
    int north = minus < pole, south = plus < pole;
    double p = south ? a[1] : a[0], m = north ? p : a[1];
    double j = north ? LANE_HALF_PI : south ? -LANE_HALF_PI : a[2];
    double k = north || south ? 0.0 : lane_wrap_once(e * (p - m));
    lane_f64_vec3 r = lane_euler_in_place(lane_wrap_once(p + m), j, k, o);
    return vec3_result((float)r.x, (float)r.y, (float)r.z);
}

/*
 * The same of an order i j i. With P = |(w, qi)|^2 and M = |(qj, qk)|^2
 *
 *     sin j : cos j = 2 sqrt(P M) : P - M,     P + M = |q|^2
 */
LANE_SELDOM static nkw_vec3 proper_angles_of(lane_f64_quat q, const lane_euler_axes *o)
{
    const double v[3] = {q.x, q.y, q.z};
    double pc = q.w, ps = v[o->i], mc = v[o->j], ms = (double)o->e * v[o->k];
    double plus = pc * pc + ps * ps, minus = mc * mc + ms * ms, pole = 0x1p-48 * (plus + minus);
    const double y[3] = {ps, ms, 2.0 * lane_sqrt64_near(plus * minus)}, x[3] = {pc, mc, plus - minus};
    double a[3];
    f64x2_three_arcs(y, x, a);
    int same = minus < pole, opposite = plus < pole;
    double p = opposite ? a[1] : a[0], m = same ? p : a[1];
    double j = same ? 0.0 : opposite ? LANE_PI : a[2], k = same || opposite ? 0.0 : lane_wrap_once(p - m);
    return vec3_result((float)lane_wrap_once(p + m), (float)j, (float)k);
}

static nkw_vec3 order_angles_of(lane_f64_quat q, nkw_euler_order order)
{
    const lane_euler_axes *o = lane_euler_axes_of(order);
    return lane_euler_is_proper(order) ? proper_angles_of(q, o) : angles_of(q, o);
}

LANE_FLAT nkw_vec3 nkw_euler_from_quat(nkw_quat q, nkw_euler_order order)
{
    lane_f64_quat w = lane_f64_quat_from(quat_argument(q));
    double n2 = lane_f64_quat_dot(w, w);
    if (!(n2 > 0x1p-20 && n2 < 0x1p20))
        w = rescued(w);
    return order_angles_of(lane_f64_quat_positive(w), order);
}

LANE_FLAT nkw_vec3 nkw_euler_from_mat3(const nkw_mat3 *m, nkw_euler_order order)
{
    lane_f64_mat3 w = lane_f64_mat3_from(m);
    lane_f64_form k = lane_f64_form_from_f64_mat3(&w);
    lane_f64_quat q = lane_f64_form_dominant(&k, LANE_NEAREST_STEPS);
    if (!(lane_f64_quat_dot(q, q) < 0x1p20))
        q = rescued(q);
    return order_angles_of(q, order);
}

nkw_vec3 nkw_euler_unwrap(nkw_vec3 angles, nkw_vec3 reference)
{
    nkw_vec3 r = {
        lane_unwrap(angles.x, reference.x),
        lane_unwrap(angles.y, reference.y),
        lane_unwrap(angles.z, reference.z),
    };
    return r;
}

/* x without half a turn, towards 0. */
static float turned_half(float x)
{
    return (float)((double)x - lane_copysign64(LANE_PI, (double)x));
}

nkw_vec3 nkw_euler_alternate(nkw_vec3 angles, nkw_euler_order order)
{
    const lane_euler_axes *o = lane_euler_axes_of(order);
    const float a[3] = {angles.x, angles.y, angles.z};
    if (lane_euler_is_proper(order)) {
        nkw_vec3 other = {turned_half(angles.x), -angles.y, turned_half(angles.z)};
        return other;
    }
    const float v[3] = {turned_half(a[o->i]), -turned_half(a[o->j]), turned_half(a[o->k])};
    nkw_vec3 r = {v[o->of[0]], v[o->of[1]], v[o->of[2]]};
    return r;
}

/* The sum of the squared differences of the angles. */
static double squared_distance(nkw_vec3 a, nkw_vec3 b)
{
    lane_f64_vec3 d = lane_f64_vec3_sub(lane_f64_vec3_from(a), lane_f64_vec3_from(b));
    return lane_f64_vec3_dot(d, d);
}

nkw_vec3 nkw_euler_nearest(nkw_vec3 angles, nkw_vec3 reference, nkw_euler_order order)
{
    nkw_vec3 first = nkw_euler_unwrap(angles, reference);
    nkw_vec3 second = nkw_euler_unwrap(nkw_euler_alternate(angles, order), reference);
    return squared_distance(second, reference) < squared_distance(first, reference) ? second : first;
}

void nkw_euler_filter(const nkw_vec3 *angles, size_t count, nkw_euler_order order, nkw_vec3 *out)
{
    for (size_t i = 0; i < count; i++)
        out[i] = i > 0 ? nkw_euler_nearest(angles[i], out[i - 1], order) : angles[i];
}

nkw_vec3 nkw_euler_lerp(nkw_vec3 a, nkw_vec3 b, float t, nkw_unwrap unwrap)
{
    int all = unwrap == NKW_UNWRAP_ALL;
    nkw_vec3 r = {
        lane_angle_lerp(a.x, b.x, t, all),
        lane_angle_lerp(a.y, b.y, t, all || unwrap == NKW_UNWRAP_YAW),
        lane_angle_lerp(a.z, b.z, t, all),
    };
    return r;
}
