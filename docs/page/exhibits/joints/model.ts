// SPDX-License-Identifier: MIT
// The state, and the joint matrices by the order of the product that is chosen.
import * as N from 'nakawari/all';
import { turnFields } from '../../kit/space';
import { whole } from '../../kit/whole';
import { choice, number } from '../../shell/state';
import { joints, rings, type Influence } from './mesh';

/** P is the joint matrix of the joint before, I is the inverse of T. */
export type Factor = 'P' | 'T' | 'J' | 'I';
export const orders = {
  right: 'PTJI', noParent: 'TJI', parentLast: 'TJIP', swapped: 'PIJT', noInverse: 'PTJ', onlyTurn: 'PJ',
} as const;
export type Order = keyof typeof orders;
export const factors = (order: Order) => [...orders[order]] as Factor[];

export type Axis = 'x' | 'y' | 'z';
export const vectors: Record<Axis, number[]> = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };

export const fields = {
  ...turnFields(60, 8),
  order: choice<Order>('right', Object.keys(orders) as Order[]),
  influence: choice<Influence>('smooth', ['smooth', 'hard']),
  paint: choice<'all' | 'one'>('all', ['all', 'one']),
  axis: choice<Axis>('x', ['x', 'y', 'z']),
  joint: whole(1, 0, joints - 1),
  ring: whole(13, 0, rings - 1),
  angle0: number(0, -3.2, 3.2), angle1: number(0.5, -3.2, 3.2), angle2: number(-0.5, -3.2, 3.2), angle3: number(0, -3.2, 3.2),
  height1: number(1, 0, 3), height2: number(2, 0, 3), height3: number(3, 0, 3),
};
export type State = { [K in keyof typeof fields]: typeof fields[K]['initial'] };

export const angles = (s: State) => [s.angle0, s.angle1, s.angle2, s.angle3];
export const heights = (s: State) => [0, s.height1, s.height2, s.height3];

export type Matrix = number[];
const zeros = (n: number): Matrix => Array<number>(n).fill(0);

/** The factors of joint i, and their product. */
export type Joint = Record<Factor | 'M', Matrix>;

export function chain(state: State): Joint[] {
  const made: Joint[] = [], turns = angles(state), one = N.mat3Identity(zeros(9));
  heights(state).forEach((height, i) => {
    const T = N.mat4FromMat3(zeros(16), one, [0, height, 0]), I = N.mat4InverseRigid(zeros(16), T);
    const J = N.mat4FromQuat(zeros(16), N.quatFromAxisAngle(zeros(4), vectors[state.axis], turns[i]));
    const parts = { P: i ? made[i - 1].M : N.mat4Identity(zeros(16)), T, J, I };
    const [first, ...rest] = factors(state.order).map(name => parts[name]);
    made.push({ ...parts, M: rest.reduce((product, m) => N.mat4Mul(zeros(16), product, m), first) });
  });
  return made;
}

/** Row r of a matrix. */
export function row(m: Matrix, r: number): Matrix {
  const rows = zeros(16);
  N.mat4ToRowMajor(m, rows);
  return rows.slice(4 * r, 4 * r + 4);
}
