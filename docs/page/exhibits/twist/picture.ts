// SPDX-License-Identifier: MIT
// The bars, each in its column of the canvas.
import * as N from 'nakawari/all';
import { colour } from '../../kit/colours';
import { viewOf, type View } from '../../kit/eye';
import { dot, line, paintAll, type Shape } from '../../kit/picture';
import { rgb, skinned } from '../../kit/skinned';
import { say } from '../../shell/text';
import { around, faces, pivot, volume, ways, type Bars, type Mode, type Way } from './bar';
import { degreesOf, type State } from './model';
import { wayWords, words } from './words';

type Context = CanvasRenderingContext2D;
export const colourOf: Record<Way, string> = { linear: 'c1', dual: 'c0', more: 'c2' };

/** The middle, width and height of what a bar can fill, and the height of its label below. */
const boxes: Record<Mode, { aim: number[]; wide: number; high: number }> = {
  twist: { aim: [0, 1.5, 0], wide: 1.7, high: 3.5 }, bend: { aim: [-0.5, 1.5, 0], wide: 2.5, high: 3.4 },
};
const below = 40;

/** A camera that sees the whole box. */
function eye({ yaw, pitch, mode }: State, width: number, height: number): View {
  const { aim, wide, high } = boxes[mode], fov = 20;
  const size = Math.max(wide / width, high / height) * Math.min(width, height);
  return viewOf({ yaw, pitch, distance: size / (2 * Math.tan(fov * Math.PI / 360)) + 0.7, fov, aim, unit: 1 }, width,
    height);
}

/** The two bones, before the bar. */
function bones(c: Context, view: View, degrees: number): Shape[] {
  const q = N.quatFromAxisAngle([0, 0, 0, 0], [0, 0, 1], N.radiansFromDegrees(degrees));
  const end = N.vec3Add([0, 0, 0], pivot, N.quatRotate([0, 0, 0], q, pivot));
  const ink = colour('ink'), bone = (a: number[], b: number[]) => line(c, view, a, b, ink, 2);
  return [bone([0, 0, 0], pivot), bone(pivot, end), dot(c, view, pivot, ink)].map(shape =>
    ({ ...shape, distance: -1 }));
}

/** The name of the way, its short one in a narrow column, and its volume. */
function label(c: Context, state: State, way: Way, size: number, width: number, height: number) {
  const name = width < 170 ? words.columns[ways.indexOf(way) + 1] : wayWords(state.joints)[way];
  c.textAlign = 'center';
  c.fillStyle = colour('ink');
  c.font = '600 14px system-ui, "Noto Sans CJK JP", sans-serif';
  c.fillText(say(name), width / 2, height + 14, width - 8);
  c.font = '14px system-ui, "Noto Sans CJK JP", sans-serif';
  c.fillText(`${size.toFixed(3)} m³`, width / 2, height + 32);
}

/** One side of a bar is paler, so that a twist is seen. */
function bar(c: Context, state: State, way: Way, bars: Bars, width: number, height: number) {
  const view = eye(state, width, height), degrees = degreesOf(state);
  const now = bars.skin(state.mode, way, Number(state.joints), degrees);
  const fill = rgb(colourOf[way]), pale = rgb('soft');
  paintAll([...skinned(c, view, now, faces, face => (face - 1) % around < 2 ? pale : fill),
    ...(state.mode === 'bend' ? bones(c, view, degrees) : [])]);
  label(c, state, way, volume(now), width, height);
}

export const paint = (c: Context, { width, height }: View, state: State, bars: Bars): Shape[] =>
  ways.map((way, i) => ({ distance: 0, paint() {
    const wide = width / ways.length;
    c.save();
    c.translate(i * wide, 0);
    bar(c, state, way, bars, wide, height - below);
    c.restore();
  } }));
