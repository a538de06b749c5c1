// SPDX-License-Identifier: MIT
// The ways from one orientation to another: orientation and angular velocity at each time.
import * as N from 'nakawari/all';
import { remembered } from '../../kit/samples';
import type { Turn } from '../../kit/space';
import { nose, withNose } from '../../kit/sphere';
import { zeros } from '../../kit/values';

export const names = ['euler', 'nlerp', 'slerp', 'long', 'turns', 'given'] as const;
export type Method = typeof names[number];

export interface State extends Turn {
  method: Method;
  turns: number;
  flip: boolean;
  ax: number; ay: number; az: number;
  bx: number; by: number; bz: number;
  /** The methods that are not drawn. */
  hidden: string[];
  time: number;
}

export const words = {
  euler: { en: 'Euler angles', ja: 'オイラー角' },
  nlerp: { en: 'nlerp', ja: 'nlerp（正規化線形補間）' },
  slerp: { en: 'slerp', ja: 'slerp（球面線形補間）' },
  long: { en: 'slerp, long arc', ja: 'slerp（長い弧）' },
  turns: { en: 'slerp, k more turns', ja: 'slerp（k 回転を追加）' },
  given: { en: 'slerp, signs as given', ja: 'slerp（符号を調整しない）' },
};
export const colours: Record<Method, string> =
  { euler: 'c1', nlerp: 'c4', slerp: 'c0', long: 'c3', turns: 'c5', given: 'c6' };

export const seconds = 2, order = N.EULER_YXZ;

export function keysOf({ ax, ay, az, bx, by, bz, flip }: State) {
  const angles = [[ax, ay, az], [bx, by, bz]].map(degrees => degrees.map(N.radiansFromDegrees));
  const [a, b] = angles.map(e => N.quatFromEuler(zeros(4), e, order));
  return { angles, a, b: flip ? N.quatNegate(zeros(4), b) : b };
}
export type Keys = ReturnType<typeof keysOf>;

/** Orientation x y z w and angular velocity x y z, radians per second. */
export interface Motion { q: number[]; w: number[] }

const arcs = { slerp: N.PATH_SHORT, long: N.PATH_LONG, turns: N.PATH_SHORT, given: N.PATH_AS_GIVEN };

/** The motion at t in 0..1. */
type Way = (t: number) => Motion;

function alongArc({ a, b }: Keys, method: keyof typeof arcs, turns: number): Way {
  const segment = N.rotationFromSlerp({}, a, b, seconds, arcs[method], method === 'turns' ? turns : 0);
  return t => {
    const state = N.rotationEvaluate(zeros(10), segment, t);
    return { q: state.slice(0, 4), w: state.slice(4, 7) };
  };
}

/** The angles change evenly. Each rate is about the axis of its gimbal: w = sum of rate times axis. */
function byEuler({ angles: [a, b] }: Keys): Way {
  const rates = N.vec3Scale(zeros(3), N.vec3Sub(zeros(3), b, a), 1 / seconds);
  return t => {
    const [x, y, z] = N.eulerLerp(zeros(3), a, b, t, N.UNWRAP_NONE);
    const pitchAxis = N.quatRotate(zeros(3), N.quatFromEuler(zeros(4), [0, y, 0], order), [1, 0, 0]);
    const rollAxis = N.quatRotate(zeros(3), N.quatFromEuler(zeros(4), [x, y, 0], order), [0, 0, 1]);
    const w = N.vec3AddScaled(zeros(3), [0, rates[1], 0], pitchAxis, rates[0]);
    return { q: N.quatFromEuler(zeros(4), [x, y, z], order), w: N.vec3AddScaled(w, w, rollAxis, rates[2]) };
  };
}

/** nlerp is the cubic whose tangents are those of the straight line: this track has its angular velocity. */
function byNlerp({ a, b }: Keys): Way {
  const end = N.quatDot(a, b) < 0 ? N.quatNegate(zeros(4), b) : b;
  const tangent = N.quatScale(zeros(4), N.quatSub(zeros(4), end, a), 1 / seconds);
  const values = [...tangent, ...a, ...tangent, ...tangent, ...end, ...tangent];
  const track = new N.Track({ times: [0, seconds], values,
    width: 4, kind: N.TRACK_ROTATION, interpolation: N.INTERPOLATION_CUBICSPLINE });
  const state = new Float32Array(10);
  return t => {
    track.sampleMotion(Math.fround(t * seconds), state, state.subarray(4), state.subarray(7));
    return { q: N.quatNlerp(zeros(4), a, b, t), w: Array.from(state.subarray(4, 7)) };
  };
}

function wayOf(keys: Keys, method: Method, turns: number): Way {
  switch (method) {
    case 'euler': return byEuler(keys);
    case 'nlerp': return byNlerp(keys);
    default: return alongArc(keys, method, turns);
  }
}

/** Degrees per second. */
export const speed = ({ w }: Motion) => N.degreesFromRadians(N.vec3Length(w));

const steps = 192;
const times = Array.from({ length: steps + 1 }, (_, i) => (i * seconds) / steps);

/** A method between the keys: its motion, its nose on the sphere, and its angular speed. */
function sampled(keys: Keys, method: Method, turns: number) {
  const at = wayOf(keys, method, turns), all = Array.from({ length: steps + 1 }, (_, i) => at(i / steps));
  return { at, points: all.map(motion => nose(motion.q)), speeds: all.map(speed) };
}
type Curves = Record<Method, ReturnType<typeof sampled>>;

/** The present keys, the methods between them, and their speeds for the plot. */
export function curvesOf() {
  const of = remembered(({ keys, turns }: { keys: Keys; turns: number }) => {
    const curves = Object.fromEntries(names.map(m => [m, sampled(keys, m, turns)])) as Curves;
    return { keys, curves, data: { x: times, y: names.map(m => curves[m].speeds) } };
  });
  return (state: State) => of({ keys: keysOf(state), turns: state.turns });
}
export type CurvesOf = ReturnType<typeof curvesOf>;

/** The key `name` turned by the shortest rotation that brings its nose to p. */
export function turned(state: State, name: 'a' | 'b', p: number[]): Partial<State> {
  const found = N.eulerFromQuat(zeros(3), withNose(keysOf(state)[name], p), order).map(N.degreesFromRadians);
  return Object.fromEntries(['x', 'y', 'z'].map((axis, i) => [name + axis, +found[i].toFixed(2)])) as Partial<State>;
}

export const shownOf = ({ hidden }: State) => names.filter(m => !hidden.includes(m));

/** The keys' signs differ, and the method that takes them as given goes the long way. */
export const isWrongWay = ({ a, b }: Keys) => N.quatDot(a, b) < 0;
