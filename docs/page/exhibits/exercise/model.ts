// SPDX-License-Identifier: MIT
// The state of the exhibit, and what its keys and buttons do with it.
import * as N from 'nakawari/all';
import type { Camera } from '../../kit/eye';
import { clamp, zeros } from '../../kit/values';
import { choice, flag, number, numbers, whole, type Fields } from '../../shell/state';
import { scenes, type Placement } from './scenes';

export const positions = ['linear', 'hermite', 'bezier', 'bspline', 'catmull-rom', 'centripetal', 'step'] as const;
export const orientations = ['euler', 'quat', 'none', 'euler-unwrapped', 'nlerp', 'squad'] as const;
export const views = ['trajectory', 'frames', 'plain'] as const;
export type Position = typeof positions[number];
export type Orientation = typeof orientations[number];
export type View = typeof views[number];

/** The methods between which the keys p and o change: those of the exercise. */
export const taught = { positions: positions.slice(0, 4), orientations: orientations.slice(0, 2) };

export const positionMethod: Record<Position, number> = {
  linear: N.POSITION_LINEAR, hermite: N.POSITION_HERMITE, bezier: N.POSITION_BEZIER, bspline: N.POSITION_BSPLINE,
  'catmull-rom': N.POSITION_CATMULL_ROM, centripetal: N.POSITION_CENTRIPETAL, step: N.POSITION_STEP,
};
export const orientationMethod: Record<Orientation, number> = {
  euler: N.ORIENTATION_EULER, quat: N.ORIENTATION_SLERP, none: N.ORIENTATION_STEP,
  'euler-unwrapped': N.ORIENTATION_EULER_UNWRAPPED, nlerp: N.ORIENTATION_NLERP, squad: N.ORIENTATION_SQUAD,
};

export interface Key {
  readonly time: number;
  readonly position: number[];
  readonly orientation: number[];
}

/** f, which keeps its last result until it is called with other arguments. */
export function memoized<A extends unknown[], R>(f: (...list: A) => R): (...list: A) => R {
  let last: A | undefined, result: R;
  return (...list) => {
    if (!last || list.some((x, i) => !Object.is(x, last![i])))
      [result, last] = [f(...list), list];
    return result;
  };
}

/** As many as a scene of the command has (docs/command.md#exercise), and as long. */
export const limits = { keys: 64, seconds: 64 };

export interface State extends Camera {
  scene: number;
  /** Eight numbers a key: time, position x y z, orientation x y z w. Empty: the keys of the scene. */
  keys: number[];
  /** The keys are those of a file. */
  loaded: boolean;
  selected: number;
  position: Position;
  orientation: Orientation;
  view: View;
  time: number;
  /** The rules of the exercise's program in place of the library's. */
  program: boolean;
  /** Axes are drawn through the objects. */
  axes: boolean;
  /** The handles have the axes of the object. */
  local: boolean;
  /** As in the exercise's program, only the handles of one operation are shown, and clicks on a key change it. */
  clicks: boolean;
  /** The operation: turns, not moves, along the axes that `local` says. */
  turns: boolean;
}

const validKeys = (list: number[]) => list.length % 8 === 0 && list.length <= 8 * limits.keys && !problem(unpack(list));

const [first] = scenes;
const exerciseAim = [-0.5, 0, 0];
export const fields: Fields<State> = {
  scene: whole(1, 1, scenes.length),
  keys: numbers([], list => list.length === 0 || validKeys(list)),
  loaded: flag(false),
  selected: whole(-1, -1, limits.keys - 1),
  position: choice<Position>('linear', positions),
  orientation: choice<Orientation>('euler', orientations),
  view: choice<View>('trajectory', views),
  time: number(0),
  program: flag(true),
  axes: flag(false),
  local: flag(false),
  clicks: flag(false),
  turns: flag(false),
  yaw: number(first.camera.yaw),
  pitch: number(first.camera.pitch, -90, 90),
  distance: number(first.camera.distance, 2, 100),
  fov: number(first.camera.fov, 10, 120),
  aim: numbers(exerciseAim, list => list.length === 3),
  unit: number(1, 1e-6, 1e30),
};

/* ---- keys ---- */

function keyOf({ time, at, turn, opposite }: Placement): Key {
  const [yaw, pitch, roll] = turn.map(N.radiansFromDegrees);
  const q = N.quatFromEuler(zeros(4), [pitch, yaw, roll], N.EULER_YXZ);
  return { time, position: at.map(Math.fround), orientation: opposite ? N.quatNegate(q, q) : q };
}

function unpack(list: number[]): Key[] {
  return Array.from({ length: list.length / 8 }, (_, k) => {
    const [time, ...rest] = list.slice(8 * k, 8 * k + 8).map(Math.fround);
    return { time, position: rest.slice(0, 3), orientation: rest.slice(3) };
  });
}

export const pack = (keys: Key[]) => keys.flatMap(key => [key.time, ...key.position, ...key.orientation]);

const made = memoized((scene: number, list: number[]): Key[] =>
  list.length ? unpack(list) : scenes[scene - 1].keys.map(keyOf));

/** The keys of a state: one array as long as they do not change. */
export const keysOf = ({ scene, keys }: Pick<State, 'scene' | 'keys'>): Key[] => made(scene, keys);

/** The first key that the library refuses, or undefined. */
export function problem(keys: Key[]): N.NakawariError | undefined {
  try {
    new N.Keyframes(pack(keys)).dispose();
  } catch (error) {
    return error as N.NakawariError;
  }
}

export const range = (keys: Key[]) => ({ start: keys[0].time, end: keys[keys.length - 1].time });

/** The angles of a key in degrees: yaw, pitch, roll. */
export function degrees(key: Key): number[] {
  const [pitch, yaw, roll] = N.eulerFromQuat(zeros(3), key.orientation, N.EULER_YXZ);
  return [yaw, pitch, roll].map(N.degreesFromRadians);
}

/* ---- changes of the state ---- */

type Change = Partial<State>;

export function setScene(scene: number): Change {
  const { camera, keys } = scenes[scene - 1];
  return { scene, keys: [], loaded: false, selected: -1, time: keys[0].time, aim: exerciseAim, unit: 1, ...camera };
}

/** Keys of a file, seen as the command shows them: from the direction of scene 1, aimed at the middle of the keys. */
export function setKeys(keys: Key[]): Change {
  const side = (pick: (...values: number[]) => number) => [0, 1, 2].map(i => pick(...keys.map(key => key.position[i])));
  const [low, high] = [side(Math.min), side(Math.max)], radius = N.vec3Distance(low, high) / 2;
  const unit = radius > 0 ? 10 ** Math.max(Math.ceil(Math.log10(radius / 5)), -6) : 1;
  const aim = N.vec3Lerp(zeros(3), low, high, 0.5), camera = { ...first.camera, distance: 2 + 2 * radius / unit };
  return { keys: pack(keys), loaded: true, selected: -1, time: keys[0].time, aim, unit, ...camera };
}

/** The keys with key k replaced; undefined if the library refuses them. */
export function replaceKey(keys: Key[], k: number, change: Partial<Key>): Change | undefined {
  const next = keys.map((key, i) => i === k ? { ...key, ...change } : key);
  return problem(next) ? undefined : { keys: pack(next) };
}

/** A key after the last, a segment later and 0.6 along its nose. */
export function addKey(keys: Key[]): Change {
  const last = keys[keys.length - 1], before = keys[keys.length - 2];
  const step = before && last.time > before.time ? last.time - before.time : 1;
  const nose = N.quatRotate(zeros(3), last.orientation, [0, 0, -0.6]);
  const position = N.vec3Add(zeros(3), last.position, nose);
  if (keys.length >= limits.keys || last.time + step - keys[0].time > limits.seconds)
    return {};
  return { keys: pack([...keys, { ...last, time: Math.fround(last.time + step), position }]), selected: keys.length };
}

/** Without the last key; one remains. */
export function deleteKey(keys: Key[], state: State): Change {
  const rest = keys.slice(0, -1);
  if (!rest.length)
    return {};
  const { start, end } = range(rest), selected = Math.min(state.selected, rest.length - 1);
  return { keys: pack(rest), selected, time: clamp(state.time, start, end) };
}

export const moved = (key: Key, by: number[]): Partial<Key> => ({ position: N.vec3Add(zeros(3), key.position, by) });

/** Turned by an angle in radians about an axis of the world, or of the object. */
export function turned(key: Key, axis: number[], angle: number, local: boolean): Partial<Key> {
  const turn = N.quatFromAxisAngle(zeros(4), axis, angle);
  const [a, b] = local ? [key.orientation, turn] : [turn, key.orientation];
  const q = N.quatMul(zeros(4), a, b);
  return { orientation: N.quatNormalize(q, q) };
}

/* ---- the four operations ---- */

export type Operation = 'moveWorld' | 'turnLocal' | 'moveLocal' | 'turnWorld';

export const operationOf = ({ turns, local }: Pick<State, 'turns' | 'local'>): Operation =>
  turns ? (local ? 'turnLocal' : 'turnWorld') : local ? 'moveLocal' : 'moveWorld';

/** In the order of the program: moves in the world, turns of the object, moves of the object, turns in the world. */
export const nextOperation = ({ turns, local }: State): Change => ({ turns: !turns, local: turns ? local : !local });

/** The orientation of angles in degrees: yaw, pitch, roll. */
export const fromDegrees = (turn: [number, number, number]): Partial<Key> =>
  ({ orientation: keyOf({ time: 0, at: [0, 0, 0], turn }).orientation });

/** The word after `word`; words that are not in the list are followed by the first. */
export const nextOf = <T extends string>(list: readonly T[], word: T): T =>
  list[(list.indexOf(word) + 1) % list.length];
