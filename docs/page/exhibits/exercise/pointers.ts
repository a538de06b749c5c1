// SPDX-License-Identifier: MIT
// The mouse and fingers on the canvas: they choose a key, drag its handles, and move the camera.
import * as N from 'nakawari/all';
import type { Point, Ray, View } from '../../kit/eye';
import { clamp } from '../../kit/values';
import type { Room } from '../../shell/exhibit';
import { drag, pick, type Gizmo, type Handle } from './gizmo';
import { keysOf, nextOperation, replaceKey, type Key, type State } from './model';

export interface Stage {
  room: Room<State>;
  canvas: HTMLCanvasElement;
  view(): View;
  /** The handles of the chosen key, if it shows them. */
  gizmo(): Gizmo | undefined;
  /** Shows a handle as the one at the pointer. */
  show(handle: Handle | undefined): void;
}

/* ---- the camera ---- */

/** One degree a pixel, as in the exercise. */
const orbit = ({ yaw, pitch }: State, dx: number, dy: number): Partial<State> =>
  ({ yaw: N.wrap(yaw - dx, 360), pitch: clamp(pitch - dy, -90, 90) });

const approach = ({ distance }: State, by: number): Partial<State> =>
  ({ distance: clamp(distance + by, 2, 100) });

/** Two fingers, of which one moves: the camera turns, and comes closer when they part. */
function pinch(state: State, before: Point, after: Point, other: Point): Partial<State> {
  const from = (p: Point) => Math.hypot(p.x - other.x, p.y - other.y);
  return {
    ...orbit(state, (after.x - before.x) / 2, (after.y - before.y) / 2),
    ...approach(state, -0.02 * (from(after) - from(before))),
  };
}

/* ---- keys and their handles ---- */

/** The key that is drawn nearest to a pixel, within `reach` pixels; or -1. */
function keyAt(keys: Key[], p: Point, eye: View, reach: number): number {
  const far = keys.map(key => eye.project(key.position)).map(q => q ? Math.hypot(q.x - p.x, q.y - p.y) : Infinity);
  const least = Math.min(...far);
  return least <= reach ? far.indexOf(least) : -1;
}

/** A key is chosen; another click on it is the next operation, or changes between the axes of world and object. */
const chosen = (state: State, k: number): Partial<State> =>
  k < 0 ? {} : k !== state.selected ? { selected: k } : state.clicks ? nextOperation(state) : { local: !state.local };

/** The handle at a pixel. The middle of the chosen key is left free for clicks. */
function handleAt({ room, view, gizmo }: Stage, p: Point, reach: number): Handle | undefined {
  const handles = gizmo(), eye = view();
  return handles && keyAt(keysOf(room.state), p, eye, 7) !== room.state.selected
    ? pick(p, handles, eye, reach) : undefined;
}

interface Grab { handle: Handle; key: Key; gizmo: Gizmo; from: Ray }

function dragged(state: State, { key, gizmo, handle, from }: Grab, to: Ray, snap: boolean): Partial<State> {
  return replaceKey(keysOf(state), state.selected, drag(key, gizmo, handle, from, to, snap)) ?? {};
}

/* ---- events ---- */

const pixelOf = (canvas: HTMLCanvasElement, e: MouseEvent): Point => {
  const box = canvas.getBoundingClientRect();
  return { x: e.clientX - box.left, y: e.clientY - box.top };
};

/** What the pointers that are down do: `press`, `move` and `release` one of them. */
function gestures(stage: Stage) {
  const { room, view, show } = stage, down = new Map<number, Point>();
  // `beside`: where a press met neither a key nor a handle, until it moves. A click there chooses none.
  let grab: Grab | undefined, beside: Point | undefined, button = 0;
  const begin = (p: Point, touch: boolean) => {
    const eye = view(), keys = keysOf(room.state), handle = handleAt(stage, p, touch ? 20 : 9);
    const key = keyAt(keys, p, eye, touch ? 32 : 24);
    beside = handle || key >= 0 ? undefined : p;
    if (handle)
      grab = { handle, key: keys[room.state.selected], gizmo: stage.gizmo()!, from: eye.ray(p) };
    else
      room.set(chosen(room.state, key));
    show(handle);
  };
  const moved = (e: PointerEvent, before: Point, p: Point): Partial<State> => {
    const other = [...down].find(([id]) => id !== e.pointerId)?.[1];
    return grab ? dragged(room.state, grab, view().ray(p), e.shiftKey)
      : button === 1 ? approach(room.state, 0.2 * (p.y - before.y))
      : other ? pinch(room.state, before, p, other)
      : orbit(room.state, p.x - before.x, p.y - before.y);
  };
  return {
    press(e: PointerEvent, p: Point) {
      down.set(e.pointerId, p);
      button = e.button;
      if (down.size > 1)
        grab = beside = undefined;
      else if (button === 0)
        begin(p, e.pointerType === 'touch');
    },
    move(e: PointerEvent, p: Point) {
      const before = down.get(e.pointerId);
      if (!before)
        return show(handleAt(stage, p, 9));
      down.set(e.pointerId, p);
      if (beside && Math.hypot(p.x - beside.x, p.y - beside.y) > 4)
        beside = undefined;
      room.set(moved(e, before, p));
    },
    release(e: PointerEvent) {
      down.delete(e.pointerId);
      if (beside && e.type === 'pointerup')
        room.set({ selected: -1 });
      grab = beside = undefined;
      show(undefined);
    },
  };
}

export function pointers(stage: Stage) {
  const { room, canvas } = stage, { press, move, release } = gestures(stage);
  canvas.addEventListener('pointerdown', e => {
    canvas.focus();
    canvas.setPointerCapture(e.pointerId);
    press(e, pixelOf(canvas, e));
  });
  canvas.addEventListener('pointermove', e => move(e, pixelOf(canvas, e)));
  canvas.addEventListener('pointerup', release);
  canvas.addEventListener('pointercancel', release);
  canvas.addEventListener('contextmenu', e => e.preventDefault());
  canvas.addEventListener('wheel', e => {
    e.preventDefault();
    room.set(approach(room.state, 0.004 * e.deltaY));
  }, { passive: false });
}
