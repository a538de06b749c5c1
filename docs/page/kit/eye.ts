// SPDX-License-Identifier: MIT
// The camera: T(0, 0, -distance) Rx(-pitch) Ry(-yaw) T(-aim), a perspective of fov degrees.
import * as N from 'nakawari/all';
import { zeros } from './values';

export interface Point { x: number; y: number }
export interface Ray { origin: number[]; direction: number[] }

/** What handles need of a camera. */
export interface Eye {
  /** The pixel of a point, or undefined behind the eye. */
  project(p: number[]): Point | undefined;
  /** The ray through a pixel; the direction is unit. */
  ray(at: Point): Ray;
  /** The length at a point that has a size of one pixel. */
  pixel(p: number[]): number;
}

export interface View extends Eye {
  width: number;
  height: number;
  unit: number;
  /** The distance of a point from the eye. */
  distance(p: number[]): number;
  position: number[];
}

/** Angles in degrees; the distance and sizes of things in units of `unit`. */
export interface Camera {
  yaw: number;
  pitch: number;
  distance: number;
  fov: number;
  /** The point that the camera looks at, and the length that pictures show as 1. */
  aim: number[];
  unit: number;
}

function turnOf({ yaw, pitch }: Camera): number[] {
  const about = (axis: number[], degrees: number) =>
    N.quatFromAxisAngle(zeros(4), axis, N.radiansFromDegrees(-degrees));
  return N.quatMul(zeros(4), about([1, 0, 0], pitch), about([0, 1, 0], yaw));
}

export function viewOf(camera: Camera, width: number, height: number): View {
  const { aim, distance, fov, unit } = camera, q = turnOf(camera);
  const m = N.mat3FromQuat(zeros(9), q), back = distance * unit;
  const scale = Math.min(width, height) / 2 / Math.tan((fov * Math.PI) / 360);
  const seen = ([x, y, z]: number[]) => {
    const [a, b, c] = [x - aim[0], y - aim[1], z - aim[2]];
    return [m[0] * a + m[3] * b + m[6] * c, m[1] * a + m[4] * b + m[7] * c, m[2] * a + m[5] * b + m[8] * c - back];
  };
  const position = N.vec3Add(zeros(3), aim, N.quatRotateInverse(zeros(3), q, [0, 0, back]));
  return {
    width, height, unit, position,
    project(p: number[]): Point | undefined {
      const [x, y, z] = seen(p);
      return z < -0.2 * unit ? { x: width / 2 - (scale * x) / z, y: height / 2 + (scale * y) / z } : undefined;
    },
    ray({ x, y }: Point) {
      const direction = N.quatRotateInverse(zeros(3), q, [(x - width / 2) / scale, (height / 2 - y) / scale, -1]);
      return { origin: position, direction: N.vec3Normalize(direction, direction) };
    },
    pixel: p => Math.max(-seen(p)[2], 0) / scale,
    distance: p => Math.hypot(...seen(p)),
  };
}
