/* SPDX-License-Identifier: MIT */
/* Squad with two derivatives: slerps of constant rotations, and the power of the rotation between them. */
#include "lane/arc.h"
#include "rotation_squad.h"

/* A number with its first two derivatives by t. */
typedef struct number_jet {
    double x, d, dd;
} number_jet;

/* f(y) with f, f', f'' known at y.x. */
static number_jet chained(number_jet y, double f, double f1, double f2)
{
    number_jet r = {f, f1 * y.d, f2 * (y.d * y.d) + f1 * y.dd};
    return r;
}

/* p q of two quaternion jets. */
static rotation_jet product(rotation_jet p, rotation_jet q)
{
    lane_f64_quat middle = lane_f64_quat_scale(lane_f64_quat_mul(p.d, q.d), 2.0);
    rotation_jet r = {
        lane_f64_quat_mul(p.q, q.q),
        lane_f64_quat_add(lane_f64_quat_mul(p.d, q.q), lane_f64_quat_mul(p.q, q.d)),
        lane_f64_quat_add(lane_f64_quat_add(lane_f64_quat_mul(p.dd, q.q), middle), lane_f64_quat_mul(p.q, q.dd)),
    };
    return r;
}

/* s q of a number and a quaternion. */
static rotation_jet scaled(rotation_jet q, number_jet s)
{
    lane_f64_quat middle = lane_f64_quat_scale(q.d, 2.0 * s.d);
    rotation_jet r = {
        lane_f64_quat_scale(q.q, s.x),
        lane_f64_quat_add(lane_f64_quat_scale(q.q, s.d), lane_f64_quat_scale(q.d, s.x)),
        lane_f64_quat_add(lane_f64_quat_add(lane_f64_quat_scale(q.q, s.dd), middle), lane_f64_quat_scale(q.dd, s.x)),
    };
    return r;
}

static rotation_jet conjugate(rotation_jet q)
{
    rotation_jet r = {lane_f64_quat_conjugate(q.q), lane_f64_quat_conjugate(q.d), lane_f64_quat_conjugate(q.dd)};
    return r;
}

static rotation_jet without_w(rotation_jet q)
{
    q.q.w = q.d.w = q.dd.w = 0.0;
    return q;
}

/* u cos(t h) + e sin(t h): the derivative is h times the point a quarter of the circle ahead. */
static rotation_jet slerp_jet(lane_f64_quat a, lane_f64_quat b, double t)
{
    lane_f64_arc arc = lane_f64_arc_between(a, b);
    lane_f64_quat q = lane_f64_arc_at(&arc, t * arc.h, 0.0, 0);
    lane_f64_quat ahead = lane_f64_arc_at(&arc, t * arc.h, 0.5, 0);
    rotation_jet r = {q, lane_f64_quat_scale(ahead, arc.h), lane_f64_quat_scale(q, -(arc.h * arc.h))};
    return r;
}

/*
 * g(w) = h / sin h, w = cos h, and its derivatives by w: (1 - w^2) g' = w g - 1, (1 - w^2) g'' = 3 w g' + g.
 *
 *     x = 1 - w <= 1/2:   g = 1 + x/3 + 2 x^2/15 + ...,      a(n+1) = a(n) (n + 1)/(2n + 3)
 */
typedef struct derivatives {
    double f, f1, f2;
} derivatives;

#define ANGLE_TERMS 30

static derivatives angle_over_sine(lane_f64_quat q)
{
    lane_f64_vec3 v = {q.x, q.y, q.z};
    double s2 = lane_f64_vec3_dot(v, v), least = 0x1p-40;
    derivatives r = {0.0, 0.0, 0.0};
    if (q.w < 0.5) {
        double bounded = s2 > least ? s2 : least, sine = lane_sqrt64(bounded);
        r.f = lane_atan2_64(sine, q.w) / sine;
        r.f1 = (q.w * r.f - 1.0) / bounded;
        r.f2 = (3.0 * q.w * r.f1 + r.f) / bounded;
        return r;
    }
    double x = s2 / (1.0 + q.w), a[ANGLE_TERMS] = {1.0};
    for (int n = 0; n + 1 < ANGLE_TERMS; n++)
        a[n + 1] = a[n] * (double)(n + 1) / (double)(2 * n + 3);
    for (int n = ANGLE_TERMS - 1; n >= 0; n--) {
        r.f2 = r.f2 * x + 2.0 * r.f1;
        r.f1 = r.f1 * x + r.f;
        r.f = r.f * x + a[n];
    }
    r.f1 = -r.f1; /* by w = 1 - x */
    return r;
}

/*
 * S(y) = sin sqrt(y) / sqrt(y) and its derivatives: 2 y S' = cos sqrt(y) - S, 4 y S'' = -S - 6 S'.
 *
 *     y < 1:   S = 1 - y/6 + y^2/120 - ...
 */
#define SINE_TERMS 11

static derivatives sine_over_angle(double y, lane_sincos turn, double angle)
{
    derivatives r = {0.0, 0.0, 0.0};
    if (y >= 1.0) {
        r.f = turn.s / angle;
        r.f1 = (turn.c - r.f) / (2.0 * y);
        r.f2 = -(r.f + 6.0 * r.f1) / (4.0 * y);
        return r;
    }
    double a[SINE_TERMS] = {1.0};
    for (int n = 0; n + 1 < SINE_TERMS; n++)
        a[n + 1] = -a[n] / (double)((2 * n + 2) * (2 * n + 3));
    for (int n = SINE_TERMS - 1; n >= 0; n--) {
        r.f2 = r.f2 * y + 2.0 * r.f1;
        r.f1 = r.f1 * y + r.f;
        r.f = r.f * y + a[n];
    }
    return r;
}

/* exp of x, whose w is 0: (x S(y), cos sqrt(y)), y = x.x; cos' = -S/2. */
static rotation_jet exp_jet(rotation_jet x)
{
    double dot1 = lane_f64_quat_dot(x.q, x.d), dot2 = lane_f64_quat_dot(x.d, x.d) + lane_f64_quat_dot(x.q, x.dd);
    number_jet y = {lane_f64_quat_dot(x.q, x.q), 2.0 * dot1, 2.0 * dot2};
    double angle = lane_sqrt64(y.x);
    lane_sincos turn = lane_turn64(angle);
    derivatives s = sine_over_angle(y.x, turn, angle);
    rotation_jet r = scaled(x, chained(y, s.f, s.f1, s.f2));
    number_jet w = chained(y, turn.c, -0.5 * s.f, -0.5 * s.f1);
    r.q.w = w.x, r.d.w = w.d, r.dd.w = w.dd;
    return r;
}

/* exp(s log q). */
static rotation_jet power(rotation_jet q, number_jet s)
{
    derivatives g = angle_over_sine(q.q);
    number_jet w = {q.q.w, q.d.w, q.dd.w};
    rotation_jet log = scaled(without_w(q), chained(w, g.f, g.f1, g.f2));
    return exp_jet(scaled(log, s));
}

rotation_jet nkwi_rotation_squad_at(const lane_f64_quat c[4], double t)
{
    rotation_jet outer = slerp_jet(c[0], c[3], t), inner = slerp_jet(c[1], c[2], t);
    number_jet s = {2.0 * t * (1.0 - t), 2.0 - 4.0 * t, -4.0};
    return product(outer, power(product(conjugate(outer), inner), s));
}
