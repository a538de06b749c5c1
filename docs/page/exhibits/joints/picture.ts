// SPDX-License-Identifier: MIT
// The capsule in the colours of its weights, its joints, the arcs of their angles, and the chosen vertex.
import * as N from 'nakawari/all';
import { colour } from '../../kit/colours';
import type { View } from '../../kit/eye';
import { circle, dot, line, path, type Shape } from '../../kit/picture';
import { mix, ramp, rgb, skinned, vertex } from '../../kit/skinned';
import type { Frame } from './frames';
import { faces, joints } from './mesh';
import { angles, type State } from './model';
import { chosen, type Skinned } from './skin';

type Context = CanvasRenderingContext2D;

/** The mean weight of a joint on a face. */
const share = (weights: Uint16Array, face: number, joint: number) =>
  faces[face].reduce((sum, v) => sum + weights[v * joints + joint], 0) / 65535 / faces[face].length;

/** The weight of the chosen joint by the ramp, or the joint of the largest weight, paler where others have a share. */
function colours(state: State, weights: Uint16Array): (face: number) => number[] {
  if (state.paint === 'one')
    return face => ramp(share(weights, face, state.joint));
  const all = Array.from({ length: joints }, (_, j) => j), own = all.map(j => rgb(`c${j}`)), pale = rgb('paper');
  return face => {
    const list = all.map(j => share(weights, face, j)), most = Math.max(...list);
    const strong = Math.min(1.25 * most - 0.2, 1);
    return mix([own[list.indexOf(most)], pale], [strong, 1 - strong]);
  };
}

const over = (shape: Shape) => ({ ...shape, distance: -1 });
const add = (p: number[], d: number[], length: number) => N.vec3AddScaled([0, 0, 0], p, d, length);

function bones(c: Context, view: View, state: State, now: Skinned, list: Frame[]): Shape[] {
  const ink = colour('ink');
  return [
    ...list.slice(1).map((f, i) => line(c, view, list[i].at, f.at, ink, 2)),
    ...list.flatMap(({ at }, i) => (['x', 'y', 'z'] as const).map((name, k) => line(c, view, at,
      add(at, N.mat4TransformDirection([0, 0, 0], now.list[i].M, [0, 1, 2].map(n => Number(n === k))), 0.3),
      colour(name), i === state.joint ? 4 : 2))),
    ...list.map(f => dot(c, view, f.at, ink)),
  ].map(over);
}

/** The sector from the direction without rotation to the present one. */
function sector(c: Context, view: View, f: Frame, angle: number, j: number, strong: boolean): Shape {
  const along = (share: number) => {
    const q = N.quatFromAxisAngle([0, 0, 0, 0], f.axis, angle * share);
    return view.project(add(f.at, N.quatRotate([0, 0, 0], q, f.zero), f.reach));
  };
  return over({ distance: 0, paint() {
    path(c, [view.project(f.at), ...Array.from({ length: 25 }, (_, i) => along(i / 24))], true);
    c.fillStyle = c.strokeStyle = colour(`c${j}`);
    c.lineWidth = strong ? 2.5 : 1.2;
    c.globalAlpha = strong ? 0.3 : 0.12;
    c.fill();
    c.globalAlpha = 1;
    c.stroke();
  } });
}

function floor(c: Context, view: View): Shape[] {
  const lines = [-2, -1, 0, 1, 2].flatMap(k => [[[k, 0, -2], [k, 0, 2]], [[-2, 0, k], [2, 0, k]]]);
  const style = colour('line');
  return lines.map(([a, b]) => ({ ...line(c, view, a, b, style, 1), distance: 1e6 }));
}

/** A dot with a rim, before everything else. */
function mark(c: Context, view: View, at: number[]): Shape {
  return { distance: -2, paint() {
    const p = view.project(at);
    if (!p)
      return;
    circle(c, p, 6);
    c.fillStyle = colour('c6');
    c.strokeStyle = colour('paper');
    c.lineWidth = 2;
    c.fill();
    c.stroke();
  } };
}

export function paint(c: Context, view: View, state: State, now: Skinned, list: Frame[]): Shape[] {
  const turns = angles(state);
  return [...floor(c, view), ...skinned(c, view, now.positions, faces, colours(state, now.weights)),
    ...list.map((f, j) => sector(c, view, f, turns[j], j, j === state.joint)), ...bones(c, view, state, now, list),
    mark(c, view, vertex(now.positions, chosen(state)))];
}
