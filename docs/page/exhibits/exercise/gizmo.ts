// SPDX-License-Identifier: MIT
// The handles of a key: three arrows move it along an axis, three squares in a plane, three rings turn it about an
// axis.
import * as N from 'nakawari/all';
import type { Eye, Point, Ray, View } from '../../kit/eye';
import { clamp, zeros } from '../../kit/values';
import { moved, turned, type Key } from './model';

type Kind = 'axis' | 'plane' | 'ring';
/** The axis, the axis that the plane is normal to, or the axis of the turn: 0 x, 1 y, 2 z. */
export interface Handle { kind: Kind; axis: number }

export interface Gizmo { centre: number[]; axes: number[][]; length: number; local: boolean; kinds: readonly Kind[] }

/** The handles of moves and of turns; those of both operations. */
export const kinds = { moves: ['axis', 'plane'], turns: ['ring'], all: ['axis', 'plane', 'ring'] } as const;

const add = (a: number[], b: number[]) => N.vec3Add(zeros(3), a, b);
const sub = (a: number[], b: number[]) => N.vec3Sub(zeros(3), a, b);
const scale = (a: number[], s: number) => N.vec3Scale(zeros(3), a, s);
const cross = (a: number[], b: number[]) => N.vec3Cross(zeros(3), a, b);
const dot = N.vec3Dot;
const unit = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];

/** The two other axes, so that axis, u, v are right-handed. */
export const others = (g: Gizmo, axis: number) => [g.axes[(axis + 1) % 3], g.axes[(axis + 2) % 3]];

export function gizmoOf(key: Key, eye: Eye, local: boolean, shown: readonly Kind[], pixels: number): Gizmo {
  const axes = local ? unit.map(v => N.quatRotate(zeros(3), key.orientation, v)) : unit;
  return { centre: key.position, axes, length: pixels * eye.pixel(key.position), local, kinds: shown };
}

/** Parts of the length: an arrow from 0 to 1, the square between these parts of its two axes, the radius of a ring. */
export const shape = { square: [0.3, 0.55], ring: 1.2 };

/** A point of the plane of the axis, by parts of the length along the other two axes. */
function inPlane(g: Gizmo, axis: number, a: number, b: number): number[] {
  const [u, v] = others(g, axis);
  return add(g.centre, add(scale(u, a * g.length), scale(v, b * g.length)));
}

export const tip = (g: Gizmo, axis: number) => add(g.centre, scale(g.axes[axis], g.length));

/** The corners of a square. */
export function square(g: Gizmo, axis: number): number[][] {
  const [a, b] = shape.square;
  return [[a, a], [b, a], [b, b], [a, b]].map(([x, y]) => inPlane(g, axis, x, y));
}

/** The points of a ring, and whether each is on the side of the eye. */
export function ring(g: Gizmo, axis: number, eye: number[], count = 48): { at: number[]; front: boolean }[] {
  const look = sub(eye, g.centre);
  return Array.from({ length: count + 1 }, (_, i) => {
    const angle = (2 * Math.PI * i) / count;
    const at = inPlane(g, axis, shape.ring * Math.cos(angle), shape.ring * Math.sin(angle));
    return { at, front: dot(sub(at, g.centre), look) >= -1e-3 * g.length };
  });
}

/** Pixels of each handle by its name, `kind axis`: the outer half of an arrow, a square's middle, a ring's front. */
export function grips(g: Gizmo, eye: View): Record<string, (Point | undefined)[]> {
  const middle = (shape.square[0] + shape.square[1]) / 2;
  const all: [Kind, number, (Point | undefined)[]][] = [0, 1, 2].flatMap(axis => [
    ['axis', axis, [0.6, 0.8, 0.95].map(s => eye.project(add(g.centre, scale(g.axes[axis], s * g.length))))],
    ['plane', axis, [eye.project(inPlane(g, axis, middle, middle))]],
    ['ring', axis, ring(g, axis, eye.position).filter(p => p.front).map(p => eye.project(p.at))],
  ]);
  return Object.fromEntries(all.filter(([kind]) => g.kinds.includes(kind))
    .map(([kind, axis, points]) => [`${kind} ${axis}`, points]));
}

/* ---- which handle is at a pixel ---- */

function toLine(p: Point, a: Point, b: Point): number {
  const dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const t = square > 0 ? clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0, 1) : 0;
  return Math.hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

/** The distance of a pixel from the lines between points of space. */
function toPath(p: Point, path: number[][], eye: Eye): number {
  const on = path.map(eye.project);
  return Math.min(Infinity, ...on.slice(1).map((b, i) => on[i] && b ? toLine(p, on[i]!, b) : Infinity));
}

function inside(p: Point, corners: number[][], eye: Eye): boolean {
  const c = corners.map(eye.project);
  if (c.some(q => !q))
    return false;
  const turn = c.map((a, i) => {
    const b = c[(i + 1) % c.length]!;
    return (b.x - a!.x) * (p.y - a!.y) - (b.y - a!.y) * (p.x - a!.x);
  });
  return turn.every(x => x >= 0) || turn.every(x => x <= 0);
}

function distance(p: Point, g: Gizmo, { kind, axis }: Handle, eye: Eye): number {
  if (kind === 'plane')
    return inside(p, square(g, axis), eye) ? 3 : Infinity;
  if (kind === 'axis')
    return toPath(p, [add(g.centre, scale(g.axes[axis], 0.25 * g.length)), tip(g, axis)], eye);
  const points = ring(g, axis, eye.ray(p).origin);
  return Math.min(...points.slice(1).map(({ at, front }, i) =>
    front && points[i].front ? toPath(p, [points[i].at, at], eye) : Infinity));
}

const handles: Handle[] = kinds.all.flatMap(kind => [0, 1, 2].map(axis => ({ kind, axis })));

/** The handle that is nearest to a pixel, within `reach` pixels. */
export function pick(p: Point, g: Gizmo, eye: Eye, reach: number): Handle | undefined {
  const found = handles.filter(({ kind }) => g.kinds.includes(kind)).map(handle => ({ handle, d: distance(p, g, handle, eye) })).sort((a, b) => a.d - b.d)[0];
  return found.d <= reach ? found.handle : undefined;
}

/* ---- dragging ---- */

/** How far along the axis the point is that is nearest to the ray. Undefined if they are nearly parallel. */
function alongAxis(g: Gizmo, axis: number, { origin, direction }: Ray): number | undefined {
  const a = g.axes[axis], w = sub(origin, g.centre), b = dot(a, direction), rest = 1 - b * b;
  return rest < 0.01 ? undefined : (dot(a, w) - b * dot(direction, w)) / rest;
}

function onPlane(g: Gizmo, axis: number, { origin, direction }: Ray, least: number): number[] | undefined {
  const n = g.axes[axis], slope = dot(n, direction);
  if (Math.abs(slope) < least)
    return undefined;
  const t = dot(n, sub(g.centre, origin)) / slope;
  return t > 0 ? add(origin, scale(direction, t)) : undefined;
}

function angleOf(g: Gizmo, axis: number, p: number[]): number {
  const [u, v] = others(g, axis), from = sub(p, g.centre);
  return Math.atan2(dot(v, from), dot(u, from));
}

/** The turn between two pixels. A ring that is seen from its side turns by the way along it. */
function turnBetween(g: Gizmo, axis: number, from: Ray, to: Ray): number {
  const [a, b] = [onPlane(g, axis, from, 0.2), onPlane(g, axis, to, 0.2)];
  if (a && b)
    return angleOf(g, axis, b) - angleOf(g, axis, a);
  const depth = dot(from.direction, sub(g.centre, from.origin)), along = cross(g.axes[axis], from.direction);
  return -depth * dot(sub(to.direction, from.direction), along) / (shape.ring * g.length);
}

const nearest = (x: number, step: number) => step > 0 ? Math.round(x / step) * step : x;

/** The key after a drag of a handle from one pixel to another; with `snap`, by whole steps of 0.1 and of 5 degrees. */
export function drag(key: Key, g: Gizmo, { kind, axis }: Handle, from: Ray, to: Ray, snap: boolean): Partial<Key> {
  if (kind === 'ring') {
    const step = snap ? N.radiansFromDegrees(5) : 0;
    return turned(key, unit[axis], nearest(turnBetween(g, axis, from, to), step), g.local);
  }
  if (kind === 'axis') {
    const [a, b] = [alongAxis(g, axis, from), alongAxis(g, axis, to)];
    return a === undefined || b === undefined ? {} : moved(key, scale(g.axes[axis], nearest(b - a, snap ? 0.1 : 0)));
  }
  const [a, b] = [onPlane(g, axis, from, 0.05), onPlane(g, axis, to, 0.05)];
  if (!a || !b)
    return {};
  const by = sub(b, a), [u, v] = others(g, axis).map(e => scale(e, nearest(dot(by, e), snap ? 0.1 : 0)));
  return moved(key, add(u, v));
}
