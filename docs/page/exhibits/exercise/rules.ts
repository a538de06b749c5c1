// SPDX-License-Identifier: MIT
// The rules of the exercise's program, with the functions of the library. They differ from the library's where
// docs/coursework.md says, under "Where this library differs".
import * as N from 'nakawari/all';
import { zeros } from '../../kit/values';
import type { Key, State } from './model';

export type Trace = N.KeyframeTrace;
export type Methods = Pick<State, 'position' | 'orientation' | 'program'>;

/** The methods that the program has. Others follow the library. */
const known = {
  position: ['linear', 'hermite', 'bezier', 'bspline'],
  orientation: ['none', 'euler', 'quat'],
};
export const hasProgram = ({ position, orientation }: Methods) =>
  known.position.includes(position) && known.orientation.includes(orientation);

/** The first segment that contains the time, ends included; before the keys the first's start, after them the end. */
export function segmentOf(keys: Key[], time: number): { k: number; t: number } {
  const last = keys.length - 2;
  const found = keys.findIndex((key, i) => i <= last && time >= key.time && time <= keys[i + 1].time);
  if (found >= 0)
    return { k: found, t: N.inverseLerp(keys[found].time, keys[found + 1].time, time) };
  return time < keys[0].time ? { k: 0, t: 0 } : { k: last, t: 1 };
}

/* ---- the position ---- */

type Curve = Pick<Trace, 'parameter' | 'key' | 'control' | 'weight' | 'position'>;
type Point = (out: number[], a: number[], b: number[], c: number[], d: number[], t: number) => number[];

function cubic(kind: N.CubicKind, curve: Point, key: number[], control: number[][], t: number): Curve {
  const [a, b, c, d] = control, weight = N.cubicWeights(zeros(4), kind, 0, t);
  return { parameter: t, key, control, weight, position: curve(zeros(3), a, b, c, d, t) };
}

function linear(keys: Key[], k: number, t: number): Curve {
  const control = [keys[k].position, keys[k + 1].position], [a, b] = control, weight = [Math.fround(1 - t), t];
  return { parameter: t, key: [k, k + 1], control, weight, position: N.vec3Lerp(zeros(3), a, b, t) };
}

const heading = ({ orientation }: Key): number[] =>
  N.vec3Negate(zeros(3), N.mat3FromQuat(zeros(9), orientation).slice(6));

function hermite(keys: Key[], k: number, t: number): Curve {
  const [a, b] = [keys[k], keys[k + 1]], control = [a.position, heading(a), b.position, heading(b)];
  return cubic(N.CUBIC_HERMITE, N.vec3Hermite, [k, k, k + 1, k + 1], control, t);
}

/**
 * The parameter is not clamped: before the first key, and after a last key that ends a group, the curve continues. Keys
 * after the last complete group have its end.
 */
function bezier(keys: Key[], k: number, time: number): Curve {
  if (keys.length < 4)
    return { parameter: 0, key: [0], control: [keys[0].position], weight: [1], position: keys[0].position };
  const whole = 3 * Math.floor(k / 3), complete = whole + 3 < keys.length, first = complete ? whole : whole - 3;
  const key = [first, first + 1, first + 2, first + 3];
  const s = complete ? N.inverseLerp(keys[first].time, keys[first + 3].time, time) : 1;
  return cubic(N.CUBIC_BEZIER, N.vec3Bezier, key, key.map(i => keys[i].position), s);
}

function bspline(keys: Key[], k: number, t: number): Curve {
  const key = [Math.max(k - 1, 0), k, k + 1, Math.min(k + 2, keys.length - 1)];
  return cubic(N.CUBIC_BSPLINE, N.vec3Bspline, key, key.map(i => keys[i].position), t);
}

export function curveOf(keys: Key[], k: number, t: number, time: number, method: State['position']): Curve {
  return method === 'hermite' ? hermite(keys, k, t)
    : method === 'bezier' ? bezier(keys, k, time)
    : method === 'bspline' ? bspline(keys, k, t) : linear(keys, k, t);
}

/* ---- the Euler angles ---- */

const f = Math.fround;

/**
 * The pitch, yaw and roll of ConvMatToEuler, in floats as there. At a pitch of 90 or -90 degrees the third column is
 * (0, -1, 0) or (0, 1, 0), yaw and roll are atan2 of what rounding leaves, and the rotation of the angles is another.
 */
function convMatToEuler({ orientation }: Key): number[] {
  const [, , , yx, yy, yz, zx, zy, zz] = N.mat3FromQuat(zeros(9), orientation);
  const yaw = N.atan2(zx, zz), pitch = N.atan2(-zy, N.sqrt(f(f(zx * zx) + f(zz * zz))));
  const side = f(f(N.sin(yaw) * yz) - f(N.cos(yaw) * yx));
  return [pitch, yaw, N.atan2(f(N.cos(pitch) * side), yy)];
}

/** Only yaw is unwrapped. */
export function eulerOf(a: Key, b: Key, t: number): Pick<Trace, 'angles' | 'orientationWeight' | 'rotation'> {
  const to = convMatToEuler(b), from = N.eulerLerp(zeros(3), convMatToEuler(a), to, 0, N.UNWRAP_YAW);
  const rotation = N.mat3FromEuler(zeros(9), N.eulerLerp(zeros(3), from, to, t, N.UNWRAP_NONE), N.EULER_YXZ);
  return { angles: [from, to], orientationWeight: [f(1 - t), t], rotation };
}
