// SPDX-License-Identifier: MIT
// The object, the curves of its nose on the sphere; the noses of the keys and their velocities are dragged.
import * as N from 'nakawari/all';
import { colour } from '../../kit/colours';
import type { Ray, View } from '../../kit/eye';
import { grips, onSphere, type Grip } from '../../kit/grips';
import { dot, line } from '../../kit/picture';
import { space } from '../../kit/space';
import { arrow, curve, globe, isBehind, nose, object } from '../../kit/sphere';
import { zeros } from '../../kit/values';
import type { Room } from '../../shell/exhibit';
import { colours, omegaFor, orientation, shownOf, turned, usesOmega, withOmega, type Curves,
  type State } from './model';

// The length of the arrow of a speed, less than `longest` radii; and the speed of a length.
const longest = 0.5, slow = 0.4;
const lengthOf = (speed: number) => longest * speed / (slow + speed);
const speedOf = (length: number) => slow * length / Math.max(longest - length, 0.03);

function tipOf(n: number[], w: number[]): number[] {
  const v = N.vec3Cross(zeros(3), w, n), speed = N.vec3Length(v);
  return N.vec3AddScaled(zeros(3), n, v, speed > 0 ? lengthOf(speed) / speed : 0);
}

/** The velocity of the nose n for a tip on the ray: where it meets the plane that touches the sphere at n. */
function velocityTo({ origin, direction }: Ray, n: number[]): number[] | undefined {
  const slope = N.vec3Dot(direction, n);
  if (Math.abs(slope) < 0.1)
    return undefined;
  const tip = N.vec3AddScaled(zeros(3), origin, direction, (1 - N.vec3Dot(origin, n)) / slope);
  const arrow = N.vec3Sub(zeros(3), tip, n), length = N.vec3Length(arrow);
  return N.vec3Scale(zeros(3), arrow, length > 0 ? speedOf(length) / length : 0);
}

function gripsOf(room: Room<State>, view: View, keys: number[][], omegas: number[][]): Grip[] {
  const noses = keys.map(nose), { state } = room;
  const keyGrips = noses.map((at, k) => ({
    label: { en: `${k}: the nose of the key`, ja: `${k}：キーの機首` }, mark: String(k), colour: 'ink', at,
    behind: isBehind(view, at),
    move: (ray: Ray) => room.set(turned(room.state, k, onSphere(ray, at))),
  }));
  const tips = noses.map((n, k) => ({
    label: { en: `${k}: ω of the key`, ja: `${k}：キーの角速度 ω` }, mark: '', colour: colours[state.method],
    at: tipOf(n, omegas[k]), small: true, behind: isBehind(view, n),
    move: (ray: Ray) => {
      const v = velocityTo(ray, n);
      if (v)
        room.set(withOmega(room.state, k, omegaFor(n, v, omegas[k])));
    },
  }));
  return usesOmega(state.method) ? [...keyGrips, ...tips] : keyGrips;
}

export function sphere(room: Room<State>, curves: Curves, host: HTMLElement) {
  const show = grips(host);
  const paint = (c: CanvasRenderingContext2D, view: View) => {
    const { state } = room, { method, time } = state, { keys, omegas, at, points } = curves.of(state);
    const shown = shownOf(state), mine = orientation(at(method, time));
    show(view, gripsOf(room, view, keys, omegas));
    globe(c, view);
    return [object(c, view, mine, 1.6), line(c, view, [0, 0, 0], nose(mine), colour('ink'), 1.5),
      ...shown.flatMap(m =>
        curve(c, view, points[m], { style: colour(colours[m]), width: m === method ? 5 : 2, horizon: 1 })),
      ...shown.map(m => dot(c, view, nose(orientation(at(m, time))), colour(colours[m]))),
      ...usesOmega(method) ? keys.map((q, k) =>
        arrow(c, view, nose(q), tipOf(nose(q), omegas[k]), colour(colours[method]))) : []];
  };
  space(room, { label: { en: 'The object, and the curves of its nose on the sphere. Arrow keys turn the camera.',
    ja: '物体と、その機首が球面上に描く曲線。矢印キーで視点を回します。' }, distance: 2.9, parent: host, paint });
}
