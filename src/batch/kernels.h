/* SPDX-License-Identifier: MIT */
/*
 * Every batch function: KERNEL_LIST(X) calls X(name, parameters, arguments) for each nkw_<name>_n of the headers.
 *
 * From one line here come the declaration of the loop, its place in the table of each instruction set, and the
 * public function that goes through the table. To add one, see docs/simd.md.
 *
 * KERNEL_INNER_LIST(X) has the loops that no header offers by themselves: parts of larger functions, which take them
 * from nkw_batch_selected(). No public function is made of these.
 */
#ifndef NAKAWARI_BATCH_KERNELS_H
#define NAKAWARI_BATCH_KERNELS_H

#include <stdint.h>

#include <nakawari/euler.h>
#include <nakawari/types.h>

#include "batch/block.h"
#include "batch/rows.h"
#include "lane/skin.h"

/* clang-format off */
/* The four of a curve: on numbers and on vectors, each at many t and at one. */
#define CURVE_LINES(X, name, name_at, vec3_name, vec3_name_at)                                                         \
    X(name,                                                                                                            \
      (const float *a, const float *b, const float *c, const float *d, const float *t, float *out, size_t n),          \
      (a, b, c, d, t, out, n))                                                                                         \
    X(name_at, (const float *a, const float *b, const float *c, const float *d, float t, float *out, size_t n),        \
      (a, b, c, d, t, out, n))                                                                                         \
    X(vec3_name,                                                                                                       \
      (nkw_vec3_view a, nkw_vec3_view b, nkw_vec3_view c, nkw_vec3_view d, const float *t, nkw_vec3_span out,          \
       size_t n),                                                                                                      \
      (a, b, c, d, t, out, n))                                                                                         \
    X(vec3_name_at,                                                                                                    \
      (nkw_vec3_view a, nkw_vec3_view b, nkw_vec3_view c, nkw_vec3_view d, float t, nkw_vec3_span out, size_t n),      \
      (a, b, c, d, t, out, n))

#define KERNEL_LIST(X) \
    X(sqrt, (const float *x, float *out, size_t n), (x, out, n)) \
    X(sin, (const float *angle, float *out, size_t n), (angle, out, n)) \
    X(cos, (const float *angle, float *out, size_t n), (angle, out, n)) \
    X(sincos, (const float *angle, float *sine, float *cosine, size_t n), (angle, sine, cosine, n)) \
    X(tan, (const float *angle, float *out, size_t n), (angle, out, n)) \
    X(asin, (const float *x, float *out, size_t n), (x, out, n)) \
    X(acos, (const float *x, float *out, size_t n), (x, out, n)) \
    X(atan, (const float *x, float *out, size_t n), (x, out, n)) \
    X(atan2, (const float *y, const float *x, float *out, size_t n), (y, x, out, n)) \
    X(exp, (const float *x, float *out, size_t n), (x, out, n)) \
    X(log, (const float *x, float *out, size_t n), (x, out, n)) \
    X(pow, (const float *x, const float *y, float *out, size_t n), (x, y, out, n)) \
    X(wrap_angle, (const float *angle, float *out, size_t n), (angle, out, n)) \
    X(lerp, (const float *a, const float *b, const float *t, float *out, size_t n), (a, b, t, out, n)) \
    X(lerp_at, (const float *a, const float *b, float t, float *out, size_t n), (a, b, t, out, n)) \
    X(vec3_add, (nkw_vec3_view a, nkw_vec3_view b, nkw_vec3_span out, size_t n), (a, b, out, n)) \
    X(vec3_sub, (nkw_vec3_view a, nkw_vec3_view b, nkw_vec3_span out, size_t n), (a, b, out, n)) \
    X(vec3_mul, (nkw_vec3_view a, nkw_vec3_view b, nkw_vec3_span out, size_t n), (a, b, out, n)) \
    X(vec3_scale, (nkw_vec3_view a, const float *s, nkw_vec3_span out, size_t n), (a, s, out, n)) \
    X(vec3_add_scaled, (nkw_vec3_view a, nkw_vec3_view b, const float *s, nkw_vec3_span out, size_t n), (a, b, s, out, n)) \
    X(vec3_dot, (nkw_vec3_view a, nkw_vec3_view b, float *out, size_t n), (a, b, out, n)) \
    X(vec3_cross, (nkw_vec3_view a, nkw_vec3_view b, nkw_vec3_span out, size_t n), (a, b, out, n)) \
    X(vec3_length, (nkw_vec3_view a, float *out, size_t n), (a, out, n)) \
    X(vec3_normalize, (nkw_vec3_view a, nkw_vec3_span out, size_t n), (a, out, n)) \
    X(vec3_lerp, (nkw_vec3_view a, nkw_vec3_view b, const float *t, nkw_vec3_span out, size_t n), (a, b, t, out, n)) \
    X(vec3_lerp_at, (nkw_vec3_view a, nkw_vec3_view b, float t, nkw_vec3_span out, size_t n), (a, b, t, out, n)) \
    X(vec3_unpack, (const nkw_vec3 *in, nkw_vec3_span out, size_t n), (in, out, n)) \
    X(vec3_pack, (nkw_vec3_view in, nkw_vec3 *out, size_t n), (in, out, n)) \
    X(quat_mul, (nkw_quat_view a, nkw_quat_view b, nkw_quat_span out, size_t n), (a, b, out, n)) \
    X(quat_conjugate, (nkw_quat_view q, nkw_quat_span out, size_t n), (q, out, n)) \
    X(quat_dot, (nkw_quat_view a, nkw_quat_view b, float *out, size_t n), (a, b, out, n)) \
    X(quat_normalize, (nkw_quat_view q, nkw_quat_span out, size_t n), (q, out, n)) \
    X(quat_rotate, (nkw_quat_view q, nkw_vec3_view v, nkw_vec3_span out, size_t n), (q, v, out, n)) \
    X(quat_from_mat3, (nkw_mat3_view m, nkw_quat_span out, size_t n), (m, out, n)) \
    X(quat_unpack, (const nkw_quat *in, nkw_quat_span out, size_t n), (in, out, n)) \
    X(quat_pack, (nkw_quat_view in, nkw_quat *out, size_t n), (in, out, n)) \
    X(mat3_from_quat, (nkw_quat_view q, nkw_mat3_span out, size_t n), (q, out, n)) \
    X(mat4_mul_affine, (nkw_mat4_view a, nkw_mat4_view b, nkw_mat4_span out, size_t n), (a, b, out, n)) \
    X(mat4_transform_point, (const nkw_mat4 *m, nkw_vec3_view p, nkw_vec3_span out, size_t n), (m, p, out, n)) \
    X(mat4_transform_direction, (const nkw_mat4 *m, nkw_vec3_view d, nkw_vec3_span out, size_t n), (m, d, out, n)) \
    X(mat4_unpack, (const nkw_mat4 *in, nkw_mat4_span out, size_t n), (in, out, n)) \
    X(mat4_pack, (nkw_mat4_view in, nkw_mat4 *out, size_t n), (in, out, n)) \
    X(quat_from_euler, (nkw_vec3_view angles, nkw_euler_order order, nkw_quat_span out, size_t n), (angles, order, out, n)) \
    X(mat4_from_trs, (nkw_trs_view trs, nkw_mat4_span out, size_t n), (trs, out, n)) \
    CURVE_LINES(X, hermite, hermite_at, vec3_hermite, vec3_hermite_at) \
    CURVE_LINES(X, bezier, bezier_at, vec3_bezier, vec3_bezier_at) \
    CURVE_LINES(X, bspline, bspline_at, vec3_bspline, vec3_bspline_at) \
    CURVE_LINES(X, catmull_rom, catmull_rom_at, vec3_catmull_rom, vec3_catmull_rom_at) \
    X(quat_nlerp, (nkw_quat_view a, nkw_quat_view b, const float *t, nkw_quat_span out, size_t n), (a, b, t, out, n)) \
    X(quat_nlerp_at, (nkw_quat_view a, nkw_quat_view b, float t, nkw_quat_span out, size_t n), (a, b, t, out, n)) \
    X(quat_slerp, (nkw_quat_view a, nkw_quat_view b, const float *t, nkw_quat_span out, size_t n), (a, b, t, out, n)) \
    X(quat_slerp_at, (nkw_quat_view a, nkw_quat_view b, float t, nkw_quat_span out, size_t n), (a, b, t, out, n)) \
    X(quat_log, (nkw_quat_view q, nkw_vec3_span out, size_t n), (q, out, n)) \
    X(quat_exp, (nkw_vec3_view v, nkw_quat_span out, size_t n), (v, out, n))

#define KERNEL_INNER_LIST(X) \
    X(clip_arcs, (float *a, const float *b, const nkw_block *blocks, size_t block_count), (a, b, blocks, block_count)) \
    X(clip_lerp, (const float *a, const float *b, float t, const nkw_block *blocks, size_t block_count, float *out), (a, b, t, blocks, block_count, out)) \
    X(clip_slerp, (const float *a, const float *b, float t, const nkw_block *blocks, size_t block_count, float *out, size_t stride), (a, b, t, blocks, block_count, out, stride)) \
    X(clip_hermite, (const float *a, const float *b, size_t words, float duration, float t, const nkw_block *blocks, size_t block_count, float *out), (a, b, words, duration, t, blocks, block_count, out)) \
    X(clip_quat_hermite, (const float *a, const float *b, size_t words, float duration, float t, const nkw_block *blocks, size_t block_count, float *out, size_t stride), (a, b, words, duration, t, blocks, block_count, out, stride)) \
    X(clip_lerp16, (const uint16_t *a, const uint16_t *b, const float *base, const float *step, float t, const nkw_block *blocks, size_t block_count, float *out), (a, b, base, step, t, blocks, block_count, out)) \
    X(clip_slerp16, (const uint16_t *a, const uint16_t *b, const float *base, const float *step, float t, const nkw_block *blocks, size_t block_count, float *out, size_t stride), (a, b, base, step, t, blocks, block_count, out, stride)) \
    X(clip_hold, (const float *key, const nkw_block *blocks, size_t block_count, float *out), (key, blocks, block_count, out)) \
    X(clip_quat_hold, (const float *key, size_t rows, int normalized, const nkw_block *blocks, size_t block_count, float *out, size_t stride), (key, rows, normalized, blocks, block_count, out, stride)) \
    X(blend_chord, (blend_rows a, blend_rows b, float t, blend_span out, int n), (a, b, t, out, n)) \
    X(blend_poses, (const float *a, const float *b, size_t stride, float t, int used, float *out), (a, b, stride, t, used, out)) \
    X(blend_nlerp, (blend_rows a, blend_rows b, float t, int used, blend_span out), (a, b, t, used, out)) \
    X(blend_settle, (nkw_quat_view v, const float *mixed, int used, nkw_quat_span out, int n), (v, mixed, used, out, n)) \
    X(blend_weigh, (float weight, const float *mask, int used, float *out, int n), (weight, mask, used, out, n)) \
    X(blend_each, (blend_rows a, blend_rows b, const float *t, int used, blend_span out, int n), (a, b, t, used, out, n)) \
    X(blend_mix, (blend_rows to, const float *t, blend_span sum, int n), (to, t, sum, n)) \
    X(blend_missing, (const double *total, float threshold, int used, float *out, int n), (total, threshold, used, out, n)) \
    X(blend_share, (const float *weight, double *total, float *mixed, float *t, size_t n), (weight, total, mixed, t, n)) \
    X(additive_build, (nkw_trs_view a, nkw_trs_view ref, int parent, nkw_trs_span out, size_t n), (a, ref, parent, out, n)) \
    X(additive_apply, (nkw_trs_view base, nkw_trs_view delta, const float *weight, int parent, nkw_trs_span out, size_t n), (base, delta, weight, parent, out, n)) \
    X(palette_4x4, (const nkw_mat4 *models, size_t model_count, const int32_t *joints, const nkw_mat4 *inverse_bind, const nkw_mat4 *global_inverse, nkw_mat4 *out, size_t n), (models, model_count, joints, inverse_bind, global_inverse, out, n)) \
    X(palette_3x4, (const nkw_mat4 *models, size_t model_count, const int32_t *joints, const nkw_mat4 *inverse_bind, const nkw_mat4 *global_inverse, nkw_mat3x4 *out, size_t n), (models, model_count, joints, inverse_bind, global_inverse, out, n)) \
    X(palette_dual, (const nkw_mat4 *models, size_t model_count, const int32_t *joints, const nkw_mat4 *inverse_bind, const nkw_mat4 *global_inverse, nkw_dual_quat *out, size_t n), (models, model_count, joints, inverse_bind, global_inverse, out, n)) \
    X(palette_inverse, (const nkw_mat4 *models, size_t model_count, const int32_t *joints, const nkw_mat4 *global_inverse, nkw_mat4 *out, size_t n), (models, model_count, joints, global_inverse, out, n)) \
    X(palette_normals, (const nkw_mat4 *palette, size_t line, int rows, float *out, size_t n), (palette, line, rows, out, n)) \
    X(skin_decode, (skin_block *b, const nkw_skin_view *joints, uint32_t limit, const nkw_skin_view *weights, size_t k, size_t n), (b, joints, limit, weights, k, n)) \
    X(skin_blend, (skin_block *b, const nkw_mat4 *palette, size_t k, size_t n), (b, palette, k, n)) \
    X(skin_blend_normals, (skin_block *b, const nkw_mat3 *palette, size_t k, size_t n), (b, palette, k, n)) \
    X(skin_blend_dual_quats, (skin_block *b, const nkw_dual_quat *palette, size_t k, size_t n), (b, palette, k, n)) \
    X(skin_pairs, (const skin_influences *f, const nkw_mat4 *palette, const skin_stream *p, const skin_stream *d, int raw, size_t more, size_t n), (f, palette, p, d, raw, more, n)) \
    X(skin_points, (const skin_block *b, nkw_vec3_view in, nkw_vec3_span out, size_t n), (b, in, out, n)) \
    X(skin_directions, (const skin_block *b, const float *m, int raw, nkw_vec3_view in, nkw_vec3_span out, size_t n), (b, m, raw, in, out, n)) \
    X(skin_read, (const unsigned char *data, size_t stride, float *out, size_t n), (data, stride, out, n)) \
    X(skin_write, (const float *in, unsigned char *data, size_t stride, size_t n), (in, data, stride, n)) \
    X(models_from_pose, (const int32_t *parents, const float *pose, size_t stride, const nkw_mat4 *root, size_t from, size_t to, nkw_mat4 *models), (parents, pose, stride, root, from, to, models)) \
    X(models_from_locals, (const int32_t *parents, const nkw_mat4 *locals, const nkw_mat4 *root, size_t from, size_t to, nkw_mat4 *models), (parents, locals, root, from, to, models)) \
    X(locals_from_models, (const int32_t *parents, const nkw_mat4 *models, const nkw_mat4 *root, size_t from, size_t to, nkw_mat4 *locals), (parents, models, root, from, to, locals)) \
    X(crowd_models, (const int32_t *parents, size_t joints, const float *crowd, const float *roots, float *models), (parents, joints, crowd, roots, models)) \
    X(crowd_bind, (const float *model, const nkw_mat4 *inverse_bind, float *out), (model, inverse_bind, out)) \
    X(crowd_from_poses, (const float *const *poses, size_t joints, size_t stride, float *crowd), (poses, joints, stride, crowd)) \
    X(crowd_to_matrices, (const float *crowd, size_t joints, nkw_mat4 *const *matrices), (crowd, joints, matrices))
/* clang-format on */

#endif
