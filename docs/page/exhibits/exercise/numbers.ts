// SPDX-License-Identifier: MIT
// The numbers of the present time by their names in the C program (program.ts).
import * as N from 'nakawari/all';
import { zeros } from '../../kit/values';
import type { Key, State } from './model';
import { matrixOf, type Trace } from './sample';

export type Numbers = Record<string, number[]>;

function ofSlerp(keys: Key[], t: Trace): Numbers {
  const [q0, q1] = t.orientation, [a, b] = t.orientationWeight;
  const q1key = keys[Math.min(t.segment + 1, keys.length - 1)].orientation;
  const q = N.quatAdd(zeros(4), N.quatScale(zeros(4), q0, a), N.quatScale(zeros(4), q1, b));
  return {
    q0, q1key, q1, dot: [N.quatDot(q0, q1key)], theta: [t.halfAngle], turn: [N.degreesFromRadians(2 * t.halfAngle)],
    share: t.orientationWeight, q,
  };
}

function ofEuler(t: Trace): Numbers {
  const [angles0, angles1] = t.angles;
  const angles = N.eulerLerp(zeros(3), angles0, angles1, t.t, N.UNWRAP_NONE);
  return { angles0, angles1, share: t.orientationWeight, angles };
}

export function numbersOf(keys: Key[], t: Trace, { orientation }: Pick<State, 'orientation'>): Numbers {
  const control = Object.fromEntries(t.control.map((v, i) => [`control${i}`, v]));
  const slerp = orientation === 'quat' || orientation === 'nlerp', euler = orientation.startsWith('euler');
  return {
    segment: [t.segment], t: [t.t], parameter: [t.parameter], key: t.key, ...control, weight: t.weight,
    position: t.position, ...(slerp ? ofSlerp(keys, t) : euler ? ofEuler(t) : {}), matrix: matrixOf(t),
  };
}
