/* SPDX-License-Identifier: CC0-1.0 */
/* The adapter of nakawari: each group is one call or two. */
#include <string.h>

#include <nakawari/nakawari.h>

#include "adapter.h"

typedef vectors_value value;

/* ---- Between the values of a case and the types ---- */

/* The curve of four keys at any times. */
static nkw_motion cubic_bezier_of(float x1, float y1, float x2, float y2, float t)
{
    const nkw_easing e = {NKW_EASING_CUBIC_BEZIER, {x1, y1, x2, y2}, NKW_EASE_JUMP_END, 0, NULL, NULL};
    return nkw_easing_evaluate(&e, t);
}

static float steps_of(size_t count, nkw_ease_jump jump, float t)
{
    const nkw_easing e = {NKW_EASING_STEPS, {0, 0, 0, 0}, jump, count, NULL, NULL};
    const nkw_motion p = nkw_easing_evaluate(&e, t);
    return p.value;
}

static float uneven(const float times[4], float p0, float p1, float p2, float p3, float t)
{
    const float keys[4] = {p0, p1, p2, p3};
    float c[4];
    nkw_cubic_from_catmull_rom(keys, times, c);
    return nkw_hermite(c[0], c[1], c[2], c[3], t);
}

static float number(const value *v)
{
    return (float)v->x[0];
}

static nkw_vec3 vec3(const value *v)
{
    nkw_vec3 r = {(float)v->x[0], (float)v->x[1], (float)v->x[2]};
    return r;
}

static nkw_quat quat_from(const double *x)
{
    nkw_quat r = {(float)x[0], (float)x[1], (float)x[2], (float)x[3]};
    return r;
}

static nkw_quat quat(const value *v)
{
    return quat_from(v->x);
}

static void floats(const value *v, float *out)
{
    for (int i = 0; i < v->count; i++)
        out[i] = (float)v->x[i];
}

static void put(value *out, const float *x, int count)
{
    out->count = count;
    for (int i = 0; i < count; i++)
        out->x[i] = (double)x[i];
}

static void put_number(value *out, float x)
{
    put(out, &x, 1);
}

static void put_vec3(value *out, nkw_vec3 v)
{
    put(out, &v.x, 3);
}

static void put_quat(value *out, nkw_quat q)
{
    put(out, &q.x, 4);
}

static nkw_trs trs_from(const double *x)
{
    nkw_trs r = {{(float)x[0], (float)x[1], (float)x[2]}, quat_from(x + 3), {(float)x[7], (float)x[8], (float)x[9]}};
    return r;
}

/* ---- curves ---- */

typedef float cubic(float c0, float c1, float c2, float c3, float t);

static void cubic_of(cubic *f, const value *in, value *out)
{
    put_number(out, f(number(in), number(in + 1), number(in + 2), number(in + 3), number(in + 4)));
}

static void hermite(const value *in, value *out)
{
    cubic_of(nkw_hermite, in, out);
}

static void bezier(const value *in, value *out)
{
    cubic_of(nkw_bezier, in, out);
}

static void bspline(const value *in, value *out)
{
    cubic_of(nkw_bspline, in, out);
}

static void catmull_rom(const value *in, value *out)
{
    cubic_of(nkw_catmull_rom, in, out);
}

static void gltf_cubicspline(const value *in, value *out)
{
    float times[2], x, out0 = number(in + 2), in1 = number(in + 3);
    const float values[6] = {0.0f, number(in + 1), out0, in1, number(in + 4), 0.0f};
    floats(in, times);
    nkw_track track = {times, values, 2, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_CUBICSPLINE, NULL};
    nkw_track_sample(&track, number(in + 5), NULL, &x);
    put_number(out, x);
}

static void catmull_rom_times(const value *in, value *out)
{
    float times[4], p[4];
    floats(in, times);
    floats(in + 1, p);
    put_number(out, uneven(times, p[0], p[1], p[2], p[3], number(in + 2)));
}

static void tcb_tangents(const value *in, value *out)
{
    float times[3], values[3], before[3], after[3];
    nkw_tcb tcb[3] = {{0, 0, 0}, {(float)in[2].x[0], (float)in[2].x[1], (float)in[2].x[2]}, {0, 0, 0}};
    floats(in, times);
    floats(in + 1, values);
    nkw_spline spline = {times, values, 3, 1, 1, NKW_SPLINE_TCB, NKW_SPLINE_ENDS_FREE, 0, tcb, NULL};
    nkw_tangent_span tangents = {before, after, 1};
    nkw_spline_tangents(&spline, tangents, NULL, (nkw_work){NULL, 0});
    put_number(out, before[1]);
    put_number(out + 1, after[1]);
}

static void cubic_bezier(const value *in, value *out)
{
    nkw_motion p = cubic_bezier_of(number(in), number(in + 1), number(in + 2), number(in + 3), number(in + 4));
    put_number(out, p.value);
}

/* ---- rotations ---- */

static void quat_mul(const value *in, value *out)
{
    put_quat(out, nkw_quat_mul(quat(in), quat(in + 1)));
}

static void quat_rotate(const value *in, value *out)
{
    put_vec3(out, nkw_quat_rotate(quat(in), vec3(in + 1)));
}

static void mat3_from_quat(const value *in, value *out)
{
    nkw_mat3 m = nkw_mat3_from_quat(quat(in));
    put(out, m.m, 9);
}

static void quat_from_mat3(const value *in, value *out)
{
    nkw_mat3 m;
    floats(in, m.m);
    put_quat(out, nkw_quat_from_mat3(&m));
}

static void quat_from_axis_angle(const value *in, value *out)
{
    put_quat(out, nkw_quat_from_axis_angle(vec3(in), number(in + 1)));
}

static void swing_twist(const value *in, value *out)
{
    nkw_swing_twist s = nkw_quat_swing_twist(quat(in), vec3(in + 1));
    put_quat(out, s.swing);
    put_quat(out + 1, s.twist);
}

static void quat_mean(const value *in, value *out)
{
    nkw_quat q[16];
    float weights[16];
    floats(in + 1, weights);
    for (int i = 0; i < in[1].count; i++)
        q[i] = quat_from(in[0].x + 4 * i);
    put_quat(out, nkw_quat_mean(q, (size_t)in[1].count, weights));
}

/* ---- paths and splines of rotations ---- */

static void slerp(const value *in, value *out)
{
    put_quat(out, nkw_quat_slerp(quat(in), quat(in + 1), number(in + 2)));
}

static void nlerp(const value *in, value *out)
{
    put_quat(out, nkw_quat_nlerp(quat(in), quat(in + 1), number(in + 2)));
}

static void slerp_path(const value *in, value *out)
{
    nkw_path path = (nkw_path)(int)in[3].x[0];
    put_quat(out, nkw_quat_slerp_path(quat(in), quat(in + 1), number(in + 2), path, (int32_t)in[4].x[0]));
}

static void nlerp_path(const value *in, value *out)
{
    nkw_path path = (nkw_path)(int)in[3].x[0];
    put_quat(out, nkw_quat_nlerp_path(quat(in), quat(in + 1), number(in + 2), path, (int32_t)in[4].x[0]));
}

static void angular_velocity(const value *in, value *out)
{
    put_vec3(out, nkw_quat_angular_velocity(quat(in), quat(in + 1), number(in + 2)));
}

static void put_state(value *out, const nkw_rotation_segment *s, float t)
{
    nkw_quat_motion at = nkw_rotation_evaluate(s, t);
    put_quat(out, at.value);
    put_vec3(out + 1, at.velocity);
    put_vec3(out + 2, at.acceleration);
}

static void squad(const value *in, value *out)
{
    const nkw_quat keys[4] = {quat(in), quat(in + 1), quat(in + 2), quat(in + 3)};
    nkw_rotation_segment s = nkw_rotation_from_squad(keys, number(in + 4));
    put_state(out, &s, number(in + 5));
}

static void rotation_bspline(const value *in, value *out)
{
    const nkw_quat keys[4] = {quat(in), quat(in + 1), quat(in + 2), quat(in + 3)};
    nkw_rotation_segment s = nkw_rotation_from_bspline(keys, number(in + 4));
    put_state(out, &s, number(in + 5));
}

static void rotation_hermite(const value *in, value *out)
{
    nkw_rotation_segment s =
        nkw_rotation_from_hermite(quat(in), vec3(in + 1), quat(in + 2), vec3(in + 3), number(in + 4));
    put_state(out, &s, number(in + 5));
}

/* From the keys and times of `in`; its last value is t. */
static void keyed(const value *in, value *out, int has_tcb)
{
    const nkw_quat keys[4] = {quat(in), quat(in + 1), quat(in + 2), quat(in + 3)};
    float times[4], t[6] = {0};
    floats(in + 4, times);
    floats(in + 5, t);
    const nkw_tcb tcb[2] = {{t[0], t[1], t[2]}, {t[3], t[4], t[5]}};
    nkw_rotation_segment s =
        has_tcb ? nkw_rotation_from_tcb(keys, times, tcb) : nkw_rotation_from_catmull_rom(keys, times);
    put_state(out, &s, number(in + 5 + has_tcb));
}

static void rotation_catmull_rom(const value *in, value *out)
{
    keyed(in, out, 0);
}

static void rotation_tcb(const value *in, value *out)
{
    keyed(in, out, 1);
}

/* ---- euler ---- */

static void quat_from_euler(const value *in, value *out)
{
    put_quat(out, nkw_quat_from_euler(vec3(in), (nkw_euler_order)(int)in[1].x[0]));
}

static void mat3_from_euler(const value *in, value *out)
{
    nkw_mat3 m = nkw_mat3_from_euler(vec3(in), (nkw_euler_order)(int)in[1].x[0]);
    put(out, m.m, 9);
}

static void euler_from_quat(const value *in, value *out)
{
    put_vec3(out, nkw_euler_from_quat(quat(in), (nkw_euler_order)(int)in[1].x[0]));
}

static void euler_nearest(const value *in, value *out)
{
    put_vec3(out, nkw_euler_nearest(vec3(in), vec3(in + 1), (nkw_euler_order)(int)in[2].x[0]));
}

/* ---- time and events ---- */

static void play_head(const value *in, value *out)
{
    nkw_play_head head =
        nkw_playback_head((nkw_playback)(int)in[0].x[0], number(in + 1), number(in + 2), number(in + 3));
    put_number(out, head.time);
    put_number(out + 1, head.cycle);
}

static void segment(const value *in, value *out)
{
    float times[VECTORS_NUMBERS];
    floats(in, times);
    nkw_segment s = nkw_segment_find(times, (size_t)in[0].count, number(in + 1));
    put_number(out, (float)s.index);
    put_number(out + 1, s.t);
}

static void events_passed(const value *in, value *out)
{
    float times[VECTORS_NUMBERS];
    size_t keys[VECTORS_NUMBERS], passed;
    floats(in, times);
    nkw_playback_step step = {times, (size_t)in[0].count, number(in + 1), number(in + 2), number(in + 3), 0};
    nkw_playback_passed(&step, keys, VECTORS_NUMBERS, &passed);
    put_number(out, (float)passed);
    out[1].count = (int)passed;
    for (size_t i = 0; i < passed; i++)
        out[1].x[i] = (double)keys[i];
}

/* ---- poses and palettes ---- */

static void trs_matrix(const value *in, value *out)
{
    nkw_trs trs = {vec3(in), quat(in + 1), vec3(in + 2)};
    nkw_mat4 m = nkw_mat4_from_trs(&trs);
    put(out, m.m, 16);
}

enum { JOINTS = 3 };

static void pose_blend(const value *in, value *out)
{
    float a[NKW_POSE_FLOATS(1)], b[NKW_POSE_FLOATS(1)];
    nkw_pose_span to_a = {a, 1}, to_b = {b, 1};
    nkw_pose_view from_a = {a, 1}, from_b = {b, 1};
    nkw_trs first = trs_from(in[0].x), second = trs_from(in[1].x);
    nkw_mask_view none = {NULL, 0};
    nkw_pose_from_trs(&first, to_a);
    nkw_pose_from_trs(&second, to_b);
    nkw_pose_blend(from_a, from_b, number(in + 2), none, to_a);
    nkw_trs r = nkw_pose_get(from_a, 0);
    put_vec3(out, r.translation);
    put_quat(out + 1, r.rotation);
    put_vec3(out + 2, r.scale);
}

static void models(const value *in, value *out)
{
    float pose[NKW_POSE_FLOATS(JOINTS)];
    int32_t parents[JOINTS];
    nkw_mat4 m[JOINTS];
    nkw_pose_span to = {pose, JOINTS};
    nkw_pose_view from = {pose, JOINTS};
    for (int j = 0; j < JOINTS; j++) {
        nkw_trs local = trs_from(in[1].x + 10 * j);
        nkw_pose_set(to, (size_t)j, &local);
        parents[j] = (int32_t)in[0].x[j];
    }
    nkw_skeleton skeleton = {parents, JOINTS};
    nkw_skeleton_models_from_pose(&skeleton, from, NULL, NULL, m);
    put(out, m[0].m, 16 * JOINTS);
}

static void palette(const value *in, value *out)
{
    nkw_mat4 m[JOINTS], inverse_bind[JOINTS], matrices[JOINTS];
    size_t count = (size_t)in[0].count / 16;
    floats(in, m[0].m);
    floats(in + 1, inverse_bind[0].m);
    nkw_palette_source source = {m, count, NULL, inverse_bind, NULL, count};
    nkw_palette_span to = {matrices, count, NKW_PALETTE_MAT4};
    nkw_palette_from_models(&source, to);
    put(out, matrices[0].m, (int)(16 * count));
}

/* ---- skinning: the vertex is `in`: weights, position, normal ---- */

static void skin(const nkw_palette_view *matrices, const value *in, value *out)
{
    static const uint16_t joints[4] = {0, 1, 2, 3};
    float weights[4], vectors[6], results[6];
    floats(in, weights);
    floats(in + 1, vectors);
    floats(in + 2, vectors + 3);
    nkw_skin s = {1, (size_t)in[0].count, {joints, 0, NKW_SKIN_U16}, {weights, 0, NKW_SKIN_F32}};
    nkw_vertices_view from = {{vectors, 0}, {vectors + 3, 0}, {NULL, 0}, {NULL, 0}};
    nkw_vertices_span to = {{results, 0}, {results + 3, 0}, {NULL, 0}, {NULL, 0}};
    nkw_skin_palette linear = {*matrices, {NULL, 0, NKW_PALETTE_NORMAL_MAT3}, {0, 0, 0}};
    if (matrices->format == NKW_PALETTE_DUAL_QUAT)
        nkw_skin_dual_quat(&s, *matrices, from, to);
    else
        nkw_skin_linear(&s, &linear, from, to);
    put(out, results, 3);
    put(out + 1, results + 3, 3);
}

static void skin_linear(const value *in, value *out)
{
    nkw_mat4 m[4];
    floats(in, m[0].m);
    nkw_palette_view matrices = {m, (size_t)in[1].count, NKW_PALETTE_MAT4};
    skin(&matrices, in + 1, out);
}

static void skin_dual_quat(const value *in, value *out)
{
    nkw_dual_quat d[4];
    for (int j = 0; j < in[2].count; j++) {
        const double *t = in[1].x + 3 * j;
        nkw_vec3 translation = {(float)t[0], (float)t[1], (float)t[2]};
        d[j] = nkw_dual_quat_from_rigid(quat_from(in[0].x + 4 * j), translation);
    }
    nkw_palette_view joints = {d, (size_t)in[2].count, NKW_PALETTE_DUAL_QUAT};
    skin(&joints, in + 2, out);
}

/* ---- motion ---- */

static void spring(const value *in, value *out)
{
    nkw_spring s = {number(in), number(in + 1)};
    nkw_state from = {number(in + 2), number(in + 3)}, goal = {number(in + 4), 0.0f};
    nkw_state r = nkw_spring_step(s, from, goal, number(in + 5));
    put_number(out, r.value);
    put_number(out + 1, r.velocity);
}

static void damper(const value *in, value *out)
{
    put_number(out, nkw_damper_step(number(in), number(in + 1), number(in + 2), number(in + 3)));
}

/* ---- tracks ---- */

static void rotation_track(const float *values, nkw_interpolation interpolation, const value *times, float time,
                           value *out)
{
    float t[2], q[4];
    floats(times, t);
    nkw_track track = {t, values, 2, 4, NKW_TRACK_ROTATION, interpolation, NULL};
    nkw_track_sample(&track, time, NULL, q);
    put(out, q, 4);
}

static void gltf_rotation_linear(const value *in, value *out)
{
    float values[8];
    floats(in + 1, values);
    floats(in + 2, values + 4);
    rotation_track(values, NKW_INTERPOLATION_LINEAR, in, number(in + 3), out);
}

static void gltf_rotation_cubicspline(const value *in, value *out)
{
    float values[24] = {0};
    for (int i = 0; i < 4; i++)
        floats(in + 1 + i, values + 4 + 4 * i);
    rotation_track(values, NKW_INTERPOLATION_CUBICSPLINE, in, number(in + 5), out);
}

static void handles(const value *in, value *out)
{
    float t[4], v[4];
    floats(in, t);
    floats(in + 1, v);
    nkw_handle_segment s = {t[0], v[0], {t[1] - t[0], v[1] - v[0]}, {t[2] - t[3], v[2] - v[3]}, t[3], v[3]};
    put_number(out, nkw_handle_sample(&s, number(in + 2)).value);
}

static void tangents(nkw_spline_method method, const value *in, value *out)
{
    float times[VECTORS_NUMBERS], values[VECTORS_NUMBERS], v[VECTORS_NUMBERS], after[VECTORS_NUMBERS];
    NKW_STACK_WORK(work, NKW_SPLINE_WORK(VECTORS_NUMBERS));
    size_t count = (size_t)in[0].count;
    floats(in, times);
    floats(in + 1, values);
    nkw_spline spline = {times, values, count, 1, 1, method, NKW_SPLINE_ENDS_FREE, 0.0f, NULL, NULL};
    nkw_tangent_span span = {v, after, 1};
    nkw_spline_tangents(&spline, span, NULL, work);
    put(out, v, (int)count);
}

static void pchip(const value *in, value *out)
{
    tangents(NKW_SPLINE_PCHIP, in, out);
}

static void akima(const value *in, value *out)
{
    tangents(NKW_SPLINE_AKIMA, in, out);
}

static void natural(const value *in, value *out)
{
    tangents(NKW_SPLINE_C2, in, out);
}

/* ---- easing ---- */

static void ease(const value *in, value *out)
{
    nkw_ease_kind kind = (nkw_ease_kind)(NKW_EASE_SINE_IN + 3 * (int)in[0].x[0] + (int)in[1].x[0]);
    put_number(out, nkw_ease_evaluate(kind, number(in + 2)).value);
}

static void steps(const value *in, value *out)
{
    put_number(out, steps_of((size_t)in[0].x[0], (nkw_ease_jump)(int)in[1].x[0], number(in + 2)));
}

#define A(name)                                                                                                        \
    {                                                                                                                  \
#name, name                                                                                                    \
    }

static const struct {
    const char *name;
    void (*answer)(const value *in, value *out);
} answers[] = {
    A(hermite),
    A(bezier),
    A(bspline),
    A(catmull_rom),
    A(gltf_cubicspline),
    A(catmull_rom_times),
    A(tcb_tangents),
    A(cubic_bezier),
    A(quat_mul),
    A(quat_rotate),
    A(mat3_from_quat),
    A(quat_from_mat3),
    A(quat_from_axis_angle),
    A(swing_twist),
    A(quat_mean),
    A(slerp),
    A(nlerp),
    A(slerp_path),
    A(nlerp_path),
    A(angular_velocity),
    A(squad),
    A(rotation_bspline),
    A(rotation_hermite),
    A(quat_from_euler),
    A(mat3_from_euler),
    A(euler_from_quat),
    A(euler_nearest),
    A(play_head),
    A(segment),
    A(events_passed),
    A(trs_matrix),
    A(pose_blend),
    A(models),
    A(palette),
    A(skin_linear),
    A(skin_dual_quat),
    A(spring),
    A(damper),
    A(gltf_rotation_linear),
    A(gltf_rotation_cubicspline),
    A(handles),
    A(pchip),
    A(akima),
    A(natural),
    A(ease),
    A(steps),
    A(rotation_catmull_rom),
    A(rotation_tcb),
};

int vectors_answer(const char *group, const vectors_value *in, vectors_value *out)
{
    for (size_t i = 0; i < sizeof answers / sizeof answers[0]; i++)
        if (strcmp(answers[i].name, group) == 0) {
            answers[i].answer(in, out);
            return 1;
        }
    return 0;
}
