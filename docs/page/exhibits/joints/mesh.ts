// SPDX-License-Identifier: MIT
// The lesson's capsule: radius 0.5, from height 0 to 3, and the weights of its vertices on four joints.
import * as N from 'nakawari/all';
import { clamp } from '../../kit/values';

export const joints = 4, around = 16;
const cap = 4, side = 12, radius = 0.5, straight = 2;
export const rings = 2 * cap + side + 1;
export type Influence = 'smooth' | 'hard';

function ring(k: number): number[] {
  const below = k - cap, above = below - side, share = clamp(below / side, 0, 1);
  const angle = Math.PI / 2 / cap * (above > 0 ? above : Math.min(below, 0));
  return Array.from({ length: around }, (_, i) => {
    const turn = 2 * Math.PI * i / around, wide = radius * Math.cos(angle);
    return [wide * Math.sin(turn), radius + straight * share + radius * Math.sin(angle), wide * Math.cos(turn)];
  }).flat();
}

export const positions = Float32Array.from(Array.from({ length: rings }, (_, k) => ring(k)).flat());
export const faces = Array.from({ length: rings - 1 }, (_, k) => Array.from({ length: around }, (_, i) => {
  const low = k * around + i, next = k * around + (i + 1) % around;
  return k === 0 ? [low, next + around, low + around] : k === rings - 2 ? [low, next, next + around] :
    [low, next, next + around, low + around];
})).flat();

/** Where the B-spline over the joints is at a height: the first of four joints may be -1 or less, t is in [0, 1]. */
export function place(height: number) {
  const u = clamp(Math.fround(height - 0.5), -1, joints - 1), k = Math.floor(u);
  return { first: k - 1, t: Math.fround(u - k) };
}

/** The joint to which each of the four weights belongs: joints beyond the ends count as the end ones. */
export const clamped = (j: number) => clamp(j, 0, joints - 1);

function share(height: number, influence: Influence): number[] {
  const out = Array<number>(joints).fill(0);
  if (influence === 'hard') {
    out[clamped(Math.floor(height))] = 1;
    return out;
  }
  const { first, t } = place(height);
  N.cubicWeights([0, 0, 0, 0], N.CUBIC_BSPLINE, 0, t).forEach((w, i) => {
    out[clamped(first + i)] = Math.fround(out[clamped(first + i)] + w);
  });
  return out;
}

/** The two largest weights of each vertex, not normalised again: their sum is less than 65535. */
function keepTwo(weights: Uint16Array): Uint16Array {
  return weights.map((w, n) => {
    const all = weights.subarray(n - n % joints, n - n % joints + joints);
    const before = all.reduce((sum, other, j) => sum + Number(other > w || (other === w && j < n % joints)), 0);
    return before < 2 ? w : 0;
  });
}

/** The weights of all vertices, of 65535. */
export function weightsOf(influence: Influence, normalised: boolean): Uint16Array {
  const count = positions.length / 3, out = new Uint16Array(count * joints);
  const shares = Array.from({ length: count }, (_, i) => share(positions[3 * i + 1], influence));
  N.skinNormalizeWeights(Float32Array.from(shares.flat()), out, joints, count);
  return normalised ? out : keepTwo(out);
}
