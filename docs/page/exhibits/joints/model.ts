// SPDX-License-Identifier: MIT
// The state, and the joint matrices by the product that is chosen.
import * as N from 'nakawari/all';
import { turnFields } from '../../kit/space';
import { zeros } from '../../kit/values';
import { choice, number, whole } from '../../shell/state';
import { around, joints, rings, type Influence } from './mesh';

/** P is the joint matrix of the parent joint, I is the inverse of T. */
export type Factor = 'P' | 'T' | 'J' | 'I';
export const orders = {
  turn: 'J', origin: 'JI', noParent: 'TJI', right: 'PTJI',
  noInverse: 'PTJ', noTranslation: 'PJI', turnFirst: 'PJTI', swapped: 'PIJT', parentLast: 'TJIP',
  transposed: 'PTJI', degrees: 'PTJI', unnormalised: 'PTJI',
} as const;
export type Order = keyof typeof orders;
export const orderNames = Object.keys(orders) as Order[];
/** The steps of the lesson; the others are mistakes. */
export const steps: Order[] = ['turn', 'origin', 'noParent', 'right'];
export const factors = (order: Order) => [...orders[order]] as Factor[];

export type Axis = 'x' | 'y' | 'z';
export const vectors: Record<Axis, number[]> = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };
export const most = 3.14;
const angle = (initial: number) => number(initial, -most, most);

export const fields = {
  ...turnFields(60, 8),
  time: number(0, 0, 4),
  order: choice<Order>('right', orderNames),
  influence: choice<Influence>('smooth', ['smooth', 'hard']),
  paint: choice<'one' | 'all'>('one', ['one', 'all']),
  axis: choice<Axis>('x', ['x', 'y', 'z']),
  joint: whole(1, 0, joints - 1),
  ring: whole(13, 0, rings - 1),
  column: whole(0, 0, around - 1),
  angle0: angle(0), angle1: angle(0.5), angle2: angle(-0.5), angle3: angle(0),
  height1: number(1, 0, 3), height2: number(2, 0, 3), height3: number(3, 0, 3),
};
export type State = { [K in keyof typeof fields]: typeof fields[K]['initial'] };

/** The share of the angles at a time: the lesson's |fmod(timer, 1) - 0.5|, from 1 to 0 and back in four seconds. */
const swing = (time: number) => 2 * Math.abs(N.wrap(time / 4, 1) - 0.5);
export const angles = (s: State) => [s.angle0, s.angle1, s.angle2, s.angle3].map(a => a * swing(s.time));
export const heights = (s: State) => [0, s.height1, s.height2, s.height3];

type Matrix = number[];

/** The factors of joint i, their product, and the matrix of the palette: the same, unless it is transposed. */
export type Joint = Record<Factor | 'product' | 'M', Matrix>;

export function chain(state: State): Joint[] {
  const made: Joint[] = [], turns = angles(state), one = N.mat3Identity(zeros(9)), { order, axis } = state;
  heights(state).forEach((height, i) => {
    const turn = order === 'degrees' ? N.degreesFromRadians(turns[i]) : turns[i];
    const T = N.mat4FromMat3(zeros(16), one, [0, height, 0]), I = N.mat4InverseRigid(zeros(16), T);
    const J = N.mat4FromQuat(zeros(16), N.quatFromAxisAngle(zeros(4), vectors[axis], turn));
    const parts = { P: i ? made[i - 1].product : N.mat4Identity(zeros(16)), T, J, I };
    const [first, ...rest] = factors(order).map(name => parts[name]);
    const product = rest.reduce((before, m) => N.mat4Mul(zeros(16), before, m), first);
    made.push({ ...parts, product, M: order === 'transposed' ? N.mat4Transpose(zeros(16), product) : product });
  });
  return made;
}

/** Row r of a matrix. */
export function row(m: Matrix, r: number): Matrix {
  const rows = zeros(16);
  N.mat4ToRowMajor(m, rows);
  return rows.slice(4 * r, 4 * r + 4);
}
