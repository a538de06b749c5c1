// SPDX-License-Identifier: MIT
import { list, literal, program } from '../../kit/code';
import { names, seconds, type State } from './model';

export const code = (state: State) => {
  const { ax, ay, az, bx, by, bz, flip, turns, method, time } = state;
  return program(`
const float a_degrees[] = ${list([ax, ay, az])}, b_degrees[] = ${list([bx, by, bz])};
const float seconds = ${literal(seconds)}, t = ${literal(time / seconds)};
float ea[3], eb[3];
for (int i = 0; i < 3; i++) {
    ea[i] = nkw_radians_from_degrees(a_degrees[i]);
    eb[i] = nkw_radians_from_degrees(b_degrees[i]);
}
const nkw_vec3 a_angles = {ea[0], ea[1], ea[2]}, b_angles = {eb[0], eb[1], eb[2]};
const nkw_quat a = nkw_quat_from_euler(a_angles, NKW_EULER_YXZ);
const nkw_quat b = ${flip ? 'nkw_quat_negate(' : ''}nkw_quat_from_euler(b_angles, NKW_EULER_YXZ)${flip ? ')' : ''};

enum {${names.map(m => m.toUpperCase()).join(', ')}, METHODS};
const char *const names[] = {${names.map(m => `"${m}"`).join(', ')}};
nkw_quat q[METHODS];
nkw_vec3 w[METHODS];

/* Euler angles: each rate is about the axis of its gimbal */
const nkw_vec3 e = nkw_euler_lerp(a_angles, b_angles, t, NKW_UNWRAP_NONE);
const nkw_vec3 yaw = {0.0f, e.y, 0.0f}, yaw_pitch = {e.x, e.y, 0.0f}, x = {1.0f, 0.0f, 0.0f}, z = {0.0f, 0.0f, 1.0f};
const nkw_vec3 rates = nkw_vec3_scale(nkw_vec3_sub(b_angles, a_angles), 1.0f / seconds), first = {0.0f, rates.y, 0.0f};
const nkw_vec3 pitch_axis = nkw_quat_rotate(nkw_quat_from_euler(yaw, NKW_EULER_YXZ), x);
const nkw_vec3 roll_axis = nkw_quat_rotate(nkw_quat_from_euler(yaw_pitch, NKW_EULER_YXZ), z);
q[EULER] = nkw_quat_from_euler(e, NKW_EULER_YXZ);
w[EULER] = nkw_vec3_add_scaled(nkw_vec3_add_scaled(first, pitch_axis, rates.x), roll_axis, rates.z);

/* nlerp: its angular velocity is that of the cubic with the tangents of the straight line */
const nkw_quat end = nkw_quat_dot(a, b) < 0.0f ? nkw_quat_negate(b) : b;
const nkw_quat tangent = nkw_quat_scale(nkw_quat_sub(end, a), 1.0f / seconds);
const nkw_quat values[] = {tangent, a, tangent, tangent, end, tangent};
const float times[] = {0.0f, seconds};
const nkw_track track = {times, &values[0].x, 2, 4, NKW_TRACK_ROTATION, NKW_INTERPOLATION_CUBICSPLINE, NULL};
nkw_quat_motion state;
const nkw_motion_span out = {&state.value.x, &state.velocity.x, &state.acceleration.x};
if (nkw_track_sample_motion(&track, t * seconds, out) != NKW_OK)
    return 1;
q[NLERP] = nkw_quat_nlerp(a, b, t);
w[NLERP] = state.velocity;

/* slerp: constant angular velocity */
const nkw_path paths[] = {NKW_PATH_SHORT, NKW_PATH_LONG, NKW_PATH_SHORT, NKW_PATH_AS_GIVEN};
for (int m = SLERP; m < METHODS; m++) {
    const nkw_rotation_segment segment = nkw_rotation_from_slerp(a, b, seconds, paths[m - SLERP], m == TURNS ? ${turns} : 0);
    state = nkw_rotation_evaluate(&segment, t);
    q[m] = state.value;
    w[m] = state.velocity;
}

const nkw_quat keys[] = {a, b, q[${method.toUpperCase()}]};
const char *const key_names[] = {"a", "b", "q"};
for (int i = 0; i < 3; i++) {
    show(key_names[i], 0, keys[i].x);
    show(key_names[i], 1, keys[i].y);
    show(key_names[i], 2, keys[i].z);
    show(key_names[i], 3, keys[i].w);
}
show("w", 0, w[${method.toUpperCase()}].x);
show("w", 1, w[${method.toUpperCase()}].y);
show("w", 2, w[${method.toUpperCase()}].z);
show("dot", 0, nkw_quat_dot(a, b));
show("arc", 0, nkw_degrees_from_radians(nkw_quat_angle(a, b)));
for (int m = 0; m < METHODS; m++) {
    show(names[m], 0, nkw_degrees_from_radians(nkw_vec3_length(w[m])));
    show(names[m], 1, nkw_degrees_from_radians(nkw_quat_angle(q[m], q[SLERP])));
}`);
};
