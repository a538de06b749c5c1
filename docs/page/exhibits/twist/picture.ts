// SPDX-License-Identifier: MIT
// The bars, each in its part of the canvas: beside each other on a wide one, lying below each other on a high one.
import * as N from 'nakawari/all';
import { colour } from '../../kit/colours';
import { viewOf, type View } from '../../kit/eye';
import { dot, line, paintAll, type Shape } from '../../kit/picture';
import { rgb, skinned } from '../../kit/skinned';
import { say } from '../../shell/text';
import { around, faces, length, pivot, volume, ways, type Bars, type Mode, type Way } from './bar';
import { degreesOf, type State } from './model';
import { wayWords } from './words';

type Context = CanvasRenderingContext2D;
export const colourOf: Record<Way, string> = { linear: 'c1', dual: 'c0', more: 'c2' };

/** The middle, width and height of what a standing bar can fill, and the place of its label below. */
const boxes: Record<Mode, { aim: number[]; wide: number; high: number }> = {
  twist: { aim: [0, 1.5, 0], wide: 1.7, high: 3.5 }, bend: { aim: [-0.5, 1.5, 0], wide: 2.5, high: 3.4 },
};
const below = 40;

/** A camera that sees the whole box. */
function eye({ yaw, pitch, mode }: State, width: number, height: number, lying: boolean): View {
  const { aim, wide, high } = boxes[mode], [w, h] = lying ? [high, wide] : [wide, high];
  const distance = Math.max(w / width, h / height) * Math.min(width, height) / (2 * Math.tan(Math.PI / 18)) + 0.7;
  return viewOf({ yaw, pitch, distance, fov: 20, aim: lying ? [0, -aim[0], 0] : aim, unit: 1 }, width, height);
}

const lie = ([x, y, z]: number[]) => [y - length / 2, -x, z];

/** The two bones, before the bar. */
function bones(c: Context, view: View, degrees: number, at: (p: number[]) => number[]): Shape[] {
  const q = N.quatFromAxisAngle([0, 0, 0, 0], [0, 0, 1], N.radiansFromDegrees(degrees));
  const end = N.vec3Add([0, 0, 0], pivot, N.quatRotate([0, 0, 0], q, pivot));
  const ink = colour('ink'), bone = (a: number[], b: number[]) => line(c, view, at(a), at(b), ink, 2);
  return [bone([0, 0, 0], pivot), bone(pivot, end), dot(c, view, at(pivot), ink)].map(shape =>
    ({ ...shape, distance: -1 }));
}

function label(c: Context, state: State, way: Way, size: number, width: number, height: number) {
  c.textAlign = 'center';
  c.fillStyle = colour('ink');
  c.font = '600 14px system-ui, "Noto Sans CJK JP", sans-serif';
  c.fillText(say(wayWords(state.joints)[way]), width / 2, height + 14, width - 8);
  c.font = '14px system-ui, "Noto Sans CJK JP", sans-serif';
  c.fillText(`${size.toFixed(3)} m³`, width / 2, height + 32);
}

/** One side of a bar is paler, so that a twist is seen. */
function bar(c: Context, state: State, way: Way, bars: Bars, width: number, height: number, lying: boolean) {
  const view = eye(state, width, height, lying), at = lying ? lie : (p: number[]) => p, degrees = degreesOf(state);
  const now = bars.skin(state.mode, way, Number(state.joints), degrees);
  const fill = rgb(colourOf[way]), pale = rgb('soft');
  paintAll([...skinned(c, view, now, faces, face => (face - 1) % around < 2 ? pale : fill, at),
    ...(state.mode === 'bend' ? bones(c, view, degrees, at) : [])]);
  label(c, state, way, volume(now), width, height);
}

export function paint(c: Context, { width, height }: View, state: State, bars: Bars): Shape[] {
  const lying = height > width, w = lying ? width : width / ways.length, h = lying ? height / ways.length : height;
  return ways.map((way, i) => ({ distance: 0, paint() {
    c.save();
    c.translate(lying ? 0 : i * w, lying ? i * h : 0);
    bar(c, state, way, bars, w, h - below, lying);
    c.restore();
  } }));
}
