// SPDX-License-Identifier: MIT
// A canvas that shows things in space, from a camera that turns by a drag and by arrow keys.
import type { Room } from '../shell/exhibit';
import { number } from '../shell/state';
import type { Text } from '../shell/text';
import { makeCanvas } from './canvas';
import { onDrag } from './drag';
import { viewOf, type View } from './eye';
import { element } from './html';
import { paintAll, path, type Shape } from './picture';
import { clamp } from './values';

/** The fields of the state that a space has: the camera's angles in degrees. */
export interface Turn { yaw: number; pitch: number }
export const turnFields = (yaw: number, pitch: number) => ({ yaw: number(yaw), pitch: number(pitch, -90, 90) });

interface SpaceOptions {
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
  onDrag(canvas, last => event => {
    turn(0.4 * (last.clientX - event.clientX), 0.4 * (last.clientY - event.clientY));
    last = event;
  });
  canvas.addEventListener('keydown', event => {
    const step = keys[event.key];
    if (step) {
      event.preventDefault();
      turn(...step);
    }
  });
}

/** A part of the stage: on the left a space, on the right (below in a narrow page) what explains it. */
export function scene(stage: HTMLElement, share = 3) {
  const host = element('div', { class: 'spot' }), beside = element('div', { class: 'beside' });
  stage.append(element('div', { class: 'scene', style: `flex: ${share}` }, [host, beside]));
  return { host, beside };
}

/** The canvas; it is redrawn whenever the state changes. */
export function space<S extends Turn>(room: Room<S>, options: SpaceOptions): HTMLCanvasElement {
  const { canvas, c, clear } = makeCanvas(options.parent ?? room.stage, options.label);
  dragged(canvas, (yaw, pitch) => room.set({
    yaw: room.state.yaw + yaw, pitch: clamp(room.state.pitch + pitch, -90, 90) } as Partial<S>));
  room.draw(() => {
    const { yaw, pitch } = room.state, { distance, fov = 45, aim = [0, 0, 0] } = options;
    clear();
    const view = viewOf({ yaw, pitch, distance, fov, aim, unit: 1 }, canvas.clientWidth, canvas.clientHeight);
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
