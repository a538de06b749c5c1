// SPDX-License-Identifier: MIT
// The object in its three gimbals. The letters on the rings are dragged.
import * as N from 'nakawari/all';
import { colour } from '../../kit/colours';
import type { Ray, View } from '../../kit/eye';
import { grips, type Grip } from '../../kit/grips';
import { line, type Shape } from '../../kit/picture';
import { space } from '../../kit/space';
import { curve, isBehind, object, ring } from '../../kit/sphere';
import { zeros } from '../../kit/values';
import type { Room } from '../../shell/exhibit';
import { axesOf, degrees, gimbalsOf, inOrder, letters, poseOf, withAngles, type State } from './model';

const radii = [1, 0.84, 0.68], widths = [6, 5, 4];

/** The outer and the inner axis are this near in degrees when the direction that is lost is shown. */
export const lost = 5;

/** The angle about an axis from `from` to where a ray meets its plane, or 0 if that is seen edge on. */
function turnTo({ origin, direction }: Ray, axis: number[], from: number[]): number {
  const slope = N.vec3Dot(direction, axis);
  if (Math.abs(slope) < 0.08)
    return 0;
  const at = N.vec3AddScaled(zeros(3), origin, direction, -N.vec3Dot(origin, axis) / slope);
  return N.degreesFromRadians(N.quatTwistAngle(N.quatFromVectors(zeros(4), from, at), axis));
}

function gripsOf(room: Room<State>, view: View): Grip[] {
  const { angles } = poseOf(room.state), order = axesOf(room.state.order);
  return gimbalsOf(angles, room.state.order).map(({ axis, carries }, n) => {
    const at = N.vec3Scale(zeros(3), carries, radii[n]), which = order[n], letter = 'XYZ'[which];
    const move = (ray: Ray) => {
      const next = degrees(angles);
      next[which] += turnTo(ray, axis, at);
      room.clock.stop();
      room.set({ by: 'angles', ...withAngles(next) });
    };
    return { label: { en: `gimbal about ${letter}`, ja: `${letter} 軸まわりのジンバル` }, mark: letter,
      colour: letters[which], at, behind: isBehind(view, at, 0), move };
  });
}

/** The circle of a gimbal contains its axis and the axis that it carries. */
const circle = (axis: number[], carries: number[], radius: number) => ring((c, s) =>
  N.vec3AddScaled(zeros(3), N.vec3Scale(zeros(3), axis, radius * c), carries, radius * s));

/** The direction about which no gimbal turns at the pole. */
function lostLine(c: CanvasRenderingContext2D, view: View, outer: number[], middle: number[]): Shape[] {
  const across = N.vec3Normalize(zeros(3), N.vec3Cross(zeros(3), outer, middle)), style = colour('ink');
  const points = Array.from({ length: 117 }, (_, i) => N.vec3Scale(zeros(3), across, 1.15 * (i / 58 - 1)));
  return curve(c, view, points, { style, width: 2, dashed: true });
}

export function gimbals(room: Room<State>, host: HTMLElement) {
  const show = grips(host);
  const paint = (c: CanvasRenderingContext2D, view: View) => {
    const { angles, q } = poseOf(room.state), { order } = room.state, axes = axesOf(order);
    const all = gimbalsOf(angles, order);
    show(view, gripsOf(room, view));
    return [object(c, view, q, 0.9), ...all.flatMap(({ axis, carries }, n) => {
      const style = colour(letters[axes[n]]), end = (length: number) => N.vec3Scale(zeros(3), axis, length);
      return [...curve(c, view, circle(axis, carries, radii[n]), { style, width: widths[n], horizon: 0 }),
        ...[1, -1].map(side => line(c, view, end(side * radii[n]), end(side * (radii[n] + 0.16)), style, 7))];
    }), ...inOrder(q, order).distance < lost ? lostLine(c, view, all[0].axis, all[1].axis) : []];
  };
  space(room, { label: { en: 'An object in three gimbals. Arrow keys turn the camera.',
    ja: '三重のジンバルの中の物体。矢印キーで視点を回します。' }, distance: 3.05, parent: host, paint });
}
