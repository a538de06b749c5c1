// SPDX-License-Identifier: MIT
// The curves through the keys: a track for each method, or cubic segments where no track has the curve.
import * as N from 'nakawari/all';
import { choice, flag, number, numbers } from '../../shell/state';
import type { Text } from '../../shell/text';

/** The splines in the order of nkw_spline_method, the first one is 0. */
export const splines = ['catmull', 'cardinal', 'tcb', 'centripetal', 'chordal', 'pchip', 'akima', 'makima',
  'c2'] as const;
export const methods = ['step', 'linear', 'own', ...splines, 'bspline'] as const;
export type Method = typeof methods[number];
export const scales = ['second', 'segment'] as const;

export const words: Record<Method, Text> = {
  step: { en: 'step', ja: 'ステップ' },
  linear: { en: 'linear', ja: '線形' },
  own: { en: 'Hermite, own tangents', ja: 'エルミート(接線を指定)' },
  catmull: { en: 'Catmull-Rom', ja: 'Catmull-Rom' },
  cardinal: { en: 'cardinal', ja: 'カーディナル' },
  tcb: { en: 'Kochanek-Bartels', ja: 'Kochanek-Bartels' },
  centripetal: { en: 'centripetal', ja: '求心型' },
  chordal: { en: 'chordal', ja: '弦長型' },
  pchip: { en: 'PCHIP, monotone', ja: 'PCHIP(単調)' },
  akima: { en: 'Akima', ja: '秋間' },
  makima: { en: 'modified Akima', ja: '修正秋間' },
  c2: { en: 'C2 spline', ja: 'C2スプライン' },
  bspline: { en: 'uniform B-spline', ja: '一様Bスプライン' },
};

export interface State {
  times: number[]; values: number[]; tangents: number[];
  method: Method; scale: typeof scales[number]; all: boolean;
  tension: number; continuity: number; bias: number; time: number;
}

const five = (list: number[]) => list.length === 5;
const ascending = (list: number[]) => five(list) && list.every((t, k) => k === 0 || t > list[k - 1]);
export const fields = {
  times: numbers([0, 0.5, 2, 2.5, 4], ascending),
  values: numbers([0, 1, 2, -0.5, 0.5], five),
  tangents: numbers([3, 1.5, -3, -2, 1], five),
  method: choice<Method>('own', methods), scale: choice<State['scale']>('second', scales), all: flag(true),
  tension: number(0, -1, 1), continuity: number(0, -1, 1), bias: number(0, -1, 1), time: number(0.75),
};

/** The tangents before and after each key, as stored; undefined for curves that have none. */
export function tangentsOf(s: State, method: Method): Record<'before' | 'after', ArrayLike<number>> | undefined {
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

function track(s: State, method: Method): Curve {
  const tangents = tangentsOf(s, method), out = [0, 0, 0].map(() => new Float32Array(1));
  const made = new N.Track({ times: s.times, width: 1,
    values: tangents ? s.values.flatMap((v, k) => [tangents.before[k], v, tangents.after[k]]) : s.values,
    interpolation: tangents ? N.INTERPOLATION_CUBICSPLINE
      : method === 'step' ? N.INTERPOLATION_STEP : N.INTERPOLATION_LINEAR });
  return time => {
    made.sampleDerivatives(time, out[0], out[1], out[2]);
    return out.map(x => x[0]);
  };
}

// Segments by their parameter: velocity and acceleration are divided by the duration and its square.
function cubic(s: State, kind: N.CubicKind, control: (k: number) => number[]): Curve {
  const times = Float32Array.from(s.times), last = times.length - 2;
  return time => {
    const { index, t } = N.segmentFind({}, times, times.length, time), k = Math.min(index, last);
    const [value, first, second] = N.cubicPoint(new Float32Array(3), kind, control(k), index > last ? 1 : t);
    const h = Math.fround(times[k + 1] - times[k]);
    return [value, first / h, second / (h * h)];
  };
}

/** The curve of a method; `scale` says how its tangents are read. */
export function curve(s: State, method: Method, scale = s.scale): Curve {
  const tangents = tangentsOf(s, method), { values } = s;
  if (method === 'bspline')
    return cubic(s, N.CUBIC_BSPLINE, k => [k - 1, k, k + 1, k + 2].map(i =>
      values[Math.min(Math.max(i, 0), values.length - 1)]));
  if (tangents && scale === 'segment')
    return cubic(s, N.CUBIC_HERMITE, k => [values[k], tangents.after[k], values[k + 1], tangents.before[k + 1]]);
  return track(s, method);
}
