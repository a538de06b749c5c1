/* SPDX-License-Identifier: MIT */
/*
 * One line per batch function: P(name, inputs, outputs, arguments of the loop, the same by the single function).
 *
 * `inputs` says what the arrays hold, letter by letter:
 *     q  unit quaternions, 4 arrays     v  vectors, 3 arrays      m  rotation matrices, 9 arrays
 *     M  matrices, 16 arrays            f  numbers of any size    t  parameters, most in 0..1
 * In the arguments in[k] and out[k] are arrays and n their length; V Q M3 M4 make views of those from k on, VS QS MS3
 * MS4 spans. In the single call x[k] are the inputs of one element and v q make values of those from k on; o is
 * written. PX is P for functions that may not work in place.
 */

P(vec3_normalize, "v", 3, (V(0), VS(0), n), put_vec3(o, nkw_vec3_normalize(v(0))))
P(vec3_lerp, "vvt", 3, (V(0), V(3), in[6], VS(0), n), put_vec3(o, nkw_vec3_lerp(v(0), v(3), x[6])))
P(vec3_lerp_at, "vv", 3, (V(0), V(3), 0.7f, VS(0), n), put_vec3(o, nkw_vec3_lerp(v(0), v(3), 0.7f)))

P(quat_mul, "qq", 4, (Q(0), Q(4), QS(0), n), put_quat(o, nkw_quat_mul(q(0), q(4))))
P(quat_normalize, "vf", 4, (Q(0), QS(0), n), put_quat(o, nkw_quat_normalize(q(0))))
P(quat_rotate, "qv", 3, (Q(0), V(4), VS(0), n), put_vec3(o, nkw_quat_rotate(q(0), v(4))))
P(quat_nlerp, "qqt", 4, (Q(0), Q(4), in[8], QS(0), n), put_quat(o, nkw_quat_nlerp(q(0), q(4), x[8])))
P(quat_nlerp_at, "qq", 4, (Q(0), Q(4), 0.7f, QS(0), n), put_quat(o, nkw_quat_nlerp(q(0), q(4), 0.7f)))
P(quat_slerp, "qqt", 4, (Q(0), Q(4), in[8], QS(0), n), put_quat(o, nkw_quat_slerp(q(0), q(4), x[8])))
P(quat_slerp_at, "qq", 4, (Q(0), Q(4), 0.3f, QS(0), n), put_quat(o, nkw_quat_slerp(q(0), q(4), 0.3f)))

P(mat4_mul_affine, "MM", 16, (M4(0), M4(16), MS4(0), n), put_mat4(o, nkw_mat4_mul_affine(&m4(0), &m4(16))))
P(mat4_transform_point, "v", 3, (&some_matrix, V(0), VS(0), n), put_vec3(o, nkw_mat4_transform_point(&some_matrix, v(0))))
P(mat4_transform_direction, "v", 3, (&some_matrix, V(0), VS(0), n), put_vec3(o, nkw_mat4_transform_direction(&some_matrix, v(0))))
PX(mat4_from_trs, "vqv", 16, (TRS(0), MS4(0), n), put_mat4(o, nkw_mat4_from_trs(&trs(0))))

P(vec3_hermite, "vvvvt", 3, (V(0), V(3), V(6), V(9), in[12], VS(0), n), put_vec3(o, nkw_vec3_hermite(v(0), v(3), v(6), v(9), x[12])))
P(vec3_bezier, "vvvvt", 3, (V(0), V(3), V(6), V(9), in[12], VS(0), n), put_vec3(o, nkw_vec3_bezier(v(0), v(3), v(6), v(9), x[12])))
P(vec3_bspline, "vvvvt", 3, (V(0), V(3), V(6), V(9), in[12], VS(0), n), put_vec3(o, nkw_vec3_bspline(v(0), v(3), v(6), v(9), x[12])))
P(vec3_catmull_rom, "vvvvt", 3, (V(0), V(3), V(6), V(9), in[12], VS(0), n), put_vec3(o, nkw_vec3_catmull_rom(v(0), v(3), v(6), v(9), x[12])))

PX(vec3_unpack, "v", 3, ((const nkw_vec3 *)aos(in, 3, n), VS(0), n), put_vec3(o, v(0)))
PX(quat_unpack, "q", 4, ((const nkw_quat *)aos(in, 4, n), QS(0), n), put_quat(o, q(0)))
PX(mat4_unpack, "M", 16, ((const nkw_mat4 *)aos(in, 16, n), MS4(0), n), put_mat4(o, m4(0)))
