// SPDX-License-Identifier: MIT
// A model of triangles as a thing in space. A tree of planes sorts it from every eye, as src/draw/object.c does.
// Source: Fuchs, Kedem, Naylor, On visible surface generation by a priori tree structures, 1980.
import { colour } from './colours';
import type { Point, View } from './eye';
import { path, type Shape } from './picture';

type Vector = number[];
/** Counter-clockwise seen from outside; red, green, blue are 0 to 255. */
export interface Triangle { corners: Vector[]; rgb: number[] }
interface Node extends Triangle { normal: Vector; offset: number; front?: Node; back?: Node }
/** Its nose at -z, its top at +y, its longest side 1. */
export interface Model { root: Node; nodes: Node[] }

/** Of a model whose longest side is 1: what is nearer to a plane is in it. */
const thickness = 1e-6;
/** The most triangles that cuts add. After them a triangle is where its middle is: large models have small triangles. */
const cutsMost = 1000;

const dot = (a: Vector, b: Vector) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const sub = (a: Vector, b: Vector) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const cross = (a: Vector, b: Vector) =>
  [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/* ---- the size and the tree ---- */

/** The triangles with the middle of their box at the origin and its longest side 1; none if they have no size. */
function fitted(triangles: Triangle[]): Triangle[] {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (const { corners } of triangles)
    for (const p of corners)
      for (let i = 0; i < 3; i++)
        [low[i], high[i]] = [Math.min(low[i], p[i]), Math.max(high[i], p[i])];
  const side = Math.max(...sub(high, low));
  if (!(side > 1e-30 && side < 1e30))
    return [];
  const place = (p: Vector) => p.map((x, i) => (x - (low[i] + high[i]) / 2) / side);
  return triangles.map(({ corners, rgb }) => ({ corners: corners.map(place), rgb }));
}

function nodeOf({ corners, rgb }: Triangle): Node | undefined {
  const [a, b, c] = corners, n = cross(sub(b, a), sub(c, a)), length = Math.hypot(...n);
  if (!(length > 1e-12))
    return undefined;
  const normal = n.map(x => x / length);
  return { corners, rgb, normal, offset: dot(normal, a) };
}

/** The part of a triangle on one side (sign 1 or -1) of a plane, d from its corners: up to two triangles. */
function partsOf(node: Node, d: number[], sign: number): Node[] {
  const on: Vector[] = [];
  node.corners.forEach((p, i) => {
    const k = (i + 1) % 3, q = node.corners[k], t = d[i] / (d[i] - d[k]);
    if (sign * d[i] >= -thickness)
      on.push(p);
    if (Math.min(d[i], d[k]) < -thickness && Math.max(d[i], d[k]) > thickness)
      on.push(p.map((x, j) => x + t * (q[j] - x)));
  });
  return on.slice(2).map((p, i) => ({ ...node, corners: [on[0], on[i + 1], p] }));
}

function insert(model: Model, plane: Node, node: Node, most: number): void {
  const below = (at: Node, side: 'front' | 'back', part: Node): void => {
    if (at[side])
      return insert(model, at[side]!, part, most);
    at[side] = part;
    model.nodes.push(part);
  };
  for (;;) {
    const d = node.corners.map(p => dot(plane.normal, p) - plane.offset), low = Math.min(...d), high = Math.max(...d);
    if (low < -thickness && high > thickness && model.nodes.length < most) {
      partsOf(node, d, 1).forEach(part => below(plane, 'front', part));
      return partsOf(node, d, -1).forEach(part => below(plane, 'back', part));
    }
    const side = Math.min(low, 0) + Math.max(high, 0) >= 0 ? 'front' : 'back', next = plane[side];
    if (!next)
      return below(plane, side, node);
    plane = next;
  }
}

/** Undefined if all triangles are lines or points. */
export function modelOf(triangles: Triangle[]): Model | undefined {
  const [root, ...rest] = fitted(triangles).map(nodeOf).filter(node => node !== undefined);
  if (!root)
    return undefined;
  const model: Model = { root, nodes: [root] };
  rest.forEach(node => insert(model, root, node, triangles.length + cutsMost));
  return model;
}

/** Calls `visit` with each node from far to near, and whether its front is seen. `eye` is in the model's space. */
function visitAll(root: Node, eye: Vector, visit: (node: Node) => void) {
  const waiting: Node[] = [];
  let at: Node | undefined = root;
  while (at || waiting.length) {
    const node: Node = at ?? waiting.pop()!, seen = dot(node.normal, eye) > node.offset;
    if (at) {
      waiting.push(node);
      at = seen ? node.back : node.front;
      continue;
    }
    if (seen)
      visit(node);
    at = seen ? node.front : node.back;
  }
}

/* ---- painting ---- */

const transform = (m: number[], unit: number, [x, y, z]: Vector): Vector => [0, 1, 2].map(i =>
  unit * (m[i] * x + m[4 + i] * y + m[8 + i] * z) + m[12 + i]);

/** A point of the world in the model's space; m is a rotation and a translation. */
const back = (m: number[], unit: number, p: Vector): Vector => {
  const q = sub(p, m.slice(12, 15));
  return [0, 4, 8].map(c => (m[c] * q[0] + m[c + 1] * q[1] + m[c + 2] * q[2]) / unit);
};

const lamp = [0.25, 0.9, 0.35];

/** The red, green and blue of a colour as #rrggbb. */
const channels = (text: string) => [1, 3, 5].map(i => parseInt(text.slice(i, i + 2), 16));

/** Triangles overlap, so alpha is a mixture with the paper. */
export function object(c: CanvasRenderingContext2D, view: View, m: number[], { root }: Model, alpha = 1): Shape {
  const paper = channels(colour('paper'));
  const paint = () => {
    c.lineWidth = 0.7;
    c.lineJoin = 'round';
    visitAll(root, back(m, view.unit, view.position), ({ corners, normal, rgb }) => {
      const on = corners.map(p => view.project(transform(m, view.unit, p)));
      if (on.some(p => !p))
        return;
      const light = 0.76 + 0.24 * Math.max(dot(sub(transform(m, 1, normal), m.slice(12, 15)), lamp), -0.8);
      const mixed = rgb.map((x, i) => Math.round(alpha * x * light + (1 - alpha) * paper[i]));
      c.fillStyle = c.strokeStyle = `rgb(${mixed.join(' ')})`;
      path(c, on, true);
      c.fill();
      c.stroke(); // closes the gap to the next triangle
    });
  };
  return { distance: view.distance(m.slice(12, 15)), paint };
}

/** From the lamp at (0, 10, 0) to the floor. */
export function objectShadow(c: CanvasRenderingContext2D, view: View, m: number[], { nodes }: Model) {
  const high = 10 * view.unit, { project } = view;
  if (m[13] >= high)
    return;
  const cast = (p: Vector) => {
    const [x, y, z] = transform(m, view.unit, p);
    return project([(x * high) / (high - y), 0, (z * high) / (high - y)]);
  };
  c.beginPath();
  for (const { corners } of nodes) {
    const on = corners.map(cast);
    if (on.every(p => p))
      outline(c, on as Point[]);
  }
  c.fill();
}

/** All in one direction, so that the shadows of triangles add up. */
function outline(c: CanvasRenderingContext2D, [a, b, d]: Point[]) {
  const turned = (b.x - a.x) * (d.y - a.y) < (b.y - a.y) * (d.x - a.x);
  c.moveTo(a.x, a.y);
  for (const { x, y } of turned ? [d, b] : [b, d])
    c.lineTo(x, y);
  c.closePath();
}
