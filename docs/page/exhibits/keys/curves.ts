// SPDX-License-Identifier: MIT
// The curves through the keys: a track for each method, or cubic segments where no track has the curve.
import * as N from 'nakawari/all';
import { clamp } from '../../kit/values';
import { choice, number, numbers, some } from '../../shell/state';
import type { Text } from '../../shell/text';

/** The splines in the order of nkw_spline_method, the first one is 0. */
export const splines = ['catmull', 'cardinal', 'tcb', 'centripetal', 'chordal', 'pchip', 'akima', 'makima',
  'c2'] as const;
export const methods = ['step', 'linear', 'own', ...splines, 'bspline'] as const;
export type Method = typeof methods[number];
export const scales = ['second', 'segment'] as const;
type Scale = typeof scales[number];

export const words: Record<Method, Text> = {
  step: { en: 'step', ja: 'ステップ' },
  linear: { en: 'linear', ja: '線形' },
  own: { en: 'Hermite, own tangents', ja: 'Hermite（接線を指定）' },
  catmull: { en: 'Catmull-Rom', ja: 'Catmull-Rom' },
  cardinal: { en: 'cardinal', ja: 'カーディナル' },
  tcb: { en: 'TCB (Kochanek-Bartels)', ja: 'TCB（Kochanek-Bartels）' },
  centripetal: { en: 'centripetal', ja: '求心' },
  chordal: { en: 'chordal', ja: '弦長' },
  pchip: { en: 'PCHIP, monotone', ja: 'PCHIP（単調）' },
  akima: { en: 'Akima', ja: 'Akima（秋間）' },
  makima: { en: 'modified Akima', ja: '修正 Akima' },
  c2: { en: 'C2 spline', ja: 'C2 スプライン' },
  bspline: { en: 'uniform B-spline', ja: '一様 B スプライン' },
};

/** The curves of the plots: all methods, the chosen tangents by the other scale, and the chosen method. */
export const shown = [...methods, 'other', 'chosen'] as const;

/** `keys` has the time, the value and the own tangent of each key. */
export interface State {
  keys: number[]; method: Method; scale: Scale; hidden: typeof shown[number][];
  tension: number; continuity: number; bias: number; time: number;
}

export const most = 8, closest = 0.1;
const valid = (list: number[]) => list.length % 3 === 0 && list.length >= 6 && list.length <= 3 * most &&
  list.every((x, i) => i % 3 !== 0 || i === 0 || x > list[i - 3]);
export const fields = {
  keys: numbers([0, 0, 3, 0.5, 1, 1.5, 2, 2, -3, 2.5, -0.5, -2, 4, 0.5, 1], valid),
  method: choice<Method>('own', methods), scale: choice<Scale>('second', scales), hidden: some([], shown),
  tension: number(0, -1, 1), continuity: number(0, -1, 1), bias: number(0, -1, 1), time: number(0.75),
};

/** The keys of a state in columns. */
export interface Keys extends State { times: number[]; values: number[]; tangents: number[] }

export function keysOf(s: State): Keys {
  const column = (offset: number) => s.keys.filter((_, i) => i % 3 === offset);
  return { ...s, times: column(0), values: column(1), tangents: column(2) };
}

/** The tangents before and after each key, as stored; undefined for curves that have none. */
export function tangentsOf(s: Keys, method = s.method): Record<'before' | 'after', ArrayLike<number>> | undefined {
  const k = splines.indexOf(method as typeof splines[number]), count = s.times.length;
  if (k < 0)
    return method === 'own' ? { before: s.tangents, after: s.tangents } : undefined;
  const before = new Float32Array(count), after = new Float32Array(count);
  N.splineTangents({ times: s.times, values: s.values, count, width: 1, stride: 1, method: k, ends: N.SPLINE_ENDS_FREE,
    tension: s.tension, tcb: s.times.flatMap(() => [s.tension, s.continuity, s.bias]) }, before, after);
  return { before, after };
}

/** Value, velocity, acceleration at a time. */
export type Curve = (time: number) => number[];

function track(s: Keys, method: Method, count: number): Curve {
  const tangents = tangentsOf(s, method), out = [0, 0, 0].map(() => new Float32Array(1));
  const made = new N.Track({ times: s.times.slice(0, count), width: 1,
    values: s.values.slice(0, count).flatMap((v, k) => tangents ? [tangents.before[k], v, tangents.after[k]] : [v]),
    interpolation: tangents ? N.INTERPOLATION_CUBICSPLINE
      : method === 'step' ? N.INTERPOLATION_STEP : N.INTERPOLATION_LINEAR });
  return time => {
    made.sampleMotion(time, out[0], out[1], out[2]);
    return out.map(x => x[0]);
  };
}

// Segments by their parameter: velocity and acceleration are divided by the duration and its square.
function cubic(s: Keys, kind: N.CubicKind, count: number, control: (k: number) => number[]): Curve {
  const times = Float32Array.from(s.times.slice(0, count)), last = count - 2;
  return time => {
    const { index, t } = N.segmentFind({}, times, count, time), k = Math.min(index, last);
    const [value, first, second] = N.cubicEvaluate(new Float32Array(3), control(k), index > last ? 1 : t, kind);
    const h = Math.fround(times[k + 1] - times[k]);
    return [value, first / h, second / (h * h)];
  };
}

/** The curve of a method up to its key `count` - 1. `scale` says how its tangents are read. */
export function curve(s: Keys, method: Method, scale = s.scale, count = s.times.length): Curve {
  const tangents = tangentsOf(s, method), { values } = s;
  if (method === 'bspline')
    return cubic(s, N.CUBIC_BSPLINE, count, k => [k - 1, k, k + 1, k + 2].map(i =>
      values[clamp(i, 0, values.length - 1)]));
  if (tangents && scale === 'segment')
    return cubic(s, N.CUBIC_HERMITE, count, k => [values[k], tangents.after[k], values[k + 1], tangents.before[k + 1]]);
  return track(s, method, count);
}

/** The key nearest to the present time, of `from` to `to`. */
export function nearest({ times, time }: Keys, from = 0, to = times.length - 1): number {
  const all = times.map((_, k) => k).slice(from, to + 1);
  return all.reduce((best, k) => Math.abs(times[k] - time) < Math.abs(times[best] - time) ? k : best, from);
}

/** The key between two segments that is nearest to the present time. */
export const joint = (s: Keys) => s.times.length > 2 ? nearest(s, 1, s.times.length - 2) : undefined;

/** The velocity of the chosen method before and after a key. */
export const velocities = (s: Keys, k: number, scale: Scale): number[] =>
  [curve(s, s.method, scale, k + 1), curve(s, s.method, scale)].map(f => f(Math.fround(s.times[k]))[1]);
