// SPDX-License-Identifier: MIT
// A bar of one square metre by three, its joints along the axis, its volume and its thickness.
import * as N from 'nakawari/all';
import { vertex } from '../../kit/skinned';

export const steps = 24, around = 8, length = 3;
/** The corners and middles of the sides of a section, counterclockwise seen from above. */
export const outline = [[0.5, 0.5], [0.5, 0], [0.5, -0.5], [0, -0.5], [-0.5, -0.5], [-0.5, 0], [-0.5, 0.5], [0, 0.5]];
/** The first corner of the section half way. */
export const middle = steps / 2 * around;

export const positions = Float32Array.from({ length: (steps + 1) * around * 3 }, (_, n) => {
  const i = Math.floor(n / 3), [x, z] = outline[i % around];
  return [x, length * Math.floor(i / around) / steps, z][n % 3];
});

const section = (k: number) => Array.from({ length: around }, (_, i) => k * around + i);
export const faces = [section(0).reverse(), ...Array.from({ length: steps }, (_, k) => section(k).map((low, i) => {
  const next = k * around + (i + 1) % around;
  return [low, next, next + around, low + around];
})).flat(), section(steps)];

/** Each joint's weight falls linearly to 0 at the joints beside it. */
export function weights(joints: number): Float32Array {
  return Float32Array.from({ length: (steps + 1) * around * joints }, (_, n) => {
    const at = Math.floor(n / joints / around) / steps * (joints - 1);
    return Math.max(0, 1 - Math.abs(at - n % joints));
  });
}

/** How far each joint is turned, in degrees: equal parts of the twist. */
export const angles = (joints: number, twist: number) => Array.from({ length: joints }, (_, j) =>
  Math.fround(twist * j / (joints - 1)));

export type Way = 'linear' | 'dual';

export function makeBar(joints: number) {
  const mesh = new N.Mesh({ positions, weights: weights(joints), influenceCount: joints,
    joints: Uint16Array.from({ length: (steps + 1) * around * joints }, (_, n) => n % joints) });
  const models = new N.Matrices(joints), make = (format: number) => new N.Palette({ jointCount: joints, format });
  const linear = make(N.PALETTE_MAT4), dual = make(N.PALETTE_DUAL_QUAT);
  const turn = (degrees: number) => N.mat4FromQuat(Array<number>(16).fill(0),
    N.quatFromAxisAngle([0, 0, 0, 0], [0, 1, 0], N.radiansFromDegrees(degrees)));
  return {
    /** A copy of the skinned positions. */
    skin(way: Way, twist: number): Float32Array {
      models.array.set(angles(joints, twist).flatMap(turn));
      const done = way === 'linear' ? mesh.skinLinear(linear.update(models)) : mesh.skinDualQuat(dual.update(models));
      return done.skinned.positions!.slice();
    },
    dispose: () => [mesh, models, linear, dual].forEach(owner => owner.dispose()),
  };
}
export type Bar = ReturnType<typeof makeBar>;

/** One sixth of the sum of a . (b x c) over triangles: the mean of both ways to divide a face, for it is not flat. */
export function volume(skinned: ArrayLike<number>): number {
  const at = Array.from({ length: skinned.length / 3 }, (_, i) => vertex(skinned, i)), cross = [0, 0, 0];
  let sum = 0;
  for (const face of faces)
    for (const s of [0, 1])
      for (let i = 2; i < face.length; i++) {
        const [a, b, c] = [s, s + i - 1, s + i].map(k => at[face[k % face.length]]);
        sum += N.vec3Dot(a, N.vec3Cross(cross, b, c));
      }
  return sum / 12;
}

/** The distance of a corner half way up from the axis. */
export const radius = (skinned: ArrayLike<number>) => N.vec3Length(N.vec3Reject([0, 0, 0], vertex(skinned, middle), [0, 1, 0]));
