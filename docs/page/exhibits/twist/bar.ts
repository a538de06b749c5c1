// SPDX-License-Identifier: MIT
// A bar of one square metre by three, skinned in three ways, and its measures.
import * as N from 'nakawari/all';
import { vertex } from '../../kit/skinned';
import { clamp, zeros } from '../../kit/values';

export const steps = 24, around = 8, length = 3;
/** The corners and middles of the sides of a section, counterclockwise seen from above. */
export const outline = [[0.5, 0.5], [0.5, 0], [0.5, -0.5], [0, -0.5], [-0.5, -0.5], [-0.5, 0], [-0.5, 0.5], [0, 0.5]];
/** The first vertex of the section half way up: a corner; the next one is the middle of a side. */
export const middle = steps / 2 * around;

export type Mode = 'twist' | 'bend';
/** About which axis the end turns, and how many metres of the bar follow both ends. */
export const motions: Record<Mode, { axis: number[]; spread: number; most: number }> = {
  twist: { axis: [0, 1, 0], spread: 3, most: 360 },
  bend: { axis: [0, 0, 1], spread: 1.5, most: 150 },
};
/** The bone, and the joint of both motions. */
export const bone = [0, 1, 0], pivot = [0, 1.5, 0];

const row = (i: number) => Math.floor(i / around);
export const positions = Float32Array.from({ length: (steps + 1) * around * 3 }, (_, n) => {
  const i = Math.floor(n / 3), [x, z] = outline[i % around];
  return [x, length * row(i) / steps, z][n % 3];
});

const section = (k: number) => Array.from({ length: around }, (_, i) => k * around + i);
export const faces = [section(0).reverse(), ...Array.from({ length: steps }, (_, k) => section(k).map((low, i) => {
  const next = k * around + (i + 1) % around;
  return [low, next, next + around, low + around];
})).flat(), section(steps)];

/** Each joint's weight falls linearly to 0 at the joints beside it, within the spread. */
function weights(joints: number, spread: number): Float32Array {
  return Float32Array.from({ length: (steps + 1) * around * joints }, (_, n) => {
    const up = (length * row(Math.floor(n / joints)) / steps - 1.5) / spread + 0.5;
    return Math.max(0, 1 - Math.abs(clamp(up, 0, 1) * (joints - 1) - n % joints));
  });
}

/* ---- skinning ---- */

/** The joint matrix T J T^-1 of the share j / (joints - 1) of the rotation: of its swing and of its twist. */
function shares(joints: number, axis: number[], degrees: number): number[][] {
  const q = N.quatFromAxisAngle(zeros(4), axis, N.radiansFromDegrees(degrees));
  const parts = N.quatSwingTwist(zeros(8), q, bone), swing = parts.slice(0, 4), turn = parts.slice(4);
  const T = N.mat4FromMat3(zeros(16), N.mat3Identity(zeros(9)), pivot);
  return Array.from({ length: joints }, (_, j) => {
    const share = Math.fround(j / (joints - 1));
    const J = N.quatMul(zeros(4), N.quatPow(zeros(4), swing, share), N.quatPow(zeros(4), turn, share));
    const TJ = N.mat4Mul(zeros(16), T, N.mat4FromQuat(zeros(16), J));
    return N.mat4Mul(zeros(16), TJ, N.mat4InverseRigid(zeros(16), T));
  });
}

function makeBar(mode: Mode, joints: number) {
  const { axis, spread } = motions[mode];
  const mesh = new N.Mesh({ positions, weights: weights(joints, spread), influenceCount: joints,
    joints: Uint16Array.from({ length: (steps + 1) * around * joints }, (_, n) => n % joints) });
  const models = new N.Matrices(joints), make = (format: number) => new N.Palette({ jointCount: joints, format });
  const linear = make(N.PALETTE_MAT4), dual = make(N.PALETTE_DUAL_QUAT);
  return {
    /** A copy of the skinned positions. */
    skin(byDual: boolean, degrees: number): Float32Array {
      models.array.set(shares(joints, axis, degrees).flat());
      const done = byDual ? mesh.skinDualQuat(dual.update(models)) : mesh.skinLinear(linear.update(models));
      return done.skinned.positions!.slice();
    },
    dispose: () => [mesh, models, linear, dual].forEach(owner => owner.dispose()),
  };
}

/** Linear blend of two joints, dual quaternions of two joints, linear blend of more joints. */
export type Way = 'linear' | 'dual' | 'more';
export const ways: Way[] = ['linear', 'dual', 'more'];

/** Bars, made when they are needed. The last result of each is kept. */
export function makeBars() {
  const made = new Map<string, ReturnType<typeof makeBar>>();
  const last = new Map<string, { degrees: number; positions: Float32Array }>();
  return {
    skin(mode: Mode, way: Way, more: number, degrees: number): Float32Array {
      const joints = way === 'more' ? more : 2, key = `${mode} ${joints}`, bar = made.get(key) ?? makeBar(mode, joints);
      made.set(key, bar);
      const before = last.get(key + way);
      if (before?.degrees === degrees)
        return before.positions;
      const positions = bar.skin(way === 'dual', degrees);
      last.set(key + way, { degrees, positions });
      return positions;
    },
    dispose: () => made.forEach(bar => bar.dispose()),
  };
}
export type Bars = ReturnType<typeof makeBars>;

/* ---- measures ---- */

/** One sixth of the sum of det(a, b, c) over triangles: the mean of both ways to divide a face, for it is not flat. */
function measure(skinned: ArrayLike<number>): number {
  const m = zeros(9);
  let sum = 0;
  for (const face of faces)
    for (const s of [0, 1])
      for (let i = 2; i < face.length; i++) {
        [s, s + i - 1, s + i].forEach((k, n) => {
          for (let x = 0; x < 3; x++)
            m[3 * n + x] = skinned[3 * face[k % face.length] + x];
        });
        sum += N.mat3Determinant(m);
      }
  return sum / 12;
}

const measured = new WeakMap<Float32Array, number>();
export function volume(skinned: Float32Array): number {
  const value = measured.get(skinned) ?? measure(skinned);
  measured.set(skinned, value);
  return value;
}

/** Half way up: the distance of a corner from the bone, or of the outer side from the joint. */
export function radius(mode: Mode, skinned: ArrayLike<number>): number {
  return N.vec3Length(mode === 'twist' ? N.vec3Reject([0, 0, 0], vertex(skinned, middle), bone) :
    N.vec3Sub([0, 0, 0], vertex(skinned, middle + 1), pivot));
}

/** How far the outer side of the lower half is from its bone, at most. */
export const bulge = (skinned: ArrayLike<number>) => Math.max(...Array.from({ length: middle + around }, (_, i) =>
  skinned[3 * i]));
