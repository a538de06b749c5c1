// SPDX-License-Identifier: MIT
// The numbers of one time: by nkw_keyframes_trace, or by the rules of the exercise's program with the functions of the
// library. The rules differ where docs/coursework.md says, under "Where this library differs".
import * as N from 'nakawari/all';
import { orientationMethod, pack, positionMethod, type Key, type State } from './model';

export type Methods = Pick<State, 'position' | 'orientation' | 'program'>;
export type Trace = N.KeyframeTrace;

/** What the exercise's program knows. Other methods follow the library. */
const known = {
  position: ['linear', 'hermite', 'bezier', 'bspline'],
  orientation: ['none', 'euler', 'quat'],
};
export const hasProgram = ({ position, orientation }: Methods) =>
  known.position.includes(position) && known.orientation.includes(orientation);

/* ---- the rules of the exercise's program ---- */

/** The first segment that contains the time, ends included; before the keys the first at 0, after them the last at 1. */
function segmentOf(keys: Key[], time: number): { k: number; t: number } {
  const last = keys.length - 2;
  const found = keys.findIndex((key, i) => i <= last && time >= key.time && time <= keys[i + 1].time);
  const k = found >= 0 ? found : time < keys[0].time ? 0 : last;
  return { k, t: found >= 0 ? N.inverseLerp(keys[k].time, keys[k + 1].time, time) : time < keys[0].time ? 0 : 1 };
}

type Curve = Pick<Trace, 'parameter' | 'key' | 'control' | 'weight' | 'position'>;
type Point = (out: number[], a: number[], b: number[], c: number[], d: number[], t: number) => number[];

function cubic(kind: N.CubicKind, curve: Point, key: number[], control: number[][], t: number): Curve {
  const [a, b, c, d] = control;
  return {
    parameter: t, key, control, weight: N.cubicWeights([0, 0, 0, 0], kind, 0, t), position: curve([0, 0, 0], a, b, c, d, t),
  };
}

function heading(key: Key): number[] {
  const m = N.mat3FromQuat(Array<number>(9).fill(0), key.orientation);
  return N.vec3Negate([0, 0, 0], m.slice(6));
}

/**
 * The parameter is not clamped: before the first key, and after a last key that ends a group, the curve continues. Keys
 * behind the last complete group have its end.
 */
function bezier(keys: Key[], k: number, time: number): Curve {
  if (keys.length < 4)
    return { parameter: 0, key: [0], control: [keys[0].position], weight: [1], position: keys[0].position };
  const whole = 3 * Math.floor(k / 3), complete = whole + 3 < keys.length, first = complete ? whole : whole - 3;
  const key = [first, first + 1, first + 2, first + 3];
  const s = complete ? N.inverseLerp(keys[first].time, keys[first + 3].time, time) : 1;
  return cubic(N.CUBIC_BEZIER, N.vec3Bezier, key, key.map(i => keys[i].position), s);
}

function curveOf(keys: Key[], k: number, t: number, time: number, method: string): Curve {
  const [a, b] = [keys[k], keys[k + 1]];
  if (method === 'hermite')
    return cubic(N.CUBIC_HERMITE, N.vec3Hermite, [k, k, k + 1, k + 1], [a.position, heading(a), b.position, heading(b)], t);
  if (method === 'bezier')
    return bezier(keys, k, time);
  if (method === 'bspline') {
    const key = [Math.max(k - 1, 0), k, k + 1, Math.min(k + 2, keys.length - 1)];
    return cubic(N.CUBIC_BSPLINE, N.vec3Bspline, key, key.map(i => keys[i].position), t);
  }
  return {
    parameter: t, key: [k, k + 1], control: [a.position, b.position], weight: [Math.fround(1 - t), t],
    position: N.vec3Lerp([0, 0, 0], a.position, b.position, t),
  };
}

/** The library's trace of the segment alone is that of the program, but for the orientation without interpolation. */
function turnOf(keys: Key[], k: number, time: number, method: Methods['orientation']): Trace {
  const pair = method === 'none' ? [keys[k]] : [keys[k], keys[k + 1]];
  return traceOf(pair, time, { position: 'linear', orientation: method, program: false });
}

function programTrace(keys: Key[], time: number, methods: Methods): Trace {
  const { k, t } = segmentOf(keys, time);
  return { ...turnOf(keys, k, time, methods.orientation), ...curveOf(keys, k, t, time, methods.position), segment: k, t };
}

/* ---- both ---- */

/** A copy of the keys in the memory of the library, kept until other keys are asked for. */
let copy: { list: number[]; keyframes: N.Keyframes } | undefined;
function keyframesOf(list: number[]): N.Keyframes {
  if (!copy || copy.list.length !== list.length || copy.list.some((x, i) => !Object.is(x, list[i]))) {
    copy?.keyframes.dispose();
    copy = { list, keyframes: new N.Keyframes(list) };
  }
  return copy.keyframes;
}

function traceOf(keys: Key[], time: number, { position, orientation }: Methods): Trace {
  return keyframesOf(pack(keys)).trace(time, positionMethod[position], orientationMethod[orientation]);
}

/** Undefined where the exercise's program writes no matrix. */
export function trace(keys: Key[], time: number, methods: Methods): Trace | undefined {
  if (!methods.program || !hasProgram(methods))
    return traceOf(keys, time, methods);
  return keys.length > 1 ? programTrace(keys, time, methods) : undefined;
}

/** The matrix by columns. */
export function matrixOf(t: Trace): number[] {
  return N.mat4FromMat3(Array<number>(16).fill(0), t.rotation, t.position);
}

/** The matrices at each of the times. */
export function matrices(keys: Key[], times: number[], methods: Methods): number[][] {
  if (methods.program && hasProgram(methods))
    return times.flatMap(time => {
      const t = trace(keys, time, methods);
      return t ? [matrixOf(t)] : [];
    });
  const all = keyframesOf(pack(keys)), { position, orientation } = methods;
  return times.map(time => all.sample(time, positionMethod[position], orientationMethod[orientation],
    Array<number>(16).fill(0)));
}

/** The first time, then every `step` seconds, and the last. */
export function timesOf(start: number, end: number, step: number): number[] {
  const count = Math.ceil((end - start) / step - 1e-6);
  return Array.from({ length: count + 1 }, (_, i) => Math.fround(Math.min(start + i * step, end)));
}
