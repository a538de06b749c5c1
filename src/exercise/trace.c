/* SPDX-License-Identifier: MIT */
#include "trace.h"

#include <nakawari/mat.h>
#include <nakawari/orient.h>
#include <nakawari/quat.h>
#include <nakawari/scalar.h>

static const char *const position_names[] = {"linear (1)",          "Hermite (2)-(6)",     "Bezier (7)-(11)",
                                             "B-spline (12)-(16)", "Catmull-Rom", "step"};
static const char *const orientation_names[] = {"none: the segment's first key", "Euler angles Ry Rx Rz",
                                                "quaternions, slerp (17)-(18)", "Euler angles, all unwrapped",
                                                "quaternions, nlerp"};

static void number(FILE *f, const char *before, float x, const char *after)
{
    fprintf(f, "%s%.9g%s", before, (double)(x + 0.0f), after);
}

static void vector(FILE *f, const char *name, nkw_vec3 v)
{
    fprintf(f, "%s = (%.9g, %.9g, %.9g)", name, (double)(v.x + 0.0f), (double)(v.y + 0.0f), (double)(v.z + 0.0f));
}

static void quaternion(FILE *f, const char *name, nkw_quat q)
{
    fprintf(f, "  %s = (%.9g, %.9g, %.9g, %.9g)", name, (double)(q.x + 0.0f), (double)(q.y + 0.0f),
            (double)(q.z + 0.0f), (double)(q.w + 0.0f));
}

static void segment(FILE *f, const scene *s, float time, const nkw_keyframe_trace *t)
{
    const nkw_keyframe *a = &s->keys[t->segment.index], *b = a + 1;
    unsigned k = (unsigned)t->segment.index;
    fprintf(f, "segment %u, from key %u to key %u\n", k, k, k + 1);
    number(f, "  time = ", time, " s\n");
    fprintf(f, "  t = (time - %.9g) / (%.9g - %.9g) = %.9g, held within 0..1\n", (double)a->time, (double)b->time,
            (double)a->time, (double)t->segment.t);
}

static void parameter(FILE *f, nkw_position_method method, const nkw_keyframe_trace *t)
{
    if (t->control_count == 1)
        fputs("  one key is held\n", f);
    else if (method == NKW_POSITION_BEZIER)
        number(f, "  s = ", t->parameter, ", the share of the time from the first of these keys to the last\n");
    else
        number(f, "  t = ", t->parameter, "\n");
}

static void position_steps(FILE *f, nkw_position_method method, const nkw_keyframe_trace *t)
{
    static const char *const points[] = {"p0", "p1", "p2", "p3"}, *const hermite[] = {"p0", "v0", "p1", "v1"};
    fprintf(f, "position: %s\n", position_names[method]);
    parameter(f, method, t);
    for (size_t i = 0; i < t->control_count; i++) {
        fputs("  ", f);
        vector(f, method == NKW_POSITION_HERMITE ? hermite[i] : points[i], t->control[i]);
        fprintf(f, " of key %u", (unsigned)t->key[i]);
        number(f, ",  weight ", t->weight[i], "\n");
    }
    fputs("  ", f);
    vector(f, "p", t->position);
    fputs("\n", f);
}

static void euler_steps(FILE *f, const nkw_keyframe_trace *t)
{
    nkw_vec3 angles = nkw_euler_lerp(t->angles[0], t->angles[1], t->segment.t, NKW_UNWRAP_NONE);
    fputs("  angles about x (pitch), y (yaw), z (roll), radians\n  ", f);
    vector(f, "a0", t->angles[0]);
    number(f, ",  weight ", t->orientation_weight[0], "\n  ");
    vector(f, "a1", t->angles[1]);
    number(f, ",  weight ", t->orientation_weight[1], "\n  ");
    vector(f, "a", angles);
    fputs("\n", f);
}

/* The textbook's sum of the traced weights; the library's own slerp differs from it by rounding only. */
static void quaternion_steps(FILE *f, const scene *s, const nkw_keyframe_trace *t)
{
    nkw_quat key = s->keys[t->segment.index + 1].orientation, q1 = t->orientation[1];
    float given = nkw_quat_dot(t->orientation[0], key);
    quaternion(f, "q0", t->orientation[0]);
    number(f, ",  weight ", t->orientation_weight[0], "\n");
    quaternion(f, "q1", q1);
    number(f, ",  weight ", t->orientation_weight[1], "\n");
    number(f, "  q0 . q1 of the keys = ", given, given < 0.0f ? " < 0, so q1 is negated\n" : ", q1 stays\n");
    number(f, "  theta = acos(q0 . q1) = ", t->half_angle, "");
    number(f, " rad, the turn is 2 theta = ", nkw_degrees_from_radians(2.0f * t->half_angle), " degrees\n");
    quaternion(f, "q ", nkw_quat_add(nkw_quat_scale(t->orientation[0], t->orientation_weight[0]),
                                     nkw_quat_scale(q1, t->orientation_weight[1])));
    fputs("\n", f);
}

static void orientation_steps(FILE *f, const scene *s, nkw_orientation_method method, const nkw_keyframe_trace *t)
{
    fprintf(f, "orientation: %s\n", orientation_names[method]);
    if (method == NKW_ORIENTATION_EULER || method == NKW_ORIENTATION_EULER_UNWRAPPED)
        euler_steps(f, t);
    else if (method == NKW_ORIENTATION_SLERP || method == NKW_ORIENTATION_NLERP)
        quaternion_steps(f, s, t);
}

static void matrix(FILE *f, const nkw_mat4 *m)
{
    fputs("matrix (written by rows; stored by columns, m[column * 4 + row])\n", f);
    for (int r = 0; r < 4; r++) {
        for (int c = 0; c < 4; c++)
            fprintf(f, "  %13.9f", (double)(m->m[c * 4 + r] + 0.0f));
        fputs("\n", f);
    }
}

void trace_print(FILE *f, const scene *s, float time, nkw_position_method position,
                 nkw_orientation_method orientation)
{
    nkw_keyframe_options options = {position, orientation, s->rule};
    nkw_keyframe_trace t;
    nkw_mat4 m = scene_sample(s, time, position, orientation);
    if (nkw_keyframes_trace(s->keys, s->count, time, &options, &t) != NKW_OK)
        return;
    segment(f, s, time, &t);
    position_steps(f, position, &t);
    orientation_steps(f, s, orientation, &t);
    matrix(f, &m);
}
