// SPDX-License-Identifier: MIT
// The unit sphere, curves on it, and the object in it whose nose draws them.
import * as N from 'nakawari/all';
import { colour } from './colours';
import type { View } from './eye';
import { dart, path, type Shape } from './picture';
import { zeros } from './values';

type Context = CanvasRenderingContext2D;

interface Stroke {
  style: string;
  width: number;
  dashed?: boolean;
  /** Pieces behind it are paler (isBehind): 1 for the unit sphere, 0 for rings about the origin. */
  horizon?: number;
}

/** A closed curve from the cosine and the sine of 0 to 360 degrees. */
export const ring = (point: (c: number, s: number) => number[]) => Array.from({ length: 97 }, (_, i) =>
  point(Math.cos((i * Math.PI) / 48), Math.sin((i * Math.PI) / 48)));
const rings = [ring((c, s) => [c, 0, s]), ring((c, s) => [c, s, 0]), ring((c, s) => [0, c, s])];

/** Whether the unit sphere is before the point; with the horizon 0, whether the origin is nearer. */
export const isBehind = (view: View, p: number[], horizon = 1) =>
  p[0] * view.position[0] + p[1] * view.position[1] + p[2] * view.position[2] < horizon;

/** A curve in pieces, which things in space hide and are hidden by. Thin curves are above thick ones. */
export function curve(c: Context, view: View, points: number[][], stroke: Stroke): Shape[] {
  const { style, width, dashed, horizon = -Infinity } = stroke, size = 4, shapes: Shape[] = [];
  const pale = `color-mix(in srgb, ${style} 40%, ${colour('paper')})`;
  for (let i = 0; i + 1 < points.length; i += dashed ? 2 * size : size) {
    const piece = points.slice(i, i + size + 1), middle = piece[piece.length >> 1];
    const paint = () => {
      Object.assign(c, { lineWidth: width, lineCap: 'round', lineJoin: 'round',
        strokeStyle: isBehind(view, middle, horizon) ? pale : style });
      path(c, piece.map(view.project));
      c.stroke();
    };
    shapes.push({ distance: view.distance(middle) + 0.004 * width, paint });
  }
  return shapes;
}

/** The disc of the unit sphere, and three great circles. */
export function globe(c: Context, view: View) {
  const far = N.vec3Length(view.position), turn = N.quatFromVectors([0, 0, 0, 0], [0, 0, 1], view.position);
  const size = Math.sqrt(1 - 1 / far ** 2);
  path(c, ring((x, y) => N.quatRotate([0, 0, 0], turn, [size * x, size * y, 1 / far])).map(view.project), true);
  c.fillStyle = colour('ground');
  c.fill();
  for (const points of rings)
    curve(c, view, points, { style: colour('line'), width: 1, horizon: 1 }).forEach(shape => shape.paint());
}

/** Where the nose of an orientation is. */
export const nose = (q: number[]) => N.quatRotate(zeros(3), q, [0, 0, -1]);

/** The orientation turned by the shortest rotation that brings its nose to p. */
export const withNose = (q: number[], p: number[]) =>
  N.quatMul(zeros(4), N.quatFromVectors(zeros(4), nose(q), p), q);

/** The object in an orientation. */
export const object = (c: Context, view: View, q: number[], size: number, alpha = 1): Shape =>
  dart(c, view, N.mat4FromMat3(zeros(16), N.mat3FromQuatScale(zeros(9), q, [size, size, size]), [0, 0, 0]), alpha);

/** A straight arrow with a head of `head` pixels. */
export function arrow(c: Context, view: View, from: number[], to: number[], style: string, head = 9): Shape {
  const paint = () => {
    const [a, b] = [from, to].map(view.project);
    if (!a || !b)
      return;
    const angle = Math.atan2(b.y - a.y, b.x - a.x), wing = (turn: number) =>
      ({ x: b.x - head * Math.cos(angle + turn), y: b.y - head * Math.sin(angle + turn) });
    Object.assign(c, { strokeStyle: style, lineWidth: 2, lineCap: 'round' });
    path(c, [a, b, wing(0.45), undefined, b, wing(-0.45)]);
    c.stroke();
  };
  return { distance: view.distance(to), paint };
}
