/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/rotation.h>

#include "lane/arc.h"
#include "lane/cubic.h"
#include "rotation_squad.h"

static const lane_f64_quat identity = {0.0, 0.0, 0.0, 1.0};

/* ---- Products of rotations ---- */

/* exp(b half): half the rotation vector, and b with its derivatives by t. */
typedef struct factor {
    lane_f64_vec3 half;
    double b, b1, b2;
} factor;

/* A product so far, with velocity and acceleration by t in the frame of the object. */
typedef struct motion {
    lane_f64_quat q;
    lane_f64_vec3 w, a;
} motion;

static motion multiplied(motion m, const factor *f)
{
    lane_f64_quat e = lane_f64_quat_exp(lane_f64_vec3_scale(f->half, f->b)), back = lane_f64_quat_conjugate(e);
    lane_f64_vec3 v1 = lane_f64_vec3_scale(f->half, 2.0 * f->b1), v2 = lane_f64_vec3_scale(f->half, 2.0 * f->b2);
    motion r;
    r.q = lane_f64_quat_mul(m.q, e);
    r.w = lane_f64_vec3_add(lane_f64_quat_rotate(back, m.w), v1);
    r.a = lane_f64_vec3_add(lane_f64_vec3_add(lane_f64_quat_rotate(back, m.a), v2), lane_f64_vec3_cross(r.w, v1));
    return r;
}

static motion product_of(lane_f64_quat q0, const factor *factors, int count)
{
    motion m = {q0, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
    for (int i = 0; i < count; i++)
        m = multiplied(m, &factors[i]);
    m.w = lane_f64_quat_rotate(m.q, m.w);
    m.a = lane_f64_quat_rotate(m.q, m.a);
    return m;
}

/* ---- Weights ---- */

static factor factor_of(lane_f64_vec3 half, double b, double b1, double b2)
{
    factor f = {half, b, b1, b2};
    return f;
}

static factor first_of_hermite(lane_f64_vec3 half, double t)
{
    double s = 1.0 - t;
    return factor_of(half, t * (3.0 - t * (3.0 - t)), 3.0 * (s * s), -6.0 * s);
}

static factor middle_of_hermite(lane_f64_vec3 half, double t)
{
    return factor_of(half, lane_f64_hermite_weights(t).f, 6.0 * t * (1.0 - t), 6.0 - 12.0 * t);
}

static factor last_of_hermite(lane_f64_vec3 half, double t)
{
    return factor_of(half, t * t * t, 3.0 * (t * t), 6.0 * t);
}

/* ---- Segments ---- */

static lane_f64_quat control_of(const nkw_rotation_segment *s, int i)
{
    return lane_f64_quat_unit_from(s->control[i]);
}

/* ---- The kinds at t, derivatives by t. `sign` receives the sign with which the second end is reached ---- */

/* Half the rotation vector from 1 to q along the path, and the sign of q at its end. */
static lane_f64_vec3 arc_to(lane_f64_quat q, nkw_path path, int32_t turns, double *sign)
{
    lane_f64_quat to = lane_f64_quat_aligned(identity, q, path);
    lane_f64_arc arc = lane_f64_arc_between(identity, to);
    lane_f64_vec3 axis = {arc.e.x, arc.e.y, arc.e.z};
    *sign = (lane_f64_quat_dot(to, q) < 0.0) != (turns % 2 != 0) ? -1.0 : 1.0;
    return lane_f64_vec3_scale(axis, arc.h + LANE_PI * (double)turns);
}

static motion slerp_at(const nkw_rotation_segment *s, double t, double *sign)
{
    lane_f64_quat a = control_of(s, 0), turn = lane_f64_quat_mul(lane_f64_quat_conjugate(a), control_of(s, 1));
    factor f = factor_of(arc_to(turn, s->path, s->turns, sign), t, 1.0, 0.0);
    motion m = product_of(a, &f, 1);
    lane_f64_quat b = lane_f64_quat_aligned(a, control_of(s, 1), s->path);
    m.q = lane_f64_quat_slerp_turned(a, b, t, (double)s->turns, 0); /* for any number of turns */
    return m;
}

static motion hermite_at(const nkw_rotation_segment *s, double t, double *sign)
{
    double sixth = s->duration > 0.0f ? (double)s->duration / 6.0 : 0.0;
    lane_f64_quat a = control_of(s, 0), b = control_of(s, 1);
    lane_f64_quat a1 = lane_f64_quat_conjugate(a), b1 = lane_f64_quat_conjugate(b);
    lane_f64_vec3 u = lane_f64_vec3_scale(lane_f64_quat_rotate(a1, lane_f64_vec3_from(s->velocity[0])), sixth);
    lane_f64_vec3 w = lane_f64_vec3_scale(lane_f64_quat_rotate(b1, lane_f64_vec3_from(s->velocity[1])), sixth);
    lane_f64_vec3 m = lane_f64_vec3_scale(lane_f64_vec3_add(u, w), 0.5);
    lane_f64_quat first = lane_f64_quat_mul(lane_f64_quat_exp(u), lane_f64_quat_exp(m));
    lane_f64_quat rest = lane_f64_quat_mul(lane_f64_quat_conjugate(first), lane_f64_quat_mul(a1, b));
    rest = lane_f64_quat_mul(rest, lane_f64_quat_conjugate(lane_f64_quat_exp(w)));
    lane_f64_vec3 r = arc_to(rest, s->path, s->turns, sign);
    factor factors[4] = {first_of_hermite(u, t), middle_of_hermite(m, t), middle_of_hermite(r, t),
                         last_of_hermite(w, t)};
    return product_of(a, factors, 4);
}

static motion bspline_at(const nkw_rotation_segment *s, double t)
{
    double r = 1.0 - t, sixth = 1.0 / 6.0, sign;
    factor factors[3] = {
        {{0.0, 0.0, 0.0}, 1.0 - sixth * (r * r * r), 0.5 * (r * r), -r},
        {{0.0, 0.0, 0.0}, sixth * (1.0 + t * (3.0 + t * (3.0 - 2.0 * t))), 0.5 + t * (1.0 - t), 1.0 - 2.0 * t},
        {{0.0, 0.0, 0.0}, sixth * (t * t * t), 0.5 * (t * t), t},
    };
    for (int i = 0; i < 3; i++) {
        lane_f64_quat turn = lane_f64_quat_mul(lane_f64_quat_conjugate(control_of(s, i)), control_of(s, i + 1));
        factors[i].half = arc_to(turn, NKW_PATH_SHORT, 0, &sign);
    }
    return product_of(control_of(s, 0), factors, 3);
}

/* 2 d q^-1, a vector. */
static lane_f64_vec3 twice_over(lane_f64_quat d, lane_f64_quat q)
{
    lane_f64_quat p = lane_f64_quat_mul(d, lane_f64_quat_conjugate(q));
    lane_f64_vec3 v = {p.x + p.x, p.y + p.y, p.z + p.z};
    return v;
}

static motion squad_at(const nkw_rotation_segment *s, double t, double *sign)
{
    lane_f64_quat c[4] = {control_of(s, 0), control_of(s, 1), control_of(s, 2), control_of(s, 3)};
    lane_f64_quat end = c[3];
    c[3] = lane_f64_quat_aligned(c[0], c[3], NKW_PATH_SHORT);
    c[1] = lane_f64_quat_aligned(c[0], c[1], NKW_PATH_SHORT);
    c[2] = lane_f64_quat_aligned(c[3], c[2], NKW_PATH_SHORT);
    *sign = lane_f64_quat_dot(c[3], end) < 0.0 ? -1.0 : 1.0;
    rotation_jet j = nkwi_rotation_squad_at(c, t);
    motion m = {j.q, twice_over(j.d, j.q), twice_over(j.dd, j.q)};
    return m;
}

static motion motion_at(const nkw_rotation_segment *s, double t, double *sign)
{
    switch (s->kind) {
    case NKW_ROTATION_HERMITE:
        return hermite_at(s, t, sign);
    case NKW_ROTATION_SQUAD:
        return squad_at(s, t, sign);
    case NKW_ROTATION_BSPLINE:
        return bspline_at(s, t);
    case NKW_ROTATION_SLERP:
    default:
        return slerp_at(s, t, sign);
    }
}

nkw_quat_motion nkw_rotation_evaluate(const nkw_rotation_segment *segment, float t)
{
    double sign = 1.0, rate = segment->duration > 0.0f ? 1.0 / (double)segment->duration : 0.0;
    motion m = motion_at(segment, (double)t, &sign);
    int last = segment->kind == NKW_ROTATION_SQUAD ? 3 : 1, has_ends = segment->kind != NKW_ROTATION_BSPLINE;
    nkw_quat_motion r = {
        lane_quat_from_f64(m.q),
        lane_vec3_from_f64(lane_f64_vec3_scale(m.w, rate)),
        lane_vec3_from_f64(lane_f64_vec3_scale(m.a, rate * rate)),
    };
    if (has_ends && t == 0.0f)
        r.value = segment->control[0];
    if (has_ends && t == 1.0f)
        r.value = nkw_quat_scale(segment->control[last], (float)sign);
    return r;
}

/* ---- Segments from keys ---- */

static nkw_rotation_segment segment_of(nkw_rotation_kind kind, float duration)
{
    const nkw_quat none = {0.0f, 0.0f, 0.0f, 1.0f};
    nkw_rotation_segment s = {kind, NKW_PATH_SHORT, 0, duration, {none, none, none, none}, {{0, 0, 0}, {0, 0, 0}}};
    return s;
}

nkw_rotation_segment nkw_rotation_from_slerp(nkw_quat a, nkw_quat b, float duration, nkw_path path, int32_t turns)
{
    nkw_rotation_segment s = segment_of(NKW_ROTATION_SLERP, duration);
    s.path = path;
    s.turns = turns;
    s.control[0] = a;
    s.control[1] = b;
    return s;
}

nkw_rotation_segment nkw_rotation_from_hermite(nkw_quat a, nkw_vec3 va, nkw_quat b, nkw_vec3 vb, float duration)
{
    nkw_rotation_segment s = segment_of(NKW_ROTATION_HERMITE, duration);
    s.control[0] = a;
    s.control[1] = b;
    s.velocity[0] = va;
    s.velocity[1] = vb;
    return s;
}

/* The rotation vectors between four keys, and the durations; a chord without a duration is that of its neighbour. */
typedef struct chords {
    lane_f64_vec3 w[3]; /* per second */
    double h[3];
} chords;

static void borrow(chords *c, int to, int from)
{
    if (!(c->h[to] > 0.0)) {
        c->w[to] = c->w[from];
        c->h[to] = c->h[from];
    }
}

static chords chords_of(const nkw_quat keys[4], const float times[4])
{
    chords c;
    for (int i = 0; i < 3; i++) {
        lane_f64_quat a = lane_f64_quat_from(keys[i]), b = lane_f64_quat_from(keys[i + 1]);
        lane_f64_quat turn = lane_f64_quat_mul(lane_f64_quat_aligned(a, b, NKW_PATH_SHORT), lane_f64_quat_conjugate(a));
        c.h[i] = (double)times[i + 1] - (double)times[i];
        c.w[i] = lane_f64_vec3_scale(lane_f64_quat_log(turn), c.h[i] > 0.0 ? 2.0 / c.h[i] : 0.0);
    }
    borrow(&c, 0, 1);
    borrow(&c, 2, 1);
    return c;
}

/* k0 w[i] + k1 w[i + 1], over h[i] + h[i + 1]. */
static nkw_vec3 velocity_of(const chords *c, int i, double k0, double k1)
{
    double sum = c->h[i] + c->h[i + 1];
    lane_f64_vec3 v = lane_f64_vec3_add_scaled(lane_f64_vec3_scale(c->w[i], k0), c->w[i + 1], k1);
    return lane_vec3_from_f64(lane_f64_vec3_scale(v, sum > 0.0 ? 1.0 / sum : 0.0));
}

nkw_rotation_segment nkw_rotation_from_catmull_rom(const nkw_quat keys[4], const float times[4])
{
    chords c = chords_of(keys, times);
    nkw_vec3 va = velocity_of(&c, 0, c.h[1], c.h[0]), vb = velocity_of(&c, 1, c.h[2], c.h[1]);
    return nkw_rotation_from_hermite(keys[1], va, keys[2], vb, times[2] - times[1]);
}

nkw_rotation_segment nkw_rotation_from_tcb(const nkw_quat keys[4], const float times[4], const nkw_tcb tcb[2])
{
    chords c = chords_of(keys, times);
    double t0 = 1.0 - (double)tcb[0].tension, c0 = tcb[0].continuity, b0 = tcb[0].bias;
    double t1 = 1.0 - (double)tcb[1].tension, c1 = tcb[1].continuity, b1 = tcb[1].bias;
    nkw_vec3 va = velocity_of(&c, 0, t0 * ((1.0 + c0) * (1.0 + b0)) * c.h[0], t0 * ((1.0 - c0) * (1.0 - b0)) * c.h[1]);
    nkw_vec3 vb = velocity_of(&c, 1, t1 * ((1.0 - c1) * (1.0 + b1)) * c.h[1], t1 * ((1.0 + c1) * (1.0 - b1)) * c.h[2]);
    return nkw_rotation_from_hermite(keys[1], va, keys[2], vb, times[2] - times[1]);
}

/* The inner control value at `key`, see nkw_rotation_from_squad. */
static nkw_quat squad_control(nkw_quat before, nkw_quat key, nkw_quat after)
{
    lane_f64_quat k = lane_f64_quat_unit_from(key), back = lane_f64_quat_conjugate(k);
    double sign;
    lane_f64_vec3 on = arc_to(lane_f64_quat_mul(back, lane_f64_quat_from(after)), NKW_PATH_SHORT, 0, &sign);
    lane_f64_vec3 from = arc_to(lane_f64_quat_mul(back, lane_f64_quat_from(before)), NKW_PATH_SHORT, 0, &sign);
    lane_f64_vec3 bent = lane_f64_vec3_scale(lane_f64_vec3_add(on, from), -0.25);
    return lane_quat_from_f64(lane_f64_quat_mul(k, lane_f64_quat_exp(bent)));
}

nkw_rotation_segment nkw_rotation_from_squad(const nkw_quat keys[4], float duration)
{
    nkw_rotation_segment s = segment_of(NKW_ROTATION_SQUAD, duration);
    s.control[0] = keys[1];
    s.control[1] = squad_control(keys[0], keys[1], keys[2]);
    s.control[2] = squad_control(keys[1], keys[2], keys[3]);
    s.control[3] = keys[2];
    return s;
}

nkw_rotation_segment nkw_rotation_from_bspline(const nkw_quat controls[4], float duration)
{
    nkw_rotation_segment s = segment_of(NKW_ROTATION_BSPLINE, duration);
    for (int i = 0; i < 4; i++)
        s.control[i] = controls[i];
    return s;
}
