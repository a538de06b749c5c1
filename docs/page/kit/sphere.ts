// SPDX-License-Identifier: MIT
// The unit sphere, and curves on it.
import { colour } from './colours';
import type { View } from './eye';
import { line, path, type Shape } from './picture';

type Context = CanvasRenderingContext2D;

/** A closed curve from the cosine and the sine of 0 to 360 degrees. */
export const ring = (point: (c: number, s: number) => number[]) => Array.from({ length: 73 }, (_, i) =>
  point(Math.cos((i * Math.PI) / 36), Math.sin((i * Math.PI) / 36)));
const rings = [ring((c, s) => [c, 0, s]), ring((c, s) => [c, s, 0]), ring((c, s) => [0, c, s])];

/** Three great circles. */
export function globe(c: Context, view: View) {
  c.strokeStyle = colour('line');
  c.lineWidth = 1;
  for (const points of rings) {
    path(c, points.map(view.project));
    c.stroke();
  }
}

/** A curve in pieces, which things in space hide and are hidden by. */
export const curve = (c: Context, view: View, points: number[][], style: string, width: number): Shape[] =>
  points.slice(1).map((p, i) => line(c, view, points[i], p, style, width));
