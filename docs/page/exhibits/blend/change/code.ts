// SPDX-License-Identifier: MIT
// The numbers of a change in C, for one joint.
import { list, literal, program } from '../../../kit/code';
import type { Rig } from '../rig';
import { type State, step } from '../state';
import { instants, kinds, rotations, timesOf } from './model';

const quats = (name: string, all: number[][]) =>
  `static const nkw_quat ${name}[COUNT] = {\n${all.map(q => `    ${list(q)},`).join('\n')}\n};`;
const motion = (clip: string, [i, j]: number[]) =>
  `{${clip}[${j}], nkw_quat_angular_velocity(${clip}[${i}], ${clip}[${j}], step)}`;

const jumps = (first: number[], last: number[]) => [first, last].map(([i, j, k], n) => `
    show(jumps[kind], ${n}, (double)nkw_vec3_distance(
        nkw_quat_angular_velocity(q[kind][${i}], q[kind][${j}], step),
        nkw_quat_angular_velocity(q[kind][${j}], q[kind][${k}], step)));`).join('');

export function changeCode(state: State, rig: Rig): string {
  const { at, duration } = timesOf(state), { times, first, last, here: [before, now] } = instants(state);
  const all = rotations(state, rig, times);
  const names = (prefix: string) => kinds.map(kind => `"${prefix}_${kind}"`).join(', ');
  return program(`
/* The rotation of ${state.joint} in both clips, at times since the change began, in seconds. */
enum { COUNT = ${times.length}, KINDS = ${kinds.length} };
static const float since[COUNT] = ${list(times.map(t => t - at))};
${quats('a', all.map(q => q[0]))}
${quats('b', all.map(q => q[1]))}
static const char *const velocities[KINDS] = {${names('velocity')}};
static const char *const jumps[KINDS] = {${names('jump')}};
const float step = ${literal(step)}, duration = ${literal(duration)};
const nkw_quat_state from = ${motion('a', first)};
const nkw_quat_state to = ${motion('b', first)};
nkw_quat_offset inertia = {.duration = duration};
nkw_quat_offset dead = {.kind = NKW_OFFSET_DEAD_BLEND, .duration = duration, .half_life = ${literal(state.coast)}};
nkw_quat_offset_begin(&inertia, &from, &to);
nkw_quat_offset_begin(&dead, &from, &to);
nkw_quat q[KINDS][COUNT];
for (int i = 0; i < COUNT; i++) {
    const nkw_quat_state next = {b[i], {0.0f, 0.0f, 0.0f}};
    const float part = nkw_clamp(since[i] / duration, 0.0f, 1.0f);
    q[0][i] = a[i];
    q[1][i] = b[i];
    q[2][i] = nkw_quat_nlerp(a[i], b[i], ${state.smooth ? 'nkw_smoothstep(part)' : 'part'});
    q[3][i] = since[i] < 0.0f ? a[i] : nkw_quat_offset_evaluate(&inertia, &next, since[i]).value;
    q[4][i] = since[i] < 0.0f ? a[i] : nkw_quat_offset_evaluate(&dead, &next, since[i]).value;
}
for (int kind = 0; kind < KINDS; kind++) {
    const nkw_vec3 now = nkw_quat_angular_velocity(q[kind][${before}], q[kind][${now}], step);
    show(velocities[kind], 0, (double)now.x);
    show(velocities[kind], 1, (double)now.y);
    show(velocities[kind], 2, (double)now.z);${jumps(first, last)}
}
`);
}
