// SPDX-License-Identifier: MIT
// A canvas that shows things in space, from a camera that turns by a drag and by arrow keys.
import type { Room } from '../shell/exhibit';
import { number } from '../shell/state';
import { say, type Text } from '../shell/text';
import { viewOf, type View } from './eye';
import { element } from './html';
import { paintAll, path, type Shape } from './picture';

/** The fields of the state that a space has: the camera's angles in degrees. */
export interface Turn { yaw: number; pitch: number }
export const turnFields = (yaw: number, pitch: number) => ({ yaw: number(yaw), pitch: number(pitch, -90, 90) });

export interface SpaceOptions {
  /** What it shows, for screen readers. */
  label: Text;
  distance: number;
  aim?: number[];
  fov?: number;
  parent?: HTMLElement;
  /** Called for each drawing. The shapes that it returns are painted from far to near. */
  paint(c: CanvasRenderingContext2D, view: View): Shape[];
}

const keys: Record<string, [number, number]> = {
  ArrowLeft: [-5, 0], ArrowRight: [5, 0], ArrowUp: [0, -5], ArrowDown: [0, 5],
};

/** Calls `turn` with degrees for drags and arrow keys. */
function dragged(canvas: HTMLCanvasElement, turn: (yaw: number, pitch: number) => void) {
  let last: { x: number; y: number } | undefined;
  canvas.addEventListener('pointerdown', ({ pointerId, clientX: x, clientY: y }) => {
    canvas.setPointerCapture(pointerId);
    last = { x, y };
  });
  canvas.addEventListener('pointermove', ({ clientX: x, clientY: y }) => {
    if (last)
      turn(0.4 * (last.x - x), 0.4 * (last.y - y));
    last &&= { x, y };
  });
  for (const name of ['pointerup', 'pointercancel'])
    canvas.addEventListener(name, () => { last = undefined; });
  canvas.addEventListener('keydown', event => {
    const step = keys[event.key];
    if (step) {
      event.preventDefault();
      turn(...step);
    }
  });
}

/** The canvas; it is redrawn whenever the state changes. */
export function space<S extends Turn>(room: Room<S>, options: SpaceOptions): HTMLCanvasElement {
  const canvas = element('canvas',
    { class: 'space', tabindex: '0', role: 'application', 'aria-label': say(options.label) });
  (options.parent ?? room.stage).append(canvas);
  const c = canvas.getContext('2d')!;
  dragged(canvas, (yaw, pitch) => room.set({
    yaw: room.state.yaw + yaw, pitch: Math.min(Math.max(room.state.pitch + pitch, -90), 90) } as Partial<S>));
  room.draw(() => {
    const { clientWidth: width, clientHeight: height } = canvas, ratio = devicePixelRatio || 1;
    if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio))
      [canvas.width, canvas.height] = [Math.round(width * ratio), Math.round(height * ratio)];
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    c.clearRect(0, 0, width, height);
    const { yaw, pitch } = room.state;
    const view = viewOf({ yaw, pitch, distance: options.distance, fov: options.fov ?? 45, aim: options.aim ?? [0, 0, 0],
      unit: 1 }, width, height);
    paintAll(options.paint(c, view));
  });
  return canvas;
}

/** A polygon in one colour, with an outline. */
export function polygon(c: CanvasRenderingContext2D, view: View, corners: number[][], fill: string,
  outline = ''): Shape {
  const middle = [0, 1, 2].map(i => corners.reduce((sum, p) => sum + p[i], 0) / corners.length);
  const paint = () => {
    const on = corners.map(view.project);
    if (on.some(p => !p))
      return;
    path(c, on, true);
    c.fillStyle = fill;
    c.fill();
    if (outline) {
      c.strokeStyle = outline;
      c.lineWidth = 0.7;
      c.stroke();
    }
  };
  return { distance: view.distance(middle), paint };
}
