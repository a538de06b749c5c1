// SPDX-License-Identifier: MIT
// What the canvas shows: the floor, the keys, the path or all frames, the object, the handles of the chosen key.
import * as N from 'nakawari/all';
import { colour } from '../../kit/colours';
import type { View } from '../../kit/eye';
import { object, objectShadow } from '../../kit/object';
import { axes, dart, dot, floor, line, paintAll, path, shadow, type Shape } from '../../kit/picture';
import { zeros } from '../../kit/values';
import { ring, square, tip, type Gizmo, type Handle } from './gizmo';
import { keysOf, range, memoized, type Key, type State } from './model';
import { ownObject } from './object';
import { matricesOf, matrixOf, trace, type Methods } from './sample';

type Context = CanvasRenderingContext2D;

const matrixAt = ({ position, orientation }: Key) =>
  N.mat4FromMat3(zeros(16), N.mat3FromQuat(zeros(9), orientation), position);

/* ---- what changes with the keys and the methods only ---- */

/** The first time, then every `step` seconds, and the last. */
function timesOf(start: number, end: number, step: number): number[] {
  const count = Math.ceil((end - start) / step - 1e-6);
  return Array.from({ length: count + 1 }, (_, i) => Math.fround(Math.min(start + i * step, end)));
}

const samples = <R>(f: (keys: Key[], methods: Methods) => R) => {
  const kept = memoized((keys: Key[], position: Methods['position'], orientation: Methods['orientation'],
    program: boolean) => f(keys, { position, orientation, program }));
  return (keys: Key[], { position, orientation, program }: Methods) => kept(keys, position, orientation, program);
};

/** The matrices every 0.2 s, the step of the exercise. */
const framesOf = samples((keys, methods) => {
  const { start, end } = range(keys);
  return matricesOf(keys, timesOf(start, end, Math.max(0.2, (end - start) / 200)), methods);
});

/** The points of the path. By the rules of the program it is longer than the keys: Bézier is not clamped. */
const pathOf = samples((keys, methods) => {
  const { start, end } = range(keys), margin = methods.program ? 0.5 : 0;
  const times = timesOf(start - margin, end + margin, Math.max((end - start) / 300, 0.02));
  return matricesOf(keys, times, methods).map(m => m.slice(12, 15));
});

const placesOf = memoized((keys: Key[]) => keys.map(matrixAt));

/* ---- the scene ---- */

function trajectory(c: Context, eye: View, keys: Key[], state: State): Shape[] {
  const points = pathOf(keys, state), style = colour('c1');
  c.strokeStyle = colour('soft');
  c.lineWidth = 1.5;
  path(c, points.map(([x, , z]) => eye.project([x, 0, z])));
  c.stroke();
  return [
    ...points.slice(1).map((p, i) => line(c, eye, points[i], p, style, 2)),
    ...framesOf(keys, state).map(m => dot(c, eye, m.slice(12, 15), style)),
  ];
}

/** The dart, or the model of a file, and their shadows. */
const body = (c: Context, eye: View, m: number[], alpha?: number) => {
  const own = ownObject();
  return own ? object(c, eye, m, own.model, alpha) : dart(c, eye, m, alpha);
};
const bodyShadow = (c: Context, eye: View, m: number[]) => {
  const own = ownObject();
  return own ? objectShadow(c, eye, m, own.model) : shadow(c, eye, m);
};

export function drawScene(c: Context, eye: View, state: State, playing: boolean) {
  const keys = keysOf(state), showsKeys = !playing || state.view !== 'plain';
  const frames = state.view === 'frames' ? framesOf(keys, state) : [], placed = showsKeys ? placesOf(keys) : [];
  const t = trace(keys, state.time, state), now = t ? [matrixOf(t)] : [];
  floor(c, eye, state.aim);
  c.fillStyle = 'rgb(20 24 36 / 0.35)';
  [...frames, ...placed, ...now].forEach(m => bodyShadow(c, eye, m));
  const shapes = [
    ...(state.view === 'trajectory' ? trajectory(c, eye, keys, state) : []),
    ...frames.map(m => body(c, eye, m, 0.45)),
    ...placed.map(m => body(c, eye, m, 0.7)),
    ...now.map(m => body(c, eye, m)),
  ];
  const crosses = placed.flatMap(m => axes(c, eye, m));
  paintAll(state.axes ? shapes : [...shapes, ...crosses]);
  if (state.axes)
    paintAll(crosses);
  if (showsKeys)
    drawNumbers(c, eye, keys, state.selected);
}

function drawNumbers(c: Context, eye: View, keys: Key[], selected: number) {
  c.textAlign = 'center';
  c.lineWidth = 4;
  c.strokeStyle = colour('paper');
  c.fillStyle = colour('ink');
  keys.forEach(({ position }, k) => {
    const p = eye.project(position);
    if (!p)
      return;
    c.font = `${k === selected ? 'bold 18px' : '15px'} system-ui, sans-serif`;
    c.strokeText(String(k), p.x, p.y - 14);
    c.fillText(String(k), p.x, p.y - 14);
  });
}

/* ---- the handles ---- */

function drawRing(c: Context, eye: View, g: Gizmo, axis: number, width: number) {
  const points = ring(g, axis, eye.position);
  c.lineWidth = width;
  points.slice(1).forEach((p, i) => {
    c.globalAlpha = p.front && points[i].front ? 1 : 0.2;
    path(c, [eye.project(points[i].at), eye.project(p.at)]);
    c.stroke();
  });
  c.globalAlpha = 1;
}

function drawArrow(c: Context, eye: View, g: Gizmo, axis: number, width: number) {
  const end = eye.project(tip(g, axis)), half = width + 2;
  c.lineWidth = width;
  path(c, [eye.project(g.centre), end]);
  c.stroke();
  if (end)
    c.fillRect(end.x - half, end.y - half, 2 * half, 2 * half);
}

export function drawGizmo(c: Context, eye: View, g: Gizmo, active: Handle | undefined) {
  for (let axis = 0; axis < 3; axis++) {
    const is = (kind: Handle['kind']) => active?.kind === kind && active.axis === axis;
    c.strokeStyle = c.fillStyle = colour('xyz'[axis]);
    if (g.kinds.includes('plane')) {
      c.globalAlpha = is('plane') ? 0.9 : 0.45;
      path(c, square(g, axis).map(eye.project), true);
      c.fill();
      c.globalAlpha = 1;
    }
    if (g.kinds.includes('ring'))
      drawRing(c, eye, g, axis, is('ring') ? 5 : 2.5);
    if (g.kinds.includes('axis'))
      drawArrow(c, eye, g, axis, is('axis') ? 6 : 3);
  }
}
