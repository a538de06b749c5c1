// SPDX-License-Identifier: MIT
// The C program of a state: it prints the numbers of numbers.ts.
import { list, literal, program } from '../../kit/code';
import { keysOf, type Orientation, type Position, type State } from './model';

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

const sampled = ({ position, orientation, program: exercise }: State) => `
const nkw_keyframe_options options = {NKW_POSITION_${positionNames[position]}, NKW_ORIENTATION_${
  orientationNames[orientation]}, NKW_KEYFRAME_RULE_${exercise ? 'EXERCISE' : 'LIBRARY'}};
if (nkw_keyframes_trace(keys, count, time, &options, &trace) != NKW_OK)
    return 1;`;

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
  if (state.program && keysOf(state).length < 2)
    return program('/* With one key, the exercise\'s program returns without writing the matrix. */');
  return program([setup(state), sampled(state), common, printOf[state.orientation], matrix].join('\n'));
}
