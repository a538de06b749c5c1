// SPDX-License-Identifier: MIT
// The joints in space: where they are, about which axes they rotate, and the handles that turn them.
import * as N from 'nakawari/all';
import type { Ray } from '../../kit/eye';
import type { Grip } from '../../kit/grips';
import { clamp } from '../../kit/values';
import type { Room } from '../../shell/exhibit';
import { angles, heights, most, vectors, type Axis, type Joint, type State } from './model';
import { labels } from './words';

export interface Frame {
  at: number[];
  /** Unit vectors: the axis of the rotation, and the direction of the handle at the angle 0. */
  axis: number[];
  zero: number[];
  /** How far the handle is from the joint. */
  reach: number;
}

const zeroOf: Record<Axis, number[]> = { x: [0, 0, 1], y: [0, 0, 1], z: [1, 0, 0] };

export const frames = (state: State, list: Joint[]): Frame[] => heights(state).map((height, i) => {
  const direction = (d: number[]) =>
    N.vec3Normalize([0, 0, 0], N.mat4TransformDirection([0, 0, 0], list[i].P, d));
  return { at: N.mat4TransformPoint([0, 0, 0], list[i].M, [0, height, 0]),
    axis: direction(vectors[state.axis]), zero: direction(zeroOf[state.axis]),
    reach: state.order === 'origin' ? 0.6 + 0.25 * i : 0.85 }; // all joints are at the origin
});

/** The angle of the point where a ray meets the plane of the rotation; undefined if it is seen from its edge. */
function angleOf({ at, axis, zero }: Frame, { origin, direction }: Ray): number | undefined {
  const slope = N.vec3Dot(direction, axis);
  if (Math.abs(slope) < 0.03)
    return undefined;
  const from = N.vec3Sub([0, 0, 0], origin, at);
  const d = N.vec3AddScaled([0, 0, 0], from, direction, -N.vec3Dot(from, axis) / slope);
  return N.atan2(N.vec3Dot(d, N.vec3Cross([0, 0, 0], axis, zero)), N.vec3Dot(d, zero));
}

/** Sets one angle; the others stay as they are at this time of the play. */
function turn(room: Room<State>, joint: number, angle: number) {
  const [angle0, angle1, angle2, angle3] = angles(room.state).map((a, j) =>
    j === joint ? clamp(angle, -most, most) : a);
  if (room.clock.playing)
    room.clock.stop();
  room.set({ joint, time: 0, angle0, angle1, angle2, angle3 });
}

/** `step` turns the joint by a number of small steps. */
interface Handle extends Grip { step(by: number): void }

/** A handle for each joint. */
export const handles = (room: Room<State>, list: Frame[]): Handle[] => angles(room.state).map((angle, i) => {
  const f = list[i], q = N.quatFromAxisAngle([0, 0, 0, 0], f.axis, angle);
  return {
    label: labels.handle(i, angle), mark: String(i), colour: `c${i}`,
    at: N.vec3AddScaled([0, 0, 0], f.at, N.quatRotate([0, 0, 0], q, f.zero), f.reach),
    move(ray) {
      const to = angleOf(f, ray);
      if (to !== undefined)
        turn(room, i, angle + N.angleDifference(angle, to));
    },
    step: by => turn(room, i, angle + 0.05 * by),
  };
});
