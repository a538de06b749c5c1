// SPDX-License-Identifier: MIT
// The things in space: floor, dart, shadow, axes, lines, painted from far to near.
import * as N from 'nakawari/all';
import { colour } from './colours';
import type { Point, View } from './eye';

export interface Shape { distance: number; paint(): void }
type Context = CanvasRenderingContext2D;

export function path(c: Context, points: (Point | undefined)[], closed = false) {
  c.beginPath();
  let pen = false;
  for (const p of points) {
    if (p && pen)
      c.lineTo(p.x, p.y);
    else if (p)
      c.moveTo(p.x, p.y);
    pen = !!p;
  }
  if (closed)
    c.closePath();
}

/** The path of a circle, in pixels. */
export function circle(c: Context, { x, y }: Point, radius: number) {
  c.beginPath();
  c.arc(x, y, radius, 0, 2 * Math.PI);
}

/* ---- the floor ---- */

/** Tiles of one unit, paler with the distance. */
export function floor(c: Context, view: View, aim: number[]) {
  const { unit } = view, at = [0, 2].map(i => Math.round(aim[i] / unit / 2) * 2);
  c.fillStyle = colour('line');
  for (let x = at[0] - 12; x < at[0] + 12; x++)
    for (let z = at[1] - 12; z < at[1] + 12; z++) {
      const corners = [[x, z], [x, z + 1], [x + 1, z + 1], [x + 1, z]].map(([a, b]) =>
        view.project([a * unit, 0, b * unit]));
      const fade = 1.4 - view.distance([x * unit, 0, z * unit]) / unit / 10;
      if ((x + z) % 2 || fade <= 0 || corners.some(p => !p))
        continue;
      c.globalAlpha = 0.45 * Math.min(fade, 1);
      path(c, corners, true);
      c.fill();
    }
  c.globalAlpha = 1;
}

/* ---- the dart: nose at -z, fin at +y, one unit long ---- */

const corners = [[0, 0, -0.55], [-0.38, 0, 0.42], [0.38, 0, 0.42], [0, 0.14, 0.42], [0, -0.09, 0.42], [0, 0.08, 0],
  [0, 0.4, 0.34], [0, 0.4, 0.45]];
const body = [{ face: [0, 1, 3], part: 0 }, { face: [0, 3, 2], part: 1 }, { face: [0, 4, 1], part: 2 },
  { face: [0, 2, 4], part: 2 }, { face: [1, 4, 2, 3], part: 2 }];
const fin = { face: [5, 3, 7, 6], part: 3 };
const livery = [[240, 138, 36], [47, 127, 209], [106, 106, 120], [244, 211, 94]];
const nose = [232, 48, 79];
const lamp = [0.25, 0.9, 0.35];

const place = (m: number[], unit: number) => corners.map(v =>
  N.mat4TransformPoint([0, 0, 0], m, v.map(x => x * unit)));

const area = (p: Point[]) => p.reduce((sum, a, i) => {
  const b = p[(i + 1) % p.length];
  return sum + a.y * b.x - a.x * b.y;
}, 0);

function lit(rgb: number[], [a, b, d]: number[][]): string {
  const n = N.vec3Cross([0, 0, 0], N.vec3Sub([0, 0, 0], b, a), N.vec3Sub([0, 0, 0], d, a));
  const share = 0.84 + 0.16 * Math.max(N.vec3Dot(N.vec3Normalize(n, n), lamp), -0.8);
  return `rgb(${rgb.map(x => Math.round(x * share)).join(' ')})`;
}

function paintFace(c: Context, view: View, at: number[][], fill: string) {
  path(c, at.map(view.project), true);
  c.fillStyle = fill;
  c.fill();
  c.stroke();
}

/** The foremost quarter of a side has a colour of its own, so that the nose is seen. */
function paintSide(c: Context, view: View, at: number[][], part: number) {
  paintFace(c, view, at, lit(livery[part], at));
  if (at.length === 3)
    paintFace(c, view, [at[0], ...at.slice(1).map(p => N.vec3Lerp([0, 0, 0], at[0], p, 0.24))], lit(nose, at));
}

/** The body is convex, and the fin is outside the planes of both top faces: before the body if one of them is seen. */
export function dart(c: Context, view: View, m: number[], alpha = 1): Shape {
  const at = place(m, view.unit), on = at.map(view.project), centre = m.slice(12, 15);
  const paint = () => {
    if (on.some(p => !p))
      return;
    const seen = body.filter(({ face }) => area(face.map(i => on[i]!)) > 0), above = seen.some(({ part }) => part < 2);
    c.globalAlpha = alpha;
    c.strokeStyle = 'rgb(30 30 40 / 0.7)';
    c.lineWidth = 0.7;
    for (const { face, part } of above ? [...seen, fin] : [fin, ...seen])
      paintSide(c, view, face.map(i => at[i]), part);
    c.globalAlpha = 1;
  };
  return { distance: view.distance(centre), paint };
}

/** From a lamp at (0, 10, 0) to the floor, as in the exercise. */
export function shadow(c: Context, view: View, m: number[]) {
  const high = 10 * view.unit;
  const at = place(m, view.unit).map(([x, y, z]) => [(x * high) / (high - y), 0, (z * high) / (high - y)]);
  const on = at.map(view.project);
  if (on.some(p => !p) || m[13] >= high)
    return;
  c.beginPath();
  for (const { face } of [...body, fin]) {
    const points = face.map(i => on[i]!), list = area(points) > 0 ? points : points.reverse();
    list.forEach((p, i) => i ? c.lineTo(p.x, p.y) : c.moveTo(p.x, p.y));
    c.closePath();
  }
  c.fill();
}

/* ---- lines ---- */

export function line(c: Context, view: View, a: number[], b: number[], style: string, width: number): Shape {
  const middle = a.map((x, i) => (x + b[i]) / 2);
  const paint = () => {
    c.strokeStyle = style;
    c.lineWidth = width;
    path(c, [view.project(a), view.project(b)]);
    c.stroke();
  };
  return { distance: view.distance(middle), paint };
}

/** The three axes of a key, x y z. */
export function axes(c: Context, view: View, m: number[]): Shape[] {
  const centre = m.slice(12, 15);
  return [0, 1, 2].map(i => {
    const tip = centre.map((x, k) => x + 0.7 * view.unit * m[4 * i + k]);
    return line(c, view, centre, tip, colour('xyz'[i]), 2);
  });
}

/** A disc of `radius` pixels, as if `before` nearer to the eye. */
export function dot(c: Context, view: View, at: number[], style: string, radius = 3, before = 0.01 * view.unit): Shape {
  const paint = () => {
    const p = view.project(at);
    if (!p)
      return;
    circle(c, p, radius);
    c.fillStyle = style;
    c.fill();
  };
  return { distance: view.distance(at) - before, paint };
}

export const paintAll = (shapes: Shape[]) => shapes.sort((a, b) => b.distance - a.distance).forEach(s => s.paint());
