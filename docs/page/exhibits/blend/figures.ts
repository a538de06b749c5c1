// SPDX-License-Identifier: MIT
// Characters beside each other, as joints and bones.
import * as N from 'nakawari/all';
import { colour } from '../../kit/colours';
import type { View } from '../../kit/eye';
import { dot, floor, line, type Shape } from '../../kit/picture';
import { space } from '../../kit/space';
import type { Room } from '../../shell/exhibit';
import { say, type Text } from '../../shell/text';
import type { Rig } from './rig';
import type { State } from './state';

interface Figure {
  pose: N.Pose;
  colour: string;
  label: Text;
}

const apart = 1.15;
const middle = [0, 0.85, 0];
// The tips of the bones that no joint ends, in the axes of the joint.
const tips: Record<string, number[]> = { head: [0, 0.12, 0], 'foot.L': [0, -0.03, 0.14], 'foot.R': [0, -0.03, 0.14] };

const ball = (c: CanvasRenderingContext2D, view: View, at: number[], radius: number, style: string): Shape =>
  dot(c, view, at, style, radius / view.pixel(at), radius);

function name(c: CanvasRenderingContext2D, view: View, at: number[], text: string, style: string): Shape {
  const paint = () => {
    const p = view.project(at);
    c.font = `${Math.min(13, view.width / 27)}px system-ui, sans-serif`;
    c.textAlign = 'center';
    c.fillStyle = style;
    if (p)
      c.fillText(text, p.x, Math.min(p.y + 16, view.height - 6));
  };
  return { distance: 0, paint };
}

// The bones and joints of a figure, from its model matrices.
function bones(c: CanvasRenderingContext2D, view: View, rig: Rig, joint: number, matrices: ArrayLike<number>,
  style: string): Shape[] {
  const matrix = (j: number) => Array.from({ length: 16 }, (_, k) => matrices[16 * j + k]);
  const at = rig.names.map((_, j) => matrix(j).slice(12, 15)), width = 0.05 / view.pixel(at[0]);
  const shapes = rig.parents.flatMap((p, j) => p < 0 ? [] : [line(c, view, at[p], at[j], style, width)]);
  for (const [tip, to] of Object.entries(tips)) {
    const j = rig.names.indexOf(tip), end = N.mat4TransformPoint([0, 0, 0], matrix(j), to);
    shapes.push(tip === 'head' ? ball(c, view, end, 0.12, style) : line(c, view, at[j], end, style, width));
  }
  const [ink, chosen] = [colour('ink'), colour('c3')];
  const knob = (p: number[], j: number) => ball(c, view, p, j === joint ? 0.055 : 0.03, j === joint ? chosen : ink);
  return [...shapes, ...at.map(knob)];
}

/** A canvas with the figures; the chosen joint is marked. */
export function figures(room: Room<State>, rig: Rig, label: Text, count: number, list: () => Figure[]) {
  const models = new N.Matrices(rig.names.length);
  const canvas: HTMLCanvasElement = space(room, {
    label, aim: middle, fov: 30,
    get distance() { // all figures are in the picture, whatever its shape
      const { clientWidth, clientHeight } = canvas, least = Math.min(clientWidth, clientHeight) || 1;
      return 1.87 * Math.max(2.2 * least / clientHeight, (apart * count + 0.3) * least / clientWidth);
    },
    paint(c, view) {
      const [left, right] = [0, view.width].map(x => view.ray({ x, y: view.height / 2 }).direction);
      const side = N.vec3Normalize([0, 0, 0], N.vec3Sub([0, 0, 0], right, left));
      floor(c, view, middle);
      return list().flatMap(({ pose, colour: own, label: text }, i) => {
        const place = N.vec3Scale([0, 0, 0], side, apart * (i - (count - 1) / 2)), style = colour(own);
        rig.skeleton.models(pose, models, N.mat4FromTrs(new Float32Array(16), [...place, 0, 0, 0, 1, 1, 1, 1]));
        return [...bones(c, view, rig, rig.names.indexOf(room.state.joint), models.array, style),
          name(c, view, place, say(text), style)];
      });
    },
  });
}
