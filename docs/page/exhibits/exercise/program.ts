// SPDX-License-Identifier: MIT
// The C program of a state: it prints the numbers of numbers.ts.
import { list, literal, program } from '../../kit/code';
import { keysOf, type Orientation, type Position, type State } from './model';
import { hasProgram } from './rules';

const positionNames: Record<Position, string> = {
  linear: 'LINEAR', hermite: 'HERMITE', bezier: 'BEZIER', bspline: 'BSPLINE', 'catmull-rom': 'CATMULL_ROM',
  centripetal: 'CENTRIPETAL', step: 'STEP',
};
const orientationNames: Record<Orientation, string> = {
  euler: 'EULER', quat: 'SLERP', none: 'STEP', 'euler-unwrapped': 'EULER_UNWRAPPED', nlerp: 'NLERP', squad: 'SQUAD',
};

function setup(state: State): string {
  const rows = keysOf(state).map(({ time, position, orientation }) =>
    `    {${literal(time)}, ${list(position)}, ${list(orientation)}},`);
  return ['const nkw_keyframe keys[] = {', ...rows, '};', 'const size_t count = sizeof keys / sizeof *keys;',
    `const float time = ${literal(state.time)};`, 'nkw_keyframe_trace trace;'].join('\n');
}

const sampled = ({ position, orientation }: State) => `
if (nkw_keyframes_trace(keys, count, time, NKW_POSITION_${positionNames[position]},
                        NKW_ORIENTATION_${orientationNames[orientation]}, &trace) != NKW_OK)
    return 1;`;

/* ---- the rules of the exercise's program ---- */

const segment = `
/* The first segment that contains the time, ends included. */
size_t k = 0;
if (time >= keys[0].time)
    while (k + 2 < count && !(time >= keys[k].time && time <= keys[k + 1].time))
        k++;
const int outside = time < keys[0].time || time > keys[count - 1].time;
const float inside = nkw_inverse_lerp(keys[k].time, keys[k + 1].time, time);
const float t = outside ? (time < keys[0].time ? 0.0f : 1.0f) : inside;
`;

/** The orientation of the first `count` keys of the segment alone. */
const alone = (count: number, method: string) => `
if (nkw_keyframes_trace(keys + k, ${count}, time, NKW_POSITION_LINEAR, NKW_ORIENTATION_${method}, &trace) != NKW_OK)
    return 1;`;

const euler = `
/* ConvMatToEuler. At a pitch of 90 or -90 degrees, yaw and roll are atan2 of what rounding leaves. */
for (size_t i = 0; i < 2; i++) {
    const nkw_mat3 o = nkw_mat3_from_quat(keys[k + i].orientation);
    const nkw_vec3 y = nkw_mat3_column(&o, 1), z = nkw_mat3_column(&o, 2);
    const float xx = z.x * z.x, zz = z.z * z.z;
    const float yaw = nkw_atan2(z.x, z.z), pitch = nkw_atan2(-z.y, nkw_sqrt(xx + zz));
    const float yz = nkw_sin(yaw) * y.z, yx = nkw_cos(yaw) * y.x;
    const nkw_vec3 angles = {pitch, yaw, nkw_atan2(nkw_cos(pitch) * (yz - yx), y.y)};
    trace.angles[i] = angles;
}
/* Only yaw is unwrapped. */
trace.angles[0] = nkw_euler_lerp(trace.angles[0], trace.angles[1], 0.0f, NKW_UNWRAP_YAW);
trace.orientation_weight[0] = 1.0f - t;
trace.orientation_weight[1] = t;
trace.rotation = nkw_mat3_from_euler(nkw_euler_lerp(trace.angles[0], trace.angles[1], t, NKW_UNWRAP_NONE),
                                     NKW_EULER_YXZ);`;

const turns: Record<string, string> = { none: alone(1, 'STEP'), quat: alone(2, 'SLERP'), euler };

const linear = `
const nkw_vec3 p0 = keys[k].position, p1 = keys[k + 1].position;
const float w[] = {1.0f - t, t};
trace.parameter = t;
trace.control_count = 2;
for (size_t i = 0; i < 2; i++) {
    trace.key[i] = k + i;
    trace.control[i] = keys[k + i].position;
    trace.weight[i] = w[i];
}
trace.position = nkw_vec3_lerp(p0, p1, t);`;

// The names of the control values, the kind, and the lines that declare `key`, the parameter u and the control values.
const four = (kind: string, curve: string, lines: string) => `${lines}
const nkw_weights w = nkw_cubic_weights(NKW_CUBIC_${kind}, 0, u);
trace.parameter = u;
trace.control_count = 4;
for (size_t i = 0; i < 4; i++) {
    trace.key[i] = key[i];
    trace.control[i] = control[i];
    trace.weight[i] = w.w[i];
}
trace.position = nkw_vec3_${curve}(control[0], control[1], control[2], control[3], u);`;

const ofKeys = `const nkw_vec3 control[] = {keys[key[0]].position, keys[key[1]].position, keys[key[2]].position,
                            keys[key[3]].position};`;

const hermite = four('HERMITE', 'hermite', `
/* The tangents: minus the third columns. */
const nkw_mat3 o0 = nkw_mat3_from_quat(keys[k].orientation), o1 = nkw_mat3_from_quat(keys[k + 1].orientation);
const size_t key[] = {k, k, k + 1, k + 1};
const nkw_vec3 control[] = {keys[k].position, nkw_vec3_negate(nkw_mat3_column(&o0, 2)), keys[k + 1].position,
                            nkw_vec3_negate(nkw_mat3_column(&o1, 2))};
const float u = t;`);

const bspline = four('BSPLINE', 'bspline', `
const size_t key[] = {k > 0 ? k - 1 : 0, k, k + 1, k + 2 < count ? k + 2 : k + 1};
${ofKeys}
const float u = t;`);

const bezier = four('BEZIER', 'bezier', `
/* The parameter is not clamped. Behind the last complete group of four keys it is 1. */
const int complete = k / 3 * 3 + 3 < count;
const size_t first = complete ? k / 3 * 3 : k / 3 * 3 - 3;
const size_t key[] = {first, first + 1, first + 2, first + 3};
${ofKeys}
const float u = complete ? nkw_inverse_lerp(keys[first].time, keys[first + 3].time, time) : 1.0f;`);

const few = `
/* Fewer than four keys: the first. */
trace.parameter = 0.0f;
trace.control_count = 1;
trace.key[0] = 0;
trace.control[0] = trace.position = keys[0].position;
trace.weight[0] = 1.0f;`;

const curves: Record<string, string> = { linear, hermite, bezier, bspline };

function exercise(state: State): string {
  const position = state.position === 'bezier' && keysOf(state).length < 4 ? few : curves[state.position];
  return [segment, turns[state.orientation], 'trace.segment.index = k;', 'trace.segment.t = t;', position].join('\n');
}

/* ---- both ---- */

const prints: Record<string, string> = {
  slerp: `
/* The formulas (17) and (18). */
const nkw_quat q0 = trace.orientation[0], q1 = trace.orientation[1];
const size_t next = trace.segment.index + 1 < count ? trace.segment.index + 1 : trace.segment.index;
show_floats("q0", 4, &q0.x);
show_floats("q1key", 4, &keys[next].orientation.x);
show_floats("q1", 4, &q1.x);
show("dot", 0, (double)nkw_quat_dot(q0, keys[next].orientation));
show("theta", 0, (double)trace.half_angle);
show("turn", 0, (double)nkw_degrees_from_radians(2.0f * trace.half_angle));
show_floats("share", 2, trace.orientation_weight);
const nkw_quat q = nkw_quat_add(nkw_quat_scale(q0, trace.orientation_weight[0]),
                                nkw_quat_scale(q1, trace.orientation_weight[1]));
show_floats("q", 4, &q.x);`,
  euler: `
/* Angles about x, y, z: pitch, yaw, roll. */
const nkw_vec3 angles = nkw_euler_lerp(trace.angles[0], trace.angles[1], trace.segment.t, NKW_UNWRAP_NONE);
show_floats("angles0", 3, &trace.angles[0].x);
show_floats("angles1", 3, &trace.angles[1].x);
show_floats("share", 2, trace.orientation_weight);
show_floats("angles", 3, &angles.x);`,
};
const printOf: Record<Orientation, string> = {
  quat: prints.slerp, nlerp: prints.slerp, euler: prints.euler, 'euler-unwrapped': prints.euler, none: '', squad: '',
};

const common = `
show("segment", 0, (double)trace.segment.index);
show("t", 0, (double)trace.segment.t);
show("parameter", 0, (double)trace.parameter);
for (size_t i = 0; i < trace.control_count; i++) {
    const char *const names[] = {"control0", "control1", "control2", "control3"};
    show_floats(names[i], 3, &trace.control[i].x);
    show("key", (int)i, (double)trace.key[i]);
}
show_floats("weight", (int)trace.control_count, trace.weight);
show_floats("position", 3, &trace.position.x);`;

const matrix = `
const nkw_mat4 m = nkw_mat4_from_mat3(&trace.rotation, trace.position);
show_floats("matrix", 16, m.m);`;

export function code(state: State): string {
  const written = !state.program || !hasProgram(state);
  if (!written && keysOf(state).length < 2)
    return program('/* With one key, the exercise\'s program returns without writing the matrix. */');
  return program([setup(state), written ? sampled(state) : exercise(state), common, printOf[state.orientation], matrix]
    .join('\n'));
}
