// SPDX-License-Identifier: MIT
// Three gimbals in the six orders, and an object that passes near the pole of an order.
import * as N from 'nakawari/all';
import type { Turn } from '../../kit/space';
import { zeros } from '../../kit/values';

export const orders = ['XYZ', 'XZY', 'YXZ', 'YZX', 'ZXY', 'ZYX'] as const;
export type Order = typeof orders[number];
export const letters = ['x', 'y', 'z'] as const;

export interface State extends Turn {
  order: Order;
  by: 'angles' | 'pass';
  /** The angles in degrees; during the pass they follow it. */
  x: number; y: number; z: number;
  miss: number;
  time: number;
}

export const seconds = 2;
/** Degrees per second about the middle axis during the pass. */
export const passSpeed = 60;
/** How far the object has turned about the middle axis, in degrees. */
export const turnAt = (time: number) => 90 + passSpeed * (time - seconds / 2);

export const unit = (i: number) => [0, 1, 2].map(k => k === i ? 1 : 0);
/** The axes of the three gimbals in their own frames, from the outermost. */
export const axesOf = (order: Order) => [...order].map(letter => 'XYZ'.indexOf(letter));
export const euler = (order: Order) => orders.indexOf(order) as N.EulerOrder;
export const degrees = (angles: number[]) => angles.map(N.degreesFromRadians);
const quat = (angles: number[], order: Order) => N.quatFromEuler(zeros(4), angles, euler(order));

/** An orientation of the pass: a turn about the middle axis, after one of `miss` degrees about the outer axis. */
function passing({ order, miss }: State, time: number): number[] {
  const [i, j] = axesOf(order), about = (axis: number, angle: number) =>
    N.quatFromAxisAngle(zeros(4), unit(axis), N.radiansFromDegrees(angle));
  return N.quatMul(zeros(4), about(j, turnAt(time)), about(i, miss));
}

export interface Pose { angles: number[]; q: number[] }

export function poseOf(state: State): Pose {
  const { order, by, x, y, z, time } = state;
  if (by === 'pass') {
    const q = passing(state, time);
    return { q, angles: N.eulerFromQuat(zeros(3), q, euler(order)) };
  }
  const angles = [x, y, z].map(N.radiansFromDegrees);
  return { angles, q: quat(angles, order) };
}

/** The frames in which the gimbals are, from the outermost: each one turns by its angle in the frame before it. */
function framesOf(angles: number[], order: Order): number[][] {
  const axes = axesOf(order);
  return [0, 1, 2, 3].map(n => quat(angles.map((angle, axis) => axes.slice(0, n).includes(axis) ? angle : 0), order));
}

/** For each gimbal its axis, and the axis that it carries. */
export function gimbalsOf(angles: number[], order: Order) {
  const frames = framesOf(angles, order), axes = axesOf(order);
  const turned = (n: number, axis: number) => N.quatRotate(zeros(3), frames[n], unit(axis));
  return axes.map((axis, n) => ({ axis: turned(n, axis), carries: turned(n + 1, axes[(n + 1) % 3]) }));
}

/** The speeds x y z, in degrees per second, at which the angles change during the pass: w = sum of speed times axis. */
export function speedsOf({ order }: State, angles: number[]): number[] {
  const [outer, middle, inner] = gimbalsOf(angles, order).map(gimbal => gimbal.axis), axes = axesOf(order);
  const w = N.vec3Scale(zeros(3), unit(axes[1]), passSpeed);
  const along = (axis: number[], across: number[]) => Math.fround(N.vec3Dot(w, across) / N.vec3Dot(axis, across));
  const speeds = [along(outer, N.vec3Cross(zeros(3), middle, inner)), N.vec3Dot(w, middle),
    along(inner, N.vec3Cross(zeros(3), outer, middle))];
  return [0, 1, 2].map(axis => speeds[axes.indexOf(axis)]);
}

/** At the pole itself the speeds are not finite. */
export const hasSpeeds = (state: State) =>
  state.by === 'pass' && inOrder(poseOf(state).q, state.order).distance > 0.01;

/** The angles of an orientation in an order, in degrees, and how far the middle one is from 90 or -90. */
export function inOrder(q: number[], order: Order): { angles: number[]; distance: number } {
  const angles = degrees(N.eulerFromQuat(zeros(3), q, euler(order)));
  return { angles, distance: Math.fround(90 - Math.abs(angles[axesOf(order)[1]])) };
}

const steps = 480;
export const times = Array.from({ length: steps + 1 }, (_, i) => (seconds * i) / steps);

/** The angles of the pass in degrees, continued from one to the next, and as the library returns them. */
export function passOf(state: State): number[][] {
  const all = times.flatMap(time => N.eulerFromQuat(zeros(3), passing(state, time), euler(state.order)));
  const filtered = zeros(all.length);
  N.eulerFilter(all, times.length, euler(state.order), filtered);
  return [filtered, all].flatMap(angles =>
    [0, 1, 2].map(axis => times.map((_, i) => N.degreesFromRadians(angles[3 * i + axis]))));
}

/* ---- changes ---- */

const wrapped = (angle: number) => +(N.wrap(angle + 180, 360) - 180).toFixed(2);
export const withAngles = ([x, y, z]: number[]): Partial<State> => ({ x: wrapped(x), y: wrapped(y), z: wrapped(z) });

/** The middle angle at its pole, or as far from it as it can be. */
export function withMiddle(state: State, atPole: boolean): Partial<State> {
  const angles = degrees(poseOf(state).angles), middle = axesOf(state.order)[1];
  angles[middle] = !atPole ? 0 : angles[middle] < 0 ? -90 : 90;
  return { by: 'angles', ...withAngles(angles) };
}

/** Another order; the object stays where it is. During the pass, it passes the pole of the other order. */
export const withOrder = (state: State, order: Order): Partial<State> =>
  state.by === 'pass' ? { order } : { order, ...withAngles(inOrder(poseOf(state).q, order).angles) };
