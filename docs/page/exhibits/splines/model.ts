// SPDX-License-Identifier: MIT
// Five curves of orientations through or near the same keys, with their angular velocities.
import * as N from 'nakawari/all';
import type { Turn } from '../../kit/space';
import { nose, withNose } from '../../kit/sphere';
import { clamp, zeros } from '../../kit/values';

export const names = ['slerp', 'squad', 'gltf', 'hermite', 'bspline'] as const;
export type Method = typeof names[number];

export interface State extends Turn {
  method: Method;
  /** Angles x y z of each key in degrees, in the order YXZ. */
  keys: number[];
  times: number[];
  /** The angular velocity x y z of each key, radians per second; empty: those of Catmull-Rom. */
  omega: number[];
  plot: 'length' | 'components';
  /** The methods that are not drawn. */
  hidden: string[];
  time: number;
}

export const words = {
  slerp: { en: 'slerp', ja: 'slerp（球面線形補間）' },
  squad: { en: 'squad', ja: 'squad' },
  gltf: { en: 'glTF cubic', ja: 'glTF の CUBICSPLINE' },
  hermite: { en: 'Hermite with ω', ja: 'ω を使う Hermite 補間' },
  bspline: { en: 'B-spline', ja: 'B スプライン' },
};
export const colours: Record<Method, string> =
  { slerp: 'c1', squad: 'c4', gltf: 'c3', hermite: 'c0', bspline: 'c2' };

export const count = 5;
const three = (list: number[], k: number) => list.slice(3 * k, 3 * k + 3);
const inner = Array.from({ length: count - 2 }, (_, i) => i + 1);
const segments = Array.from({ length: count - 1 }, (_, k) => k);

/** The keys, each with the sign nearer to the one before it. */
export function keysOf({ keys }: State): number[][] {
  const made: number[][] = [];
  for (let k = 0; k < count; k++) {
    const q = N.quatFromEuler(zeros(4), three(keys, k).map(N.radiansFromDegrees), N.EULER_YXZ);
    made.push(k > 0 && N.quatDot(made[k - 1], q) < 0 ? N.quatNegate(zeros(4), q) : q);
  }
  return made;
}

const around = (k: number) => [Math.max(k - 1, 0), k, k + 1, Math.min(k + 2, count - 1)];

/** The angular velocities of the keys: those of the state, or of Catmull-Rom. */
function omegasOf({ omega, times }: State, keys: number[][]): number[][] {
  return keys.map((_, k) => {
    if (omega.length)
      return three(omega, k).map(Math.fround);
    const four = around(Math.min(k, count - 2));
    const { velocity } = N.rotationFromCatmullRom({}, four.map(i => keys[i]), four.map(i => times[i]));
    return three(Array.from(velocity), k < count - 1 ? 0 : 1);
  });
}

interface Keys { keys: number[][]; times: number[]; omegas: number[][] }

function segmentOf(method: Exclude<Method, 'gltf'>, { keys, times, omegas }: Keys, k: number): N.RotationSegment {
  const four = around(k).map(i => keys[i]), duration = Math.fround(Math.fround(times[k + 1]) - Math.fround(times[k]));
  switch (method) {
    case 'slerp': return N.rotationFromSlerp({}, keys[k], keys[k + 1], duration, N.PATH_SHORT, 0);
    case 'squad': return N.rotationFromSquad({}, four, duration);
    case 'hermite': return N.rotationFromHermite({}, keys[k], omegas[k], keys[k + 1], omegas[k + 1], duration);
    case 'bspline': return N.rotationFromBspline({}, four, duration);
  }
}

/** Two keys as a CUBICSPLINE track with the tangents of the angular velocities: dq/dt = (w/2) q. */
function trackOf({ keys, times, omegas }: Keys, k: number): N.Track {
  const values = [k, k + 1].flatMap(i => {
    const tangent = N.quatScale(zeros(4), N.quatMul(zeros(4), [...omegas[i], 0], keys[i]), 0.5);
    return [...tangent, ...keys[i], ...tangent];
  });
  return new N.Track({ times: [times[k], times[k + 1]], values, width: 4, kind: N.TRACK_ROTATION,
    interpolation: N.INTERPOLATION_CUBICSPLINE });
}

/** Orientation x y z w, angular velocity x y z, angular acceleration x y z. */
export type Motion = number[];
export const velocity = (motion: Motion) => motion.slice(4, 7);
export const degrees = (x: number) => N.degreesFromRadians(x);
export const orientation = (motion: Motion) => motion.slice(0, 4);

/** The angular velocity on both sides of key k, and its jump in degrees per second. */
interface Corner { k: number; before: number[]; after: number[]; jump: number }

/** The motion of each method in segment k at t in 0..1, and at a time; the inner keys. */
function motionsOf(state: State) {
  const { times } = state, keys = keysOf(state), all = { keys, times, omegas: omegasOf(state, keys) };
  const tracks = segments.map(k => trackOf(all, k));
  const made = Object.fromEntries(names.filter(m => m !== 'gltf').map(m =>
    [m, segments.map(k => segmentOf(m, all, k))]));
  const within = (method: Method, k: number, t: number, time: number): Motion => {
    if (method !== 'gltf')
      return N.rotationEvaluate(zeros(10), made[method][k], t);
    const out = new Float32Array(10);
    tracks[k].sampleMotion(time, out, out.subarray(4), out.subarray(7));
    return Array.from(out);
  };
  const at = (method: Method, time: number) => {
    const { index, t } = N.segmentFind({}, times, count, time), k = Math.min(index, count - 2);
    return within(method, k, index > k ? 1 : t, time);
  };
  const corners = Object.fromEntries(names.map(m => [m, inner.map(k => {
    const [before, after] = [within(m, k - 1, 1, times[k]), within(m, k, 0, times[k])].map(velocity);
    return { k, before, after, jump: degrees(N.vec3Distance(before, after)) };
  })])) as Record<Method, Corner[]>;
  return { ...all, within, at, corners, dispose: () => tracks.forEach(track => track.dispose()) };
}

const steps = 48;

/** Samples of all segments. At an inner key there are two: before and after it. */
function samplesOf({ times, within }: ReturnType<typeof motionsOf>) {
  const places = segments.flatMap(k => Array.from({ length: steps + 1 }, (_, i) =>
    ({ k, t: i / steps, time: i < steps ? times[k] + (i / steps) * (times[k + 1] - times[k]) : times[k + 1] })));
  const motions = Object.fromEntries(names.map(m => [m, places.map(({ k, t, time }) => within(m, k, t, time))])) as
    Record<Method, Motion[]>;
  return { x: places.map(place => place.time), motions,
    lengths: names.map(m => motions[m].map(motion => degrees(N.vec3Length(velocity(motion))))),
    points: Object.fromEntries(names.map(m => [m, motions[m].map(motion => nose(orientation(motion)))])) as
      Record<Method, number[][]> };
}

/** The curves of a state, made again when its keys change. */
export function curvesOf() {
  let made = '', kept: (ReturnType<typeof motionsOf> & ReturnType<typeof samplesOf>) | undefined;
  const of = (state: State) => {
    const { keys, times, omega } = state, next = JSON.stringify([keys, times, omega]);
    if (!kept || next !== made) {
      kept?.dispose();
      const motions = motionsOf(state);
      kept = { ...motions, ...samplesOf(motions) };
      made = next;
    }
    return kept;
  };
  return { of, dispose: () => kept?.dispose() };
}
export type Curves = ReturnType<typeof curvesOf>;

export const shownOf = ({ hidden }: State) => names.filter(m => !hidden.includes(m));
/** The methods that use the angular velocities of the keys. */
export const usesOmega = (method: Method) => method === 'hermite' || method === 'gltf';

/* ---- changes ---- */

/** Key k turned by the shortest rotation that brings its nose to p. */
export function turned(state: State, k: number, p: number[]): Partial<State> {
  const angles = N.eulerFromQuat(zeros(3), withNose(keysOf(state)[k], p), N.EULER_YXZ);
  return { keys: state.keys.map((x, i) => Math.floor(i / 3) === k ? +degrees(angles[i % 3]).toFixed(2) : x) };
}

/** The angular velocities with that of key k changed. */
const fastest = 1000; // radians per second
export function withOmega(state: State, k: number, omega: number[]): Partial<State> {
  return { omega: omegasOf(state, keysOf(state)).flatMap((w, i) => (i === k ? omega : w).map(x => clamp(+x.toFixed(3), -fastest, fastest))) };
}

/** The angular velocity for which the nose n moves with the velocity v; the part about the nose stays. */
export const omegaFor = (n: number[], v: number[], before: number[]) =>
  N.vec3AddScaled(zeros(3), N.vec3Cross(zeros(3), n, v), n, N.vec3Dot(before, n));

/** Key k at another time, at least 0.1 s from its neighbours; undefined if it cannot be there. */
export function withTime({ times }: State, k: number, time: number): Partial<State> | undefined {
  const least = k > 0 ? times[k - 1] + 0.1 : 0, most = k < count - 1 ? times[k + 1] - 0.1 : 20;
  const next = +clamp(time, least, most).toFixed(2);
  return Number.isFinite(next) ? { times: times.map((x, i) => i === k ? next : x) } : undefined;
}
export const ascending = (times: number[]) => times.length === count && times[0] >= 0 && times[count - 1] <= 20 &&
  times.every((x, k) => k === 0 || x > times[k - 1]);
