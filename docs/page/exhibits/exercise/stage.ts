// SPDX-License-Identifier: MIT
// The canvas: what it shows, and the mouse, the finger and the keyboard on it.
import * as N from 'nakawari/all';
import { colour } from '../../kit/colours';
import { element } from '../../kit/html';
import type { Room } from '../../shell/exhibit';
import { say } from '../../shell/text';
import { viewOf, type Point, type Ray, type View } from '../../kit/eye';
import { drag, gizmoOf, pick, ring, square, tip, type Gizmo, type Handle } from './gizmo';
import { keysOf, moved, range, replaceKey, turned, type Key, type State } from './model';
import { axes, dart, dot, floor, line, paintAll, path, shadow, type Shape } from '../../kit/picture';
import { matrices, matrixOf, timesOf, trace } from './sample';

const words = {
  canvas: {
    en: 'The key frames in space. Tab chooses the next key; arrow keys, page up and page down move it, with Shift they turn it.',
    ja: '空間のキーフレーム。Tab キーで次のキーを選び、矢印キーと PageUp / PageDown で移動、Shift を加えると回転します。',
  },
};

export const steps = { move: 0.1, turn: 5 };
const matrixAt = ({ position, orientation }: Key) =>
  N.mat4FromMat3(Array<number>(16).fill(0), N.mat3FromQuat(Array<number>(9).fill(0), orientation), position);

export function stage(room: Room<State>) {
  const canvas = element('canvas', { class: 'space', tabindex: '0', role: 'application', 'aria-label': say(words.canvas) });
  Object.assign(canvas.style, { touchAction: 'none', width: '100%', height: '100%', minHeight: '20rem', display: 'block' });
  room.stage.append(canvas);
  const c = canvas.getContext('2d')!;
  const size = () => ({ width: canvas.clientWidth, height: canvas.clientHeight });
  const view = () => viewOf(room.state, size().width, size().height);
  let active: Handle | undefined;

  const gizmo = (keys: Key[], eye: View): Gizmo | undefined => {
    const key = keys[room.state.selected];
    return key && !room.clock.playing
      ? gizmoOf(key, eye, room.state.local, Math.min(90, 0.2 * Math.min(eye.width, eye.height))) : undefined;
  };

  room.draw(() => {
    const { width, height } = size(), ratio = devicePixelRatio || 1;
    if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio))
      [canvas.width, canvas.height] = [Math.round(width * ratio), Math.round(height * ratio)];
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    c.clearRect(0, 0, width, height);
    const eye = view(), keys = keysOf(room.state), handles = gizmo(keys, eye);
    drawScene(c, eye, keys, room.state, room.clock.playing);
    if (handles)
      drawGizmo(c, eye, handles, active);
    // For tests: the pixels of the keys and of the tips of the arrows.
    canvas.dataset.keys = JSON.stringify(keys.map(key => eye.project(key.position)));
    canvas.dataset.arrows = JSON.stringify(handles ? [0, 1, 2].map(i => eye.project(tip(handles, i))) : []);
  });
  pointers(room, canvas, view, gizmo, handle => { active = handle; });
  keyboard(room, canvas);
}

/* ---- drawing ---- */

function curve(c: CanvasRenderingContext2D, eye: View, keys: Key[], state: State): Shape[] {
  const { start, end } = range(keys), red = colour('c1') || 'crimson';
  const margin = state.program ? 0.5 : 0;
  const points = matrices(keys, timesOf(start - margin, end + margin, Math.max((end - start) / 300, 0.02)), state)
    .map(m => m.slice(12, 15));
  c.strokeStyle = colour('soft') || 'gray';
  c.lineWidth = 1.5;
  path(c, points.map(([x, , z]) => eye.project([x, 0, z])));
  c.stroke();
  const every = matrices(keys, timesOf(start, end, Math.max(0.2, (end - start) / 200)), state);
  return [
    ...points.slice(1).map((p, i) => line(c, eye, points[i], p, red, 2)),
    ...every.map(m => dot(c, eye, m.slice(12, 15), red)),
  ];
}

function drawScene(c: CanvasRenderingContext2D, eye: View, keys: Key[], state: State, playing: boolean) {
  const { start, end } = range(keys), all = state.view === 'frames';
  const frames = all ? matrices(keys, timesOf(start, end, Math.max(0.2, (end - start) / 200)), state) : [];
  const showsKeys = !playing || state.view !== 'plain', placed = showsKeys ? keys.map(matrixAt) : [];
  const t = trace(keys, state.time, state), now = t && matrixOf(t);
  floor(c, eye, state.aim);
  c.fillStyle = 'rgb(20 24 36 / 0.35)';
  [...frames, ...placed, ...(now ? [now] : [])].forEach(m => shadow(c, eye, m));
  const shapes = [
    ...(state.view === 'trajectory' ? curve(c, eye, keys, state) : []),
    ...frames.map(m => dart(c, eye, m, 0.45)),
    ...placed.map(m => dart(c, eye, m, 0.7)),
    ...(now ? [dart(c, eye, now)] : []),
  ];
  const cross = placed.flatMap(m => axes(c, eye, m));
  paintAll(state.axes ? shapes : [...shapes, ...cross]);
  if (state.axes)
    paintAll(cross);
  if (showsKeys)
    labels(c, eye, keys, state.selected);
}

function labels(c: CanvasRenderingContext2D, eye: View, keys: Key[], selected: number) {
  c.textAlign = 'center';
  keys.forEach(({ position }, k) => {
    const p = eye.project(position);
    if (!p)
      return;
    c.font = `${k === selected ? 'bold ' : ''}15px system-ui, sans-serif`;
    c.lineWidth = 4;
    c.strokeStyle = colour('paper') || 'white';
    c.fillStyle = colour('ink') || 'black';
    c.strokeText(String(k), p.x, p.y - 14);
    c.fillText(String(k), p.x, p.y - 14);
  });
}

function drawGizmo(c: CanvasRenderingContext2D, eye: View, g: Gizmo, active: Handle | undefined) {
  const centre = eye.project(g.centre);
  for (let i = 0; centre && i < 3; i++) {
    const is = (kind: string) => active?.kind === kind && active.axis === i;
    c.strokeStyle = c.fillStyle = colour('xyz'[i]) || ['#d33', '#2a2', '#36d'][i];
    c.globalAlpha = is('plane') ? 0.9 : 0.45;
    path(c, square(g, i).map(eye.project), true);
    c.fill();
    const end = eye.project(tip(g, i)), points = ring(g, i, eye.position);
    for (let k = 1; k < points.length; k++) {
      const front = points[k].front && points[k - 1].front;
      c.globalAlpha = front ? 1 : 0.2;
      c.lineWidth = is('ring') ? 5 : 2.5;
      path(c, [eye.project(points[k - 1].at), eye.project(points[k].at)]);
      c.stroke();
    }
    c.globalAlpha = 1;
    c.lineWidth = is('axis') ? 6 : 3;
    path(c, [centre, end]);
    c.stroke();
    if (end)
      c.fillRect(end.x - 5, end.y - 5, 10, 10);
  }
}

/* ---- mouse and fingers ---- */

/** The camera turns one degree a pixel, as in the exercise. */
function orbit(state: State, dx: number, dy: number): Partial<State> {
  const yaw = N.wrap(state.yaw - dx, 360);
  return { yaw, pitch: Math.min(Math.max(state.pitch - dy, -90), 90) };
}
const approach = (state: State, by: number): Partial<State> =>
  ({ distance: Math.min(Math.max(state.distance + by, 2), 100) });

interface Grab { handle: Handle; key: Key; gizmo: Gizmo; from: Ray }

function pointers(room: Room<State>, canvas: HTMLCanvasElement, view: () => View,
  gizmoAt: (keys: Key[], eye: View) => Gizmo | undefined, show: (handle: Handle | undefined) => void) {
  const down = new Map<number, Point>();
  let grab: Grab | undefined, button = 0;
  const at = (e: MouseEvent): Point => {
    const box = canvas.getBoundingClientRect();
    return { x: e.clientX - box.left, y: e.clientY - box.top };
  };
  const hit = (p: Point, eye: View, reach: number): number => {
    const far = keysOf(room.state).map(key => eye.project(key.position))
      .map(q => q ? Math.hypot(q.x - p.x, q.y - p.y) : Infinity);
    const least = Math.min(...far);
    return least <= reach ? far.indexOf(least) : -1;
  };
  const choose = (p: Point, eye: View, reach: number) => {
    const k = hit(p, eye, reach);
    if (k >= 0)
      room.set(k === room.state.selected ? { local: !room.state.local } : { selected: k });
  };
  const start = (e: PointerEvent) => {
    const p = at(e), eye = view(), keys = keysOf(room.state), handles = gizmoAt(keys, eye);
    const touch = e.pointerType === 'touch', handle = handles && pick(p, handles, eye, touch ? 20 : 9);
    if (handle && hit(p, eye, 7) !== room.state.selected)
      grab = { handle, key: keys[room.state.selected], gizmo: handles, from: eye.ray(p) };
    else
      choose(p, eye, touch ? 32 : 24);
    show(grab?.handle);
    room.refresh();
  };
  canvas.addEventListener('pointerdown', e => {
    canvas.focus();
    canvas.setPointerCapture(e.pointerId);
    down.set(e.pointerId, at(e));
    button = e.button;
    if (down.size > 1)
      grab = undefined;
    else if (button === 0)
      start(e);
  });
  canvas.addEventListener('pointermove', e => {
    const before = down.get(e.pointerId), p = at(e);
    if (!before)
      return;
    const keys = keysOf(room.state), eye = view();
    down.set(e.pointerId, p);
    if (grab) {
      const next = drag(grab.key, grab.gizmo, grab.handle, grab.from, eye.ray(p), e.shiftKey);
      room.set(replaceKey(keys, room.state.selected, next) ?? {});
    } else if (button === 1) {
      room.set(approach(room.state, 0.2 * (p.y - before.y)));
    } else if (down.size > 1) {
      const other = [...down].find(([id]) => id !== e.pointerId)![1];
      const closer = Math.hypot(p.x - other.x, p.y - other.y) - Math.hypot(before.x - other.x, before.y - other.y);
      room.set({ ...orbit(room.state, (p.x - before.x) / 2, (p.y - before.y) / 2), ...approach(room.state, -0.02 * closer) });
    } else {
      room.set(orbit(room.state, p.x - before.x, p.y - before.y));
    }
  });
  const end = (e: PointerEvent) => {
    down.delete(e.pointerId);
    grab = undefined;
    show(undefined);
    room.refresh();
  };
  canvas.addEventListener('pointerup', end);
  canvas.addEventListener('pointercancel', end);
  canvas.addEventListener('contextmenu', e => e.preventDefault());
  canvas.addEventListener('wheel', e => {
    e.preventDefault();
    room.set(approach(room.state, 0.004 * e.deltaY));
  }, { passive: false });
}

/* ---- keyboard ---- */

const directions: Record<string, number[]> = {
  ArrowRight: [1, 0, 0], ArrowLeft: [-1, 0, 0], PageUp: [0, 1, 0], PageDown: [0, -1, 0], ArrowDown: [0, 0, 1],
  ArrowUp: [0, 0, -1],
};
const spins: Record<string, number[]> = {
  ArrowLeft: [0, 1, 0], ArrowRight: [0, -1, 0], ArrowUp: [1, 0, 0], ArrowDown: [-1, 0, 0], PageUp: [0, 0, 1],
  PageDown: [0, 0, -1],
};

function keyboard(room: Room<State>, canvas: HTMLCanvasElement) {
  canvas.addEventListener('keydown', e => {
    const { state } = room, keys = keysOf(state), key = keys[state.selected];
    const next = state.selected + (e.shiftKey ? -1 : 1), table = e.shiftKey ? spins : directions;
    if (e.key === 'Tab' && keys[next]) {
      e.preventDefault();
      room.set({ selected: next });
    } else if (e.key === 'Escape') {
      room.set({ selected: -1 });
    } else if (key && table[e.key]) {
      e.preventDefault();
      const by = table[e.key].map(x => x * steps.move * state.unit);
      const local = state.local ? N.quatRotate([0, 0, 0], key.orientation, by) : by;
      const change = e.shiftKey ? turned(key, table[e.key], N.radiansFromDegrees(steps.turn), state.local) : moved(key, local);
      room.set(replaceKey(keys, state.selected, change) ?? {});
    }
  });
}
